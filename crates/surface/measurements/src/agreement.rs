//! Scans of one instrument share its height scale, so that what is said of it must be the same.

use crate::error::{ScanProblem, TopographyError};
use crate::instrument::InstrumentOfScan;

/// A scan, as it was asked for.
pub(crate) struct Asked<'s> {
    /// Which request it belongs to, by index.
    pub request: usize,
    /// The file.
    pub path: &'s str,
    /// Its instrument.
    pub instrument: &'s InstrumentOfScan,
}

/// Refuses scans of one instrument, named or guessed, that say different things of it.
pub(crate) fn check(scans: &[Asked<'_>]) -> Result<(), TopographyError> {
    type Said = fn(&InstrumentOfScan) -> Option<f64>;
    let sayings: [(&str, Said); 2] = [
        ("z-calibration", |instrument| instrument.z_calibration),
        ("slope uncertainty", |instrument| instrument.slope_uncertainty),
    ];
    for (at, scan) in scans.iter().enumerate() {
        let name = &scan.instrument.name;
        let before = || scans[..at].iter().filter(|other| other.instrument.name == *name);
        for (what, said) in sayings {
            let Some(here) = said(scan.instrument) else { continue };
            let Some((other, there)) = before().find_map(|other| Some((other, said(other.instrument)?)))
            else {
                continue;
            };
            if here != there {
                let other = other.path.to_owned();
                let problem =
                    ScanProblem::InstrumentDisagrees { instrument: name.clone(), what, here, there, other };
                let error = TopographyError::of_file(scan.path, problem);
                return Err(TopographyError { request: Some(scan.request), ..error });
            }
        }
    }
    Ok(())
}
