//! Surfaces that stick to each other, by an indicator.

use interface::adhesion::{NOT_STICKY_ABOVE, StickyContact};
use study::interface::{InterfaceStates, Quantity, Slot};
use units::{Remark, RemarkCode};

/// The indicator that finds the surface sticky: Pastewka & Robbins' criterion, or without a range of the attraction Fuller &
/// Tabor's parameter.
pub(crate) fn stickiness(states: &InterfaceStates<'_>) -> Option<Remark> {
    let value = |quantity| states.value(Slot { quantity, load: None, curve: None }).ok().flatten();
    if let Some(left_side) = value(Quantity::PastewkaRobbins) {
        let remark = Remark::new(RemarkCode::StickyByPastewka).with("indicator", "pastewka-robbins");
        let remark = remark.with("left_side", left_side).with("limit", StickyContact::LIMIT);
        return (left_side < StickyContact::LIMIT).then_some(remark);
    }
    let theta = value(Quantity::FullerTabor)?;
    let remark = Remark::new(RemarkCode::StickyByFuller).with("indicator", "fuller-tabor");
    let remark = remark.with("theta", theta).with("limit", NOT_STICKY_ABOVE);
    (theta <= NOT_STICKY_ABOVE).then_some(remark)
}
