//! Condition numbers: the sensitivity of the answers to their inputs, by central differences.
//!
//! If an output changes by k times the relative change of an input, it is known k times worse than the input. No
//! computation whose inputs are doubles can have an error below k half units in the last place.

use stat_contact::ContactState;

use crate::statistical::{Question, StatisticalCase};

/// Relative change of an input for derivatives; their own relative error is some 1e-7.
const STEP: f64 = 1e-5;
const TOLERANCE: f64 = 1e-13;

/// Derivatives of the answers by the logarithm of one input, and by the separation over sigma_s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Condition {
    /// Name of the input.
    pub input: &'static str,
    /// Names of the first three numbers in reports.
    pub names: [&'static str; 3],
    /// Derivative of ln p, at a fixed separation.
    pub ln_pressure: f64,
    /// Derivative of ln(A/A_n) without the limit to 1, at a fixed separation.
    pub ln_area: f64,
    /// Derivative of d/sigma_s, at a fixed pressure.
    pub separation: f64,
    /// Derivative of ln(A/A_n), at a fixed pressure.
    pub ln_area_at_pressure: f64,
}

/// Slopes of ln p and of ln(A/A_n) by u = d/sigma_s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slopes {
    /// Slope of ln p, usually negative.
    pub ln_pressure: f64,
    /// Slope of ln(A/A_n).
    pub ln_area: f64,
}

/// Slopes at the separation d \[m\]; `None` if numbers are refused.
pub fn slopes(case: &StatisticalCase, separation_m: f64) -> Option<Slopes> {
    let u = separation_m / case.sigma_s_m;
    // ln p bends on the scale of 1 near the mean plane, and of |u| away from it, and u has to move.
    let step = 1e-3 / (1.0 + u.max(0.0)) + 1e-9 * u.abs();
    let at = |u: f64| {
        let question = Question::Separation(u * case.sigma_s_m);
        StatisticalCase { question, tolerance: TOLERANCE, ..*case }.state().ok()
    };
    let [low, high] = [at(u - step)?, at(u + step)?];
    let width = (high.separation_m? - low.separation_m?) / case.sigma_s_m;
    let [ln_pressure, ln_area] = differences(&high, &low).map(|difference| difference / width);
    Some(Slopes { ln_pressure, ln_area })
}

/// Condition numbers of the answers at the separation d \[m\] for every input.
pub fn conditions(case: &StatisticalCase, separation_m: f64) -> Option<Vec<Condition>> {
    let slopes = slopes(case, separation_m)?;
    let case =
        StatisticalCase { question: Question::Separation(separation_m), tolerance: TOLERANCE, ..*case };
    INPUTS
        .iter()
        .map(|&(input, names, scaled)| {
            let at = |factor: f64| {
                let mut other = case;
                scaled(&mut other, factor);
                other.state().ok()
            };
            let [low, high] = [at(1.0 - STEP)?, at(1.0 + STEP)?];
            let [ln_pressure, ln_area] = differences(&high, &low).map(|difference| difference / (2.0 * STEP));
            let separation = -ln_pressure / slopes.ln_pressure;
            let ln_area_at_pressure = ln_area + slopes.ln_area * separation;
            Some(Condition { input, names, ln_pressure, ln_area, separation, ln_area_at_pressure })
        })
        .collect()
}

fn differences(high: &ContactState, low: &ContactState) -> [f64; 2] {
    [high.ln_pressure_pa - low.ln_pressure_pa, high.ln_area_fraction - low.ln_area_fraction]
}

/// Function that multiplies one input of a case.
type Scale = fn(&mut StatisticalCase, f64);

const INPUTS: [(&str, [&str; 3], Scale); 8] = [
    ("Young's modulus", ["d ln p/d ln E", "d ln A/d ln E", "d u/d ln E at p"], |case, factor| {
        case.material.youngs_modulus_pa *= factor;
    }),
    ("Poisson's ratio", ["d ln p/d ln nu", "d ln A/d ln nu", "d u/d ln nu at p"], |case, factor| {
        case.material.poisson_ratio = (case.material.poisson_ratio * factor).clamp(-0.999_999, 0.5);
    }),
    ("strength", ["d ln p/d ln Sy", "d ln A/d ln Sy", "d u/d ln Sy at p"], |case, factor| {
        case.material.strength_pa *= factor;
        case.material.strength_cap_pa = case.material.strength_cap_pa.map(|cap_pa| cap_pa * factor);
    }),
    ("strain-gradient length", ["d ln p/d ln h*", "d ln A/d ln h*", "d u/d ln h* at p"], |case, factor| {
        let length_m = case.material.strain_gradient_length_m;
        case.material.strain_gradient_length_m = length_m.map(|length_m| length_m * factor);
    }),
    ("radius", ["d ln p/d ln R", "d ln A/d ln R", "d u/d ln R at p"], |case, factor| case.radius_m *= factor),
    ("density", ["d ln p/d ln eta", "d ln A/d ln eta", "d u/d ln eta at p"], |case, factor| {
        case.density_per_m2 *= factor;
    }),
    ("sigma_s", ["d ln p/d ln sigma", "d ln A/d ln sigma", "d u/d ln sigma at p"], |case, factor| {
        case.sigma_s_m *= factor;
    }),
    ("separation", ["d ln p/d ln d", "d ln A/d ln d", "d u/d ln d at p"], |case, factor| {
        if let Question::Separation(separation_m) = &mut case.question {
            *separation_m *= factor;
        }
    }),
];

#[cfg(test)]
mod tests {
    use asperity::Hardness;

    use super::*;
    use crate::{Kind, Material};

    #[test]
    fn hertzian_condition_numbers_are_the_known_ones() {
        let material = Material {
            youngs_modulus_pa: 1e11,
            poisson_ratio: 0.3,
            counterface: None,
            strength_pa: 1e9,
            strain_gradient_length_m: None,
            strength_cap_pa: None,
        };
        let case = StatisticalCase {
            kind: Kind::Hertz,
            material,
            hardness: Hardness::default(),
            radius_m: 1e-6,
            density_per_m2: 1e10,
            sigma_s_m: 1e-8,
            tolerance: 1e-10,
            question: Question::Separation(0.0),
        };
        let conditions = conditions(&case, 2e-8).unwrap();
        let of = |input: &str| conditions.iter().find(|condition| condition.input == input).unwrap();
        // p = eta E* R^(1/2) sigma^(3/2) F(d/sigma), A = eta R sigma G(d/sigma): dimensional analysis leaves one free
        // function each.
        assert!((of("Young's modulus").ln_pressure - 1.0).abs() < 1e-7);
        assert!(of("Young's modulus").ln_area.abs() < 1e-7);
        assert!((of("radius").ln_pressure - 0.5).abs() < 1e-7);
        assert!((of("density").ln_area - 1.0).abs() < 1e-7);
        assert!((of("sigma_s").ln_pressure + of("separation").ln_pressure - 1.5).abs() < 1e-6);
        assert!((of("sigma_s").ln_area + of("separation").ln_area - 1.0).abs() < 1e-6);
        assert_eq!(of("strength").separation, 0.0);
        // More force moves the flat away from the mean plane.
        assert!(of("Young's modulus").separation > 0.0);
    }
}
