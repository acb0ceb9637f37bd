//! The data of figures, out of the results of a plan.

use stacked_contact::Scale;
use units::display::{length, lengths_apart, load_in_full, pressure, typeset};

use super::{Axis, BandKind, CurveLook, Figure, FigureBand, FigureData, PSD, Series, Shows, WAVEVECTOR};
use crate::linear_laws::{linear_areas, rms_gradients};
use crate::plan::{Load, Needs, Results};

const WAVELENGTH: Axis = Axis { column: "wavelength_m", label: "wavelength (m)" };
const CUTOFF: Axis = Axis { column: "wavelength_m", label: "shortest wavelength included (m)" };
const PRESSURE: Axis = Axis { column: "nominal_pressure_pa", label: "nominal pressure (Pa)" };
const AREA: &str = "contact area / nominal area";

impl Figure {
    /// Computes the data of a figure from the results of its plan. Loads are also labelled in units of the hardness
    /// \[Pa\], if there is one.
    pub fn data(&self, results: &Results, needs: &Needs, hardness_pa: Option<f64>) -> FigureData {
        let (x, y_label, series) = match self.shows {
            Shows::Psd => (WAVEVECTOR, PSD, psd_series(results)),
            Shows::Moments => (CUTOFF, "moment over its final value", moment_series(results)),
            Shows::Amplitude => (
                WAVELENGTH,
                "amplitude Δ (m)",
                scale_series(results, "amplitude_m", |scale| scale.amplitude_m),
            ),
            Shows::AspectRatio => (
                WAVELENGTH,
                "aspect ratio B = Δ/λ",
                scale_series(results, "aspect_ratio", Scale::aspect_ratio),
            ),
            Shows::Area => (CUTOFF, AREA, self.area_series(results, needs, hardness_pa)),
            // No scene asks for a response.
            Shows::AreaAgainstLoad | Shows::Response => (PRESSURE, AREA, self.load_series(results, needs)),
        };
        let title = self.title.clone().unwrap_or_else(|| y_label.to_owned());
        let x_label = match hardness_pa.filter(|_| x == PRESSURE) {
            Some(hardness_pa) => format!("{}; H = {}", x.label, pressure(hardness_pa)),
            None => x.label.to_owned(),
        };
        FigureData {
            title,
            x_label,
            bands: if self.shows == Shows::Area { self.linear_bands(results, needs) } else { Vec::new() },
            ..FigureData::new(&self.name, self.shows, x, y_label, series)
        }
    }

    /// For every load the areas that go with it, where an elastic curve is drawn.
    fn linear_bands(&self, results: &Results, needs: &Needs) -> Vec<FigureBand> {
        let mut models = self.curves.iter().map(|&curve| &needs.curves[curve].model);
        let Some(elastic) = models.find(|model| model.strength().is_none()) else { return Vec::new() };
        let gradients = rms_gradients(&results.psd);
        let band = |(index, load): (usize, &Load)| {
            let areas = |gradient| linear_areas(elastic, load.nominal_pressure_pa(), gradient);
            let point = |&(cutoff_m, gradient): &(f64, f64)| Some((cutoff_m, areas(gradient)?));
            let points = gradients.iter().filter_map(point).collect();
            FigureBand {
                label: "linear laws".to_owned(),
                kind: BandKind::Yardstick,
                load: Some(index),
                curve_index: 0,
                points,
            }
        };
        let loads = needs.loads.iter().enumerate().filter(|(index, _)| self.draws_load(*index));
        loads.map(band).filter(|band| !band.points.is_empty()).collect()
    }

    fn area_series(&self, results: &Results, needs: &Needs, hardness_pa: Option<f64>) -> Vec<Series> {
        let mut series = Vec::new();
        for (place, &curve) in self.curves.iter().enumerate() {
            for (index, load) in needs.loads.iter().enumerate().filter(|(index, _)| self.draws_load(*index)) {
                let points = results.curves[curve].area_fractions(index);
                let line = line(needs, curve, &load.label, place, index, points);
                series.push(Series {
                    condition_in_full: load_in_full(&load.label, load.nominal_pressure_pa(), hardness_pa),
                    load: Some(index),
                    ..line
                });
            }
            if needs.curves[curve].model.takes_separations() {
                for (at, separation_m) in needs.separations_m.iter().enumerate() {
                    // The blocks of separations follow those of the loads.
                    let block = needs.loads.len() + at;
                    let sign = if *separation_m < 0.0 { "-" } else { "" };
                    let label = format!("separation {sign}{}", length(separation_m.abs()));
                    let points = results.curves[curve].area_fractions(block);
                    series.push(line(needs, curve, &label, place, block, points));
                }
            }
        }
        series
    }

    /// Makes the lines of the sweeps, each under the cutoff of its spectrum.
    fn load_series(&self, results: &Results, needs: &Needs) -> Vec<Series> {
        let cutoffs_m: Vec<f64> = self.sweeps.iter().map(|&sweep| results.sweeps[sweep].cutoff_m).collect();
        let labels = lengths_apart(&cutoffs_m);
        let mut distinct_m: Vec<f64> = Vec::new();
        let of_sweep = |((&sweep, &cutoff_m), label): ((&usize, &f64), String)| {
            let (asked, found) = (&needs.sweeps[sweep], &results.sweeps[sweep]);
            let index = distinct_m.iter().position(|&other| other == cutoff_m).unwrap_or_else(|| {
                distinct_m.push(cutoff_m);
                distinct_m.len() - 1
            });
            let place = self.curves.iter().position(|&curve| curve == asked.curve).unwrap_or(0);
            let areas = found.area_fractions.iter().copied();
            let points = asked.pressures_pa.iter().copied().zip(areas).collect();
            let line = line(needs, asked.curve, &label, place, index, points);
            Series { condition_in_full: format!("cutoff {label}"), ..line }
        };
        self.sweeps.iter().zip(&cutoffs_m).zip(labels).map(of_sweep).collect()
    }
}

/// The line of one curve under one condition.
fn line(
    needs: &Needs,
    curve: usize,
    condition: &str,
    curve_index: usize,
    condition_index: usize,
    points: Vec<(f64, f64)>,
) -> Series {
    let name = &needs.curves[curve].name;
    Series {
        column: format!("{name} at {condition}"),
        curve: name.clone(),
        curve_index,
        look: CurveLook::of_curves(&needs.curves).get(curve).copied(),
        condition: condition.to_owned(),
        condition_in_full: typeset(condition),
        load: None,
        condition_index: Some(condition_index),
        points,
    }
}

fn psd_series(results: &Results) -> Vec<Series> {
    let wavevectors =
        results.psd.wavelengths_m().iter().map(|wavelength_m| std::f64::consts::TAU / wavelength_m);
    vec![Series::alone("c1d_m3", wavevectors.zip(results.psd.c1d_m3().iter().copied()).collect())]
}

fn scale_series(results: &Results, column: &str, of: fn(&Scale) -> f64) -> Vec<Series> {
    vec![Series::alone(column, results.scales.iter().map(|scale| (scale.wavelength_m, of(scale))).collect())]
}

fn moment_series(results: &Results) -> Vec<Series> {
    let moment = |index, name: &str, of: fn(&spectrum::Moments) -> f64| {
        let last = results.moments.last().map_or(1.0, |(moments, _)| of(moments));
        let point = |(moments, _): &(spectrum::Moments, _)| (moments.wavelength_m, of(moments) / last);
        let points = results.moments.iter().map(point).collect();
        Series { column: format!("{name}_over_final"), ..Series::under(name, index, points) }
    };
    vec![moment(0, "m0", |m| m.m0_m2), moment(1, "m2", |m| m.m2), moment(2, "m4", |m| m.m4_per_m2)]
}
