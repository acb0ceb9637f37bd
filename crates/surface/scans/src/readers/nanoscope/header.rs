//! The text at the beginning of a Nanoscope file: sections of keys and values.

use crate::cursor::latin1;
use crate::error::{FilePlace, ScanReadError, quoted};
use crate::format::ScanFormat;
use crate::numbers;

/// The format whose reader this is, for messages.
pub(crate) const FORMAT: ScanFormat = ScanFormat::Nanoscope;

/// Headers take some ten kilobytes; a file that goes on with lines beyond this is none.
const LONGEST: usize = 1 << 20;

const END: &[u8] = b"\\*File list end";
const FILE_LIST: [&str; 2] = ["file list", "ec file list"];
const SCANNER: [&str; 2] = ["scanner list", "microscope list"];
const SCAN: [&str; 4] = ["ciao scan list", "afm list", "stm list", "nc afm list"];
const IMAGE: [&str; 5] =
    ["ciao image list", "afm image list", "stm image list", "ncafm image list", "image list"];

/// Sections in the order of the file.
pub(crate) struct Header<'b> {
    sections: Vec<Section<'b>>,
    /// Offset of the end of the header, where data may begin.
    pub(crate) end: usize,
}

/// The keys below a line `\*Name`.
pub(crate) struct Section<'b> {
    name: String,
    pub(crate) offset: u64,
    entries: Vec<(&'b [u8], &'b [u8], u64)>,
}

/// A value with the place of its line.
pub(crate) struct Value {
    pub(crate) key: &'static str,
    pub(crate) text: String,
    pub(crate) offset: u64,
}

impl<'b> Header<'b> {
    pub(crate) fn read(bytes: &'b [u8]) -> Result<Self, ScanReadError> {
        let mut header = Self { sections: Vec::new(), end: 0 };
        let head = &bytes[..bytes.len().min(LONGEST)];
        let mut offset = 0;
        for raw in head.split_inclusive(|&byte| byte == b'\n') {
            let line = raw.trim_ascii();
            header.end = offset + raw.len();
            if line.eq_ignore_ascii_case(END) {
                return Ok(header);
            }
            header.take(line, offset as u64)?;
            offset = header.end;
        }
        let mend = "the file is cut off: export it again";
        Err(FORMAT.missing(FilePlace::Byte(head.len() as u64), "line '\\*File list end' before it", mend))
    }

    fn take(&mut self, line: &'b [u8], offset: u64) -> Result<(), ScanReadError> {
        match (line.strip_prefix(b"\\"), self.sections.last_mut()) {
            (Some([b'*', name @ ..]), _) => {
                self.sections.push(Section {
                    name: latin1(name).to_lowercase(),
                    offset,
                    entries: Vec::new(),
                });
                Ok(())
            }
            (Some(entry), Some(section)) => {
                let colon = entry.windows(2).position(|pair| pair == b": ");
                let (key, value) = match colon {
                    Some(at) => (&entry[..at], &entry[at + 2..]),
                    None => (entry.strip_suffix(b":").unwrap_or(entry), &entry[entry.len()..]),
                };
                section.entries.push((key, value, offset));
                Ok(())
            }
            _ => Err(FORMAT.bad(
                FilePlace::Byte(offset),
                "the line",
                format!("'{}'", line[..line.len().min(40)].escape_ascii()),
                "a line of the header, which begins with a backslash",
                "the file is damaged: export it again",
            )),
        }
    }

    /// The sections of images.
    pub(crate) fn images(&self) -> impl Iterator<Item = &Section<'b>> {
        self.sections.iter().filter(|section| IMAGE.contains(&section.name.as_str()))
    }

    pub(crate) fn file_list(&self, key: &'static str) -> Option<Value> {
        self.within(&FILE_LIST, key)
    }

    /// A value of the scan as a whole.
    pub(crate) fn scan_list(&self, key: &'static str) -> Option<Value> {
        self.within(&SCAN, key)
    }

    pub(crate) fn any(&self, key: &'static str) -> Option<Value> {
        self.sections.iter().find_map(|section| section.get(key))
    }

    /// A sensitivity such as `@Sens. Zsens`, of the scanner before that of the scan.
    pub(crate) fn sensitivity(&self, name: &str) -> Option<Value> {
        let key = format!("@{name}");
        let sections = |names: &'static [&str]| {
            self.sections.iter().filter(move |section| names.contains(&section.name.as_str()))
        };
        sections(&SCANNER).chain(sections(&SCAN)).find_map(|section| {
            let (_, text, offset) = section.find(key.as_bytes())?;
            Some(Value { key: "sensitivity", text: latin1(text), offset })
        })
    }

    fn within(&self, names: &[&str], key: &'static str) -> Option<Value> {
        self.sections
            .iter()
            .filter(|section| names.contains(&section.name.as_str()))
            .find_map(|section| section.get(key))
    }
}

impl Section<'_> {
    /// The value of a key, in any case.
    pub(crate) fn get(&self, key: &'static str) -> Option<Value> {
        let (_, text, offset) = self.find(key.as_bytes())?;
        Some(Value { key, text: latin1(text), offset })
    }

    pub(crate) fn require(&self, key: &'static str) -> Result<Value, ScanReadError> {
        self.get(key).ok_or_else(|| {
            let mend = "export the file again with a newer version of the software";
            FORMAT.missing(FilePlace::Byte(self.offset), format!("'{key}' in this section"), mend)
        })
    }

    fn find(&self, key: &[u8]) -> Option<(&[u8], &[u8], u64)> {
        self.entries.iter().copied().find(|(name, ..)| name.eq_ignore_ascii_case(key))
    }
}

impl Value {
    /// The value as a whole number of at least 1.
    pub(crate) fn count(&self) -> Result<usize, ScanReadError> {
        numbers::count(&self.text).ok_or_else(|| self.bad("a whole number above 0"))
    }

    pub(crate) fn bad(&self, bound: &str) -> ScanReadError {
        let mend = "the header is damaged: export the file again";
        FORMAT.bad(FilePlace::Byte(self.offset), format!("'{}'", self.key), quoted(&self.text), bound, mend)
    }
}
