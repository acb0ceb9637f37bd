//! Lengths and pressures as people read them: three significant digits and a prefix.

use std::collections::{HashMap, HashSet};

/// Formats a length \[m\] with three significant digits, e.g. `5.65 nm`.
#[must_use]
pub fn length(length_m: f64) -> String {
    length_with(LEAST_DIGITS, length_m)
}

/// Formats lengths \[m\] with three significant digits, and more only as needed to distinguish different ones.
#[must_use]
pub fn lengths_apart(lengths_m: &[f64]) -> Vec<String> {
    let mut digits = vec![LEAST_DIGITS; lengths_m.len()];
    loop {
        let texts: Vec<String> =
            digits.iter().zip(lengths_m).map(|(&digits, &length_m)| length_with(digits, length_m)).collect();
        let mut first_of: HashMap<&str, f64> = HashMap::new();
        let mut ambiguous: HashSet<&str> = HashSet::new();
        for (text, &length_m) in texts.iter().zip(lengths_m) {
            if *first_of.entry(text).or_insert(length_m) != length_m {
                ambiguous.insert(text);
            }
        }
        let mut any_left = false;
        for (text, digits) in texts.iter().zip(&mut digits) {
            if ambiguous.contains(text.as_str()) && *digits < MOST_DIGITS {
                *digits += 1;
                any_left = true;
            }
        }
        if !any_left {
            return texts;
        }
    }
}

/// Significant digits unless more are needed.
const LEAST_DIGITS: usize = 3;
/// Significant digits that distinguish any two doubles.
const MOST_DIGITS: usize = 17;

fn length_with(digits: usize, length_m: f64) -> String {
    with_prefix(digits, length_m, &[("m", 0), ("mm", -3), ("µm", -6), ("nm", -9), ("pm", -12)])
}

/// Formats a pressure \[Pa\] with three significant digits, e.g. `5.4 MPa`.
#[must_use]
pub fn pressure(pressure_pa: f64) -> String {
    with_prefix(LEAST_DIGITS, pressure_pa, &[("TPa", 12), ("GPa", 9), ("MPa", 6), ("kPa", 3), ("Pa", 0)])
}

/// Formats an energy per area \[J/m^2\] with three significant digits, e.g. `1.2 mJ/m²`.
#[must_use]
pub fn energy_per_area(energy_j_per_m2: f64) -> String {
    let units = [("J/m²", 0), ("mJ/m²", -3), ("µJ/m²", -6), ("nJ/m²", -9), ("pJ/m²", -12)];
    with_prefix(LEAST_DIGITS, energy_j_per_m2, &units)
}

/// Formats a value with the largest fitting prefix; zero and values that are not finite take the plain unit.
fn with_prefix(digits: usize, value: f64, units: &[(&str, i32)]) -> String {
    let has_size = value.is_finite() && value != 0.0;
    let fits = |(_, power): &&(&str, i32)| match has_size {
        true => value.abs() >= 0.9995 * 10f64.powi(*power),
        false => *power == 0,
    };
    let (unit, power) = units.iter().find(fits).unwrap_or(&units[units.len() - 1]);
    format!("{} {unit}", significant(digits, value / 10f64.powi(*power)))
}

/// Formats a count of things, e.g. `1 scale`, `2 scales`; the plural of `thing` takes an s.
#[must_use]
pub fn counted(number: usize, thing: &str) -> String {
    let s = if number == 1 { "" } else { "s" };
    format!("{number} {thing}{s}")
}

/// Words a number from 2 to 12, e.g. `three`; others are in digits.
#[must_use]
pub fn number_word(number: usize) -> String {
    const WORDS: [&str; 11] =
        ["two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"];
    let word = number.checked_sub(2).and_then(|at| WORDS.get(at));
    word.map_or_else(|| number.to_string(), |word| (*word).to_owned())
}

/// A share in percent with three significant digits, e.g. `0.18 %` of 0.0018.
#[must_use]
pub fn percent(share: f64) -> String {
    format!("{} %", three_digits(100.0 * share))
}

/// A share as people read it: `0.18 %`, or `40 ppm` below 0.01 %.
#[must_use]
pub fn share(share: f64) -> String {
    if share < 0.9995e-4 { format!("{} ppm", three_digits(1e6 * share)) } else { percent(share) }
}

/// Three significant digits, with an exponent outside 1e-3 to 1e4; 0 is 0.
#[must_use]
pub fn three_digits(value: f64) -> String {
    significant(LEAST_DIGITS, value)
}

fn significant(digits: usize, value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    let after_the_first = digits - 1;
    if !(1e-3..1e4).contains(&value.abs()) {
        return format!("{value:.after_the_first$e}");
    }
    let decimals = (after_the_first as i32 - value.abs().log10().floor() as i32).max(0) as usize;
    let fixed = format!("{value:.decimals$}");
    if fixed.contains('.') { fixed.trim_end_matches('0').trim_end_matches('.').to_owned() } else { fixed }
}

/// Formats a power of ten with a superscript, e.g. `10⁻³`.
#[must_use]
pub fn power_of_ten(power: i32) -> String {
    const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| SUPERSCRIPTS[digit as usize]);
    format!("10{}", power.to_string().chars().map(raised).collect::<String>())
}

/// Replaces exponents by superscripts: `1e-3 H` becomes `10⁻³ H`, `1.2e-3` `1.2 × 10⁻³`, `mm^2` `mm²`.
pub fn typeset(text: &str) -> String {
    let text = text.replace("m^2", "m²").replace("m^3", "m³");
    text.split(' ').map(typeset_word).collect::<Vec<_>>().join(" ")
}

fn typeset_word(word: &str) -> String {
    let end = word.find(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | 'e' | 'E')));
    let number = word[..end.unwrap_or(word.len())].trim_end_matches('.');
    let unit = &word[number.len()..];
    let parts = number.split_once(['e', 'E']).and_then(|(mantissa, power)| {
        Some((mantissa.parse::<f64>().ok().map(|_| mantissa)?, power_of_ten(power.parse().ok()?)))
    });
    let Some((mantissa, power)) = parts else { return word.to_owned() };
    let space = if unit.starts_with(char::is_alphabetic) { " " } else { "" };
    let times = if mantissa == "1" { String::new() } else { format!("{mantissa} × ") };
    format!("{times}{power}{space}{unit}")
}

/// Formats a number with three significant digits, below 0.1 with a power of ten, e.g. `3.33 × 10⁻³`.
#[must_use]
pub fn typeset_digits(value: f64) -> String {
    if (1e-3..0.1).contains(&value.abs()) {
        typeset(&format!("{value:.2e}"))
    } else {
        typeset(&three_digits(value))
    }
}

/// Formats a load as typed, and also in units of the hardness unless typed so: `10 MPa = 3.33 × 10⁻³ H`.
#[must_use]
pub fn load_in_full(typed: &str, pressure_pa: f64, hardness_pa: Option<f64>) -> String {
    match hardness_pa.filter(|_| !typed.ends_with('H')) {
        Some(hardness_pa) => format!("{} = {} H", typeset(typed), typeset_digits(pressure_pa / hardness_pa)),
        None => typeset(typed),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_digits_and_the_fitting_prefix() {
        assert_eq!(length(5.65e-9), "5.65 nm");
        assert_eq!(length(1.49392e-4), "149 µm");
        assert_eq!(length(0.00895), "8.95 mm");
        assert_eq!(length(0.99999e-6), "1 µm");
        assert_eq!(pressure(5.4e6), "5.4 MPa");
        assert_eq!(pressure(1.234e-5), "1.23e-5 Pa");
        assert_eq!(three_digits(123456.0), "1.23e5");
        assert_eq!(length(0.000008226666666666667), "8.23 µm");
        assert_eq!([length(0.0), length(-2e-9), length(f64::NAN)], ["0 m", "-2 nm", "NaN m"]);
        assert_eq!([pressure(0.0), three_digits(0.0)], ["0 Pa", "0"]);
    }

    #[test]
    fn shares_are_told_in_percent() {
        assert_eq!([0.0018, 0.322, 1.0].map(percent), ["0.18 %", "32.2 %", "100 %"]);
    }

    #[test]
    fn one_thing_is_no_things() {
        assert_eq!([0, 1, 2].map(|number| counted(number, "bin")), ["0 bins", "1 bin", "2 bins"]);
    }

    #[test]
    fn more_digits_are_printed_only_to_distinguish_lengths() {
        assert_eq!(
            lengths_apart(&[35e-9, 35.004e-9, 70e-9, 35e-9]),
            ["35 nm", "35.004 nm", "70 nm", "35 nm"]
        );
        assert_eq!(lengths_apart(&[5.65e-9, 1e-6]), ["5.65 nm", "1 µm"]);
    }

    #[test]
    fn exponents_are_set_as_powers_of_ten() {
        for (typed, set) in [
            ("1e-3 H", "10⁻³ H"),
            ("1e-3H", "10⁻³ H"),
            ("2.5e+06 Pa", "2.5 × 10⁶ Pa"),
            ("0.001 H", "0.001 H"),
            ("at 2e-9.", "at 2 × 10⁻⁹."),
            ("54 N on 1e2 mm^2", "54 N on 10² mm²"),
            ("erg", "erg"),
        ] {
            assert_eq!(typeset(typed), set);
        }
        for (value, set) in
            [(1.234e-5, "1.23 × 10⁻⁵"), (0.0625, "6.25 × 10⁻²"), (1e-3, "1.00 × 10⁻³"), (0.5, "0.5")]
        {
            assert_eq!(typeset_digits(value), set);
        }
    }

    #[test]
    fn a_load_is_also_given_in_units_of_the_hardness() {
        assert_eq!(load_in_full("1e-3 H", 3e6, Some(3e9)), "10⁻³ H");
        assert_eq!(load_in_full("10 MPa", 1e7, Some(3e9)), "10 MPa = 3.33 × 10⁻³ H");
        assert_eq!(load_in_full("10 MPa", 1e7, None), "10 MPa");
    }
}
