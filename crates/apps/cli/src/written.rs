//! The file that `scan --write` makes of one channel.

use std::path::PathBuf;
use std::str::FromStr;

use scans::WrittenFormat;

use crate::place::Place;

/// A file in the format that its name ends in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct WrittenScan {
    pub path: PathBuf,
    pub format: WrittenFormat,
}

/// A name that ends in no format that heights are written in.
#[derive(Debug, thiserror::Error)]
#[error("'{name}' must end in {}, the formats that heights are written in", endings())]
pub(crate) struct EndingError {
    name: String,
}

fn endings() -> String {
    WrittenFormat::ALL.iter().map(|format| format.ending()).collect::<Vec<_>>().join(", ")
}

impl FromStr for WrittenScan {
    type Err = EndingError;

    fn from_str(name: &str) -> Result<Self, EndingError> {
        let format = WrittenFormat::from_name(name).ok_or_else(|| EndingError { name: name.to_owned() })?;
        Ok(Self { path: PathBuf::from(name), format })
    }
}

impl WrittenScan {
    pub fn place(&self) -> Place {
        Place::File(self.path.clone())
    }
}
