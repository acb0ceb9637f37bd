//! The quantities of an interface, from the roughness, the bodies and the loads.

mod sealing;
mod separation;

use std::sync::{Arc, OnceLock};

use ::interface::OutOfBounds;
use ::interface::conductance::{CutSurface, PlasticCorrelation, PressureRatio, RelativeStiffness, Spot};
use ::interface::friction::SlidingContact;
use ::interface::gas::plastic_separation_m;
use ::interface::tangential::{ShearedContact, ShearedPair};
use asperity::MaterialPair;
use persson::Band;
use persson::corrections::Correction;
use persson::sealing::{MagnifiedContact, SealingLaw};
use persson::separation::{LIGHT_CONTACT, LightLoads, STIFFNESS_WITHIN, Separation, SeparationLaw};
use persson::yielding::{SpotFactor, YieldedSeparation, YieldingLaw};
use persson::{Roughness, SealConductance, SealFlow};
use spectrum::{Moments, Normalisation};

use super::flat::FlatnessAdds;
use super::quantity::{Quantity, Slot};
use super::request::InterfaceRequest;
use super::shear::sheared_pair;
use crate::figure::ShearLoop;
use crate::gap_law;
use crate::plan::{NominalPressure, Results};

/// A value out of bounds for a quantity.
pub type InterfaceError = OutOfBounds;

/// The inputs of an interface: results of a plan, bodies and loads.
#[derive(Debug, Clone)]
pub struct InterfaceInputs<'r> {
    /// The results of a plan that has moments.
    pub results: &'r Results,
    /// The normalisation of these moments.
    pub normalisation: Normalisation,
    /// The bodies in contact.
    pub pair: MaterialPair,
    /// The hardness of the softer body \[Pa\], if it yields.
    pub hardness_pa: Option<f64>,
    /// True if the hardness grows at small scales: gap and stiffness are then those of elastic peaks.
    pub hardness_grows: bool,
    /// The nominal pressures.
    pub pressures: Vec<NominalPressure>,
}

/// The requested quantities of an interface, computed when they are read.
#[derive(Debug)]
pub struct InterfaceStates<'a> {
    /// The requested quantities.
    pub request: &'a InterfaceRequest,
    /// The inputs.
    pub inputs: InterfaceInputs<'a>,
    elastic: Arc<ElasticStates>,
    /// The separation of bodies that yield under every load, once it is read; `None` where everything touches and flows.
    yielded: Vec<OnceLock<Option<YieldedSeparation>>>,
    /// The conductance of the seal under every load, once it is read.
    conductances: Vec<OnceLock<Option<SealConductance>>>,
    /// Factors of spots that have flowed under every load; those of the best inputs are those of their draws.
    spots: Vec<SpotFactor>,
}

/// The part that does not depend on the hardness.
#[derive(Debug)]
struct ElasticStates {
    /// The moments of the whole spectrum, by Parseval's theorem.
    moments: Moments,
    roughness: Roughness,
    separation: SeparationLaw,
    /// The separation under every load, once it is read.
    separations: Vec<OnceLock<Separation>>,
    /// The law of peaks that flow, once it is read.
    yielding: OnceLock<YieldingLaw>,
    sealing: Option<SealingLaw>,
    /// The response to the tangential load under every load, once it is read; `None` where everything slides.
    sheared: Vec<OnceLock<Option<ShearedContact>>>,
    constrictions: Vec<OnceLock<Option<MagnifiedContact>>>,
    /// Flow factors of the seal; draws of a spectrum share them.
    flow: Option<Arc<SealFlow>>,
    /// States with the deviation of the nominal contact from a plane as a wave, if one is given.
    with_wave: Option<Arc<ElasticStates>>,
    /// The additions of both limits of that deviation under every load, once they are read.
    flatness: Vec<OnceLock<[FlatnessAdds; 2]>>,
}

/// The corrected form of the theory that is nearest to boundary elements.
const CORRECTION_OF_SEALS: Correction = Correction::AlgebraicNayak;

impl<'a> InterfaceStates<'a> {
    /// The requested quantities; `None` if the spectrum of the results has no moments.
    #[must_use]
    pub fn new(request: &'a InterfaceRequest, inputs: InterfaceInputs<'a>) -> Option<Self> {
        let spots = vec![SpotFactor::new(); inputs.pressures.len()];
        Self::from_inputs(request, inputs, None, spots)
    }

    /// Returns the quantities of other inputs that differ little, such as draws of them: factors of flow and of spots are shared.
    #[must_use]
    pub fn drawn(&self, inputs: InterfaceInputs<'a>) -> Option<Self> {
        Self::from_inputs(self.request, inputs, self.elastic.flow.clone(), self.known_spots())
    }

    fn from_inputs(
        request: &'a InterfaceRequest,
        inputs: InterfaceInputs<'a>,
        flow: Option<Arc<SealFlow>>,
        spots: Vec<SpotFactor>,
    ) -> Option<Self> {
        let results = inputs.results;
        let (last, _) = results.moments.last()?;
        let moments = by_parseval(last, inputs.normalisation);
        let roughness = gap_law::roughness(results, inputs.normalisation, request.band);
        let with_wave = request.flatness.and_then(|flatness| {
            let mean_square_m2 = flatness.mean_square_height_m2();
            let roughness = roughness.with_long_wave(flatness.wavelength_m(), mean_square_m2)?;
            let moments = Moments { m0_m2: moments.m0_m2 + mean_square_m2, ..moments };
            Some(Arc::new(ElasticStates::new(request, &inputs, roughness, moments)))
        });
        let mut elastic =
            ElasticStates { with_wave, ..ElasticStates::new(request, &inputs, roughness, moments) };
        elastic.flow = flow.or(elastic.flow);
        Some(Self::from_parts(request, inputs, Arc::new(elastic), spots))
    }

    fn from_parts(
        request: &'a InterfaceRequest,
        inputs: InterfaceInputs<'a>,
        elastic: Arc<ElasticStates>,
        spots: Vec<SpotFactor>,
    ) -> Self {
        let loads = inputs.pressures.len();
        InterfaceStates {
            request,
            inputs,
            elastic,
            yielded: vec![OnceLock::new(); loads],
            conductances: vec![OnceLock::new(); loads],
            spots,
        }
    }

    /// Returns the states with the deviation from flat faces as a wave of the roughness; `None` without one.
    #[must_use]
    pub fn with_wave(&self) -> Option<Self> {
        let elastic = Arc::clone(self.elastic.with_wave.as_ref()?);
        let spots = vec![SpotFactor::new(); self.inputs.pressures.len()];
        Some(Self::from_parts(self.request, self.inputs.clone(), elastic, spots))
    }

    /// Returns what both limits of the flatness add under a load, as a wave and as a cap; `None` without a flatness.
    #[must_use]
    pub fn flatness_limits(&self, load: usize) -> Option<[FlatnessAdds; 2]> {
        let (flatness, with_wave) = self.request.flatness.zip(self.elastic.with_wave.as_ref())?;
        let (pressure_pa, modulus_pa) = (self.pressure_pa(load), self.modulus_pa());
        let compare = || {
            let flat = self.elastic_separation(load);
            let ridge = flatness.ridge(pressure_pa, modulus_pa);
            let cap = flatness.cap(pressure_pa, modulus_pa);
            [
                FlatnessAdds::of_wave(
                    &with_wave.separation,
                    &self.elastic.separation,
                    flat,
                    &ridge,
                    pressure_pa,
                ),
                FlatnessAdds::of(&cap, &self.elastic.separation, flat),
            ]
        };
        Some(*self.elastic.flatness[load].get_or_init(compare))
    }

    /// Takes another hardness of the softer body \[Pa\], and shares all else.
    #[must_use]
    pub fn with_hardness(&self, hardness_pa: Option<f64>) -> Self {
        let inputs = InterfaceInputs { hardness_pa, ..self.inputs.clone() };
        Self::from_parts(self.request, inputs, Arc::clone(&self.elastic), self.known_spots())
    }

    /// Takes a hardness that does not grow at small scales, and shares all else.
    #[must_use]
    pub fn at_constant_hardness(&self) -> Self {
        let inputs = InterfaceInputs { hardness_grows: false, ..self.inputs.clone() };
        let spots = vec![SpotFactor::new(); inputs.pressures.len()];
        Self::from_parts(self.request, inputs, Arc::clone(&self.elastic), spots)
    }

    /// The spectrum as the theory takes it.
    #[must_use]
    pub fn roughness(&self) -> &Roughness {
        &self.elastic.roughness
    }

    /// All requested slots.
    #[must_use]
    pub fn slots(&self) -> Vec<Slot> {
        let curves = self.inputs.results.curves.len();
        self.request.slots(self.inputs.pressures.len(), curves, self.inputs.hardness_pa.is_some())
    }

    /// The value of a slot; `None` if there is none, as for a channel in a tight seal or friction without an area.
    ///
    /// # Errors
    /// [`InterfaceError`] for what leaves the range of magnitudes.
    pub fn value(&self, slot: Slot) -> Result<Option<f64>, InterfaceError> {
        match slot.load {
            None => self.of_all_loads(slot.quantity),
            Some(load) => self.under(load, slot),
        }
    }

    /// The friction under a load for a given area fraction.
    ///
    /// # Errors
    /// The errors of [`value`](Self::value).
    pub fn friction(
        &self,
        quantity: Quantity,
        load: usize,
        area_fraction: f64,
    ) -> Result<Option<f64>, InterfaceError> {
        let Some(shear_strength_pa) = self.request.shear_strength_pa else { return Ok(None) };
        let sliding = SlidingContact::new(shear_strength_pa, area_fraction, self.pressure_pa(load))?;
        Ok(match quantity {
            Quantity::FrictionStress => Some(sliding.friction_stress_pa()),
            Quantity::FrictionCoefficient => Some(sliding.friction_coefficient()),
            _ => None,
        })
    }

    /// The asymptotic law of light loads.
    #[must_use]
    pub fn light_loads(&self) -> Option<LightLoads> {
        self.elastic.separation.light_loads()
    }

    /// Returns true if longer waves than the spectrum has would change gap and stiffness.
    #[must_use]
    pub fn lacks_roll_off(&self) -> bool {
        self.light_loads().is_some_and(|light| light.lacks_roll_off(&self.elastic.roughness))
    }

    /// The rms height \[m\] of the whole spectrum.
    #[must_use]
    pub fn rms_height_m(&self) -> f64 {
        self.elastic.moments.rms_height_m()
    }

    /// The mean absolute slope of profiles, sqrt(2/pi) of the rms slope, at the shortest wavelength.
    ///
    /// # Errors
    /// [`InterfaceError`] for what leaves the range of magnitudes.
    pub fn mean_absolute_slope(&self) -> Result<f64, InterfaceError> {
        Ok(self.surface()?.mean_absolute_slope())
    }

    /// The largest factor between the stiffness under a load and the true one, either way, where little touches; 1 elsewhere, and with
    /// the waves of profiles, whose error a note states.
    #[must_use]
    pub fn light_contact_factor(&self, load: usize) -> f64 {
        let Some(area_fraction) = self.elastic_area_fraction(self.pressure_pa(load)) else { return 1.0 };
        match self.request.band {
            Band::Surface if area_fraction < LIGHT_CONTACT => STIFFNESS_WITHIN,
            _ => 1.0,
        }
    }

    /// P/H under a load, with the range of the correlations for flowed peaks; `None` without a hardness.
    ///
    /// # Errors
    /// [`InterfaceError`] for what leaves the range of magnitudes.
    pub fn pressure_ratio(&self, load: usize) -> Result<Option<PressureRatio>, InterfaceError> {
        let of = |hardness_pa| PressureRatio::new(self.pressure_pa(load), hardness_pa);
        self.inputs.hardness_pa.map(of).transpose()
    }

    /// Returns the loads \[index\] under which the tangential load reaches friction times pressure, so that everything slides.
    #[must_use]
    pub fn sliding_loads(&self) -> Vec<usize> {
        let is_asked = self.request.shear.is_some();
        (0..self.inputs.pressures.len())
            .filter(|load| is_asked && self.sticking_share(*load).is_none())
            .collect()
    }

    /// Returns Dundurs' beta of the bodies, which the response to a tangential load neglects; `None` without such a load.
    #[must_use]
    pub fn coupling(&self) -> Option<f64> {
        self.sheared_pair().ok().flatten().map(|pair| pair.mismatch())
    }

    /// Follows the tangential load through a cycle under a load, in some steps; `None` without a tangential load, and where
    /// everything slides.
    #[must_use]
    pub fn shear_loop(&self, load: usize, label: &str, steps: usize) -> Option<ShearLoop> {
        let (pair, share) = (self.sheared_pair().ok().flatten()?, self.sticking_share(load)?);
        let stiffness = |pressure_pa| self.finite_stiffness_pa_per_m(pressure_pa).ok_or(());
        ShearLoop::new(&pair, label, self.pressure_pa(load), share, steps, stiffness).ok()
    }

    fn of_all_loads(&self, quantity: Quantity) -> Result<Option<f64>, InterfaceError> {
        match (quantity, &self.request.adhesion) {
            (Quantity::TightPressure, _) => Ok(self.tight_pressure_pa()),
            (Quantity::FullerTabor, Some(adhesion)) => {
                adhesion.fuller_tabor(&self.elastic.moments, self.modulus_pa())
            }
            (Quantity::PastewkaRobbins, Some(adhesion)) => {
                adhesion.pastewka_robbins(&self.elastic.moments, self.modulus_pa())
            }
            _ => Ok(None),
        }
    }

    fn under(&self, load: usize, slot: Slot) -> Result<Option<f64>, InterfaceError> {
        match slot.quantity {
            Quantity::MeanGap => {
                Ok(self.separation(load).map(|found| found.gap.mean_gap_m).filter(|gap_m| *gap_m > 0.0))
            }
            Quantity::Stiffness => Ok(self.stiffness_pa_per_m(load)),
            Quantity::ThermalConductance | Quantity::ThermalResistance => self.heat(load, slot.quantity),
            Quantity::YovanovichConductance => self.flowed(load, PlasticCorrelation::Yovanovich),
            Quantity::CooperMikicYovanovichConductance => {
                self.flowed(load, PlasticCorrelation::CooperMikicYovanovich)
            }
            Quantity::YovanovichGap => Ok(self.flowed_gap_m(load)?.filter(|gap_m| *gap_m > 0.0)),
            Quantity::YovanovichConductanceWithGas => {
                let of_spots = self.flowed(load, PlasticCorrelation::Yovanovich)?;
                // Where everything touches no gap is left.
                let of_gas = self.flowed_gap_m(load)?.and_then(|gap_m| self.gas_over(gap_m));
                Ok(of_spots.map(|of_spots| of_spots + of_gas.unwrap_or(0.0)))
            }
            Quantity::YovanovichElectricalConductance => self.flowed_current(load),
            Quantity::GasConductance => Ok(self.gas(load)),
            Quantity::ThermalConductanceWithGas => {
                let of_spots = self.heat(load, Quantity::ThermalConductance)?;
                Ok(of_spots.zip(self.gas(load)).map(|(of_spots, of_gas)| of_spots + of_gas))
            }
            Quantity::ElectricalConductance | Quantity::ElectricalResistance => {
                self.current(load, slot.quantity)
            }
            Quantity::ChannelWavelength => Ok(self.constriction(load).map(|seen| seen.wavelength_m())),
            Quantity::ChannelHeight => Ok(self.constriction(load).and_then(|seen| seen.opening_gap_m)),
            Quantity::LeakRateLow => Ok(self.leak(load).map(|rate| rate.low_m3_per_s)),
            Quantity::LeakRateHigh => Ok(self.leak(load).map(|rate| rate.high_m3_per_s)),
            Quantity::LeakGap => Ok(self.seal_conductance(load).map(|gaps| gaps.medium_m3.cbrt())),
            Quantity::FrictionStress | Quantity::FrictionCoefficient => {
                let area = slot.curve.and_then(|curve| {
                    let curve = self.inputs.results.curves.get(curve)?;
                    curve.area_fractions(load).last().map(|(_, area_fraction)| *area_fraction)
                });
                area.map_or(Ok(None), |area_fraction| self.friction(slot.quantity, load, area_fraction))
            }
            Quantity::TangentialStiffness
            | Quantity::TangentialDisplacement
            | Quantity::StuckAreaFraction
            | Quantity::TangentialDissipation
            | Quantity::DampingRatio => self.tangential(load, slot.quantity),
            Quantity::TightPressure | Quantity::FullerTabor | Quantity::PastewkaRobbins => {
                self.of_all_loads(slot.quantity)
            }
        }
    }

    /// The bodies with the friction of the request.
    fn sheared_pair(&self) -> Result<Option<ShearedPair>, InterfaceError> {
        self.request.shear.map(|shear| sheared_pair(shear.friction, &self.inputs.pair)).transpose()
    }

    /// The share of friction times pressure that a tangential load has under a load, if it is below 1.
    fn sticking_share(&self, load: usize) -> Option<f64> {
        let share = self.request.shear?.share_of_sliding(self.pressure_pa(load));
        (share < 1.0).then_some(share)
    }

    fn sheared(&self, load: usize) -> Result<Option<ShearedContact>, InterfaceError> {
        let (Some(pair), Some(share)) = (self.sheared_pair()?, self.sticking_share(load)) else {
            return Ok(None);
        };
        let respond = || {
            let stiffness = |pressure_pa| self.finite_stiffness_pa_per_m(pressure_pa).ok_or(());
            pair.respond(self.pressure_pa(load), share, stiffness).ok()
        };
        Ok(*self.elastic.sheared[load].get_or_init(respond))
    }

    fn tangential(&self, load: usize, quantity: Quantity) -> Result<Option<f64>, InterfaceError> {
        if quantity == Quantity::TangentialStiffness {
            // The response to a tangential load is that of elastic peaks throughout.
            let stiffness = self.finite_stiffness_pa_per_m(self.pressure_pa(load));
            let pair = self.sheared_pair()?;
            return Ok(pair.zip(stiffness).map(|(pair, stiffness)| stiffness / pair.compliance_ratio()));
        }
        let Some(found) = self.sheared(load)? else { return Ok(None) };
        Ok(match quantity {
            Quantity::TangentialDisplacement => Some(found.displacement_m),
            Quantity::StuckAreaFraction => self.elastic_area_fraction(found.stuck_pressure_pa),
            Quantity::TangentialDissipation => Some(found.dissipation_j_per_m2),
            Quantity::DampingRatio => Some(found.damping_ratio),
            _ => None,
        })
    }

    /// The spot that conducts like the whole interface, if its nominal area is known.
    fn spot(&self, stiffness: &RelativeStiffness) -> Result<Option<Spot>, InterfaceError> {
        let spot = self.request.nominal_area_m2.map(|area_m2| stiffness.equivalent_spot(area_m2));
        spot.transpose()
    }

    fn heat(&self, load: usize, quantity: Quantity) -> Result<Option<f64>, InterfaceError> {
        let (Some(conductivities), Some(stiffness)) =
            (&self.request.conductivities, self.relative_stiffness(load)?)
        else {
            return Ok(None);
        };
        if quantity == Quantity::ThermalConductance {
            return Ok(Some(stiffness.thermal_conductance_w_per_m2_k(conductivities)));
        }
        let spot = self.spot(&stiffness)?;
        Ok(spot.map(|spot| spot.thermal_resistance_k_per_w(conductivities)))
    }

    /// Conductance of the gas over the gaps of the theory, taken as Gaussian about the distance of the mean planes.
    fn gas(&self, load: usize) -> Option<f64> {
        self.gas_over(self.separation(load)?.gap.mean_plane_distance_m)
    }

    /// Returns the conductance \[W/(m^2 K)\] of the gas over Gaussian gaps about a distance of the mean planes \[m\]; `None` in a vacuum.
    #[must_use]
    pub fn gas_over(&self, gap_m: f64) -> Option<f64> {
        let rms_height_m = self.elastic.moments.rms_height_m();
        let of_gas = self.request.gas.filter(|_| rms_height_m > 0.0 && gap_m.is_finite())?;
        Some(of_gas.conductance_w_per_m2_k(gap_m, rms_height_m))
    }

    /// Returns the distance of the mean planes \[m\] under a local pressure \[Pa\], by the theory or by Yovanovich; `None` where
    /// everything touches.
    pub(super) fn gap_under(&self, gap: Quantity, local_pa: f64) -> Option<f64> {
        match gap {
            Quantity::YovanovichGap => {
                let ratio = PressureRatio::new(local_pa, self.inputs.hardness_pa?).ok()?;
                plastic_separation_m(self.elastic.moments.rms_height_m(), ratio)
            }
            _ => Some(self.gap_at(local_pa)?.mean_plane_distance_m),
        }
    }

    /// Distance of the mean planes of peaks that have flowed \[m\]; `None` without a hardness, and where everything touches.
    fn flowed_gap_m(&self, load: usize) -> Result<Option<f64>, InterfaceError> {
        let ratio = self.pressure_ratio(load)?;
        Ok(ratio.and_then(|ratio| plastic_separation_m(self.elastic.moments.rms_height_m(), ratio)))
    }

    fn current(&self, load: usize, quantity: Quantity) -> Result<Option<f64>, InterfaceError> {
        let (Some(resistivities), Some(stiffness)) =
            (&self.request.resistivities, self.relative_stiffness(load)?)
        else {
            return Ok(None);
        };
        if quantity == Quantity::ElectricalConductance {
            return Ok(Some(stiffness.electrical_conductance_s_per_m2(resistivities)));
        }
        let spot = self.spot(&stiffness)?;
        Ok(spot.map(|spot| spot.electrical_resistance_ohm(resistivities)))
    }

    fn flowed(&self, load: usize, correlation: PlasticCorrelation) -> Result<Option<f64>, InterfaceError> {
        let (Some(conductivities), Some(ratio)) = (&self.request.conductivities, self.pressure_ratio(load)?)
        else {
            return Ok(None);
        };
        Ok(Some(correlation.conductance_w_per_m2_k(conductivities, &self.surface()?, ratio)))
    }

    fn flowed_current(&self, load: usize) -> Result<Option<f64>, InterfaceError> {
        let (Some(resistivities), Some(ratio)) = (&self.request.resistivities, self.pressure_ratio(load)?)
        else {
            return Ok(None);
        };
        let conductivities = resistivities.conductivities();
        let correlation = PlasticCorrelation::Yovanovich;
        Ok(Some(correlation.conductance_w_per_m2_k(&conductivities, &self.surface()?, ratio)))
    }

    fn surface(&self) -> Result<CutSurface, InterfaceError> {
        CutSurface::from_rms_slope(self.elastic.moments.rms_height_m(), self.elastic.moments.rms_slope())
    }

    fn relative_stiffness(&self, load: usize) -> Result<Option<RelativeStiffness>, InterfaceError> {
        let of = |stiffness| RelativeStiffness::new(stiffness, self.modulus_pa());
        self.stiffness_pa_per_m(load).map(of).transpose()
    }

    pub(super) fn pressure_pa(&self, load: usize) -> f64 {
        self.inputs.pressures[load].pa()
    }

    pub(super) fn modulus_pa(&self) -> f64 {
        self.inputs.pair.composite_modulus_pa()
    }
}

impl ElasticStates {
    fn new(
        request: &InterfaceRequest,
        inputs: &InterfaceInputs<'_>,
        roughness: Roughness,
        moments: Moments,
    ) -> Self {
        let modulus_pa = inputs.pair.composite_modulus_pa();
        let separation = SeparationLaw::from_roughness(&roughness, modulus_pa, request.energy_factor);
        let sealing = request.seal.map(|seal| {
            let correction = Some(CORRECTION_OF_SEALS);
            SealingLaw::new(&roughness, modulus_pa, request.energy_factor, correction, seal.threshold)
        });
        let flow = sealing.as_ref().map(|law| Arc::new(SealFlow::new(law)));
        let loads = inputs.pressures.len();
        ElasticStates {
            moments,
            roughness,
            separation,
            separations: vec![OnceLock::new(); loads],
            yielding: OnceLock::new(),
            sealing,
            sheared: vec![OnceLock::new(); loads],
            constrictions: vec![OnceLock::new(); loads],
            flow,
            with_wave: None,
            flatness: vec![OnceLock::new(); loads],
        }
    }

    /// Spread of the pressure that would flatten the whole roughness \[Pa\].
    fn spread_pa(&self, modulus_pa: f64) -> f64 {
        self.roughness.places().last().map_or(0.0, |last| last.variance_pa2(modulus_pa).sqrt())
    }
}

/// Moments in the normalisation of Parseval's theorem.
fn by_parseval(moments: &Moments, normalisation: Normalisation) -> Moments {
    let factor = Normalisation::Parseval.factor() / normalisation.factor();
    Moments {
        m0_m2: factor * moments.m0_m2,
        m2: factor * moments.m2,
        m4_per_m2: factor * moments.m4_per_m2,
        ..*moments
    }
}
