//! The modulus E*(q) of a layer along a spectrum.

use asperity::LayerCompliance;
use numerics::GaussLegendre;

/// Most growth of the wavevector over one Gauss rule: S(q t) changes on the scale of q itself.
const MOST_GROWTH: f64 = 2.0;

/// Mean of (E*(q)/E*)^2 over the mean square gradient between two wavevectors \[rad/m\], where that grows by
/// dh'^2/dq ~ q^(e-1), and by which power of q that square grows from one to the other.
pub(crate) fn mean_square_stiffening(
    layer: &LayerCompliance,
    [start_rad_per_m, end_rad_per_m]: [f64; 2],
    exponent: f64,
) -> (f64, f64) {
    let whole_ln = (end_rad_per_m / start_rad_per_m).ln();
    let square = |part_ln: f64| layer.relative_at(start_rad_per_m * part_ln.exp()).powi(-2);
    let grown = (square(whole_ln) / square(0.0)).ln() / whole_ln;
    let rule = GaussLegendre::new(8);
    let pieces = (whole_ln / MOST_GROWTH.ln()).ceil().max(1.0);
    // Weights from the end at which the power is larger, so that it does not overflow.
    let from_ln = if exponent > 0.0 { whole_ln } else { 0.0 };
    let (mut sum, mut all) = (0.0, 0.0);
    for piece in 0..pieces as usize {
        let ends = [piece, piece + 1].map(|end| end as f64 * whole_ln / pieces);
        for (part_ln, weight) in rule.over(ends[0], ends[1]) {
            let weight = weight * (exponent * (part_ln - from_ln)).exp();
            sum += weight * square(part_ln);
            all += weight;
        }
    }
    (sum / all, grown)
}
