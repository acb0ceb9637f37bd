//! Gap and compliance that parts which are not flat add to those of their roughness.
//!
//! As a wave, the deviation is one of the roughness in Persson's theory, or a smooth ridge; as a cap, it is a smooth body on which the roughness has the local
//! pressure. Peaks that flow get the same additions, since the deviation stays elastic.

use ::interface::conductance::RelativeStiffness;
use ::interface::flatness::{Deviation, Ridge};
use persson::separation::{Separation, SeparationLaw};

/// Additions of one limit of flatness under a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlatnessAdds {
    /// Mean gap \[m\].
    pub gap_m: f64,
    /// Compliance per nominal area \[m/Pa\].
    pub compliance_m_per_pa: f64,
    /// Share of the nominal contact over which contact spreads.
    pub share: f64,
}

impl FlatnessAdds {
    /// The stiffness of the addition over the contact modulus \[Pa\]; `None` if it adds no compliance, or less than the range of
    /// magnitudes has.
    pub(super) fn stiffness(&self, modulus_pa: f64) -> Option<RelativeStiffness> {
        RelativeStiffness::new(self.compliance_m_per_pa.recip(), modulus_pa).ok()
    }

    /// Compares a limit with flat faces.
    fn new(limit: Separation, flat: Separation, share: f64) -> Self {
        FlatnessAdds {
            gap_m: (limit.mean_gap_m - flat.mean_gap_m).max(0.0),
            compliance_m_per_pa: (limit.stiffness_pa_per_m.recip() - flat.stiffness_pa_per_m.recip())
                .max(0.0),
            share,
        }
    }

    /// Compares a wave with flat faces. It is one of the roughness, by the law with it, or a smooth ridge; what the two add is nearest to
    /// elements by the one that adds less (`docs/develop/trials.md`): a smooth ridge spreads too little contact, and the theory too much gap.
    pub(super) fn of_wave(
        with_wave: &SeparationLaw,
        law: &SeparationLaw,
        flat: Separation,
        ridge: &Ridge,
        pressure_pa: f64,
    ) -> Self {
        let (in_theory, smooth) =
            (Self::new(with_wave.whole(pressure_pa), flat, ridge.share()), Self::of(ridge, law, flat));
        FlatnessAdds {
            gap_m: in_theory.gap_m.min(smooth.gap_m),
            compliance_m_per_pa: in_theory.compliance_m_per_pa.min(smooth.compliance_m_per_pa),
            share: smooth.share,
        }
    }

    /// Compares a smooth deviation under the roughness with flat faces. Around the contact the roughness keeps the gap of the nominal
    /// pressure.
    pub(super) fn of(deviation: &impl Deviation, law: &SeparationLaw, flat: Separation) -> Self {
        let inside_m = deviation.mean_inside(|local_pa| law.whole(local_pa).mean_gap_m);
        let outside_m = deviation.mean_outside(|gap_m| gap_m + flat.mean_gap_m);
        let of_roughness = deviation.mean_inside(|local_pa| law.whole(local_pa).stiffness_pa_per_m);
        let compliance_m_per_pa = deviation.compliance_m_per_pa() + of_roughness.recip();
        let limit =
            Separation { mean_gap_m: inside_m + outside_m, stiffness_pa_per_m: compliance_m_per_pa.recip() };
        Self::new(limit, flat, deviation.share())
    }
}
