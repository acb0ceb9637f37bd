//! Choice of the points of a table of conductances: as few as linear interpolation needs.

use units::Bound;

use crate::finite_elements::conductance::between;
use crate::finite_elements::error::SamplingError;
use crate::finite_elements::sampling::{BEYOND_MIDDLE, FIRST_STEP, check_range};
use crate::finite_elements::{ConductancePoint, ConductanceTable, Flow};

/// Relative width below which a stretch is not cut: a conductance may have a step, where a law of asperities yields.
const NARROWEST: f64 = 1e-6;

impl ConductanceTable {
    /// Samples a conductance from one pressure \[Pa\] to a larger one, with as many points as keep the conductance on
    /// the straight lines between them within a relative `tolerance`. `at` returns the conductances at a pressure \[Pa\],
    /// above 0 for the spots.
    ///
    /// # Errors
    /// [`SamplingError`] for an invalid range, tolerance or conductance, and if `at` fails.
    pub fn sample<E>(
        flow: Flow,
        [from_pa, to_pa]: [f64; 2],
        tolerance: f64,
        at: impl FnMut(f64) -> Result<ConductancePoint, E>,
    ) -> Result<Self, SamplingError<E>> {
        check_range([from_pa, to_pa], tolerance)?;
        let mut source = Source { at, tolerance, interpolation_error: 0.0 };
        let first = source.point(from_pa)?;
        let zero = ConductancePoint { pressure_pa: 0.0, contact_si: 0.0, gas_si: first.gas_si };
        let mut points = vec![zero, first];
        let steps = ((to_pa / from_pa).ln() / FIRST_STEP).ceil().max(1.0);
        let mut last = first;
        for step in 1..=steps as u32 {
            let is_last = f64::from(step) == steps;
            let share = f64::from(step) / steps;
            let next_pa = if is_last { to_pa } else { from_pa * (to_pa / from_pa).powf(share) };
            let next = source.point(next_pa)?;
            source.line(&last, &next, &mut points)?;
            last = next;
        }
        Ok(ConductanceTable { flow, points, interpolation_error: source.interpolation_error })
    }
}

/// Source of conductances.
struct Source<F> {
    at: F,
    tolerance: f64,
    interpolation_error: f64,
}

impl<E, F: FnMut(f64) -> Result<ConductancePoint, E>> Source<F> {
    fn point(&mut self, pressure_pa: f64) -> Result<ConductancePoint, SamplingError<E>> {
        let point = (self.at)(pressure_pa).map_err(SamplingError::Source)?;
        Bound::Magnitude.check("conductance of the spots", point.contact_si)?;
        Bound::AtLeast(0.0).check("conductance of the gas", point.gas_si)?;
        Ok(ConductancePoint { pressure_pa, ..point })
    }

    /// Adds the points that a stretch needs behind its beginning.
    fn line(
        &mut self,
        from: &ConductancePoint,
        to: &ConductancePoint,
        points: &mut Vec<ConductancePoint>,
    ) -> Result<(), SamplingError<E>> {
        let middle = self.point((from.pressure_pa * to.pressure_pa).sqrt())?;
        let off = BEYOND_MIDDLE * (between(from, to, middle.pressure_pa) / middle.total_si() - 1.0).abs();
        if off <= self.tolerance || to.pressure_pa < (1.0 + NARROWEST) * from.pressure_pa {
            self.interpolation_error = self.interpolation_error.max(off);
            points.push(*to);
            return Ok(());
        }
        self.line(from, &middle, points)?;
        self.line(&middle, to, points)
    }
}
