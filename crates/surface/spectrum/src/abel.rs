//! The spectrum of the profiles of a surface, C1D(q) = (1/pi) Int_q^inf p Ciso(p) (p^2 - q^2)^(-1/2) dp (Jacobs, Junge &
//! Pastewka 2017, Surf. Topogr.: Metrol. Prop. 5:013001). The way back is
//! [`AreaSpectrum::from_profile`](crate::random_surfaces::AreaSpectrum::from_profile).
//!
//! As everywhere in this crate, a spectrum is a power law between neighbouring samples and zero outside them. C1D then falls to
//! zero at the last sample; its value there is the end of a power law such that the rms gradient of the surface is kept.

use std::sync::LazyLock;

use numerics::{GaussLegendre, zero_in_bracket};

use std::f64::consts::TAU;

use crate::interval::{Interval, Sample, ln_ratio};
use crate::power_law::PowerLaw;

/// Computes C1D \[m^3\] from Ciso \[m^4\]; wavelengths \[m\] from long to short.
///
/// Relative error below 1e-12 for the piecewise power law, except the last sample, which keeps the gradient. The work grows as the
/// square of the number of samples.
pub(crate) fn profile_of_area(wavelengths_m: &[f64], ciso_m4: &[f64]) -> Vec<f64> {
    // p Ciso/pi is a power law where Ciso is one.
    let sample = |at: usize| (TAU / wavelengths_m[at], 2.0 * ciso_m4[at] / wavelengths_m[at]);
    let pieces = (1..ciso_m4.len()).map(|end| PowerLaw::through(sample(end - 1), sample(end)));
    let integral = AbelIntegral::new(pieces);
    let c1d_at = |q: f64| integral.from(q);
    let last = wavelengths_m.len() - 1;
    let mut c1d_m3: Vec<f64> =
        wavelengths_m[..last].iter().map(|wavelength_m| c1d_at(TAU / wavelength_m)).collect();
    c1d_m3.push(last_of_profile(wavelengths_m, &c1d_m3, c1d_at));
    c1d_m3
}

/// Intervals at the end of a profile whose second moment is kept together: there C1D bends most between its samples.
const BENT: usize = 4;

/// The last sample of C1D, such that power laws between the samples have the Int q^2 C1D dq of the last intervals.
fn last_of_profile(wavelengths_m: &[f64], c1d_m3: &[f64], c1d_at: impl Fn(f64) -> f64) -> f64 {
    let last = wavelengths_m.len() - 1;
    let q = |at: usize| TAU / wavelengths_m[at];
    // C1D falls as the root of the distance from its end, which the substitution q = end - width s^2 removes.
    let moment = |from: usize| -> f64 {
        let (end, width) = (q(from + 1), q(from + 1) - q(from));
        let at = |&(s, weight): &(f64, f64)| {
            let q = end - width * s * s;
            2.0 * width * s * weight * q * q * c1d_at(q)
        };
        gauss_nodes::<NODES>(&RULE, 0.0, 1.0).iter().map(at).sum()
    };
    let first = last.saturating_sub(BENT);
    let of_last = moment(last - 1);
    let missed = (first..last - 1).map(moment).sum::<f64>()
        - second_moment(&wavelengths_m[first..last], &c1d_m3[first..last], 2);
    let wanted = (of_last + missed).clamp(0.5 * of_last, 2.0 * of_last);
    // With y = (exponent + 3) ln(end/start), the power law has C start^3 ln(end/start) (e^y - 1)/y.
    let ln_q_ratio = ln_ratio(wavelengths_m[last - 1], wavelengths_m[last]);
    let share = wanted / (c1d_m3[last - 1] * q(last - 1).powi(3) * ln_q_ratio);
    let growth = |y: f64| if y == 0.0 { 1.0 } else { y.exp_m1() / y };
    let y = zero_in_bracket(-600.0, 600.0, |y| growth(y) / share - 1.0);
    c1d_m3[last - 1] * (y - 3.0 * ln_q_ratio).exp()
}

/// Int q^power C dq of a spectrum that is a power law between its samples.
fn second_moment(wavelengths_m: &[f64], values: &[f64], power: i32) -> f64 {
    let sample = |at: usize| Sample { wavelength_m: wavelengths_m[at], c1d_m3: values[at] };
    (1..values.len()).map(|at| Interval::new(sample(at - 1), sample(at)).integral(power)).sum()
}

/// The Abel integral Int_q^inf f(p) (p^2 - q^2)^(-1/2) dp of a function f that is a power law of the wavevector on each
/// of its pieces and zero elsewhere.
///
/// With f = p Ciso/pi it is C1D(q), with f = -2 C1D' it is Ciso(q) (Jacobs, Junge & Pastewka 2017, Surf. Topogr.:
/// Metrol. Prop. 5:013001, and its inverse). Relative error below 1e-12 where no piece cancels another.
#[derive(Debug, Clone)]
pub struct AbelIntegral {
    panels: Vec<Panel>,
}

impl AbelIntegral {
    /// Prepares the integral of a function given by its pieces, in any order.
    #[must_use]
    pub fn new(pieces: impl IntoIterator<Item = PowerLaw>) -> Self {
        let cut = |piece: PowerLaw| {
            let (start, end) = (piece.start_rad_per_m, piece.end_rad_per_m);
            Panel::cut(start, end, ln_ratio(end, start), piece.at_start, piece.exponent)
        };
        Self { panels: pieces.into_iter().flat_map(cut).collect() }
    }

    /// Integrates from a wavevector above 0 \[rad/m\] to infinity. The work grows with the number of pieces.
    #[must_use]
    pub fn from(&self, q_rad_per_m: f64) -> f64 {
        self.panels.iter().map(|panel| panel.integral(q_rad_per_m)).sum()
    }
}

/// A piece of an integrand f(p) (p^2 - q^2)^(-1/2) in which f = f_0 (p/p_0)^b changes by at most a factor of e^4 and p
/// by at most e.
#[derive(Debug, Clone)]
struct Panel {
    start: f64,
    end: f64,
    at_start: f64,
    exponent: f64,
    /// For q below this, the panel is not wider in ln p than its distance from q.
    nearest_far: f64,
    /// Nodes p and weights f(p) dp of the Gauss rule in ln p, valid for every q below `nearest_far`.
    nodes: [(f64, f64); NODES],
    /// For q below this, `few` nodes suffice; 0 where the function bends too much for them.
    nearest_very_far: f64,
    few: [(f64, f64); FEW],
}

impl Panel {
    /// Cuts an interval into panels of equal width in ln p.
    fn cut(start: f64, end: f64, ln_ratio: f64, at_start: f64, exponent: f64) -> impl Iterator<Item = Self> {
        let count = (ln_ratio * (1.0 + exponent.abs() / 4.0)).ceil().max(1.0);
        let width = ln_ratio / count;
        let place = move |k: f64| if k == count { end } else { start * (k * width).exp() };
        (0..count as usize).map(move |k| {
            let k = k as f64;
            Self::new(place(k), place(k + 1.0), width, at_start * (k * width * exponent).exp(), exponent)
        })
    }

    fn new(start: f64, end: f64, ln_ratio: f64, at_start: f64, exponent: f64) -> Self {
        let node = |(x, weight): (f64, f64)| {
            (start * x.exp(), at_start * ((exponent + 1.0) * x).exp() * start * weight)
        };
        let few_suffice = (1.0 + exponent.abs()) * ln_ratio < LEAST_BENT;
        Self {
            start,
            end,
            at_start,
            exponent,
            nearest_far: start * (start / end),
            nodes: gauss_nodes(&RULE, 0.0, ln_ratio).map(node),
            nearest_very_far: if few_suffice { start * (-WIDTHS_AWAY * ln_ratio).exp() } else { 0.0 },
            few: gauss_nodes(&FEW_RULE, 0.0, ln_ratio).map(node),
        }
    }

    /// Integrates f(p) (p^2 - q^2)^(-1/2) over the part of the panel above q.
    fn integral(&self, q: f64) -> f64 {
        let over = |nodes: &[(f64, f64)]| -> f64 {
            nodes.iter().map(|&(p, weight)| weight / ((p - q) * (p + q)).sqrt()).sum()
        };
        if self.end <= q {
            0.0
        } else if q < self.nearest_very_far {
            over(&self.few)
        } else if q < self.nearest_far {
            over(&self.nodes)
        } else {
            self.integral_close_to(q)
        }
    }

    /// Integrates near the singularity, which the substitution p = q cosh t removes: Int f(q cosh t) dt.
    fn integral_close_to(&self, q: f64) -> f64 {
        // cosh t - 1 = 2 sinh^2(t/2) keeps the digits of a small p - q.
        let t_at = |p: f64| 2.0 * ((p - q) / (2.0 * q)).sqrt().asinh();
        let (start, end) = (t_at(self.start.max(q)), t_at(self.end));
        let parts = (end - start).ceil().max(1.0);
        let width = (end - start) / parts;
        let power = |t: f64| (t.cosh() * (q / self.start)).powf(self.exponent);
        let part = |k: usize| -> f64 {
            let from = start + k as f64 * width;
            gauss_nodes::<NODES>(&RULE, from, from + width).iter().map(|&(t, weight)| weight * power(t)).sum()
        };
        self.at_start * (0..parts as usize).map(part).sum::<f64>()
    }
}

/// Nodes per panel; 16 suffice for the twelve digits that the tests check.
const NODES: usize = 16;
/// Nodes of a panel that changes by less than `LEAST_BENT` in its logarithm, seen from `WIDTHS_AWAY` of its widths in ln p:
/// n points are off by (z + sqrt(z^2 - 1))^(-2n), 1e-15 at the z = 9 half widths from the middle.
const FEW: usize = 6;
const WIDTHS_AWAY: f64 = 4.0;
const LEAST_BENT: f64 = 1.0;

static RULE: LazyLock<GaussLegendre> = LazyLock::new(|| GaussLegendre::new(NODES));
static FEW_RULE: LazyLock<GaussLegendre> = LazyLock::new(|| GaussLegendre::new(FEW));

/// Returns nodes and weights of a rule of `N` points between two bounds.
fn gauss_nodes<const N: usize>(rule: &GaussLegendre, from: f64, to: f64) -> [(f64, f64); N] {
    let mut nodes = rule.over(from, to);
    std::array::from_fn(|_| nodes.next().expect("the rule has as many nodes"))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use approx::assert_relative_eq;

    use super::*;

    /// Start, end, exponent b, q and Int (p/start)^b (p^2 - q^2)^(-1/2) dp, computed with mpmath to 40 digits.
    const INTEGRALS: [[f64; 5]; 10] = [
        [1.0, 2.0, -2.5, 1.0, 0.797_636_851_581_964_2],
        [1.0, 1.001, -2.6, 1.0, 0.044_678_922_714_849_69],
        [1.0, 10.0, -1.0, 1.0, 1.470_628_905_633_336_8],
        [1.0, 1000.0, 0.75, 1.0, 236.653_865_574_775_48],
        [1.0, 1.1662, -418.0, 1.0, 0.061_338_272_826_844_9],
        [2.0, 3.0, 4.0, 1.0, 1.104_868_429_092_480_4],
        [1.5, 1.50001, -3.0, 1.0, 8.944_128_803_742_484e-6],
        [100.0, 1e4, -2.6, 1.0, 0.384_623_827_989_796_06],
        [1.01, 2.0, 60.0, 1.0, 12_284_853_384_650_711.0],
        [1.0, 1e6, -4.0, 1.0, 0.666_666_666_666_666_7],
    ];

    #[test]
    fn integrals_of_a_power_agree_with_those_of_forty_digits() {
        for [start, end, exponent, q, expected] in INTEGRALS {
            let panels = Panel::cut(start, end, ln_ratio(end, start), 1.0, exponent);
            let integral: f64 = panels.map(|panel| panel.integral(q)).sum();
            assert_relative_eq!(integral, expected, max_relative = 1e-12, epsilon = 0.0);
        }
    }

    #[test]
    fn the_profile_of_three_samples_agrees_with_that_of_forty_digits() {
        let found = profile_of_area(&[TAU, TAU / 3.0, TAU / 10.0], &[5.0, 0.4, 0.001]);
        for (found, expected) in found.into_iter().zip([1.892_643_938_129_05, 0.254_668_360_435_247_6]) {
            assert_relative_eq!(found, expected, max_relative = 1e-12, epsilon = 0.0);
        }
    }

    #[test]
    fn the_profile_of_an_area_keeps_its_gradient() {
        let kept = |ciso: &dyn Fn(f64) -> f64, per_decade: f64| {
            let samples = (2.0 * per_decade) as i32;
            let wavelengths_m: Vec<f64> =
                (0..=samples).map(|at| 1e-4 * 10f64.powf(-f64::from(at) / per_decade)).collect();
            let ciso_m4: Vec<f64> = wavelengths_m.iter().map(|m| ciso(TAU / m)).collect();
            let c1d_m3 = profile_of_area(&wavelengths_m, &ciso_m4);
            assert_eq!(c1d_m3.len(), wavelengths_m.len());
            // Int q^2 C1D dq from the first sample on; a wave p of the surface has p^2/4 of it, less what lies below that sample.
            let first = TAU / wavelengths_m[0];
            let above = |p: f64| {
                let share = (first / p).min(1.0);
                (p * p / PI) * 0.5 * (0.5 * PI - share.asin() + share * (1.0 - share * share).sqrt())
            };
            let dense: Vec<f64> =
                (0..=200_000).map(|at| first * 10f64.powf(2.0 * f64::from(at) / 2e5)).collect();
            let moment = |pair: &[f64]| {
                let p = (pair[0] * pair[1]).sqrt();
                (pair[1] - pair[0]) * p * ciso(p) * above(p)
            };
            second_moment(&wavelengths_m, &c1d_m3, 2) / dense.windows(2).map(moment).sum::<f64>()
        };
        for (per_decade, bound) in [(5.0, 4e-3), (10.0, 1e-3), (30.0, 6e-4)] {
            for hurst in [0.2, 0.5, 0.8, 0.95] {
                let self_affine = kept(&|q| q.powf(-2.0 - 2.0 * hurst), per_decade);
                assert!((self_affine - 1.0).abs() < bound, "{hurst} {per_decade}: {self_affine}");
            }
            let rising = kept(&|q| q * q, per_decade);
            assert!((rising - 1.0).abs() < 0.05, "{per_decade}: {rising}");
        }
    }

    #[test]
    fn an_integral_that_begins_inside_a_piece_is_that_of_its_upper_part() {
        let piece = |start_rad_per_m: f64, end_rad_per_m: f64| PowerLaw {
            start_rad_per_m,
            end_rad_per_m,
            at_start: start_rad_per_m.powf(-2.6),
            exponent: -2.6,
        };
        let whole = AbelIntegral::new([piece(1.0, 1e4)]);
        for q in [1.0, 1.3, 100.0, 9.9e3] {
            let upper = AbelIntegral::new([piece(q, 1e4)]);
            assert_relative_eq!(whole.from(q), upper.from(q), max_relative = 1e-12, epsilon = 0.0);
        }
        assert_eq!(whole.from(1e4), 0.0);
    }

    #[test]
    fn a_constant_spectrum_has_closed_transforms() {
        // Ciso = 1 up to q = 2: C1D = (1/pi) sqrt(4 - q^2); C1D = 1 up to q = 2: only the step at the end remains.
        let wavelengths_m = [TAU / 0.5, TAU, TAU / 1.9, TAU / 2.0];
        for (c1d, q) in profile_of_area(&wavelengths_m, &[1.0; 4]).into_iter().zip([0.5f64, 1.0, 1.9]) {
            assert_relative_eq!(c1d, (4.0 - q * q).sqrt() / PI, max_relative = 1e-13, epsilon = 0.0);
        }
    }
}
