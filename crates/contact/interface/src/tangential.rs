//! Tangential loading of a contact under a constant normal load, from its normal law: Ciavarella, Int. J. Solids Struct. 35
//! (1998) 2349, and Jaeger, Arch. Appl. Mech. 68 (1998) 332.
//!
//! With Coulomb friction f at every point the tangential stress q leaves what the smaller pressure p* = p - q/f presses
//! sticking, and the bodies move by d = f eta [u(p) - u(p*)] against each other, where u is the approach under p. The
//! ratio of the tangential to the normal compliance is eta = E* Sum (2 - nu)/(4 G). Normal and tangential tractions do not
//! act on each other, which is exact for equal bodies, and for a rigid one on one with nu = 1/2.

use std::f64::consts::PI;
use std::sync::LazyLock;

use numerics::GaussLegendre;
use units::{Bound, OutOfBounds};

/// Dundurs' beta above which the coupling of normal and tangential tractions is worth a warning.
pub const NOTICEABLE_MISMATCH: f64 = 0.1;

/// Widest part of ln p that one rule of nodes covers.
const WIDEST_PART: f64 = 0.7;

/// Relative fall of the stiffness, on the way to a larger pressure, that solvers leave.
const STIFFNESS_ERROR: f64 = 1e-3;

static RULE: LazyLock<GaussLegendre> = LazyLock::new(|| GaussLegendre::new(10));

/// Why a contact has no tangential response.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ShearError<E> {
    /// The normal law has no stiffness.
    #[error(transparent)]
    Stiffness(#[from] E),
    /// The stiffness of the normal law falls with the pressure, as that of no elastic contact does: cycles would gain energy.
    #[error("the stiffness falls on the way to {pressure_pa} Pa")]
    FallingStiffness {
        /// The pressure \[Pa\].
        pressure_pa: f64,
    },
}

/// An elastic body: its shear modulus \[Pa\] and Poisson's ratio.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct ShearedBody {
    /// Shear modulus G \[Pa\].
    pub shear_modulus_pa: f64,
    /// Poisson's ratio nu.
    pub poisson_ratio: f64,
}

/// Friction and elasticity of two bodies that are sheared.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct ShearedPair {
    friction: f64,
    compliance_ratio: f64,
    mismatch: f64,
}

/// A contact under a normal and a tangential load, per nominal area.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct ShearedContact {
    /// Pressure p* \[Pa\] whose contact sticks.
    pub stuck_pressure_pa: f64,
    /// Tangential displacement d \[m\] on first loading.
    pub displacement_m: f64,
    /// Stiffness at no tangential load \[Pa/m\].
    pub initial_stiffness_pa_per_m: f64,
    /// Stiffness dq/dd at this load \[Pa/m\].
    pub tangent_stiffness_pa_per_m: f64,
    /// Energy lost in a cycle between -q and q \[J/m^2\].
    pub dissipation_j_per_m2: f64,
    /// Equivalent viscous damping ratio of that cycle: the energy lost over 2 pi q d.
    pub damping_ratio: f64,
}

/// A cycle of the tangential stress between q and -q under a constant pressure, after first loading. Points are tangential
/// displacements d \[m\] and stresses \[Pa\], with rising displacements.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct ShearCycle {
    /// From no stress to q.
    pub first_loading: Vec<(f64, f64)>,
    /// From q to -q, which is run through backwards.
    pub unloading: Vec<(f64, f64)>,
    /// From -q to q.
    pub reloading: Vec<(f64, f64)>,
}

impl ShearedPair {
    /// Pairs an elastic body with another, or with a rigid one, at a coefficient of friction.
    ///
    /// # Errors
    /// [`OutOfBounds`] unless friction, moduli and E* \[Pa\] are positive and within thirty decades of 1.
    pub fn new(
        friction: f64,
        composite_modulus_pa: f64,
        body: ShearedBody,
        counterface: Option<ShearedBody>,
    ) -> Result<Self, OutOfBounds> {
        let friction = Bound::Magnitude.check("coefficient of friction", friction)?;
        let modulus_pa = Bound::Magnitude.check("composite modulus in Pa", composite_modulus_pa)?;
        let bodies = || std::iter::once(body).chain(counterface);
        for body in bodies() {
            Bound::Magnitude.check("shear modulus in Pa", body.shear_modulus_pa)?;
        }
        let tangential: f64 =
            bodies().map(|body| (2.0 - body.poisson_ratio) / (4.0 * body.shear_modulus_pa)).sum();
        let of = |share: fn(f64) -> f64| {
            move |body: ShearedBody| share(body.poisson_ratio) / body.shear_modulus_pa
        };
        let (across, along) = (of(|nu| 1.0 - 2.0 * nu), of(|nu| 1.0 - nu));
        let difference = across(body) - counterface.map_or(0.0, across);
        let sum = along(body) + counterface.map_or(0.0, along);
        Ok(ShearedPair {
            friction,
            compliance_ratio: modulus_pa * tangential,
            mismatch: 0.5 * difference / sum,
        })
    }

    /// Coefficient of friction f.
    #[must_use]
    pub fn friction(&self) -> f64 {
        self.friction
    }

    /// Ratio eta of the tangential to the normal compliance, 1 to 1.5.
    #[must_use]
    pub fn compliance_ratio(&self) -> f64 {
        self.compliance_ratio
    }

    /// Dundurs' beta, which couples normal and tangential tractions and is neglected; 0 for equal bodies.
    #[must_use]
    pub fn mismatch(&self) -> f64 {
        self.mismatch
    }

    /// Computes the response to a tangential stress that is a share, above 0 and below 1, of friction times pressure.
    /// `stiffness_pa_per_m` is the normal stiffness K = dp/du under a pressure \[Pa\].
    ///
    /// Displacement and loss are integrals of 1/K over the pressures between p* and p:
    /// d = f eta Int dp/K, W = 4 f^2 eta Int (p + p* - 2 s) ds/K(s).
    ///
    /// # Errors
    /// [`ShearError`] with errors of `stiffness_pa_per_m`, and for a stiffness that falls between p* and p.
    pub fn respond<E>(
        &self,
        pressure_pa: f64,
        share: f64,
        mut stiffness_pa_per_m: impl FnMut(f64) -> Result<f64, E>,
    ) -> Result<ShearedContact, ShearError<E>> {
        let initial_pa_per_m = stiffness_pa_per_m(pressure_pa)?;
        let mut least_pa_per_m = initial_pa_per_m;
        // Pressures fall from p on, and stiffnesses with them.
        let mut falling = |at_pa: f64| {
            let found_pa_per_m = stiffness_pa_per_m(at_pa)?;
            if found_pa_per_m > least_pa_per_m * (1.0 + STIFFNESS_ERROR) {
                return Err(ShearError::FallingStiffness { pressure_pa });
            }
            least_pa_per_m = least_pa_per_m.min(found_pa_per_m);
            Ok(found_pa_per_m)
        };
        let (mut approach_m, mut loss) = (0.0, 0.0);
        each_part(pressure_pa, [0.0, extent(share)], &mut falling, |below, part_m| {
            // s = p e^-below; p + p* - 2 s = p (2 [1 - e^-below] - share), without cancellation.
            let slipped = -(-below).exp_m1();
            approach_m += part_m;
            loss += part_m * pressure_pa * (2.0 * slipped - share);
        })?;
        let stuck_pressure_pa = pressure_pa * (1.0 - share);
        let displacement_m = self.friction * self.compliance_ratio * approach_m;
        // Within the error of a constant stiffness the loss may come out below 0.
        let loss = f64::max(loss, 0.0);
        let dissipation_j_per_m2 = 4.0 * self.friction * self.friction * self.compliance_ratio * loss;
        let stress_pa = share * self.friction * pressure_pa;
        let tangent_pa_per_m = falling(stuck_pressure_pa)?.min(initial_pa_per_m);
        Ok(ShearedContact {
            stuck_pressure_pa,
            displacement_m,
            initial_stiffness_pa_per_m: initial_pa_per_m / self.compliance_ratio,
            tangent_stiffness_pa_per_m: tangent_pa_per_m / self.compliance_ratio,
            dissipation_j_per_m2,
            damping_ratio: dissipation_j_per_m2 / (2.0 * PI * stress_pa * displacement_m),
        })
    }

    /// Follows the stress to a share, above 0 and below 1, of friction times pressure, back to its opposite, and up again. Each
    /// part of the cycle has `steps` steps, at least 1. `stiffness_pa_per_m` is the normal stiffness under a pressure \[Pa\].
    ///
    /// On the way back d = d_max - 2 D((q_max - q)/2), where D is the displacement of first loading (Masing 1926).
    ///
    /// # Errors
    /// Errors of `stiffness_pa_per_m`.
    pub fn cycle<E>(
        &self,
        pressure_pa: f64,
        share: f64,
        steps: usize,
        mut stiffness_pa_per_m: impl FnMut(f64) -> Result<f64, E>,
    ) -> Result<ShearCycle, E> {
        let steps = steps.max(1);
        let mut first_loading = vec![(0.0, 0.0)];
        let (mut approach_m, mut from) = (0.0, 0.0);
        for step in 1..=steps {
            // Closer towards the end, where the curve bends.
            let left = (steps - step) as f64 / steps as f64;
            let reached = share * (1.0 - left * left);
            let to = extent(reached);
            each_part(pressure_pa, [from, to], &mut stiffness_pa_per_m, |_, part_m| approach_m += part_m)?;
            from = to;
            let displacement_m = self.friction * self.compliance_ratio * approach_m;
            first_loading.push((displacement_m, reached * self.friction * pressure_pa));
        }
        let (most_m, most_pa) = first_loading[steps];
        let back = |(way_m, way_pa): &(f64, f64)| (most_m - 2.0 * way_m, most_pa - 2.0 * way_pa);
        let unloading: Vec<(f64, f64)> = first_loading.iter().rev().map(back).collect();
        let reloading = unloading.iter().rev().map(|(at_m, at_pa)| (-at_m, -at_pa)).collect();
        Ok(ShearCycle { first_loading, unloading, reloading })
    }
}

/// The distance of ln p* below ln p at a share of friction times pressure.
fn extent(share: f64) -> f64 {
    -(-share).ln_1p()
}

/// Passes ln p - ln s and ds/K(s) \[m\] at the nodes of an integral over the pressures s between two distances of ln s below
/// ln p.
fn each_part<E>(
    pressure_pa: f64,
    [from, to]: [f64; 2],
    stiffness_pa_per_m: &mut impl FnMut(f64) -> Result<f64, E>,
    mut take: impl FnMut(f64, f64),
) -> Result<(), E> {
    let parts = ((to - from) / WIDEST_PART).ceil().max(1.0);
    let width = (to - from) / parts;
    for part in 0..parts as usize {
        for (below, weight) in RULE.over(from + part as f64 * width, from + (part + 1) as f64 * width) {
            let at_pa = pressure_pa * (-below).exp();
            take(below, weight * at_pa / stiffness_pa_per_m(at_pa)?);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn equal(friction: f64, poisson_ratio: f64) -> ShearedPair {
        let body = ShearedBody { shear_modulus_pa: 1.0, poisson_ratio };
        ShearedPair::new(friction, 1.0 / (1.0 - poisson_ratio), body, Some(body)).unwrap()
    }

    fn assert_near(found: f64, expected: f64) {
        assert!((found / expected - 1.0).abs() < 1e-10, "{found} {expected}");
    }

    const SHARES: [f64; 7] = [1e-3, 0.01, 0.1, 0.5, 0.9, 0.99, 0.999];

    #[test]
    fn a_sphere_responds_as_cattaneo_and_mindlin_have_it() {
        // u = (9 P^2/(16 R E*^2))^(1/3) with R = G = 1, in place of loads per area.
        let load = 0.001f64;
        for (friction, nu) in [(0.2, 0.3), (0.6, 0.45), (0.6, 0.0)] {
            let modulus = 1.0 / (1.0 - nu);
            let radius = (0.75 * load / modulus).cbrt();
            let stiffness = |load: f64| Ok::<f64, ()>(2.0 * modulus * (0.75 * load / modulus).cbrt());
            for share in SHARES {
                let found = equal(friction, nu).respond(load, share, stiffness).unwrap();
                let rest: f64 = 1.0 - share;
                let displacement = 3.0 * (2.0 - nu) * friction * load / (8.0 * radius)
                    * -(2.0 / 3.0 * (-share).ln_1p()).exp_m1();
                assert_near(found.displacement_m, displacement);
                assert_near(found.initial_stiffness_pa_per_m, 4.0 * radius / (2.0 - nu));
                assert_near(found.tangent_stiffness_pa_per_m, 4.0 * radius * rest.cbrt() / (2.0 - nu));
                if share >= 0.1 {
                    let braces =
                        1.0 - rest.powf(5.0 / 3.0) - 5.0 * share / 6.0 * (1.0 + rest.powf(2.0 / 3.0));
                    let loss = 9.0 * (friction * load).powi(2) / (10.0 * radius) * 2.0 * (2.0 - nu) * braces;
                    assert_near(found.dissipation_j_per_m2, loss);
                }
            }
            // -(2/3) (eta/f) u'' Q^3 for a small Q.
            let small = equal(friction, nu).respond(load, 1e-6, stiffness).unwrap();
            let curvature = -(9.0 / (16.0 * modulus * modulus)).cbrt() * (2.0 / 9.0) * load.powf(-4.0 / 3.0);
            let cubed = (1e-6 * friction * load).powi(3);
            let expected = -2.0 / 3.0 * equal(friction, nu).compliance_ratio() / friction * curvature * cubed;
            assert!((small.dissipation_j_per_m2 / expected - 1.0).abs() < 1e-5);
        }
    }

    #[test]
    fn an_exponential_law_has_its_closed_forms() {
        let (pressure_pa, decay_m) = (1e6, 1e-7);
        for (friction, nu) in [(0.2, 0.3), (0.6, 0.45)] {
            let pair = equal(friction, nu);
            let eta = (2.0 - nu) / (2.0 * (1.0 - nu));
            assert_near(pair.compliance_ratio(), eta);
            for share in SHARES {
                let stiffness = |pressure_pa: f64| Ok::<f64, ()>(pressure_pa / decay_m);
                let found = pair.respond(pressure_pa, share, stiffness).unwrap();
                let log = (-share).ln_1p();
                assert_near(found.displacement_m, -friction * eta * decay_m * log);
                assert_near(found.initial_stiffness_pa_per_m, pressure_pa / (eta * decay_m));
                let braces = match share < 0.05 {
                    // The closed form cancels here: its series.
                    true => {
                        (3..12).map(|n| share.powi(n) * (8.0 / f64::from(n) - 4.0 / f64::from(n - 1))).sum()
                    }
                    false => -8.0 * share - (8.0 - 4.0 * share) * log,
                };
                assert_near(
                    found.dissipation_j_per_m2,
                    friction * friction * eta * decay_m * pressure_pa * braces,
                );
            }
        }
    }

    #[test]
    fn a_cycle_encloses_the_energy_lost_and_follows_the_curve_of_first_loading() {
        let (pressure_pa, decay_m) = (1e6, 1e-7);
        let stiffness = |pressure_pa: f64| Ok::<f64, ()>(pressure_pa / decay_m);
        let pair = equal(0.3, 0.3);
        for share in [0.1, 0.6, 0.95] {
            let steps = 400;
            let ShearCycle { first_loading, unloading, reloading } =
                pair.cycle(pressure_pa, share, steps, stiffness).unwrap();
            let found = pair.respond(pressure_pa, share, stiffness).unwrap();
            let (most_m, most_pa) = first_loading[steps];
            assert_near(most_m, found.displacement_m);
            assert_near(most_pa, share * 0.3 * pressure_pa);
            for (displacement_m, stress_pa) in &first_loading[1..] {
                let closed =
                    -0.3 * pair.compliance_ratio() * decay_m * (-stress_pa / (0.3 * pressure_pa)).ln_1p();
                assert_near(*displacement_m, closed);
            }
            for way in [&unloading, &reloading] {
                assert!(way.windows(2).all(|pair| pair[0].0 < pair[1].0 && pair[0].1 < pair[1].1));
                assert!((way[0].0 + most_m).abs() < 1e-12 * most_m && way[steps] == (most_m, most_pa));
            }
            let under = |way: &[(f64, f64)]| {
                way.windows(2)
                    .map(|pair| 0.5 * (pair[0].1 + pair[1].1) * (pair[1].0 - pair[0].0))
                    .sum::<f64>()
            };
            let enclosed = under(&reloading) - under(&unloading);
            assert!((enclosed / found.dissipation_j_per_m2 - 1.0).abs() < 2e-3, "{share}: {enclosed}");
        }
    }

    #[test]
    fn equal_bodies_are_not_coupled_and_a_rigid_one_is_the_limit_of_a_stiff_one() {
        assert_eq!(equal(0.3, 0.3).mismatch(), 0.0);
        let body = ShearedBody { shear_modulus_pa: 80e9, poisson_ratio: 0.3 };
        let stiff = ShearedBody { shear_modulus_pa: 80e21, poisson_ratio: 0.1 };
        let rigid = ShearedPair::new(0.3, 230e9, body, None).unwrap();
        let limit = ShearedPair::new(0.3, 230e9, body, Some(stiff)).unwrap();
        assert_near(limit.compliance_ratio(), rigid.compliance_ratio());
        assert_near(limit.mismatch(), rigid.mismatch());
        assert_near(rigid.mismatch(), 0.5 * 0.4 / 0.7);
        assert!(ShearedPair::new(-0.3, 230e9, body, None).is_err());
    }

    #[test]
    fn errors_of_the_normal_law_are_passed_on() {
        let failed = equal(0.3, 0.3).respond(1e6, 0.5, |_| Err::<f64, _>("none"));
        assert_eq!(failed, Err(ShearError::Stiffness("none")));
    }

    #[test]
    fn a_stiffness_that_falls_with_the_pressure_is_refused() {
        for share in SHARES {
            let softens = |at_pa: f64| Ok::<f64, ()>(1e12 * (1e6 / at_pa));
            let refused = equal(0.3, 0.3).respond(1e6, share, softens);
            assert_eq!(refused, Err(ShearError::FallingStiffness { pressure_pa: 1e6 }), "{share}");
            let constant = equal(0.3, 0.3).respond(1e6, share, |_| Ok::<f64, ()>(1e12)).unwrap();
            assert!(constant.dissipation_j_per_m2 >= 0.0 && constant.damping_ratio < 1e-12, "{constant:?}");
        }
    }
}
