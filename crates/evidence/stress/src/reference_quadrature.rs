//! The integrals of the statistical model by another quadrature: adaptive Gauss-Kronrod over the laws of their own
//! crate, sharing nothing with `stat-contact` but the formula.

use bilby::{AdaptiveIntegrator, GKPair};

use crate::law::Response;

/// ln p, with p in Pa, ln of the area fraction without the limit to 1, and the errors of both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Integrals {
    /// Natural logarithm of eta Int F(w) g(d + w) dw.
    pub ln_pressure_pa: f64,
    /// Natural logarithm of eta Int A(w) g(d + w) dw.
    pub ln_area_fraction: f64,
    /// Relative errors of the two: the integrator's own estimate, or the difference from another rule.
    pub errors: [f64; 2],
}

/// Integrates at the separation d \[m\] over Gaussian heights of standard deviation sigma_s \[m\].
///
/// The density at d, or its peak if that is in contact, is taken out. The variable is the cube root of the
/// interference, in which powers of it are smooth.
pub fn integrals(response: &Response, separation_m: f64, sigma_s_m: f64) -> Option<Integrals> {
    /// Drop of the density, as -ln of its largest value, below which it is left out.
    const DROP: f64 = 80.0;
    const TOLERANCE: f64 = 1e-12;
    const MOST_EVALUATIONS: usize = 60_000;
    const STRETCHES: u32 = 16;
    let u = separation_m / sigma_s_m;
    let half_width = (2.0 * DROP).sqrt();
    let (low, high, log_reference) = if u > 0.0 {
        (0.0, 2.0 * DROP / (u + (u * u + 2.0 * DROP).sqrt()), -0.5 * u * u)
    } else {
        ((-u - half_width).max(0.0), half_width - u, 0.0)
    };
    let log_density = |s: f64| if u > 0.0 { -s * (u + 0.5 * s) } else { -0.5 * (u + s).powi(2) };
    let [from, to] = [low, high].map(f64::cbrt);
    let peak = if u < 0.0 { -u } else { 1.0 / (1.0 + u) };
    // No rule would see a kink between an end of a stretch and the first node there.
    let kinks_m = response.kinks_m(low * sigma_s_m, high * sigma_s_m);
    let mut breaks: Vec<f64> = kinks_m.iter().map(|at_m| at_m / sigma_s_m).collect();
    breaks.extend([peak, peak + 1.0, peak - 1.0, 0.1 * high]);
    // Both rules may miss a kink that the law does not announce; short stretches leave it no room.
    let stretches = (1..STRETCHES).map(|at| from + (to - from) * f64::from(at) / f64::from(STRETCHES));
    let mut breaks: Vec<f64> =
        breaks.into_iter().map(f64::cbrt).chain(stretches).filter(|v| from < *v && *v < to).collect();
    breaks.sort_by(f64::total_cmp);
    breaks.dedup();
    let [integrator, again] = [GKPair::G10K21, GKPair::G15K31].map(|pair| {
        AdaptiveIntegrator::default()
            .with_pair(pair)
            .with_abs_tol(0.0)
            .with_rel_tol(TOLERANCE)
            .with_max_evals(MOST_EVALUATIONS)
    });
    let integral = |of: fn((f64, f64)) -> f64| {
        let integrand = |v: f64| {
            let s = v * v * v;
            of(response.at(s * sigma_s_m)) * log_density(s).exp() * 3.0 * v * v
        };
        let result = integrator.integrate_with_breaks(from, to, &breaks, integrand).ok()?;
        // Across a kink that the law does not announce an estimate may be thousands of times too small; the
        // difference from another rule is not.
        let other = again.integrate_with_breaks(from, to, &breaks, integrand).ok()?;
        let error = result.error_estimate.max((result.value - other.value).abs());
        Some((result.value, error / result.value))
    };
    let (pressure_pa, pressure_error) = integral(|(pressure_pa, _)| pressure_pa)?;
    let (area, area_error) = integral(|(_, area)| area)?;
    let log_scale = log_reference - 0.5 * std::f64::consts::TAU.ln();
    Some(Integrals {
        ln_pressure_pa: pressure_pa.ln() + log_scale,
        ln_area_fraction: area.ln() + log_scale,
        errors: [pressure_error, area_error],
    })
}

#[cfg(test)]
mod tests {
    use asperity::Hardness;

    use super::*;
    use crate::{Kind, Material};

    #[test]
    fn the_integrator_is_right_where_the_answer_is_known() {
        let integrator = AdaptiveIntegrator::default().with_abs_tol(0.0).with_rel_tol(1e-12);
        let step = |x: f64| if x < 0.3 { 1.0 } else { x.sqrt() };
        let exact = 0.3 + 2.0 / 3.0 * (1.0 - 0.3f64.powf(1.5));
        let split = integrator.integrate_with_breaks(0.0, 1.0, &[0.3], step).unwrap();
        assert!((split.value / exact - 1.0).abs() < 1e-12 && split.is_converged());
        let whole = integrator.integrate(0.0, 1.0, step).unwrap();
        assert!((whole.value / exact - 1.0).abs() < 1e-11);
    }

    #[test]
    fn hertzian_integrals_agree_with_their_closed_forms() {
        let material = Material {
            youngs_modulus_pa: 1e11,
            poisson_ratio: 0.0,
            counterface: None,
            strength_pa: 1e9,
            strain_gradient_length_m: None,
            strength_cap_pa: None,
        };
        let response = Response::new(Kind::Hertz, &material, Hardness::default(), 1e-6, 1e10).unwrap();
        let at = integrals(&response, 0.0, 1e-8).unwrap();
        // Int s^(3/2) phi(s) ds = 2^(1/4) Gamma(5/4)/sqrt(2 pi), Int s phi(s) ds = 1/sqrt(2 pi) over s > 0.
        let moment = 2f64.powf(0.25) * 0.906_402_477_055_477 / std::f64::consts::TAU.sqrt();
        let pressure_pa = 1e10 * 4.0 / 3.0 * 1e11 * 1e-3 * 1e-12 * moment;
        let area = 1e10 * std::f64::consts::PI * 1e-14 / std::f64::consts::TAU.sqrt();
        assert!((at.ln_pressure_pa - pressure_pa.ln()).abs() < 1e-12, "{at:?}");
        assert!((at.ln_area_fraction - area.ln()).abs() < 1e-12, "{at:?}");
    }
}
