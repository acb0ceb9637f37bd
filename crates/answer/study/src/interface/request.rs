//! Requests of a scene for the quantities of its interface.

use interface::adhesion::{StickyContact, fuller_tabor};
use interface::conductance::{Conductivities, Resistivities};
use interface::flatness::Flatness;
use interface::gas::GapGas;
use interface::leak::SealedJoint;
use interface::sealed_fluid::LeakUnit;
use persson::Band;
use persson::EnergyFactor;
use persson::sealing::PercolationThreshold;
use spectrum::{AsperityParameters, Moments};
use units::OutOfBounds;

use super::quantity::{Quantity, Slot};
use super::shear::Shear;

/// A request for quantities of an interface besides its area: gap and stiffness always, others if their inputs are
/// given.
#[derive(Debug, Clone, PartialEq)]
pub struct InterfaceRequest {
    /// The elastic energy factor gamma of Persson's theory.
    pub energy_factor: EnergyFactor,
    /// The spectrum that a cutoff applies to in Persson's theory: that of profiles, or that of the surface.
    pub band: Band,
    /// Thermal conductivities of both bodies.
    pub conductivities: Option<Conductivities>,
    /// Resistivities of both.
    pub resistivities: Option<Resistivities>,
    /// The gas in the gaps; vacuum if absent.
    pub gas: Option<GapGas>,
    /// The deviation of the nominal contact from a plane; flat if absent.
    pub flatness: Option<Flatness>,
    /// The nominal area \[m^2\], if a force was given.
    pub nominal_area_m2: Option<f64>,
    /// The seal that the contact makes.
    pub seal: Option<Seal>,
    /// The shear strength of what touches \[Pa\].
    pub shear_strength_pa: Option<f64>,
    /// The adhesion across the gap.
    pub adhesion: Option<AdhesionRequest>,
    /// The tangential load, and the friction that it meets.
    pub shear: Option<Shear>,
    /// The questions of the scene, of all that its bodies allow.
    pub asks: Asks,
}

/// The questions of a scene that its inputs alone do not tell, since bodies of a table bring conductivities with them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Asks {
    /// True for mean gap and stiffness.
    pub gap: bool,
    /// True for heat.
    pub heat: bool,
    /// True for current.
    pub current: bool,
}

/// A contact as a seal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seal {
    /// The share in contact at which channels close.
    pub threshold: PercolationThreshold,
    /// The nominal contact, its fluid and what presses on that; without it there is no rate.
    pub joint: Option<SealedJoint>,
    /// The unit that the leak rate is asked in; cubic metres per second if absent.
    pub unit: Option<LeakUnit>,
}

/// Attraction across a gap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AdhesionRequest {
    /// The work of adhesion w \[J/m^2\].
    pub work_j_per_m2: f64,
    /// The range of the attraction \[m\].
    pub range_m: Option<f64>,
}

impl AdhesionRequest {
    /// Returns the parameter of Fuller & Tabor for a surface by its moments, by Parseval's theorem; `None` without summits.
    ///
    /// # Errors
    /// [`OutOfBounds`] for what leaves the range of magnitudes.
    pub fn fuller_tabor(
        &self,
        moments: &Moments,
        contact_modulus_pa: f64,
    ) -> Result<Option<f64>, OutOfBounds> {
        let Some(summits) = AsperityParameters::from_moments(moments) else { return Ok(None) };
        let AsperityParameters { sigma_s_m, radius_m, .. } = summits;
        fuller_tabor(contact_modulus_pa, sigma_s_m, radius_m, self.work_j_per_m2).map(Some)
    }

    /// Returns the left side of the criterion of Pastewka & Robbins likewise; `None` without a range.
    ///
    /// # Errors
    /// [`OutOfBounds`] for what leaves the range of magnitudes.
    pub fn pastewka_robbins(
        &self,
        moments: &Moments,
        contact_modulus_pa: f64,
    ) -> Result<Option<f64>, OutOfBounds> {
        let Some(range_m) = self.range_m else { return Ok(None) };
        let contact = StickyContact {
            rms_gradient: moments.rms_gradient(),
            rms_laplacian_per_m: (8.0 / 3.0 * moments.m4_per_m2).sqrt(),
            contact_modulus_pa,
            work_of_adhesion_j_per_m2: self.work_j_per_m2,
            range_m,
            kappa: StickyContact::USUAL_KAPPA,
        };
        contact.left_side().map(Some)
    }
}

impl InterfaceRequest {
    /// Tells whether heat, current or a seal is asked for, which hang on the gap and so on the longest waves.
    #[must_use]
    pub fn conducts_or_seals(&self) -> bool {
        self.seal.is_some() || self.asks.heat || self.asks.current
    }

    /// Tells whether the longest waves decide something that is asked for.
    #[must_use]
    pub fn hangs_on_long_waves(&self) -> bool {
        self.asks.gap || self.conducts_or_seals()
    }

    /// Tells whether the fluid of a seal presses as much as the bodies do, at a nominal pressure \[Pa\], and would part them.
    #[must_use]
    pub fn parts_bodies(&self, pressure_pa: f64) -> bool {
        self.seal.and_then(|seal| seal.joint).is_some_and(|joint| joint.pressure_drop_pa() >= pressure_pa)
    }

    /// Lists all requested quantities, under every load and of every curve, whether or not they will have a value.
    #[must_use]
    pub fn slots(&self, loads: usize, curves: usize, has_hardness: bool) -> Vec<Slot> {
        let mut slots: Vec<Slot> = self
            .of_all_loads()
            .into_iter()
            .map(|quantity| Slot { quantity, load: None, curve: None })
            .collect();
        for load in 0..loads {
            let of_load = self.of_each_load(has_hardness).into_iter();
            slots.extend(of_load.map(|quantity| Slot { quantity, load: Some(load), curve: None }));
            if self.shear_strength_pa.is_some() {
                slots.extend((0..curves).flat_map(|curve| {
                    [Quantity::FrictionStress, Quantity::FrictionCoefficient].map(|quantity| Slot {
                        quantity,
                        load: Some(load),
                        curve: Some(curve),
                    })
                }));
            }
        }
        slots
    }

    fn of_all_loads(&self) -> Vec<Quantity> {
        let tight = self.seal.is_some().then_some(Quantity::TightPressure);
        let fuller_tabor = self.adhesion.is_some().then_some(Quantity::FullerTabor);
        let has_range = self.adhesion.is_some_and(|adhesion| adhesion.range_m.is_some());
        let pastewka_robbins = has_range.then_some(Quantity::PastewkaRobbins);
        [tight, fuller_tabor, pastewka_robbins].into_iter().flatten().collect()
    }

    fn of_each_load(&self, has_hardness: bool) -> Vec<Quantity> {
        let has_area = self.nominal_area_m2.is_some();
        let mut quantities = vec![Quantity::MeanGap, Quantity::Stiffness];
        quantities.extend(has_hardness.then_some(Quantity::YovanovichGap));
        if self.conductivities.is_some() {
            quantities.push(Quantity::ThermalConductance);
            quantities.extend(has_area.then_some(Quantity::ThermalResistance));
            if has_hardness {
                quantities
                    .extend([Quantity::YovanovichConductance, Quantity::CooperMikicYovanovichConductance]);
                quantities.extend(self.gas.map(|_| Quantity::YovanovichConductanceWithGas));
            }
        }
        if self.gas.is_some() {
            quantities.push(Quantity::GasConductance);
            quantities.extend(self.conductivities.map(|_| Quantity::ThermalConductanceWithGas));
        }
        if self.resistivities.is_some() {
            quantities.push(Quantity::ElectricalConductance);
            quantities.extend(has_area.then_some(Quantity::ElectricalResistance));
            quantities.extend(has_hardness.then_some(Quantity::YovanovichElectricalConductance));
        }
        if let Some(seal) = &self.seal {
            quantities.extend([Quantity::ChannelWavelength, Quantity::ChannelHeight, Quantity::LeakGap]);
            let rates = seal.joint.map(|_| [Quantity::LeakRateLow, Quantity::LeakRateHigh]);
            quantities.extend(rates.into_iter().flatten());
        }
        if self.shear.is_some() {
            quantities.extend(Quantity::OF_SHEAR);
        }
        quantities
    }
}
