//! A ball pressed onto a rough flat by boundary elements.

use elements::{Ball, BallPressing, BallState, ball_table};
use elements::{Pressing, Relief, Surfaces};
use numerics::parallel::Progress;
use serde::{Deserialize, Serialize};
use study::surface::Surface;

use crate::ball_figure::averaged_pressure;
use crate::elements::{RandomInput, notes_on_map, notes_on_spectrum, random_surfaces};
use crate::{Answer, MaterialInput, Note, QuestionError};

/// A smooth ball under a force on a rough flat with free boundaries.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct BallQuestion {
    /// Bodies in contact; the roughness is that of both.
    pub material: MaterialInput,
    /// Radius of the ball \[m\].
    pub radius_m: f64,
    /// Force on it \[N\].
    pub force_n: f64,
    /// Largest residual, above 0 and at most 0.1.
    pub tolerance: f64,
    /// Random surfaces, for a spectrum.
    pub random: RandomInput,
}

impl Default for BallQuestion {
    fn default() -> Self {
        BallQuestion {
            material: MaterialInput::default(),
            radius_m: 0.0,
            force_n: 0.0,
            tolerance: Pressing::TOLERANCE,
            random: RandomInput::default(),
        }
    }
}

/// Flats ready for the ball.
pub struct PreparedBall {
    /// The flats.
    pub surfaces: Surfaces,
    /// Notes on the surfaces and on the material.
    pub notes: Vec<Note>,
    ball: Ball,
    pressing: BallPressing,
}

impl BallQuestion {
    /// Finds a material that is missing or contradicts itself.
    ///
    /// # Errors
    /// [`QuestionError`] with the first of them.
    pub fn check(&self) -> Result<(), QuestionError> {
        self.material.of_half_spaces("balls").map(drop)
    }

    /// Prepares random surfaces of a spectrum, each of which is a place of its own.
    ///
    /// # Errors
    /// [`QuestionError`].
    pub fn on(&self, surface: &Surface) -> Result<PreparedBall, QuestionError> {
        let material = self.material.of_half_spaces("balls")?;
        let mut notes = notes_on_spectrum(&material, surface);
        let elastic = Pressing::elastic(material.pair.composite_modulus_pa());
        let (random, made) = random_surfaces(surface, &self.random, &elastic)?;
        notes.extend(made);
        self.prepared(Surfaces::Random(random), notes)
    }

    /// Prepares a map as measured, whatever lies beyond its edges.
    ///
    /// # Errors
    /// [`QuestionError`]; choices of random surfaces mean nothing for a map.
    pub fn on_map(&self, relief: Relief) -> Result<PreparedBall, QuestionError> {
        let material = self.material.of_half_spaces("balls")?;
        let notes = notes_on_map(&material, &relief);
        self.prepared(Surfaces::Maps(vec![relief]), notes)
    }

    fn prepared(&self, surfaces: Surfaces, notes: Vec<Note>) -> Result<PreparedBall, QuestionError> {
        let contact_modulus_pa = self.material.of_half_spaces("balls")?.pair.composite_modulus_pa();
        Ok(PreparedBall {
            surfaces,
            notes,
            ball: Ball { radius_m: self.radius_m, force_n: self.force_n },
            pressing: BallPressing { contact_modulus_pa, tolerance: self.tolerance },
        })
    }
}

impl PreparedBall {
    /// Presses the ball onto every flat. The table has a row for each, with the columns of
    /// [`ball_table`](elements::ball_table).
    ///
    /// # Errors
    /// [`QuestionError::Ball`] if the contact reaches the edges of the flat, and for numbers out of their bounds.
    pub fn answer(&self, progress: &dyn Progress) -> Result<Answer, QuestionError> {
        let states = self.ball.press_all(&self.surfaces, &self.pressing, progress)?;
        let cautions = states.first().map(BallState::cautions).unwrap_or_default();
        let mut notes: Vec<Note> = cautions.into_iter().map(Note::Ball).collect();
        let areas_m2: Vec<f64> = states.iter().map(|state| state.real_area_m2).collect();
        notes.push(Note::of_places(&areas_m2));
        Ok(Answer { table: ball_table(&states), notes, figure: averaged_pressure(&states) })
    }
}
