//! Sources of input and destinations of results.

use std::path::PathBuf;

/// A path, or `-` for stdin or stdout.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    /// stdin or stdout.
    Standard,
    /// A file.
    File(PathBuf),
}

impl From<&str> for Place {
    fn from(text: &str) -> Self {
        if text == "-" { Place::Standard } else { Place::File(PathBuf::from(text)) }
    }
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Place::Standard => write!(f, "-"),
            Place::File(path) => write!(f, "{}", path.display()),
        }
    }
}

impl Place {
    /// Returns the name of a source in messages.
    pub fn name(&self) -> String {
        match self {
            Place::Standard => "standard input".to_owned(),
            Place::File(path) => path.display().to_string(),
        }
    }
}
