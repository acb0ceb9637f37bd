//! Causes that an answer hangs on, in words.

use conclusions::Cause;
use findings::features::DecadeShare;
use units::display::{length, percent, pressure, three_digits};

/// Names the cause in a word or two; `None` where words alone tell it.
pub(crate) fn cause_in_short(cause: Cause) -> Option<String> {
    match cause {
        Cause::GrowthOfHardness { .. } | Cause::Hardness { .. } => Some("the hardness".to_owned()),
        Cause::HardnessAndRoughness { .. } => Some("hardness and roughness".to_owned()),
        Cause::Roughness { decade } => Some(percent(decade.share)),
        Cause::Adhesion => Some("adhesion".to_owned()),
        Cause::FullContact | Cause::Unknown => None,
    }
}

/// Describes the cause in a sentence or two.
pub(crate) fn cause_words(cause: Cause) -> String {
    match cause {
        Cause::GrowthOfHardness { ratio } => format!(
            "A constant one gives {} times the area of one that grows at small scales. Settle it by nano-indentation at the depth of the \
             roughness.",
            three_digits(ratio)
        ),
        Cause::Hardness { hardness_pa } => format!(
            "The area is the load over {}: 10 % harder, 10 % less area, whatever the roughness.",
            pressure(hardness_pa)
        ),
        Cause::HardnessAndRoughness { hardness_pa, decade } => format!(
            "Part of the contact flows at {}; of what roughness decides, {} is from {}.",
            pressure(hardness_pa),
            percent(decade.share),
            scales(&decade)
        ),
        Cause::Roughness { decade } => {
            format!("of the answer is decided by roughness from {}.", scales(&decade))
        }
        Cause::Adhesion => "It holds surfaces together wherever they come close.".to_owned(),
        Cause::FullContact => {
            "The pressure flattens all of the roughness: no scale is left to decide.".to_owned()
        }
        Cause::Unknown => {
            "Roughness, and the hardness where peaks flow. Which scales is not known: no closed form agrees on most of them.".to_owned()
        }
    }
}

/// Words the cause in a line; `None` if it is unknown.
pub(crate) fn cause_line(cause: Cause) -> Option<String> {
    Some(match cause {
        Cause::GrowthOfHardness { .. } => "whether the hardness grows at small scales".to_owned(),
        Cause::Hardness { .. } => {
            "the hardness: 10 % harder, 10 % less area, whatever the roughness".to_owned()
        }
        Cause::HardnessAndRoughness { hardness_pa, decade } => {
            format!("the hardness, {}, and roughness from {}", pressure(hardness_pa), scales(&decade))
        }
        Cause::Roughness { decade } => {
            format!("roughness from {}: {}", scales(&decade), percent(decade.share))
        }
        Cause::Adhesion => "adhesion, which no area here counts".to_owned(),
        Cause::FullContact => "nothing: all of the roughness is flattened".to_owned(),
        Cause::Unknown => return None,
    })
}

fn scales(decade: &DecadeShare) -> String {
    let measured = if decade.measured { "" } else { ", not measured" };
    format!("{} to {}{measured}", length(decade.longest_m), length(decade.shortest_m))
}
