//! Options of a model that it ignores.

use study::models::{ModelEntry, ModelOptions};
use units::Remark;

/// Refuses the first option that a model ignores.
pub(crate) fn check(
    options: &ModelOptions,
    entry: &'static ModelEntry,
    has_strength_cap: bool,
) -> Result<(), Box<Remark>> {
    let of_cap = || options.ignored_strength_cap(entry).filter(|_| has_strength_cap);
    let ignored = options.ignored_by(entry).into_iter().next().or_else(of_cap);
    ignored.map_or(Ok(()), |ignored| Err(Box::new(ignored)))
}
