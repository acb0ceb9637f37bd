//! Outline of a specimen, and its own compliance: how far the half-space sinks under it as a whole.

use numerics::parallel::Progress;
use serde::{Deserialize, Serialize};
use units::named;

use crate::half_space::{Elements, Grid, HalfSpaceError};
use crate::relief::Boundary;

/// Compliance of a specimen as a whole that is taken out of the stiffness of a contact with free edges.
///
/// Such a stiffness is the load per approach of two half-spaces, which sink under the nominal contact even where the surfaces are
/// smooth. A stiffness of the interface, as for a finite-element model of the bodies, is without that share.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SpecimenCompliance {
    /// Nothing is taken out.
    #[default]
    None,
    /// The approach of a rigid flat punch of the outline: the bodies behind the interface are stiff.
    Punch,
    /// The mean displacement under even pressure on the outline: the bodies behind the interface pass the load on evenly.
    Even,
}

named!(SpecimenCompliance, "compliance of the specimen", { None => "none", Punch => "punch", Even => "even" });

/// Points of a map that belong to the specimen.
///
/// Missing points that rows and columns of missing points connect with the edge of the frame lie outside the specimen: they are no
/// part of the nominal area. All others are holes: they are part of it. Neither kind ever touches. A periodic map has no outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    grid: Grid,
    boundary: Boundary,
    is_inside: Vec<bool>,
    points: usize,
}

impl Outline {
    /// Finds the outline among the missing points of a map.
    ///
    /// # Errors
    /// [`HalfSpaceError`] if no point has a height, or if `is_missing` has another size than the grid.
    pub fn new(grid: Grid, boundary: Boundary, is_missing: &[bool]) -> Result<Self, HalfSpaceError> {
        grid.check_size(is_missing.len())?;
        if !is_missing.contains(&false) {
            return Err(HalfSpaceError::NoSpecimen);
        }
        let (rows, columns) = (grid.rows(), grid.columns());
        let mut is_inside = vec![true; grid.points()];
        // Points outside whose neighbours have not been visited.
        let mut front = Vec::new();
        let mut leave = |row: usize, column: usize, front: &mut Vec<(usize, usize)>| {
            let point = row * columns + column;
            if is_missing[point] && std::mem::replace(&mut is_inside[point], false) {
                front.push((row, column));
            }
        };
        if boundary == Boundary::Free {
            for column in 0..columns {
                leave(0, column, &mut front);
                leave(rows - 1, column, &mut front);
            }
            for row in 0..rows {
                leave(row, 0, &mut front);
                leave(row, columns - 1, &mut front);
            }
        }
        while let Some((row, column)) = front.pop() {
            let next = [(row.wrapping_sub(1), column), (row + 1, column)];
            let beside = [(row, column.wrapping_sub(1)), (row, column + 1)];
            for (row, column) in next.into_iter().chain(beside) {
                if row < rows && column < columns {
                    leave(row, column, &mut front);
                }
            }
        }
        let points = is_inside.iter().filter(|is_inside| **is_inside).count();
        Ok(Self { grid, boundary, is_inside, points })
    }

    /// Returns for each point of the frame, row by row, true if it belongs to the specimen.
    #[must_use]
    pub fn is_inside(&self) -> &[bool] {
        &self.is_inside
    }

    /// Number of points that belong to the specimen.
    #[must_use]
    pub fn points(&self) -> usize {
        self.points
    }

    /// Nominal area of the specimen over the area of the frame.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.points as f64 / self.grid.points() as f64
    }

    /// Nominal area of the specimen \[m^2\].
    #[must_use]
    pub fn area_m2(&self) -> f64 {
        self.share() * self.grid.length_x_m() * self.grid.length_y_m()
    }

    /// Returns the compliance of the specimen as a whole \[m/Pa\]: the approach per nominal pressure, which is the force over the
    /// area of the specimen. 0 of a periodic map, whose displacements have a mean of 0.
    ///
    /// It is computed with the elements of the contact itself, so that their errors at the edges (1 to 2 % for a punch 100 points
    /// across) are the same in both and cancel in the difference.
    ///
    /// # Errors
    /// [`HalfSpaceError`] for a modulus out of bounds, and if `progress` cancels.
    pub fn compliance_m_per_pa(
        &self,
        kind: SpecimenCompliance,
        contact_modulus_pa: f64,
        progress: &dyn Progress,
    ) -> Result<f64, HalfSpaceError> {
        if kind == SpecimenCompliance::None || self.boundary == Boundary::Periodic {
            return Ok(0.0);
        }
        let inside: Vec<u32> = (0u32..)
            .zip(&self.is_inside)
            .filter_map(|(point, is_inside)| is_inside.then_some(point))
            .collect();
        let mut flat = Elements::free(self.grid, &vec![0.0; self.grid.points()])?;
        let per_mean_of_frame = match kind {
            SpecimenCompliance::Even => flat.mean_displacement_m_per_pa(&inside, contact_modulus_pa)?,
            _ => 1.0 / flat.stiffness_together(&inside, contact_modulus_pa, progress)?,
        };
        Ok(self.share() * per_mean_of_frame)
    }
}

/// Takes the compliance of a specimen \[m/Pa\] out of the stiffness of its contact \[Pa/m\], both over the area of the specimen.
/// `None` if nothing is left: if all of the specimen touches, or if the contact is stiffer than the compliance allows.
#[must_use]
pub fn stiffness_without(compliance_m_per_pa: f64, stiffness_pa_per_m: f64) -> Option<f64> {
    let rest = 1.0 - compliance_m_per_pa * stiffness_pa_per_m;
    (rest > LEAST_REST).then(|| stiffness_pa_per_m / rest)
}

/// Share of the compliance of a contact below which the rest is no more than the errors of both, each 1e-8.
const LEAST_REST: f64 = 1e-6;
