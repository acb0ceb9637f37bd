//! Causes that an answer hangs on, in words.

use conclusions::Cause;
use findings::features::DecadeShare;
use units::display::{length, percent, pressure, three_digits};

/// Describes the cause in a sentence or two.
pub(crate) fn cause_words(cause: Cause) -> String {
    match cause {
        Cause::GrowthOfHardness { ratio } => format!(
            "A constant hardness gives {} times the area of one that grows at small scales. Settle it by nano-indentation at the depth of the \
             roughness.",
            three_digits(ratio)
        ),
        Cause::Hardness { hardness_pa } => format!(
            "The area is the load over {}: 10 % harder, 10 % less area, whatever the roughness.",
            pressure(hardness_pa)
        ),
        Cause::HardnessAndRoughness { hardness_pa, decade } => format!(
            "Part of the contact flows at {}; the rest hangs on the slopes: {} of their mean square is from {}.",
            pressure(hardness_pa),
            percent(decade.share),
            scales(&decade)
        ),
        Cause::Roughness { decade } => {
            format!(
                "The slopes: {} of their mean square is from {}. 10 % steeper, up to 10 % less area.",
                percent(decade.share),
                scales(&decade)
            )
        }
        Cause::Adhesion => "Adhesion, which holds surfaces together wherever they come close.".to_owned(),
        Cause::FullContact => {
            "The pressure flattens all of the roughness: no scale is left to decide.".to_owned()
        }
        Cause::Unknown => "The hardness, and roughness that the spectrum does not have.".to_owned(),
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
            format!("the hardness, {}, and slopes from {}", pressure(hardness_pa), scales(&decade))
        }
        Cause::Roughness { decade } => {
            format!("slopes from {}: {} of their mean square", scales(&decade), percent(decade.share))
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
