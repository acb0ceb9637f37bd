//! Recognition of the format of a file by its content.

use crate::format::ScanFormat;
use crate::readers::{READERS, reader_of};

impl ScanFormat {
    /// Recognises the format of a binary file by its content; `None` for text, which may be anything, and for unknown
    /// files. [`read_scans`](crate::read_scans) may still refuse the file.
    #[must_use]
    pub fn recognise(bytes: &[u8]) -> Option<Self> {
        #[cfg(feature = "archives")]
        let bytes = &*crate::unpacked::recognisable(bytes);
        #[cfg(feature = "container")]
        if crate::archive::is_container(bytes) {
            return Some(Self::Container);
        }
        reader_of(bytes).map(|reader| reader.format).filter(|format| *format != Self::Text)
    }

    /// Returns every format but text that the content of a file fits. More than one shows a file made to deceive, or
    /// readers that recognise their files too loosely.
    #[must_use]
    pub fn candidates(bytes: &[u8]) -> Vec<Self> {
        let claimed = READERS.iter().filter(|reader| (reader.recognises)(bytes));
        claimed.map(|reader| reader.format).filter(|format| *format != Self::Text).collect()
    }
}
