//! The share of each decade of wavelengths in the fall of a curve.

use spectrum::Hole;

use super::Point;

/// A decade of wavelengths between whole powers of ten, and its share in a curve.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct DecadeShare {
    /// Its longest wavelength \[m\].
    pub longest_m: f64,
    /// Its shortest wavelength \[m\], a tenth of the longest.
    pub shortest_m: f64,
    /// Its share of the logarithm of the final value; negative where the curve rises against its final direction.
    pub share: f64,
    /// True if the spectrum was measured in at least half of the decade, on a logarithmic scale; otherwise the share is
    /// that of an interpolation across a hole.
    pub measured: bool,
}

impl DecadeShare {
    /// Sets `measured` for a spectrum with these holes, none of which overlap.
    #[must_use]
    pub fn of_spectrum_with(self, holes: &[Hole]) -> Self {
        let missing: f64 = holes.iter().map(|hole| hole.share_of(self.longest_m, self.shortest_m)).sum();
        DecadeShare { measured: missing <= 0.5, ..self }
    }
}

/// The share of each decade of wavelengths in ln(final value), for a curve that starts from 1 before its first point: the
/// area of a stack is a product over its scales, so the shares of its scales add up to 1. The change from one point to the
/// next counts for the shorter wavelength.
///
/// From long to short wavelengths, decades without points between others included; empty where the final value is 1 or not
/// positive, since nothing is decided then.
pub fn decade_shares(curve: &[Point]) -> Vec<DecadeShare> {
    shares_of_rise(curve.iter().map(|(wavelength_m, value)| (decade(*wavelength_m), value.ln())))
}

/// The share of each decade of wavelengths in the mean square slope, from the rms slope down to each wavelength. Areas of rough bodies
/// depend on roughness through that slope alone where peaks are pressed together elastically, or flow at one hardness.
///
/// From long to short wavelengths, as [`decade_shares`]; empty without slopes.
pub fn slope_shares(rms_slopes: &[Point]) -> Vec<DecadeShare> {
    // The slopes down to a power of ten are those of waves above it.
    let above = |wavelength_m: f64| decade(wavelength_m * (1.0 + 2e-6));
    shares_of_rise(
        rms_slopes.iter().map(|(wavelength_m, rms_slope)| (above(*wavelength_m), rms_slope * rms_slope)),
    )
}

/// The share of each decade in the rise of a value from 0 before its first point; of each point the decade and the value.
fn shares_of_rise(curve: impl Iterator<Item = (i32, f64)> + Clone) -> Vec<DecadeShare> {
    let total = curve.clone().last().map_or(0.0, |(_, value)| value);
    if total == 0.0 || !total.is_finite() {
        return Vec::new();
    }
    let mut shares: Vec<DecadeShare> = Vec::new();
    let (mut before, mut next) = (0.0, curve.clone().next().map_or(0, |(decade, _)| decade));
    for (decade, value) in curve {
        while next >= decade {
            let (longest_m, shortest_m) = (power_of_ten(next + 1), power_of_ten(next));
            shares.push(DecadeShare { longest_m, shortest_m, share: 0.0, measured: true });
            next -= 1;
        }
        if let Some(last) = shares.last_mut() {
            last.share += (value - before) / total;
        }
        before = value;
    }
    shares
}

/// Finds the decade with the largest share.
#[must_use]
pub fn decisive_decade(shares: &[DecadeShare]) -> Option<&DecadeShare> {
    shares.iter().reduce(|most, other| if other.share > most.share { other } else { most })
}

/// The power of ten at the short end of the decade that a wavelength \[m\] belongs to. A decade has its long end, to a part
/// in a million: a spectrum that begins at 1 mm, whatever the rounding, begins in the decade from 1 mm to 100 um.
fn decade(wavelength_m: f64) -> i32 {
    (wavelength_m * (1.0 - 1e-6)).log10().floor() as i32
}

fn power_of_ten(power: i32) -> f64 {
    format!("1e{power}").parse().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_add_up_to_one_and_stand_in_their_decade() {
        let curve = [(5e-4, 0.5), (2e-4, 0.1), (3e-6, 0.01), (2e-6, 0.02), (9e-7, 0.01)];
        let shares = decade_shares(&curve);
        let decades: Vec<(f64, f64)> = shares.iter().map(|s| (s.longest_m, s.shortest_m)).collect();
        assert_eq!(decades, [(1e-3, 1e-4), (1e-4, 1e-5), (1e-5, 1e-6), (1e-6, 1e-7)]);
        let expected = [0.5, 0.0, 0.5 - 2f64.log10() / 2.0, 2f64.log10() / 2.0];
        for (share, expected) in shares.iter().zip(expected) {
            assert!((share.share - expected).abs() < 1e-12, "{shares:?}");
        }
        assert!((shares.iter().map(|s| s.share).sum::<f64>() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn slopes_have_the_share_of_their_squares() {
        let shares = slope_shares(&[(5e-4, 0.1), (2e-4, 0.2), (3e-6, 0.2), (9e-7, 0.4)]);
        let found: Vec<(f64, f64)> = shares.iter().map(|share| (share.longest_m, share.share)).collect();
        for ((longest_m, share), expected) in
            found.iter().zip([(1e-3, 0.25), (1e-4, 0.0), (1e-5, 0.0), (1e-6, 0.75)])
        {
            assert!(*longest_m == expected.0 && (share - expected.1).abs() < 1e-12, "{found:?}");
        }
        assert_eq!(slope_shares(&[(1e-3, 0.0)]), []);
        // The last step ends at a power of ten, and belongs to the decade above.
        let [only] = slope_shares(&[(5e-4, 0.1), (1e-4, 0.2)])[..] else { panic!() };
        assert_eq!((only.longest_m, only.share), (1e-3, 1.0));
    }

    #[test]
    fn a_decade_has_its_long_end() {
        for longest_m in [1e-3, 1e-3 * (1.0 + 1e-9), 1e-3 * (1.0 - 1e-9)] {
            let shares = decade_shares(&[(longest_m, 0.5), (2e-4, 0.1), (1e-4, 0.05)]);
            let decades: Vec<(f64, f64)> = shares.iter().map(|s| (s.longest_m, s.shortest_m)).collect();
            assert_eq!(decades, [(1e-3, 1e-4), (1e-4, 1e-5)]);
        }
    }

    #[test]
    fn a_decade_that_lies_mostly_in_a_hole_was_not_measured() {
        let holes = [Hole { longest_m: 2.27e-6, shortest_m: 114e-9 }];
        let shares = decade_shares(&[(5e-6, 0.5), (2.27e-6, 0.4), (114e-9, 0.2), (2e-8, 0.1)]);
        let measured = shares.into_iter().map(|share| share.of_spectrum_with(&holes).measured);
        assert_eq!(measured.collect::<Vec<_>>(), [true, false, true]);
    }

    #[test]
    fn a_rise_counts_against() {
        let shares = decade_shares(&[(2e-3, 0.1), (2e-4, 0.5), (2e-5, 0.1)]);
        assert!(shares[1].share < 0.0 && shares[0].share == 1.0);
    }

    #[test]
    fn complete_contact_decides_nothing() {
        assert_eq!(decade_shares(&[(1e-3, 1.0), (1e-4, 1.0)]), []);
        assert_eq!(decade_shares(&[(1e-3, 0.0)]), []);
        assert_eq!(decade_shares(&[]), []);
    }
}
