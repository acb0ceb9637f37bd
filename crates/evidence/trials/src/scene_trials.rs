//! Trials of the answer of realistic scenes: files of instruments and tabled materials, whose whole band is pressed at once, against the
//! area and the one range that `truearea report` gives: a table of `docs/develop/trials.md`.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use elements::half_space::{ContactNumbers, Loading};
use elements::{Boundary, RandomChoices, Relief, Surfaces};
use measurements::{MapOfFile, ScanRequest};
use numerics::parallel::{Unobserved, map_indices};
use scene::{Overrides, Scene};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use spectrum::random_surfaces::{AreaSpectrum, MapWaves};
use tables::markdown::{table, with_section};
use topography::Recipe;
use units::display::three_digits;

use crate::TrialError;
use crate::elements::digits;
use crate::judge_truth::{TOLERANCE, TRUTH_ERROR};
use crate::statistics::Mean;

/// Number of scenes.
const SCENES: u32 = 100;
/// Files of instruments, the shortest wavelength \[m\] that is trusted, and true for maps, whose shortest wave has four points.
const FILES: [(&str, f64, bool); 12] = [
    ("hfm-1.hfm", 10e-6, false),
    ("di-6.di", 78.2e-9, true),
    ("opd-1.opd", 788e-9, true),
    ("dektak-1.csv", 3.1e-6, false),
    ("di-4.di", 78.2e-9, true),
    ("plu-1.plu", 6.65e-6, true),
    ("opdx-3.opdx", 230e-9, false),
    ("mi-1.mi", 313e-9, true),
    ("sur-2.sur", 14e-6, true),
    ("uncd_stylus_300um_5mar_3_k0HpKJt.txt", 2.4e-6, false),
    ("nid-1.nid", 313e-9, true),
    ("80_Scale10.472_FIXEDv2p1_D7eHXiT.asc", 6.2e-9, false),
];
/// Materials of the table.
const MATERIALS: [&str; 5] = ["100Cr6", "C45", "6061-T6", "alumina", "PTFE"];
/// Points on the shortest wavelength, and longest wavelengths along a side of the box, on grids that hold both.
const POINTS_AND_LENGTHS: f64 = 4.0 * 4.0;
/// Points along a side, with the surfaces that are pressed at most.
const GRIDS: [(usize, usize); 3] = [(512, 48), (1024, 16), (2048, 4)];
/// Surfaces that are pressed before the error is looked at again.
const BATCH: usize = 4;
/// Seed of the surfaces. The judge's own seed is another.
const SEED: u64 = 4000;
/// Relative error of the grid and of the box. Spots of a map that few points touch add one over the root of these points.
const GRID_ERROR: f64 = 0.02;
/// Loads p/(E* h') below which the area of a random surface, and of a map, is carried down: nearly in proportion to the load.
const LIGHTEST: [f64; 2] = [3e-4, 1e-3];
/// Limit of A E* h'/p at the lightest loads.
const LIGHT_LIMIT: f64 = 2.506_628_274_631;

/// The answer of a scene beside the truth.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct SceneRow {
    /// Number of the scene.
    pub scene: u32,
    /// File of the scan.
    pub file: String,
    /// True for a map, whose truth is that of the map itself; other files have the truth of Gaussian surfaces with their spectrum.
    pub is_map: bool,
    /// Name of the material.
    pub material: String,
    /// Nominal pressure \[MPa\].
    pub pressure_mpa: f64,
    /// Load p/(E* h').
    pub pressure_over_gradient: f64,
    /// Share of the load that flows.
    pub flowing: f64,
    /// Area fraction of the whole band.
    pub truth: f64,
    /// Its relative standard error.
    pub truth_error: f64,
    /// Best estimate; empty if only a range is known.
    pub area: Option<f64>,
    /// Lower end of the range.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// True if the number is that of boundary elements.
    pub is_judged: bool,
}

/// All scenes without truth and answer: files and materials in turn, loads spread evenly over three decades.
#[must_use]
pub fn scenes() -> Vec<SceneRow> {
    let row = |scene: u32| {
        let (file, _, is_map) = file_of(scene);
        let share = (f64::from(scene) * 0.618_033_988_749_895).fract();
        let pressure_mpa = digits(10f64.powf(1.0 + 3.0 * share).round() / 100.0);
        let material = MATERIALS[scene as usize % MATERIALS.len()].to_owned();
        SceneRow { scene, file: file.to_owned(), is_map, material, pressure_mpa, ..SceneRow::default() }
    };
    (1..=SCENES).map(row).collect()
}

/// The file of a scene by number.
fn file_of(scene: u32) -> (&'static str, f64, bool) {
    FILES[scene as usize % FILES.len()]
}

impl SceneRow {
    /// Presses the whole band at once.
    ///
    /// # Errors
    /// The error of reading the files, and of making or pressing a surface.
    pub fn with_truth(self, files: &BTreeMap<String, Vec<u8>>) -> Result<Self, TrialError> {
        let (file, shortest_m, is_map) = file_of(self.scene);
        let text = format!(
            "title = \"trial\"\n[surface]\nscans = [{{ file = \"{file}\", shortest_wavelength = \"{shortest_m:e} m\" }}]\n\
             [material]\nname = \"{}\"\n[loads]\npressures = [\"{} MPa\"]\n[[curve]]\nmodel = \"persson\"\n",
            self.material, self.pressure_mpa
        );
        let scene = Scene::parse(&text, files, &Overrides::default()).map_err(failed)?;
        let material = scene.material.ok_or_else(|| failed("no material"))?;
        let surfaces = match is_map {
            true => Surfaces::Maps(vec![mirrored(file, files, shortest_m)?]),
            false => random(&AreaSpectrum::from_profile(&scene.plan().compute()?.psd)?)?,
        };
        let contact_modulus_pa = material.pair.composite_modulus_pa();
        let full_pa = contact_modulus_pa * surfaces.rms_gradient(&*surfaces.relief(0)?);
        let load = 1e6 * self.pressure_mpa / full_pa;
        let pressed = load.max(LIGHTEST[usize::from(is_map)]);
        let press = |load: f64| {
            let (nominal_pressure_pa, saturation_pa) = (load * full_pa, material.hardness_pa());
            let tolerance = TOLERANCE;
            known(&surfaces, &Loading { contact_modulus_pa, nominal_pressure_pa, saturation_pa, tolerance })
        };
        let (area, flowing) = press(pressed)?;
        // Below the load that is pressed, A/p rises at most as from ten times that load to it, and at most to its limit.
        let mut rise = 0.0;
        if load < pressed {
            let of_decade = (10.0 * area.value / press(10.0 * pressed)?.0.value).ln();
            let most = (LIGHT_LIMIT * pressed / area.value).ln();
            rise = (of_decade * (pressed / load).log10()).min(most).max(0.0);
        }
        let points = surfaces.points().map_or(1, |[rows, columns]| rows * columns) as f64;
        let scatter =
            if is_map { (area.value * points).sqrt().recip() } else { area.standard_error / area.value };
        Ok(SceneRow {
            pressure_over_gradient: digits(load),
            flowing: digits(flowing),
            truth: digits(area.value * load / pressed * (0.5 * rise).exp()),
            truth_error: digits(GRID_ERROR.hypot(scatter).hypot(0.25 * rise)),
            ..self
        })
    }

    /// Asks a program for its report on a file of a folder.
    ///
    /// # Errors
    /// [`TrialError::Scene`] if it gives none.
    pub fn with_answer(self, program: &Path, folder: &Path) -> Result<Self, TrialError> {
        let out = std::env::temp_dir().join(format!("truearea-scene-{}", std::process::id()));
        let (file, shortest_m, _) = file_of(self.scene);
        let file = format!("{}:shortest={shortest_m:e}m", folder.join(file).display());
        let pressure = format!("{}MPa", self.pressure_mpa);
        let mut command = Command::new(program);
        command.args(["report", &file, "--material", &self.material, "--pressure", &pressure, "--out"]);
        let output = command.arg(&out).output().map_err(failed)?;
        if !output.status.success() {
            return Err(failed(String::from_utf8_lossy(&output.stderr)));
        }
        let text = std::fs::read(out.join("answer.json")).map_err(failed)?;
        std::fs::remove_dir_all(&out).map_err(failed)?;
        let answer: Value = serde_json::from_slice(&text).map_err(failed)?;
        let area = &answer["loads"][0]["area"];
        let number = |key: &str| area[key].as_f64().map(digits);
        let end = |key: &str| number(key).ok_or_else(|| failed(format!("no {key} in the answer")));
        let is_of_models = area["source"] == "models" || area["source"].get("model").is_some();
        let (low, high) = (end("low")?, end("high")?);
        Ok(SceneRow { area: number("area_fraction"), low, high, is_judged: !is_of_models, ..self })
    }

    /// True if the range, widened by two standard errors of the truth, holds the truth.
    fn holds(&self) -> bool {
        let centre = self.area.unwrap_or_else(|| (self.low * self.high).sqrt());
        let end = if self.truth < centre { self.low } else { self.high };
        (self.truth / centre).ln().abs() <= (end / centre).ln().hypot(2.0 * self.truth_error)
    }
}

fn failed(problem: impl ToString) -> TrialError {
    TrialError::Scene(problem.to_string())
}

/// Presses surfaces until their mean area fraction is known; with the share of the load that flows on the last.
fn known(surfaces: &Surfaces, loading: &Loading) -> Result<(Mean, f64), TrialError> {
    // No contact bears more than the bound.
    let least = loading.saturation_pa.map_or(0.0, |bound_pa| loading.nominal_pressure_pa / bound_pa);
    let press = |number: usize| -> Result<ContactNumbers, TrialError> {
        Ok(surfaces.relief(number)?.press(loading, &Unobserved)?.numbers)
    };
    let (mut areas, mut flowing) = (Vec::new(), 0.0);
    let mut mean = Mean { value: 0.0, standard_error: f64::INFINITY };
    while areas.len() < surfaces.count() && mean.standard_error > TRUTH_ERROR * mean.value {
        let count = BATCH.min(surfaces.count() - areas.len());
        for numbers in map_indices(count, |number| press(areas.len() + number)) {
            let numbers = numbers?;
            areas.push(numbers.area_fraction_corrected.max(least));
            flowing = if least > 0.0 { numbers.plastic_area_fraction / least } else { 0.0 };
        }
        mean = Mean::new(areas.iter().copied());
    }
    Ok((mean, flowing))
}

/// Gaussian surfaces with the whole of a spectrum.
fn random(spectrum: &AreaSpectrum) -> Result<Surfaces, TrialError> {
    let width = spectrum.longest_m() / spectrum.shortest_m();
    let holds = |grid: &&(usize, usize)| grid.0 as f64 >= POINTS_AND_LENGTHS * width;
    let (points, realisations) = *GRIDS.iter().find(holds).unwrap_or(&GRIDS[GRIDS.len() - 1]);
    let choices = RandomChoices { points, realisations, seed: SEED, ..RandomChoices::default() };
    Ok(Surfaces::Random(choices.surfaces(spectrum)?.0))
}

/// A map beside its mirror images, which repeats itself, without waves shorter than those that are trusted.
fn mirrored(file: &str, files: &BTreeMap<String, Vec<u8>>, shortest_m: f64) -> Result<Relief, TrialError> {
    let request = ScanRequest { path: file.to_owned(), ..ScanRequest::default() };
    let map = MapOfFile::read(&request, &files[file], files, &Recipe::default(), false)?.heights.map;
    let rows = map.heights_m().chunks_exact(map.columns());
    let wide: Vec<Vec<f64>> = rows.map(|row| row.iter().chain(row.iter().rev()).copied().collect()).collect();
    let heights_m: Vec<f64> = wide.iter().chain(wide.iter().rev()).flatten().copied().collect();
    let lengths_m =
        [2.0 * map.columns() as f64 * map.spacing_x_m(), 2.0 * map.rows() as f64 * map.spacing_y_m()];
    let spacing_m = map.spacing_x_m().max(map.spacing_y_m());
    let surface =
        MapWaves::new(&heights_m, 2 * map.columns(), lengths_m, true, shortest_m / spacing_m).surface();
    Ok(Relief {
        rows: surface.points_y,
        columns: surface.points_x,
        length_x_m: surface.length_x_m,
        length_y_m: surface.length_y_m,
        heights_m: surface.heights_m,
        boundary: Boundary::Periodic,
        is_missing: Vec::new(),
    })
}

/// Returns the page with a new table; its text is written by hand.
///
/// # Errors
/// [`TrialError::Page`] if the page lacks the section.
pub fn written(page: &str, rows: &[SceneRow]) -> Result<String, TrialError> {
    let line = |name: &str, wanted: &dyn Fn(&SceneRow) -> bool| {
        let of_line: Vec<&SceneRow> = rows.iter().filter(|row| wanted(row)).collect();
        let share = |has: fn(&SceneRow) -> bool| {
            format!("{} of {}", of_line.iter().filter(|row| has(row)).count(), of_line.len())
        };
        let mut widths: Vec<f64> = of_line.iter().map(|row| row.high / row.low).collect();
        widths.sort_by(f64::total_cmp);
        let median = widths.get(widths.len() / 2).copied().unwrap_or(f64::NAN);
        vec![name.to_owned(), share(|row| row.is_judged), share(SceneRow::holds), three_digits(median)]
    };
    let lines = [
        line("all", &|_| true),
        line("traces", &|row| !row.is_map),
        line("maps", &|row| row.is_map),
        line("less than 3 % of the load flows", &|row| row.flowing < 0.03),
        line("3 to 90 %", &|row| (0.03..=0.9).contains(&row.flowing)),
        line("more", &|row| row.flowing > 0.9),
    ];
    let contents = table(&["scenes", "judged", "range holds", "median high/low"], &lines);
    with_section(page, "scenes", &contents).map_err(TrialError::Page)
}
