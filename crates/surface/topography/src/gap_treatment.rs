//! Treatment of missing points, those without a height.

use scans::{MeasuredScan, Scan, ScanFile};
use serde::{Deserialize, Serialize};
use units::display::{counted, length};

use crate::cut_lines::{Cut, cut};
use crate::error::TransformError;
use crate::harmonic::harmonic_m;
use crate::holes::{Holes, extent, points};

/// Treatment of missing points, those of a scan without a height.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum GapTreatment {
    /// Refuses scans with missing points.
    Refuse,
    /// Fills missing points by the harmonic surface through the points around them: Laplace's equation with the heights
    /// around a patch as boundary values, flat at the edge of the map. In a line, a straight line from end to end.
    /// Fills up to [`MOST_FILLED`] of the points.
    #[default]
    Harmonic,
    /// Uses only lines, or stretches of lines, without missing points: whole rows if they hold at least half of the
    /// measured points, else stretches of the one length that keeps most points.
    ///
    /// Stretches have no wavelengths beyond their length. If points are missing on steep flanks, the stretches lie
    /// where the surface is flat, and the spectrum is too low.
    Lines,
    /// Keeps them: they never touch. For maps that are pressed; spectra refuse them.
    Keep,
}

units::named!(GapTreatment, "treatment of gaps", {
    Refuse => "refuse", Harmonic => "harmonic", Lines => "lines", Keep => "keep",
});

/// Largest share of missing points that is filled.
pub const MOST_FILLED: f64 = 0.2;

/// Removes missing points from the scan of a file, with a note on the treatment.
///
/// # Errors
/// [`TransformError::Gaps`] if they are refused or kept, [`TransformError::TooManyGaps`] for more than are filled,
/// [`TransformError::NoLines`] if no line without them is left, [`TransformError::NoHeights`] if no point has a height.
pub fn without_gaps(file: ScanFile, treatment: GapTreatment) -> Result<ScanFile<Scan>, TransformError> {
    let is_refused = matches!(treatment, GapTreatment::Refuse | GapTreatment::Keep);
    if is_refused || file.scan.missing_points().is_empty() {
        return file.try_map(|scan| Ok(scan.complete()?));
    }
    let count = count(&file.scan);
    let gaps = file.scan.missing_points().count();
    if gaps >= count {
        return Err(TransformError::NoHeights { points: count });
    }
    let share = gaps as f64 / count as f64;
    match treatment {
        GapTreatment::Lines => lines_only(file, share),
        _ if share > MOST_FILLED => Err(TransformError::TooManyGaps { share, bound: MOST_FILLED }),
        _ => filled(file, share),
    }
}

fn count(scan: &MeasuredScan) -> usize {
    let (columns, rows) = scan.points();
    columns * rows.unwrap_or(1)
}

fn filled(file: ScanFile, share: f64) -> Result<ScanFile<Scan>, TransformError> {
    let (columns, rows) = file.scan.points();
    let holes = Holes::new(file.scan.missing_points().indices(), columns);
    let heights_m = match rows {
        Some(_) => harmonic_m(&file.scan, &holes),
        None => interpolated_m(&file.scan),
    };
    let surface = if rows.is_some() { "harmonic surface" } else { "straight line" };
    let note = format!(
        "{} of the points have no height ({}, the largest {}): filled by the {surface} through the points around them",
        percent(share),
        counted(holes.count(), "hole"),
        size_of_largest(&holes, &file.scan)
    );
    let mut file = file.try_map(|scan| scan.filled(&heights_m))?;
    file.notes.push(note);
    Ok(file)
}

/// Interpolates the missing points of a line \[m\]: straight lines between the points beside them, level at the ends.
fn interpolated_m(line: &MeasuredScan) -> Vec<f64> {
    let (points, _) = line.points();
    let known = |index: usize| line.height_m(index).map(|height_m| (index, height_m));
    let (mut before, mut after) = (None, (0..points).find_map(known));
    let mut heights_m = Vec::with_capacity(line.missing_points().count());
    for index in 0..points {
        if let Some(here) = known(index) {
            before = Some(here);
            continue;
        }
        if after.is_some_and(|(at, _)| at < index) {
            after = (index..points).find_map(known);
        }
        heights_m.push(match (before, after) {
            (Some((from, from_m)), Some((to, to_m))) => {
                let share = (index - from) as f64 / (to - from) as f64;
                let height_m = (1.0 - share) * from_m + share * to_m;
                // Below the normal doubles a sum of two shares may round beyond both.
                height_m.clamp(from_m.min(to_m), from_m.max(to_m))
            }
            (Some((_, height_m)), None) | (None, Some((_, height_m))) => height_m,
            (None, None) => 0.0, // a line without any height, refused before
        });
    }
    heights_m
}

fn size_of_largest(holes: &Holes, scan: &MeasuredScan) -> String {
    let Some(largest) = (0..holes.count()).rev().max_by_key(|&hole| points(holes.hole(hole))) else {
        return length(0.0);
    };
    let (rows, columns) = extent(holes.hole(largest));
    let (x_m, y_m) = scan.spacing_m();
    let along_x = length(x_m * columns.len() as f64);
    y_m.map_or(along_x.clone(), |y_m| format!("{along_x} x {}", length(y_m * rows.len() as f64)))
}

fn lines_only(file: ScanFile, share: f64) -> Result<ScanFile<Scan>, TransformError> {
    let Cut { lines, is_whole } = cut(&file.scan)?;
    let (whole, kept) = (if is_whole { "whole lines" } else { "stretches" }, lines.heights_m().len());
    let note = format!(
        "{} of the points have no height: {} {whole} of {} ({} points each) without missing points are used, {} of the points",
        percent(share),
        lines.lines(),
        length(lines.length_m()),
        lines.points(),
        percent(kept as f64 / count(&file.scan) as f64)
    );
    let mut file = file.try_map(|_| Ok::<Scan, TransformError>(Scan::Lines(lines)))?;
    file.is_periodic &= is_whole;
    file.notes.push(note);
    Ok(file)
}

/// Formats a share in percent; a small one is not rounded to zero.
fn percent(share: f64) -> String {
    if share < 1e-4 { "less than 0.01 %".to_owned() } else { format!("{:.2} %", 100.0 * share) }
}
