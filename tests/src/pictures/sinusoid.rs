//! One sinusoid: elastic, elastic-plastic, by boundary elements.

use std::f64::consts::PI;

use asperity::{BemSinusoid, Break, ElasticPlasticSinusoid, ElasticSinusoid};

use super::{Picture, STEEL, along, dashed, geometric, line, picture, steel, with_breaks};

const PRESSURE: &str = "mean pressure p/p*";
const STRENGTH_PA: f64 = 1e9;
/// Aspect ratios over the critical one.
const RATIOS: [f64; 4] = [2.0, 10.0, 37.0, 100.0];

fn at_ratio(ratio: f64) -> ElasticPlasticSinusoid {
    let critical = ElasticPlasticSinusoid::new(&steel(), 1.0, STRENGTH_PA).critical_aspect_ratio();
    ElasticPlasticSinusoid::new(&steel(), ratio * critical, STRENGTH_PA)
}

/// The breaks of a law, its pressures over p*.
fn over(complete_pa: f64, breaks: impl Iterator<Item = Break>) -> impl Iterator<Item = Break> {
    breaks.map(move |b| Break { at: b.at / complete_pa, ..b })
}

/// The joined law, its two limits, and the boundary-element solutions.
pub(super) fn elastic_area() -> Picture {
    let (law, solved) = (ElasticSinusoid::new(&steel(), 0.01), BemSinusoid::new(&steel(), 0.01));
    let complete_pa = law.complete_contact_pressure_pa();
    let shares = with_breaks(geometric([1e-4, 1.0], 61), over(complete_pa, law.breaks()));
    let mut series = vec![
        line("joined law", 0, along(&shares, |x| law.area_fraction(x * complete_pa))),
        line("light load (Hertz)", 1, along(&[1e-4, 1.0], |x| PI * (3.0 * x / (8.0 * PI)).cbrt().powi(2))),
        line(
            "near full contact",
            2,
            along(&geometric([1e-4, 1.0], 41), |x| 1.0 - 3.0 / (2.0 * PI) * (1.0 - x)),
        ),
    ];
    let solutions = solved.breaks().filter(|b| b.what.contains("table")).map(|b| b.at);
    series.extend(solutions.map(|pressure_pa| {
        let point = (pressure_pa / complete_pa, solved.area_fraction(pressure_pa));
        line("boundary elements", 5, vec![point])
    }));
    picture(
        "elastic-sinusoid",
        ["Contact area of an elastic sinusoid", "any material, any aspect ratio"],
        [PRESSURE, "contact area / nominal area"],
        series,
    )
}

/// The area of a yielding sinusoid for several aspect ratios.
pub(super) fn plastic_area() -> Picture {
    let elastic = at_ratio(1.0);
    let complete_pa = elastic.complete_contact_pressure_pa();
    let shares = geometric([1e-4, 1.0], 61);
    let elastic = with_breaks(shares.clone(), over(complete_pa, elastic.breaks()));
    let mut series =
        vec![line("r ≤ 1: elastic", 5, along(&elastic, |x| at_ratio(1.0).area_fraction(x * complete_pa)))];
    for (colour, ratio) in RATIOS.into_iter().enumerate() {
        let law = at_ratio(ratio);
        let complete_pa = law.elastic().complete_contact_pressure_pa();
        let shares = with_breaks(shares.clone(), over(complete_pa, law.breaks()));
        let points = along(&shares, |x| law.area_fraction(x * complete_pa));
        series.push(line(&format!("r = {ratio}"), colour, points));
    }
    picture(
        "plastic-sinusoid",
        ["Contact area of a yielding sinusoid, r = B/B_c", &format!("{STEEL}, S_y = 1 GPa")],
        [PRESSURE, "contact area / nominal area"],
        series,
    )
}

/// Approach of the flat, for several aspect ratios, and by boundary elements.
pub(super) fn deformation() -> Picture {
    let shares = geometric([1e-5, 1.0], 61);
    let (law, solved) = (ElasticSinusoid::new(&steel(), 0.01), BemSinusoid::new(&steel(), 0.01));
    let complete_pa = law.complete_contact_pressure_pa();
    let mut series = vec![
        dashed(
            "Rostami & Jackson",
            0,
            line("r ≤ 1: elastic", 5, along(&shares, |x| law.deformation_over_amplitude(x * complete_pa))),
        ),
        dashed(
            "boundary elements",
            1,
            line("r ≤ 1: elastic", 5, along(&shares, |x| solved.deformation_over_amplitude(x * complete_pa))),
        ),
    ];
    for (colour, ratio) in RATIOS.into_iter().enumerate() {
        let law = at_ratio(ratio);
        let complete_pa = law.elastic().complete_contact_pressure_pa();
        let shares = with_breaks(shares.clone(), over(complete_pa, law.deformation_breaks()));
        let points = along(&shares, |x| law.deformation_over_amplitude(x * complete_pa));
        series.push(dashed("Rostami & Jackson", 0, line(&format!("r = {ratio}"), colour, points)));
    }
    picture(
        "sinusoid-deformation",
        ["Deformation of a sinusoid, r = B/B_c", &format!("{STEEL}, S_y = 1 GPa")],
        [PRESSURE, "deformation h_p/Δ = 1 − mean gap/Δ"],
        series,
    )
}
