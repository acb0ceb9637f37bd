//! Elastic-plastic contact of a hardness that grows towards small scales: Persson (2006), Surf. Sci. Rep. 61:201.
//!
//! Plastic contact stays at the hardness H(V) of the scale and returns area to the elastic part as H grows; area and
//! force are conserved at every scale. The mean excess C(sigma, V) = E[(X - sigma)+] of the stress X of a random
//! point obeys a heat equation between two fixed values:
//!
//! C_V = C''/2,  C(0) = p,  C(H(V)) = 0,  C(sigma, 0) = (p - sigma)+;  A = -C'(0),  A_pl = -C'(H).
//!
//! Continued by zero above H, C is the elastic solution less the contribution of sources of strength A_pl(V')/2 along
//! the path sigma = H(V'). Its slope on that path is an integral equation of the second kind for A_pl alone, and the
//! area follows from A_pl by an integral of positive terms:
//!
//! A_pl(V) = D(V) + Int_0^V A_pl(V') [(H + H') g(H + H') - (H - H') g(H - H')] dV',
//! A(V) = erf(p/(sqrt2 s)) + Int_0^V A_pl(V') H' g(H') dV',
//!
//! with g(d) = exp(-d^2/(2 (V - V')))/(sqrt(2 pi) (V - V')^(3/2)), H' = H(V') and D = erfc((H - p)/(sqrt2 s)) -
//! erfc((H + p)/(sqrt2 s)). With a constant hardness its iterations are the images. Panels of V at a distance act like
//! a few points each.

use std::f64::consts::PI;

use numerics::{GaussLegendre, solve};

use crate::areas::ContactAreas;
use crate::constant_hardness::image;
use crate::elastic;
use crate::hardness_path::{HardnessPath, Piece};
use crate::panel_rules::{Arc, Polynomial, Rules, SIZE, SIZE_MIN};
use crate::sources::{Source, Sources, rule_at};

/// Widths of panels, in the unit of `WIDEST`, up to which `SIZE_MIN` unknowns and each one more suffice. The error
/// falls like the width to the power of their number.
const WIDTHS: [f64; SIZE - SIZE_MIN] = [0.03, 0.065, 0.1, 0.14];
/// Largest width of a panel, in sqrt(V - V_i) over sqrt(V), with V_i the start of its piece of the path.
const WIDEST: f64 = 0.2;
/// Growth of sqrt(V - V_i) over a panel beyond a step, the share of the step below which nothing arrives, and the multiple of
/// it from which the step is forgotten.
const STEP_GROWTH: f64 = 1.25;
const STEP_UNREACHED: f64 = 0.028;
const STEP_OVER: f64 = 4.0;
/// Ratio H^2/V below which the areas are those of a hardness that has always grown as it does: the stress between the walls
/// spreads over all of them within V of the order of H^2, while the growth changes over V of the order of V. Panels of the
/// width of V would resolve it less and less.
const FORGOTTEN: f64 = 1e-6;
/// Smallest width of a panel, relative to V.
const NARROWEST: f64 = 16.0 * f64::EPSILON;
/// Growth of the hardness beyond the place up to which it is smooth that a panel may contain.
const MOST_GROWTH: f64 = 1.01;
/// Distance E = (H - p)^2/(2V) above which the plastic share underflows a double.
const UNREACHED: f64 = 600.0;
/// Exponent beyond which exp(-x) is negligible beside 1.
const NEGLIGIBLE: f64 = 45.0;

/// Returns the shares of the nominal area at each of some non-decreasing variances of the flattening pressure, under
/// a nominal pressure 0 < p < H(0) \[Pa\]. Areas are accurate to 1e-9 or better up to a spread sqrt(V) of a hundred times
/// the hardness, and to 1e-5 beyond.
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
    let mut march = March::new(path, pressure_pa);
    march.extend_to(
        variances_pa2.iter().rfind(|variance_pa2| !has_forgotten(**variance_pa2)).copied().unwrap_or(0.0),
    );
    let areas = |&variance_pa2: &f64| match has_forgotten(variance_pa2) {
        true => {
            let hardness_pa = path.hardness_pa(variance_pa2);
            steady(pressure_pa / hardness_pa, path.growth_of_square(variance_pa2).min(FORGOTTEN))
        }
        false => march.areas_at(variance_pa2),
    };
    variances_pa2.iter().map(areas).collect()
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

/// Plastic area up to some variance, panel by panel.
struct March<'a> {
    path: &'a HardnessPath,
    pressure_pa: f64,
    rules: Rules,
    panels: Vec<Panel>,
    /// End of the last panel \[Pa^2\].
    reached_pa2: f64,
    /// True as long as the distance E has only decreased.
    approaching: bool,
    /// A_pl of the panels as few points, for larger variances.
    sources: Sources,
}

/// Interval of V on which A_pl and its contribution to the area are polynomials, or polynomials times exp(-E) where
/// they still grow that steeply.
struct Panel {
    from_pa2: f64,
    to_pa2: f64,
    piece: Piece,
    /// Distances sqrt(V - V_i) at both ends \[Pa\].
    kink_distances_pa: [f64; 2],
    steep: bool,
    /// E at the end.
    last_distance: f64,
    /// Number of coefficients that are not 0.
    size: usize,
    /// Polynomial of A_pl; `None` while it is being solved for.
    plastic: Option<Polynomial>,
    /// Polynomial of A less the elastic theory's A.
    held: Polynomial,
}

/// Variance and the hardness there.
#[derive(Clone, Copy)]
struct Place {
    variance_pa2: f64,
    hardness_pa: f64,
}

impl<'a> March<'a> {
    fn new(path: &'a HardnessPath, pressure_pa: f64) -> Self {
        let distance_pa = path.hardness_pa(0.0) - pressure_pa;
        let reached_pa2 = 0.5 * distance_pa * distance_pa / UNREACHED;
        March {
            path,
            pressure_pa,
            rules: Rules::new(),
            panels: Vec::new(),
            reached_pa2,
            approaching: true,
            sources: Sources::default(),
        }
    }

    /// Areas at a variance that has been reached.
    fn areas_at(&self, variance_pa2: f64) -> ContactAreas {
        let spread_pa = variance_pa2.sqrt();
        let elastic = elastic::area_fraction(self.pressure_pa, spread_pa);
        let gap = elastic::gap_fraction(self.pressure_pa, spread_pa);
        let at = self.panels.partition_point(|panel| panel.from_pa2 < variance_pa2);
        let panel = at.checked_sub(1).map(|at| &self.panels[at]);
        // Between two panels there is at most rounding.
        let ends_before = |panel: &Panel| panel.to_pa2 < variance_pa2 * (1.0 - 2.0 * NARROWEST);
        let panel = panel.filter(|panel| !ends_before(panel));
        let Some((panel, coefficients)) = panel.and_then(|panel| Some((panel, panel.plastic.as_ref()?)))
        else {
            return ContactAreas { elastic, plastic: 0.0, gap };
        };
        let inside_pa2 = variance_pa2.min(panel.to_pa2);
        let place = Place { variance_pa2: inside_pa2, hardness_pa: panel.piece.hardness_pa(inside_pa2) };
        let t = panel.variable((inside_pa2 - panel.piece.from_variance_pa2).sqrt());
        let scale = if panel.steep { (-place.distance(self.pressure_pa)).exp() } else { 1.0 };
        let [plastic, held] = [coefficients, &panel.held].map(|polynomial| scale * value(polynomial, t));
        let contact = (elastic + held).clamp(0.0, 1.0);
        let plastic = plastic.clamp(0.0, contact);
        ContactAreas { elastic: contact - plastic, plastic, gap: (gap - held).clamp(0.0, 1.0) }
    }

    /// Appends the panels up to a variance, split where a piece of the path begins.
    fn extend_to(&mut self, variance_pa2: f64) {
        while self.reached_pa2 < variance_pa2 {
            let pieces = self.path.pieces();
            let next = pieces.partition_point(|piece| piece.from_variance_pa2 <= self.reached_pa2);
            let at = next.saturating_sub(1);
            let (piece, step_pa) = (pieces[at], self.path.step_pa(at));
            let until_pa2 =
                pieces.get(next).map_or(variance_pa2, |next| next.from_variance_pa2.min(variance_pa2));
            self.append(piece, step_pa, until_pa2);
        }
    }

    /// Appends the next panel, which ends at `until_pa2` at the latest, of a piece that begins with a step of the hardness.
    fn append(&mut self, piece: Piece, step_pa: f64, until_pa2: f64) {
        let from_pa2 = self.reached_pa2;
        let place = |variance_pa2| Place { variance_pa2, hardness_pa: piece.hardness_pa(variance_pa2) };
        let distance = |variance_pa2| place(variance_pa2).distance(self.pressure_pa);
        let first_distance = distance(from_pa2);
        let kink_pa2 = piece.from_variance_pa2;
        let widest_pa = (from_pa2 - kink_pa2).sqrt() + WIDEST * from_pa2.sqrt();
        let mut to_pa2 = until_pa2.min(kink_pa2 + widest_pa * widest_pa);
        let smooth_pa2 = piece.smooth_up_to_pa2(from_pa2);
        if from_pa2 < smooth_pa2
            && smooth_pa2 < to_pa2
            && piece.hardness_pa(to_pa2) > MOST_GROWTH * piece.hardness_pa(smooth_pa2)
        {
            to_pa2 = smooth_pa2;
        }
        let mut steep = self.approaching && distance(to_pa2) <= first_distance;
        // A hardness that runs away from the stress takes the plastic area with it, as steeply as exp(-E).
        while !steep
            && distance(to_pa2).min(first_distance) < NEGLIGIBLE
            && (distance(to_pa2) - first_distance).abs() > 1.0
        {
            to_pa2 = from_pa2 + 0.5 * (to_pa2 - from_pa2);
            steep = self.approaching && distance(to_pa2) <= first_distance;
        }
        // Beyond a step, what was at the hardness reaches the new one as exp(-step^2/(2 (V - V_i))) does.
        if step_pa > 0.0 {
            let reached_pa = STEP_GROWTH * (from_pa2 - kink_pa2).sqrt().max(STEP_UNREACHED * step_pa);
            if reached_pa < STEP_OVER * step_pa {
                to_pa2 = to_pa2.min(kink_pa2 + reached_pa * reached_pa);
            }
        }
        // A hardness that grows over less than the rounding of V grows at once, over no panel.
        if to_pa2 - from_pa2 <= NARROWEST * from_pa2 {
            self.reached_pa2 = (from_pa2 * (1.0 + NARROWEST)).max(from_pa2.next_up()).min(until_pa2);
            return;
        }
        self.approaching = steep;
        if self.panels.is_empty() && first_distance > UNREACHED {
            (self.reached_pa2, self.approaching) = (to_pa2, true);
            return;
        }
        let last_distance = distance(to_pa2);
        let kink_distances_pa = [from_pa2, to_pa2].map(|variance_pa2| (variance_pa2 - kink_pa2).sqrt());
        let mut panel = Panel {
            from_pa2,
            to_pa2,
            piece,
            kink_distances_pa,
            steep,
            last_distance,
            size: SIZE,
            plastic: None,
            held: [0.0; SIZE],
        };
        let [first_pa, last_pa] = kink_distances_pa;
        let width = (last_pa - first_pa) / from_pa2.sqrt();
        panel.size = SIZE_MIN + WIDTHS.iter().filter(|widest| width > **widest).count();
        self.panels.push(panel);
        self.reached_pa2 = to_pa2;
        self.solve_last();
    }

    /// Solves for the polynomials of the last panel: collocates the integral equation at `SIZE` places.
    fn solve_last(&mut self) {
        let mut sources = std::mem::take(&mut self.sources);
        let Some(panel) = self.panels.last() else { return };
        let (mut matrix, mut to_held) = ([[0.0; SIZE]; SIZE], [[0.0; SIZE]; SIZE]);
        let (mut right, mut held) = ([0.0; SIZE], [0.0; SIZE]);
        let collocation = &self.rules.collocations[panel.size - SIZE_MIN];
        for (row, &t) in collocation.places.iter().take(panel.size).enumerate() {
            let variance_pa2 = panel.variance_pa2(t);
            let here = Place { variance_pa2, hardness_pa: panel.piece.hardness_pa(variance_pa2) };
            let relief = if panel.steep { here.distance(self.pressure_pa) } else { 0.0 };
            let [plastic, contact] = self.history(here, relief, &mut sources);
            let direct = image(here.hardness_pa, self.pressure_pa, variance_pa2.sqrt()) * relief.exp();
            right[row] = direct + plastic.known;
            held[row] = contact.known;
            matrix[row] =
                std::array::from_fn(|column| collocation.powers[row][column] - plastic.powers[column]);
            to_held[row] = contact.powers;
        }
        for row in panel.size..SIZE {
            (matrix[row], to_held[row]) = (collocation.powers[row], [0.0; SIZE]);
        }
        // The equation is of the second kind: its matrix is that of a polynomial through points, less something
        // small.
        let plastic = solve(matrix, right).unwrap_or_default();
        for (held, powers) in held.iter_mut().zip(to_held) {
            *held += powers.iter().zip(plastic).map(|(power, coefficient)| power * coefficient).sum::<f64>();
        }
        let held = solve(collocation.powers, held).unwrap_or_default();
        panel.append_sources(&plastic, &self.rules.finest, self.pressure_pa, &mut sources);
        self.sources = sources;
        if let Some(panel) = self.panels.last_mut() {
            panel.plastic = Some(plastic);
            panel.held = held;
        }
    }

    /// Integrates exp(relief) A_pl(V') kernel dV' over the panels, for the kernels of A_pl and of A.
    fn history(&self, here: Place, relief: f64, far: &mut Sources) -> [Integral; 2] {
        let mut integrals = [Integral::default(); 2];
        let (resolved_pa, scale) = (self.resolved_pa(here), relief.exp());
        // Panels that are seen by the same rule are summed together.
        let (mut run, mut of_run, mut sums) = (0..0, None, [0.0; 2]);
        let mut sum = |rule: Option<usize>, panels| {
            if let Some(rule) = rule {
                let [plastic, contact] = far.passages(rule, panels, here.variance_pa2, here.hardness_pa);
                sums = [sums[0] + plastic, sums[1] + contact];
            }
        };
        for (at, panel) in self.panels.iter().enumerate().rev() {
            let faded = panel.steep && panel.last_distance - relief > NEGLIGIBLE;
            if panel.plastic.is_some() && (faded || panel.to_pa2 < 1e-17 * here.variance_pa2) {
                break;
            }
            let rule = panel.rule_seen_from(here.variance_pa2);
            if rule != of_run {
                sum(of_run, run);
                (of_run, run) = (rule, at + 1..at + 1);
            }
            run.start = at;
            if rule.is_some() {
                continue;
            }
            let arc = panel.seen_from(here.variance_pa2);
            self.rules.over(&arc, resolved_pa, |root_pa, from_kink_pa, weight| {
                let variance_pa2 = panel.piece.from_variance_pa2 + from_kink_pa * from_kink_pa;
                let there = Place { variance_pa2, hardness_pa: panel.piece.hardness_pa(variance_pa2) };
                let weight = match panel.steep {
                    true => weight * (relief - there.distance(self.pressure_pa)).exp(),
                    false => weight * scale,
                };
                let t = panel.variable(from_kink_pa);
                let kernels =
                    [here.passage_to_the_hardness(there, root_pa), passage(there.hardness_pa, root_pa)];
                for (integral, kernel) in integrals.iter_mut().zip(kernels) {
                    match &panel.plastic {
                        Some(polynomial) => integral.known += weight * kernel * value(polynomial, t),
                        None => integral.add_powers(weight * kernel, t, panel.size),
                    }
                }
            });
        }
        sum(of_run, run);
        for (integral, far) in integrals.iter_mut().zip(sums) {
            integral.known += scale * far;
        }
        integrals
    }

    /// Root of V - V' below which every kernel and weight is smooth \[Pa\].
    fn resolved_pa(&self, here: Place) -> f64 {
        let steepness_pa = here.variance_pa2 / (here.hardness_pa - self.pressure_pa);
        0.25 * here.hardness_pa.min(steepness_pa)
    }
}

impl Panel {
    /// Maps a distance sqrt(V - V_i) from the start of the panel's piece of the path to \[-1, 1\]. A_pl responds to a
    /// kink of the hardness with the root of that distance.
    fn variable(&self, from_kink_pa: f64) -> f64 {
        let [first_pa, last_pa] = self.kink_distances_pa;
        2.0 * (from_kink_pa - first_pa) / (last_pa - first_pa) - 1.0
    }

    fn variance_pa2(&self, t: f64) -> f64 {
        let [first_pa, last_pa] = self.kink_distances_pa;
        if t == 1.0 {
            return self.to_pa2;
        }
        self.piece.from_variance_pa2 + (first_pa + 0.5 * (1.0 + t) * (last_pa - first_pa)).powi(2)
    }

    /// Appends A_pl as few points, of a polynomial of it.
    fn append_sources(
        &self,
        plastic: &Polynomial,
        rule: &GaussLegendre,
        pressure_pa: f64,
        sources: &mut Sources,
    ) {
        let [first_pa, last_pa] = self.kink_distances_pa;
        let nodes = rule.over(first_pa, last_pa).map(|(from_kink_pa, weight_pa)| {
            let variance_pa2 = self.piece.from_variance_pa2 + from_kink_pa * from_kink_pa;
            let hardness_pa = self.piece.hardness_pa(variance_pa2);
            let place = Place { variance_pa2, hardness_pa };
            // Distances are at most a little above `UNREACHED`: their exponentials are doubles.
            let scale = if self.steep { (-place.distance(pressure_pa)).exp() } else { 1.0 };
            let plastic = scale * value(plastic, self.variable(from_kink_pa));
            Source { variance_pa2, weight_pa2: 2.0 * from_kink_pa * weight_pa * plastic }
        });
        sources
            .append(nodes, [self.from_pa2, self.to_pa2], |variance_pa2| self.piece.hardness_pa(variance_pa2));
    }

    /// Returns the panel, or its part below, as seen from a variance.
    fn seen_from(&self, variance_pa2: f64) -> Arc {
        let to_pa2 = self.to_pa2.min(variance_pa2);
        Arc::new(self.piece.from_variance_pa2, [self.from_pa2, to_pa2], variance_pa2)
    }

    /// Returns the rule whose points stand for the panel at a variance above it; `None` if it is too near for any.
    fn rule_seen_from(&self, variance_pa2: f64) -> Option<usize> {
        self.plastic?;
        let width_pa2 = self.to_pa2 - self.from_pa2;
        rule_at((2.0 * variance_pa2 - self.from_pa2 - self.to_pa2) / width_pa2)
    }
}

/// Evaluates a polynomial at t.
fn value(polynomial: &Polynomial, t: f64) -> f64 {
    polynomial.iter().rev().fold(0.0, |sum, coefficient| sum * t + coefficient)
}

/// Integral over the panels: a number over those whose A_pl is known, and over the last one a coefficient for each
/// power of its variable.
#[derive(Default, Clone, Copy)]
struct Integral {
    known: f64,
    powers: Polynomial,
}

impl Integral {
    fn add_powers(&mut self, weight: f64, t: f64, size: usize) {
        let mut power = weight;
        for sum in &mut self.powers[..size] {
            *sum += power;
            power *= t;
        }
    }
}

impl Place {
    /// Distance E = (H - p)^2/(2V) of the hardness from the stress.
    fn distance(&self, pressure_pa: f64) -> f64 {
        let distance_pa = self.hardness_pa - pressure_pa;
        0.5 * distance_pa * distance_pa / self.variance_pa2
    }

    /// Kernel of A_pl times dV'/dx = 2x, x = sqrt(V - V'); that of A is the passage from H' to 0.
    fn passage_to_the_hardness(&self, there: Place, root_pa: f64) -> f64 {
        passage(self.hardness_pa + there.hardness_pa, root_pa)
            - passage(self.hardness_pa - there.hardness_pa, root_pa)
    }
}

/// Computes 2 x d g(d) = sqrt(2/pi) (d/x^2) exp(-d^2/(2x^2)).
fn passage(distance_pa: f64, root_pa: f64) -> f64 {
    let ratio = distance_pa / root_pa;
    (2.0 / PI).sqrt() * ratio / root_pa * (-0.5 * ratio * ratio).exp()
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
