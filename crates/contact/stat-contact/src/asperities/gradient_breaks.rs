//! Breaks below complete contact of elastic-plastic sinusoids whose strength depends on the depth.

use asperity::elementary;
use numerics::{minimum_in_bracket, zero_in_bracket};

use super::gradient_law::GradientLaw;

/// Interferences \[m\] between two others at which the force or the area has a kink or jump. Some of those returned
/// may lie outside, or where nothing yields.
pub(crate) fn breaks_m(law: &GradientLaw, from_m: f64, to_m: f64) -> Vec<f64> {
    let mut breaks_m = vec![law.critical_m];
    breaks_m.extend(law.strength.cap_depth_m());
    breaks_m.extend(ends_of_growth_m(law, to_m));
    // The break of the elastic area matters only where nothing yields; elsewhere it costs a panel.
    let elastic = law.at_depth(from_m).elastic();
    breaks_m.extend(
        elastic
            .breaks()
            .map(|b| law.shape.interference_m(b.at))
            .filter(|&w| !law.at_depth(w).yields_at(law.pressure_pa(w))),
    );
    // Strictly inside the plastic branch, whose criteria have no meaning at its very edge.
    const BESIDE: f64 = 1e-12;
    let edge_m = from_m.max(law.critical_m * (1.0 + BESIDE));
    breaks_m.extend(flow_changes_m(law, edge_m, to_m));
    breaks_m.extend(crossing_m(edge_m, to_m, |w| law.log_pressure_over_critical(w)));
    breaks_m.extend(crossing_m(edge_m, to_m, |w| law.at_depth(w).flattening_margin(law.pressure_pa(w))));
    breaks_m
}

/// Interferences \[m\] between which the growth of the strength, (1 + h*/w)^(1/2), takes place, if they are a small
/// part of the interferences up to one: a rule over all of these would see too little of the growth to estimate its
/// own error.
pub(crate) fn ends_of_growth_m(law: &GradientLaw, to_m: f64) -> impl Iterator<Item = f64> {
    // Ends in units of h*: in the cube root of the interference, the singularity at -h* is as far off as each stretch
    // is long.
    const ENDS: [f64; 2] = [1.0, 500.0];
    const SMALL_PART: f64 = 1e-3;
    let length_m = law.strength.strain_gradient_length_m().filter(|length_m| *length_m < SMALL_PART * to_m);
    length_m.into_iter().flat_map(|length_m| ENDS.map(|end| end * length_m))
}

/// Interference \[m\] between two others at which `sign` is zero, if its signs at the two differ.
fn crossing_m(from_m: f64, to_m: f64, sign: impl Fn(f64) -> f64) -> Option<f64> {
    let at = |log_m: f64| sign(log_m.exp());
    let (low, high) = (from_m.ln(), to_m.ln());
    (low < high && at(low) * at(high) < 0.0).then(|| zero_in_bracket(low, high, at).exp())
}

/// Interferences at which plastic flow sets in or gives way to elasticity. The exponent A2 falls and rises again with
/// r, so that this may happen several times, and a short stretch of flow may lie between two samples: an extremum
/// that bends towards the other sign is examined.
fn flow_changes_m(law: &GradientLaw, from_m: f64, to_m: f64) -> Vec<f64> {
    // Nine decades at three samples each; the exponent bends at most once between samples.
    const SAMPLES: usize = 25;
    // 0.618^40 of the bracket, some 1e-8, is where a minimum loses its digits.
    const GOLDEN_STEPS: usize = 40;
    if from_m >= to_m {
        return Vec::new();
    }
    let margin = |log_m: f64| {
        let depth_m = elementary::exp(log_m);
        // The exponential of a logarithm may exceed complete contact by its rounding.
        let ratio = (depth_m / law.amplitude_m).min(1.0 - f64::EPSILON);
        law.at_depth(depth_m).flow_margin_at_interference(ratio)
    };
    let (low, step) = (from_m.ln(), (to_m / from_m).ln() / (SAMPLES - 1) as f64);
    let even: [[f64; 2]; SAMPLES] = std::array::from_fn(|i| {
        let log_m = low + step * i as f64;
        [log_m, margin(log_m)]
    });
    let mut samples = even.to_vec();
    for neighbours in even.windows(3) {
        let [[left, at_left], [_, at_middle], [right, at_right]] =
            [neighbours[0], neighbours[1], neighbours[2]];
        let bends_towards_zero = at_left * at_middle > 0.0
            && at_middle * at_right > 0.0
            && at_middle.abs() < at_left.abs().min(at_right.abs());
        if bends_towards_zero {
            let signed = |log_m: f64| margin(log_m) * at_middle.signum();
            let extremum = minimum_in_bracket(left, right, GOLDEN_STEPS, signed);
            samples.push([extremum, margin(extremum)]);
        }
    }
    samples.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let changes = samples.windows(2).filter(|pair| pair[0][1] * pair[1][1] < 0.0);
    changes.map(|pair| zero_in_bracket(pair[0][0], pair[1][0], margin).exp()).collect()
}
