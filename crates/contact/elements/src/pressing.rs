//! Material and loads under which surfaces are pressed.

use crate::half_space::{Approach, Closing, Contact, Elements, HalfSpaceError, Loading};
use crate::specimen::SpecimenCompliance;
use asperity::{LayerCompliance, MaterialPair};
use numerics::parallel::Progress;

/// Load on a surface, or what is held in its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ImposedLoad {
    /// Nominal pressure \[Pa\].
    PressurePa(f64),
    /// Nominal pressure in units of E* h' of each surface, with its own rms gradient h'.
    ReducedPressure(f64),
    /// Distance that the bodies are pressed to.
    Approach(Approach),
}

/// Material, loads and tolerance.
#[derive(Clone, Debug, PartialEq)]
pub struct Pressing {
    /// Contact modulus E* \[Pa\]; 1/E* is the sum of (1 - nu^2)/E over both bodies, of the layer where one has a layer.
    pub contact_modulus_pa: f64,
    /// Displacement of a layer under waves, over that of half-spaces with this modulus; `None` for half-spaces.
    pub layer: Option<LayerCompliance>,
    /// Loads, in the order of the results.
    pub loads: Vec<ImposedLoad>,
    /// Pressure at which the surface yields, an indentation hardness \[Pa\]; `None` if it is elastic throughout.
    pub saturation_pa: Option<f64>,
    /// Largest residual: sum of p|g| over the sum of p h_rms, above 0 and at most 0.1.
    pub tolerance: f64,
    /// True to compute the stiffness, which costs about half a solve more.
    pub stiffness: bool,
    /// Compliance of the specimen as a whole that is taken out of the stiffness where edges are free.
    pub compliance: SpecimenCompliance,
}

impl Pressing {
    /// Default tolerance: areas are then exact to a point or two.
    pub const TOLERANCE: f64 = 1e-6;

    /// Creates an elastic material of a contact modulus \[Pa\], without loads, and without the stiffness.
    #[must_use]
    pub fn elastic(contact_modulus_pa: f64) -> Self {
        Self {
            contact_modulus_pa,
            layer: None,
            loads: Vec::new(),
            saturation_pa: None,
            tolerance: Self::TOLERANCE,
            stiffness: false,
            compliance: SpecimenCompliance::None,
        }
    }

    /// Creates the elastic material of a pair of bodies, with the layer if there is one, without loads and stiffness.
    #[must_use]
    pub fn between(pair: &MaterialPair) -> Self {
        Self { layer: pair.layer_compliance(), ..Self::elastic(pair.composite_modulus_pa()) }
    }

    /// Checks the numbers before any surface is made.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for numbers out of their bounds, and for a load that is not below the saturation.
    pub fn check(&self) -> Result<(), HalfSpaceError> {
        self.loads.iter().try_for_each(|load| match *load {
            ImposedLoad::PressurePa(pressure_pa) => self.loading(pressure_pa).check(),
            // Pressures of surfaces with a gradient of 1; each surface checks its own.
            ImposedLoad::ReducedPressure(share) => {
                Loading { saturation_pa: None, ..self.loading(share * self.contact_modulus_pa) }.check()
            }
            ImposedLoad::Approach(approach) => self.closing(approach).check(),
        })
    }

    /// Presses elements by one of the loads; `rms_gradient` is that of their surface.
    pub(crate) fn press(
        &self,
        load: usize,
        rms_gradient: f64,
        elements: &mut Elements,
        progress: &dyn Progress,
    ) -> Result<Contact, HalfSpaceError> {
        match self.loads[load] {
            ImposedLoad::PressurePa(pressure_pa) => elements.press(&self.loading(pressure_pa), progress),
            ImposedLoad::ReducedPressure(share) => {
                elements.press(&self.loading(share * self.contact_modulus_pa * rms_gradient), progress)
            }
            ImposedLoad::Approach(approach) => elements.press_to(&self.closing(approach), progress),
        }
    }

    /// Loading at a nominal pressure \[Pa\].
    pub(crate) fn loading(&self, nominal_pressure_pa: f64) -> Loading {
        Loading {
            contact_modulus_pa: self.contact_modulus_pa,
            nominal_pressure_pa,
            saturation_pa: self.saturation_pa,
            tolerance: self.tolerance,
        }
    }

    fn closing(&self, approach: Approach) -> Closing {
        Closing {
            contact_modulus_pa: self.contact_modulus_pa,
            approach,
            saturation_pa: self.saturation_pa,
            tolerance: self.tolerance,
        }
    }
}
