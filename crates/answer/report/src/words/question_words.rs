//! Errors of questions in words.

use elements::ElementsError;
use elements::half_space::HalfSpaceError;
use questions::{LawQuantity, QuestionError};
use study::body_properties::BodyProperty;
use study::material::MaterialError;
use units::Spelling;
use units::display::{length, pressure};

use crate::elements_words;

/// An error in words, with the options that mend it.
#[must_use]
pub fn error(error: &QuestionError, spelling: &dyn Spelling) -> String {
    let name = |option: &str| spelling.option(option);
    match error {
        QuestionError::Unused(remark) => remark.words(spelling),
        QuestionError::Missing(options) => {
            let names: Vec<String> = options.iter().map(|option| name(option)).collect();
            format!("{} is needed", names.join(" or "))
        }
        QuestionError::ElasticConstant(option) => {
            format!("{} is needed: every model is at least elastic", name(option))
        }
        QuestionError::Material(error) => of_material(error, spelling),
        QuestionError::Load { option, label, error } => {
            let given = match label {
                Some(label) => spelling.with_value(option, label),
                None => name(option),
            };
            format!("{given}: {}", of_material(error, spelling))
        }
        QuestionError::CutoffBelowData { cutoff_m, shortest_m, surface } => format!(
            "{} leaves nothing out: the shortest wavelength of {surface} is {}; leave it out, or choose a longer one",
            spelling.with_value("cutoff", &length(*cutoff_m)),
            length(*shortest_m)
        ),
        QuestionError::TooManyLines { drawn, lines, most } => {
            format!("{} draws a {drawn}, and {lines} are given; give at most {most}", name("figure"))
        }
        QuestionError::NoLoop => format!(
            "{}: every tangential stress reaches friction times pressure, and what slides has no loop; lower {}",
            name("figure"),
            name("tangential_stress")
        ),
        QuestionError::ConductanceOnly(correlation) => format!(
            "{} has no overclosure, only conductances; add {} or {}",
            spelling.model(correlation.name()),
            spelling.with_value("quantity", LawQuantity::Heat.name()),
            spelling.with_value("quantity", LawQuantity::Current.name())
        ),
        QuestionError::NoExponentialLaw(model) => format!(
            "{} is the law of light loads of Persson's theory, and {} has none; take the table",
            spelling.with_value("form", "exponential"),
            spelling.model(model.name)
        ),
        QuestionError::NotElastic(model) => {
            format!(
                "{} yields, and only elastic contacts are sheared; take persson or bem",
                spelling.model(model.name)
            )
        }
        QuestionError::NoStiffness { pressure_pa } => {
            format!(
                "the model has no stiffness under {}; choose another pressure, or take persson or bem",
                pressure(*pressure_pa)
            )
        }
        QuestionError::FallingStiffness { pressure_pa } => format!(
            "the stiffness of the model falls on the way to {}, which no elastic contact does; lower {}, or take persson or bem",
            pressure(*pressure_pa),
            name("pressure")
        ),
        QuestionError::Value { option, error } => format!("{}: {error}", name(option)),
        QuestionError::SaturationWithoutHardness => format!(
            "{} is given in H, and the material has no hardness: add {} or {}",
            name("saturation"),
            name("indentation_hardness"),
            name("yield_strength")
        ),
        QuestionError::Elements(ElementsError::HalfSpace(HalfSpaceError::CannotBeCarried {
            nominal_pressure_pa,
            saturation_pa,
        })) => elements_words::cannot_be_carried(*nominal_pressure_pa, *saturation_pa),
        error => error.to_string(),
    }
}

/// An error of the material, with the options that mend it.
#[must_use]
pub fn of_material(error: &MaterialError, spelling: &dyn Spelling) -> String {
    let name = |option: &str| spelling.option(option);
    let hardness = || name("indentation_hardness");
    let strength = || name("yield_strength");
    match error {
        MaterialError::Missing(needed_for) => {
            let options = match needed_for.property() {
                BodyProperty::IndentationHardness => format!("{} or {}", hardness(), strength()),
                BodyProperty::YieldStrength => format!("{} or {}", strength(), hardness()),
                _ => name("strain_gradient_length"),
            };
            format!("{error}: give {}{options}", spelling.of_material())
        }
        MaterialError::HardnessOffStrength(_) => {
            format!("{error}: leave out {} or {}", hardness(), strength())
        }
        error => error.to_string(),
    }
}
