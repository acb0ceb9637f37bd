//! Other loads and another cutoff for a scene that has been read, without reading its surface again.

use scene::{ReplaceError, Scene, with_keys};
use study::plan::{Load, NominalPressure};
use toml::Value;
use units::{Length, OutOfBounds, Pressure, QuantityError};

/// Error of conditions for a scene.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ConditionError {
    /// The text is not a quantity.
    #[error("{0}")]
    Quantity(#[from] QuantityError),
    /// A pressure in H needs a hardness.
    #[error("{0}: the bodies have no hardness; give the pressure in Pa")]
    NoHardness(String),
    /// The pressure is out of bounds.
    #[error(transparent)]
    Bounds(#[from] OutOfBounds),
    /// The text of the scene takes no such key.
    #[error(transparent)]
    Text(#[from] ReplaceError),
}

/// Gives a scene one nominal pressure, and a shortest wavelength or none, as text with units. Its text follows.
///
/// # Errors
/// [`ConditionError`]; the scene then keeps its conditions.
pub fn retune(scene: &mut Scene, pressure: &str, shortest: Option<&str>) -> Result<(), ConditionError> {
    let pressure_pa = pressure
        .parse::<Pressure>()?
        .pascals(scene.hardness_pa())
        .ok_or_else(|| ConditionError::NoHardness(pressure.to_owned()))?;
    let nominal_pressure = NominalPressure::new(pressure_pa)?;
    let cutoff = shortest.map(str::parse::<Length>).transpose()?;
    let mut changes = vec![("loads.pressures", Value::Array(vec![Value::String(pressure.to_owned())]))];
    changes.extend(shortest.map(|text| ("cutoffs.shortest_wavelength", Value::String(text.to_owned()))));
    scene.text = with_keys(&scene.text, changes)?;
    scene.needs.loads = vec![Load { nominal_pressure, label: pressure.to_owned() }];
    scene.sampling.cutoff_m = cutoff.map(|length| length.m);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use scene::{Overrides, Template};
    use study::NoFiles;

    #[test]
    fn a_retuned_scene_is_the_scene_that_its_text_gives() {
        let mut scene = Scene::builtin(Template::Gasket).unwrap();
        retune(&mut scene, "0.3 MPa", Some("20 um")).unwrap();
        let read = Scene::parse(&scene.text, &NoFiles, &Overrides::default()).unwrap();
        assert_eq!(read.needs.loads, scene.needs.loads);
        assert_eq!(read.sampling, scene.sampling);
        let [found, expected] =
            [&scene, &read].map(|scene| scene.plan().compute().unwrap().curves[0].area_fractions(0));
        assert_eq!(found, expected);
    }

    #[test]
    fn conditions_that_cannot_be_read_change_nothing() {
        let mut scene = Scene::builtin(Template::Gasket).unwrap();
        let before = scene.text.clone();
        assert!(matches!(retune(&mut scene, "0.3", None), Err(ConditionError::Quantity(_))));
        assert!(matches!(retune(&mut scene, "1 MPa", Some("3 kg")), Err(ConditionError::Quantity(_))));
        scene.material = None;
        assert!(matches!(retune(&mut scene, "1e-3 H", None), Err(ConditionError::NoHardness(_))));
        assert_eq!(scene.text, before);
    }
}
