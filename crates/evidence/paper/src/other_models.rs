//! Results of models that the paper does not use on its surface. They are reported beside the ledger and not counted
//! in it.

use std::error::Error;

use persson::Cut;
use study::models::{Framework, ModelOptions, named};
use study::plan::{Curve, CurveResult, Cutoffs, Needs, Plan};
use study::validity::SMALL_SLOPE_PRESSURE;
use tables::markdown::table;
use units::display::{length, three_digits};

use crate::evidence::Evidence;

/// Model that the paper does not use, with its findings on each spectrum.
#[derive(Debug, Clone, PartialEq)]
pub struct OtherModel {
    /// Name of the model.
    pub model: &'static str,
    /// Statement of the model.
    pub statement: &'static str,
    /// Remark of one sentence.
    pub remark: &'static str,
    /// Names of the spectra with all measured values.
    pub findings: Vec<(&'static str, String)>,
}

/// Relative distance within which the area counts as p/H.
const NEAR: f64 = 0.01;

/// Persson's theory, at a constant hardness and with one that grows at small scales, on the spectra in `evidence`.
///
/// # Errors
/// The error of a spectrum or material that the theory does not accept.
pub fn other_models(evidence: &[Evidence]) -> Result<Vec<OtherModel>, Box<dyn Error>> {
    let mut constant = OtherModel {
        model: "persson-plastic",
        statement: "At a constant hardness the real pressure is the hardness from some scale down: A = p/H.",
        remark: "This contradicts that hardness does not limit the pressure: it is a statement about models whose asperities bear more than H.",
        findings: Vec::new(),
    };
    let mut growing = OtherModel {
        model: "persson-plastic, strain gradient",
        statement: "With a hardness that grows at small scales the contact stays elastic throughout.",
        remark: "The strength decides between all plastic and all elastic, and it is an extrapolation of indentation.",
        findings: Vec::new(),
    };
    for of_scene in evidence {
        let name = of_scene.template.name();
        let curves = Curves::compute(of_scene)?;
        constant.findings.push((name, curves.at_constant_hardness(of_scene)));
        growing.findings.push((name, curves.with_growing_hardness()));
    }
    Ok(vec![constant, growing])
}

/// Findings as the table of `docs/guide/which-model.md`.
#[must_use]
pub fn other_models_table(models: &[OtherModel]) -> String {
    let lines: Vec<Vec<String>> = models
        .iter()
        .flat_map(|model| model.findings.iter().map(move |(spectrum, finding)| (model, spectrum, finding)))
        .map(|(model, spectrum, finding)| {
            vec![format!("`{}`", model.model), (*spectrum).to_owned(), finding.replace('*', "\\*")]
        })
        .collect();
    table(&["model", "spectrum", "found"], &lines).replace("---:", "---")
}

/// Cuts for every load: elastic, with a constant hardness, with a growing one.
struct Curves {
    elastic: Vec<Vec<Cut>>,
    constant: Vec<Vec<Cut>>,
    growing: Vec<Vec<Cut>>,
}

impl Curves {
    fn compute(evidence: &Evidence) -> Result<Self, Box<dyn Error>> {
        let scene = &evidence.scene;
        let material = scene.material.ok_or("the paper's scenes have a material")?;
        let curve = |name: &str, strain_gradient: bool| -> Result<Curve, Box<dyn Error>> {
            let options = ModelOptions { strain_gradient, ..ModelOptions::default() };
            let model = named(Framework::Persson, name)?.build(&material, &options)?;
            Ok(Curve { name: name.to_owned(), model, cutoffs: Cutoffs::Every })
        };
        let curves =
            vec![curve("persson", false)?, curve("persson-plastic", false)?, curve("persson-plastic", true)?];
        let needs = Needs { curves, sweeps: Vec::new(), ..scene.needs.clone() };
        let results = Plan { psd: &scene.surface.psd, sampling: scene.sampling, needs }.compute()?;
        let cuts = |result: CurveResult| {
            result.persson().map(<[_]>::to_vec).ok_or("a curve of Persson's theory has cuts")
        };
        let mut of_models = results.curves.into_iter().map(cuts);
        let mut next = || of_models.next().unwrap_or(Err("there are three curves"));
        Ok(Curves { elastic: next()?, constant: next()?, growing: next()? })
    }

    fn at_constant_hardness(&self, evidence: &Evidence) -> String {
        let hardness_pa = evidence.hardness_pa();
        let is_at_hardness = |cut: &Cut| (cut.real_pressure_pa / hardness_pa - 1.0).abs() <= NEAR;
        let first = |cuts: &Vec<Cut>| {
            let from_below = cuts.iter().rev().take_while(|cut| is_at_hardness(cut)).count();
            cuts.get(cuts.len() - from_below).map(|cut| (cut.wavelength_m, spread_pa(evidence, cut)))
        };
        let reached: Option<Vec<(f64, f64)>> = self.constant.iter().map(first).collect();
        let found = match reached {
            Some(places) => {
                // The load that reaches it last.
                let (wavelength_m, spread_pa) = places
                    .into_iter()
                    .fold((f64::INFINITY, 0.0), |last, place| if place.0 < last.0 { place } else { last });
                format!(
                    "A = p/H within 1 % at every load from {} down, where s/H = {}",
                    length(wavelength_m),
                    three_digits(spread_pa / hardness_pa)
                )
            }
            None => "A = p/H is not reached at every load".to_owned(),
        };
        format!("{found}. {}", steep(evidence, &self.constant))
    }

    fn with_growing_hardness(&self) -> String {
        let plastic = self.growing.iter().flatten().map(|cut| cut.areas.plastic / cut.areas.contact());
        let off = self.growing.iter().zip(&self.elastic).filter_map(|(growing, elastic)| {
            Some(growing.last()?.areas.contact() / elastic.last()?.areas.contact() - 1.0)
        });
        format!(
            "at most {} of the contact is plastic at any scale and load; the area at the shortest wavelength is at most {} off the elastic one",
            share(plastic.fold(0.0, f64::max)),
            share(off.map(f64::abs).fold(0.0, f64::max)),
        )
    }
}

/// Spread s = E* h'/2 up to a cut \[Pa\].
fn spread_pa(evidence: &Evidence, cut: &Cut) -> f64 {
    evidence.contact_modulus_pa() * cut.rms_gradient / 2.0
}

/// Describes the wavelengths at which slopes are too steep for any model.
fn steep(evidence: &Evidence, cuts: &[Vec<Cut>]) -> String {
    let modulus_pa = evidence.contact_modulus_pa();
    let too_steep = |cut: &&Cut| spread_pa(evidence, cut) > SMALL_SLOPE_PRESSURE * modulus_pa;
    match cuts.first().and_then(|cuts| cuts.iter().find(too_steep).zip(cuts.last())) {
        Some((first, last)) => format!(
            "s exceeds E*/10 from {} down and ends at {} E*: slopes too steep for a half-space",
            length(first.wavelength_m),
            three_digits(0.5 * last.rms_gradient)
        ),
        None => "Slopes stay small enough for a half-space".to_owned(),
    }
}

/// Formats a share, readable also if it is tiny.
fn share(of: f64) -> String {
    if of < 1e-6 { "a millionth".to_owned() } else { format!("{} %", three_digits(100.0 * of)) }
}
