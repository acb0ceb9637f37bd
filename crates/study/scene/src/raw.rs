//! A scene as typed, with every key that exists.

use std::fmt;

use persson::corrections::Correction;
use persson::variance::Band;
use serde::de::value::MapAccessDeserializer;
use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use serde_spanned::Spanned;
use spectrum::{AmplitudeDefinition, Normalisation};
use stat_contact::InterferenceLaw;
use topography::{Average, Detrend, Direction, GapTreatment, Window};

use super::error::SceneError;
use super::from_toml::scene_error;
use super::mistyped::explained;
use study::figure::Shows;
use study::models::ModelEntry;
use study::plan::Cutoffs;

/// A quantity: text with a unit. Any other value is let in here, to be refused with the mend.
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
#[serde(deny_unknown_fields)]
pub(super) struct RawSurface {
    pub psd: Option<Spanned<String>>,
    pub column: Option<String>,
    pub x: Option<Spanned<String>>,
    pub convention: Option<Spanned<String>>,
    pub series: Option<String>,
    pub subject: Option<String>,
    pub x_unit: Option<String>,
    pub psd_unit: Option<String>,
    #[serde(default)]
    pub scans: Vec<Spanned<RawScan>>,
    pub detrend: Option<Detrend>,
    pub window: Option<Window>,
    pub average: Option<Average>,
    pub bins_per_decade: Option<Spanned<i64>>,
    pub rms_height: Option<RawQuantity>,
    pub rms_slope: Option<Spanned<f64>>,
    pub mean_width: Option<RawQuantity>,
    pub rolloff_wavelength: Option<RawQuantity>,
    pub hurst: Option<Spanned<f64>>,
}

/// A scan: its file alone, or with the options that the file needs.
#[derive(Debug, Default)]
pub(super) struct RawScan(pub RawScanKeys);

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawScanKeys {
    pub file: String,
    pub unit: Option<Spanned<String>>,
    pub channel: Option<String>,
    pub size: Option<RawQuantity>,
    pub tip_radius: Option<RawQuantity>,
    pub shortest_wavelength: Option<RawQuantity>,
    pub gaps: Option<GapTreatment>,
    pub direction: Option<Direction>,
    pub instrument: Option<Spanned<String>>,
    pub z_calibration: Option<RawQuantity>,
    pub slope_uncertainty: Option<RawQuantity>,
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawMaterial {
    pub name: Option<Spanned<String>>,
    pub youngs_modulus: Option<Spanned<RawProperty>>,
    pub poisson_ratio: Option<Spanned<RawProperty>>,
    pub yield_strength: Option<Spanned<RawProperty>>,
    pub indentation_hardness: Option<Spanned<RawProperty>>,
    pub strain_gradient_length: Option<Spanned<RawProperty>>,
    pub thermal_conductivity: Option<RawQuantity>,
    pub resistivity: Option<RawQuantity>,
}

/// A property of a material: text with a unit, perhaps with how well it is known, or the distribution of it.
#[derive(Debug, Clone)]
pub(super) enum RawProperty {
    /// A text, a number, or anything else, which is refused with the remedy.
    Value(toml::Value),
    /// A table.
    Distribution(RawDistribution),
}

#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
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
#[serde(deny_unknown_fields)]
pub(super) struct RawCounterface {
    pub name: Option<Spanned<String>>,
    pub youngs_modulus: Option<Spanned<RawProperty>>,
    pub poisson_ratio: Option<Spanned<RawProperty>>,
    pub yield_strength: Option<Spanned<RawProperty>>,
    pub indentation_hardness: Option<Spanned<RawProperty>>,
    pub strain_gradient_length: Option<Spanned<RawProperty>>,
    pub thermal_conductivity: Option<RawQuantity>,
    pub resistivity: Option<RawQuantity>,
    pub surface: Option<Spanned<RawSurface>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawLoads {
    pub pressures: Option<Vec<RawQuantity>>,
    pub force: Option<RawQuantity>,
    pub nominal_area: Option<RawQuantity>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawCurve {
    pub model: &'static ModelEntry,
    #[serde(default)]
    pub strain_gradient: bool,
    pub interference_law: Option<InterferenceLaw>,
    pub correction: Option<Correction>,
    pub band: Option<Band>,
    pub gamma: Option<Spanned<f64>>,
    pub hardness_law: Option<Spanned<String>>,
    pub cutoffs: Option<Cutoffs>,
    pub name: Option<Spanned<String>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawFigure {
    pub name: Spanned<String>,
    pub shows: Shows,
    pub title: Option<String>,
    pub curves: Option<Vec<Spanned<String>>>,
    pub loads: Option<Spanned<RawLoadRange>>,
    pub cutoff_multiples: Option<Vec<f64>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawLoadRange {
    pub from: RawQuantity,
    pub to: RawQuantity,
    pub points: Spanned<u32>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawCutoffs {
    pub shortest_wavelength: Option<RawQuantity>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawOptions {
    pub normalisation: Option<Normalisation>,
    pub amplitude: Option<AmplitudeDefinition>,
    pub scales_per_decade: Option<Spanned<i64>>,
    pub hardness: Option<asperity::Hardness>,
    pub strength_cap: Option<RawQuantity>,
    pub interference_law: Option<InterferenceLaw>,
    pub tolerance: Option<Spanned<f64>>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawJudge {
    pub grid: Option<Spanned<i64>>,
    pub realisations: Option<Spanned<i64>>,
    pub seed: Option<Spanned<i64>>,
    pub budget: Option<Spanned<f64>>,
    #[serde(default)]
    pub off: bool,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawUncertainty {
    pub level: Option<Spanned<f64>>,
    pub draws: Option<Spanned<i64>>,
    pub seed: Option<Spanned<i64>>,
    pub shares_draws: Option<Spanned<i64>>,
    #[serde(default)]
    pub off: bool,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawInterface {
    pub gamma: Option<Spanned<f64>>,
    pub band: Option<Spanned<String>>,
    pub shear_strength: Option<RawQuantity>,
    pub work_of_adhesion: Option<RawQuantity>,
    pub range_of_attraction: Option<RawQuantity>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawSeal {
    pub percolation_threshold: Option<Spanned<f64>>,
    pub pressure_drop: Option<RawQuantity>,
    pub viscosity: Option<RawQuantity>,
    pub breadth: Option<RawQuantity>,
    pub length: Option<RawQuantity>,
}

impl<'de> Deserialize<'de> for RawScan {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct FileOrKeys;

        impl<'de> Visitor<'de> for FileOrKeys {
            type Value = RawScan;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the name of a scan's file or { file = \"...\", ... }")
            }

            fn visit_str<E: serde::de::Error>(self, file: &str) -> Result<RawScan, E> {
                Ok(RawScan(RawScanKeys { file: file.to_owned(), ..RawScanKeys::default() }))
            }

            fn visit_map<A: MapAccess<'de>>(self, keys: A) -> Result<RawScan, A::Error> {
                RawScanKeys::deserialize(MapAccessDeserializer::new(keys)).map(RawScan)
            }
        }

        deserializer.deserialize_any(FileOrKeys)
    }
}

impl<'de> Deserialize<'de> for RawProperty {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct ValueOrKeys;

        impl<'de> Visitor<'de> for ValueOrKeys {
            type Value = RawProperty;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a value or { distribution = \"...\", ... }")
            }

            fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<RawProperty, E> {
                Ok(RawProperty::Value(toml::Value::String(text.to_owned())))
            }

            fn visit_f64<E: serde::de::Error>(self, number: f64) -> Result<RawProperty, E> {
                Ok(RawProperty::Value(toml::Value::Float(number)))
            }

            fn visit_i64<E: serde::de::Error>(self, number: i64) -> Result<RawProperty, E> {
                Ok(RawProperty::Value(toml::Value::Integer(number)))
            }

            fn visit_bool<E: serde::de::Error>(self, truth: bool) -> Result<RawProperty, E> {
                Ok(RawProperty::Value(toml::Value::Boolean(truth)))
            }

            fn visit_map<A: MapAccess<'de>>(self, keys: A) -> Result<RawProperty, A::Error> {
                RawDistribution::deserialize(MapAccessDeserializer::new(keys)).map(RawProperty::Distribution)
            }
        }

        deserializer.deserialize_any(ValueOrKeys)
    }
}

impl RawScene {
    pub fn parse(text: &str) -> Result<Self, SceneError> {
        toml::from_str(text).map_err(|error| explained(scene_error(&error), text))
    }
}
