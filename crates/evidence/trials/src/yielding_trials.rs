//! Trials of gap and stiffness after yielding: closed forms against elements with a saturation: a table of `docs/develop/trials.md`.

use elements::half_space::ContactNumbers;
use elements::{Boundary, ElementsError, ImposedLoad, Pressing, Relief, Surfaces, press};
use interface::conductance::{Conductivities, CutSurface, PlasticCorrelation, PressureRatio};
use interface::gas::plastic_separation_m;
use numerics::parallel::Unobserved;
use persson::EnergyFactor;
use persson::separation::SeparationLaw;
use persson::yielding::{SpotFactor, YieldingLaw};
use scene::{Overrides, Scene};
use serde::{Deserialize, Serialize};
use spectrum::random_surfaces::{Phases, Synthesis};
use tables::markdown::{table, with_section};
use units::display::three_digits;

use crate::TrialError;
use crate::elements::digits;
use crate::judge_spectra::Set;
use crate::spectra::{BOX_M, CONTACT_MODULUS_PA, RMS_GRADIENT, WaveBand};
use crate::statistics::mean_and_relative_error;

/// Surfaces of each trial.
const SURFACES: u64 = 4;

/// Surfaces of a spectrum, with their hardnesses and loads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct YieldingTrial {
    /// Spectrum of the surfaces.
    pub band: WaveBand,
    /// Points along a side.
    pub grid: usize,
    /// Hardnesses H/(E* h').
    pub hardnesses_over_gradient: [f64; 3],
    /// Loads over the hardness.
    pub loads_over_hardness: [f64; 4],
    seed: u64,
}

/// Means over the surfaces of a spectrum of one hardness under one load.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct YieldingRow {
    /// Hurst exponent H.
    pub hurst_exponent: f64,
    /// Longest wavelength, in waves per box.
    pub first_wave: f64,
    /// Roll-off, in waves per box.
    pub rolloff_wave: f64,
    /// Shortest wavelength, in waves per box.
    pub last_wave: f64,
    /// Points along a side.
    pub grid: usize,
    /// Hardness H/(E* h').
    pub hardness_over_gradient: f64,
    /// Load over the hardness.
    pub load_over_hardness: f64,
    /// Share in contact of the elements.
    pub area_fraction: f64,
    /// Share of that contact that has flowed.
    pub flowed_share: f64,
    /// Mean gap of the elements \[m\].
    pub gap_m: f64,
    /// Its relative standard error.
    pub gap_error: f64,
    /// Mean depth that has flowed \[m\].
    pub plastic_depth_m: f64,
    /// Stiffness of unloading of the elements \[Pa/m\].
    pub stiffness_pa_per_m: f64,
    /// Its relative standard error.
    pub stiffness_error: f64,
    /// Gap of the closed form over that of the elements.
    #[serde(default)]
    pub gap: f64,
    /// Distance of the mean planes of the closed form less that of the elements, over the rms height.
    #[serde(default)]
    pub plane_distance: f64,
    /// Stiffness of the closed form over that of the elements.
    #[serde(default)]
    pub stiffness: f64,
    /// Gap of the elastic theory.
    #[serde(default)]
    pub gap_elastic: f64,
    /// Stiffness of the elastic theory.
    #[serde(default)]
    pub stiffness_elastic: f64,
    /// Gap of Yovanovich, of peaks that flow and do not bend.
    #[serde(default)]
    pub gap_yovanovich: f64,
    /// Stiffness of the conductance by Yovanovich's correlation.
    #[serde(default)]
    pub stiffness_yovanovich: f64,
    /// Stiffness of the conductance by the correlation of Cooper, Mikic & Yovanovich.
    #[serde(default)]
    pub stiffness_cooper: f64,
}

/// Spectra: 48 on which the closed form was chosen, or 24 that were pressed afterwards.
#[must_use]
pub fn trials(set: Set) -> Vec<YieldingTrial> {
    /// Bands of waves per box: longest, roll-off, shortest.
    type Bands = [[f64; 3]; 6];
    let of = |hurst_exponents: [f64; 4], bands: Bands, like: YieldingTrial, other: [f64; 3]| {
        bands.into_iter().enumerate().flat_map(move |(at, [first_wave, rolloff_wave, last_wave])| {
            hurst_exponents.into_iter().enumerate().map(move |(number, hurst_exponent)| YieldingTrial {
                band: WaveBand { hurst_exponent, first_wave, rolloff_wave, last_wave },
                grid: if last_wave > 128.0 { 1024 } else { like.grid },
                // Every second spectrum has the other hardnesses.
                hardnesses_over_gradient: match (at + number) % 2 {
                    0 => like.hardnesses_over_gradient,
                    _ => other,
                },
                ..like
            })
        })
    };
    let chosen_on = YieldingTrial {
        band: WaveBand { hurst_exponent: 0.0, first_wave: 0.0, rolloff_wave: 0.0, last_wave: 0.0 },
        grid: 512,
        hardnesses_over_gradient: [0.6, 0.2, 0.06],
        loads_over_hardness: [0.006, 0.02, 0.07, 0.25],
        seed: 56,
    };
    if set == Set::Calibration {
        const FIRST: Bands = [
            [4.0, 4.0, 64.0],
            [4.0, 4.0, 128.0],
            [4.0, 12.0, 128.0],
            [3.0, 3.0, 96.0],
            [4.0, 24.0, 128.0],
            [4.0, 4.0, 256.0],
        ];
        const SECOND: Bands = [
            [4.0, 4.0, 96.0],
            [5.0, 5.0, 128.0],
            [4.0, 8.0, 128.0],
            [4.0, 16.0, 96.0],
            [3.0, 3.0, 128.0],
            [5.0, 5.0, 256.0],
        ];
        let other = [0.35, 0.12, 0.025];
        let first = of([0.35, 0.6, 0.75, 0.9], FIRST, chosen_on, other);
        return first.chain(of([0.45, 0.55, 0.7, 0.85], SECOND, chosen_on, other)).collect();
    }
    // Eight points a wave, where those above have four or more.
    const REPORTED: Bands = [
        [4.0, 4.0, 112.0],
        [6.0, 6.0, 128.0],
        [4.0, 9.0, 112.0],
        [4.0, 32.0, 128.0],
        [3.0, 3.0, 80.0],
        [3.0, 6.0, 256.0],
    ];
    let reported = YieldingTrial {
        grid: 1024,
        hardnesses_over_gradient: [0.9, 0.3, 0.08],
        loads_over_hardness: [0.005, 0.015, 0.05, 0.35],
        seed: 57,
        ..chosen_on
    };
    of([0.3, 0.5, 0.8, 0.95], REPORTED, reported, [0.5, 0.15, 0.03]).collect()
}

impl YieldingRow {
    /// Spectrum and grid.
    #[must_use]
    pub fn spectrum(&self) -> (WaveBand, usize) {
        let Self { hurst_exponent, first_wave, rolloff_wave, last_wave, grid, .. } = *self;
        (WaveBand { hurst_exponent, first_wave, rolloff_wave, last_wave }, grid)
    }
}

impl YieldingTrial {
    /// Spectrum and grid.
    #[must_use]
    pub fn spectrum(&self) -> (WaveBand, usize) {
        (self.band, self.grid)
    }

    /// Presses the surfaces under every load of every hardness.
    ///
    /// # Errors
    /// The error of making or pressing a surface.
    pub fn rows(&self) -> Result<Vec<YieldingRow>, TrialError> {
        let spectrum = self.band.spectrum()?;
        let synthesis = Synthesis::square(self.grid, BOX_M, self.seed, Phases::default());
        let relief = |number| {
            Ok(Relief {
                rows: self.grid,
                columns: self.grid,
                length_x_m: BOX_M,
                length_y_m: BOX_M,
                heights_m: spectrum.surface(&synthesis, number)?.heights_m,
                boundary: Boundary::Periodic,
                is_missing: Vec::new(),
            })
        };
        let surfaces = Surfaces::Maps((0..SURFACES).map(relief).collect::<Result<Vec<_>, TrialError>>()?);
        let mut rows = Vec::new();
        for hardness_over_gradient in self.hardnesses_over_gradient {
            let hardness_pa = hardness_over_gradient * CONTACT_MODULUS_PA * RMS_GRADIENT;
            let loads = self.loads_over_hardness.map(|share| ImposedLoad::PressurePa(share * hardness_pa));
            let pressing = Pressing {
                loads: loads.to_vec(),
                saturation_pa: Some(hardness_pa),
                stiffness: true,
                ..Pressing::elastic(CONTACT_MODULUS_PA)
            };
            let pressed = press::<ElementsError>(&surfaces, &pressing, |_| Ok(()), &Unobserved)?;
            for (load_over_hardness, load) in self.loads_over_hardness.into_iter().zip(&pressed) {
                let numbers = |of: fn(&ContactNumbers) -> f64| {
                    mean_and_relative_error(load.states.iter().map(|state| of(&state.numbers)))
                };
                let (gap_m, gap_error) = numbers(|numbers| numbers.mean_gap_m);
                let (area_fraction, _) = numbers(|numbers| numbers.area_fraction);
                let (flowed, _) = numbers(|numbers| numbers.plastic_area_fraction);
                let (stiffness_pa_per_m, stiffness_error) =
                    mean_and_relative_error(load.states.iter().filter_map(|state| state.stiffness_pa_per_m));
                rows.push(YieldingRow {
                    hurst_exponent: self.band.hurst_exponent,
                    first_wave: self.band.first_wave,
                    rolloff_wave: self.band.rolloff_wave,
                    last_wave: self.band.last_wave,
                    grid: self.grid,
                    hardness_over_gradient,
                    load_over_hardness,
                    area_fraction: digits(area_fraction),
                    flowed_share: digits(flowed / area_fraction),
                    gap_m: digits(gap_m),
                    gap_error: digits(gap_error),
                    plastic_depth_m: digits(numbers(|numbers| numbers.mean_plastic_depth_m).0),
                    stiffness_pa_per_m: digits(stiffness_pa_per_m),
                    stiffness_error: digits(stiffness_error),
                    ..YieldingRow::default()
                });
            }
        }
        self.beside(&rows)
    }

    /// Puts the closed forms of today beside the elements of the rows.
    ///
    /// # Errors
    /// The error of the scene, and of numbers out of their bounds.
    pub fn beside(&self, rows: &[YieldingRow]) -> Result<Vec<YieldingRow>, TrialError> {
        let spectrum = self.band.spectrum()?;
        let text = format!(
            "[surface]\npsd = \"s.csv\"\n[material]\nyoungs_modulus = \"{CONTACT_MODULUS_PA} Pa\"\npoisson_ratio = 0\n\
             [loads]\npressures = [\"1 Pa\"]\n[interface]\n"
        );
        let scene = Scene::parse(&text, &self.band.file(&spectrum, 1.0)?, &Overrides::default())
            .map_err(|error| TrialError::Scene(error.to_string()))?;
        let results = scene.plan().compute()?;
        let nothing = || TrialError::Scene("the spectrum has no moments".to_owned());
        let states = scene.interface_states(&results).ok_or_else(nothing)?;
        let elastic =
            SeparationLaw::from_roughness(states.roughness(), CONTACT_MODULUS_PA, EnergyFactor::default());
        let last = states.roughness().places().last().ok_or_else(nothing)?;
        let law = YieldingLaw::new(&elastic, last.variance_pa2(CONTACT_MODULUS_PA).sqrt());
        let rms_height_m = states.rms_height_m();
        let surface = CutSurface::new(rms_height_m, states.mean_absolute_slope()?)?;
        let conductivities = Conductivities::new(1.0, 1.0)?;
        let beside = |row: &YieldingRow| -> Result<YieldingRow, TrialError> {
            let hardness_pa = row.hardness_over_gradient * CONTACT_MODULUS_PA * RMS_GRADIENT;
            let pressure_pa = row.load_over_hardness * hardness_pa;
            let yielded = law.at(pressure_pa, hardness_pa, &SpotFactor::new()).ok_or_else(nothing)?;
            let of_elastic = elastic.whole(pressure_pa);
            let ratio = PressureRatio::new(pressure_pa, hardness_pa)?;
            // Barber's analogy, K = h E*/k.
            let by = |correlation: PlasticCorrelation| {
                let conductance = correlation.conductance_w_per_m2_k(&conductivities, &surface, ratio);
                digits(CONTACT_MODULUS_PA * conductance / row.stiffness_pa_per_m)
            };
            let apart_m = yielded.gap.mean_plane_distance_m - (row.gap_m - row.plastic_depth_m);
            Ok(YieldingRow {
                gap: digits(yielded.gap.mean_gap_m / row.gap_m),
                plane_distance: digits(apart_m / rms_height_m),
                stiffness: digits(yielded.unloading_stiffness_pa_per_m / row.stiffness_pa_per_m),
                gap_elastic: digits(of_elastic.mean_gap_m / row.gap_m),
                stiffness_elastic: digits(of_elastic.stiffness_pa_per_m / row.stiffness_pa_per_m),
                gap_yovanovich: digits(plastic_separation_m(rms_height_m, ratio).unwrap_or(0.0) / row.gap_m),
                stiffness_yovanovich: by(PlasticCorrelation::Yovanovich),
                stiffness_cooper: by(PlasticCorrelation::CooperMikicYovanovich),
                ..*row
            })
        };
        rows.iter().map(beside).collect()
    }
}

/// Returns the page with its table of gaps and stiffnesses after yielding.
///
/// # Errors
/// [`TrialError::Page`] if the page lacks the section.
pub fn written(page: &str, rows: &[YieldingRow]) -> Result<String, TrialError> {
    /// Shares of the contact that have flowed.
    const SHARES: [[f64; 2]; 5] = [[0.0, 0.3], [0.3, 0.6], [0.6, 0.9], [0.9, 0.97], [0.97, 1.0]];
    let of_set = |set: Set| {
        let spectra: Vec<_> = trials(set).iter().map(YieldingTrial::spectrum).collect();
        rows.iter().filter(|row| spectra.contains(&row.spectrum())).collect::<Vec<&YieldingRow>>()
    };
    let reported = of_set(Set::Report);
    let mut lines = Vec::new();
    let mut add = |name: String, rows: &[&YieldingRow]| {
        let of = |value: fn(&YieldingRow) -> f64| spread(rows.iter().map(|row| value(row)));
        lines.push(vec![
            name,
            rows.len().to_string(),
            of(|row| row.stiffness),
            of(|row| row.stiffness_elastic),
            of(|row| row.stiffness_cooper),
            of(|row| row.stiffness_yovanovich),
            of(|row| row.gap),
            of(|row| row.gap_elastic),
            of(|row| row.gap_yovanovich),
        ]);
    };
    add("chosen on".to_owned(), &of_set(Set::Calibration));
    add("reported".to_owned(), &reported);
    for [from, to] in SHARES {
        let is_in = |row: &&YieldingRow| from <= row.flowed_share && row.flowed_share < to;
        let of_line: Vec<&YieldingRow> = reported.iter().copied().filter(is_in).collect();
        add(format!("{} to {} % has flowed", 100.0 * from, 100.0 * to), &of_line);
    }
    let mut hardnesses: Vec<f64> = reported.iter().map(|row| row.hardness_over_gradient).collect();
    hardnesses.sort_by(|soft, hard| hard.total_cmp(soft));
    hardnesses.dedup();
    for hardness in hardnesses {
        let is_of = |row: &&YieldingRow| row.hardness_over_gradient == hardness;
        let of_line: Vec<&YieldingRow> = reported.iter().copied().filter(is_of).collect();
        add(format!("H = {hardness} E\\* h'"), &of_line);
    }
    let headings = [
        "spectra",
        "states",
        "K",
        "K, elastic",
        "K, Cooper",
        "K, Yovanovich",
        "u",
        "u, elastic",
        "u, Yovanovich",
    ];
    with_section(page, "yielding", &table(&headings, &lines)).map_err(TrialError::Page)
}

/// Root mean square of the logarithms of some ratios in per cent, and the least and the largest: `9 % 0.83–1.12`.
fn spread(ratios: impl Iterator<Item = f64> + Clone) -> String {
    let square: f64 = ratios.clone().map(|ratio| ratio.ln().powi(2)).sum();
    let root = (square / ratios.clone().count() as f64).sqrt();
    let [least, largest] = ratios
        .fold([f64::INFINITY, 0.0f64], |[least, largest], ratio| [least.min(ratio), largest.max(ratio)]);
    format!("{:.0} % {}–{}", 100.0 * root, three_digits(least), three_digits(largest))
}
