//! The files that scenes and commands name, and tables that come in from them.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use study::Files;
use tables::{TableError, TableSource};
use tempfile::SpooledTempFile;

use crate::failure::Failure;
use crate::missing_file::{explained, files_in, spelt_as_on_disk};
use crate::output::Place;
use crate::targets::Targets;
use tables::staging::reading::{FileAsOpened, bytes_of, bytes_of_stream, copy_stream, length_of};

/// Bytes of a stream read more than once that are held in memory; a longer stream goes to a temporary file.
const MOST_BYTES_HELD: usize = 1 << 24;

/// Files by their paths relative to a folder, none of which a result may replace; `-` is standard input.
pub(crate) struct Folder {
    path: PathBuf,
    targets: Targets,
    read: Mutex<Vec<PathBuf>>,
}

impl Folder {
    /// The folder that the program was called in.
    pub fn current(targets: Targets) -> Self {
        Folder { path: PathBuf::new(), targets, read: Mutex::default() }
    }

    /// The folder of a file.
    pub fn of(file: &Path, targets: Targets) -> Self {
        Folder { path: file.parent().unwrap_or(Path::new("")).to_owned(), ..Folder::current(targets) }
    }

    /// Refuses further results that would replace what has been read.
    ///
    /// # Errors
    /// [`Failure::Input`] that names the file read and the result.
    pub fn spare_from(self, results: &Targets) -> Result<(), Failure> {
        let read = self.read.into_inner().unwrap_or_else(PoisonError::into_inner);
        read.iter().try_for_each(|path| {
            results.spare(path).map_err(|error| Failure::reading(&path.display().to_string(), &error))
        })
    }

    fn bytes(&self, path: &Path) -> io::Result<Vec<u8>> {
        let path = &spelt_as_on_disk(path);
        self.targets.spare(path)?;
        let bytes = bytes_of(path).map_err(|error| explained(error, path))?;
        self.read.lock().unwrap_or_else(PoisonError::into_inner).push(path.to_owned());
        Ok(bytes)
    }
}

impl Files for Folder {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        if Place::from(name) == Place::Standard {
            self.targets.spare_standard_input()?;
            return bytes_of_stream(&mut io::stdin().lock());
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

/// The table at a place. A stream is copied aside, since a table is read twice: to check all of it, and to compute.
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
