//! The meaning for the interface: gap, stiffness, heat, current, leaks, friction and adhesion, as far as inputs are given.

use maud::{Markup, PreEscaped, html};

use super::{SceneReport, Section, per_scene, row_group, sentence, table};
use crate::interface_figure::{gap_against_load, loops_of_loads};
use crate::listing::capital;
use crate::uncertainty_words::level;
use crate::{chart, interface_words};
use study::interface::InterfaceStates;
use study::interface::Slot;
use units::display::typeset;

pub(super) fn section(scenes: &[SceneReport<'_>]) -> Option<Section> {
    let body = per_scene(scenes, of)?;
    Some(Section { id: "meaning", title: "The interface", gist: String::new(), body })
}

fn of(report: &SceneReport<'_>) -> Option<Markup> {
    if report.scene.needs.curves.is_empty() && report.scene.interface.is_none() {
        return None;
    }
    let found = report.scene.interface_states(report.results);
    let further = interface_words::further_keys(report.scene);
    Some(html! {
        @if let Some(states) = &found {
            @for note in interface_words::notes(states, report.scene, report.evidence.uncertainty) { p { (typeset(&capital(&note))) "." } }
            (quantities(report, states))
            (gap(report, states))
            (shear(report, states))
        }
        @if let Some(further) = further { p { (typeset(&further)) } }
    })
}

fn quantities(report: &SceneReport<'_>, states: &InterfaceStates<'_>) -> Markup {
    let uncertainty = report.evidence.uncertainty;
    let mut columns = ["nominal pressure", "quantity", "value"].map(str::to_owned).to_vec();
    columns.extend(uncertainty.map(level));
    let values: Vec<(Slot, f64)> = states
        .slots()
        .into_iter()
        .filter_map(|slot| Some((slot, states.value(slot).ok().flatten()?)))
        .collect();
    let cells = |(slot, value): &(Slot, f64)| {
        html! {
            td {
                (slot.quantity.words())
                @if let Some(curve) = slot.curve { ", " span.curve { (report.curve(curve)) } }
            }
            td { (typeset(&interface_words::value(slot.quantity, *value))) }
            @if let Some(uncertainty) = uncertainty {
                td { (typeset(&interface_words::ends(*slot, uncertainty).unwrap_or_default())) }
            }
        }
    };
    let load = |slot: Slot| slot.load.map_or("any".to_owned(), |load| report.load(load));
    let body = html! {
        @for of_load in values.chunk_by(|(one, _), (other, _)| one.load == other.load) {
            (row_group(&load(of_load[0].0), of_load, cells))
        }
    };
    table(
        "Quantities of the interface. Gap and stiffness are those of Persson’s elastic theory; conductances follow from the stiffness by \
         Barber’s analogy, friction from the areas of the curves, and the response to a tangential load from the stiffness.",
        &columns,
        &body,
    )
}

fn gap(report: &SceneReport<'_>, states: &InterfaceStates<'_>) -> Markup {
    let Some(figure) = gap_against_load(states, report.scene, report.evidence.uncertainty) else {
        return html! {};
    };
    let words = format!("{} against {}", figure.y_label, figure.x_label);
    html! {
        figure {
            div.panels { div { (PreEscaped(chart::element(&figure, &[&figure], &words))) } }
            figcaption {
                strong { "Mean gap against load." } " The whole theory, and the law u" sub { "0" } " ln(p" sub { "00" }
                "/p) that light loads follow; the loads of the scene with their intervals."
            }
        }
    }
}

fn shear(report: &SceneReport<'_>, states: &InterfaceStates<'_>) -> Markup {
    let Some(figure) = loops_of_loads(states, report.scene) else { return html! {} };
    let words = format!("{}: {} against {}", figure.title, figure.y_label, figure.x_label);
    html! {
        figure {
            div.panels { div { (PreEscaped(chart::element(&figure, &[&figure], &words))) } }
            figcaption {
                strong { (sentence(&figure.title)) } " First loading, and the cycle between both signs of the load; the area that it \
                encloses is the energy lost per cycle."
            }
        }
    }
}
