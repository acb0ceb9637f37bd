//! Arguments of the command line.

mod bem;
mod figure_files;
mod flow;
mod gap;
mod groups;
mod layer;
mod parsers;
mod persson;
mod report;
mod scans;

pub(crate) use bem::BemArgs;
pub(crate) use figure_files::FigureFilesArgs;
pub(crate) use flow::FlowArgs;
pub(crate) use gap::{GapArgs, LawArgs, TangentialArgs};
pub(crate) use groups::{
    AmplitudeArg, BodiesArgs, CounterfaceArgs, CounterfaceSurfaceArgs, FigureArg, HardnessFormulaArg,
    MaterialArgs, NormalisationArg, PressureArgs, PsdArgs, QuotedPaths, ReadingArgs, SamplingArgs,
    SharedArgs, StrengthCapArg,
};
pub(crate) use layer::LayerArgs;
pub(crate) use persson::{GrowthArg, PerssonArgs};
pub(crate) use report::ReportArgs;
pub(crate) use scans::{RoughnessArgs, ScanArgs, ScansArgs, refuse_replaced};

use std::path::PathBuf;

use clap::{Args as ClapArgs, Parser, Subcommand};
use clap_complete::Shell;
use stacked_contact::YieldingAreaLaw;
use stat_contact::{Flattening, InterferenceLaw, SummitHeights};

use crate::place::Place;
use measurements::ScanRequest;
use parsers::{model_of, one_of, parse_place, parse_tolerance};
use questions::rows::GivenColumn;
use scene::Template;
use study::models::{Framework, ModelEntry, ModelOptions};
use study::plan::Tolerance;
use units::{Length, SignedLength};

/// Real contact area of two rough surfaces, and the scales of roughness that decide it.
///
/// `truearea report` answers the whole question from scans of a surface or its power spectral density (PSD), a material and
/// a pressure: how much touches, how sure that is, and which of its models agree with boundary elements. The other commands
/// are the parts: spectra and roughness of scans; contact area by Persson's theory, by asperities after Greenwood &
/// Williamson, and by Archard's stack after Jackson & Jacobs; boundary elements; gaps, contact laws and tangential loads.
#[derive(Debug, Parser)]
#[command(
    name = "truearea",
    version,
    after_long_help = "\
Quantities carry units: 463GPa, '1.8e9 Pa', 5um, 3 Å; pressures also in H,
three times the yield strength. PSD is a file (CSV or two-column text), - for
standard input, or a built-in spectrum: builtin:uncd-measured,
builtin:uncd-reconstructed (a reconstruction, not the published data) and
builtin:contact-challenge.

Examples:
  truearea stacked builtin:uncd-measured --model elastic-plastic \\
      --pressure 5.4MPa --youngs-modulus 463GPa --poisson-ratio 0.2 \\
      --yield-strength 1.8GPa
  truearea scene uncd-measured > uncd.toml
  truearea run uncd.toml"
)]
pub struct Args {
    #[command(flatten)]
    pub(crate) shared: SharedArgs,
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Evaluate the contact law of one asperity, row by row of a table
    Asperity(AsperityArgs),
    /// Spectral moments and McCool's asperity parameters for every cutoff
    #[command(after_help = "\
Columns: wavelength_m, m0_m2, m2, m4_per_m2, radius_m, density_per_m2,
sigma_s_m, offset_m, nayak_alpha; a row per wavelength from long to short. The
first row has no interval yet: its cells are empty.

Example:
  truearea moments psd.csv --output moments.csv")]
    Moments(MomentsArgs),
    /// Amplitude and aspect ratio of every scale
    #[command(after_help = "\
Columns: wavelength_m, amplitude_m, aspect_ratio; a row per wavelength from
long to short.

Example:
  truearea amplitude psd.csv --amplitude parseval")]
    Amplitude(AmplitudeArgs),
    /// Contact area against cutoff by the stacked multiscale model
    #[command(after_help = "\
Columns: wavelength_m, amplitude_m, area_fraction, real_pressure_pa (the mean
pressure on the contact after that scale), regime (elastic, plastic or
flattened); a row per wavelength from long to short. With several pressures a
first column nominal_pressure_pa, in blocks in the order given.

Example:
  truearea stacked psd.csv --model elastic-plastic \\
      --pressure 5.4MPa --pressure 1e-2H --youngs-modulus 463GPa \\
      --poisson-ratio 0.2 --yield-strength 1.8GPa --strain-gradient-length 5um")]
    Stacked(StackedArgs),
    /// Contact of a population of asperities: at a pressure or a separation, row by row or over all cutoffs
    #[command(after_help = "\
With a spectrum, the asperities that each cutoff leaves are pressed by a flat.
Columns: wavelength_m, radius_m, density_per_m2, sigma_s_m, separation_m,
pressure_pa, area_fraction; a row per wavelength from long to short, in blocks
in the order of the pressures, then of the separations. The first row has no
asperities yet: its cells are empty.

With --input, a table with the columns model (one of those of --model),
youngs_modulus_pa, poisson_ratio, yield_strength_pa or, three times that,
indentation_hardness_pa, strain_gradient_length_m (empty for none), radius_m, density_per_m2, sigma_s_m (of bgt m0_m2, m2, m4_per_m2), and of separation_m and
pressure_pa exactly one in each row; the other one and area_fraction are filled
in. What is the same in every row may be given as an option instead of a
column. Rows without asperities, as the first one of `moments`, have empty
results. A pressure beyond complete contact of every sinusoid has no
separation: its cell stays empty, and the area fraction is 1.

The separation is measured from the mean of the asperity heights and may be
negative.

Examples:
  truearea statistical psd.csv --model ep-sphere --pressure 5.4MPa \\
      --youngs-modulus 463GPa --poisson-ratio 0.2 --yield-strength 1.8GPa
  truearea statistical psd.csv --model hertz --pressures 1kPa:1GPa:1000 \\
      --youngs-modulus 463GPa --poisson-ratio 0.2 --output sweep.csv
  truearea statistical --input rows.csv --given pressure --output rows.csv
  truearea moments psd.csv | truearea statistical --input - \\
      --model hertz --pressure 1MPa --youngs-modulus 463GPa --poisson-ratio 0.2")]
    Statistical(StatisticalArgs),
    /// Contact area, mean gap and stiffness by Persson's theory: over all cutoffs, or row by row
    #[command(after_help = "\
With a spectrum: columns wavelength_m, area_fraction, elastic_area_fraction,
plastic_area_fraction, real_pressure_pa, rms_gradient, mean_gap_m,
stiffness_pa_per_m, band (that a cutoff lets through: 1d or 2d); a row per
wavelength from long to short. With several pressures a first column
nominal_pressure_pa, in blocks in the order given. Gap and stiffness are those of the elastic theory: their cells are empty where more
than 3 % of the contact is plastic.

With --input, a table with the columns pressure_pa, rms_pressure_pa (of the
pressure that would flatten the roughness, E* h'/2), and, where it yields,
hardness_pa and hardness_growth (c of H^2 = H0^2 + c V with V the square of
rms_pressure_pa; empty for none). area_fraction, elastic_area_fraction and
plastic_area_fraction are filled in. What is the same in every row may be given
as --pressure and --indentation-hardness instead.

Examples:
  truearea persson psd.csv --model elastic --pressure 5.4MPa \\
      --youngs-modulus 463GPa --poisson-ratio 0.2
  truearea persson psd.csv --model elastic-plastic --hardness-law power:0.2 \\
      --pressures 1kPa:1GPa:40 --youngs-modulus 463GPa --poisson-ratio 0.2 \\
      --indentation-hardness 5.4GPa
  truearea persson --input rows.csv --output rows.csv")]
    Persson(PerssonArgs),
    /// Mean gap and stiffness of a rough surface under loads, with its whole spectrum
    #[command(after_help = "\
Columns: nominal_pressure_pa, area_fraction, mean_gap_m, stiffness_pa_per_m,
u0_m, p00_pa; a row per load in the order given. The mean gap is the distance of
the flat from the mean plane of the rough surface, the stiffness how much more
nominal pressure it takes to close it by a metre, in excess of smooth bodies. At
light loads Persson's theory has u = u0 ln(p00/p) and K = p/u0; other models
have neither, and their cells are empty. What the table leaves open is said on
standard error.

Examples:
  truearea gap psd.csv --model persson --pressures 1kPa:100MPa:11 \\
      --youngs-modulus 463GPa --poisson-ratio 0.2
  truearea gap psd.csv --model hertz --pressure 1MPa --youngs-modulus 463GPa \\
      --poisson-ratio 0.2
  truearea gap psd.csv --model bem --shortest 500nm --grid 128 --realisations 2 \\
      --pressure 10MPa --youngs-modulus 463GPa --poisson-ratio 0.2")]
    Gap(Box<GapArgs>),
    /// Displacement, stiffness and energy lost of a surface sheared under a constant normal load
    #[command(after_help = "\
Columns: nominal_pressure_pa, tangential_stress_pa, share_of_sliding (over
friction times pressure), displacement_m (on first loading),
initial_stiffness_pa_per_m, tangent_stiffness_pa_per_m, dissipation_j_per_m2 (a
cycle between both signs of the stress), damping_ratio (the same as equivalent
viscous damping), area_fraction, stuck_area_fraction; a row per pressure and
stress. The response follows from the normal law: what a smaller pressure
presses sticks, the rest slips (Cattaneo, Mindlin, Ciavarella, Jaeger).

Examples:
  truearea tangential psd.csv --model persson --friction 0.3 \\
      --pressure 10MPa --youngs-modulus 210GPa --poisson-ratio 0.3
  truearea tangential psd.csv --model persson --friction 0.15 \\
      --pressure 50MPa --tangential-stress 5MPa --material 100Cr6 --on 100Cr6")]
    Tangential(Box<TangentialArgs>),
    /// Pressure against overclosure of a rough surface, as finite element codes read it
    #[command(after_help = "\
Writes *SURFACE INTERACTION and *SURFACE BEHAVIOR for Abaqus or CalculiX, or a
plain table (csv), in the units of the model. The overclosure is u_ref - u, u
the mean gap of `truearea gap`, u_ref the one at 1/e of the least pressure:
there the pressure is set to 0. There are as many rows as keep the pressure on
the straight lines between them within --error from the least pressure on. What
has to be known for it to be used stands in comment lines.

--quantity asperity-pressure writes a table for solvers of mixed lubrication:
nominal_pressure_pa, area_fraction, mean_gap_m, nominal_separation_m (of the
mean planes), separation_over_rms_height, pressure and area of the nearest
Greenwood-Tripp law, and flow factors over mean_gap_m^3; a row per separation,
rising. PSD may then be a scene, or --summit-density and two more numbers.

Examples:
  truearea law psd.csv --model persson --dialect abaqus --units N-mm \\
      --pressure-range 10kPa:100MPa --youngs-modulus 463GPa --poisson-ratio 0.2 \\
      --output rough.inp
  truearea law psd.csv --model hertz --dialect calculix --units N-mm \\
      --pressure-range 10kPa:100MPa --youngs-modulus 463GPa --poisson-ratio 0.2
  truearea law psd.csv --model persson --dialect calculix --form exponential \\
      --pressure-range 1kPa:1MPa --youngs-modulus 463GPa --poisson-ratio 0.2
  truearea law psd.csv --model bem --quantity asperity-pressure --dialect csv \\
      --separation-range 0.5:3 --material 100Cr6 --on 100Cr6")]
    Law(Box<LawArgs>),
    /// Contact area by boundary elements: of a map as scanned, or of random surfaces of a spectrum
    #[command(after_help = "\
Columns: nominal_pressure_pa, area_fraction (share of the points in contact),
area_fraction_corrected (less the staircase around each spot),
area_fraction_extrapolated (what a finer grid would show), standard_error,
plastic_area_fraction, mean_gap_m, mean_plastic_depth_m, largest_pressure_pa,
stiffness_pa_per_m, iterations, residual, plastic_area_fraction_corrected,
open_along_x and open_along_y (share of the surfaces that points not in contact
lead across, from edge to edge, with --flow as the fluid meets the edges); a row
per load, the mean of all surfaces. With --per-realisation a row for each
surface, and the column realisation behind the first. --flow adds flow_factor_x,
flow_factor_y, their standard deviations over the surfaces (_sd), their errors
by the spacing of the points (_error), and flow_residual.

A map is pressed as scanned, less the trend that `psd` subtracts. Of a spectrum
as many surfaces are made as --realisations asks for, the same ones for a seed
on every grid; which band of the spectrum they show is said.

Examples:
  truearea bem map.nc --pressure 1MPa --pressure 10MPa \\
      --youngs-modulus 463GPa --poisson-ratio 0.2 --saturation 3GPa
  truearea bem psd.csv --shortest 100nm --pressures 1MPa:1GPa:7 \\
      --youngs-modulus 463GPa --poisson-ratio 0.2 --figure area.svg")]
    Bem(Box<BemArgs>),
    /// Flow through a gap, point by point: flow factors along x and along y
    #[command(after_help = "\
Solves div(g^3 grad p) = 0 (Reynolds) with the gap g of every point. Columns:
flow_factor_x, flow_factor_y (the flow over that of a parallel slot of the mean
gap; 0 where no path leads through), their errors of the spacing of the points
(flow_factor_x_error, flow_factor_y_error), mean_gap_m, closed_fraction (share
of the points in contact), open_along_x and open_along_y (1 or 0), residual,
iterations. A fluid of viscosity eta flows at flow_factor mean_gap^3/(12 eta)
per width and pressure gradient.

Examples:
  truearea bem psd.csv --pressure 10MPa --youngs-modulus 463GPa \\
      --poisson-ratio 0.2 --fields fields
  truearea flow fields/load-1-surface-1.nc --figure flow.png
  truearea flow gap.npy --unit m --size 1mm --edges reservoirs")]
    Flow(FlowArgs),
    /// List the channels of heights in instrument files, one row each
    #[command(after_help = "\
Columns: file, format, channel, points_x, points_y, size_x_m, size_y_m,
rms_height_m (about the mean of the points that are there), peak_to_valley_m,
gaps (points without a height), rms_slope_x, rms_slope_y (of neighbouring
points), note. A line has points_y 1 and neither size nor slope along y. The
size of evenly spaced points is points times spacing, of others their extent.

Examples:
  truearea scan *.sur
  truearea scan map.gwy --all-channels
  truearea scan map.opd --figure heights.png")]
    Scan(ScanArgs),
    /// Roughness parameters of profiles (ISO 21920-2) and maps (ISO 25178-2)
    #[command(after_help = "\
Ra to Rz, Rdq, Rmr and the Rk family of profiles; Sa to Sz, Sdq, Sdr, Sal, Str,
Smr, the Sk family and volumes of maps. The least-squares line or plane is
subtracted first, then --filter; points without a height are left out.

Columns: file, channel, parameter, value, unit (um, 1, %, um3/um2), convention
(how points are joined, where the standards leave it open). A value that the
scan does not determine is empty. A terminal shows them with three digits.

Examples:
  truearea roughness trace.txt:unit=um --filter 0.8mm
  truearea roughness map.sur --form second-order --convention all")]
    Roughness(RoughnessArgs),
    /// The power spectrum of scans, each in the band that shows the surface, and their composite
    #[command(after_help = "\
Reads the files of some thirty kinds of instruments, text, and containers of
contact.engineering; `truearea scan FILE` tells what is in one. Unit and size
come from the file, else from a meta.yml or index.json beside it that names it,
else from --unit and --size. Options of a single file follow it after a colon.

Columns: wavelength_m, wavevector_rad_per_m, C1D_m3, C1D_se_m3 (standard error
where several scans share a bin), measurements; a row per bin from long to
short. Every other command takes this table. Which wavelengths of each scan are
used, and what is doubtful, is said on standard error. A sum of two faces has
the columns C1D_face_1_m3 and C1D_face_2_m3 besides.

Examples:
  truearea psd map.001 trace.asc:unit=nm,shortest=5nm stylus.txt --out psd.csv
  truearea psd --list scans.csv --out psd.csv
  truearea psd ring.txt:unit=um face.txt:unit=um --sum --out both.csv
  truearea psd map.001 --areal --out ciso.csv")]
    Psd(ScansArgs),
    /// Fit a self-affine spectrum: Hurst exponent and roll-off
    #[command(after_help = "\
Columns: hurst_exponent, hurst_exponent_se, rolloff_wavelength_m,
rolloff_wavelength_se_m, plateau_m3, plateau_se_m3, rms_log10_residual,
points; one row. Where no roll-off can be identified its cells are empty and
the fit is a power law.

Example:
  truearea fit psd.csv --from 100um --to 100nm")]
    Fit(FitArgs),
    /// Answer the whole question: from scans or a spectrum to a report with a verdict
    #[command(after_help = "\
Runs every model that applies, presses the surface by boundary elements, and
says how much touches, how sure that is, and what to measure next. The folder
holds report.html, scene.toml (which repeats it), summary.txt, answer.json,
figures and data.

All files in front are scans of one rough face; the other is smooth unless its
own scans follow --counterface-scans, or its spectrum --counterface-psd.

Examples:
  truearea report ring.txt:unit=um --material 100Cr6 --on 100Cr6 \\
      --pressure 10MPa --seal
  truearea report ring.txt:unit=um --counterface-scans face.txt:unit=um \\
      --material 100Cr6 --on 100Cr6 --pressure 10MPa --seal
  truearea report builtin:uncd-measured --material diamond --pressure 5.4MPa")]
    Report(Box<ReportArgs>),
    /// Run a scene: tables, figures and a summary
    #[command(after_help = "\
Writes one table per curve, one table and one SVG per figure, a report and
answer.json, and prints a summary of at most twelve lines; --verbose adds the
area of every model and all notes. Options given here count more than the scene's own.

Example:
  truearea scene uncd-measured > uncd.toml
  truearea run uncd.toml --out results")]
    Run(RunArgs),
    /// Draw the figures of a scene for publication: SVG, PNG or PDF in the width of a column
    #[command(after_help = "\
Computes the scene again, areas with boundary elements, and writes a file per
figure and format, named after the figure. No other file is touched.

Examples:
  truearea figure flange-report --width 85mm --picture pdf,png --no-title
  truearea figure uncd.toml --only figure-6 --models persson,elastic \\
      --loads '1e-3 H' --font-size 9 --out paper")]
    Figure(FigureFilesArgs),
    /// Print a commented scene to start from
    #[command(after_help = "\
Example:
  truearea scene new > my-scene.toml")]
    Scene {
        /// Template to print: an empty one to fill in, or UNCD
        #[arg(value_parser = one_of::<Template, _>(Template::ALL))]
        template: Template,
    },
    /// Print what a shell needs to complete commands and options
    #[command(after_help = "\
Examples:
  truearea completions bash --output ~/.local/share/bash-completion/completions/truearea
  truearea completions fish --output ~/.config/fish/completions/truearea.fish
  source <(truearea completions zsh)")]
    Completions {
        /// Shell to complete for
        shell: Shell,
    },
    /// Write manual pages: one for the program, one for each command
    #[command(after_help = "\
Examples:
  truearea man --out ~/.local/share/man/man1
  man -l man/truearea-stacked.1")]
    Man(ManArgs),
}

#[derive(Debug, ClapArgs)]
pub(crate) struct ManArgs {
    /// The folder for the pages, made where absent
    #[arg(long, value_name = "DIR", default_value = "man")]
    pub out: PathBuf,
}

#[derive(Debug, ClapArgs)]
#[command(after_help = "\
Example:
  truearea asperity sphere --input spheres.csv --output spheres.csv")]
pub(crate) struct AsperityArgs {
    #[command(subcommand)]
    pub law: AsperityLaw,
}

#[derive(Debug, Subcommand)]
pub(crate) enum AsperityLaw {
    /// A sphere at an interference: Hertz, and Jackson & Green
    #[command(after_help = "\
Input columns: youngs_modulus_pa, poisson_ratio, yield_strength_pa (or, three
times that, indentation_hardness_pa), radius_m, interference_m. Results: hertz_force_n, hertz_area_m2, jackson_green_force_n,
jackson_green_area_m2, jackson_green_force_cosine_hardness_n. What every row has may be
an option in place of a column.

Example:
  truearea asperity sphere --input spheres.csv")]
    Sphere(TableArgs),
    /// A sinusoid at a mean pressure: elastic, and elastic-plastic
    #[command(after_help = "\
Input columns: youngs_modulus_pa, poisson_ratio, yield_strength_pa (or, three
times that, indentation_hardness_pa), aspect_ratio, pressure_pa. Results: complete_contact_pressure_elastic_pa,
area_fraction_elastic, critical_aspect_ratio, complete_contact_pressure_ep_pa,
area_fraction_ep, mean_gap_over_amplitude. What every row has may be
an option in place of a column.

Example:
  truearea asperity sinusoid --input sinusoids.csv")]
    Sinusoid(TableArgs),
    /// A sinusoid pressed to an interference
    #[command(after_help = "\
Input columns: youngs_modulus_pa, poisson_ratio, yield_strength_pa (or, three
times that, indentation_hardness_pa), wavelength_m, aspect_ratio, interference_m. Results: pressure_elastic_pa,
area_fraction_elastic, pressure_ep_pa, area_fraction_ep. What every row has may be
an option in place of a column.

Example:
  truearea asperity sinusoid-interference --input sinusoids.csv --output sinusoids.csv")]
    SinusoidInterference(TableArgs),
}

#[derive(Debug, Clone, ClapArgs)]
pub(crate) struct TableArgs {
    /// The table to extend, CSV or JSON: a path, or - for standard input
    #[arg(long, value_name = "PATH", default_value = "-", value_parser = parse_place)]
    pub input: Place,
    #[command(flatten)]
    pub bodies: BodiesArgs,
}

#[derive(Debug, ClapArgs)]
pub(crate) struct MomentsArgs {
    #[command(flatten)]
    pub psd: PsdArgs,
    #[command(flatten)]
    pub sampling: SamplingArgs,
    #[command(flatten)]
    pub normalisation: NormalisationArg,
    #[command(flatten)]
    pub figure: FigureArg,
}

#[derive(Debug, ClapArgs)]
pub(crate) struct AmplitudeArgs {
    #[command(flatten)]
    pub psd: PsdArgs,
    #[command(flatten)]
    pub sampling: SamplingArgs,
    #[command(flatten)]
    pub amplitude: AmplitudeArg,
    #[command(flatten)]
    pub figure: FigureArg,
}

#[derive(Debug, ClapArgs)]
#[command(group = clap::ArgGroup::new("pressed").required(true).multiple(true).args(["pressures", "pressure_ranges"]))]
pub(crate) struct StackedArgs {
    #[command(flatten)]
    pub psd: PsdArgs,
    /// Deformation model of every scale
    #[arg(long, value_parser = model_of(Framework::Stacked))]
    pub model: &'static ModelEntry,
    #[command(flatten)]
    pub loads: PressureArgs,
    #[command(flatten)]
    pub material: MaterialArgs,
    #[command(flatten)]
    pub sampling: SamplingArgs,
    #[command(flatten)]
    pub amplitude: AmplitudeArg,
    /// Area of a scale that yields: blended, the published fit limited to 1, which is the default, or elastic-shape, the
    /// elastic area at p/p*_ep
    #[arg(long, value_parser = one_of::<YieldingAreaLaw, _>(YieldingAreaLaw::ALL))]
    pub elastic_plastic_area: Option<YieldingAreaLaw>,
    /// Append the columns pressure_in_pa and yield_strength_pa
    #[arg(long)]
    pub details: bool,
    #[command(flatten)]
    pub figure: FigureArg,
}

#[derive(Debug, ClapArgs)]
#[command(group = clap::ArgGroup::new("source").required(true).args(["psd", "input"]))]
#[command(group = clap::ArgGroup::new("pressed").multiple(true).args(["pressures", "pressure_ranges", "separations"]))]
pub(crate) struct StatisticalArgs {
    /// The power spectrum: a file, - for standard input, builtin:uncd-measured, builtin:uncd-reconstructed or
    /// builtin:contact-challenge; or scans of one face, each perhaps with options of its own: FILE:unit=um
    #[arg(requires = "model", requires = "pressed", value_name = "PSD")]
    pub psd: Vec<ScanRequest>,
    #[command(flatten)]
    pub reading: ReadingArgs,
    /// A table of populations instead, CSV or JSON: a path, or - for standard input
    #[arg(long, value_name = "PATH", value_parser = parse_place, conflicts_with_all = ["normalisation", "pressure_ranges", "figure"], conflicts_with_all = LayerArgs::OPTIONS, conflicts_with_all = ReadingArgs::OPTIONS, conflicts_with_all = CounterfaceSurfaceArgs::OPTIONS, conflicts_with_all = SamplingArgs::OPTIONS)]
    pub input: Option<Place>,
    /// Column of the table to use as input where both are filled; the other is recomputed
    #[arg(long, value_parser = one_of::<GivenColumn, _>(GivenColumn::ALL), requires = "input", conflicts_with = "psd")]
    pub given: Option<GivenColumn>,
    /// The law of one asperity
    #[arg(long, value_parser = model_of(Framework::Statistical))]
    pub model: Option<&'static ModelEntry>,
    #[command(flatten)]
    pub loads: PressureArgs,
    /// Separation from the mean of the asperity heights, of either sign; repeatable
    #[arg(long = "separation", value_name = "L", allow_hyphen_values = true)]
    pub separations: Vec<SignedLength>,
    #[command(flatten)]
    pub material: MaterialArgs,
    /// Relative tolerance of pressure and area, in (0, 0.01]; a looser one costs less
    #[arg(long, value_name = "T", default_value = "1e-12", value_parser = parse_tolerance)]
    pub tolerance: Tolerance,
    /// Relation between the pressure on an elastic sinusoid (elastic-sine) and its interference: a fit, which is the
    /// default, or boundary-element solutions
    #[arg(long, value_parser = one_of::<InterferenceLaw, _>(InterferenceLaw::ALL))]
    pub interference_law: Option<InterferenceLaw>,
    /// Quantities of a flattened sphere (ep-sphere) that no longer grow: area-and-force, from a contact radius of 0.41 R
    /// on, which is the default, or area, from R on
    #[arg(long, value_parser = one_of::<Flattening, _>(Flattening::ALL))]
    pub flattening: Option<Flattening>,
    /// Distribution of the heights of elastic spheres (hertz): gaussian, which is the default, or exponential, of standard
    /// deviation sigma_s from the separation 0 on
    #[arg(long, value_parser = one_of::<SummitHeights, _>(SummitHeights::ALL))]
    pub summit_heights: Option<SummitHeights>,
    #[command(flatten)]
    pub sampling: SamplingArgs,
    #[command(flatten)]
    pub normalisation: NormalisationArg,
    #[command(flatten)]
    pub hardness: HardnessFormulaArg,
    /// Append error_estimate, evaluations, out_of_range_load_share, ln_pressure_pa, ln_area_fraction,
    /// flattened_share, contacts_per_m2 (number of contacts per nominal area) and, with a hardness, plasticity_index
    /// ((E*/H) sqrt(sigma_s/R))
    #[arg(long)]
    pub details: bool,
    #[command(flatten)]
    pub figure: FigureArg,
}

impl StatisticalArgs {
    /// The options of the model; its strength grows as soon as a length is given.
    pub fn options(&self) -> ModelOptions {
        ModelOptions {
            strain_gradient: self.material.strain_gradient_length.is_some(),
            hardness: self.hardness.hardness_formula,
            interference_law: self.interference_law,
            flattening: self.flattening,
            summit_heights: self.summit_heights,
            ..ModelOptions::default()
        }
    }
}

#[derive(Debug, ClapArgs)]
pub(crate) struct FitArgs {
    #[command(flatten)]
    pub psd: PsdArgs,
    #[command(flatten)]
    pub sampling: SamplingArgs,
    /// The longest wavelength to fit; the spectrum's own where not given
    #[arg(long, value_name = "L", allow_hyphen_values = true)]
    pub from: Option<Length>,
    /// The shortest wavelength to fit; given both, either may come first
    #[arg(long, value_name = "L", allow_hyphen_values = true)]
    pub to: Option<Length>,
}

#[derive(Debug, ClapArgs)]
pub(crate) struct RunArgs {
    /// The scene file, or - for standard input
    #[arg(value_name = "SCENE", value_parser = parse_place)]
    pub scene: Place,
    /// The folder for tables and figures, made where absent; else SCENE-results in the current folder
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Print every note and number that the summary leaves out
    #[arg(short, long)]
    pub verbose: bool,
    /// Leave out report.html, its tables, and the sensitivities, which only it needs
    #[arg(long)]
    pub no_report: bool,
    /// Skip the comparison with boundary elements, even if the scene asks for it
    #[arg(long)]
    pub no_judge: bool,
    /// Skip the uncertainty analysis, even if the scene asks for it
    #[arg(long)]
    pub no_uncertainty: bool,
    /// Print the steps that the run would take, and compute nothing
    #[arg(long, conflicts_with_all = ["no_report", "out", "verbose", "no_judge", "counterface_youngs_modulus", "counterface_poisson_ratio"])]
    pub dry_run: bool,
    #[command(flatten)]
    pub sampling: SamplingArgs,
    #[command(flatten)]
    pub normalisation: NormalisationArg,
    #[command(flatten)]
    pub amplitude: AmplitudeArg,
    #[command(flatten)]
    pub hardness: HardnessFormulaArg,
    #[command(flatten)]
    pub strength_cap: StrengthCapArg,
    #[command(flatten)]
    pub counterface: CounterfaceArgs,
}
