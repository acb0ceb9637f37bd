//! Zlib streams within bounds.

use std::io::Read;

use flate2::read::ZlibDecoder;

use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;

/// Offset of a stream in a file, for messages.
pub(crate) struct StreamPlace {
    pub(crate) format: ScanFormat,
    pub(crate) offset: usize,
}

/// Unpacks a stream that must hold exactly so many bytes. Memory grows with what is unpacked, not with what is
/// promised.
pub(crate) fn inflated(place: &StreamPlace, packed: &[u8], length: usize) -> Result<Vec<u8>, ScanReadError> {
    let bad = |value: String| {
        place.format.bad(
            FilePlace::Byte(place.offset as u64),
            "the packed data",
            value,
            format!("a zlib stream of {length} bytes"),
            "the file is damaged: export it again",
        )
    };
    let mut unpacked = Vec::new();
    // One byte more shows a stream that is too long.
    let limit = (length as u64).saturating_add(1);
    ZlibDecoder::new(packed)
        .take(limit)
        .read_to_end(&mut unpacked)
        .map_err(|error| bad(error.to_string()))?;
    match unpacked.len() {
        found if found == length => Ok(unpacked),
        found if found > length => Err(bad("longer".to_owned())),
        found => Err(bad(format!("one of {found} bytes"))),
    }
}
