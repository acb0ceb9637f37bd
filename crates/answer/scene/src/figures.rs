//! The figures of a scene.

use serde_spanned::Spanned;

use super::error::SceneError;
use super::figure_style::{
    Defaults, curve_index, curves_of_models, font_size_pt, formats, loads_of, title, width_mm,
};
use super::loads::nominal_pressure;
use super::raw::{RawFigure, RawFigureLoads, RawLoadRange, RawScene};
use super::values::check_file_name;
use study::figure::{Figure, FigureStyle, Shows};
use study::material::Material;
use study::plan::{Curve, Cutoffs, Load, LoadRange, LoadSweep, NominalPressure};

/// The figures, and the sweeps over loads that they draw.
pub(super) fn resolve_figures(
    raw: &RawScene,
    curves: &[Curve],
    loads: &[Load],
    material: Option<&Material>,
) -> Result<(Vec<Figure>, Vec<LoadSweep>), SceneError> {
    let defaults = Defaults::new(raw, curves, loads, material)?;
    let are_all = raw.curve.is_empty() && defaults.models.is_none();
    let raw = &raw.figure;
    if raw.is_empty() {
        let mut over_cutoffs = followed(curves);
        defaults.keep_models(&mut over_cutoffs);
        let any = !over_cutoffs.is_empty();
        let all = || Figure {
            style: defaults.style,
            loads: defaults.loads.clone(),
            draws_nearest: are_all,
            formats: defaults.formats.clone(),
            ..Figure::area_of_all(over_cutoffs)
        };
        return Ok((any.then(all).into_iter().collect(), Vec::new()));
    }
    let mut figures: Vec<Figure> = Vec::new();
    let mut sweeps = Vec::new();
    for spanned in raw {
        let figure = spanned.get_ref();
        let name = figure.name.get_ref();
        check_file_name(name, figure.name.span())?;
        if figures.iter().any(|other| &other.name == name) || curves.iter().any(|curve| &curve.name == name) {
            let message =
                format!("another figure or curve is called {name:?}, and so would be its file; rename one");
            return Err(SceneError::at(figure.name.span(), message));
        }
        if figure.shows.draws_areas() && curves.is_empty() {
            return Err(SceneError::at(spanned.span(), "a figure of the area needs a [[curve]]"));
        }
        let mut drawn = match &figure.curves {
            None if figure.shows == Shows::Area => followed(curves),
            None => (0..curves.len()).collect(),
            Some(names) => names
                .iter()
                .map(|name| drawn_curve(name, curves, figure.shows))
                .collect::<Result<Vec<_>, _>>()?,
        };
        keep_first_of_each(&mut drawn);
        match &figure.models {
            Some(models) => {
                let models = curves_of_models(models, curves)?;
                drawn.retain(|curve| models.contains(curve));
            }
            None => defaults.keep_models(&mut drawn),
        }
        if drawn.is_empty() && figure.shows.draws_areas() {
            return Err(SceneError::at(
                spanned.span(),
                match figure.curves {
                    _ if figure.models.is_some() || defaults.models.is_some() => {
                        "a figure of the area draws at least one curve; models leaves none"
                    }
                    Some(_) => "a figure of the area draws at least one curve; curves is empty",
                    None => {
                        "a figure of the area against cutoff needs a [[curve]] without cutoffs = \"shortest\""
                    }
                },
            ));
        }
        let first_sweep = sweeps.len();
        if figure.shows == Shows::AreaAgainstLoad {
            sweeps.extend(load_sweeps(spanned, &drawn, material)?);
        }
        figures.push(Figure {
            name: name.clone(),
            shows: figure.shows,
            title: title(figure)?,
            curves: drawn,
            loads: match figure.loads.as_ref().map(Spanned::get_ref) {
                Some(RawFigureLoads::Other(some)) => Some(loads_of(some, loads, material)?),
                _ => defaults.loads.clone(),
            },
            draws_nearest: are_all && figure.curves.is_none() && figure.models.is_none(),
            formats: figure.format.as_ref().map_or_else(|| defaults.formats.clone(), |own| formats(own)),
            style: FigureStyle {
                hides_title: match figure.title.as_ref().map(Spanned::get_ref) {
                    Some(toml::Value::Boolean(shown)) => !shown,
                    Some(_) => false,
                    None => defaults.style.hides_title,
                },
                width_mm: width_mm(figure.width.as_ref())?.or(defaults.style.width_mm),
                font_size_pt: font_size_pt(figure.font_size.as_ref())?.or(defaults.style.font_size_pt),
            },
            sweeps: (first_sweep..sweeps.len()).collect(),
        });
    }
    Ok((figures, sweeps))
}

/// Removes repeated items, so that each is drawn once.
fn keep_first_of_each<T: PartialEq + Copy>(items: &mut Vec<T>) {
    let mut kept: Vec<T> = Vec::with_capacity(items.len());
    items.retain(|item| {
        let is_new = !kept.contains(item);
        kept.extend(is_new.then_some(*item));
        is_new
    });
}

/// The curves with an area at every cutoff, by index.
fn followed(curves: &[Curve]) -> Vec<usize> {
    (0..curves.len()).filter(|&curve| curves[curve].cutoffs == Cutoffs::Every).collect()
}

fn drawn_curve(name: &Spanned<String>, curves: &[Curve], shows: Shows) -> Result<usize, SceneError> {
    let curve = curve_index(name, curves)?;
    if shows == Shows::Area && curves[curve].cutoffs == Cutoffs::Shortest {
        let message = format!(
            "a figure of the area against cutoff cannot draw {:?}, whose cutoffs = \"shortest\"; take one of them away",
            name.get_ref()
        );
        return Err(SceneError::at(name.span(), message));
    }
    Ok(curve)
}

/// Every curve of a figure of area against load, at every cutoff.
fn load_sweeps(
    spanned: &Spanned<RawFigure>,
    drawn: &[usize],
    material: Option<&Material>,
) -> Result<Vec<LoadSweep>, SceneError> {
    let figure = spanned.get_ref();
    let Some(RawFigureLoads::Table(range)) = figure.loads.as_ref().map(Spanned::get_ref) else {
        let message = "area-against-load needs loads = { from = \"1e-6 H\", to = \"1 H\", points = 41 }";
        return Err(SceneError::at(spanned.span(), message));
    };
    let pressures_pa = load_range(range, material)?;
    let mut multiples = figure.cutoff_multiples.clone().unwrap_or_else(|| vec![1.0]);
    keep_first_of_each(&mut multiples);
    if let Some(wrong) = multiples.iter().find(|multiple| !(multiple.is_finite() && **multiple >= 1.0)) {
        let message = format!(
            "key figure.cutoff_multiples: {wrong} must be finite and at least 1, a multiple of the shortest wavelength"
        );
        return Err(SceneError::at(spanned.span(), message));
    }
    let sweep = |curve: usize| {
        let pressures_pa = &pressures_pa;
        multiples.iter().map(move |&cutoff_multiple| LoadSweep {
            curve,
            cutoff_multiple,
            pressures_pa: pressures_pa.clone(),
        })
    };
    Ok(drawn.iter().flat_map(|&curve| sweep(curve)).collect())
}

/// Pressures \[Pa\] evenly spaced in their logarithms, both ends included.
fn load_range(range: &RawLoadRange, material: Option<&Material>) -> Result<Vec<f64>, SceneError> {
    let from = nominal_pressure("figure.loads.from", &range.from, material)?;
    let to = nominal_pressure("figure.loads.to", &range.to, material)?;
    let points = *range.points.get_ref();
    if !(2..=100_000).contains(&points) {
        let message = format!("key figure.loads.points: {points} must be a whole number from 2 to 100000");
        return Err(SceneError::at(range.points.span(), message));
    }
    Ok(LoadRange::new(from, to, points).pressures().map(NominalPressure::pa).collect())
}
