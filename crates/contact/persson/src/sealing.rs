//! Sealing: open channels through a contact and their narrowest place, by Persson & Yang (2008), J. Phys.: Condens.
//! Matter 20:315011.
//!
//! At low magnification, with its long waves alone, a surface touches everywhere; every shorter wave opens gaps
//! inside the contact. The channels connect at the wavevector q_c at which the share in contact has come down to the
//! percolation threshold, A(q_c) = a_c. Their narrowest places are the gaps that open at q_c, with the mean height
//!
//! u_1(q) = ubar(q) + ubar'(q) A(q)/A'(q),
//!
//! This follows from the balance (A + dA) ubar(q + dq) + (-dA) u_1 = A ubar(q) of each wave, with ubar(q) the mean
//! gap inside the contact at q: [`SeparationLaw::beyond`] q under p/A(q). Along the spectrum the derivatives are
//! taken by V, where they have a closed form:
//!
//! u_1 = ubar + P/K + (dA/dV)^-1 A du/dV_z,  P = p/A, K the stiffness belonging to ubar(P).

use numerics::zero_in_bracket;
use units::{Bound, OutOfBounds};

use crate::corrections::{Correction, flattened};
use crate::elastic::argument_of_area;
use crate::energy::EnergyFactor;
use crate::roughness::Roughness;
use crate::separation::SeparationLaw;

/// Share of the nominal area in contact at which the last open channel closes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PercolationThreshold(f64);

impl PercolationThreshold {
    /// 0.42, from simulations of randomly rough surfaces (Dapp et al. 2012, Phys. Rev. Lett. 108:244301). This
    /// project's boundary elements give 0.416 +- 0.03 in a channel of eight roll-off wavelengths.
    pub const SIMULATED: Self = PercolationThreshold(0.42);

    /// Range of a threshold.
    pub const BOUND: Bound = Bound::Between { above: 0.0, below: 1.0 };

    /// Creates a threshold.
    ///
    /// # Errors
    /// [`OutOfBounds`] unless it lies between 0 and 1.
    pub fn new(area_fraction: f64) -> Result<Self, OutOfBounds> {
        Ok(PercolationThreshold(
            Self::BOUND.check("share in contact at which channels close", area_fraction)?,
        ))
    }

    /// The threshold as a share of the nominal area.
    #[must_use]
    pub fn area_fraction(self) -> f64 {
        self.0
    }

    /// Argument p/sqrt(2 V_e) of erf at this share, at least 1e-100 so that its square does not vanish.
    fn argument(self) -> f64 {
        argument_of_area(self.0).max(1e-100)
    }
}

impl Default for PercolationThreshold {
    fn default() -> Self {
        Self::SIMULATED
    }
}

/// Contact at one magnification: with the waves up to a wavevector only.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct MagnifiedContact {
    /// The wavevector q \[rad/m\].
    pub wavevector_rad_per_m: f64,
    /// Share in contact A(q), in (0, 1\].
    pub area_fraction: f64,
    /// Mean gap ubar(q) >= 0 that shorter waves open inside that share \[m\].
    pub mean_gap_m: f64,
    /// Mean gap u_1(q) of the area that opens at q \[m\]. `None` if none opens: where all of the area is in contact
    /// to rounding, and where V does not grow.
    pub opening_gap_m: Option<f64>,
}

impl MagnifiedContact {
    /// Wavelength 2 pi/q \[m\].
    #[must_use]
    pub fn wavelength_m(&self) -> f64 {
        std::f64::consts::TAU / self.wavevector_rad_per_m
    }
}

/// Elastic contact as a seal, under any load.
#[derive(Debug, Clone)]
pub struct SealingLaw {
    roughness: Roughness,
    contact_modulus_pa: f64,
    correction: Option<Correction>,
    threshold: PercolationThreshold,
    separation: SeparationLaw,
}

impl SealingLaw {
    /// Creates the seal of a roughness under a contact modulus E* > 0 \[Pa\]. Give a correction: without one the theory has 20 % too little area.
    #[must_use]
    pub fn new(
        roughness: &Roughness,
        contact_modulus_pa: f64,
        energy_factor: EnergyFactor,
        correction: Option<Correction>,
        threshold: PercolationThreshold,
    ) -> Self {
        let separation = SeparationLaw::from_roughness(roughness, contact_modulus_pa, energy_factor);
        SealingLaw { roughness: roughness.clone(), contact_modulus_pa, correction, threshold, separation }
    }

    /// Smallest nominal pressure \[Pa\] under which the seal is tight; 0 without roughness.
    #[must_use]
    pub fn tight_pressure_pa(&self) -> f64 {
        self.roughness.places().last().map_or(0.0, |last| {
            let flattened = flattened(self.correction, self.threshold.argument(), last.alpha);
            (last.variance_pa2(self.contact_modulus_pa) / flattened.variance_over_square_pressure).sqrt()
        })
    }

    /// Finds the narrowest place of the last channel under a nominal pressure p > 0 \[Pa\]: the contact at q_c, whose
    /// `opening_gap_m` is u_c. Returns `None` if the seal is tight: with all waves, the threshold or more is in
    /// contact.
    #[must_use]
    pub fn critical_constriction(&self, pressure_pa: f64) -> Option<MagnifiedContact> {
        let wavevectors: Vec<f64> =
            self.roughness.places().iter().map(|place| place.wavevector_rad_per_m).collect();
        let is_open = |wavevector_rad_per_m: f64| self.opened(wavevector_rad_per_m, pressure_pa) > 0.0;
        if !wavevectors.last().copied().is_some_and(is_open) {
            return None;
        }
        // If the corrected area rises again, which takes an alpha that falls, channels connect earlier: take the
        // first.
        let [start, end] = wavevectors.windows(2).find_map(|pair| match pair {
            &[start, end] if is_open(end) => Some([start, end]),
            _ => None,
        })?;
        let wavevector_rad_per_m = zero_in_bracket(start, end, |q| self.opened(q, pressure_pa));
        Some(self.with_argument(wavevector_rad_per_m, pressure_pa, self.threshold.argument()))
    }

    /// Threshold at which the last channel closes.
    #[must_use]
    pub fn threshold(&self) -> PercolationThreshold {
        self.threshold
    }

    /// Mean gap under a nominal pressure p > 0 \[Pa\], of the theory \[m\].
    #[must_use]
    pub fn mean_gap_m(&self, pressure_pa: f64) -> f64 {
        self.separation.whole(pressure_pa).mean_gap_m
    }

    /// Share in contact with all waves under a nominal pressure p > 0 \[Pa\]; 1 without roughness.
    #[must_use]
    pub fn area_fraction(&self, pressure_pa: f64) -> f64 {
        self.ends_rad_per_m().map_or(1.0, |[_, last]| self.area_up_to(last, pressure_pa))
    }

    /// Contact with the waves up to a wavevector within the spectrum \[rad/m\] under a nominal pressure p > 0 \[Pa\].
    #[must_use]
    pub fn contact_at(&self, wavevector_rad_per_m: f64, pressure_pa: f64) -> MagnifiedContact {
        let argument = self.argument(wavevector_rad_per_m, pressure_pa);
        self.with_argument(wavevector_rad_per_m, pressure_pa, argument)
    }

    /// Wavevectors \[rad/m\] of the longest and of the shortest waves; `None` without roughness.
    pub(crate) fn ends_rad_per_m(&self) -> Option<[f64; 2]> {
        let [first, .., last] = self.roughness.places() else { return None };
        Some([first.wavevector_rad_per_m, last.wavevector_rad_per_m])
    }

    /// Mean square height of the waves beyond a wavevector \[m^2\].
    pub(crate) fn mean_square_height_beyond_m2(&self, wavevector_rad_per_m: f64) -> f64 {
        self.separation.beyond(wavevector_rad_per_m).mean_square_height_m2()
    }

    /// Share in contact with the waves up to a wavevector \[rad/m\].
    pub(crate) fn area_up_to(&self, wavevector_rad_per_m: f64, pressure_pa: f64) -> f64 {
        libm::erf(self.argument(wavevector_rad_per_m, pressure_pa))
    }

    /// The x of A = erf(x) with the waves up to a wavevector.
    fn argument(&self, wavevector_rad_per_m: f64, pressure_pa: f64) -> f64 {
        let variance_pa2 = self.separation.variance_pa2(wavevector_rad_per_m);
        let effective_pa2 = match self.correction {
            None => variance_pa2,
            Some(correction) => {
                let [alpha, _] = self.roughness.alpha_at(wavevector_rad_per_m);
                correction
                    .effective_variances_pa2(pressure_pa, &[variance_pa2], &[alpha])
                    .first()
                    .copied()
                    .unwrap_or(variance_pa2)
            }
        };
        pressure_pa / (2.0 * effective_pa2).sqrt()
    }

    /// Excess of V/p^2 over the value that leaves the threshold in contact.
    fn opened(&self, wavevector_rad_per_m: f64, pressure_pa: f64) -> f64 {
        let [alpha, _] = self.roughness.alpha_at(wavevector_rad_per_m);
        let flattened = flattened(self.correction, self.threshold.argument(), alpha);
        let scaled = self.separation.variance_pa2(wavevector_rad_per_m) / pressure_pa / pressure_pa;
        scaled - flattened.variance_over_square_pressure
    }

    /// Contact at a wavevector where A = erf(`argument`).
    fn with_argument(&self, wavevector_rad_per_m: f64, pressure_pa: f64, argument: f64) -> MagnifiedContact {
        let area_fraction = libm::erf(argument);
        let inside = self.separation.beyond(wavevector_rad_per_m);
        let real_pressure_pa = pressure_pa / area_fraction;
        let separation = inside.whole(real_pressure_pa);
        let opening_gap_m =
            self.variance_per_area_pa2(wavevector_rad_per_m, pressure_pa, argument).map(|per_area| {
                let left_out = inside.gap_per_variance_left_out_m_per_pa2(real_pressure_pa);
                separation.mean_gap_m
                    + real_pressure_pa / separation.stiffness_pa_per_m
                    + area_fraction * per_area * left_out
            });
        MagnifiedContact {
            wavevector_rad_per_m,
            area_fraction,
            mean_gap_m: separation.mean_gap_m,
            opening_gap_m: opening_gap_m.filter(|gap_m| gap_m.is_finite()),
        }
    }

    /// Derivative dV/dA < 0 along the spectrum \[Pa^2\] of V = p^2 r(A, alpha), with alpha a function of V. `None`
    /// where A does not fall.
    fn variance_per_area_pa2(
        &self,
        wavevector_rad_per_m: f64,
        pressure_pa: f64,
        argument: f64,
    ) -> Option<f64> {
        let [alpha, ln_alpha_per_ln_q] = self.roughness.alpha_at(wavevector_rad_per_m);
        let flattened = flattened(self.correction, argument, alpha);
        let square_pa2 = pressure_pa * pressure_pa;
        let variance_per_ln_q_pa2 = self.separation.variance_per_ln_wavevector_pa2(wavevector_rad_per_m)?;
        let by_alpha = square_pa2 * flattened.per_ln_alpha * ln_alpha_per_ln_q / variance_per_ln_q_pa2;
        let per_area = square_pa2 * flattened.per_area / (1.0 - by_alpha);
        Some(per_area).filter(|per_area| per_area.is_finite() && *per_area < 0.0)
    }
}
