//! One sphere: Hertz, Jackson & Green.

use asperity::{Hardness, Hertz, JacksonGreen};

use super::{Picture, STEEL, along, body, dashed, geometric, line, picture, steel, with_breaks};

const RADIUS_M: f64 = 1e-6;

/// Force and area against interference, over their values at first yield.
pub(super) fn force_and_area() -> Picture {
    let pair = steel();
    let hertz = Hertz::new(&pair, RADIUS_M);
    let green = |hardness| JacksonGreen::new(&pair, RADIUS_M, 1e9, hardness);
    let [published, cosine] = [Hardness::JacksonGreen2005, Hardness::Cosine].map(green);
    let first_yield_m = published.critical_interference_m();
    let over_first_yield = |law: &dyn Fn(f64) -> f64| {
        let breaks = published.breaks().map(|b| asperity::Break { at: b.at / first_yield_m, ..b });
        let ratios = with_breaks(geometric([1.0, 1e5], 61), breaks);
        along(&ratios, |ratio| law(ratio * first_yield_m) / law(first_yield_m))
    };
    let force = |law: &dyn Fn(f64) -> f64| line("force F/P_c", 1, over_first_yield(law));
    let area = |law: &dyn Fn(f64) -> f64| line("area A/A_c", 0, over_first_yield(law));
    picture(
        "sphere-force-and-area",
        ["A sphere pressed by a flat", &format!("{STEEL}, S_y = 1 GPa")],
        ["interference w/w_c", "force and area over first yield"],
        vec![
            dashed("Hertz", 0, force(&|w| hertz.force_n(w))),
            dashed("Hertz", 0, area(&|w| hertz.area_m2(w))),
            dashed("Jackson & Green", 1, force(&|w| published.force_n(w))),
            dashed("Jackson & Green", 1, area(&|w| published.area_m2(w))),
            dashed("cosine form of the hardness", 3, force(&|w| cosine.force_n(w))),
        ],
    )
}

/// The mean pressure over the strength: the jump of the force, and the two forms of the hardness.
pub(super) fn mean_pressure() -> Picture {
    let mut series = Vec::new();
    for (dash, hardness, name) in
        [(0, Hardness::JacksonGreen2005, "Jackson & Green 2005"), (1, Hardness::Cosine, "cosine form")]
    {
        for (colour, poisson_ratio) in [0.0, 0.3, 0.5].into_iter().enumerate() {
            let pair = body(210e9, poisson_ratio);
            let law = JacksonGreen::new(&pair, RADIUS_M, 1e9, hardness);
            let first_yield_m = law.critical_interference_m();
            let breaks = law.breaks().map(|b| asperity::Break { at: b.at / first_yield_m, ..b });
            let ratios = with_breaks(geometric([1.5, 1000.0], 61), breaks);
            let pressure = |ratio: f64| {
                let interference_m = ratio * first_yield_m;
                law.force_n(interference_m) / law.area_m2(interference_m) / 1e9
            };
            let condition = format!("ν = {poisson_ratio}");
            series.push(dashed(name, dash, line(&condition, colour, along(&ratios, pressure))));
        }
    }
    picture(
        "sphere-mean-pressure",
        ["Mean pressure on a yielding sphere", "E = 210 GPa, S_y = 1 GPa, rigid counterface"],
        ["interference w/w_c", "mean pressure / yield strength"],
        series,
    )
}
