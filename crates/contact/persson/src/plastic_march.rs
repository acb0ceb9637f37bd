//! Plastic area under a hardness that grows, as the solution of an integral equation along the variance.
//!
//! Continued by zero above the hardness, the mean excess C (see [`growing_hardness`](crate::growing_hardness)) is the elastic
//! solution less the contribution of sources of strength A_pl(V')/2 along the path sigma = H(V'). Its slope on that path is an
//! integral equation of the second kind for A_pl alone, and the area follows from A_pl by an integral of positive terms:
//!
//! A_pl(V) = D(V) + Int_0^V A_pl(V') [(H + H') g(H + H') - (H - H') g(H - H')] dV',
//! A(V) = erf(p/(sqrt2 s)) + Int_0^V A_pl(V') H' g(H') dV',
//!
//! with g(d) = exp(-d^2/(2 (V - V')))/(sqrt(2 pi) (V - V')^(3/2)), H' = H(V') and D = erfc((H - p)/(sqrt2 s)) -
//! erfc((H + p)/(sqrt2 s)). With a constant hardness its iterations are the images. Panels of V at a distance act like
//! a few points each. The equation may also begin at a later variance, where C is known: then D and the first part of A come from
//! its slope there, spread by the normal density of what the variance has grown by.

use std::sync::LazyLock;

use numerics::{GaussLegendre, solve};

use crate::areas::ContactAreas;
use crate::constant_hardness::image;
use crate::elastic;
use crate::hardness_path::{HardnessPath, NARROWEST, Piece};
use crate::near_panels::{NearPanel, Sight};
use crate::panel_rules::{Arc, Polynomial, Rules, SIZE, SIZE_MIN};
use crate::sources::{Source, Sources, rule_at};
use crate::stress_profile::StressProfile;

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
/// Width of the layer behind the end of a variance, over the unit of the panels, from which on the layer does not limit them; width
/// of the first panel over that of the layer, and growth of sqrt(V - V_i) over a later one.
const LAYER_OVER: f64 = 0.1;
const LAYER_FIRST: f64 = 0.5;
const LAYER_GROWTH: f64 = 2.0;
/// Growth of the hardness beyond the place up to which it is smooth that a panel may contain.
const MOST_GROWTH: f64 = 1.000_001;
/// Rise of the distance E from one panel to the next, relative to it, from which on the hardness has stepped.
const STEP_DISTANCE: f64 = 1e-5;
/// Distance E = (H - p)^2/(2V) above which the plastic share underflows a double.
const UNREACHED: f64 = 600.0;
/// Root of V - V', relative to the distance from the wall, below which the kernel vanishes.
const NEAR_WALL: f64 = 0.05;
/// Exponent beyond which exp(-x) is negligible beside 1.
const NEGLIGIBLE: f64 = 45.0;

/// Rules of all marches.
static RULES: LazyLock<Rules> = LazyLock::new(Rules::new);

/// Plastic area up to some variance, panel by panel.
pub(crate) struct PlasticMarch<'a> {
    path: &'a HardnessPath,
    pressure_pa: f64,
    /// Slope of the mean excess at the beginning; `None` if that is V = 0, where all stress is the pressure.
    start: Option<StressProfile>,
    rules: &'static Rules,
    panels: Vec<Panel>,
    /// End of the last panel \[Pa^2\].
    reached_pa2: f64,
    /// True as long as the distance E has only decreased.
    approaching: bool,
    /// A_pl of the panels as few points, for larger variances.
    sources: Sources,
    /// Work space.
    near: NearPanel,
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

/// Kink of the hardness with which a piece of the path begins.
struct Kink {
    /// Step of the hardness \[Pa\].
    step_pa: f64,
    /// Root of the variance \[Pa^2\] that was left before it; infinite unless the hardness grew towards the end of a variance.
    layer_pa: f64,
}

impl Kink {
    /// Creates the kink with which the piece at a place begins.
    fn new(path: &HardnessPath, at: usize) -> Self {
        let kink_pa2 = path.piece(at).from_variance_pa2;
        let before = at.checked_sub(1).map(|before| path.piece(before));
        let layer_pa = before.map_or(f64::INFINITY, |before| before.left_pa2(kink_pa2).max(0.0).sqrt());
        Kink { step_pa: path.step_pa(at), layer_pa }
    }
}

/// Variance and the hardness there.
#[derive(Clone, Copy)]
struct Place {
    variance_pa2: f64,
    hardness_pa: f64,
}

impl<'a> PlasticMarch<'a> {
    pub(crate) fn new(path: &'a HardnessPath, pressure_pa: f64) -> Self {
        let distance_pa = path.hardness_pa(0.0) - pressure_pa;
        let reached_pa2 = 0.5 * distance_pa * distance_pa / UNREACHED;
        PlasticMarch {
            path,
            pressure_pa,
            start: None,
            rules: &RULES,
            panels: Vec::new(),
            reached_pa2,
            approaching: true,
            sources: Sources::default(),
            near: NearPanel::default(),
        }
    }

    /// Creates a march that begins at the variance of a profile.
    pub(crate) fn from_profile(path: &'a HardnessPath, pressure_pa: f64, start: StressProfile) -> Self {
        let reached_pa2 = start.variance_pa2();
        PlasticMarch { start: Some(start), reached_pa2, approaching: false, ..Self::new(path, pressure_pa) }
    }

    /// Areas at a variance that has been reached.
    pub(crate) fn areas_at(&self, variance_pa2: f64) -> ContactAreas {
        let [elastic, gap] = self.elastic(variance_pa2);
        let at = self.panels.partition_point(|panel| panel.from_pa2 < variance_pa2);
        let panel = at.checked_sub(1).map(|at| &self.panels[at]);
        // Between two panels the hardness grows at once, any number of times over the last places of V.
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

    /// Shares in contact and of the gap at a variance if nothing flowed from the beginning on.
    fn elastic(&self, variance_pa2: f64) -> [f64; 2] {
        match &self.start {
            Some(start) => {
                let contact = start.contact(variance_pa2);
                [contact, 1.0 - contact]
            }
            None => {
                let spread_pa = variance_pa2.sqrt();
                [elastic::area_fraction, elastic::gap_fraction].map(|of| of(self.pressure_pa, spread_pa))
            }
        }
    }

    /// Part D of A_pl, from the stress at the beginning, times exp(relief).
    fn direct(&self, here: Place, relief: f64) -> f64 {
        match &self.start {
            Some(start) => start.plastic(here.hardness_pa, here.variance_pa2),
            None => image(here.hardness_pa, self.pressure_pa, here.variance_pa2.sqrt()) * relief.exp(),
        }
    }

    /// Unit \[Pa\] of the widths of panels.
    fn unit_pa(&self, from: Place) -> f64 {
        let spread_pa = from.variance_pa2.sqrt();
        if self.start.is_some() { spread_pa.min(from.hardness_pa) } else { spread_pa }
    }

    /// Appends the panels up to a variance, split where a piece of the path begins.
    pub(crate) fn extend_to(&mut self, variance_pa2: f64) {
        while self.reached_pa2 < variance_pa2 {
            let pieces = self.path.pieces();
            let next = pieces.partition_point(|piece| piece.from_variance_pa2 <= self.reached_pa2);
            let at = next.saturating_sub(1);
            let until_pa2 =
                pieces.get(next).map_or(variance_pa2, |next| next.from_variance_pa2.min(variance_pa2));
            self.append(pieces[at], Kink::new(self.path, at), until_pa2);
        }
    }

    /// Appends the next panel, which ends at `until_pa2` at the latest, of a piece that begins with a kink.
    fn append(&mut self, piece: Piece, Kink { step_pa, layer_pa }: Kink, until_pa2: f64) {
        let from_pa2 = self.reached_pa2;
        let place = |variance_pa2| Place { variance_pa2, hardness_pa: piece.hardness_pa(variance_pa2) };
        let distance = |variance_pa2| place(variance_pa2).distance(self.pressure_pa);
        let first_distance = distance(from_pa2);
        let kink_pa2 = piece.from_variance_pa2;
        let unit_pa = self.unit_pa(place(from_pa2));
        let widest_pa = (from_pa2 - kink_pa2).sqrt() + WIDEST * unit_pa;
        let mut to_pa2 = until_pa2.min(kink_pa2 + widest_pa * widest_pa);
        let smooth_pa2 = from_pa2 + 0.5 * piece.left_pa2(from_pa2);
        if from_pa2 < smooth_pa2
            && smooth_pa2 < to_pa2
            && piece.hardness_pa(to_pa2) > MOST_GROWTH * piece.hardness_pa(smooth_pa2)
        {
            to_pa2 = smooth_pa2;
        }
        // Behind a variance that has come to an end, the plastic area keeps traces of the growth there.
        let reached_pa = LAYER_GROWTH * (from_pa2 - kink_pa2).sqrt();
        let in_layer = layer_pa < LAYER_OVER * unit_pa && reached_pa < WIDEST * unit_pa;
        if in_layer {
            to_pa2 = to_pa2.min(kink_pa2 + reached_pa.max(LAYER_FIRST * layer_pa).powi(2));
        }
        // A step of the hardness leaves the stress behind.
        let last_distance = self.panels.last().map_or(f64::INFINITY, |panel| panel.last_distance);
        self.approaching &= first_distance <= last_distance * (1.0 + STEP_DISTANCE);
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
        // A hardness that grows over the last places of V grows at once, over no panel.
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
        let width = (last_pa - first_pa) / unit_pa;
        if !in_layer {
            panel.size = SIZE_MIN + WIDTHS.iter().filter(|widest| width > **widest).count();
        }
        self.panels.push(panel);
        self.reached_pa2 = to_pa2;
        self.solve_last();
    }

    /// Solves for the polynomials of the last panel: collocates the integral equation at `SIZE` places.
    fn solve_last(&mut self) {
        let (mut near, mut sources) = (std::mem::take(&mut self.near), std::mem::take(&mut self.sources));
        let Some((panel, before)) = self.panels.split_last() else { return };
        // Nothing sees the points of a panel before the next one is solved for.
        if let Some((before, plastic)) =
            before.last().and_then(|panel| Some((panel, panel.plastic.as_ref()?)))
        {
            before.append_sources(plastic, &self.rules.finest, self.pressure_pa, &mut sources);
        }
        let (mut matrix, mut to_held) = ([[0.0; SIZE]; SIZE], [[0.0; SIZE]; SIZE]);
        let (mut right, mut held) = ([0.0; SIZE], [0.0; SIZE]);
        let collocation = &self.rules.collocations[panel.size - SIZE_MIN];
        for (row, &t) in collocation.places.iter().take(panel.size).enumerate() {
            let variance_pa2 = panel.variance_pa2(t);
            let here = Place { variance_pa2, hardness_pa: panel.piece.hardness_pa(variance_pa2) };
            let relief = if panel.steep { here.distance(self.pressure_pa) } else { 0.0 };
            let [plastic, contact] =
                self.history(here, relief, self.resolved_pa(here), (&mut near, &mut sources));
            let direct = self.direct(here, relief);
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
        (self.near, self.sources) = (near, sources);
        if let Some(panel) = self.panels.last_mut() {
            panel.plastic = Some(plastic);
            panel.held = held;
        }
    }

    /// Slope -dC/dsigma of the mean excess at the variance reached, at a stress between the walls.
    pub(crate) fn fall_at(&mut self, stress_pa: f64) -> f64 {
        let wall =
            Place { variance_pa2: self.reached_pa2, hardness_pa: self.path.hardness_pa(self.reached_pa2) };
        let here = Place { hardness_pa: stress_pa, ..wall };
        // Sources beside the wall are as narrow as they are near.
        let resolved_pa = self.resolved_pa(wall).min(NEAR_WALL * (wall.hardness_pa - stress_pa));
        let (mut near, mut sources) = (std::mem::take(&mut self.near), std::mem::take(&mut self.sources));
        let [plastic, _] = self.history(here, 0.0, resolved_pa, (&mut near, &mut sources));
        (self.near, self.sources) = (near, sources);
        0.5 * (self.direct(here, 0.0) + plastic.known)
    }

    /// Integrates exp(relief) A_pl(V') kernel dV' over the panels, for the kernels of A_pl and of A.
    fn history(
        &self,
        here: Place,
        relief: f64,
        resolved_pa: f64,
        (near, far): (&mut NearPanel, &mut Sources),
    ) -> [Integral; 2] {
        let mut integrals = [Integral::default(); 2];
        let scale = relief.exp();
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
            near.clear();
            self.rules.split(&arc, resolved_pa, |rule, start, end| near.append(rule, start, end));
            near.weigh(&Sight {
                radius_pa: arc.radius_pa,
                piece: panel.piece,
                kink_distances_pa: panel.kink_distances_pa,
                hardness_pa: here.hardness_pa,
                steep_about_pa: panel.steep.then_some(self.pressure_pa),
                relief,
            });
            match &panel.plastic {
                Some(polynomial) => {
                    for (integral, known) in integrals.iter_mut().zip(near.integrals(polynomial)) {
                        integral.known += known;
                    }
                }
                None => {
                    for (integral, powers) in integrals.iter_mut().zip(near.integrals_of_powers(panel.size)) {
                        integral.powers = powers;
                    }
                }
            }
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

impl Place {
    /// Distance E = (H - p)^2/(2V) of the hardness from the stress.
    fn distance(&self, pressure_pa: f64) -> f64 {
        let distance_pa = self.hardness_pa - pressure_pa;
        0.5 * distance_pa * distance_pa / self.variance_pa2
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::constant_hardness;

    #[test]
    fn the_fall_of_the_mean_excess_is_the_share_above_a_stress() {
        // A hardness that hardly grows, whose density between the walls is known.
        let path = HardnessPath::with_squared_growth(1.0, 1e-12);
        let rule = GaussLegendre::new(30);
        for (pressure, variance) in [(0.001, 0.036), (0.3, 0.05), (0.9, 0.036), (0.97, 0.1)] {
            let spread = f64::sqrt(variance);
            let mut march = PlasticMarch::new(&path, pressure);
            march.extend_to(variance);
            let plastic = constant_hardness::areas(pressure, spread, 1.0).plastic;
            for stress in [0.0, 1e-4, 0.1, 0.35, 0.6, 0.8, 0.9, 0.99, 0.9999] {
                let ends = |part: i32| stress + (1.0 - stress) * f64::from(part) / 8.0;
                let nodes = (0..8).flat_map(|part| rule.over(ends(part), ends(part + 1)));
                let density = |at: f64| constant_hardness::stress_density_per_pa(at, pressure, spread, 1.0);
                let above = plastic + nodes.map(|(at, weight)| weight * density(at)).sum::<f64>();
                let fall = march.fall_at(stress);
                assert!((fall / above - 1.0).abs() < 1e-12, "{pressure} {variance} {stress}: {fall} {above}");
            }
        }
    }
}
