//! Kinds of files that people take for scans and spectra, recognised by their first bytes.

use std::fmt;

use memchr::memmem;

/// A kind of file that holds no numbers to read, or none in this form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ForeignFile {
    /// A picture in this format, whose colours are not heights.
    Picture(&'static str),
    /// A page for printing.
    Pdf,
    /// A web page, often saved in place of the file that it offers.
    WebPage,
    /// A document or a workbook of an Office before 2007.
    OldOffice,
    /// A document or a slide show of Office.
    Document,
    /// A file of LibreOffice.
    OpenDocument,
    /// A force curve of a Nanoscope.
    ForceCurve,
    /// A Nanoscope file with its data as text.
    NanoscopeText,
    /// A file of this instrument or program, in a format that is not read.
    Instrument(&'static str),
    /// HDF5 or NetCDF-4, which not every build reads.
    Hdf5,
    /// A ZIP file without a known scan.
    Zip,
}

/// Beginnings of files; of several that fit, the first counts.
const BEGINNINGS: [(&[u8], ForeignFile); 20] = [
    (b"\x89PNG", ForeignFile::Picture("PNG")),
    (b"\xff\xd8\xff", ForeignFile::Picture("JPEG")),
    (b"GIF8", ForeignFile::Picture("GIF")),
    (b"II*\0", ForeignFile::Picture("TIFF without known heights")),
    (b"MM\0*", ForeignFile::Picture("TIFF without known heights")),
    (b"%PDF-", ForeignFile::Pdf),
    (b"%!PS", ForeignFile::Pdf),
    (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", ForeignFile::OldOffice),
    (b"\\*Force file list", ForeignFile::ForceCurve),
    (b"?*File list", ForeignFile::NanoscopeText),
    (b"\x89HDF\r\n\x1a\n", ForeignFile::Hdf5),
    (b"<svg", ForeignFile::Picture("SVG")),
    (b"PK", ForeignFile::Zip),
    (b"[ParVERT", ForeignFile::Instrument("Createc spectrum (.vert)")),
    (b"ONTMATRX", ForeignFile::Instrument("Omicron Matrix file (.mtrx)")),
    (b"OLYMPUSRAWFORMAT", ForeignFile::Instrument("Olympus raw image (.oir)")),
    (b"\0\0\0\0TPPH", ForeignFile::Instrument("high-speed AFM film (.asd)")),
    (b"MATLAB 7.3 MAT-file", ForeignFile::Instrument("MATLAB file of version 7.3; save it with '-v7'")),
    (b"Grid dim=", ForeignFile::Instrument("Nanonis grid of spectra (.3ds)")),
    (b"ZISRAWFILE", ForeignFile::Instrument("Zeiss image (.czi)")),
];

/// Bytes at the beginning in which the kind of a text shows.
const LOOKED_AT: usize = 1024;
/// Bytes of the header of a Createc image.
const CREATEC_HEADER: usize = 1 << 14;

impl ForeignFile {
    /// Recognises a file by its content; `None` for all that may hold numbers.
    #[must_use]
    pub fn recognise(bytes: &[u8]) -> Option<Self> {
        let has = |offset: usize, word: &[u8]| bytes.get(offset..).is_some_and(|rest| rest.starts_with(word));
        // The name of a file in an archive is stored as it is.
        let holds = |name: &str| memmem::find(bytes, name.as_bytes()).is_some();
        let start = &bytes[..bytes.len().min(CREATEC_HEADER)];
        let found = BEGINNINGS.iter().find(|(start, _)| bytes.starts_with(start)).map(|(_, kind)| *kind);
        match found {
            Some(Self::Zip) if has(30, b"mimetypeapplication/vnd.oasis") => Some(Self::OpenDocument),
            Some(Self::Zip) if holds("word/document.xml") || holds("ppt/presentation.xml") => {
                Some(Self::Document)
            }
            Some(Self::Zip) if holds("header.properties") && (holds("segments/0/") || holds("index/0/")) => {
                Some(Self::Instrument("JPK force curve or map"))
            }
            Some(Self::Zip) if holds("index.xml") && holds("recipe.txt") => {
                Some(Self::Instrument("Sensofar PLUX file without a layer of heights (LAYER_0)"))
            }
            Some(Self::Picture(_)) if holds("TiffTagDescData") => {
                Some(Self::Instrument("Olympus LEXT image (.lext)"))
            }
            Some(kind) => Some(kind),
            None if has(0, b"\x01\0\0\0") && has(24, b"TP\0\0PH\0\0") => {
                Some(Self::Instrument("high-speed AFM film (.asd)"))
            }
            // Other programs begin texts with '[Parameter]', too.
            None if has(0, b"[Param") && memmem::find(start, b"Num.X / Num.X").is_some() => {
                Some(Self::Instrument("Createc image (.dat)"))
            }
            None if has(2, b"S\0T\0i\0M\0a\0g\0e\0") => Some(Self::Instrument("RHK image (.sm4)")),
            None if has(0, b"RIFF") && has(8, b"WEBP") => Some(Self::Picture("WebP")),
            None if has(0, b"BM") && has(6, b"\0\0\0\0") => Some(Self::Picture("BMP")),
            None if has(4, b"ftyphei") || has(4, b"ftypavif") => Some(Self::Picture("HEIF")),
            None => {
                let start = String::from_utf8_lossy(&bytes[..bytes.len().min(LOOKED_AT)]).to_lowercase();
                let start = start.trim_start_matches('\u{feff}').trim_start();
                if start.starts_with("<!doctype html") || start.starts_with("<html") {
                    return Some(Self::WebPage);
                }
                (start.starts_with("<?xml") && start.contains("<svg")).then_some(Self::Picture("SVG"))
            }
        }
    }

    /// Advice on what to do instead.
    #[must_use]
    pub fn advice(self) -> &'static str {
        match self {
            Self::Picture(_) | Self::Pdf | Self::Document => "export the heights as text, CSV or .xlsx",
            Self::Instrument(_) => {
                "export the heights with the maker's program or Gwyddion, as .gsf, .x3p or text"
            }
            Self::WebPage => "download the file that the page offers",
            Self::OldOffice | Self::OpenDocument => "save it as .xlsx or CSV",
            Self::ForceCurve => "export an image of heights",
            Self::NanoscopeText => "save it with binary data",
            Self::Hdf5 => "save it as NetCDF-3 ('NETCDF3_64BIT_OFFSET')",
            Self::Zip => "unpack it",
        }
    }
}

impl fmt::Display for ForeignFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Picture(format) => write!(f, "a picture ({format})"),
            Self::Pdf => f.write_str("a PDF"),
            Self::WebPage => f.write_str("a web page"),
            Self::OldOffice => f.write_str("an old Office file (.xls, .doc)"),
            Self::Document => f.write_str("an Office document"),
            Self::OpenDocument => f.write_str("a LibreOffice file"),
            Self::ForceCurve => f.write_str("a Nanoscope force curve"),
            Self::NanoscopeText => f.write_str("a Nanoscope file with its data as text"),
            Self::Instrument(file) => write!(f, "a file that is not read: {file}"),
            Self::Hdf5 => f.write_str("HDF5 or NetCDF-4"),
            Self::Zip => f.write_str("a ZIP file without a known scan"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_are_recognised_by_content() {
        for (bytes, kind) in [
            (&b"\x89PNG\r\n\x1a\n"[..], Some(ForeignFile::Picture("PNG"))),
            (b"\xff\xd8\xff\xe0", Some(ForeignFile::Picture("JPEG"))),
            (b"BM\x36\0\x0c\0\0\0\0\0\x36", Some(ForeignFile::Picture("BMP"))),
            (b"RIFF\x10\0\0\0WEBPVP8 ", Some(ForeignFile::Picture("WebP"))),
            (b"<?xml version=\"1.0\"?>\n<svg>", Some(ForeignFile::Picture("SVG"))),
            (b"%PDF-1.7\n", Some(ForeignFile::Pdf)),
            (b"\n<!DOCTYPE html>", Some(ForeignFile::WebPage)),
            (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1\0", Some(ForeignFile::OldOffice)),
            (b"PK\x03\x04\0\0word/document.xml", Some(ForeignFile::Document)),
            (b"[Paramco32]\r\nNum.X / Num.X=8", Some(ForeignFile::Instrument("Createc image (.dat)"))),
            (b"\0\0\0\0TPPH\x83\0", Some(ForeignFile::Instrument("high-speed AFM film (.asd)"))),
            (
                b"\x01\0\0\0\xd3\0\0\0 \0\0\0\xa4\x03\0\0\t\0\0\0%\0\0\0TP\0\0PH\0\0",
                Some(ForeignFile::Instrument("high-speed AFM film (.asd)")),
            ),
            (b"\xaa\0S\0T\0i\0M\0a\0g\0e\0 \0", Some(ForeignFile::Instrument("RHK image (.sm4)"))),
            (
                b"PK\x03\x04 index.xml recipe.txt",
                Some(ForeignFile::Instrument("Sensofar PLUX file without a layer of heights (LAYER_0)")),
            ),
            (b"[Parameter]\nlength 4\n", None),
            (b"BM 1 2\n", None),
            (b"% position height\n0 1\n", None),
            (b"", None),
        ] {
            assert_eq!(ForeignFile::recognise(bytes), kind, "{}", bytes.escape_ascii());
        }
    }
}
