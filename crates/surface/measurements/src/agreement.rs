//! Scans of one instrument share its calibration, so their options about it must agree.

use std::collections::HashMap;

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
    let mut stated = HashMap::new();
    for scan in scans {
        let name = &scan.instrument.name;
        for (what, value_of) in properties {
            let Some(here) = value_of(scan.instrument) else { continue };
            let (other, there) = *stated.entry((name, what)).or_insert((scan.path, here));
            if here != there {
                let (name, other) = (name.clone(), other.to_owned());
                let problem = ScanProblem::InstrumentDisagrees { instrument: name, what, here, there, other };
                let error = TopographyError::for_file(scan.path, problem);
                return Err(TopographyError { request: Some(scan.request), ..error });
            }
        }
    }
    Ok(())
}
