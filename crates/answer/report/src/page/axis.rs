//! Logarithmic axes of figures on pages.

/// The largest number of decades with a tick each.
const MAX_TICKS: i32 = 9;

/// A logarithmic axis from one value to another, in units of the drawing.
#[derive(Clone, Copy)]
pub(super) struct Axis {
    pub least: f64,
    pub most: f64,
    pub start: f64,
    pub end: f64,
}

impl Axis {
    pub fn place(&self, value: f64) -> f64 {
        let share = (value / self.least).ln() / (self.most / self.least).ln();
        self.start + share * (self.end - self.start)
    }

    /// The powers of ten on the axis, thinned to a few.
    pub fn powers(&self) -> impl Iterator<Item = i32> + use<> {
        let (first, last) =
            ((self.least.log10() - 1e-9).ceil() as i32, (self.most.log10() + 1e-9).floor() as i32);
        let step = ((last - first) / MAX_TICKS + 1) as usize;
        (first..=last).rev().step_by(step)
    }

    /// The values of these powers.
    pub fn ticks(&self) -> impl Iterator<Item = f64> + use<> {
        self.powers().map(|power| 10f64.powi(power))
    }
}
