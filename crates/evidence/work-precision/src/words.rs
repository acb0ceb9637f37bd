//! Numbers as `docs/develop/performance.md` shows them.

/// Formats a time in the unit that leaves one to three digits before the point.
pub fn time(seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s >= 1.0 => (s, "s"),
        s if s >= 1e-3 => (s * 1e3, "ms"),
        s if s >= 1e-6 => (s * 1e6, "µs"),
        s => (s * 1e9, "ns"),
    };
    format!("{} {unit}", three_digits(value))
}

/// Formats a number to three digits, those below a tenth to four places, grouped in threes from five places on.
pub fn three_digits(value: f64) -> String {
    let digits = match value.abs() {
        v if v >= 99.95 => 0,
        v if v >= 9.995 => 1,
        v if v >= 0.0995 || v == 0.0 => 2,
        _ => 4,
    };
    let rounded = if value.abs() >= 999.5 {
        let unit = 10f64.powf(value.abs().log10().floor() - 2.0);
        (value / unit).round() * unit
    } else {
        value
    };
    let mut text = format!("{rounded:.digits$}");
    if rounded.abs() >= 1e4 {
        for at in (1..text.len()).rev().filter(|at| (text.len() - at) % 3 == 0).collect::<Vec<_>>() {
            text.insert(at, ',');
        }
    }
    text
}

/// Formats an error like 1.2e-9.
pub fn error(value: f64) -> String {
    format!("{value:.1e}")
}

/// Formats a number of bytes in MiB.
pub fn mebibytes(bytes: u64) -> String {
    format!("{} MiB", three_digits(bytes as f64 / (1024.0 * 1024.0)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_and_numbers_have_three_digits() {
        assert_eq!(
            [3.7e-2, 3.4e-4, 8.31e-6, 1.5e-8, 2.0].map(time),
            ["37.0 ms", "340 µs", "8.31 µs", "15.0 ns", "2.00 s"]
        );
        assert_eq!(
            [3456.0, 34567.0, 1_234_567.0, 0.5, 99.99, 0.00291].map(three_digits),
            ["3460", "34,600", "1,230,000", "0.50", "100", "0.0029"]
        );
    }
}
