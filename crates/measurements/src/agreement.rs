//! Scans of one instrument share its height scale, so that what is said of it must be the same.

use crate::error::{ScanProblem, TopographyError};
use crate::request::ScanRequest;

/// Refuses scans of one named instrument that say different things of it.
pub(crate) fn check(requests: &[ScanRequest]) -> Result<(), TopographyError> {
    type Said = fn(&ScanRequest) -> Option<f64>;
    let sayings: [(&str, Said); 2] = [
        ("z-calibration", |request| request.z_calibration),
        ("slope uncertainty", |request| request.slope_uncertainty),
    ];
    for (at, request) in requests.iter().enumerate() {
        let Some(instrument) = &request.instrument else { continue };
        let of_instrument =
            || requests[..at].iter().filter(|other| other.instrument.as_ref() == Some(instrument));
        for (what, said) in sayings {
            let Some(here) = said(request) else { continue };
            let Some((other, there)) = of_instrument().find_map(|other| Some((other, said(other)?))) else {
                continue;
            };
            if here != there {
                let problem = ScanProblem::InstrumentDisagrees {
                    instrument: instrument.clone(),
                    what,
                    here,
                    there,
                    other: other.path.clone(),
                };
                return Err(TopographyError {
                    request: Some(at),
                    ..TopographyError::of_file(&request.path, problem)
                });
            }
        }
    }
    Ok(())
}
