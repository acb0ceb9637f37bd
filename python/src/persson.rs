//! Persson's theory along the cutoff.

use findings::doubts::{Doubt, RealPressures};
use numpy::PyReadonlyArray1;
use persson::PerssonModel;
use persson::corrections::Correction;
use persson::hardness_laws::HardnessTable;
use persson::variance::Band;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use report::summary::CurveCounts;
use report::{doubt_words, persson_words};
use spectrum::{AmplitudeDefinition, Normalisation};
use study::gap_law;
use study::hardness_growth::{GrowthError, GrowthLaw, hardness_of};
use study::material::Material;
use study::models::{self, CurveModel, Framework, ModelOptions};
use study::persson_law::Deformation;
use study::plan::{Curve, CurveResult, Cutoffs, Needs, NominalPressure, Plan};
use study::result_tables::part_of_curve;

use crate::errors::{input, of_argument};
use crate::material::{PyMaterial, loads, told};
use crate::quantities::{Given, checked, number};
use crate::surface::{PySurface, named, notes, sampling};
use crate::tables::columns;
use crate::work::carry_out;

/// Result of a curve: its columns block after block, the pressures of the blocks \[Pa\], u_0 \[m\] and p_00 \[Pa\] of
/// light loads, and the notes.
type Found<'py> = (Bound<'py, PyDict>, Vec<f64>, Option<(f64, f64)>, Vec<String>);

/// Sizes of contacts \[m\] and the hardnesses \[Pa\] that they have.
type GivenTable<'py> = (PyReadonlyArray1<'py, f64>, PyReadonlyArray1<'py, f64>);

/// Contact over the cutoffs of a spectrum under each of the pressures.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the arguments of a call from Python, by name")]
pub fn persson_curve<'py>(
    py: Python<'py>,
    surface: &PySurface,
    material: &PyMaterial,
    pressure: &Given<'py>,
    model: &str,
    correction: Option<&str>,
    gamma: &Given<'py>,
    band: &str,
    hardness_law: Option<&str>,
    hardness_table: Option<GivenTable<'py>>,
    strain_gradient: bool,
    amplitude: &str,
    cutoff: Option<&Given<'py>>,
    scales_per_decade: Option<i64>,
) -> PyResult<Found<'py>> {
    let deformation: Deformation = named("model", model)?;
    let law = growth_law(hardness_law, hardness_table, strain_gradient)?;
    refuse_idle(deformation, correction.is_some(), law.is_some(), strain_gradient)?;
    let correction = correction.map(|name| named::<Correction>("correction", name)).transpose()?;
    let gamma = energy_factor(gamma)?;
    let band: Band = named("band", band)?;
    let (psd, material) = (&surface.surface.psd, &material.material);
    let contact_modulus_pa = material.pair.composite_modulus_pa();
    let model = match deformation {
        Deformation::Elastic => PerssonModel::Elastic { contact_modulus_pa, correction },
        Deformation::ElasticPlastic => {
            let hardness = hardness_of(material, law.as_ref()).map_err(|error| no_hardness(&error))?;
            PerssonModel::ElasticPlastic { contact_modulus_pa, hardness }
        }
    };
    let needs = Needs {
        moments: Some(Normalisation::Parseval),
        amplitudes: Some(named::<AmplitudeDefinition>("amplitude", amplitude)?),
        loads: loads("pressure", pressure, material)?,
        ..Needs::default()
    };
    let pressures_pa: Vec<f64> = needs.pressures().map(NominalPressure::pa).collect();
    let plan = Plan { psd, sampling: sampling(&surface.surface, cutoff, scales_per_decade)?, needs };
    let (blocks, roughness, light, rms_height_m) = carry_out(py, None, |progress| {
        let results = plan.compute_observed(progress).map_err(input)?;
        let roughness = gap_law::roughness(&plan, &results, band);
        let separation = model.separation(&roughness, gamma);
        let of_load = |&pressure_pa: &f64| match progress.is_cancelled() {
            true => Err(input("the work was ended")),
            false => model.along(&roughness, &separation, pressure_pa).map_err(input),
        };
        let blocks = parallel::try_map(&pressures_pa, of_load)?;
        let rms_height_m = results.moments.last().map_or(0.0, |(moments, _)| moments.rms_height_m());
        PyResult::Ok((blocks, roughness, separation.light_loads(), rms_height_m))
    })??;
    let rows = CurveResult::Persson(blocks);
    let mut said = notes(&surface.surface);
    said.extend(correction.iter().flat_map(|correction| persson_words::correction(*correction, &roughness)));
    let least_pa = pressures_pa.iter().copied().fold(f64::INFINITY, f64::min);
    let of_gaps = |light| persson_words::separation(light, &roughness, rms_height_m, least_pa);
    said.extend(light.iter().flat_map(of_gaps));
    said.extend(findings(deformation, &rows, &plan, material, law.is_some())?);
    let table = part_of_curve(&rows, &pressures_pa, false, true);
    let light = light.map(|light| (light.decay_length_m, light.reference_pressure_pa));
    Ok((columns(py, &table)?, pressures_pa, light, said))
}

/// The elastic energy factor of Persson's theory.
pub fn energy_factor(gamma: &Given<'_>) -> PyResult<f64> {
    checked("gamma", units::Bound::LeftOpen { above: 0.0, at_most: 1.0 }, number("gamma", gamma)?)
}

/// Returns the law by which the hardness grows, if it does.
fn growth_law(
    name: Option<&str>,
    table: Option<GivenTable<'_>>,
    strain_gradient: bool,
) -> PyResult<Option<GrowthLaw>> {
    let given = match (name, table) {
        (_, Some((sizes_m, hardnesses_pa))) => {
            let rows = sizes_m.as_array().to_vec().into_iter().zip(hardnesses_pa.as_array().to_vec());
            let table = HardnessTable::new(rows).map_err(|error| of_argument("hardness_law", error))?;
            Some(GrowthLaw::Table(table))
        }
        (Some(name), None) => {
            let law = GrowthLaw::named(name).map_err(|error| of_argument("hardness_law", error))?;
            Some(law.ok_or_else(|| {
                of_argument("hardness_law", format!("'{name}' is none of power:N, nix-gao"))
            })?)
        }
        (None, None) => None,
    };
    match given {
        Some(law) if strain_gradient && law != GrowthLaw::NixGao => {
            Err(input("strain_gradient has no bearing on a hardness_law other than nix-gao; leave it out"))
        }
        given => Ok(given.or(strain_gradient.then_some(GrowthLaw::NixGao))),
    }
}

/// Refuses arguments that the model has no use for.
fn refuse_idle(
    deformation: Deformation,
    is_corrected: bool,
    grows: bool,
    strain_gradient: bool,
) -> PyResult<()> {
    let (argument, why) = match deformation {
        Deformation::Elastic if strain_gradient => ("strain_gradient", ", which does not yield"),
        Deformation::Elastic if grows => ("hardness_law", ", which does not yield"),
        Deformation::ElasticPlastic if is_corrected => {
            ("correction", ": the corrected forms are elastic ones")
        }
        _ => return Ok(()),
    };
    Err(input(format!("{argument} has no bearing on model {deformation}{why}; leave it out")))
}

fn no_hardness(error: &GrowthError) -> PyErr {
    match error {
        GrowthError::Material(error) => told(error),
        GrowthError::Hardness(error) => input(error),
    }
}

/// Words the open questions of the curve, and the limits that it exceeds.
fn findings(
    deformation: Deformation,
    rows: &CurveResult,
    plan: &Plan<'_>,
    material: &Material,
    grows: bool,
) -> PyResult<Vec<String>> {
    // A hardness that grows bears more than that of the bulk.
    let hardness_pa = material.hardness_pa().filter(|_| !grows);
    let curve = Curve {
        name: "persson".to_owned(),
        model: model_by_name(deformation, material)?,
        cutoffs: Cutoffs::Every,
    };
    let mut counts = CurveCounts::default();
    counts.add(rows);
    let mut real_pressures = RealPressures::new(hardness_pa);
    let pressures_pa: Vec<f64> = plan.needs.pressures().map(NominalPressure::pa).collect();
    real_pressures.add_part(&curve, rows, &pressures_pa);
    let labels = plan.needs.loads.iter().map(|load| Some(load.label.as_str()));
    let doubts = Doubt::of_material(material)
        .into_iter()
        .chain(Doubt::of_spectrum(plan.psd))
        .chain(Doubt::of_pressures(plan.needs.pressures().zip(labels), hardness_pa))
        .chain(real_pressures.doubts());
    let mut said = report::question_words::of_counts(&counts);
    said.extend(doubts.map(|doubt| format!("doubtful: {}", doubt_words::line(&doubt))));
    Ok(said)
}

/// The model by the name that scenes give it; a table brings its own hardness, which a material may lack.
fn model_by_name(deformation: Deformation, material: &Material) -> PyResult<CurveModel> {
    let yields = deformation == Deformation::ElasticPlastic && material.hardness_pa().is_some();
    let name = if yields { "persson-plastic" } else { "persson" };
    let entry = models::named(Framework::Persson, name).map_err(input)?;
    entry.build(material, &ModelOptions::default()).map_err(|error| told(&error))
}
