//! Lengths and pressures as people read them: three digits and a prefix.

/// A length, e.g. `5.65 nm`.
#[must_use]
pub fn length(length_m: f64) -> String {
    with_prefix(length_m, &[("m", 0), ("mm", -3), ("µm", -6), ("nm", -9), ("pm", -12)])
}

/// A pressure, e.g. `5.4 MPa`.
#[must_use]
pub fn pressure(pressure_pa: f64) -> String {
    with_prefix(pressure_pa, &[("TPa", 12), ("GPa", 9), ("MPa", 6), ("kPa", 3), ("Pa", 0)])
}

/// What is zero, or no finite number, has the plain unit.
fn with_prefix(value: f64, units: &[(&str, i32)]) -> String {
    let has_size = value.is_finite() && value != 0.0;
    let fits = |(_, power): &&(&str, i32)| match has_size {
        true => value.abs() >= 0.9995 * 10f64.powi(*power),
        false => *power == 0,
    };
    let (unit, power) = units.iter().find(fits).unwrap_or(&units[units.len() - 1]);
    format!("{} {unit}", three_digits(value / 10f64.powi(*power)))
}

/// A number of things, e.g. `1 scale`, `2 scales`; `thing` takes an s.
#[must_use]
pub fn counted(number: usize, thing: &str) -> String {
    let s = if number == 1 { "" } else { "s" };
    format!("{number} {thing}{s}")
}

/// Three significant digits, with an exponent outside 1e-3 to 1e4; 0 is 0.
#[must_use]
pub fn three_digits(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    if !(1e-3..1e4).contains(&value.abs()) {
        return format!("{value:.2e}");
    }
    let decimals = (2 - value.abs().log10().floor() as i32).max(0) as usize;
    let fixed = format!("{value:.decimals$}");
    if fixed.contains('.') { fixed.trim_end_matches('0').trim_end_matches('.').to_owned() } else { fixed }
}

/// A power of ten as it is set, e.g. `10⁻³`.
#[must_use]
pub fn power_of_ten(power: i32) -> String {
    const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| SUPERSCRIPTS[digit as usize]);
    format!("10{}", power.to_string().chars().map(raised).collect::<String>())
}

/// Exponents as they are set: `10⁻³ H` of `1e-3 H`, `1.2 × 10⁻³` of `1.2e-3`, `mm²` of `mm^2`. Anything else stays.
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

/// Three significant digits; below a tenth with a power of ten, e.g. `3.33 × 10⁻³`.
#[must_use]
pub fn typeset_digits(value: f64) -> String {
    if (1e-3..0.1).contains(&value.abs()) {
        typeset(&format!("{value:.2e}"))
    } else {
        typeset(&three_digits(value))
    }
}

/// A load as typed; one typed in units of pressure or force also in units of the hardness, e.g. `10 MPa = 3.33 × 10⁻³ H`.
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
    fn one_thing_is_no_things() {
        assert_eq!([0, 1, 2].map(|number| counted(number, "bin")), ["0 bins", "1 bin", "2 bins"]);
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
