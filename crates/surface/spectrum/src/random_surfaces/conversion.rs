//! Conversion of the spectrum of profiles to that of their isotropic surface.
//!
//! Between its samples C1D is the monotone cubic of its logarithm; beyond the last it goes on with the slope that it has there. A
//! fall of C1D at p holds waves of the surface up to p, so that the heights and gradients of the waves up to each sample are sums
//! over falls:
//!
//! (1/2 pi) Int_0^c q Ciso dq = -(1/pi) Int_0^inf C1D'(p) I_1(p; c) dp, I_1 = p - sqrt(p^2 - c^2) (p if p < c),
//! (1/2 pi) Int_0^c q^3 Ciso dq = -(1/pi) Int_0^inf C1D'(p) I_3(p; c) dp, I_3 = (2/3) p^3 - sqrt(p^2 - c^2) (2 p^2 + c^2)/3.
//!
//! Between two samples Ciso is the power law with these heights and gradients. C1D below the first sample does not matter: none of
//! the waves beyond it depends on that.

use std::f64::consts::{LN_10, PI, TAU};
use std::sync::LazyLock;

use numerics::{GaussLegendre, line_through};
use serde::Serialize;

use crate::interval::ln_ratio;
use crate::random_surfaces::error::RandomSurfaceError;
use crate::random_surfaces::monotone::{Pool, not_rising};
use crate::{PowerLaw, ProfilePsd};

/// Treatment of a spectrum of profiles in its conversion to that of their surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Conversion {
    /// Share of the roughness, 0 to 1, that was moved to level rises of C1D that no isotropic surface has: the mean of the shares in
    /// heights and in slopes of profiles.
    pub levelled_share: f64,
    /// Relative standard error of the rms gradient: the waves beyond the end of the spectrum, which its last values hold too, are
    /// known from its last slope alone.
    pub end_error: f64,
}

/// Largest exponent of C1D beyond its end. The heights of a surface are finite, so that its C1D falls faster than 1/q in the end.
const SHALLOWEST_END: f64 = -1.0;
/// Exponent beyond the end for comparison, of a Hurst exponent of 1, if C1D does not fall to its end.
const STEEP_END: f64 = -3.0;
/// Negative gradient between two samples, in units of Int q^2 C1D dq/pi there, from which on it is more than an error of
/// interpolation, and a rise of C1D is levelled.
const MOST_NEGATIVE: f64 = -0.3;
/// Largest exponent of the factor that restores moments after levelling.
const MOST_TILT: f64 = 0.05;
/// Factor of C1D between a turn and a sample beside it from which on the turn is a corner.
const SHARP: f64 = std::f64::consts::E;
/// Step in ln q, about a quarter of a decade, from which on neighbouring samples are joined by a power law.
const WIDE: f64 = 0.6;
/// Largest part of the range of ratios of gradient to heights that a power law fits, and the steps of Newton that this takes.
const MOST_BENT: f64 = 0.9;
const NEWTON_STEPS: usize = 6;

/// Computes the pieces of Ciso between the first and the last wavevector of a spectrum of profiles.
pub(crate) fn of_profile(profile: &ProfilePsd) -> Result<(Vec<PowerLaw>, Conversion), RandomSurfaceError> {
    if profile.len() < 2 {
        return Err(RandomSurfaceError::TooFewSamples { samples: profile.len() });
    }
    let samples = profile.samples().chain(profile.beyond.iter().copied());
    let (wavelengths_m, c1d_m3): (Vec<f64>, Vec<f64>) = samples.unzip();
    let curve = Curve::new(&wavelengths_m, c1d_m3);
    let (roughness, levelled_share) = curve.levelled();
    let roughness = spread(&roughness);
    let pieces = (0..profile.len() - 1).filter_map(|at| {
        let [heights, gradient] = roughness[at];
        piece([curve.q[at], curve.q[at + 1]], curve.steps[at], heights, gradient)
    });
    let last = profile.len() - 1;
    let gradient: f64 = roughness[..last].iter().map(|[_, gradient]| gradient).sum();
    let other_end = (1.0 + curve.change_of_other_end(last) / gradient).max(0.0).sqrt();
    let conversion = Conversion { levelled_share, end_error: (other_end - 1.0).abs() };
    Ok((pieces.collect(), conversion))
}

/// The power law of Ciso between two wavevectors that has the given shares of the mean square height and gradient. If no power law
/// has both, it has the gradient; `None` if that is rounding.
fn piece([start, end]: [f64; 2], step: f64, heights: f64, gradient: f64) -> Option<PowerLaw> {
    if gradient <= 0.0 || gradient.is_nan() {
        return None;
    }
    // With z = (exponent + 3) step, the ratio of both is start^2 g(z + step)/g(z - step), g(y) = (e^y - 1)/y.
    let wanted = (gradient / heights / (start * start)).ln() - step;
    let mut z = 0.0;
    if wanted.abs() < MOST_BENT * step {
        for _ in 0..NEWTON_STEPS {
            let [(high, high_slope), (low, low_slope)] = [z + step, z - step].map(ln_growth);
            z -= (high - low - step - wanted) / (high_slope - low_slope);
        }
    }
    let of_one =
        PowerLaw { start_rad_per_m: start, end_rad_per_m: end, at_start: 1.0, exponent: z / step - 3.0 };
    Some(PowerLaw { at_start: TAU * gradient / of_one.integral(3), ..of_one })
}

/// Returns ln((e^y - 1)/y) and its derivative.
fn ln_growth(y: f64) -> (f64, f64) {
    /// Below this the series is exact to rounding.
    const SMALL: f64 = 1e-2;
    if y.abs() < SMALL {
        let square = y * y;
        return (0.5 * y + square / 24.0 * (1.0 - square / 120.0), 0.5 + y / 12.0 * (1.0 - square / 60.0));
    }
    let grown = y.exp_m1();
    ((grown / y).ln(), (grown + 1.0) / grown - 1.0 / y)
}

/// Roughness between neighbouring samples.
#[derive(Clone, Copy)]
struct StepRoughness {
    /// Mean squares of heights and gradient of the waves of the surface there.
    of_surface: [f64; 2],
    /// Parts of m0 and m2 of profiles there.
    of_profiles: [f64; 2],
}

impl StepRoughness {
    /// Returns true if the gradient is negative by more than an error of interpolation.
    fn is_negative(&self) -> bool {
        self.of_surface[1] < MOST_NEGATIVE * self.of_profiles[1]
    }

    /// Returns true if a mean square is not above rounding.
    fn is_missing(&self) -> bool {
        (0..2).any(|of| self.of_surface[of] <= ROUNDING * self.of_profiles[of])
    }

    fn plus(self, other: Self) -> Self {
        let sum = |one: [f64; 2], other: [f64; 2]| [one[0] + other[0], one[1] + other[1]];
        StepRoughness {
            of_surface: sum(self.of_surface, other.of_surface),
            of_profiles: sum(self.of_profiles, other.of_profiles),
        }
    }
}

/// Spreads heights and gradients that interpolation has left negative: neighbours share their sum like the variances of profiles, so
/// that all are above 0.
fn spread(steps: &[StepRoughness]) -> Vec<[f64; 2]> {
    let mut pools: Vec<(StepRoughness, usize)> = Vec::new();
    for step in steps {
        let mut last = (*step, 1);
        while let Some((pool, count)) = pools.pop_if(|(pool, _)| pool.is_missing()) {
            last = (pool.plus(last.0), count + last.1);
        }
        pools.push(last);
    }
    while pools.len() > 1 && pools[pools.len() - 1].0.is_missing() {
        let last = pools.split_off(pools.len() - 1)[0];
        let end = pools.len() - 1;
        pools[end] = (pools[end].0.plus(last.0), pools[end].1 + last.1);
    }
    let mut steps = steps.iter();
    let mut spread = Vec::new();
    for (pool, count) in pools {
        let part = |of: usize, step: &StepRoughness| {
            pool.of_surface[of] / pool.of_profiles[of] * step.of_profiles[of]
        };
        spread.extend(steps.by_ref().take(count).map(|step| [part(0, step), part(1, step)]));
    }
    spread
}

/// C1D at its samples by rising wavevector, and its monotone cubic in logarithmic axes between them.
#[derive(Clone)]
struct Curve {
    q: Vec<f64>,
    /// Differences of ln q between neighbouring samples.
    steps: Vec<f64>,
    c1d: Vec<f64>,
    /// Slopes dln(C1D)/dln(q) at the start and the end of each step.
    slopes: Vec<[f64; 2]>,
    /// Exponent of C1D beyond its last sample, and another one that is as likely.
    ends: [f64; 2],
}

impl Curve {
    fn new(wavelengths_m: &[f64], c1d: Vec<f64>) -> Self {
        let steps: Vec<f64> = wavelengths_m.windows(2).map(|pair| ln_ratio(pair[0], pair[1])).collect();
        let q = wavelengths_m.iter().map(|wavelength_m| TAU / wavelength_m).collect();
        let mut curve = Curve { q, steps, c1d, slopes: Vec::new(), ends: [SHALLOWEST_END; 2] };
        curve.slopes = curve.slopes();
        curve.ends = curve.exponents_beyond();
        curve
    }

    fn secants(&self) -> Vec<f64> {
        let secant = |(pair, step): (&[f64], &f64)| ln_ratio(pair[1], pair[0]) / step;
        self.c1d.windows(2).zip(&self.steps).map(secant).collect()
    }

    /// Computes the slopes of the monotone piecewise cubic (Fritsch & Butland 1984, SIAM J. Sci. Stat. Comput. 5:300) at both ends of
    /// each step. Steps beside a turn by more than a factor of [`SHARP`] stay power laws, because a round turn would be broader, and so
    /// do those wider than [`WIDE`], of which no samples show a bend.
    fn slopes(&self) -> Vec<[f64; 2]> {
        let (steps, secants) = (&self.steps, self.secants());
        // The parabola through the last three samples, without a turn between the last two.
        let end = |nearest: usize, next: usize| {
            let (width, secant) = (steps[nearest], secants[nearest]);
            let slope = secant + width * (secant - secants[next]) / (width + steps[next]);
            let most = if secant * secants[next] > 0.0 { f64::INFINITY } else { 3.0 };
            if secant == 0.0 { 0.0 } else { (slope / secant).clamp(0.0, most) * secant }
        };
        let is_turn = |at: usize| secants[at] * secants[at + 1] <= 0.0;
        let is_sharp = |at: usize| {
            (secants[at] * steps[at]).abs().max((secants[at + 1] * steps[at + 1]).abs()) > SHARP.ln()
        };
        let is_corner = |at: usize| at + 1 < steps.len() && is_turn(at) && is_sharp(at);
        let mut slopes: Vec<[f64; 2]> = secants.iter().map(|secant| [*secant; 2]).collect();
        let last = steps.len().saturating_sub(1);
        if last == 0 {
            return slopes;
        }
        (slopes[0][0], slopes[last][1]) = (end(0, 1), end(last, last - 1));
        for at in 0..last {
            let (before, after) = (secants[at], secants[at + 1]);
            let weights = [2.0 * steps[at + 1] + steps[at], steps[at + 1] + 2.0 * steps[at]];
            let slope = (weights[0] + weights[1]) / (weights[0] / before + weights[1] / after);
            let slope = if is_turn(at) { 0.0 } else { slope };
            (slopes[at][1], slopes[at + 1][0]) = (slope, slope);
        }
        let is_straight =
            |at: &usize| steps[*at] > WIDE || is_corner(*at) || at.checked_sub(1).is_some_and(is_corner);
        (0..=last).filter(is_straight).for_each(|at| slopes[at] = [secants[at]; 2]);
        slopes
    }

    /// Chooses the exponent of C1D beyond its last sample, and another one about a standard error off.
    ///
    /// It is the slope at the end, and if samples scatter that of a line through as few of the last ones as give it to
    /// [`SLOPE_ERROR`], within half a decade: the slope of two samples would turn scatter into areas that are too large in the mean.
    fn exponents_beyond(&self) -> [f64; 2] {
        let (at_end, of_last_two) =
            (self.slopes.last().map_or(0.0, |slopes| slopes[1]), self.secants().pop().unwrap_or(0.0));
        let last = self.q.len() - 1;
        let points: Vec<(f64, f64)> = self
            .q
            .iter()
            .zip(&self.c1d)
            .map(|(q, c1d)| ((q / self.q[last]).ln(), (c1d / self.c1d[last]).ln()))
            .collect();
        let within = |decades: f64| &points[points.partition_point(|point| point.0 < -decades * LN_10)..];
        let scatter = scatter(within(1.0));
        let mut exponents = [at_end, of_last_two];
        for count in 2..=within(0.5).len() {
            let Some(line) = line_through(points[points.len() - count..].iter().copied()) else { break };
            if count > 2 {
                exponents = [line.slope, line.slope - scatter / line.spread];
            }
            if scatter <= SLOPE_ERROR * line.spread {
                break;
            }
        }
        if exponents[0] > SHALLOWEST_END { [SHALLOWEST_END, STEEP_END] } else { exponents }
    }

    /// Levels rises of C1D that would need negative roughness. Returns the roughness between the samples, and the share of it that
    /// this moved.
    ///
    /// Rising samples are pooled. A pool is levelled if a negative gradient precedes its end; the others stay, because a narrow peak
    /// of the surface, as turning leaves it, lets C1D rise. A factor a q^b then restores the variances of heights and slopes.
    fn levelled(&self) -> (Vec<StepRoughness>, f64) {
        let given = self.roughness();
        if !given.iter().any(StepRoughness::is_negative) {
            return (given, 0.0);
        }
        let wanted = self.profile_moments();
        let pools = self.rising_pools(wanted);
        let mut is_levelled = vec![false; pools.len()];
        let (mut curve, mut roughness) = (self.clone(), given.clone());
        loop {
            let places = roughness.iter().enumerate().filter(|(_, step)| step.is_negative());
            let next = |at: usize| (0..pools.len()).find(|of| pools[*of].end > at + 1 && !is_levelled[*of]);
            let found: Vec<usize> = places.filter_map(|(at, _)| next(at)).collect();
            if found.is_empty() {
                break;
            }
            found.into_iter().for_each(|of| is_levelled[of] = true);
            curve.c1d.clone_from(&self.c1d);
            for (pool, _) in pools.iter().zip(&is_levelled).filter(|(_, done)| **done) {
                curve.c1d[pool.start..pool.end].fill(pool.level);
            }
            curve.slopes = curve.slopes();
            roughness = curve.roughness();
        }
        if !is_levelled.contains(&true) {
            return (given, 0.0);
        }
        let moved = |of: usize| {
            let off = given
                .iter()
                .zip(&roughness)
                .map(|(one, other)| (one.of_profiles[of] - other.of_profiles[of]).abs());
            0.25 * off.sum::<f64>() / wanted[of]
        };
        let moved = moved(0) + moved(1);
        curve.restore(wanted);
        (curve.roughness(), moved.min(1.0))
    }

    /// Computes the roughness between neighbouring samples.
    fn roughness(&self) -> Vec<StepRoughness> {
        let falls = Falls::new(self);
        let rise = |pair: &[[f64; 2]]| [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
        let steps = falls.contents();
        let steps = steps.windows(2).map(rise).zip(falls.profile_shares());
        steps.map(|(of_surface, of_profiles)| StepRoughness { of_surface, of_profiles }).collect()
    }

    /// Computes m0 and m2 of profiles with power laws between the samples, as moments take them.
    fn profile_moments(&self) -> [f64; 2] {
        let pieces = (1..self.q.len()).map(|end| self.power_law(end - 1));
        pieces.fold([0.0; 2], |[m0, m2], piece| [m0 + piece.integral(0) / PI, m2 + piece.integral(2) / PI])
    }

    fn power_law(&self, at: usize) -> PowerLaw {
        PowerLaw::through((self.q[at], self.c1d[at]), (self.q[at + 1], self.c1d[at + 1]))
    }

    /// Pools rising samples into levels that keep their variances of heights and slopes, each in units of the whole.
    fn rising_pools(&self, [m0, m2]: [f64; 2]) -> Vec<Pool> {
        let (mut variances, mut widths) = (vec![0.0; self.q.len()], vec![0.0; self.q.len()]);
        for at in 0..self.steps.len() {
            let law = self.power_law(at);
            let level = PowerLaw { at_start: 1.0, exponent: 0.0, ..law };
            let middle = (self.q[at] * self.q[at + 1]).sqrt();
            for (sample, least, largest) in [(at, self.q[at], middle), (at + 1, middle, self.q[at + 1])] {
                let part = |of: PowerLaw| of.integral(0) / m0 + of.integral(2) / m2;
                let part = |of: PowerLaw| of.between(least, largest).map_or(0.0, part);
                variances[sample] += part(law);
                widths[sample] += part(level);
            }
        }
        let means: Vec<f64> =
            variances.iter().zip(&widths).map(|(variance, width)| variance / width).collect();
        not_rising(&means, &widths).into_iter().filter(|pool| pool.end > pool.start + 1).collect()
    }

    /// Multiplies C1D by a q^b so that the cubics have given m0 and m2; m2 alone if that needs more than [`MOST_TILT`], since m2
    /// decides the area of contact.
    fn restore(&mut self, wanted: [f64; 2]) {
        let falls = Falls::new(self);
        let ln_q = |q: f64| (q / self.q[0]).ln();
        // For both moments the logarithm of the missing factor, and the mean of ln q.
        let [of_m0, of_m2] = [0, 1].map(|of| {
            let nodes = falls.nodes[..falls.starts[self.steps.len()]].iter();
            let [sum, logarithms] = nodes.fold([0.0; 2], |[sum, logarithms], node| {
                let weight = node.mass * node.q.powi(2 * of) / PI;
                [sum + weight, logarithms + weight * ln_q(node.q)]
            });
            [(wanted[of as usize] / sum).ln(), logarithms / sum]
        });
        let tilt = ((of_m2[0] - of_m0[0]) / (of_m2[1] - of_m0[1])).clamp(-MOST_TILT, MOST_TILT);
        let factors: Vec<f64> =
            self.q.iter().map(|q| (of_m2[0] + tilt * (ln_q(*q) - of_m2[1])).exp()).collect();
        self.c1d.iter_mut().zip(factors).for_each(|(c1d, factor)| *c1d *= factor);
        self.slopes = self.slopes();
    }

    /// Change of the mean square gradient of the waves up to a sample if C1D went on beyond its end with the other exponent.
    fn change_of_other_end(&self, sample: usize) -> f64 {
        let last = self.q.len() - 1;
        let q = if sample < last { vec![self.q[sample], self.q[last]] } else { vec![self.q[last]] };
        let steps: Vec<f64> = q.windows(2).map(|pair| ln_ratio(pair[1], pair[0])).collect();
        let of_end = self.ends.map(|exponent| {
            let (c1d, slopes) = (vec![self.c1d[last]; q.len()], vec![[0.0; 2]; steps.len()]);
            let end = Curve { q: q.clone(), steps: steps.clone(), c1d, slopes, ends: [exponent; 2] };
            Falls::new(&end).contents()[0][1]
        });
        of_end[1] - of_end[0]
    }
}

/// Share of the variance of profiles below which a mean square of the surface is rounding.
const ROUNDING: f64 = 1e-9;
/// Standard error to which the exponent at the end of a spectrum is wanted.
const SLOPE_ERROR: f64 = 0.1;

/// Standard deviation of points about a smooth curve: from the distance of each from the line between its neighbours, which
/// changes little from point to point on a curve, and the median of these changes. 0 for fewer than four points.
fn scatter(points: &[(f64, f64)]) -> f64 {
    /// Standard deviation of a normal distribution over the median of its absolute values.
    const OF_MEDIAN: f64 = 1.4826;
    /// Standard deviation of the changes over that of evenly spaced points.
    const OF_CHANGES: f64 = 2.236;
    let off = |three: &[(f64, f64)]| {
        let share = (three[1].0 - three[0].0) / (three[2].0 - three[0].0);
        three[1].1 - (three[0].1 + share * (three[2].1 - three[0].1))
    };
    let off: Vec<f64> = points.windows(3).map(off).collect();
    let mut changes: Vec<f64> = off.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect();
    changes.sort_by(f64::total_cmp);
    changes.get(changes.len() / 2).map_or(0.0, |median| OF_MEDIAN / OF_CHANGES * median)
}

/// The falls of C1D with the waves that they hold.
struct Falls {
    /// Wavevectors of the samples, and one beyond, where the power law of the end begins to be summed in closed form.
    knots: Vec<f64>,
    nodes: Vec<Node>,
    /// The first node of every step between knots, and the number of nodes.
    starts: Vec<usize>,
    /// Terms of the integrals from each knot q on: Int_q^inf -C'(p) p^3 (q/p)^(2k) dp, k from 2 on.
    far: Vec<[f64; TERMS]>,
}

/// A node of the quadrature of C1D.
struct Node {
    q: f64,
    /// -C1D' dq.
    fall: f64,
    /// C1D dq.
    mass: f64,
}

/// Square of p/c from which on the integrals are power series in (c/p)^2.
const FAR_SQUARE: f64 = 2.0;
/// Number of their terms; those left out, from k = 54 on, are below 2^-52 of the first.
const TERMS: usize = 52;
/// ln q of the step beyond the last sample.
const END_STEP: f64 = 0.5;
/// Width in ln q up to which a step has few nodes, and widest part of a step.
const NARROW: f64 = 0.03;
const WIDEST: f64 = 0.5;

/// Places and weights on 0 to 1. The first set is dense near 0, where I_1 and I_3 have the root of the distance.
static FEW: LazyLock<[Vec<(f64, f64)>; 2]> = LazyLock::new(|| places(3));
static MANY: LazyLock<[Vec<(f64, f64)>; 2]> = LazyLock::new(|| places(8));

fn places(count: usize) -> [Vec<(f64, f64)>; 2] {
    let even: Vec<(f64, f64)> = GaussLegendre::new(count).over(0.0, 1.0).collect();
    [even.iter().map(|(t, weight)| (t * t, 2.0 * t * weight)).collect(), even]
}

impl Falls {
    fn new(curve: &Curve) -> Self {
        let last = curve.q.len() - 1;
        let mut falls = Falls { knots: curve.q.clone(), nodes: Vec::new(), starts: vec![0], far: Vec::new() };
        for (at, &step) in curve.steps.iter().enumerate() {
            let ln_ratio = ln_ratio(curve.c1d[at + 1], curve.c1d[at]);
            let [slope, next_slope] = curve.slopes[at].map(|slope| step * slope);
            // The cubic of Hermite in t from 0 to 1, and its slope.
            let [square, cube] =
                [3.0 * ln_ratio - 2.0 * slope - next_slope, slope + next_slope - 2.0 * ln_ratio];
            falls.extend([curve.q[at], curve.c1d[at]], step, |t| {
                [t * (slope + t * (square + t * cube)), slope + t * (2.0 * square + 3.0 * t * cube)]
            });
        }
        let exponent = curve.ends[0];
        let slope = exponent * END_STEP;
        falls.extend([curve.q[last], curve.c1d[last]], END_STEP, |t| [slope * t, slope]);
        let (end, c1d) = (curve.q[last] * END_STEP.exp(), curve.c1d[last] * slope.exp());
        falls.knots.push(end);
        let fall = -exponent * c1d * end.powi(3);
        let mut terms: [f64; TERMS] =
            std::array::from_fn(|place| fall / (2.0 * place as f64 + 1.0 - exponent));
        falls.far = vec![terms; last + 2];
        for at in (0..=last).rev() {
            let start = falls.knots[at];
            let ratio = (start / falls.knots[at + 1]).powi(2);
            let mut share = ratio * ratio;
            for term in &mut terms {
                *term *= share;
                share *= ratio;
            }
            for node in &falls.nodes[falls.starts[at]..falls.starts[at + 1]] {
                let ratio = (start / node.q).powi(2);
                let mut part = node.fall * node.q.powi(3) * ratio * ratio;
                for term in &mut terms {
                    *term += part;
                    part *= ratio;
                }
            }
            falls.far[at] = terms;
        }
        falls
    }

    /// Appends the nodes of a step from q and C1D at its start, of a width in ln q. `shape` is ln C1D above that at the start, and its
    /// slope, against the share of the width.
    fn extend(&mut self, [q, c1d]: [f64; 2], step: f64, shape: impl Fn(f64) -> [f64; 2]) {
        let rules = if step < NARROW { &*FEW } else { &*MANY };
        let parts = (step / WIDEST).ceil().max(1.0);
        for part in 0..parts as usize {
            self.nodes.extend(rules[usize::from(part > 0)].iter().map(|(place, weight)| {
                let t = (part as f64 + place) / parts;
                let [ln_ratio, slope] = shape(t);
                let (q, value) = (q * (t * step).exp(), c1d * ln_ratio.exp() * weight / parts);
                Node { q, fall: -slope * value, mass: value * q * step }
            }));
        }
        self.starts.push(self.nodes.len());
    }

    /// The mean squares of heights and gradient of all waves up to each sample.
    fn contents(&self) -> Vec<[f64; 2]> {
        let samples = self.knots.len() - 1;
        let mut below = [0.0; 2];
        let content = |at: usize| {
            for node in &self.nodes[self.starts[at.saturating_sub(1)]..self.starts[at]] {
                below = [below[0] + node.fall * node.q, below[1] + 2.0 / 3.0 * node.fall * node.q.powi(3)];
            }
            let square = self.knots[at].powi(2);
            let far = at + self.knots[at..].partition_point(|knot| knot * knot < FAR_SQUARE * square);
            let mut sums = below;
            for node in &self.nodes[self.starts[at]..self.starts[far]] {
                // With e = 1 - sqrt(1 - c^2/p^2), I_1 = p e and I_3 = p^3 e^2 (1 - e/3).
                let ratio = square / (node.q * node.q);
                let e = ratio / (1.0 + (1.0 - ratio).max(0.0).sqrt());
                let heights = node.fall * node.q * e;
                sums = [sums[0] + heights, sums[1] + heights * node.q * node.q * e * (1.0 - e / 3.0)];
            }
            let ratio = square / self.knots[far].powi(2);
            let series = |coefficients: &[f64; TERMS]| {
                let products = coefficients.iter().zip(&self.far[far]).rev();
                ratio
                    * ratio
                    * products.fold(0.0, |sum, (coefficient, term)| sum * ratio + coefficient * term)
            };
            [(sums[0] + series(&SERIES[0]) / square) / PI, (sums[1] + series(&SERIES[1])) / PI]
        };
        (0..samples).map(content).collect()
    }

    /// The parts of m0 and m2 of profiles between neighbouring samples.
    fn profile_shares(&self) -> Vec<[f64; 2]> {
        let share = |pair: &[usize]| {
            self.nodes[pair[0]..pair[1]]
                .iter()
                .fold([0.0; 2], |[m0, m2], node| [m0 + node.mass / PI, m2 + node.mass * node.q * node.q / PI])
        };
        self.starts.windows(2).take(self.knots.len() - 2).map(share).collect()
    }
}

/// Coefficients of (c/p)^(2k), k from 2 on, in c^2 I_1(p; c)/p^3 = (c/p)^2 (1 - sqrt(1 - c^2/p^2)) and in I_3(p; c)/p^3 = 2/3 -
/// sqrt(1 - c^2/p^2) (2 + c^2/p^2)/3.
static SERIES: LazyLock<[[f64; TERMS]; 2]> = LazyLock::new(|| {
    // The coefficient of (c/p)^(2k) in the root is the one before it times (k - 3/2)/k.
    let mut of_root = -0.5;
    let [mut heights, mut gradient] = [[0.0; TERMS]; 2];
    for (place, (of_heights, of_gradient)) in heights.iter_mut().zip(&mut gradient).enumerate() {
        let k = place as f64 + 2.0;
        *of_heights = -of_root;
        *of_gradient = -of_root * (k - 1.0) / k;
        of_root *= (k - 1.5) / k;
    }
    [heights, gradient]
});
