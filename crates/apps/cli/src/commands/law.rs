//! `law`: pressure against overclosure for finite elements.

use contact_law::{ContactLawError, Heading, SamplingError};
use report::gap_words;
use report::provenance::provenance;
use study::gap_law::GapError;
use study::plan::Tolerance;
use tables::Format;

use super::material_options::material;
use super::{Context, gap, say_doubts, say_notes, say_surface};
use crate::args::{LawArgs, LawForm};
use crate::failure::Failure;
use crate::material_errors;
use crate::timings::Timings;
use findings::doubts::Doubt;

pub(super) fn run(args: &LawArgs, context: &Context<'_>) -> Result<(), Failure> {
    if context.shared.format == Format::Json {
        return Err(Failure::input(
            "--format json has no bearing on `law`, which writes what --dialect says; leave it out",
        ));
    }
    gap::refuse_idle_options(&args.choices, args.model)?;
    let material = material(&args.choices.material)?;
    say_doubts(Doubt::of_material(&material));
    let pascals = |pressure| {
        material
            .nominal_pressure(pressure)
            .map(|pressure| pressure.pa())
            .map_err(|error| Failure::Input(format!("--pressure-range: {}", material_errors::told(&error))))
    };
    let [from, to] = args.pressure_range.map(pascals);
    let range_pa = [from?, to?];
    let mut timings = Timings::start();
    let surface = gap::load(&args.psd, &args.reading, &args.choices, context)?;
    timings.lap("reading");
    say_surface(&surface);
    let law = gap::law(args.model, &args.choices, Tolerance::default(), &material, &surface)?;
    say_notes(gap_words::of_law(&law, range_pa[0], gap::BY_SURFACE));
    let mut origin = provenance(context.typed, &surface, args.choices.sampling.sampling());
    origin.push(format!("{}: {}", args.model.full_name, args.model.citation));
    let heading = Heading { provenance: origin, name: args.name.clone() };
    let text = match args.form {
        LawForm::Table => {
            let sampled = law.sampled(range_pa, args.error)?;
            args.dialect.table(&sampled, args.units, &heading, &[])?
        }
        LawForm::Exponential => {
            let exponential = law.exponential(gap_words::LIGHT_LOADS_SHARE).ok_or_else(|| {
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
