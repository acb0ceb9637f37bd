//! Contact against cutoff, of a spectrum: the stacked and the statistical models.

use asperity::Hardness;
use findings::doubts::{Doubt, RealPressures};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use report::summary::{CurveCounts, sampling_of};
use report::{doubt_words, material_words};
use spectrum::{AmplitudeDefinition, Normalisation};
use stat_contact::InterferenceLaw;
use study::material::Material;
use study::models::{self, Choice, Framework, ModelEntry, ModelOptions};
use study::plan::{Curve, CurveResult, Cutoffs, Needs, NominalPressure, Plan, Tolerance};
use study::result_tables::part_of_curve;
use units::SignedLength;

use crate::errors::{input, of_argument};
use crate::material::{PyMaterial, is_several, loads, told};
use crate::quantities::{Given, quantity};
use crate::surface::{PySurface, named, notes, sampling};
use crate::tables::columns;
use crate::work::carry_out;

/// Result of a curve: its columns block after block, the pressures of the blocks \[Pa\], and the notes.
type Found<'py> = (Bound<'py, PyDict>, Vec<f64>, Vec<String>);

/// A curve of a model of a framework over the cutoffs of a spectrum, under each of the pressures, and behind them at each of the
/// separations.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the arguments of a call from Python, by name")]
pub fn curve<'py>(
    py: Python<'py>,
    framework: &str,
    model: &str,
    surface: &PySurface,
    material: &PyMaterial,
    pressure: Option<&Given<'py>>,
    separation: Option<&Given<'py>>,
    strain_gradient: bool,
    hardness: Option<&str>,
    interference_law: Option<&str>,
    normalisation: &str,
    amplitude: &str,
    tolerance: f64,
    cutoff: Option<&Given<'py>>,
    scales_per_decade: Option<i64>,
) -> PyResult<Found<'py>> {
    let framework = match framework {
        "stacked" => Framework::Stacked,
        _ => Framework::Statistical,
    };
    let entry = models::named(framework, model).map_err(|error| of_argument("model", error))?;
    let (psd, material) = (&surface.surface.psd, &material.material);
    let options = model_options(entry, strain_gradient, hardness, interference_law)?;
    let curve = Curve {
        name: entry.to_string(),
        model: entry.build(material, &options).map_err(|error| told(&error))?,
        cutoffs: Cutoffs::Every,
    };
    let needs = Needs {
        moments: (framework == Framework::Statistical)
            .then(|| named::<Normalisation>("normalisation", normalisation))
            .transpose()?,
        amplitudes: (framework == Framework::Stacked)
            .then(|| named::<AmplitudeDefinition>("amplitude", amplitude))
            .transpose()?,
        curves: vec![curve.clone()],
        loads: pressure.map_or(Ok(Vec::new()), |pressure| loads("pressure", pressure, material))?,
        separations_m: separation.map_or(Ok(Vec::new()), separations_m)?,
        tolerance: Tolerance::new(tolerance).map_err(input)?,
        ..Needs::default()
    };
    if needs.loads.is_empty() && needs.separations_m.is_empty() {
        return Err(input("pressure or separation is needed; give one of them"));
    }
    let plan = Plan { psd, sampling: sampling(&surface.surface, cutoff, scales_per_decade)?, needs };
    let results = carry_out(py, None, |progress| plan.compute_observed(progress))?.map_err(input)?;
    let mut said = notes(&surface.surface);
    let rows = &results.curves[0];
    if framework == Framework::Stacked {
        said.push(format!(
            "{}; the area depends on how densely scales are sampled",
            sampling_of(&results.psd)
        ));
    }
    said.extend(findings(&curve, rows, &plan, material));
    let pressures_pa: Vec<f64> = plan.needs.pressures().map(NominalPressure::pa).collect();
    let table = part_of_curve(rows, &pressures_pa, false, true);
    Ok((columns(py, &table)?, pressures_pa, said))
}

/// Words the open questions of a curve, and the limits that it exceeds.
pub fn findings(curve: &Curve, rows: &CurveResult, plan: &Plan<'_>, material: &Material) -> Vec<String> {
    let hardness_pa = material.hardness_pa();
    let needs = &plan.needs;
    let mut counts = CurveCounts::default();
    counts.add(rows);
    let mut real_pressures = RealPressures::new(hardness_pa);
    let pressures_pa: Vec<f64> = needs.pressures().map(NominalPressure::pa).collect();
    real_pressures.add_part(curve, rows, &pressures_pa);
    let labels = needs.loads.iter().map(|load| Some(load.label.as_str()));
    let doubts = Doubt::of_material(material)
        .into_iter()
        .chain(Doubt::of_spectrum(plan.psd))
        .chain(Doubt::of_pressures(needs.pressures().zip(labels), hardness_pa))
        .chain(real_pressures.doubts());
    let mut said = report::question_words::of_counts(&counts);
    said.extend(material_words::assumed_strength(material, curve.model.entry()));
    said.extend(doubts.map(|doubt| format!("doubtful: {}", doubt_words::line(&doubt))));
    said
}

/// The separations \[m\] of an argument that is one, or several of them.
fn separations_m(given: &Given<'_>) -> PyResult<Vec<f64>> {
    let one =
        |argument: &str, given: &Given<'_>| quantity::<SignedLength>(argument, given).map(|length| length.m);
    if !is_several(given) {
        return Ok(vec![one("separation", given)?]);
    }
    let each = given.try_iter()?.enumerate();
    each.map(|(at, given)| one(&format!("separation[{at}]"), &given?)).collect()
}

/// The choices made for a model; those that it does not have are refused.
pub fn model_options(
    entry: &ModelEntry,
    strain_gradient: bool,
    hardness: Option<&str>,
    interference_law: Option<&str>,
) -> PyResult<ModelOptions> {
    let idle = [
        ("hardness", hardness.is_some(), Choice::Hardness),
        ("interference_law", interference_law.is_some(), Choice::Interference),
        ("strain_gradient", strain_gradient, Choice::StrainGradient),
    ];
    if let Some((argument, ..)) = idle.iter().find(|(_, given, choice)| *given && !entry.has(*choice)) {
        let its_models = models::of_framework(entry.framework)
            .filter(|entry| idle.iter().any(|(name, _, choice)| name == argument && entry.has(*choice)));
        let names: Vec<&str> = its_models.map(|entry| entry.name).collect();
        return Err(input(format!(
            "{argument} has no bearing on model {entry}, only on {}; leave it out",
            names.join(", ")
        )));
    }
    Ok(ModelOptions {
        strain_gradient,
        hardness: hardness.map(form_of_hardness).transpose()?,
        interference_law: interference_law
            .map(|name| named::<InterferenceLaw>("interference_law", name))
            .transpose()?,
        ..ModelOptions::default()
    })
}

pub fn form_of_hardness(name: &str) -> PyResult<Hardness> {
    let found = Hardness::ALL.into_iter().find(|hardness| hardness.name() == name);
    found.ok_or_else(|| {
        let names = Hardness::ALL.map(Hardness::name).join(", ");
        of_argument("hardness", format!("'{name}' is none of {names}"))
    })
}
