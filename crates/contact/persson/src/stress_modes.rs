//! Stress between its two walls, 0 and a growing hardness, as a sum of modes: for the scales at which it has spread over the
//! whole interval.
//!
//! With x = sigma/H and w = C/p the heat equation of the mean excess C has fixed walls, w(0) = 1 and w(1) = 0:
//!
//! dw/dtau = w''/2 + c x w',  dtau = dV/H^2,  c = d(H^2)/dV / 2.
//!
//! w - (1 - x) is expanded in differences of Legendre polynomials that vanish at both walls (Shen 1994, SIAM J. Sci. Comput.
//! 15:1489), for which every matrix has five diagonals. Steps are those of Radau's method IIA with four stages (Hairer &
//! Wanner 1996, Solving Ordinary Differential Equations II, IV.5), in the distance y = sqrt(V - V_i) from the last kink of
//! the hardness, of which the solution is a smooth function.

use multiversion::multiversion;
use numerics::GaussLegendre;

use crate::areas::ContactAreas;

/// Number of modes.
const MODES: usize = 32;
/// Nodes of the rule by which a state is expanded.
const NODES: usize = 48;
/// Stages of a step.
const STAGES: usize = 4;
/// Places of the stages in a step.
const PLACES: [f64; STAGES] =
    [0.088_587_959_512_703_95, 0.409_466_864_440_734_7, 0.787_659_461_760_847_1, 1.0];

type Block = [[f64; STAGES]; STAGES];
type Stages = [f64; STAGES];
/// Entries of a row of a matrix of five diagonals, two before the diagonal to two behind it.
type Row = [f64; 5];

/// Equations of the modes: M da/dtau = -2 a + c (G a - b).
#[derive(Debug)]
pub(crate) struct StressEquations {
    /// Matrix M of the products of two modes.
    masses: [Row; MODES],
    /// Matrix G of the products of a mode and (1 + z) times the slope of another, z = 2x - 1.
    drifts: [Row; MODES],
    /// Slope of every mode at x = 1, in z. At x = 0 signs alternate.
    slopes: [f64; MODES],
    /// Derivative at each stage by the values at the stages, and by the value at the beginning.
    derivatives: (Block, Stages),
    rule: GaussLegendre,
}

/// Equations of a step after elimination: work space.
#[derive(Debug)]
pub(crate) struct Elimination {
    /// Inverses of the blocks on the diagonal.
    inverses: [Block; MODES],
    /// Both blocks behind the diagonal.
    behind: [[Block; 2]; MODES],
    right: [Stages; MODES],
}

impl Default for Elimination {
    fn default() -> Self {
        let (block, right) = (Block::default(), Stages::default());
        Elimination { inverses: [block; MODES], behind: [[block; 2]; MODES], right: [right; MODES] }
    }
}

/// State at one variance: the modes of w - (1 - x).
#[derive(Debug, Clone)]
pub(crate) struct StressModes([f64; MODES]);

/// Stage of a step: its length dtau/dt, and the growth c.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stage {
    pub(crate) length: f64,
    pub(crate) growth: f64,
}

impl StressEquations {
    pub(crate) fn new() -> Self {
        let number = |k: usize| k as f64;
        // The modes (L_k - L_k+2)/sqrt(4k + 6) have orthonormal slopes; the square of L_k is 2/(2k + 1).
        let norm = |k: usize| (4.0 * number(k) + 6.0).sqrt().recip();
        let square = |k: usize| 2.0 / (2.0 * number(k) + 1.0);
        let mass = |j: usize, k: usize| match j.abs_diff(k) {
            0 => norm(k) * norm(k) * (square(k) + square(k + 2)),
            2 => -norm(j) * norm(k) * square(j.max(k)),
            _ => 0.0,
        };
        // (1 + z) L_k+1 = L_k+1 + ((k + 2) L_k+2 + (k + 1) L_k)/(2k + 3).
        let drift = |j: usize, k: usize| {
            let part = |m: usize| match (m + 2).checked_sub(k) {
                Some(2) => number(k + 1) / number(2 * k + 3) * square(m),
                Some(3) => square(m),
                Some(4) => number(k + 2) / number(2 * k + 3) * square(m),
                _ => 0.0,
            };
            -norm(j) * norm(k) * number(2 * k + 3) * (part(j) - part(j + 2))
        };
        let rows = |entry: &dyn Fn(usize, usize) -> f64| {
            std::array::from_fn(|j| {
                std::array::from_fn(|at| (j + at).checked_sub(2).map_or(0.0, |k| entry(j, k)))
            })
        };
        StressEquations {
            masses: rows(&mass),
            drifts: rows(&drift),
            slopes: std::array::from_fn(|k| -norm(k) * number(2 * k + 3)),
            derivatives: derivatives(),
            rule: GaussLegendre::new(NODES),
        }
    }

    /// Expands the state whose -dw/dx at x is `fall`.
    pub(crate) fn expand(&self, mut fall: impl FnMut(f64) -> f64) -> StressModes {
        let mut modes = [0.0; MODES];
        for (&z, weight) in self.rule.nodes().iter().zip(self.rule.weights()) {
            let slope = 0.5 * weight * (1.0 - fall(0.5 * (1.0 + z)));
            let mut legendre = [1.0, z];
            for (k, (mode, at_one)) in modes.iter_mut().zip(&self.slopes).enumerate() {
                *mode += at_one * legendre[1] * slope;
                let n = (k + 1) as f64;
                legendre = [legendre[1], ((2.0 * n + 1.0) * z * legendre[1] - n * legendre[0]) / (n + 1.0)];
            }
        }
        StressModes(modes)
    }

    /// Returns -dw/dx of a state at several x, side by side.
    pub(crate) fn falls<const N: usize>(&self, state: &StressModes, places: [f64; N]) -> [f64; N] {
        let z = places.map(|x| 2.0 * x - 1.0);
        let (mut falls, mut before, mut now) = ([1.0; N], [1.0; N], z);
        for (k, (mode, at_one)) in state.0.iter().zip(&self.slopes).enumerate() {
            let n = (k + 1) as f64;
            let [of_now, of_before] = [(2.0 * n + 1.0) / (n + 1.0), n / (n + 1.0)];
            let slope = 2.0 * mode * at_one;
            for at in 0..N {
                falls[at] -= slope * now[at];
                (before[at], now[at]) = (now[at], of_now * z[at] * now[at] - of_before * before[at]);
            }
        }
        falls
    }

    /// Returns the shares of the nominal area, with p/H.
    pub(crate) fn areas(&self, state: &StressModes, pressure_over_hardness: f64) -> ContactAreas {
        let (mut at_zero, mut at_one) = (0.0, 0.0);
        for (k, (mode, slope)) in state.0.iter().zip(&self.slopes).enumerate() {
            at_one += mode * slope;
            at_zero += if k % 2 == 0 { -mode * slope } else { mode * slope };
        }
        let plastic = (pressure_over_hardness * (1.0 - 2.0 * at_one)).clamp(0.0, 1.0);
        let elastic = (2.0 * pressure_over_hardness * (at_one - at_zero)).clamp(0.0, 1.0 - plastic);
        ContactAreas { elastic, plastic, gap: 1.0 - plastic - elastic }
    }

    /// Follows the state over a step.
    pub(crate) fn step(
        &self,
        state: &mut StressModes,
        elimination: &mut Elimination,
        stage_at: impl Fn(f64) -> Stage,
    ) {
        advance(self, state, elimination, PLACES.map(stage_at));
    }
}

/// Derivatives at the stages of the polynomial through the beginning and the stages.
fn derivatives() -> (Block, Stages) {
    let places: [f64; STAGES + 1] = std::array::from_fn(|at| if at == 0 { 0.0 } else { PLACES[at - 1] });
    // Product of the distances of a place from all others but `left_out`.
    let product = |of: usize, left_out: usize| -> f64 {
        (0..=STAGES)
            .filter(|other| *other != of && *other != left_out)
            .map(|other| places[of] - places[other])
            .product()
    };
    let entry = |row: usize, column: usize| match row == column {
        true => (0..=STAGES)
            .filter(|other| *other != row)
            .map(|other| (places[row] - places[other]).recip())
            .sum(),
        false => product(row, column) / product(column, column),
    };
    let block = std::array::from_fn(|row| std::array::from_fn(|column| entry(row + 1, column + 1)));
    (block, std::array::from_fn(|row| entry(row + 1, 0)))
}

/// Solves for the state at the end of a step by elimination of blocks. The equations lose energy at every stage, so no
/// pivot is small.
#[multiversion(targets("x86_64+avx2"))]
fn advance(
    equations: &StressEquations,
    state: &mut StressModes,
    Elimination { inverses, behind, right }: &mut Elimination,
    stages: [Stage; STAGES],
) {
    let (derivatives, of_beginning) = &equations.derivatives;
    let StressModes(modes) = state;
    let entry = |row: usize, at: usize| -> Block {
        let (mass, drift) = (equations.masses[row][at], equations.drifts[row][at]);
        let mut block = *derivatives;
        for (i, (numbers, stage)) in block.iter_mut().zip(&stages).enumerate() {
            for number in numbers.iter_mut() {
                *number *= mass;
            }
            numbers[i] += stage.length * (if at == 2 { 2.0 } else { 0.0 } - stage.growth * drift);
        }
        block
    };
    // Of (G a - b): b is the product of a mode and x.
    let source = |row: usize| match row {
        0 => 6f64.sqrt().recip(),
        1 => 10f64.sqrt().recip() / 3.0,
        _ => 0.0,
    };
    for row in 0..MODES {
        let mut mass = 0.0;
        for at in 0..5 {
            if let Some(mode) = (row + at).checked_sub(2).and_then(|column| modes.get(column)) {
                mass += equations.masses[row][at] * mode;
            }
        }
        let mut rest: Stages = std::array::from_fn(|i| {
            -of_beginning[i] * mass - stages[i].length * stages[i].growth * source(row)
        });
        let mut diagonal = entry(row, 2);
        let mut next = entry(row, 3);
        let mut before = entry(row, 1);
        if row > 1 {
            let factor = product(&entry(row, 0), &inverses[row - 2]);
            subtract(&mut before, &product(&factor, &behind[row - 2][0]));
            subtract(&mut diagonal, &product(&factor, &behind[row - 2][1]));
            subtract_applied(&mut rest, &factor, &right[row - 2]);
        }
        if row > 0 {
            let factor = product(&before, &inverses[row - 1]);
            subtract(&mut diagonal, &product(&factor, &behind[row - 1][0]));
            subtract(&mut next, &product(&factor, &behind[row - 1][1]));
            subtract_applied(&mut rest, &factor, &right[row - 1]);
        }
        inverses[row] = inverse(diagonal);
        behind[row] = [next, entry(row, 4)];
        right[row] = rest;
    }
    let mut solved = [Stages::default(); MODES + 2];
    for row in (0..MODES).rev() {
        let mut rest = right[row];
        for (at, block) in behind[row].iter().enumerate() {
            subtract_applied(&mut rest, block, &solved[row + 1 + at]);
        }
        for (number, numbers) in solved[row].iter_mut().zip(&inverses[row]) {
            *number = numbers.iter().zip(&rest).map(|(a, b)| a * b).sum();
        }
        modes[row] = solved[row][STAGES - 1];
    }
}

#[inline(always)]
fn product(a: &Block, b: &Block) -> Block {
    let mut product = Block::default();
    for (row, numbers) in product.iter_mut().zip(a) {
        for (number, other) in numbers.iter().zip(b) {
            for (sum, entry) in row.iter_mut().zip(other) {
                *sum += number * entry;
            }
        }
    }
    product
}

#[inline(always)]
fn subtract(from: &mut Block, block: &Block) {
    for (from, block) in from.iter_mut().zip(block) {
        for (from, block) in from.iter_mut().zip(block) {
            *from -= block;
        }
    }
}

#[inline(always)]
fn subtract_applied(from: &mut Stages, block: &Block, to: &Stages) {
    for (from, numbers) in from.iter_mut().zip(block) {
        for (number, to) in numbers.iter().zip(to) {
            *from -= number * to;
        }
    }
}

/// Inverts a block by Gauss and Jordan's elimination.
#[inline(always)]
fn inverse(mut block: Block) -> Block {
    let mut inverse: Block = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
    for pivot in 0..STAGES {
        let scale = block[pivot][pivot].recip();
        let (of_block, of_inverse) =
            (block[pivot].map(|number| number * scale), inverse[pivot].map(|number| number * scale));
        (block[pivot], inverse[pivot]) = (of_block, of_inverse);
        for row in (0..STAGES).filter(|row| *row != pivot) {
            let factor = block[row][pivot];
            for column in 0..STAGES {
                block[row][column] -= factor * of_block[column];
                inverse[row][column] -= factor * of_inverse[column];
            }
        }
    }
    inverse
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    #[test]
    fn derivatives_at_the_stages_are_exact_for_polynomials_through_them() {
        let (block, of_beginning) = derivatives();
        for power in 0..=STAGES as i32 {
            for (i, row) in block.iter().enumerate() {
                let at_beginning = if power == 0 { of_beginning[i] } else { 0.0 };
                let found =
                    at_beginning + row.iter().zip(PLACES).map(|(d, t)| d * t.powi(power)).sum::<f64>();
                let exact = f64::from(power) * PLACES[i].powi(power - 1);
                assert!((found - exact).abs() < 1e-13, "{power}: {found} {exact}");
            }
        }
        // The places are Radau's: their polynomial is orthogonal to those of the second degree.
        let rule = GaussLegendre::new(STAGES);
        for power in 0..STAGES as i32 - 1 {
            let value = |t: f64| t.powi(power) * PLACES.iter().map(|place| t - place).product::<f64>();
            let integral: f64 = rule.over(0.0, 1.0).map(|(t, weight)| weight * value(t)).sum();
            assert!(integral.abs() < 1e-16, "{power}: {integral}");
        }
    }

    #[test]
    fn the_slopes_of_an_expanded_state_are_its_areas() {
        // w = 1 - x + a x (1 - x).
        let a = -0.3;
        let equations = StressEquations::new();
        let fall = |x: f64| 1.0 - a * (1.0 - 2.0 * x);
        let state = equations.expand(fall);
        let places = [0.0, 0.1, 0.5, 0.77, 1.0];
        for (x, found) in places.into_iter().zip(equations.falls(&state, places)) {
            assert!((found - fall(x)).abs() < 1e-13, "{x}: {found}");
        }
        let areas = equations.areas(&state, 0.2);
        assert!((areas.contact() - 0.2 * (1.0 - a)).abs() < 1e-14, "{areas:?}");
        assert!((areas.plastic - 0.2 * (1.0 + a)).abs() < 1e-14, "{areas:?}");
    }

    #[test]
    fn a_state_that_has_forgotten_its_beginning_has_the_limit_of_a_squared_growth() {
        let equations = StressEquations::new();
        for growth in [1e-6, 0.5, 4.0, 12.0f64] {
            let mut state = equations.expand(|_| 1.0);
            let mut elimination = Elimination::default();
            for _ in 0..8 {
                equations.step(&mut state, &mut elimination, |_| Stage { length: 30.0, growth });
            }
            let root = growth.sqrt();
            let contact = 0.1 * 2.0 / PI.sqrt() * root / libm::erf(root);
            let areas = equations.areas(&state, 0.1);
            assert!((areas.contact() / contact - 1.0).abs() < 1e-11, "{growth}: {areas:?}");
            assert!(
                (areas.plastic - contact * (-growth).exp()).abs() < 1e-11 * contact,
                "{growth}: {areas:?}"
            );
        }
    }
}
