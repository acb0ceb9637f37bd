//! Linear axes: their range in whole steps, their ticks, and the prefix of their unit.

use std::sync::Arc;

use kuva::TickFormat;
use units::display::percent;

/// Units that take a prefix.
const UNITS: [&str; 5] = ["m", "Pa", "N", "J/m²", "Pa/m"];
/// Prefixes with their powers of ten.
const PREFIXES: [(&str, i32); 9] =
    [("f", -15), ("p", -12), ("n", -9), ("µ", -6), ("m", -3), ("", 0), ("k", 3), ("M", 6), ("G", 9)];
/// An axis begins at zero if its least value is below this share of its largest.
const NEAR_ZERO: f64 = 0.3;
/// Unlabelled parts of a step.
const PARTS: f64 = 5.0;

/// The range of a linear axis and the step between its labelled ticks, in its unit with a prefix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Steps {
    /// The value at which it begins.
    pub first: f64,
    /// The value at which it ends.
    pub last: f64,
    /// The difference from one labelled tick to the next.
    pub step: f64,
    /// The power of ten that the prefix means.
    power: i32,
}

impl Steps {
    /// Returns the range of whole steps around all finite values, of at most `most` steps. Only a label that ends with a unit in
    /// brackets leaves a prefix to choose.
    pub fn around(values: impl Iterator<Item = f64>, label: &str, most: f64) -> Self {
        let finite = values.filter(|value| value.is_finite());
        let (low, high) = finite
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        let (low, high) = match () {
            _ if low > high || (low == 0.0 && high == 0.0) => (0.0, 1.0),
            _ if low == high || (low > 0.0 && low < NEAR_ZERO * high) => (low.min(0.0), high.max(0.0)),
            _ if high < 0.0 && high > NEAR_ZERO * low => (low, 0.0),
            _ => (low, high),
        };
        let power = split_unit(label).map_or(0, |_| thousands(low.abs().max(high.abs())));
        let scale = 10f64.powi(power);
        let (low, high) = (low / scale, high / scale);
        let finest = 10f64.powf(((high - low) / most).log10().floor());
        let fits = |step: &f64| (high / step).ceil() - (low / step).floor() <= most;
        let step = [1.0, 2.0, 5.0, 10.0, 20.0].map(|factor| factor * finest).into_iter().find(fits);
        let step = step.unwrap_or(high - low);
        Steps { first: (low / step).floor() * step, last: (high / step).ceil() * step, step, power }
    }

    /// Returns a value in the unit with its prefix.
    pub fn place(&self, value: f64) -> f64 {
        value / 10f64.powi(self.power)
    }

    /// Returns the unlabelled ticks between the labelled ones.
    pub fn minor_ticks(&self) -> Vec<f64> {
        let steps = ((self.last - self.first) / self.step).round() as usize;
        let parts = PARTS as usize;
        let ticks = (0..steps * parts).filter(|part| part % parts != 0);
        ticks.map(|part| self.first + part as f64 * self.step / PARTS).collect()
    }

    /// Returns the labels of its ticks: plain numbers with as many decimals as the step has.
    pub fn numbers(&self) -> TickFormat {
        let decimals = (-(self.step * (1.0 + 1e-9)).log10().floor()).max(0.0) as usize;
        let step = self.step;
        TickFormat::Custom(Arc::new(move |value| number(value, step, decimals)))
    }

    /// Returns the labels of its ticks in percent.
    pub fn percents(&self) -> TickFormat {
        let step = self.step;
        TickFormat::Custom(Arc::new(
            move |value| if is_zero(value, step) { "0".to_owned() } else { percent(value) },
        ))
    }

    /// Returns the label with the prefix of its unit: `mean gap (nm)`.
    pub fn label(&self, label: &str) -> String {
        let prefix = PREFIXES.iter().find(|(_, power)| *power == self.power);
        match split_unit(label).zip(prefix) {
            Some(((quantity, unit), (prefix, _))) => format!("{quantity} ({prefix}{unit})"),
            None => label.to_owned(),
        }
    }

    /// Returns the factor from the unit to the unit with its prefix.
    pub fn scale(&self) -> f64 {
        10f64.powi(self.power)
    }
}

/// The quantity and the unit of a label such as `mean gap (m)`, if the unit takes a prefix.
fn split_unit(label: &str) -> Option<(&str, &str)> {
    let (quantity, unit) = label.strip_suffix(')')?.rsplit_once(" (")?;
    UNITS.contains(&unit).then_some((quantity, unit))
}

/// The power of a prefix that leaves one to three digits before the point.
fn thousands(largest: f64) -> i32 {
    let [(_, least), .., (_, most)] = PREFIXES;
    // A largest value just below a power of ten ends on that power.
    let thousands = ((largest * (1.0 + 1e-9)).log10() / 3.0).floor();
    (3 * thousands as i32).clamp(least, most)
}

fn is_zero(value: f64, step: f64) -> bool {
    value.abs() < 1e-6 * step
}

/// A number with a minus sign as wide as a plus.
fn number(value: f64, step: f64, decimals: usize) -> String {
    match value {
        value if is_zero(value, step) => "0".to_owned(),
        value if value < 0.0 => format!("\u{2212}{:.decimals$}", -value),
        value => format!("{value:.decimals$}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(steps: &Steps) -> Vec<String> {
        let count = ((steps.last - steps.first) / steps.step).round() as usize;
        let format = steps.numbers();
        (0..=count).map(|at| format.format(steps.first + at as f64 * steps.step)).collect()
    }

    #[test]
    fn ticks_are_round_numbers_of_the_unit_with_a_prefix() {
        let pressures = Steps::around([-2.3e4, 1.1e3].into_iter(), "mean pressure (Pa)", 7.0);
        assert_eq!(
            labels(&pressures),
            ["\u{2212}25", "\u{2212}20", "\u{2212}15", "\u{2212}10", "\u{2212}5", "0", "5"]
        );
        assert_eq!(pressures.label("mean pressure (Pa)"), "mean pressure (kPa)");
        assert_eq!(pressures.place(-5e3), -5.0);
        let gaps = Steps::around([1.1e-9, 5.9e-9].into_iter(), "mean gap (m)", 6.0);
        assert_eq!(labels(&gaps), ["0", "1", "2", "3", "4", "5", "6"]);
        let narrow = Steps::around([0.91, 1.32].into_iter(), "shear (N)", 5.0);
        assert_eq!(labels(&narrow), ["0.9", "1.0", "1.1", "1.2", "1.3", "1.4"]);
    }

    #[test]
    fn a_number_without_a_unit_has_no_prefix_and_shares_are_percents() {
        let shares = Steps::around([0.0, 0.34].into_iter(), "contact area / nominal area", 7.0);
        assert_eq!(
            (shares.label("contact area / nominal area").as_str(), shares.scale()),
            ("contact area / nominal area", 1.0)
        );
        assert_eq!([shares.percents().format(0.0), shares.percents().format(0.1)], ["0", "10 %"]);
        // The unit of an inverse length squared takes no prefix.
        assert_eq!(Steps::around([0.0, 3e-9].into_iter(), "density (1/m²)", 7.0).scale(), 1.0);
    }

    #[test]
    fn values_that_do_not_differ_have_an_axis() {
        for values in [vec![], vec![0.0], vec![3.0, 3.0], vec![-3.0], vec![f64::NAN]] {
            let steps = Steps::around(values.iter().copied(), "force (N)", 6.0);
            assert!(steps.last > steps.first && steps.step > 0.0, "{values:?}: {steps:?}");
            assert!(values.iter().all(|value| !(*value < steps.first || *value > steps.last)), "{steps:?}");
        }
        let minor = Steps::around([0.0, 2.0].into_iter(), "force (N)", 2.0).minor_ticks();
        assert_eq!(minor.len(), 8, "{minor:?}");
    }
}
