//! Files of scans, one or many.

use crate::error::ScanReadError;
use crate::file::ScanFile;
#[cfg(feature = "container")]
use crate::format::Magic;
use crate::options::ScanOptions;
use crate::single::read_one;

/// Reads the scan in a file, or those in a container.
///
/// The format is told by the content: text (profiles `x h`, one column of heights, points `x y h`, matrices; decimal
/// commas where unambiguous), Nanoscope files with binary data, NetCDF-3 as contact.engineering writes it, X3P, and the
/// containers of contact.engineering. `name` is the name of the file, for messages. Memory is bounded by a small
/// multiple of the file, or of what a ZIP file unpacks to.
///
/// ```
/// use scans::{Scan, ScanOptions, read_scans};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let options = ScanOptions { unit: Some("µm".parse()?), ..ScanOptions::default() };
/// let scans = read_scans(b"0.0 0.125\n0.5 0.25\n1.0 0.125\n", "stylus.txt", &options)?;
/// let Scan::UniformLine(line) = &scans[0].scan else { panic!("evenly spaced") };
/// assert_eq!((line.spacing_m(), line.heights_m()[1]), (0.5e-6, 0.25e-6));
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// [`ScanReadError`], with the place in the file, the value and the bound, for the first thing that is wrong.
pub fn read_scans(bytes: &[u8], name: &str, options: &ScanOptions) -> Result<Vec<ScanFile>, ScanReadError> {
    #[cfg(feature = "container")]
    if Magic::of(bytes) == Magic::Zip {
        let mut archive = crate::archive::Archive::open(bytes, options.unpacked_bound())?;
        if let Some(index) = crate::container::index_path(&archive) {
            return crate::container::read(&mut archive, &index, options);
        }
    }
    Ok(vec![read_one(bytes, name, options)?])
}
