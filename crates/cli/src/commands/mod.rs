//! One module per command: from what was typed to a plan, and from its results to the output.

mod completions;
mod man_pages;
mod one_asperity;
mod psd;
mod row_by_row;
mod run_scene;
mod spectrum_tables;
mod stacked;
mod statistical;

use std::time::{Duration, Instant};

use asperity::ElasticBody;
use spectrum::ReadOptions;

use crate::args::{Args, Command, MaterialArgs, ReadingArgs, SharedArgs};
use crate::failure::Failure;
use crate::files::Folder;
use crate::output::{Place, Stopped};
use crate::progress::Progress;
use crate::stderr::say;
use crate::timings::Timings;
use report::doubt_words;
use report::summary::CurveCounts;
use study::doubts::{Doubt, RealPressures};
use study::material::{GivenMaterial, Material, MaterialError};
use study::plan::{Load, LoadRange, Needs, Plan, PlanError, Results, Sampling, Stream};
use study::provenance::provenance;
use study::result_tables;
use study::scene::Overrides;
use study::surface::Surface;
use tables::{Table, TableWriter};
use units::PressureRange;
use units::{Modulus, Pressure};

/// Carries a command out; `typed` is the command line without the program's name.
pub fn run(args: Args, typed: &str) -> Result<(), Failure> {
    let context = Context { shared: args.shared, typed };
    match args.command {
        Command::Asperity(args) => one_asperity::run(&args.law, &context),
        Command::Moments(psd) => spectrum_tables::moments(&psd, &context),
        Command::Amplitude(psd) => spectrum_tables::amplitude(&psd, &context),
        Command::Psd(args) => psd::run(&args, &context),
        Command::Fit(args) => spectrum_tables::fit(&args, &context),
        Command::Stacked(args) => stacked::run(&args, &context),
        Command::Statistical(args) => statistical::run(&args, &context),
        Command::Run(args) => run_scene::run(&args, &context),
        Command::Completions { shell } => completions::run(shell, &context),
        Command::Man(args) => man_pages::run(&args, &context),
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
        elastic_body(modulus, "--counterface-poisson-ratio", ratio).map(Some)
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
        psd: &str,
        reading: &ReadingArgs,
        needs: Needs,
        table: impl FnOnce(&Results, &Needs) -> Table,
        notes: impl FnOnce(&Results) -> Vec<String>,
    ) -> Result<(), Failure> {
        let mut timings = Timings::start();
        let surface = load(psd, reading)?;
        timings.lap("reading");
        let plan = Plan { psd: &surface.psd, sampling: self.sampling(), needs };
        let results = compute(&plan).map_err(Failure::input)?;
        timings.lap("computing");
        say_notes(surface.notes.iter().cloned().chain(notes(&results)));
        say_doubts(Doubt::of_spectrum(&surface.psd));
        self.write(&table(&results, &plan.needs), &provenance(self.typed, &surface, plan.sampling))?;
        timings.lap("writing");
        timings.report(self.shared.timings);
        Ok(())
    }

    /// Reads the spectrum, and writes the one curve that is needed of it part by part as it is computed; `first_note` is
    /// said before all that is found.
    fn curve_to_table(
        &self,
        psd: &str,
        reading: &ReadingArgs,
        needs: Needs,
        hardness_pa: Option<f64>,
        details: bool,
        first_note: impl FnOnce(&Stream<'_>) -> String,
    ) -> Result<(), Failure> {
        let mut timings = Timings::start();
        let surface = load(psd, reading)?;
        timings.lap("reading");
        let plan = Plan { psd: &surface.psd, sampling: self.sampling(), needs };
        let stream = plan.stream().map_err(Failure::input)?;
        say_notes(surface.notes.iter().cloned().chain([first_note(&stream)]));
        let several = plan.needs.load_count() > 1;
        let mut counts = CurveCounts::default();
        say_doubts(Doubt::of_spectrum(&surface.psd));
        let mut real_pressures = RealPressures::new(hardness_pa);
        let labels =
            plan.needs.loads.iter().map(|load| Some(load.label.as_str())).chain(std::iter::repeat(None));
        say_doubts(Doubt::of_pressures(plan.needs.pressures().zip(labels), hardness_pa));
        let mut writing = Duration::ZERO;
        let comments = provenance(self.typed, &surface, plan.sampling);
        self.write_blocks(&self.shared.output, &comments, |out| {
            for curve in &plan.needs.curves {
                let progress = Progress::towards(stream.rows(curve));
                stream.parts(curve, &progress, |part| {
                    counts.add(&part.rows);
                    real_pressures.add_part(curve, &part.rows, &part.pressures_pa);
                    let begun = Instant::now();
                    out.block(&result_tables::part_of_curve(
                        &part.rows,
                        &part.pressures_pa,
                        several,
                        details,
                    ))?;
                    writing += begun.elapsed();
                    Ok::<(), Stopped>(())
                })?;
            }
            say_notes(counts.notes());
            say_doubts(real_pressures.doubts());
            Ok(())
        })?;
        timings.lap_with("computing", "writing", writing);
        timings.report(self.shared.timings);
        Ok(())
    }

    fn write(&self, table: &Table, comments: &[String]) -> Result<(), Failure> {
        self.write_to(&self.shared.output, table, comments)
    }

    fn write_to(&self, output: &Place, table: &Table, comments: &[String]) -> Result<(), Failure> {
        self.write_blocks(output, comments, |out| Ok(out.block(table)?))
    }

    /// Writes a table block by block; what is written to a file carries its provenance, stdout carries the table alone.
    fn write_blocks(
        &self,
        output: &Place,
        comments: &[String],
        write: impl FnOnce(&mut TableWriter<'_>) -> Result<(), Stopped>,
    ) -> Result<(), Failure> {
        let comments = match output {
            Place::Standard => &[],
            Place::File(_) => comments,
        };
        output.write(|out| {
            let mut writer = TableWriter::begin(self.shared.format, comments, out)?;
            write(&mut writer)?;
            let unrepresentable = writer.end()?;
            if unrepresentable > 0 {
                say_notes([format!(
                    "{unrepresentable} results lie beyond the range of double-precision numbers: their cells are empty"
                )]);
            }
            Ok::<(), Stopped>(())
        })
    }
}

/// Carries a plan out, with a progress bar where it takes long.
fn compute(plan: &Plan<'_>) -> Result<Results, PlanError> {
    let progress = Progress::towards(plan.statistical_states());
    plan.compute_observed(&progress)
}

fn load(psd: &str, reading: &ReadingArgs) -> Result<Surface, Failure> {
    let options = ReadOptions {
        column: reading.column.clone(),
        x: reading.x,
        convention: reading.convention,
        series: reading.series.clone(),
        subject: reading.subject.clone(),
        x_unit: reading.x_unit.clone(),
        psd_unit: reading.psd_unit.clone(),
    };
    Surface::load(psd, &Folder::current(), &options).map_err(Failure::input)
}

/// The rough body and its counterface, as given on the command line.
fn material(given: &MaterialArgs, context: &Context<'_>) -> Result<Material, Failure> {
    let missing = |flag: &str| Failure::Input(format!("{flag} is needed: every model is at least elastic"));
    let modulus = given.youngs_modulus.ok_or_else(|| missing("--youngs-modulus"))?;
    let poisson_ratio = given.poisson_ratio.ok_or_else(|| missing("--poisson-ratio"))?;
    let body = elastic_body(modulus, "--poisson-ratio", poisson_ratio)?;
    Ok(Material::new(GivenMaterial {
        body,
        counterface: context.counterface()?,
        yield_strength: given.yield_strength,
        strength_cap: context.shared.strength_cap,
        strain_gradient_length_m: given.strain_gradient_length.map(|length| length.m),
    }))
}

/// The loads given by `--pressure`, and the ranges behind them by `--pressures`.
fn loads(
    pressures: &[(Pressure, String)],
    ranges: &[PressureRange],
    material: &Material,
) -> Result<(Vec<Load>, Vec<LoadRange>), Failure> {
    let pascals = |option: &str, pressure| {
        material.nominal_pressure(pressure).map_err(|error| {
            let mend = if matches!(error, MaterialError::NoHardness) { ": add --yield-strength" } else { "" };
            Failure::Input(format!("{option}: {error}{mend}"))
        })
    };
    let load = |(pressure, label): &(Pressure, String)| {
        let nominal_pressure = pascals(&format!("--pressure {label}"), *pressure)?;
        Ok(Load { nominal_pressure, label: label.clone() })
    };
    let range = |range: &PressureRange| {
        let [from, to] = [range.from, range.to].map(|end| pascals("--pressures", end));
        Ok(LoadRange::new(from?, to?, range.points))
    };
    let loads = pressures.iter().map(load).collect::<Result<_, Failure>>()?;
    Ok((loads, ranges.iter().map(range).collect::<Result<_, Failure>>()?))
}

fn elastic_body(modulus: Modulus, ratio_flag: &str, ratio: f64) -> Result<ElasticBody, Failure> {
    ElasticBody::new(modulus.pa, ratio).map_err(|error| Failure::Input(format!("{ratio_flag}: {error}")))
}

/// Says what physics speaks against.
fn say_doubts(doubts: impl IntoIterator<Item = Doubt>) {
    say_notes(doubts.into_iter().map(|doubt| format!("doubtful: {}", doubt_words::line(&doubt))));
}

/// Says notes on stderr.
fn say_notes(notes: impl IntoIterator<Item = String>) {
    for note in notes {
        say(&format!("note: {note}"));
    }
}
