//! What a material lacks, told with the option that gives it.

use study::material::{MaterialError, MaterialProperty};

use crate::failure::Failure;

impl From<MaterialError> for Failure {
    fn from(error: MaterialError) -> Self {
        let MaterialError::Missing(needed_for) = error else { return Failure::input(error) };
        let flag = flag_of(needed_for.property());
        Failure::Input(format!("{error}: give {flag}"))
    }
}

/// The option that gives a property of the material.
pub(crate) fn flag_of(property: MaterialProperty) -> &'static str {
    match property {
        MaterialProperty::YieldStrength => "--yield-strength",
        MaterialProperty::StrainGradientLength => "--strain-gradient-length",
    }
}
