//! Share of the nominal area above a stress, between the walls 0 and H, as polynomials on elements.
//!
//! With x = 1 - sigma/H and g = f H/p, where f(sigma) is the share whose stress exceeds sigma, g diffuses, and a growing hardness
//! carries it along:
//!
//! dg/dtau = d/dx \[(1/2) dg/dx - c (1 - x) g\],  dtau = dV/H^2,  c = d(H^2)/dV / 2.
//!
//! Nothing passes either end, so that the integral of g over x stays 1. Elements are halves of halves of \[0, 1\], as short as g is
//! curved (Galerkin's method, polynomials through Chebyshev's points). Steps are those of the diagonally implicit method of
//! fourth order of Hairer & Wanner 1996, Solving Ordinary Differential Equations II, IV.6, with its embedded error.

use std::f64::consts::PI;

use multiversion::multiversion;
use numerics::GaussLegendre;

/// Nodes of an element.
const SIZE: usize = 8;
/// Last two coefficients of an element over the largest g above which it is halved, the multiple of it above which a step is
/// tried again after that, and the share of it below which two halves are joined.
const RESOLUTION: f64 = 4e-7;
const COARSE: f64 = 10.0;
const JOINED: f64 = 0.3;
/// Width below which no element is halved.
const NARROWEST: f64 = 1e-18;
/// Number of elements from which on none is halved.
const MOST_ELEMENTS: usize = 300;
/// Share of the largest g that is negligible.
const UNREACHED: f64 = 3e-8;
/// Distance over the spread beyond which the normal density is negligible.
const FAR: f64 = 8.5;

/// Stages of a step.
pub(crate) const STAGES: usize = 5;
/// Places of the stages in a step.
pub(crate) const PLACES: [f64; STAGES] = [0.25, 0.75, 0.55, 0.5, 1.0];
/// Weight of each stage in itself, and of the stages before.
const DIAGONAL: f64 = 0.25;
const BEFORE: [[f64; STAGES - 1]; STAGES] = [
    [0.0; 4],
    [0.5, 0.0, 0.0, 0.0],
    [17.0 / 50.0, -1.0 / 25.0, 0.0, 0.0],
    [371.0 / 1360.0, -137.0 / 2720.0, 15.0 / 544.0, 0.0],
    [25.0 / 24.0, -49.0 / 48.0, 125.0 / 16.0, -85.0 / 12.0],
];
/// Weights of the stages in the difference from the embedded method of third order.
const ERROR: [f64; STAGES] = [-3.0 / 16.0, -27.0 / 32.0, 25.0 / 32.0, 0.0, 0.25];

type Values = [f64; SIZE];
type Matrix = [Values; SIZE];

/// Stage of a step: its length in V/H^2, and the growth c.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stage {
    pub(crate) length: f64,
    pub(crate) growth: f64,
}

/// Element from -1 to 1.
#[derive(Debug)]
pub(crate) struct Element {
    nodes: Values,
    /// Integrals of the shape functions.
    weights: Values,
    /// Integrals of the products of two shape functions, and of their slopes.
    masses: Matrix,
    stiffnesses: Matrix,
    /// Integrals of a slope times a shape function, and of both times the variable.
    drifts: [Matrix; 2],
    /// Values at the nodes of both halves.
    halves: [Matrix; 2],
    /// Value at each node by those at the nodes of the half in which it lies.
    whole: Matrix,
    /// Last two Chebyshev coefficients.
    tails: [Values; 2],
    /// Rule for convolutions with the normal density.
    rule: GaussLegendre,
}

/// Share above each stress at one variance.
#[derive(Debug, Clone, Default)]
pub(crate) struct StressProfile {
    /// Ends of the elements, from x = 0 at the hardness to x = 1.
    edges: Vec<f64>,
    /// Values of g at all nodes; neighbouring elements share one.
    values: Vec<f64>,
}

/// Work space of a step, and its result.
#[derive(Debug, Default)]
pub(crate) struct StepWork {
    known: Vec<f64>,
    slopes: [Vec<f64>; STAGES],
    next: Vec<f64>,
    error: Vec<f64>,
    /// For each element, the values at its nodes if its end has none, and what the end takes from them.
    eliminated: Vec<[Values; 2]>,
}

impl Element {
    pub(crate) fn new() -> Self {
        let last = (SIZE - 1) as f64;
        let nodes: Values = std::array::from_fn(|i| -(PI * i as f64 / last).cos());
        let product = |i: usize, left_out: usize, z: f64| -> f64 {
            let others = (0..SIZE).filter(|j| *j != i && *j != left_out);
            others.map(|j| (z - nodes[j]) / (nodes[i] - nodes[j])).product()
        };
        let shape = |i: usize, z: f64| product(i, i, z);
        let slope = |i: usize, z: f64| -> f64 {
            (0..SIZE).filter(|j| *j != i).map(|j| product(i, j, z) / (nodes[i] - nodes[j])).sum()
        };
        let exact = GaussLegendre::new(SIZE + 1);
        let integral =
            |of: &dyn Fn(f64) -> f64| exact.over(-1.0, 1.0).map(|(z, weight)| weight * of(z)).sum();
        let matrix = |of: &dyn Fn(usize, usize) -> f64| -> Matrix {
            std::array::from_fn(|i| std::array::from_fn(|j| of(i, j)))
        };
        let coefficient =
            |i: usize, order: f64| 2.0 / last * end_weight(i) * (order * PI * (1.0 - i as f64 / last)).cos();
        Element {
            nodes,
            weights: std::array::from_fn(|i| integral(&|z| shape(i, z))),
            masses: matrix(&|i, j| integral(&|z| shape(i, z) * shape(j, z))),
            stiffnesses: matrix(&|i, j| integral(&|z| slope(i, z) * slope(j, z))),
            drifts: [
                matrix(&|i, j| integral(&|z| slope(i, z) * shape(j, z))),
                matrix(&|i, j| integral(&|z| slope(i, z) * z * shape(j, z))),
            ],
            halves: [-1.0, 1.0].map(|side| matrix(&|i, j| shape(j, 0.5 * (nodes[i] + side)))),
            whole: matrix(&|i, j| shape(j, 2.0 * nodes[i] - nodes[i].signum())),
            tails: [
                std::array::from_fn(|i| 0.5 * coefficient(i, last)),
                std::array::from_fn(|i| coefficient(i, last - 1.0)),
            ],
            rule: GaussLegendre::new(12),
        }
    }

    /// Size of the last two coefficients of a polynomial.
    fn tail(&self, values: &[f64]) -> f64 {
        self.tails.iter().map(|tail| dot(tail, values).abs()).sum()
    }

    /// Value of a polynomial at z, by the barycentric formula.
    fn value(&self, values: &[f64], z: f64) -> f64 {
        let [mut above, mut below] = [0.0; 2];
        for (i, (value, node)) in values.iter().zip(&self.nodes).enumerate() {
            if z == *node {
                return *value;
            }
            let sign = if i % 2 == 0 { 1.0 } else { -1.0 };
            let weight = sign * end_weight(i) / (z - node);
            above += weight * value;
            below += weight;
        }
        above / below
    }
}

/// Weight of a node in sums over Chebyshev's points, of which both ends count half.
fn end_weight(i: usize) -> f64 {
    if i == 0 || i + 1 == SIZE { 0.5 } else { 1.0 }
}

fn dot(row: &Values, values: &[f64]) -> f64 {
    row.iter().zip(values).map(|(a, b)| a * b).sum()
}

impl StressProfile {
    /// Interpolates g as a function of x, up to a factor.
    pub(crate) fn through(element: &Element, of: impl Fn(f64) -> f64) -> Self {
        let (first, largest) = (of(0.0), of(1.0));
        let mut profile = StressProfile { edges: vec![0.0], values: vec![first] };
        let mut left = vec![[0.0, 1.0]];
        while let Some([from, to]) = left.pop() {
            let (middle, half): (f64, f64) = (0.5 * (from + to), 0.5 * (to - from));
            let values: Values = std::array::from_fn(|i| of(middle + half * element.nodes[i]));
            if element.tail(&values) > RESOLUTION * largest && half > NARROWEST {
                left.extend([[middle, to], [from, middle]]);
            } else {
                profile.edges.push(to);
                profile.values.extend_from_slice(&values[1..]);
            }
        }
        profile.normalise(element);
        profile
    }

    fn normalise(&mut self, element: &Element) {
        let mass = |at: usize| {
            0.5 * (self.edges[at + 1] - self.edges[at]) * dot(&element.weights, of_element(&self.values, at))
        };
        let mass: f64 = (0..self.elements()).map(mass).sum();
        self.values.iter_mut().for_each(|value| *value /= mass);
    }

    fn elements(&self) -> usize {
        self.edges.len() - 1
    }

    /// Value of g at the hardness: the plastic share over p/H.
    pub(crate) fn at_hardness(&self) -> f64 {
        self.values.first().copied().unwrap_or_default()
    }

    /// Value of g at no stress: the share in contact over p/H.
    pub(crate) fn at_zero(&self) -> f64 {
        self.values.last().copied().unwrap_or_default()
    }

    /// Returns the distance x from the hardness within which g is negligible, if there is any.
    pub(crate) fn unreached(&self, element: &Element) -> Option<f64> {
        let is_negligible = |value: f64| value.abs() <= UNREACHED * self.at_zero();
        let mut within = None;
        for (at, ends) in self.edges.windows(2).enumerate() {
            for (node, value) in element.nodes.iter().zip(of_element(&self.values, at)) {
                if !is_negligible(*value) {
                    return within;
                }
                within = Some(ends[0] + 0.5 * (ends[1] - ends[0]) * (1.0 + node));
            }
        }
        within
    }

    /// Integrates g times the normal density about a place x, and about its mirror image beyond 1.
    pub(crate) fn spread(&self, element: &Element, place: f64, spread: f64) -> f64 {
        let over_element = |place: f64, at: usize| -> f64 {
            let [from, to] = [0, 1].map(|end| (self.edges[at + end] - place) / spread);
            let (first, last) = (from.max(-FAR), to.min(FAR));
            if first >= last {
                return 0.0;
            }
            let parts = (0.5 * (last - first)).ceil();
            let width = (last - first) / parts;
            let values = of_element(&self.values, at);
            let over = |part: i32| {
                let start = first + width * f64::from(part);
                element.rule.over(start, start + width)
            };
            let value = |t: f64| element.value(values, 2.0 * (t - from) / (to - from) - 1.0);
            (0..parts as i32).flat_map(over).map(|(t, weight)| weight * (-0.5 * t * t).exp() * value(t)).sum()
        };
        let about = |place: f64| (0..self.elements()).map(|at| over_element(place, at)).sum::<f64>();
        (about(place) + about(2.0 - place)) / (2.0 * PI).sqrt()
    }

    /// Tries a step, and returns its largest error over the largest g.
    pub(crate) fn attempt(&self, element: &Element, work: &mut StepWork, stages: [Stage; STAGES]) -> f64 {
        work.error.clear();
        work.error.resize(self.values.len(), 0.0);
        for (at, stage) in stages.into_iter().enumerate() {
            work.known.clone_from(&self.values);
            for (slopes, factor) in work.slopes[..at].iter().zip(BEFORE[at]) {
                add(&mut work.known, factor, slopes);
            }
            solve(element, &self.edges, stage, work);
            let StepWork { known, slopes, next, error, .. } = work;
            let slopes = &mut slopes[at];
            slopes.clear();
            slopes.extend(next.iter().zip(known.iter()).map(|(next, known)| (next - known) / DIAGONAL));
            add(error, ERROR[at], slopes);
        }
        let larger = |largest: f64, value: &f64| if value.abs() <= largest { largest } else { value.abs() };
        // Not a number is the largest.
        let largest = |values: &[f64]| values.iter().fold(0.0, larger);
        largest(&work.error) / largest(&work.next)
    }

    /// Halves the elements that do not resolve the tried step, and returns true if it has to be tried again.
    pub(crate) fn refine(&mut self, element: &Element, work: &StepWork, is_last: bool) -> bool {
        let coarse = if is_last { RESOLUTION } else { COARSE * RESOLUTION };
        self.halve(element, &work.next, coarse)
    }

    /// Takes the tried step, and joins and halves elements as it needs them.
    pub(crate) fn accept(&mut self, element: &Element, work: &mut StepWork) {
        std::mem::swap(&mut self.values, &mut work.next);
        let mut at = 0;
        while at + 1 < self.elements() {
            let [from, middle, to] = [0, 1, 2].map(|more| self.edges[at + more]);
            let start = at * (SIZE - 1);
            if middle - from == to - middle && (from / (to - from)).fract() == 0.0 {
                let halves = [at, at + 1].map(|half| of_element(&self.values, half));
                let whole: Values =
                    std::array::from_fn(|i| dot(&element.whole[i], halves[usize::from(2 * i >= SIZE)]));
                if element.tail(&whole) < JOINED * RESOLUTION * self.at_zero() {
                    self.values.splice(start..start + 2 * SIZE - 1, whole);
                    self.edges.remove(at + 1);
                    at = at.saturating_sub(1);
                    continue;
                }
            }
            at += 1;
        }
        self.normalise(element);
        work.next.clone_from(&self.values);
        self.halve(element, &work.next, RESOLUTION);
    }

    /// Halves the elements on which the last coefficients of other values at the same nodes are too large; false if there are none.
    fn halve(&mut self, element: &Element, values: &[f64], coarse: f64) -> bool {
        let largest = values.last().copied().unwrap_or_default();
        let is_coarse = |at: usize| {
            let width = self.edges[at + 1] - self.edges[at];
            element.tail(of_element(values, at)) > coarse * largest
                && width > NARROWEST.max(1e-12 * self.edges[at])
        };
        if self.elements() > MOST_ELEMENTS || !(0..self.elements()).any(is_coarse) {
            return false;
        }
        let mut finer = StressProfile { edges: vec![0.0], values: vec![self.values[0]] };
        for at in 0..self.elements() {
            let own = of_element(&self.values, at);
            if is_coarse(at) {
                finer.edges.push(0.5 * (self.edges[at] + self.edges[at + 1]));
                for half in &element.halves {
                    finer.values.extend(half[1..].iter().map(|row| dot(row, own)));
                }
            } else {
                finer.values.extend_from_slice(&own[1..]);
            }
            finer.edges.push(self.edges[at + 1]);
        }
        *self = finer;
        true
    }
}

/// Values at the nodes of an element.
fn of_element(values: &[f64], at: usize) -> &[f64] {
    &values[at * (SIZE - 1)..][..SIZE]
}

fn add(to: &mut [f64], factor: f64, values: &[f64]) {
    if factor != 0.0 {
        to.iter_mut().zip(values).for_each(|(to, value)| *to += factor * value);
    }
}

/// Solves for a stage by Gauss and Jordan's elimination, element by element: the values at the nodes of an element by the one at its
/// end. The equations lose energy, so that no pivot is small.
#[multiversion(targets("x86_64+avx2"))]
fn solve(element: &Element, edges: &[f64], stage: Stage, work: &mut StepWork) {
    const LAST: usize = SIZE - 1;
    let elements = edges.len() - 1;
    let StepWork { known, next, eliminated, .. } = work;
    next.resize(known.len(), 0.0);
    eliminated.clear();
    let step = DIAGONAL * stage.length;
    // What elements before add to the first node of the next one.
    let mut carried = [0.0; 2];
    for at in 0..elements {
        let (width, middle) = (edges[at + 1] - edges[at], 0.5 * (edges[at] + edges[at + 1]));
        let (half, of_stiffness) = (0.5 * width, step / width);
        let of_drifts = [-step * stage.growth * (1.0 - middle), step * stage.growth * half];
        let (mut matrix, mut right) = (Matrix::default(), Values::default());
        for (i, value) in of_element(known, at).iter().enumerate() {
            for j in 0..SIZE {
                let mass = half * element.masses[i][j];
                right[j] += mass * value;
                matrix[i][j] = mass
                    + of_stiffness * element.stiffnesses[i][j]
                    + of_drifts[0] * element.drifts[0][i][j]
                    + of_drifts[1] * element.drifts[1][i][j];
            }
        }
        matrix[0][0] += carried[0];
        right[0] += carried[1];
        for pivot in 0..LAST {
            let inverse = matrix[pivot][pivot].recip();
            let row = matrix[pivot].map(|number| inverse * number);
            let of_row = inverse * right[pivot];
            for i in 0..SIZE {
                let factor = matrix[i][pivot];
                for j in 0..SIZE {
                    matrix[i][j] -= factor * row[j];
                }
                right[i] -= factor * of_row;
            }
            (matrix[pivot], right[pivot]) = (row, of_row);
        }
        carried = [matrix[LAST][LAST], right[LAST]];
        eliminated.push([right, matrix.map(|row| row[LAST])]);
    }
    let mut end = carried[1] / carried[0];
    next[elements * LAST] = end;
    for (at, [right, by_end]) in eliminated.iter().enumerate().rev() {
        let values = &mut next[at * LAST..][..LAST];
        for (value, (right, by_end)) in values.iter_mut().zip(right.iter().zip(by_end)) {
            *value = right - by_end * end;
        }
        end = values[0];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_profile_that_has_forgotten_its_beginning_has_the_limit_of_a_squared_growth() {
        let element = Element::new();
        for growth in [1e-6, 0.5, 4.0, 12.0f64] {
            let mut profile = StressProfile::through(&element, |x| 1.0 + x);
            let mut work = StepWork::default();
            for _ in 0..40 {
                profile.attempt(&element, &mut work, [Stage { length: 1.0, growth }; STAGES]);
                if !profile.refine(&element, &work, true) {
                    profile.accept(&element, &mut work);
                }
            }
            let root = growth.sqrt();
            let contact = 2.0 / PI.sqrt() * root / libm::erf(root);
            assert!((profile.at_zero() / contact - 1.0).abs() < 1e-7, "{growth}: {}", profile.at_zero());
            let plastic = contact * (-growth).exp();
            assert!((profile.at_hardness() - plastic).abs() < 1e-7 * contact, "{growth}: {profile:?}");
        }
    }

    #[test]
    fn a_narrow_profile_is_resolved_and_spreads_like_a_normal_distribution() {
        // The share above a stress about x = 1e-3 with a spread of 1e-4, and the same with a larger spread.
        let element = Element::new();
        let share = |spread: f64| move |x: f64| 0.5 * libm::erfc((1e-3 - x) / (2f64.sqrt() * spread));
        let profile = StressProfile::through(&element, share(1e-4));
        let scale = profile.at_zero();
        for x in [8e-4, 1e-3, 1.3e-3, 0.4] {
            let found = profile.spread(&element, x, 1e-4) / scale;
            let exact = share(2f64.sqrt() * 1e-4)(x);
            assert!((found - exact).abs() < 1e-7, "{x}: {found} {exact}");
        }
        let unreached = profile.unreached(&element).unwrap();
        assert!((3e-4..6e-4).contains(&unreached), "{unreached}");
    }
}
