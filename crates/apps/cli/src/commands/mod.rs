//! One module per command: from what was typed to a plan, and from its results to the output.

mod bem;
mod completions;
mod gap;
mod law;
mod man_pages;
mod material_options;
mod one_asperity;
mod persson;
mod psd;
mod row_by_row;
mod run_scene;
mod scan;
mod spectrum_tables;
mod stacked;
mod statistical;

use std::time::{Duration, Instant};

use spectrum::{ProfilePsd, ReadOption, ReadOptions};
use staging::StagedFiles;

use crate::args::{Args, Command, FigureArg, ReadingArgs, SharedArgs};
use crate::failure::Failure;
use crate::files::Folder;
use crate::interruption;
use crate::output::{Place, Stopped, publish, stage};
use crate::picture::Picture;
use crate::progress::Progress;
use crate::stderr::say;
use crate::targets::Targets;
use crate::timings::Timings;
use findings::doubts::{Doubt, RealPressures};
use report::doubt_words;
use report::provenance::provenance;
use report::summary::CurveCounts;
use report::{plot, scan_words, spectrum_words};
use study::figure::{Figure, FigureData, Shows};
use study::plan::{Curve, Load, LoadRange, Needs, NominalPressure, Part, Plan, PlanError, Results, Sampling};
use study::result_tables;
use study::surface::{Surface, SurfaceError};
use tables::{Format, Table, TableWriter};
use topography::Severity;
use units::display::length;

/// Carries a command out; `typed` is the command line without the program's name.
pub fn run(args: Args, typed: &str) -> Result<(), Failure> {
    let context = Context { shared: args.shared, typed };
    if context.shared.provenance && context.shared.format == Format::Json {
        return Err(Failure::input(
            "--provenance writes comment lines, which JSON does not have; leave it out, or take --format csv",
        ));
    }
    match args.command {
        Command::Asperity(args) => one_asperity::run(&args.law, &context),
        Command::Moments(args) => spectrum_tables::moments(&args, &context),
        Command::Amplitude(args) => spectrum_tables::amplitude(&args, &context),
        Command::Bem(args) => bem::run(&args, &context),
        Command::Gap(args) => gap::run(&args, &context),
        Command::Law(args) => law::run(&args, &context),
        Command::Scan(args) => scan::run(&args, &context),
        Command::Psd(args) => psd::run(&args, &context),
        Command::Fit(args) => spectrum_tables::fit(&args, &context),
        Command::Stacked(args) => stacked::run(&args, &context),
        Command::Statistical(args) => statistical::run(&args, &context),
        Command::Persson(args) => persson::run(&args, &context),
        Command::Run(args) => run_scene::run(&args, &context),
        Command::Completions { shell } => completions::run(shell, &context),
        Command::Man(args) => man_pages::run(&args, &context),
        Command::Scene { template } => {
            context.targets(None)?;
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
    /// Reads the spectrum, computes what is needed of it, and writes the table made from that.
    fn spectrum_to_table(
        &self,
        spectrum: &Spectrum<'_>,
        needs: Needs,
        table: impl FnOnce(&Results) -> Table,
        notes: impl FnOnce(&Results) -> Vec<String>,
    ) -> Result<(), Failure> {
        let mut timings = Timings::start();
        let surface = self.load(spectrum)?;
        timings.lap("reading");
        let plan = Plan { psd: &surface.psd, sampling: spectrum.sampling, needs };
        let results = compute(&plan)?;
        timings.lap("computing");
        say_surface(&surface);
        say_notes(notes(&results));
        say_doubts(Doubt::of_spectrum(&surface.psd));
        let comments = provenance(self.typed, &surface, plan.sampling);
        let mut files = StagedFiles::default();
        if let Some(figure) = &spectrum.figure {
            let data = figure.of.data(&results, &plan.needs, figure.hardness_pa);
            self.stage_picture(&mut files, figure.picture, &data, &surface.name, &comments)?;
        }
        self.stage_blocks(&mut files, &self.shared.output, self.wanted(&comments), |out| {
            Ok(out.block(&table(&results))?)
        })?;
        publish(files)?;
        timings.lap("writing");
        timings.report(self.shared.timings);
        Ok(())
    }

    /// Reads the spectrum, and writes the one curve that is needed of it part by part as it is computed, or at once where it
    /// is drawn as well; `first_note` is said before all that is found.
    fn curve_to_table(
        &self,
        spectrum: &Spectrum<'_>,
        needs: Needs,
        hardness_pa: Option<f64>,
        details: bool,
        first_note: impl FnOnce(&ProfilePsd) -> String,
    ) -> Result<(), Failure> {
        let mut timings = Timings::start();
        let surface = self.load(spectrum)?;
        timings.lap("reading");
        let plan = Plan { psd: &surface.psd, sampling: spectrum.sampling, needs };
        let stream = plan.stream()?;
        say_surface(&surface);
        say_notes([first_note(stream.psd())]);
        let comments = provenance(self.typed, &surface, plan.sampling);
        let mut files = StagedFiles::default();
        let mut drawn = None;
        if let Some(figure) = &spectrum.figure {
            let results = compute(&plan)?;
            let data = figure.of.data(&results, &plan.needs, figure.hardness_pa);
            self.stage_picture(&mut files, figure.picture, &data, &surface.name, &comments)?;
            drawn = Some(results);
        }
        let several = plan.needs.load_count() > 1;
        let mut counts = CurveCounts::default();
        say_doubts(Doubt::of_spectrum(&surface.psd));
        let mut real_pressures = RealPressures::new(hardness_pa);
        let labels =
            plan.needs.loads.iter().map(|load| Some(load.label.as_str())).chain(std::iter::repeat(None));
        say_doubts(Doubt::of_pressures(plan.needs.pressures().zip(labels), hardness_pa));
        let mut writing = Duration::ZERO;
        self.stage_blocks(&mut files, &self.shared.output, self.wanted(&comments), |out| {
            let mut write = |curve: &Curve, part: Part| {
                counts.add(&part.rows);
                real_pressures.add_part(curve, &part.rows, &part.pressures_pa);
                let begun = Instant::now();
                let rows = result_tables::part_of_curve(&part.rows, &part.pressures_pa, several, details);
                out.block(&rows)?;
                writing += begun.elapsed();
                if interruption::is_asked_for() { Err(Failure::Interrupted.into()) } else { Ok(()) }
            };
            match drawn {
                Some(results) => {
                    let pressures_pa: Vec<f64> = plan.needs.pressures().map(NominalPressure::pa).collect();
                    for (curve, rows) in plan.needs.curves.iter().zip(results.curves) {
                        write(curve, Part { pressures_pa: pressures_pa.clone(), rows })?;
                    }
                }
                None => {
                    for curve in &plan.needs.curves {
                        let progress = Progress::towards(stream.rows(curve), "states");
                        stream.parts::<Stopped>(curve, &progress, |part| write(curve, part))?;
                    }
                }
            }
            say_notes(counts.notes());
            say_doubts(real_pressures.doubts());
            Ok(())
        })?;
        publish(files)?;
        timings.lap_with("computing", "writing", writing);
        timings.report(self.shared.timings);
        Ok(())
    }

    fn load(&self, spectrum: &Spectrum<'_>) -> Result<Surface, Failure> {
        let options = reading_options(spectrum.reading);
        let targets = self.targets(spectrum.figure.as_ref().map(|figure| figure.picture))?;
        let surface =
            Surface::load(spectrum.psd, &Folder::current(targets), &options).map_err(
                |error| match error {
                    SurfaceError::Scan { ref name, .. } => {
                        Failure::Input(format!("{error}; use `truearea psd {name}`"))
                    }
                    SurfaceError::Spectrum { error: ref reading, .. } => {
                        let mend = reading.mend().map(|mend| spectrum_words::mend(&mend, flag_of));
                        Failure::Input(format!("{error}{}", mend.unwrap_or_default()))
                    }
                    error => Failure::input(error),
                },
            )?;
        refuse_idle_cutoff(spectrum.sampling.cutoff_m, &surface)?;
        Ok(surface)
    }

    /// The files that results go to.
    fn targets(&self, picture: Option<&Picture>) -> Result<Targets, Failure> {
        let targets = Targets::default().with("--output", &self.shared.output)?;
        match picture {
            Some(picture) => targets.with_file("--figure", &picture.path),
            None => Ok(targets),
        }
    }

    fn stage_picture(
        &self,
        files: &mut StagedFiles,
        picture: &Picture,
        figure: &FigureData,
        subject: &str,
        comments: &[String],
    ) -> Result<(), Failure> {
        let bytes = picture
            .bytes(plot::svg(figure, subject, comments))
            .map_err(|error| Failure::System(error.to_string()))?;
        stage(files, &picture.path, |out| out.write_all(&bytes))
    }

    /// Lines that tell where a table comes from, if they are asked for.
    fn wanted<'c>(&self, provenance: &'c [String]) -> &'c [String] {
        if self.shared.provenance { provenance } else { &[] }
    }

    /// Writes a table block by block, comment lines first.
    fn stage_blocks(
        &self,
        files: &mut StagedFiles,
        output: &Place,
        comments: &[String],
        write: impl FnOnce(&mut TableWriter<'_>) -> Result<(), Stopped>,
    ) -> Result<(), Failure> {
        output.stage(files, |out| {
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

/// How a spectrum is read.
fn reading_options(reading: &ReadingArgs) -> ReadOptions {
    ReadOptions {
        column: reading.column.clone(),
        x: reading.x,
        convention: reading.convention,
        series: reading.series.clone(),
        subject: reading.subject.clone(),
        x_unit: reading.x_unit.clone(),
        psd_unit: reading.psd_unit.clone(),
    }
}

/// A spectrum as a command is given it, and what is drawn of its results.
struct Spectrum<'a> {
    psd: &'a str,
    reading: &'a ReadingArgs,
    sampling: Sampling,
    figure: Option<Drawn<'a>>,
}

/// A figure of results, and the file that it goes to.
struct Drawn<'a> {
    of: Figure,
    picture: &'a Picture,
    hardness_pa: Option<f64>,
}

impl<'a> Drawn<'a> {
    /// More lines than these nobody tells apart.
    const MOST_LINES: usize = 24;

    /// Moments or amplitudes against wavelength.
    fn against_wavelength(shows: Shows, figure: &'a FigureArg) -> Option<Self> {
        let of = Figure { shows, ..Figure::area_of_all(Vec::new()) };
        figure.figure.as_ref().map(|picture| Drawn { of, picture, hardness_pa: None })
    }

    /// The area of the one curve against cutoff, a line for each load and separation. The loads of ranges get labels, since
    /// lines have them.
    fn area(
        figure: &'a FigureArg,
        needs: &mut Needs,
        hardness_pa: Option<f64>,
    ) -> Result<Option<Self>, Failure> {
        let Some(picture) = &figure.figure else { return Ok(None) };
        let lines = needs.load_count() + needs.separations_m.len();
        if lines > Self::MOST_LINES {
            return Err(Failure::Input(format!(
                "--figure draws a line for each pressure and separation, and {lines} are given; give at most {}",
                Self::MOST_LINES
            )));
        }
        let of_ranges = std::mem::take(&mut needs.load_ranges);
        needs.loads.extend(
            of_ranges
                .into_iter()
                .flat_map(LoadRange::pressures)
                .map(|nominal_pressure| Load { nominal_pressure, label: nominal_pressure.label() }),
        );
        Ok(Some(Drawn { of: Figure::area_of_all(vec![0]), picture, hardness_pa }))
    }
}

/// Carries a plan out, with a progress bar where it takes long.
fn compute(plan: &Plan<'_>) -> Result<Results, PlanError> {
    let progress = Progress::towards(plan.statistical_states(), "states");
    plan.compute_observed(&progress)
}

/// The flag that gives an option of reading.
fn flag_of(option: ReadOption) -> &'static str {
    match option {
        ReadOption::Column => "--column",
        ReadOption::Convention => "--convention",
        ReadOption::X => "--x",
        ReadOption::Series => "--series",
        ReadOption::Subject => "--subject",
        ReadOption::XUnit => "--x-unit",
        ReadOption::PsdUnit => "--psd-unit",
    }
}

/// Refuses a cutoff below all data.
fn refuse_idle_cutoff(cutoff_m: Option<f64>, surface: &Surface) -> Result<(), Failure> {
    let shortest_m = surface.psd.shortest_wavelength_m();
    match cutoff_m {
        Some(cutoff_m) if cutoff_m < shortest_m => Err(Failure::Input(format!(
            "--cutoff {} leaves nothing out: the shortest wavelength of {} is {}; leave it out, or choose a longer one",
            length(cutoff_m),
            surface.name,
            length(shortest_m)
        ))),
        _ => Ok(()),
    }
}

/// Says on stderr what a reader has to know about a spectrum.
fn say_surface(surface: &Surface) {
    for note in &surface.notes {
        say_of_severity(note.severity(), &scan_words::note(note));
    }
}

/// Says a note or a warning on stderr, and of checks that were passed nothing.
fn say_of_severity(severity: Severity, text: &str) {
    match severity {
        Severity::Passed => {}
        Severity::Note => say(&format!("note: {text}")),
        Severity::Warning => say(&format!("warning: {text}")),
    }
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
