//! Options as the command line writes them.

use questions::{OptionName, QuestionError, Spelling};
use report::question_words;
use study::models::Choice;

use crate::failure::Failure;

/// Flags, as `--interference-law`.
pub(crate) struct Flags;

/// Flags of `persson`, whose models are called `elastic` and `elastic-plastic`.
pub(crate) struct PerssonFlags;

impl Spelling for Flags {
    fn option(&self, option: OptionName) -> String {
        let name = match option {
            OptionName::MissingPoints => "gaps",
            OptionName::Reading => return "an option for reading spectra".to_owned(),
            OptionName::Side => "box",
            OptionName::ModelOption(Choice::Hardness) => "hardness-formula",
            OptionName::ModelOption(Choice::StrainGradient) => "strain-gradient-length",
            option => return format!("--{}", option.snake_case().replace('_', "-")),
        };
        format!("--{name}")
    }

    fn with_value(&self, option: OptionName, value: &str) -> String {
        format!("{} {value}", self.option(option))
    }

    fn model(&self, name: &str) -> String {
        format!("--model {name}")
    }
}

impl Spelling for PerssonFlags {
    fn option(&self, option: OptionName) -> String {
        Flags.option(option)
    }

    fn with_value(&self, option: OptionName, value: &str) -> String {
        Flags.with_value(option, value)
    }

    fn model(&self, name: &str) -> String {
        Flags.model(if name == "persson" { "elastic" } else { "elastic-plastic" })
    }
}

/// A question's error as the failure of a command.
pub(crate) fn failure(error: &QuestionError, spelling: &dyn Spelling) -> Failure {
    match error.is_cancelled() {
        true => Failure::Interrupted,
        false => Failure::Input(question_words::error(error, spelling)),
    }
}

impl From<QuestionError> for Failure {
    fn from(error: QuestionError) -> Self {
        failure(&error, &Flags)
    }
}
