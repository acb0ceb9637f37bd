//! Formats of scans and how they are told apart.

use std::fmt;

/// A format that scans are read from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ScanFormat {
    /// Columns or a matrix of numbers.
    Text,
    /// Nanoscope and Dimension atomic force microscopes: `.001`, `.di`, `.spm`.
    Nanoscope,
    /// NetCDF classic, in the layout of contact.engineering.
    NetCdf,
    /// ISO 25178-72.
    X3p,
    /// ZIP file of contact.engineering, with `meta.yml` or `index.json`.
    Container,
}

impl ScanFormat {
    /// The format of a binary file, told by its beginning and, of a ZIP file, by the names of what is in it; `None` for text,
    /// which may be anything, and for what no reader knows. Whether it can be read is [`read_scans`](crate::read_scans)'s to
    /// say.
    #[must_use]
    pub fn of(bytes: &[u8]) -> Option<Self> {
        let names = |name: &str| bytes.windows(name.len()).any(|part| part == name.as_bytes());
        match Magic::of(bytes) {
            Magic::Nanoscope => Some(Self::Nanoscope),
            Magic::NetCdf => Some(Self::NetCdf),
            Magic::Zip if names("main.xml") => Some(Self::X3p),
            Magic::Zip if names("meta.yml") || names("index.json") => Some(Self::Container),
            Magic::Zip | Magic::Text | Magic::Foreign(_) => None,
        }
    }
}

impl fmt::Display for ScanFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Text => "text",
            Self::Nanoscope => "Nanoscope",
            Self::NetCdf => "NetCDF",
            Self::X3p => "X3P",
            Self::Container => "container",
        })
    }
}

impl ScanFormat {
    /// The format that the first bytes of a file show beyond doubt, for whoever takes a scan for something else; none for
    /// text, which may hold anything, and for a ZIP file without the names that a scan has in it, such as a workbook.
    #[must_use]
    pub fn of_binary(bytes: &[u8]) -> Option<Self> {
        match Magic::of(bytes) {
            Magic::Nanoscope => Some(Self::Nanoscope),
            Magic::NetCdf => Some(Self::NetCdf),
            Magic::Zip => {
                // Names stand in a ZIP file as they are.
                let holds = |name: &[u8]| bytes.windows(name.len()).any(|found| found == name);
                let containers = [b"meta.yml".as_slice(), b"index.json"];
                match containers.into_iter().any(holds) {
                    true => Some(Self::Container),
                    false => holds(b"main.xml").then_some(Self::X3p),
                }
            }
            Magic::Text | Magic::Foreign(_) => None,
        }
    }
}

/// What the first bytes tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Magic {
    Nanoscope,
    NetCdf,
    Zip,
    Text,
    /// No reader's, with what is known about it.
    Foreign(&'static str),
}

/// Beginnings of formats that are not read, with the way to one that is.
const FOREIGN: [(&[u8], &str); 9] = [
    (b"\\*Force file list", ": this is a Nanoscope force curve; export an image of heights"),
    (b"\x89HDF\r\n\x1a\n", ": this is HDF5 or NetCDF-4; save it as NetCDF-3 ('NETCDF3_64BIT_OFFSET')"),
    (b"GWYP", ": this is Gwyddion's own format; export it as X3P or as an ASCII matrix with its header"),
    (b"GWYO", ": this is Gwyddion's own format; export it as X3P or as an ASCII matrix with its header"),
    (b"?*File list", ": this is a Nanoscope file with its data as text; save it with binary data"),
    (b"\xff\xfe", ": this is text in UTF-16; save it in UTF-8"),
    (b"\xfe\xff", ": this is text in UTF-16; save it in UTF-8"),
    (b"PK\x05\x06", ": this is an empty ZIP file"),
    (b"\x1f\x8b", ": this is a gzip file; unpack it"),
];

impl Magic {
    pub(crate) fn of(bytes: &[u8]) -> Self {
        let is_nanoscope = [b"\\*File list".as_slice(), b"\\*EC File list"];
        if is_nanoscope.iter().any(|start| starts_with_any_case(bytes, start)) {
            return Self::Nanoscope;
        }
        if bytes.starts_with(b"CDF") && bytes.get(3).is_some_and(|version| *version < b' ') {
            return Self::NetCdf;
        }
        if bytes.starts_with(b"PK\x03\x04") {
            return Self::Zip;
        }
        if let Some((_, hint)) = FOREIGN.iter().find(|(start, _)| bytes.starts_with(start)) {
            return Self::Foreign(hint);
        }
        // The first bytes alone; what comes later is the text reader's to refuse, with its line.
        let is_binary = |byte: &u8| *byte < b' ' && !b"\t\n\r\x0c".contains(byte);
        if bytes.iter().take(512).any(is_binary) { Self::Foreign("") } else { Self::Text }
    }
}

fn starts_with_any_case(bytes: &[u8], start: &[u8]) -> bool {
    bytes.get(..start.len()).is_some_and(|head| head.eq_ignore_ascii_case(start))
}
