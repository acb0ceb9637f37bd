//! Self-affine maps with the holes that optical instruments leave, and the effect of treatments on the spectrum.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use scans::MeasuredScan;
use spectrum::random_surfaces::{AreaSpectrum, Phases, SelfAffine, Size, Synthesis};
use topography::{
    BandLimits, BinMean, DEFAULT_BINS_PER_DECADE, Direction, GapTreatment, Recipe, ScanSpectrum, log_binned,
    without_gaps,
};

use super::Random;
use super::files::{file_of, map_with_gaps};

/// Distance of points.
pub const SPACING_M: f64 = 1e-6;

/// Why points have no height.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HoleKind {
    /// Single points and small groups of them.
    Dropouts,
    /// The steepest points.
    Flanks,
    /// All along the edges.
    Border,
    /// A few large ones, as dirt leaves them.
    Blobs,
}

impl HoleKind {
    pub const ALL: [Self; 4] = [Self::Dropouts, Self::Flanks, Self::Border, Self::Blobs];

    pub fn name(self) -> &'static str {
        match self {
            Self::Dropouts => "dropouts",
            Self::Flanks => "steep flanks",
            Self::Border => "border",
            Self::Blobs => "a few blobs",
        }
    }
}

/// A Gaussian surface without a preferred direction, its roll-off at a quarter of its side: neither periodic at the scale
/// of the part that is kept, nor level.
pub fn surface(points: usize, hurst_exponent: f64, seed: u64) -> Vec<f64> {
    // Twice the side is made and a quarter of it kept, so that nothing repeats itself.
    let whole = 2 * points;
    let length_m = SPACING_M * whole as f64;
    let spectrum = AreaSpectrum::self_affine(&SelfAffine {
        hurst_exponent,
        longest_m: length_m,
        rolloff_m: length_m / 8.0,
        shortest_m: 2.0 * SPACING_M,
        size: Size::RmsHeightM(1e-6),
    })
    .expect("a sound surface");
    let synthesis = Synthesis::square(whole, length_m, seed, Phases::FixedModulus);
    let heights_m = spectrum.surface(&synthesis, 0).expect("a surface").heights_m;
    heights_m.chunks_exact(whole).take(points).flat_map(|row| row[..points].iter().copied()).collect()
}

/// Returns a mask that is true at missing points, which make up this share, and the typical size of a hole in points.
pub fn holes(kind: HoleKind, share: f64, heights_m: &[f64], points: usize, seed: u64) -> (Vec<bool>, f64) {
    let mut random = Random(seed);
    let mut gaps = vec![false; points * points];
    let wanted = (share * gaps.len() as f64) as usize;
    let size = match kind {
        HoleKind::Dropouts => {
            scatter(&mut gaps, points, wanted, &mut random, |random| 0.5 + 2.0 * random.next().powi(3));
            2.0
        }
        HoleKind::Blobs => {
            let radius = points as f64 / 32.0;
            scatter(&mut gaps, points, wanted, &mut random, |_| radius);
            2.0 * radius
        }
        HoleKind::Border => {
            // 1 - (1 - 2 w/n)^2 of the map.
            let width = (0.5 * points as f64 * (1.0 - (1.0 - share).sqrt())).floor() as usize;
            let inner = width..points - width;
            for (index, gap) in gaps.iter_mut().enumerate() {
                *gap = !(inner.contains(&(index / points)) && inner.contains(&(index % points)));
            }
            width as f64
        }
        HoleKind::Flanks => {
            let slope_squared = |index: usize| {
                let (row, column) = (index / points, index % points);
                let across = |step: usize, at: usize| {
                    let (lower, upper) = (
                        if at > 0 { index - step } else { index },
                        if at + 1 < points { index + step } else { index },
                    );
                    (heights_m[upper] - heights_m[lower]) * if upper - lower == step { 2.0 } else { 1.0 }
                };
                across(1, column).powi(2) + across(points, row).powi(2)
            };
            let mut steepest: Vec<usize> = (0..gaps.len()).collect();
            steepest.sort_by(|&a, &b| slope_squared(b).total_cmp(&slope_squared(a)));
            steepest[..wanted].iter().for_each(|&index| gaps[index] = true);
            mean_run(&gaps, points)
        }
    };
    (gaps, size)
}

/// Discs at random places until enough points lie in one.
fn scatter(
    gaps: &mut [bool],
    points: usize,
    wanted: usize,
    random: &mut Random,
    radius: impl Fn(&mut Random) -> f64,
) {
    let mut lost = 0;
    while lost < wanted {
        let (row, column) = (random.next() * points as f64, random.next() * points as f64);
        let radius = radius(random);
        let reach =
            |centre: f64| (centre - radius).max(0.0) as usize..((centre + radius + 1.0) as usize).min(points);
        for r in reach(row) {
            for c in reach(column) {
                let is_inside = (r as f64 - row.floor()).hypot(c as f64 - column.floor()) <= radius;
                if is_inside && lost < wanted && !std::mem::replace(&mut gaps[r * points + c], true) {
                    lost += 1;
                }
            }
        }
    }
}

/// The length along x of the hole that a lost point lies in, on average over these points.
fn mean_run(gaps: &[bool], points: usize) -> f64 {
    let rows = gaps.chunks_exact(points);
    let runs =
        rows.flat_map(|row| row.split(|gap| !gap).map(|run| run.len() as f64).filter(|&length| length > 0.0));
    let (squares, lengths) =
        runs.fold((0.0, 0.0), |(squares, lengths), run| (squares + run * run, lengths + run));
    squares / lengths
}

/// Spectrum of a treated map over that of the whole map.
pub struct Bias {
    /// Wavelength over the size of a hole, and the ratio of C1D, ten bins to the decade.
    pub spectrum: Vec<(f64, f64)>,
    pub rms_slope: f64,
}

/// The map with and without its gaps; none where the treatment refuses them.
pub fn bias(
    heights_m: &[f64],
    points: usize,
    gaps: &[bool],
    size: f64,
    treatment: GapTreatment,
) -> Option<Bias> {
    let spectrum = |scan: MeasuredScan| {
        let recipe = Recipe { direction: Direction::X, ..Recipe::default() };
        let whole = without_gaps(file_of(scan), treatment).ok()?;
        ScanSpectrum::new(whole, BandLimits::default(), &recipe).ok()
    };
    let map = |is_gap: &dyn Fn(usize, usize) -> bool| {
        map_with_gaps(points, points, [SPACING_M; 2], |row, column| heights_m[row * points + column], is_gap)
    };
    let whole = spectrum(map(&|_, _| false))?;
    let found = spectrum(map(&|row, column| gaps[row * points + column]))?;
    let expected = binned(&whole);
    let ratio = |(bin, (wavelength_m, c1d_m3)): (i64, (f64, f64))| {
        let (_, expected_m3) = expected.get(&bin)?;
        Some((wavelength_m / (size * SPACING_M), c1d_m3 / expected_m3))
    };
    Some(Bias {
        spectrum: binned(&found).into_iter().filter_map(ratio).collect(),
        rms_slope: found.checks.real_slope / whole.checks.real_slope,
    })
}

fn binned(scan: &ScanSpectrum) -> BTreeMap<i64, (f64, f64)> {
    let psd = log_binned(&scan.reliable, DEFAULT_BINS_PER_DECADE, BinMean::Arithmetic);
    let samples = psd.wavelengths_m().iter().zip(psd.c1d_m3());
    samples
        .map(|(&wavelength_m, &c1d_m3)| {
            (((TAU / wavelength_m).log10() * 10.0).floor() as i64, (wavelength_m, c1d_m3))
        })
        .collect()
}
