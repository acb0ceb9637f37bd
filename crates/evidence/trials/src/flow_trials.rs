//! Trials of leaks by the effective medium and by the last channel against flow through the gaps of elements: a table of
//! `docs/develop/trials.md`.

use std::sync::Mutex;

use elements::{Boundary, ContactField, ImposedLoad, Pressing, Relief, Surfaces, press};
use interface::OutOfBounds;
use interface::leak::{LeakRate, SealedJoint};
use interface::sealed_fluid::SealedFluid;
use numerics::parallel::Unobserved;
use scene::{Overrides, Scene};
use serde::{Deserialize, Serialize};
use spectrum::random_surfaces::{AreaSpectrum, Phases, Synthesis};
use study::interface::{Quantity, Slot};
use tables::markdown::{table, with_section};
use transport::GapField;
use transport::flow::{Ends, FlowDirection, solve};

use units::display::three_digits;

use crate::TrialError;
use crate::elements::digits;
use crate::judge_spectra::Set;
use crate::spectra::{BOX_M, CONTACT_MODULUS_PA, TrialLoad, WaveBand};

/// Loads p/(E* h') of the trials, from an area of 0.02 to one of 0.4.
const LOADS: [f64; 8] = [0.01, 0.025, 0.05, 0.08, 0.11, 0.14, 0.17, 0.205];
/// Loads of the lines for narrow boxes and stretched waves.
const NARROW_LOADS: [f64; 2] = [0.025, 0.08];
const BOTH: [FlowDirection; 2] = [FlowDirection::X, FlowDirection::Y];
/// Surfaces of each trial.
const SURFACES: u64 = 4;

/// Surfaces of a spectrum, stretched along x.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FlowTrial {
    /// Hurst exponent H.
    pub hurst_exponent: f64,
    /// Longest wavelength, in waves per box.
    pub first_wave: f64,
    /// Roll-off, in waves per box.
    pub rolloff_wave: f64,
    /// Shortest wavelength, in waves per box.
    pub last_wave: f64,
    /// Length of the waves along x over that along y.
    pub stretch: f64,
    /// Points along a side.
    pub grid: usize,
}

/// Flow through one surface along one direction under one load, and what closed forms say of its spectrum.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FlowRow {
    /// Hurst exponent H.
    pub hurst_exponent: f64,
    /// Longest wavelength, in waves per box.
    pub first_wave: f64,
    /// Roll-off, in waves per box.
    pub rolloff_wave: f64,
    /// Shortest wavelength, in waves per box.
    pub last_wave: f64,
    /// Length of the waves along x over that along y.
    pub stretch: f64,
    /// Points along a side.
    pub grid: usize,
    /// Number of the surface.
    pub surface: usize,
    /// Load p/(E* h').
    pub pressure_over_gradient: f64,
    /// Share in contact of the elements.
    pub area_fraction: f64,
    /// Mean gap of the elements \[m\].
    pub gap_m: f64,
    /// Flow factor along x.
    pub flow_factor_x: f64,
    /// Flow factor along y.
    pub flow_factor_y: f64,
    /// Share in contact by the theory.
    pub area_by_theory: f64,
    /// Mean gap by the theory \[m\].
    pub gap_by_theory_m: f64,
    /// Cube of the gap of the effective medium \[m^3\].
    pub medium_m3: f64,
    /// Mean cube of the gap by the theory \[m^3\].
    #[serde(default)]
    pub parallel_m3: f64,
    /// Cube of the gap of Bruggeman's medium \[m^3\].
    pub bruggeman_m3: f64,
    /// Narrowest place of the last channel \[m\].
    pub channel_m: f64,
}

/// Bands of waves per box: longest, roll-off, shortest.
type Bands = &'static [[f64; 3]];

/// Twelve spectra in boxes of at least four longest waves, and some in narrower ones: those by which the range of leaks was chosen, or
/// those that were pressed afterwards. Waves of the last four are stretched.
#[must_use]
pub fn trials(set: Set) -> Vec<FlowTrial> {
    const WIDE: [Bands; 2] = [
        &[[4.0, 4.0, 64.0], [4.0, 4.0, 128.0], [4.0, 16.0, 128.0], [8.0, 8.0, 128.0]],
        &[[4.0, 4.0, 96.0], [5.0, 5.0, 128.0], [4.0, 10.0, 128.0], [6.0, 12.0, 96.0]],
    ];
    const NARROW: [Bands; 2] =
        [&[[2.0, 2.0, 64.0], [2.0, 2.0, 128.0]], &[[2.0, 2.0, 96.0], [3.0, 3.0, 96.0]]];
    const STRETCHED: Bands = &[[4.0, 4.0, 96.0], [4.0, 12.0, 96.0]];
    let of = |hurst_exponents: &'static [f64], bands: Bands, stretch: f64| {
        hurst_exponents.iter().flat_map(move |&hurst_exponent| {
            bands.iter().map(move |&[first_wave, rolloff_wave, last_wave]| FlowTrial {
                hurst_exponent,
                first_wave,
                rolloff_wave,
                last_wave,
                stretch,
                grid: 512,
            })
        })
    };
    match set {
        Set::Calibration => {
            of(&[0.35, 0.6, 0.85], WIDE[0], 1.0).chain(of(&[0.6, 0.85], NARROW[0], 1.0)).collect()
        }
        Set::Report => of(&[0.5, 0.75, 0.95], WIDE[1], 1.0)
            .chain(of(&[0.5, 0.75, 0.95], NARROW[1], 1.0))
            .chain(of(&[0.6, 0.85], STRETCHED, 4.0))
            .collect(),
    }
}

impl FlowRow {
    /// Cube of the parallel slot that lets as much through along a direction \[m^3\].
    fn cube_m3(&self, along: FlowDirection) -> f64 {
        let factor = if along == FlowDirection::X { self.flow_factor_x } else { self.flow_factor_y };
        factor * self.gap_m.powi(3)
    }

    /// Returns true if four of the longest waves fit into the box.
    fn is_wide(&self) -> bool {
        self.first_wave >= 4.0
    }

    /// Range of the leak rate of the program, of a square joint that passes the cube of its gap.
    fn range(&self) -> Result<LeakRate, OutOfBounds> {
        let fluid = SealedFluid::Incompressible { viscosity_pa_s: 1.0 / 12.0 };
        let joint = SealedJoint::new(self.first_wave, self.first_wave, 1.0, fluid)?;
        Ok(joint.leak_rate([self.medium_m3, self.parallel_m3], self.area_by_theory, 1.0))
    }

    /// The trial to which the row belongs.
    #[must_use]
    pub fn trial(&self) -> FlowTrial {
        let Self { hurst_exponent, first_wave, rolloff_wave, last_wave, stretch, grid, .. } = *self;
        FlowTrial { hurst_exponent, first_wave, rolloff_wave, last_wave, stretch, grid }
    }
}

impl FlowTrial {
    fn band(&self) -> WaveBand {
        let Self { hurst_exponent, first_wave, rolloff_wave, last_wave, .. } = *self;
        WaveBand { hurst_exponent, first_wave, rolloff_wave, last_wave }
    }

    /// Presses the surfaces, solves the flow, and puts the closed forms beside it.
    ///
    /// # Errors
    /// The error of making or pressing a surface, of the flow, and of the scene.
    pub fn rows(&self) -> Result<Vec<FlowRow>, TrialError> {
        let spectrum = self.band().spectrum()?;
        let synthesis = Synthesis::square(self.grid, BOX_M, 55, Phases::default());
        let relief = |number| {
            Ok(Relief {
                rows: self.grid,
                columns: self.grid,
                length_x_m: BOX_M * self.stretch,
                length_y_m: BOX_M,
                heights_m: spectrum.surface(&synthesis, number)?.heights_m,
                boundary: Boundary::Periodic,
                is_missing: Vec::new(),
            })
        };
        let surfaces = (0..SURFACES).map(relief).collect::<Result<Vec<_>, TrialError>>()?;
        let loads = LOADS.map(|load| TrialLoad::elastic(load).nominal_pressure_pa());
        let pressing = Pressing {
            loads: loads.map(ImposedLoad::PressurePa).to_vec(),
            ..Pressing::elastic(CONTACT_MODULUS_PA)
        };
        let rows = Mutex::new(Vec::new());
        let see = |field: &ContactField<'_>| {
            let gap = GapField::from_contact(field)?;
            let factor = |along| {
                Ok::<f64, TrialError>(digits(solve(&gap, along, Ends::Periodic, &Unobserved)?.flow_factor))
            };
            let row = FlowRow {
                hurst_exponent: self.hurst_exponent,
                first_wave: self.first_wave,
                rolloff_wave: self.rolloff_wave,
                last_wave: self.last_wave,
                stretch: self.stretch,
                grid: self.grid,
                surface: field.surface,
                pressure_over_gradient: LOADS[field.load],
                area_fraction: digits(gap.closed_share()),
                gap_m: digits(gap.mean_gap_m()),
                flow_factor_x: factor(FlowDirection::X)?,
                flow_factor_y: factor(FlowDirection::Y)?,
                area_by_theory: 0.0,
                gap_by_theory_m: 0.0,
                medium_m3: 0.0,
                parallel_m3: 0.0,
                bruggeman_m3: 0.0,
                channel_m: 0.0,
            };
            if let Ok(mut rows) = rows.lock() {
                rows.push(row);
            }
            Ok(())
        };
        press::<TrialError>(&Surfaces::Maps(surfaces), &pressing, see, &Unobserved)?;
        let mut rows = rows.into_inner().unwrap_or_default();
        let load = |row: &FlowRow| LOADS.iter().position(|load| *load == row.pressure_over_gradient);
        rows.sort_by_key(|row| (load(row), row.surface));
        self.beside(&rows)
    }

    /// Puts the closed forms of today beside the flows of the rows.
    ///
    /// # Errors
    /// The error of the scene.
    pub fn beside(&self, rows: &[FlowRow]) -> Result<Vec<FlowRow>, TrialError> {
        let spectrum = self.band().spectrum()?;
        let [scene, bruggeman] = [self.scene(&spectrum, 0.42)?, self.scene(&spectrum, 0.5)?];
        let (results, same) = (scene.plan().compute()?, bruggeman.plan().compute()?);
        let nothing = || TrialError::Scene("the spectrum has no moments".to_owned());
        let states = scene.interface_states(&results).ok_or_else(nothing)?;
        let bruggeman = bruggeman.interface_states(&same).ok_or_else(nothing)?;
        let beside = |row: &FlowRow| -> Result<FlowRow, TrialError> {
            let load =
                LOADS.iter().position(|load| *load == row.pressure_over_gradient).ok_or_else(nothing)?;
            let value = |quantity| states.value(Slot { quantity, load: Some(load), curve: None });
            Ok(FlowRow {
                area_by_theory: digits(states.sealing_area_fraction(load).unwrap_or(1.0)),
                gap_by_theory_m: digits(value(Quantity::MeanGap)?.unwrap_or(0.0)),
                medium_m3: digits(states.seal_conductance(load).map_or(0.0, |gaps| gaps.medium_m3)),
                parallel_m3: digits(states.seal_conductance(load).map_or(0.0, |gaps| gaps.parallel_m3)),
                bruggeman_m3: digits(bruggeman.seal_conductance(load).map_or(0.0, |gaps| gaps.medium_m3)),
                channel_m: digits(value(Quantity::ChannelHeight)?.unwrap_or(0.0)),
                ..*row
            })
        };
        rows.iter().map(beside).collect()
    }

    /// Scene of the spectrum, whose waves count with the root mean square of their gradients along x and y.
    fn scene(&self, spectrum: &AreaSpectrum, threshold: f64) -> Result<Scene, TrialError> {
        let shorter = (0.5 * (1.0 + self.stretch.powi(-2))).sqrt();
        let file = self.band().file(spectrum, shorter)?;
        let pressures: Vec<String> = LOADS
            .iter()
            .map(|load| format!("\"{} Pa\"", TrialLoad::elastic(*load).nominal_pressure_pa()))
            .collect();
        let text = format!(
            "[surface]\npsd = \"s.csv\"\n[material]\nyoungs_modulus = \"{CONTACT_MODULUS_PA} Pa\"\npoisson_ratio = 0\n[loads]\n\
             pressures = [{}]\n[interface]\nband = \"2d\"\n[seal]\n\
             percolation_threshold = {threshold}\n",
            pressures.join(", "),
        );
        Scene::parse(&text, &file, &Overrides::default())
            .map_err(|error| TrialError::Scene(error.to_string()))
    }
}

/// Returns the page with its table of leaks.
///
/// # Errors
/// [`TrialError`] if the page lacks the section, or a range has no joint.
pub fn written(page: &str, rows: &[FlowRow]) -> Result<String, TrialError> {
    let reported = trials(Set::Report);
    let rows: Vec<&FlowRow> = rows.iter().filter(|row| reported.contains(&row.trial())).collect();
    let mut lines = Vec::new();
    for load in LOADS {
        let of_load =
            |row: &&FlowRow| row.pressure_over_gradient == load && row.is_wide() && row.stretch == 1.0;
        lines.push(line("four waves or more", &select(&rows, of_load), &BOTH)?);
    }
    for load in NARROW_LOADS {
        let of_load = |row: &&FlowRow| row.pressure_over_gradient == load && !row.is_wide();
        lines.push(line("two and three waves", &select(&rows, of_load), &BOTH)?);
    }
    for load in NARROW_LOADS {
        let of_load = |row: &&FlowRow| row.pressure_over_gradient == load && row.stretch > 1.0;
        let of_load = select(&rows, of_load);
        lines.push(line("1 : 4, along the waves", &of_load, &[FlowDirection::X])?);
        lines.push(line("1 : 4, across", &of_load, &[FlowDirection::Y])?);
    }
    let headings = ["surfaces", "A", "medium", "d = 2", "last channel", "inside", "high/low"];
    with_section(page, "flow", &table(&headings, &lines)).map_err(TrialError::Page)
}

fn select<'r>(rows: &[&'r FlowRow], is_of: impl Fn(&&FlowRow) -> bool) -> Vec<&'r FlowRow> {
    rows.iter().copied().filter(|row| is_of(row)).collect()
}

/// Line of the table: closed forms over solved flow along directions, and the flows inside the range.
fn line(name: &str, rows: &[&FlowRow], directions: &[FlowDirection]) -> Result<Vec<String>, TrialError> {
    let flows = |of: fn(&FlowRow) -> f64| -> String {
        let over = rows.iter().flat_map(|row| directions.iter().map(|along| of(row) / row.cube_m3(*along)));
        let mut over: Vec<f64> = over.collect();
        over.sort_by(f64::total_cmp);
        let ends = [over.first(), over.get(over.len() / 2), over.last()]
            .map(|end| end.filter(|end| end.is_finite()).map_or("∞".to_owned(), |end| three_digits(*end)));
        format!("{} to {} ({})", ends[0], ends[2], ends[1])
    };
    let (mut inside, mut all, mut widest) = (0, 0, 0.0f64);
    for row in rows {
        let LeakRate { low_m3_per_s, high_m3_per_s } = row.range()?;
        widest = widest.max(high_m3_per_s / low_m3_per_s);
        for along in directions {
            all += 1;
            inside += usize::from((low_m3_per_s..=high_m3_per_s).contains(&row.cube_m3(*along)));
        }
    }
    let area = rows.iter().map(|row| row.area_by_theory).sum::<f64>() / rows.len() as f64;
    Ok(vec![
        name.to_owned(),
        three_digits(area),
        flows(|row| row.medium_m3),
        flows(|row| row.bruggeman_m3),
        flows(|row| row.channel_m.powi(3)),
        format!("{inside} of {all}"),
        three_digits(widest),
    ])
}
