//! All parameters of prepared heights.

use units::display::length;

use crate::autocorrelation::{Autocorrelation, AutocorrelationNormalisation, Reach};
use crate::heights::{HeightParameters, section_means_m};
use crate::material_ratio::{Core, MaterialRatioCurve};
use crate::parameter::{Parameter, ParameterValue};
use crate::relief::ScaleLimitedSurface;
use crate::slopes::{Differences, Triangles, developed_area_excess, rms_gradient};

/// The convention of a core with [a twin](Core::has_twin).
const TWINS: &str = "the first of two windows that are equally flat (ISO 21920-2)";

/// Computes all parameters of prepared heights, and the material ratio at `height_m` above the mean.
///
/// Further conventions of a parameter follow it, with [`Parameter::is_first`] false.
#[must_use]
pub fn parameters(relief: &ScaleLimitedSurface, height_m: f64) -> Vec<Parameter> {
    let is_map = relief.points().1.is_some();
    let mut found = HeightParameters::from_relief(relief).parameters();
    if !is_map && let Some([ra_m, rq_m]) = section_means_m(relief) {
        let mean = |symbol, value_m| {
            Parameter::new(symbol, ParameterValue::LengthM(value_m))
                .by("mean over five sections (ISO 4287)")
                .further()
        };
        found.extend([mean("Ra", ra_m), mean("Rq", rq_m)]);
    }
    found.extend(gradients(relief, if is_map { "Sdq" } else { "Rdq" }));
    if is_map {
        found.extend(developed_areas(relief));
        found.extend(autocorrelation(relief));
    }
    found.extend(material_ratio(relief, is_map, height_m));
    found
}

fn gradients(relief: &ScaleLimitedSurface, symbol: &'static str) -> Vec<Parameter> {
    let of = |differences: Differences| {
        let gradient = rms_gradient(relief, differences)?;
        Some(Parameter::new(symbol, ParameterValue::Number(gradient)).by(differences.name()))
    };
    let found = Differences::ALL.iter().filter_map(|differences| of(*differences));
    found.enumerate().map(|(at, parameter)| if at == 0 { parameter } else { parameter.further() }).collect()
}

fn developed_areas(relief: &ScaleLimitedSurface) -> Vec<Parameter> {
    let of = |triangles: Triangles| {
        let excess = developed_area_excess(relief, triangles)?;
        Some(Parameter::new("Sdr", ParameterValue::Share(excess)).by(triangles.name()))
    };
    let found = Triangles::ALL.iter().filter_map(|triangles| of(*triangles));
    found.enumerate().map(|(at, parameter)| if at == 0 { parameter } else { parameter.further() }).collect()
}

fn autocorrelation(relief: &ScaleLimitedSurface) -> Vec<Parameter> {
    let Some(table) = Autocorrelation::of_map(relief) else { return Vec::new() };
    AutocorrelationNormalisation::ALL
        .iter()
        .flat_map(|normalisation| {
            let Reach { shortest_m, longest_m, searched_m } = table.reach(*normalisation);
            let name = normalisation.name();
            let undetermined = |symbol| {
                let bound = length(searched_m);
                Parameter::new(symbol, ParameterValue::NotDetermined).by(format!(
                    "{name}; not determined, it does not fall to 0.2 within {bound} in every direction"
                ))
            };
            let sal = match shortest_m {
                Some(shortest_m) => Parameter::new("Sal", ParameterValue::LengthM(shortest_m)).by(name),
                None => undetermined("Sal"),
            };
            let str_ = match (shortest_m, longest_m) {
                (Some(shortest_m), Some(longest_m)) => {
                    Parameter::new("Str", ParameterValue::Number(shortest_m / longest_m)).by(name)
                }
                _ => undetermined("Str"),
            };
            let is_first = *normalisation == AutocorrelationNormalisation::Unbiased;
            [sal, str_].map(|parameter| Parameter { is_first, ..parameter })
        })
        .collect()
}

fn material_ratio(relief: &ScaleLimitedSurface, is_map: bool, height_m: f64) -> Vec<Parameter> {
    use ParameterValue::{LengthM, Share, VolumeM};
    let curve = MaterialRatioCurve::new(relief);
    let Core { depth_m, peaks_m, valleys_m, peak_share, valley_share, has_twin } = curve.core();
    let of_core = |name, value| Parameter::new(name, value).by(if has_twin { TWINS } else { "" });
    let [ratio, core, peaks, valleys, from, to] = match is_map {
        true => ["Smr", "Sk", "Spk", "Svk", "Smr1", "Smr2"],
        false => ["Rmr", "Rk", "Rpk", "Rvk", "Rmr1", "Rmr2"],
    };
    let at = match height_m {
        0.0 => "at the mean".to_owned(),
        _ => format!("at {} from the mean", length(height_m)),
    };
    let mut found = vec![
        Parameter::new(ratio, Share(curve.share_at_or_above(height_m))).by(at),
        of_core(core, LengthM(depth_m)),
        of_core(peaks, LengthM(peaks_m)),
        of_core(valleys, LengthM(valleys_m)),
        of_core(from, Share(peak_share)),
        of_core(to, Share(valley_share)),
    ];
    if is_map {
        let (peak, void) = (curve.material_m(0.1), curve.void_m(0.8));
        found.extend([
            Parameter::new("Vmp", VolumeM(peak)),
            Parameter::new("Vmc", VolumeM(curve.material_m(0.8) - peak)),
            Parameter::new("Vvc", VolumeM(curve.void_m(0.1) - void)),
            Parameter::new("Vvv", VolumeM(void)),
        ]);
    }
    found
}
