//! From what was typed in a scene to what it means.

use std::num::NonZeroU32;
use std::path::Path;
use std::str::FromStr;

use asperity::{ElasticBody, Hardness};
use serde_spanned::Spanned;
use spectrum::{AmplitudeDefinition, Normalisation, ReadOptions};

use super::Scene;
use super::diagnostic::SceneError;
use super::raw::{RawCurve, RawFigure, RawLoads, RawMaterial, RawQuantity, RawScene, RawSurface};
use crate::failure::Failure;
use crate::figure::{Figure, Shows};
use crate::material::{GivenMaterial, Material, StackedModelName};
use crate::plan::{Curve, Load, Needs, Sampling};
use crate::quantity::{Area, Force, Length, Pressure};
use crate::surface::Surface;

/// Options given outside the scene, which count more than the scene's own.
#[derive(Debug, Clone, Default)]
pub struct Overrides {
    /// Normalisation of the moments.
    pub normalisation: Option<Normalisation>,
    /// Definition of the amplitude.
    pub amplitude: Option<AmplitudeDefinition>,
    /// Scales per decade to resample to.
    pub scales_per_decade: Option<NonZeroU32>,
    /// Form of the hardness of spheres.
    pub hardness: Option<Hardness>,
    /// Cap of a growing strength.
    pub strength_cap: Option<Pressure>,
    /// Shortest wavelength kept.
    pub cutoff: Option<Length>,
    /// Counterface.
    pub counterface: Option<ElasticBody>,
}

pub(super) fn resolve(raw: RawScene, folder: &Path, overrides: &Overrides) -> Result<Scene, SceneError> {
    let options = raw.options;
    let strength_cap = match overrides.strength_cap {
        Some(cap) => Some(cap),
        None => optional("options.strength_cap", options.strength_cap.as_ref())?,
    };
    let counterface = match (overrides.counterface, &raw.counterface) {
        (Some(body), _) => Some(body),
        (None, Some(raw)) => Some(elastic_body("counterface", &raw.youngs_modulus, &raw.poisson_ratio)?),
        (None, None) => None,
    };
    let material = raw
        .material
        .as_ref()
        .map(|material| resolve_material(material, counterface, strength_cap))
        .transpose()?;
    let cutoff: Option<Length> =
        optional("cutoffs.shortest_wavelength", raw.cutoffs.shortest_wavelength.as_ref())?;
    let scales_per_decade = options.scales_per_decade.as_ref().map(resolve_scales_per_decade).transpose()?;
    let curves = resolve_curves(&raw.curve, material.as_ref())?;
    let loads = match &raw.loads {
        Some(loads) => resolve_loads(loads, material.as_ref())?,
        None if curves.is_empty() => Vec::new(),
        None => {
            return Err(SceneError::anywhere(
                "the scene has curves but no section [loads]; add pressures = [...]",
            ));
        }
    };
    let figures = resolve_figures(&raw.figure, &curves)?;
    if curves.is_empty() && figures.is_empty() {
        return Err(SceneError::anywhere("the scene asks for nothing; add a [[curve]] or a [[figure]]"));
    }
    let shows = |wanted: &[Shows]| figures.iter().any(|figure| wanted.contains(&figure.shows));
    let normalisation = overrides.normalisation.or(options.normalisation).unwrap_or_default();
    let amplitude = overrides.amplitude.or(options.amplitude).unwrap_or_default();
    Ok(Scene {
        title: raw.title.unwrap_or_else(|| raw.surface.psd.get_ref().clone()),
        surface: resolve_surface(&raw.surface, folder)?,
        material,
        hardness: overrides.hardness.or(options.hardness).unwrap_or_default(),
        sampling: Sampling {
            scales_per_decade: overrides.scales_per_decade.or(scales_per_decade),
            cutoff_m: overrides.cutoff.or(cutoff).map(|cutoff| cutoff.m),
        },
        needs: Needs {
            moments: shows(&[Shows::Moments]).then_some(normalisation),
            amplitudes: (!curves.is_empty() || shows(&[Shows::Amplitude, Shows::AspectRatio]))
                .then_some(amplitude),
            fit_band_m: None,
            curves,
            loads,
        },
        figures,
    })
}

fn resolve_surface(raw: &RawSurface, folder: &Path) -> Result<Surface, SceneError> {
    let options = ReadOptions {
        column: raw.column.clone(),
        x: raw.x.as_ref().map(|text| parsed("surface.x", text)).transpose()?,
        convention: raw.convention.as_ref().map(|text| parsed("surface.convention", text)).transpose()?,
    };
    Surface::load(raw.psd.get_ref(), folder, &options).map_err(|failure| match failure {
        Failure::Input(message) => SceneError::at(raw.psd.span(), message),
        other => SceneError::anywhere(format!("{other:?}")),
    })
}

fn resolve_material(
    raw: &RawMaterial,
    counterface: Option<ElasticBody>,
    strength_cap: Option<Pressure>,
) -> Result<Material, SceneError> {
    let body = elastic_body("material", &raw.youngs_modulus, &raw.poisson_ratio)?;
    let strength = optional("material.yield_strength", raw.yield_strength.as_ref())?;
    let gradient: Option<Length> =
        optional("material.strain_gradient_length", raw.strain_gradient_length.as_ref())?;
    let given = GivenMaterial {
        body,
        counterface,
        yield_strength: strength,
        strength_cap,
        strain_gradient_length_m: gradient.map(|length| length.m),
    };
    Material::new(given).map_err(|error| match &raw.yield_strength {
        Some(strength) => SceneError::at(strength.span(), error),
        None => SceneError::anywhere(error),
    })
}

fn elastic_body(
    section: &str,
    youngs_modulus: &RawQuantity,
    poisson_ratio: &Spanned<f64>,
) -> Result<ElasticBody, SceneError> {
    let modulus: Pressure = quantity(&format!("{section}.youngs_modulus"), youngs_modulus)?;
    let Some(modulus_pa) = modulus.pascals(None) else {
        let message = format!("key {section}.youngs_modulus: a modulus cannot be given in H; give it in GPa");
        return Err(SceneError::at(youngs_modulus.span(), message));
    };
    ElasticBody::new(modulus_pa, *poisson_ratio.get_ref()).map_err(|error| {
        SceneError::at(poisson_ratio.span(), format!("key {section}.poisson_ratio: {error}"))
    })
}

fn resolve_scales_per_decade(raw: &Spanned<i64>) -> Result<NonZeroU32, SceneError> {
    u32::try_from(*raw.get_ref()).ok().and_then(NonZeroU32::new).ok_or_else(|| {
        let message =
            format!("key options.scales_per_decade: {} must be a whole number from 1 on", raw.get_ref());
        SceneError::at(raw.span(), message)
    })
}

fn resolve_curves(raw: &[Spanned<RawCurve>], material: Option<&Material>) -> Result<Vec<Curve>, SceneError> {
    let mut curves: Vec<Curve> = Vec::new();
    for spanned in raw {
        let curve = spanned.get_ref();
        let Some(material) = material else {
            return Err(SceneError::at(spanned.span(), "a curve needs a section [material]"));
        };
        let model = material
            .stacked(curve.model, curve.strain_gradient)
            .map_err(|error| SceneError::at(spanned.span(), error))?;
        let name = curve.name.as_ref().map_or_else(|| default_name(curve), |name| name.get_ref().clone());
        let name_span = curve.name.as_ref().map_or_else(|| spanned.span(), Spanned::span);
        check_file_name(&name, name_span.clone())?;
        if curves.iter().any(|other| other.name == name) {
            let message = format!("two curves are called {name:?}; give one of them another name = \"...\"");
            return Err(SceneError::at(name_span, message));
        }
        curves.push(Curve { name, model });
    }
    Ok(curves)
}

fn default_name(curve: &RawCurve) -> String {
    match (curve.model, curve.strain_gradient) {
        (StackedModelName::Elastic, _) => "elastic",
        (StackedModelName::ElasticPlastic, false) => "elastic-plastic",
        (StackedModelName::ElasticPlastic, true) => "elastic-plastic-strain-gradient",
    }
    .to_owned()
}

/// The names of curves and figures become those of files.
fn check_file_name(name: &str, span: std::ops::Range<usize>) -> Result<(), SceneError> {
    let plain = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | '.');
    if name.chars().all(plain) && name.starts_with(char::is_alphanumeric) {
        return Ok(());
    }
    let message = format!("{name:?} becomes the name of a file; use letters, digits, '-', '_' and '.' only");
    Err(SceneError::at(span, message))
}

fn resolve_loads(raw: &Spanned<RawLoads>, material: Option<&Material>) -> Result<Vec<Load>, SceneError> {
    let loads = raw.get_ref();
    let resolved = match (&loads.pressures, &loads.force, &loads.nominal_area) {
        (Some(pressures), None, None) => {
            pressures.iter().map(|raw| pressure_load(raw, material)).collect::<Result<_, _>>()?
        }
        (None, Some(force), Some(area)) => vec![force_load(force, area)?],
        _ => {
            let message = "[loads] takes either pressures = [...], or force and nominal_area together";
            return Err(SceneError::at(raw.span(), message));
        }
    };
    if resolved.is_empty() {
        return Err(SceneError::at(raw.span(), "[loads] is empty; give at least one pressure"));
    }
    Ok(resolved)
}

fn pressure_load(raw: &RawQuantity, material: Option<&Material>) -> Result<Load, SceneError> {
    let pressure: Pressure = quantity("loads.pressures", raw)?;
    let nominal_pressure_pa = pressure.pascals(material.and_then(Material::hardness_pa)).ok_or_else(|| {
        let message = "key loads.pressures: a pressure in H, three times the yield strength, needs material.yield_strength";
        SceneError::at(raw.span(), message)
    })?;
    Ok(Load { nominal_pressure_pa, label: label(raw) })
}

fn force_load(force: &RawQuantity, area: &RawQuantity) -> Result<Load, SceneError> {
    let Force { n } = quantity("loads.force", force)?;
    let Area { m2 } = quantity("loads.nominal_area", area)?;
    Ok(Load { nominal_pressure_pa: n / m2, label: format!("{} on {}", label(force), label(area)) })
}

fn label(raw: &RawQuantity) -> String {
    raw.get_ref().as_str().unwrap_or_default().trim().to_owned()
}

fn resolve_figures(raw: &[Spanned<RawFigure>], curves: &[Curve]) -> Result<Vec<Figure>, SceneError> {
    if raw.is_empty() && !curves.is_empty() {
        return Ok(vec![Figure::area_of_all(curves.len())]);
    }
    let mut figures: Vec<Figure> = Vec::new();
    for spanned in raw {
        let figure = spanned.get_ref();
        let name = figure.name.get_ref();
        check_file_name(name, figure.name.span())?;
        if figures.iter().any(|other| &other.name == name) || curves.iter().any(|curve| &curve.name == name) {
            let message =
                format!("another figure or curve is called {name:?}, and so would be its file; rename one");
            return Err(SceneError::at(figure.name.span(), message));
        }
        if figure.shows == Shows::Area && curves.is_empty() {
            return Err(SceneError::at(spanned.span(), "a figure of the area needs a [[curve]]"));
        }
        figures.push(Figure {
            name: name.clone(),
            shows: figure.shows,
            title: figure.title.clone(),
            curves: match &figure.curves {
                None => (0..curves.len()).collect(),
                Some(names) => {
                    names.iter().map(|name| curve_index(name, curves)).collect::<Result<_, _>>()?
                }
            },
        });
    }
    Ok(figures)
}

fn curve_index(name: &Spanned<String>, curves: &[Curve]) -> Result<usize, SceneError> {
    curves.iter().position(|curve| &curve.name == name.get_ref()).ok_or_else(|| {
        let known: Vec<&str> = curves.iter().map(|curve| curve.name.as_str()).collect();
        let message = format!("there is no curve {:?}; the curves are {}", name.get_ref(), known.join(", "));
        SceneError::at(name.span(), message)
    })
}

fn optional<T: FromStr<Err: std::fmt::Display>>(
    key: &str,
    raw: Option<&RawQuantity>,
) -> Result<Option<T>, SceneError> {
    raw.map(|raw| quantity(key, raw)).transpose()
}

/// A quantity with its unit; a bare number is read as text without one, so that the message tells the units.
fn quantity<T: FromStr<Err: std::fmt::Display>>(key: &str, raw: &RawQuantity) -> Result<T, SceneError> {
    let text = match raw.get_ref() {
        toml::Value::String(text) => text.clone(),
        other => other.to_string(),
    };
    text.parse().map_err(|error| SceneError::at(raw.span(), format!("key {key}: {error}")))
}

fn parsed<T: FromStr<Err: std::fmt::Display>>(key: &str, text: &Spanned<String>) -> Result<T, SceneError> {
    text.get_ref().parse().map_err(|error| SceneError::at(text.span(), format!("key {key}: {error}")))
}
