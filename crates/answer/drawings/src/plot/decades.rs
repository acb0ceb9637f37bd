//! Logarithmic axes: their range in powers of ten, their ticks and the labels of these.

use std::sync::Arc;

use kuva::TickFormat;

use units::display::{length, power_of_ten, share};

pub(super) const MAX_TICKS: f64 = 9.0;

/// The range of an axis in powers of ten, and the step between its labelled ticks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Decades {
    /// The power at which it begins.
    pub first: f64,
    /// The power at which it ends.
    pub last: f64,
    /// Decades from one labelled tick to the next.
    pub step: f64,
}

impl Decades {
    /// The range of whole steps around every positive value.
    pub fn around(values: impl Iterator<Item = f64>) -> Self {
        Decades::with_ticks(values, MAX_TICKS)
    }

    /// The range of whole steps around every positive value, of fewer steps than this.
    pub fn with_ticks(values: impl Iterator<Item = f64>, most: f64) -> Self {
        let (low, high) = values
            .filter(|value| *value > 0.0)
            .map(f64::log10)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        if low > high {
            return Decades { first: 0.0, last: 1.0, step: 1.0 };
        }
        let span = (high.ceil() - low.floor()).max(1.0);
        let step = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0].into_iter().find(|step| span / step < most);
        let step = step.unwrap_or(span);
        let first = (low / step).floor() * step;
        Decades { first, last: ((high / step).ceil() * step).max(first + step), step }
    }

    /// The powers of unlabelled ticks: the multiples 2 to 9 of each decade, or the decades between labels.
    pub fn minor_ticks(&self) -> Vec<f64> {
        let powers = (0..).map(|i| self.first + f64::from(i)).take_while(|power| *power < self.last);
        if self.step == 1.0 {
            powers.flat_map(|power| (2..10).map(move |i| power + f64::from(i).log10())).collect()
        } else {
            powers.filter(|power| (power / self.step).fract() != 0.0).collect()
        }
    }
}

/// Ticks labelled 10⁻⁸ and so on.
pub(super) fn powers_of_ten() -> TickFormat {
    TickFormat::Custom(Arc::new(|power| power_of_ten(power.round() as i32)))
}

/// Ticks labelled 100 nm, 1 µm and so on.
pub(super) fn lengths() -> TickFormat {
    TickFormat::Custom(Arc::new(|power| length(10f64.powi(power.round() as i32))))
}

/// Ticks labelled 10 ppm, 0.01 % and so on.
pub(super) fn shares() -> TickFormat {
    TickFormat::Custom(Arc::new(|power| share(10f64.powi(power.round() as i32))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn minor_ticks_stand_between_the_labelled_ones() {
        let narrow = Decades::around([2.0, 30.0].into_iter());
        assert_eq!((narrow.first, narrow.last, narrow.step), (0.0, 2.0, 1.0));
        assert_eq!(narrow.minor_ticks().len(), 16);
        let wide = Decades::around([1e-40, 1e-20].into_iter());
        assert_eq!((wide.first, wide.last, wide.step), (-40.0, -20.0, 5.0));
        assert_eq!(wide.minor_ticks().len(), 16);
        assert_eq!(wide.minor_ticks()[..2], [-39.0, -38.0]);
    }
}
