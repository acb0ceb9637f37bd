//! Hardness H along a spectrum, as a function of the variance V of the flattening pressure.

use asperity::elementary;

/// Pieces of H = H_i [1 + k (V - V_i)]^n, each from its V_i on. A power of the wavevector where the spectrum is a
/// power law, a hardness whose square grows in proportion to V, and a constant hardness all have this form.
#[derive(Debug, Clone, PartialEq)]
pub struct HardnessPath {
    pub(crate) pieces: Vec<Piece>,
}

/// Piece of a path, up to the start of the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Piece {
    /// V_i \[Pa^2\].
    pub(crate) from_variance_pa2: f64,
    /// H_i > 0 \[Pa\].
    hardness_pa: f64,
    /// k \[1/Pa^2\].
    growth_per_pa2: f64,
    /// n.
    exponent: f64,
    /// Least ln\[1 + k (V - V_i)\]: that at the end of the piece where the variance comes to an end, which rounding of V would
    /// miss by any amount.
    least_log: f64,
}

/// Hardness at one wavevector of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HardnessKnot {
    /// Wavevector q > 0 \[rad/m\].
    pub wavevector_rad_per_m: f64,
    /// Variance V >= 0 of the flattening pressure up to q \[Pa^2\].
    pub variance_pa2: f64,
    /// Hardness H > 0 \[Pa\].
    pub hardness_pa: f64,
    /// Exponent e of dV/dq ~ q^(e-1) between here and the next knot: 3 plus the exponent of C1D.
    pub variance_exponent: f64,
}

impl HardnessPath {
    /// Creates H^2 = H_0^2 + c V with H_0 > 0 \[Pa\] and c >= 0.
    #[must_use]
    pub fn with_squared_growth(hardness_pa: f64, growth: f64) -> Self {
        let growth_per_pa2 = growth / (hardness_pa * hardness_pa);
        HardnessPath {
            pieces: vec![Piece {
                from_variance_pa2: 0.0,
                hardness_pa,
                growth_per_pa2,
                exponent: 0.5,
                least_log: f64::NEG_INFINITY,
            }],
        }
    }

    /// Interpolates at least one knot of rising wavevector and non-decreasing variance and hardness: a power of the
    /// wavevector between neighbours, continued beyond the last.
    ///
    /// Knots within 1e-10 of a common power are merged. If more than 500 pieces remain, the tolerance rises tenfold
    /// until they do not.
    #[must_use]
    pub fn through(knots: &[HardnessKnot]) -> Self {
        let mut tolerance = FINEST;
        let mut pieces = joined(knots, tolerance);
        while pieces.len() > MOST_PIECES {
            tolerance *= 10.0;
            pieces = joined(knots, tolerance);
        }
        if pieces.is_empty() {
            let (variance_pa2, hardness_pa) =
                knots.last().map_or((0.0, f64::INFINITY), |knot| (knot.variance_pa2, knot.hardness_pa));
            pieces.push(Piece::constant(variance_pa2, hardness_pa));
        }
        HardnessPath { pieces }
    }

    /// Hardness \[Pa\] at a variance \[Pa^2\].
    #[must_use]
    pub fn hardness_pa(&self, variance_pa2: f64) -> f64 {
        self.pieces[self.piece_at(variance_pa2)].hardness_pa(variance_pa2)
    }

    /// True if the hardness is the same everywhere.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        let first_pa = self.pieces[0].hardness_pa;
        self.pieces.iter().all(|piece| piece.is_constant() && piece.hardness_pa == first_pa)
    }

    /// Returns the path limited to `cap_pa` > 0 \[Pa\].
    #[must_use]
    pub fn capped(self, cap_pa: f64) -> Self {
        let mut pieces: Vec<Piece> = Vec::with_capacity(self.pieces.len() + 1);
        for (at, piece) in self.pieces.iter().enumerate() {
            let from_variance_pa2 = match piece.variance_pa2_of(cap_pa) {
                _ if piece.hardness_pa >= cap_pa => Some(piece.from_variance_pa2),
                Some(reached_pa2)
                    if self.pieces.get(at + 1).is_none_or(|next| reached_pa2 < next.from_variance_pa2) =>
                {
                    pieces.push(*piece);
                    Some(reached_pa2)
                }
                _ => None,
            };
            match from_variance_pa2 {
                None => pieces.push(*piece),
                Some(from_variance_pa2) => {
                    pieces.push(Piece::constant(from_variance_pa2, cap_pa));
                    break;
                }
            }
        }
        HardnessPath { pieces }
    }

    /// Place of the piece on which a variance lies, of two that meet there the later one.
    fn piece_at(&self, variance_pa2: f64) -> usize {
        self.pieces.partition_point(|piece| piece.from_variance_pa2 <= variance_pa2).saturating_sub(1)
    }
}

/// Upper limit of the pieces of a path.
const MOST_PIECES: usize = 500;
/// Relative tolerance of the first attempt to merge knots.
const FINEST: f64 = 1e-10;

/// Pieces through knots, each as long as the knots that it skips lie on it within a tolerance.
fn joined(knots: &[HardnessKnot], tolerance: f64) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut start = 0;
    while start + 1 < knots.len() {
        let mut piece = Piece::between(&knots[start], &knots[start + 1]);
        let mut end = start + 1;
        // The stride doubles, so that skipped knots are visited twice in all.
        let mut ahead = 2;
        while let Some(further) = knots.get(start + ahead).filter(|_| piece.is_some()) {
            let longer = Piece::between(&knots[start], further);
            let between = &knots[start + 1..start + ahead];
            let holds = |longer: &Piece| between.iter().all(|knot| longer.meets(knot, tolerance));
            let Some(longer) = longer.filter(holds) else { break };
            (piece, end, ahead) = (Some(longer), start + ahead, 2 * ahead);
        }
        pieces.extend(piece);
        start = end;
    }
    pieces
}

impl Piece {
    /// Constant hardness \[Pa\] from a variance \[Pa^2\] on.
    fn constant(from_variance_pa2: f64, hardness_pa: f64) -> Self {
        Piece {
            from_variance_pa2,
            hardness_pa,
            growth_per_pa2: 0.0,
            exponent: 0.0,
            least_log: f64::NEG_INFINITY,
        }
    }

    /// Returns true if a knot lies on the piece within a relative tolerance.
    fn meets(&self, knot: &HardnessKnot, tolerance: f64) -> bool {
        (self.hardness_pa(knot.variance_pa2) / knot.hardness_pa - 1.0).abs() <= tolerance
    }

    /// Piece between two knots; `None` where the variance does not grow.
    fn between(start: &HardnessKnot, end: &HardnessKnot) -> Option<Self> {
        let rise_pa2 = end.variance_pa2 - start.variance_pa2;
        if rise_pa2 <= 0.0 {
            return None;
        }
        let ln_q = (end.wavevector_rad_per_m / start.wavevector_rad_per_m).ln();
        // V - V_i = rise (x^e - 1)/(x_1^e - 1) with x = q/q_i; a small e replaces 0, where the limit is a logarithm.
        let e = start.variance_exponent;
        let e = if e.abs() < 1e-9 { 1e-9 } else { e };
        let growth_per_pa2 = libm::expm1(e * ln_q) / rise_pa2;
        let exponent = (end.hardness_pa / start.hardness_pa).ln() / (ln_q * e);
        let hardness_pa = start.hardness_pa;
        let least_log = if e < 0.0 { e * ln_q } else { f64::NEG_INFINITY };
        Some(Piece {
            from_variance_pa2: start.variance_pa2,
            hardness_pa,
            growth_per_pa2,
            exponent,
            least_log,
        })
    }

    fn hardness_pa(&self, variance_pa2: f64) -> f64 {
        self.hardness_beyond_pa(variance_pa2 - self.from_variance_pa2)
    }

    /// Growth d(H^2)/dV >= 0 at V - V_i \[Pa^2\].
    pub(crate) fn growth_of_square(&self, from_kink_pa2: f64) -> f64 {
        let grown = self.growth_per_pa2 * from_kink_pa2;
        let growth = 2.0 * self.exponent * self.growth_per_pa2 / self.log(grown).exp();
        (self.hardness_beyond_pa(from_kink_pa2).powi(2) * growth).max(0.0)
    }

    /// Hardness \[Pa\] at V - V_i \[Pa^2\].
    pub(crate) fn hardness_beyond_pa(&self, from_kink_pa2: f64) -> f64 {
        let growth = self.growth_per_pa2 * from_kink_pa2;
        if self.exponent == 0.5 {
            return self.hardness_pa * (1.0 + growth).sqrt();
        }
        self.hardness_pa * elementary::exp(self.exponent * self.log(growth))
    }

    /// Computes ln(1 + growth), within the piece.
    #[inline(always)]
    fn log(&self, growth: f64) -> f64 {
        let log = elementary::ln_1p(if growth > -1.0 { growth } else { -1.0 });
        if log > self.least_log { log } else { self.least_log }
    }

    /// Variance at which the piece reaches a hardness above that of its beginning, if it does.
    fn variance_pa2_of(&self, hardness_pa: f64) -> Option<f64> {
        let log = (hardness_pa / self.hardness_pa).ln() / self.exponent;
        if self.exponent == 0.0 || log < self.least_log {
            return None;
        }
        let growth = libm::expm1(log);
        let variance_pa2 = self.from_variance_pa2 + growth / self.growth_per_pa2;
        variance_pa2.is_finite().then_some(variance_pa2)
    }

    fn is_constant(&self) -> bool {
        self.exponent == 0.0 || self.growth_per_pa2 == 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// V = q^0.4 - 1 and H = q^0.3 from q = 1 to 1e3.
    fn path() -> HardnessPath {
        let knots: Vec<HardnessKnot> = (0..=3)
            .map(|i| {
                let q = 10f64.powi(i);
                HardnessKnot {
                    wavevector_rad_per_m: q,
                    variance_pa2: q.powf(0.4) - 1.0,
                    hardness_pa: q.powf(0.3),
                    variance_exponent: 0.4,
                }
            })
            .collect();
        HardnessPath::through(&knots)
    }

    #[test]
    fn a_power_of_the_wavevector_is_met_between_the_knots_too() {
        for q in [1.0, 1.7, 10.0, 33.0, 999.0f64] {
            let hardness_pa = path().hardness_pa(q.powf(0.4) - 1.0);
            assert!((hardness_pa / q.powf(0.3) - 1.0).abs() < 1e-14, "{q}");
        }
        assert!(!path().is_constant());
    }

    #[test]
    fn knots_on_one_power_are_one_piece_and_many_others_are_thinned() {
        let knot = |i: i32, factor: f64| {
            let q = 10f64.powf(f64::from(i) / 1e3);
            HardnessKnot {
                wavevector_rad_per_m: q,
                variance_pa2: q.powf(0.4) - 1.0,
                hardness_pa: factor * q.powf(0.3),
                variance_exponent: 0.4,
            }
        };
        let smooth: Vec<HardnessKnot> = (0..=1024).map(|i| knot(i, 1.0)).collect();
        assert_eq!(HardnessPath::through(&smooth).pieces.len(), 1);
        let rough: Vec<HardnessKnot> = (0..5000).map(|i| knot(i, 1.0 + 1e-5 * f64::from(i % 3))).collect();
        let path = HardnessPath::through(&rough);
        assert!(path.pieces.len() <= MOST_PIECES);
        assert!(rough.iter().all(|knot| path.pieces.iter().any(|piece| piece.meets(knot, 3e-5))));
    }

    #[test]
    fn a_cap_is_reached_where_the_law_reaches_it() {
        let capped = path().capped(50f64.powf(0.3));
        for (q, expected) in [(49.0f64, 49f64.powf(0.3)), (51.0, 50f64.powf(0.3)), (900.0, 50f64.powf(0.3))] {
            let hardness_pa = capped.hardness_pa(q.powf(0.4) - 1.0);
            assert!((hardness_pa / expected - 1.0).abs() < 1e-14, "{q}");
        }
        assert_eq!(path().capped(1e3).hardness_pa(14.0), path().hardness_pa(14.0));
        assert!(path().capped(1.0).is_constant());
    }

    #[test]
    fn a_squared_hardness_grows_with_the_variance() {
        assert_eq!(HardnessPath::with_squared_growth(3.0, 2.0).hardness_pa(8.0), 5.0);
        assert!(HardnessPath::with_squared_growth(3.0, 0.0).is_constant());
    }
}
