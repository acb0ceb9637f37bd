//! Facts that a reader has to know about an answer, as data.

use crate::rows::RowsNote;
use elements::{IndenterCaution, PressedLoad, RandomSurfaces};
use findings::doubts::Doubt;
use persson::Roughness;
use persson::corrections::Correction;
use persson::separation::LightLoads;
use spectrum::ProfilePsd;
use spectrum::random_surfaces::{AreaSpectrum, GridBand};
use study::material::Material;
use study::models::{Choice, ModelEntry};
use study::plan::scales_per_decade;

use crate::CurveCounts;

/// A fact that a reader has to know about an answer. Deliberately not `#[non_exhaustive]`: `report` must word every variant.
#[derive(Debug, Clone, PartialEq)]
pub enum Note {
    /// About the spectrum of the question.
    Surface(study::Note),
    /// Physics speaks against a number.
    Doubt(Doubt),
    /// No yield strength is given, and H/3 is taken.
    AssumedStrength {
        /// H/3 \[Pa\].
        yield_strength_pa: f64,
    },
    /// A model of half-spaces takes a layer by its modulus at each wavelength, which is an approximation.
    ModulusOfLayer,
    /// A tolerance beyond double precision.
    ToleranceTooFine {
        /// The requested tolerance.
        asked: f64,
        /// The tolerance used.
        used: f64,
    },
    /// Sampling of the spectrum, on which the area of a stack depends.
    Sampling(SampledScales),
    /// The longest wavelength has no asperities yet.
    FirstRowIsEmpty,
    /// Rows at a bound or outside the range of a law.
    Counts(CurveCounts),
    /// Corrected forms of Persson's theory are fits.
    Correction {
        /// The form.
        correction: Correction,
        /// Cutoffs outside its range; none if all are inside.
        outside: Option<OutsideFit>,
    },
    /// The spectrum begins inside its fractal range, on which gap and stiffness depend.
    NoRollOff {
        /// Share of the mean gap that the first decade of wavevectors makes.
        share_of_first_decade: f64,
    },
    /// Below this load few asperities of a finite sample touch.
    FewTouchBelow {
        /// The load \[Pa\].
        pressure_pa: f64,
    },
    /// Gap and stiffness take the waves of profiles.
    WavesOfProfiles,
    /// The logarithmic law of light loads holds below a load.
    LightLoads {
        /// The load \[Pa\].
        up_to_pa: f64,
        /// The share of the pressure within which it holds.
        share: f64,
    },
    /// Gaps that mean little, or are missing.
    Gaps(GapCounts),
    /// Moments of no Gaussian isotropic surface.
    NotGaussian {
        /// Number of cutoffs with such moments.
        cutoffs: usize,
        /// Longest and shortest of these cutoffs \[m\].
        range_m: [f64; 2],
        /// The least Nayak parameter.
        least_alpha: f64,
    },
    /// No roll-off can be identified.
    PurePowerLaw,
    /// A Hurst exponent outside 0 to 1.
    HurstOutOfRange {
        /// The exponent.
        hurst_exponent: f64,
    },
    /// The spectrum of an area is used as it is.
    AreaSpectrumAsItIs,
    /// Surfaces made of a spectrum.
    RandomSurfaces(Box<MadeSurfaces>),
    /// Surfaces pressed by boundary elements.
    Pressed(Vec<PressedLoad>),
    /// A ball on a flat that is coarse, narrow, or much larger than the ball can be as a parabola.
    Ball(IndenterCaution),
    /// A cylinder on a flat that is coarse, narrow, or much larger than the cylinder can be as a parabola.
    Cylinder(IndenterCaution),
    /// A map that does not repeat itself is repeated under a cylinder.
    RepeatedMap,
    /// A finding on surfaces that attract each other.
    Adhesion(AdhesionNote),
    /// A ball or a cylinder was pressed onto one place alone.
    OnePlace,
    /// A ball or a cylinder was pressed onto several places.
    Places {
        /// Standard deviation of the real area over its mean.
        scatter: f64,
    },
    /// Normal and tangential tractions act on each other, which superposition leaves out.
    CoupledTractions {
        /// Dundurs' beta.
        mismatch: f64,
    },
    /// Tangential loads under which everything slides.
    Sliding {
        /// Their number.
        sliding: usize,
        /// Number of all loads.
        all: usize,
    },
    /// Rows of a table.
    Rows(RowsNote),
}

/// Number and range of the scales that take part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SampledScales {
    /// Number of scales.
    pub scales: usize,
    /// The longest \[m\].
    pub longest_m: f64,
    /// The shortest \[m\].
    pub shortest_m: f64,
    /// Number of scales per decade, on average; absent for a single scale.
    pub per_decade: Option<f64>,
}

/// Cutoffs outside the range of a fit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutsideFit {
    /// Number of cutoffs outside the fit.
    pub cutoffs: usize,
    /// Number of all cutoffs.
    pub all: usize,
    /// The first and the last of them \[m\].
    pub wavelengths_m: [f64; 2],
    /// Their alpha = m0 m4/m2^2.
    pub alphas: [f64; 2],
}

/// Loads whose gaps mean little, or are missing.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct GapCounts {
    /// All loads.
    pub all: usize,
    /// Loads with a gap above [`FEW_TOUCH`] rms heights.
    pub few_touch: usize,
    /// Loads with a negative gap.
    pub negative: usize,
    /// Loads without a gap.
    pub missing: usize,
}

/// Surfaces made of a spectrum, and the grid that holds them.
#[derive(Debug, Clone, PartialEq)]
pub struct MadeSurfaces {
    /// The spectrum.
    pub spectrum: AreaSpectrum,
    /// The surfaces.
    pub random: RandomSurfaces,
    /// Their grid.
    pub grid: GridBand,
    /// E* \[Pa\].
    pub contact_modulus_pa: f64,
}

/// Above so many rms heights only the highest summits of a finite sample touch.
pub const FEW_TOUCH: f64 = 3.0;

/// The share of u0 that the first decade of wavevectors may have if the spectrum has no roll-off.
const MOST_OF_FIRST_DECADE: f64 = 0.3;

/// From this exponent of dV/dq = q^(e-1) on, C1D falls more slowly than q^-0.5: a roll-off.
const FLAT: f64 = 2.5;

impl SampledScales {
    /// The scales of a spectrum.
    #[must_use]
    pub fn of(psd: &ProfilePsd) -> Self {
        SampledScales {
            scales: psd.len(),
            longest_m: psd.longest_wavelength_m(),
            shortest_m: psd.shortest_wavelength_m(),
            per_decade: scales_per_decade(psd),
        }
    }
}

impl Note {
    /// True for every doubt, which front ends mark as such.
    #[must_use]
    pub fn is_doubt(&self) -> bool {
        matches!(self, Note::Doubt(_))
    }

    /// Returns the note on how far places differ, by the real areas of each.
    pub(crate) fn of_places(areas: &[f64]) -> Note {
        let [_, _, ..] = areas else { return Note::OnePlace };
        let count = areas.len() as f64;
        let mean = areas.iter().sum::<f64>() / count;
        let squares = areas.iter().map(|area| (area - mean).powi(2)).sum::<f64>();
        Note::Places { scatter: (squares / (count - 1.0)).sqrt() / mean }
    }

    /// Returns a note if asperities yield at H/3 because no strength is given (Persson's theory takes H itself), or if the
    /// theory takes a layer, which no other model does.
    #[must_use]
    pub fn of_model(material: &Material, model: &ModelEntry) -> Option<Note> {
        if material.pair.layer().is_some() {
            return Some(Note::ModulusOfLayer);
        }
        let takes_strength = model.has(Choice::Strength) && !model.framework.takes_hardness();
        let strength_pa = material.assumed_yield_strength_pa().filter(|_| takes_strength)?;
        Some(Note::AssumedStrength { yield_strength_pa: strength_pa })
    }

    /// The range that a corrected form was fitted in.
    #[must_use]
    pub fn of_correction(correction: Correction, roughness: &Roughness) -> Note {
        let [least, most] = Correction::FITTED_ALPHA;
        let places = roughness.places();
        let outside: Vec<_> =
            places.iter().skip(1).filter(|place| !(least..=most).contains(&place.alpha)).collect();
        let outside = outside.first().zip(outside.last()).map(|(first, last)| OutsideFit {
            cutoffs: outside.len(),
            all: places.len() - 1,
            wavelengths_m: [first.wavelength_m, last.wavelength_m],
            alphas: [first.alpha, last.alpha],
        });
        Note::Correction { correction, outside }
    }

    /// Spectra and loads for which mean gap and stiffness mean little: a spectrum that begins inside its fractal range, and
    /// loads (the least of them in Pa) under which few asperities touch.
    #[must_use]
    pub fn of_separation(
        light: &LightLoads,
        roughness: &Roughness,
        rms_height_m: f64,
        least_pa: f64,
    ) -> Vec<Note> {
        let places = roughness.places();
        let decade = places.first().map_or(0.0, |place| 10.0 * place.wavevector_rad_per_m);
        let mut in_decade = places.iter().take_while(|place| place.wavevector_rad_per_m < decade);
        let rolls_off = in_decade.any(|place| place.variance_exponent > FLAT);
        let share_of_first_decade = light.share_of_first_decade;
        let no_rolloff = (share_of_first_decade > MOST_OF_FIRST_DECADE && !rolls_off)
            .then_some(Note::NoRollOff { share_of_first_decade });
        let pressure_pa =
            light.reference_pressure_pa * (-FEW_TOUCH * rms_height_m / light.decay_length_m).exp();
        let few_touch = (least_pa < pressure_pa).then_some(Note::FewTouchBelow { pressure_pa });
        no_rolloff.into_iter().chain(few_touch).collect()
    }
}

/// Finding on adhesive surfaces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum AdhesionNote {
    /// The grid is coarse for the process zone E* rho^2/w.
    CoarseGrid {
        /// Points of the grid in the process zone; 2 are good to 1 %.
        points: f64,
    },
    /// A negative load holds only until something disturbs it.
    Metastable,
    /// The area depends on the history of the load.
    Hysteresis {
        /// The load \[Pa\] at which it depends most.
        nominal_pressure_pa: f64,
        /// Area fraction on approach.
        apart: f64,
        /// Area fraction from full contact.
        contact: f64,
    },
    /// The largest pull that the surfaces bear.
    PullOff {
        /// Nominal pressure \[Pa\], negative; the mean over the surfaces.
        nominal_pressure_pa: f64,
        /// Mean gap there \[m\].
        mean_gap_m: f64,
        /// Area fraction there.
        area_fraction: f64,
    },
    /// The two indicators of stickiness beside their limits.
    Indicators {
        /// Parameter of Fuller & Tabor, if the spectrum has summits.
        fuller_tabor: Option<f64>,
        /// Left side of the criterion of Pastewka & Robbins.
        pastewka_robbins: f64,
    },
}

impl AdhesionNote {
    /// Returns the numbers of the finding, each with its name, which ends in its unit.
    #[must_use]
    pub fn numbers(&self) -> Vec<(&'static str, f64)> {
        match *self {
            AdhesionNote::CoarseGrid { points } => vec![("process_zone_points", points)],
            AdhesionNote::Metastable => Vec::new(),
            AdhesionNote::Hysteresis { nominal_pressure_pa, apart, contact } => vec![
                ("hysteresis_pressure_pa", nominal_pressure_pa),
                ("hysteresis_apart_area_fraction", apart),
                ("hysteresis_contact_area_fraction", contact),
            ],
            AdhesionNote::PullOff { nominal_pressure_pa, mean_gap_m, area_fraction } => vec![
                ("pull_off_pressure_pa", nominal_pressure_pa),
                ("pull_off_mean_gap_m", mean_gap_m),
                ("pull_off_area_fraction", area_fraction),
            ],
            AdhesionNote::Indicators { fuller_tabor, pastewka_robbins } => fuller_tabor
                .map(|theta| ("fuller_tabor", theta))
                .into_iter()
                .chain([("pastewka_robbins", pastewka_robbins)])
                .collect(),
        }
    }
}
