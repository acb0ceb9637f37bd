//! Keys of a scene that take numbers in SI units.

use scene::{si_unit, spread_of, with_si_unit};
use study::body_properties::BodyProperty;
use toml::Value;

#[test]
fn numbers_keep_all_digits_and_pressures_take_the_largest_unit_with_few() {
    let pressures = [
        (999.0, "999 Pa"),
        (1e3, "1 kPa"),
        (2.5e3, "2.5 kPa"),
        (1.234e6, "1.234 MPa"),
        (12_345_000.0, "12345 kPa"),
        (1_234_567.0, "1234567 Pa"),
        (2.1e11, "210 GPa"),
    ];
    for (pa, text) in pressures {
        assert_eq!(with_si_unit("material.layer.youngs_modulus", Value::from(pa)), Value::from(text));
    }
    assert_eq!(with_si_unit("material.yield_strength", Value::from(2_000_000)), Value::from("2 MPa"));
    assert_eq!(with_si_unit("material.layer.thickness", Value::from(2000)), Value::from("2000 m"));
    assert_eq!(with_si_unit("material.poisson_ratio", Value::from(0.3)), Value::from(0.3));
    assert_eq!(with_si_unit("loads.pressures", Value::from(1e6)), Value::from(vec!["1 MPa"]));
    assert_eq!(with_si_unit("loads.pressures", Value::from(vec![1e6])), Value::from(vec!["1 MPa"]));
}

#[test]
fn a_key_has_the_unit_of_its_property() {
    assert_eq!(si_unit("counterface.resistivity"), Some("ohm m"));
    assert_eq!((si_unit("material.poisson_ratio"), si_unit("title")), (None, None));
}

#[test]
fn a_property_without_an_uncertainty_refuses_one() {
    assert!(spread_of(BodyProperty::Resistivity, "1e-8 ohm m", "1e-9 ohm m").is_err());
    assert!(spread_of(BodyProperty::YoungsModulus, "210 GPa", "5 GPa").unwrap().is_some());
}
