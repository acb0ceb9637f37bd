//! The material and the loads, as options give them.

use asperity::ElasticBody;

use super::say_notes;
use crate::args::{CounterfaceArgs, MaterialArgs};
use crate::failure::Failure;
use crate::material_errors;
use report::material_words;
use study::hardness_and_strength::HardnessAndStrength;
use study::material::{GivenMaterial, Material, MaterialError};
use study::models::ModelEntry;
use study::plan::{Load, LoadRange};
use units::{Modulus, Pressure, PressureRange};

/// Refuses a limit of the strength where no strength grows.
pub(super) fn refuse_idle_strength_cap(
    given: &MaterialArgs,
    model: &str,
    yields: bool,
) -> Result<(), Failure> {
    match (given.strength_cap.strength_cap, given.strain_gradient_length) {
        (None, _) => Ok(()),
        (Some(_), Some(_)) if yields => Ok(()),
        (Some(_), None) if yields => Err(Failure::input(
            "--strength-cap limits a strength that grows at small depths, and without --strain-gradient-length none does; \
             leave it out, or give that length",
        )),
        (Some(_), _) => Err(Failure::Input(format!(
            "--strength-cap has no bearing on --model {model}, which does not yield; leave it out"
        ))),
    }
}

/// The rough body and its counterface, as given on the command line.
pub(super) fn material(given: &MaterialArgs) -> Result<Material, Failure> {
    let missing = |flag: &str| Failure::Input(format!("{flag} is needed: every model is at least elastic"));
    let modulus = given.youngs_modulus.ok_or_else(|| missing("--youngs-modulus"))?;
    let poisson_ratio = given.poisson_ratio.ok_or_else(|| missing("--poisson-ratio"))?;
    let body = elastic_body(modulus, "--poisson-ratio", poisson_ratio)?;
    Ok(Material::new(GivenMaterial {
        body,
        counterface: counterface(&given.counterface)?,
        flows: study::bodies::Body::Rough,
        hardness_and_strength: HardnessAndStrength::new(given.indentation_hardness, given.yield_strength)
            .map_err(MaterialError::from)?,
        strength_cap: given.strength_cap.strength_cap,
        strain_gradient_length_m: given.strain_gradient_length.map(|length| length.m),
    }))
}

/// Says that a third of the hardness is the strength, where a model needs one that was not given.
pub(super) fn say_assumed_strength(material: &Material, model: &ModelEntry) {
    say_notes(material_words::assumed_strength(material, model));
}

pub(super) fn counterface(given: &CounterfaceArgs) -> Result<Option<ElasticBody>, Failure> {
    let (Some(modulus), Some(ratio)) = (given.counterface_youngs_modulus, given.counterface_poisson_ratio)
    else {
        return Ok(None);
    };
    elastic_body(modulus, "--counterface-poisson-ratio", ratio).map(Some)
}

/// The loads given by `--pressure`, and the ranges behind them by `--pressures`.
pub(super) fn loads(
    pressures: &[(Pressure, String)],
    ranges: &[PressureRange],
    material: &Material,
) -> Result<(Vec<Load>, Vec<LoadRange>), Failure> {
    let pascals = |option: &str, pressure| {
        material
            .nominal_pressure(pressure)
            .map_err(|error| Failure::Input(format!("{option}: {}", material_errors::told(&error))))
    };
    let load = |(pressure, label): &(Pressure, String)| {
        let nominal_pressure = pascals(&format!("--pressure {label}"), *pressure)?;
        Ok(Load { nominal_pressure, label: label.clone() })
    };
    let range = |range: &PressureRange| {
        let [from, to] = [range.from, range.to].map(|end| pascals("--pressures", end));
        Ok(LoadRange::new(from?, to?, range.points))
    };
    let loads = pressures.iter().map(load).collect::<Result<_, Failure>>()?;
    Ok((loads, ranges.iter().map(range).collect::<Result<_, Failure>>()?))
}

pub(super) fn elastic_body(modulus: Modulus, ratio_flag: &str, ratio: f64) -> Result<ElasticBody, Failure> {
    ElasticBody::new(modulus.pa, ratio).map_err(|error| Failure::Input(format!("{ratio_flag}: {error}")))
}
