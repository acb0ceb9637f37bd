//! Scenes and spectra that several files of tests judge.

use std::f64::consts::PI;

use judge::{JudgePlan, JudgeSettings, Judgement};
use scene::{Overrides, Scene};
use study::plan::Results;
use study::{Files, Unobserved};

/// A spectrum in memory: Hurst exponent 0.8 over some decades from 1 um down, and steep between 0.3 and 0.1 um if it has a step.
pub struct SelfAffine {
    pub decades: f64,
    pub has_step: bool,
}

impl Files for SelfAffine {
    fn read(&self, _: &str) -> std::io::Result<Vec<u8>> {
        let samples = (12.0 * self.decades).round() as usize;
        let mut text = "wavelength_m,C1D_m3\n".to_owned();
        for sample in 0..=samples {
            let wavelength_m = 1e-6 * 10f64.powf(-self.decades * sample as f64 / samples as f64);
            let below_step = if self.has_step { wavelength_m.clamp(1e-7, 3e-7) / 3e-7 } else { 1.0 };
            let c1d_m3 = 1e-24 * (wavelength_m / 1e-6).powf(2.6) * below_step.powi(5);
            text += &format!("{wavelength_m:e},{c1d_m3:e}\n");
        }
        Ok(text.into_bytes())
    }

    fn read_beside(&self, _: &str, _: &str) -> std::io::Result<Option<Vec<u8>>> {
        Ok(None)
    }
}

/// The spectrum of a white area with an rms gradient of 0.05, over some decades from 1 um down.
pub struct White(pub f64);

impl Files for White {
    fn read(&self, _: &str) -> std::io::Result<Vec<u8>> {
        let [first, last] = [0.0, self.0].map(|decades| 2e6 * PI * 10f64.powf(decades));
        let ciso_m4 = 8.0 * PI * 0.05f64.powi(2) / (last.powi(4) - first.powi(4));
        let row = |at: u32| format!("{:e},{ciso_m4:e}\n", 1e-6 * 10f64.powf(-self.0 * f64::from(at) / 10.0));
        let rows: String = (0..=10).map(row).collect();
        Ok(format!("wavelength_m,Ciso_m4\n{rows}").into_bytes())
    }

    fn read_beside(&self, _: &str, _: &str) -> std::io::Result<Option<Vec<u8>>> {
        Ok(None)
    }
}

pub fn scene(decades: f64, material: &str, loads: &str, curves: &[&str]) -> Scene {
    scene_on(&SelfAffine { decades, has_step: false }, material, loads, curves)
}

pub fn scene_on(files: &impl Files, material: &str, loads: &str, curves: &[&str]) -> Scene {
    let curves: String = curves.iter().map(|curve| format!("[[curve]]\n{curve}\n")).collect();
    let text = format!(
        "title = \"s\"\n[surface]\npsd = \"s.csv\"\n[material]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0.3\n{material}\n\
         [loads]\npressures = [{loads}]\n{curves}"
    );
    Scene::parse(&text, files, &Overrides::default()).unwrap()
}

pub fn judged(scene: &Scene, settings: &JudgeSettings) -> (Results, Judgement) {
    let results = scene.plan().compute().unwrap();
    let judgement = JudgePlan::new(scene, &results, settings).run(&Unobserved).unwrap();
    (results, judgement)
}

pub fn coarse(grid: usize, realisations: usize) -> JudgeSettings {
    JudgeSettings { grid: Some(grid), realisations: Some(realisations), ..JudgeSettings::default() }
}

pub const ELASTIC: [&str; 3] = ["model = \"elastic\"", "model = \"persson\"", "model = \"hertz\""];

/// Scene of the spectrum of [`SelfAffine`] on a layer of 200 GPa, whose base is rigid or has these constants.
pub fn layered(decades: f64, thickness: &str, constants: &str) -> Scene {
    let base = if constants.is_empty() { "rigid" } else { "material" };
    let text = format!(
        "title = \"s\"\n[surface]\npsd = \"s.csv\"\n[material]\n{constants}\n[material.layer]\nthickness = \"{thickness}\"\n\
         youngs_modulus = \"200 GPa\"\npoisson_ratio = 0.3\nbase = \"{base}\"\n[judge]\n\
         [loads]\npressures = [\"300 MPa\"]\n[[curve]]\nmodel = \"persson\"\n"
    );
    Scene::parse(&text, &SelfAffine { decades, has_step: false }, &Overrides::default()).unwrap()
}
