//! Scenes of every kind, drawn by number, and their answers.

use std::collections::BTreeMap;

use conclusions::{Conclusions, Evidence};
use findings::answer::SceneAnswer;
use judge::{JudgePlan, Judgement};
use scene::{Overrides, Scene};
use study::Unobserved;
use study::plan::Results;
use uncertainty::{Uncertainty, UncertaintyPlan};

/// Spectra without errors, with them, with a hole of 1.3 decades, with too few scales; and roughness parameters.
const SURFACES: [&str; 6] = [
    "surface = { psd = \"plain.csv\" }",
    "surface = { psd = \"errors.csv\" }",
    "surface = { psd = \"hole.csv\" }",
    "surface = { psd = \"short.csv\" }",
    "surface = { psd = \"power.csv\" }",
    "surface = { rms_height = \"0.3 um\", rms_slope = 0.035, hurst = 0.8, rolloff_wavelength = \"60 um\" }",
];

/// Bodies that never yield, yield at a constant hardness, or at one that grows; soft and hard, one against another.
const BODIES: [&str; 7] = [
    "material = { youngs_modulus = \"200 GPa\", poisson_ratio = 0.3 }",
    "material = { name = \"100Cr6\" }\ncounterface = { name = \"100Cr6\" }",
    "material = { name = \"diamond\", yield_strength = \"1.8 GPa\", strain_gradient_length = \"5 um\" }",
    "material = { youngs_modulus = \"5 MPa +- 10 %\", poisson_ratio = 0.49 }",
    "material = { name = \"silver\" }\ncounterface = { name = \"gold\" }",
    "material = { youngs_modulus = \"70 GPa\", poisson_ratio = 0.33, indentation_hardness = \"300 MPa +- 30 %\", thermal_conductivity = \
     \"150 W/(m K)\" }\n[counterface]\nthermal_conductivity = \"20 W/(m K)\"",
    "material = { youngs_modulus = \"110 GPa\", poisson_ratio = 0.34, indentation_hardness = \"3 GPa\", resistivity = \"2e-8 ohm m\" \
     }\n[counterface]\nresistivity = \"2e-8 ohm m\"",
];

const LOADS: [&str; 4] = [
    "pressures = [\"10 MPa\"]",
    "pressures = [\"300 kPa\", \"30 MPa\"]",
    "pressures = [\"10 kPa\", \"1 MPa\", \"200 MPa\"]",
    "force = \"20 N\"\nnominal_area = \"4 mm^2\"",
];

/// Questions besides the area.
const QUESTIONS: [&str; 6] = [
    "",
    "[interface]",
    "[seal]",
    "[seal]\npressure_drop = \"1 MPa\"\nviscosity = \"1 mPa s\"\nbreadth = \"100 mm\"\nlength = \"2 mm\"",
    "[interface]\ngas = \"air\"",
    "[interface]\nshear_strength = \"50 MPa\"\nwork_of_adhesion = \"50 mJ/m^2\"\nrange_of_attraction = \"0.3 nm\"",
];

/// Curves: those of a report, a pair without yielding, and one that yields.
const CURVES: [&str; 3] = [
    "",
    "[[curve]]\nmodel = \"persson\"\n[[curve]]\nmodel = \"elastic\"",
    "[[curve]]\nmodel = \"persson-plastic\"",
];

/// Few points and few draws: what is said of them must agree all the same.
const SMALL: &str = "[judge]\ngrid = 64\n[uncertainty]\ndraws = 100\n";

/// A scene with everything that was found about it.
pub struct Answered {
    pub text: String,
    pub scene: Scene,
    pub results: Results,
    pub answer: SceneAnswer,
    pub judgement: Option<Judgement>,
    pub uncertainty: Option<Uncertainty>,
}

impl Answered {
    /// Answers a scene; the judge and the draws are left out where the scene switches them off.
    pub fn new(text: &str) -> Self {
        Self::with_files(text, &spectra())
    }

    /// Answers a scene on files of its own.
    pub fn with_files(text: &str, files: &BTreeMap<String, Vec<u8>>) -> Self {
        let scene = Scene::parse(text, files, &Overrides::default())
            .unwrap_or_else(|error| panic!("{error:?}\n{text}"));
        let results = scene.plan().compute().unwrap_or_else(|error| panic!("{error:?}\n{text}"));
        let answer = SceneAnswer::from_results(&scene, &results);
        let judgement = scene.judge.filter(|choices| !choices.off).map(|choices| {
            JudgePlan::new(&scene, &results, &choices)
                .run(&Unobserved)
                .unwrap_or_else(|error| panic!("{error:?}\n{text}"))
        });
        let drawn = scene.uncertainty.filter(|choices| !choices.off);
        let plan = drawn.and_then(|settings| UncertaintyPlan::new(&scene, &results, &settings));
        let uncertainty = plan.map(|plan| plan.run(&Unobserved).unwrap());
        Answered { text: text.to_owned(), scene, results, answer, judgement, uncertainty }
    }

    pub fn evidence(&self) -> Evidence<'_> {
        Evidence {
            scene: &self.scene,
            results: &self.results,
            answer: &self.answer,
            judgement: self.judgement.as_ref(),
            uncertainty: self.uncertainty.as_ref(),
        }
    }

    pub fn conclusions(&self) -> Conclusions {
        Conclusions::new(&self.evidence())
    }
}

/// Writes scene number `at`: all surfaces meet all bodies, and lists of loads, questions and curves go round at other speeds.
pub fn drawn(at: usize) -> String {
    let of = |list: &[&str], place: usize| list[place % list.len()].to_owned();
    let (surface, bodies) = (of(&SURFACES, at), of(&BODIES, at));
    let yields = !bodies.contains("200 GPa") && !bodies.contains("5 MPa");
    let curves = if yields { &CURVES[..] } else { &CURVES[..2] };
    let (loads, asked, curves) = (of(&LOADS, at / 5), of(&QUESTIONS, at / 11 + at), of(curves, at / 3));
    format!("{surface}\n{bodies}\n[loads]\n{loads}\n{asked}\n{curves}\n{SMALL}")
}

/// The spectra that the scenes name: C1D falls as q^-2.6 below 50 um, down to 10 nm; that of `power.csv` everywhere.
fn spectra() -> BTreeMap<String, Vec<u8>> {
    let spectrum = |head: &str, rolloff_m: f64, error: Option<f64>, keeps: &dyn Fn(f64) -> bool| {
        let row = |at: i32| {
            let wavelength_m = 10f64.powf(-3.9 - 0.1 * f64::from(at));
            let c1d_m3 = 2e-17 * ((50e-6 / rolloff_m).powi(2) + (50e-6 / wavelength_m).powi(2)).powf(-1.3);
            let tail = error.map_or_else(String::new, |share| format!(",{:e}", share * c1d_m3));
            keeps(wavelength_m).then(|| format!("{wavelength_m:e},{c1d_m3:e}{tail}\n"))
        };
        let rows: String = (0..=41).filter_map(row).collect();
        format!("wavelength_m,C1D_m3{head}\n{rows}").into_bytes()
    };
    let all = |_: f64| true;
    BTreeMap::from([
        ("plain.csv".to_owned(), spectrum("", 50e-6, None, &all)),
        ("power.csv".to_owned(), spectrum("", 1.0, None, &all)),
        ("errors.csv".to_owned(), spectrum(",C1D_se_m3", 50e-6, Some(0.2), &all)),
        (
            "hole.csv".to_owned(),
            spectrum("", 50e-6, None, &|wavelength_m| !(1.1e-7..2.2e-6).contains(&wavelength_m)),
        ),
        (
            "short.csv".to_owned(),
            spectrum("", 50e-6, None, &|wavelength_m| (4e-6..1.1e-5).contains(&wavelength_m)),
        ),
    ])
}
