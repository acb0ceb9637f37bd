//! Options of `gap`, `law` and `tangential`.

mod lubrication;

use clap::Args as ClapArgs;
use clap::builder::TypedValueParser;
use interface::finite_elements::{ContactLaw, Dialect, Heading, UnitSystem};
use persson::Band;
use persson::EnergyFactor;
use questions::{
    ElementsLawQuestion, GapModel, GasInput, LawForm, LawQuantity, LawQuestion, LawTableQuestion, LoadInput,
    NamedGas, PlasticCorrelation, TransportInput,
};
use stat_contact::{Flattening, InterferenceLaw};
use study::models::{self, ModelEntry, ModelOptions};
use study::plan::Tolerance;
use units::{Length, Pressure, Resistivity, Temperature, ThermalConductivity};

use self::lubrication::{LawQuantityArg, LubricationArgs, law_quantity};
use super::bem::RandomArgs;
use super::parsers::{ModelName, one_of, parse_tolerance};
use super::{HardnessFormulaArg, MaterialArgs, NormalisationArg, PressureArgs, PsdArgs, SamplingArgs};
use crate::picture::Picture;

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

/// Model behind a law: that of a gap, boundary elements, or a correlation of conductances.
#[derive(Debug, Clone, Copy)]
pub(crate) enum LawModelArg {
    Gap(&'static ModelEntry),
    Elements,
    Correlation(PlasticCorrelation),
}

fn law_model() -> impl TypedValueParser<Value = LawModelArg> {
    let correlations = PlasticCorrelation::ALL.iter().map(|correlation| correlation.name());
    let names = models::with_gaps().map(|entry| entry.name).chain([ELEMENTS]).chain(correlations);
    ModelName(names.collect()).try_map(|name| match name.parse() {
        Ok(correlation) => Ok(LawModelArg::Correlation(correlation)),
        Err(_) if name == ELEMENTS => Ok(LawModelArg::Elements),
        Err(_) => entry(&name).map(LawModelArg::Gap),
    })
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
    /// Quantities of a flattened sphere (ep-sphere) that no longer grow: area-and-force, from a contact radius of 0.41 R
    /// on, which is the default, or area, from R on
    #[arg(long, value_parser = one_of::<Flattening, _>(Flattening::ALL))]
    pub flattening: Option<Flattening>,
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
                strain_gradient: material.strain_gradient_length_m.is_some(),
                hardness: self.hardness.hardness_formula,
                interference_law: self.interference_law,
                flattening: self.flattening,
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
    #[command(flatten)]
    pub psd: PsdArgs,
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
    #[command(flatten)]
    pub psd: PsdArgs,
    /// Elastic model of the normal law: Persson's theory, a law of asperities, or boundary elements
    #[arg(long, value_parser = gap_model())]
    pub model: GapModelArg,
    /// Coefficient of friction at every point
    #[arg(long, value_name = "F", allow_hyphen_values = true)]
    pub friction: f64,
    /// Tangential stress on the nominal area; give it several times for several. Shares of friction times pressure from 1 to
    /// 99 % where not given
    #[arg(long = "tangential-stress", value_name = "Q", allow_hyphen_values = true)]
    pub stresses: Vec<LoadInput>,
    #[command(flatten)]
    pub loads: PressureArgs,
    #[command(flatten)]
    pub choices: GapChoiceArgs,
    #[command(flatten)]
    pub figure: ShearFigureArg,
    #[command(flatten)]
    pub random: RandomArgs,
}

/// A picture of the loops of tangential loads.
#[derive(Debug, Clone, ClapArgs)]
pub(crate) struct ShearFigureArg {
    /// Draw the loop of each load: stress over displacement on first loading, on unloading and on reloading
    #[arg(long, value_name = "FILE.svg|FILE.png|FILE.pdf")]
    pub figure: Option<Picture>,
}

#[derive(Debug, ClapArgs)]
#[command(mut_arg("psd", |psd| psd.required(false).required_unless_present("summit_density")))]
pub(crate) struct LawArgs {
    #[command(flatten)]
    pub psd: PsdArgs,
    /// Model behind the law: Persson's theory, a law of asperities, or boundary elements, which yield; for conductances also a
    /// correlation for flowed peaks
    #[arg(long, value_parser = law_model(), required_unless_present = "summit_density")]
    pub model: Option<LawModelArg>,
    /// Quantity of the law: pressure over overclosure, the conductance of heat or current over pressure, or pressure and area over
    /// the separation of two faces for mixed lubrication
    #[arg(long, value_parser = law_quantity(), default_value = LawQuantity::Pressure.name())]
    pub quantity: LawQuantityArg,
    /// Finite element program that reads the law
    #[arg(long, value_parser = one_of::<Dialect, _>(Dialect::ALL))]
    pub dialect: Dialect,
    /// The units of the finite element model
    #[arg(long, value_parser = one_of::<UnitSystem, _>(UnitSystem::ALL), default_value = "SI")]
    pub units: UnitSystem,
    /// The least and the largest nominal pressure of interest
    #[arg(long, value_name = "FROM:TO", value_parser = parse_range, allow_hyphen_values = true, required_unless_present = "separation_range")]
    pub pressure_range: Option<[Pressure; 2]>,
    /// The largest relative error of the pressure, or of the conductance, on the straight lines between the rows
    #[arg(long, value_name = "E", default_value_t = ContactLaw::TOLERANCE)]
    pub error: f64,
    /// Form of the law for calculix: a table, which is the default, or the exponential law of light loads that Persson's
    /// theory has
    #[arg(long, value_parser = one_of::<LawForm, _>(LawForm::ALL))]
    pub form: Option<LawForm>,
    /// The name of the surface interaction, ROUGH where not given
    #[arg(long, value_name = "NAME", value_parser = parse_name)]
    pub name: Option<String>,
    #[command(flatten)]
    pub transport: TransportArgs,
    #[command(flatten)]
    pub gas: GasArgs,
    #[command(flatten)]
    pub choices: GapChoiceArgs,
    #[command(flatten)]
    pub lubrication: LubricationArgs,
    #[command(flatten)]
    pub random: RandomArgs,
}

/// Conductivities and resistivities of the bodies.
#[derive(Debug, ClapArgs)]
pub(crate) struct TransportArgs {
    /// Thermal conductivity of the rough body, for --quantity heat; that of the table of materials where not given
    #[arg(long, value_name = "K", allow_hyphen_values = true)]
    pub thermal_conductivity: Option<ThermalConductivity>,
    /// Thermal conductivity of the counterface
    #[arg(long, value_name = "K", allow_hyphen_values = true)]
    pub counterface_thermal_conductivity: Option<ThermalConductivity>,
    /// Electrical resistivity of the rough body, for --quantity current; that of the table of materials where not given
    #[arg(long, value_name = "RHO", allow_hyphen_values = true)]
    pub resistivity: Option<Resistivity>,
    /// Electrical resistivity of the counterface
    #[arg(long, value_name = "RHO", allow_hyphen_values = true)]
    pub counterface_resistivity: Option<Resistivity>,
}

/// Gas in the gaps.
#[derive(Debug, ClapArgs)]
pub(crate) struct GasArgs {
    /// Gas in the gaps, for --quantity heat: air, nitrogen, helium, argon or hydrogen; vacuum where no gas is given
    #[arg(long, value_name = "NAME")]
    pub gas: Option<NamedGas>,
    /// Temperature of that gas in kelvins, as in 400K; 288.15K where not given
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    pub gas_temperature: Option<Temperature>,
    /// Pressure of that gas, 1 atm where not given
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pub gas_pressure: Option<Pressure>,
    /// Thermal conductivity of any other gas, with --gas-parameter
    #[arg(long, value_name = "K", allow_hyphen_values = true)]
    pub gas_conductivity: Option<ThermalConductivity>,
    /// Gas parameter M, which lengthens every gap by the temperature jumps at its walls
    #[arg(long, value_name = "L", allow_hyphen_values = true)]
    pub gas_parameter: Option<Length>,
}

impl TransportArgs {
    fn input(&self) -> TransportInput {
        let w_per_m_k = |given: Option<ThermalConductivity>| given.map(|conductivity| conductivity.w_per_m_k);
        let ohm_m = |given: Option<Resistivity>| given.map(|resistivity| resistivity.ohm_m);
        TransportInput {
            thermal_conductivity_w_per_m_k: w_per_m_k(self.thermal_conductivity),
            counterface_thermal_conductivity_w_per_m_k: w_per_m_k(self.counterface_thermal_conductivity),
            resistivity_ohm_m: ohm_m(self.resistivity),
            counterface_resistivity_ohm_m: ohm_m(self.counterface_resistivity),
        }
    }
}

impl GasArgs {
    fn input(&self) -> GasInput {
        GasInput {
            name: self.gas,
            temperature_k: self.gas_temperature.map(|temperature| temperature.k),
            pressure: self.gas_pressure,
            conductivity_w_per_m_k: self.gas_conductivity.map(|conductivity| conductivity.w_per_m_k),
            parameter_m: self.gas_parameter.map(|length| length.m),
        }
    }
}

impl LawArgs {
    /// The question of boundary elements, if they are the model.
    pub fn elements(&self) -> Option<ElementsLawQuestion> {
        let is_elements = matches!(self.model, Some(LawModelArg::Elements));
        is_elements.then(|| ElementsLawQuestion {
            table: self.question(),
            random: self.random.input(),
            error: Some(self.error),
        })
    }

    /// The question of a table for finite elements that these options ask.
    pub fn question(&self) -> LawTableQuestion {
        let (model, correlation) = match self.model {
            Some(LawModelArg::Gap(entry)) => (Some(entry), None),
            Some(LawModelArg::Correlation(correlation)) => (None, Some(correlation)),
            Some(LawModelArg::Elements) | None => (None, None),
        };
        let LawQuestion { from, to, .. } = LawQuestion::default();
        let [from, to] = self.pressure_range.unwrap_or([from, to]);
        let named = &self.choices.material.bodies.named;
        let question = LawTableQuestion {
            law: LawQuestion { by: self.choices.input(model), from, to },
            quantity: self.quantity.0.unwrap_or_default(),
            correlation,
            transport: self.transport.input(),
            gas: self.gas.input(),
            form: self.form,
            name: self.name.clone(),
            dialect: Some(self.dialect),
        };
        question.filled_from(named.material.as_ref(), named.on.as_ref())
    }
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
