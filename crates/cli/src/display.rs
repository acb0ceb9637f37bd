//! Lengths and pressures as people read them: three digits and a prefix.

/// A length, e.g. `5.65 nm`.
pub fn length(length_m: f64) -> String {
    with_prefix(length_m, &[("m", 0), ("mm", -3), ("µm", -6), ("nm", -9), ("pm", -12)])
}

/// A pressure, e.g. `5.4 MPa`.
pub fn pressure(pressure_pa: f64) -> String {
    with_prefix(pressure_pa, &[("TPa", 12), ("GPa", 9), ("MPa", 6), ("kPa", 3), ("Pa", 0)])
}

fn with_prefix(value: f64, units: &[(&str, i32)]) -> String {
    let fits = |(_, power): &&(&str, i32)| value >= 0.9995 * 10f64.powi(*power);
    let (unit, power) = units.iter().find(fits).unwrap_or(&units[units.len() - 1]);
    format!("{} {unit}", three_digits(value / 10f64.powi(*power)))
}

/// Three significant digits, with an exponent outside 1e-3 to 1e4.
pub fn three_digits(value: f64) -> String {
    if !(1e-3..1e4).contains(&value.abs()) {
        return format!("{value:.2e}");
    }
    let decimals = (2 - value.abs().log10().floor() as i32).max(0) as usize;
    let fixed = format!("{value:.decimals$}");
    if fixed.contains('.') { fixed.trim_end_matches('0').trim_end_matches('.').to_owned() } else { fixed }
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
    }
}
