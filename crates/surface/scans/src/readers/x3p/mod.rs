//! X3P, the XML and binary data in a ZIP file of ISO 25178-72 (earlier ISO 5436-2): profiles, surfaces, and points as
//! far as they lie on a grid, with their data in a file or in the XML itself. Lengths are in m.

mod axis;
mod data;
mod description;
mod element;

use crate::archive::{Archive, is_named_in, is_zip};
use crate::channel::{Channel, Lateral, Quantity, Samples};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::options::ScanOptions;
use crate::raster::Decoded;
use crate::readers::Reader;
use crate::readers::even_axis::{ScanAxis as EvenAxis, points_of_grid};
use axis::ScanAxis;
use data::Data;
use description::{Description, Layout};

const FORMAT: ScanFormat = ScanFormat::X3p;
const INDEX: &str = "main.xml";
const LARGEST_INDEX: u64 = 16 << 20;
/// The share of its distance from zero within which a position is known, of computed ones and of single precision.
const ROUNDING: f64 = 1e-6;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    is_zip(bytes) && is_named_in(bytes, INDEX)
}

/// The one channel of a file, which has no name.
fn channels<'b>(bytes: &'b [u8], options: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let mut archive = Archive::open(bytes, options.unpacked_bound())?;
    let folder = folder(&archive)?;
    let index = archive.read_at_most(&format!("{folder}{INDEX}"), LARGEST_INDEX)?;
    let description = Description::read(&index, &folder)?;
    let data = description.data(&mut archive)?;
    let (columns, lateral, decoded) = match (description.layout, description.x, description.y) {
        (Layout::Profile, ScanAxis::Given(_), _) => {
            (description.columns, Lateral::Positions(data.x_m), data.z_m)
        }
        (Layout::Profile, ScanAxis::Even(x_m), _) => {
            (description.columns, Lateral::Spacing { x_m, y_m: None }, data.z_m)
        }
        (Layout::Surface, ScanAxis::Even(x_m), ScanAxis::Even(y_m)) => {
            (description.columns, Lateral::Spacing { x_m, y_m: Some(y_m) }, data.z_m)
        }
        (Layout::Surface | Layout::Cloud, ..) => on_grid(&description, data)?,
    };
    let samples = Samples::Decoded { columns, decoded };
    let Description { probe, free_text, notes, .. } = description;
    let channel = Channel::new(None, Quantity::HEIGHTS_IN_M, lateral, samples);
    Ok(vec![Channel { probe, free_text, notes, ..channel }])
}

/// The folder of the archive that holds the files, with a slash behind it: some programs pack one, not its content.
fn folder(archive: &Archive) -> Result<String, ScanReadError> {
    let folders: Vec<&str> = archive
        .paths()
        .filter(|path| !path.starts_with("__MACOSX/"))
        .filter_map(|path| path.strip_suffix(INDEX))
        .filter(|folder| folder.is_empty() || folder.ends_with('/'))
        .collect();
    match folders[..] {
        [folder] => Ok(folder.to_owned()),
        _ if folders.contains(&"") => Ok(String::new()),
        [] => Err(FORMAT.missing(FilePlace::File, format!("file '{INDEX}'"), "export the file again")),
        _ => {
            let found = format!("an archive with {} files named '{INDEX}'", folders.len());
            Err(FORMAT.unsupported(FilePlace::File, found, "pack each scan into a file of its own"))
        }
    }
}

/// Points with positions of their own, which must lie on an even grid; grid points without any are missing.
fn on_grid(description: &Description, data: Data) -> Result<(usize, Lateral, Decoded), ScanReadError> {
    let no_grid = || {
        FORMAT.unsupported(
            FilePlace::Element("Record1/FeatureType".to_owned()),
            "points that lie on no even grid, one at each of its points",
            "export a surface (SUR) on a regular grid",
        )
    };
    // The matrix tells the place of a point along an axis without positions.
    let along = |given: Vec<f64>, axis: ScanAxis, place: fn(usize, usize) -> usize| match axis {
        ScanAxis::Given(_) => given,
        ScanAxis::Even(spacing_m) => (0..data.z_m.values.len())
            .map(|index| place(index, description.columns) as f64 * spacing_m)
            .collect(),
    };
    let x_m = along(data.x_m, description.x, |index, columns| index % columns);
    let y_m = along(data.y_m, description.y, |index, columns| index / columns);
    let is_point = |&index: &usize| !data.z_m.missing.contains(index);
    let even_axis = |positions_m: &[f64]| {
        let known: Vec<f64> =
            (0..positions_m.len()).filter(is_point).map(|index| positions_m[index]).collect();
        let largest_m = known.iter().fold(0.0, |largest: f64, position_m| largest.max(position_m.abs()));
        EvenAxis::fit(known, ROUNDING * largest_m).ok_or_else(no_grid)
    };
    let (x, y) = (even_axis(&x_m)?, even_axis(&y_m)?);
    let size = points_of_grid(&x, &y, x_m.len()).ok_or_else(no_grid)?;
    let mut heights_m: Vec<Option<f64>> = vec![None; size];
    for (index, (&at_x_m, &at_y_m)) in x_m.iter().zip(&y_m).enumerate().filter(|(index, _)| is_point(index)) {
        let place =
            heights_m.get_mut(y.index(at_y_m) * x.count + x.index(at_x_m)).filter(|place| place.is_none());
        *place.ok_or_else(no_grid)? = data.z_m.values.get(index).copied();
    }
    let lateral = Lateral::Spacing { x_m: x.spacing, y_m: Some(y.spacing) };
    Ok((x.count, lateral, heights_m.into_iter().collect()))
}
