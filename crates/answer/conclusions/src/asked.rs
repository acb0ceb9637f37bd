//! Answers to what a scene asks of its interface besides the area and the seal: one value with one range for each, in the state that
//! the peaks of the roughness are in.

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

/// The factor, either way, within which gas conducts in a gap that is known.
const GAS_WITHIN: f64 = 1.25;

/// The factor, either way, within which a measured map that is pressed on its own points has the gap and the stiffness of the surface.
const MAP_WITHIN: f64 = 1.05;

/// The factor, either way, within which a correlation for flowed peaks is taken to hold: measured conductances of conforming faces
/// scatter by as much about it where the hardness is that of a large indentation.
const CORRELATION_WITHIN: f64 = 1.73;

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
    /// Part of it has, or how much depends on a hardness that is not known.
    Partly,
    /// More than 90 % has.
    Flowed,
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

/// A quantity by the theory of elastic peaks and by that of flowed ones.
struct ByState {
    elastic: Quantity,
    flowed: Option<Quantity>,
    elastic_within: f64,
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
            Source::Elements(Reference::Growing | Reference::Elastic) => PeakState::Partly,
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
            let gap = ByState {
                elastic: Quantity::MeanGap,
                flowed: Some(Quantity::FlowedGap),
                elastic_within: GAP_WITHIN,
            };
            found.extend(self.by_state(&gap));
            let stiffness = self.within(Quantity::Stiffness, STIFFNESS_WITHIN);
            found.extend(stiffness.map(|stiffness| stiffness.answers(Quantity::Stiffness, None)));
        }
        if request.asks.heat {
            let heat = self.by_state(&ByState::heat(request.conductivities.is_some(), request.gas.is_some()));
            let of_area = Quantity::ThermalResistance;
            let conducts = request.conductivities.is_some();
            found.extend(heat.map(|heat| if conducts { self.of_nominal_area(heat, of_area) } else { heat }));
        }
        if request.asks.current {
            let current = ByState {
                elastic: Quantity::ElectricalConductance,
                flowed: Some(Quantity::FlowedElectricalConductance),
                elastic_within: STIFFNESS_WITHIN,
            };
            let current = self.by_state(&current);
            found
                .extend(current.map(|current| self.of_nominal_area(current, Quantity::ElectricalResistance)));
        }
        found.extend(self.friction());
        found
    }

    /// A value with the range of the state that the peaks are in; of partly flowed ones, from elastic to flowed.
    fn by_state(&self, quantities: &ByState) -> Option<AskedValue> {
        let elastic = || self.within(quantities.elastic, quantities.elastic_within);
        let flowed = || self.within(quantities.flowed?, self.correlation_within(quantities.flowed?));
        let state = PeakState::new(self.states, self.load, self.area);
        let (quantity, state, found) = match (state, elastic(), flowed()) {
            (PeakState::Flowed, _, Some(flowed)) => (quantities.flowed?, PeakState::Flowed, flowed),
            (PeakState::Partly, Some(elastic), Some(Ranged { value: flowed, .. })) => {
                let (low, high) = (elastic.low.min(flowed), elastic.high.max(flowed));
                (quantities.elastic, PeakState::Partly, Ranged { low, high, ..elastic })
            }
            (state, elastic, None) => (quantities.elastic, state, elastic?),
            (_, None, Some(flowed)) => (quantities.flowed?, PeakState::Flowed, flowed),
            (PeakState::Elastic, Some(elastic), _) => (quantities.elastic, PeakState::Elastic, elastic),
        };
        Some(found.answers(quantity, Some(state)))
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

    /// The factor within which a correlation for flowed peaks holds; the gas beside its spots is known better.
    fn correlation_within(&self, flowed: Quantity) -> f64 {
        let by_spots = match flowed {
            Quantity::FlowedConductanceWithGas => {
                self.by_theory(Quantity::YovanovichConductance).zip(self.by_theory(flowed))
            }
            _ => None,
        };
        let share = by_spots.map_or(1.0, |(spots, all)| spots / all);
        share * CORRELATION_WITHIN + (1.0 - share) * GAS_WITHIN
    }

    /// A gap, or what follows the stiffness, of the measured map over that of the theory. Gas has the gap of the map.
    fn of_map(&self, quantity: Quantity) -> Option<f64> {
        let maps = self.area.maps?;
        let of_gas = || maps.mean_gap_m.and_then(|gap_m| self.states.gas_over(gap_m));
        let beside_gas =
            |spots: Quantity| Some(self.of_map(spots).unwrap_or(1.0) * self.by_theory(spots)? + of_gas()?);
        let (of_map, theory) = match quantity {
            Quantity::GasConductance => (of_gas(), quantity),
            Quantity::ThermalConductanceWithGas => (beside_gas(Quantity::ThermalConductance), quantity),
            Quantity::FlowedConductanceWithGas if maps.plastic_share.is_some() => {
                (beside_gas(Quantity::YovanovichConductance), quantity)
            }
            Quantity::MeanGap => (maps.mean_gap_m, quantity),
            Quantity::FlowedGap => (maps.mean_gap_m.filter(|_| maps.plastic_share.is_some()), quantity),
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

impl Ranged {
    fn answers(self, quantity: Quantity, state: Option<PeakState>) -> AskedValue {
        let Ranged { value, low, high, flat } = self;
        AskedValue { quantity, value: Some(value), low, high, state, flat }
    }
}

impl ByState {
    /// Heat through spots, where both bodies conduct, and through gas, where there is some.
    fn heat(conducts: bool, has_gas: bool) -> Self {
        let (elastic, flowed) = match (conducts, has_gas) {
            (true, true) => (Quantity::ThermalConductanceWithGas, Some(Quantity::FlowedConductanceWithGas)),
            (true, false) => (Quantity::ThermalConductance, Some(Quantity::YovanovichConductance)),
            (false, _) => (Quantity::GasConductance, None),
        };
        ByState { elastic, flowed, elastic_within: STIFFNESS_WITHIN }
    }
}
