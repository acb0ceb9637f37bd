//! Elastic-plastic contact of constant hardness H: Persson (2001), Phys. Rev. Lett. 87:116101; Persson (2006),
//! Surf. Sci. Rep. 61:201.
//!
//! The density of the stress diffuses between two absorbing walls, at 0 (out of contact) and at H (plastic). For s <
//! H/2 it is a sum over images, beyond that a sum over eigenfunctions; each converges in at most six terms where it
//! is used. Both sums are arranged in terms that do not cancel, so that the smallest share keeps its digits.

use std::f64::consts::{FRAC_1_SQRT_2, PI};
use std::sync::LazyLock;

use numerics::GaussLegendre;

use crate::areas::ContactAreas;

/// Ratio s/H from which the sum over eigenfunctions replaces the sum over images.
const LATE: f64 = 0.5;

/// Share of a sum at which a term no longer changes it.
const NEGLIGIBLE: f64 = 0.25 * f64::EPSILON;

/// Rule for the difference of two images that nearly cancel: integrates cosh and exp over less than 1/2 each, to
/// rounding.
static RULE: LazyLock<GaussLegendre> = LazyLock::new(|| GaussLegendre::new(9));

/// Returns the shares of the nominal area under a nominal pressure p > 0 \[Pa\], a spread s >= 0 \[Pa\] and a hardness
/// H > 0 \[Pa\]. For p >= H the whole area touches and yields, at every scale.
#[must_use]
pub fn areas(pressure_pa: f64, spread_pa: f64, hardness_pa: f64) -> ContactAreas {
    if pressure_pa >= hardness_pa {
        return ContactAreas { elastic: 0.0, plastic: 1.0, gap: 0.0 };
    }
    if spread_pa == 0.0 {
        return ContactAreas::FULL;
    }
    // The walls mirror each other: the elastic share under p equals that under H - p, and the plastic share under p
    // is the gap under H - p.
    let from_above_pa = hardness_pa - pressure_pa;
    let nearer_pa = pressure_pa.min(from_above_pa);
    if spread_pa < LATE * hardness_pa {
        ContactAreas {
            elastic: elastic_by_images(nearer_pa, spread_pa, hardness_pa),
            plastic: absorbed_by_images([pressure_pa, from_above_pa], spread_pa, hardness_pa),
            gap: absorbed_by_images([from_above_pa, pressure_pa], spread_pa, hardness_pa),
        }
    } else {
        let absorbed = |pressure_pa: f64| absorbed_by_modes(pressure_pa, spread_pa, hardness_pa);
        ContactAreas {
            elastic: elastic_by_modes(nearer_pa, spread_pa, hardness_pa),
            plastic: absorbed(pressure_pa),
            gap: absorbed(from_above_pa),
        }
    }
}

/// Density \[1/Pa\] of the elastic stress 0 < sigma < H \[Pa\] over the nominal area, for 0 < p < H, s > 0.
#[must_use]
pub fn stress_density_per_pa(stress_pa: f64, pressure_pa: f64, spread_pa: f64, hardness_pa: f64) -> f64 {
    // Swapping both walls, or stress and pressure, leaves the density unchanged; below, p <= H/2.
    let swap = pressure_pa > 0.5 * hardness_pa;
    let mirrored = |value: f64| if swap { hardness_pa - value } else { value };
    let (stress_pa, pressure_pa) = (mirrored(stress_pa), mirrored(pressure_pa));
    if spread_pa >= LATE * hardness_pa {
        density_by_modes(stress_pa, pressure_pa, spread_pa, hardness_pa)
    } else if stress_pa <= 0.5 * hardness_pa {
        density_by_images(stress_pa, pressure_pa, spread_pa, hardness_pa)
    } else {
        density_near_the_hardness(stress_pa, pressure_pa, spread_pa, hardness_pa)
    }
}

/// Share absorbed at H at early times: the sum of D_j over odd j. The distances of the pressure from both walls are given, because
/// the smaller one is lost in the difference of H and the larger.
fn absorbed_by_images([pressure_pa, from_above_pa]: [f64; 2], spread_pa: f64, hardness_pa: f64) -> f64 {
    let nearest_pa = |j: f64| (j - 1.0) * hardness_pa + from_above_pa;
    sum_of_falling(images(1).map(|j| image_from([nearest_pa(j), j * hardness_pa], pressure_pa, spread_pa)))
}

/// Elastic share erf(b) + (sum of D_j over even j) - (sum over odd j), for p <= H/2, where the first two terms do not
/// cancel.
fn elastic_by_images(pressure_pa: f64, spread_pa: f64, hardness_pa: f64) -> f64 {
    let share = crate::elastic::area_fraction(pressure_pa, spread_pa);
    let of = |j: f64| image(j * hardness_pa, pressure_pa, spread_pa);
    let mut lost = 0.0;
    for (odd, even) in images(1).zip(images(2)) {
        let odd = of(odd);
        if odd <= NEGLIGIBLE * share {
            break;
        }
        lost += odd - of(even);
    }
    share - lost
}

/// Sums positive terms that fall ever faster, as far as they count.
fn sum_of_falling(terms: impl Iterator<Item = f64>) -> f64 {
    let mut sum = 0.0;
    for term in terms {
        sum += term;
        if term <= NEGLIGIBLE * sum {
            break;
        }
    }
    sum
}

/// Multiples of H at which every second image lies; the exponential of the last is below rounding for s < H/2.
fn images(first: u8) -> impl Iterator<Item = f64> {
    (first..8).step_by(2).map(f64::from)
}

/// Contribution D = erfc((d - p)/(sqrt(2) s)) - erfc((d + p)/(sqrt(2) s)) of an image at the distance d >= 0, to
/// rounding.
fn image(distance_pa: f64, pressure_pa: f64, spread_pa: f64) -> f64 {
    image_from([distance_pa - pressure_pa, distance_pa], pressure_pa, spread_pa)
}

/// Contribution of an image from d - p and d.
pub(crate) fn image_from([nearest_pa, distance_pa]: [f64; 2], pressure_pa: f64, spread_pa: f64) -> f64 {
    let [near, far] = [nearest_pa, distance_pa + pressure_pa].map(|d| FRAC_1_SQRT_2 * (d / spread_pa));
    let (a, b) = (FRAC_1_SQRT_2 * (distance_pa / spread_pa), FRAC_1_SQRT_2 * (pressure_pa / spread_pa));
    if 4.0 * a * b > 1.0 || b > 0.5 {
        return libm::erfc(near) - libm::erfc(far);
    }
    // The two erfc nearly cancel; their difference is an integral of positive terms, D = (4/sqrt(pi)) exp(-a^2)
    // Int_0^b cosh(2 a t) exp(-t^2) dt with 2 a b <= 1/2.
    let integral: f64 =
        RULE.over(0.0, b).map(|(t, weight)| weight * (2.0 * a * t).cosh() * (-t * t).exp()).sum();
    4.0 / PI.sqrt() * (-a * a).exp() * integral
}

/// Elastic share at late times, sum over odd n of (4/(n pi)) sin(n pi p/H) e_n, for p <= H/2.
fn elastic_by_modes(pressure_pa: f64, spread_pa: f64, hardness_pa: f64) -> f64 {
    let term = |n: f64| 4.0 / (n * PI) * (n * PI * (pressure_pa / hardness_pa)).sin();
    modes(1, 2, spread_pa, hardness_pa).map(|(n, decay)| term(n) * decay).sum()
}

/// Plastic share at late times, p/H + (2/pi) sum over n of ((-1)^n/n) sin(n pi p/H) e_n. The sine is taken from the
/// nearer end of (0, H), so that it keeps its digits.
fn absorbed_by_modes(pressure_pa: f64, spread_pa: f64, hardness_pa: f64) -> f64 {
    let from_above_pa = hardness_pa - pressure_pa;
    let sine = |n: f64| {
        let sign = if n % 2.0 == 0.0 { 1.0 } else { -1.0 };
        if pressure_pa <= from_above_pa {
            sign * (n * PI * (pressure_pa / hardness_pa)).sin()
        } else {
            -(n * PI * (from_above_pa / hardness_pa)).sin()
        }
    };
    let transient: f64 =
        modes(1, 1, spread_pa, hardness_pa).map(|(n, decay)| 2.0 / (n * PI) * sine(n) * decay).sum();
    pressure_pa / hardness_pa + transient
}

/// Modes n with their decays e_n = exp(-n^2 pi^2 s^2/(2 H^2)), as far as they count beside the first.
fn modes(first: u8, step: usize, spread_pa: f64, hardness_pa: f64) -> impl Iterator<Item = (f64, f64)> {
    let exponent = move |n: f64| {
        let ratio = n * PI * (spread_pa / hardness_pa);
        -0.5 * ratio * ratio
    };
    // A term of mode n is at most n^2 e_n/e_1 times the first.
    const NEGLIGIBLE_FALL: f64 = 45.0;
    let counted = exponent(1.0) - NEGLIGIBLE_FALL;
    let modes = (first..9).step_by(step).map(f64::from);
    modes
        .map(move |n| (n, exponent(n)))
        .take_while(move |(_, exponent)| *exponent >= counted)
        .map(|(n, exponent)| (n, exponent.exp()))
}

fn density_by_modes(stress_pa: f64, pressure_pa: f64, spread_pa: f64, hardness_pa: f64) -> f64 {
    // sin(n pi sigma/H) from the nearer end; from the farther one its sign is that of sin(n pi).
    let from_above_pa = hardness_pa - stress_pa;
    let sine = |n: f64| {
        if stress_pa <= from_above_pa {
            (n * PI * (stress_pa / hardness_pa)).sin()
        } else {
            let sign = if n % 2.0 == 0.0 { -1.0 } else { 1.0 };
            sign * (n * PI * (from_above_pa / hardness_pa)).sin()
        }
    };
    let term = |n: f64| (n * PI * (pressure_pa / hardness_pa)).sin() * sine(n);
    let sum: f64 = modes(1, 1, spread_pa, hardness_pa).map(|(n, decay)| term(n) * decay).sum();
    2.0 / hardness_pa * sum
}

/// Density by images grouped about the wall at 0: each is paired with its mirror image, and nothing cancels for
/// sigma, p <= H/2.
fn density_by_images(stress_pa: f64, pressure_pa: f64, spread_pa: f64, hardness_pa: f64) -> f64 {
    let pair = |at_pa: f64| crate::elastic::stress_density_per_pa(at_pa, pressure_pa, spread_pa);
    let beyond = (1..4).map(|k| 2.0 * f64::from(k) * hardness_pa);
    pair(stress_pa)
        + beyond.map(|shift_pa| pair(stress_pa + shift_pa) - pair(shift_pa - stress_pa)).sum::<f64>()
}

/// Density by images grouped about the wall at H. In units of s, with delta = H - sigma, a group of four at the
/// distance w = H, 3 H, 5 H is (4/sqrt(2 pi)) exp(-(w - delta - p)^2/2) times S(w delta) S(w p) - (1/4) \[1 - exp(-2
/// delta p)\] \[exp(2 delta (p - w)) + exp(2 p (delta - w))\], S(x) = \[1 - exp(-2x)\]/2.
fn density_near_the_hardness(stress_pa: f64, pressure_pa: f64, spread_pa: f64, hardness_pa: f64) -> f64 {
    let [delta, p, h] = [hardness_pa - stress_pa, pressure_pa, hardness_pa].map(|x| x / spread_pa);
    let rise = |x: f64| -0.5 * libm::expm1(-2.0 * x);
    let group = |c: f64| {
        let wall = c * h;
        let apart = wall - delta - p;
        let lost = (2.0 * delta * (p - wall)).exp() + (2.0 * p * (delta - wall)).exp();
        (-0.5 * apart * apart).exp() * (rise(wall * delta) * rise(wall * p) - 0.5 * rise(delta * p) * lost)
    };
    4.0 / ((2.0 * PI).sqrt() * spread_pa) * [1.0, 3.0, 5.0].map(group).iter().sum::<f64>()
}
