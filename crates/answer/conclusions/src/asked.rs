//! Answers to what a scene asks of its interface besides the area and the seal: one value with one range for each, and the state of the
//! peaks of the roughness.

use interface::conductance::MOST_PLASTIC_SHARE;
use interface::flatness::LIMITS_WITHIN;
use interface::friction::SlidingContact;
use judge::Reference;
use persson::separation::STIFFNESS_WITHIN;
use serde::Serialize;
use study::interface::{FlatnessRange, InterfaceStates, Quantity, Slot};
use uncertainty::Uncertainty;

use super::area::{AreaEstimate, Source};

/// The share of the contact that has flowed from which on all of it counts as flowed.
const FLOWED_SHARE: f64 = 0.9;

/// The factor, either way, within which gaps of Persson's theory hold boundary elements of nine in ten spectra.
const GAP_WITHIN: f64 = 1.15;

/// The factor, either way, within which a measured map that is pressed on its own points has the gap and the stiffness of the surface.
const MAP_WITHIN: f64 = 1.05;

/// Returns the factor, either way, within which both limits of flatness hold: [`LIMITS_WITHIN`], or the most by which either changes the
/// value of flat faces, if that is less.
#[must_use]
pub fn flatness_within(flat: f64, limits: FlatnessRange) -> f64 {
    let change = |limit: f64| (limit / flat).ln().abs();
    LIMITS_WITHIN.ln().min(change(limits.by_wave).max(change(limits.by_cap))).exp()
}

/// The state of the peaks under a load.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PeakState {
    /// Less than 3 % of the contact has flowed.
    Elastic,
    /// Part of it has.
    Partly,
    /// More than 90 % has.
    Flowed,
    /// A part that depends on a hardness of small scales that is not known.
    Unknown,
}

/// A quantity that a scene asks for, under a load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct AskedValue {
    /// The quantity; its name tells the unit.
    pub quantity: Quantity,
    /// The best estimate; `None` if only its range is known.
    pub value: Option<f64>,
    /// The low end of its range: uncertain inputs, the error of the theory, and all states that the peaks may be in.
    pub low: f64,
    /// The high end.
    pub high: f64,
    /// The state of the peaks that it is for; `None` if it does not depend on that.
    pub state: Option<PeakState>,
    /// The value of flat faces, where a flatness is given that changes it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flat: Option<f64>,
}

/// A value with its range.
#[derive(Clone, Copy)]
struct Ranged {
    value: f64,
    low: f64,
    high: f64,
    /// The value of flat faces, where a flatness changes it.
    flat: Option<f64>,
}

/// The questions of a scene under one of its loads, and what answers them.
pub(crate) struct Questions<'a> {
    pub states: &'a InterfaceStates<'a>,
    pub uncertainty: Option<&'a Uncertainty>,
    pub load: usize,
    pub area: &'a AreaEstimate,
}

impl PeakState {
    /// Finds the state under a load: that of the measured maps that were pressed, or else that of the spectrum.
    pub(crate) fn new(states: &InterfaceStates<'_>, load: usize, area: &AreaEstimate) -> Self {
        let of_maps = area.maps.and_then(|maps| maps.plastic_share);
        let share = of_maps.or_else(|| states.plastic_share(load)).unwrap_or(0.0);
        match area.source {
            _ if share <= MOST_PLASTIC_SHARE => PeakState::Elastic,
            Source::Elements(Reference::Growing) => PeakState::Unknown,
            Source::Elements(Reference::Elastic) if states.inputs.hardness_grows => PeakState::Unknown,
            // Elements are elastic where the mean pressure of the contact stays below the hardness.
            Source::Elements(Reference::Elastic) => PeakState::Partly,
            _ if share <= FLOWED_SHARE => PeakState::Partly,
            _ => PeakState::Flowed,
        }
    }
}

impl Questions<'_> {
    /// Answers all of them.
    pub fn answers(&self) -> Vec<AskedValue> {
        let request = self.states.request;
        let mut found = Vec::new();
        if request.asks.gap {
            found.extend(self.in_state(Quantity::MeanGap, GAP_WITHIN));
            let stiffness = self.in_state(Quantity::Stiffness, STIFFNESS_WITHIN);
            found.extend(stiffness.map(|stiffness| AskedValue { state: None, ..stiffness }));
        }
        if request.asks.heat {
            let (quantity, conducts) = match (request.conductivities.is_some(), request.gas.is_some()) {
                (true, true) => (Quantity::ThermalConductanceWithGas, true),
                (true, false) => (Quantity::ThermalConductance, true),
                (false, _) => (Quantity::GasConductance, false),
            };
            let heat = self.in_state(quantity, STIFFNESS_WITHIN);
            let of_area = |heat| match conducts {
                true => self.of_nominal_area(heat, Quantity::ThermalResistance),
                false => heat,
            };
            found.extend(heat.map(of_area));
        }
        if request.asks.current {
            let current = self.in_state(Quantity::ElectricalConductance, STIFFNESS_WITHIN);
            found
                .extend(current.map(|current| self.of_nominal_area(current, Quantity::ElectricalResistance)));
        }
        found.extend(self.friction());
        found
    }

    /// A value with the state of the peaks and its range, which spans elastic peaks and those of a constant hardness where it
    /// is not known how much flows.
    fn in_state(&self, quantity: Quantity, factor: f64) -> Option<AskedValue> {
        let found = self.within(quantity, factor)?;
        let state = PeakState::new(self.states, self.load, self.area);
        let others = match state {
            PeakState::Unknown => vec![self.states.with_hardness(None), self.states.at_constant_hardness()],
            _ => Vec::new(),
        };
        let over_this = |other: &InterfaceStates<'_>| {
            Some(other.value(self.slot(quantity)).ok().flatten()? / self.by_theory(quantity)?)
        };
        let [least, largest] = others
            .iter()
            .filter_map(over_this)
            .fold([1.0f64, 1.0], |[least, largest], ratio| [least.min(ratio), largest.max(ratio)]);
        Some(AskedValue {
            quantity,
            value: Some(found.value),
            low: found.low * least,
            high: found.high * largest,
            state: Some(state),
            flat: found.flat,
        })
    }

    /// A value with its range: the interval of uncertain inputs and the factor of the theory, whose logarithms add as squares, about
    /// both limits of the flatness.
    fn within(&self, quantity: Quantity, factor: f64) -> Option<Ranged> {
        let of_theory = self.by_theory(quantity)?;
        let of_map = self.of_map(quantity);
        let value = of_map.map_or(of_theory, |over_theory| over_theory * of_theory);
        let interval = self.uncertainty.and_then(|found| found.quantity(self.slot(quantity)));
        // Intervals of stiffnesses under light loads contain their error.
        let contained = quantity.follows_stiffness() && self.states.light_contact_factor(self.load) > 1.0;
        let factor = match of_map {
            Some(_) => MAP_WITHIN,
            None if contained && interval.is_some() => 1.0,
            None => factor,
        };
        let [below, above] = interval.map_or([1.0, 1.0], |found| {
            [(of_theory / found.low).max(1.0), (found.high / of_theory).max(1.0)]
        });
        let wider = |ratio: f64| ratio.ln().hypot(factor.ln()).exp();
        let (wider_below, wider_above) = (wider(below), wider(above));
        let limits = self.states.with_flatness(quantity, self.load, value).ok().flatten();
        Some(match limits {
            None => Ranged { value, low: value / wider_below, high: value * wider_above, flat: None },
            Some(limits) => {
                let within = flatness_within(value, limits).ln();
                let with_flatness = |factor: f64| factor.ln().hypot(within).exp();
                let FlatnessRange { by_wave, by_cap } = limits;
                Ranged {
                    value: (by_wave * by_cap).sqrt(),
                    low: by_wave.min(by_cap) / with_flatness(wider_below),
                    high: by_wave.max(by_cap) * with_flatness(wider_above),
                    flat: Some(value),
                }
            }
        })
    }

    /// A gap, or what follows the stiffness, of the measured map over that of the theory. Gas has the gap of the map. A map that was
    /// pressed without yielding says nothing of peaks that flow.
    fn of_map(&self, quantity: Quantity) -> Option<f64> {
        let flows = self.states.plastic_share(self.load).is_some_and(|share| share > MOST_PLASTIC_SHARE);
        let maps = self.area.maps.filter(|maps| maps.plastic_share.is_some() || !flows)?;
        let of_gas = || maps.mean_gap_m.and_then(|gap_m| self.states.gas_over(gap_m));
        let beside_gas = || {
            let spots = Quantity::ThermalConductance;
            Some(self.of_map(spots).unwrap_or(1.0) * self.by_theory(spots)? + of_gas()?)
        };
        let (of_map, theory) = match quantity {
            Quantity::GasConductance => (of_gas(), quantity),
            Quantity::ThermalConductanceWithGas => (beside_gas(), quantity),
            Quantity::MeanGap => (maps.mean_gap_m, quantity),
            _ if quantity.follows_stiffness() => (maps.stiffness_pa_per_m, Quantity::Stiffness),
            _ => (None, quantity),
        };
        Some(of_map? / self.by_theory(theory)?)
    }

    fn by_theory(&self, quantity: Quantity) -> Option<f64> {
        self.states.value(self.slot(quantity)).ok().flatten()
    }

    fn slot(&self, quantity: Quantity) -> Slot {
        Slot { quantity, load: Some(self.load), curve: None }
    }

    /// The resistance of the nominal area in place of a conductance per area, where that area is known.
    fn of_nominal_area(&self, conductance: AskedValue, resistance: Quantity) -> AskedValue {
        let Some(area_m2) = self.states.request.nominal_area_m2 else { return conductance };
        let inverse = |per_area: f64| 1.0 / (per_area * area_m2);
        AskedValue {
            quantity: resistance,
            value: conductance.value.map(inverse),
            flat: conductance.flat.map(inverse),
            low: inverse(conductance.high),
            high: inverse(conductance.low),
            ..conductance
        }
    }

    /// The coefficient of friction of the area that touches.
    fn friction(&self) -> Option<AskedValue> {
        let shear_strength_pa = self.states.request.shear_strength_pa?;
        let pressure_pa = self.states.inputs.pressures[self.load].pa();
        let coefficient = |area_fraction: f64| {
            let sliding = SlidingContact::new(shear_strength_pa, area_fraction, pressure_pa);
            sliding.ok().map(|sliding| sliding.friction_coefficient())
        };
        Some(AskedValue {
            quantity: Quantity::FrictionCoefficient,
            value: self.area.area_fraction.and_then(coefficient),
            low: coefficient(self.area.low)?,
            high: coefficient(self.area.high)?,
            state: None,
            flat: None,
        })
    }
}
