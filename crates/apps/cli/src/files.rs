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
use crate::targets::Targets;
use tables::staging::reading::{FileAsOpened, copy_stream, length_of};

/// Bytes of a stream read more than once that are held in memory; a longer stream goes to a temporary file.
const MOST_BYTES_HELD: usize = 1 << 24;

/// Files by their paths relative to a folder, none of which a result may replace; `-` is standard input.
pub(crate) struct Folder {
    path: PathBuf,
    targets: Targets,
}

impl Folder {
    /// The folder that the program was called in.
    pub fn current(targets: Targets) -> Self {
        Folder { path: PathBuf::new(), targets }
    }

    /// The folder of a file.
    pub fn of(file: &Path, targets: Targets) -> Self {
        Folder { path: file.parent().unwrap_or(Path::new("")).to_owned(), ..Folder::current(targets) }
    }

    fn bytes(&self, path: &Path) -> io::Result<Vec<u8>> {
        let place = Place::File(spelt_as_on_disk(path));
        let bytes = bytes_at(&place);
        self.targets.spare(&place)?;
        bytes
    }
}

impl Files for Folder {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        if Place::from(name) == Place::Standard {
            self.targets.spare(&Place::Standard)?;
            return bytes_at(&Place::Standard);
        }
        self.bytes(&self.path.join(name))
    }

    fn read_beside(&self, name: &str, sibling: &str) -> io::Result<Option<Vec<u8>>> {
        let beside = self.path.join(name).with_file_name(sibling);
        if beside.is_file() { self.bytes(&beside).map(Some) } else { Ok(None) }
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
    record(place);
    open_table(place)?.whole()
}

/// The table at a place, which its own result may replace. A stream is copied aside, since a table is read twice: to check all of it, and to compute.
///
/// # Errors
/// [`TableError`] that names the place, and the line where it has one.
pub fn open_table(place: &Place) -> Result<TableSource, TableError> {
    let name = match place {
        Place::Standard => "standard input".to_owned(),
        Place::File(path) => path.display().to_string(),
    };
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
