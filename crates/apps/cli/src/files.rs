//! The files that scenes and commands name, and tables that come in from them.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use study::Files;
use tables::{InputTable, TableError, TableSource};
use tempfile::SpooledTempFile;

use crate::inputs::{bytes_at, record};
use crate::missing_file::{files_in, spelt_as_on_disk};
use crate::place::Place;
use tables::staging::reading::{FileAsOpened, copy_stream, length_of};

/// Bytes of a stream read more than once that are held in memory; a longer stream goes to a temporary file.
const MOST_BYTES_HELD: usize = 1 << 24;

/// Files by their paths relative to a folder, none of which a result may replace; `-` is standard input.
pub(crate) struct Folder {
    path: PathBuf,
}

impl Folder {
    /// The folder that the program was called in.
    pub fn current() -> Self {
        Folder { path: PathBuf::new() }
    }

    /// The folder of a file.
    pub fn of(file: &Path) -> Self {
        Folder { path: file.parent().unwrap_or(Path::new("")).to_owned() }
    }
}

impl Files for Folder {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        bytes_at(&match Place::from(name) {
            Place::Standard => Place::Standard,
            Place::File(name) => Place::File(spelt_as_on_disk(&self.path.join(name))),
        })
    }

    fn read_beside(&self, name: &str, sibling: &str) -> io::Result<Option<Vec<u8>>> {
        let beside = self.path.join(name).with_file_name(sibling);
        beside.is_file().then(|| bytes_at(&Place::File(beside))).transpose()
    }

    fn list(&self, name: &str) -> io::Result<Option<Vec<String>>> {
        let path = self.path.join(name);
        path.is_dir().then(|| files_in(&path)).transpose()
    }
}

/// All of a table that is an input like any other.
///
/// # Errors
/// Errors of [`open_table`], and of its rows.
pub fn whole_table(place: &Place) -> Result<InputTable, TableError> {
    record(place).map_err(|error| TableError::Reading { table: place.name(), error })?;
    open_table(place)?.whole()
}

/// The table at a place, which its own result may replace. A stream is copied aside, since a table is read twice: to check all of it, and to compute.
///
/// # Errors
/// [`TableError`] that names the place, and the line where it has one.
pub fn open_table(place: &Place) -> Result<TableSource, TableError> {
    let name = place.name();
    let reading = |error| TableError::Reading { table: name.clone(), error };
    let stream: &mut dyn Read = match place {
        Place::Standard => &mut io::stdin().lock(),
        Place::File(path) => {
            let file = File::open(path).map_err(reading)?;
            if let Some(length) = length_of(&file).map_err(reading)? {
                return TableSource::new(&name, FileAsOpened::new(file, length));
            }
            &mut { file }
        }
    };
    let mut copy = SpooledTempFile::new(MOST_BYTES_HELD);
    copy_stream(stream, &mut copy).map_err(reading)?;
    TableSource::new(&name, copy)
}
