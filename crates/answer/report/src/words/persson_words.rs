//! The limits of Persson's theory in words.

use persson::corrections::Correction;
use questions::{FEW_TOUCH, Note, OutsideFit};
use units::display::{length, pressure, three_digits};

/// The note on gap and stiffness from the waves of profiles; `mend` is the option for the waves of the surface.
pub(crate) fn by_profiles(mend: &str) -> String {
    format!(
        "gap and stiffness use the waves of profiles, which makes the stiffness of a surface with a roll-off 17 to 51 % lower than \
         boundary elements give; use {mend} for the waves of the surface"
    )
}

/// The words of a note on the limits of the theory; none for other notes.
pub(crate) fn words(note: &Note) -> Vec<String> {
    match note {
        Note::Correction { correction, outside } => {
            let [least, most] = Correction::FITTED_ALPHA;
            let fit = format!(
                "{correction} is fitted to boundary elements for alpha = m0 m4/m2^2 from {least} to {most}"
            );
            std::iter::once(fit).chain(outside.as_ref().map(outside_fit)).collect()
        }
        Note::NoRollOff { share_of_first_decade } => vec![format!(
            "the first decade of wavevectors makes {} % of the mean gap, and the spectrum has no roll-off there: gap and \
             stiffness depend on longer wavelengths, which are missing",
            three_digits(100.0 * share_of_first_decade)
        )],
        Note::FewTouchBelow { pressure_pa } => vec![format!(
            "below {} the mean gap exceeds {FEW_TOUCH} rms heights: only a few asperities of a finite sample touch",
            pressure(*pressure_pa)
        )],
        _ => Vec::new(),
    }
}

fn outside_fit(outside: &OutsideFit) -> String {
    let [first_m, last_m] = outside.wavelengths_m;
    let [first, last] = outside.alphas;
    format!(
        "alpha is outside that range at {} of {} cutoffs between {} and {}: {} to {}",
        outside.cutoffs,
        outside.all,
        length(first_m),
        length(last_m),
        three_digits(first),
        three_digits(last)
    )
}
