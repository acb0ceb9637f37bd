//! Numbers as people type them outside of programs: with commas, and with powers of ten.

/// Returns a text whose first number has a comma without it: `10.5 MPa` for `10,5 MPa`; both readings for `1,000 m`,
/// which may be one or a thousand. `None` if the text does not begin with such a number.
///
/// ```
/// assert_eq!(units::without_comma("10,5 MPa").as_deref(), Some("10.5 MPa"));
/// assert_eq!(units::without_comma("1.000,5 MPa").as_deref(), Some("1000.5 MPa"));
/// assert_eq!(units::without_comma("1,000 MPa").as_deref(), Some("1.000 MPa or 1000 MPa"));
/// ```
#[must_use]
pub fn without_comma(text: &str) -> Option<String> {
    let text = text.trim();
    let end = text.find(|c: char| !(c.is_ascii_digit() || "+-.,".contains(c))).unwrap_or(text.len());
    let (number, rest) = text.split_at(end);
    let (before, after) = number.split_once(',')?;
    let is_digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let before_digits = before.trim_start_matches(['+', '-']);
    if !before_digits.starts_with(|c: char| c.is_ascii_digit())
        || !after.starts_with(|c: char| c.is_ascii_digit())
    {
        return None;
    }
    let without = |sign: char| number.replace(sign, "");
    // Of two signs the last marks decimals; a repeated one separates thousands.
    Some(if before.contains('.') {
        format!("{}{rest}", without('.').replace(',', "."))
    } else if after.contains(['.', ',']) {
        format!("{}{rest}", without(','))
    } else if is_digits(after)
        && after.len() == 3
        && before_digits.len() <= 3
        && !before_digits.starts_with('0')
    {
        format!("{}{rest} or {}{rest}", number.replace(',', "."), without(','))
    } else {
        format!("{}{rest}", number.replace(',', "."))
    })
}

/// Returns a text whose first number is a power of ten, perhaps with a factor, with `e` in its place: `2e6 Pa` for
/// `2 x 10^6 Pa`.
pub(crate) fn without_power(text: &str) -> Option<String> {
    let (factor, power) = text.trim().split_once("10^")?;
    let factor = factor.trim_end().trim_end_matches(['*', 'x', '×', '·']).trim_end();
    let factor = if factor.is_empty() { "1" } else { factor };
    factor.parse::<f64>().ok()?;
    let end = power.find(|c: char| !(c.is_ascii_digit() || "+-".contains(c))).unwrap_or(power.len());
    let (exponent, rest) = power.split_at(end);
    exponent.parse::<i32>().ok()?;
    Some(format!("{factor}e{exponent}{rest}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comma_marks_decimals_or_thousands() {
        for (text, meant) in [
            ("10,5MPa", "10.5MPa"),
            ("0,125 um", "0.125 um"),
            ("-0,5", "-0.5"),
            ("1,5e3 Pa", "1.5e3 Pa"),
            ("1,000,000 Pa", "1000000 Pa"),
            ("1,000.5 Pa", "1000.5 Pa"),
            ("12,345 Pa", "12.345 Pa or 12345 Pa"),
        ] {
            assert_eq!(without_comma(text).as_deref(), Some(meant), "{text}");
        }
        for text in ["10.5 MPa", "10 MPa, 20 MPa", "10, 20", ",5", "MPa", ""] {
            assert_eq!(without_comma(text), None, "{text}");
        }
    }

    #[test]
    fn a_power_of_ten_is_written_with_an_e() {
        for (text, meant) in [
            ("10^6 Pa", "1e6 Pa"),
            ("2 x 10^-9 m", "2e-9 m"),
            ("1.5*10^9Pa", "1.5e9Pa"),
            ("2·10^6 Pa", "2e6 Pa"),
        ] {
            assert_eq!(without_power(text).as_deref(), Some(meant), "{text}");
        }
        for text in ["10 um^2", "1e6 Pa", "a x 10^6 Pa", "10^ Pa"] {
            assert_eq!(without_power(text), None, "{text}");
        }
    }
}
