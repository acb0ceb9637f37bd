//! The material and the counterface of a scene.

use std::fmt::Display;
use std::ops::Range;
use std::str::FromStr;

use asperity::ElasticBody;
use serde_spanned::Spanned;

use super::error::{SceneError, SceneProblem};
use super::layer::resolve_layer;
use super::named_material::BodyKeys;
use super::raw::{RawCounterface, RawMaterial, RawProperty};
use super::uncertain::{Property, Uncertain, poisson_ratio, property};
use super::values::{quantity_at, value_error};
use study::bodies::{Bodies, Body, FromTable, Softer, Transport};
use study::body_properties::BodyProperty;
use study::hardness_and_strength::HardnessAndStrength;
use study::material::{GivenMaterial, Material, MaterialError};
use study::material_spreads::MaterialSpreads;
use study::materials::named;
use study::spread::Spread;
use units::display::pressure;
use units::{IndentationHardness, Length, Modulus, Pressure, Resistivity, ThermalConductivity};

/// An elastic body, and how well its constants are known.
pub(super) struct KnownBody {
    body: ElasticBody,
    youngs_modulus: Option<Spread>,
    poisson_ratio: Option<Spread>,
}

/// Hardness and strength of a body, with their uncertainties.
#[derive(Default)]
struct KnownStrength {
    hardness_and_strength: HardnessAndStrength,
    spread: Option<Spread>,
    length: Option<Length>,
    of_length: Option<Spread>,
}

/// Body that presses on the rough body.
#[derive(Default)]
pub(super) struct UncertainCounterface {
    /// Rigid where absent.
    elastic: Option<KnownBody>,
    strength: KnownStrength,
    transport: Transport,
    from_table: Option<FromTable>,
    /// Place of the strain-gradient length in the scene.
    length: Option<Range<usize>>,
}

impl UncertainCounterface {
    /// A body with only its elastic constants.
    pub fn exactly(body: ElasticBody) -> Self {
        let elastic = Some(KnownBody { body, youngs_modulus: None, poisson_ratio: None });
        UncertainCounterface { elastic, ..Self::default() }
    }
}

/// The material against its counterface, the uncertainties of both, and their other properties.
pub(super) fn resolve_material(
    raw: &Spanned<RawMaterial>,
    counterface: UncertainCounterface,
    strength_cap: Option<Pressure>,
) -> Result<(Material, MaterialSpreads, Bodies), SceneError> {
    let keys = BodyKeys::new(raw)?;
    let of_rough = strength(&keys)?;
    let rough = || {
        let modulus = required(&keys, BodyProperty::YoungsModulus)?;
        elastic_body(&keys, modulus, required(&keys, BodyProperty::PoissonRatio)?)
    };
    let layer = raw.get_ref().layer.as_ref();
    let layer = layer.map(|layer| resolve_layer(layer, || exact_body(&keys, rough()?))).transpose()?;
    let own = match layer {
        None => rough()?,
        Some(layer) => {
            if layer.base().is_none() {
                refuse_constants_of_rigid_base(&keys)?;
            }
            KnownBody { body: layer.body(), youngs_modulus: None, poisson_ratio: None }
        }
    };
    let transport = transport(&keys)?;
    let softer = counterface.elastic.as_ref().and_then(|elastic| {
        let counterface = (&counterface.strength.hardness_and_strength, elastic.body);
        Softer::between((&of_rough.hardness_and_strength, own.body), counterface)
    });
    let flows = softer.map_or(Body::Rough, |softer| softer.flows);
    let (flowing, length_of_the_other) = match flows {
        Body::Counterface => {
            (counterface.strength, keys.get(BodyProperty::StrainGradientLength).map(Spanned::span))
        }
        Body::Rough => (of_rough, counterface.length),
    };
    refuse_length_of_the_harder(length_of_the_other, flows)?;
    let (counterface_body, counterface_youngs_modulus, counterface_poisson_ratio) = match counterface.elastic
    {
        Some(known) => (Some(known.body), known.youngs_modulus, known.poisson_ratio),
        None => (None, None, None),
    };
    let modulus_span = || match flows {
        Body::Rough => keys.get(BodyProperty::YoungsModulus).map(Spanned::span),
        Body::Counterface => None,
    };
    let material = Material::new(GivenMaterial {
        body: own.body,
        layer,
        counterface: counterface_body,
        softer,
        hardness_and_strength: flowing.hardness_and_strength,
        strength_cap,
        strain_gradient_length_m: flowing.length.map(|length| length.m),
    })
    .checked()
    .map_err(|error| SceneError { problem: error.into(), span: modulus_span() })?;
    let spreads = MaterialSpreads {
        youngs_modulus: own.youngs_modulus,
        poisson_ratio: own.poisson_ratio,
        counterface_youngs_modulus,
        counterface_poisson_ratio,
        strength: flowing.spread.map(Spread::over_its_centre),
        strain_gradient_length: flowing.of_length,
    };
    let bodies = Bodies {
        transport,
        counterface_transport: counterface.transport,
        from_table: keys.from_table,
        counterface_from_table: counterface.from_table,
    };
    Ok((material, spreads, bodies))
}

/// The base of a layer, whose constants must be exact.
fn exact_body(keys: &BodyKeys, known: KnownBody) -> Result<ElasticBody, SceneError> {
    let uncertain = [
        (BodyProperty::YoungsModulus, known.youngs_modulus.is_some()),
        (BodyProperty::PoissonRatio, known.poisson_ratio.is_some()),
    ];
    match uncertain.into_iter().find(|(_, is_uncertain)| *is_uncertain) {
        None => Ok(known.body),
        Some((property, _)) => {
            let span = keys.get(property).map_or(keys.span.clone(), Spanned::span);
            let key = keys.key(property);
            Err(SceneError::at(
                span,
                format!("key {key}: the base of a layer takes a single value; leave out its uncertainty"),
            ))
        }
    }
}

/// Refuses elastic constants of a body that a rigid base stands for.
fn refuse_constants_of_rigid_base(keys: &BodyKeys) -> Result<(), SceneError> {
    let given = [BodyProperty::YoungsModulus, BodyProperty::PoissonRatio]
        .into_iter()
        .find_map(|property| Some((keys.key(property), keys.get(property)?)));
    given.map_or(Ok(()), |(key, given)| {
        let message =
            format!("key {key}: the base of the layer is rigid; leave this out, or material.layer.base");
        Err(SceneError::at(given.span(), message))
    })
}

/// Refuses a strain-gradient length of the harder body: only that of the body that yields has an effect.
fn refuse_length_of_the_harder(length: Option<Range<usize>>, flows: Body) -> Result<(), SceneError> {
    let Some(span) = length else { return Ok(()) };
    let [yields, other] = match flows {
        Body::Counterface => ["counterface", "material"],
        Body::Rough => ["material", "counterface"],
    };
    let message = format!(
        "key {other}.strain_gradient_length: the {yields} is the body that yields, and this is a length of the other; give \
         {yields}.strain_gradient_length instead"
    );
    Err(SceneError::at(span, message))
}

/// Resolves the body that presses on the rough body. It is rigid if no elastic constants are given.
pub(super) fn resolve_counterface(raw: &Spanned<RawCounterface>) -> Result<UncertainCounterface, SceneError> {
    let keys = BodyKeys::new(raw)?;
    let strength = strength(&keys)?;
    let transport = transport(&keys)?;
    if strength.hardness_and_strength.strength_is_in_hardnesses() {
        let span = keys.get(BodyProperty::YieldStrength).map_or(keys.span.clone(), Spanned::span);
        return Err(SceneError::at(span, MaterialError::StrengthInHardnesses));
    }
    let has_strength = keys.has_strength();
    let has_more = raw.get_ref().surface.is_some() || transport != Transport::default();
    let elastic = match (keys.get(BodyProperty::YoungsModulus), keys.get(BodyProperty::PoissonRatio)) {
        (Some(modulus), Some(ratio)) => Some(elastic_body(&keys, modulus, ratio)?),
        (None, None) if has_more && !has_strength => None,
        (None, None) if has_strength => {
            let message = "[counterface] yields, so that it is not rigid; give its youngs_modulus and poisson_ratio as well, or a \
                           name from the table of materials";
            return Err(SceneError::at(raw.span(), message));
        }
        _ => {
            let message = "[counterface] needs both youngs_modulus and poisson_ratio; with neither of them, only a surface, it \
                           is rigid";
            return Err(SceneError::at(raw.span(), message));
        }
    };
    let length = keys.get(BodyProperty::StrainGradientLength).map(Spanned::span);
    Ok(UncertainCounterface { elastic, strength, transport, from_table: keys.from_table, length })
}

/// The hardness, the strength and its length, as far as they are given.
fn strength(keys: &BodyKeys) -> Result<KnownStrength, SceneError> {
    let (length, of_length) = known::<Length>(keys, BodyProperty::StrainGradientLength)?;
    let (hardness, of_hardness) = known::<IndentationHardness>(keys, BodyProperty::IndentationHardness)?;
    let (strength, of_strength) = known::<Pressure>(keys, BodyProperty::YieldStrength)?;
    let hardness_span = || keys.get(BodyProperty::IndentationHardness).map(Spanned::span);
    if of_hardness.is_some() && of_strength.is_some() {
        let message = "yield_strength says how well it is known as well, and the hardness is three times it; keep one of \
                       the two uncertainties";
        let problem =
            SceneProblem::from(format!("key {}: {message}", keys.key(BodyProperty::IndentationHardness)));
        return Err(SceneError { problem, span: hardness_span() });
    }
    let hardness_and_strength = HardnessAndStrength::new(hardness, strength)
        .map_err(|error| SceneError { problem: MaterialError::from(error).into(), span: hardness_span() })?;
    Ok(KnownStrength { hardness_and_strength, spread: of_hardness.or(of_strength), length, of_length })
}

fn transport(keys: &BodyKeys) -> Result<Transport, SceneError> {
    let conductivity: Option<ThermalConductivity> = exact(keys, BodyProperty::ThermalConductivity)?;
    let resistivity: Option<Resistivity> = exact(keys, BodyProperty::Resistivity)?;
    Ok(Transport {
        thermal_conductivity_w_per_m_k: conductivity.map(|conductivity| conductivity.w_per_m_k),
        resistivity_ohm_m: resistivity.map(|resistivity| resistivity.ohm_m),
    })
}

/// Reads a property that may be uncertain.
fn known<T: Property>(
    keys: &BodyKeys,
    which: BodyProperty,
) -> Result<(Option<T>, Option<Spread>), SceneError> {
    let known = keys.get(which).map(|raw| property::<T>(&keys.key(which), raw)).transpose()?;
    Ok(known.map_or((None, None), |known| (Some(known.value), known.spread)))
}

/// Reads a property that may not be uncertain.
fn exact<T: FromStr<Err: Display>>(keys: &BodyKeys, which: BodyProperty) -> Result<Option<T>, SceneError> {
    match keys.get(which).map(|raw| (raw.get_ref(), raw.span())) {
        Some((RawProperty::Other(value), span)) => quantity_at(&keys.key(which), value, span).map(Some),
        _ => Ok(None),
    }
}

fn required(keys: &BodyKeys, which: BodyProperty) -> Result<&Spanned<RawProperty>, SceneError> {
    let missing = || SceneProblem::MissingKey { key: which.key().to_owned() };
    keys.get(which).ok_or_else(|| SceneError::at(keys.span.clone(), missing()))
}

fn elastic_body(
    keys: &BodyKeys,
    youngs_modulus: &Spanned<RawProperty>,
    ratio: &Spanned<RawProperty>,
) -> Result<KnownBody, SceneError> {
    let modulus: Uncertain<Modulus> = property(&keys.key(BodyProperty::YoungsModulus), youngs_modulus)?;
    refuse_mistaken_prefix(keys, modulus.value.pa, youngs_modulus.span())?;
    let key = keys.key(BodyProperty::PoissonRatio);
    let known_ratio = poisson_ratio(&key, ratio)?;
    let body = ElasticBody::new(modulus.value.pa, known_ratio.value)
        .map_err(|error| SceneError::at(ratio.span(), format!("key {key}: {error}")))?;
    Ok(KnownBody { body, youngs_modulus: modulus.spread, poisson_ratio: known_ratio.spread })
}

/// Ratio of a modulus to that of the table, either way, from which a prefix is mistaken: grades differ by less.
const OTHER_PREFIX: f64 = 100.0;

/// A modulus with the prefix that brings it closest to that of the table.
fn prefixed(modulus_pa: f64, tabled_pa: f64) -> String {
    let steps = ((tabled_pa / modulus_pa).log10() / 3.0).round();
    pressure(modulus_pa * 1e3f64.powi(steps as i32))
}

/// Refuses a modulus far from that of the named material.
fn refuse_mistaken_prefix(keys: &BodyKeys, modulus_pa: f64, span: Range<usize>) -> Result<(), SceneError> {
    let Some(FromTable { name, .. }) = &keys.from_table else { return Ok(()) };
    let tabled =
        named(name).ok().and_then(|material| material.quantity::<Modulus>(BodyProperty::YoungsModulus));
    match tabled.map(|tabled| tabled.pa) {
        Some(tabled_pa) if (tabled_pa / modulus_pa).ln().abs() > OTHER_PREFIX.ln() => {
            let typed = pressure(modulus_pa);
            let problem = format!(
                "{typed}, but {name} has {}; did you mean {}?",
                pressure(tabled_pa),
                prefixed(modulus_pa, tabled_pa)
            );
            Err(value_error(&keys.key(BodyProperty::YoungsModulus), &typed, span, problem))
        }
        _ => Ok(()),
    }
}
