//! `law`: pressure against overclosure, and conductance against pressure, for finite elements.

mod lubrication;

use interface::finite_elements::{Dialect, Heading};
use questions::{ElementsLawAnswer, ElementsLawQuestion, LawAnswer, LawForm, PlasticCorrelation};
use report::provenance::provenance;
use tables::Format;
use units::display::pressure;
use units::{Remark, RemarkCode};

use super::{Context, say_all};
use crate::args::LawArgs;
use crate::failure::Failure;
use crate::flags::{Flags, refuse_first};
use crate::memory;
use crate::progress::Progress;
use crate::timings::Timings;

/// The answer of a model, or of boundary elements.
enum Answer {
    Model(LawAnswer),
    Elements(ElementsLawAnswer),
}

pub(super) fn run(args: &LawArgs, context: &Context<'_>) -> Result<(), Failure> {
    if context.shared.format() == Format::Json {
        return Err(Failure::input(
            "--format json does not affect `law`, which writes what --dialect says; leave it out",
        ));
    }
    let Some(quantity) = args.quantity.0 else { return lubrication::run(args, context) };
    let other = Remark::new(RemarkCode::OtherQuantity).with("quantity", quantity.name());
    refuse_first(args.of_lubrication(), other)?;
    let (question, elements) = (args.question(), args.elements());
    elements.as_ref().map_or_else(|| question.check(), ElementsLawQuestion::check)?;
    memory::refuse_beyond(args.random.grid)?;
    if elements.is_none() {
        let name = question.law.by.model.map(|entry| entry.name);
        let name = name.or(question.correlation.map(PlasticCorrelation::name)).unwrap_or_default();
        let reason = Remark::new(RemarkCode::NoSuchOption).with("model", name).with("models", "bem");
        refuse_first(args.random.input().given(), reason)?;
    }
    if let Some(correlation) = question.correlation {
        let bodies = &args.choices.material.bodies;
        let (modulus, ratio) = (bodies.youngs_modulus.is_some(), bodies.poisson_ratio.is_some());
        let other = bodies.counterface.counterface_youngs_modulus.is_some();
        let constants =
            [("youngs_modulus", modulus), ("poisson_ratio", ratio), ("counterface_youngs_modulus", other)];
        refuse_first(constants, Remark::new(RemarkCode::NoSuchOption).with("model", correlation.name()))?;
    }
    let mut timings = Timings::start();
    let surface = context.load(&args.psd.psd, &args.psd.reading, None)?;
    timings.lap("reading");
    let progress = Progress::counting("states");
    let mut origin = provenance(context.typed, &surface, question.law.by.sampling.sampling());
    let name = args.name.as_deref().unwrap_or(Heading::NAME).to_owned();
    let answer = match &elements {
        Some(elements) => Answer::Elements(elements.answer(&surface, &progress)?),
        None => Answer::Model(question.answer(&surface, &progress)?),
    };
    let text = match answer {
        Answer::Elements(ElementsLawAnswer::Pressure(law)) => {
            progress.aside(|| say_all(&law.notes, &Flags));
            origin.extend(law.description(&Flags));
            let (sampled, mut columns) = law.sampled(args.error, args.units)?;
            columns.retain(|_| args.dialect == Dialect::Csv);
            args.dialect.table(&sampled, args.units, &Heading { provenance: origin, name }, &columns)?
        }
        Answer::Model(LawAnswer::Pressure(found)) => {
            progress.aside(|| say_all(&found.notes, &Flags));
            origin.extend(found.description(&Flags));
            let mut heading = Heading { provenance: origin, name };
            match args.form.unwrap_or(LawForm::Table) {
                LawForm::Table => {
                    let sampled = found.sampled(args.error, &progress)?;
                    let mut columns = found.columns(&sampled, args.units);
                    columns.retain(|_| args.dialect == Dialect::Csv);
                    args.dialect.table(&sampled, args.units, &heading, &columns)?
                }
                LawForm::Exponential => {
                    let (law, remark) = found.exponential(args.error)?;
                    let [from, to] = found.range_pa.map(pressure);
                    heading.provenance.push(format!("pressures of interest: {from} to {to}"));
                    let text = args.dialect.exponential(&law, args.units, &heading)?;
                    progress.aside(|| say_all(remark.as_slice(), &Flags));
                    text
                }
            }
        }
        Answer::Model(LawAnswer::Conductance(found))
        | Answer::Elements(ElementsLawAnswer::Conductance(found)) => {
            progress.aside(|| say_all(&found.notes, &Flags));
            origin.extend(found.description(&Flags));
            found.sampled(args.error, &progress)?.to_text(args.dialect, args.units, &origin)?
        }
    };
    drop(progress);
    timings.lap("computing");
    context.print(&text)?;
    timings.lap("writing");
    timings.report(context.shared.timings);
    Ok(())
}
