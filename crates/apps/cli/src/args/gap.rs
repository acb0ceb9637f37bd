//! Options of `gap`, `law` and `tangential`.

use clap::Args as ClapArgs;
use clap::builder::TypedValueParser;
use contact_law::{ContactLaw, Dialect, Heading, UnitSystem};
use persson::EnergyFactor;
use persson::variance::Band;
use questions::{GapModel, LawForm};
use stat_contact::InterferenceLaw;
use study::models::{self, ModelEntry, ModelOptions};
use study::plan::Tolerance;
use units::Pressure;

use super::bem::RandomArgs;
use super::parsers::{ModelName, one_of, parse_labelled_pressure, parse_tolerance};
use super::{HardnessFormulaArg, MaterialArgs, NormalisationArg, PressureArgs, ReadingArgs, SamplingArgs};

/// Model of the gap: a law of asperities, Persson's theory, or boundary elements if there is none.
#[derive(Debug, Clone, Copy)]
pub(crate) struct GapModelArg(pub Option<&'static ModelEntry>);

/// The name of boundary elements among models.
const ELEMENTS: &str = "bem";

fn entry(name: &str) -> Result<&'static ModelEntry, &'static str> {
    models::with_gaps().find(|entry| entry.name == name).ok_or("an unknown model")
}

fn gap_model() -> impl TypedValueParser<Value = GapModelArg> {
    let names = models::with_gaps().map(|entry| entry.name).chain([ELEMENTS]);
    ModelName(names.collect()).try_map(|name| match name.as_str() {
        ELEMENTS => Ok(GapModelArg(None)),
        name => entry(name).map(|entry| GapModelArg(Some(entry))),
    })
}

fn law_model() -> impl TypedValueParser<Value = &'static ModelEntry> {
    ModelName(models::with_gaps().map(|entry| entry.name).collect()).try_map(|name| entry(&name))
}

/// Options of the models that both commands have.
#[derive(Debug, ClapArgs)]
pub(crate) struct GapChoiceArgs {
    /// Elastic energy factor of Persson's theory, in (0, 1], 0.45 where not given, or the form fitted to boundary elements
    #[arg(long, value_name = "G|fitted", allow_hyphen_values = true)]
    pub gamma: Option<EnergyFactor>,
    /// Spectrum cut off at a wavelength in Persson's theory: 2d, that of the surface, which is the default and nearer to
    /// boundary elements, or 1d, that of profiles
    #[arg(long, value_parser = one_of::<Band, _>(Band::ALL))]
    pub band: Option<Band>,
    /// Relation between the pressure on an elastic sinusoid (elastic-sine) and its interference: a fit, which is the
    /// default, or boundary-element solutions
    #[arg(long, value_parser = one_of::<InterferenceLaw, _>(InterferenceLaw::ALL))]
    pub interference_law: Option<InterferenceLaw>,
    #[command(flatten)]
    pub hardness: HardnessFormulaArg,
    #[command(flatten)]
    pub normalisation: NormalisationArg,
    #[command(flatten)]
    pub material: MaterialArgs,
    #[command(flatten)]
    pub sampling: SamplingArgs,
}

impl GapChoiceArgs {
    /// Model, material and spectrum as questions take them.
    pub fn input(&self, model: Option<&'static ModelEntry>) -> GapModel {
        let material = self.material.input();
        GapModel {
            model,
            options: ModelOptions {
                strain_gradient: model.is_some_and(|entry| material.strain_gradient_in(entry)),
                hardness: self.hardness.hardness_formula,
                interference_law: self.interference_law,
                band: self.band,
                gamma: self.gamma,
                ..ModelOptions::default()
            },
            material,
            sampling: self.sampling.input(),
            normalisation: self.normalisation.normalisation,
            tolerance: None,
        }
    }
}

#[derive(Debug, ClapArgs)]
#[command(group = clap::ArgGroup::new("pressed").required(true).multiple(true).args(["pressures", "pressure_ranges"]))]
pub(crate) struct GapArgs {
    /// The power spectrum: a file, - for standard input, or builtin:uncd-measured,
    /// builtin:uncd-reconstructed or builtin:contact-challenge
    pub psd: String,
    #[command(flatten)]
    pub reading: ReadingArgs,
    /// Model of the gap: Persson's theory, a law of asperities, or boundary elements
    #[arg(long, value_parser = gap_model())]
    pub model: GapModelArg,
    #[command(flatten)]
    pub loads: PressureArgs,
    #[command(flatten)]
    pub choices: GapChoiceArgs,
    /// Relative tolerance of statistical states, in (0, 0.01]; 1e-12 where not given, and a looser one costs less
    #[arg(long, value_name = "T", value_parser = parse_tolerance)]
    pub tolerance: Option<Tolerance>,
    #[command(flatten)]
    pub random: RandomArgs,
}

#[derive(Debug, ClapArgs)]
#[command(group = clap::ArgGroup::new("pressed").required(true).multiple(true).args(["pressures", "pressure_ranges"]))]
pub(crate) struct TangentialArgs {
    /// The power spectrum: a file, - for standard input, or builtin:uncd-measured,
    /// builtin:uncd-reconstructed or builtin:contact-challenge
    pub psd: String,
    #[command(flatten)]
    pub reading: ReadingArgs,
    /// Elastic model of the normal law: Persson's theory, a law of asperities, or boundary elements
    #[arg(long, value_parser = gap_model())]
    pub model: GapModelArg,
    /// Coefficient of friction at every point
    #[arg(long, value_name = "F", allow_hyphen_values = true)]
    pub friction: f64,
    /// Tangential stress on the nominal area; give it several times for several. Shares of friction times pressure from 1 to
    /// 99 % where not given
    #[arg(long = "tangential-stress", value_name = "Q", value_parser = parse_labelled_pressure, allow_hyphen_values = true)]
    pub stresses: Vec<(Pressure, String)>,
    #[command(flatten)]
    pub loads: PressureArgs,
    #[command(flatten)]
    pub choices: GapChoiceArgs,
    #[command(flatten)]
    pub random: RandomArgs,
}

#[derive(Debug, ClapArgs)]
pub(crate) struct LawArgs {
    /// The power spectrum: a file, - for standard input, or builtin:uncd-measured,
    /// builtin:uncd-reconstructed or builtin:contact-challenge
    pub psd: String,
    #[command(flatten)]
    pub reading: ReadingArgs,
    /// Model behind the law: Persson's theory, or a law of asperities
    #[arg(long, value_parser = law_model())]
    pub model: &'static ModelEntry,
    /// Finite element program that reads the law
    #[arg(long, value_parser = one_of::<Dialect, _>(Dialect::ALL))]
    pub dialect: Dialect,
    /// The units of the finite element model
    #[arg(long, value_parser = one_of::<UnitSystem, _>(UnitSystem::ALL), default_value = "SI")]
    pub units: UnitSystem,
    /// The least and the largest nominal pressure of interest
    #[arg(long, value_name = "FROM:TO", value_parser = parse_range, allow_hyphen_values = true)]
    pub pressure_range: [Pressure; 2],
    /// The largest relative error of the pressure on the straight lines between the rows
    #[arg(long, value_name = "E", default_value_t = ContactLaw::TOLERANCE)]
    pub error: f64,
    /// Form of the law for calculix: a table, or the exponential law of light loads that Persson's theory has
    #[arg(long, value_parser = one_of::<LawForm, _>(LawForm::ALL), default_value = "table")]
    pub form: LawForm,
    /// The name of the surface interaction
    #[arg(long, value_name = "NAME", default_value = Heading::NAME, value_parser = parse_name)]
    pub name: String,
    #[command(flatten)]
    pub choices: GapChoiceArgs,
}

fn parse_range(text: &str) -> Result<[Pressure; 2], String> {
    let (from, to) = text
        .split_once(':')
        .ok_or_else(|| format!("'{text}' is not a range of pressures; write FROM:TO, as in '1kPa:1GPa'"))?;
    let end = |text: &str| text.trim().parse::<Pressure>().map_err(|error| error.to_string());
    Ok([end(from)?, end(to)?])
}

fn parse_name(text: &str) -> Result<String, String> {
    Heading::checked_name(text).map(str::to_owned).map_err(|error| error.to_string())
}
