//! The pressed surface on the first screen: what touches at the chosen load.

use conclusions::AnswerUnderLoad;
use judge::{PressedSurface, SeenContact};
use maud::{Markup, PreEscaped, html};
use units::display::{length, share, typeset};

use super::SceneReport;
use crate::chart::contact::picture;

/// With fewer points in contact their share says little.
const MIN_POINTS: f64 = 200.0;

/// Makes the picture of the loads that were pressed, each in a group of the class that `class_of` gives it; `None` if none was.
pub(super) fn contact_picture(
    report: &SceneReport<'_>,
    loads: &[AnswerUnderLoad],
    class_of: impl Fn(&AnswerUnderLoad) -> String,
) -> Option<Markup> {
    let surface = report.evidence.judgement?.surface.as_ref()?;
    let seen: Vec<(&AnswerUnderLoad, Option<&SeenContact>)> = loads
        .iter()
        .map(|load| (load, surface.contacts.iter().find(|contact| contact.load == load.load)))
        .collect();
    let contacts: Vec<&SeenContact> = seen.iter().filter_map(|(_, contact)| *contact).collect();
    let class_of_load =
        |at: usize| loads.iter().find(|load| load.load == at).map_or_else(String::new, &class_of);
    let drawn = (!contacts.is_empty())
        .then(|| picture(surface, &contacts, class_of_load, &what(surface)))
        .flatten()?;
    Some(html! {
        figure.contact {
            (PreEscaped(drawn))
            @for (load, contact) in &seen {
                figcaption class=(class_of(load)) { (typeset(&caption(surface, *contact, load))) }
            }
        }
    })
}

/// The surface in words.
fn what(surface: &PressedSurface) -> String {
    match &surface.map {
        Some(map) => format!("{map} as scanned"),
        None => "A surface with these waves".to_owned(),
    }
}

/// The caption under a load.
fn caption(surface: &PressedSurface, contact: Option<&SeenContact>, load: &AnswerUnderLoad) -> String {
    let Some(contact) = contact else {
        return format!("{}, not pressed at {}", what(surface), load.label);
    };
    let Some(shortest_m) = surface.shortest_m else {
        return format!("{}, pressed at {}: red touches", what(surface), load.label);
    };
    let area_fraction = contact.area_fraction();
    let has_enough = area_fraction * contact.touching.len() as f64 >= MIN_POINTS;
    let spots = if has_enough { share(area_fraction) } else { "little".to_owned() };
    // The picture is seen before the number, and must not be taken for it.
    let all = match load.area.area_fraction {
        Some(all) => format!("with all waves {}", share(all)),
        None => "finer waves leave less".to_owned(),
    };
    let shortest = length(shortest_m);
    format!(
        "A surface with the waves down to {shortest}, pressed at {}: {spots} touches, red; {all}",
        load.label
    )
}
