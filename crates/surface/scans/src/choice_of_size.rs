//! Lateral sizes: which one counts.

use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::options::{IGNORED, ScanOptions};
use crate::scan_size::ScanSize;

/// The size that counts: that of the options, else of the file, else of the metadata, else that to fall back on.
pub(crate) fn size(
    options: &ScanOptions,
    stated: Option<ScanSize>,
    notes: &mut Vec<String>,
) -> Option<ScanSize> {
    if let (Some(wanted), Some(stated)) = (options.size, stated)
        && wanted != stated
    {
        notes.push(format!("the size {wanted} asked for replaces that of the file, {stated}"));
    }
    let known = options.size.or(stated).or_else(|| options.metadata_size());
    if let (Some(known), Some(unused)) = (known, options.fallback_size)
        && known != unused
    {
        notes.push(format!("{IGNORED}the size {unused}: {known} is known"));
    }
    known.or(options.fallback_size)
}

/// Refuses a size asked for where every point has its position.
pub(crate) fn refuse_size(
    format: ScanFormat,
    place: FilePlace,
    options: &ScanOptions,
) -> Result<(), ScanReadError> {
    if options.size.is_none() { Ok(()) } else { Err(ScanReadError::SizeIsFixed { format, place }) }
}
