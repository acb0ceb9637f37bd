//! Publications that an answer rests on, to be cited with it.

use judge::Reference;
use serde::Serialize;
use study::growth_law::GrowthLaw;
use study::interface::InterfaceStates;

use super::evidence::Evidence;
use super::load_answer::AnswerUnderLoad;

/// Boundary elements: the equations and how they are solved.
const ELEMENTS: &str = "Westergaard (1939), J. Appl. Mech. 6:A49; Stanley & Kato (1997), J. Tribol. 119:481; Polonsky & Keer (1999), Wear \
                        231:206";
/// Elements that yield.
const YIELDING: &str = "Almqvist et al. (2007), Tribol. Int. 40:574";
/// A strength that grows at small scales.
const GROWING: &str = "Nix & Gao (1998), J. Mech. Phys. Solids 46:411";

/// A publication and what it is cited for.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Publication {
    /// Name of the curve or the quantity that it is cited for, or `boundary elements`.
    pub used_for: String,
    /// Authors, year and place.
    pub publication: &'static str,
}

/// Lists the publications of the elements, of all models that ran, and of the quantities of the interface.
pub(crate) fn publications(
    evidence: &Evidence<'_>,
    loads: &[AnswerUnderLoad],
    states: Option<&InterfaceStates<'_>>,
) -> Vec<Publication> {
    let mut found: Vec<Publication> = Vec::new();
    let mut add = |used_for: &str, publication: &'static str| {
        if found.iter().all(|one| one.publication != publication) {
            found.push(Publication { used_for: used_for.to_owned(), publication });
        }
    };
    let references = || loads.iter().flat_map(|load| &load.references).map(|group| group.reference);
    if references().next().is_some() {
        add("boundary elements", ELEMENTS);
    }
    if references().any(|reference| matches!(reference, Reference::Yielding { .. })) {
        add("boundary elements that yield", YIELDING);
    }
    for curve in &evidence.scene.needs.curves {
        let model = &curve.model;
        add(&curve.name, model.entry.citation);
        // Powers and tables have no publication.
        if model.strength_grows() && matches!(model.options().hardness_law, None | Some(GrowthLaw::NixGao)) {
            add("strength that grows at small scales", GROWING);
        }
    }
    for quantity in states.iter().flat_map(|states| states.slots()).map(|slot| slot.quantity) {
        quantity.publication().into_iter().for_each(|publication| add(quantity.words(), publication));
    }
    found
}
