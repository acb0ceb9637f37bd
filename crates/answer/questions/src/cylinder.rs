//! A cylinder pressed onto a rough flat by boundary elements.

use elements::{BallPressing, Boundary, Cylinder, CylinderState, cylinder_table};
use elements::{Pressing, Relief, Surfaces};
use numerics::parallel::Progress;
use serde::{Deserialize, Serialize};
use study::surface::Surface;

use crate::elements::{RandomInput, notes_on_map, notes_on_spectrum, random_surfaces};
use crate::{Answer, MaterialInput, Note, QuestionError};

/// The contact in messages.
const CONTACT: &str = "cylinders";

/// A smooth cylinder along y under a force per length, on a rough flat that repeats itself along and across.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct CylinderQuestion {
    /// Bodies in contact; the roughness is that of both.
    pub material: MaterialInput,
    /// Radius of the cylinder \[m\].
    pub radius_m: f64,
    /// Force per length \[N/m\].
    pub force_n_per_m: f64,
    /// Largest residual, above 0 and at most 0.1.
    pub tolerance: f64,
    /// Random surfaces, for a spectrum.
    pub random: RandomInput,
}

impl Default for CylinderQuestion {
    fn default() -> Self {
        CylinderQuestion {
            material: MaterialInput::default(),
            radius_m: 0.0,
            force_n_per_m: 0.0,
            tolerance: Pressing::TOLERANCE,
            random: RandomInput::default(),
        }
    }
}

/// Flats ready for the cylinder.
pub struct PreparedCylinder {
    /// The flats.
    pub surfaces: Surfaces,
    /// Notes on the surfaces and on the material.
    pub notes: Vec<Note>,
    cylinder: Cylinder,
    pressing: BallPressing,
}

impl CylinderQuestion {
    /// Finds a material that is missing or contradicts itself.
    ///
    /// # Errors
    /// [`QuestionError`] with the first of them.
    pub fn check(&self) -> Result<(), QuestionError> {
        self.material.of_half_spaces(CONTACT).map(drop)
    }

    /// Prepares random surfaces of a spectrum, each of which is a place of its own.
    ///
    /// # Errors
    /// [`QuestionError`].
    pub fn on(&self, surface: &Surface) -> Result<PreparedCylinder, QuestionError> {
        let material = self.material.of_half_spaces(CONTACT)?;
        let mut notes = notes_on_spectrum(&material, surface);
        let elastic = Pressing::elastic(material.pair.composite_modulus_pa());
        let (random, made) = random_surfaces(surface, &self.random, &elastic)?;
        notes.extend(made);
        self.prepared(Surfaces::Random(random), notes)
    }

    /// Prepares a map as measured, which is repeated along and across the cylinder.
    ///
    /// # Errors
    /// [`QuestionError`]; choices of random surfaces mean nothing for a map.
    pub fn on_map(&self, relief: Relief) -> Result<PreparedCylinder, QuestionError> {
        let material = self.material.of_half_spaces(CONTACT)?;
        let mut notes = notes_on_map(&material, &relief);
        notes.extend((relief.boundary == Boundary::Free).then_some(Note::RepeatedMap));
        self.prepared(Surfaces::Maps(vec![relief]), notes)
    }

    fn prepared(&self, surfaces: Surfaces, notes: Vec<Note>) -> Result<PreparedCylinder, QuestionError> {
        let contact_modulus_pa = self.material.of_half_spaces(CONTACT)?.pair.composite_modulus_pa();
        Ok(PreparedCylinder {
            surfaces,
            notes,
            cylinder: Cylinder { radius_m: self.radius_m, force_n_per_m: self.force_n_per_m },
            pressing: BallPressing { contact_modulus_pa, tolerance: self.tolerance },
        })
    }
}

impl PreparedCylinder {
    /// Presses the cylinder onto every flat. The table has a row for each, with the columns of
    /// [`cylinder_table`](elements::cylinder_table).
    ///
    /// # Errors
    /// [`QuestionError::Cylinder`] if the contact reaches the edges of the box, and for numbers out of their bounds.
    pub fn answer(&self, progress: &dyn Progress) -> Result<Answer, QuestionError> {
        let states = self.cylinder.press_all(&self.surfaces, &self.pressing, progress)?;
        let cautions = states.first().map(CylinderState::cautions).unwrap_or_default();
        let mut notes: Vec<Note> = cautions.into_iter().map(Note::Cylinder).collect();
        let widths_m: Vec<f64> = states.iter().map(|state| state.real_width_m).collect();
        notes.push(Note::of_places(&widths_m));
        Ok(Answer { table: cylinder_table(&states), notes, figure: None })
    }
}
