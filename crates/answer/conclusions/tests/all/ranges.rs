//! Ranges of areas: their parts, and the steps that narrow them.

use std::collections::BTreeMap;

use conclusions::{AnswerUnderLoad, Cause, NextStep, Source};
use judge::Reference;
use units::RemarkCode;

use crate::drawn_scenes::Answered;

const SMALL: &str = "[judge]\ngrid = 32\nrealisations = 2\n[uncertainty]\ndraws = 40\nshares_draws = 64\n";

/// An elastic model, and bodies that flow at a hardness under 10 MPa.
fn flowing(hardness: &str) -> Answered {
    Answered::new(&format!(
        "surface = {{ psd = \"plain.csv\" }}\nmaterial = {{ youngs_modulus = \"70 GPa\", poisson_ratio = 0.33, indentation_hardness = \
         \"{hardness}\" }}\n[loads]\npressures = [\"10 MPa\"]\n[[curve]]\nmodel = \"persson\"\n{SMALL}"
    ))
}

fn only(answered: &Answered) -> AnswerUnderLoad {
    let [load] = &answered.conclusions().loads[..] else { panic!() };
    load.clone()
}

#[test]
fn bodies_that_flow_have_the_interval_of_their_hardness_where_no_model_yields() {
    let answered = flowing("300 MPa +- 30 MPa");
    let area = only(&answered).area;
    assert_eq!(area.source, Source::Elements(Reference::Yielding { hardness_pa: 300e6 }));
    let of_inputs = area.of_inputs.unwrap();
    assert_eq!(of_inputs.curve, None);
    // 1.96 standard uncertainties of a tenth, either way.
    let half = 1.96 * 0.1;
    assert!((of_inputs.factor.ln() / (2.0 * half) - 1.0).abs() < 0.02, "{of_inputs:?}");
    let headline = answered.judgement.as_ref().unwrap().headline(0).unwrap();
    let centre = area.area_fraction.unwrap();
    for (end, of_elements) in [(area.low, headline.low), (area.high, headline.high)] {
        let wider = (of_elements / centre).ln().hypot(half);
        assert!(((end / centre).ln().abs() / wider - 1.0).abs() < 0.02, "{area:?} {headline:?}");
    }
    // A hardness that is known widens nothing.
    let certain = only(&flowing("300 MPa")).area;
    assert!(certain.of_inputs.is_none() && certain.high < area.high, "{certain:?}");
}

#[test]
fn elastic_bodies_have_no_interval_of_a_hardness() {
    let area = only(&flowing("90 GPa +- 9 GPa")).area;
    assert_eq!(area.source, Source::Elements(Reference::Elastic));
    assert!(area.of_inputs.is_none_or(|inputs| inputs.curve == Some(0)), "{area:?}");
}

#[test]
fn waves_beyond_the_end_of_a_spectrum_have_their_part_in_ranges_of_elements_alone() {
    let mut answered = flowing("90 GPa");
    answered.judgement.as_mut().unwrap().error_of_spectrum_end = 0.1;
    assert!((only(&answered).area.factor_of_spectrum_end.ln() - 0.4).abs() < 1e-12);
    answered.judgement = None;
    assert_eq!(only(&answered).area.factor_of_spectrum_end, 1.0);
}

#[test]
fn slopes_decide_and_the_decade_that_has_most_of_them_is_named_whatever_a_model_says() {
    for model in ["persson", "elastic"] {
        let answered = Answered::new(&format!(
            "surface = {{ psd = \"plain.csv\" }}\nmaterial = {{ youngs_modulus = \"200 GPa\", poisson_ratio = 0.3 }}\n[loads]\npressures = [\"10 MPa\"]\n\
             [[curve]]\nmodel = \"{model}\"\n[judge]\noff = true\n"
        ));
        let Cause::Roughness { decade } = only(&answered).cause else { panic!() };
        assert!(
            (decade.longest_m / 1e-7 - 1.0).abs() < 1e-9 && (decade.shortest_m / 1e-8 - 1.0).abs() < 1e-6
        );
        // Of q^(2 - 2.6) the integral goes as q^0.4: the last decade of 3.7 below the roll-off has 1 - 10^-0.4 of it, or a bit more.
        let expected = 1.0 - 10f64.powf(-0.4);
        assert!(decade.share > expected && decade.share < expected + 0.03, "{decade:?} {expected}");
    }
}

#[test]
fn areas_that_have_settled_are_no_upper_bound_whatever_a_model_says_that_does_not_hold() {
    let is_upper_bound = |knee_m: f64| {
        let row = |at: i32| {
            let wavelength_m = 10f64.powf(-4.0 - 0.1 * f64::from(at));
            let c1d_m3 = 2e-17 * (wavelength_m / 50e-6).powf(2.6) * (wavelength_m / knee_m).min(1.0).powi(8);
            format!("{wavelength_m:e},{c1d_m3:e}\n")
        };
        let rows: String = (0..=30).map(row).collect();
        let files =
            BTreeMap::from([("psd.csv".to_owned(), format!("wavelength_m,C1D_m3\n{rows}").into_bytes())]);
        let answered = Answered::with_files(
            &format!(
                "surface = {{ psd = \"psd.csv\" }}\nmaterial = {{ youngs_modulus = \"200 GPa\", poisson_ratio = 0.3 }}\n[loads]\npressures = \
                 [\"1 MPa\"]\n[[curve]]\nmodel = \"elastic\"\n[[curve]]\nmodel = \"persson\"\n{SMALL}"
            ),
            &files,
        );
        let shortest_m = answered.results.psd.shortest_wavelength_m();
        let conclusions = answered.conclusions();
        let is_bound = conclusions.cautions.iter().any(|caution| caution.code == RemarkCode::UpperBound);
        // A finer scan is advised where, and only where, the area still falls.
        assert_eq!(conclusions.next.contains(&NextStep::FinerScan { from_m: shortest_m }), is_bound);
        is_bound
    };
    assert!(is_upper_bound(1e-9) && !is_upper_bound(3e-6));
}

#[test]
fn a_surface_made_of_numbers_is_scanned_first_unless_the_area_hangs_on_the_hardness() {
    let next = |material: &str| {
        let answered = Answered::new(&format!(
            "surface = {{ rms_height = \"0.3 um\", rms_slope = 0.2, hurst = 0.8, rolloff_wavelength = \"60 um\" }}\n{material}\n[loads]\npressures = \
             [\"10 MPa\"]\n[[curve]]\nmodel = \"persson-plastic\"\n[[curve]]\nmodel = \"persson\"\n{SMALL}"
        ));
        answered.conclusions().next
    };
    let yields = |hardness: &str| {
        next(&format!(
            "material = {{ youngs_modulus = \"70 GPa\", poisson_ratio = 0.33, indentation_hardness = \"{hardness}\" }}"
        ))
    };
    let surface = NextStep::Surface { body: "the surface".to_owned() };
    assert_eq!(yields("90 GPa +- 9 GPa").first(), Some(&surface));
    let soft = yields("300 MPa +- 30 MPa");
    assert!(!soft.is_empty() && !soft.contains(&surface), "{soft:?}");
}
