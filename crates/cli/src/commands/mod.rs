//! One module per command: from what was typed to a plan, and from its results to the output.

mod asperity_laws;
mod run_scene;
mod spectrum_tables;
mod stacked;

use std::path::Path;

use asperity::ElasticBody;
use spectrum::ReadOptions;

use crate::args::{Args, Command, PsdArgs, SharedArgs};
use crate::failure::Failure;
use crate::output::Place;
use crate::plan::{Needs, Plan, Results, Sampling};
use crate::provenance::provenance;
use crate::quantity::Pressure;
use crate::scene::Overrides;
use crate::surface::Surface;
use crate::table::Table;
use crate::timings::Timings;

/// Carries a command out; `typed` is the command line without the program's name.
pub fn run(args: Args, typed: &str) -> Result<(), Failure> {
    let context = Context { shared: args.shared, typed };
    match args.command {
        Command::Asperity(args) => asperity_laws::run(&args.law, &context),
        Command::Moments(psd) => spectrum_tables::moments(&psd, &context),
        Command::Amplitude(psd) => spectrum_tables::amplitude(&psd, &context),
        Command::Fit(args) => spectrum_tables::fit(&args, &context),
        Command::Stacked(args) => stacked::run(&args, &context),
        Command::Run(args) => run_scene::run(&args, &context),
        Command::Scene { template } => {
            context.shared.output.write(|out| out.write_all(template.text().as_bytes()))
        }
    }
}

/// The options of every command, and how it was called.
struct Context<'a> {
    shared: SharedArgs,
    typed: &'a str,
}

impl Context<'_> {
    fn sampling(&self) -> Sampling {
        Sampling {
            scales_per_decade: self.shared.scales_per_decade,
            cutoff_m: self.shared.cutoff.map(|cutoff| cutoff.m),
        }
    }

    fn counterface(&self) -> Result<Option<ElasticBody>, Failure> {
        let (Some(modulus), Some(ratio)) =
            (self.shared.counterface_youngs_modulus, self.shared.counterface_poisson_ratio)
        else {
            return Ok(None);
        };
        elastic_body("--counterface-youngs-modulus", modulus, "--counterface-poisson-ratio", ratio).map(Some)
    }

    fn overrides(&self) -> Result<Overrides, Failure> {
        Ok(Overrides {
            normalisation: self.shared.normalisation,
            amplitude: self.shared.amplitude,
            scales_per_decade: self.shared.scales_per_decade,
            hardness: self.shared.hardness,
            strength_cap: self.shared.strength_cap,
            cutoff: self.shared.cutoff,
            counterface: self.counterface()?,
        })
    }

    /// Reads the spectrum, computes what is needed of it, and writes the table made from that.
    fn spectrum_to_table(
        &self,
        psd: &PsdArgs,
        needs: Needs,
        table: impl FnOnce(&Results, &Needs) -> Table,
        notes: impl FnOnce(&Results) -> Vec<String>,
    ) -> Result<(), Failure> {
        let mut timings = Timings::start();
        let surface = load(psd)?;
        timings.lap("reading");
        let plan = Plan { psd: &surface.psd, sampling: self.sampling(), needs };
        let results = plan.compute().map_err(Failure::input)?;
        timings.lap("computing");
        say(surface.notes.iter().cloned().chain(notes(&results)));
        self.write(&table(&results, &plan.needs), &provenance(self.typed, &surface, plan.sampling))?;
        timings.lap("writing");
        timings.report(self.shared.timings);
        Ok(())
    }

    /// Writes a table; what is written to a file carries its provenance, stdout carries the table alone.
    fn write(&self, table: &Table, comments: &[String]) -> Result<(), Failure> {
        let comments = match self.shared.output {
            Place::Standard => &[],
            Place::File(_) => comments,
        };
        self.shared.output.write(|out| table.write(self.shared.format, comments, out))
    }
}

fn load(psd: &PsdArgs) -> Result<Surface, Failure> {
    let options = ReadOptions { column: psd.column.clone(), x: psd.x, convention: psd.convention };
    Surface::load(&psd.psd, Path::new(""), &options)
}

fn elastic_body(
    modulus_flag: &str,
    modulus: Pressure,
    ratio_flag: &str,
    ratio: f64,
) -> Result<ElasticBody, Failure> {
    let modulus_pa = modulus.pascals(None).ok_or_else(|| {
        Failure::Input(format!("{modulus_flag}: a modulus cannot be given in H; give it in GPa"))
    })?;
    ElasticBody::new(modulus_pa, ratio).map_err(|error| Failure::Input(format!("{ratio_flag}: {error}")))
}

/// Says notes on stderr.
fn say(notes: impl IntoIterator<Item = String>) {
    for note in notes {
        eprintln!("note: {note}");
    }
}
