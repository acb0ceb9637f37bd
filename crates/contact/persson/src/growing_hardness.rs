//! Elastic-plastic contact of a hardness that grows towards small scales: Persson (2006), Surf. Sci. Rep. 61:201.
//!
//! Plastic contact stays at the hardness H(V) of the scale and returns area to the elastic part as H grows; area and
//! force are conserved at every scale. The share f(sigma, V) of the nominal area whose stress exceeds sigma obeys a heat
//! equation, in which nothing passes either wall:
//!
//! f_V = f''/2,  f'(0) = 0,  f'(H) = -2 H'(V) f(H),  f(sigma, 0) = 1 below p and 0 above;  A = f(0),  A_pl = f(H).
//!
//! As long as the stress does not feel the hardness, it spreads freely, and f is known in closed form: from the beginning on, and
//! again from where the hardness steps or runs away from it. In between, a `StressProfile` follows it, in
//! elements and steps that are as small as their estimated errors ask. In the distance sqrt(V - V_i) from the last kink of
//! the hardness f is smooth.

use std::f64::consts::PI;
use std::sync::LazyLock;

use crate::areas::ContactAreas;
use crate::constant_hardness::image_from;
use crate::elastic;
use crate::hardness_path::{HardnessPath, Piece};
use crate::stress_profile::{Element, PLACES, Stage, StepWork, StressProfile};

static ELEMENT: LazyLock<Element> = LazyLock::new(Element::new);

/// Spreads above the largest stress beyond which a wall is not felt.
const REACH: f64 = 6.0;
/// Growth of the squared spread, up to the place where a wall is felt, that is not worth another look at its distance.
const FELT: f64 = 1.02;
/// Largest estimated error of a step over the share in contact.
const TOLERANCE: f64 = 2e-6;
/// Margin of the length of the next step, and its range over the last one: after a step that was refused, and after another.
const MARGIN: f64 = 0.85;
const SHORTER: [f64; 2] = [0.1, 0.8];
const LONGER: [f64; 2] = [0.3, 3.0];
/// Shortest step over sqrt(V - V_i): shorter ones are rounding.
const SHORTEST: f64 = 1e-12;
/// First step in V over the variance that has been added since the stress was free, and first step of sqrt(V - V_i) over the
/// hardness behind the first kink.
const FIRST_STEP: f64 = 0.3;
const FIRST_STEP_FROM_KINK: f64 = 0.1;
/// Steps that the stress has to be free for, to be followed as such.
const LONG_FLIGHT: f64 = 20.0;
/// Length of a stage in V/H^2 from which on nothing is left of what was before.
const LONGEST: f64 = 1e3;
/// Step of the hardness that counts, relative to it.
const STEP_MIN: f64 = 1e-6;
/// Interval of the variance, relative to it, over which a hardness grows at once: the rounding of variances is a part of it.
const AT_ONCE: f64 = 1e-12;

/// Returns the shares of the nominal area at each of some non-decreasing variances of the flattening pressure, under
/// a nominal pressure 0 < p < H(0) \[Pa\]. Shares are accurate to 1e-6 of the share in contact
/// while the variance is below some (1e4 H)^2; beyond, a hardness that grows within the last digits of the variance is not resolved.
#[must_use]
pub fn areas_along(path: &HardnessPath, pressure_pa: f64, variances_pa2: &[f64]) -> Vec<ContactAreas> {
    if path.is_constant() {
        let hardness_pa = path.hardness_pa(0.0);
        let areas = |variance_pa2: &f64| {
            crate::constant_hardness::areas(pressure_pa, variance_pa2.sqrt(), hardness_pa)
        };
        return variances_pa2.iter().map(areas).collect();
    }
    let mut march = StressMarch::new(pressure_pa);
    let mut areas = Vec::with_capacity(variances_pa2.len());
    let mut asked = variances_pa2.iter().peekable();
    let pieces = &path.pieces;
    for (at, piece) in pieces.iter().enumerate() {
        let next = pieces.get(at + 1);
        let end_pa2 = next.map_or(f64::INFINITY, |next| next.from_variance_pa2);
        while let Some(variance_pa2) = asked.next_if(|variance_pa2| **variance_pa2 <= end_pa2) {
            march.advance(piece, *variance_pa2);
            areas.push(march.areas(piece));
        }
        let Some(next) = next.filter(|_| asked.peek().is_some()) else { break };
        march.advance(piece, end_pa2);
        march.enter(piece, next);
    }
    areas
}

/// Stress along the variance, piece by piece of the path of the hardness.
struct StressMarch {
    pressure_pa: f64,
    stress: Stress,
    /// V - V_i \[Pa^2\] that has been reached on the piece.
    beyond_pa2: f64,
    /// Length of the next step \[Pa^2\].
    step_pa2: f64,
    /// First step of sqrt(V - V_i) over the hardness behind the last kink.
    step_from_kink: f64,
    work: StepWork,
}

/// Stress at one variance.
enum Stress {
    /// It does not feel the hardness.
    Free(FreeStress),
    /// It does.
    Walled(StressProfile),
}

/// Stress that spreads freely.
struct FreeStress {
    /// Start \[Pa^2\] of the piece of the path on which it begins to, and V - V_i \[Pa^2\] there.
    piece_pa2: f64,
    beyond_pa2: f64,
    /// Profile there; `None` at V = 0, where all stress is the pressure.
    profile: Option<StressProfile>,
    /// End of the profile \[Pa\], and the largest stress.
    end_pa: f64,
    largest_pa: f64,
}

impl StressMarch {
    fn new(pressure_pa: f64) -> Self {
        let start = FreeStress {
            piece_pa2: 0.0,
            beyond_pa2: 0.0,
            profile: None,
            end_pa: pressure_pa,
            largest_pa: pressure_pa,
        };
        StressMarch {
            pressure_pa,
            stress: Stress::Free(start),
            beyond_pa2: 0.0,
            step_pa2: 0.0,
            step_from_kink: FIRST_STEP_FROM_KINK,
            work: StepWork::default(),
        }
    }

    /// Begins a piece of the path, at the end of the one before.
    fn enter(&mut self, before: &Piece, piece: &Piece) {
        let reached_pa = before.hardness_beyond_pa(self.beyond_pa2);
        self.beyond_pa2 = 0.0;
        let at_once_pa2 = AT_ONCE * piece.from_variance_pa2;
        let rise_pa = |beyond_pa2: f64| piece.hardness_beyond_pa(beyond_pa2) - reached_pa;
        let is_at_once = rise_pa(at_once_pa2) > REACH * at_once_pa2.sqrt();
        let begin_pa2 = if is_at_once { at_once_pa2 } else { 0.0 };
        if let Stress::Walled(profile) = &mut self.stress
            && rise_pa(begin_pa2) > STEP_MIN * reached_pa
        {
            self.beyond_pa2 = begin_pa2;
            self.stress = Stress::Free(FreeStress {
                piece_pa2: piece.from_variance_pa2,
                beyond_pa2: 0.0,
                profile: Some(std::mem::take(profile)),
                end_pa: reached_pa,
                largest_pa: reached_pa,
            });
        }
    }

    /// Follows the stress to a variance \[Pa^2\] of a piece.
    fn advance(&mut self, piece: &Piece, to_pa2: f64) {
        let end_pa2 = to_pa2 - piece.from_variance_pa2;
        if end_pa2 - self.beyond_pa2 <= AT_ONCE * to_pa2 && matches!(self.stress, Stress::Walled(_)) {
            return;
        }
        while self.beyond_pa2 < end_pa2 {
            if let Stress::Free(free) = &self.stress {
                let (at_pa2, is_felt) = free.up_to_wall(piece, self.beyond_pa2, end_pa2);
                self.beyond_pa2 = at_pa2;
                if is_felt {
                    let spread_pa = free.spread_pa(piece, at_pa2);
                    self.step_pa2 = FIRST_STEP * spread_pa * spread_pa;
                    self.stress = Stress::Walled(free.profile(piece, at_pa2, self.pressure_pa));
                }
            } else {
                self.follow(piece, end_pa2);
            }
        }
    }

    /// Follows the profile to V - V_i \[Pa^2\] on a piece, or to where the hardness leaves it behind.
    fn follow(&mut self, piece: &Piece, end_pa2: f64) {
        let Stress::Walled(profile) = &mut self.stress else { return };
        let (mut reached_pa, end_pa) = (self.beyond_pa2.sqrt(), end_pa2.sqrt());
        let mut step_pa = (self.beyond_pa2 + self.step_pa2).sqrt() - reached_pa;
        let mut is_first = reached_pa == 0.0;
        if is_first {
            step_pa = step_pa.min(2.0 * self.step_from_kink * piece.hardness_beyond_pa(0.0));
        }
        while reached_pa < end_pa {
            let left_pa = end_pa - reached_pa;
            let is_last = left_pa <= 1.0001 * step_pa;
            let tried_pa = if is_last { left_pa } else { step_pa.min(0.5 * left_pa) };
            let stages = PLACES.map(|place| stage(piece, reached_pa + place * tried_pa, tried_pa));
            let error = profile.attempt(&ELEMENT, &mut self.work, stages);
            let ratio = MARGIN * (TOLERANCE / error.max(f64::MIN_POSITIVE)).powf(0.25);
            if error.is_nan() || error > TOLERANCE {
                step_pa = tried_pa * ratio.clamp(SHORTER[0], SHORTER[1]);
                if step_pa > SHORTEST * reached_pa {
                    continue;
                }
                // The variance of the piece comes to an end, and the hardness grows over the rest of it at once.
                let hardness_pa = piece.hardness_beyond_pa(self.beyond_pa2);
                let rise_pa = piece.hardness_beyond_pa(end_pa2) - hardness_pa;
                let spread_pa = (end_pa2 - self.beyond_pa2).max(0.0).sqrt();
                if rise_pa > (STEP_MIN * hardness_pa).max(REACH * spread_pa) {
                    self.stress = Stress::Free(FreeStress {
                        piece_pa2: piece.from_variance_pa2,
                        beyond_pa2: self.beyond_pa2,
                        profile: Some(std::mem::take(profile)),
                        end_pa: hardness_pa,
                        largest_pa: hardness_pa,
                    });
                }
                self.beyond_pa2 = end_pa2;
                return;
            }
            if profile.refine(&ELEMENT, &self.work, is_last) {
                continue;
            }
            if std::mem::take(&mut is_first) {
                self.step_from_kink = tried_pa * ratio.clamp(1.0, LONGER[1]) / piece.hardness_beyond_pa(0.0);
            }
            profile.accept(&ELEMENT, &mut self.work);
            reached_pa = if is_last { end_pa } else { reached_pa + tried_pa };
            self.beyond_pa2 = if is_last { end_pa2 } else { reached_pa * reached_pa };
            let next_pa = tried_pa * ratio.clamp(LONGER[0], LONGER[1]);
            step_pa = if is_last { step_pa.max(next_pa) } else { next_pa };
            self.step_pa2 = step_pa * (2.0 * reached_pa + step_pa);
            if let Some(unreached) = profile.unreached(&ELEMENT).filter(|_| !is_last) {
                let hardness_pa = piece.hardness_beyond_pa(self.beyond_pa2);
                let mut free = FreeStress {
                    piece_pa2: piece.from_variance_pa2,
                    beyond_pa2: self.beyond_pa2,
                    profile: None,
                    end_pa: hardness_pa,
                    largest_pa: (1.0 - unreached) * hardness_pa,
                };
                let (felt_pa2, _) = free.up_to_wall(piece, self.beyond_pa2, end_pa2);
                if felt_pa2 == end_pa2 || felt_pa2 - self.beyond_pa2 > LONG_FLIGHT * self.step_pa2 {
                    free.profile = Some(std::mem::take(profile));
                    self.stress = Stress::Free(free);
                    return;
                }
            }
        }
    }

    /// Areas at the variance that has been reached on a piece.
    fn areas(&self, piece: &Piece) -> ContactAreas {
        match &self.stress {
            Stress::Free(free) => free.areas(piece, self.beyond_pa2, self.pressure_pa),
            Stress::Walled(profile) => {
                let least = self.pressure_pa / piece.hardness_beyond_pa(self.beyond_pa2);
                let spread_pa = (piece.from_variance_pa2 + self.beyond_pa2).sqrt();
                // Without a hardness less touches.
                let elastic = elastic::area_fraction(self.pressure_pa, spread_pa);
                let contact = (least * profile.at_zero().max(1.0)).max(elastic).min(1.0);
                let plastic = least * profile.at_hardness().clamp(0.0, 1.0);
                ContactAreas { elastic: contact - plastic, plastic, gap: 1.0 - contact }
            }
        }
    }
}

/// Stage of a step of sqrt(V - V_i) \[Pa\] at a place of a piece.
fn stage(piece: &Piece, from_kink_pa: f64, step_pa: f64) -> Stage {
    let from_kink_pa2 = from_kink_pa * from_kink_pa;
    let hardness_pa = piece.hardness_beyond_pa(from_kink_pa2);
    let length = 2.0 * from_kink_pa * step_pa / (hardness_pa * hardness_pa);
    Stage { length: length.min(LONGEST), growth: 0.5 * piece.growth_of_square(from_kink_pa2) }
}

impl FreeStress {
    /// V - V_i \[Pa^2\] of a piece at which it began.
    fn began_pa2(&self, piece: &Piece) -> f64 {
        (self.piece_pa2 - piece.from_variance_pa2) + self.beyond_pa2
    }

    /// Spread \[Pa\] that has been added at V - V_i \[Pa^2\] of a piece.
    fn spread_pa(&self, piece: &Piece, at_pa2: f64) -> f64 {
        (at_pa2 - self.began_pa2(piece)).max(0.0).sqrt()
    }

    /// Returns V - V_i \[Pa^2\] up to which the wall is not felt, from a place of a piece on, and true if it is felt before the end.
    fn up_to_wall(&self, piece: &Piece, mut at_pa2: f64, end_pa2: f64) -> (f64, bool) {
        let began_pa2 = self.began_pa2(piece);
        // The hardness only grows: what it leaves free now is free for good.
        loop {
            let reach_pa = (piece.hardness_beyond_pa(at_pa2) - self.largest_pa) / REACH;
            let next_pa2 = began_pa2 + reach_pa * reach_pa;
            if next_pa2 >= end_pa2 {
                return (end_pa2, false);
            }
            if next_pa2 <= at_pa2 || next_pa2 - began_pa2 <= FELT * (at_pa2 - began_pa2) {
                return (at_pa2, true);
            }
            at_pa2 = next_pa2;
        }
    }

    /// Share above a stress, by its distance \[Pa\] from the end of the profile, after a spread > 0 \[Pa\].
    fn above(&self, from_end_pa: f64, spread_pa: f64, pressure_pa: f64) -> f64 {
        match &self.profile {
            None => 0.5 * image_from([from_end_pa, from_end_pa + pressure_pa], pressure_pa, spread_pa),
            Some(profile) => {
                let [place, spread] = [-from_end_pa, spread_pa].map(|stress_pa| stress_pa / self.end_pa);
                pressure_pa / self.end_pa * profile.spread(&ELEMENT, place, spread)
            }
        }
    }

    /// Returns the profile between the walls at V - V_i \[Pa^2\] of a piece.
    fn profile(&self, piece: &Piece, at_pa2: f64, pressure_pa: f64) -> StressProfile {
        let (hardness_pa, spread_pa) = (piece.hardness_beyond_pa(at_pa2), self.spread_pa(piece, at_pa2));
        let beyond_end_pa = hardness_pa - self.end_pa;
        StressProfile::through(&ELEMENT, |x| {
            self.above(beyond_end_pa - hardness_pa * x, spread_pa, pressure_pa)
        })
    }

    fn areas(&self, piece: &Piece, at_pa2: f64, pressure_pa: f64) -> ContactAreas {
        let spread_pa = self.spread_pa(piece, at_pa2);
        let whole_pa = (piece.from_variance_pa2 + at_pa2).sqrt();
        let elastic = elastic::area_fraction(pressure_pa, whole_pa);
        let (contact, gap) = match &self.profile {
            None => (elastic, elastic::gap_fraction(pressure_pa, whole_pa)),
            Some(profile) => {
                let contact = match spread_pa {
                    0.0 => pressure_pa / self.end_pa * profile.at_zero(),
                    _ => self.above(-self.end_pa, spread_pa, pressure_pa),
                };
                let contact = contact.max(elastic).min(1.0);
                (contact, 1.0 - contact)
            }
        };
        // The wall mirrors what hardly reaches it.
        let beyond_end_pa = piece.hardness_beyond_pa(at_pa2) - self.end_pa;
        let plastic = match spread_pa {
            0.0 => 0.0,
            _ => (2.0 * self.above(beyond_end_pa, spread_pa, pressure_pa)).clamp(0.0, contact),
        };
        ContactAreas { elastic: contact - plastic, plastic, gap }
    }
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
            assert!((areas.contact() / alone.contact() - 1.0).abs() < 1e-6, "{at}");
            assert!((areas.plastic - alone.plastic).abs() <= 1e-6 * alone.contact(), "{at}");
        }
    }

    #[test]
    fn growth_that_ends_leaves_the_law_of_constant_hardness_to_take_over() {
        // Grows to sqrt(3) at V = 1 and is constant beyond: at late times A = p/H.
        let path = HardnessPath::with_squared_growth(1.0, 2.0).capped(3f64.sqrt());
        let areas = areas_along(&path, 0.1, &[0.5, 1.0, 40.0]);
        let growing = areas_of_squared_growth(0.1, 0.5f64.sqrt(), 1.0, 2.0);
        assert!((areas[0].contact() / growing.contact() - 1.0).abs() < 1e-6, "{areas:?} {growing:?}");
        assert!((areas[2].contact() / (0.1 / 3f64.sqrt()) - 1.0).abs() < 1e-6, "{:?}", areas[2]);
        assert!(areas[2].elastic < 1e-7 && areas[1].elastic > 1e-3, "{areas:?}");
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
        assert!((before.contact() / after.contact() - 1.0).abs() < 1e-6, "{before:?} {after:?}");
        assert!((before.plastic / after.plastic - 1.0).abs() < 1e-6);
    }

    /// Asserts that shares agree to 1e-6 of the contact with an integral equation for the plastic share along the variance, which
    /// is accurate to 1e-9 (removed at this commit: `plastic_march.rs`).
    fn assert_agrees(path: &HardnessPath, pressure: f64, variance: f64, [contact, plastic]: [f64; 2]) {
        let found = areas_along(path, pressure, &[variance])[0];
        let off = [found.contact() - contact, found.plastic - plastic].map(|off| off.abs() / contact);
        assert!(off.iter().all(|off| *off < 1e-6), "{pressure} {variance}: {off:?}");
    }

    #[test]
    fn areas_beside_a_kink_agree_with_an_integral_equation() {
        // The growth of the squared hardness ends at V = 0.5.
        for (growth, pressure, width, contact, plastic) in [
            (1.0f64, 0.3, 0.003, 0.333_981_660_429, 0.137_159_809_620),
            (1.0, 0.001, 0.03, 0.001_140_310_724, 0.000_445_567_292),
            (12.0, 0.3, 0.01, 0.328_412_606_882, 0.000_541_777_127),
            (12.0, 0.001, 0.1, 0.001_056_826_398, 0.000_004_285_060),
            (4.0, 0.9, 0.02, 0.813_778_620_069, 0.144_558_664_978),
            (4.0, 0.9, 0.3, 0.716_676_544_296, 0.313_404_545_222),
        ] {
            let hardness = (1.0 + 0.5 * growth).sqrt();
            let path = HardnessPath::with_squared_growth(1.0, growth).capped(hardness);
            assert_agrees(&path, pressure, 0.5 + (width * hardness).powi(2), [contact, plastic]);
        }
    }

    #[test]
    fn areas_beyond_a_step_agree_with_an_integral_equation() {
        for (to, pressure, beyond, contact, plastic) in [
            (1.02, 0.3, 1e-4, 0.497_702_441_248, 0.005_182_277_149),
            (1.1, 0.01, 0.002, 0.017_753_016_311, 0.000_074_596_846),
            (1.1, 0.9, 0.1, 0.943_086_489_911, 0.638_240_875_870),
            (1.5, 0.3, 0.02, 0.477_857_393_567, 0.000_047_138_198),
            (2.0, 0.3, 2.0, 0.169_635_020_051, 0.130_374_908_630),
        ] {
            let knot = |wavevector_rad_per_m, variance_pa2, hardness_pa| HardnessKnot {
                wavevector_rad_per_m,
                variance_pa2,
                hardness_pa,
                variance_exponent: 0.4,
            };
            let knots = [knot(1.0, 0.0, 1.0), knot(2.0, 0.2, 1.0), knot(2.5, 0.2, to), knot(4.0, 5.0, to)];
            assert_agrees(&HardnessPath::through(&knots), pressure, 0.2 + beyond, [contact, plastic]);
        }
    }
}
