//! The spectrum of a self-affine surface with a roll-off and two cutoffs.

use std::f64::consts::TAU;

use crate::PowerLaw;
use units::Bound;

use crate::random_surfaces::area_spectrum::AreaSpectrum;
use crate::random_surfaces::conversion::Conversion;
use crate::random_surfaces::error::RandomSurfaceError;

/// A self-affine surface: Ciso is level from the longest wavelength to the roll-off and falls as q^(-2(1 + H)) from
/// there to the shortest (Persson, Albohr, Tartaglino, Volokitin & Tosatti 2005, J. Phys.: Condens. Matter 17:R1,
/// section 2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SelfAffine {
    /// Hurst exponent H, above 0 and at most 1.
    pub hurst_exponent: f64,
    /// The longest wavelength \[m\].
    pub longest_m: f64,
    /// The roll-off wavelength \[m\], from the shortest to the longest.
    pub rolloff_m: f64,
    /// The shortest wavelength \[m\].
    pub shortest_m: f64,
    /// Size of the roughness.
    pub size: Size,
}

/// The size of a roughness whose form is given.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Size {
    /// Root mean square of the gradient of the surface, h'.
    RmsGradient(f64),
    /// Root mean square height \[m\].
    RmsHeightM(f64),
}

impl AreaSpectrum {
    /// Builds the spectrum of a self-affine surface.
    ///
    /// # Errors
    /// [`RandomSurfaceError::Bounds`] for a Hurst exponent outside 0 to 1, lengths and sizes that are not finite and above 0,
    /// or a roll-off outside the band; [`RandomSurfaceError::EmptyBand`] if the shortest wavelength is not below the longest.
    pub fn self_affine(surface: &SelfAffine) -> Result<Self, RandomSurfaceError> {
        let SelfAffine { hurst_exponent, longest_m, rolloff_m, shortest_m, size } = *surface;
        Bound::LeftOpen { above: 0.0, at_most: 1.0 }.check("the Hurst exponent", hurst_exponent)?;
        Bound::Magnitude.check("the longest wavelength in m", longest_m)?;
        Bound::Magnitude.check("the shortest wavelength in m", shortest_m)?;
        Bound::AtLeast(shortest_m).check("the roll-off wavelength in m", rolloff_m)?;
        Bound::LeftOpen { above: 0.0, at_most: longest_m }
            .check("the roll-off wavelength in m", rolloff_m)?;
        let (name, wanted) = match size {
            Size::RmsGradient(gradient) => ("the rms gradient", gradient),
            Size::RmsHeightM(height_m) => ("the rms height in m", height_m),
        };
        Bound::Magnitude.check(name, wanted)?;
        let of_form = |height: f64| {
            let [first, rolloff, last] = [longest_m, rolloff_m, shortest_m].map(|length_m| TAU / length_m);
            let exponent = -2.0 * (1.0 + hurst_exponent);
            let level =
                PowerLaw { start_rad_per_m: first, end_rad_per_m: rolloff, at_start: height, exponent: 0.0 };
            let fall = PowerLaw { start_rad_per_m: rolloff, end_rad_per_m: last, at_start: height, exponent };
            let pieces =
                [level, fall].into_iter().filter(|piece| piece.start_rad_per_m < piece.end_rad_per_m);
            Self::from_pieces(pieces.collect(), longest_m, shortest_m, Conversion::default())
        };
        // A guess of the order of a length to the fourth keeps every product within the range of doubles.
        let guess = of_form(rolloff_m.powi(4))?;
        let of_guess = match size {
            Size::RmsGradient(_) => guess.mean_square_gradient(),
            Size::RmsHeightM(_) => guess.mean_square_height_m2(),
        };
        of_form(rolloff_m.powi(4) * (wanted * wanted / of_guess))
    }
}
