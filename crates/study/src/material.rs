//! The material as given: what a model needs of it is drawn, and missed, only when the model asks.

use asperity::{AsperityError, Bound, ElasticBody, Hardness, MaterialPair, NixGao};
use stacked_contact::StackedModel;
use stat_contact::{AsperityLaw, InterferenceLaw, Model};

use units::Pressure;
use units::display::{length, pressure};
use units::number;

/// H/S0.
const HARDNESS_OVER_STRENGTH: f64 = 3.0;

/// The bodies and, where given, the strength; what a model does not need of it is not looked at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// The rough body and its counterface.
    pub pair: MaterialPair,
    /// The counterface, where it is not rigid.
    counterface: Option<ElasticBody>,
    /// The strength S0; not needed by elastic models.
    yield_strength: Option<Pressure>,
    /// The cap of its growth.
    strength_cap: Option<Pressure>,
    /// h* \[m\]; needed by models with a strain gradient.
    strain_gradient_length_m: Option<f64>,
}

/// What a material is made from, as given.
#[derive(Debug, Clone, Copy)]
pub struct GivenMaterial {
    /// The rough body.
    pub body: ElasticBody,
    /// What presses on it; rigid where absent.
    pub counterface: Option<ElasticBody>,
    /// Its yield strength S0.
    pub yield_strength: Option<Pressure>,
    /// The cap of its growth.
    pub strength_cap: Option<Pressure>,
    /// h* \[m\], the strain-gradient length of Eq. (8).
    pub strain_gradient_length_m: Option<f64>,
}

/// Which of the stacked models, as typed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StackedModelName {
    /// Sinusoids that only deform elastically.
    Elastic,
    /// Sinusoids that yield.
    ElasticPlastic,
}

units::named!(StackedModelName, "stacked model", { Elastic => "elastic", ElasticPlastic => "elastic-plastic" });

/// Any of the models, as typed in a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ModelName {
    /// Stacked, elastic sinusoids.
    Elastic,
    /// Stacked, elastic-plastic sinusoids.
    ElasticPlastic,
    /// Statistical, elastic spheres.
    Hertz,
    /// Statistical, elastic-plastic spheres.
    EpSphere,
    /// Statistical, elastic sinusoids.
    ElasticSine,
    /// Statistical, elastic-plastic sinusoids.
    EpSine,
}

impl ModelName {
    /// The model in its framework.
    pub fn framework(self) -> Framework {
        match self {
            ModelName::Elastic => Framework::Stacked(StackedModelName::Elastic),
            ModelName::ElasticPlastic => Framework::Stacked(StackedModelName::ElasticPlastic),
            ModelName::Hertz => Framework::Statistical(Model::Hertz),
            ModelName::EpSphere => Framework::Statistical(Model::EpSphere),
            ModelName::ElasticSine => Framework::Statistical(Model::ElasticSine),
            ModelName::EpSine => Framework::Statistical(Model::EpSine),
        }
    }
}

/// One of the two frameworks and its model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Framework {
    /// Scale upon scale.
    Stacked(StackedModelName),
    /// Asperities of one curvature.
    Statistical(Model),
}

/// Something a model needs and the material lacks.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MaterialError {
    /// A property outside its bounds.
    #[error(transparent)]
    Bound(#[from] AsperityError),
    /// A strength given as a multiple of itself.
    #[error(
        "the yield strength cannot be given in H, which is three times the yield strength; give it in GPa or MPa"
    )]
    StrengthInHardnesses,
    /// A pressure in units of a hardness that is not known.
    #[error("a pressure in H, three times the yield strength, needs the yield strength")]
    NoHardness,
    /// An elastic-plastic model without a strength.
    #[error(
        "an elastic-plastic model needs the yield strength: give --yield-strength, or yield_strength in [material]"
    )]
    NoStrength,
    /// A strain gradient without its length.
    #[error(
        "the strain-gradient strength needs its length: give --strain-gradient-length, or strain_gradient_length in [material]"
    )]
    NoStrainGradientLength,
}

impl Material {
    /// The material that was given.
    pub fn new(given: GivenMaterial) -> Self {
        let pair = match given.counterface {
            Some(counterface) => MaterialPair::against(given.body, counterface),
            None => MaterialPair::against_rigid(given.body),
        };
        Material {
            pair,
            counterface: given.counterface,
            yield_strength: given.yield_strength,
            strength_cap: given.strength_cap,
            strain_gradient_length_m: given.strain_gradient_length_m,
        }
    }

    /// The hardness H = 3 S0 \[Pa\], a unit for pressures (Jackson & Jacobs), where there is a strength.
    pub fn hardness_pa(&self) -> Option<f64> {
        Some(HARDNESS_OVER_STRENGTH * self.yield_strength?.pascals(None)?)
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
        let mut add = |name: &str, value: Option<f64>, unit: &str| {
            if let Some(value) = value {
                text.push_str(&format!(", {name} = {} {unit}", number(value)));
            }
        };
        add("S0", self.yield_strength.and_then(|strength| strength.pascals(None)), "Pa");
        add("strength cap", self.strength_cap.and_then(|cap| cap.pascals(self.hardness_pa())), "Pa");
        add("h*", self.strain_gradient_length_m, "m");
        text
    }

    /// What is known of it, each with its name, for people.
    pub fn properties(&self) -> Vec<(&'static str, String)> {
        let body = self.pair.body();
        let mut properties = vec![
            ("Young’s modulus E", pressure(body.youngs_modulus_pa())),
            ("Poisson’s ratio ν", number(body.poisson_ratio())),
        ];
        match self.counterface {
            Some(counterface) => properties.extend([
                ("Young’s modulus of the counterface", pressure(counterface.youngs_modulus_pa())),
                ("Poisson’s ratio of the counterface", number(counterface.poisson_ratio())),
            ]),
            None => properties.push(("counterface", "rigid".to_owned())),
        }
        properties
            .push(("composite modulus E*, with the counterface", pressure(self.pair.composite_modulus_pa())));
        let strength_pa = self.yield_strength.and_then(|strength| strength.pascals(None));
        let cap_pa = self.strength_cap.and_then(|cap| cap.pascals(self.hardness_pa()));
        properties.extend(strength_pa.map(|strength_pa| ("yield strength S₀", pressure(strength_pa))));
        properties.extend(self.hardness_pa().map(|hardness_pa| ("hardness H = 3 S₀", pressure(hardness_pa))));
        properties.extend(cap_pa.map(|cap_pa| ("upper limit of the yield strength", pressure(cap_pa))));
        properties.extend(
            self.strain_gradient_length_m.map(|length_m| ("strain-gradient length h*", length(length_m))),
        );
        properties
    }

    /// A pressure > 0 \[Pa\], in units of the hardness or not.
    ///
    /// # Errors
    /// [`MaterialError::NoHardness`] where it is in H and there is no strength, [`MaterialError::Bound`] where it is
    /// not finite and positive.
    pub fn pascals(&self, pressure: Pressure) -> Result<f64, MaterialError> {
        let pressure_pa = pressure.pascals(self.hardness_pa()).ok_or(MaterialError::NoHardness)?;
        Ok(Bound::Positive.check("pressure in Pa", pressure_pa)?)
    }

    /// The stacked model of this name for this material; `strain_gradient` lets its strength grow at small depths.
    ///
    /// # Errors
    /// [`MaterialError`] where the model needs what the material lacks, or what it has is out of bounds.
    pub fn stacked(
        &self,
        name: StackedModelName,
        strain_gradient: bool,
    ) -> Result<StackedModel, MaterialError> {
        match name {
            StackedModelName::Elastic => Ok(StackedModel::Elastic { pair: self.pair }),
            StackedModelName::ElasticPlastic => Ok(StackedModel::ElasticPlastic {
                pair: self.pair,
                strength: self.strength(strain_gradient)?,
            }),
        }
    }

    /// The statistical law of this model for this material; `strain_gradient` lets its strength grow at small depths,
    /// and the options that the law does not have are not looked at.
    ///
    /// # Errors
    /// [`MaterialError`] where the model needs what the material lacks, or what it has is out of bounds.
    pub fn statistical(
        &self,
        model: Model,
        strain_gradient: bool,
        hardness: Hardness,
        interference: InterferenceLaw,
    ) -> Result<AsperityLaw, MaterialError> {
        Ok(match model {
            Model::Hertz => AsperityLaw::Hertz,
            Model::EpSphere => AsperityLaw::EpSphere { strength: self.strength(strain_gradient)?, hardness },
            Model::ElasticSine => AsperityLaw::ElasticSine { interference },
            Model::EpSine => AsperityLaw::EpSine { strength: self.strength(strain_gradient)? },
        })
    }

    fn strength(&self, strain_gradient: bool) -> Result<NixGao, MaterialError> {
        let given = self.yield_strength.ok_or(MaterialError::NoStrength)?;
        let strength_pa = given.pascals(None).ok_or(MaterialError::StrengthInHardnesses)?;
        let length_m = match (strain_gradient, self.strain_gradient_length_m) {
            (false, _) => None,
            (true, Some(length_m)) => Some(length_m),
            (true, None) => return Err(MaterialError::NoStrainGradientLength),
        };
        Ok(strength(strength_pa, length_m, self.strength_cap)?)
    }
}

/// A strength S0 > 0 \[Pa\], growing with a strain-gradient length > 0 \[m\] where there is one (Eq. 8), up to a cap,
/// at least S0, where there is one.
///
/// # Errors
/// [`AsperityError`] for what is out of these bounds.
pub fn strength(
    strength_pa: f64,
    length_m: Option<f64>,
    cap: Option<Pressure>,
) -> Result<NixGao, AsperityError> {
    let mut strength = NixGao::constant(strength_pa)?;
    if let Some(length_m) = length_m {
        strength = strength.with_strain_gradient(length_m)?;
    }
    match cap.and_then(|cap| cap.pascals(Some(HARDNESS_OVER_STRENGTH * strength_pa))) {
        Some(cap_pa) => strength.with_cap(cap_pa),
        None => Ok(strength),
    }
}
