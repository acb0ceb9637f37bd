//! Assembly of a channel to a scan: choice of channel, unit and size.

use crate::channel::{Channel, Lateral, Quantity, UNNAMED, UnitsBy};
use crate::choice_of_size;
use crate::choice_of_size::refuse_size;
use crate::choice_of_units::{Units, own_scale_note, refuse_unit};
use crate::error::{FilePlace, ScanReadError};
use crate::file::ScanFile;
use crate::format::{FormatCheck, ScanFormat, UNCHECKED};
use crate::heights::{HeightMap, NonuniformLineScan, Scan, UniformLineScan};
use crate::measured::MeasuredScan;
use crate::metadata::MeasurementMetadata;
use crate::options::{IGNORED, ScanOptions};
use crate::raster::Decoded;
use crate::scan_size::ScanSize;
use units::LengthUnit;
use units::display::length;

/// Relative difference of the sizes in metadata and file above which a note says so.
const SIZE_AGREEMENT: f64 = 1e-4;

/// Relative difference of the stated size and that of the points above which a note says so.
const STATED_AGREEMENT: f64 = 0.01;

/// The channel asked for, else the one that the metadata chose, else the first of heights.
pub(crate) fn chosen<'b>(
    format: ScanFormat,
    channels: Vec<Channel<'b>>,
    options: &ScanOptions,
) -> Result<Channel<'b>, ScanReadError> {
    let label = |channel: &Channel| channel.name.clone().unwrap_or_else(|| UNNAMED.to_owned());
    let all: Vec<String> = channels.iter().map(label).collect();
    let (found, wanted) = if let Some(wanted) = &options.channel {
        let exactly = all.iter().position(|name| name == wanted);
        let loosely = || {
            let fits = |&at: &usize| is_short_for(wanted, &all[at]);
            let is_heights = |&at: &usize| fits(&at) && channels[at].is_heights();
            (0..all.len()).find(is_heights).or_else(|| (0..all.len()).find(fits))
        };
        (exactly.or_else(loosely), format!("channel '{wanted}'"))
    } else if let Some(source) = options.metadata.as_ref().and_then(|metadata| metadata.data_source) {
        let found = (source < all.len()).then_some(source);
        // A file of one channel leaves nothing to choose.
        (found.or((all.len() == 1).then_some(0)), format!("image number {source}, counted from 0"))
    } else {
        let heights = || channels.iter().enumerate().filter(|(_, channel)| channel.is_heights());
        // If no channel can be read, the error of the first says why.
        let found = heights().find(|(_, channel)| channel.is_readable()).or_else(|| heights().next());
        let Some((at, _)) = found else {
            return Err(ScanReadError::NoHeightChannel { format, channels: all });
        };
        (Some(at), String::new())
    };
    let found = found.and_then(|at| channels.into_iter().nth(at));
    found.ok_or(ScanReadError::NoChannel { format, wanted, channels: all })
}

/// The names of the channels with heights, of those that have one.
pub(crate) fn names_of_heights(channels: &[Channel<'_>]) -> Vec<String> {
    let heights = channels.iter().filter(|channel| channel.is_heights());
    heights.filter_map(|channel| channel.name.clone()).collect()
}

/// Returns true if a name is that of a channel without its number, or without the direction or title in brackets too, or
/// the number of a column without a name.
fn is_short_for(short: &str, name: &str) -> bool {
    let plain = match name.rsplit_once(" #") {
        Some((plain, number)) if number.parse::<usize>().is_ok() => plain,
        _ => name,
    };
    let bare = plain.strip_suffix(')').and_then(|name| name.split_once(" (")).map_or(plain, |(name, _)| name);
    short == plain || short == bare || name.strip_prefix("column ") == Some(short)
}

/// Decodes a channel, completed from options and metadata. `with_heights` lists all channels of heights.
pub(crate) fn assembled(
    format: ScanFormat,
    channel: Channel<'_>,
    with_heights: &[String],
    name: &str,
    options: &ScanOptions,
) -> Result<ScanFile, ScanReadError> {
    let measure = channel.measure();
    let Channel { quantity, lateral, samples, units, mut notes, .. } = channel;
    let height_to_m: Option<Box<dyn Fn(f64) -> f64>> = match (units, &quantity) {
        (UnitsBy::Asker, _) => {
            Some(Box::new(Units::choose(options, None, None, &mut notes).height_to_m(format)?))
        }
        (UnitsBy::Format, _) => {
            refuse_unit(format, options)?;
            notes.extend(own_scale_note(options));
            let unused = options.fallback_unit.or(options.fallback_height_unit);
            notes.extend(unused.map(|unit| format!("{IGNORED}the unit {unit}: the file has its own")));
            to_m(&quantity)
        }
        (UnitsBy::Reader, _) => to_m(&quantity),
    };
    if matches!(format.check(), FormatCheck::MadeFiles(_)) {
        notes.push(UNCHECKED.to_owned());
    }
    let (columns, mut decoded) = samples.decode(format)?;
    if let Some(height_to_m) = height_to_m {
        decoded.values.iter_mut().for_each(|value| *value = height_to_m(*value));
    }
    let scan = scan(format, columns, decoded, lateral, options, &mut notes)?;
    notes.extend(stated_note(&scan, channel.stated_m, columns));
    let metadata = options.metadata.as_ref();
    if options.size.is_none() {
        notes.extend(metadata.and_then(|metadata| size_note(&scan, metadata.size()?)));
    }
    let of_metadata = |get: fn(&MeasurementMetadata) -> Option<f64>| metadata.and_then(get);
    let periodic = metadata.and_then(|metadata| metadata.is_periodic);
    let described = metadata.and_then(|metadata| metadata.description.clone());
    let free_text = [Some(channel.free_text), described].into_iter().flatten().collect::<Vec<_>>().join("\n");
    Ok(ScanFile {
        name: metadata.map_or(name, |metadata| &metadata.name).to_owned(),
        format,
        scan,
        measure,
        channel: channel.name,
        channels: with_heights.to_vec(),
        fast_axis: channel.fast_axis,
        is_periodic: channel.is_periodic.or(periodic).unwrap_or(false),
        probe: channel.probe.or(metadata.and_then(|metadata| metadata.probe)),
        tip_radius_m: channel.tip_radius_m.or(of_metadata(|metadata| metadata.tip_radius_m)),
        resolution_m: channel.resolution_m.or(of_metadata(|metadata| metadata.resolution_m)),
        free_text,
        notes,
    })
}

/// Returns the conversion of values to m; none where they are in m, or are not lengths.
fn to_m(quantity: &Quantity) -> Option<Box<dyn Fn(f64) -> f64>> {
    match *quantity {
        Quantity::Heights(Some(unit)) | Quantity::OtherLength(unit) if unit != LengthUnit::METRE => {
            Some(Box::new(move |value| unit.to_m(value)))
        }
        _ => None,
    }
}

/// Places the values of a channel.
fn scan(
    format: ScanFormat,
    columns: usize,
    decoded: Decoded,
    lateral: Lateral,
    options: &ScanOptions,
    notes: &mut Vec<String>,
) -> Result<MeasuredScan, ScanReadError> {
    let rows = decoded.values.len() / columns.max(1);
    let stated = match lateral {
        Lateral::Positions(positions_m) => {
            refuse_size(format, FilePlace::File, options)?;
            let unused = options.fallback_size;
            notes
                .extend(unused.map(|size| format!("{IGNORED}the size {size}: every point has its position")));
            return uneven_line(positions_m, decoded, notes);
        }
        Lateral::Unknown => None,
        Lateral::Size(size) => Some(size),
        Lateral::Spacing { x_m, y_m } => {
            let y_m = y_m.filter(|_| rows > 1).map(|y_m| y_m * rows as f64);
            Some(ScanSize { x_m: x_m * columns as f64, y_m })
        }
    };
    let size = choice_of_size::size(options, stated, notes).ok_or_else(|| {
        let what = if rows > 1 { "how large the map is" } else { "how long the line of heights is" };
        ScanReadError::NoSize { format, what }
    })?;
    // A spacing given by the file is kept: multiplying and dividing it again would round it.
    let spacing = match lateral {
        Lateral::Spacing { x_m, y_m } if Some(size) == stated => Some((x_m, y_m)),
        _ => None,
    };
    let Decoded { values, missing } = decoded;
    let scan = match (rows, spacing) {
        (0 | 1, Some((x_m, _))) => Scan::UniformLine(UniformLineScan::new(x_m, values)?),
        (0 | 1, None) => size.line(values)?,
        (_, Some((x_m, Some(y_m)))) => Scan::Map(HeightMap::new(columns, x_m, y_m, values)?),
        (_, _) => size.map(columns, values, notes)?,
    };
    Ok(MeasuredScan::with_missing_points(scan, missing))
}

/// A line without the points that have no height: neighbours may lie at any distance.
fn uneven_line(
    positions_m: Vec<f64>,
    decoded: Decoded,
    notes: &mut Vec<String>,
) -> Result<MeasuredScan, ScanReadError> {
    let missing = &decoded.missing;
    if !missing.is_empty() {
        let (count, points) = (missing.count(), positions_m.len());
        notes.push(format!(
            "{count} of {points} points have no height and are left out of the unevenly spaced line"
        ));
    }
    let measured = |values: Vec<f64>| -> Vec<f64> {
        if missing.is_empty() {
            return values;
        }
        values
            .into_iter()
            .enumerate()
            .filter(|(index, _)| !missing.contains(*index))
            .map(|(_, value)| value)
            .collect()
    };
    let line = NonuniformLineScan::new(measured(positions_m), measured(decoded.values))?;
    Ok(Scan::NonuniformLine(line).into())
}

/// Tells of a stated size that is not that of the points in the file, as where it is cut off. Points times spacing and
/// the distance of the ends differ by one spacing.
fn stated_note(scan: &MeasuredScan, stated_m: [Option<f64>; 2], columns: usize) -> Option<String> {
    let (x_m, y_m) = scan.size_m();
    let note = |what: &str, found_m: Option<f64>, stated_m: Option<f64>, points: usize| {
        let (found_m, stated_m) = found_m.zip(stated_m)?;
        let differs = (found_m / stated_m - 1.0).abs() > STATED_AGREEMENT + 1.5 / points as f64;
        let [found, stated] = [found_m, stated_m].map(length);
        differs.then(|| {
            format!("the header says {stated} {what}, the points are {found} {what}; is the file cut off?")
        })
    };
    let rows = scan.heights_m().len() / columns.max(1);
    note("long", Some(x_m), stated_m[0], columns).or_else(|| note("wide", y_m, stated_m[1], rows))
}

/// Tells of a size in the metadata that is not that of the file.
fn size_note(scan: &MeasuredScan, stated: ScanSize) -> Option<String> {
    let (x_m, y_m) = scan.size_m();
    let agrees = |found: f64, stated: f64| (found - stated).abs() <= SIZE_AGREEMENT * stated.abs();
    let y_agrees = y_m.zip(stated.y_m).is_none_or(|(found, stated)| agrees(found, stated));
    (!agrees(x_m, stated.x_m) || !y_agrees).then(|| {
        let found = ScanSize { x_m, y_m };
        format!("the metadata give the size as {stated}, the file as {found}: the file counts")
    })
}
