//! Inputs of the program: files and streams, which no result replaces.

use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use tables::staging::reading::{bytes_of, bytes_of_stream};
use tables::staging::resolve;

use crate::failure::Failure;
use crate::missing_file::explained;
use crate::place::Place;
use crate::targets::Targets;

/// Inputs of the program so far. It carries out one command, and none of its results may replace one of them.
static INPUTS: Mutex<BTreeSet<Place>> = Mutex::new(BTreeSet::new());

/// Bytes of the streams read so far, by their paths without links: a stream yields them once.
static STREAMS: Mutex<BTreeMap<PathBuf, Vec<u8>>> = Mutex::new(BTreeMap::new());

/// Refuses results that would replace an input.
///
/// # Errors
/// [`Failure::Input`] that names the file read and the result.
pub(crate) fn spare_inputs(results: &Targets) -> Result<(), Failure> {
    let inputs = INPUTS.lock().unwrap_or_else(PoisonError::into_inner);
    inputs.iter().try_for_each(|place| results.refuse_replacing(place))
}

/// Reads a place, which is an input from now on. A stream may be read again.
///
/// # Errors
/// Errors of the file system, with what to do.
pub(crate) fn bytes_at(place: &Place) -> io::Result<Vec<u8>> {
    record(place);
    let path = match place {
        Place::File(path) if path.is_file() || path.is_dir() || !path.exists() => {
            return bytes_of(path).map_err(|error| explained(error, path));
        }
        Place::File(path) => path,
        Place::Standard => Path::new("-"),
    };
    let mut streams = STREAMS.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(bytes) = streams.get(&resolve(path)) {
        return Ok(bytes.clone());
    }
    let bytes = match place {
        Place::Standard => bytes_of_stream(&mut io::stdin().lock()),
        Place::File(path) => bytes_of(path),
    }?;
    streams.insert(resolve(path), bytes.clone());
    Ok(bytes)
}

/// Makes a place an input.
pub(crate) fn record(place: &Place) {
    INPUTS.lock().unwrap_or_else(PoisonError::into_inner).insert(place.clone());
}
