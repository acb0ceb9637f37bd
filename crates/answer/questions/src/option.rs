//! Options of questions. An option has the name of its key in a scene; a front end spells it in its own way.

use units::{Remark, RemarkCode};

/// Refuses the first option of a list that is given, for the reason in a remark.
pub(crate) fn first_given(
    options: impl IntoIterator<Item = (&'static str, bool)>,
    reason: Remark,
) -> Result<(), Box<Remark>> {
    match options.into_iter().find(|(_, is_given)| *is_given) {
        Some((option, _)) => Err(Box::new(reason.on(option))),
        None => Ok(()),
    }
}

/// The reason that a model has no such option.
pub(crate) fn not_of_model(model: &'static str) -> Remark {
    Remark::new(RemarkCode::NoSuchOption).with("model", model)
}
