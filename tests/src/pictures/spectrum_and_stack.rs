//! Results of a spectrum: moments and asperities for every cutoff, and the stack of its scales.

use std::num::NonZeroU32;

use asperity::{MaterialPair, NixGao};
use spectrum::{
    AmplitudeDefinition, AsperityParameters, Convention, Moments, Normalisation, ProfilePsd, Psd,
    ReadOptions, amplitudes, cumulative_moments,
};
use stacked_contact::{Level, StackedModel, levels};
use study::NoFiles;
use study::surface::Surface;

use super::{Picture, body, dashed, geometric, line, picture};

const CUTOFF: &str = "shortest wavelength included (m)";
const WHOLE: &str = "contact area / nominal area";
const UNCD: &str = "UNCD, reconstructed spectrum; nominal pressure 5.4 MPa";
const UNCD_PRESSURE_PA: f64 = 5.4e6;
const ROLL_OFF_M: f64 = 10e-6;

/// C1D = C0 [1 + (q/q_r)^2]^(-(Hu + 1/2)), Hu = 0.8, from 1 mm to 1 nm, rolling off at 10 µm.
fn self_affine() -> ProfilePsd {
    let wavelengths_m = geometric([1e-3, 1e-9], 61);
    let density_m3 = |wavelength_m: &f64| 1e-18 * (1.0 + (ROLL_OFF_M / wavelength_m).powi(2)).powf(-1.3);
    let densities_m3 = wavelengths_m.iter().map(density_m3).collect();
    let psd = Psd::new(wavelengths_m, densities_m3, Convention::C1D).expect("a spectrum");
    psd.profile().expect("a profile spectrum")
}

/// Moments and asperity parameters against cutoff, each over its value next to the roll-off.
pub(super) fn moments() -> Picture {
    let rows: Vec<(Moments, AsperityParameters)> =
        cumulative_moments(&self_affine(), Normalisation::default())
            .into_iter()
            .filter_map(|moments| Some((moments, AsperityParameters::from_moments(&moments)?)))
            .filter(|(moments, _)| moments.wavelength_m < 0.99 * ROLL_OFF_M)
            .collect();
    let over_first =
        |curve: &str, dash, name: &str, colour, of: fn(&(Moments, AsperityParameters)) -> f64| {
            let points = rows.iter().map(|row| (row.0.wavelength_m, of(row) / of(&rows[0]))).collect();
            dashed(curve, dash, line(name, colour, points))
        };
    let moment = |name: &str, colour, of| over_first("moments", 0, name, colour, of);
    let asperities = |name: &str, colour, of| over_first("asperities", 1, name, colour, of);
    picture(
        "moments",
        [
            "Moments and asperities against cutoff",
            "self-affine surface, Hurst exponent 0.8, roll-off at 10 µm",
        ],
        [CUTOFF, "value over that at the roll-off"],
        vec![
            moment("m0", 0, |(moments, _)| moments.m0_m2),
            moment("m2", 1, |(moments, _)| moments.m2),
            moment("m4", 2, |(moments, _)| moments.m4_per_m2),
            asperities("radius R", 3, |(_, asperities)| asperities.radius_m),
            asperities("density η", 4, |(_, asperities)| asperities.density_per_m2),
            asperities("spread σ_s", 5, |(_, asperities)| asperities.sigma_s_m),
        ],
    )
}

/// The reconstructed spectrum of UNCD, and its material.
fn uncd() -> (ProfilePsd, MaterialPair, NixGao) {
    let surface = Surface::load("builtin:uncd-reconstructed", &NoFiles, &ReadOptions::default());
    let strength = NixGao::constant(1.8e9).expect("a strength within its bounds");
    (surface.expect("a spectrum of the program's own").psd, body(463e9, 0.2), strength)
}

fn areas(model: &StackedModel, psd: &ProfilePsd) -> Vec<(f64, f64)> {
    let point = |level: Level| (level.wavelength_m, level.area_fraction);
    levels(model, UNCD_PRESSURE_PA, amplitudes(psd, AmplitudeDefinition::default())).map(point).collect()
}

/// The area of the stack against cutoff, over the aspect ratio of each scale.
pub(super) fn area() -> Picture {
    let (psd, pair, strength) = uncd();
    // The flattest scales would stretch the ordinate to a range without change.
    const LEAST_ASPECT_RATIO: f64 = 1e-5;
    let aspect_ratios = amplitudes(&psd, AmplitudeDefinition::default())
        .iter()
        .map(|scale| (scale.wavelength_m, scale.aspect_ratio()))
        .filter(|(_, aspect_ratio)| *aspect_ratio > LEAST_ASPECT_RATIO)
        .collect();
    picture(
        "stacked-area",
        ["Stacked area, and the scales that make it", UNCD],
        ["wavelength of the scale = shortest included (m)", "area / nominal area, aspect ratio B"],
        vec![
            line("area, elastic", 0, areas(&StackedModel::Elastic { pair }, &psd)),
            line(
                "area, elastic-plastic",
                1,
                areas(&StackedModel::ElasticPlastic { pair, strength, area: Default::default() }, &psd),
            ),
            line("aspect ratio B = Δ/λ", 2, aspect_ratios),
        ],
    )
}

/// Draws the same elastic stack with more and fewer scales.
pub(super) fn sampling() -> Picture {
    let (psd, pair, _) = uncd();
    let densities = [(1, "1 per decade"), (2, "2 per decade"), (5, "5 per decade"), (20, "20 per decade")];
    let lines = densities.into_iter().enumerate().map(|(colour, (per_decade, name))| {
        let sampled = psd.resampled(NonZeroU32::new(per_decade).expect("not zero"));
        line(name, colour, areas(&StackedModel::Elastic { pair }, &sampled))
    });
    picture(
        "stacked-sampling",
        ["Elastic stacked area, by scales per decade", UNCD],
        [CUTOFF, WHOLE],
        lines.collect(),
    )
}

/// Draws the effect on the stacked area of a strength that grows at small depths.
pub(super) fn strain_gradient() -> Picture {
    let (psd, pair, strength) = uncd();
    let gradient = |length_m: f64| {
        let strength = strength.with_strain_gradient(length_m).expect("a length within its bounds");
        areas(&StackedModel::ElasticPlastic { pair, strength, area: Default::default() }, &psd)
    };
    let constant = areas(&StackedModel::ElasticPlastic { pair, strength, area: Default::default() }, &psd);
    picture(
        "strain-gradient",
        ["Stacked area with a strength that grows at small depths", UNCD],
        [CUTOFF, WHOLE],
        vec![
            line("constant strength", 1, constant),
            line("h* = 1 nm", 2, gradient(1e-9)),
            line("h* = 10 nm", 3, gradient(1e-8)),
            line("h* = 5 µm", 0, gradient(5e-6)),
            dashed("elastic", 1, line("", 5, areas(&StackedModel::Elastic { pair }, &psd))),
        ],
    )
}
