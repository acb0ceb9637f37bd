//! Vision64 of Bruker, which drives Dektak styli and Contour interferometers: `.opdx`.
//!
//! A tree of named values of many types, as the readers of Gwyddion and SurfaceTopography take it: profiles below
//! `1D_Data`, maps below `2D_Data`, and what was set and measured below `MetaData`.

mod stream;

use std::collections::HashMap;

use stream::{Tree, Value};

use crate::channel::{
    Channel, Lateral, MOST_TEXT, Quantity, Samples, is_named_after_height, refuse_many, shortened,
};
use crate::cursor::{ByteOrder, Cursor};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::numbers;
use crate::options::ScanOptions;
use crate::raster::{NumberType, Raster};
use crate::readers::Reader;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::Vision64;
const PROFILES: &str = "/1D_Data/";
const MAPS: &str = "/2D_Data/";
const PRIMARY_MAP: &str = "/MetaData/PrimaryData2D";
const SETTINGS: &str = "/MetaData/MeasurementSettings/";
/// Bytes before the numbers of a profile: their type and count.
const BEFORE_NUMBERS: usize = 5;
/// Last parts of the paths of what people write.
const TEXTS: [&str; 6] = ["Title", "Note", "Notes", "Comment", "Comments", "Description"];

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    bytes.starts_with(stream::MAGIC)
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let tree = Tree::read(bytes)?;
    let primary = tree.text(PRIMARY_MAP).map(|name| format!("{MAPS}{name}"));
    let mut groups: Vec<&str> = tree.paths().filter_map(group).collect();
    refuse_many(FORMAT, groups.len())?;
    // The map shown first is the first to be read.
    groups.sort_by_key(|&group| primary.as_deref() != Some(group));
    let kinds: Vec<String> = groups.iter().map(|group| kind(&tree, group)).collect();
    let mut groups_of_kind: HashMap<&str, usize> = HashMap::new();
    kinds.iter().for_each(|kind| *groups_of_kind.entry(kind).or_default() += 1);
    let is_unique = |kind: &str| groups_of_kind.get(kind) == Some(&1);
    let label = |(group, kind): (&&str, &String)| {
        let own = group.rsplit('/').next().unwrap_or_default();
        if is_unique(kind) { kind.clone() } else { format!("{kind} ({own})") }
    };
    let labels: Vec<String> = groups.iter().zip(&kinds).map(label).collect();
    let about = About { probe: probe(&tree), tip_radius_m: tip_radius_m(&tree), free_text: free_text(&tree) };
    let channels = groups.iter().zip(&kinds).zip(labels);
    Ok(channels.map(|((group, kind), label)| channel(bytes, &tree, group, kind, label, &about)).collect())
}

/// Joins the texts on instrument and specimen.
struct About {
    probe: Option<Probe>,
    tip_radius_m: Option<f64>,
    free_text: String,
}

/// The group of a path to the numbers of a profile or a map: `/2D_Data/Raw`.
fn group(path: &str) -> Option<&str> {
    let is_own = |group: &str, parent: &str| group.strip_prefix(parent).is_some_and(|own| !own.contains('/'));
    let profile = path.strip_suffix("/Array").filter(|group| is_own(group, PROFILES));
    profile.or_else(|| path.strip_suffix("/Matrix").filter(|group| is_own(group, MAPS)))
}

/// Kind of a group, in the words of the file.
fn kind(tree: &Tree, group: &str) -> String {
    let own = || group.rsplit('/').next().unwrap_or_default();
    tree.text(&format!("{group}/DataKind")).unwrap_or_else(own).to_owned()
}

fn channel<'b>(
    bytes: &'b [u8],
    tree: &Tree,
    group: &str,
    kind: &str,
    label: String,
    about: &About,
) -> Channel<'b> {
    let (scale, unit) = tree.quantity(&format!("{group}/DataScale")).unwrap_or((1.0, ""));
    let quantity = match length_unit(unit) {
        Some(unit) if is_named_after_height(kind) || kind == "Raw" => Quantity::Heights(Some(unit)),
        Some(unit) => Quantity::OtherLength(unit),
        None => Quantity::Other(unit.to_owned()),
    };
    let is_profile = group.starts_with(PROFILES);
    let raster = if is_profile { profile(bytes, tree, group) } else { map(bytes, tree, group) };
    let (lateral, samples) = match raster {
        Ok(raster) => {
            let axes = if is_profile { ["Extent", ""] } else { ["Dimension2Extent", "Dimension1Extent"] };
            let x_m = spacing_m(tree, &format!("{group}/{}", axes[0]), raster.columns);
            let y_m = spacing_m(tree, &format!("{group}/{}", axes[1]), raster.rows);
            let lateral = match (x_m, y_m) {
                (Some(x_m), y_m) if is_profile || y_m.is_some() => Lateral::Spacing { x_m, y_m },
                _ => Lateral::Unknown,
            };
            (lateral, Samples::Raster(Raster { scale, ..raster }))
        }
        Err(error) => (Lateral::Unknown, Samples::Unreadable(Box::new(error))),
    };
    Channel {
        probe: about.probe,
        tip_radius_m: about.tip_radius_m,
        free_text: about.free_text.clone(),
        ..Channel::new(Some(label), quantity, lateral, samples)
    }
}

fn profile<'b>(bytes: &'b [u8], tree: &Tree, group: &str) -> Result<Raster<'b>, ScanReadError> {
    let Some(&Value::Numbers { offset, length }) = tree.get(&format!("{group}/Array")) else {
        return Err(missing(format!("array of numbers '{group}/Array'")));
    };
    let held = length.saturating_sub(BEFORE_NUMBERS) / NumberType::F64.bytes();
    let points = match tree.number(&format!("{group}/NumPoints")) {
        Some(points) if points != held as f64 => {
            let cursor = Cursor::new(FORMAT, bytes, ByteOrder::Little);
            let bound = format!("the {held} of its array");
            return Err(cursor.bad(offset, &format!("'{group}/NumPoints'"), points, &bound));
        }
        _ => held,
    };
    Ok(Raster::within(NumberType::F64, points, 1, bytes, offset.saturating_add(BEFORE_NUMBERS)))
}

fn map<'b>(bytes: &'b [u8], tree: &Tree, group: &str) -> Result<Raster<'b>, ScanReadError> {
    let Some(&Value::Matrix { columns, rows, offset, length }) = tree.get(&format!("{group}/Matrix")) else {
        return Err(missing(format!("matrix of numbers '{group}/Matrix'")));
    };
    let holds = |number: &NumberType| {
        columns.checked_mul(rows).and_then(|points| points.checked_mul(number.bytes())) == Some(length)
    };
    let number = [NumberType::F32, NumberType::F64].into_iter().find(holds).filter(|_| length > 0);
    let number = number.ok_or_else(|| {
        let bound = format!("the {columns} x {rows} points of 4 or 8 bytes");
        let cursor = Cursor::new(FORMAT, bytes, ByteOrder::Little);
        cursor.bad(offset, &format!("the length of '{group}/Matrix'"), length, &bound)
    })?;
    Ok(Raster::within(number, columns, rows, bytes, offset))
}

fn missing(field: String) -> ScanReadError {
    FORMAT.missing(FilePlace::File, field, "export the file again")
}

/// The extent is the distance of the first from the last point.
fn spacing_m(tree: &Tree, path: &str, points: usize) -> Option<f64> {
    let (extent, unit) = tree.quantity(path)?;
    numbers::positive(length_unit(unit)?.to_m(extent) / points.checked_sub(1)? as f64)
}

/// Inches are written with a full stop.
fn length_unit(unit: &str) -> Option<LengthUnit> {
    LengthUnit::parse_instrument(unit.trim_end_matches('.'))
}

/// Returns the probe: a stylus, or light in a mode of its own.
fn probe(tree: &Tree) -> Option<Probe> {
    let setting = |name: &str| tree.text(&format!("{SETTINGS}{name}"));
    let is_stylus = |text: &str| text.to_lowercase().contains("stylus");
    let texts = [setting("InstrumentType"), setting("MeasMode"), tree.text("/MetaData/MeasMode")];
    let mut texts = texts.into_iter().flatten().peekable();
    texts.peek()?;
    Some(if texts.any(is_stylus) { Probe::Tip } else { Probe::Microscope })
}

/// The stylus is described as `Radius: 2 µm`.
fn tip_radius_m(tree: &Tree) -> Option<f64> {
    let (_, radius) = tree.text(&format!("{SETTINGS}StylusType"))?.split_once("Radius:")?;
    let mut words = radius.split_whitespace();
    let radius: f64 = words.next()?.parse().ok()?;
    numbers::positive(length_unit(words.next()?)?.to_m(radius))
}

fn free_text(tree: &Tree) -> String {
    let is_written = |path: &str| path.rsplit('/').next().is_some_and(|last| TEXTS.contains(&last));
    let texts = tree.paths().filter(|path| is_written(path)).filter_map(|path| tree.text(path));
    let texts = texts.filter(|text| !text.is_empty()).collect::<Vec<_>>();
    shortened(texts.join("\n"), MOST_TEXT)
}
