//! Tables of conductance against pressure for finite elements: heat by spots and gas, and current.

use interface::conductance::{
    Conductivities, CutSurface, ELECTRON_MEAN_FREE_PATH_M, PlasticCorrelation, PressureRatio,
    RelativeStiffness, Resistivities,
};
use interface::finite_elements::{ConductancePoint, ConductanceTable, Dialect, Flow, SamplingError};
use interface::gas::{GapGas, plastic_separation_m};
use numerics::parallel::Progress;
use serde::{Deserialize, Serialize};
use spectrum::Normalisation;
use study::body_properties::BodyProperty;
use study::gap_law::{GapError, GapLaw, GapState};
use study::interface::GasInput;
use study::material::Material;
use study::materials::TabledMaterial;
use study::models::{Choice, ModelEntry};
use study::plan::{Needs, Plan, PlanError};
use study::surface::Surface;
use units::display::{length, pressure, three_digits};
use units::{OutOfBounds, Remark, RemarkCode, Resistivity, Spelling, ThermalConductivity, named};

use crate::elements_law::ElementsLaw;
use crate::gap::cautions;
use crate::loads::nominal_pressure;
use crate::option::{first_given, not_of_model};
use crate::{FoundLaw, LawForm, LawQuestion, MaterialInput, QuestionError};

/// Young's modulus \[Pa\] in place of one that is not used: above all hardnesses.
const NEARLY_RIGID_PA: f64 = 1e13;

/// Poisson's ratio of a body of which none is known.
const USUAL_POISSON_RATIO: f64 = 0.3;

/// Stiffness of boundary elements on unloading over that of Persson's elastic theory, on twelve spectra, three surfaces of 768 x 768
/// points each.
const LOW_BY_FLOW: &str = "The contact flows, and this K is elastic. On unloading, which conductance follows, boundary elements have 1.05 \
                           times K where 7 % flows, 1.5 to 2.3 times at 95 % and 5.9 to 7.1 times at 99 %: this conductance is low. The \
                           models persson-plastic and bem have it.";

/// Quantity that a law has over the nominal pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LawQuantity {
    /// Overclosure: the mechanical law.
    #[default]
    Pressure,
    /// Thermal conductance.
    Heat,
    /// Electrical conductance.
    Current,
}

named!(LawQuantity, "quantity", { Pressure => "pressure", Heat => "heat", Current => "current" });

/// Thermal conductivities and electrical resistivities of both bodies.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct TransportInput {
    /// Thermal conductivity of the rough body \[W/(m K)\].
    pub thermal_conductivity_w_per_m_k: Option<f64>,
    /// Thermal conductivity of the counterface \[W/(m K)\].
    pub counterface_thermal_conductivity_w_per_m_k: Option<f64>,
    /// Resistivity of the rough body \[ohm m\].
    pub resistivity_ohm_m: Option<f64>,
    /// Resistivity of the counterface \[ohm m\].
    pub counterface_resistivity_ohm_m: Option<f64>,
}

/// A law between two nominal pressures: pressure against overclosure, or conductance against pressure.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct LawTableQuestion {
    /// Model, material, spectrum and range of pressures; no model with a correlation.
    pub law: LawQuestion,
    /// Quantity of the law.
    pub quantity: LawQuantity,
    /// Correlation for flowed peaks in place of the model, for conductances.
    pub correlation: Option<PlasticCorrelation>,
    /// Conductivities and resistivities, for conductances.
    pub transport: TransportInput,
    /// Gas in the gaps, for heat.
    pub gas: GasInput,
    /// Form of the mechanical law.
    pub form: Option<LawForm>,
    /// Name of the surface interaction of the mechanical law.
    pub name: Option<String>,
    /// Code that reads the law, where it is known.
    #[serde(skip)]
    pub dialect: Option<Dialect>,
}

/// Answer to a [`LawTableQuestion`].
#[derive(Debug)]
pub enum LawAnswer {
    /// The mechanical law.
    Pressure(FoundLaw),
    /// Conductance against pressure.
    Conductance(FoundConductance),
}

/// Conductance of a surface under any load.
#[derive(Debug)]
pub struct FoundConductance {
    /// Flow.
    pub flow: Flow,
    /// Notes for the reader of the table.
    pub notes: Vec<Remark>,
    range_pa: [f64; 2],
    spots: Spots,
    conductivities: Conductivities,
    gas: Option<GapGas>,
}

/// Conductance of the spots that touch.
#[derive(Debug)]
enum Spots {
    /// Barber's analogy with the stiffness of a model.
    Analogy { model: &'static ModelEntry, law: Box<GapLaw>, modulus_pa: f64, flows: bool },
    /// Barber's analogy with the stiffness of boundary elements on unloading.
    Elements { law: Box<ElementsLaw>, modulus_pa: f64 },
    /// A correlation for flowed peaks.
    Correlation { correlation: PlasticCorrelation, surface: CutSurface, hardness_pa: f64, cutoff_m: f64 },
}

impl LawTableQuestion {
    /// Takes the properties that the quantity needs, and that are not given, from the table of materials.
    #[must_use]
    pub fn filled_from(self, rough: Option<&TabledMaterial>, counterface: Option<&TabledMaterial>) -> Self {
        let mut filled = self;
        let transport = &mut filled.transport;
        let conductivity = |body: Option<&TabledMaterial>| {
            let tabled: Option<ThermalConductivity> = body?.quantity(BodyProperty::ThermalConductivity);
            tabled.map(|conductivity| conductivity.w_per_m_k)
        };
        let resistivity = |body: Option<&TabledMaterial>| {
            let tabled: Option<Resistivity> = body?.quantity(BodyProperty::Resistivity);
            tabled.map(|resistivity| resistivity.ohm_m)
        };
        let fill = |value: &mut Option<f64>, tabled: Option<f64>| *value = value.or(tabled);
        match filled.quantity {
            LawQuantity::Pressure => {}
            LawQuantity::Heat => {
                fill(&mut transport.thermal_conductivity_w_per_m_k, conductivity(rough));
                fill(&mut transport.counterface_thermal_conductivity_w_per_m_k, conductivity(counterface));
            }
            LawQuantity::Current => {
                fill(&mut transport.resistivity_ohm_m, resistivity(rough));
                fill(&mut transport.counterface_resistivity_ohm_m, resistivity(counterface));
            }
        }
        filled
    }

    /// Options that tables of other quantities have, and whether they are given.
    pub(crate) fn options_of_tables(&self) -> impl Iterator<Item = (&'static str, bool)> {
        let of_law = [("form", self.form.is_some()), ("name", self.name.is_some())];
        of_law.into_iter().chain(self.transport.foreign(None)).chain(self.gas.options())
    }

    /// Finds options without effect, and input that contradicts itself or is missing.
    ///
    /// # Errors
    /// [`QuestionError`] with the first of them.
    pub fn check(&self) -> Result<(), QuestionError> {
        let Some(flow) = self.flow() else {
            if self.dialect == Some(Dialect::Csv) {
                let reason = Remark::new(RemarkCode::OtherDialect).with("dialect", Dialect::Csv.name());
                first_given([("name", self.name.is_some())], reason)?;
            }
            if let Some(correlation) = self.correlation {
                return Err(QuestionError::ConductanceOnly(correlation));
            }
            let given = self.transport.foreign(None).chain(self.gas.options());
            first_given(given, self.no_option_of_quantity())?;
            if self.form == Some(LawForm::Exponential) {
                // Light loads are those of the elastic theory.
                let material = &self.law.by.material;
                let of_strength = [
                    ("strain_gradient_length", material.strain_gradient_length_m.is_some()),
                    ("strength_cap", material.strength_cap.is_some()),
                ];
                first_given(of_strength, Remark::new(RemarkCode::Replaced).with("other", "form"))?;
            }
            return self.law.check();
        };
        let of_law = [("form", self.form.is_some()), ("name", self.name.is_some())];
        let of_gas = self.gas.options().into_iter().filter(|_| flow == Flow::Current);
        let given = of_law.into_iter().chain(self.transport.foreign(Some(flow))).chain(of_gas);
        first_given(given, self.no_option_of_quantity())?;
        let material = self.material()?;
        match self.correlation {
            Some(correlation) => {
                self.check_correlation(correlation)?;
                self.law.range_pa(&material)?;
                hardness_pa(&material)?;
            }
            None => self.law.check()?,
        }
        self.transport.conductivities(flow)?;
        self.gas(&material).map(drop)
    }

    /// Finds the law.
    ///
    /// # Errors
    /// [`QuestionError`].
    pub fn answer(&self, surface: &Surface, progress: &dyn Progress) -> Result<LawAnswer, QuestionError> {
        self.check()?;
        let Some(flow) = self.flow() else {
            return self.law.answer(surface, progress).map(LawAnswer::Pressure);
        };
        let material = self.material()?;
        let range_pa = self.law.range_pa(&material)?;
        let (spots, notes) = match self.correlation {
            Some(correlation) => {
                let by = &self.law.by;
                by.sampling.check(surface)?;
                let needs = Needs { moments: Some(Normalisation::Parseval), ..Needs::default() };
                let plan = Plan { psd: &surface.psd, sampling: by.sampling.sampling(), needs };
                let results = plan.compute_observed(progress)?;
                let (moments, _) = results.moments.last().ok_or(GapError::NoRoughness)?;
                let spots = Spots::Correlation {
                    correlation,
                    surface: CutSurface::from_rms_slope(moments.rms_height_m(), moments.rms_slope())
                        .map_err(|_| GapError::NoRoughness)?,
                    hardness_pa: hardness_pa(&material)?,
                    cutoff_m: results.psd.shortest_wavelength_m(),
                };
                (spots, by.notes(&material, surface))
            }
            None => {
                let FoundLaw { model, law, mut notes, flows, .. } = self.law.answer(surface, progress)?;
                let is_elastic = !model.has(Choice::Strength);
                let is_above = |note: &&mut Remark| note.code == RemarkCode::RealAboveHardness && is_elastic;
                for note in notes.iter_mut().filter(is_above) {
                    note.numbers.push(("model", PlasticCorrelation::Yovanovich.name().into()));
                }
                let modulus_pa = material.pair.composite_modulus_pa();
                (Spots::Analogy { model, law: Box::new(law), modulus_pa, flows: flows.is_some() }, notes)
            }
        };
        Ok(LawAnswer::Conductance(FoundConductance {
            flow,
            notes,
            range_pa,
            spots,
            conductivities: self.transport.conductivities(flow)?,
            gas: self.gas(&material)?,
        }))
    }

    /// The conductance of pressed surfaces.
    pub(crate) fn conductance_of_elements(
        &self,
        law: ElementsLaw,
    ) -> Result<FoundConductance, QuestionError> {
        let flow = self.flow().unwrap_or(Flow::Heat);
        let material = self.material()?;
        Ok(FoundConductance {
            flow,
            notes: law.notes.clone(),
            range_pa: law.range_pa,
            spots: Spots::Elements { law: Box::new(law), modulus_pa: material.pair.composite_modulus_pa() },
            conductivities: self.transport.conductivities(flow)?,
            gas: self.gas(&material)?,
        })
    }

    /// The material; a correlation takes half-spaces, and of their elastic constants none but the Poisson's ratios that tell which
    /// body is softer.
    fn material(&self) -> Result<Material, QuestionError> {
        let material = self.law.by.material;
        if self.correlation.is_none() {
            return material.material();
        }
        let rigid = MaterialInput {
            youngs_modulus_pa: material.youngs_modulus_pa.or(Some(NEARLY_RIGID_PA)),
            poisson_ratio: material.poisson_ratio.or(Some(USUAL_POISSON_RATIO)),
            ..material
        };
        rigid.of_half_spaces("correlations of conductances")
    }

    /// The gas, if there is one.
    fn gas(&self, material: &Material) -> Result<Option<GapGas>, QuestionError> {
        let pressure = self.gas.pressure.map(|given| nominal_pressure("gas_pressure", None, given, material));
        Ok(self.gas.resolve(pressure.transpose()?)?)
    }

    fn flow(&self) -> Option<Flow> {
        match self.quantity {
            LawQuantity::Pressure => None,
            LawQuantity::Heat => Some(Flow::Heat),
            LawQuantity::Current => Some(Flow::Current),
        }
    }

    /// The reason that the quantity does not depend on an option.
    fn no_option_of_quantity(&self) -> Remark {
        Remark::new(RemarkCode::OtherQuantity).with("quantity", self.quantity.name())
    }

    /// Refuses options of models, which no correlation has.
    fn check_correlation(&self, correlation: PlasticCorrelation) -> Result<(), QuestionError> {
        let by = &self.law.by;
        let of_models = by.options.given().map(|choice| (choice.key(), true));
        let given = [
            ("normalisation", by.normalisation.is_some()),
            ("tolerance", by.tolerance.is_some()),
            ("strain_gradient_length", by.material.strain_gradient_length_m.is_some()),
            ("strength_cap", by.material.strength_cap.is_some()),
        ];
        Ok(first_given(of_models.chain(given), not_of_model(correlation.name()))?)
    }
}

impl TransportInput {
    /// Properties of both bodies that a flow needs.
    fn properties(&self, flow: Flow) -> [(&'static str, Option<f64>); 2] {
        match flow {
            Flow::Heat => [
                ("thermal_conductivity", self.thermal_conductivity_w_per_m_k),
                ("counterface_thermal_conductivity", self.counterface_thermal_conductivity_w_per_m_k),
            ],
            Flow::Current => [
                ("resistivity", self.resistivity_ohm_m),
                ("counterface_resistivity", self.counterface_resistivity_ohm_m),
            ],
        }
    }

    /// Properties that a flow does not need, or all without one, and whether they are given.
    fn foreign(&self, flow: Option<Flow>) -> impl Iterator<Item = (&'static str, bool)> {
        let others = [Flow::Heat, Flow::Current].into_iter().filter(move |other| flow != Some(*other));
        others.flat_map(|other| self.properties(other)).map(|(option, value)| (option, value.is_some()))
    }

    /// Thermal conductivities, or the electrical ones 1/rho: sigma_g = 2 K/(E* (rho1 + rho2)) is h = k_s K/E* with these.
    fn conductivities(&self, flow: Flow) -> Result<Conductivities, QuestionError> {
        let [own, other] = self.properties(flow);
        let needed = |(option, value): (&'static str, Option<f64>)| {
            value.ok_or_else(|| QuestionError::missing(option))
        };
        let (option, own, other) = (own.0, needed(own)?, needed(other)?);
        let made = match flow {
            Flow::Heat => Conductivities::new(own, other),
            Flow::Current => Resistivities::new(own, other).map(|both| both.conductivities()),
        };
        made.map_err(|error| QuestionError::Value { option, error })
    }
}

impl FoundConductance {
    /// Samples the conductance between its pressures, straight within a relative `tolerance`. `progress` advances once per
    /// state that is computed; how many are needed shows only in the end.
    ///
    /// # Errors
    /// [`QuestionError`] for a model without stiffness or gap under a pressure, and if `progress` is cancelled.
    pub fn sampled(
        &self,
        tolerance: f64,
        progress: &dyn Progress,
    ) -> Result<ConductanceTable, QuestionError> {
        // The rest of the error is that between loads.
        let of_lines = match &self.spots {
            Spots::Elements { law, .. } => tolerance - law.stiffness_error,
            Spots::Analogy { .. } | Spots::Correlation { .. } => tolerance,
        };
        let sampled = ConductanceTable::sample(self.flow, self.range_pa, of_lines, |pressure_pa| {
            if progress.is_cancelled() {
                return Err(QuestionError::Plan(PlanError::Cancelled));
            }
            progress.advance(1);
            self.at(pressure_pa)
        });
        sampled.map_err(|error| match error {
            SamplingError::Source(error) => error,
            other => QuestionError::Other(other.to_string()),
        })
    }

    /// Conductances under a nominal pressure > 0 \[Pa\].
    fn at(&self, pressure_pa: f64) -> Result<ConductancePoint, QuestionError> {
        let out_of_range = |error: OutOfBounds| QuestionError::Value { option: "pressure_range", error };
        let (contact_si, gas_si) = match &self.spots {
            Spots::Analogy { law, modulus_pa, .. } => {
                self.by_analogy(&law.at(pressure_pa)?, *modulus_pa, law.rms_height_m)?
            }
            Spots::Elements { law, modulus_pa } => {
                self.by_analogy(&law.at(pressure_pa), *modulus_pa, law.rms_height_m)?
            }
            Spots::Correlation { correlation, surface, hardness_pa, .. } => {
                let ratio = PressureRatio::new(pressure_pa, *hardness_pa).map_err(out_of_range)?;
                let rms_height_m = surface.rms_height_m();
                // Where everything touches no gap is left.
                let gas = self.gas.zip(plastic_separation_m(rms_height_m, ratio));
                let gas = gas.map(|(gas, apart_m)| gas.conductance_w_per_m2_k(apart_m, rms_height_m));
                (correlation.conductance_w_per_m2_k(&self.conductivities, surface, ratio), gas.unwrap_or(0.0))
            }
        };
        Ok(ConductancePoint { pressure_pa, contact_si, gas_si })
    }

    /// Conductances of spots and gas in a state, by the analogy of the spots with its stiffness.
    fn by_analogy(
        &self,
        state: &GapState,
        modulus_pa: f64,
        rms_height_m: f64,
    ) -> Result<(f64, f64), QuestionError> {
        let stiffness = state.stiffness_pa_per_m.filter(|stiffness| stiffness.is_finite());
        let (Some(stiffness), Some(mean_gap_m)) = (stiffness, state.mean_gap_m) else {
            return Err(QuestionError::NoStiffness { pressure_pa: state.nominal_pressure_pa });
        };
        let relative = RelativeStiffness::new(stiffness, modulus_pa)
            .map_err(|error| QuestionError::Value { option: "pressure_range", error })?;
        let gas = self.gas.map(|gas| gas.conductance_w_per_m2_k(mean_gap_m, rms_height_m));
        Ok((relative.thermal_conductance_w_per_m2_k(&self.conductivities), gas.unwrap_or(0.0)))
    }

    /// Describes formulas, inputs and every caution in lines, for the comments of a file.
    #[must_use]
    pub fn description(&self, spelling: &dyn Spelling) -> Vec<String> {
        let mean = self.conductivities.harmonic_mean_w_per_m_k();
        let (symbol, mean) = match self.flow {
            Flow::Heat => ("h", format!("k_s = {} W/(m K)", three_digits(mean))),
            Flow::Current => ("G", format!("k_s = 2/(rho1 + rho2) = {} S/m", three_digits(mean))),
        };
        let analogy = |modulus_pa: f64, stiffness: &str| {
            format!(
                "Conductance of the spots by Barber's analogy, {symbol} = k_s K/E* (Barber 2003, Proc. R. Soc. A 459:53): \
                 {mean}, E* = {}, and K is the stiffness of {stiffness}.",
                pressure(modulus_pa)
            )
        };
        let mut lines = match &self.spots {
            Spots::Analogy { model, law, modulus_pa, .. } => {
                let stiffness = if law.yields() { "this model on unloading" } else { "this model" };
                vec![format!("{}: {}", model.full_name, model.citation), analogy(*modulus_pa, stiffness)]
            }
            Spots::Elements { law, modulus_pa } => {
                let mut lines = law.description(spelling);
                lines.push(analogy(*modulus_pa, "these elements on unloading"));
                lines
            }
            Spots::Correlation { correlation, surface, hardness_pa, cutoff_m } => vec![format!(
                "{}, with {mean}, sigma = {}, mean absolute slope m = {} of all waves down to {}, H = {}.",
                formula(*correlation, symbol),
                length(surface.rms_height_m()),
                three_digits(surface.mean_absolute_slope()),
                length(*cutoff_m),
                pressure(*hardness_pa)
            )],
        };
        if !matches!(self.spots, Spots::Elements { .. }) {
            lines.extend(cautions(&self.notes, spelling));
        }
        lines.extend(self.caution());
        if let Some(gas) = &self.gas {
            lines.push(format!(
                "Conductance of the gas k_g <1/(g + M)> over Gaussian gaps: k_g = {} W/(m K), M = {}. At no pressure it is that of \
                 the first pressure.",
                three_digits(gas.conductivity_w_per_m_k()),
                length(gas.parameter_m())
            ));
            let rms_height_m = match &self.spots {
                Spots::Analogy { law, .. } => Some(law.rms_height_m),
                Spots::Elements { law, .. } => Some(law.rms_height_m),
                Spots::Correlation { .. } => None,
            };
            let caution = rms_height_m.and_then(|rms_height_m| gas.caution(rms_height_m));
            lines.extend(caution.map(str::to_owned));
        }
        lines
    }

    /// Describes what the conductance of the spots leaves out.
    fn caution(&self) -> Vec<String> {
        let mut lines = match &self.spots {
            Spots::Analogy { model, law, .. } if model.has(Choice::Strength) && !law.yields() => vec![
                "The model yields: K is the slope of its loading curve, and the elastic stiffness that the analogy takes is larger, \
                 so that this conductance is low."
                    .to_owned(),
            ],
            Spots::Analogy { flows: true, .. } => vec![LOW_BY_FLOW.to_owned()],
            Spots::Analogy { .. } | Spots::Elements { .. } => Vec::new(),
            Spots::Correlation { hardness_pa, .. } => {
                let [least, most] = PressureRatio::FITTED;
                let [from, to] = self.range_pa.map(|pressure_pa| pressure_pa / hardness_pa);
                let outside = if from < least || to > most { ": the table goes beyond" } else { "" };
                vec![format!(
                    "The slope, and this conductance with it, grow with every shorter wave (--cutoff); heat and current do not. The \
                     correlation was fitted for p/H from {} to {}, and p/H is {} to {} here{outside}.",
                    three_digits(least),
                    three_digits(most),
                    three_digits(from),
                    three_digits(to)
                )]
            }
        };
        lines.push(match self.flow {
            Flow::Heat => "Both bodies are clean: films are left out.".to_owned(),
            Flow::Current => format!(
                "Both bodies are clean, and spots wider than the mean free path of electrons, {} in good metals: films and \
                 ballistic transport are left out.",
                length(ELECTRON_MEAN_FREE_PATH_M)
            ),
        });
        lines
    }
}

fn formula(correlation: PlasticCorrelation, symbol: &str) -> String {
    match correlation {
        PlasticCorrelation::CooperMikicYovanovich => format!(
            "Conductance of the spots {symbol} = 1.45 k_s (m/sigma) (p/H)^0.985 (Cooper, Mikic & Yovanovich 1969, Int. J. Heat \
             Mass Transfer 12:279)"
        ),
        PlasticCorrelation::Yovanovich => format!(
            "Conductance of the spots {symbol} = 1.25 k_s (m/sigma) (p/H)^0.95 (Yovanovich 1982, Prog. Astronaut. Aeronaut. \
             83:83)"
        ),
        other => format!("Conductance of the spots {symbol} by the correlation {other}"),
    }
}

/// Hardness of the softer body \[Pa\].
fn hardness_pa(material: &Material) -> Result<f64, QuestionError> {
    let options = || QuestionError::Missing(vec!["indentation_hardness", "yield_strength"]);
    material.hardness_pa().ok_or_else(options)
}
