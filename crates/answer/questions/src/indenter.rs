//! A ball or a cylinder pressed onto a rough flat by boundary elements.

use elements::{
    Boundary, Indenter, IndenterPressing, IndenterShape, IndenterState, Pressing, Relief, Surfaces,
    indenter_table,
};
use findings::doubts::{PressedBodies, RealPressures};
use numerics::parallel::Progress;
use serde::{Deserialize, Serialize};
use study::material::Material;
use study::surface::Surface;
use units::{Remark, RemarkCode};

use crate::ball_figure::averaged_pressure;
use crate::elements::{ELEMENTS, Prepared, RandomInput, notes_on_map, notes_on_spectrum, random_surfaces};
use crate::note::remark_on_places;
use crate::{Answer, MaterialInput, QuestionError};

/// A smooth indenter under a force on a rough flat.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct IndenterQuestion {
    /// Bodies in contact; the roughness is that of both.
    pub material: MaterialInput,
    /// Shape of the indenter.
    pub shape: IndenterShape,
    /// Radius of the indenter \[m\].
    pub radius_m: f64,
    /// Force on it \[N\]; force per length \[N/m\] on a cylinder.
    pub force: f64,
    /// Largest residual, above 0 and at most 0.1; [`Pressing::TOLERANCE`] if absent.
    pub tolerance: Option<f64>,
    /// Random surfaces, for a spectrum.
    pub random: RandomInput,
}

/// Flats ready for the indenter.
pub type PreparedIndenter = Prepared<(Indenter, IndenterPressing)>;

impl IndenterQuestion {
    fn material(&self) -> Result<Material, QuestionError> {
        self.material.of_half_spaces(match self.shape {
            IndenterShape::Ball => "balls",
            IndenterShape::Cylinder => "cylinders",
        })
    }

    /// Finds a material that is missing or contradicts itself.
    ///
    /// # Errors
    /// [`QuestionError`] with the first of them.
    pub fn check(&self) -> Result<(), QuestionError> {
        self.material().map(drop)
    }

    /// Prepares random surfaces of a spectrum, each of which is a place of its own.
    ///
    /// # Errors
    /// [`QuestionError`].
    pub fn on(&self, surface: &Surface) -> Result<PreparedIndenter, QuestionError> {
        let material = self.material()?;
        let mut notes = notes_on_spectrum(&material, surface);
        let elastic = Pressing::elastic(material.pair.composite_modulus_pa());
        let (random, made) = random_surfaces(surface, &self.random, &elastic)?;
        notes.extend(made);
        self.prepared(Surfaces::Random(random), notes)
    }

    /// Prepares a map as measured: whatever lies beyond its edges under a ball, repeated along and across under a cylinder.
    ///
    /// # Errors
    /// [`QuestionError`]; choices of random surfaces mean nothing for a map.
    pub fn on_map(&self, relief: Relief) -> Result<PreparedIndenter, QuestionError> {
        let material = self.material()?;
        let mut notes = notes_on_map(&material, &relief);
        let is_repeated = self.shape == IndenterShape::Cylinder && relief.boundary == Boundary::Free;
        notes.extend(is_repeated.then(|| Remark::new(RemarkCode::RepeatedMap)));
        self.prepared(Surfaces::Maps(vec![relief]), notes)
    }

    fn prepared(&self, surfaces: Surfaces, notes: Vec<Remark>) -> Result<PreparedIndenter, QuestionError> {
        let material = self.material()?;
        let contact_modulus_pa = material.pair.composite_modulus_pa();
        let indenter = Indenter { shape: self.shape, radius_m: self.radius_m, force: self.force };
        let tolerance = self.tolerance.unwrap_or(Pressing::TOLERANCE);
        let pressing = (indenter, IndenterPressing { contact_modulus_pa, tolerance });
        Ok(Prepared { surfaces, notes, pressing, hardness_pa: material.hardness_pa() })
    }
}

impl PreparedIndenter {
    /// Presses the indenter onto every flat. The table has a row for each, with the columns of
    /// [`indenter_table`](elements::indenter_table); the figure has the averaged pressure under a ball.
    ///
    /// # Errors
    /// [`QuestionError::Indenter`] if the contact reaches the edges of the flat, and for numbers out of their bounds.
    pub fn answer(&self, progress: &dyn Progress) -> Result<Answer, QuestionError> {
        let (indenter, pressing) = &self.pressing;
        let states = indenter.press_all(&self.surfaces, pressing, progress)?;
        let shape = indenter.shape;
        let figure = match shape {
            IndenterShape::Ball => averaged_pressure(&states),
            IndenterShape::Cylinder => None,
        };
        let mut notes = states.first().map(IndenterState::remarks).unwrap_or_default();
        let areas: Vec<f64> = states.iter().map(|state| state.real_area).collect();
        notes.push(remark_on_places(&areas));
        let mut pressures = RealPressures::new(self.hardness_pa);
        let real_pa = indenter.force * areas.len() as f64 / areas.iter().sum::<f64>();
        let (modulus_pa, hardness_pa) = (pressing.contact_modulus_pa, self.hardness_pa);
        let bodies = PressedBodies { name: ELEMENTS, modulus_pa, hardness_pa, is_elastic: true };
        pressures.add_contact(&bodies, real_pa, || "this force".to_owned());
        notes.extend(pressures.doubts());
        Ok(Answer { table: indenter_table(shape, &states), notes, figure })
    }
}
