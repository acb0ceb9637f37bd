//! Options of `persson`.

use std::path::PathBuf;

use clap::Args as ClapArgs;
use measurements::ScanRequest;
use persson::Band;
use persson::EnergyFactor;
use persson::corrections::Correction;
use study::growth_law::GrowthLaw;
use study::models::ModelOptions;
use study::persson_law::Deformation;

use super::parsers::{one_of, parse_place};
use super::{
    AmplitudeArg, CounterfaceSurfaceArgs, FigureArg, LayerArgs, MaterialArgs, PressureArgs, ReadingArgs,
    SamplingArgs,
};
use crate::place::Place;

/// Growth of a hardness towards short wavelengths.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum GrowthArg {
    /// Growth by a law.
    Law(GrowthLaw),
    /// Growth tabulated in a file.
    Table(PathBuf),
}

/// Options that rows do not take, besides those for reading and sampling a spectrum: a row has a pressure and a hardness alone.
const OF_SPECTRA: [&str; 16] = [
    "figure",
    "amplitude",
    "correction",
    "band",
    "hardness_law",
    "gamma",
    "pressure_ranges",
    "material",
    "on",
    "youngs_modulus",
    "poisson_ratio",
    "yield_strength",
    "strain_gradient_length",
    "strength_cap",
    "counterface_youngs_modulus",
    "counterface_poisson_ratio",
];

#[derive(Debug, ClapArgs)]
#[command(group = clap::ArgGroup::new("source").required(true).args(["psd", "input"]))]
#[command(group = clap::ArgGroup::new("pressed").multiple(true).args(["pressures", "pressure_ranges"]))]
pub(crate) struct PerssonArgs {
    /// The power spectrum: a file, - for standard input, builtin:uncd-measured, builtin:uncd-reconstructed or
    /// builtin:contact-challenge; or scans of one face, each perhaps with options of its own: FILE:unit=um
    #[arg(requires = "model", requires = "pressed", value_name = "PSD")]
    pub psd: Vec<ScanRequest>,
    #[command(flatten)]
    pub reading: ReadingArgs,
    /// A table of pressures instead, CSV or JSON: a path, or - for standard input
    #[arg(long, value_name = "PATH", value_parser = parse_place, conflicts_with_all = OF_SPECTRA, conflicts_with_all = LayerArgs::OPTIONS, conflicts_with_all = ReadingArgs::OPTIONS, conflicts_with_all = CounterfaceSurfaceArgs::OPTIONS, conflicts_with_all = SamplingArgs::OPTIONS)]
    pub input: Option<Place>,
    /// Deformation of the surface; where left out, rows with a hardness yield and the others do not
    #[arg(long, value_parser = one_of::<Deformation, _>(Deformation::ALL))]
    pub model: Option<Deformation>,
    /// A corrected form of the elastic theory, fitted to simulations
    #[arg(long, value_parser = one_of::<Correction, _>(Correction::ALL))]
    pub correction: Option<Correction>,
    /// Spectrum cut off at a wavelength: 2d, that of the surface, which is the default and nearer to boundary elements, or
    /// 1d, that of profiles
    #[arg(long, value_parser = one_of::<Band, _>(Band::ALL))]
    pub band: Option<Band>,
    /// Growth of the hardness towards short wavelengths: power:N, with the wavevector to that power; nix-gao, with the
    /// amplitudes of scales and --strain-gradient-length; table:FILE, with the columns contact_size_m and hardness_pa
    #[arg(long, value_name = "power:N|nix-gao|table:FILE", value_parser = parse_growth)]
    pub hardness_law: Option<GrowthArg>,
    /// Elastic energy factor of the mean separation, in (0, 1], or the form fitted to boundary elements
    #[arg(long, value_name = "G|fitted", default_value_t, allow_hyphen_values = true)]
    pub gamma: EnergyFactor,
    #[command(flatten)]
    pub loads: PressureArgs,
    #[command(flatten)]
    pub material: MaterialArgs,
    #[command(flatten)]
    pub sampling: SamplingArgs,
    #[command(flatten)]
    pub amplitude: AmplitudeArg,
    #[command(flatten)]
    pub figure: FigureArg,
}

impl PerssonArgs {
    /// The options that need no file.
    pub fn options(&self) -> ModelOptions {
        ModelOptions {
            correction: self.correction,
            band: self.band,
            gamma: Some(self.gamma),
            ..ModelOptions::default()
        }
    }
}

fn parse_growth(text: &str) -> Result<GrowthArg, String> {
    match text.split_once(':') {
        Some(("table", path)) if !path.is_empty() => Ok(GrowthArg::Table(path.into())),
        _ => match GrowthLaw::named(text)? {
            Some(law) => Ok(GrowthArg::Law(law)),
            None => Err(format!("'{text}' is not one of power:N, nix-gao, table:FILE")),
        },
    }
}
