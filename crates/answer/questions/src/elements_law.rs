//! Laws by boundary elements: monotone cubics between loads pressed in turn on random surfaces.

use asperity::MonotoneCubic;
use elements::{PressedLoad, PressedState, RandomSurfaces};
use interface::finite_elements::{Column, ContactLaw, LawPoint, SamplingError, UnitSystem};
use study::gap_law::{GapError, GapState};
use units::display::{pressure, three_digits};
use units::{Remark, RemarkLevel, Spelling};

use crate::QuestionError;
use crate::gap::cautions;

/// Mean of random surfaces under loads between two nominal pressures.
#[derive(Debug, Clone)]
pub struct ElementsLaw {
    /// The least and the largest nominal pressure \[Pa\].
    pub range_pa: [f64; 2],
    /// Rms height of the surfaces \[m\].
    pub rms_height_m: f64,
    /// Notes for the reader of the law.
    pub notes: Vec<Remark>,
    hardness_pa: Option<f64>,
    /// States by rising pressure, from the load at which laws are cut off.
    pub(crate) loads: Vec<PressedLoad>,
    /// Distance of the mean planes \[m\] over ln p: of the mean, and of each surface.
    distance_m: MonotoneCubic,
    distances_m: Vec<MonotoneCubic>,
    mean_gap_m: MonotoneCubic,
    log_area: MonotoneCubic,
    /// Logarithm of the stiffness on unloading; `None` where it is not asked for, or no gap is left.
    log_stiffness: Option<MonotoneCubic>,
    /// Relative errors between two loads: of the pressure at a distance, and of the stiffness.
    pub(crate) error: f64,
    pub(crate) stiffness_error: f64,
}

impl ElementsLaw {
    /// The law through states by rising pressure, an odd number of them.
    pub(crate) fn through(
        surfaces: &RandomSurfaces,
        range_pa: [f64; 2],
        hardness_pa: Option<f64>,
        loads: Vec<PressedLoad>,
    ) -> Result<Self, QuestionError> {
        let logs: Vec<f64> = loads.iter().map(|load| load.nominal_pressure_pa.ln()).collect();
        let distances_m: Vec<f64> = loads.iter().map(mean_distance_m).collect();
        if let Some(at) = distances_m.windows(2).position(|pair| pair[0] <= pair[1]) {
            let [from_pa, to_pa] = [at, at + 1].map(|at| loads[at].nominal_pressure_pa);
            return Err(SamplingError::NotClosing { from_pa, to_pa }.into());
        }
        let from = range_pa[0].ln();
        let stiffnesses = loads.iter().map(|load| load.mean().stiffness_pa_per_m.map(f64::ln));
        let stiffnesses: Option<Vec<f64>> = stiffnesses.collect();
        let cubic = |values: Vec<f64>| MonotoneCubic::through(logs.clone(), values);
        let of_loads = |value: &dyn Fn(&PressedLoad) -> f64| cubic(loads.iter().map(value).collect());
        let of_surface = |surface: usize| of_loads(&|load| distance_m(&load.states[surface]));
        Ok(Self {
            range_pa,
            rms_height_m: surfaces.band.mean_square_height_m2().sqrt(),
            notes: Vec::new(),
            hardness_pa,
            distances_m: (0..surfaces.realisations).map(of_surface).collect(),
            mean_gap_m: of_loads(&|load| load.mean().mean_gap_m),
            log_area: of_loads(&|load| load.area_fraction(hardness_pa).ln()),
            error: half_of_left_out(from, &logs, &distances_m, |off_m, slope_m| (off_m / slope_m).abs()),
            stiffness_error: stiffnesses
                .as_ref()
                .map_or(0.0, |values| half_of_left_out(from, &logs, values, |off, _| off.abs())),
            distance_m: cubic(distances_m),
            log_stiffness: stiffnesses.map(cubic),
            loads,
        })
    }

    /// State under a nominal pressure within the range \[Pa\], with the stiffness on unloading.
    #[must_use]
    pub fn at(&self, pressure_pa: f64) -> GapState {
        let log = pressure_pa.ln();
        GapState {
            nominal_pressure_pa: pressure_pa,
            area_fraction: self.log_area.at(log).0.exp(),
            mean_gap_m: Some(self.mean_gap_m.at(log).0),
            mean_plane_distance_m: Some(self.distance_m.at(log).0),
            stiffness_pa_per_m: self.log_stiffness.as_ref().map(|curve| curve.at(log).0.exp()),
        }
    }

    /// Slope -dp/dd of the law \[Pa/m\] at a nominal pressure within the range \[Pa\], with d the distance of the mean planes.
    #[must_use]
    pub fn loading_stiffness_pa_per_m(&self, pressure_pa: f64) -> f64 {
        -pressure_pa / self.distance_m.at(pressure_pa.ln()).1
    }

    /// Samples the law between its pressures, straight within the relative `tolerance` of the question, with the columns that plain
    /// tables have besides.
    ///
    /// # Errors
    /// [`QuestionError::Sampling`] for a tolerance that the loads do not allow.
    pub fn sampled(
        &self,
        tolerance: f64,
        units: UnitSystem,
    ) -> Result<(ContactLaw, Vec<Column>), QuestionError> {
        let at = |pressure_pa: f64| {
            let mean_gap_m = self.distance_m.at(pressure_pa.ln()).0;
            let area_fraction = self.at(pressure_pa).area_fraction;
            Ok::<_, GapError>(Some(LawPoint { pressure_pa, mean_gap_m, area_fraction }))
        };
        let mut law = ContactLaw::sample(self.range_pa, tolerance - self.error, at)?;
        law.tolerance = tolerance;
        law.interpolation_error += self.error;
        let (pa, m) = (units.pressure_symbol(), units.length_symbol());
        let stiffness = |pa_per_m: f64| units.pressure(pa_per_m) / units.length(1.0);
        let column = |name: String, value: &dyn Fn(f64) -> Option<f64>| Column {
            name,
            values: law.points.iter().map(|point| value(point.pressure_pa)).collect(),
        };
        let columns = vec![
            column(format!("mean_gap_{m}"), &|pa| self.at(pa).mean_gap_m.map(|gap_m| units.length(gap_m))),
            column(format!("loading_stiffness_{pa}_per_{m}"), &|pa| {
                Some(stiffness(self.loading_stiffness_pa_per_m(pa)))
            }),
            column(format!("unloading_stiffness_{pa}_per_{m}"), &|pa| {
                self.at(pa).stiffness_pa_per_m.map(stiffness)
            }),
            column(format!("overclosure_low_{m}"), &|pa| Some(units.length(self.overclosures_m(pa)?[0]))),
            column(format!("overclosure_high_{m}"), &|pa| Some(units.length(self.overclosures_m(pa)?[1]))),
        ];
        Ok((law, columns))
    }

    /// Least and largest overclosure \[m\] of the single surfaces, each counted from where its own law is cut off; `None` of one surface.
    fn overclosures_m(&self, pressure_pa: f64) -> Option<[f64; 2]> {
        let closed_m = self.distances_m.iter().map(|curve| self.overclosure_m(curve, pressure_pa));
        (self.distances_m.len() > 1).then(|| ends(closed_m))
    }

    fn overclosure_m(&self, curve: &MonotoneCubic, pressure_pa: f64) -> f64 {
        curve.at(self.range_pa[0].ln() - 1.0).0 - curve.at(pressure_pa.ln()).0
    }

    /// Describes elements, yielding, scatter and every note in lines, for the comments of a file.
    #[must_use]
    pub fn description(&self, spelling: &dyn Spelling) -> Vec<String> {
        let at_ends = |value: &dyn Fn(f64, &PressedLoad) -> String| {
            let of_end = |pressure_pa: f64| {
                let load = self.loads.iter().find(|load| load.nominal_pressure_pa >= pressure_pa);
                load.map(|load| format!("{} at {}", value(pressure_pa, load), pressure(pressure_pa)))
            };
            self.range_pa.into_iter().filter_map(of_end).collect::<Vec<_>>().join(", ")
        };
        let percent = |share: f64| format!("{} %", three_digits(100.0 * share));
        let range = |values: &mut dyn Iterator<Item = f64>, mean: f64| match self.distances_m.len() {
            1 => "unknown from one".to_owned(),
            _ => ends(values).map(|end| three_digits(end / mean)).join(" to "),
        };
        let closed = |pressure_pa: f64, _: &PressedLoad| {
            let closed_m = |curve| self.overclosure_m(curve, pressure_pa);
            range(&mut self.distances_m.iter().map(closed_m), closed_m(&self.distance_m))
        };
        let stiff = |_: f64, load: &PressedLoad| {
            let mean = load.mean().stiffness_pa_per_m.unwrap_or_default();
            range(&mut load.states.iter().filter_map(|state| state.stiffness_pa_per_m), mean)
        };
        let flows = |_: f64, load: &PressedLoad| {
            percent(load.mean().plastic_area_fraction / load.mean().area_fraction)
        };
        let mut lines = vec![
            format!(
                "Boundary elements: the mean of random surfaces under {} loads, and monotone cubics over ln p between them, within {} of \
                 the pressure as loads left out show.",
                self.loads.len(),
                percent(self.error)
            ),
            self.hardness_pa.map_or_else(
                || "They are elastic: no hardness is given.".to_owned(),
                |hardness_pa| {
                    let hardness = pressure(hardness_pa);
                    format!(
                        "Share of the contact that flows at the hardness {hardness}: {}.",
                        at_ends(&flows)
                    )
                },
            ),
            STIFFNESSES.to_owned(),
            format!(
                "Overclosures of the single surfaces, each from its own cut, over those of their mean: {}.",
                at_ends(&closed)
            ),
        ];
        if self.log_stiffness.is_some() {
            let error = percent(self.stiffness_error);
            let stiff = at_ends(&stiff);
            lines.push(format!(
                "Their stiffness on unloading over its mean: {stiff}; between loads within {error}."
            ));
        }
        let notes = self.notes.iter().filter(|note| note.level != RemarkLevel::Caution);
        lines.extend(notes.map(|note| format!("Note: {}.", note.words(spelling))));
        lines.extend(cautions(&self.notes, spelling));
        lines
    }
}

const STIFFNESSES: &str = "The slope of the law is the stiffness on loading. Contact that has flowed is stiffer on unloading: the law leaves \
                           that out, and heat and current follow it.";

fn ends(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, largest], value| {
        [least.min(value), largest.max(value)]
    })
}

/// Distance of the mean planes of a surface \[m\].
fn distance_m(state: &PressedState) -> f64 {
    state.numbers.mean_gap_m - state.numbers.mean_plastic_depth_m
}

fn mean_distance_m(load: &PressedLoad) -> f64 {
    load.states.iter().map(distance_m).sum::<f64>() / load.states.len() as f64
}

/// Estimates the error between values beyond `from`: half of the largest one at values that are left out, as at a kink, where smooth
/// curves have an eighth. `error` takes a difference and the slope.
fn half_of_left_out(from: f64, x: &[f64], values: &[f64], error: impl Fn(f64, f64) -> f64) -> f64 {
    let every_second = |values: &[f64]| values.iter().step_by(2).copied().collect();
    let curve = MonotoneCubic::through(every_second(x), every_second(values));
    let left_out = x.iter().zip(values).skip(1).step_by(2).filter(|(x, _)| **x > from);
    let left_out = left_out.map(|(x, value)| (curve.at(*x), value));
    0.5 * left_out.map(|((found, slope), value)| error(found - value, slope)).fold(0.0, f64::max)
}
