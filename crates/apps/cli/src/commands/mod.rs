//! One module per command: from what was typed to a plan, and from its results to the output.

mod bem;
mod completions;
mod figure;
mod flow;
mod gap;
mod law;
mod man_pages;
mod one_asperity;
mod persson;
mod psd;
mod readable;
mod roughness;
mod row_by_row;
mod run_scene;
mod scan;
mod spectrum_tables;
mod stacked;
mod statistical;
mod surface_report;
mod tangential;

use std::path::Path;
use std::time::{Duration, Instant};

use measurements::ScanRequest;
use questions::{Answer, CurveQuestion, QuestionError, SamplingInput};
use report::provenance::provenance;
use report::{chart, spectrum_words};
use spectrum::{ReadOption, ReadOptions};
use study::figure::FigureData;
use study::surface::{Surface, SurfaceError};
use tables::staging::StagedFiles;
use tables::{Format, Table, TableWriter};
use topography::Recipe;
use units::printable::shown_path;
use units::{Remark, RemarkCode, RemarkLevel, Spelling};

use crate::args::{Args, Command, CounterfaceSurfaceArgs, PsdArgs, QuotedPaths, ReadingArgs, SharedArgs};
use crate::failure::Failure;
use crate::files::Folder;
use crate::flags::{Flags, failure, refuse_first};
use crate::inputs::announce;
use crate::interruption;
use crate::output::{Stopped, publish, stage};
use crate::picture::Picture;
use crate::place::Place;
use crate::progress::Progress;
use crate::stderr::say;
use crate::timings::Timings;

/// The file that a figure goes to, if there is one.
type Figure<'a> = Option<&'a Picture>;

/// Carries a command out; `typed` is the command line without the program's name.
pub fn run(args: Args, typed: &[String]) -> Result<(), Failure> {
    let quoted: Vec<_> = match args.shared.provenance {
        Some(QuotedPaths::Full) => typed.to_vec(),
        _ => typed.iter().map(|word| without_folders(word)).collect(),
    };
    let context = Context { shared: args.shared, typed: &quoted.join(" ") };
    if context.shared.provenance.is_some() && context.shared.format() == Format::Json {
        return Err(Failure::input(
            "--provenance writes comment lines, which JSON does not have; leave it out, or take --format csv",
        ));
    }
    refuse_idle_options(&args.command, &context.shared)?;
    announce("--output", [context.shared.output.clone()])?;
    match args.command {
        Command::Asperity(args) => one_asperity::run(&args.law, &context),
        Command::Moments(args) => spectrum_tables::moments(&args, &context),
        Command::Amplitude(args) => spectrum_tables::amplitude(&args, &context),
        Command::Bem(args) => bem::run(&args, &context),
        Command::Flow(args) => flow::run(&args, &context),
        Command::Gap(args) => gap::run(&args, &context),
        Command::Tangential(args) => tangential::run(&args, &context),
        Command::Law(args) => law::run(&args, &context),
        Command::Scan(args) => scan::run(&args, &context),
        Command::Roughness(args) => roughness::run(&args, &context),
        Command::Psd(args) => psd::run(&args, &context),
        Command::Fit(args) => spectrum_tables::fit(&args, &context),
        Command::Stacked(args) => stacked::run(&args, &context),
        Command::Statistical(args) => statistical::run(&args, &context),
        Command::Persson(args) => persson::run(&args, &context),
        Command::Report(args) => surface_report::run(&args, &context),
        Command::Figure(args) => figure::run(&args, &context),
        Command::Run(args) => run_scene::run(&args, &context),
        Command::Completions { shell } => completions::run(shell, &context),
        Command::Man(args) => man_pages::run(&args, &context),
        Command::Scene { template } => context.print(template.text()),
    }
}

/// Refuses options of every command that one has no use for.
fn refuse_idle_options(command: &Command, shared: &SharedArgs) -> Result<(), Failure> {
    let (name, takes_no_time) = match command {
        Command::Scene { .. } => ("scene", true),
        Command::Completions { .. } => ("completions", true),
        Command::Man(_) => ("man", true),
        Command::Figure(_) => ("figure", false),
        Command::Run(args) if args.dry_run => ("run --dry-run", true),
        _ => return Ok(()),
    };
    let SharedArgs { format, provenance, timings, .. } = shared;
    let times = *timings && takes_no_time;
    let given = [("format", format.is_some()), ("provenance", provenance.is_some()), ("timings", times)];
    refuse_first(given, Remark::new(RemarkCode::OtherCommand).with("command", name))
}

/// The options of every command, and how it was called.
struct Context<'a> {
    shared: SharedArgs,
    typed: &'a str,
}

impl Context<'_> {
    /// Answers a question about a spectrum, in so many steps.
    fn answer(
        &self,
        psd: &PsdArgs,
        sampling: &SamplingInput,
        figure: Figure<'_>,
        steps: impl FnOnce(&Surface) -> Result<usize, QuestionError>,
        answer: impl FnOnce(&Surface, &Progress) -> Result<Answer, QuestionError>,
    ) -> Result<(), Failure> {
        let mut timings = Timings::start();
        let surface = self.load(&psd.psd, &psd.reading, figure)?;
        timings.lap("reading");
        let progress = Progress::towards(steps(&surface)?, "steps");
        let answer = answer(&surface, &progress)?;
        drop(progress);
        timings.lap("computing");
        let comments = provenance(self.typed, &surface, sampling.sampling());
        self.publish_answer(&answer, &surface.name, &comments, figure, timings)
    }

    /// Says the notes of an answer, and writes its table and its figure.
    fn publish_answer(
        &self,
        answer: &Answer,
        subject: &str,
        comments: &[String],
        figure: Figure<'_>,
        timings: Timings,
    ) -> Result<(), Failure> {
        say_all(&answer.notes, &Flags);
        let mut files = StagedFiles::default();
        self.stage_figure(&mut files, figure, answer.figure.as_ref(), subject, comments)?;
        self.stage_table(&mut files, &self.shared.output, self.wanted(comments), &answer.table)?;
        self.finish(files, timings)
    }

    /// Puts the results in place, and says how long everything took.
    fn finish(&self, files: StagedFiles, mut timings: Timings) -> Result<(), Failure> {
        publish(files)?;
        timings.lap("writing");
        timings.report(self.shared.timings);
        Ok(())
    }

    /// Answers a question about a curve, part by part as it is computed, or at once if it is drawn as well.
    fn curve(
        &self,
        question: &CurveQuestion,
        psd: &[ScanRequest],
        reading: &ReadingArgs,
        figure: Figure<'_>,
        spelling: &dyn Spelling,
    ) -> Result<(), Failure> {
        let failed = |error| failure(&error, spelling);
        question.check().map_err(failed)?;
        let mut timings = Timings::start();
        let surface = self.load(psd, reading, figure)?;
        timings.lap("reading");
        let prepared = question.on(&surface).map_err(failed)?;
        let stream = prepared.stream().map_err(failed)?;
        say_all(&stream.notes(), spelling);
        let progress = Progress::towards(stream.steps(), "states");
        let whole = figure.map(|_| stream.whole(&progress)).transpose().map_err(failed)?;
        let comments = provenance(self.typed, &surface, prepared.sampling());
        let mut files = StagedFiles::default();
        let drawn = whole.as_ref().and_then(|answer| answer.figure.as_ref());
        self.stage_figure(&mut files, figure, drawn, &surface.name, &comments)?;
        let mut writing = Duration::ZERO;
        self.stage_blocks(&mut files, &self.shared.output, self.wanted(&comments), |out| {
            let mut write = |table: &Table| {
                let begun = Instant::now();
                out.block(table)?;
                writing += begun.elapsed();
                if interruption::is_asked_for() { Err(Failure::Interrupted.into()) } else { Ok(()) }
            };
            let notes = match whole {
                Some(answer) => write(&answer.table).map(|()| answer.notes),
                None => stream.parts::<Stopped>(&progress, |table| write(&table)),
            }?;
            progress.aside(|| say_all(&notes, spelling));
            Ok(())
        })?;
        drop(progress);
        publish(files)?;
        timings.lap_with("computing", "writing", writing);
        timings.report(self.shared.timings);
        Ok(())
    }

    /// Reads the spectrum of a face, or makes it from scans, and adds that of the other face if there is one.
    fn load(
        &self,
        files: &[ScanRequest],
        reading: &ReadingArgs,
        figure: Figure<'_>,
    ) -> Result<Surface, Failure> {
        announce_figure(figure)?;
        let folder = Folder::current();
        let reader =
            FaceReader { folder: &folder, options: reading_options(reading), recipe: Recipe::default() };
        let (own, other) = (reader.face(files)?, reader.counterface(&reading.other)?);
        let of_scans = |face: &Surface| face.made_from.is_some();
        if reader.options != ReadOptions::default() && of_scans(&own) && other.as_ref().is_none_or(of_scans) {
            return Err(Failure::input("options for reading a spectrum do not affect scans; leave them out"));
        }
        Ok(other.into_iter().fold(own, Surface::against))
    }

    /// Writes a text in place of a table.
    fn print(&self, text: &str) -> Result<(), Failure> {
        self.shared.output.write(|out| out.write_all(text.as_bytes()))
    }

    /// Draws a figure, if there is one and a file for it.
    fn stage_figure(
        &self,
        files: &mut StagedFiles,
        picture: Figure<'_>,
        figure: Option<&FigureData>,
        subject: &str,
        comments: &[String],
    ) -> Result<(), Failure> {
        match picture.zip(figure) {
            Some((picture, figure)) => self.stage_picture(files, picture, figure, subject, comments),
            None => Ok(()),
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
            .bytes(chart::svg(figure, subject, comments))
            .map_err(|error| Failure::System(error.to_string()))?;
        stage(files, &picture.path, |out| out.write_all(&bytes))
    }

    /// Lines that tell where a table comes from, if they are asked for.
    fn wanted<'c>(&self, provenance: &'c [String]) -> &'c [String] {
        if self.shared.provenance.is_some() { provenance } else { &[] }
    }

    /// Writes a table, comment lines first.
    fn stage_table(
        &self,
        files: &mut StagedFiles,
        output: &Place,
        comments: &[String],
        table: &Table,
    ) -> Result<(), Failure> {
        self.stage_blocks(files, output, comments, |out| Ok(out.block(table)?))
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
            let mut writer = TableWriter::begin(self.shared.format(), comments, out)?;
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

/// Returns a word of the command with the file name in place of a path, such as `a.txt:unit=um` for
/// `/data/a.txt:unit=um` and `--out=results` for `--out=/data/results`. A relative path counts if its folder is there.
fn without_folders(word: &str) -> String {
    let (option, value) = match word.split_once('=') {
        Some((option, value)) if option.starts_with("--") => (format!("{option}="), value),
        _ => (String::new(), word),
    };
    // The second character of a path may be the colon behind a drive.
    let end = value.char_indices().skip(2).find(|(_, c)| *c == ':').map_or(value.len(), |(at, _)| at);
    let (path, settings) = value.split_at(end);
    let is_relative =
        Path::new(path).parent().is_some_and(|folder| folder != Path::new("") && folder.is_dir());
    let is_absolute = path.starts_with(['/', '\\']) || path.get(1..3) == Some(":\\");
    format!("{option}{}{settings}", if is_relative || is_absolute { shown_path(path) } else { path })
}

/// Announces the file of a figure.
fn announce_figure(figure: Figure<'_>) -> Result<(), Failure> {
    announce("--figure", figure.map(Picture::place))
}

/// Reads faces: files of a folder, spectra by these options and scans by this recipe.
struct FaceReader<'f> {
    folder: &'f Folder,
    options: ReadOptions,
    recipe: Recipe,
}

impl FaceReader<'_> {
    /// Reads one file as a spectrum if it holds one, and otherwise all files as scans of one face.
    fn face(&self, files: &[ScanRequest]) -> Result<Surface, Failure> {
        if let [file] = files
            && !Path::new(&file.path).is_dir()
        {
            match (Surface::load(&file.path, self.folder, &self.options), file.check_takes(&[])) {
                (Ok(surface), takes) => return takes.map(|()| surface).map_err(psd::refused),
                // Options of a scan say that it is one.
                (Err(SurfaceError::Scan { .. }), _) | (Err(SurfaceError::Spectrum { .. }), Err(_)) => {}
                (Err(error), _) => return Err(unread(error)),
            }
        }
        Surface::from_scans(files, self.folder, &self.recipe).map_err(unread)
    }

    /// Reads the other face, if there is one: scans or a spectrum, as its option says.
    fn counterface(&self, other: &CounterfaceSurfaceArgs) -> Result<Option<Surface>, Failure> {
        let surface = match &other.counterface_psd {
            Some(psd) => Surface::load(&psd.path, self.folder, &self.options)
                .and_then(|surface| Ok(psd.check_takes(&[]).map(|()| surface)?)),
            None if other.counterface_scans.is_empty() => return Ok(None),
            None => Surface::from_scans(&other.counterface_scans, self.folder, &self.recipe),
        };
        surface.map(Some).map_err(unread)
    }
}

/// Words why a surface cannot be read, and what mends it.
fn unread(error: SurfaceError) -> Failure {
    match error {
        SurfaceError::Scans(error) => psd::refused(error),
        SurfaceError::Scan { ref name, .. } => {
            Failure::Input(format!("{error}; use --counterface-scans {name}"))
        }
        SurfaceError::Spectrum { error: ref reading, .. } => {
            let mend = reading.mend().map(|mend| spectrum_words::mend(&mend, flag_of));
            Failure::Input(format!("{error}{}", mend.unwrap_or_default()))
        }
        error => Failure::input(error),
    }
}

/// Returns the options for reading a spectrum.
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

/// The flag that gives an option of reading.
fn flag_of(option: ReadOption) -> String {
    format!("--{}", option.key().replace('_', "-"))
}

/// Says remarks on stderr, with the flags of a command; of checks that were passed nothing.
fn say_all(remarks: &[Remark], spelling: &dyn Spelling) {
    for remark in remarks {
        let kind = match remark.level {
            RemarkLevel::Passed => continue,
            RemarkLevel::Caution => "warning",
            RemarkLevel::Note | RemarkLevel::Error => "note",
        };
        say(&format!("{kind}: {}", remark.words(spelling)));
    }
}

/// Says notes on stderr.
fn say_notes(notes: impl IntoIterator<Item = String>) {
    for note in notes {
        say(&format!("note: {note}"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn provenance_quotes_file_names_in_place_of_absolute_paths() {
        for (word, quoted) in [
            ("/data/a.txt:unit=um,channel=a/b", "a.txt:unit=um,channel=a/b"),
            ("--out=/data/results", "--out=results"),
            ("C:\\data\\a.txt:unit=um", "a.txt:unit=um"),
            ("src/a.txt", "a.txt"),
            ("--x-unit=1/m", "--x-unit=1/m"),
        ] {
            assert_eq!(without_folders(word), quoted);
        }
    }
}
