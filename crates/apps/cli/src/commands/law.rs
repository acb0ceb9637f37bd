//! `law`: pressure against overclosure for finite elements.

use contact_law::{ContactLawError, Heading, SamplingError};
use questions::{FoundLaw, LIGHT_LOADS_SHARE, LawQuestion};
use report::provenance::provenance;
use study::gap_law::GapError;
use tables::Format;

use super::{Context, say_all};
use crate::args::{LawArgs, LawForm};
use crate::failure::Failure;
use crate::flags::Flags;
use crate::progress::Unseen;
use crate::timings::Timings;

pub(super) fn run(args: &LawArgs, context: &Context<'_>) -> Result<(), Failure> {
    if context.shared.format == Format::Json {
        return Err(Failure::input(
            "--format json has no bearing on `law`, which writes what --dialect says; leave it out",
        ));
    }
    let [from, to] = args.pressure_range;
    let question = LawQuestion { by: args.choices.input(Some(args.model)), from, to };
    question.check()?;
    let mut timings = Timings::start();
    let surface = context.load(&args.psd, &args.reading, None)?;
    timings.lap("reading");
    let found = question.answer(&surface, &Unseen)?;
    say_all(&found.notes, &Flags);
    let FoundLaw { law, range_pa, .. } = found;
    let mut origin = provenance(context.typed, &surface, question.by.sampling.sampling());
    origin.push(format!("{}: {}", args.model.full_name, args.model.citation));
    let heading = Heading { provenance: origin, name: args.name.clone() };
    let text = match args.form {
        LawForm::Table => {
            let sampled = law.sampled(range_pa, args.error)?;
            args.dialect.table(&sampled, args.units, &heading, &[])?
        }
        LawForm::Exponential => {
            let exponential = law.exponential(LIGHT_LOADS_SHARE).ok_or_else(|| {
                Failure::Input(format!(
                    "--form exponential is the law of light loads of Persson's theory, and --model {} has none; take the \
                     table",
                    args.model
                ))
            })?;
            args.dialect.exponential(&exponential, args.units, &heading)?
        }
    };
    timings.lap("computing");
    context.targets(None)?;
    context.shared.output.write(|out| out.write_all(text.as_bytes()))?;
    timings.lap("writing");
    timings.report(context.shared.timings);
    Ok(())
}

impl From<SamplingError<GapError>> for Failure {
    fn from(error: SamplingError<GapError>) -> Self {
        Failure::input(error)
    }
}

impl From<ContactLawError> for Failure {
    fn from(error: ContactLawError) -> Self {
        Failure::input(error)
    }
}
