//! Rules for panels of the variance: where the integral equation of a growing hardness is collocated, and how it is
//! integrated over a panel that is near.

use std::f64::consts::FRAC_PI_2;

use numerics::GaussLegendre;

use crate::sources::NODES;

/// Largest number of unknowns of a panel: the coefficients of a polynomial.
pub(crate) const SIZE: usize = 9;
/// Smallest number of unknowns of a panel.
pub(crate) const SIZE_MIN: usize = 5;

/// Coefficients by rising power.
pub(crate) type Polynomial = [f64; SIZE];

/// Gauss-Legendre rules of the integrals, and the places of collocation.
pub(crate) struct Rules {
    coarse: GaussLegendre,
    medium: GaussLegendre,
    fine: GaussLegendre,
    pub(crate) finest: GaussLegendre,
    /// By the number of unknowns, from `SIZE_MIN` on.
    pub(crate) collocations: [Collocation; SIZE - SIZE_MIN + 1],
}

/// Places of a panel at which the equation is collocated.
pub(crate) struct Collocation {
    pub(crate) places: [f64; SIZE],
    /// Powers of each place, one row per place; rows of the identity beyond the number of unknowns.
    pub(crate) powers: [Polynomial; SIZE],
}

impl Collocation {
    fn new(size: usize) -> Self {
        let mut places = [1.0; SIZE];
        places[..size - 1].copy_from_slice(GaussLegendre::new(size - 1).nodes());
        let power = |row: usize, column: usize| match (row < size, column < size) {
            (true, true) => places[row].powi(column as i32),
            _ => f64::from(u8::from(row == column)),
        };
        let powers = std::array::from_fn(|row| std::array::from_fn(|column| power(row, column)));
        Collocation { places, powers }
    }
}

impl Rules {
    pub(crate) fn new() -> Self {
        Rules {
            coarse: GaussLegendre::new(4),
            medium: GaussLegendre::new(6),
            fine: GaussLegendre::new(12),
            finest: GaussLegendre::new(NODES),
            collocations: std::array::from_fn(|more| Collocation::new(SIZE_MIN + more)),
        }
    }

    /// Calls `append` with a rule and two angles for each piece of an arc over which x at most halves, down to `resolved_pa`.
    pub(crate) fn split(
        &self,
        arc: &Arc,
        resolved_pa: f64,
        mut append: impl FnMut(&GaussLegendre, f64, f64),
    ) {
        // The hardness has left earlier panels, which makes their kernel as steep as x is small.
        let least_pa = if arc.to == FRAC_PI_2 { resolved_pa } else { 0.0 };
        let mut start = arc.from;
        while start < arc.to {
            let root_pa = arc.radius_pa * start.cos();
            let halved = if root_pa > least_pa { (0.5 * start.cos()).acos() } else { arc.to };
            let end = halved.min(arc.to);
            let rule = match end.cos() / start.cos() {
                0.92.. => &self.coarse,
                0.75.. => &self.medium,
                _ => &self.fine,
            };
            append(rule, start, end);
            start = end;
        }
    }
}

/// Panel as seen from a variance V above it: V' = V_i + R^2 sin^2 and x = sqrt(V - V') = R cos of an angle, in which
/// both the root of the kernel, in x, and that of A_pl, in sqrt(V' - V_i), are smooth.
pub(crate) struct Arc {
    pub(crate) radius_pa: f64,
    from: f64,
    to: f64,
}

impl Arc {
    /// Sees the interval between two variances, from a later one; both lie on a piece of the path that starts at `kink_pa2`.
    pub(crate) fn new(kink_pa2: f64, [from_pa2, to_pa2]: [f64; 2], variance_pa2: f64) -> Self {
        let angle = |at_pa2: f64| (at_pa2 - kink_pa2).sqrt().atan2((variance_pa2 - at_pa2).sqrt());
        Arc { radius_pa: (variance_pa2 - kink_pa2).sqrt(), from: angle(from_pa2), to: angle(to_pa2) }
    }
}
