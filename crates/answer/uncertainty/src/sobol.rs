//! First-order and total indices of groups of inputs from Saltelli's design.
//!
//! The design has three outputs a draw: two independent draws of all inputs, A and B, and AB, which is A with the inputs of
//! one group taken from B (Saltelli et al. 2010, Comput. Phys. Commun. 181:259). AB and B share that group alone, AB and A
//! all the others, so that
//!
//! ```text
//! corr(B, AB) = S      corr(A, AB) = 1 - T      corr(A, B) = 0
//! ```
//!
//! in the mean, S being the first-order and T the total index. With a few hundred draws corr(A, B) is not 0, and it enters
//! the other two: wholly where the group does nothing and AB is A, not at all where it does everything and AB is B. Taken out
//! in that proportion, in the manner of Glen & Isaacs 2012 (Environ. Model. Softw. 37:157), it leaves
//!
//! ```text
//! S = (corr(B, AB) - corr(A, B))/(1 - corr(A, B))      T = (1 - corr(A, AB))/(1 - corr(A, B))
//! ```
//!
//! which are exact at either end. Root mean square errors of 3,000 repeats with 128 draws, for sums of two normal inputs of
//! which the group has the share s, are:
//!
//! ```text
//! s                                  0      0.1    0.25   0.5    0.75   0.9    1
//! S, Saltelli 2010, centred          0      0.039  0.063  0.088  0.108  0.115  0.125
//! S, Janon et al. 2014               0.087  0.088  0.082  0.069  0.039  0.017  0
//! S, here                            0      0.038  0.055  0.060  0.040  0.019  0
//! T, Jansen 1999                     0      0.015  0.035  0.064  0.082  0.086  0.088
//! T, here                            0      0.019  0.040  0.059  0.056  0.039  0
//! ```

use crate::group::{Index, Indices};

/// The fewest draws from which correlations are estimated.
const MIN_DRAWS: usize = 8;

/// An unknown index: its standard error is as large as a share can be.
const UNKNOWN: Index = Index { value: 0.0, standard_error: 1.0 };

/// The indices for an output that does not vary.
pub(crate) const NOTHING: Indices = Indices {
    first_order: Index { value: 0.0, standard_error: 0.0 },
    total: Index { value: 0.0, standard_error: 0.0 },
};

/// Computes the indices of one group from the outputs of Saltelli's design: `a` and `b` from two independent draws of
/// all inputs, `ab` from the inputs of `a` with this group's inputs from `b`. Slices are cut to the shortest.
///
/// Standard errors are of first order, from the influence of each draw on the index; they agree with a bootstrap over
/// the draws. If the output does not vary, both indices are 0 with no error, because there is no variance to share.
/// Fewer than 8 draws, or draws in which A and B are fully correlated, give 0 with a standard error of 1.
pub fn indices(a: &[f64], b: &[f64], ab: &[f64]) -> Indices {
    let draws = a.len().min(b.len()).min(ab.len());
    let (a, b, ab) = (&a[..draws], &b[..draws], &ab[..draws]);
    if does_not_vary(a) && does_not_vary(b) && does_not_vary(ab) {
        return NOTHING;
    }
    let standard = (standardised(a), standardised(b), standardised(ab));
    let (Some(a), Some(b), Some(ab)) = standard else {
        return Indices { first_order: UNKNOWN, total: UNKNOWN };
    };
    let spurious = Correlation::new(&a, &b);
    let unexplained = 1.0 - spurious.value;
    if draws < MIN_DRAWS || unexplained < f64::EPSILON.sqrt() {
        return Indices { first_order: UNKNOWN, total: UNKNOWN };
    }

    let with_b = Correlation::new(&b, &ab);
    let first_order = (with_b.value - spurious.value) / unexplained;
    let on_first_order = with_b.influences.iter().zip(&spurious.influences);
    let on_first_order = on_first_order.map(|(c, p)| (c - (1.0 - first_order) * p) / unexplained);

    let with_a = Correlation::new(&a, &ab);
    let total = (1.0 - with_a.value) / unexplained;
    let on_total = with_a.influences.iter().zip(&spurious.influences);
    let on_total = on_total.map(|(c, p)| (total * p - c) / unexplained);

    Indices {
        first_order: Index { value: first_order, standard_error: standard_error(on_first_order, draws) },
        total: Index { value: total, standard_error: standard_error(on_total, draws) },
    }
}

fn does_not_vary(outputs: &[f64]) -> bool {
    outputs.windows(2).all(|pair| pair[0] == pair[1])
}

/// Scales outputs to mean 0 and variance 1; `None` if they do not vary or are not finite.
fn standardised(outputs: &[f64]) -> Option<Vec<f64>> {
    let n = outputs.len() as f64;
    let unit = unit(outputs);
    let outputs: Vec<f64> = outputs.iter().map(|output| output * unit).collect();
    let mean = outputs.iter().sum::<f64>() / n;
    let deviation = (outputs.iter().map(|output| (output - mean).powi(2)).sum::<f64>() / n).sqrt();
    (deviation.is_finite() && deviation > 0.0)
        .then(|| outputs.iter().map(|output| (output - mean) / deviation).collect())
}

/// Power of two that brings the largest of some outputs near 1, so that squares neither overflow nor lose their digits.
fn unit(outputs: &[f64]) -> f64 {
    let largest = outputs.iter().fold(0.0f64, |largest, output| largest.max(output.abs()));
    2f64.powi(-(largest.log2().clamp(-1000.0, 1000.0) as i32))
}

/// A correlation coefficient, and the influence of each draw on it.
struct Correlation {
    value: f64,
    influences: Vec<f64>,
}

impl Correlation {
    /// The correlation of standardised outputs. The influence of a pair is u v - c (u^2 + v^2)/2 (Devlin et al. 1975,
    /// Biometrika 62:531).
    fn new(u: &[f64], v: &[f64]) -> Self {
        let pairs = || u.iter().zip(v);
        let value = pairs().map(|(u, v)| u * v).sum::<f64>() / u.len() as f64;
        let influences = pairs().map(|(u, v)| u * v - value * (u * u + v * v) / 2.0).collect();
        Correlation { value, influences }
    }
}

/// The standard error of a mean whose influences have the mean 0.
fn standard_error(influences: impl Iterator<Item = f64>, draws: usize) -> f64 {
    let n = draws as f64;
    (influences.map(|influence| influence * influence).sum::<f64>() / (n - 1.0) / n).sqrt()
}

#[cfg(test)]
mod tests {
    use chacha20::ChaCha8Rng;
    use chacha20::rand_core::{Rng, SeedableRng};
    use rand_distr::{Distribution, StandardNormal};

    use super::{MIN_DRAWS, indices};
    use crate::group::{Index, Indices};

    /// The indices of each input of a function from one seeded design.
    fn of_design<const INPUTS: usize>(
        draws: usize,
        seed: u64,
        input: impl Fn(&mut ChaCha8Rng) -> f64,
        output: impl Fn(&[f64; INPUTS]) -> f64,
    ) -> [Indices; INPUTS] {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut inputs = || -> Vec<[f64; INPUTS]> {
            (0..draws).map(|_| std::array::from_fn(|_| input(&mut random))).collect()
        };
        let (a, b) = (inputs(), inputs());
        let outputs = |inputs: &[[f64; INPUTS]]| inputs.iter().map(&output).collect::<Vec<f64>>();
        std::array::from_fn(|group| {
            let mut ab = a.clone();
            ab.iter_mut().zip(&b).for_each(|(ab, b)| ab[group] = b[group]);
            indices(&outputs(&a), &outputs(&b), &outputs(&ab))
        })
    }

    fn normal(random: &mut ChaCha8Rng) -> f64 {
        StandardNormal.sample(random)
    }

    fn angle(random: &mut ChaCha8Rng) -> f64 {
        let turn = (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
        std::f64::consts::PI * (2.0 * turn - 1.0)
    }

    fn ishigami([x, y, z]: &[f64; 3]) -> f64 {
        x.sin() + 7.0 * y.sin().powi(2) + 0.1 * z.powi(4) * x.sin()
    }

    #[test]
    fn ishigamis_function_has_its_indices() {
        let found = of_design(1 << 15, 1, angle, ishigami);
        let expected = [(0.3139, 0.5576), (0.4424, 0.4424), (0.0, 0.2437)];
        for (found, (first_order, total)) in found.iter().zip(expected) {
            assert!((found.first_order.value - first_order).abs() < 0.01, "{found:?}");
            assert!((found.total.value - total).abs() < 0.01, "{found:?}");
            assert!(
                found.first_order.standard_error < 0.01 && found.total.standard_error < 0.01,
                "{found:?}"
            );
        }
    }

    #[test]
    fn a_sum_is_shared_out_as_its_variances_are() {
        let shares = [0.0_f64, 0.1, 0.3, 0.6];
        let found =
            of_design(4096, 2, normal, |x: &[f64; 4]| x.iter().zip(shares).map(|(x, s)| s.sqrt() * x).sum());
        for (found, share) in found.iter().zip(shares) {
            assert!((found.first_order.value - share).abs() < 0.02, "{found:?}");
            assert!((found.total.value - share).abs() < 0.02, "{found:?}");
        }
    }

    #[test]
    fn a_group_that_does_nothing_or_everything_is_known_exactly() {
        let [nothing, everything] = of_design(128, 3, normal, |[_, x]: &[f64; 2]| x.exp());
        for (found, share) in [(nothing, 0.0), (everything, 1.0)] {
            for index in [found.first_order, found.total] {
                assert!((index.value - share).abs() < 1e-12, "{found:?}");
                assert!(index.standard_error < 1e-12, "{found:?}");
            }
        }
    }

    #[test]
    fn stated_errors_cover_as_often_as_they_should() {
        const REPEATS: u64 = 400;
        for share in [0.1f64, 0.5, 0.9] {
            let sum = |[x, y]: &[f64; 2]| share.sqrt() * x + (1.0 - share).sqrt() * y;
            let repeats: Vec<_> = (0..REPEATS).map(|seed| of_design(128, seed, normal, sum)[0]).collect();
            let covered = |index: fn(&Indices) -> Index| {
                let held =
                    |found: &&Indices| (index(found).value - share).abs() < index(found).standard_error;
                repeats.iter().filter(held).count() as f64 / REPEATS as f64
            };
            // Three standard errors of a share of 400 are 0.07.
            for covered in [covered(|found| found.first_order), covered(|found| found.total)] {
                assert!((covered - 0.683).abs() < 0.07, "{share}: {covered}");
            }
        }
    }

    #[test]
    fn stated_errors_are_those_of_a_bootstrap() {
        const RESAMPLES: usize = 400;
        const DRAWS: usize = 256;
        let mut random = ChaCha8Rng::seed_from_u64(5);
        let outputs =
            |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| x + 0.7 * y + 0.3 * x * y).collect();
        let inputs: [Vec<f64>; 4] =
            std::array::from_fn(|_| (0..DRAWS).map(|_| normal(&mut random)).collect());
        let [x_a, y_a, x_b, y_b] = &inputs;
        let [a, b, ab]: [Vec<f64>; 3] = [outputs(x_a, y_a), outputs(x_b, y_b), outputs(x_b, y_a)];
        let stated = indices(&a, &b, &ab);

        let resampled: Vec<Indices> = (0..RESAMPLES)
            .map(|_| {
                let drawn: Vec<usize> =
                    (0..DRAWS).map(|_| (random.next_u64() % DRAWS as u64) as usize).collect();
                let of = |outputs: &[f64]| drawn.iter().map(|&draw| outputs[draw]).collect::<Vec<f64>>();
                indices(&of(&a), &of(&b), &of(&ab))
            })
            .collect();
        for index in [|found: &Indices| found.first_order, |found: &Indices| found.total] {
            let values = || resampled.iter().map(|found| index(found).value);
            let mean = values().sum::<f64>() / RESAMPLES as f64;
            let deviation =
                (values().map(|value| (value - mean).powi(2)).sum::<f64>() / RESAMPLES as f64).sqrt();
            let stated = index(&stated).standard_error;
            assert!((stated / deviation - 1.0).abs() < 0.15, "{stated} {deviation}");
        }
    }

    #[test]
    fn without_variance_there_is_nothing_to_share_out() {
        let found = indices(&[2.0; 64], &[2.0; 64], &[2.0; 64]);
        for index in [found.first_order, found.total] {
            assert_eq!(index, Index { value: 0.0, standard_error: 0.0 });
        }
    }

    #[test]
    fn draws_that_say_nothing_have_an_error_as_large_as_a_share() {
        let few: Vec<f64> = (1..MIN_DRAWS).map(|n| (n * n % 5) as f64).collect();
        let many: Vec<f64> = (0..64).map(f64::from).collect();
        let infinite = [f64::NEG_INFINITY; 64];
        for [a, b, ab] in
            [[&few[..]; 3], [&many, &many, &many], [&many, &infinite, &many], [&[], &many, &many[..1]]]
        {
            let found = indices(a, b, ab);
            assert!(found.first_order.value == 0.0 && found.first_order.standard_error <= 1.0);
        }
        assert_eq!(indices(&many, &many, &many).total.standard_error, 1.0);
    }
}
