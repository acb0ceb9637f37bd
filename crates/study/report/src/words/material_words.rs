//! Notes on a material in words.

use study::material::Material;
use study::models::{Choice, ModelEntry};
use units::display::pressure;

/// The note that a third of the hardness is used as the strength, for a model that needs one.
#[must_use]
pub fn assumed_strength(material: &Material, model: &ModelEntry) -> Option<String> {
    let strength_pa = material.assumed_yield_strength_pa().filter(|_| model.has(Choice::Strength))?;
    let strength = pressure(strength_pa);
    Some(format!("no yield strength given: S0 = H/3 = {strength} is used"))
}
