//! The tables of draws: their columns, and the reasons for empty cells.

use scene::{Overrides, Scene};
use study::NoFiles;
use study::plan::Work;
use tables::{Format, Table};
use uncertainty::{
    Advice, AreaBand, AreaInterval, BandPoint, Group, Index, Indices, InstrumentInput, InstrumentName,
    Resampled, Settling, Step, StepKind, Uncertainty, UncertaintySettings,
};

const SCENE: &str = r#"
    surface = { psd = "builtin:uncd-measured" }
    material = { youngs_modulus = "463 GPa", poisson_ratio = 0.2 }
    loads = { pressures = ["1 MPa", "5 MPa"] }
    [[curve]]
    model = "elastic"
"#;

fn indices(value: f64, standard_error: f64) -> Indices {
    let index = |value| Index { value, standard_error };
    Indices { first_order: index(value), total: index(value + 0.01) }
}

fn area(load: usize, indices: Vec<Indices>) -> AreaInterval {
    AreaInterval {
        curve: 0,
        load,
        area_fraction: 2e-3,
        median: 2.1e-3,
        low: 1e-3,
        high: 4e-3,
        within_68: [1.5e-3, 3e-3],
        monte_carlo_error: 0.03,
        ln_area_sd: 0.35,
        indices,
    }
}

fn found() -> Uncertainty {
    let instrument = |name: &str| InstrumentInput {
        name: InstrumentName::Given(name.to_owned()),
        scans: 3,
        resampled: Resampled::Scans(3),
        z_calibration: 0.03,
        z_calibration_is_assumed: true,
        slope_uncertainty: 0.0,
        gain: [0.0, 0.06],
        band_m: [1e-5, 1e-8],
    };
    let step = |kind, width_ratio| Step { kind, width_ratio, area_ratio: 1.0 };
    Uncertainty {
        settings: UncertaintySettings::default(),
        draws: 1000,
        ended_early: false,
        groups: vec![Group::Scans, Group::Material],
        instruments: vec![instrument("stylus"), instrument("AFM")],
        overlaps: Vec::new(),
        spectrum_errors: Vec::new(),
        guesses: Vec::new(),
        areas: vec![
            area(0, vec![indices(0.7, 0.02), indices(0.25, 0.03)]),
            area(1, vec![indices(0.7, 0.02), indices(0.4, 0.2)]),
        ],
        quantities: Vec::new(),
        open_channels: Vec::new(),
        bands: Vec::new(),
        advice: vec![Advice {
            curve: 0,
            load: 1,
            decades: Vec::new(),
            instruments: vec![[0.1, 0.0], [0.6, 0.0]],
            steps: vec![
                step(StepKind::MoreScans { instrument: 1, added: 3 }, 0.75),
                step(StepKind::KnownExactly { group: Group::Material }, 0.9),
                step(StepKind::ShorterWavelengths { to_m: 1e-9 }, 1.25),
            ],
            settling: Settling::CannotSettle { slope: -3.0, standard_error: 0.1 },
        }],
        work: Work::default(),
        plans: 1000,
    }
}

fn scene() -> Scene {
    Scene::parse(SCENE, &NoFiles, &Overrides::default()).unwrap()
}

fn text(table: &Table) -> String {
    let mut bytes = Vec::new();
    table.write(Format::Csv, &[], &mut bytes).unwrap();
    String::from_utf8(bytes).unwrap()
}

#[test]
fn shares_that_are_not_known_are_empty_and_groups_that_do_not_scatter_carry_nothing() {
    assert_eq!(
        text(&found().intervals_table(&scene().needs)),
        "curve,nominal_pressure_pa,area_fraction,median,low,high,level,monte_carlo_error,share_scans,share_instruments,\
         share_material,share_strength,share_holes,share_other\n\
         elastic,1000000,0.002,0.0021,0.001,0.004,0.95,0.03,0.7,0,0.25,0,0,0.050000000000000044\n\
         elastic,5000000,0.002,0.0021,0.001,0.004,0.95,0.03,0.7,0,,0,0,\n"
    );
}

#[test]
fn an_area_that_does_not_vary_and_draws_without_shares_leave_them_empty() {
    let mut found = found();
    found.areas[0].ln_area_sd = 0.0;
    found.areas[1].indices.clear();
    for (area, group) in [(0, Group::Scans), (1, Group::Scans), (1, Group::Material)] {
        assert_eq!(found.share(&found.areas[area], group), None);
    }
    assert_eq!(found.share(&found.areas[0], Group::Strength), Some(0.0));
    assert_eq!(found.indices_table(&scene().needs).rows(), 2);
}

#[test]
fn every_index_stands_beside_its_error() {
    let table = text(&found().indices_table(&scene().needs));
    let mut lines = table.lines();
    assert_eq!(
        lines.next(),
        Some("curve,nominal_pressure_pa,group,first_order,first_order_error,total,total_error")
    );
    assert_eq!(lines.next(), Some("elastic,1000000,scans,0.7,0.02,0.71,0.02"));
    assert_eq!(lines.nth(2), Some("elastic,5000000,material,0.4,0.2,0.41000000000000003,0.2"));
    assert_eq!(lines.next(), None);
}

#[test]
fn bands_have_a_row_for_each_cutoff() {
    let mut found = found();
    let point = |wavelength_m: f64| BandPoint {
        wavelength_m,
        area_fraction: 0.15,
        median: 0.14,
        low: 0.1,
        high: 0.2,
    };
    found.bands = vec![AreaBand { curve: 0, load: 1, points: vec![point(1e-6), point(1e-7)] }];
    assert_eq!(
        text(&found.bands_table(&scene().needs)),
        "curve,nominal_pressure_pa,wavelength_m,area_fraction,median,low,high\n\
         elastic,5000000,1e-6,0.15,0.14,0.1,0.2\n\
         elastic,5000000,1e-7,0.15,0.14,0.1,0.2\n"
    );
}

#[test]
fn steps_are_ranked_and_name_what_they_take() {
    assert_eq!(
        text(&found().advice_table(&scene().needs)),
        "curve,nominal_pressure_pa,rank,step,instrument,added_scans,wavelength_m,width_ratio,area_ratio\n\
         elastic,5000000,1,more-scans,AFM,3,,0.75,1\n\
         elastic,5000000,2,known-material,,,,0.9,1\n\
         elastic,5000000,3,shorter-wavelengths,,,1e-9,1.25,1\n"
    );
}
