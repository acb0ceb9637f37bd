//! Headers of lines `key = value` under lines `[Section]`, in Latin-1.

use std::collections::HashMap;

use crate::cursor::latin1;
use crate::error::{FilePlace, ScanReadError, quoted};
use crate::format::ScanFormat;
use crate::numbers;

/// Headers take some ten kilobytes; a file that goes on with lines beyond this is none.
const LONGEST: usize = 1 << 20;

/// The values of a header by section and key. Of values under one key the first counts.
pub(super) struct Sections {
    format: ScanFormat,
    sections: HashMap<String, HashMap<String, String>>,
    /// Offset behind the mark that ends the header.
    pub(super) end: usize,
}

impl Sections {
    /// Reads the lines up to the one that begins with the mark. Lines before the first section, and lines without the
    /// separator, are passed over.
    pub(super) fn read(
        format: ScanFormat,
        bytes: &[u8],
        separator: char,
        mark: &[u8],
    ) -> Result<Self, ScanReadError> {
        let head = bytes.get(..LONGEST).unwrap_or(bytes);
        let mut found = Self { format, sections: HashMap::new(), end: 0 };
        let mut section: Option<&mut HashMap<String, String>> = None;
        for raw in head.split_inclusive(|&byte| byte == b'\n') {
            if raw.starts_with(mark) {
                found.end += mark.len();
                return Ok(found);
            }
            found.end += raw.len();
            let line = latin1(raw);
            if let Some(name) = line.strip_prefix('[').and_then(|line| line.strip_suffix(']')) {
                section = Some(found.sections.entry(name.to_owned()).or_default());
            } else if let (Some(section), Some((key, value))) = (section.as_mut(), line.split_once(separator))
            {
                section.entry(key.trim().to_owned()).or_insert_with(|| value.trim().to_owned());
            }
        }
        Err(format.missing(
            FilePlace::Byte(head.len() as u64),
            format!("'{}' before it, which ends the header", latin1(mark)),
            "the file is cut off: export it again",
        ))
    }

    pub(super) fn get(&self, section: &str, key: &str) -> Option<&str> {
        self.sections.get(section)?.get(key).map(String::as_str)
    }

    /// The keys and values of a section, in no order.
    pub(super) fn entries(&self, section: &str) -> impl Iterator<Item = (&str, &str)> {
        let entries = self.sections.get(section).into_iter().flatten();
        entries.map(|(key, value)| (key.as_str(), value.as_str()))
    }

    pub(super) fn require(&self, section: &str, key: &str) -> Result<&str, ScanReadError> {
        self.get(section, key).ok_or_else(|| {
            let mend = "export the file again";
            self.format.missing(FilePlace::Element(format!("[{section}]")), format!("'{key}'"), mend)
        })
    }

    /// A whole number above 0.
    pub(super) fn count(&self, section: &str, key: &str) -> Result<usize, ScanReadError> {
        let text = self.require(section, key)?;
        numbers::count(text).ok_or_else(|| self.bad(section, key, text, "a whole number above 0"))
    }

    /// A finite number.
    pub(super) fn number(&self, section: &str, key: &str) -> Result<f64, ScanReadError> {
        let text = self.require(section, key)?;
        numbers::finite(text).ok_or_else(|| self.bad(section, key, text, "a number"))
    }

    pub(super) fn bad(&self, section: &str, key: &str, value: &str, bound: &str) -> ScanReadError {
        self.format.bad(
            FilePlace::Element(format!("[{section}]")),
            format!("'{key}'"),
            quoted(value),
            bound,
            "the header is damaged: export the file again",
        )
    }
}
