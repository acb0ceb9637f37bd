//! Properties of all zeros and rules.

use numerics::{
    GaussLegendre, bisect, legendre_integral_above, legendre_polynomials, newton_in_bracket, zero_in_bracket,
};
use proptest::prelude::*;

/// Positive nodes and weights of the rule of 16 nodes (Abramowitz & Stegun, table 25.4).
const SIXTEEN: [(f64, f64); 8] = [
    (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
    (0.281_603_550_779_258_9, 0.182_603_415_044_923_6),
    (0.458_016_777_657_227_4, 0.169_156_519_395_002_54),
    (0.617_876_244_402_643_7, 0.149_595_988_816_576_73),
    (0.755_404_408_355_003, 0.124_628_971_255_533_87),
    (0.865_631_202_387_831_7, 0.095_158_511_682_492_78),
    (0.944_575_023_073_232_6, 0.062_253_523_938_647_89),
    (0.989_400_934_991_649_9, 0.027_152_459_411_754_095),
];

#[test]
fn the_rule_of_sixteen_nodes_is_the_published_one() {
    let rule = GaussLegendre::new(16);
    let (nodes, weights) = (rule.nodes, rule.weights);
    for (i, (node, weight)) in SIXTEEN.into_iter().enumerate() {
        assert!((nodes[8 + i] - node).abs() < 1.2e-16, "{} {node}", nodes[8 + i]);
        assert!((weights[8 + i] / weight - 1.0).abs() < 5e-15, "{} {weight}", weights[8 + i]);
        assert_eq!((nodes[7 - i], weights[7 - i]), (-nodes[8 + i], weights[8 + i]));
    }
}

proptest! {
    #[test]
    fn every_method_finds_the_zero_of_a_rising_cubic(linear in 0.1..10.0f64, zero in -5.0..5.0f64) {
        // x^3 + linear x rises, so that it has the value that it has at `zero` nowhere else.
        let value = |x: f64| (x - zero) * (x * x + x * zero + zero * zero + linear);
        let slope = |x: f64| 3.0 * x * x + linear;
        let near = |found: f64| (found - zero).abs() <= 1e-14 * zero.abs().max(1e-3);
        let newton = newton_in_bracket(-6.0, 7.0, 0.5, |x| (value(x), slope(x)));
        prop_assert!(near(newton), "{newton} {zero}");
        let secant = zero_in_bracket(-6.0, 7.0, value);
        prop_assert!(near(secant), "{secant} {zero}");
        let halved = bisect(-6.0, 7.0, 0.0, |x| value(x) >= 0.0);
        prop_assert!(near(halved), "{halved} {zero}");
    }

    #[test]
    fn a_rule_is_exact_for_the_polynomials_it_must_be(
        coefficients in proptest::collection::vec(-1.0..1.0f64, 1..24),
        above in -1.0..1.0f64,
    ) {
        // Of Legendre polynomials, whose integral from anywhere to 1 is known in closed form.
        let rule = GaussLegendre::new(coefficients.len().div_ceil(2));
        let polynomial = |x: f64| -> f64 {
            let terms = legendre_polynomials(x, coefficients.len());
            terms.iter().zip(&coefficients).map(|(p, c)| p * c).sum()
        };
        let integral: f64 = rule.over(above, 1.0).map(|(x, weight)| weight * polynomial(x)).sum();
        let exact = legendre_integral_above(above, &coefficients);
        prop_assert!((integral - exact).abs() < 2e-14, "{integral} {exact}");
    }
}
