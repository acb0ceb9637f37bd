//! Plain sampling of uncertain inputs against a polynomial fitted to few draws: the cost of an interval of ln A and
//! of the shares of its variance in plans run, and their errors.
//!
//! The polynomial is a chaos expansion: Hermite polynomials in the standard normal numbers behind the inputs, up to a
//! total degree, by least squares (Sudret 2008, Reliab. Eng. Syst. Saf. 93:964). Its shares of variance are sums of
//! squares of its coefficients. Its interval is that of many draws of the polynomial, which cost nothing compared
//! with a plan.

use asperity::{ElasticBody, MaterialPair, NixGao};
use faer::Mat;
use faer::linalg::solvers::SolveLstsq;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use scene::{Overrides, Scene};
use spectrum::ProfilePsd;
use study::NoFiles;
use study::models::CurveModel;
use study::plan::Plan;
use uncertainty::{quantiles, sobol};

use crate::uncertain_scene::LOADS_AND_CURVES;

/// Surface and material of the scene: the measured spectrum of diamond.
const DIAMOND: &str = r#"
title = "UNCD, measured"

[surface]
psd = "builtin:uncd-measured"

[material]
youngs_modulus = "463 GPa"
poisson_ratio = 0.2
yield_strength = "10 GPa"
"#;

/// Number of inputs: Young's modulus, the yield strength, and the height scale.
const INPUTS: usize = 3;

/// Standard uncertainties of their logarithms.
const SPREADS: [f64; INPUTS] = [0.05, 0.1, 0.03];

/// Draws of the reference.
const REFERENCE_DRAWS: usize = 1 << 14;

/// Probability that intervals cover.
const LEVEL: f64 = 0.95;

/// Largest number of repeats with different draws.
const REPEATS: usize = 16;

/// Total degrees of the polynomials.
const DEGREES: [usize; 3] = [1, 2, 3];

/// Smallest number of draws per coefficient.
const OVERSAMPLING: usize = 2;

/// Numbers of plans run.
const PLANS: [usize; 8] = [10, 20, 40, 80, 160, 320, 640, 1280];

/// Standard normal numbers, one for each input.
type Draw = [f64; INPUTS];

/// Method by which plans give an interval and shares.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Quantiles of the draws, and Saltelli's design.
    Plain,
    /// Polynomial of a total degree.
    Polynomial(usize),
}

/// Errors of a method for a number of plans.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MethodErrors {
    /// Method used.
    pub method: Method,
    /// Number of plans run.
    pub plans: usize,
    /// Root mean square error of the ends of an interval of ln A, over its length.
    pub ends: f64,
    /// Root mean square error of first-order shares.
    pub shares: f64,
}

/// Ends of an interval, and the share of each input.
#[derive(Debug, Clone, Copy)]
struct Answer {
    ends: [f64; 2],
    shares: Draw,
}

/// Outputs of Saltelli's design, for one area.
struct Design {
    a: Vec<f64>,
    b: Vec<f64>,
    ab: [Vec<f64>; INPUTS],
}

/// Computes the errors of every method at every number of plans, over all curves, loads and repeats.
///
/// # Errors
/// A message if the scene fails.
pub fn method_errors() -> Result<Vec<MethodErrors>, String> {
    let scene = DIAMOND.to_owned() + LOADS_AND_CURVES;
    let scene = Scene::parse(&scene, &NoFiles, &Overrides::default()).map_err(|error| error.to_string())?;
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let mut draws = || -> Vec<Draw> {
        (0..REFERENCE_DRAWS).map(|_| std::array::from_fn(|_| StandardNormal.sample(&mut random))).collect()
    };
    let (a, b) = (draws(), draws());
    let designs = designs(&scene, &a, &b)?;
    let references: Vec<Answer> = designs
        .iter()
        .map(|design| plain(design, 0..REFERENCE_DRAWS))
        .collect::<Option<_>>()
        .ok_or("no draws")?;
    let mut rows = Vec::new();
    for plans in PLANS {
        rows.push(compared(&references, Method::Plain, plans, |repeat| {
            let ends = repeat * plans..(repeat + 1) * plans;
            let base = plans / (INPUTS + 2);
            let shares = repeat * base..(repeat + 1) * base;
            let of_area = |design: &Design| {
                Some(Answer { shares: plain(design, shares.clone())?.shares, ..plain(design, ends.clone())? })
            };
            designs.iter().map(of_area).collect()
        }));
        for degree in DEGREES {
            let terms = terms(degree);
            if plans < OVERSAMPLING * terms.len() {
                continue;
            }
            rows.push(compared(&references, Method::Polynomial(degree), plans, |repeat| {
                let fitted = repeat * plans..(repeat + 1) * plans;
                let outputs: Vec<&[f64]> = designs.iter().map(|design| &design.a[fitted.clone()]).collect();
                let coefficients = least_squares(&a[fitted.clone()], &terms, &outputs);
                coefficients.iter().map(|coefficients| of_polynomial(coefficients, &terms, &b)).collect()
            }));
        }
    }
    Ok(rows.into_iter().flatten().collect())
}

/// Errors of a method over all repeats for which there are draws; `None` without an answer.
fn compared(
    references: &[Answer],
    method: Method,
    plans: usize,
    answers: impl Fn(usize) -> Option<Vec<Answer>> + Sync,
) -> Option<MethodErrors> {
    let repeats = REPEATS.min(REFERENCE_DRAWS / plans);
    let answers: Vec<Vec<Answer>> =
        numerics::parallel::map_indices(repeats, answers).into_iter().collect::<Option<_>>()?;
    let pairs = || answers.iter().flat_map(|of_areas| of_areas.iter().zip(references));
    let root_mean_square = |squares: Vec<f64>| (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
    let ends = pairs().flat_map(|(found, reference)| {
        let length = reference.ends[1] - reference.ends[0];
        (0..2).map(move |end| ((found.ends[end] - reference.ends[end]) / length).powi(2))
    });
    let shares = pairs().flat_map(|(found, reference)| {
        (0..INPUTS).map(move |input| (found.shares[input] - reference.shares[input]).powi(2))
    });
    Some(MethodErrors {
        method,
        plans,
        ends: root_mean_square(ends.collect()),
        shares: root_mean_square(shares.collect()),
    })
}

/// Outputs of all draws, for every curve and load.
fn designs(scene: &Scene, a: &[Draw], b: &[Draw]) -> Result<Vec<Design>, String> {
    let outputs = |draws: &[Draw]| -> Result<Vec<Vec<f64>>, String> {
        numerics::parallel::try_map(draws, |draw| ln_areas(scene, draw))
    };
    let of_ab = |input: usize| {
        let exchanged = |(a, b): (&Draw, &Draw)| {
            let mut ab = *a;
            ab[input] = b[input];
            ab
        };
        outputs(&a.iter().zip(b).map(exchanged).collect::<Vec<Draw>>())
    };
    let (a, b) = (outputs(a)?, outputs(b)?);
    let ab: Vec<Vec<Vec<f64>>> = (0..INPUTS).map(of_ab).collect::<Result<_, _>>()?;
    let of_area = |outputs: &[Vec<f64>], area: usize| outputs.iter().map(|draw| draw[area]).collect();
    let areas = a.first().map_or(0, Vec::len);
    Ok((0..areas)
        .map(|area| Design {
            a: of_area(&a, area),
            b: of_area(&b, area),
            ab: std::array::from_fn(|input| of_area(&ab[input], area)),
        })
        .collect())
}

/// ln A of every curve and load for one draw of the inputs.
fn ln_areas(scene: &Scene, draw: &Draw) -> Result<Vec<f64>, String> {
    let [modulus, strength, height]: Draw = std::array::from_fn(|input| (SPREADS[input] * draw[input]).exp());
    let psd = &scene.surface.psd;
    let scaled = psd.c1d_m3().iter().map(|c1d_m3| c1d_m3 * height * height).collect();
    let psd = ProfilePsd::new(psd.wavelengths_m().to_vec(), scaled).map_err(|error| error.to_string())?;
    let mut needs = scene.needs.clone();
    for curve in &mut needs.curves {
        curve.model = drawn(&curve.model, modulus, strength)?;
    }
    let plan = Plan { psd: &psd, sampling: scene.sampling, needs };
    let results = plan.compute().map_err(|error| error.to_string())?;
    let last = |points: Vec<(f64, f64)>| points.last().map(|point| point.1.ln());
    let areas = results
        .curves
        .iter()
        .flat_map(|curve| (0..curve.blocks()).map(|load| last(curve.area_fractions(load))));
    areas.collect::<Option<_>>().ok_or_else(|| "a curve without an area".to_owned())
}

/// Model of a material with the modulus and the strength multiplied.
fn drawn(model: &CurveModel, modulus: f64, strength: f64) -> Result<CurveModel, String> {
    let body = model.pair().body();
    let body = ElasticBody::new(modulus * body.youngs_modulus_pa(), body.poisson_ratio());
    let moved = model.with_pair(MaterialPair::against_rigid(body.map_err(|error| error.to_string())?));
    let Some(plain) = moved.strength() else { return Ok(moved) };
    let strength = NixGao::constant(strength * plain.macroscopic_strength_pa());
    Ok(moved.with_strength(strength.map_err(|error| error.to_string())?).unwrap_or(moved))
}

fn plain(design: &Design, draws: std::ops::Range<usize>) -> Option<Answer> {
    let found = quantiles::interval(&design.a[draws.clone()], LEVEL)?;
    let share = |input: usize| {
        let [a, b, ab] = [&design.a, &design.b, &design.ab[input]].map(|outputs| &outputs[draws.clone()]);
        sobol::indices(a, b, ab).first_order.value
    };
    Some(Answer { ends: [found.low.value, found.high.value], shares: std::array::from_fn(share) })
}

/// Degrees in each input of all terms up to a total degree.
fn terms(degree: usize) -> Vec<[usize; INPUTS]> {
    let all =
        (0..=degree).flat_map(move |x| (0..=degree).flat_map(move |y| (0..=degree).map(move |z| [x, y, z])));
    all.filter(|term| term.iter().sum::<usize>() <= degree).collect()
}

/// Value of a term: a product of Hermite polynomials of mean square 1.
fn term_at(term: &[usize; INPUTS], draw: &Draw) -> f64 {
    let hermite = |degree: usize, x: f64| match degree {
        0 => 1.0,
        1 => x,
        2 => (x * x - 1.0) / 2f64.sqrt(),
        _ => x * (x * x - 3.0) / 6f64.sqrt(),
    };
    term.iter().zip(draw).map(|(&degree, &x)| hermite(degree, x)).product()
}

/// Coefficients of each output.
fn least_squares(draws: &[Draw], terms: &[[usize; INPUTS]], outputs: &[&[f64]]) -> Vec<Vec<f64>> {
    let matrix = Mat::from_fn(draws.len(), terms.len(), |row, column| term_at(&terms[column], &draws[row]));
    let right = Mat::from_fn(draws.len(), outputs.len(), |row, column| outputs[column][row]);
    let solved = matrix.qr().solve_lstsq(&right);
    let of_output = |output: usize| (0..terms.len()).map(|term| solved[(term, output)]).collect();
    (0..outputs.len()).map(of_output).collect()
}

fn of_polynomial(coefficients: &[f64], terms: &[[usize; INPUTS]], draws: &[Draw]) -> Option<Answer> {
    let at = |draw: &Draw| -> f64 {
        terms.iter().zip(coefficients).map(|(term, coefficient)| coefficient * term_at(term, draw)).sum()
    };
    let found = quantiles::interval(&draws.iter().map(at).collect::<Vec<f64>>(), LEVEL)?;
    let squares = |is_counted: &dyn Fn(&[usize; INPUTS]) -> bool| -> f64 {
        let counted = terms.iter().zip(coefficients).filter(|(term, _)| is_counted(term));
        counted.map(|(_, coefficient)| coefficient * coefficient).sum()
    };
    let variance = squares(&|term| term.iter().any(|&degree| degree > 0));
    let alone = |input: usize| {
        squares(&|term| (0..INPUTS).all(|other| (term[other] > 0) == (other == input))) / variance
    };
    Some(Answer { ends: [found.low.value, found.high.value], shares: std::array::from_fn(alone) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polynomial_is_fitted_and_its_variance_shared() {
        let mut random = ChaCha8Rng::seed_from_u64(2);
        let draws: Vec<Draw> =
            (0..40).map(|_| std::array::from_fn(|_| StandardNormal.sample(&mut random))).collect();
        let outputs: Vec<f64> =
            draws.iter().map(|[x, y, z]| 1.0 + 3.0 * x + (y * y - 1.0) / 2f64.sqrt() + x * z).collect();
        let terms = terms(2);
        let coefficients = least_squares(&draws, &terms, &[&outputs]);
        let answer = of_polynomial(&coefficients[0], &terms, &draws).unwrap();
        // Variances 9, 1 and 1, the last of x and z together.
        for (share, expected) in answer.shares.iter().zip([9.0 / 11.0, 1.0 / 11.0, 0.0]) {
            assert!((share - expected).abs() < 1e-10, "{answer:?}");
        }
    }

    #[test]
    fn the_number_of_terms_is_the_binomial_one() {
        assert_eq!(DEGREES.map(|degree| terms(degree).len()), [4, 10, 20]);
    }
}
