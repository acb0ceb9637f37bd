//! Sinusoids and an assertion shared by the tests of several files.

use crate::lanes::LANES;
use crate::{ElasticBody, ElasticPlasticSinusoid, MaterialPair};

/// Ultrananocrystalline diamond against a rigid flat.
pub(crate) fn pair() -> MaterialPair {
    MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2).unwrap())
}

/// Sinusoid of that diamond with r times the critical aspect ratio.
pub(crate) fn at_ratio(r: f64) -> ElasticPlasticSinusoid {
    let critical = ElasticPlasticSinusoid::new(&pair(), 1.0, 1.8e9).critical_aspect_ratio();
    ElasticPlasticSinusoid::new(&pair(), r * critical, 1.8e9)
}

/// Asserts that a law evaluated at many arguments has the digits of the law at each: over all decades, at and beside the
/// places where it is not smooth, at `others`, and with every length of the last block.
pub(crate) fn assert_batch_has_the_digits_of_each(
    breaks: &[f64],
    others: &[f64],
    one: impl Fn(f64) -> (f64, f64),
    many: impl Fn(&[f64], &mut [f64], &mut [f64]),
) {
    let mut at = vec![0.0, f64::from_bits(1), 1e-310, f64::MIN_POSITIVE];
    at.extend(others);
    for &place in breaks {
        let beside = (-40..40).map(|i| place * (1.0 + f64::from(i) * f64::EPSILON));
        let around = (1..500).map(|i| place * f64::from(i) / 250.0);
        let decades = (-3200..160).map(|i| place * 10f64.powf(f64::from(i) / 16.0));
        at.extend(beside.chain(around).chain(decades));
    }
    // Neighbours in a block lie on different branches, too.
    let mixed: Vec<f64> = (0..at.len()).map(|i| at[(i * 7919) % at.len()]).collect();
    let lengths = (0..=LANES + 1).chain([at.len()]);
    for (at, length) in lengths.map(|n| (&at, n)).chain([(&mixed, mixed.len()), (&mixed, LANES - 1)]) {
        let at = &at[..length];
        let (mut first, mut second) = (vec![f64::NAN; length], vec![f64::NAN; length]);
        many(at, &mut first, &mut second);
        for ((&at, &first), &second) in at.iter().zip(&first).zip(&second) {
            let (alone, alone_too) = one(at);
            let same = |a: f64, b: f64| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
            assert!(
                same(first, alone) && same(second, alone_too),
                "at {at}: {first} {second}, not {alone} {alone_too}"
            );
        }
    }
}
