//! Options of a model that it ignores.

use study::models::{self, Choice, IgnoredReason, ModelEntry, ModelOptions};

use crate::option::{OptionName, Reason, UnusedOption};

/// Refuses the first option that a model ignores.
pub(crate) fn check(
    options: &ModelOptions,
    entry: &'static ModelEntry,
    has_strength_cap: bool,
) -> Result<(), UnusedOption> {
    if let Some(ignored) = options.ignored_by(entry).first() {
        return Err(UnusedOption {
            option: OptionName::of_choice(ignored.choice),
            why: reason(ignored.choice, ignored.reason, entry),
        });
    }
    match options.reason_to_ignore_strength_cap(entry).filter(|_| has_strength_cap) {
        None => Ok(()),
        Some(why) => {
            Err(UnusedOption { option: OptionName::StrengthCap, why: reason(Choice::Strength, why, entry) })
        }
    }
}

fn reason(choice: Choice, why: IgnoredReason, entry: &'static ModelEntry) -> Reason {
    let others = models::of_framework(entry.framework).filter(|other| other.has(choice));
    let models: Vec<&'static str> = others.map(|other| other.name).collect();
    let model = entry.name;
    match why {
        IgnoredReason::NoSuchOption if models.is_empty() => Reason::Model(model),
        IgnoredReason::NoSuchOption => Reason::OnlyOn { model, models },
        // Statistical and stacked models that yield are named.
        IgnoredReason::NeverYields
            if choice == Choice::StrainGradient && !entry.framework.takes_hardness() =>
        {
            Reason::OnlyOn { model, models }
        }
        IgnoredReason::NeverYields => Reason::DoesNotYield(model),
        IgnoredReason::CorrectionsAreElastic => Reason::CorrectionsAreElastic(model),
        IgnoredReason::OtherHardnessLaw => Reason::OtherHardnessLaw(model),
        IgnoredReason::NothingGrows if entry.framework.takes_hardness() => Reason::HardnessDoesNotGrow(model),
        IgnoredReason::NothingGrows => Reason::StrengthDoesNotGrow,
    }
}
