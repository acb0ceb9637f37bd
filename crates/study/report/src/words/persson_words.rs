//! The limits of Persson's theory in words.

use persson::Roughness;
use persson::corrections::Correction;
use persson::separation::LightLoads;
use units::display::{length, pressure, three_digits};

/// The largest share of u0 in the first decade of wavevectors for a spectrum without a roll-off.
const MAX_FIRST_DECADE: f64 = 0.3;

/// Above this exponent e of dV/dq = q^(e-1), C1D falls more slowly than q^-0.5: a roll-off.
const FLAT: f64 = 2.5;

/// The mean gap in rms heights above which only the highest summits of a finite sample touch.
pub(crate) const FEW_TOUCH: f64 = 3.0;

/// The note on gap and stiffness from the waves of profiles; `mend` is the option for the waves of the surface.
pub(crate) fn by_profiles(mend: &str) -> String {
    format!(
        "gap and stiffness use the waves of profiles, which makes the stiffness of a surface with a roll-off 17 to 51 % lower than \
         boundary elements give; use {mend} for the waves of the surface"
    )
}

/// The notes on a corrected form: it is a fit, and the cutoffs at which the roughness is outside its range.
#[must_use]
pub fn correction(correction: Correction, roughness: &Roughness) -> Vec<String> {
    let [least, most] = Correction::FITTED_ALPHA;
    let mut notes = vec![format!(
        "{correction} is fitted to boundary elements for alpha = m0 m4/m2^2 from {least} to {most}"
    )];
    let outside: Vec<_> =
        roughness.places().iter().skip(1).filter(|place| !(least..=most).contains(&place.alpha)).collect();
    if let (Some(first), Some(last)) = (outside.first(), outside.last()) {
        notes.push(format!(
            "alpha is outside that range at {} of {} cutoffs between {} and {}: {} to {}",
            outside.len(),
            roughness.places().len() - 1,
            length(first.wavelength_m),
            length(last.wavelength_m),
            three_digits(first.alpha),
            three_digits(last.alpha)
        ));
    }
    notes
}

/// The notes on mean gap and stiffness that mean little: for a spectrum that begins inside the fractal range, and for loads
/// (the least of them in Pa) under which few asperities touch.
#[must_use]
pub fn separation(
    light: &LightLoads,
    roughness: &Roughness,
    rms_height_m: f64,
    least_pa: f64,
) -> Vec<String> {
    let mut notes = Vec::new();
    let places = roughness.places();
    let decade = places.first().map_or(0.0, |place| 10.0 * place.wavevector_rad_per_m);
    let mut in_decade = places.iter().take_while(|place| place.wavevector_rad_per_m < decade);
    if light.share_of_first_decade > MAX_FIRST_DECADE
        && !in_decade.any(|place| place.variance_exponent > FLAT)
    {
        notes.push(format!(
            "the first decade of wavevectors makes {} % of the mean gap, and the spectrum has no roll-off there: gap and \
             stiffness depend on longer wavelengths, which are missing",
            three_digits(100.0 * light.share_of_first_decade)
        ));
    }
    let few_touch_pa = light.reference_pressure_pa * (-FEW_TOUCH * rms_height_m / light.decay_length_m).exp();
    if least_pa < few_touch_pa {
        notes.push(format!(
            "below {} the mean gap exceeds {FEW_TOUCH} rms heights: only a few asperities of a finite sample touch",
            pressure(few_touch_pa)
        ));
    }
    notes
}
