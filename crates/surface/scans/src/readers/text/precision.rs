//! Precision of printed numbers.

/// Most decimals and most significant digits of printed numbers. The most, since trailing zeros may be left out.
#[derive(Clone, Copy, Default)]
pub(super) struct Precision {
    /// 3 for `0.250`, 5 for `1.3381669e+02`, -2 for `1e2`.
    decimals: Option<i32>,
    digits: i32,
}

impl Precision {
    /// Takes a printed number into account.
    pub(super) fn take(&mut self, field: &str) {
        let (mantissa, exponent) = match field.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, exponent.parse().unwrap_or(0)),
            None => (field, 0i32),
        };
        let length = |text: &str| i32::try_from(text.len()).unwrap_or(i32::MAX);
        let decimals =
            mantissa.split_once('.').map_or(0, |(_, decimals)| length(decimals)).saturating_sub(exponent);
        let significant = mantissa.trim_start_matches(['+', '-', '0', '.']);
        let digits = length(significant) - i32::from(significant.contains('.'));
        self.decimals = self.decimals.max(Some(decimals));
        self.digits = self.digits.max(digits);
    }

    /// The value of one in the last digit of numbers up to `largest`.
    pub(super) fn last_digit(self, largest: f64) -> f64 {
        let Some(decimals) = self.decimals else { return 0.0 };
        let of_decimals = 10f64.powi(decimals.saturating_neg());
        if largest == 0.0 {
            return of_decimals;
        }
        of_decimals.max(10f64.powi(largest.log10().floor() as i32 + 1 - self.digits))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_digit_is_the_finest_printed() {
        for (fields, largest, digit) in [
            (&["0.000", "0.250", "12.500"][..], 12.5, 1e-3),
            (&["0", "0.5", "1.25"], 1.25, 1e-2),
            (&["1.3381669e+01", "2.0057210e+02"], 200.6, 1e-5),
            (&["0.123456", "123.456"], 123.5, 1e-3),
            (&["0", "5", "10"], 10.0, 1.0),
            (&["-5E-9", "1e-8"], 1e-8, 1e-8),
            (&["0", "1e99999999999"], 0.0, 1.0),
        ] {
            let mut printed = Precision::default();
            fields.iter().for_each(|field| printed.take(field));
            let found = printed.last_digit(largest);
            assert!((found / digit - 1.0).abs() < 1e-12, "{fields:?}: {found}");
        }
    }
}
