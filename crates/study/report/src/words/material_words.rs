//! What there is to say of a material.

use study::material::Material;
use study::models::{Choice, ModelEntry};
use units::display::pressure;

/// That a third of the hardness is the strength, where a model needs one that was not given.
#[must_use]
pub fn assumed_strength(material: &Material, model: &ModelEntry) -> Option<String> {
    let strength_pa = material.assumed_yield_strength_pa().filter(|_| model.has(Choice::Strength))?;
    let strength = pressure(strength_pa);
    Some(format!("no yield strength is given: a third of the hardness is taken, S0 = H/3 = {strength}"))
}
