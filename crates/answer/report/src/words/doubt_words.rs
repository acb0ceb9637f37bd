//! Doubts in words, a short line each.

use findings::doubts::Doubt;
use units::display::{counted, length, pressure, three_digits};

/// The rms slope from which a mistaken unit of heights is more likely than any surface.
const FAR_TOO_STEEP: f64 = 30.0;

/// Error of Persson's theory on layers, against boundary elements with the kernel of the layer.
pub(crate) const MODULUS_OF_LAYER: &str = "the layer counts by its modulus at each wavelength: boundary elements (bem) find 0.75 to 1.15 times the areas on \
                     elastic bases or compressible layers, up to 2.3 times on thin rubber-like layers, and 0.9 to 1.2 times the gaps";

/// A doubt in a line, without a full stop.
#[must_use]
pub fn line(doubt: &Doubt) -> String {
    match doubt {
        Doubt::SteepSurface { rms_slope } if *rms_slope > FAR_TOO_STEEP => format!(
            "the rms slope of the surface is {}, 1000 times too high: nm and µm mixed up?",
            three_digits(*rms_slope)
        ),
        Doubt::SteepSurface { rms_slope } => format!(
            "the rms slope of the surface is {}, above 1: check the units of the spectrum",
            three_digits(*rms_slope)
        ),
        Doubt::SteepScale { wavelength_m, aspect_ratio } => format!(
            "the scale at {} is {} times as high as it is long: check the units of the spectrum",
            length(*wavelength_m),
            three_digits(*aspect_ratio)
        ),
        Doubt::StrongerThanSolids { yield_strength_pa, bound_pa } => format!(
            "the yield strength {} exceeds E/10 = {}, about the most that a solid bears: is the modulus in GPa?",
            pressure(*yield_strength_pa),
            pressure(*bound_pa)
        ),
        Doubt::SofterThanItsRatio { youngs_modulus_pa, probable_pa, poisson_ratio } => format!(
            "E = {} is unusually soft for Poisson's ratio {}; did you mean {}?",
            pressure(*youngs_modulus_pa),
            three_digits(*poisson_ratio),
            pressure(*probable_pa)
        ),
        Doubt::NominalAboveHardness { load, pressure_pa, hardness_pa, others } => format!(
            "the load {load} is {} times the hardness H = {}: the body yields as a whole{}",
            three_digits(pressure_pa / hardness_pa),
            pressure(*hardness_pa),
            and_more(*others, "load")
        ),
        Doubt::RealAboveHardness { highest, hardness_pa } => format!(
            "{} at {} has a real pressure of {} H, above the hardness H = {}{}",
            highest.curve,
            highest.load,
            three_digits(highest.pressure_pa / hardness_pa),
            pressure(*hardness_pa),
            and_more(highest.other_curves, "curve")
        ),
        Doubt::RealAboveThirdModulus { highest, bound_pa } => format!(
            "{} at {} has a real pressure of {}, above E*/3 = {}: beyond linear elasticity{}",
            highest.curve,
            highest.load,
            pressure(highest.pressure_pa),
            pressure(*bound_pa),
            and_more(highest.other_curves, "curve")
        ),
        // Doubts without words of their own show their data.
        other => format!("{other:?}"),
    }
}

fn and_more(others: usize, what: &str) -> String {
    match others {
        0 => String::new(),
        _ => format!(" (and {})", counted(others, &format!("more {what}"))),
    }
}
