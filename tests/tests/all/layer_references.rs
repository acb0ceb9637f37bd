//! The kernel of a layer against values of twenty digits, and layers by boundary elements and by Persson's theory against another
//! solver's answers.

use asperity::{ElasticBody, Layer, LayerCompliance, MaterialPair};
use elements::half_space::{Elements, Ending, Grid, Loading};
use numerics::parallel::Unobserved;
use scans::{Scan, ScanOptions, read_scans};
use tests::{Deviations, ReferenceTable, committed_file};

const UM: f64 = 1e-6;
/// Plane-strain modulus of the layer \[Pa\]; pressures are in its units.
const MODULUS_PA: f64 = 2e9;

/// Layer whose shear modulus is `ratio` times that of its base; the base is rigid without a Poisson's ratio of its own.
fn layer(poisson_ratio: f64, base_ratio: Option<f64>, ratio: f64, thickness_m: f64) -> Layer {
    let modulus_pa = MODULUS_PA * (1.0 - poisson_ratio * poisson_ratio);
    let body = ElasticBody::new(modulus_pa, poisson_ratio).unwrap();
    let base = base_ratio.map(|base_ratio| {
        let modulus_pa = 2.0 * body.shear_modulus_pa() / ratio * (1.0 + base_ratio);
        ElasticBody::new(modulus_pa, base_ratio).unwrap()
    });
    Layer::new(body, thickness_m, base).unwrap()
}

#[test]
fn the_kernel_agrees_with_twenty_digits() {
    let table = ReferenceTable::committed("layer_kernel.csv");
    let bases = table.text("base_poisson");
    let [ratios, shear_ratios, places, values] =
        ["layer_poisson", "shear_modulus_ratio_layer_over_base", "wavevector_times_thickness", "s"]
            .map(|column| table.numbers(column));
    assert_eq!(table.len(), 110);
    let mut deviations = Deviations::default();
    for row in 0..table.len() {
        let layer = layer(ratios[row], bases[row].parse().ok(), shear_ratios[row], 1.0);
        deviations.note(layer.relative_displacement(places[row]), values[row]);
    }
    deviations.assert_within("S(k)", 1e-15, 1e-13);
}

/// Map in a file, as the kernel of a layer or of a half-space lays out its elements.
struct Map {
    grid: Grid,
    heights_m: Vec<f64>,
}

impl Map {
    fn read(name: &str) -> Self {
        let file = format!("adhesion_{name}.nc");
        let bytes = std::fs::read(committed_file("tests/reference").join(&file)).unwrap();
        let scan = read_scans(&bytes, &file, &ScanOptions::default()).unwrap().remove(0);
        let Scan::Map(map) = scan.scan.complete().unwrap() else { panic!("{file} is not a map") };
        let (length_x_m, length_y_m) =
            (map.spacing_x_m() * map.columns() as f64, map.spacing_y_m() * map.rows() as f64);
        let grid = Grid::new(map.rows(), map.columns(), length_x_m, length_y_m).unwrap();
        Map { grid, heights_m: map.heights_m().to_vec() }
    }

    fn elements(&self, layer: Option<LayerCompliance>) -> Elements {
        match layer {
            None => Elements::periodic(self.grid, &self.heights_m),
            Some(layer) => Elements::periodic_on(self.grid, &self.heights_m, |q| layer.relative_at(q)),
        }
        .unwrap()
    }
}

#[test]
fn boundary_elements_on_layers() {
    let table = ReferenceTable::committed("layer_area.csv");
    let (maps, bases) = (table.text("map"), table.text("base_poisson"));
    let [ratios, shear_ratios, thicknesses, pressures, areas, gaps] = [
        "layer_poisson",
        "shear_modulus_ratio_layer_over_base",
        "thickness_um",
        "pressure_over_layer_e_star",
        "area_fraction",
        "mean_gap_um",
    ]
    .map(|column| table.numbers(column));
    assert_eq!(table.len(), 20);
    for row in 0..table.len() {
        let map = Map::read(maps[row]);
        let layer = layer(ratios[row], bases[row].parse().ok(), shear_ratios[row], thicknesses[row] * UM);
        let pair = MaterialPair::against_rigid(layer.body()).bonded(Some(layer));
        let loading = Loading {
            contact_modulus_pa: pair.composite_modulus_pa(),
            nominal_pressure_pa: pressures[row] * MODULUS_PA,
            saturation_pa: None,
            tolerance: 1e-10,
        };
        let mut elements = map.elements(pair.layer_compliance());
        let contact = elements.press(&loading, &Unobserved).unwrap();
        let case = format!("row {row}, map {}", maps[row]);
        assert_eq!(contact.numbers.ending, Ending::Converged, "{case}");
        let points = map.heights_m.len() as f64;
        let off = (contact.numbers.area_fraction - areas[row]).abs() * points;
        let gap_off = contact.numbers.mean_gap_m / (gaps[row] * UM) - 1.0;
        eprintln!("{case}: {off:.2} points, gap {gap_off:.1e}, {} operators", contact.numbers.operators);
        assert!(off < 1.01, "{case}: {off} points");
        assert!(gap_off.abs() < 1e-6, "{case}: {gap_off}");
        assert!(contact.numbers.operators < 300, "{case}: {}", contact.numbers.operators);
        if shear_ratios[row] == 1.0 {
            let plain = map.elements(None).press(&loading, &Unobserved).unwrap();
            assert!(
                (plain.numbers.area_fraction - contact.numbers.area_fraction).abs() * points < 1.01,
                "{case}"
            );
            assert!((plain.numbers.mean_gap_m / contact.numbers.mean_gap_m - 1.0).abs() < 1e-8, "{case}");
        }
    }
}

#[test]
fn pressures_of_full_contact_and_the_areas_of_the_theory() {
    let table = ReferenceTable::committed("layer_area.csv");
    let (maps, bases) = (table.text("map"), table.text("base_poisson"));
    let [ratios, shear_ratios, thicknesses, pressures, spreads, areas] = [
        "layer_poisson",
        "shear_modulus_ratio_layer_over_base",
        "thickness_um",
        "pressure_over_layer_e_star",
        "full_contact_pressure_rms_over_layer_e_star",
        "persson_area_fraction",
    ]
    .map(|column| table.numbers(column));
    // Two loads for each surface: its spread is the same.
    for row in (0..table.len()).step_by(2) {
        let map = Map::read(maps[row]);
        let layer = layer(ratios[row], bases[row].parse().ok(), shear_ratios[row], thicknesses[row] * UM);
        let pair = MaterialPair::against_rigid(layer.body()).bonded(Some(layer));
        let loading = Loading {
            contact_modulus_pa: pair.composite_modulus_pa(),
            nominal_pressure_pa: 10.0 * spreads[row] * MODULUS_PA,
            saturation_pa: None,
            tolerance: 1e-12,
        };
        let contact = map.elements(pair.layer_compliance()).press(&loading, &Unobserved).unwrap();
        assert_eq!(contact.numbers.area_fraction, 1.0, "row {row}");
        let squares: f64 = contact
            .pressures_pa
            .iter()
            .map(|pressure_pa| ((pressure_pa - loading.nominal_pressure_pa) / MODULUS_PA).powi(2))
            .sum();
        let spread = (squares / map.heights_m.len() as f64).sqrt();
        let off = spread / spreads[row] - 1.0;
        eprintln!("row {row}: spread off by {off:.1e}");
        assert!(off.abs() < 1e-10, "row {row}: {off}");
        for at in [row, row + 1] {
            let area = persson::elastic::area_fraction(pressures[at], spread);
            assert!((area / areas[at] - 1.0).abs() < 1e-10, "row {at}: {area}");
        }
    }
}
