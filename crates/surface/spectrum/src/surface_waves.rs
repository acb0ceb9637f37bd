//! The waves of an isotropic surface: pieces of Ciso over a band.

use crate::power_law::PowerLaw;

/// Most growth of the wavevector over a piece of a weighted spectrum.
const MOST_GROWTH: f64 = 1.03;

/// Pieces of Ciso \[m^4\] by rising wavevector, without overlaps; between two that do not touch there is no roughness.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SurfaceWaves {
    pub pieces: Vec<PowerLaw>,
    pub longest_m: f64,
    pub shortest_m: f64,
}

impl SurfaceWaves {
    /// Multiplies Ciso by a smooth weight above 0, a function of the wavevector \[rad/m\].
    ///
    /// Pieces are divided so that the wavevector grows by at most 3 % over each, with power laws between their ends: a weight
    /// such as q^4 tanh(q)^2 is met within 2e-4.
    pub fn weighted(&self, weight: impl Fn(f64) -> f64) -> Self {
        let value = |piece: &PowerLaw, q_rad_per_m: f64| {
            (q_rad_per_m, piece.value_at(q_rad_per_m) * weight(q_rad_per_m))
        };
        let divided = |piece: &PowerLaw| {
            let growth = piece.end_rad_per_m / piece.start_rad_per_m;
            let parts = (growth.ln() / MOST_GROWTH.ln()).ceil().max(1.0);
            let ends = (0..=parts as usize).map(|at| match at as f64 / parts {
                1.0 => piece.end_rad_per_m,
                share => piece.start_rad_per_m * growth.powf(share),
            });
            let points: Vec<(f64, f64)> = ends.map(|q_rad_per_m| value(piece, q_rad_per_m)).collect();
            points.windows(2).map(|pair| PowerLaw::through(pair[0], pair[1])).collect::<Vec<_>>()
        };
        Self { pieces: self.pieces.iter().flat_map(divided).collect(), ..*self }
    }

    /// Adds the waves of another, uncorrelated surface; between the ends of all pieces the sum is a power law.
    pub fn plus(&self, other: &Self) -> Self {
        let both = [self, other];
        let all = both.iter().flat_map(|waves| &waves.pieces);
        let mut ends: Vec<f64> = all.flat_map(|piece| [piece.start_rad_per_m, piece.end_rad_per_m]).collect();
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        let sum = |pair: &[f64]| {
            let middle = (pair[0] * pair[1]).sqrt();
            let pieces = both.iter().filter_map(|waves| waves.piece_at(middle));
            let [start, end] = pieces.fold([0.0; 2], |sum, piece| {
                [sum[0] + piece.value_at(pair[0]), sum[1] + piece.value_at(pair[1])]
            });
            (start > 0.0 && end > 0.0).then(|| PowerLaw::through((pair[0], start), (pair[1], end)))
        };
        Self {
            pieces: ends.windows(2).filter_map(sum).collect(),
            longest_m: self.longest_m.max(other.longest_m),
            shortest_m: self.shortest_m.min(other.shortest_m),
        }
    }

    /// Returns the piece at a wavevector \[rad/m\].
    pub fn piece_at(&self, q_rad_per_m: f64) -> Option<&PowerLaw> {
        let at = self.pieces.partition_point(|piece| piece.end_rad_per_m < q_rad_per_m);
        self.pieces.get(at).filter(|piece| piece.start_rad_per_m <= q_rad_per_m)
    }
}
