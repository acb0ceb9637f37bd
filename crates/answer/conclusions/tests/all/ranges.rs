//! What the one range of an area consists of.

use conclusions::{AnswerUnderLoad, Source};
use judge::Reference;

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
