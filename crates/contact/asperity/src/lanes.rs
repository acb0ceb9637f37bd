//! Formulas over several numbers at once, step by step.
//!
//! A law is a chain of exponentials and logarithms, each of which waits for the one before. A processor that goes down
//! the chain for one vector at a time idles. So a formula takes N numbers and does every step for all of them before the
//! next; the compiler turns each step into a loop over vectors. A single number is the case N = 1, with the same digits.

/// Numbers that go through a formula together. 16 take twice as long, and more than 32 gain nothing (measured).
pub(crate) const LANES: usize = 32;

/// Computes one step of a formula for all N numbers, given by index.
#[inline(always)]
pub(crate) fn each<const N: usize>(step: impl Fn(usize) -> f64) -> [f64; N] {
    // Aligned, so that no vector spans two lines of the cache.
    #[repr(align(64))]
    struct Aligned<const N: usize>([f64; N]);
    let mut results = Aligned([0.0; N]);
    for (i, result) in results.0.iter_mut().enumerate() {
        *result = step(i);
    }
    results.0
}

/// Returns true if a condition holds for any of N numbers, given by index. Neighbours are usually on one branch of a law;
/// a block skips a branch that none of its numbers takes.
#[inline(always)]
pub(crate) fn any<const N: usize>(condition: impl Fn(usize) -> bool) -> bool {
    (0..N).fold(false, |any, i| any | condition(i))
}

/// Panics unless there is a place for every result of every argument.
#[inline(always)]
pub(crate) fn check_lengths<const N: usize>(arguments: &[f64], results: [&[f64]; N]) {
    let lengths = results.map(<[f64]>::len);
    assert!(
        lengths == [arguments.len(); N],
        "{} interferences need as many places for results, not {lengths:?}",
        arguments.len()
    );
}

/// Computes two results at each of many arguments, [`LANES`] together. The last block is filled up with its last
/// argument.
#[inline(always)]
pub(crate) fn in_blocks(
    arguments: &[f64],
    [first, second]: [&mut [f64]; 2],
    law: impl Fn([f64; LANES]) -> [[f64; LANES]; 2],
) {
    check_lengths(arguments, [first, second]);
    let results = first.chunks_mut(LANES).zip(second.chunks_mut(LANES));
    for (at, (first, second)) in arguments.chunks(LANES).zip(results) {
        let mut block = [at[at.len() - 1]; LANES];
        block[..at.len()].copy_from_slice(at);
        let [firsts, seconds] = law(block);
        first.copy_from_slice(&firsts[..first.len()]);
        second.copy_from_slice(&seconds[..second.len()]);
    }
}

/// Number of arguments that go together where there are few of them.
pub(crate) const FEW: usize = 8;

/// Computes a result at each of few arguments. The last block is filled up with its last argument.
#[inline(always)]
pub(crate) fn in_few(arguments: &[f64], results: &mut [f64], law: impl Fn([f64; FEW]) -> [f64; FEW]) {
    check_lengths(arguments, [results]);
    for (at, results) in arguments.chunks(FEW).zip(results.chunks_mut(FEW)) {
        let mut block = [at[at.len() - 1]; FEW];
        block[..at.len()].copy_from_slice(at);
        results.copy_from_slice(&law(block)[..results.len()]);
    }
}

#[cfg(test)]
mod tests {
    use super::check_lengths;

    #[test]
    #[should_panic(expected = "2 interferences need as many places for results, not [2, 1]")]
    fn results_need_as_many_places_as_there_are_arguments() {
        check_lengths(&[1.0, 2.0], [&[0.0, 0.0], &[0.0]]);
    }
}
