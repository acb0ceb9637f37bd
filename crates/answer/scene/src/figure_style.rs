//! The look of figures and their choice of models and loads, given for each or for all.

use serde_spanned::Spanned;
use study::figure::{Figure, FigureStyle, PictureFormat};
use study::material::Material;
use study::plan::{Curve, Load};
use units::printable::listed;
use units::{Bound, Length, OutOfBounds};

use super::Scene;
use super::error::SceneError;
use super::loads::nominal_pressure;
use super::raw::{RawFigure, RawFigureDefaults, RawQuantity, RawScene, Typed};
use super::spelling::meant;
use super::values::{number, text_of, value_error};

const WIDTH_MM: Bound = Bound::Within { at_least: 30.0, at_most: 1000.0 };
const FONT_SIZE_PT: Bound = Bound::Within { at_least: 3.0, at_most: 40.0 };

/// A choice among the figures of a scene, and settings that count more than theirs. What is empty leaves all as it is.
#[derive(Debug, Clone, Default)]
pub struct FigureChoice {
    /// The names of the figures.
    pub only: Vec<String>,
    /// The width in print.
    pub width: Option<Length>,
    /// The size of letters in print, in points.
    pub font_size_pt: Option<f64>,
    /// True to draw neither titles nor subjects.
    pub hides_title: bool,
    /// The models to draw, as under the key `models`.
    pub models: Vec<String>,
    /// The loads to draw, as under the key `loads`.
    pub loads: Vec<String>,
}

impl Scene {
    /// Keeps some of the figures, and changes their look.
    ///
    /// # Errors
    /// A name, a size, a model or a load that the scene does not have or that is out of range.
    pub fn choose_figures(&mut self, choice: &FigureChoice) -> Result<(), SceneError> {
        let spanned = |text: &String| Spanned::new(0..0, text.clone());
        let names: Vec<&str> = self.figures.iter().map(|figure| figure.name.as_str()).collect();
        if let Some(unknown) = choice.only.iter().find(|name| !names.contains(&name.as_str())) {
            let hint = meant(unknown, names.iter().copied())
                .map_or_else(String::new, |meant| format!(", did you mean {meant:?}?"));
            let message =
                format!("there is no figure {unknown:?}{hint}; the figures are {}", listed(&names, ""));
            return Err(SceneError::anywhere(message));
        }
        let width_mm = choice.width.map(|width| WIDTH_MM.check("the width in mm", 1e3 * width.m));
        let font_size_pt = choice.font_size_pt.map(|size| FONT_SIZE_PT.check("the size in points", size));
        let wrong = |error: OutOfBounds| SceneError::anywhere(error.to_string());
        let width_mm = width_mm.transpose().map_err(wrong)?;
        let font_size_pt = font_size_pt.transpose().map_err(wrong)?;
        let models: Vec<_> = choice.models.iter().map(spanned).collect();
        let models =
            (!models.is_empty()).then(|| curves_of_models(&models, &self.needs.curves)).transpose()?;
        let loads: Vec<_> =
            choice.loads.iter().map(|load| Spanned::new(0..0, toml::Value::String(load.clone()))).collect();
        let loads = (!loads.is_empty())
            .then(|| loads_of(&loads, &self.needs.loads, self.material.as_ref()))
            .transpose()?;
        self.figures.retain(|figure| choice.only.is_empty() || choice.only.contains(&figure.name));
        for figure in &mut self.figures {
            let style = &mut figure.style;
            style.width_mm = width_mm.or(style.width_mm);
            style.font_size_pt = font_size_pt.or(style.font_size_pt);
            style.hides_title |= choice.hides_title;
            figure.loads = loads.clone().or(figure.loads.take());
            if let Some(models) = &models {
                figure.keep_curves(models, &self.needs);
                figure.draws_nearest = false;
            }
        }
        let lacks_curves = |figure: &&Figure| figure.shows.draws_areas() && figure.curves.is_empty();
        match self.figures.iter().find(lacks_curves) {
            Some(figure) => {
                let message = format!("figure {:?} draws none of these models; choose others", figure.name);
                Err(SceneError::anywhere(message))
            }
            None => Ok(()),
        }
    }
}

/// The settings of figures that have none of their own, from `[figures]`.
pub(super) struct Defaults {
    pub style: FigureStyle,
    /// Curves of the listed models, by index.
    pub models: Option<Vec<usize>>,
    pub loads: Option<Vec<usize>>,
    pub formats: Vec<PictureFormat>,
}

impl Defaults {
    pub fn new(
        raw: &RawScene,
        curves: &[Curve],
        loads: &[Load],
        material: Option<&Material>,
    ) -> Result<Self, SceneError> {
        let of_all = RawFigureDefaults::default();
        let raw = raw.figures.as_ref().unwrap_or(&of_all);
        let style = FigureStyle {
            width_mm: width_mm(raw.width.as_ref())?,
            font_size_pt: font_size_pt(raw.font_size.as_ref())?,
            hides_title: raw.title.as_ref().is_some_and(|shown| !shown.get_ref()),
        };
        let models = raw.models.as_ref().map(|models| curves_of_models(models, curves)).transpose()?;
        let loads = raw.loads.as_ref().map(|some| loads_of(some, loads, material)).transpose()?;
        let formats = formats(raw.format.as_deref().unwrap_or_default());
        Ok(Defaults { style, models, loads, formats })
    }

    /// Removes the curves of models that are not drawn.
    pub fn keep_models(&self, drawn: &mut Vec<usize>) {
        drawn.retain(|curve| self.models.as_ref().is_none_or(|models| models.contains(curve)));
    }
}

/// The listed formats, each once, with SVG, from which the others are made.
pub(super) fn formats(listed: &[PictureFormat]) -> Vec<PictureFormat> {
    let all = [PictureFormat::Svg, PictureFormat::Png, PictureFormat::Pdf, PictureFormat::Script];
    all.into_iter().filter(|format| *format == PictureFormat::Svg || listed.contains(format)).collect()
}

/// The title of a figure, if it is a text.
pub(super) fn title(figure: &RawFigure) -> Result<Option<String>, SceneError> {
    match figure.title.as_ref().map(|title| (title.get_ref(), title.span())) {
        None | Some((toml::Value::Boolean(_), _)) => Ok(None),
        Some((toml::Value::String(text), _)) => Ok(Some(text.clone())),
        Some((other, span)) => Err(value_error(
            "figure.title",
            &other.to_string(),
            span,
            format!("{other}: write a text in quotes, or false"),
        )),
    }
}

pub(super) fn width_mm(raw: Option<&Typed<Length>>) -> Result<Option<f64>, SceneError> {
    let Some(raw) = raw else { return Ok(None) };
    let checked = WIDTH_MM.check("the width in mm", 1e3 * raw.value.m);
    checked.map(Some).map_err(|error| value_error("figure.width", &raw.text, raw.span(), error))
}

pub(super) fn font_size_pt(raw: Option<&Spanned<f64>>) -> Result<Option<f64>, SceneError> {
    raw.map(|raw| number("figure.font_size", "the size in points", raw, FONT_SIZE_PT)).transpose()
}

/// The curves of some models, by index. A model is named by its key, by the name of a curve, or as people call it.
pub(super) fn curves_of_models(
    models: &[Spanned<String>],
    curves: &[Curve],
) -> Result<Vec<usize>, SceneError> {
    let mut found = Vec::new();
    for model in models {
        let name = model.get_ref();
        let all = |is_meant: fn(&Curve, &str) -> bool| -> Vec<usize> {
            (0..curves.len()).filter(|&at| is_meant(&curves[at], name)).collect()
        };
        let meant = [
            all(|curve, name| curve.model.entry.name == name),
            all(|curve, name| curve.name == name),
            all(|curve, name| curve.model.entry.answers_to(name)),
        ];
        match meant.into_iter().find(|meant| !meant.is_empty()) {
            Some(meant) => found.extend(meant),
            None => found.push(curve_index(model, curves)?),
        }
    }
    Ok(found)
}

/// The curve of this name, by index.
pub(super) fn curve_index(name: &Spanned<String>, curves: &[Curve]) -> Result<usize, SceneError> {
    curves.iter().position(|curve| &curve.name == name.get_ref()).ok_or_else(|| {
        let known: Vec<&str> = curves.iter().map(|curve| curve.name.as_str()).collect();
        let meant = meant(name.get_ref(), known.iter().copied());
        let hint = meant.map_or_else(String::new, |meant| format!(", did you mean {meant:?}?"));
        let message =
            format!("there is no curve {:?}{hint}; the curves are {}", name.get_ref(), listed(&known, ""));
        SceneError::at(name.span(), message)
    })
}

/// Some loads of the scene, by index: by their labels, or the same pressure in another unit.
pub(super) fn loads_of(
    some: &[RawQuantity],
    loads: &[Load],
    material: Option<&Material>,
) -> Result<Vec<usize>, SceneError> {
    let index = |raw: &RawQuantity| {
        let typed = text_of(raw.get_ref()).trim().to_owned();
        if let Some(at) = loads.iter().position(|load| load.label == typed) {
            return Ok(at);
        }
        let pressure =
            Typed::read(raw).map_err(|error: SceneError| error.or_at(raw.span()).below("figure.loads"))?;
        let pressure_pa = nominal_pressure("figure.loads", &pressure, material)?.pa();
        let is_meant = |load: &Load| (load.nominal_pressure_pa() / pressure_pa - 1.0).abs() < 1e-9;
        loads.iter().position(is_meant).ok_or_else(|| {
            let known: Vec<&str> = loads.iter().map(|load| load.label.as_str()).collect();
            let problem = format!("{typed} is no load of the scene; these are {}", listed(&known, ""));
            value_error("figure.loads", &typed, raw.span(), problem)
        })
    };
    some.iter().map(index).collect()
}
