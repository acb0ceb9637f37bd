//! Mean separation and stiffness: Persson (2007), Phys. Rev. Lett. 99:125502; Yang & Persson (2008), J. Phys.: Condens.
//! Matter 20:215214; Almqvist et al. (2011), J. Mech. Phys. Solids 59:2355.
//!
//! From p = -dU/du with the elastic energy U of the flattened waves in contact, over v = sqrt(2 V) in place of the
//! wavevector, one integral with a bounded integrand:
//!
//! u(p) = (2/(sqrt(pi) E*)) Int_0^v1 G(p/v) dv/q(v),  G(x) = Int_x^inf \[g + (n + 1) (1 - g) erf(t)^n\] exp(-t^2) dt/t,
//! 1/K = -du/dp = (1/p) (2/(sqrt(pi) E*)) Int_0^v1 \[g + (n + 1) (1 - g) erf(p/v)^n\] exp(-(p/v)^2) dv/q(v).
//!
//! The energy in contact is W = g + (1 - g) P^n of that of full contact at an area fraction P ([`EnergyFactor`]); n = 2 there.
//! On a layer E*(q) is in place of E*, inside the integrals. u is measured from the mean plane of the deformed rough
//! surface to the flat. Both integrals take the whole spectrum and are dominated by its longest wavelengths.
//!
//! Under light loads u = u_0 ln(p_00/p), as if the heights fell off exponentially. Those of a surface are Gaussian: with the waves of
//! the surface K/p grows by (u - u_1)/sigma^2 above u_1 = 1.5 rms heights sigma ([`TAIL_START`]), so that p falls like exp(-(u -
//! u_1)^2/2 sigma^2) as well.

use std::f64::consts::PI;
use std::sync::{Arc, LazyLock};

use asperity::LayerCompliance;
use numerics::{GaussLegendre, zero_in_bracket};

use crate::contact_energy::ContactEnergy;
use crate::energy::EnergyFactor;
use crate::roughness::{Place, Roughness};
use crate::stretch::Stretch;

pub use crate::stretch::SeparationKnot;

impl SeparationKnot {
    /// Returns the knots of a roughness under a contact modulus E* > 0 \[Pa\].
    #[must_use]
    pub fn along(roughness: &Roughness, contact_modulus_pa: f64) -> Vec<Self> {
        let knot = |place: &Place| SeparationKnot {
            wavevector_rad_per_m: place.wavevector_rad_per_m,
            variance_pa2: place.variance_pa2(contact_modulus_pa),
            variance_exponent: place.variance_exponent,
        };
        roughness.places().iter().map(knot).collect()
    }
}

/// Mean gap and stiffness under a load with the spectrum cut off somewhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Separation {
    /// Mean separation u > 0 of the flat from the mean plane of the deformed surface \[m\].
    pub mean_gap_m: f64,
    /// Stiffness K = -dp/du \[Pa/m\]; infinite where nothing has been flattened.
    pub stiffness_pa_per_m: f64,
}

/// Waves of a narrow band.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wave {
    /// Wavevector \[rad/m\].
    pub(crate) wavevector_rad_per_m: f64,
    /// Mean square height \[m^2\].
    pub(crate) mean_square_height_m2: f64,
}

/// Area fraction below which stiffness and gap are less certain, since few summits of a finite surface carry the load.
pub const LIGHT_CONTACT: f64 = 0.02;

/// Factor between the stiffness and that of boundary elements, either way, which nine of ten spectra keep (`docs/develop/trials.md`);
/// under such loads it is the largest.
pub const STIFFNESS_WITHIN: f64 = 1.25;

/// Mean gap over the rms height from which on the Gaussian tail of the heights stiffens the contact. With 1.5 gap and stiffness are
/// nearest to those of boundary elements on 24 spectra (`docs/develop/trials.md`).
pub const TAIL_START: f64 = 1.5;

/// Limit of light loads, u = u_0 ln(p_00/p) and K = p/u_0, without the tail of the heights.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightLoads {
    /// Decay length u_0 \[m\].
    pub decay_length_m: f64,
    /// Reference pressure p_00 \[Pa\].
    pub reference_pressure_pa: f64,
    /// Share of u_0 that comes from the first decade of wavevectors, in (0, 1\]. If it is large and the spectrum has
    /// no roll-off there, the unmeasured waves below the first wavevector decide u_0.
    pub share_of_first_decade: f64,
    /// True if separations have the tail of the heights, which this limit leaves out.
    pub has_tail: bool,
}

/// The share of u_0 that the first decade of wavevectors may have if the spectrum has no roll-off.
const MOST_OF_FIRST_DECADE: f64 = 0.3;

/// From this exponent of dV/dq = q^(e-1) on, C1D falls more slowly than q^-0.5: a roll-off.
const FLAT: f64 = 2.5;

impl LightLoads {
    /// Returns the pressure \[Pa\] under which the mean gap is so many rms heights \[m\], with the tail where separations have it.
    #[must_use]
    pub fn pressure_at_gap_pa(&self, rms_heights: f64, rms_height_m: f64) -> f64 {
        let beyond = if self.has_tail { (rms_heights - TAIL_START).max(0.0) } else { 0.0 };
        let decays = rms_heights * rms_height_m / self.decay_length_m + 0.5 * beyond * beyond;
        self.reference_pressure_pa * libm::exp(-decays)
    }

    /// Returns true if the waves that a spectrum begins with decide gap and stiffness, and do not roll off: longer waves, which were not
    /// measured, would change both.
    #[must_use]
    pub fn lacks_roll_off(&self, roughness: &Roughness) -> bool {
        let places = roughness.places();
        let decade = places.first().map_or(0.0, |place| 10.0 * place.wavevector_rad_per_m);
        let mut in_decade = places.iter().take_while(|place| place.wavevector_rad_per_m < decade);
        self.share_of_first_decade > MOST_OF_FIRST_DECADE
            && !in_decade.any(|place| place.variance_exponent > FLAT)
    }
}

/// Separation for one elastic energy factor g and one spectrum, whose knots have rising wavevector and variance.
#[derive(Debug, Clone)]
pub struct SeparationLaw {
    energy: Arc<ContactEnergy>,
    contact_modulus_pa: f64,
    stretches: Vec<Option<Stretch>>,
    layer: Option<LayerCompliance>,
    /// Tails of the heights up to each knot; none with the waves of profiles.
    tails: Vec<Tail>,
}

/// Gaussian tail of the heights up to a cutoff.
#[derive(Debug, Clone, Copy, Default)]
struct Tail {
    decay_length_m: f64,
    mean_square_height_m2: f64,
}

impl Tail {
    /// Returns the separation with the tail. The gap u of the theory is that with the tail, u', plus u_0 (u' - u_1)^2/2 sigma^2.
    fn of(&self, theory: Separation) -> Separation {
        let start_m = TAIL_START * self.mean_square_height_m2.sqrt();
        let beyond_m = theory.mean_gap_m - start_m;
        let growth = 2.0 * self.decay_length_m * beyond_m / self.mean_square_height_m2;
        if beyond_m.is_nan() || beyond_m <= 0.0 || !growth.is_finite() {
            return theory;
        }
        let factor = (1.0 + growth).sqrt();
        Separation {
            mean_gap_m: start_m + 2.0 * beyond_m / (1.0 + factor),
            stiffness_pa_per_m: factor * theory.stiffness_pa_per_m,
        }
    }
}

static RULE: LazyLock<GaussLegendre> = LazyLock::new(|| GaussLegendre::new(16));

impl SeparationLaw {
    /// Creates the law of a roughness, on a layer or on half-spaces, under a contact modulus E* > 0 \[Pa\]. With the waves of the
    /// surface it has the tail of their heights.
    #[must_use]
    pub fn from_roughness(
        roughness: &Roughness,
        contact_modulus_pa: f64,
        energy_factor: EnergyFactor,
    ) -> Self {
        let knots = SeparationKnot::along(roughness, contact_modulus_pa);
        let law = Self::new(&knots, contact_modulus_pa, energy_factor);
        let law = SeparationLaw { layer: roughness.layer, ..law };
        let tails = if roughness.is_of_surface { law.tails() } else { Vec::new() };
        SeparationLaw { tails, ..law }
    }

    /// Creates the law of half-spaces under a contact modulus E* > 0 \[Pa\].
    #[must_use]
    pub fn new(knots: &[SeparationKnot], contact_modulus_pa: f64, energy_factor: EnergyFactor) -> Self {
        let stretches = knots.windows(2).map(|pair| Stretch::between(&pair[0], &pair[1])).collect();
        SeparationLaw {
            energy: ContactEnergy::of(energy_factor),
            contact_modulus_pa,
            stretches,
            layer: None,
            tails: Vec::new(),
        }
    }

    /// Computes the tails of the heights up to each knot.
    fn tails(&self) -> Vec<Tail> {
        let light = self.energy.light() * self.factor();
        let per_square_pa2 = (2.0 / self.contact_modulus_pa).powi(2);
        let mut tail = Tail::default();
        let mut tails = vec![tail];
        tails.extend(self.stretches.iter().map(|stretch| {
            self.over(stretch, 0.0, |v_pa, stiffness_rad_per_m, weight| {
                tail.decay_length_m += light * (weight / stiffness_rad_per_m);
                tail.mean_square_height_m2 += per_square_pa2 * v_pa * (weight / stiffness_rad_per_m.powi(2));
            });
            tail
        }));
        tails
    }

    /// Returns q E*(q)/E* \[rad/m\].
    fn stiffness(&self, wavevector_rad_per_m: f64) -> f64 {
        wavevector_rad_per_m / self.layer.map_or(1.0, |layer| layer.relative_at(wavevector_rad_per_m))
    }

    /// Separation and stiffness under a nominal pressure p > 0 \[Pa\] with the spectrum cut off at each knot; 0 and
    /// infinite at the first.
    #[must_use]
    pub fn along(&self, pressure_pa: f64) -> Vec<Separation> {
        let (mut gap, mut compliance) = (0.0, 0.0);
        let mut all = vec![self.separation_from_sums(pressure_pa, gap, compliance)];
        all.extend(self.stretches.iter().map(|stretch| {
            self.add(stretch, pressure_pa, &mut gap, &mut compliance);
            self.separation_from_sums(pressure_pa, gap, compliance)
        }));
        all.iter_mut().zip(&self.tails).for_each(|(theory, tail)| *theory = tail.of(*theory));
        all
    }

    /// Adds a stretch to the two integrals.
    fn add(&self, stretch: &Option<Stretch>, pressure_pa: f64, gap: &mut f64, compliance: &mut f64) {
        self.over(stretch, pressure_pa, |v_pa, stiffness_rad_per_m, weight| {
            let (x, per_rad_m) = (pressure_pa / v_pa, weight / stiffness_rad_per_m);
            *gap += per_rad_m * self.energy.beyond(x);
            *compliance += per_rad_m * self.energy.density(x);
        });
    }

    fn separation_from_sums(&self, pressure_pa: f64, gap: f64, compliance: f64) -> Separation {
        let factor = self.factor();
        Separation { mean_gap_m: factor * gap, stiffness_pa_per_m: pressure_pa / (factor * compliance) }
    }

    /// Separation and stiffness under a nominal pressure p > 0 \[Pa\] of the whole spectrum; 0 and infinite without
    /// roughness.
    #[must_use]
    pub fn whole(&self, pressure_pa: f64) -> Separation {
        let theory = self.without_tail(pressure_pa);
        self.tails.last().map_or(theory, |tail| tail.of(theory))
    }

    /// Separation and stiffness of the whole spectrum without the tail of its heights.
    fn without_tail(&self, pressure_pa: f64) -> Separation {
        let (mut gap, mut compliance) = (0.0, 0.0);
        for stretch in &self.stretches {
            self.add(stretch, pressure_pa, &mut gap, &mut compliance);
        }
        self.separation_from_sums(pressure_pa, gap, compliance)
    }

    /// Largest pressure \[Pa\] up to which the limit of light loads gives the pressure of the theory within a relative error
    /// `share`, both without the tail of the heights. `None` without roughness.
    #[must_use]
    pub fn light_load_limit_pa(&self, share: f64) -> Option<f64> {
        // The limit is approached from below: a millionth of p_00 lies well within, and the steps are finer than it
        // bends.
        const FROM: f64 = 1e-6;
        const STEP: f64 = 1.2;
        let light = self.light_loads()?;
        let excess = |log_pa: f64| {
            let gap_m = self.without_tail(log_pa.exp()).mean_gap_m;
            let log_of_law = light.reference_pressure_pa.ln() - gap_m / light.decay_length_m;
            libm::expm1(log_of_law - log_pa).abs() - share
        };
        let steps = (0..).map(|step| (FROM * light.reference_pressure_pa).ln() + f64::from(step) * STEP.ln());
        let mut within = None;
        // Once the gap has vanished, the limit may be off by any share.
        for log_pa in steps.take_while(|log_pa| *log_pa < (1e3 * light.reference_pressure_pa).ln()) {
            if excess(log_pa) > 0.0 {
                let bracket = |within| zero_in_bracket(within, log_pa, excess);
                return Some(within.map_or(log_pa, bracket).exp());
            }
            within = Some(log_pa);
        }
        within.map(f64::exp)
    }

    /// Limit of light loads of the whole spectrum; `None` without roughness.
    #[must_use]
    pub fn light_loads(&self) -> Option<LightLoads> {
        // The waves of a surface begin later than those of its profiles: the first stretches may be empty.
        let first = self.stretches.iter().flatten().next()?;
        let decade_rad_per_m = 10.0 * first.start_rad_per_m;
        let (mut sum, mut in_first_decade, mut logarithms) = (0.0, 0.0, 0.0);
        for stretch in &self.stretches {
            self.over(stretch, 0.0, |v_pa, stiffness_rad_per_m, weight| {
                let per_rad_m = weight / stiffness_rad_per_m;
                sum += per_rad_m;
                logarithms += per_rad_m * v_pa.ln();
            });
            let inside = stretch.and_then(|stretch| stretch.up_to(decade_rad_per_m));
            self.over(&inside, 0.0, |_, stiffness_rad_per_m, weight| {
                in_first_decade += weight / stiffness_rad_per_m;
            });
        }
        let g = self.energy.light();
        Some(LightLoads {
            decay_length_m: g * self.factor() * sum,
            reference_pressure_pa: (logarithms / sum + self.energy.constant / g).exp(),
            share_of_first_decade: (in_first_decade / sum).min(1.0),
            has_tail: !self.tails.is_empty(),
        })
    }

    /// Returns the law of the waves shorter than those of a wavevector q_z \[rad/m\]: it describes the gap inside the
    /// contact that longer waves leave, whose pressure is p/A(q_z). v^2 = 2 (V(q) - V(q_z)) replaces 2 V(q). It has no tail of heights.
    #[must_use]
    pub fn beyond(&self, wavevector_rad_per_m: f64) -> Self {
        let left_out_pa2 = self.variance_pa2(wavevector_rad_per_m);
        let stretches = self.stretches.iter().flatten();
        let rest = stretches.filter_map(|stretch| stretch.beyond(wavevector_rad_per_m, left_out_pa2));
        SeparationLaw { stretches: rest.map(Some).collect(), tails: Vec::new(), ..self.clone() }
    }

    /// Returns the waves in bands, so many per decade, from long to short; none on a layer.
    pub(crate) fn waves(&self, per_decade: f64) -> Vec<Wave> {
        let stretches = self.stretches.iter().flatten().filter(|_| self.layer.is_none());
        let first_rad_per_m = stretches.clone().next().map_or(1.0, |first| first.start_rad_per_m);
        let per_square_pa2 = (2.0 / self.contact_modulus_pa).powi(2);
        let mut bands: Vec<(usize, Wave)> = Vec::new();
        for stretch in stretches {
            let decades = (stretch.end_rad_per_m / stretch.start_rad_per_m).log10();
            let count = (per_decade * decades).ceil().max(1.0);
            let wavevector = |at: u32| stretch.start_rad_per_m * 10f64.powf(decades * f64::from(at) / count);
            for at in 0..count as u32 {
                let ends = [at, at + 1].map(wavevector);
                let q = (ends[0] * ends[1]).sqrt();
                let [below, above] = ends.map(|q| stretch.variance_pa2(q));
                let mean_square_height_m2 = per_square_pa2 * (above - below) / (q * q);
                let band = (per_decade * (q / first_rad_per_m).log10()) as usize;
                match bands.last_mut() {
                    Some((last, wave)) if *last == band => {
                        let sum_m2 = wave.mean_square_height_m2 + mean_square_height_m2;
                        let share = mean_square_height_m2 / sum_m2;
                        wave.wavevector_rad_per_m *= (q / wave.wavevector_rad_per_m).powf(share);
                        wave.mean_square_height_m2 = sum_m2;
                    }
                    _ => bands.push((band, Wave { wavevector_rad_per_m: q, mean_square_height_m2 })),
                }
            }
        }
        // Within a band heights count with its middle; together they are those of the spectrum.
        let sum_m2: f64 = bands.iter().map(|(_, wave)| wave.mean_square_height_m2).sum();
        let factor = self.tails().last().map_or(1.0, |all| all.mean_square_height_m2 / sum_m2);
        bands.iter_mut().for_each(|(_, wave)| wave.mean_square_height_m2 *= factor);
        bands.into_iter().map(|(_, wave)| wave).filter(|wave| wave.mean_square_height_m2 > 0.0).collect()
    }

    /// Mean square height of all waves \[m^2\], Int 4 dV/(q E*(q))^2.
    pub(crate) fn mean_square_height_m2(&self) -> f64 {
        self.tails().last().map_or(0.0, |tail| tail.mean_square_height_m2)
    }

    /// Variance V up to a wavevector \[Pa^2\]; outside of the spectrum that of its nearest end.
    pub(crate) fn variance_pa2(&self, wavevector_rad_per_m: f64) -> f64 {
        match self.stretch_begun_at(wavevector_rad_per_m) {
            Some(stretch) if wavevector_rad_per_m < stretch.end_rad_per_m => {
                stretch.variance_pa2(wavevector_rad_per_m)
            }
            Some(stretch) => stretch.end_pa2,
            None => self.stretches.iter().flatten().next().map_or(0.0, |first| first.start_pa2),
        }
    }

    /// Derivative dV/dln(q) at a wavevector \[Pa^2\], from below where it jumps; `None` where nothing is added.
    pub(crate) fn variance_per_ln_wavevector_pa2(&self, wavevector_rad_per_m: f64) -> Option<f64> {
        let within = |stretch: &&Stretch| {
            stretch.start_rad_per_m < wavevector_rad_per_m && wavevector_rad_per_m <= stretch.end_rad_per_m
        };
        let stretch = self.stretches.iter().flatten().find(within)?;
        Some(stretch.variance_per_ln_wavevector_pa2(wavevector_rad_per_m))
    }

    fn stretch_begun_at(&self, wavevector_rad_per_m: f64) -> Option<&Stretch> {
        let begun = |stretch: &&Stretch| stretch.start_rad_per_m <= wavevector_rad_per_m;
        self.stretches.iter().flatten().rfind(begun)
    }

    /// Derivative of the gap under a constant pressure p > 0 \[Pa\] by the variance left out at the long end
    /// \[m/Pa^2\].
    ///
    /// With W = V - V_z, du/dV_z = (2/(sqrt(pi) E*)) Int_0^v1 G(p/v) (d/dW)(1/q) dv less the loss at the end v1. By
    /// parts that is (2/(sqrt(pi) E*)) Int_0^v1 \[G(x) - D(x)\]/v^2 dv/q with x = p/v and D = -x G', in which the
    /// loss at the end has cancelled and no derivative of the spectrum appears.
    pub(crate) fn gap_per_variance_left_out_m_per_pa2(&self, pressure_pa: f64) -> f64 {
        let mut sum = 0.0;
        for stretch in &self.stretches {
            self.over(stretch, pressure_pa, |v_pa, stiffness_rad_per_m, weight| {
                let (x, per_rad_m) = (pressure_pa / v_pa, weight / stiffness_rad_per_m);
                sum += per_rad_m * (self.energy.beyond(x) - self.energy.density(x)) / (v_pa * v_pa);
            });
        }
        self.factor() * sum
    }

    /// Contact modulus E* \[Pa\].
    pub(crate) fn contact_modulus_pa(&self) -> f64 {
        self.contact_modulus_pa
    }

    /// Factor 2/(sqrt(pi) E*) of both integrals.
    fn factor(&self) -> f64 {
        2.0 / (PI.sqrt() * self.contact_modulus_pa)
    }

    /// Calls `term` with v, the stiffness q E*(q)/E* and the weight of dv over a stretch, for terms that fall like exp(-x^2) with
    /// x = p/v; without a load p = 0. v and the wavevector grow by at most `MOST_GROWTH` on a piece, dV/dln(q) by at most
    /// `MOST_CHANGE` or its inverse, and x^2 by at most `MOST_FALL`; pieces end at x^2 = `SMALLEST` or `NEGLIGIBLE` beyond that of
    /// the end.
    fn over(&self, stretch: &Option<Stretch>, pressure_pa: f64, mut term: impl FnMut(f64, f64, f64)) {
        const MOST_GROWTH: f64 = 1.6;
        const MOST_CHANGE: f64 = 8.0;
        const MOST_FALL: f64 = 24.0;
        const NEGLIGIBLE: f64 = 44.0;
        const SMALLEST: f64 = 27.0 * 27.0;
        let Some(stretch) = stretch else { return };
        let square_at = |v_pa: f64| (pressure_pa / v_pa).powi(2);
        let last_pa = (2.0 * stretch.end_pa2).sqrt();
        let most = SMALLEST.min(square_at(last_pa) + NEGLIGIBLE);
        let first_pa = (2.0 * stretch.start_pa2).sqrt().max(pressure_pa / most.sqrt()).max(1e-18 * last_pa);
        let growth = stretch.growth_with_slope(MOST_CHANGE).min(MOST_GROWTH);
        let mut end_pa = last_pa;
        while end_pa > first_pa {
            let mut slower_rad_per_m = stretch.wavevector_rad_per_m(end_pa) / growth;
            let fallen_pa = pressure_pa / (square_at(end_pa) + MOST_FALL).sqrt();
            let least_pa = first_pa.max(end_pa / MOST_GROWTH).max(fallen_pa);
            let start = |slower_rad_per_m| least_pa.max(stretch.v_pa(slower_rad_per_m));
            let mut start_pa = start(slower_rad_per_m);
            // If a spectrum falls by powers of ten within a stretch, v stays constant to rounding over much of it.
            while start_pa >= end_pa && slower_rad_per_m > stretch.start_rad_per_m {
                slower_rad_per_m /= growth;
                start_pa = start(slower_rad_per_m);
            }
            if start_pa >= end_pa {
                break;
            }
            for (v_pa, weight) in RULE.over(start_pa, end_pa) {
                term(v_pa, self.stiffness(stretch.wavevector_rad_per_m(v_pa)), weight);
            }
            end_pa = start_pa;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// C1D ~ q^-2.6 over two decades of wavevectors: V ~ q^0.4 for the exponents of the theory.
    fn power_law() -> SeparationLaw {
        let knots: Vec<SeparationKnot> = (0..=20)
            .map(|at| {
                let q = 1e4 * 10f64.powf(f64::from(at) / 10.0);
                let variance_pa2 = 1e16 * ((q / 1e4).powf(0.4) - 1.0);
                SeparationKnot { wavevector_rad_per_m: q, variance_pa2, variance_exponent: 0.4 }
            })
            .collect();
        SeparationLaw::new(&knots, 1e11, EnergyFactor::ALMQVIST)
    }

    #[test]
    fn the_whole_spectrum_is_the_last_of_its_cutoffs() {
        let law = power_law();
        for pressure_pa in [1e3, 1e7, 3e8] {
            assert_eq!(law.along(pressure_pa).last(), Some(&law.whole(pressure_pa)));
        }
    }

    #[test]
    fn the_fitted_energy_keeps_gaps_open_under_heavy_loads_and_its_stiffness_is_their_slope() {
        let almqvist = power_law();
        let fitted = SeparationLaw { energy: ContactEnergy::of(EnergyFactor::FITTED), ..almqvist.clone() };
        for pressure_pa in [1e3, 1e6, 3e7, 3e8] {
            let [below, above] =
                [1.0 - 1e-4, 1.0 + 1e-4].map(|factor| fitted.whole(factor * pressure_pa).mean_gap_m);
            let slope = 2e-4 * pressure_pa / (below - above);
            let found = fitted.whole(pressure_pa);
            assert!((found.stiffness_pa_per_m / slope - 1.0).abs() < 1e-6, "{found:?} {slope}");
        }
        let [light, usual] = [&fitted, &almqvist].map(|law| law.light_loads().unwrap());
        assert_eq!(light.decay_length_m, usual.decay_length_m);
        let gaps = [&fitted, &almqvist].map(|law| law.whole(3e8).mean_gap_m);
        assert!(gaps[0] > gaps[1], "{gaps:?}");
    }

    /// Asserts that the law of two knots, ln(q) apart, is that of finer ones between which V(ln q) has an exponent.
    fn assert_as_with_finer_knots(
        whole_ln: f64,
        exponent: f64,
        variance_pa2: impl Fn(f64) -> f64,
        pressures_pa: [f64; 4],
        tolerance: f64,
    ) {
        let law = |knots: i32| {
            let knot = |at: i32| {
                let ln_q = whole_ln * f64::from(at) / f64::from(knots);
                SeparationKnot {
                    wavevector_rad_per_m: 1e4 * ln_q.exp(),
                    variance_pa2: variance_pa2(ln_q),
                    variance_exponent: exponent,
                }
            };
            SeparationLaw::new(&(0..=knots).map(knot).collect::<Vec<_>>(), 1e11, EnergyFactor::FITTED)
        };
        let (coarse, fine) = (law(1), law(400));
        for pressure_pa in pressures_pa {
            let [found, known] = [&coarse, &fine].map(|law| law.whole(pressure_pa));
            let gap = found.mean_gap_m / known.mean_gap_m - 1.0;
            let stiffness = found.stiffness_pa_per_m / known.stiffness_pa_per_m - 1.0;
            let off = gap.abs().max(stiffness.abs());
            assert!(off < tolerance, "{exponent} {pressure_pa}: {gap:e} {stiffness:e}");
        }
    }

    /// One rule over all of exp(-310) to exp(-790) was off by 1e-3.
    #[test]
    fn the_gap_under_a_load_of_many_times_the_spread_is_that_of_finer_knots() {
        let variance_pa2 = |ln_q: f64| 1e16 * libm::expm1(3.0 * ln_q);
        let spread_pa = (2.0 * variance_pa2(1.5)).sqrt();
        let pressures_pa = [0.1, 1.0, 4.0, 18.0].map(|times| times * spread_pa);
        assert_as_with_finer_knots(1.5, 3.0, variance_pa2, pressures_pa, 1e-10);
    }

    /// One rule over a stretch at whose end the variance hardly grows, or at whose beginning it has hardly begun to, was off by 1e-5.
    #[test]
    fn the_gap_of_a_spectrum_that_falls_or_rises_steeply_is_that_of_finer_knots() {
        for exponent in [-12.0, -6.0, 6.0, 12.0f64] {
            let share = |ln_q: f64| libm::expm1(exponent * ln_q) / libm::expm1(0.5 * exponent);
            let variance_pa2 = |ln_q: f64| 1e16 * (1.0 + share(ln_q));
            assert_as_with_finer_knots(0.5, exponent, variance_pa2, [2e7, 2e8, 8e8, 16e8], 1e-9);
        }
    }

    #[test]
    fn light_loads_are_accurate_up_to_their_limit() {
        let law = power_law();
        let light = law.light_loads().unwrap();
        let off = |pressure_pa: f64| {
            let gap_m = law.whole(pressure_pa).mean_gap_m;
            light.reference_pressure_pa * (-gap_m / light.decay_length_m).exp() / pressure_pa - 1.0
        };
        for share in [1e-3, 0.01, 0.1] {
            let most_pa = law.light_load_limit_pa(share).unwrap();
            assert!((off(most_pa).abs() / share - 1.0).abs() < 1e-3, "{share}: {}", off(most_pa));
            assert!((0..40).all(|step| off(most_pa * 0.8f64.powi(step)).abs() <= share * (1.0 + 1e-3)));
        }
        let flat = SeparationLaw::new(&[], 1e11, EnergyFactor::ALMQVIST);
        assert_eq!(flat.light_load_limit_pa(0.01), None);
    }

    #[test]
    fn a_spectrum_that_falls_by_powers_of_ten_has_an_end() {
        // Between neighbouring samples all of the variance is at the beginning, or all at the end.
        for exponent in [-90.0, -900.0, 90.0] {
            let knot = |wavevector_rad_per_m, variance_pa2| SeparationKnot {
                wavevector_rad_per_m,
                variance_pa2,
                variance_exponent: exponent,
            };
            let knots = [knot(1e6, 0.0), knot(1.26e6, 1e18), knot(1.6e6, 1e18 + 1e5), knot(2e6, 2e18)];
            let law = SeparationLaw::new(&knots, 1e11, EnergyFactor::ALMQVIST);
            let found = law.along(1e7);
            assert!(found.iter().all(|cut| cut.mean_gap_m.is_finite()), "{found:?}");
            assert!(found.windows(2).all(|pair| pair[1].mean_gap_m >= pair[0].mean_gap_m));
            assert!(law.light_loads().is_some_and(|loads| loads.decay_length_m.is_finite()));
        }
    }

    /// With the tail p falls like exp(-(u - u1)/u0 - (u - u1)^2/2 sigma^2), and K is its slope.
    #[test]
    fn the_tail_of_the_heights_ends_the_gap_and_keeps_its_slope() {
        let plain = power_law();
        let law = SeparationLaw { tails: plain.tails(), ..plain.clone() };
        let light = plain.light_loads().unwrap();
        let tail = law.tails.last().unwrap();
        assert!((tail.decay_length_m / light.decay_length_m - 1.0).abs() < 1e-12);
        // V ~ q^0.4 has the heights 4 Int dV/(E* q)^2.
        let heights = 4.0 * 1e16 / 1e22 * (0.4 / 1.6) / 1e8 * (1.0 - 100f64.powf(-1.6));
        assert!((tail.mean_square_height_m2 / heights - 1.0).abs() < 1e-9, "{tail:?} {heights}");
        for law in [&plain, &law] {
            let pressure_pa = law.light_loads().unwrap().pressure_at_gap_pa(3.0, heights.sqrt());
            let rms_heights = law.whole(pressure_pa).mean_gap_m / heights.sqrt();
            assert!((rms_heights / 3.0 - 1.0).abs() < 0.02, "{rms_heights}");
        }
        let start_m = TAIL_START * heights.sqrt();
        for pressure_pa in [1e-3, 1.0, 1e4, 1e6] {
            let [theory, found] = [&plain, &law].map(|law| law.whole(pressure_pa));
            let beyond_m = found.mean_gap_m - start_m;
            let lost = light.decay_length_m * beyond_m * beyond_m / (2.0 * heights);
            assert!(
                ((found.mean_gap_m + lost) / theory.mean_gap_m - 1.0).abs() < 1e-12,
                "{found:?} {theory:?}"
            );
            let gap_m = |factor: f64| law.whole(factor * pressure_pa).mean_gap_m;
            let slope = 2e-4 * pressure_pa / (gap_m(1.0 - 1e-4) - gap_m(1.0 + 1e-4));
            assert!((found.stiffness_pa_per_m / slope - 1.0).abs() < 1e-6, "{found:?} {slope}");
            assert_eq!(law.along(pressure_pa).last(), Some(&found));
        }
        // Under heavy loads the theory stays as it is.
        assert_eq!(law.whole(1e8), plain.whole(1e8));
    }
}
