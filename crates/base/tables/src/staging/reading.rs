//! Bytes of files and streams, of which no more is read than there was at opening or than a bound allows.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::Path;

/// Most bytes that are read from a stream: pipes and devices need not end.
const MOST_BYTES_OF_STREAM: u64 = 1 << 30;

/// Reads a file up to its length at opening, or a stream up to the bound.
///
/// # Errors
/// Errors of the file system; [`io::ErrorKind::FileTooLarge`] for a stream beyond the bound.
pub fn bytes_of(path: &Path) -> io::Result<Vec<u8>> {
    let mut file = File::open(path)?;
    match length_of(&file)? {
        Some(length) => {
            let mut bytes = Vec::new();
            // A sparse file may state more than memory holds.
            let room = usize::try_from(length).map_err(|_| io::ErrorKind::OutOfMemory)?;
            bytes.try_reserve_exact(room).map_err(|_| io::ErrorKind::OutOfMemory)?;
            file.take(length).read_to_end(&mut bytes)?;
            Ok(bytes)
        }
        None => bytes_of_stream(&mut file),
    }
}

/// Reads a stream up to the bound.
///
/// # Errors
/// Errors of the stream; [`io::ErrorKind::FileTooLarge`] beyond the bound.
pub fn bytes_of_stream(stream: &mut dyn Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    copy_stream(stream, &mut bytes)?;
    Ok(bytes)
}

/// Copies a stream up to the bound.
///
/// # Errors
/// Errors of either end; [`io::ErrorKind::FileTooLarge`] beyond the bound.
pub fn copy_stream(stream: &mut dyn Read, to: &mut dyn Write) -> io::Result<()> {
    copy_up_to(stream, to, MOST_BYTES_OF_STREAM)
}

fn copy_up_to(stream: &mut dyn Read, mut to: &mut dyn Write, most: u64) -> io::Result<()> {
    let copied = io::copy(&mut stream.take(most + 1), &mut to)?;
    if copied <= most {
        return Ok(());
    }
    let bound = most as f64 / f64::from(1 << 30);
    let message = format!("a stream may hold at most {bound} GiB, and this one goes on; save it as a file");
    Err(io::Error::new(io::ErrorKind::FileTooLarge, message))
}

/// The length of a regular file at opening; `None` for streams, and for files that state no length, as those of /proc.
pub fn length_of(file: &File) -> io::Result<Option<u64>> {
    let metadata = file.metadata()?;
    Ok(Some(metadata.len()).filter(|length| metadata.is_file() && *length > 0))
}

/// A file up to the length that it had at opening.
#[derive(Debug)]
pub struct FileAsOpened {
    file: File,
    length: u64,
    at: u64,
}

impl FileAsOpened {
    /// Takes a file that begins at its start.
    pub fn new(file: File, length: u64) -> Self {
        FileAsOpened { file, length, at: 0 }
    }
}

impl Read for FileAsOpened {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let left = usize::try_from(self.length.saturating_sub(self.at)).unwrap_or(usize::MAX);
        let most = buffer.len().min(left);
        let read = self.file.read(&mut buffer[..most])?;
        self.at += read as u64;
        Ok(read)
    }
}

impl Seek for FileAsOpened {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.at = self.file.seek(to)?;
        Ok(self.at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn streams_end_at_the_bound() {
        let copied = |most| {
            let mut bytes = Vec::new();
            copy_up_to(&mut b"12345".as_slice(), &mut bytes, most).map(|()| bytes)
        };
        assert_eq!(copied(5).unwrap(), b"12345");
        assert_eq!(copied(4).unwrap_err().kind(), io::ErrorKind::FileTooLarge);
        let endless = copy_up_to(&mut io::repeat(0), &mut io::sink(), 1 << 20);
        assert_eq!(endless.unwrap_err().kind(), io::ErrorKind::FileTooLarge);
    }

    #[test]
    fn a_file_that_grows_is_read_up_to_its_length_at_opening() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("growing");
        std::fs::write(&path, "12345").unwrap();
        let file = File::open(&path).unwrap();
        let length = length_of(&file).unwrap().unwrap();
        std::fs::write(&path, "1234567").unwrap();
        let mut opened = FileAsOpened::new(file, length);
        for _ in 0..2 {
            let mut text = String::new();
            opened.seek(SeekFrom::Start(1)).unwrap();
            opened.read_to_string(&mut text).unwrap();
            assert_eq!(text, "2345");
        }
    }
}
