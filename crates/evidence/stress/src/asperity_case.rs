//! Single asperities: their numbers, and the promises of their laws.

use std::f64::consts::PI;

use asperity::{
    BemSinusoid, Bound, Break, ElasticPlasticSinusoid, ElasticSinusoid, Hardness, Hertz, JacksonGreen,
    MaterialPair,
};

use crate::tally::{Case, Refused, Trial};
use crate::{Draw, Material, Reach};

/// Relative rounding of a law.
const ROUNDING: f64 = 1e-13;

/// Asperity of a material under a load; printed, it is a literal that recreates it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AsperityCase {
    /// Bodies in contact.
    pub material: Material,
    /// Hardness form of spheres.
    pub hardness: Hardness,
    /// Radius R \[m\].
    pub radius_m: f64,
    /// Aspect ratio B of sinusoids.
    pub aspect_ratio: f64,
    /// Interference of spheres over R, of sinusoids over their amplitude, and pressure over that of complete contact.
    pub load: f64,
}

impl Case for AsperityCase {
    fn draw(draw: &mut Draw) -> (Self, Reach) {
        let reach = Reach::draw(draw);
        let [radius, ratio] = match reach {
            Reach::Usual => [(-9.0, -3.0), (-5.0, 0.0)],
            _ => [(-15.0, 3.0), (-20.0, 20.0)],
        };
        let radius_m = reach.number(draw, radius.0, radius.1);
        let aspect_ratio = reach.number(draw, ratio.0, ratio.1);
        let gradient = draw.chance(0.3);
        let material = Material::draw(draw, reach, gradient, radius_m);
        let [light, heavy] = [draw.decades(-18.0, 0.0), draw.decades(0.0, 6.0)];
        let middle = draw.between(0.0, 1.2).max(f64::MIN_POSITIVE);
        let at_a_break = draw.one_of(&[0.8, 1.0, 1e-4, 0.99]);
        let load = match draw.between(0.0, 1.0) {
            share if share < 0.05 => draw.near(at_a_break),
            share if share < 0.08 && reach == Reach::Edge => draw.edge(),
            _ => draw.one_of(&[light, light, middle, heavy]),
        };
        let hardness = draw.one_of(Hardness::ALL);
        (AsperityCase { material, hardness, radius_m, aspect_ratio, load }, reach)
    }

    /// Tests every law at its load, and at every break that it announces, on it and beside it.
    fn test(trial: &mut Trial<Self>) -> Result<(), Refused> {
        let case = trial.case;
        let (pair, strength) = (case.material.pair()?, case.material.strength()?);
        // Plain numbers that the laws take unchecked are checked where populations are made.
        if ![case.radius_m, case.aspect_ratio].into_iter().all(|number| Bound::Magnitude.admits(number)) {
            return Err(Refused);
        }
        let strength_pa = strength.at_depth_pa(case.load * case.radius_m);
        let soft_pa = strength.macroscopic_strength_pa();
        trial.hold("Nix-Gao: no NaN, at least S0", strength_pa >= soft_pa * (1.0 - f64::EPSILON));
        spheres(&pair, soft_pa, trial);
        elastic(&pair, trial);
        boundary_elements(&pair, trial);
        elastic_plastic(&pair, soft_pa, trial);
        Ok(())
    }
}

fn spheres(pair: &MaterialPair, strength_pa: f64, trial: &mut Trial<AsperityCase>) {
    let case = trial.case;
    let hertz = Hertz::new(pair, case.radius_m);
    let sphere = JacksonGreen::new(pair, case.radius_m, strength_pa, case.hardness);
    let breaks: Vec<Break> = sphere.breaks().collect();
    trial.hold("sphere: breaks rise", breaks.is_sorted_by(|a, b| a.at <= b.at));
    let mut interferences_m = vec![case.load * case.radius_m];
    interferences_m.extend(breaks.iter().flat_map(|b| [b.at.next_down(), b.at, b.at.next_up()]));
    let cross_section_m2 = PI * case.radius_m * case.radius_m;
    for w_m in interferences_m.into_iter().filter(|w_m| *w_m > 0.0 && Bound::Signed.admits(*w_m)) {
        let [force_n, area_m2] = [sphere.force_n(w_m), sphere.area_m2(w_m)];
        let both = sphere.force_and_area(w_m);
        let elastic = [hertz.force_n(w_m), hertz.area_m2(w_m)];
        let numbers = [force_n, area_m2, both.0, both.1, elastic[0], elastic[1]];
        trial.hold("sphere: no NaN, at least 0", numbers.iter().all(|number| *number >= 0.0));
        trial.hold("sphere: area within the cross-section", area_m2 <= cross_section_m2);
        if trial.reach == Reach::Edge {
            continue;
        }
        trial.hold("sphere: finite", numbers.iter().all(|number| number.is_finite()));
        trial.bound("sphere: force alone and with area", (both.0 - force_n).abs(), ROUNDING * force_n);
        trial.bound("sphere: area alone and with force", (both.1 - area_m2).abs(), ROUNDING * area_m2);
        if w_m < sphere.plastic_onset_m() {
            trial.hold("sphere: Hertz's below the onset", force_n == elastic[0]);
        }
        let beyond_m = w_m * (1.0 + 1e-3);
        trial.bound("sphere: area rises", area_m2 - sphere.area_m2(beyond_m), ROUNDING * area_m2);
    }
}

fn elastic(pair: &MaterialPair, trial: &mut Trial<AsperityCase>) {
    let case = trial.case;
    let law = ElasticSinusoid::new(pair, case.aspect_ratio);
    let full_pa = law.complete_contact_pressure_pa();
    for p_pa in pressures_pa(case.load * full_pa, law.breaks()) {
        let state = [
            law.area_fraction(p_pa),
            law.mean_gap_over_amplitude(p_pa),
            law.deformation_over_amplitude(p_pa),
        ];
        let promises = ["elastic sinusoid: area in [0, 1]", "elastic sinusoid: gap and deformation make one"];
        sinusoid(promises, state, 0.0, trial);
        if trial.reach != Reach::Edge {
            let back_pa = law.pressure_at_interference_pa(state[2]);
            inverse("elastic sinusoid: p -> h -> p", p_pa.min(full_pa), back_pa, state[2], trial);
        }
    }
    interference("elastic sinusoid: p(w) in [0, p*]", full_pa, |w| law.pressure_at_interference_pa(w), trial);
}

fn boundary_elements(pair: &MaterialPair, trial: &mut Trial<AsperityCase>) {
    let case = trial.case;
    let law = BemSinusoid::new(pair, case.aspect_ratio);
    let full_pa = law.complete_contact_pressure_pa();
    for p_pa in pressures_pa(case.load * full_pa, law.breaks()) {
        let deformation = law.deformation_over_amplitude(p_pa);
        let state = [law.area_fraction(p_pa), 1.0 - deformation, deformation];
        let promises = ["bem sinusoid: area in [0, 1]", "bem sinusoid: gap and deformation make one"];
        sinusoid(promises, state, 0.0, trial);
        if trial.reach != Reach::Edge {
            let back_pa = law.pressure_at_interference_pa(deformation);
            inverse("bem sinusoid: p -> h -> p", p_pa.min(full_pa), back_pa, deformation, trial);
        }
    }
    interference("bem sinusoid: p(w) in [0, p*]", full_pa, |w| law.pressure_at_interference_pa(w), trial);
}

fn elastic_plastic(pair: &MaterialPair, strength_pa: f64, trial: &mut Trial<AsperityCase>) {
    let case = trial.case;
    let law = ElasticPlasticSinusoid::new(pair, case.aspect_ratio, strength_pa);
    let full_pa = law.complete_contact_pressure_pa();
    let flattening_pa = law.flattening_pressure_pa();
    trial.hold("ep-sinusoid: flat in [0, p*_ep]", (0.0..=full_pa).contains(&flattening_pa));
    let breaks = law.breaks().chain(law.deformation_breaks());
    for p_pa in pressures_pa(case.load * full_pa, breaks) {
        let area = law.area_fraction(p_pa);
        let state = [area, law.mean_gap_over_amplitude(p_pa), law.deformation_over_amplitude(p_pa)];
        // The exponent of the mean gap grows like r^0.44/15: for r beyond some thirty decades, the last place of p
        // decides between open and closed. The branches on either side of the critical pressure are different laws.
        let steps = [p_pa.next_down(), p_pa.next_up()]
            .into_iter()
            .filter(|beside_pa| law.yields_at(*beside_pa) == law.yields_at(p_pa))
            .map(|beside_pa| (law.deformation_over_amplitude(beside_pa) - state[2]).abs());
        let last_place = steps.fold(0.0, f64::max);
        let promises = ["ep-sinusoid: area in [0, 1]", "ep-sinusoid: gap and deformation make one"];
        sinusoid(promises, state, 2.0 * last_place, trial);
        if trial.reach == Reach::Edge {
            continue;
        }
        // A scale never pushes the pressure above its own complete contact.
        trial.bound("ep-sinusoid: p/phi within p*_ep", (p_pa / full_pa).min(1.0), area * (1.0 + 1e-12));
        if p_pa > flattening_pa * (1.0 + 1e-9) {
            trial.bound("ep-sinusoid: complete from flattening on", 1.0 - area, 1e-9);
        }
    }
    if law.aspect_ratio_over_critical().is_finite() {
        interference(
            "ep-sinusoid: p(w) in [0, p*_ep]",
            full_pa,
            |w| law.pressure_at_interference_pa(w),
            trial,
        );
        let (p_pa, area) = law.pressure_and_area_at_interference(case.load);
        let alone_pa = law.pressure_at_interference_pa(case.load);
        trial.bound("ep-sinusoid: p(w) alone and with area", (p_pa - alone_pa).abs(), ROUNDING * alone_pa);
        trial.hold("ep-sinusoid: A(w) in [0, 1]", (0.0..=1.0).contains(&area));
    }
}

/// The pressure and the breaks, on them and on either side.
fn pressures_pa(pressure_pa: f64, breaks: impl Iterator<Item = Break>) -> Vec<f64> {
    let mut pressures_pa = vec![pressure_pa];
    pressures_pa.extend(breaks.flat_map(|b| [b.at.next_down(), b.at, b.at.next_up()]));
    pressures_pa.retain(|p_pa| *p_pa > 0.0 && p_pa.is_finite());
    pressures_pa
}

/// Checks area fraction, mean gap and deformation over the amplitude; `last_places` is the change of the deformation
/// by the last places of the pressure.
fn sinusoid(
    promises: [&'static str; 2],
    [area, gap, deformation]: [f64; 3],
    last_places: f64,
    trial: &mut Trial<AsperityCase>,
) {
    trial.hold(promises[0], (0.0..=1.0).contains(&area));
    trial.bound(promises[1], (gap + deformation - 1.0).abs(), 4.0 * f64::EPSILON + last_places);
}

/// Towards complete contact the gap g goes like (1-x)^(5/2), so that a unit in its last place changes x by more.
fn inverse(promise: &'static str, there: f64, back: f64, deformation: f64, trial: &mut Trial<AsperityCase>) {
    let gap = 1.0 - deformation;
    let lost = if gap > 0.0 { f64::EPSILON / gap } else { 1.0 };
    let unresolved = if gap < 1e-12 { 1e-4 } else { 0.0 };
    trial.bound(promise, (back - there).abs(), (1e-10 + 4.0 * lost.min(1.0) + unresolved) * there);
}

/// The pressure at an interference over amplitude rises, up to that of complete contact.
fn interference(
    promise: &'static str,
    full_pa: f64,
    pressure_at: impl Fn(f64) -> f64,
    trial: &mut Trial<AsperityCase>,
) {
    let w = trial.case.load;
    let [here_pa, beyond_pa] = [pressure_at(w), pressure_at(w * (1.0 + 1e-3))];
    let rises = here_pa <= beyond_pa * (1.0 + ROUNDING);
    trial.hold(promise, (0.0..=full_pa * (1.0 + ROUNDING)).contains(&here_pa) && rises);
}
