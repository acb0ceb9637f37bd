//! States of the theory of summits: their numbers, and the promises of every result.

use std::f64::consts::PI;

use asperity::{AsperityError, ElasticBody, HertzEllipse, MaterialPair};
use bilby::AdaptiveIntegrator;
use numerics::GaussLegendre;
use stat_contact::{Condition, ContactState, NayakSummits, StatisticalContact};

use crate::statistical_trial::Search;
use crate::tally::{Case, Refused, Trial};
use crate::{Draw, Reach};

/// Relative rounding of a sum of some hundred positive terms.
const ROUNDING: f64 = 1e-12;

/// Surface, body and a given quantity; printed, it is a literal that recreates it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SummitsCase {
    /// Young's modulus \[Pa\] of the surface against a rigid flat.
    pub youngs_modulus_pa: f64,
    /// Mean square height of profiles m0 \[m^2\].
    pub m0_m2: f64,
    /// Mean square slope of profiles m2.
    pub m2: f64,
    /// Mean square curvature of profiles m4 \[m^-2\].
    pub m4_per_m2: f64,
    /// Relative tolerance.
    pub tolerance: f64,
    /// Given quantity.
    pub question: Condition,
}

impl SummitsCase {
    fn pair(&self) -> Result<MaterialPair, AsperityError> {
        Ok(MaterialPair::against_rigid(ElasticBody::new(self.youngs_modulus_pa, 0.3)?))
    }

    fn contact(&self) -> Result<StatisticalContact, AsperityError> {
        let summits = NayakSummits::new(self.m0_m2, self.m2, self.m4_per_m2)?;
        Ok(StatisticalContact::from_summits(&self.pair()?, &summits))
    }

    fn height_m(&self) -> f64 {
        self.m0_m2.sqrt()
    }
}

impl Case for SummitsCase {
    fn draw(draw: &mut Draw) -> (Self, Reach) {
        let reach = Reach::draw(draw);
        let [modulus, height, slope] = match reach {
            Reach::Usual => [(8.0, 12.0), (-10.0, -5.0), (-3.0, 0.0)],
            _ => [(0.0, 14.0), (-15.0, 0.0), (-12.0, 12.0)],
        };
        let m0_m2 = reach.number(draw, height.0, height.1).powi(2);
        let m2 = reach.number(draw, slope.0, slope.1).powi(2);
        let above = match reach {
            Reach::Usual => draw.decades(-2.0, 4.0),
            _ => reach.number(draw, -16.0, 30.0),
        };
        let alpha = draw.one_of(&[1.5 + above, 1.5 + above, 1.5 + above, 1.5, 1.5f64.next_up()]);
        let youngs_modulus_pa = reach.number(draw, modulus.0, modulus.1);
        let digits = draw.between(1.0, 14.0);
        let near = draw.between(-8.0, 12.0);
        let far = draw.one_of(&[-1.0, 1.0]) * draw.decades(-6.0, 3.0);
        let beyond = draw.one_of(&[-1.0, 1.0]) * draw.decades(3.0, 12.0);
        let edge = draw.one_of(&[-1e6, -0.0, 0.0, 60.0]);
        let edge = draw.near(edge);
        let u = draw.one_of(&[near, near, far, beyond, edge]);
        let pressure_pa = match reach {
            Reach::Usual => youngs_modulus_pa * m2.sqrt() * draw.decades(-9.0, 1.0),
            _ => reach.number(draw, -12.0, 15.0),
        };
        let question = if draw.chance(0.3) {
            Condition::Pressure(pressure_pa)
        } else {
            Condition::Separation(u * m0_m2.sqrt())
        };
        let tolerance = 10f64.powf(-digits);
        let m4_per_m2 = alpha * m2 * (m2 / m0_m2);
        (SummitsCase { youngs_modulus_pa, m0_m2, m2, m4_per_m2, tolerance, question }, reach)
    }

    fn test(trial: &mut Trial<Self>) -> Result<(), Refused> {
        let case = trial.case;
        let contact = &case.contact()?;
        let SummitsCase { question, tolerance, .. } = *case;
        let search = Search {
            contact,
            question,
            tolerance,
            height_m: case.height_m(),
            force_rises: true,
            area_rises: true,
        };
        let Some((state, separation_m)) = search.test(trial)? else { return Ok(()) };
        let stiffness = state.stiffness_pa_per_m();
        trial.hold("stiffness at least 0", stiffness.is_none_or(|stiffness| stiffness >= 0.0));
        scaled(&state, separation_m, trial);
        if trial.draw.chance(0.05) {
            error_bar(contact, separation_m, trial);
        }
        if trial.draw.chance(0.005) {
            other_quadrature(contact, separation_m, trial);
        }
        Ok(())
    }
}

/// Effect of the last places of a separation on ln p: u^2 above the mean plane.
fn rounding(case: &SummitsCase, state: &ContactState, separation_m: f64) -> f64 {
    let u = separation_m / case.height_m();
    let high = u.max(0.0);
    ROUNDING + 8.0 * f64::EPSILON * (state.ln_pressure_pa.abs() + high * high + u.abs().ln_1p())
}

fn scaled(state: &ContactState, separation_m: f64, trial: &mut Trial<SummitsCase>) {
    let case = trial.case;
    let [lengths, pressures] = [0, 1].map(|_| trial.draw.between(-20.0, 20.0) as i32);
    let [length, pressure] = [lengths, pressures].map(|power| 2f64.powi(power));
    let question = match case.question {
        Condition::Separation(d_m) => Condition::Separation(length * d_m),
        Condition::Pressure(p_pa) => Condition::Pressure(pressure * p_pa),
    };
    let other = SummitsCase {
        youngs_modulus_pa: pressure * case.youngs_modulus_pa,
        m0_m2: length * length * case.m0_m2,
        m4_per_m2: case.m4_per_m2 / (length * length),
        question,
        ..*case
    };
    let there = other.contact().and_then(|contact| contact.at(question, case.tolerance, None));
    if let Ok(there) = there {
        let off = (there.ln_area_fraction - state.ln_area_fraction).abs();
        trial.bound("units do not matter", off, 10.0 * rounding(case, state, separation_m));
    }
}

fn error_bar(contact: &StatisticalContact, separation_m: f64, trial: &mut Trial<SummitsCase>) {
    let case = trial.case;
    let states = [case.tolerance, 1e-13].map(|tolerance| contact.at_separation(separation_m, tolerance));
    let [Ok(coarse), Ok(fine)] = states else { return };
    let error = (coarse.ln_pressure_pa - fine.ln_pressure_pa).abs();
    let allowed = coarse.error_estimate + fine.error_estimate + rounding(case, &fine, separation_m);
    trial.bound("error within its estimate", error, allowed);
}

/// Compares with the triple integral over heights, mean curvatures and their differences, which shares no code.
fn other_quadrature(contact: &StatisticalContact, separation_m: f64, trial: &mut Trial<SummitsCase>) {
    let case = trial.case;
    let u = separation_m / case.height_m();
    let alpha = (case.m0_m2 / case.m2) * (case.m4_per_m2 / case.m2);
    if !((-20.0..=5.0).contains(&u) && (1.51..=1e6).contains(&alpha)) {
        return;
    }
    let Ok(state) = contact.at_separation(separation_m, 1e-12) else { return };
    let spread = (1.0 - 1.5 / alpha).sqrt();
    let over_ratio: Vec<(f64, f64)> = {
        // rho = tanh(eta), in which the ellipses are smooth.
        let rule = GaussLegendre::new(20);
        let ends = [0.0, 0.02, 0.08, 0.3, 1.0, 3.0, 8.0, 16.0];
        ends.windows(2).flat_map(|pair| rule.over(pair[0], pair[1]).collect::<Vec<_>>()).collect()
    };
    let ellipses: Vec<[f64; 4]> = over_ratio
        .iter()
        .map(|&(eta, weight)| {
            let ellipse = HertzEllipse::from_curvatures(2.0 * eta);
            [eta.tanh(), weight * eta.cosh().powi(-2), ellipse.area_factor(), ellipse.force_factor()]
        })
        .collect();
    let heights = GaussLegendre::new(24);
    // Of summits of the mean curvature T, pressed by w: per area, w and w^(3/2) with the factors of their ellipses.
    let of_curvature = |curvature: f64, is_force: bool| {
        let mean = 1.5 * curvature / alpha.sqrt() - u;
        let (low, high) = ((mean - 12.0 * spread).max(0.0), (mean + 12.0 * spread).max(0.0));
        let panels = 40;
        let power = if is_force { 1.5 } else { 1.0 };
        let [from, to] = [low, high].map(f64::sqrt);
        let width = (to - from) / f64::from(panels);
        let height: f64 = (0..panels)
            .flat_map(|at| heights.over(from + f64::from(at) * width, from + f64::from(at + 1) * width))
            .map(|(root, weight)| {
                let w = root * root;
                let z = (w - mean) / spread;
                2.0 * root * weight * w.powf(power) * (-0.5 * z * z).exp()
            })
            .sum::<f64>()
            / (spread * (2.0 * PI).sqrt());
        // r = rho T: (T^2 - r^2) 3 r exp(-3 r^2/2) dr.
        let shape: f64 = ellipses
            .iter()
            .map(|&[rho, weight, area, force]| {
                let r = rho * curvature;
                let factor = if is_force { force } else { area };
                weight * factor * (curvature * curvature - r * r) * 3.0 * r * (-1.5 * r * r).exp() * curvature
            })
            .sum();
        let density = (-0.75 * curvature * curvature).exp() * (0.75 / PI).sqrt();
        let law = if is_force { 4.0 / 3.0 / curvature.sqrt() } else { PI / curvature };
        density * shape * height * law
    };
    let integrator =
        AdaptiveIntegrator::default().with_abs_tol(0.0).with_rel_tol(1e-11).with_max_evals(4_000);
    let integral = |is_force: bool| {
        let breaks = [0.3, 1.0, 2.0, 3.0, 4.5, 6.0];
        integrator.integrate_with_breaks(1e-9, 12.0, &breaks, |t| of_curvature(t, is_force)).ok()
    };
    let (Some(area), Some(force)) = (integral(false), integral(true)) else { return };
    // Per area in units of m4/(2 pi m2), heights in sqrt(m0), curvatures in sqrt(m4).
    let number = case.m4_per_m2 / (2.0 * PI * case.m2);
    let (height_m, curvature_per_m) = (case.height_m(), case.m4_per_m2.sqrt());
    let modulus_pa = case.youngs_modulus_pa / (1.0 - 0.09);
    let ln_area = (area.value * number * height_m / curvature_per_m).ln();
    let ln_pressure =
        (force.value * number * modulus_pa * height_m * height_m.sqrt() / curvature_per_m.sqrt()).ln();
    for (promise, ours, theirs, result) in [
        ("another quadrature agrees on p", state.ln_pressure_pa, ln_pressure, &force),
        ("another quadrature agrees on A", state.ln_area_fraction, ln_area.min(0.0), &area),
    ] {
        let error = result.error_estimate / result.value;
        if error < 1e-8 {
            trial.bound(promise, (ours - theirs).abs(), 1e-9 + 2.0 * error);
        }
    }
}
