//! Trials of the judge of scenes: spectra of every kind, whose whole band is solved at once, against the judge that must cut
//! them into windows: the tables of `docs/guide/judge.md`.

use gaussian_surfaces::AreaSpectrum;
use judge::{JudgePlan, Judgement, Settings, Verdict};
use parallel::Unobserved;
use scene::{Overrides, Scene};
use serde::{Deserialize, Serialize};
use spectrum::{Convention, Psd};
use study::Files;
use tables::markdown::{table, with_section};
use units::display::three_digits;

use crate::TrialError;
use crate::elements::digits;

/// Contact modulus E* of all trials \[Pa\].
pub(crate) const CONTACT_MODULUS_PA: f64 = 100e9;
/// Rms gradient h' of every surface.
pub(crate) const RMS_GRADIENT: f64 = 0.05;
/// The shortest wavelength \[m\]. Areas do not depend on it.
pub(crate) const SHORTEST_M: f64 = 1e-8;
/// Longest over shortest wavelength.
pub(crate) const WIDTH: f64 = 64.0;
/// Loads p/(E* h') of every trial.
pub const LOADS: [f64; 3] = [0.005, 0.03, 0.2];
/// Points along a side on which the judge presses windows: about one decade each.
pub const WINDOW_GRID: usize = 96;
/// Relative standard error to which the truth is known; surfaces are added until it is.
const TRUTH_ERROR: f64 = 0.02;
/// Surfaces that are pressed before the error of the truth is looked at again.
const BATCH: usize = 8;
/// The most batches of surfaces.
const MAX_BATCHES: u64 = 3;
/// The seed of the first batch of the truth. The judge's own seed is another.
const TRUTH_SEED: u64 = 1000;
/// Samples per decade of the spectra.
const PER_DECADE: f64 = 40.0;
/// Decades beyond the shortest wavelength over which profiles see shorter waves of the surface.
const BEYOND_DECADES: f64 = 2.5;
/// Spectra of each kind in a set.
const OF_A_KIND: u32 = 5;

/// Part of the trials.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Set {
    /// The errors that the judge states were measured on these.
    Calibration,
    /// These were pressed afterwards, and changed nothing.
    Report,
}

/// Form of a spectrum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// Hurst exponents from 0.2 to 0.9 over the whole band.
    SelfAffine,
    /// Level at long wavelengths.
    RollOff,
    /// Two humps with little between them.
    TwoHumps,
    /// One hump on a self-affine spectrum.
    Hump,
    /// A band with less or more roughness than its neighbours.
    Step,
    /// Steeper than any fractal at long wavelengths.
    Steep,
}

/// Spectrum of a trial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JudgeTrial {
    /// Set to which it belongs.
    pub set: Set,
    /// Form of the spectrum.
    pub kind: Kind,
    /// Number of the trial among all of both sets, from 1.
    pub number: u32,
}

/// All trials of a set.
#[must_use]
pub fn trials(set: Set) -> Vec<JudgeTrial> {
    let first = match set {
        Set::Calibration => 1,
        Set::Report => 1 + OF_A_KIND * Kind::ALL.len() as u32,
    };
    let members = Kind::ALL.iter().flat_map(|&kind| (0..OF_A_KIND).map(move |_| kind));
    let trial = |(at, kind): (usize, Kind)| JudgeTrial { set, kind, number: first + at as u32 };
    members.enumerate().map(trial).collect()
}

impl JudgeTrial {
    /// Four numbers between 0 and 1 that spread evenly over the trials.
    fn draws(&self) -> [f64; 4] {
        // Powers of the inverse of the root of x^5 = x + 1, the generalised golden ratio of four dimensions.
        const ROOT: f64 = 1.167_303_978_261_418_7;
        [1, 2, 3, 4].map(|power| (0.5 + f64::from(self.number) * ROOT.powi(-power)).fract())
    }

    /// Ciso at a wavelength in units of the shortest, up to a factor.
    fn ciso(&self, wavelength: f64) -> f64 {
        let [a, b, c, d] = self.draws();
        let between = |low: f64, high: f64, share: f64| low * (high / low).powf(share);
        let self_affine = |hurst: f64, rolloff: f64| wavelength.min(rolloff).powf(2.0 + 2.0 * hurst);
        let hump = |centre: f64, width: f64| (-0.5 * ((wavelength / centre).ln() / width).powi(2)).exp();
        match self.kind {
            Kind::SelfAffine => self_affine(0.2 + 0.7 * a, f64::INFINITY),
            Kind::RollOff => self_affine(0.2 + 0.7 * a, between(2.0, 32.0, b)),
            Kind::TwoHumps => {
                let long = hump(between(25.0, 60.0, a), 0.2 + 0.3 * b);
                let short = between(0.03, 1.0, c) * hump(between(1.5, 6.0, d), 0.2 + 0.3 * b);
                self_affine(1.0, f64::INFINITY) * (1e-4 + long + short)
            }
            Kind::Hump => {
                let height = between(3.0, 1000.0, c);
                self_affine(0.3 + 0.6 * a, f64::INFINITY)
                    * (1.0 + height * hump(between(1.5, 50.0, b), 0.15 + 0.35 * d))
            }
            Kind::Step => {
                let end = between(1.5, 8.0, b);
                let inside = (end..end * between(3.0, 8.0, d)).contains(&wavelength);
                self_affine(0.3 + 0.6 * a, f64::INFINITY) * if inside { between(1e-3, 30.0, c) } else { 1.0 }
            }
            Kind::Steep => {
                let knee = between(2.0, 32.0, b);
                self_affine(1.7 + 0.5 * c, f64::INFINITY)
                    * (1.0 + (knee / wavelength).powi(2)).powf(1.0 + 0.5 * a)
            }
        }
    }

    /// Spectrum of the profiles of a surface whose waves go on below the shortest wavelength, as scans see it.
    fn profile(&self) -> Result<(Vec<f64>, Vec<f64>), TrialError> {
        let decades = WIDTH.log10();
        let steps = |decades: f64| (PER_DECADE * decades).ceil();
        let place = |at: u32, of: f64, decades: f64| WIDTH * 10f64.powf(-decades * f64::from(at) / of);
        let all_decades = decades + BEYOND_DECADES;
        let fine = 4.0 * steps(all_decades);
        let wavelengths: Vec<f64> = (0..=fine as u32).map(|at| place(at, fine, all_decades)).collect();
        // Beyond the band the spectrum falls as it does at its end.
        let slope = (self.ciso(1.01) / self.ciso(1.0)).ln() / 1.01f64.ln();
        let ciso = |&wavelength: &f64| {
            if wavelength < 1.0 {
                self.ciso(1.0) * wavelength.powf(slope.max(3.0))
            } else {
                self.ciso(wavelength)
            }
        };
        let values = wavelengths.iter().map(ciso).collect();
        let wavelengths_m = wavelengths.iter().map(|wavelength| wavelength * SHORTEST_M).collect();
        let surface = AreaSpectrum::from_psd(&Psd::new(wavelengths_m, values, Convention::Ciso)?)?;
        let own_gradient =
            surface.cut(WIDTH * SHORTEST_M, SHORTEST_M * (1.0 + 1e-9))?.mean_square_gradient().sqrt();
        let of_band = steps(decades);
        let sampled: Vec<f64> =
            (0..=of_band as u32).map(|at| place(at, of_band, decades) * SHORTEST_M).collect();
        let scale = (RMS_GRADIENT / own_gradient).powi(2);
        let c1d_m3 = surface.profile(&sampled)?.c1d_m3().iter().map(|value| scale * value).collect();
        Ok((sampled, c1d_m3))
    }

    /// Scene of the trial, with all models that apply or Persson's theory alone.
    pub(crate) fn scene(&self, all_models: bool) -> Result<Scene, TrialError> {
        let (wavelengths_m, c1d_m3) = self.profile()?;
        let mut csv = "wavelength_m,C1D_m3\n".to_owned();
        for (wavelength_m, c1d_m3) in wavelengths_m.iter().zip(&c1d_m3) {
            csv += &format!("{wavelength_m:e},{c1d_m3:e}\n");
        }
        let loads =
            LOADS.map(|load| format!("\"{} Pa\"", load * CONTACT_MODULUS_PA * RMS_GRADIENT)).join(", ");
        let text = format!(
            "title = \"trial\"\n[surface]\npsd = \"s.csv\"\n[material]\nyoungs_modulus = \"{CONTACT_MODULUS_PA} Pa\"\n\
             poisson_ratio = 0\n[judge]\nall_models = {all_models}\n[loads]\npressures = [{loads}]\n\
             [[curve]]\nmodel = \"persson\"\n"
        );
        Scene::parse(&text, &InMemory(csv), &Overrides::default())
            .map_err(|error| TrialError::Scene(error.to_string()))
    }

    /// Nayak's alpha of the surface.
    ///
    /// # Errors
    /// The error of making the spectrum.
    pub fn alpha(&self) -> Result<f64, TrialError> {
        let psd = self.scene(false)?.plan().compute()?.psd;
        let moments = AreaSpectrum::from_profile(&psd)?.moments();
        Ok(moments.m0_m2 * moments.m4_per_m2 / (moments.m2 * moments.m2))
    }

    fn judgement(&self, all_models: bool, settings: &Settings) -> Result<(Scene, Judgement), TrialError> {
        let scene = self.scene(all_models)?;
        let results = scene.plan().compute()?;
        let judgement = JudgePlan::new(&scene, &results, settings).run(&Unobserved)?;
        Ok((scene, judgement))
    }

    /// Solves the whole band at once, with more surfaces until the area under every load is known.
    ///
    /// # Errors
    /// The error of making or pressing a surface.
    pub fn truth(&self) -> Result<Vec<TruthRow>, TrialError> {
        let grid = (8.0 * WIDTH) as usize;
        let mut batches: Vec<Vec<(f64, f64)>> = Vec::new();
        for seed in TRUTH_SEED..TRUTH_SEED + MAX_BATCHES {
            let settings =
                Settings { grid: Some(grid), realisations: Some(BATCH), seed, budget: f64::INFINITY };
            let (_, judgement) = self.judgement(false, &settings)?;
            batches.push(judgement.references.iter().filter_map(area_of_surfaces).collect());
            if (0..LOADS.len()).all(|load| pooled(&batches, load).1 < TRUTH_ERROR) {
                break;
            }
        }
        let alpha = self.alpha()?;
        let row = |(load, pressure_over_gradient): (usize, &f64)| {
            let (area_fraction, relative_error) = pooled(&batches, load);
            TruthRow {
                set: self.set,
                kind: self.kind,
                number: self.number,
                alpha: digits(alpha),
                pressure_over_gradient: *pressure_over_gradient,
                area_fraction: digits(area_fraction),
                relative_error: digits(relative_error),
                surfaces: batches.len() * BATCH,
            }
        };
        Ok(LOADS.iter().enumerate().map(row).collect())
    }

    /// Judges the spectrum in windows, and compares the judge and every curve with the truth.
    ///
    /// # Errors
    /// The error of making or pressing a surface, and of running a model.
    pub fn judged(&self, truth: &[TruthRow]) -> Result<Vec<JudgedRow>, TrialError> {
        let settings = Settings { grid: Some(WINDOW_GRID), budget: f64::INFINITY, ..Settings::default() };
        let (scene, judgement) = self.judgement(true, &settings)?;
        let row = |curve: &judge::CurveVerdict| {
            let known = truth.iter().filter(|row| row.number == self.number).nth(curve.load)?;
            let elements = curve.elements?;
            Some(JudgedRow {
                set: self.set,
                kind: self.kind,
                number: self.number,
                alpha: known.alpha,
                pressure_over_gradient: known.pressure_over_gradient,
                truth: known.area_fraction,
                truth_error: known.relative_error,
                judge: digits(elements.area_fraction / known.area_fraction),
                stated_error: digits(elements.relative_error()),
                bracket: digits(elements.high() / elements.low()),
                curve: scene.needs.curves[curve.curve].name.clone(),
                curve_over_truth: digits(curve.area_fraction? / known.area_fraction),
                agrees: curve.verdict == Verdict::Agrees,
                holds: curve.holds(),
            })
        };
        Ok(judgement.curves.iter().filter_map(row).collect())
    }
}

/// The scatter of surfaces alone: the grid is the same in the judge and in the truth.
fn area_of_surfaces(area: &judge::ReferenceArea) -> Option<(f64, f64)> {
    const GRID_ERROR: f64 = 0.015;
    let elements = area.elements?;
    let scatter = (elements.relative_error().powi(2) - GRID_ERROR * GRID_ERROR).max(0.0).sqrt();
    Some((elements.area_fraction, scatter))
}

/// Mean over batches, and its relative standard error.
fn pooled(batches: &[Vec<(f64, f64)>], load: usize) -> (f64, f64) {
    let of_load: Vec<(f64, f64)> = batches.iter().filter_map(|batch| batch.get(load).copied()).collect();
    let count = of_load.len() as f64;
    let mean = of_load.iter().map(|(area, _)| area).sum::<f64>() / count;
    let variance = of_load.iter().map(|(area, relative)| (area * relative).powi(2)).sum::<f64>();
    (mean, variance.sqrt() / count / mean)
}

/// Spectrum in memory.
struct InMemory(String);

impl Files for InMemory {
    fn read(&self, _: &str) -> std::io::Result<Vec<u8>> {
        Ok(self.0.clone().into_bytes())
    }

    fn read_beside(&self, _: &str, _: &str) -> std::io::Result<Option<Vec<u8>>> {
        Ok(None)
    }
}

/// Area of a whole band solved at once.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct TruthRow {
    /// Set of the trial.
    pub set: Set,
    /// Form of its spectrum.
    pub kind: Kind,
    /// Number of the trial.
    pub number: u32,
    /// Nayak's alpha.
    pub alpha: f64,
    /// Load p/(E* h').
    pub pressure_over_gradient: f64,
    /// Mean area fraction.
    pub area_fraction: f64,
    /// Its relative standard error, from the scatter of the surfaces.
    pub relative_error: f64,
    /// Number of surfaces.
    pub surfaces: usize,
}

/// A curve under a load, beside the judge and the truth.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct JudgedRow {
    /// Set of the trial.
    pub set: Set,
    /// Form of its spectrum.
    pub kind: Kind,
    /// Number of the trial.
    pub number: u32,
    /// Nayak's alpha.
    pub alpha: f64,
    /// Load p/(E* h').
    pub pressure_over_gradient: f64,
    /// Area fraction of the whole band solved at once.
    pub truth: f64,
    /// Its relative standard error.
    pub truth_error: f64,
    /// Judge's area over the truth.
    pub judge: f64,
    /// Relative standard error that the judge states.
    pub stated_error: f64,
    /// Upper over lower end of the judge's bracket.
    pub bracket: f64,
    /// Name of the curve.
    pub curve: String,
    /// Curve's area over the truth.
    pub curve_over_truth: f64,
    /// True if its verdict on the whole band is `agrees`.
    pub agrees: bool,
    /// True if it agrees on most windows too.
    pub holds: bool,
}

/// Returns the page with new tables; its text is written by hand.
///
/// # Errors
/// [`TrialError::Page`] if the page lacks a section.
pub fn written(page: &str, rows: &[JudgedRow]) -> Result<String, TrialError> {
    let sections = [("judge", errors(rows)), ("agrees", promises(rows))];
    sections.into_iter().try_fold(page.to_owned(), |page, (name, contents)| {
        with_section(&page, name, &contents).map_err(TrialError::Page)
    })
}

/// Errors of the judge, for each set and each kind of the reported one.
fn errors(rows: &[JudgedRow]) -> String {
    let of_judge: Vec<&JudgedRow> = rows.iter().filter(|row| row.curve == "persson").collect();
    let line = |name: &str, wanted: &dyn Fn(&JudgedRow) -> bool| {
        let of_line: Vec<&JudgedRow> = of_judge.iter().copied().filter(|row| wanted(row)).collect();
        let count = of_line.len();
        let squares: f64 = of_line.iter().map(|row| row.judge.ln().powi(2)).sum();
        let worst = of_line.iter().map(|row| (row.judge.ln().abs(), row.judge));
        let worst = worst.max_by(|a, b| a.0.total_cmp(&b.0)).map_or(1.0, |(_, ratio)| ratio);
        let within = of_line.iter().filter(|row| row.is_within_two_errors()).count();
        let mut brackets: Vec<f64> = of_line.iter().map(|row| row.bracket).collect();
        brackets.sort_by(f64::total_cmp);
        vec![
            name.to_owned(),
            format!("{:.1} %", 100.0 * (squares / count.max(1) as f64).sqrt()),
            three_digits(worst),
            format!("{within} of {count}"),
            three_digits(brackets.get(count / 2).copied().unwrap_or(f64::NAN)),
        ]
    };
    let mut lines = vec![
        line("calibration", &|row| row.set == Set::Calibration),
        line("reported", &|row| row.set == Set::Report),
        line("reported, truth known to 2 %", &|row| row.set == Set::Report && row.truth_error <= TRUTH_ERROR),
    ];
    lines.extend(Kind::ALL.iter().map(|&kind| {
        line(&format!("reported, {}", kind.name()), &|row| row.set == Set::Report && row.kind == kind)
    }));
    table(&["trials", "rms", "worst ratio", "within two standard errors", "median bracket"], &lines)
}

/// Share of the curves that get `agrees` and are within 4/3 of the truth.
fn promises(rows: &[JudgedRow]) -> String {
    let line = |name: &str, set: Set, has: fn(&JudgedRow) -> bool| {
        let promised = || rows.iter().filter(|row| row.set == set && has(row));
        let kept = promised().filter(|row| (0.75..=4.0 / 3.0).contains(&row.curve_over_truth)).count();
        let count = promised().count();
        vec![
            name.to_owned(),
            format!("{kept} of {count}"),
            format!("{:.1} %", 100.0 * kept as f64 / count.max(1) as f64),
        ]
    };
    let lines = [
        line("calibration, whole band", Set::Calibration, |row| row.agrees),
        line("calibration, whole band and most windows", Set::Calibration, |row| row.holds),
        line("reported, whole band", Set::Report, |row| row.agrees),
        line("reported, whole band and most windows", Set::Report, |row| row.holds),
    ];
    table(&["`agrees`", "within 4/3 of the truth", "share"], &lines)
}

impl Kind {
    pub(crate) const ALL: [Kind; 6] =
        [Kind::SelfAffine, Kind::RollOff, Kind::TwoHumps, Kind::Hump, Kind::Step, Kind::Steep];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Kind::SelfAffine => "self-affine",
            Kind::RollOff => "roll-off",
            Kind::TwoHumps => "two humps",
            Kind::Hump => "one hump",
            Kind::Step => "step or hole",
            Kind::Steep => "steep",
        }
    }
}

impl JudgedRow {
    /// True if judge and truth differ by at most two of their standard errors. The errors of the judge and of the truth are
    /// independent.
    fn is_within_two_errors(&self) -> bool {
        (self.judge - 1.0).abs() <= 2.0 * (self.stated_error * self.judge).hypot(self.truth_error)
    }
}
