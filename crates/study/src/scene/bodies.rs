//! The material and the counterface of a scene.

use asperity::ElasticBody;
use serde_spanned::Spanned;

use super::error::{SceneError, SceneProblem};
use super::known::{Known, optional_property, poisson_ratio, property};
use super::raw::{RawCounterface, RawMaterial, RawProperty};
use crate::hardness_and_strength::HardnessAndStrength;
use crate::material::{GivenMaterial, Material, MaterialError};
use crate::material_spreads::MaterialSpreads;
use crate::spread::Spread;
use units::{IndentationHardness, Length, Modulus, Pressure};

/// An elastic body, and how well its constants are known.
pub(super) struct KnownBody {
    pub body: ElasticBody,
    pub youngs_modulus: Option<Spread>,
    pub poisson_ratio: Option<Spread>,
}

impl KnownBody {
    pub fn exactly(body: ElasticBody) -> Self {
        KnownBody { body, youngs_modulus: None, poisson_ratio: None }
    }
}

/// The material, and how well it is known.
pub(super) fn resolve_material(
    raw: &RawMaterial,
    counterface: Option<KnownBody>,
    strength_cap: Option<Pressure>,
) -> Result<(Material, MaterialSpreads), SceneError> {
    let (length, strain_gradient_length) = apart(optional_property::<Length>(
        "material.strain_gradient_length",
        raw.strain_gradient_length.as_ref(),
    )?);
    let (hardness, of_hardness) =
        apart(optional_property::<IndentationHardness>(HARDNESS_KEY, raw.indentation_hardness.as_ref())?);
    let (strength, of_strength) =
        apart(optional_property::<Pressure>("material.yield_strength", raw.yield_strength.as_ref())?);
    let hardness_span = || raw.indentation_hardness.as_ref().map(Spanned::span);
    if of_hardness.is_some() && of_strength.is_some() {
        let message = "yield_strength says how well it is known as well, and the hardness is three times it; keep one of \
                       the two uncertainties";
        let problem = SceneProblem::from(format!("key {HARDNESS_KEY}: {message}"));
        return Err(SceneError { problem, span: hardness_span() });
    }
    let hardness_and_strength = HardnessAndStrength::new(hardness, strength)
        .map_err(|error| SceneError { problem: MaterialError::from(error).into(), span: hardness_span() })?;
    let own = elastic_body("material", &raw.youngs_modulus, &raw.poisson_ratio)?;
    let (counterface, counterface_youngs_modulus, counterface_poisson_ratio) = match counterface {
        Some(known) => (Some(known.body), known.youngs_modulus, known.poisson_ratio),
        None => (None, None, None),
    };
    let material = Material::new(GivenMaterial {
        body: own.body,
        counterface,
        hardness_and_strength,
        strength_cap,
        strain_gradient_length_m: length.map(|length| length.m),
    });
    let spreads = MaterialSpreads {
        youngs_modulus: own.youngs_modulus,
        poisson_ratio: own.poisson_ratio,
        counterface_youngs_modulus,
        counterface_poisson_ratio,
        strength: of_hardness.or(of_strength).map(Spread::over_its_centre),
        strain_gradient_length,
    };
    Ok((material, spreads))
}

const HARDNESS_KEY: &str = "material.indentation_hardness";

fn apart<T>(known: Option<Known<T>>) -> (Option<T>, Option<Spread>) {
    known.map_or((None, None), |known| (Some(known.value), known.spread))
}

/// The body of the counterface; rigid where only its surface is given.
pub(super) fn resolve_counterface(raw: &Spanned<RawCounterface>) -> Result<Option<KnownBody>, SceneError> {
    let counterface = raw.get_ref();
    match (&counterface.youngs_modulus, &counterface.poisson_ratio) {
        (Some(modulus), Some(ratio)) => elastic_body("counterface", modulus, ratio).map(Some),
        (None, None) if counterface.surface.is_some() => Ok(None),
        _ => {
            let message = "[counterface] needs both youngs_modulus and poisson_ratio; with neither of them, only a surface, it \
                           is rigid";
            Err(SceneError::at(raw.span(), message))
        }
    }
}

fn elastic_body(
    section: &str,
    youngs_modulus: &Spanned<RawProperty>,
    ratio: &Spanned<RawProperty>,
) -> Result<KnownBody, SceneError> {
    let modulus: Known<Modulus> = property(&format!("{section}.youngs_modulus"), youngs_modulus)?;
    let key = format!("{section}.poisson_ratio");
    let known_ratio = poisson_ratio(&key, ratio)?;
    let body = ElasticBody::new(modulus.value.pa, known_ratio.value)
        .map_err(|error| SceneError::at(ratio.span(), format!("key {key}: {error}")))?;
    Ok(KnownBody { body, youngs_modulus: modulus.spread, poisson_ratio: known_ratio.spread })
}
