//! Tables against the laws that they are of, and the words around them.

use std::convert::Infallible;

use crate::support::{sampled, separation};
use interface::finite_elements::{
    Column, ContactLaw, ContactLawError, Dialect, ExponentialLaw, Heading, LawPoint, SamplingError,
    UnitSystem,
};

fn heading() -> Heading {
    Heading { name: "ROUGH".to_owned(), provenance: vec!["truearea law psd.csv".to_owned()] }
}

/// Rows of numbers of a table for a code.
fn rows(text: &str) -> Vec<[f64; 2]> {
    let lines = text.lines().filter(|line| !line.starts_with('*'));
    lines
        .map(|line| {
            let cells: Vec<f64> = line.split(',').map(|cell| cell.trim().parse().unwrap()).collect();
            [cells[0], cells[1]]
        })
        .collect()
}

#[test]
fn pressures_between_the_rows_are_within_the_tolerance() {
    let exact = separation();
    for tolerance in [0.05, 0.01, 1e-3] {
        // Up to near complete contact, where the gap closes within a small part of u0.
        let [from_pa, to_pa] = [1e4, 4e10];
        let law = sampled([from_pa, to_pa], tolerance);
        let mut worst = 0.0f64;
        let count = 600;
        for at in 0..count {
            let pressure_pa = from_pa * (to_pa / from_pa).powf(f64::from(at) / f64::from(count - 1));
            let overclosure_m = law.overclosure_m(exact.whole(pressure_pa).mean_gap_m);
            worst = worst.max((law.pressure_pa(overclosure_m) / pressure_pa - 1.0).abs());
        }
        let rows = law.points.len();
        println!("tolerance {tolerance}: worst {worst:e}, told {:e}, {rows} rows", law.interpolation_error);
        assert!(worst <= tolerance && worst <= law.interpolation_error * 1.001, "{tolerance}: {worst}");
        assert!(worst > 0.3 * tolerance, "{tolerance}: {worst}");
    }
}

#[test]
fn the_first_line_is_the_tangent_of_a_logarithmic_law() {
    let law = sampled([1e4, 1e7], 0.01);
    let exact = separation().whole(1e4);
    let overclosure_m = law.overclosure_m(exact.mean_gap_m);
    assert!((1e4 / overclosure_m / exact.stiffness_pa_per_m - 1.0).abs() < 1e-6);
    let cut = law.cut();
    assert!((cut.pressure_pa * std::f64::consts::E / 1e4 - 1.0).abs() < 1e-15);
    assert_eq!(
        (law.overclosure_m(cut.mean_gap_m), law.pressure_pa(0.0), law.pressure_pa(-1e-6)),
        (0.0, 0.0, 0.0)
    );
}

#[test]
fn the_tables_of_all_codes_and_units_are_the_same_law() {
    let law = sampled([1e4, 1e9], 0.01);
    let exact = separation();
    for &units in UnitSystem::ALL {
        for dialect in [Dialect::Abaqus, Dialect::Calculix] {
            let text = dialect.table(&law, units, &heading(), &[]).unwrap();
            let rows = rows(&text);
            assert_eq!((rows[0], rows.len()), ([0.0, 0.0], law.points.len()));
            for pair in rows.windows(2) {
                assert!(pair[1][0] > pair[0][0] && pair[1][1] - pair[0][1] >= 1e-10, "{pair:?}");
            }
            let u_ref_m = exact.whole(1e4 / std::f64::consts::E).mean_gap_m;
            for [pressure, overclosure] in &rows[1..] {
                let gap_m = exact.whole(pressure * units.pressure_pa()).mean_gap_m;
                let expected_m = u_ref_m - gap_m;
                assert!(
                    (overclosure * units.length_m() / expected_m - 1.0).abs() < 1e-9,
                    "{dialect} {units}"
                );
            }
            assert!(text.lines().all(|line| line.len() <= 120 && line.is_ascii()), "{text}");
            let numbers =
                text.lines().filter(|line| !line.starts_with('*')).flat_map(|line| line.split(", "));
            assert!(numbers.clone().all(|number| number.len() <= 20 && number.contains('.')), "{text}");
            assert!(numbers.count() == 2 * rows.len());
        }
    }
}

#[test]
fn a_comment_says_where_the_law_comes_from_and_what_was_cut() {
    let law = sampled([1e4, 1e9], 0.01);
    let text = Dialect::Calculix.table(&law, UnitSystem::Millimetres, &heading(), &[]).unwrap();
    let comment: String =
        text.lines().filter_map(|line| line.strip_prefix("** ")).collect::<Vec<_>>().join(" ");
    for said in [
        "truearea law psd.csv",
        "from 0.01 MPa to 1000 MPa",
        "within 1 % of the pressure of this model",
        "Units N-mm: forces in N, lengths in mm, pressures in MPa",
        "Pressures are nominal",
        "in excess of smooth bodies",
        "There the law is cut off, the pressure is set to 0",
        "NODE TO SURFACE",
        "1e-3 of the root of the slave area",
        "holds the pressure at 1000 MPa",
    ] {
        assert!(comment.contains(said), "{said}\n{comment}");
    }
    assert!(text.contains(
        "\n*SURFACE INTERACTION, NAME=ROUGH\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR\n0., 0.\n"
    ));
    let text = Dialect::Abaqus.table(&law, UnitSystem::Millimetres, &heading(), &[]).unwrap();
    assert!(!text.contains("CalculiX"));
}

#[test]
fn values_under_a_header_have_all_digits_and_further_columns() {
    let law = sampled([1e4, 1e6], 0.01);
    let values: Vec<Option<f64>> = law.points.iter().map(|point| Some(2.0 * point.pressure_pa)).collect();
    let column = |values| Column { name: "conductance_w_per_m2_k".to_owned(), values };
    let text = Dialect::Csv.table(&law, UnitSystem::Millimetres, &heading(), &[column(values)]).unwrap();
    let mut lines = text.lines().skip_while(|line| line.starts_with("# "));
    assert_eq!(
        lines.next().unwrap(),
        "pressure_MPa,overclosure_mm,mean_gap_mm,area_fraction,conductance_w_per_m2_k"
    );
    let first: Vec<f64> = lines.next().unwrap().split(',').map(|cell| cell.parse().unwrap()).collect();
    assert_eq!(first[..2], [0.0, 0.0]);
    assert_eq!(first[2], 1e3 * law.cut().mean_gap_m);
    assert_eq!(lines.count(), law.points.len() - 1);
    let short = Dialect::Csv.table(&law, UnitSystem::Si, &heading(), &[column(vec![None])]);
    assert!(matches!(short, Err(ContactLawError::ColumnLength { values: 1, .. })), "{short:?}");
    let elsewhere = Dialect::Abaqus.table(&law, UnitSystem::Si, &heading(), &[column(vec![None])]);
    assert_eq!(elsewhere, Err(ContactLawError::NoColumns("abaqus")));
}

#[test]
fn what_calculix_has_no_room_for_is_refused_with_the_mend() {
    let long = sampled([1.0, 1e10], 1e-3);
    assert!(long.points.len() > Dialect::MOST_CALCULIX_ROWS);
    let refused = Dialect::Calculix.table(&long, UnitSystem::Millimetres, &heading(), &[]).unwrap_err();
    let (rows, most) = (long.points.len(), Dialect::MOST_CALCULIX_ROWS);
    assert!(
        matches!(refused, ContactLawError::TooManyRows { rows: found, most: bound, .. } if (found, bound) == (rows, most))
    );
    assert!(Dialect::Abaqus.table(&long, UnitSystem::Millimetres, &heading(), &[]).is_ok());
    // Near complete contact the gap closes by less than 0.1 nm from row to row.
    let heavy = sampled([1e9, 5e10], 0.01);
    let refused = Dialect::Calculix.table(&heavy, UnitSystem::Si, &heading(), &[]).unwrap_err();
    assert!(matches!(refused, ContactLawError::TooClose { unit: "m", least: 1e-10, .. }), "{refused}");
    assert!(Dialect::Calculix.table(&heavy, UnitSystem::Micrometres, &heading(), &[]).is_ok());
}

#[test]
fn the_exponential_form_is_that_of_the_light_loads() {
    let light = separation().light_loads().unwrap();
    let law = ExponentialLaw {
        decay_length_m: light.decay_length_m,
        reference_pressure_pa: light.reference_pressure_pa,
        holds_up_to_pa: separation().light_load_limit_pa(0.01).unwrap(),
        share: 0.01,
    };
    let text = Dialect::Calculix.exponential(&law, UnitSystem::Millimetres, &heading()).unwrap();
    let [clearance, pressure] = rows(&text)[0];
    assert!((clearance * 1e-3 / (100f64.ln() * light.decay_length_m) - 1.0).abs() < 1e-12);
    assert!((pressure * 1e6 / light.reference_pressure_pa - 1.0).abs() < 1e-12);
    let said = text.replace("\n** ", " ");
    assert!(said.contains("For smaller pressures take p0 = p00 exp(-s/u0) and a mesh"), "{text}");
    assert!(text.contains("PRESSURE-OVERCLOSURE=EXPONENTIAL\n"), "{text}");
    let refused = Dialect::Abaqus.exponential(&law, UnitSystem::Si, &heading()).unwrap_err();
    assert!(matches!(refused, ContactLawError::NoExponential("abaqus")), "{refused}");
}

#[test]
fn laws_that_are_none_are_refused() {
    let with = |range_pa, tolerance, gap: fn(f64) -> Option<f64>| {
        let at = |pressure_pa: f64| {
            let point = |mean_gap_m| LawPoint { pressure_pa, mean_gap_m, area_fraction: 0.1 };
            Ok::<_, Infallible>(gap(pressure_pa).map(point))
        };
        ContactLaw::sample(range_pa, tolerance, at).unwrap_err()
    };
    let falling = |pressure_pa: f64| Some(-pressure_pa.ln());
    assert!(matches!(with([1e6, 1e3], 0.01, falling), SamplingError::EmptyRange { .. }));
    assert!(matches!(with([0.0, 1e3], 0.01, falling), SamplingError::Value(_)));
    assert!(matches!(with([1.0, f64::NAN], 0.01, falling), SamplingError::Value(_)));
    assert!(matches!(with([1.0, 1e3], 0.0, falling), SamplingError::Value(_)));
    let opening = |pressure_pa: f64| Some(pressure_pa);
    assert!(matches!(with([1.0, 1e3], 0.01, opening), SamplingError::NotClosing { .. }));
    let ends = |pressure_pa: f64| (pressure_pa < 500.0).then(|| -pressure_pa.ln());
    assert!(matches!(with([1.0, 1e3], 0.01, ends), SamplingError::NoGap { .. }));
    // Over a step of the gap the pressure is that of the step, whatever the line.
    let step = |pressure_pa: f64| {
        let mean_gap_m = -pressure_pa.ln() - if pressure_pa > 77.0 { 1.0 } else { 0.0 };
        Ok::<_, Infallible>(Some(LawPoint { pressure_pa, mean_gap_m, area_fraction: 0.1 }))
    };
    let law = ContactLaw::sample([1.0, 1e3], 1e-3, step).unwrap();
    assert!((law.pressure_pa(law.overclosure_m(-77f64.ln() - 0.5)) / 77.0 - 1.0).abs() < 1e-3);
    let fails = ContactLaw::sample([1.0, 1e3], 0.01, |_| Err::<Option<LawPoint>, _>("gone"));
    assert_eq!(fails, Err(SamplingError::Source("gone")));
}
