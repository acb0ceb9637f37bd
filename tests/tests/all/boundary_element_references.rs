//! Boundary elements against another solver's answers on maps as instruments' programs write them.

use elements::half_space::{Elements, Ending, Grid, Loading};
use numerics::parallel::Unobserved;
use scans::{Scan, ScanOptions, read_scans};
use tests::ReferenceTable;
use tests::committed_file;

/// Residual at which they are compared.
const TOLERANCE: f64 = 1e-10;
/// Areas may differ by so many points.
const POINTS: f64 = 3.0;
/// Gaps and depths relatively, of a thousandth of the largest gap where they vanish.
const GAPS: f64 = 1e-5;
/// The references are in micrometres and in units of the modulus.
const MODULUS_PA: f64 = 70e9;
const UM: f64 = 1e-6;

fn map(name: &str) -> (Elements, f64) {
    let file = format!("bem_{name}.nc");
    let bytes = std::fs::read(committed_file("tests/reference").join(&file)).unwrap();
    let scan = read_scans(&bytes, &file, &ScanOptions::default()).unwrap().remove(0);
    assert!(scan.is_periodic);
    let Scan::Map(map) = scan.scan.complete().unwrap() else { panic!("{file} is not a map") };
    let (length_x_m, length_y_m) =
        (map.spacing_x_m() * map.columns() as f64, map.spacing_y_m() * map.rows() as f64);
    let grid = Grid::new(map.rows(), map.columns(), length_x_m, length_y_m).unwrap();
    (Elements::periodic(grid, map.heights_m()).unwrap(), (map.rows() * map.columns()) as f64)
}

#[test]
fn elastic_and_saturated_maps() {
    let table = ReferenceTable::committed("boundary_elements.csv");
    let (maps, saturations) = (table.text("map"), table.text("saturation_over_e_star"));
    let plastic_areas = table.text("plastic_area_fraction");
    let column = |name: &str| table.numbers(name);
    let [pressures, areas, gaps, depths, largest] = [
        "pressure_over_e_star",
        "area_fraction",
        "mean_gap_um",
        "mean_plastic_depth_um",
        "largest_pressure_over_e_star",
    ]
    .map(column);
    assert_eq!(table.len(), 18);
    for row in 0..table.len() {
        let (mut elements, points) = map(maps[row]);
        let loading = Loading {
            contact_modulus_pa: MODULUS_PA,
            nominal_pressure_pa: pressures[row] * MODULUS_PA,
            saturation_pa: saturations[row].parse().ok().map(|saturation: f64| saturation * MODULUS_PA),
            tolerance: TOLERANCE,
        };
        let contact = elements.press(&loading, &Unobserved).unwrap();
        let case = format!("{} at {} below {:?}", maps[row], pressures[row], saturations[row]);
        assert_eq!(contact.numbers.ending, Ending::Converged, "{case}");
        assert!(contact.numbers.operators < 100, "{case}: {}", contact.numbers.operators);
        let bar = POINTS / points + f64::EPSILON;
        assert!(
            (contact.numbers.area_fraction - areas[row]).abs() <= bar,
            "{case}: {}",
            contact.numbers.area_fraction
        );
        let plastic = plastic_areas[row].parse().unwrap_or(0.0);
        assert!(
            (contact.numbers.plastic_area_fraction - plastic).abs() <= bar,
            "{case}: {}",
            contact.numbers.plastic_area_fraction
        );
        let largest_gap_m = contact.gaps_m.iter().fold(0.0f64, |largest, &gap_m| largest.max(gap_m));
        for (found_m, expected_um) in
            [(contact.numbers.mean_gap_m, gaps[row]), (contact.numbers.mean_plastic_depth_m, depths[row])]
        {
            let bar_m = GAPS * (expected_um * UM).max(1e-3 * largest_gap_m);
            // Closed throughout there is no gap to take a thousandth of, but rounding.
            let bar_m = bar_m.max(1e-9 * UM);
            assert!((found_m - expected_um * UM).abs() <= bar_m, "{case}: {found_m} {expected_um}");
        }
        let found = contact.numbers.largest_pressure_pa / MODULUS_PA;
        assert!((found / largest[row] - 1.0).abs() < 1e-6, "{case}: {found} {}", largest[row]);
    }
}
