//! A scene as typed, with every key that exists.

use std::fmt;
use std::marker::PhantomData;
use std::ops::Range;
use std::str::FromStr;
use std::sync::LazyLock;

use ::interface::flatness::Flatness;
use ::interface::gas::NamedGas;
use ::interface::sealed_fluid::LeakUnit;
use measurements::{Instrument, SlopeUncertainty, TipRadius, ZCalibration};
use persson::Band;
use persson::EnergyFactor;

use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Error, IntoDeserializer, MapAccess, SeqAccess, Unexpected, Visitor};
use serde::{Deserialize, Deserializer};
use serde_spanned::Spanned;
use spectrum::{Abscissa, AmplitudeDefinition, Convention, Normalisation};
use stacked_contact::YieldingAreaLaw;
use stat_contact::{Flattening, InterferenceLaw};
use topography::{Average, Detrend, Direction, GapTreatment, LineAverage, Window};

use super::error::SceneError;
use super::mistyped::explained;
use super::reader::read;
use super::section::{Section, read_section};
use super::values::text_of;
use study::body_properties::BodyProperty;
use study::figure::{PictureFormat, Shows};
use study::layer_base::LayerBase;
use study::models::{Choice, ModelEntry, ModelOptions};
use study::plan::Cutoffs;
use units::{
    Area, Force, Length, LengthUnit, Modulus, Pressure, Temperature, ThermalConductivity, Viscosity,
    WorkOfAdhesion,
};

/// A quantity that is read later: text with a unit. Any other value is let in here, to be refused with the mend.
pub(super) type RawQuantity = Spanned<toml::Value>;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawScene {
    pub title: Option<String>,
    pub surface: Spanned<RawSurface>,
    pub material: Option<Spanned<RawMaterial>>,
    pub counterface: Option<Spanned<RawCounterface>>,
    pub loads: Option<Spanned<RawLoads>>,
    #[serde(default)]
    pub curve: Vec<Spanned<RawCurve>>,
    #[serde(default)]
    pub figure: Vec<Spanned<RawFigure>>,
    pub figures: Option<RawFigureDefaults>,
    #[serde(default)]
    pub cutoffs: RawCutoffs,
    #[serde(default)]
    pub options: RawOptions,
    pub judge: Option<RawJudge>,
    pub uncertainty: Option<RawUncertainty>,
    pub interface: Option<RawInterface>,
    pub seal: Option<Spanned<RawSeal>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a section [surface]")]
pub(super) struct RawSurface {
    pub psd: Option<Spanned<String>>,
    pub column: Option<String>,
    pub x: Option<Typed<Abscissa>>,
    pub convention: Option<Typed<Convention>>,
    pub series: Option<String>,
    pub subject: Option<String>,
    pub x_unit: Option<String>,
    pub psd_unit: Option<String>,
    #[serde(default)]
    pub scans: Vec<Spanned<RawScan>>,
    pub detrend: Option<Detrend>,
    pub window: Option<Window>,
    pub average: Option<Average>,
    pub line_average: Option<LineAverage>,
    pub remove_spikes: Option<bool>,
    pub bins_per_decade: Option<Spanned<i64>>,
    pub rms_height: Option<Typed<Length>>,
    pub rms_slope: Option<Spanned<f64>>,
    pub mean_width: Option<Typed<Length>>,
    pub rolloff_wavelength: Option<Typed<Length>>,
    pub hurst: Option<Spanned<f64>>,
}

/// A scan: its file alone, or with the options that the file needs.
pub(super) type RawScan = TableOr<RawScanKeys, String>;

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, expecting = "{ file = \"...\", ... }")]
pub(super) struct RawScanKeys {
    pub file: String,
    pub unit: Option<Typed<LengthUnit>>,
    pub height_unit: Option<Typed<LengthUnit>>,
    pub channel: Option<String>,
    pub size: Option<Typed<Length>>,
    pub tip_radius: Option<Typed<TipRadius>>,
    pub shortest_wavelength: Option<Typed<Length>>,
    pub gaps: Option<GapTreatment>,
    pub direction: Option<Direction>,
    pub detrend: Option<Detrend>,
    pub instrument: Option<Typed<Instrument>>,
    pub z_calibration: Option<Typed<ZCalibration>>,
    pub slope_uncertainty: Option<Typed<SlopeUncertainty>>,
}

/// The rough body.
pub(super) type RawMaterial = RawBody<false>;

/// The body that presses on the rough one, perhaps with a surface of its own.
pub(super) type RawCounterface = RawBody<true>;

#[derive(Debug, Default)]
pub(super) struct RawBody<const IS_COUNTERFACE: bool> {
    pub name: Option<Spanned<String>>,
    pub properties: Vec<(BodyProperty, Spanned<RawProperty>)>,
    /// Layer on the rough body; a counterface has none.
    pub layer: Option<Spanned<RawLayer>>,
    /// Surface of the counterface.
    pub surface: Option<Spanned<RawSurface>>,
}

impl<const IS_COUNTERFACE: bool> RawBody<IS_COUNTERFACE> {
    /// Tells whether the scene types a property itself.
    pub fn types(&self, property: BodyProperty) -> bool {
        self.properties.iter().any(|(given, _)| *given == property)
    }
}

/// A layer bonded to the rough body.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a section [material.layer]")]
pub(super) struct RawLayer {
    pub thickness: Option<Typed<Length>>,
    pub youngs_modulus: Option<Typed<Modulus>>,
    pub poisson_ratio: Option<Spanned<f64>>,
    pub base: Option<LayerBase>,
}

static MATERIAL_KEYS: LazyLock<Vec<&str>> = LazyLock::new(|| body_keys("layer"));
static COUNTERFACE_KEYS: LazyLock<Vec<&str>> = LazyLock::new(|| body_keys("surface"));

fn body_keys(last: &'static str) -> Vec<&'static str> {
    let properties = BodyProperty::ALL.map(BodyProperty::key);
    ["name"].into_iter().chain(properties).chain([last]).collect()
}

impl<const IS_COUNTERFACE: bool> Section for RawBody<IS_COUNTERFACE> {
    const WANTED: &'static str =
        if IS_COUNTERFACE { "a section [counterface]" } else { "a section [material]" };

    fn keys() -> &'static [&'static str] {
        if IS_COUNTERFACE { &COUNTERFACE_KEYS } else { &MATERIAL_KEYS }
    }

    fn read<'de, A: MapAccess<'de>>(&mut self, key: &str, values: &mut A) -> Result<(), A::Error> {
        match BodyProperty::of_key(key) {
            Some(property) if property.may_be_uncertain() => {
                self.properties.push((property, values.next_value()?));
            }
            Some(property) => {
                let quantity: RawQuantity = values.next_value()?;
                let given = Spanned::new(quantity.span(), RawProperty::Other(quantity.into_inner()));
                self.properties.push((property, given));
            }
            None if key == "name" => self.name = Some(values.next_value()?),
            None if key == "layer" => self.layer = Some(values.next_value()?),
            None => self.surface = Some(values.next_value()?),
        }
        Ok(())
    }
}

impl<'de, const IS_COUNTERFACE: bool> Deserialize<'de> for RawBody<IS_COUNTERFACE> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        read_section(deserializer)
    }
}

/// A property of a material: text with a unit, perhaps with how well it is known, or the distribution of it. Other values are
/// refused with the remedy.
pub(super) type RawProperty = TableOr<RawDistribution, toml::Value>;

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, expecting = "{ distribution = \"...\", ... }")]
pub(super) struct RawDistribution {
    pub distribution: Distribution,
    pub median: Option<RawQuantity>,
    pub standard_uncertainty: Option<RawQuantity>,
    pub from: Option<RawQuantity>,
    pub to: Option<RawQuantity>,
    pub values: Option<Vec<RawQuantity>>,
}

/// The distributions that a property may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Distribution {
    LogNormal,
    Beta,
    Uniform,
    Values,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a section [loads]")]
pub(super) struct RawLoads {
    pub pressures: Option<Vec<Typed<Pressure>>>,
    pub force: Option<Typed<Force>>,
    pub nominal_area: Option<Typed<Area>>,
}

/// A curve. Of the options of its model, those whose values need more checks stand beside the others.
#[derive(Debug, Default)]
pub(super) struct RawCurve {
    pub model: Option<&'static ModelEntry>,
    pub options: ModelOptions,
    pub gamma: Option<Typed<EnergyFactor>>,
    pub hardness_law: Option<Spanned<String>>,
    pub cutoffs: Option<Cutoffs>,
    pub name: Option<Spanned<String>>,
}

static CURVE_KEYS: LazyLock<Vec<&str>> = LazyLock::new(|| {
    let options = Choice::OF_CURVES.map(Choice::key);
    ["model"].into_iter().chain(options).chain(["cutoffs", "name"]).collect()
});

impl Section for RawCurve {
    const WANTED: &'static str = "a section [[curve]]";

    fn keys() -> &'static [&'static str] {
        &CURVE_KEYS
    }

    fn read<'de, A: MapAccess<'de>>(&mut self, key: &str, values: &mut A) -> Result<(), A::Error> {
        match key {
            "model" => self.model = Some(values.next_value()?),
            "gamma" => self.gamma = Some(values.next_value()?),
            "hardness_law" => self.hardness_law = Some(values.next_value()?),
            "cutoffs" => self.cutoffs = Some(values.next_value()?),
            "name" => self.name = Some(values.next_value()?),
            key => {
                let choice = Choice::OF_CURVES.into_iter().find(|choice| choice.key() == key);
                choice.map_or(Ok(()), |choice| self.options.read(choice, values))?;
            }
        }
        Ok(())
    }

    fn missing(&self) -> Option<&'static str> {
        self.model.is_none().then_some("model")
    }
}

impl<'de> Deserialize<'de> for RawCurve {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        read_section(deserializer)
    }
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a section [[figure]]")]
pub(super) struct RawFigure {
    pub name: Spanned<String>,
    pub shows: Shows,
    pub title: Option<Spanned<toml::Value>>,
    pub curves: Option<Vec<Spanned<String>>>,
    pub models: Option<Vec<Spanned<String>>>,
    pub loads: Option<Spanned<RawFigureLoads>>,
    pub cutoff_multiples: Option<Vec<f64>>,
    pub width: Option<Typed<Length>>,
    pub format: Option<Vec<PictureFormat>>,
    pub font_size: Option<Spanned<f64>>,
}

/// Settings of all figures that do not set their own.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a section [figures]")]
pub(super) struct RawFigureDefaults {
    pub title: Option<Spanned<bool>>,
    pub models: Option<Vec<Spanned<String>>>,
    pub loads: Option<Vec<RawQuantity>>,
    pub width: Option<Typed<Length>>,
    pub format: Option<Vec<PictureFormat>>,
    pub font_size: Option<Spanned<f64>>,
}

/// The loads of a figure: some loads of the scene, of a figure against the cutoff, or the abscissas of one against the load.
pub(super) type RawFigureLoads = TableOr<RawLoadRange, Vec<RawQuantity>>;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, expecting = "{ from = \"1e-6 H\", to = \"1 H\", points = 41 }")]
pub(super) struct RawLoadRange {
    pub from: Typed<Pressure>,
    pub to: Typed<Pressure>,
    pub points: Spanned<u32>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a section [cutoffs]")]
pub(super) struct RawCutoffs {
    pub shortest_wavelength: Option<Typed<Length>>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a section [options]")]
pub(super) struct RawOptions {
    pub normalisation: Option<Normalisation>,
    pub amplitude: Option<AmplitudeDefinition>,
    pub scales_per_decade: Option<Spanned<i64>>,
    pub hardness_formula: Option<asperity::Hardness>,
    pub strength_cap: Option<Typed<Pressure>>,
    pub interference_law: Option<InterferenceLaw>,
    pub flattening: Option<Flattening>,
    pub elastic_plastic_area: Option<YieldingAreaLaw>,
    pub tolerance: Option<Spanned<f64>>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a section [judge]")]
pub(super) struct RawJudge {
    pub grid: Option<Spanned<i64>>,
    pub realisations: Option<Spanned<i64>>,
    pub seed: Option<Spanned<i64>>,
    pub budget: Option<Spanned<f64>>,
    #[serde(default)]
    pub all_models: bool,
    #[serde(default)]
    pub off: bool,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a section [uncertainty]")]
pub(super) struct RawUncertainty {
    pub level: Option<Spanned<f64>>,
    pub draws: Option<Spanned<i64>>,
    pub seed: Option<Spanned<i64>>,
    pub shares_draws: Option<Spanned<i64>>,
    #[serde(default)]
    pub off: bool,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a section [interface]")]
pub(super) struct RawInterface {
    pub gamma: Option<Typed<EnergyFactor>>,
    pub band: Option<Typed<Band>>,
    pub shear_strength: Option<Typed<Pressure>>,
    pub work_of_adhesion: Option<Typed<WorkOfAdhesion>>,
    pub range_of_attraction: Option<Typed<Length>>,
    pub flatness: Option<Typed<Flatness>>,
    pub gas: Option<Typed<NamedGas>>,
    pub gas_temperature: Option<Typed<Temperature>>,
    pub gas_pressure: Option<Typed<Pressure>>,
    pub gas_conductivity: Option<Typed<ThermalConductivity>>,
    pub gas_parameter: Option<Typed<Length>>,
    pub friction: Option<Spanned<f64>>,
    pub tangential_stress: Option<Typed<Pressure>>,
    pub share_of_sliding: Option<Spanned<f64>>,
}

impl RawInterface {
    /// Tells whether the section says nothing but how gap and stiffness are computed.
    pub fn has_no_question(&self) -> bool {
        let asks = [
            self.shear_strength.is_some(),
            self.work_of_adhesion.is_some(),
            self.gas.is_some(),
            self.gas_conductivity.is_some(),
            self.friction.is_some(),
        ];
        !asks.contains(&true)
    }
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a section [seal]")]
pub(super) struct RawSeal {
    pub percolation_threshold: Option<Spanned<f64>>,
    pub pressure_drop: Option<Typed<Pressure>>,
    pub viscosity: Option<Typed<Viscosity>>,
    pub gas: Option<Typed<NamedGas>>,
    pub gas_temperature: Option<Typed<Temperature>>,
    pub outlet_pressure: Option<Typed<Pressure>>,
    pub leak_unit: Option<Typed<LeakUnit>>,
    pub breadth: Option<Typed<Length>>,
    pub length: Option<Typed<Length>>,
}

/// A value that is typed as text, such as a quantity with its unit, with the text and its place.
#[derive(Debug, Clone)]
pub(super) struct Typed<T> {
    pub value: T,
    pub text: String,
    span: Range<usize>,
}

impl<T: FromStr<Err: fmt::Display>> Typed<T> {
    /// Reads a value. A bare number is read as text without a unit, so that the message lists the units.
    pub fn read<E: Error>(raw: &RawQuantity) -> Result<Self, E> {
        let text = text_of(raw.get_ref());
        match text.parse() {
            Ok(value) => Ok(Typed { value, text: text.trim().to_owned(), span: raw.span() }),
            Err(error) => Err(E::invalid_value(Unexpected::Other(&text), &error.to_string().as_str())),
        }
    }
}

impl<T> Typed<T> {
    pub fn span(&self) -> Range<usize> {
        self.span.clone()
    }
}

impl<'de, T: FromStr<Err: fmt::Display>> Deserialize<'de> for Typed<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Typed::read(&Spanned::deserialize(deserializer)?)
    }
}

/// Returns the value of a key, if it is given.
pub(super) fn given<T: Copy>(typed: &Option<Typed<T>>) -> Option<T> {
    typed.as_ref().map(|typed| typed.value)
}

/// A table, or another value in its place.
#[derive(Debug, Clone)]
pub(super) enum TableOr<T, V> {
    Table(T),
    Other(V),
}

impl<'de, T: Deserialize<'de>, V: Deserialize<'de>> Deserialize<'de> for TableOr<T, V> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Either<T, V>(PhantomData<(T, V)>);

        fn other<'de, V: Deserialize<'de>, T, E: Error>(
            value: impl IntoDeserializer<'de, E>,
        ) -> Result<TableOr<T, V>, E> {
            V::deserialize(value.into_deserializer()).map(TableOr::Other)
        }

        impl<'de, T: Deserialize<'de>, V: Deserialize<'de>> Visitor<'de> for Either<T, V> {
            type Value = TableOr<T, V>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a value or a table")
            }

            fn visit_map<A: MapAccess<'de>>(self, keys: A) -> Result<Self::Value, A::Error> {
                T::deserialize(MapAccessDeserializer::new(keys)).map(TableOr::Table)
            }

            fn visit_seq<A: SeqAccess<'de>>(self, values: A) -> Result<Self::Value, A::Error> {
                V::deserialize(SeqAccessDeserializer::new(values)).map(TableOr::Other)
            }

            fn visit_str<E: Error>(self, text: &str) -> Result<Self::Value, E> {
                other(text.to_owned())
            }

            fn visit_f64<E: Error>(self, number: f64) -> Result<Self::Value, E> {
                other(number)
            }

            fn visit_i64<E: Error>(self, number: i64) -> Result<Self::Value, E> {
                other(number)
            }

            fn visit_bool<E: Error>(self, truth: bool) -> Result<Self::Value, E> {
                other(truth)
            }
        }

        deserializer.deserialize_any(Either(PhantomData))
    }
}

impl RawScene {
    pub fn parse(text: &str) -> Result<Self, SceneError> {
        read(text).map_err(|error| explained(error, text))
    }
}
