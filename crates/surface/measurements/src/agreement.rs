//! Scans of one instrument share its calibration, so their options about it must agree.

use crate::error::{ScanProblem, TopographyError};
use crate::instrument::InstrumentOfScan;

/// A scan with its instrument.
pub(crate) struct InstrumentUse<'s> {
    /// Index of its request.
    pub request: usize,
    /// The file.
    pub path: &'s str,
    /// The instrument of the scan.
    pub instrument: &'s InstrumentOfScan,
}

/// Refuses scans of one instrument, named or guessed, with different calibrations.
pub(crate) fn check(scans: &[InstrumentUse<'_>]) -> Result<(), TopographyError> {
    type Property = fn(&InstrumentOfScan) -> Option<f64>;
    let properties: [(&str, Property); 2] = [
        ("z-calibration", |instrument| instrument.z_calibration),
        ("slope uncertainty", |instrument| instrument.slope_uncertainty),
    ];
    for (at, scan) in scans.iter().enumerate() {
        let name = &scan.instrument.name;
        let before = || scans[..at].iter().filter(|other| other.instrument.name == *name);
        for (what, value_of) in properties {
            let Some(here) = value_of(scan.instrument) else { continue };
            let Some((other, there)) = before().find_map(|other| Some((other, value_of(other.instrument)?)))
            else {
                continue;
            };
            if here != there {
                let other = other.path.to_owned();
                let problem =
                    ScanProblem::InstrumentDisagrees { instrument: name.clone(), what, here, there, other };
                let error = TopographyError::for_file(scan.path, problem);
                return Err(TopographyError { request: Some(scan.request), ..error });
            }
        }
    }
    Ok(())
}
