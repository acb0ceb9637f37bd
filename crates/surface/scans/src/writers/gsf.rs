//! Gwyddion Simple Field; `readers/gsf.rs` has its layout.

use super::ScanWriteError;
use crate::file::ScanFile;
use crate::readers::gsf::{ALIGNMENT, TITLE};

pub(super) fn write(file: &ScanFile, provenance: &str) -> Result<Vec<u8>, ScanWriteError> {
    let ((columns, Some(rows)), (x_m, Some(y_m))) = (file.scan.points(), file.scan.size_m()) else {
        return Err(ScanWriteError::Profile { format: ".gsf" });
    };
    // gsffile takes no value with a second equals sign.
    let [title, provenance] = [file.channel.as_deref().unwrap_or(&file.name), provenance]
        .map(|text| text.replace(['\n', '\r', '\0'], " ").replace('=', ":"));
    let header = format!(
        "{TITLE}XRes = {columns}\nYRes = {rows}\nXReal = {x_m:e}\nYReal = {y_m:e}\nXYUnits = m\nZUnits = m\n\
         Title = {title}\nComment = {provenance}\n"
    );
    let mut bytes = header.into_bytes();
    bytes.resize((bytes.len() / ALIGNMENT + 1) * ALIGNMENT, 0);
    bytes.extend(file.scan.heights_m().flat_map(|height| (height.unwrap_or(f64::NAN) as f32).to_le_bytes()));
    Ok(bytes)
}
