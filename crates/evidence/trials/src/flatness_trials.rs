//! Trials of both limits of flatness against elements on surfaces with a real long wave: a table of `docs/develop/trials.md`.

use std::f64::consts::TAU;
use std::sync::Mutex;

use conclusions::flatness_within;
use elements::{Boundary, ContactField, ElementsError, ImposedLoad, Pressing, Relief, Surfaces, press};
use numerics::parallel::Unobserved;
use scene::{Overrides, Scene};
use serde::{Deserialize, Serialize};
use spectrum::random_surfaces::{AreaSpectrum, Phases, Synthesis};
use study::interface::{FlatnessRange, Quantity, Slot};
use tables::markdown::{table, with_section};
use units::display::three_digits;

use crate::TrialError;
use crate::elements::digits;
use crate::judge_spectra::Set;
use crate::spectra::{BOX_M, CONTACT_MODULUS_PA, TrialLoad, WaveBand};

/// Loads p/(E* h').
const LOADS: [f64; 4] = [0.002, 0.01, 0.04, 0.12];
const POINTS: usize = 512;
/// Surfaces of each trial.
const SURFACES: u64 = 2;
/// Conductivity of both bodies and of the gas \[W/(m K)\], and the parameter M of the gas \[m\]: spots and gas conduct alike.
const CONDUCTIVITY_W_PER_M_K: f64 = 100.0;
const GAS_W_PER_M_K: f64 = 0.5;
const GAS_PARAMETER_M: f64 = 0.2e-6;

/// Form of a real deviation from a plane, of height H over a length L.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Form {
    /// One wave along x: the box is 2 L wide.
    Ridge,
    /// A wave along x and one along y: the box is L wide, and its dome falls by H to the corners.
    Dome,
}

impl Form {
    /// Length L \[m\].
    fn span_m(self) -> f64 {
        if self == Form::Ridge { 0.5 * BOX_M } else { BOX_M }
    }
}

/// Surface with a long wave.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FlatnessTrial {
    /// Hurst exponent of the roughness, whose longest wave is an eighth of the box.
    pub hurst_exponent: f64,
    /// Form of the long wave.
    pub form: Form,
    /// Root mean square height of a straight wave of its height over that of the roughness.
    pub wave_over_roughness: f64,
}

/// A quantity of the elements, of flat faces by the theory, and by both limits.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FlatnessRow {
    /// Hurst exponent.
    pub hurst_exponent: f64,
    /// Form of the long wave.
    pub form: Form,
    /// Root mean square height of the wave over that of the roughness.
    pub wave_over_roughness: f64,
    /// Load p/(E* h').
    pub pressure_over_gradient: f64,
    /// Name of the quantity.
    pub quantity: AskedOf,
    /// Value of the elements.
    pub elements: f64,
    /// Value of the theory for flat faces.
    pub flat: f64,
    /// Value with the deviation as a wave of the roughness.
    pub by_wave: f64,
    /// Value with the deviation as a cap.
    pub by_cap: f64,
}

/// Quantity that a trial compares.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum AskedOf {
    /// Mean gap \[m\].
    Gap,
    /// Stiffness \[Pa/m\].
    Stiffness,
    /// Heat through spots and gas \[W/(m^2 K)\].
    Heat,
}

impl AskedOf {
    const ALL: [AskedOf; 3] = [AskedOf::Gap, AskedOf::Stiffness, AskedOf::Heat];

    fn quantity(self) -> Quantity {
        match self {
            AskedOf::Gap => Quantity::MeanGap,
            AskedOf::Stiffness => Quantity::Stiffness,
            AskedOf::Heat => Quantity::ThermalConductanceWithGas,
        }
    }

    /// The factor, either way, within which the program takes its theory to hold for flat faces.
    fn within(self) -> f64 {
        if self == AskedOf::Gap { 1.15 } else { 1.25 }
    }

    fn words(self) -> &'static str {
        match self {
            AskedOf::Gap => "mean gap",
            AskedOf::Stiffness => "stiffness",
            AskedOf::Heat => "heat, with gas",
        }
    }
}

/// Twelve surfaces: those by which the error of the limits was chosen, or those that were pressed afterwards.
#[must_use]
pub fn trials(set: Set) -> Vec<FlatnessTrial> {
    let (hurst_exponents, waves) = match set {
        Set::Calibration => ([0.5, 0.8], [1.0, 3.0, 8.0]),
        Set::Report => ([0.65, 0.9], [1.5, 4.5, 10.0]),
    };
    let of_form = |form: Form| {
        hurst_exponents.into_iter().flat_map(move |hurst_exponent| {
            waves.map(|wave_over_roughness| FlatnessTrial { hurst_exponent, form, wave_over_roughness })
        })
    };
    [Form::Ridge, Form::Dome].into_iter().flat_map(of_form).collect()
}

impl FlatnessRow {
    /// Returns true if the row belongs to a trial.
    #[must_use]
    pub fn is_of(&self, trial: &FlatnessTrial) -> bool {
        let Self { hurst_exponent, form, wave_over_roughness, .. } = *self;
        *trial == FlatnessTrial { hurst_exponent, form, wave_over_roughness }
    }

    /// Both limits in rising order, each with the error of the theory.
    fn range(&self) -> [f64; 2] {
        let limits = FlatnessRange { by_wave: self.by_wave, by_cap: self.by_cap };
        let within = self.quantity.within().ln().hypot(flatness_within(self.flat, limits).ln()).exp();
        [self.by_wave.min(self.by_cap) / within, self.by_wave.max(self.by_cap) * within]
    }

    /// Returns true if the elements lie between both limits, each with its error.
    #[must_use]
    pub fn is_inside(&self) -> bool {
        (self.range()[0]..=self.range()[1]).contains(&self.elements)
    }

    fn wave_is_nearer(&self) -> bool {
        let off = |limit: f64| (limit / self.elements).ln().abs();
        off(self.by_wave) < off(self.by_cap)
    }
}

impl FlatnessTrial {
    fn band(&self) -> WaveBand {
        let hurst_exponent = self.hurst_exponent;
        WaveBand { hurst_exponent, first_wave: 8.0, rolloff_wave: 8.0, last_wave: 128.0 }
    }

    /// Presses the surfaces, and puts both limits beside them.
    ///
    /// # Errors
    /// The error of making or pressing a surface, and of the scene.
    pub fn rows(&self) -> Result<Vec<FlatnessRow>, TrialError> {
        let spectrum = self.band().spectrum()?;
        let height_m = self.height_m(&spectrum);
        let synthesis = Synthesis::square(POINTS, BOX_M, 54, Phases::default());
        let surfaces = (0..SURFACES)
            .map(|number| Ok(self.relief(spectrum.surface(&synthesis, number)?.heights_m, height_m)))
            .collect::<Result<Vec<_>, TrialError>>()?;
        let loads = LOADS.map(|load| TrialLoad::elastic(load).nominal_pressure_pa());
        let pressing = Pressing {
            loads: loads.map(ImposedLoad::PressurePa).to_vec(),
            stiffness: true,
            ..Pressing::elastic(CONTACT_MODULUS_PA)
        };
        let gas = Mutex::new(vec![0.0; LOADS.len()]);
        let see = |field: &ContactField<'_>| {
            let open = field.gaps_m.iter().filter(|gap_m| **gap_m > 0.0);
            let sum: f64 = open.map(|gap_m| GAS_W_PER_M_K / (gap_m + GAS_PARAMETER_M)).sum();
            if let Ok(mut gas) = gas.lock() {
                gas[field.load] += sum / (field.gaps_m.len() as f64 * SURFACES as f64);
            }
            Ok(())
        };
        let pressed = press::<ElementsError>(&Surfaces::Maps(surfaces), &pressing, see, &Unobserved)?;
        let gas = gas.into_inner().unwrap_or_default();
        let mut rows = Vec::new();
        for ((pressed, gas), load) in pressed.iter().zip(gas).zip(LOADS) {
            let count = pressed.states.len() as f64;
            let gap_m = pressed.states.iter().map(|state| state.numbers.mean_gap_m).sum::<f64>() / count;
            let stiffness =
                pressed.states.iter().filter_map(|state| state.stiffness_pa_per_m).sum::<f64>() / count;
            let heat = stiffness / CONTACT_MODULUS_PA * CONDUCTIVITY_W_PER_M_K + gas;
            rows.extend(AskedOf::ALL.into_iter().zip([gap_m, stiffness, heat]).map(
                |(quantity, elements)| FlatnessRow {
                    hurst_exponent: self.hurst_exponent,
                    form: self.form,
                    wave_over_roughness: self.wave_over_roughness,
                    pressure_over_gradient: load,
                    quantity,
                    elements: digits(elements),
                    flat: 0.0,
                    by_wave: 0.0,
                    by_cap: 0.0,
                },
            ));
        }
        self.beside(&rows)
    }

    /// Puts the theory of today beside the elements of the rows.
    ///
    /// # Errors
    /// The error of the scene.
    pub fn beside(&self, rows: &[FlatnessRow]) -> Result<Vec<FlatnessRow>, TrialError> {
        let spectrum = self.band().spectrum()?;
        let loads = LOADS.map(|load| TrialLoad::elastic(load).nominal_pressure_pa());
        let scene = self.scene(&spectrum, self.height_m(&spectrum), &loads)?;
        let results = scene.plan().compute()?;
        let nothing = || TrialError::Scene("the spectrum has no moments".to_owned());
        let states = scene.interface_states(&results).ok_or_else(nothing)?;
        let beside = |row: &FlatnessRow| -> Result<FlatnessRow, TrialError> {
            let quantity = row.quantity.quantity();
            let load =
                LOADS.iter().position(|load| *load == row.pressure_over_gradient).ok_or_else(nothing)?;
            let flat = states.value(Slot { quantity, load: Some(load), curve: None })?.ok_or_else(nothing)?;
            let limits = states.with_flatness(quantity, load, flat)?.ok_or_else(nothing)?;
            let [flat, by_wave, by_cap] = [flat, limits.by_wave, limits.by_cap].map(digits);
            Ok(FlatnessRow { flat, by_wave, by_cap, ..*row })
        };
        rows.iter().map(beside).collect()
    }

    /// Height H \[m\] from valley to peak.
    fn height_m(&self, spectrum: &AreaSpectrum) -> f64 {
        8f64.sqrt() * self.wave_over_roughness * spectrum.moments().m0_m2.sqrt()
    }

    /// Puts the long wave below the roughness.
    fn relief(&self, mut heights_m: Vec<f64>, height_m: f64) -> Relief {
        let cosine = |at: usize| (TAU * at as f64 / POINTS as f64).cos();
        for (at, height) in heights_m.iter_mut().enumerate() {
            let (row, column) = (at / POINTS, at % POINTS);
            *height += match self.form {
                Form::Ridge => 0.5 * height_m * cosine(column),
                Form::Dome => 0.25 * height_m * (cosine(column) + cosine(row)),
            };
        }
        Relief {
            rows: POINTS,
            columns: POINTS,
            length_x_m: BOX_M,
            length_y_m: BOX_M,
            heights_m,
            boundary: Boundary::Periodic,
            is_missing: Vec::new(),
        }
    }

    /// Scene of the roughness with the flatness as a user would state it.
    fn scene(&self, spectrum: &AreaSpectrum, height_m: f64, loads_pa: &[f64]) -> Result<Scene, TrialError> {
        let file = self.band().file(spectrum, 1.0)?;
        let pressures: Vec<String> =
            loads_pa.iter().map(|pressure_pa| format!("\"{pressure_pa} Pa\"")).collect();
        let text = format!(
            "[surface]\npsd = \"s.csv\"\n[material]\nyoungs_modulus = \"{CONTACT_MODULUS_PA} Pa\"\npoisson_ratio = 0\n\
             thermal_conductivity = \"{CONDUCTIVITY_W_PER_M_K} W/(m K)\"\n[counterface]\nthermal_conductivity = \
             \"{CONDUCTIVITY_W_PER_M_K} W/(m K)\"\n[loads]\npressures = [{}]\n[interface]\nband = \"2d\"\nflatness = \"{height_m:e} m \
             over {} m\"\ngas_conductivity = \"{GAS_W_PER_M_K} W/(m K)\"\ngas_parameter = \"{GAS_PARAMETER_M:e} m\"\n",
            pressures.join(", "),
            self.form.span_m()
        );
        Scene::parse(&text, &file, &Overrides::default())
            .map_err(|error| TrialError::Scene(error.to_string()))
    }
}

/// Returns the page with its table of flatness.
///
/// # Errors
/// [`TrialError::Page`] if the page lacks the section.
pub fn written(page: &str, rows: &[FlatnessRow]) -> Result<String, TrialError> {
    let is_reported = |row: &&FlatnessRow| trials(Set::Report).iter().any(|trial| row.is_of(trial));
    let reported: Vec<&FlatnessRow> = rows.iter().filter(is_reported).collect();
    let mut lines = Vec::new();
    for form in [Form::Ridge, Form::Dome] {
        for quantity in AskedOf::ALL {
            let of_line: Vec<&FlatnessRow> =
                reported.iter().copied().filter(|row| row.form == form && row.quantity == quantity).collect();
            let count =
                |is_so: &dyn Fn(&FlatnessRow) -> bool| of_line.iter().filter(|row| is_so(row)).count();
            let over = |of: fn(&FlatnessRow) -> f64| {
                let mut ratios: Vec<f64> = of_line.iter().map(|row| of(row) / row.elements).collect();
                ratios.sort_by(f64::total_cmp);
                let ends = ratios.first().zip(ratios.last());
                ends.map_or(String::new(), |(least, most)| {
                    format!("{} to {}", three_digits(*least), three_digits(*most))
                })
            };
            let wide = |row: &&FlatnessRow| row.range()[1] / row.range()[0];
            let widest = of_line.iter().map(wide).fold(0.0, f64::max);
            let form = if form == Form::Ridge { "ridge" } else { "dome" };
            lines.push(vec![
                format!("{form}, {}", quantity.words()),
                over(|row| row.flat),
                over(|row| row.by_wave),
                over(|row| row.by_cap),
                format!("{} of {}", count(&FlatnessRow::wave_is_nearer), of_line.len()),
                format!("{} of {}", count(&FlatnessRow::is_inside), of_line.len()),
                three_digits(widest),
            ]);
        }
    }
    let headings = ["deviation", "flat faces", "wave", "cap", "wave is nearer", "inside", "high/low at most"];
    with_section(page, "flatness", &table(&headings, &lines)).map_err(TrialError::Page)
}
