//! Descriptions of the choices that the models leave open: each setting, and its source.

use asperity::Hardness;
use persson::Band;
use persson::corrections::Correction;
use spectrum::{AmplitudeDefinition, Normalisation};
use stacked_contact::YieldingAreaLaw;
use stat_contact::{Flattening, InterferenceLaw};

use crate::growth_law::GrowthLaw;

/// Describes the factor of the moments.
#[must_use]
pub fn normalisation(choice: Normalisation) -> &'static str {
    match choice {
        Normalisation::Parseval => "1/π, which keeps the variance",
        Normalisation::AsPrinted => "1, as printed in Eq. (1) of Jackson & Jacobs",
    }
}

/// Describes the definition of the amplitude of a scale.
#[must_use]
pub fn amplitude(choice: AmplitudeDefinition) -> &'static str {
    match choice {
        AmplitudeDefinition::Eq5 => "Eq. (5) of Jackson & Jacobs",
        AmplitudeDefinition::Parseval => "of its band, which keeps the variance",
    }
}

/// Names the law by which the hardness of a sphere falls as its contact grows.
#[must_use]
pub fn hardness(choice: Hardness) -> &'static str {
    match choice {
        Hardness::JacksonGreen2005 => "Jackson & Green 2005",
        Hardness::Cosine => "cosine form, 2.84 - 0.92 [1 - cos(πa/R)]",
        other => other.name(),
    }
}

/// Names the quantities of flattened spheres that no longer grow.
#[must_use]
pub fn flattening(choice: Flattening) -> &'static str {
    match choice {
        Flattening::Area => "area held at a = R, force unlimited",
        Flattening::AreaAndForce => "area and force held from a = 0.41 R",
    }
}

/// Names the area of a scale of a stack that yields.
#[must_use]
pub fn yielding_area(choice: YieldingAreaLaw) -> &'static str {
    match choice {
        YieldingAreaLaw::Blended => "plastic power law blended into complete contact, limited to 1",
        YieldingAreaLaw::ElasticShape => "elastic area at p/p*_ep",
    }
}

/// Names the law between the pressure on an elastic sinusoid and its interference.
#[must_use]
pub fn interference(choice: InterferenceLaw) -> &'static str {
    match choice {
        InterferenceLaw::RostamiJackson => "fit of Rostami & Jackson 2013",
        InterferenceLaw::Bem => "boundary-element solutions",
    }
}

/// Names a corrected form of Persson's elastic theory by those who fitted it.
#[must_use]
pub fn correction(choice: Correction) -> &'static str {
    match choice {
        Correction::WangMuser => "corrected as Wang & Müser 2017",
        Correction::YangPersson => "corrected as Yang & Persson 2008",
        Correction::Algebraic => "corrected as Xu et al. 2024",
        Correction::AlgebraicNayak => "corrected as Xu et al. 2024, by Nayak's alpha",
        other => other.name(),
    }
}

/// Names the spectrum that a cutoff ends.
#[must_use]
pub fn band(choice: Band) -> &'static str {
    match choice {
        Band::Profile => "spectrum of profiles",
        Band::Surface => "spectrum of the surface",
        other => other.name(),
    }
}

/// Names the growth of a hardness towards short wavelengths.
#[must_use]
pub fn hardness_law(choice: &GrowthLaw) -> String {
    match choice {
        GrowthLaw::Power(exponent) => format!("hardness as the wavevector to the power {exponent}"),
        GrowthLaw::NixGao => "hardness as Nix & Gao 1998".to_owned(),
        GrowthLaw::Table(_) => "hardness by a table".to_owned(),
    }
}
