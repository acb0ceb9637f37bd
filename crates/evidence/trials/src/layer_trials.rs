//! Trials of the judge on layers: bands whose waves feel layer and base, solved at once, against the judge that cuts them into
//! windows: tables of `docs/develop/trials.md`.

use asperity::{ElasticBody, Layer, LayerCompliance, MaterialPair};
use elements::Relief;
use elements::half_space::{Elements, Loading};
use numerics::parallel::Unobserved;
use scene::Scene;
use spectrum::random_surfaces::AreaSpectrum;
use tables::markdown::{table, with_section};
use units::display::three_digits;

use crate::TrialError;
use crate::elements::digits;
use crate::judge_spectra::{
    CONTACT_MODULUS_PA, JudgeTrial, LayerKind, SHORTEST_M, Set, trials as judge_trials,
};
use crate::judge_trials::{JudgedRow, errors_of_judge, judged};
use crate::judge_truth::TOLERANCE;

/// Loads p/(2s) of every trial, with the rms pressure s of full contact.
pub const LOADS: [f64; 3] = [0.005, 0.03, 0.2];
/// The most batches of surfaces.
const MAX_BATCHES: u64 = 4;
/// Side of the box over the longest wavelength.
const LENGTHS_IN_BOX: f64 = 2.0;

/// A spectrum on a layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LayerTrial {
    /// The layer.
    pub layer: LayerKind,
    /// The spectrum.
    pub spectrum: JudgeTrial,
}

/// Spectra on which the closed form and the error of a seam were chosen: two self-affine ones with the Hurst exponents 0.84 and
/// 0.54, and one that is steep at long waves, which feel the base most.
const CALIBRATION: [u32; 3] = [32, 35, 56];
/// Spectra that were pressed afterwards: self-affine (0.64), with a roll-off (0.84), and steep.
const REPORT: [u32; 3] = [34, 39, 57];

/// All trials: some of the judge's spectra, each on every layer.
#[must_use]
pub fn trials() -> Vec<LayerTrial> {
    let all = judge_trials(Set::Report);
    let numbers = CALIBRATION.iter().chain(&REPORT);
    let spectra = numbers.filter_map(|number| all.iter().find(|trial| trial.number == *number));
    let on_layers = |&spectrum| LayerKind::ALL.iter().map(move |&layer| LayerTrial { layer, spectrum });
    spectra.flat_map(on_layers).collect()
}

impl LayerTrial {
    fn thickness_m(&self) -> f64 {
        self.spectrum.width() * SHORTEST_M / self.layer.wavelengths()
    }

    fn youngs_modulus_pa(&self) -> f64 {
        CONTACT_MODULUS_PA * (1.0 - self.layer.poisson_ratio().powi(2))
    }

    fn compliance(&self) -> Result<LayerCompliance, TrialError> {
        let body = |modulus_pa: f64| ElasticBody::new(modulus_pa, self.layer.poisson_ratio());
        let own = body(self.youngs_modulus_pa())?;
        let base =
            self.layer.base_over_layer().map(|ratio| body(ratio * self.youngs_modulus_pa())).transpose()?;
        let layer = Layer::new(own, self.thickness_m(), base)?;
        let pair = MaterialPair::against_rigid(own).bonded(Some(layer));
        pair.layer_compliance().ok_or_else(|| TrialError::Scene("the pair has no layer".to_owned()))
    }

    fn scene(&self, pressures_pa: &[f64]) -> Result<Scene, TrialError> {
        let ratio = self.layer.poisson_ratio();
        let base = match self.layer.base_over_layer() {
            Some(over) => {
                format!(
                    "youngs_modulus = \"{} Pa\"\npoisson_ratio = {ratio}\n",
                    over * self.youngs_modulus_pa()
                )
            }
            None => String::new(),
        };
        let word = if base.is_empty() { "rigid" } else { "material" };
        let material = format!(
            "[material]\n{base}[material.layer]\nthickness = \"{} m\"\nyoungs_modulus = \"{} Pa\"\npoisson_ratio = {ratio}\n\
             base = \"{word}\"\n",
            self.thickness_m(),
            self.youngs_modulus_pa()
        );
        self.spectrum.scene_with(&material, pressures_pa, true)
    }

    /// The spectrum of the surface, and the rms pressure \[Pa\] of its full contact on the layer and on a half-space.
    fn surface(&self) -> Result<(AreaSpectrum, [f64; 2]), TrialError> {
        let psd = self.spectrum.scene(false)?.plan().compute()?.psd;
        let surface = AreaSpectrum::from_profile(&psd)?;
        let layer = self.compliance()?;
        let alike = surface.weighted(|wavevector_rad_per_m| layer.relative_at(wavevector_rad_per_m).powi(-2));
        let spread_pa = |waves: &AreaSpectrum| 0.5 * CONTACT_MODULUS_PA * waves.mean_square_gradient().sqrt();
        let spreads_pa = [spread_pa(&alike), spread_pa(&surface)];
        Ok((surface, spreads_pa))
    }

    /// Presses surfaces with the whole band until the area under every load is known, or the most batches are pressed.
    ///
    /// # Errors
    /// The error of making or pressing a surface.
    pub fn truth(&self) -> Result<Vec<JudgedRow>, TrialError> {
        let (surface, [spread_pa, on_half_space_pa]) = self.surface()?;
        let layer = self.compliance()?;
        let row = |&load: &f64| {
            let loading = Loading {
                contact_modulus_pa: CONTACT_MODULUS_PA,
                nominal_pressure_pa: load * 2.0 * spread_pa,
                saturation_pa: None,
                tolerance: TOLERANCE,
            };
            let area = |relief: &Relief| {
                let mut elements =
                    Elements::periodic_on(relief.grid()?, &relief.heights_m, |wavevector_rad_per_m| {
                        layer.relative_at(wavevector_rad_per_m)
                    })?;
                Ok(elements.press(&loading, &Unobserved)?.numbers.area_fraction_corrected)
            };
            let (area, _) = self.spectrum.known_area(&surface, LENGTHS_IN_BOX, MAX_BATCHES, area)?;
            Ok(JudgedRow {
                set: if REPORT.contains(&self.spectrum.number) { Set::Report } else { Set::Calibration },
                layer: Some(self.layer),
                kind: self.spectrum.kind,
                number: self.spectrum.number,
                stiffening: digits(spread_pa / on_half_space_pa),
                load,
                truth: digits(area.value),
                truth_error: digits(area.standard_error / area.value),
                ..JudgedRow::default()
            })
        };
        LOADS.iter().map(row).collect()
    }

    /// Judges the spectrum in windows, and compares the judge and every curve with the truth.
    ///
    /// # Errors
    /// The error of making or pressing a surface, and of running a model.
    pub fn judged(&self, truth: &[JudgedRow]) -> Result<Vec<JudgedRow>, TrialError> {
        let (_, [spread_pa, _]) = self.surface()?;
        let scene = self.scene(&LOADS.map(|load| load * 2.0 * spread_pa))?;
        judged(&scene, |load| truth.iter().find(|row| self.is_of(row) && row.load == LOADS[load]).cloned())
    }

    /// Returns true for a truth of this trial.
    #[must_use]
    pub fn is_of(&self, truth: &JudgedRow) -> bool {
        (truth.layer, truth.number) == (Some(self.layer), self.spectrum.number)
    }
}

/// Returns the page with a new table; its text is written by hand.
///
/// # Errors
/// [`TrialError::Page`] if the page lacks the section.
pub fn written(page: &str, rows: &[JudgedRow]) -> Result<String, TrialError> {
    let line = |name: &str, wanted: &dyn Fn(&JudgedRow) -> bool| {
        let of_line: Vec<&JudgedRow> = rows.iter().filter(|row| wanted(row)).collect();
        let of_judge: Vec<&JudgedRow> =
            of_line.iter().copied().filter(|row| row.curve == "persson").collect();
        let [rms, within, bracket] = errors_of_judge(&of_judge);
        let range = |values: Vec<f64>| {
            let least = values.iter().copied().fold(f64::INFINITY, f64::min);
            let most = values.iter().copied().fold(0.0, f64::max);
            format!("{} to {}", three_digits(least), three_digits(most))
        };
        let promised: Vec<_> = of_line.iter().filter(|row| row.agrees).collect();
        let kept = promised.iter().filter(|row| row.is_curve_right()).count();
        vec![
            name.to_owned(),
            range(of_judge.iter().map(|row| row.stiffening).collect()),
            rms,
            range(of_judge.iter().map(|row| row.judge).collect()),
            within,
            bracket,
            range(of_judge.iter().map(|row| row.curve_over_truth).collect()),
            format!("{kept} of {}", promised.len()),
        ]
    };
    let is_reported = |row: &JudgedRow| row.set == Set::Report;
    let mut lines = vec![line("calibration", &|row| !is_reported(row)), line("reported", &is_reported)];
    lines.extend(LayerKind::ALL.iter().map(|&layer| {
        line(&format!("reported, {}", layer.name()), &|row| is_reported(row) && row.layer == Some(layer))
    }));
    let headings = [
        "layer",
        "s over that without",
        "rms",
        "judge over truth",
        "within two standard errors",
        "median bracket",
        "`persson` over truth",
        "`agrees` within 4/3 of the truth",
    ];
    with_section(page, "layers", &table(&headings, &lines)).map_err(TrialError::Page)
}
