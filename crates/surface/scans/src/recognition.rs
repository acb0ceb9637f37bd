//! How the format of a file is told: by its content.

use crate::format::ScanFormat;
use crate::readers::{READERS, reader_of};

impl ScanFormat {
    /// The format of a binary file, told by its content; `None` for text, which may be anything, and for what no reader
    /// knows. Whether it can be read is [`read_scans`](crate::read_scans)'s to say.
    #[must_use]
    pub fn of(bytes: &[u8]) -> Option<Self> {
        #[cfg(feature = "archives")]
        let bytes = &*crate::unpacked::told_by(bytes);
        #[cfg(feature = "container")]
        if crate::archive::is_container(bytes) {
            return Some(Self::Container);
        }
        reader_of(bytes).map(|reader| reader.format).filter(|format| *format != Self::Text)
    }

    /// Every format but text that a file, as it is, could be of by its content. More than one is the mark of a file that was
    /// made to deceive, or of readers that tell their files too loosely.
    #[must_use]
    pub fn candidates(bytes: &[u8]) -> Vec<Self> {
        let claimed = READERS.iter().filter(|reader| (reader.recognises)(bytes));
        claimed.map(|reader| reader.format).filter(|format| *format != Self::Text).collect()
    }
}
