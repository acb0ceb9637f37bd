//! `law`: pressure against overclosure, and conductance against pressure, for finite elements.

use interface::finite_elements::Heading;
use questions::{LawAnswer, LawForm};
use report::provenance::provenance;
use tables::Format;
use units::display::pressure;
use units::{Remark, RemarkCode};

use super::{Context, say_all};
use crate::args::LawArgs;
use crate::failure::Failure;
use crate::flags::{Flags, refuse_first};
use crate::progress::Progress;
use crate::timings::Timings;

pub(super) fn run(args: &LawArgs, context: &Context<'_>) -> Result<(), Failure> {
    if context.shared.format() == Format::Json {
        return Err(Failure::input(
            "--format json does not affect `law`, which writes what --dialect says; leave it out",
        ));
    }
    let question = args.question();
    question.check()?;
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
    let text = match question.answer(&surface, &progress)? {
        LawAnswer::Pressure(found) => {
            progress.aside(|| say_all(&found.notes, &Flags));
            origin.extend(found.description(&Flags));
            let name = args.name.as_deref().unwrap_or(Heading::NAME).to_owned();
            let mut heading = Heading { provenance: origin, name };
            match args.form.unwrap_or(LawForm::Table) {
                LawForm::Table => {
                    let sampled = found.sampled(args.error, &progress)?;
                    args.dialect.table(&sampled, args.units, &heading, &[])?
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
        LawAnswer::Conductance(found) => {
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
