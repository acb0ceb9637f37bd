//! The seal: the pressure that closes it, and whether it is closed under each load.

use interface::sealed_fluid::LeakUnit;
use serde::Serialize;
use study::interface::InterfaceStates;
use study::interface::{Quantity, Seal, Slot};
use uncertainty::Uncertainty;

/// The conclusion on a seal that holds under every load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SealConclusion {
    /// The pressure that closes it; `None` if no pressure does.
    pub closes: Option<SealClosing>,
    /// Number of the longest waves of the surface that fit into the shorter side of the joint, if they are so few that chance decides
    /// the leak rate.
    pub few_waves: Option<f64>,
}

/// The pressure that closes a seal.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SealClosing {
    /// The nominal pressure \[Pa\].
    pub nominal_pressure_pa: f64,
    /// The low end of its interval \[Pa\]; the pressure itself where no input is uncertain.
    pub low: f64,
    /// The high end \[Pa\].
    pub high: f64,
    /// True if the contact flows before it would close elastically.
    pub by_yielding: bool,
}

/// A seal under a load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SealUnderLoad {
    /// The verdict.
    pub verdict: SealVerdict,
    /// The share of draws in which a channel is open; `None` without draws.
    pub open_share: Option<f64>,
    /// The leak rate \[m^3/s\], low and high end; `None` where the seal is tight, or without the inputs of a rate.
    pub leak_rate_m3_per_s: Option<[f64; 2]>,
    /// The leak rate in the unit that is asked for.
    pub leak_rate: Option<LeakInUnit>,
    /// True if the fluid presses more than the bodies do: the rate holds if something else keeps them together.
    pub fluid_parts_bodies: bool,
}

/// A leak rate in a unit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LeakInUnit {
    /// Low end.
    pub low: f64,
    /// High end.
    pub high: f64,
    /// The unit; masses and pressures times volumes are of gases.
    pub unit: LeakUnit,
}

/// The answer to "does it seal?", by the interval of the pressure that closes the last channel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SealVerdict {
    /// The load is above the whole interval.
    Tight,
    /// The load is in the interval, at or above the best estimate.
    LikelyTight,
    /// The load is in the interval, below the best estimate.
    LikelyOpen,
    /// The load is below the whole interval, or the fluid parts the bodies.
    Open,
}

impl SealConclusion {
    /// Draws the conclusion; `None` if the scene has no seal.
    pub(crate) fn new(states: &InterfaceStates<'_>, uncertainty: Option<&Uncertainty>) -> Option<Self> {
        let seal = states.request.seal?;
        let longest_m = states.longest_wave_m();
        let narrow = seal.joint.filter(|joint| joint.is_narrow(longest_m));
        let few_waves = narrow.map(|joint| joint.waves(longest_m));
        Some(SealConclusion { closes: SealClosing::new(states, uncertainty), few_waves })
    }
}

/// The pressure that closes a seal, the same under all loads.
const TIGHT: Slot = Slot { quantity: Quantity::TightPressure, load: None, curve: None };

impl SealClosing {
    /// Finds the pressure; `None` if none closes the seal.
    pub(crate) fn new(states: &InterfaceStates<'_>, uncertainty: Option<&Uncertainty>) -> Option<Self> {
        let of_flat_pa = states.value(TIGHT).ok().flatten()?;
        let interval = uncertainty.and_then(|found| found.quantity(TIGHT));
        let (low, high) = interval.map_or((1.0, 1.0), |found| {
            ((found.low / of_flat_pa).min(1.0), (found.high / of_flat_pa).max(1.0))
        });
        let [least_pa, most_pa] = flatness_limits_pa(states, of_flat_pa).unwrap_or([of_flat_pa; 2]);
        Some(SealClosing {
            nominal_pressure_pa: if least_pa < most_pa { (least_pa * most_pa).sqrt() } else { least_pa },
            low: low * least_pa,
            high: high * most_pa,
            by_yielding: most_pa == of_flat_pa && states.closed_by_yielding_from_pa() == Some(of_flat_pa),
        })
    }
}

/// The pressures \[Pa\] that close a seal by both limits of the flatness, in rising order: as a wave of the roughness, and as a cap that
/// has to touch all over; `None` without a flatness.
fn flatness_limits_pa(states: &InterfaceStates<'_>, of_flat_pa: f64) -> Option<[f64; 2]> {
    let by_wave_pa = states.with_wave()?.value(TIGHT).ok().flatten()?;
    let modulus_pa = states.inputs.pair.composite_modulus_pa();
    let by_cap_pa = of_flat_pa.max(states.request.flatness?.flattening_pressure_pa(modulus_pa));
    Some([by_wave_pa.min(by_cap_pa), by_wave_pa.max(by_cap_pa)])
}

/// The most \[m^3/s\] that faces which are not flat let through: through the channels of the roughness with the wave, or around the contact.
fn around(states: &InterfaceStates<'_>, load: usize) -> Option<f64> {
    let slot = Slot { quantity: Quantity::LeakRateHigh, load: Some(load), curve: None };
    let by_wave = states.with_wave()?.value(slot).ok().flatten();
    by_wave.into_iter().chain(states.leak_around_m3_per_s(load)).reduce(f64::max)
}

/// Converts a leak rate \[m^3/s\] to the unit of a seal.
fn in_unit(seal: &Seal, [low, high]: [f64; 2]) -> Option<LeakInUnit> {
    let (unit, joint) = (seal.unit.unwrap_or(LeakUnit::CubicMetrePerSecond), seal.joint?);
    let of = |rate_m3_per_s| unit.of(rate_m3_per_s, joint.fluid());
    Some(LeakInUnit { low: of(low)?, high: of(high)?, unit })
}

impl SealUnderLoad {
    pub(crate) fn new(
        states: &InterfaceStates<'_>,
        uncertainty: Option<&Uncertainty>,
        load: usize,
    ) -> Option<Self> {
        let pressure_pa = states.inputs.pressures[load].pa();
        let seal = states.request.seal?;
        let closing = SealClosing::new(states, uncertainty);
        let rate = |quantity| {
            let slot = Slot { quantity, load: Some(load), curve: None };
            let value = states.value(slot).ok().flatten()?;
            let interval = uncertainty.and_then(|found| found.quantity(slot));
            Some(interval.map_or([value, value], |found| [found.low.min(value), found.high.max(value)]))
        };
        let [low, high] = [Quantity::LeakRateLow, Quantity::LeakRateHigh].map(rate);
        let of_flat = low.zip(high).map(|(low, high)| [low[0], high[1]]);
        let open_share = uncertainty.and_then(|found| found.share_open(load));
        let fluid_parts_bodies = states.request.parts_bodies(pressure_pa);
        let leak_rate_m3_per_s = match (of_flat, around(states, load)) {
            (Some([low, high]), Some(around)) => Some([low, high.max(around)]),
            (None, Some(around)) => Some([0.0, around]),
            (of_flat, None) => of_flat,
        };
        Some(SealUnderLoad {
            verdict: match fluid_parts_bodies {
                true => SealVerdict::Open,
                false => closing.map_or(SealVerdict::Open, |closing| SealVerdict::new(pressure_pa, &closing)),
            },
            // The draws are those of flat faces.
            open_share: open_share.filter(|_| states.request.flatness.is_none()),
            leak_rate_m3_per_s,
            leak_rate: leak_rate_m3_per_s.and_then(|rate| in_unit(&seal, rate)),
            fluid_parts_bodies,
        })
    }
}

impl SealVerdict {
    fn new(pressure_pa: f64, closing: &SealClosing) -> Self {
        match pressure_pa {
            _ if pressure_pa < closing.low => SealVerdict::Open,
            _ if pressure_pa < closing.nominal_pressure_pa => SealVerdict::LikelyOpen,
            _ if pressure_pa < closing.high => SealVerdict::LikelyTight,
            _ => SealVerdict::Tight,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_seal_is_certain_outside_the_interval_alone() {
        let closing = SealClosing { nominal_pressure_pa: 3e5, low: 1.4e5, high: 8.6e5, by_yielding: false };
        for (pressure_pa, expected) in [
            (1.3e5, SealVerdict::Open),
            (1.4e5, SealVerdict::LikelyOpen),
            (2.9e5, SealVerdict::LikelyOpen),
            (3e5, SealVerdict::LikelyTight),
            (8.5e5, SealVerdict::LikelyTight),
            (8.6e5, SealVerdict::Tight),
        ] {
            assert_eq!(SealVerdict::new(pressure_pa, &closing), expected, "{pressure_pa}");
        }
        let known = SealClosing { low: 3e5, high: 3e5, ..closing };
        assert_eq!(SealVerdict::new(2.9e5, &known), SealVerdict::Open);
        assert_eq!(SealVerdict::new(3e5, &known), SealVerdict::Tight);
    }
}
