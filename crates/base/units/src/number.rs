//! Printed numbers: the fewest digits that read back to the same double.

/// Appends `value` with the fewest digits that read back, with an exponent if that is shorter.
pub fn write_number(out: &mut String, value: f64) {
    let mut buffer = zmij::Buffer::new();
    let text = buffer.format(value);
    out.push_str(text.strip_suffix(".0").unwrap_or(text));
}

/// Formats `value` with the fewest digits that read back to the same double.
#[must_use]
pub fn number(value: f64) -> String {
    let mut text = String::new();
    write_number(&mut text, value);
    text
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn the_fewest_digits_that_read_back_are_printed() {
        for (value, text) in
            [(0.1, "0.1"), (1.0, "1"), (5.65e-9, "5.65e-9"), (4.63e11, "463000000000"), (-2.5, "-2.5")]
        {
            assert_eq!(number(value), text);
        }
        for value in [1.0 / 3.0, 2f64.powi(-1074), f64::MAX, 1e22, 1e-5, 123456789.125] {
            assert_eq!(number(value).parse::<f64>().unwrap().to_bits(), value.to_bits());
        }
    }
}
