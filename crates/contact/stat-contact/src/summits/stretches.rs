//! Intervals of the integral over the mean curvature.
//!
//! With heights in sqrt(m0) and mean curvatures T in sqrt(m4), a summit of curvature T has the mean height 3T/(2
//! sqrt(alpha)) and the spread s = sqrt(1 - 3/(2 alpha)) about it. A flat at u stands (u - 3T/(2 sqrt(alpha)))/s
//! spreads above that mean: positive for flat summits, of which few are reached, negative for sharp ones, of which
//! most are. Between them, at the edge T = 2u sqrt(alpha)/3, the integrand bends within 2s sqrt(alpha)/3, which
//! vanishes with alpha - 3/2.

/// -ln of the share of the largest integrand that is left out.
const DROP: f64 = 42.0;
/// Longest stretches, in standard deviations of the integrand: short enough for a rule of 34 nodes.
const LONGEST: f64 = 5.0;
/// Longest stretches beside the edge, over their distance from it and the width of the bend there.
const GROWTH: f64 = 8.0;

/// Mean curvatures that contribute at one separation, from an origin: the peak of the integrand among flat summits.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stretches {
    /// Curvature at the origin: that of summits at the flat where they are rare, and 0 if the flat is below the mean
    /// plane.
    pub origin: f64,
    /// Height of the flat above the mean height of the summits at the origin, in spreads.
    pub height_at_origin: f64,
    /// Curvature by which that height falls by 1.
    pub bend: f64,
    spread: f64,
    low: f64,
    high: f64,
}

/// Stretch of mean curvatures, counted from the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stretch {
    pub from: f64,
    pub to: f64,
    /// True if it begins at curvature zero, where powers of its root enter, or nearer to zero than it is long.
    pub rooted: bool,
}

impl Stretches {
    /// Returns the stretches of a separation u, in sqrt(m0), for a spread s of the heights at one curvature, in
    /// sqrt(m0).
    pub fn around(u: f64, alpha: f64, spread: f64) -> Self {
        let bend = 2.0 / 3.0 * alpha.sqrt() * spread;
        if u <= 0.0 {
            // The integrand goes like exp(-3 T^2/4).
            let high = (4.0 / 3.0 * DROP).sqrt();
            return Stretches { origin: 0.0, height_at_origin: u / spread, bend, spread, low: 0.0, high };
        }
        let (origin, height_at_origin) = (u / alpha.sqrt(), u * spread);
        let edge = height_at_origin * bend;
        // Among flat summits the integrand is a Gaussian about the origin, with the standard deviation s sqrt(2/3).
        let reach = spread * (4.0 / 3.0 * DROP).sqrt();
        // Among sharp ones it falls like exp(-alpha/3 (2 u w + w^2 + s^2 u^2)), with w the height of their mean above
        // the flat.
        let left = 3.0 * DROP / alpha - height_at_origin * height_at_origin;
        let high = if left > 0.0 {
            edge + 2.0 / 3.0 * alpha.sqrt() * left / (u + (u * u + left).sqrt())
        } else {
            edge.min(reach)
        };
        Stretches { origin, height_at_origin, bend, spread, low: (-reach).max(-origin), high }
    }

    /// Height of the flat above the mean height of the summits at a curvature, counted from the origin, in spreads.
    pub fn height_at(&self, curvature: f64) -> f64 {
        self.height_at_origin - curvature / self.bend
    }

    /// Iterates over the stretches: those of the flat summits, going down from the edge, then those of the sharp
    /// ones, going up.
    pub fn iter(&self) -> impl Iterator<Item = Stretch> {
        let edge = self.height_at_origin * self.bend;
        let (flat_end, sharp_start) = (edge.min(self.high), edge.max(self.low));
        let length = |distance: f64, longest: f64, left: f64| {
            // A last stretch that is a fifth longer than the others does no harm.
            const SLACK: f64 = 1.2;
            let length = longest.min(GROWTH * (distance + self.bend));
            if left < SLACK * length { left } else { length }
        };
        let deviation = (2.0f64 / 3.0).sqrt();
        let flat = std::iter::successors(Some((flat_end, flat_end)), move |&(_, to)| {
            let left = to - self.low;
            (left > 0.0).then(|| {
                let length = length(edge - to, LONGEST * deviation * self.spread, left);
                (to, if length == left { self.low } else { to - length })
            })
        });
        let sharp = std::iter::successors(Some((sharp_start, sharp_start)), move |&(_, from)| {
            let left = self.high - from;
            (left > 0.0).then(|| {
                let length = length(from - edge, LONGEST * deviation, left);
                (from, if length == left { self.high } else { from + length })
            })
        });
        let flat = flat.skip(1).map(|(to, from)| (from, to));
        flat.chain(sharp.skip(1)).map(|(from, to)| Stretch {
            from,
            to,
            rooted: self.origin + from < to - from,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stretches(u: f64, alpha: f64) -> Vec<Stretch> {
        let spread = (1.0 - 1.5 / alpha).max(1e-18f64).sqrt();
        let mut stretches: Vec<Stretch> = Stretches::around(u, alpha, spread).iter().collect();
        stretches.sort_by(|a, b| a.from.total_cmp(&b.from));
        stretches
    }

    #[test]
    fn stretches_follow_each_other_and_are_few() {
        for alpha in [1.5, 1.500_001, 1.6, 3.0, 10.0, 1e3, 1e6, 1e40] {
            for u in [-1e6, -30.0, -1.0, -1e-9, 0.0, 1e-9, 0.5, 3.0, 30.0, 1e3, 1e9] {
                let stretches = stretches(u, alpha);
                assert!(stretches.windows(2).all(|pair| pair[0].to == pair[1].from), "{alpha} {u}");
                assert!(stretches.iter().all(|stretch| stretch.from < stretch.to), "{alpha} {u}");
                assert!((1..=16).contains(&stretches.len()), "{alpha} {u}: {}", stretches.len());
            }
        }
    }

    #[test]
    fn the_curvature_of_zero_begins_a_stretch_where_it_counts() {
        assert!(stretches(-1.0, 10.0)[0].rooted && stretches(0.5, 1e3)[0].rooted);
        assert!(stretches(30.0, 2.0).iter().all(|stretch| !stretch.rooted));
    }
}
