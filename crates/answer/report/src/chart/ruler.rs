//! Axes: the place of a value, the ticks with their labels, and the label.

use units::display::{length, percent, power_of_ten, share};

/// Units that take a prefix.
const UNITS: [&str; 5] = ["m", "Pa", "N", "J/m²", "Pa/m"];
/// Prefixes with their powers of ten.
const PREFIXES: [(&str, i32); 9] =
    [("f", -15), ("p", -12), ("n", -9), ("µ", -6), ("m", -3), ("", 0), ("k", 3), ("M", 6), ("G", 9)];
/// A linear axis begins at zero if its least value is below this share of its largest.
const NEAR_ZERO: f64 = 0.3;
/// Unlabelled parts of a step.
const PARTS: usize = 5;
/// The most labelled ticks of a logarithmic axis.
pub(super) const MOST_POWERS: f64 = 9.0;

/// The quantity that labels of ticks spell out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum TickWords {
    /// A number; a power of ten on a logarithmic axis.
    Number,
    /// A length with its unit on a logarithmic axis: 100 nm, 1 µm.
    Length,
    /// A share of an area: 10 ppm, 0.01 %.
    Share,
}

/// An axis: powers of ten, or equal steps of a unit with its prefix. Ends and ticks are places in these.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Ruler {
    is_logarithmic: bool,
    /// The value of one on a linear axis.
    unit: f64,
    ends: [f64; 2],
    ends_px: [f64; 2],
    /// The places of labelled ticks, with their labels.
    pub ticks: Vec<(f64, String)>,
    /// The places of unlabelled ticks.
    pub minor_ticks: Vec<f64>,
    /// The label of the axis.
    pub label: String,
}

impl Ruler {
    /// Returns a logarithmic axis of whole decades around all positive values, with fewer labelled ticks than `most`.
    pub fn decades(values: impl Iterator<Item = f64>, words: TickWords, label: &str, most: f64) -> Self {
        let (low, high) = range(values.filter(|value| *value > 0.0).map(f64::log10)).unwrap_or((0.0, 1.0));
        let span = (high.ceil() - low.floor()).max(1.0);
        let steps = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0];
        let step = steps.into_iter().find(|step| span / step < most.min(MOST_POWERS)).unwrap_or(span);
        let first = (low / step).floor() * step;
        let last = ((high / step).ceil() * step).max(first + step);
        // Shares above the whole are factors.
        let words = if words == TickWords::Share && last > 0.0 { TickWords::Number } else { words };
        let powers = (0..).map(|i| first + f64::from(i)).take_while(|power| *power < last);
        let minor_ticks = match step {
            1.0 => powers.flat_map(|power| (2..10).map(move |i| power + f64::from(i).log10())).collect(),
            _ => powers.filter(|power| (power / step).fract() != 0.0).collect(),
        };
        let count = ((last - first) / step).round() as usize;
        let tick = |at: usize| first + at as f64 * step;
        Ruler {
            ticks: (0..=count).map(tick).map(|power| (power, power_label(power, words))).collect(),
            minor_ticks,
            label: label
                .strip_suffix(" (m)")
                .filter(|_| words == TickWords::Length)
                .unwrap_or(label)
                .to_owned(),
            ..Ruler::between(true, 1.0, [first, last])
        }
    }

    /// Returns an axis of decades with its ends a little beyond these values, if it keeps two labelled ticks; linear ones stay.
    pub fn cut_to(self, values: impl Iterator<Item = f64>) -> Self {
        const ROOM: f64 = 0.02;
        let inside = values.filter(|value| self.is_logarithmic && *value > 0.0);
        let Some((low, high)) = range(inside.map(f64::log10)) else {
            return self;
        };
        let room = ROOM * (high - low);
        let ends = [self.ends[0].max(low - room), self.ends[1].min(high + room)];
        let is_inside = |place: f64| (ends[0]..=ends[1]).contains(&place);
        let ticks: Vec<(f64, String)> =
            self.ticks.iter().filter(|(place, _)| is_inside(*place)).cloned().collect();
        if ticks.len() < 2 {
            return self;
        }
        let minor_ticks = self.minor_ticks.iter().copied().filter(|place| is_inside(*place)).collect();
        Ruler { ends, ticks, minor_ticks, ..self }
    }

    /// Returns a logarithmic axis from one value to another, with a tick at each power of ten or at some of them.
    pub fn tight([least, most]: [f64; 2], words: TickWords) -> Self {
        let (first, last) = ((least.log10() - 1e-9).ceil() as i32, (most.log10() + 1e-9).floor() as i32);
        let powers = (first..=last).rev().step_by(((last - first).max(0) / MOST_POWERS as i32 + 1) as usize);
        let tick = |power: i32| (f64::from(power), power_label(f64::from(power), words));
        Ruler {
            ticks: powers.map(tick).collect(),
            ..Ruler::between(true, 1.0, [least.log10(), most.log10()])
        }
    }

    /// Returns a linear axis of at most `most` whole steps around all finite values. A label that ends with a unit in
    /// brackets gets a prefix.
    pub fn steps(values: impl Iterator<Item = f64>, words: TickWords, label: &str, most: f64) -> Self {
        let (low, high) = match range(values.filter(|value| value.is_finite())) {
            None | Some((0.0, 0.0)) => (0.0, 1.0),
            Some((low, high)) if low == high || (low > 0.0 && low < NEAR_ZERO * high) => {
                (low.min(0.0), high.max(0.0))
            }
            Some((low, high)) if high < 0.0 && high > NEAR_ZERO * low => (low, 0.0),
            Some(ends) => ends,
        };
        let power = split_unit(label).map_or(0, |_| thousands(low.abs().max(high.abs())));
        let unit = 10f64.powi(power);
        let (low, high) = (low / unit, high / unit);
        let step = step(low, high, most);
        let (first, last) = ((low / step).floor(), (high / step).ceil());
        let prefix = PREFIXES.iter().find(|(_, of)| *of == power);
        let label = match split_unit(label).zip(prefix) {
            Some(((quantity, unit), (prefix, _))) => format!("{quantity} ({prefix}{unit})"),
            None => label.to_owned(),
        };
        Ruler { label, ..Ruler::stepped(unit, [first * step, last * step], step, words) }
    }

    /// Returns a linear axis that ends a little beyond the values, whose label has its unit.
    pub fn around(values: impl Iterator<Item = f64>, label: &str, most: f64) -> Self {
        let (low, high) = range(values).unwrap_or((0.0, 1.0));
        let (low, high) =
            if low == high { (low - 0.5 * low.abs(), high + 0.5 * high.abs()) } else { (low, high) };
        let room = if low == high { 1.0 } else { 0.01 * (high - low) };
        let ends = [if low >= 0.0 { (low - room).max(0.0) } else { low - room }, high + room];
        let step = step(ends[0], ends[1], most);
        Ruler { label: label.to_owned(), ..Ruler::stepped(1.0, ends, step, TickWords::Number) }
    }

    /// Returns a linear axis with ticks at all multiples of a step.
    fn stepped(unit: f64, ends: [f64; 2], step: f64, words: TickWords) -> Self {
        let multiples = |step: f64| {
            let [first, last] = [(ends[0] / step - 1e-6).ceil(), (ends[1] / step + 1e-6).floor()];
            (0..=(last - first).max(0.0) as usize).map(move |at| (first + at as f64) * step)
        };
        let is_labelled = |place: f64| ((place / step).round() - place / step).abs() < 1e-6;
        Ruler {
            ticks: multiples(step).map(|place| (place, step_label(place, step, words))).collect(),
            minor_ticks: multiples(step / PARTS as f64).filter(|place| !is_labelled(*place)).collect(),
            ..Ruler::between(false, unit, ends)
        }
    }

    fn between(is_logarithmic: bool, unit: f64, ends: [f64; 2]) -> Self {
        let (ticks, minor_ticks) = (Vec::new(), Vec::new());
        Ruler { is_logarithmic, unit, ends, ends_px: [0.0, 1.0], ticks, minor_ticks, label: String::new() }
    }

    /// Lays the axis over pixels.
    pub fn over(mut self, ends_px: [f64; 2]) -> Self {
        self.ends_px = ends_px;
        self
    }

    /// Returns the pixel of a value, if it has a place: only positive values have one on a logarithmic axis.
    pub fn px(&self, value: f64) -> Option<f64> {
        match self.is_logarithmic {
            true => (value > 0.0).then(|| self.place_px(value.log10())),
            false => value.is_finite().then(|| self.place_px(value / self.unit)),
        }
    }

    /// Returns the pixel of a value, or the first pixel of the axis if it has no place.
    pub fn px_or_first(&self, value: f64) -> f64 {
        self.px(value).unwrap_or(self.ends_px[0])
    }

    /// Returns the pixel of a value, held between the ends.
    pub fn px_within(&self, value: f64) -> f64 {
        let [first, last] = self.ends_px;
        self.px_or_first(value).clamp(first.min(last), first.max(last))
    }

    /// Returns the pixel of a place.
    pub fn place_px(&self, place: f64) -> f64 {
        let ([first, last], [from, to]) = (self.ends, self.ends_px);
        from + (place - first) / (last - first) * (to - from)
    }

    /// Returns the pixel of zero on a linear axis that crosses it.
    pub fn zero_px(&self) -> Option<f64> {
        let [first, last] = self.ends;
        (!self.is_logarithmic && first < 0.0 && last > 0.0).then(|| self.place_px(0.0))
    }
}

/// Returns where an axis of areas begins that leaves room below the least: at a half or a whole decade.
pub(crate) fn floor_below(least: f64) -> f64 {
    10f64.powf((2.0 * (0.6 * least).log10()).floor() / 2.0)
}

/// The least and the largest value, if there is one.
fn range(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    values.fold(None, |ends: Option<(f64, f64)>, value| {
        Some(ends.map_or((value, value), |(low, high)| (low.min(value), high.max(value))))
    })
}

/// The smallest round step of which at most `most` reach from a value to another.
fn step(low: f64, high: f64, most: f64) -> f64 {
    let finest = 10f64.powf(((high - low) / most).log10().floor());
    let fits = |step: &f64| (high / step).ceil() - (low / step).floor() <= most;
    let steps = [1.0, 2.0, 5.0, 10.0, 20.0].map(|factor| factor * finest);
    steps.into_iter().find(fits).unwrap_or(high - low)
}

fn power_label(power: f64, words: TickWords) -> String {
    let power = power.round() as i32;
    match words {
        TickWords::Number => power_of_ten(power),
        TickWords::Length => length(10f64.powi(power)),
        TickWords::Share => share(10f64.powi(power)),
    }
}

/// A plain number with as many decimals as the step has and a minus sign as wide as a plus, or percent.
fn step_label(place: f64, step: f64, words: TickWords) -> String {
    let decimals = (-(step * (1.0 + 1e-9)).log10().floor()).max(0.0) as usize;
    match place {
        place if place.abs() < 1e-6 * step => "0".to_owned(),
        place if words == TickWords::Share => percent(place),
        place if place < 0.0 => format!("\u{2212}{:.decimals$}", -place),
        place => format!("{place:.decimals$}"),
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

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(ruler: &Ruler) -> Vec<&str> {
        ruler.ticks.iter().map(|(_, label)| label.as_str()).collect()
    }

    fn steps(values: &[f64], words: TickWords, label: &str, most: f64) -> Ruler {
        Ruler::steps(values.iter().copied(), words, label, most)
    }

    #[test]
    fn minor_ticks_lie_between_the_labelled_ones() {
        let decades = |values: [f64; 2], words| Ruler::decades(values.into_iter(), words, "size (m)", 9.0);
        let narrow = decades([2.0, 30.0], TickWords::Number);
        assert_eq!((narrow.ends, labels(&narrow)), ([0.0, 2.0], vec!["10⁰", "10¹", "10²"]));
        assert_eq!((narrow.minor_ticks.len(), narrow.label.as_str()), (16, "size (m)"));
        let wide = decades([1e-40, 1e-20], TickWords::Number);
        assert_eq!(
            (wide.ends, wide.ticks.len(), &wide.minor_ticks[..2]),
            ([-40.0, -20.0], 5, &[-39.0, -38.0][..])
        );
        let lengths = decades([2e-9, 3e-6], TickWords::Length);
        assert_eq!((labels(&lengths)[..2].to_vec(), lengths.label.as_str()), (vec!["1 nm", "10 nm"], "size"));
        assert_eq!(labels(&decades([0.02, 1.0], TickWords::Share)), ["1 %", "10 %", "100 %"]);
        assert_eq!(labels(&decades([0.2, 3.0], TickWords::Share)), ["10⁻¹", "10⁰", "10¹"]);
        let cut = decades([2e-9, 3e-6], TickWords::Length).cut_to([2e-9, 3e-6].into_iter());
        assert_eq!(labels(&cut), ["10 nm", "100 nm", "1 µm"]);
        assert!(cut.ends[0] > -8.8 && cut.ends[1] < -5.4, "{:?}", cut.ends);
        assert_eq!(narrow.clone().cut_to([2.0, 30.0].into_iter()), narrow, "one tick is too few");
    }

    #[test]
    fn steps_are_round_numbers_of_the_unit_with_a_prefix() {
        let pressures =
            steps(&[-2.3e4, 1.1e3], TickWords::Number, "mean pressure (Pa)", 7.0).over([0.0, 30.0]);
        let minus = ["\u{2212}25", "\u{2212}20", "\u{2212}15", "\u{2212}10", "\u{2212}5", "0", "5"];
        assert_eq!((labels(&pressures), pressures.label.as_str()), (minus.to_vec(), "mean pressure (kPa)"));
        assert_eq!((pressures.px(-5e3), pressures.zero_px()), (Some(20.0), Some(25.0)));
        let gaps = steps(&[1.1e-9, 5.9e-9], TickWords::Number, "mean gap (m)", 6.0);
        assert_eq!(labels(&gaps), ["0", "1", "2", "3", "4", "5", "6"]);
        let narrow = steps(&[0.91, 1.32], TickWords::Number, "shear (N)", 5.0);
        assert_eq!(labels(&narrow), ["0.9", "1.0", "1.1", "1.2", "1.3", "1.4"]);
        let shares = steps(&[0.0, 0.34], TickWords::Share, "contact area / nominal area", 7.0);
        assert_eq!((labels(&shares)[..2].to_vec(), shares.unit), (vec!["0", "5 %"], 1.0));
        // The unit of an inverse length squared takes no prefix.
        assert_eq!(steps(&[0.0, 3e-9], TickWords::Number, "density (1/m²)", 7.0).unit, 1.0);
    }

    #[test]
    fn values_that_do_not_differ_have_an_axis() {
        for values in [vec![], vec![0.0], vec![3.0, 3.0], vec![-3.0], vec![f64::NAN]] {
            let found = steps(&values, TickWords::Number, "force (N)", 6.0);
            let [first, last] = found.ends;
            assert!(last > first && found.ticks.len() > 1, "{values:?}: {found:?}");
            assert!(values.iter().all(|value| !(*value < first || *value > last)), "{found:?}");
            let around = Ruler::around(values.iter().copied().filter(|value| value.is_finite()), "z", 6.0);
            assert!(around.ends[1] > around.ends[0] && !around.ticks.is_empty(), "{around:?}");
        }
        assert_eq!(steps(&[0.0, 2.0], TickWords::Number, "force (N)", 2.0).minor_ticks.len(), 8);
        let powers = Ruler::tight([2e-9, 3e-5], TickWords::Length);
        assert_eq!(labels(&powers), ["10 µm", "1 µm", "100 nm", "10 nm"]);
    }
}
