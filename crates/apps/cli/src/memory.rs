//! A look at the memory before elements are pressed on a large grid.

use units::display::three_digits;

use crate::failure::Failure;

/// Memory per point of a periodic grid \[B\], measured at 2048 and 4096 points a side.
const BYTES_PER_POINT: f64 = 100.0;
const GIGABYTE: f64 = 1e9;

/// Refuses a grid of so many points a side that does not fit into the memory that is left, where the system says how much that is.
///
/// # Errors
/// [`Failure::Input`] with the grid that fits.
pub(crate) fn refuse_beyond(grid: Option<u32>) -> Result<(), Failure> {
    let (Some(points), Some(left)) = (grid.map(f64::from), bytes_left()) else { return Ok(()) };
    let needed = BYTES_PER_POINT * points * points;
    if needed <= left {
        return Ok(());
    }
    let [needed, gigabytes] = [needed, left].map(|bytes| three_digits(bytes / GIGABYTE));
    Err(Failure::Input(format!(
        "--grid {points}: takes some {needed} GB of memory, and {gigabytes} GB are left; use at most {:.0}",
        (left / BYTES_PER_POINT).sqrt().floor()
    )))
}

/// Memory \[B\] that is free, or that the process may still take, as Linux says.
fn bytes_left() -> Option<f64> {
    let text = |path: &str| std::fs::read_to_string(path).unwrap_or_default();
    let number = |text: &str, name: &str, scale: f64| {
        let line = text.lines().find_map(|line| line.strip_prefix(name))?;
        Some(line.split_whitespace().next()?.parse::<f64>().ok()? * scale)
    };
    let free = number(&text("/proc/meminfo"), "MemAvailable:", 1024.0);
    let allowed = number(&text("/proc/self/limits"), "Max address space", 1.0);
    let taken = number(&text("/proc/self/status"), "VmSize:", 1024.0);
    let allowed = allowed.zip(taken).map(|(allowed, taken)| allowed - taken);
    free.into_iter().chain(allowed).reduce(f64::min)
}
