//! The limit that ends the band of a scan at its short end.

use scans::{Scan, ScanFile};
use units::display::length;
use units::{Remark, RemarkCode};

use crate::recipe::Recipe;
use crate::remark::BandEnd;
use crate::tip::may_have_a_tip;
use crate::tip_indication::{TipIndication, usual_tip_radii_m};
use crate::tip_words::{TipWords, proposed_tip};
use crate::{BandLimits, ReliableBand, TransformError};

/// The band of a scan, the limit that ends it, and remarks on the tip.
pub(crate) struct FoundBand {
    pub(crate) band: ReliableBand,
    pub(crate) end: BandEnd,
    pub(crate) tip_remarks: Vec<Remark>,
}

/// Computes the band of a scan and the limit that ends it.
pub(crate) fn band_of(
    file: &ScanFile<Scan>,
    given: BandLimits,
    recipe: &Recipe,
) -> Result<FoundBand, TransformError> {
    let limits = recipe.limits(given, file);
    let band = ReliableBand::new(&file.scan, limits)?;
    let ends = |limit_m: Option<f64>| limit_m == Some(band.shortest_m);
    let end = match limits.tip_radius_m {
        Some(radius_m) if ends(band.tip_m) => BandEnd::Tip { radius_m },
        _ if ends(given.shortest_m) => BandEnd::Given,
        _ if ends(file.resolution_m) => BandEnd::Resolution,
        None if limits.shortest_m.is_none() && may_have_a_tip(file) => BandEnd::PixelsWithoutTip,
        _ => BandEnd::Pixels,
    };
    let tip_remarks = tip_remarks(file, given, (&band, end));
    Ok(FoundBand { band, end, tip_remarks })
}

/// Remarks on a tip of unknown radius, and on a radius found in the text of the file.
fn tip_remarks(
    file: &ScanFile<Scan>,
    given: BandLimits,
    (band, end): (&ReliableBand, BandEnd),
) -> Vec<Remark> {
    if given.tip_radius_m.or(file.tip_radius_m).is_some() {
        return Vec::new();
    }
    let words = proposed_tip(&file.free_text).filter(|_| may_have_a_tip(file));
    let mut remarks = Vec::new();
    if end == BandEnd::PixelsWithoutTip {
        let sharp_tip = length(usual_tip_radii_m(band.shortest_m)[0]).replace('µ', "u");
        let indication = TipIndication::from_scan(&file.scan, band.shortest_m);
        remarks.push(
            Remark::new(RemarkCode::TipUnknown)
                .with("shortest_m", band.shortest_m)
                .with("sharp_tip", sharp_tip),
        );
        let remark = indication.remark();
        remarks.push(match indication.may_show_below_m() {
            Some(below_m) => remark.with("may_show_below_m", below_m),
            None => remark,
        });
    }
    let from_text = |words: TipWords| {
        let remark = Remark::new(RemarkCode::TipFromText).with("radius_m", words.radius_m);
        remark.with("text", words.text)
    };
    remarks.extend(words.map(from_text));
    remarks
}
