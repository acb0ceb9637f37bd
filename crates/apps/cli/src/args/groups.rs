//! Groups of options that several commands share; a command takes those that mean something for it.

use std::num::NonZeroU32;

use asperity::Hardness;
use clap::Args as ClapArgs;
use measurements::ScanRequest;
use questions::{BodyInput, LoadInput, MaterialInput, SamplingInput};
use spectrum::{Abscissa, AmplitudeDefinition, Convention, Normalisation};
use study::materials::{TabledMaterial, named};
use tables::Format;
use units::{IndentationHardness, Length, Modulus, Pressure, PressureRange};

use super::layer::LayerArgs;
use super::parsers::{one_of, parse_count, parse_place, parse_poisson_ratio};
use crate::picture::Picture;
use crate::place::Place;

/// Form in which provenance quotes the paths of the command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum QuotedPaths {
    /// The file name alone.
    Names,
    /// The path as typed.
    Full,
}

units::named!(QuotedPaths, "form of absolute paths", { Names => "names", Full => "full" });

/// Options of every command.
#[derive(Debug, Clone, ClapArgs)]
#[command(next_help_heading = "Options for every command")]
pub(crate) struct SharedArgs {
    /// Format of tables written, csv where not given; on a terminal `scan` then prints a readable table
    #[arg(long, value_parser = one_of::<Format, _>(Format::ALL), global = true)]
    pub format: Option<Format>,
    /// Destination of the table, or of the text of `run` and `scene`: a path, or - for standard output
    #[arg(long, value_name = "PATH", default_value = "-", value_parser = parse_place, global = true)]
    pub output: Place,
    /// Begin CSV tables with comment lines that tell where they come from; those of `psd` and `run` always do. They quote file names without folders; --provenance=full quotes the paths
    #[arg(
        long,
        value_name = "PATHS",
        value_parser = one_of::<QuotedPaths, _>(QuotedPaths::ALL),
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = QuotedPaths::Names.name(),
        global = true
    )]
    pub provenance: Option<QuotedPaths>,
    /// Say on standard error how long reading, computing and writing took
    #[arg(long, global = true)]
    pub timings: bool,
}

impl SharedArgs {
    /// The format of tables.
    pub fn format(&self) -> Format {
        self.format.unwrap_or_default()
    }
}

/// A surface, and how to read its spectrum.
#[derive(Debug, Clone, ClapArgs)]
pub(crate) struct PsdArgs {
    /// The power spectrum: a file, - for standard input, builtin:uncd-measured, builtin:uncd-reconstructed or
    /// builtin:contact-challenge; or scans of one face, each perhaps with options of its own: FILE:unit=um
    #[arg(required = true, value_name = "PSD")]
    pub psd: Vec<ScanRequest>,
    #[command(flatten)]
    pub reading: ReadingArgs,
}

/// The roughness of the counterface.
#[derive(Debug, Clone, ClapArgs)]
pub(crate) struct CounterfaceSurfaceArgs {
    /// Scans of the other face, if that is rough as well: its spectrum is added. Each takes options of its own, FILE:unit=um
    #[arg(long, value_name = "FILE", num_args = 1.., conflicts_with = "counterface_psd")]
    pub counterface_scans: Vec<ScanRequest>,
    /// Power spectrum of the other face, if that is rough as well: it is added
    #[arg(long, value_name = "FILE")]
    pub counterface_psd: Option<ScanRequest>,
}

/// Options for everything that the header of a spectrum may leave open, and the spectrum of the other face.
#[derive(Debug, Clone, ClapArgs)]
pub(crate) struct ReadingArgs {
    /// The column that holds the spectrum, where several could
    #[arg(long, value_name = "NAME")]
    pub column: Option<String>,
    /// Quantity in the first column of a text without header
    #[arg(long, value_parser = one_of::<Abscissa, _>(Abscissa::ALL))]
    pub x: Option<Abscissa>,
    /// The convention of the spectrum, where the header does not tell
    #[arg(long, value_parser = one_of::<Convention, _>(Convention::ALL))]
    pub convention: Option<Convention>,
    /// The series to read, of files that hold several, e.g. '1D PSD along y'
    #[arg(long, value_name = "NAME")]
    pub series: Option<String>,
    /// The subject whose series is read, of files that hold several
    #[arg(long, value_name = "NAME")]
    pub subject: Option<String>,
    /// Unit of the abscissa where the file states none, e.g. 1/um
    #[arg(long, value_name = "UNIT")]
    pub x_unit: Option<String>,
    /// Unit of the spectrum where the file states none, e.g. um^3
    #[arg(long, value_name = "UNIT")]
    pub psd_unit: Option<String>,
    #[command(flatten)]
    pub other: CounterfaceSurfaceArgs,
}

impl ReadingArgs {
    /// All of them.
    pub const OPTIONS: [&str; 7] = ["column", "x", "convention", "series", "subject", "x_unit", "psd_unit"];
}

impl CounterfaceSurfaceArgs {
    /// All of them.
    pub const OPTIONS: [&str; 2] = ["counterface_scans", "counterface_psd"];

    /// Returns the files of the other face; none if it is smooth.
    pub fn files(&self) -> Vec<ScanRequest> {
        [&self.counterface_scans, self.counterface_psd.as_slice()].concat()
    }
}

/// Nominal pressures, one by one and as ranges.
#[derive(Debug, Clone, ClapArgs)]
pub(crate) struct PressureArgs {
    /// Nominal pressure; give it several times for several loads
    #[arg(long = "pressure", value_name = "P", allow_hyphen_values = true)]
    pub pressures: Vec<LoadInput>,
    /// COUNT log-spaced pressures from FROM to TO, in addition to any --pressure
    #[arg(long = "pressures", value_name = "FROM:TO:COUNT", allow_hyphen_values = true)]
    pub pressure_ranges: Vec<PressureRange>,
}

/// Options that select the scales of a spectrum.
#[derive(Debug, Clone, ClapArgs)]
pub(crate) struct SamplingArgs {
    /// Resample the spectrum to N scales per decade; the stacked area depends on it
    #[arg(long, value_name = "N", value_parser = parse_count, allow_hyphen_values = true)]
    pub scales_per_decade: Option<NonZeroU32>,
    /// Leave out the scales below this wavelength
    #[arg(long, value_name = "L", allow_hyphen_values = true)]
    pub cutoff: Option<Length>,
}

impl SamplingArgs {
    /// All of them.
    pub const OPTIONS: [&str; 2] = ["scales_per_decade", "cutoff"];

    /// The sampling as questions take it.
    pub fn input(&self) -> SamplingInput {
        SamplingInput {
            scales_per_decade: self.scales_per_decade,
            cutoff_m: self.cutoff.map(|cutoff| cutoff.m),
        }
    }
}

/// Option for the normalisation of moments.
#[derive(Debug, Clone, ClapArgs)]
pub(crate) struct NormalisationArg {
    /// Normalisation of the moments: parseval, 1/pi, which keeps the variance, or as-printed, the 1 of Jackson & Jacobs,
    /// Eq. (1)
    #[arg(long, value_parser = one_of::<Normalisation, _>(Normalisation::ALL))]
    pub normalisation: Option<Normalisation>,
}

/// Option for the definition of the amplitude of a scale.
#[derive(Debug, Clone, ClapArgs)]
pub(crate) struct AmplitudeArg {
    /// Amplitude of a scale: eq5, Eq. (5) of Jackson & Jacobs, or parseval, the band amplitude that keeps the variance
    #[arg(long, value_parser = one_of::<AmplitudeDefinition, _>(AmplitudeDefinition::ALL))]
    pub amplitude: Option<AmplitudeDefinition>,
}

/// Option for the form of the hardness of a sphere.
#[derive(Debug, Clone, ClapArgs)]
pub(crate) struct HardnessFormulaArg {
    /// Hardness of the sphere in the model ep-sphere: 2005, that of Jackson & Green 2005, or cosine, the cosine form
    /// 2.84 - 0.92 [1 - cos(pi a/R)]
    #[arg(long, value_parser = one_of::<Hardness, _>(Hardness::ALL))]
    pub hardness_formula: Option<Hardness>,
}

/// Option for the upper limit of a growing strength.
#[derive(Debug, Clone, ClapArgs)]
pub(crate) struct StrengthCapArg {
    /// Upper limit of the depth-dependent yield strength
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pub strength_cap: Option<Pressure>,
}

/// Options for the body that presses on the rough one.
#[derive(Debug, Clone, ClapArgs)]
pub(crate) struct CounterfaceArgs {
    /// Young's modulus of the counterface, rigid where not given
    #[arg(long, value_name = "P", allow_hyphen_values = true, requires = "counterface_poisson_ratio")]
    pub counterface_youngs_modulus: Option<Modulus>,
    /// Poisson's ratio of the counterface
    #[arg(long, value_name = "NU", value_parser = parse_poisson_ratio, allow_hyphen_values = true, requires = "counterface_youngs_modulus")]
    pub counterface_poisson_ratio: Option<f64>,
}

/// Bodies by their names in the table of materials; properties given by flags replace those of the table.
#[derive(Debug, Clone, ClapArgs)]
pub(crate) struct NamedMaterialArgs {
    /// Material of the rough body, by its name in the table of materials
    #[arg(long, value_name = "NAME", value_parser = named)]
    pub material: Option<TabledMaterial>,
    /// Material of the counterface, rigid where not given; the softer of the two bodies yields
    #[arg(long, value_name = "NAME", value_parser = named)]
    pub on: Option<TabledMaterial>,
}

/// The bodies in contact, as far as every model takes them.
#[derive(Debug, Clone, ClapArgs)]
pub(crate) struct BodiesArgs {
    #[command(flatten)]
    pub named: NamedMaterialArgs,
    /// Young's modulus of the rough body
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pub youngs_modulus: Option<Modulus>,
    /// Poisson's ratio of the rough body, in (-1, 0.5]
    #[arg(long, value_name = "NU", value_parser = parse_poisson_ratio, allow_hyphen_values = true)]
    pub poisson_ratio: Option<f64>,
    /// Yield strength of the rough body; elastic models do without
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pub yield_strength: Option<Pressure>,
    /// Indentation hardness H of the rough body, a pressure or a number of a scale, as 300HV, 200HBW or 60HRC; three times
    /// the yield strength where not given, and where it alone is given, a third of it is the yield strength
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pub indentation_hardness: Option<IndentationHardness>,
    #[command(flatten)]
    pub counterface: CounterfaceArgs,
}

/// The bodies in contact, and the growth of their strength.
#[derive(Debug, Clone, ClapArgs)]
pub(crate) struct MaterialArgs {
    #[command(flatten)]
    pub bodies: BodiesArgs,
    #[command(flatten)]
    pub layer: LayerArgs,
    /// Let the strength grow where the deformation is shallower than this length (Nix & Gao)
    #[arg(long, value_name = "L", allow_hyphen_values = true)]
    pub strain_gradient_length: Option<Length>,
    #[command(flatten)]
    pub strength_cap: StrengthCapArg,
}

impl CounterfaceArgs {
    /// The counterface as questions take it.
    pub fn input(&self) -> Option<BodyInput> {
        Some(BodyInput {
            youngs_modulus_pa: self.counterface_youngs_modulus?.pa,
            poisson_ratio: self.counterface_poisson_ratio?,
        })
    }
}

impl BodiesArgs {
    /// The properties of strength, and whether each is given.
    pub fn given_strengths(&self) -> [(&'static str, bool); 2] {
        let (hardness, strength) = (self.indentation_hardness.is_some(), self.yield_strength.is_some());
        [("indentation_hardness", hardness), ("yield_strength", strength)]
    }

    /// The material as questions take it.
    pub fn input(&self) -> MaterialInput {
        let given = MaterialInput {
            youngs_modulus_pa: self.youngs_modulus.map(|modulus| modulus.pa),
            poisson_ratio: self.poisson_ratio,
            yield_strength: self.yield_strength,
            indentation_hardness_pa: self.indentation_hardness.map(|hardness| hardness.pa),
            counterface: self.counterface.input(),
            ..MaterialInput::default()
        };
        given.filled_from(self.named.material.as_ref(), self.named.on.as_ref())
    }
}

impl MaterialArgs {
    /// The material as questions take it.
    pub fn input(&self) -> MaterialInput {
        MaterialInput {
            strain_gradient_length_m: self.strain_gradient_length.map(|length| length.m),
            strength_cap: self.strength_cap.strength_cap,
            layer: self.layer.input(),
            ..self.bodies.input()
        }
    }
}

/// A picture of what a table holds.
#[derive(Debug, Clone, ClapArgs)]
pub(crate) struct FigureArg {
    /// Draw the table as well
    #[arg(long, value_name = "FILE.svg|FILE.png|FILE.pdf")]
    pub figure: Option<Picture>,
}
