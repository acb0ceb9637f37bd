//! Containers of contact.engineering: a ZIP file of measurements with `index.json` or `meta.yml`.

mod index;

pub use index::read_metadata;

use crate::archive::{Archive, INDEXES, is_zip, leads_outside};
use crate::error::{FilePlace, ScanReadError};
use crate::file::ScanFile;
use crate::format::ScanFormat;
use crate::metadata::{MeasurementMetadata, file_name};
use crate::options::ScanOptions;
use crate::single::read_one;

/// A measurement takes some kilobytes.
const LARGEST_INDEX: u64 = 16 << 20;

/// The path of the index, JSON before YAML, the least deep first: archives are repacked with a folder around them.
fn index_path(archive: &Archive) -> Option<String> {
    INDEXES.iter().find_map(|index| {
        let named = archive.paths().filter(|path| file_name(path) == *index);
        named.min_by_key(|path| path.matches('/').count()).map(str::to_owned)
    })
}

/// Reads a container; nothing where the file is none.
pub(crate) fn read(bytes: &[u8], options: &ScanOptions) -> Option<Result<Vec<ScanFile>, ScanReadError>> {
    if !is_zip(bytes) {
        return None;
    }
    let mut archive = match Archive::open(bytes, options.unpacked_bound()) {
        Ok(archive) => archive,
        Err(error) => return Some(Err(error)),
    };
    let index = index_path(&archive)?;
    Some(measurements(&mut archive, &index, options))
}

/// Reads every measurement, or the one asked for.
///
/// An instrument's own file counts before its processed copy, whose heights have a trend taken off; where only the copy
/// can be read, a note says why.
fn measurements(
    archive: &mut Archive,
    index: &str,
    options: &ScanOptions,
) -> Result<Vec<ScanFile>, ScanReadError> {
    let text = archive.read_at_most(index, LARGEST_INDEX)?;
    let text = String::from_utf8(text).map_err(|error| ScanReadError::Syntax {
        file: index.to_owned(),
        problem: format!("no UTF-8: {error}"),
    })?;
    let measurements = read_metadata(&text, index)?;
    let names: Vec<String> = measurements.iter().map(|entry| entry.name.clone()).collect();
    let folder = &index[..index.len() - file_name(index).len()];
    let is_wanted = |entry: &MeasurementMetadata| match &options.measurement {
        None => true,
        Some(wanted) => entry.name == *wanted || entry.names_file(wanted),
    };
    let wanted: Vec<_> = measurements.into_iter().filter(is_wanted).collect();
    if wanted.is_empty() {
        return Err(ScanReadError::NoChannel {
            format: ScanFormat::Container,
            wanted: match &options.measurement {
                Some(wanted) => format!("measurement '{wanted}'"),
                None => "measurement at all".to_owned(),
            },
            channels: names,
        });
    }
    wanted.into_iter().map(|entry| measurement(archive, folder, entry, options)).collect()
}

fn measurement(
    archive: &mut Archive,
    folder: &str,
    entry: MeasurementMetadata,
    options: &ScanOptions,
) -> Result<ScanFile, ScanReadError> {
    let (measurement, squeezed) = (entry.name.clone(), entry.squeezed.clone());
    let failed = |file: &str, source: ScanReadError| ScanReadError::Measurement {
        measurement: measurement.clone(),
        file: file.to_owned(),
        source: Box::new(source),
    };
    let original = entry.original.clone().map(|path| {
        let options = ScanOptions { metadata: Some(entry.clone()), measurement: None, ..options.clone() };
        data_file(archive, folder, &path, &options).map_err(|error| failed(&path, error))
    });
    let Some(path) = squeezed else {
        let nothing = || {
            ScanFormat::Container.missing(
                FilePlace::Element("datafile".to_owned()),
                "path 'original' or 'squeezed-netcdf'",
                "download the container again",
            )
        };
        return original.unwrap_or_else(|| Err(failed("", nothing())));
    };
    let reason = match original {
        Some(Ok(scan)) => return Ok(scan),
        // An archive that means harm is not read at all.
        Some(Err(error)) if means_harm(&error) => return Err(error),
        Some(Err(error)) => {
            format!("the instrument's file cannot be read ({error}): its processed copy '{path}' is")
        }
        None => {
            format!("only the processed copy '{path}' is there; a trend may have been taken off its heights")
        }
    };
    // The processed copy has its scale applied, its one channel chosen, its units written down.
    let processed = MeasurementMetadata { height_scale: None, data_source: None, ..entry.clone() };
    let options =
        ScanOptions { metadata: Some(processed), measurement: None, channel: None, ..options.clone() };
    let mut scan = data_file(archive, folder, &path, &options).map_err(|error| failed(&path, error))?;
    scan.notes.push(reason);
    Ok(scan)
}

fn data_file(
    archive: &mut Archive,
    folder: &str,
    path: &str,
    options: &ScanOptions,
) -> Result<ScanFile, ScanReadError> {
    if leads_outside(path) {
        return Err(ScanReadError::PathOutside { path: path.to_owned() });
    }
    let bytes = archive.read(&format!("{folder}{path}"))?;
    read_one(&bytes, path, options)
}

fn means_harm(error: &ScanReadError) -> bool {
    match error {
        ScanReadError::Measurement { source, .. } => means_harm(source),
        _ => matches!(error, ScanReadError::PathOutside { .. } | ScanReadError::ArchiveTooLarge { .. }),
    }
}
