//! The quantities of an interface in words.

use interface::conductance::{ELECTRON_MEAN_FREE_PATH_M, MOST_PLASTIC_SHARE, PressureRatio};
use interface::sealed_fluid::SealedFluid;
use interface::tangential::NOTICEABLE_MISMATCH;
use persson::Band;
use persson::sealing::PercolationThreshold;
use questions::remarks_on_separation;
use scene::Scene;
use study::interface::InterfaceStates;
use study::interface::{Quantity, Seal, Slot};
use uncertainty::Uncertainty;
use units::display::{energy_per_area, length, percent, pressure, share, three_digits};
use units::{Remark, RemarkCode, SceneKeys};

use crate::listing::listed;

/// The size of an atom \[m\]: surfaces nearer than this touch.
const ATOM_M: f64 = 0.3e-9;

/// A value with its unit: `2.31 um`.
pub(crate) fn value(quantity: Quantity, value: f64) -> String {
    match quantity.unit() {
        "m" => length(value),
        "Pa" => pressure(value),
        "J/m²" => energy_per_area(value),
        "" if quantity == Quantity::StuckAreaFraction => share(value),
        "" => three_digits(value),
        unit => format!("{} {unit}", three_digits(value)),
    }
}

/// Both ends of an interval: `2.1 um to 2.5 um`; `None` if no uncertain input changes the value.
pub(crate) fn ends(slot: Slot, uncertainty: &Uncertainty) -> Option<String> {
    let found = uncertainty.quantity(slot).filter(|interval| interval.low < interval.high)?;
    range(slot.quantity, found.low, found.high)
}

/// A range with its unit: `2.1 um to 2.5 um`, `1.1 to 1.4 S/m²`; `None` if both ends print alike.
pub(crate) fn range(quantity: Quantity, low: f64, high: f64) -> Option<String> {
    let [from, to] = [low, high].map(|end| value(quantity, end));
    let from = match quantity.unit() {
        "m" | "Pa" | "J/m²" | "" => from.as_str(),
        unit => from.trim_end_matches(unit).trim_end(),
    };
    (low < high && value(quantity, low) != to).then(|| format!("{from} to {to}"))
}

/// Limits of the numbers, a sentence each.
pub(crate) fn notes(
    states: &InterfaceStates<'_>,
    scene: &Scene,
    uncertainty: Option<&Uncertainty>,
) -> Vec<String> {
    let asked = states.request;
    let mut notes = of_the_gap(states, scene);
    if asked.conductivities.is_some() || asked.resistivities.is_some() {
        notes.push(format!(
            "conductances assume clean bodies (no films) and contact spots wider than the mean free path of the carriers, about {} \
             for electrons in a good metal",
            length(ELECTRON_MEAN_FREE_PATH_M)
        ));
    }
    let caution = asked.gas.as_ref().and_then(|gas| gas.caution(states.rms_height_m()));
    notes.extend(caution.map(str::to_owned));
    if asked.conductivities.is_some() && scene.hardness_pa().is_some() {
        notes.extend(of_flowed_peaks(states, scene));
    }
    if let Some(seal) = &asked.seal {
        notes.extend(of_the_seal(states, scene, seal, uncertainty));
    }
    let softer_pa = scene.material.as_ref().and_then(|material| material.yield_strength_pa());
    if let (Some(shear_pa), Some(yield_pa)) = (asked.shear_strength_pa, softer_pa)
        && shear_pa > yield_pa / 3f64.sqrt()
    {
        notes.push(format!(
            "the shear strength of {} exceeds that of the softer body, S₀/√3 = {}, which would shear instead",
            pressure(shear_pa),
            pressure(yield_pa / 3f64.sqrt())
        ));
    }
    if asked.shear.is_some() {
        notes.extend(of_shear(states, scene));
    }
    if asked.adhesion.is_some() {
        notes.push(
            "the adhesion parameters are indicators at the shortest wavelength and need not agree; no area follows from them"
                .to_owned(),
        );
    }
    notes
}

/// The labels of the loads for which `remark` returns a text, each followed by the text.
fn loads_where(scene: &Scene, remark: impl Fn(usize) -> Option<String>) -> Option<String> {
    let label = |load: usize| Some(format!("{}{}", scene.needs.loads[load].label, remark(load)?));
    let labels: Vec<String> = (0..scene.needs.loads.len()).filter_map(label).collect();
    (!labels.is_empty()).then(|| listed(&labels.iter().map(String::as_str).collect::<Vec<_>>()))
}

/// An empty text for a label alone, if the condition holds.
fn alone(holds: bool) -> Option<String> {
    holds.then(String::new)
}

/// The loads at which gap and stiffness mean little: yielding, few asperities, less than an atom.
fn of_the_gap(states: &InterfaceStates<'_>, scene: &Scene) -> Vec<String> {
    let loads = &scene.needs.loads;
    let least_pa = loads.iter().map(|load| load.nominal_pressure_pa()).fold(f64::INFINITY, f64::min);
    let light = states.light_loads();
    let mut notes = light.map_or_else(Vec::new, |light| {
        let remarks = remarks_on_separation(&light, states.roughness(), states.rms_height_m(), least_pa);
        // Peaks that flow are nearer.
        let least_gaps = states.mean_gap_under_m(least_pa).unwrap_or(0.0) / states.rms_height_m();
        let counts = |remark: &&Remark| remark.number("few_touch").is_none_or(|few| least_gaps > few);
        remarks.iter().filter(counts).map(|remark| remark.words(&SceneKeys)).collect()
    });
    if states.request.band == Band::Profile {
        notes.push(Remark::new(RemarkCode::WavesOfProfiles).words(&SceneKeys));
    }
    let is_all_flowed = |load: usize| {
        states.inputs.hardness_pa.is_some_and(|hardness_pa| loads[load].nominal_pressure_pa() >= hardness_pa)
    };
    let all = loads_where(scene, |load| alone(is_all_flowed(load)));
    notes.extend(all.map(|loads| {
        format!("at {loads} the load exceeds the hardness: everything touches and flows, no gap is left, and stiffness, heat and current have \
                 no limit")
    }));
    let plastic = loads_where(scene, |load| {
        let share =
            states.plastic_share(load).filter(|share| *share > MOST_PLASTIC_SHARE && !is_all_flowed(load))?;
        Some(format!(" ({} of the contact, by a theory that overstates it)", percent(share)))
    });
    notes.extend(plastic.map(|loads| match states.leaves_out_yielding() {
        true => format!(
            "the contact yields at {loads}: gap, stiffness and what follows from them are those of elastic peaks, an order of \
             magnitude there"
        ),
        false => format!(
            "the contact yields at {loads}: gap, stiffness, heat and current are those of peaks that have flowed, the stiffness on \
             unloading"
        ),
    }));
    let below_atoms = loads_where(scene, |load| {
        let slot = Slot { quantity: Quantity::MeanGap, load: Some(load), curve: None };
        alone(states.value(slot).ok().flatten().is_none_or(|gap_m| gap_m < ATOM_M))
    });
    notes.extend(below_atoms.map(|loads| {
        format!(
            "at {loads} the mean gap is below the size of an atom, {}: treat it as closed",
            length(ATOM_M)
        )
    }));
    notes
}

/// The cutoff that the correlations for flowed peaks depend on, and the loads outside their range.
fn of_flowed_peaks(states: &InterfaceStates<'_>, scene: &Scene) -> Vec<String> {
    let slope = states.mean_absolute_slope().ok().map(|slope| {
        format!(
            "the correlations for flowed peaks use the mean absolute slope at {}, {}: both grow with every shorter wavelength, \
             unlike Barber’s analogy",
            length(states.inputs.results.psd.shortest_wavelength_m()),
            three_digits(slope)
        )
    });
    let outside = loads_where(scene, |load| {
        let ratio = states.pressure_ratio(load).ok().flatten()?;
        alone(!ratio.is_fitted())
    });
    let [least, most] = PressureRatio::FITTED;
    let outside = outside.map(|loads| {
        format!(
            "at {loads} the pressure over the hardness is outside {least:e} to {most}, the range of these correlations"
        )
    });
    slope.into_iter().chain(outside).collect()
}

/// Assumptions of a tangential load, and the loads under which everything slides.
fn of_shear(states: &InterfaceStates<'_>, scene: &Scene) -> Vec<String> {
    let assumed = "the tangential load acts in one direction on a constant normal load, without adhesion; displacement and stiffness are \
                   those of the roughness on flat faces, in excess of smooth bodies";
    let sliding = states.sliding_loads();
    let slides = loads_where(scene, |load| alone(sliding.contains(&load)));
    let slides = slides.map(|loads| {
        format!("at {loads} the tangential load reaches friction times pressure, and everything slides")
    });
    let coupled = states.coupling().filter(|mismatch| mismatch.abs() > NOTICEABLE_MISMATCH);
    std::iter::once(assumed.to_owned()).chain(slides).chain(coupled.map(coupled_tractions)).collect()
}

/// Dundurs' beta, which superposition leaves out.
fn coupled_tractions(mismatch: f64) -> String {
    Remark::new(RemarkCode::CoupledTractions).with("mismatch", mismatch).words(&SceneKeys)
}

/// Assumptions of a seal.
fn of_the_seal(
    states: &InterfaceStates<'_>,
    scene: &Scene,
    seal: &Seal,
    uncertainty: Option<&Uncertainty>,
) -> Vec<String> {
    let threshold = seal.threshold.area_fraction();
    let mut notes = vec![format!(
        "channels close when {} of the area touches; the area of the seal comes from a fit to boundary elements, not from the curves",
        percent(threshold)
    )];
    notes.extend(seal.joint.map(|_| {
        "the leak rate is that of an effective medium of all gaps; its range holds flow solved through the gaps of boundary elements, on \
         single pieces of the surface four of its longest waves wide"
            .to_owned()
    }));
    let is_usual = seal.threshold == PercolationThreshold::SIMULATED;
    notes.extend(seal.joint.filter(|_| !is_usual).map(|_| {
        format!(
            "that range was found with channels that close at {}",
            percent(PercolationThreshold::SIMULATED.area_fraction())
        )
    }));
    let longest_m = states.longest_wave_m();
    let narrow = seal.joint.filter(|joint| joint.is_narrow(longest_m));
    notes.extend(narrow.map(|joint| {
        format!(
            "only {} of the longest waves, {}, fit into the seal: a single valley may decide, and the range is wider for it",
            three_digits(joint.waves(longest_m)),
            length(longest_m)
        )
    }));
    notes.extend(seal.joint.map(|_| {
        "the leak rate is that of roughness without a lay: with waves four times as long along the lay, 1.4 to 2 times as much leaks \
         along it, and a fourth to a twentieth across"
            .to_owned()
    }));
    let is_bowed = seal.joint.is_some() && states.request.flatness.is_some();
    notes.extend(is_bowed.then(|| {
        "faces that are not flat leak around their contact: the high end of the leak rate is what the open gap lets through".to_owned()
    }));
    notes.extend(seal.joint.map(|joint| *joint.fluid()).and_then(|fluid| match fluid {
        SealedFluid::Gas(gas) => Some(format!("the leak rate is that of {} at the pressure of the outlet", gas.gas)),
        _ if fluid.is_unnamed_gas() => Some(
            "the viscosity is that of a gas, which expands and slips: give gas = \"air\", say, in place of it".to_owned(),
        ),
        SealedFluid::Incompressible { .. } => None,
    }));
    let slips = loads_where(scene, |load| {
        let (joint, gaps) = seal.joint.zip(states.seal_conductance(load))?;
        let times = joint.fluid().notable_slip(joint.pressure_drop_pa(), gaps.medium_m3.cbrt())?;
        Some(format!(" ({} times as much)", three_digits(times)))
    });
    notes.extend(
        slips.map(|loads| format!("the gas slips at the walls of the gaps, and that is counted: at {loads}")),
    );
    let sometimes = loads_where(scene, |load| {
        let share = uncertainty?.share_open(load).filter(|share| *share > 0.0 && *share < 1.0)?;
        Some(format!(" ({})", percent(share)))
    });
    notes.extend(sometimes.map(|loads| {
        format!(
            "a channel is open in some draws only at {loads}; the others leak nothing, and have no wavelength and height of a channel"
        )
    }));
    let at_the_end = loads_where(scene, |load| {
        let slot = Slot { quantity: Quantity::ChannelWavelength, load: Some(load), curve: None };
        alone(states.value(slot).ok().flatten()? > 0.5 * longest_m)
    });
    notes.extend(at_the_end.map(|loads| {
        format!(
            "at {loads} the last channel is as wide as the longest wave of the spectrum, {}: wider channels may decide",
            length(longest_m)
        )
    }));
    notes
}

/// The keys of a scene that would add quantities.
pub(crate) fn further_keys(scene: &Scene) -> Option<String> {
    let asked = scene.interface.as_ref();
    let is_missing = |has: Option<bool>| !has.unwrap_or(false);
    let keys = [
        (asked.is_none(), "[interface] (mean gap and stiffness)"),
        (
            is_missing(asked.map(|asked| asked.conductivities.is_some())),
            "thermal_conductivity of [material] and [counterface] (heat)",
        ),
        (is_missing(asked.map(|asked| asked.gas.is_some())), "interface.gas (heat through gas)"),
        (is_missing(asked.map(|asked| asked.resistivities.is_some())), "resistivity of both (current)"),
        (is_missing(asked.map(|asked| asked.seal.is_some())), "[seal] (leaks)"),
        (
            is_missing(asked.map(|asked| asked.shear_strength_pa.is_some())),
            "interface.shear_strength (friction)",
        ),
        (
            is_missing(asked.map(|asked| asked.shear.is_some())),
            "interface.friction and share_of_sliding (tangential load)",
        ),
        (is_missing(asked.map(|asked| asked.adhesion.is_some())), "interface.work_of_adhesion (adhesion)"),
    ];
    let missing: Vec<&str> = keys.iter().filter(|(is_missing, _)| *is_missing).map(|(_, key)| *key).collect();
    (!missing.is_empty()).then(|| format!("For more quantities, add to the scene: {}.", listed(&missing)))
}
