//! The hardness and the yield strength that belong together.

use study::hardness_and_strength::{HardnessAndStrength, HardnessOffStrength};

fn given(hardness: &str, strength: &str) -> Result<HardnessAndStrength, HardnessOffStrength> {
    let strength = (!strength.is_empty()).then(|| strength.parse().unwrap());
    HardnessAndStrength::new((!hardness.is_empty()).then(|| hardness.parse().unwrap()), strength)
}

#[test]
fn either_gives_the_other_and_what_is_given_counts() {
    let found = |hardness, strength| {
        let given = given(hardness, strength).unwrap();
        (given.hardness_pa(), given.yield_strength_pa(), given.assumed_yield_strength_pa())
    };
    assert_eq!(found("", "1 GPa"), (Some(3e9), Some(1e9), None));
    assert_eq!(found("6 GPa", ""), (Some(6e9), Some(2e9), Some(2e9)));
    assert_eq!(found("3.02 GPa", "1 GPa"), (Some(3.02e9), Some(1e9), None));
    assert_eq!(found("", ""), (None, None, None));
    // A strength in units of a hardness that it would have to tell is none.
    assert_eq!(found("", "1 H"), (None, None, None));
    assert_eq!(found("3 GPa", "1 H"), (Some(3e9), None, None));
}

#[test]
fn both_belong_together_within_one_percent() {
    for hardness in ["2.9701 GPa", "3.0299 GPa"] {
        assert!(given(hardness, "1 GPa").is_ok(), "{hardness}");
    }
    for hardness in ["2.9699 GPa", "3.0301 GPa", "1 kPa"] {
        let error = given(hardness, "1 GPa").unwrap_err();
        assert_eq!(error.yield_strength_pa, 1e9);
    }
    assert_eq!(
        given("300 HV", "1 GPa").unwrap_err().to_string(),
        "the hardness 2.94 GPa is 2.942 times the yield strength 1 GPa; where both are given it must be 3 times it \
         within 1 %"
    );
}
