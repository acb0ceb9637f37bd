//! Bias of spectra of self-affine maps by the treatment of missing points, as the table of docs/guide/missing-points.md: C1D and the rms slope
//! of a map with missing points over those of the whole map, geometric means over seeds and over the wavelengths of a column.

#[path = "../tests/all/transform_support/mod.rs"]
mod transform_support;

use topography::GapTreatment;
use transform_support::holes::{Bias, HoleKind, bias, holes, surface};

const POINTS: usize = 512;
const SEEDS: u64 = 4;
/// Wavelengths over the size of a hole.
const EDGES: [f64; 6] = [0.1, 1.0, 4.0, 10.0, 40.0, 1000.0];

fn main() {
    println!(
        "| Hurst | holes | share | treatment | 0.1 to 1 | 1 to 4 | 4 to 10 | 10 to 40 | above 40 | rms slope |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for hurst_exponent in [0.5, 0.8] {
        let surfaces: Vec<Vec<f64>> = (1..=SEEDS).map(|seed| surface(POINTS, hurst_exponent, seed)).collect();
        for kind in HoleKind::ALL {
            for share in [0.05, 0.1, 0.2] {
                for treatment in [GapTreatment::Harmonic, GapTreatment::Lines] {
                    let of_seed = |(seed, heights_m): (usize, &Vec<f64>)| {
                        let (gaps, size) = holes(kind, share, heights_m, POINTS, seed as u64);
                        bias(heights_m, POINTS, &gaps, size, treatment)
                    };
                    let found: Vec<Bias> = surfaces.iter().enumerate().filter_map(of_seed).collect();
                    println!(
                        "| {hurst_exponent} | {} | {} % | {treatment} | {} |",
                        kind.name(),
                        100.0 * share,
                        row(&found)
                    );
                }
            }
        }
    }
}

fn row(found: &[Bias]) -> String {
    let in_column = |edges: &[f64]| {
        let samples = found.iter().flat_map(|bias| &bias.spectrum);
        samples
            .filter(|&&(ratio, _)| ratio > edges[0] && ratio <= edges[1])
            .map(|&(_, value)| value)
            .collect::<Vec<_>>()
    };
    let columns = EDGES.windows(2).map(|edges| mean(&in_column(edges)));
    let slope = mean(&found.iter().map(|bias| bias.rms_slope).collect::<Vec<_>>());
    columns.chain([slope]).collect::<Vec<_>>().join(" | ")
}

fn mean(values: &[f64]) -> String {
    if values.is_empty() {
        return "-".to_owned();
    }
    format!("{:.3}", (values.iter().map(|value| value.ln()).sum::<f64>() / values.len() as f64).exp())
}
