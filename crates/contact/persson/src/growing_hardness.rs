//! Elastic-plastic contact of a hardness that grows towards small scales: Persson (2006), Surf. Sci. Rep. 61:201.
//!
//! Plastic contact stays at the hardness H(V) of the scale and returns area to the elastic part as H grows; area and
//! force are conserved at every scale. The mean excess C(sigma, V) = E[(X - sigma)+] of the stress X of a random
//! point obeys a heat equation between two fixed values:
//!
//! C_V = C''/2,  C(0) = p,  C(H(V)) = 0,  C(sigma, 0) = (p - sigma)+;  A = -C'(0),  A_pl = -C'(H).
//!
//! As long as little of the stress has reached the hardness, and wherever the hardness steps or runs away from it, an integral
//! equation gives A_pl to its own last digits, at a cost that grows with the square of the pieces of the path. From where the
//! stress has spread over the whole interval between the walls, and the hardness grows gently to the end, C is followed by its
//! modes, and beside kinks of the hardness by the integral equation from the modes on.

use std::f64::consts::PI;
use std::sync::LazyLock;

use crate::areas::ContactAreas;
use crate::beside_kinks::{BesideKinks, is_resolved, stop_before_end};
use crate::hardness_path::HardnessPath;
use crate::plastic_march::PlasticMarch;
use crate::stress_modes::{Elimination, Stage, StressEquations};

static EQUATIONS: LazyLock<StressEquations> = LazyLock::new(StressEquations::new);

/// Ratio of two neighbouring stops at most; below the first one, stops go down to a part of it.
const STOP_RATIO: f64 = 1.4;
const FIRST_STOP: f64 = 1e4;
/// Ratio V/H^2 over which the stress spreads so far from a kink of the mean excess that its modes resolve it, and the one at which
/// a stop is made for it.
const SPREAD: f64 = 0.036;
const SPREAD_STOP: f64 = 0.04;
/// Growth d(H^2)/dV up to which they resolve the fall of C. In the long run A_pl/A is exp(-d(H^2)/dV/2).
const FASTEST: f64 = 30.0;
/// First step from a kink of the hardness, in sqrt(V - V_i) over the hardness or the spread, and growth of that root over a later
/// one: a kink sends waves of all lengths into the modes, which steps of one ratio damp in turn.
const FIRST_STEP: f64 = 0.05;
const LATER_STEP: f64 = 1.5;
/// Longest step in V/H^2 relative to V/H^2, and its square beyond 1, since what it follows grows as slowly as that.
const RELATIVE_STEP: f64 = 0.1;
/// Longest step in V/H^2 at first, and the rate at which later ones may be longer, since the slowest mode falls by exp(-pi^2/2) in
/// each unit.
const EARLY_STEP: f64 = 0.03;
const FORGETTING: f64 = 0.6;
/// Step towards the end of a variance, relative to what is left: the hardness grows over less and less of it.
const STEP_OF_REST: f64 = 0.25;
/// Ratio H^2/V below which the areas are those of a hardness that has always grown as it does: the stress between the walls
/// spreads over all of them within V of the order of H^2, while the growth changes over V of the order of V. Panels of the
/// width of V would resolve it less and less.
const FORGOTTEN: f64 = 1e-6;

/// Returns the shares of the nominal area at each of some non-decreasing variances of the flattening pressure, under
/// a nominal pressure 0 < p < H(0) \[Pa\]. Areas are accurate to 1e-8 of
/// the contact, to 1e-7 beside kinks at which the hardness has grown fast, and plastic areas to 1e-6 of themselves. Before
/// a step of the hardness, or a place where it runs away from the stress, areas are accurate to 1e-7 up to a spread sqrt(V)
/// of a hundred times the hardness, and to 1e-5 beyond.
#[must_use]
pub fn areas_along(path: &HardnessPath, pressure_pa: f64, variances_pa2: &[f64]) -> Vec<ContactAreas> {
    if path.is_constant() {
        let hardness_pa = path.hardness_pa(0.0);
        return variances_pa2
            .iter()
            .map(|variance_pa2| {
                crate::constant_hardness::areas(pressure_pa, variance_pa2.sqrt(), hardness_pa)
            })
            .collect();
    }
    let has_forgotten = |variance_pa2: f64| has_forgotten(path, variance_pa2);
    let last = variances_pa2.iter().rposition(|variance_pa2| !has_forgotten(*variance_pa2));
    let stops = Stops::new(path, &variances_pa2[..last.map_or(0, |last| last + 1)]);
    let mut march = PlasticMarch::new(path, pressure_pa);
    march.extend_to(stops.late_from_pa2());
    let late = follow(&mut march, path, pressure_pa, &stops);
    let areas =
        |&variance_pa2: &f64| match late.binary_search_by(|(at_pa2, _)| at_pa2.total_cmp(&variance_pa2)) {
            _ if has_forgotten(variance_pa2) => {
                let hardness_pa = path.hardness_pa(variance_pa2);
                steady(pressure_pa / hardness_pa, path.growth_of_square(variance_pa2).min(FORGOTTEN))
            }
            Ok(at) => late[at].1,
            Err(_) => march.areas_at(variance_pa2),
        };
    variances_pa2.iter().map(areas).collect()
}

/// Returns the areas at all later stops, from where the stress is late.
fn follow(
    march: &mut PlasticMarch,
    path: &HardnessPath,
    pressure_pa: f64,
    stops: &Stops,
) -> Vec<(f64, ContactAreas)> {
    let intervals = stops.late_intervals();
    let mut areas = Vec::with_capacity(intervals.len());
    if intervals.len() == 0 {
        return areas;
    }
    let (equations, mut elimination) = (&*EQUATIONS, Elimination::default());
    let mut elapsed = 0.0f64;
    let hardness_pa = path.hardness_pa(stops.late_from_pa2());
    let mut state = equations.expand(|x| hardness_pa / pressure_pa * march.fall_at(x * hardness_pa));
    let mut beside_kinks =
        BesideKinks::new(path, pressure_pa, equations, (stops.late_from_pa2(), state.clone()));
    for [from_pa2, to_pa2] in intervals {
        let at = path.piece_at(from_pa2);
        let piece = path.piece(at);
        if piece.from_variance_pa2 == from_pa2 {
            beside_kinks.enter(at);
        }
        let kink_pa2 = piece.from_variance_pa2;
        let hardness_pa = piece.hardness_pa(from_pa2);
        let first_pa = FIRST_STEP * hardness_pa.min(from_pa2.sqrt());
        let [mut reached_pa, end_pa] = [from_pa2, to_pa2].map(|at_pa2| (at_pa2 - kink_pa2).sqrt());
        while reached_pa < end_pa {
            let reached_pa2 = kink_pa2 + reached_pa * reached_pa;
            let time = reached_pa2 / (hardness_pa * hardness_pa);
            let longest =
                (EARLY_STEP * (FORGETTING * elapsed).exp()).min(RELATIVE_STEP * time * time.max(1.0));
            let longest_pa2 =
                (longest * hardness_pa * hardness_pa).min(STEP_OF_REST * piece.left_pa2(reached_pa2));
            let within_pa = (reached_pa * reached_pa + longest_pa2).sqrt();
            // Far above the hardness a step within it is below the rounding of V.
            let within_pa = within_pa.max(reached_pa * (1.0 + 1e-6));
            let next_pa = end_pa.min(first_pa.max(LATER_STEP * reached_pa)).min(within_pa);
            let step_pa = next_pa - reached_pa;
            elapsed += step_pa * (reached_pa + next_pa) / (hardness_pa * hardness_pa);
            equations.step(&mut state, &mut elimination, |t| {
                let from_kink_pa = reached_pa + t * step_pa;
                let variance_pa2 = kink_pa2 + from_kink_pa * from_kink_pa;
                let hardness_pa = piece.hardness_pa(variance_pa2);
                Stage {
                    length: 2.0 * from_kink_pa * step_pa / (hardness_pa * hardness_pa),
                    growth: 0.5 * piece.growth_of_square(variance_pa2),
                }
            });
            reached_pa = next_pa;
        }
        areas.push((to_pa2, beside_kinks.areas(&piece, to_pa2, &state)));
    }
    areas
}

/// Rising variances \[Pa^2\] at which areas are asked for or a piece of the path begins, and others between them.
struct Stops {
    variances_pa2: Vec<f64>,
    /// Place of the stop from which on the stress is late.
    late: usize,
}

impl Stops {
    fn new(path: &HardnessPath, asked_pa2: &[f64]) -> Self {
        let last_pa2 = asked_pa2.last().copied().unwrap_or(0.0);
        let starts = path.pieces().iter().map(|piece| piece.from_variance_pa2);
        let ends_pa2 = starts.clone().skip(1).chain([last_pa2]);
        let before_ends = path.pieces().iter().zip(ends_pa2);
        let before_ends =
            before_ends.filter_map(|(piece, end_pa2)| stop_before_end(piece, end_pa2.min(last_pa2)));
        let mut ends: Vec<f64> = starts
            .chain(asked_pa2.iter().copied())
            .chain(before_ends)
            .filter(|at| *at > 0.0 && *at <= last_pa2)
            .collect();
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        let mut variances_pa2 = Vec::with_capacity(ends.len());
        let mut from_pa2 = 0.0;
        for to_pa2 in ends {
            let ratio = (to_pa2 / from_pa2).min(FIRST_STOP);
            let steps = (ratio.ln() / STOP_RATIO.ln()).ceil().max(1.0);
            let between = (1..steps as i32).rev().map(|left| to_pa2 * ratio.powf(-f64::from(left) / steps));
            variances_pa2.extend(between);
            variances_pa2.push(to_pa2);
            from_pa2 = to_pa2;
        }
        // The mean excess has a kink where it begins and where the hardness leaves it.
        let last_kink_pa2 = intervals(&variances_pa2).rev().find_map(|interval| kink_between(path, interval));
        let kink_pa2 = last_kink_pa2.unwrap_or(0.0);
        let spread_from_pa2 = kink_pa2 + SPREAD_STOP * path.hardness_pa(kink_pa2).powi(2);
        let place = variances_pa2.partition_point(|at_pa2| *at_pa2 < spread_from_pa2);
        if kink_pa2 > 0.0 && place < variances_pa2.len() {
            variances_pa2.insert(place, spread_from_pa2);
        }
        let has_spread = |at_pa2: f64| at_pa2 - kink_pa2 >= SPREAD * path.hardness_pa(at_pa2).powi(2);
        let last_early = variances_pa2.iter().rposition(|at_pa2| !has_spread(*at_pa2));
        let last = variances_pa2.len().saturating_sub(1);
        let mut late = last_early.map_or(0, |at| at + 1).min(last);
        while late < last && !is_resolved(path, variances_pa2[late]) {
            late += 1;
        }
        Stops { variances_pa2, late }
    }

    /// Variance from which on the stress is late; the last stop if it never is.
    fn late_from_pa2(&self) -> f64 {
        self.variances_pa2.get(self.late).copied().unwrap_or(0.0)
    }

    /// Intervals between the stops from there on.
    fn late_intervals(&self) -> impl ExactSizeIterator<Item = [f64; 2]> {
        intervals(self.variances_pa2.get(self.late..).unwrap_or_default())
    }
}

fn intervals(stops_pa2: &[f64]) -> impl DoubleEndedIterator<Item = [f64; 2]> + ExactSizeIterator {
    stops_pa2.windows(2).map(|ends| [ends[0], ends[1]])
}

/// Returns the last variance between two neighbouring stops at which the hardness leaves the stress behind, by a step or by fast
/// growth.
fn kink_between(path: &HardnessPath, [from_pa2, to_pa2]: [f64; 2]) -> Option<f64> {
    let at = path.piece_at(from_pa2);
    let piece = path.piece(at);
    if [from_pa2, to_pa2].iter().any(|at_pa2| piece.growth_of_square(*at_pa2) > FASTEST) {
        return Some(to_pa2);
    }
    Some(from_pa2).filter(|_| piece.from_variance_pa2 == from_pa2 && path.step_pa(at) > 0.0)
}

/// Returns true if the stress spreads so far above the hardness that it has forgotten where it came from.
fn has_forgotten(path: &HardnessPath, variance_pa2: f64) -> bool {
    path.hardness_pa(variance_pa2).powi(2) < FORGOTTEN * variance_pa2
}

/// Returns a hardness and a spread \[Pa\] at which the stress has forgotten its past although the hardness grows to its size
/// later, which [`areas_along`] cannot follow.
pub(crate) fn overrun(path: &HardnessPath, variances_pa2: &[f64]) -> Option<(f64, f64)> {
    let last = variances_pa2.iter().rfind(|variance_pa2| !has_forgotten(path, **variance_pa2))?;
    let starts = path.pieces().iter().map(|piece| piece.from_variance_pa2);
    let ends = starts.chain([*last]).filter(|end| end <= last);
    let before =
        ends.flat_map(|end| [0.5 * end, end.next_down()]).find(|at| *at > 0.0 && has_forgotten(path, *at))?;
    Some((path.hardness_pa(before), before.sqrt()))
}

/// Returns the shares under a nominal pressure 0 < p < H_0, a spread s >= 0 and a hardness H^2 = H_0^2 + c s^2, c >=
/// 0.
#[must_use]
pub fn areas_of_squared_growth(
    pressure_pa: f64,
    spread_pa: f64,
    hardness_pa: f64,
    growth: f64,
) -> ContactAreas {
    let relative = spread_pa / hardness_pa;
    let grown = growth * relative * relative;
    // Diffusion time in units of the interval's length; the slowest mode decays faster than exp(-pi^2/2 of it).
    let elapsed = if grown > 0.0 { libm::log1p(grown) / growth } else { relative * relative };
    if growth > 0.0 && elapsed > STEADY {
        return steady(pressure_pa / (hardness_pa * (1.0 + grown).sqrt()), growth);
    }
    let path = HardnessPath::with_squared_growth(hardness_pa, growth);
    areas_along(&path, pressure_pa, &[spread_pa * spread_pa])[0]
}

/// Diffusion time from which the initial state no longer matters: exp(-8 pi^2/2) = 7e-18.
const STEADY: f64 = 8.0;

/// Limit of large V for a hardness H^2 = H_0^2 + c V under p = `pressure` H: A = (p/H) sqrt(2c/pi)/erf(sqrt(c/2)),
/// A_pl = A exp(-c/2).
fn steady(pressure: f64, growth: f64) -> ContactAreas {
    let root = (0.5 * growth).sqrt();
    let slowing = if root > 0.0 { 2.0 / PI.sqrt() * root / libm::erf(root) } else { 1.0 };
    let contact = (pressure * slowing).min(1.0);
    let (elastic, plastic) = (-contact * libm::expm1(-0.5 * growth), contact * (-0.5 * growth).exp());
    ContactAreas { elastic, plastic, gap: 1.0 - contact }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::HardnessKnot;

    #[test]
    fn each_place_of_a_curve_agrees_with_the_place_alone() {
        let path = HardnessPath::with_squared_growth(1.0, 2.0);
        let variances_pa2: Vec<f64> = (0..40).map(|i| 1e-4 * 10f64.powf(f64::from(i) / 8.0)).collect();
        let together = areas_along(&path, 0.2, &variances_pa2);
        for (at, areas) in together.iter().enumerate() {
            let alone = areas_of_squared_growth(0.2, variances_pa2[at].sqrt(), 1.0, 2.0);
            assert!((areas.contact() / alone.contact() - 1.0).abs() < 1e-9, "{at}");
            assert!((areas.plastic - alone.plastic).abs() <= 1e-9 * alone.contact(), "{at}");
        }
    }

    #[test]
    fn growth_that_ends_leaves_the_law_of_constant_hardness_to_take_over() {
        // Grows to sqrt(3) at V = 1 and is constant beyond: at late times A = p/H.
        let path = HardnessPath::with_squared_growth(1.0, 2.0).capped(3f64.sqrt());
        let areas = areas_along(&path, 0.1, &[0.5, 1.0, 40.0]);
        let growing = areas_of_squared_growth(0.1, 0.5f64.sqrt(), 1.0, 2.0);
        assert!((areas[0].contact() / growing.contact() - 1.0).abs() < 1e-11, "{areas:?} {growing:?}");
        assert!((areas[2].contact() / (0.1 / 3f64.sqrt()) - 1.0).abs() < 1e-8, "{:?}", areas[2]);
        assert!(areas[2].elastic < 1e-10 && areas[1].elastic > 1e-3, "{areas:?}");
    }

    #[test]
    fn a_hardness_that_outgrows_the_stress_at_first_and_falls_behind_later_is_followed() {
        // V = q^4 - 1 under H = 3 q^0.5 grows from nothing to many times H^2.
        let knot = |i: i32| {
            let q = 1.0 + 1e-6 * 10f64.powf(f64::from(i) / 5.0);
            HardnessKnot {
                wavevector_rad_per_m: q,
                variance_pa2: libm::expm1(4.0 * q.ln()),
                hardness_pa: 3.0 * q.sqrt(),
                variance_exponent: 4.0,
            }
        };
        let mut knots: Vec<HardnessKnot> = (0..=37).map(knot).collect();
        knots.insert(
            0,
            HardnessKnot { wavevector_rad_per_m: 1.0, variance_pa2: 0.0, hardness_pa: 1e-3, ..knots[0] },
        );
        let path = HardnessPath::through(&knots);
        let variances_pa2: Vec<f64> = knots.iter().map(|knot| knot.variance_pa2).collect();
        let areas = areas_along(&path, 5e-4, &variances_pa2);
        for (areas, knot) in areas.iter().zip(&knots) {
            assert!((areas.elastic + areas.plastic + areas.gap - 1.0).abs() < 1e-12, "{areas:?}");
            assert!(areas.plastic * knot.hardness_pa <= 5e-4, "{areas:?}");
        }
        let last = areas.last().unwrap();
        assert!(last.plastic > 0.9 * last.contact(), "{last:?}");
    }

    #[test]
    fn early_and_late_forms_meet() {
        let growth = 0.5f64;
        let at = |elapsed: f64| (libm::expm1(growth * elapsed) / growth).sqrt();
        let [before, after] = [STEADY - 1e-9, STEADY + 1e-9]
            .map(|elapsed| areas_of_squared_growth(0.3, at(elapsed), 1.0, growth));
        assert!((before.contact() / after.contact() - 1.0).abs() < 2e-9, "{before:?} {after:?}");
        assert!((before.plastic / after.plastic - 1.0).abs() < 2e-9);
    }
}
