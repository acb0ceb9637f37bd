//! The choices that the models leave open, in words: what a setting is, and of which paper.

use asperity::Hardness;
use spectrum::{AmplitudeDefinition, Normalisation};
use stat_contact::InterferenceLaw;

/// What the moments are multiplied by.
#[must_use]
pub fn normalisation(choice: Normalisation) -> &'static str {
    match choice {
        Normalisation::Parseval => "1/π, which keeps the variance",
        Normalisation::AsPrinted => "1, as printed in Eq. (1) of Jackson & Jacobs",
    }
}

/// What the amplitude of a scale is.
#[must_use]
pub fn amplitude(choice: AmplitudeDefinition) -> &'static str {
    match choice {
        AmplitudeDefinition::Eq5 => "Eq. (5) of Jackson & Jacobs",
        AmplitudeDefinition::Parseval => "of its band, which keeps the variance",
    }
}

/// How the hardness of a sphere falls as its contact grows.
#[must_use]
pub fn hardness(choice: Hardness) -> &'static str {
    match choice {
        Hardness::JacksonGreen2005 => "Jackson & Green 2005",
        Hardness::Cosine => "cosine form, 2.84 - 0.92 [1 - cos(πa/R)]",
        other => other.name(),
    }
}

/// What ties the pressure on an elastic sinusoid to its interference.
#[must_use]
pub fn interference(choice: InterferenceLaw) -> &'static str {
    match choice {
        InterferenceLaw::RostamiJackson => "fit of Rostami & Jackson 2013",
        InterferenceLaw::Bem => "boundary-element solutions",
    }
}
