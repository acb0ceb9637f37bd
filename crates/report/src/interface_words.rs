//! What the interface does besides touching, in plain words.

use interface::conductance::{ELECTRON_MEAN_FREE_PATH_M, MOST_PLASTIC_SHARE, PressureRatio};
use study::interface::{InterfaceStates, Quantity, Slot};
use study::scene::Scene;
use uncertainty::Uncertainty;
use units::display::{counted, length, pressure, three_digits};

use crate::coverage::level;
use crate::listing::listed;
use crate::persson_words;

/// More loads than this are left to the table.
const LOADS_TOLD: usize = 3;

/// `mean gap 2.31 um`, with its unit.
pub(crate) fn value(quantity: Quantity, value: f64) -> String {
    match quantity.unit() {
        "m" => length(value),
        "Pa" => pressure(value),
        "" => three_digits(value),
        unit => format!("{} {unit}", three_digits(value)),
    }
}

/// `2.31 um (95 %: 2.1 um to 2.5 um)`.
pub(crate) fn with_interval(slot: Slot, found: f64, uncertainty: Option<&Uncertainty>) -> String {
    let interval = uncertainty.and_then(|found| Some(format!(" ({}: {})", level(found), ends(slot, found)?)));
    value(slot.quantity, found) + &interval.unwrap_or_default()
}

/// `2.1 um to 2.5 um`, both ends of an interval; none where nothing that is uncertain moves it.
pub(crate) fn ends(slot: Slot, uncertainty: &Uncertainty) -> Option<String> {
    let found = uncertainty.quantity(slot).filter(|interval| interval.low < interval.high)?;
    let unit = slot.quantity.unit();
    Some(match unit {
        "m" | "Pa" => {
            format!("{} to {}", value(slot.quantity, found.low), value(slot.quantity, found.high))
        }
        _ => format!("{} to {} {unit}", three_digits(found.low), three_digits(found.high))
            .trim_end()
            .to_owned(),
    })
}

/// What is told under a heading: names and values.
pub(crate) struct Told {
    /// Under which load.
    pub heading: String,
    /// Every quantity with its value.
    pub lines: Vec<(String, String)>,
}

/// What is told of every load, of the first alone where there are many; what all of them share comes first.
pub(crate) fn told(
    states: &InterfaceStates<'_>,
    scene: &Scene,
    uncertainty: Option<&Uncertainty>,
) -> Vec<Told> {
    let slots = states.slots();
    let line = |slot: &Slot| {
        let found = states.value(*slot).ok().flatten()?;
        let of_curve =
            slot.curve.map_or_else(String::new, |curve| format!(", {}", scene.needs.curves[curve].name));
        let name = format!("{}{of_curve}", slot.quantity.words());
        Some((name, with_interval(*slot, found, uncertainty)))
    };
    let of = |load: Option<usize>| -> Vec<(String, String)> {
        slots.iter().filter(|slot| slot.load == load).filter_map(line).collect()
    };
    let all = Told { heading: "What it means under any load".to_owned(), lines: of(None) };
    let loads = &scene.needs.loads;
    let of_load = |load: usize| {
        let more = (load + 1 == LOADS_TOLD && loads.len() > LOADS_TOLD)
            .then(|| format!(" ({} more in report-interface)", counted(loads.len() - LOADS_TOLD, "load")));
        let tight = is_tight(states, &slots, load)
            .then(|| ("last channel".to_owned(), "none is open: tight".to_owned()));
        let heading = format!("What it means at {}{}", loads[load].label, more.unwrap_or_default());
        Told { heading, lines: of(Some(load)).into_iter().chain(tight).collect() }
    };
    let of_loads = (0..loads.len().min(LOADS_TOLD)).map(of_load);
    Some(all).filter(|all| !all.lines.is_empty()).into_iter().chain(of_loads).collect()
}

fn is_tight(states: &InterfaceStates<'_>, slots: &[Slot], load: usize) -> bool {
    let of_channel = |slot: &&Slot| slot.load == Some(load) && slot.quantity == Quantity::ChannelWavelength;
    slots.iter().find(of_channel).is_some_and(|slot| matches!(states.value(*slot), Ok(None)))
}

/// What the numbers leave out or go beyond.
pub(crate) fn notes(states: &InterfaceStates<'_>, scene: &Scene) -> Vec<String> {
    let loads = &scene.needs.loads;
    let least_pa = loads.iter().map(|load| load.nominal_pressure_pa()).fold(f64::INFINITY, f64::min);
    let mut notes = match states.light_loads() {
        Some(light) => persson_words::separation(&light, states.roughness(), states.rms_height_m(), least_pa),
        None => Vec::new(),
    };
    let at = |is_meant: &dyn Fn(usize) -> bool| -> Vec<&str> {
        (0..loads.len()).filter(|load| is_meant(*load)).map(|load| loads[load].label.as_str()).collect()
    };
    let plastic = at(&|load| states.plastic_share(load).is_some_and(|share| share > MOST_PLASTIC_SHARE));
    if !plastic.is_empty() {
        notes.push(format!(
            "at {} more than {} % of the contact has flowed: gap, stiffness and what follows from them are those of the elastic \
             theory, and say less the more has flowed",
            listed(&plastic),
            100.0 * MOST_PLASTIC_SHARE
        ));
    }
    let asked = states.asked();
    if asked.conductivities.is_some() || asked.resistivities.is_some() {
        notes.push(format!(
            "conductances take both bodies to be clean (films are not considered) and spots to be wider than the mean free path of \
             what crosses them, about {} for electrons in a good metal",
            length(ELECTRON_MEAN_FREE_PATH_M)
        ));
    }
    if asked.conductivities.is_some() && scene.hardness_pa().is_some() {
        notes.extend(states.mean_absolute_slope().ok().map(|slope| {
            format!(
                "the correlations for flowed peaks take the mean absolute slope at {}, {}: it grows with every shorter wavelength, \
                 and so do they; Barber’s analogy does not",
                length(states.pressed().results.psd.shortest_wavelength_m()),
                three_digits(slope)
            )
        }));
        let outside = at(&|load| {
            states.pressure_ratio(load).ok().flatten().is_some_and(|ratio| !ratio.range().is_within())
        });
        let [least, most] = PressureRatio::FITTED;
        if !outside.is_empty() {
            notes.push(format!(
                "at {} the pressure over the hardness is outside {least} to {most}, for which these correlations stand",
                listed(&outside)
            ));
        }
    }
    if let Some(seal) = &asked.seal {
        notes.push(format!(
            "channels close where {} of the nominal area touches; contact areas of the seal are those of a form fitted to boundary \
             elements, and a leak rate is an order of magnitude",
            seal.threshold.area_fraction()
        ));
    }
    if asked.adhesion.is_some() {
        notes.push(
            "the parameters of adhesion are indicators at the shortest wavelength; no area follows from them"
                .to_owned(),
        );
    }
    notes
}

/// Which keys would give more.
pub(crate) fn further_keys(scene: &Scene) -> Option<String> {
    let asked = scene.interface.as_ref();
    let is_missing = |has: Option<bool>| !has.unwrap_or(false);
    let keys = [
        (asked.is_none(), "[interface] (mean gap and stiffness)"),
        (
            is_missing(asked.map(|asked| asked.conductivities.is_some())),
            "thermal_conductivity of [material] and [counterface] (heat)",
        ),
        (is_missing(asked.map(|asked| asked.resistivities.is_some())), "resistivity of both (current)"),
        (is_missing(asked.map(|asked| asked.seal.is_some())), "[seal] (leaks)"),
        (
            is_missing(asked.map(|asked| asked.shear_strength_pa.is_some())),
            "interface.shear_strength (friction)",
        ),
        (is_missing(asked.map(|asked| asked.adhesion.is_some())), "interface.work_of_adhesion (adhesion)"),
    ];
    let missing: Vec<&str> = keys.iter().filter(|(is_missing, _)| *is_missing).map(|(_, key)| *key).collect();
    (!missing.is_empty())
        .then(|| format!("More of what the contact does is told where the scene has {}.", listed(&missing)))
}
