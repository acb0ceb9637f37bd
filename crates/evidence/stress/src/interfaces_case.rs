//! Conductance, leaks and tangential loops of interfaces: their numbers, and the promises of every result.

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use bilby::AdaptiveIntegrator;
use interface::OutOfBounds;
use interface::conductance::{
    Conductivities, CutSurface, PlasticCorrelation, PressureRatio, RelativeStiffness, Resistivities,
};
use interface::gas::{GapGas, NamedGas, plastic_separation_m};
use interface::leak::SealedJoint;
use interface::sealed_fluid::SealedFluid;
use interface::tangential::{ShearError, ShearedBody, ShearedContact, ShearedPair};

use crate::tally::{Case, Refused, Trial};
use crate::{Draw, Reach};

/// Numbers of an interface in SI units; printed, it is a literal that recreates it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InterfacesCase {
    /// Nominal pressure \[Pa\].
    pub pressure_pa: f64,
    /// Contact modulus \[Pa\].
    pub modulus_pa: f64,
    /// Hardness \[Pa\].
    pub hardness_pa: f64,
    /// Decay length of the gap, a length in general \[m\].
    pub length_m: f64,
    /// Thermal conductivities \[W/(m K)\], also taken as electrical resistivities \[ohm m\].
    pub bodies: [f64; 2],
    /// Rms height \[m\].
    pub rms_height_m: f64,
    /// Rms slope.
    pub rms_slope: f64,
    /// Distance of the mean planes over the rms height.
    pub separation: f64,
    /// Gas parameter over the rms height.
    pub gas_parameter: f64,
    /// Conductivity of the gas \[W/(m K)\].
    pub gas_w_per_m_k: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Poisson's ratio of the sheared bodies.
    pub poisson_ratio: f64,
    /// Tangential stress over friction times pressure.
    pub share: f64,
}

impl Case for InterfacesCase {
    fn draw(draw: &mut Draw) -> (Self, Reach) {
        let reach = Reach::draw(draw);
        let modulus_pa = reach.number(draw, 6.0, 13.0);
        let wide = if reach == Reach::Usual { 1.0 } else { 4.0 };
        let case = InterfacesCase {
            pressure_pa: modulus_pa * reach.number(draw, -6.0 * wide, -1.0),
            modulus_pa,
            hardness_pa: modulus_pa * reach.number(draw, -4.0 * wide, 0.0),
            length_m: reach.number(draw, -9.0 * wide, -4.0),
            bodies: [reach.number(draw, -9.0, 3.0), reach.number(draw, -9.0, 3.0)],
            rms_height_m: reach.number(draw, -8.0 * wide, -4.0),
            rms_slope: reach.number(draw, -3.0 * wide, 1.0),
            separation: draw.between(-9.0, 12.0) * draw.one_of(&[1.0, 0.0, 1e-6, 3.0]),
            gas_parameter: reach.number(draw, -3.0 * wide, 2.0 * wide),
            gas_w_per_m_k: reach.number(draw, -3.0 * wide, 0.0),
            friction: reach.number(draw, -2.0 * wide, 0.5 * wide),
            poisson_ratio: draw.one_of(&[0.0, 0.3, 0.5]),
            share: 0.5,
        };
        let middle = draw.between(0.0, 1.0);
        let small = draw.decades(-12.0, 0.0);
        let nearly = 1.0 - draw.decades(-15.0, 0.0);
        let share = draw.one_of(&[middle, small, nearly]);
        (InterfacesCase { share: share.clamp(1e-12, 1.0f64.next_down()), ..case }, reach)
    }

    fn test(trial: &mut Trial<Self>) -> Result<(), Refused> {
        let tested = [spots(trial), plastic(trial), gas(trial), leak(trial), sheared(trial)];
        if tested.iter().all(Result::is_err) { Err(Refused) } else { Ok(()) }
    }
}

fn positive(value: f64) -> bool {
    value > 0.0 && value.is_finite()
}

/// Checks the conductance of spots.
fn spots(trial: &mut Trial<InterfacesCase>) -> Result<(), OutOfBounds> {
    let case = trial.case;
    let stiffness = RelativeStiffness::from_light_load(case.pressure_pa, case.modulus_pa, case.length_m)?;
    let conductivities = Conductivities::new(case.bodies[0], case.bodies[1])?;
    let resistivities = Resistivities::new(case.bodies[0], case.bodies[1])?;
    let heat = stiffness.thermal_conductance_w_per_m2_k(&conductivities);
    let current = stiffness.electrical_conductance_s_per_m2(&resistivities);
    trial.hold("conductance of spots finite, above 0", positive(heat) && positive(current));
    let mean = conductivities.harmonic_mean_w_per_m_k();
    let ends = [case.bodies[0].min(case.bodies[1]), case.bodies[0].max(case.bodies[1])];
    let between = ends[0] * (1.0 - 1e-15) <= mean && mean <= ends[1] * (1.0 + 1e-15);
    trial.hold("mean conductivity between both", between);
    let spot = stiffness.equivalent_spot(case.length_m * case.length_m);
    if let Ok(spot) = spot {
        let area_m2 = case.length_m * case.length_m;
        let off = spot.thermal_conductance_w_per_k(&conductivities) / (heat * area_m2) - 1.0;
        trial.bound("the equivalent spot conducts as much", off.abs(), 1e-13);
        let ohmic =
            spot.electrical_conductance_s(&resistivities) * spot.electrical_resistance_ohm(&resistivities);
        trial.bound("resistance times conductance", (ohmic - 1.0).abs(), 1e-14);
    }
    Ok(())
}

/// Checks plastic correlations and the separation of heights that flow.
fn plastic(trial: &mut Trial<InterfacesCase>) -> Result<(), OutOfBounds> {
    let case = trial.case;
    let ratio = PressureRatio::new(case.pressure_pa, case.hardness_pa)?;
    let surface = CutSurface::from_rms_slope(case.rms_height_m, case.rms_slope)?;
    let separation_m = plastic_separation_m(case.rms_height_m, ratio);
    match separation_m {
        None => trial.hold("some height is out of contact", ratio.value() > 1.0 - 1e-14),
        Some(separation_m) => {
            let u = separation_m / case.rms_height_m;
            let touching = 0.5 * libm::erfc(u * FRAC_1_SQRT_2);
            let off = (touching.ln() - ratio.value().ln()).abs();
            let reaches = ratio.value() > 1e-300;
            trial.bound(
                "heights above the separation touch",
                if reaches { off } else { 0.0 },
                1e-12 * (1.0 + u * u),
            );
        }
    }
    if let Ok(conductivities) = Conductivities::new(case.bodies[0], case.bodies[1]) {
        for correlation in PlasticCorrelation::ALL {
            let conductance = correlation.conductance_w_per_m2_k(&conductivities, &surface, ratio);
            trial.hold("correlations finite, above 0", positive(conductance));
        }
    }
    Ok(())
}

/// Checks the conductance of the gas.
fn gas(trial: &mut Trial<InterfacesCase>) -> Result<(), OutOfBounds> {
    let case = trial.case;
    let parameter_m = case.gas_parameter * case.rms_height_m;
    let gas = GapGas::new(case.gas_w_per_m_k, parameter_m)?;
    if !interface::Bound::Magnitude.admits(case.rms_height_m) {
        return Ok(());
    }
    let conductance = gas.conductance_w_per_m2_k(case.separation * case.rms_height_m, case.rms_height_m);
    let (u, m) = (case.separation, case.gas_parameter);
    let open = 0.5 * libm::erfc(-u * FRAC_1_SQRT_2);
    let unit = case.gas_w_per_m_k / case.rms_height_m;
    let sound = conductance.is_finite() && conductance >= 0.0;
    trial.hold("conductance of the gas finite, at least 0", sound);
    trial.bound("gas at most k/M over open gaps", conductance, unit * open / m * (1.0 + 1e-10));
    // Mean of the open gaps over the nominal area; cancels far below.
    if u > -3.0 {
        let mean = u * open + (-0.5 * u * u).exp() / (2.0 * PI).sqrt();
        let least = unit * open * open / (mean + m * open);
        trial.bound("gas at least k over the mean gap", least, conductance * (1.0 + 1e-9));
    }
    if trial.draw.chance(0.1) && u > -8.0 {
        let integrator =
            AdaptiveIntegrator::default().with_abs_tol(0.0).with_rel_tol(1e-11).with_max_evals(20_000);
        let density = |t: f64| (-0.5 * (u - t) * (u - t)).exp();
        // In t = M sinh(v) both ends of the gaps are resolved.
        let (from, to) = ((u - 12.0).max(0.0), u.max(0.0) + 12.0);
        let [start, end] = [from, to].map(|t| (t / m).asinh());
        let breaks: Vec<f64> = [u - 3.0, u, u + 3.0, 1.0, 0.1]
            .iter()
            .filter(|t| **t > from && **t < to)
            .map(|t| (t / m).asinh())
            .collect();
        let mut breaks = breaks;
        breaks.sort_by(f64::total_cmp);
        let integrand = |v: f64| {
            let t = m * v.sinh();
            density(t) / (t + m) * m * v.cosh()
        };
        if let Ok(result) = integrator.integrate_with_breaks(start, end, &breaks, integrand) {
            let error = result.error_estimate / result.value;
            let theirs = unit * result.value / (2.0 * PI).sqrt();
            if error < 1e-9 {
                trial.bound(
                    "another quadrature agrees on the gas",
                    (conductance / theirs - 1.0).abs(),
                    1e-9 + 2.0 * error,
                );
            }
        }
    }
    for named in NamedGas::ALL {
        if let Ok(parameter_m) = named.parameter_m(case.bodies[0], case.pressure_pa) {
            trial.hold("gas parameter finite, above 0", positive(parameter_m));
        }
    }
    Ok(())
}

/// Checks the leak rate.
fn leak(trial: &mut Trial<InterfacesCase>) -> Result<(), OutOfBounds> {
    let case = trial.case;
    let fluid = SealedFluid::Incompressible { viscosity_pa_s: case.bodies[0] };
    let joint = SealedJoint::new(case.length_m, case.rms_height_m, case.pressure_pa, fluid)?;
    let cube_m3 = interface::Bound::Magnitude.check("length", case.length_m)?.powi(3);
    let [rate, of_twice] =
        [1.0, 8.0].map(|factor| joint.leak_rate([factor * cube_m3; 2], 0.1, case.length_m).low_m3_per_s);
    trial.hold("leak rate finite, above 0", positive(rate));
    trial.bound("leaks by the cube of the height", (of_twice / rate / 8.0 - 1.0).abs(), 1e-14);
    Ok(())
}

/// Checks loops of tangential load against the closed forms of an exponential law and of a sphere.
fn sheared(trial: &mut Trial<InterfacesCase>) -> Result<(), OutOfBounds> {
    let case = trial.case;
    let body = ShearedBody { shear_modulus_pa: case.modulus_pa, poisson_ratio: case.poisson_ratio };
    let pair = ShearedPair::new(case.friction, case.modulus_pa, body, None)?;
    interface::Bound::Magnitude.check("pressure", case.pressure_pa)?;
    interface::Bound::Magnitude.check("length", case.length_m)?;
    let (f, eta, p, x) = (pair.friction(), pair.compliance_ratio(), case.pressure_pa, case.share);
    let exponential = pair.respond(p, x, |at_pa| Ok::<f64, OutOfBounds>(at_pa / case.length_m));
    let displacement_m = -f * eta * case.length_m * (-x).ln_1p();
    let loss = f * f * eta * case.length_m * p * (-8.0 * x - (8.0 - 4.0 * x) * (-x).ln_1p());
    loop_of(exponential, [displacement_m, loss], trial)?;
    // Sphere: u = length (p/modulus)^(2/3).
    let approach_m = |at_pa: f64| case.length_m * (at_pa / case.modulus_pa).cbrt().powi(2);
    let stiffness = |at_pa: f64| 1.5 * at_pa / approach_m(at_pa);
    let sphere = pair.respond(p, x, |at_pa| Ok::<f64, OutOfBounds>(stiffness(at_pa)));
    // (1 - x)^(2/3) and (1 - x)^(5/3), both less 1, without cancellation.
    let [two, five] = [2.0 / 3.0, 5.0 / 3.0].map(|power: f64| (power * (-x).ln_1p()).exp_m1());
    let displacement_m = -f * eta * approach_m(p) * two;
    let loss = f * f * eta * approach_m(p) * p * (-4.0 * x * two - 8.0 * x - 4.8 * five);
    loop_of(sphere, [displacement_m, loss], trial)
}

fn loop_of(
    contact: Result<ShearedContact, ShearError<OutOfBounds>>,
    [displacement_m, loss_j_per_m2]: [f64; 2],
    trial: &mut Trial<InterfacesCase>,
) -> Result<(), OutOfBounds> {
    let case = trial.case;
    let contact = match contact {
        Ok(contact) => contact,
        Err(ShearError::Stiffness(error)) => return Err(error),
        Err(ShearError::FallingStiffness { .. }) => {
            trial.hold("stiffness rises with the pressure", false);
            return Ok(());
        }
    };
    let numbers = [
        contact.displacement_m,
        contact.initial_stiffness_pa_per_m,
        contact.tangent_stiffness_pa_per_m,
        contact.dissipation_j_per_m2,
        contact.damping_ratio,
        contact.stuck_pressure_pa,
    ];
    trial.hold("loop finite, at least 0", numbers.iter().all(|number| *number >= 0.0 && number.is_finite()));
    trial.bound("damping at most 2/pi", contact.damping_ratio, 2.0 / PI * (1.0 + 1e-9));
    if trial.reach == Reach::Edge {
        return Ok(());
    }
    let off = (contact.displacement_m / displacement_m - 1.0).abs();
    trial.bound("displacement by the closed form", off, 1e-9);
    if case.share > 0.02 && loss_j_per_m2 > 0.0 {
        let off = (contact.dissipation_j_per_m2 / loss_j_per_m2 - 1.0).abs();
        trial.bound("loss by the closed form", off, 1e-9 / case.share.powi(2));
    }
    let softer = contact.tangent_stiffness_pa_per_m / contact.initial_stiffness_pa_per_m;
    trial.bound("slip softens", softer, 1.0 + 1e-12);
    Ok(())
}
