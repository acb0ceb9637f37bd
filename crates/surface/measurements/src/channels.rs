//! Channels of the files of instruments, one row each.

use roughness::{HeightParameters, Parameter};
use scans::{Measure, Probe, ScanAxis, ScanFile, Statistics, visit_channels};
use tables::Table;
use units::SceneKeys;
use units::display::{counted, length};
use units::printable::printable_line;

use crate::error::{ScanProblem, TopographyError};
use crate::files::{Files, file_name};
use crate::load::{bytes_of_scans, options};
use crate::request::ScanRequest;

/// The channels of some files.
#[derive(Debug, Default)]
#[non_exhaustive]
pub struct Channels {
    /// One row per channel.
    rows: Vec<Row>,
    /// Files that cannot be read, with the error of each.
    pub unreadable: Vec<TopographyError>,
}

/// A channel in numbers; `None` where a number is not known.
#[derive(Debug, Default, Clone, PartialEq)]
struct Row {
    file: String,
    format: String,
    channel: String,
    points: Option<(usize, usize)>,
    size_x_m: Option<f64>,
    size_y_m: Option<f64>,
    rms_height_m: Option<f64>,
    peak_to_valley_m: Option<f64>,
    gaps: Option<usize>,
    rms_slope_x: Option<f64>,
    rms_slope_y: Option<f64>,
    note: String,
    roughness: Vec<Parameter>,
}

impl Channels {
    /// Lists the channel of a scan in memory.
    #[must_use]
    pub fn from_scan(request: &ScanRequest, file: &ScanFile) -> Self {
        Channels { rows: vec![Row::new(request, file)], unreadable: Vec::new() }
    }

    /// Describes the channels for people: kind, size, points, missing points, roughness parameters and notes.
    #[must_use]
    pub fn describe(&self) -> String {
        self.rows.iter().map(|row| row.describe() + "\n").collect()
    }

    /// Makes a table with the columns `file, format, channel, points_x, points_y, size_x_m, size_y_m, rms_height_m,
    /// peak_to_valley_m, gaps, rms_slope_x, rms_slope_y, note`.
    ///
    /// `gaps` counts missing points. A line has one point along y and no size there. For channels that measure no
    /// length, rms and peak to valley are in the note, with their unit.
    #[must_use]
    pub fn table(&self) -> Table {
        let text = |of: fn(&Row) -> &String| self.rows.iter().map(move |row| of(row).clone());
        let number = |of: fn(&Row) -> Option<f64>| self.rows.iter().map(of);
        let count =
            |of: fn(&Row) -> Option<usize>| self.rows.iter().map(move |row| of(row).map(|n| n as f64));
        Table::default()
            .with_text("file", text(|row| &row.file))
            .with_text("format", text(|row| &row.format))
            .with_text("channel", text(|row| &row.channel))
            .with_numbers("points_x", count(|row| row.points.map(|(x, _)| x)))
            .with_numbers("points_y", count(|row| row.points.map(|(_, y)| y)))
            .with_numbers("size_x_m", number(|row| row.size_x_m))
            .with_numbers("size_y_m", number(|row| row.size_y_m))
            .with_numbers("rms_height_m", number(|row| row.rms_height_m))
            .with_numbers("peak_to_valley_m", number(|row| row.peak_to_valley_m))
            .with_numbers("gaps", count(|row| row.gaps))
            .with_numbers("rms_slope_x", number(|row| row.rms_slope_x))
            .with_numbers("rms_slope_y", number(|row| row.rms_slope_y))
            .with_text("note", text(|row| &row.note))
    }
}

impl Row {
    /// Describes the channel in a few lines, in um and nm with three digits.
    fn describe(&self) -> String {
        let title = [&self.file, &self.format, &self.channel];
        let title = title.map(String::as_str).into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>();
        let mut lines = vec![title.join(" - ")];
        if let (Some((x, y)), Some(size_x_m)) = (self.points, self.size_x_m) {
            let missing = match self.gaps {
                None | Some(0) => "none missing".to_owned(),
                Some(missing) => format!("{} missing", counted(missing, "point")),
            };
            lines.push(match self.size_y_m {
                Some(size_y_m) => {
                    format!("map, {} x {}, {x} x {y} points, {missing}", length(size_x_m), length(size_y_m))
                }
                None => format!("profile, {}, {x} points, {missing}", length(size_x_m)),
            });
        }
        lines.push(self.roughness.iter().map(ToString::to_string).collect::<Vec<_>>().join(", "));
        lines.push(self.note.clone());
        lines.retain(|line| !line.is_empty());
        // Names and notes come from files; a terminal would obey their control characters.
        lines.iter().map(|line| printable_line(line)).collect::<Vec<_>>().join("\n  ")
    }
}

/// Reads the height channels of files, or all channels with `all_channels`, one at a time, and passes each to `see`.
///
/// # Errors
/// Errors of `see`. Files that cannot be read are listed in [`Channels::unreadable`]; the error of a channel is its
/// note.
pub fn read_channels<E>(
    requests: &[ScanRequest],
    files: &dyn Files,
    all_channels: bool,
    mut see: impl FnMut(&ScanRequest, &ScanFile) -> Result<(), E>,
) -> Result<Channels, E> {
    let mut found = Channels::default();
    for request in requests {
        let mut seen = Ok(());
        let rows = channels_of(request, files, all_channels, &mut |file| {
            if seen.is_ok() {
                seen = see(request, file);
            }
        });
        seen?;
        match rows {
            Ok(rows) => found.rows.extend(rows),
            Err(error) => found.unreadable.push(error),
        }
    }
    Ok(found)
}

fn channels_of(
    request: &ScanRequest,
    files: &dyn Files,
    all_channels: bool,
    see: &mut dyn FnMut(&ScanFile),
) -> Result<Vec<Row>, TopographyError> {
    let blame = |problem| TopographyError::for_file(&request.path, problem);
    request.check_takes(&ScanRequest::OF_HEIGHTS)?;
    let bytes = bytes_of_scans(request, files)?;
    let options = options(request, files)?;
    let (mut rows, mut first_error, mut is_any_read) = (Vec::new(), None, false);
    let visited =
        visit_channels(&bytes, file_name(&request.path), &options, all_channels, |channel| match channel {
            Ok(file) => {
                is_any_read = true;
                rows.push(Row::new(request, &file));
                see(&file);
            }
            Err(error) => {
                rows.push(Row { file: request.path.clone(), note: error.to_string(), ..Row::default() });
                first_error.get_or_insert(error);
            }
        });
    visited.map_err(|error| blame(ScanProblem::Format(Box::new(error))))?;
    match first_error {
        // The file fails only if none of its channels can be read.
        Some(error) if !is_any_read => Err(blame(ScanProblem::Format(Box::new(error)))),
        _ => Ok(rows),
    }
}

impl Row {
    fn new(request: &ScanRequest, file: &ScanFile) -> Self {
        let scan = &file.scan;
        let (points_x, points_y) = scan.points();
        let (size_x_m, size_y_m) = scan.size_m();
        let found = Statistics::from_scan(scan);
        let in_m = found.filter(|_| !matches!(file.measure, Measure::Other(_)));
        Row {
            file: request.path.clone(),
            format: file.format.to_string(),
            channel: channel(request, file),
            points: Some((points_x, points_y.unwrap_or(1))),
            size_x_m: Some(size_x_m),
            size_y_m,
            rms_height_m: in_m.map(|found| found.rms_height_m),
            peak_to_valley_m: in_m.map(|found| found.peak_to_valley_m),
            gaps: Some(scan.missing_points().count()),
            rms_slope_x: in_m.and_then(|found| found.rms_slope_x),
            rms_slope_y: in_m.and_then(|found| found.rms_slope_y),
            note: note(file, found),
            roughness: in_m
                .and_then(|_| HeightParameters::from_scan(scan))
                .map_or_else(Vec::new, |found| found.parameters()),
        }
    }
}

/// Names the channel, after its measurement if that differs from the file.
pub(crate) fn channel(request: &ScanRequest, file: &ScanFile) -> String {
    let measurement = (file.name != file_name(&request.path)).then(|| file.name.clone());
    [measurement, file.channel.clone()].into_iter().flatten().collect::<Vec<_>>().join(": ")
}

/// Describes properties of a channel that its numbers do not show.
fn note(file: &ScanFile, found: Option<Statistics>) -> String {
    let mut parts = Vec::new();
    match (&file.measure, found) {
        (Measure::Height, _) => {}
        (Measure::Length, _) => parts.push("a length, but not a height".to_owned()),
        (Measure::Other(unit), Some(found)) => parts.push(format!(
            "not a length: rms {:.6e} {unit} about the mean, peak to valley {:.6e} {unit}",
            found.rms_height_m, found.peak_to_valley_m
        )),
        (Measure::Other(unit), None) => parts.push(format!("not a length, in {unit}")),
    }
    if found.is_none() {
        parts.push("no point has a value".to_owned());
    }
    if file.scan.positions_m().is_some() {
        parts.push("unevenly spaced".to_owned());
    }
    match file.fast_axis {
        Some(ScanAxis::X) => parts.push("fast axis x".to_owned()),
        Some(ScanAxis::Y) => parts.push("fast axis y".to_owned()),
        None => {}
    }
    match (file.probe, file.tip_radius_m) {
        (_, Some(radius_m)) => parts.push(format!("tip radius {}", length(radius_m))),
        (Some(Probe::Microscope), None) => parts.push("no tip".to_owned()),
        _ => {}
    }
    let doubt = found.as_ref().filter(|_| file.measure == Measure::Height);
    let doubt = doubt.and_then(|found| topography::doubt_of_scan(&file.scan, found));
    parts.extend(doubt.map(|doubt| doubt.words(&SceneKeys)));
    parts.extend(file.notes.iter().cloned());
    parts.join("; ")
}
