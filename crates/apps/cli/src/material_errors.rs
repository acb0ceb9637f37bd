//! What is wrong with a material, told with the options that mend it.

use study::material::{MaterialError, MaterialProperty};

use crate::failure::Failure;

impl From<MaterialError> for Failure {
    fn from(error: MaterialError) -> Self {
        Failure::Input(told(&error))
    }
}

/// The error with the options that mend it.
pub(crate) fn told(error: &MaterialError) -> String {
    match error {
        MaterialError::Missing(needed_for) => format!("{error}: give {}", flags_of(needed_for.property())),
        MaterialError::HardnessOffStrength(_) => {
            format!("{error}: leave out --indentation-hardness or --yield-strength")
        }
        error => error.to_string(),
    }
}

/// The options that give a property of the material.
fn flags_of(property: MaterialProperty) -> &'static str {
    match property {
        MaterialProperty::IndentationHardness => "--indentation-hardness or --yield-strength",
        MaterialProperty::YieldStrength => "--yield-strength or --indentation-hardness",
        MaterialProperty::StrainGradientLength => "--strain-gradient-length",
    }
}
