//! Choice of the points of a law: as few as linear interpolation needs.

use std::f64::consts::E;

use units::Bound;

use crate::finite_elements::error::SamplingError;
use crate::finite_elements::law::{ContactLaw, LawPoint};

/// Largest ratio of pressures between the first points, as a logarithm: a factor e.
pub(super) const FIRST_STEP: f64 = 1.0;
/// Factor by which the largest error of a line exceeds that in the middle of its logarithms.
pub(super) const BEYOND_MIDDLE: f64 = 1.03;
/// Largest number of parts into which a stretch is cut at once.
const MOST_PARTS: f64 = 8.0;

impl ContactLaw {
    /// Default relative error of the pressure.
    pub const TOLERANCE: f64 = 0.01;
    /// Range of the relative error of the pressure.
    pub const TOLERANCES: Bound = Bound::Within { at_least: 1e-5, at_most: 0.5 };

    /// Samples a law from one pressure \[Pa\] to a larger one, with as many points as keep the pressure on the
    /// straight lines between them within a relative `tolerance`. `at` returns mean gap and area at a pressure
    /// \[Pa\], or `None` without a gap.
    ///
    /// # Errors
    /// [`SamplingError`] for an invalid range or tolerance, for a law that has no gap within the range or does not
    /// close, and if `at` fails.
    pub fn sample<E>(
        [from_pa, to_pa]: [f64; 2],
        tolerance: f64,
        at: impl FnMut(f64) -> Result<Option<LawPoint>, E>,
    ) -> Result<Self, SamplingError<E>> {
        check_range([from_pa, to_pa], tolerance)?;
        let mut source = Source { at, tolerance, interpolation_error: 0.0, cut_m: 0.0 };
        let cut = source.point(from_pa / E)?;
        source.cut_m = cut.mean_gap_m;
        let mut points = vec![cut];
        let looks = ((to_pa / from_pa).ln() / FIRST_STEP).ceil().max(1.0);
        let first = source.point(from_pa)?;
        source.closing(&cut, &first)?;
        points.push(first);
        let mut last = first;
        for next in source.between(&first, to_pa, looks)? {
            source.line(&last, &next, &mut points)?;
            last = next;
        }
        Ok(ContactLaw { points, tolerance, interpolation_error: source.interpolation_error })
    }
}

/// Checks the range of pressures \[Pa\] and the tolerance of a table.
pub(super) fn check_range<E>([from_pa, to_pa]: [f64; 2], tolerance: f64) -> Result<(), SamplingError<E>> {
    for pressure_pa in [from_pa, to_pa] {
        Bound::Magnitude.check("pressure of the law in Pa", pressure_pa)?;
    }
    ContactLaw::TOLERANCES.check("tolerance of the law", tolerance)?;
    if from_pa < to_pa { Ok(()) } else { Err(SamplingError::EmptyRange { from_pa, to_pa }) }
}

/// Source of a law.
struct Source<F> {
    at: F,
    tolerance: f64,
    interpolation_error: f64,
    /// Gap \[m\] of first touch, from which overclosures are counted.
    cut_m: f64,
}

impl<E, F: FnMut(f64) -> Result<Option<LawPoint>, E>> Source<F> {
    fn point(&mut self, pressure_pa: f64) -> Result<LawPoint, SamplingError<E>> {
        let point = (self.at)(pressure_pa).map_err(SamplingError::Source)?;
        let point = point.filter(|point| point.mean_gap_m.is_finite());
        let point = point.ok_or(SamplingError::NoGap { pressure_pa })?;
        Bound::Signed.check("mean gap in m", point.mean_gap_m)?;
        Ok(LawPoint { pressure_pa, ..point })
    }

    /// Points that cut a stretch into parts of equal ratio, without its beginning.
    fn between(
        &mut self,
        from: &LawPoint,
        to_pa: f64,
        parts: f64,
    ) -> Result<Vec<LawPoint>, SamplingError<E>> {
        let ratio = to_pa / from.pressure_pa;
        let inner = (1..parts as u32).map(|part| from.pressure_pa * ratio.powf(f64::from(part) / parts));
        inner.chain([to_pa]).map(|pressure_pa| self.point(pressure_pa)).collect()
    }

    /// Adds the points that a stretch needs behind its beginning. The pressure stays between those of the ends
    /// however the law bends, so that few cuts suffice.
    fn line(
        &mut self,
        from: &LawPoint,
        to: &LawPoint,
        points: &mut Vec<LawPoint>,
    ) -> Result<(), SamplingError<E>> {
        self.closing(from, to)?;
        let middle = self.point((from.pressure_pa * to.pressure_pa).sqrt())?;
        let share = (from.mean_gap_m - middle.mean_gap_m) / (from.mean_gap_m - to.mean_gap_m);
        let on_line_pa = from.pressure_pa + share * (to.pressure_pa - from.pressure_pa);
        let off = BEYOND_MIDDLE * (on_line_pa / middle.pressure_pa - 1.0).abs();
        if off <= self.tolerance {
            self.interpolation_error = self.interpolation_error.max(off);
            points.push(*to);
            return Ok(());
        }
        // The error of a line is proportional to the square of its length.
        let parts = (off / self.tolerance).sqrt().ceil().clamp(2.0, MOST_PARTS);
        let mut last = *from;
        for next in self.between(from, to.pressure_pa, parts)? {
            self.line(&last, &next, points)?;
            last = next;
        }
        Ok(())
    }

    /// Refuses a stretch over which the gap does not fall, or by so little that rounding of the overclosures would move the
    /// pressure by more than a part of the tolerance.
    fn closing(&self, from: &LawPoint, to: &LawPoint) -> Result<(), SamplingError<E>> {
        const PART: f64 = 0.1;
        let largest_m = self.cut_m.abs().max(to.mean_gap_m.abs()).max(f64::MIN_POSITIVE);
        let rounding_m = f64::EPSILON * largest_m;
        if from.mean_gap_m - to.mean_gap_m > rounding_m / (PART * self.tolerance) {
            return Ok(());
        }
        Err(SamplingError::NotClosing { from_pa: from.pressure_pa, to_pa: to.pressure_pa })
    }
}
