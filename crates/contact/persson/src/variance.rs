//! Roughness up to a cutoff: the mean square gradient of the surface, and with it the variance V = E*^2 h'^2/4 of the
//! pressure that would flatten it.
//!
//! Cutting off the spectrum of profiles is not cutting off the surface: C1D at q holds every wave of the surface with
//! |q'| > q.

use std::f64::consts::{LN_10, PI};
use std::sync::LazyLock;

use numerics::{GaussLegendre, line_through};
use serde::{Deserialize, Serialize};
use units::named;

/// Standard error to which the exponent at the end of a spectrum is wanted.
const SLOPE_ERROR: f64 = 0.1;

/// Spectrum that a cutoff applies to.
///
/// The surface is the default of areas, gaps and stiffnesses, because it is nearer to boundary elements: on twenty
/// spectra under five loads areas by the waves of profiles are 0.58 to 0.96 of theirs (rms 32 %), those by the waves of the
/// surface 0.66 to 0.97 (24 %), and stiffnesses 0.52 to 1.29 and 0.79 to 1.11 (`docs/develop/trials.md`). With Nayak's alpha areas are
/// 10 and 3.2 % off (`docs/develop/trials.md`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[non_exhaustive]
pub enum Band {
    /// Spectrum of profiles: h'^2 = 2 m2 up to the cutoff.
    #[serde(rename = "1d")]
    Profile,
    /// Spectrum of the surface: its waves up to the cutoff.
    #[default]
    #[serde(rename = "2d")]
    Surface,
}

named!(Band, "band", { Profile => "1d", Surface => "2d" });

/// Sample of a spectrum of profiles. Samples come by rising wavevector, with a power law between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectrumSample {
    /// Wavevector q > 0 \[rad/m\].
    pub wavevector_rad_per_m: f64,
    /// Spectral density C1D > 0 at q \[m^3\], normalised so that the variance of heights is (1/pi) Int C1D dq.
    pub c1d_m3: f64,
    /// m2 of profiles from the first sample up to here, (1/pi) Int q^2 C1D dq.
    pub mean_square_slope: f64,
}

/// Mean square gradients h'^2 of a cut spectrum, one per sample; non-decreasing, and 0 at the first.
#[derive(Debug, Clone, PartialEq)]
pub struct MeanSquareGradients {
    /// Up to each of the samples, if profiles have nothing below the first one.
    pub up_to: Vec<f64>,
    /// Part of the waves between the first sample and each of the others.
    ///
    /// Profiles show these waves below the first sample too, seen at a slant, where no spectrum was measured. All values of
    /// `up_to` lack what they show there, as much as the first one does, so that differences from that are whole.
    pub from_first: Vec<f64>,
}

impl MeanSquareGradients {
    /// Cuts a spectrum at each of its samples.
    #[must_use]
    pub fn of(samples: &[SpectrumSample], band: Band) -> Self {
        match band {
            Band::Profile => {
                let up_to: Vec<f64> = samples.iter().map(of_profiles).collect();
                MeanSquareGradients { from_first: up_to.clone(), up_to }
            }
            Band::Surface => {
                let cut = cut_gradients(samples);
                let first = cut.first().copied().unwrap_or(0.0);
                let from_first = rising(&cut, first).iter().map(|gradient| gradient - first).collect();
                // At the longest wavelengths the spectrum of profiles holds less than its continuation takes away.
                MeanSquareGradients { up_to: rising(&cut, 0.0), from_first }
            }
        }
    }
}

fn of_profiles(sample: &SpectrumSample) -> f64 {
    2.0 * sample.mean_square_slope
}

/// h'^2 of the surface up to each sample, if profiles have nothing below the first one.
fn cut_gradients(samples: &[SpectrumSample]) -> Vec<f64> {
    // A single sample has no waves.
    if samples.len() < 2 {
        return vec![0.0; samples.len()];
    }
    let tail = Tails::new(samples);
    samples.iter().enumerate().map(|(at, sample)| of_profiles(sample) - tail.beyond(at)).collect()
}

/// The largest value up to each place, and at least `least`.
fn rising(values: &[f64], least: f64) -> Vec<f64> {
    let most = values.iter().scan(least, |most, value| {
        *most = most.max(*value);
        Some(*most)
    });
    most.collect()
}

/// Exponents of the power laws between neighbouring samples, and beyond the last.
#[must_use]
pub fn spectral_exponents(samples: &[SpectrumSample]) -> Vec<f64> {
    let between = |pair: &[SpectrumSample]| {
        (pair[1].c1d_m3 / pair[0].c1d_m3).ln()
            / (pair[1].wavevector_rad_per_m / pair[0].wavevector_rad_per_m).ln()
    };
    let mut exponents: Vec<f64> = samples.windows(2).map(between).collect();
    exponents.extend(exponents.last().copied());
    exponents
}

/// Exponent with which a spectrum goes on beyond its last sample: the slope of its last samples, of as few as give it to
/// [`SLOPE_ERROR`] in view of their scatter, but of no more than half a decade. Of a table without scatter that is the slope of
/// the last two.
///
/// A spectrum of a few scans scatters from bin to bin; the slope of two bins would turn that into areas which are too large in
/// the mean.
fn exponent_at_the_end(samples: &[SpectrumSample], of_last_two: f64) -> f64 {
    // Logarithms of ratios to the last sample keep the digits of samples that nearly coincide, in any unit.
    let Some(end) = samples.last() else { return of_last_two };
    let point = |sample: &SpectrumSample| {
        [(sample.wavevector_rad_per_m / end.wavevector_rad_per_m).ln(), (sample.c1d_m3 / end.c1d_m3).ln()]
    };
    let points: Vec<[f64; 2]> = samples.iter().map(point).collect();
    let last = |count: usize| &points[points.len() - count..];
    let within =
        |decades: f64| last(points.iter().rev().take_while(|point| point[0] >= -decades * LN_10).count());
    let (scatter, longest) = (scatter(within(1.0)), within(0.5).len());
    let mut exponent = of_last_two;
    for count in 2..=longest {
        let Some(line) = line_through(last(count).iter().map(|[ln_q, ln_c]| (*ln_q, *ln_c))) else { break };
        if count > 2 {
            exponent = line.slope;
        }
        if scatter <= SLOPE_ERROR * line.spread {
            break;
        }
    }
    exponent
}

/// Standard deviation of points about a smooth curve: from the distance of each from the line between its neighbours, which
/// changes little from point to point on a curve, and the median of these changes. 0 for fewer than four points.
fn scatter(points: &[[f64; 2]]) -> f64 {
    /// Standard deviation of a normal distribution over the median of its absolute values.
    const OF_MEDIAN: f64 = 1.4826;
    /// Standard deviation of the changes over that of evenly spaced points.
    const OF_CHANGES: f64 = 2.236;
    let off = |three: &[[f64; 2]]| {
        let share = (three[1][0] - three[0][0]) / (three[2][0] - three[0][0]);
        three[1][1] - (three[0][1] + share * (three[2][1] - three[0][1]))
    };
    let off: Vec<f64> = points.windows(3).map(off).collect();
    let mut changes: Vec<f64> = off.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect();
    changes.sort_by(f64::total_cmp);
    changes.get(changes.len() / 2).map_or(0.0, |median| OF_MEDIAN / OF_CHANGES * median)
}

/// Contribution of the waves shorter than a cutoff to the profile's m2 below it.
struct Tails<'a> {
    samples: &'a [SpectrumSample],
    exponents: Vec<f64>,
    /// Terms of the integrals from each sample q on: Int_q^inf C'(p) p^3 (q/p)^(2k) dp, k from 2 on.
    far: Vec<[f64; FAR_TERMS]>,
}

static NARROW: LazyLock<GaussLegendre> = LazyLock::new(|| GaussLegendre::new(6));
static WIDE: LazyLock<GaussLegendre> = LazyLock::new(|| GaussLegendre::new(12));

/// Square of the ratio p/c of a wavevector to the cutoff from which on the kernel is a power series in (c/p)^2.
const FAR_SQUARE: f64 = 2.0;
/// Number of its terms; those left out, from k = 54 on, are below 2^-52 k^-1.5 of the first.
const FAR_TERMS: usize = 52;

impl<'a> Tails<'a> {
    fn new(samples: &'a [SpectrumSample]) -> Self {
        let mut exponents = spectral_exponents(samples);
        // No surface has a spectrum of profiles that rises for ever.
        if let Some(last) = exponents.last_mut() {
            *last = exponent_at_the_end(samples, *last).min(0.0);
        }
        let far = far_terms(samples, &exponents);
        Tails { samples, exponents, far }
    }

    /// Computes (2/3pi) c^3 C(c) + (1/pi) Int_c^inf C'(p) I_3(p; c) dp at the cutoff c of a sample, the spectrum
    /// being continued with its last slope.
    fn beyond(&self, at: usize) -> f64 {
        let SpectrumSample { wavevector_rad_per_m: cutoff, c1d_m3, .. } = self.samples[at];
        let near = self.samples[at..].partition_point(|sample| {
            sample.wavevector_rad_per_m * sample.wavevector_rad_per_m < FAR_SQUARE * cutoff * cutoff
        });
        let far = at + near;
        let mut integral: f64 = (at..far).map(|from| self.stretch(from, cutoff)).sum();
        if let Some(terms) = self.far.get(far) {
            let square = (cutoff / self.samples[far].wavevector_rad_per_m).powi(2);
            let products = SERIES_OF_KERNEL.iter().zip(terms).rev();
            let series = products.fold(0.0, |sum, (coefficient, term)| sum * square + coefficient * term);
            integral += square * square * series;
        }
        (2.0 / 3.0 * c1d_m3 * cutoff.powi(3) + integral) / PI
    }

    /// Integrates C'(p) I_3(p; c) dp from a sample to the next, from the last one to infinity.
    ///
    /// With p = c cosh(theta) and E = exp(-theta) the kernel (2/3) p^3 - sqrt(p^2 - c^2) (2 p^2 + c^2)/3 is c^3 (3 E
    /// + E^3)/6, which loses nothing to cancellation.
    fn stretch(&self, from: usize, cutoff: f64) -> f64 {
        let SpectrumSample { wavevector_rad_per_m: start, c1d_m3, .. } = self.samples[from];
        let exponent = self.exponents[from.min(self.exponents.len() - 1)];
        let theta = |wavevector: f64| (wavevector / cutoff).max(1.0).acosh();
        let first = theta(start);
        let last = match self.samples.get(from + 1) {
            Some(next) => theta(next.wavevector_rad_per_m),
            // The integrand falls like exp((exponent - 1) theta), down to 1e-18 of itself.
            None => first + 42.0 / (1.0 - exponent),
        };
        let density = |theta: f64| {
            let decay = (-theta).exp();
            let square = decay * decay;
            let wavevector = 0.5 * cutoff * (1.0 + square) / decay;
            let tanh = (1.0 - square) / (1.0 + square);
            let kernel = decay * (3.0 + square) / 6.0;
            exponent * c1d_m3 * (wavevector / start).powf(exponent) * tanh * kernel
        };
        let rule = if last - first < 0.3 { &*NARROW } else { &*WIDE };
        let pieces = (last - first).ceil().max(1.0) as usize;
        let width = (last - first) / pieces as f64;
        let over = (0..pieces).map(|i| {
            let begin = first + width * i as f64;
            rule.over(begin, begin + width).map(|(theta, weight)| weight * density(theta)).sum::<f64>()
        });
        cutoff.powi(3) * over.sum::<f64>()
    }
}

/// Coefficients of (c/p)^(2k), k from 2 on, in I_3(p; c)/p^3 = 2/3 - sqrt(1 - c^2/p^2) (2 + c^2/p^2)/3.
static SERIES_OF_KERNEL: LazyLock<[f64; FAR_TERMS]> = LazyLock::new(|| {
    // That of (c/p)^(2k) in the root is the one before it times (k - 3/2)/k.
    let mut of_root = -0.5;
    std::array::from_fn(|place| {
        let k = place as f64 + 2.0;
        let coefficient = -of_root * (k - 1.0) / k;
        of_root *= (k - 1.5) / k;
        coefficient
    })
});

/// Sums Int_q^inf C'(p) p^3 (q/p)^(2k) dp from each sample q on, k from 2 on, over the power laws between the samples.
fn far_terms(samples: &[SpectrumSample], exponents: &[f64]) -> Vec<[f64; FAR_TERMS]> {
    /// Difference of logarithms from which on that of the powers is taken from the powers.
    const FAR_APART: f64 = 0.5;
    let mut all = vec![[0.0; FAR_TERMS]; samples.len()];
    let mut next: Option<(f64, [f64; FAR_TERMS])> = None;
    for (at, sample) in samples.iter().enumerate().rev() {
        let SpectrumSample { wavevector_rad_per_m: start, c1d_m3, .. } = *sample;
        let factor = exponents[at] * c1d_m3 * start.powi(3);
        let exponent = |place: usize| exponents[at] - 1.0 - 2.0 * place as f64;
        all[at] = match next {
            None => std::array::from_fn(|place| -factor / exponent(place)),
            Some((end, beyond)) => {
                let ln_ratio = (end / start).ln();
                let inverse_square = (start / end).powi(2);
                let mut power = (exponent(0) * ln_ratio).exp();
                let mut share = inverse_square * inverse_square;
                std::array::from_fn(|place| {
                    let (exponent, grown) = (exponent(place), exponent(place) * ln_ratio);
                    let own = match exponent {
                        0.0 => ln_ratio,
                        _ if grown.abs() < FAR_APART => libm::expm1(grown) / exponent,
                        _ => (power - 1.0) / exponent,
                    };
                    let sum = factor * own + share * beyond[place];
                    power *= inverse_square;
                    share *= inverse_square;
                    sum
                })
            }
        };
        next = Some((start, all[at]));
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A power law from 1 to 1e8 rad/m.
    fn power_law(exponent: f64) -> Vec<SpectrumSample> {
        let moment = |q: f64| (q.powf(3.0 + exponent) - 1.0) / (3.0 + exponent) / PI;
        let sample = |i: i32| {
            let q = 10f64.powf(f64::from(i) / 5.0);
            SpectrumSample { wavevector_rad_per_m: q, c1d_m3: q.powf(exponent), mean_square_slope: moment(q) }
        };
        (0..=40).map(sample).collect()
    }

    #[test]
    fn a_cut_of_the_surface_lets_less_through_than_one_of_its_profiles() {
        // Far from the beginning of a power law the ratio is sqrt(pi) Gamma(1 + H)/(2 Gamma(H + 1/2)), exponent = -1
        // - 2 H.
        for (exponent, ratio) in [(-2.0, PI / 4.0), (-2.6, 0.919_715_127), (-2.2, 0.832_350_576)] {
            let samples = power_law(exponent);
            let [profile, surface] =
                [Band::Profile, Band::Surface].map(|band| MeanSquareGradients::of(&samples, band).up_to[40]);
            let found = surface / profile;
            let unaffected = 1e8f64.powf(-(3.0 + exponent));
            assert!((found / ratio - 1.0).abs() < 1e-6 + 2.0 * unaffected, "{exponent}: {found} {ratio}");
        }
    }

    /// A surface with a constant Ciso of 1 m^4 from 1 to 10 rad/m: C1D = sqrt(10^2 - q^2)/pi between them.
    fn constant_spectrum() -> Vec<SpectrumSample> {
        let c1d = |q: f64| (100.0 - q * q).max(1e-6).sqrt() / PI;
        let places: Vec<f64> = (0..=2000).map(|at| 9.9995f64.powf(f64::from(at) / 2000.0)).collect();
        let slope = places.windows(2).scan(0.0, |sum, pair| {
            let middle = 0.5 * (pair[0] + pair[1]);
            *sum += middle * middle * c1d(middle) * (pair[1] - pair[0]) / PI;
            Some(*sum)
        });
        let slopes = std::iter::once(0.0).chain(slope);
        let sample = |(&q, mean_square_slope): (&f64, f64)| SpectrumSample {
            wavevector_rad_per_m: q,
            c1d_m3: c1d(q),
            mean_square_slope,
        };
        places.iter().zip(slopes).map(sample).collect()
    }

    #[test]
    fn waves_from_the_first_sample_on_are_all_counted() {
        let samples = constant_spectrum();
        let MeanSquareGradients { up_to: cut, from_first } = MeanSquareGradients::of(&samples, Band::Surface);
        for at in [200, 500, 1000, 1500, 1900] {
            let q = samples[at].wavevector_rad_per_m;
            // (1/2pi) Int_1^q q^3 dq
            let known = (q.powi(4) - 1.0) / (8.0 * PI);
            assert!((from_first[at] / known - 1.0).abs() < 2e-3, "{q}: {} {known}", from_first[at]);
            assert!(cut[at] < from_first[at], "{q}");
        }
    }

    #[test]
    fn the_series_of_the_kernel_agrees_with_the_quadrature() {
        let mut samples = power_law(-2.6);
        for (at, sample) in samples.iter_mut().enumerate() {
            sample.c1d_m3 *= 1.0 + 0.5 * ((at * at) as f64).sin();
        }
        // Also a spectrum so sparse that nothing but the waves beyond its end is near a cutoff.
        for samples in [samples.clone(), samples.into_iter().step_by(10).collect()] {
            let tails = Tails::new(&samples);
            for at in 0..samples.len() {
                let cutoff = samples[at].wavevector_rad_per_m;
                let plain = 2.0 / 3.0 * samples[at].c1d_m3 * cutoff.powi(3);
                let whole: f64 = (at..samples.len()).map(|from| tails.stretch(from, cutoff)).sum();
                let off = (tails.beyond(at) * PI - plain - whole).abs() / plain;
                assert!(off < 1e-12, "{at}: {off:e}");
            }
        }
    }

    #[test]
    fn a_spectrum_that_scatters_ends_with_the_slope_of_its_last_half_decade() {
        let scattering: Vec<SpectrumSample> = power_law(-2.6)
            .iter()
            .enumerate()
            .map(|(at, sample)| SpectrumSample {
                c1d_m3: sample.c1d_m3 * if at % 2 == 0 { 0.9 } else { 1.1 },
                ..*sample
            })
            .collect();
        let last_two = spectral_exponents(&scattering).pop().unwrap();
        let found = exponent_at_the_end(&scattering, last_two);
        assert!((last_two + 2.6).abs() > 0.4, "{last_two}");
        assert!((found + 2.6).abs() < 0.2, "{found}");
        // Without scatter the last two decide, whatever came before.
        let mut bent = power_law(-2.6);
        let last = bent.len() - 1;
        bent[last].c1d_m3 *= 0.5;
        let last_two = spectral_exponents(&bent).pop().unwrap();
        assert_eq!(exponent_at_the_end(&bent, last_two), last_two);
    }

    #[test]
    fn no_cutoff_lets_less_through_than_a_longer_one() {
        let mut samples = power_law(-2.6);
        samples[20].c1d_m3 *= 3.0;
        for band in Band::ALL {
            let MeanSquareGradients { up_to, from_first } = MeanSquareGradients::of(&samples, *band);
            for gradients in [up_to, from_first] {
                assert!(gradients.is_sorted() && gradients[0] == 0.0, "{band}: {gradients:?}");
            }
        }
    }
}
