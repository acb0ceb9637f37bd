//! `law`: pressure against overclosure for finite elements.

use contact_law::{ContactLawError, Heading};
use questions::{LawForm, LawQuestion};
use report::provenance::provenance;
use tables::Format;

use super::{Context, say_all};
use crate::args::LawArgs;
use crate::failure::Failure;
use crate::flags::Flags;
use crate::progress::Progress;
use crate::timings::Timings;

pub(super) fn run(args: &LawArgs, context: &Context<'_>) -> Result<(), Failure> {
    if context.shared.format() == Format::Json {
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
    let progress = Progress::counting("states");
    let found = question.answer(&surface, &progress)?;
    progress.aside(|| say_all(&found.notes, &Flags));
    let mut origin = provenance(context.typed, &surface, question.by.sampling.sampling());
    origin.push(format!("{}: {}", args.model.full_name, args.model.citation));
    let heading = Heading { provenance: origin, name: args.name.clone() };
    let text = match args.form {
        LawForm::Table => {
            let sampled = found.sampled(args.error, &progress)?;
            args.dialect.table(&sampled, args.units, &heading, &[])?
        }
        LawForm::Exponential => args.dialect.exponential(&found.exponential()?, args.units, &heading)?,
    };
    drop(progress);
    timings.lap("computing");
    context.targets(None)?;
    context.shared.output.write(|out| out.write_all(text.as_bytes()))?;
    timings.lap("writing");
    timings.report(context.shared.timings);
    Ok(())
}

impl From<ContactLawError> for Failure {
    fn from(error: ContactLawError) -> Self {
        Failure::input(error)
    }
}
