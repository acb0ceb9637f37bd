//! Options as the command line writes them.

use questions::QuestionError;
use report::question_words;
use units::{Remark, Spelling};

use crate::failure::Failure;

/// Flags, as `--interference-law`.
pub(crate) struct Flags;

/// Flags of `persson`, whose models are called `elastic` and `elastic-plastic`.
pub(crate) struct PerssonFlags;

impl Spelling for Flags {
    fn option(&self, option: &str) -> String {
        match option {
            "missing_points" => "--gaps".to_owned(),
            "reading" => "an option for reading spectra".to_owned(),
            "side" => "--box".to_owned(),
            "counterface_surface" => "--counterface-scans".to_owned(),
            "strain_gradient" => "--strain-gradient-length".to_owned(),
            option => format!("--{}", option.replace('_', "-")),
        }
    }

    fn with_value(&self, option: &str, value: &str) -> String {
        format!("{} {value}", self.option(option))
    }

    fn model(&self, name: &str) -> String {
        format!("--model {name}")
    }
}

impl Spelling for PerssonFlags {
    fn option(&self, option: &str) -> String {
        Flags.option(option)
    }

    fn with_value(&self, option: &str, value: &str) -> String {
        Flags.with_value(option, value)
    }

    fn model(&self, name: &str) -> String {
        Flags.model(if name == "persson" { "elastic" } else { "elastic-plastic" })
    }
}

/// Refuses the first option of a list that is given, for the reason in a remark.
pub(crate) fn refuse_first(
    options: impl IntoIterator<Item = (&'static str, bool)>,
    reason: Remark,
) -> Result<(), Failure> {
    match options.into_iter().find(|(_, is_given)| *is_given) {
        None => Ok(()),
        Some((option, _)) => Err(Failure::Input(reason.on(option).words(&Flags))),
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
