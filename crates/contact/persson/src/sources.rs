//! Gauss quadrature of the plastic area of a panel: few points that act like the whole panel on what comes later.

use std::f64::consts::PI;

use asperity::elementary;
use multiversion::multiversion;

/// Node of a quadrature of a panel.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Source {
    /// V' \[Pa^2\].
    pub(crate) variance_pa2: f64,
    /// Part of the integral of A_pl dV' \[Pa^2\].
    pub(crate) weight_pa2: f64,
}

/// Nodes from which the few points are derived.
pub(crate) const NODES: usize = 16;
/// Largest number of points of a Gauss rule.
const MOST: usize = 8;
/// Numbers of points, with the least distance from the middle of the panel, in its half widths z, from which each
/// suffices: n points of a Gauss rule are off by (z + sqrt(z^2 - 1))^(-2n), here at most 2e-13.
pub(crate) const RULES: [(usize, f64); 5] = [(2, 770.0), (3, 66.0), (4, 19.5), (6, 7.5), (8, 4.0)];

/// Points of all panels so far, one panel after the other, for each of the `RULES`.
///
/// They are Gauss rules whose weight is the plastic area of a panel, as a function of the variance. So the root with
/// which it starts at a kink does no harm: every other factor is smooth in the variance.
#[derive(Debug, Default)]
pub(crate) struct Sources {
    points: [Points; RULES.len()],
    /// Terms of both sums: work space.
    terms: [Vec<f64>; 2],
}

/// Points, number by number, so that several are computed at once.
#[derive(Debug, Default)]
struct Points {
    variances_pa2: Vec<f64>,
    hardnesses_pa: Vec<f64>,
    weights_pa2: Vec<f64>,
}

/// Returns the place in `RULES` of the smallest rule for a distance from the middle of a panel in half widths.
pub(crate) fn rule_at(distance: f64) -> Option<usize> {
    RULES.iter().position(|(_, least)| distance > *least)
}

impl Sources {
    /// Appends the points of the next panel, from a fine quadrature between two variances.
    pub(crate) fn append(
        &mut self,
        nodes: impl Iterator<Item = Source>,
        [from_pa2, to_pa2]: [f64; 2],
        hardness_pa: impl Fn(f64) -> f64,
    ) {
        let half_pa2 = 0.5 * (to_pa2 - from_pa2);
        let mut measure = [[0.0; 2]; NODES];
        for (point, node) in measure.iter_mut().zip(nodes) {
            *point = [(node.variance_pa2 - from_pa2) / half_pa2 - 1.0, node.weight_pa2];
        }
        let recurrence = Recurrence::new(&measure);
        let mut roots = Roots::default();
        for size in 1..=MOST {
            roots = recurrence.roots(size, &roots);
            let Some(at) = RULES.iter().position(|(of_rule, _)| *of_rule == size) else { continue };
            let points = &mut self.points[at];
            for &t in &roots[..size] {
                let variance_pa2 = from_pa2 + half_pa2 * (1.0 + t);
                points.variances_pa2.push(variance_pa2);
                points.hardnesses_pa.push(hardness_pa(variance_pa2));
                points.weights_pa2.push(recurrence.weight(size, t));
            }
        }
    }

    /// Sums weights times (H + H') g(H + H') - (H - H') g(H - H'), and times H' g(H'), over the points that one of the
    /// rules has for a range of panels, at a later place.
    pub(crate) fn passages(
        &mut self,
        rule: usize,
        panels: std::ops::Range<usize>,
        variance_pa2: f64,
        hardness_pa: f64,
    ) -> [f64; 2] {
        let size = RULES[rule].0;
        let range = size * panels.start..size * panels.end;
        let Points { variances_pa2, hardnesses_pa, weights_pa2 } = &self.points[rule];
        let [plastic, contact] = self.terms.each_mut().map(|terms| {
            if terms.len() < range.len() {
                terms.resize(range.len(), 0.0);
            }
            &mut terms[..range.len()]
        });
        let points = [variances_pa2, hardnesses_pa, weights_pa2].map(|numbers| &numbers[range.clone()]);
        passages_of_each([variance_pa2, hardness_pa], points, [plastic, contact])
    }
}

/// Computes both passages of each point to a place of a variance and a hardness, and returns their sums.
#[multiversion(targets("x86_64+avx2"))]
fn passages_of_each(
    [variance_pa2, hardness_pa]: [f64; 2],
    [variances_pa2, hardnesses_pa, weights_pa2]: [&[f64]; 3],
    [plastic, contact]: [&mut [f64]; 2],
) -> [f64; 2] {
    let points = variances_pa2.iter().zip(hardnesses_pa).zip(weights_pa2);
    for ((plastic, contact), ((there_pa2, there_pa), weight_pa2)) in
        plastic.iter_mut().zip(contact.iter_mut()).zip(points)
    {
        [*plastic, *contact] = passages(variance_pa2 - there_pa2, hardness_pa, *there_pa, *weight_pa2);
    }
    let scale = (0.5 / PI).sqrt();
    [scale * sum(plastic), scale * sum(contact)]
}

/// Sums four lanes side by side.
#[inline(always)]
pub(crate) fn sum(terms: &[f64]) -> f64 {
    let (fours, rest) = terms.as_chunks::<4>();
    let [a, b, c, d] = fours
        .iter()
        .fold([0.0; 4], |[a, b, c, d], four| [a + four[0], b + four[1], c + four[2], d + four[3]]);
    (a + b) + (c + d) + rest.iter().sum::<f64>()
}

/// Both passages of a point, up to a factor 1/sqrt(2 pi).
#[inline(always)]
fn passages(apart_pa2: f64, here_pa: f64, there_pa: f64, weight_pa2: f64) -> [f64; 2] {
    let per_pa2 = 1.0 / apart_pa2;
    let scale = weight_pa2 * (per_pa2 * per_pa2.sqrt());
    let (apart_pa, mirrored_pa) = (here_pa - there_pa, here_pa + there_pa);
    let half = -0.5 * per_pa2;
    let passage = |distance_pa: f64| distance_pa * elementary::exp(half * (distance_pa * distance_pa));
    [scale * (passage(mirrored_pa) - passage(apart_pa)), scale * passage(there_pa)]
}

type Roots = [f64; MOST];

/// Monic orthogonal polynomials p_{k+1} = (t - alpha_k) p_k - beta_k p_{k-1} of a measure on \[-1, 1\].
struct Recurrence {
    alpha: [f64; MOST],
    beta: [f64; MOST],
    /// Whole measure.
    total: f64,
}

impl Recurrence {
    /// Stieltjes' procedure for a measure of points and weights.
    fn new(measure: &[[f64; 2]; NODES]) -> Self {
        let (mut alpha, mut beta) = ([0.0; MOST], [0.0; MOST]);
        let (mut last, mut now) = ([0.0; NODES], [1.0; NODES]);
        let (mut total, mut norm_before) = (0.0, 1.0);
        for k in 0..MOST {
            let (mut norm, mut first) = (0.0, 0.0);
            for ([t, weight], value) in measure.iter().zip(now) {
                let square = weight * value * value;
                norm += square;
                first += t * square;
            }
            if k == 0 {
                total = norm;
            }
            // An underflowing measure is 0: any nodes will do.
            alpha[k] = if norm == 0.0 { 0.0 } else { first / norm };
            beta[k] = if k == 0 || norm_before == 0.0 { 0.0 } else { norm / norm_before };
            norm_before = norm;
            for ((last, now), [t, _]) in last.iter_mut().zip(&mut now).zip(measure) {
                (*last, *now) = (*now, (t - alpha[k]) * *now - beta[k] * *last);
            }
        }
        Recurrence { alpha, beta, total }
    }

    /// p_size and its derivative.
    fn value(&self, size: usize, t: f64) -> [f64; 2] {
        let (mut before, mut now) = ([0.0; 2], [1.0, 0.0]);
        for k in 0..size {
            let next = |order: usize| (t - self.alpha[k]) * now[order] - self.beta[k] * before[order];
            (before, now) = (now, [next(0), next(1) + now[0]]);
        }
        now
    }

    /// Returns the zeros of p_size, which the zeros of the polynomial before separate.
    fn roots(&self, size: usize, separators: &Roots) -> Roots {
        let mut roots = Roots::default();
        for at in 0..size {
            let low = if at == 0 { -1.0 } else { separators[at - 1] };
            let high = if at + 1 == size { 1.0 } else { separators[at] };
            let sign = if (size - at).is_multiple_of(2) { 1.0 } else { -1.0 };
            roots[at] = numerics::newton_in_bracket(low, high, 0.5 * (low + high), |t| {
                let [value, slope] = self.value(size, t);
                (-sign * value, -sign * slope)
            });
        }
        roots
    }

    /// Weight of a zero of p_size: the inverse of the sum of the squares of all normalised polynomials before.
    fn weight(&self, size: usize, t: f64) -> f64 {
        let (mut before, mut now, mut norm, mut sum) = (0.0, 1.0, 1.0, 0.0);
        for k in 0..size {
            if k > 0 {
                norm *= self.beta[k];
            }
            if norm > 0.0 {
                sum += now * now / norm;
            }
            (before, now) = (now, (t - self.alpha[k]) * now - self.beta[k] * before);
        }
        self.total / sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_points_integrate_what_is_smooth_even_under_a_root() {
        // sqrt(v) dv on [0, 1] against 1/(z - v), by the distance of z.
        let rule = numerics::GaussLegendre::new(NODES);
        let nodes = rule.over(0.0, 1.0).map(|(root, weight)| Source {
            variance_pa2: root * root,
            weight_pa2: 2.0 * root * weight * root,
        });
        let mut sources = Sources::default();
        sources.append(nodes, [0.0, 1.0], |_| 1.0);
        for (rule, (size, distance)) in RULES.into_iter().enumerate() {
            let z = 0.5 * (1.0 + distance);
            let exact = 2.0 * (z.sqrt() * (1.0 / z.sqrt()).atanh() - 1.0);
            let Points { variances_pa2, weights_pa2, .. } = &sources.points[rule];
            assert_eq!(weights_pa2.len(), size);
            let found: f64 =
                variances_pa2.iter().zip(weights_pa2).map(|(at, weight)| weight / (z - at)).sum();
            assert_eq!(rule_at(1.001 * distance), Some(rule));
            assert!((found / exact - 1.0).abs() < 1e-11, "{distance}: {found} {exact}");
        }
        assert_eq!(rule_at(2.0), None);
    }
}
