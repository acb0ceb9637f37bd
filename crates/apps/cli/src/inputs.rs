//! Inputs of the program: files and streams, which no result replaces. Results are announced before anything is read, so that an
//! input among them is refused when it is read; what nobody announced is refused when it is put in place.

use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tables::staging::reading::{bytes_of, bytes_of_stream};
use tables::staging::resolve;

use crate::failure::Failure;
use crate::missing_file::explained;
use crate::place::Place;
use crate::targets::Targets;

/// Inputs of the program so far. It carries out one command, and none of its results may replace one of them.
static INPUTS: Mutex<BTreeSet<Place>> = Mutex::new(BTreeSet::new());

/// Results that have been announced.
static RESULTS: Mutex<Targets> = Mutex::new(Targets::NONE);

/// Bytes of the streams read so far, by their paths without links: a stream yields them once.
static STREAMS: Mutex<BTreeMap<PathBuf, Vec<u8>>> = Mutex::new(BTreeMap::new());

/// Announces the places of results that an option names: none of them may be read from now on.
///
/// # Errors
/// Errors of [`Targets::add`].
pub(crate) fn announce(option: &'static str, places: impl IntoIterator<Item = Place>) -> Result<(), Failure> {
    lock(&RESULTS).add(option, places)
}

/// Refuses a place that an announced result would replace.
///
/// # Errors
/// An error that names the option and its file.
pub(crate) fn refuse_replaced(place: &Place) -> io::Result<()> {
    lock(&RESULTS).spare(place)
}

/// Refuses results that would replace an input.
///
/// # Errors
/// [`Failure::Input`] that names the file read and the result.
pub(crate) fn spare_inputs(results: &Targets) -> Result<(), Failure> {
    let spare = |place: &Place| results.spare(place).map_err(|error| Failure::reading(&place.name(), &error));
    lock(&INPUTS).iter().try_for_each(spare)
}

/// Reads a place, which is an input from now on. A stream may be read again.
///
/// # Errors
/// Errors of the file system, with what to do; errors of [`record`].
pub(crate) fn bytes_at(place: &Place) -> io::Result<Vec<u8>> {
    record(place)?;
    let path = match place {
        Place::File(path) if path.is_file() || path.is_dir() || !path.exists() => {
            return bytes_of(path).map_err(|error| explained(error, path));
        }
        Place::File(path) => path,
        Place::Standard => Path::new("-"),
    };
    let mut streams = lock(&STREAMS);
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
///
/// # Errors
/// Errors of [`refuse_replaced`].
pub(crate) fn record(place: &Place) -> io::Result<()> {
    lock(&INPUTS).insert(place.clone());
    refuse_replaced(place)
}

fn lock<T>(held: &Mutex<T>) -> MutexGuard<'_, T> {
    held.lock().unwrap_or_else(PoisonError::into_inner)
}
