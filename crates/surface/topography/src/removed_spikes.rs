//! Removal of spikes before the spectrum of a scan.

use scans::{IGNORED, MeasuredScan, ScanFile};
use units::display::counted;

use crate::error::TransformError;

/// Least distance of a spike from the median of its neighbours, over the median of such distances; 13 standard deviations of
/// Gaussian ones.
const FAR: f64 = 20.0;
/// Neighbours on either side along the line; spikes of two points leave their median.
const REACH: usize = 3;
/// Largest share of points that are spikes, not edges of the surface.
const FEW: f64 = 5e-3;

/// Takes the heights of spikes away, which then are missing points; with a note on their number.
///
/// A spike lies 20 times as far from the median of the three points on either side of it along the line as points do in the
/// median. If they are more than 0.5 % of all points, they are edges of the surface, and none is removed.
///
/// # Errors
/// [`TransformError`] if too few points are left.
pub fn without_spikes(file: ScanFile) -> Result<ScanFile, TransformError> {
    let spikes = spikes(&file.scan);
    if spikes.is_empty() {
        let mut file = file;
        file.notes.push(format!("{IGNORED}the removal of spikes: there are none"));
        return Ok(file);
    }
    let note = format!(
        "{} removed: over {FAR} times as far from the points beside as others are",
        counted(spikes.len(), "spike")
    );
    let mut file = file.try_map(|scan| scan.without_points(&spikes))?;
    file.notes.push(note);
    Ok(file)
}

fn spikes(scan: &MeasuredScan) -> Vec<usize> {
    let (columns, _) = scan.points();
    let heights_m: Vec<Option<f64>> = scan.heights_m().collect();
    let rows = heights_m.chunks(columns).enumerate();
    let distances_m: Vec<(usize, f64)> = rows
        .flat_map(|(row, heights_m)| {
            (0..heights_m.len()).filter_map(move |at| Some((row * columns + at, distance_m(heights_m, at)?)))
        })
        .collect();
    let mut sorted: Vec<f64> = distances_m.iter().map(|(_, distance_m)| *distance_m).collect();
    let Some(middle) = sorted.len().checked_sub(1).map(|last| last / 2) else { return Vec::new() };
    let usual_m = *sorted.select_nth_unstable_by(middle, f64::total_cmp).1;
    let is_far = |(_, distance_m): &(usize, f64)| *distance_m > FAR * usual_m;
    let far: Vec<usize> = distances_m.into_iter().filter(is_far).map(|(index, _)| index).collect();
    let most = (FEW * heights_m.len() as f64).max(1.0);
    if usual_m > 0.0 && far.len() as f64 <= most { far } else { Vec::new() }
}

/// Distance \[m\] of a height from the median of its neighbours along the line; `None` without it or them.
fn distance_m(heights_m: &[Option<f64>], at: usize) -> Option<f64> {
    let near = at.saturating_sub(REACH)..(at + REACH + 1).min(heights_m.len());
    let mut others: Vec<f64> =
        near.filter(|other| *other != at).filter_map(|other| heights_m[other]).collect();
    others.sort_by(f64::total_cmp);
    let last = others.len().checked_sub(1)?;
    Some((heights_m[at]? - 0.5 * (others[last / 2] + others[last.div_ceil(2)])).abs())
}
