//! Columns of numbers filled in place, block by block.

#[cfg(feature = "threads")]
use rayon::prelude::*;

/// Fills columns of equal length in blocks of `block` rows; the last block may be shorter.
///
/// `fill` receives the index of the block's first row and the block of every column.
///
/// # Errors
/// The first error in the order of the blocks, for any number of threads.
///
/// # Panics
/// If the columns differ in length or `block` is 0.
pub fn fill_blocks<const N: usize, E: Send>(
    columns: [&mut [f64]; N],
    block: usize,
    fill: impl Fn(usize, [&mut [f64]; N]) -> Result<(), E> + Sync,
) -> Result<(), E> {
    let rows = columns.first().map_or(0, |column| column.len());
    assert!(columns.iter().all(|column| column.len() == rows), "the columns of a table are of one length");
    let mut column_blocks = columns.map(|column| column.chunks_mut(block));
    let mut next = || {
        let mut is_there = true;
        let block_columns = column_blocks.each_mut().map(|blocks| {
            blocks.next().unwrap_or_else(|| {
                is_there = false;
                &mut []
            })
        });
        is_there.then_some(block_columns)
    };
    let blocks: Vec<(usize, [&mut [f64]; N])> =
        (0..rows).step_by(block).map_while(|first| Some((first, next()?))).collect();
    #[cfg(feature = "threads")]
    if !super::one_thread::is_confined() {
        let found: Vec<Result<(), E>> =
            blocks.into_par_iter().map(|(first, block_columns)| fill(first, block_columns)).collect();
        return found.into_iter().collect();
    }
    blocks.into_iter().try_for_each(|(first, block_columns)| fill(first, block_columns))
}

#[cfg(test)]
mod tests {
    use super::fill_blocks;

    #[test]
    fn every_row_is_set_once_and_the_first_error_is_returned() {
        let (mut rows, mut squares) = (vec![0.0; 1001], vec![0.0; 1001]);
        let set = |first: usize, [rows, squares]: [&mut [f64]; 2]| {
            for (at, (row, square)) in rows.iter_mut().zip(squares).enumerate() {
                let number = (first + at) as f64;
                *row += number;
                *square += number * number;
            }
            Ok::<(), ()>(())
        };
        fill_blocks([&mut rows, &mut squares], 64, set).unwrap();
        assert!(rows.iter().enumerate().all(|(at, row)| *row == at as f64));
        assert!(squares.iter().zip(&rows).all(|(square, row)| *square == row * row));
        let failed = fill_blocks([&mut rows], 10, |first, _| if first >= 500 { Err(first) } else { Ok(()) });
        assert_eq!(failed, Err(500));
        assert_eq!(fill_blocks([&mut []], 10, |_, _| Err("never called")), Ok(()));
    }
}
