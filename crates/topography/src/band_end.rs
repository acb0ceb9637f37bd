//! What ends the band of a scan at its short end.

use scans::{Probe, Scan, ScanFile};

use crate::recipe::Recipe;
use crate::remark::{BandEnd, ScanRemark};
use crate::{BandLimits, ReliableBand, TransformError};

/// The band of a scan, and what ends it.
pub(crate) fn band_of(
    file: &ScanFile<Scan>,
    given: BandLimits,
    recipe: &Recipe,
) -> Result<(ReliableBand, BandEnd), TransformError> {
    let limits = recipe.limits(given, file);
    let band = ReliableBand::of(&file.scan, limits)?;
    let ends = |limit_m: Option<f64>| limit_m == Some(band.shortest_m);
    let end = match limits.tip_radius_m {
        Some(radius_m) if ends(band.tip_m) => BandEnd::Tip { radius_m },
        _ if ends(given.shortest_m) => BandEnd::Given,
        _ if ends(file.resolution_m) => BandEnd::Resolution,
        None if limits.shortest_m.is_none() && may_have_a_tip(file) => BandEnd::PixelsWithoutTip,
        _ => BandEnd::Pixels,
    };
    Ok((band, end))
}

/// What there is to say of a tip that nobody knows.
pub(crate) fn tip_remark(band: &ReliableBand, end: BandEnd) -> Option<ScanRemark> {
    (end == BandEnd::PixelsWithoutTip).then_some(ScanRemark::TipUnknown { shortest_m: band.shortest_m })
}

/// Whether a tip may have touched the surface: not that of a microscope, nor heights that repeat themselves, which were
/// computed.
fn may_have_a_tip(file: &ScanFile<Scan>) -> bool {
    file.probe != Some(Probe::Microscope) && !file.is_periodic
}
