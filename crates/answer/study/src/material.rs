//! The material as given: values are drawn, or reported missing, only when a model needs them.

use asperity::{AsperityError, ElasticBody, Layer, MaterialPair, NixGao};

use crate::bodies::{Body, Softer};
use crate::body_properties::BodyProperty;
use crate::hardness_and_strength::{HardnessAndStrength, HardnessOffStrength};
use crate::load::NominalPressure;
use units::Pressure;
use units::display::{length, pressure};
use units::number;

/// The bodies and, where given, the strength; unused properties are not checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// The rough body and its counterface.
    pub pair: MaterialPair,
    given: GivenMaterial,
}

/// The properties that a material is made from, as given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GivenMaterial {
    /// The rough body; its layer where it has one.
    pub body: ElasticBody,
    /// The layer that the rough body is, with its base; a half-space if absent.
    pub layer: Option<Layer>,
    /// The body that presses on the rough one; rigid if absent.
    pub counterface: Option<ElasticBody>,
    /// The body that flows, if the counterface has a strength; the properties below are its own.
    pub softer: Option<Softer>,
    /// Its indentation hardness H and its yield strength S0.
    pub hardness_and_strength: HardnessAndStrength,
    /// The cap of its growth.
    pub strength_cap: Option<Pressure>,
    /// h* \[m\], the strain-gradient length of Eq. (8).
    pub strain_gradient_length_m: Option<f64>,
}

impl GivenMaterial {
    /// Returns a body against a rigid one, with no property but its elastic constants.
    #[must_use]
    pub fn new(body: ElasticBody) -> Self {
        GivenMaterial {
            body,
            layer: None,
            counterface: None,
            softer: None,
            hardness_and_strength: HardnessAndStrength::default(),
            strength_cap: None,
            strain_gradient_length_m: None,
        }
    }
}

/// The purpose that a property of the material is needed for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum NeededFor {
    /// A pressure in units of the hardness.
    PressureInHardnesses,
    /// A model whose asperities yield.
    Yielding,
    /// A strength that grows at small depths.
    StrainGradient,
}

impl NeededFor {
    /// The property that it takes.
    #[must_use]
    pub fn property(self) -> BodyProperty {
        match self {
            NeededFor::PressureInHardnesses => BodyProperty::IndentationHardness,
            NeededFor::Yielding => BodyProperty::YieldStrength,
            NeededFor::StrainGradient => BodyProperty::StrainGradientLength,
        }
    }
}

impl std::fmt::Display for NeededFor {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            NeededFor::PressureInHardnesses => {
                "a pressure in H, the indentation hardness, needs that hardness or the yield strength, a third of it"
            }
            NeededFor::Yielding => "an elastic-plastic model needs the yield strength",
            NeededFor::StrainGradient => "the strain-gradient strength needs its length",
        })
    }
}

/// Something a model needs and the material lacks.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MaterialError {
    /// A property outside its bounds.
    #[error(transparent)]
    Bound(#[from] AsperityError),
    /// A hardness and a strength that do not belong together.
    #[error(transparent)]
    HardnessOffStrength(#[from] HardnessOffStrength),
    /// A modulus below the strength, as no solid has: its prefix is mistaken.
    #[error(
        "Young's modulus {} is below the yield strength {}; did you mean {}?",
        pressure(*youngs_modulus_pa), pressure(*yield_strength_pa),
        probable(*youngs_modulus_pa, *yield_strength_pa)
    )]
    ModulusBelowStrength {
        /// Young's modulus of the body that yields \[Pa\].
        youngs_modulus_pa: f64,
        /// Its yield strength \[Pa\].
        yield_strength_pa: f64,
    },
    /// A strength given as a multiple of itself.
    #[error(
        "the yield strength cannot be given in H, which is three times the yield strength; give it in GPa or MPa"
    )]
    StrengthInHardnesses,
    /// A model of half-spaces is asked for, and the rough body is a layer.
    #[error(
        "{model} knows half-spaces alone, and the material has a layer: take persson or boundary elements, or leave out the layer"
    )]
    LayerUnknown {
        /// Name of the model.
        model: &'static str,
    },
    /// Something is asked for that takes a property which the material was not given.
    #[error("{0}")]
    Missing(NeededFor),
}

/// Largest Young's modulus of a solid \[Pa\], above that of diamond.
const STIFFEST_PA: f64 = 1.3e12;

/// The modulus or the strength with the prefix that it probably has: a modulus that is a thousandfold no solid's is right.
fn probable(youngs_modulus_pa: f64, yield_strength_pa: f64) -> String {
    match 1e3 * youngs_modulus_pa {
        stiffer_pa if stiffer_pa <= STIFFEST_PA => format!("E = {}", pressure(stiffer_pa)),
        _ => format!("a strength of {}", pressure(1e-3 * yield_strength_pa)),
    }
}

impl Material {
    /// The material that was given.
    pub fn new(given: GivenMaterial) -> Self {
        let flows = given.softer.map_or(Body::Rough, |softer| softer.flows);
        Material { pair: flows.pair(given.body, given.counterface).bonded(given.layer), given }
    }

    /// Returns the material itself if its modulus is not below its strength.
    ///
    /// # Errors
    /// [`MaterialError::ModulusBelowStrength`] otherwise.
    pub fn checked(self) -> Result<Self, MaterialError> {
        let youngs_modulus_pa = self.pair.yielding_body().youngs_modulus_pa();
        match self.yield_strength_pa().filter(|yield_strength_pa| *yield_strength_pa > youngs_modulus_pa) {
            None => Ok(self),
            Some(yield_strength_pa) => {
                Err(MaterialError::ModulusBelowStrength { youngs_modulus_pa, yield_strength_pa })
            }
        }
    }

    /// The counterface, where it is not rigid.
    #[must_use]
    pub fn counterface(&self) -> Option<ElasticBody> {
        self.given.counterface
    }

    /// The body that flows where the pressure is high enough.
    #[must_use]
    pub fn flows(&self) -> Body {
        self.given.softer.map_or(Body::Rough, |softer| softer.flows)
    }

    /// The body that flows of two with a strength.
    #[must_use]
    pub fn softer(&self) -> Option<Softer> {
        self.given.softer
    }

    /// The yield strength S0 \[Pa\], where there is one: as given, or else a third of the hardness.
    #[must_use]
    pub fn yield_strength_pa(&self) -> Option<f64> {
        self.given.hardness_and_strength.yield_strength_pa()
    }

    /// The yield strength S0 = H/3 \[Pa\] that laws take where only the hardness was given.
    #[must_use]
    pub fn assumed_yield_strength_pa(&self) -> Option<f64> {
        self.given.hardness_and_strength.assumed_yield_strength_pa()
    }

    /// The indentation hardness H \[Pa\], a unit for pressures (Jackson & Jacobs), where there is one: as given, or else
    /// 3 S0.
    #[must_use]
    pub fn hardness_pa(&self) -> Option<f64> {
        self.given.hardness_and_strength.hardness_pa()
    }

    /// The cap \[Pa\] of the strength's growth, where there is one.
    #[must_use]
    pub fn strength_cap_pa(&self) -> Option<f64> {
        self.given.strength_cap.and_then(|cap| cap.pascals(self.hardness_pa()))
    }

    /// The strain-gradient length h* \[m\], where there is one.
    #[must_use]
    pub fn strain_gradient_length_m(&self) -> Option<f64> {
        self.given.strain_gradient_length_m
    }

    /// The material in a line, in SI units, for the record; what presses on the body shows in E*.
    pub fn describe(&self) -> String {
        let body = self.pair.body();
        let mut text = format!(
            "E = {} Pa, nu = {}, E* = {} Pa",
            number(body.youngs_modulus_pa()),
            number(body.poisson_ratio()),
            number(self.pair.composite_modulus_pa())
        );
        if let Some(layer) = self.pair.layer() {
            text.push_str(&format!(", a layer of {} m on a {}", number(layer.thickness_m()), base(&layer)));
        }
        let mut add = |name: &str, value: Option<f64>, unit: &str| {
            if let Some(value) = value {
                text.push_str(&format!(", {name} = {} {unit}", number(value)));
            }
        };
        match self.assumed_yield_strength_pa() {
            None => add("S0", self.yield_strength_pa(), "Pa"),
            assumed => add("S0 = H/3", assumed, "Pa"),
        }
        add("H", self.given.hardness_and_strength.given_hardness_pa(), "Pa");
        add("strength cap", self.strength_cap_pa(), "Pa");
        add("h*", self.given.strain_gradient_length_m, "m");
        text
    }

    /// Returns the known properties of the material with their names, for people.
    pub fn properties(&self) -> Vec<(&'static str, String)> {
        let body = self.pair.body();
        let mut properties = vec![
            ("Young’s modulus E", pressure(body.youngs_modulus_pa())),
            ("Poisson’s ratio ν", number(body.poisson_ratio())),
        ];
        properties.extend(self.pair.layer().map(|layer| {
            ("layer of this material", format!("{} on a {}", length(layer.thickness_m()), base(&layer)))
        }));
        match self.given.counterface {
            Some(counterface) => properties.extend([
                ("Young’s modulus of the counterface", pressure(counterface.youngs_modulus_pa())),
                ("Poisson’s ratio of the counterface", number(counterface.poisson_ratio())),
            ]),
            None => properties.push(("counterface", "rigid".to_owned())),
        }
        properties
            .push(("composite modulus E*, with the counterface", pressure(self.pair.composite_modulus_pa())));
        let cap_pa = self.strength_cap_pa();
        let strength = match self.assumed_yield_strength_pa() {
            None => "yield strength S₀",
            Some(_) => "yield strength S₀, none given and H/3 assumed",
        };
        let hardness = match self.given.hardness_and_strength.given_hardness_pa() {
            None => "hardness H = 3 S₀",
            Some(_) => "indentation hardness H",
        };
        properties.extend(self.yield_strength_pa().map(|strength_pa| (strength, pressure(strength_pa))));
        properties.extend(self.hardness_pa().map(|hardness_pa| (hardness, pressure(hardness_pa))));
        properties.extend(cap_pa.map(|cap_pa| ("upper limit of the yield strength", pressure(cap_pa))));
        properties.extend(
            self.given
                .strain_gradient_length_m
                .map(|length_m| ("strain-gradient length h*", length(length_m))),
        );
        properties
    }

    /// A nominal pressure, in units of the hardness or not.
    ///
    /// # Errors
    /// [`MaterialError::Missing`] where it is in H and there is neither hardness nor strength, [`MaterialError::Bound`] where it is beyond
    /// [`NominalPressure::BOUND`].
    pub fn nominal_pressure(&self, pressure: Pressure) -> Result<NominalPressure, MaterialError> {
        let pressure_pa = pressure
            .pascals(self.hardness_pa())
            .ok_or(MaterialError::Missing(NeededFor::PressureInHardnesses))?;
        Ok(NominalPressure::new(pressure_pa)?)
    }

    /// The strength of the body that flows; `strain_gradient` lets it grow at small depths.
    ///
    /// # Errors
    /// [`MaterialError`] where the material lacks what that takes, or what it has is out of bounds.
    pub fn strength(&self, strain_gradient: bool) -> Result<NixGao, MaterialError> {
        if self.given.hardness_and_strength.strength_is_in_hardnesses() {
            return Err(MaterialError::StrengthInHardnesses);
        }
        let strength_pa = self.yield_strength_pa().ok_or(MaterialError::Missing(NeededFor::Yielding))?;
        let length_m = match (strain_gradient, self.given.strain_gradient_length_m) {
            (false, _) => None,
            (true, Some(length_m)) => Some(length_m),
            (true, None) => return Err(MaterialError::Missing(NeededFor::StrainGradient)),
        };
        let cap_pa = self.strength_cap_pa();
        Ok(strength(strength_pa, length_m, cap_pa)?)
    }
}

/// The base of a layer in words.
fn base(layer: &Layer) -> String {
    match layer.base() {
        None => "rigid base".to_owned(),
        Some(base) => format!(
            "base of E = {} and nu = {}",
            pressure(base.youngs_modulus_pa()),
            number(base.poisson_ratio())
        ),
    }
}

/// A strength S0 > 0 \[Pa\], growing with a strain-gradient length > 0 \[m\] where there is one (Eq. 8), up to a cap,
/// at least S0 \[Pa\], where there is one.
///
/// # Errors
/// [`AsperityError`] for what is out of these bounds.
fn strength(strength_pa: f64, length_m: Option<f64>, cap_pa: Option<f64>) -> Result<NixGao, AsperityError> {
    let mut strength = NixGao::constant(strength_pa)?;
    if let Some(length_m) = length_m {
        strength = strength.with_strain_gradient(length_m)?;
    }
    match cap_pa {
        Some(cap_pa) => strength.with_cap(cap_pa),
        None => Ok(strength),
    }
}
