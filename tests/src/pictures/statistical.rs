//! Populations of asperities under the four laws.

use asperity::{Hardness, NixGao};
use stat_contact::{AsperityLaw, InterferenceLaw, Population, StatisticalContact};

use super::{Picture, STEEL, along, dashed, geometric, line, picture, steel};

const STRENGTH_PA: f64 = 1e9;
const HARDNESS_PA: f64 = 3.0 * STRENGTH_PA;
const SIGMA_S_M: f64 = 50e-9;
const TOLERANCE: f64 = 1e-10;
const POPULATION: &str = "R = 5 µm, η = 0.2 µm⁻², σ_s = 50 nm";

/// Contacts of the four laws, with the material and the population of these pictures.
fn contacts() -> [(&'static str, StatisticalContact); 4] {
    let strength = NixGao::constant(STRENGTH_PA).expect("a strength within its bounds");
    let interference = InterferenceLaw::default();
    let laws = [
        ("hertz", AsperityLaw::Hertz),
        ("ep-sphere", AsperityLaw::EpSphere { strength, hardness: Hardness::default(), held_from: None }),
        ("elastic-sine", AsperityLaw::ElasticSine { interference }),
        ("ep-sine", AsperityLaw::EpSine { strength }),
    ];
    let population = Population::new(5e-6, 0.2e12, SIGMA_S_M).expect("a population within its bounds");
    laws.map(|(name, law)| (name, StatisticalContact::new(&steel(), &population, &law)))
}

/// Pressure and area against separation.
pub(super) fn separation() -> Picture {
    let separations = geometric([0.1, 3.2], 41);
    let mut series = Vec::new();
    for (colour, (name, contact)) in contacts().into_iter().enumerate() {
        let state = |u: f64| contact.at_separation(u * SIGMA_S_M, TOLERANCE).expect("a finite separation");
        let area = along(&separations, |u| state(u).area_fraction);
        let pressure = along(&separations, |u| state(u).pressure_pa / HARDNESS_PA);
        series.push(dashed("area A/A_n", 0, line(name, colour, area)));
        series.push(dashed("pressure p/H", 1, line(name, colour, pressure)));
    }
    picture(
        "statistical-separation",
        ["Pressure and area against separation", &format!("{POPULATION}; {STEEL}, S_0 = 1 GPa")],
        ["separation from the mean asperity d/σ_s", "area / nominal area, pressure / H"],
        series,
    )
}

/// Area against load, and the line on which the real pressure is the hardness.
pub(super) fn load() -> Picture {
    let loads = geometric([1e-6, 1.0], 37);
    let mut series: Vec<_> = contacts()
        .into_iter()
        .enumerate()
        .map(|(colour, (name, contact))| {
            let area = |load: f64| {
                let state = contact.at_pressure(load * HARDNESS_PA, TOLERANCE, None);
                state.expect("a pressure within its bounds").area_fraction
            };
            line(name, colour, along(&loads, area))
        })
        .collect();
    series.push(dashed("A/A_n = p/H", 1, line("", 5, vec![(1e-6, 1e-6), (1.0, 1.0)])));
    picture(
        "statistical-load",
        ["Area against load under the four laws", &format!("{POPULATION}; {STEEL}, S_0 = 1 GPa")],
        ["nominal pressure p/H", "contact area / nominal area"],
        series,
    )
}
