//! `report`: one command from scans to a verdict.

use std::fmt::Display;
use std::io::{self, BufRead, IsTerminal, Write};
use std::path::{Path, PathBuf};

use measurements::{ScanProblem, ScanRequest, TopographyError};
use questions::{ReportQuestion, ReportSurface, RunOptions};
use report::products::{self, REPORT};
use scans::{Mend, ScanOption};
use scene::{Overrides, Scene, SceneError, SceneProblem};
use study::body_properties::BodyProperty;
use study::materials::named;
use study::surface::SurfaceError;
use tables::staging::resolve;
use units::Pressure;

use super::Context;
use super::psd::{refusal_of, refused};
use super::run_scene::SceneRun;
use crate::args::ReportArgs;
use crate::failure::Failure;
use crate::files::Folder;
use crate::missing_file::explained;
use crate::output::new_folder;
use crate::results_folder::{Layout, ResultsFolder, file_names};
use crate::stderr::say;
use crate::targets::check_writable;
use crate::timings::Timings;

pub(super) fn run(args: &ReportArgs, context: &Context<'_>) -> Result<(), Failure> {
    let mut timings = Timings::start();
    let folder = args.out.clone().unwrap_or_else(|| default_folder(&args.files));
    let all = [&args.files[..], &args.other.files()].concat();
    if let Some(file) = all
        .iter()
        .find(|file| Path::new(&file.path).is_dir() && resolve(Path::new(&file.path)) == resolve(&folder))
    {
        return Err(Failure::Input(format!(
            "--out {}: this folder holds the scans; name another one",
            file.path
        )));
    }
    let mut question = question(args)?;
    // Paths in the scene are relative to the folder, so that the scene there repeats the report.
    let _made = new_folder("--out", &folder)?;
    check_writable(&folder)?;
    let paths = all.iter().map(|file| PathBuf::from(&file.path)).collect();
    let results = ResultsFolder::open(&folder, [("", paths)]);
    let scene = scene(&mut question, &results, context)?;
    timings.lap("reading");
    let options = OPTIONS;
    let verbose = args.verbose;
    SceneRun { scene: &scene, results, layout: Layout::Folders, options, verbose }.run(timings, context)?;
    if args.open {
        let page = folder.join(REPORT);
        opener::open(&page)
            .map_err(|error| Failure::System(format!("opening {}: {error}", page.display())))?;
    }
    Ok(())
}

/// Everything that a report holds.
const OPTIONS: RunOptions = RunOptions { report: true, judge: None, uncertainty: None };

/// Fills the question from the options, and asks for what is missing if somebody can answer.
fn question(args: &ReportArgs) -> Result<ReportQuestion, Failure> {
    let (surface, counterface_surface) = faces(args)?;
    let mut material = args.material();
    if material.is_empty() {
        let option = "--material \"steel 100Cr6\"";
        material.name = Some(needed("material of the rough body", "steel 100Cr6", option, named)?);
    }
    let has_strength = material.yield_strength.is_some() || material.indentation_hardness.is_some();
    if material.strain_gradient_length.is_some() && !has_strength && material.name.is_none() {
        return Err(Failure::input(
            "--strain-gradient-length makes a strength grow; add --yield-strength 500MPa or --indentation-hardness 300HV",
        ));
    }
    let mut pressures = args.pressure.clone();
    if pressures.is_empty() {
        pressures.push(needed("nominal pressure", "10 MPa", "--pressure 10MPa", str::parse::<Pressure>)?);
    }
    let counterface = Some(args.counterface()).filter(|body| !body.is_empty());
    let pressures = pressures.iter().map(|pressure| spaced(pressure)).collect();
    Ok(ReportQuestion {
        title: Some(args.title.clone().unwrap_or_else(|| match &args.other.files()[..] {
            [] => default_title(&args.files),
            other => format!("{} against {}", default_title(&args.files), default_title(other)),
        })),
        surface,
        material,
        counterface,
        counterface_surface,
        pressures,
        strength_cap: args.strength_cap.clone(),
        seal: args.seal,
        flatness: args.flatness.clone(),
    })
}

/// The files as scans, or the one file as a spectrum; and those of the other face.
fn faces(args: &ReportArgs) -> Result<(ReportSurface, Option<ReportSurface>), Failure> {
    let mut requests =
        args.defaults.complete_all(&[&args.files[..], &args.other.counterface_scans].concat())?;
    if let Some(twice) = args.files.iter().enumerate().find(|(at, file)| args.files[..*at].contains(file)) {
        return Err(Failure::Input(format!("{} is given twice; name each scan once", twice.1.path)));
    }
    let psd = args.other.counterface_psd.as_ref();
    let is_a_spectrum = |request: &&ScanRequest| request.path.starts_with("builtin:");
    if let Some(spectrum) = args.files.iter().find(is_a_spectrum).filter(|_| args.files.len() > 1) {
        let path = &spectrum.path;
        return Err(Failure::Input(format!(
            "{path} is a spectrum, and the other files are scans: leave it out, or give it to the other face as \
             --counterface-psd {path}"
        )));
    }
    for ScanRequest { path, .. } in requests.iter().chain(psd).filter(|request| is_a_path(&request.path)) {
        if Path::new(path).extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml")) {
            return Err(Failure::Input(format!("{path} is a scene; type `truearea run {path}`")));
        }
        std::fs::metadata(path)
            .map_err(|error| Failure::reading(path, &explained(error, Path::new(path))))?;
    }
    let scans = requests.split_off(args.files.len());
    let other = match psd {
        Some(psd) => {
            psd.check_takes(&[]).map_err(refused)?;
            Some(ReportSurface::Psd(psd.path.clone()))
        }
        None => (!scans.is_empty()).then_some(ReportSurface::Scans(scans)),
    };
    Ok((ReportSurface::of_files(requests, &Folder::current()).map_err(Failure::input)?, other))
}

/// The scene of the question, its files relative to the folder. Asks for what a file does not state.
fn scene(
    question: &mut ReportQuestion,
    results: &ResultsFolder<'_>,
    context: &Context<'_>,
) -> Result<Scene, Failure> {
    let folder = results.folder;
    loop {
        let placed = relative_to(question, folder)?;
        let text = placed.scene_text();
        let files = Folder::of(&folder.join("scene.toml"));
        match Scene::parse(&text, &files, &Overrides::default()) {
            Ok(scene) => {
                let products = products::file_names(&scene, OPTIONS, context.shared.format());
                results.refuse(&file_names(&products, Layout::Folders))?;
                return Ok(scene);
            }
            Err(error) => {
                let answered =
                    missing(&error, &text, question).is_some_and(|(scan, option)| ask_for(scan, option));
                if !answered {
                    let scan = scan_at_fault(&error, &text, question).cloned();
                    let typed = |file: &str| as_typed(file, question, &placed);
                    return Err(Failure::Input(worded(error, &text, scan.as_ref(), typed)));
                }
            }
        }
    }
}

/// The question with its paths relative to a folder.
fn relative_to(question: &ReportQuestion, folder: &Path) -> Result<ReportQuestion, Failure> {
    let from =
        folder.canonicalize().map_err(|error| Failure::writing(&folder.display().to_string(), &error))?;
    let relative = |path: &str| -> String {
        if !is_a_path(path) {
            return path.to_owned();
        }
        // The file may be a link, whose own name is the one that people know.
        let to = std::path::absolute(path).ok();
        let to = to.and_then(|to| Some(to.parent()?.canonicalize().ok()?.join(to.file_name()?)));
        let found = to.and_then(|to| pathdiff::diff_paths(to, &from));
        found.map_or_else(|| path.to_owned(), |path| path.to_string_lossy().into_owned())
    };
    let placed = |surface: &ReportSurface| match surface {
        ReportSurface::Psd(path) => ReportSurface::Psd(relative(path)),
        ReportSurface::Scans(scans) => ReportSurface::Scans(
            scans.iter().map(|scan| ScanRequest { path: relative(&scan.path), ..scan.clone() }).collect(),
        ),
    };
    let counterface_surface = question.counterface_surface.as_ref().map(placed);
    Ok(ReportQuestion { surface: placed(&question.surface), counterface_surface, ..question.clone() })
}

/// Returns true unless the name is that of a built-in spectrum or of standard input.
fn is_a_path(name: &str) -> bool {
    !name.starts_with("builtin:") && name != "-"
}

/// The error of scans in that of a scene.
fn of_scans(error: &SceneError) -> Option<&TopographyError> {
    let SceneProblem::Surface(surface) = &error.problem else { return None };
    match &**surface {
        SurfaceError::Scans(found) => Some(found),
        _ => None,
    }
}

/// The scan whose file lacks something, and the option that gives it.
fn missing<'q>(
    error: &SceneError,
    text: &str,
    question: &'q mut ReportQuestion,
) -> Option<(&'q mut ScanRequest, ScanOption)> {
    match of_scans(error)?.mend()? {
        Mend::Give(option) => Some((scan_at_fault(error, text, question)?, option)),
        Mend::LeaveOut(_) => None,
    }
}

/// The scan that an error is about.
fn scan_at_fault<'q>(
    error: &SceneError,
    text: &str,
    question: &'q mut ReportQuestion,
) -> Option<&'q mut ScanRequest> {
    let found = of_scans(error)?;
    let other = question.counterface_surface.as_mut().zip(text.find("[counterface.surface]"));
    let face = match other {
        Some((face, at)) if error.span.as_ref().is_some_and(|span| span.start > at) => face,
        _ => &mut question.surface,
    };
    match face {
        ReportSurface::Scans(scans) => scans.get_mut(found.request.unwrap_or(0)),
        ReportSurface::Psd(_) => None,
    }
}

/// Asks for an option of a scan on a terminal; returns true if it was given. Of positions and heights the units may
/// differ: that of lengths counts for heights, too, unless another is given.
fn ask_for(scan: &mut ScanRequest, option: ScanOption) -> bool {
    let (key, subject, example) = match option {
        ScanOption::Units => return ask_for_units(scan),
        ScanOption::HeightUnit => ("height-unit", "unit of heights", "um"),
        ScanOption::Unit => ("unit", "unit of heights", "um"),
        ScanOption::Size => ("size", "size along the scan lines", "100 um"),
        _ => return false,
    };
    ask_for_key(scan, key, subject, example)
}

/// Asks for the units of lengths and of heights.
fn ask_for_units(scan: &mut ScanRequest) -> bool {
    let is_given = ask_for_key(scan, "unit", "unit of lengths", "um");
    let Some(unit) = scan.unit else { return is_given };
    while scan.height_unit.is_none() && ask_for_key(scan, "height-unit", "unit of heights", unit.ascii()) {}
    scan.height_unit = scan.height_unit.filter(|of_heights| *of_heights != unit);
    true
}

fn ask_for_key(scan: &mut ScanRequest, key: &str, subject: &str, example: &str) -> bool {
    let Some(value) = ask(&format!("{subject} in {}", scan.path), example) else { return false };
    // An answer that is not a value is asked for again.
    match scan.with_option(key, &value) {
        Ok(changed) => *scan = changed,
        Err(error) => say(&error.to_string()),
    }
    true
}

/// Asks for a value that the options lack, until it can be read.
fn needed<T, E: Display>(
    subject: &str,
    example: &str,
    option: &str,
    read: impl Fn(&str) -> Result<T, E>,
) -> Result<String, Failure> {
    loop {
        let Some(answer) = ask(subject, example) else {
            return Err(Failure::Input(format!("a report needs the {subject}; add {option}")));
        };
        match read(&answer) {
            Ok(_) => return Ok(answer),
            Err(error) => say(&error.to_string()),
        }
    }
}

/// Asks on a terminal; `None` if nobody is there to answer.
fn ask(subject: &str, example: &str) -> Option<String> {
    if !io::stdin().is_terminal() || !io::stderr().is_terminal() {
        return None;
    }
    let mut stderr = io::stderr().lock();
    write!(stderr, "{subject}? [{example}] ").and_then(|()| stderr.flush()).ok()?;
    let mut line = String::new();
    let read = io::stdin().lock().read_line(&mut line).ok()?;
    let answer = line.trim();
    (read > 0).then(|| if answer.is_empty() { example.to_owned() } else { answer.to_owned() })
}

/// The path of a file in the scene as it was typed.
fn as_typed(file: &str, typed: &ReportQuestion, placed: &ReportQuestion) -> String {
    let paths = |question: &ReportQuestion| -> Vec<String> {
        let faces = [Some(&question.surface), question.counterface_surface.as_ref()].into_iter().flatten();
        let paths = faces.flat_map(|face| match face {
            ReportSurface::Scans(scans) => scans.iter().map(|scan| scan.path.clone()).collect(),
            ReportSurface::Psd(path) => vec![path.clone()],
        });
        paths.collect()
    };
    let (typed, placed) = (paths(typed), paths(placed));
    let mut pairs = typed.iter().zip(&placed);
    let found = pairs.find_map(|(typed, placed)| Some(format!("{typed}{}", file.strip_prefix(&placed[..])?)));
    found.unwrap_or_else(|| file.to_owned())
}

/// The error of the scene in one line: of scans with the option that mends it, of a value with its key.
fn worded(
    error: SceneError,
    text: &str,
    scan: Option<&ScanRequest>,
    as_typed: impl Fn(&str) -> String,
) -> String {
    let SceneProblem::Surface(surface) = error.problem else {
        return underlined(&error, text);
    };
    let error = match *surface {
        SurfaceError::Scans(error) => error,
        // Only the other face is called a spectrum unseen.
        SurfaceError::Scan { name, format } => {
            let name = as_typed(&name);
            return format!(
                "{}; use --counterface-scans {name}",
                SurfaceError::Scan { name: name.clone(), format }
            );
        }
        other => return other.to_string(),
    };
    let file = error.file.as_deref().map(as_typed);
    match error.problem {
        ScanProblem::Reading(error) => format!("reading {}: {error}", file.unwrap_or_default()),
        _ => refusal_of(scan, TopographyError { file, ..error }),
    }
}

/// The error of a value in the words of options, with the option as typed and a caret below its value.
fn underlined(error: &SceneError, text: &str) -> String {
    let span = error.span.clone().unwrap_or_default();
    let (before, value) = (text.get(..span.start).unwrap_or_default(), text.get(span).unwrap_or_default());
    let section = value.strip_prefix('[').or_else(|| Some(before.rsplit_once("\n[")?.1));
    let section = section.and_then(|section| section.split(']').next()).unwrap_or_default();
    let option = |section: &str, key: &str| match (section, key) {
        ("loads", _) => "--pressure".to_owned(),
        ("material", "name") => "--material".to_owned(),
        ("counterface", "name") => "--on".to_owned(),
        ("counterface", _) => format!("--counterface-{}", key.replace('_', "-")),
        _ => format!("--{}", key.replace('_', "-")),
    };
    let mut message = match &error.problem {
        SceneProblem::MissingKey { key } => format!("{key} is missing; add it"),
        problem => {
            problem.to_string().replace(" in [material]", "").replace("[counterface] ", "the counterface ")
        }
    };
    if let Some((section, key)) = error.key().and_then(|key| key.split_once('.')) {
        message = message.replacen(&format!("{section}.{key}:"), &format!("{}:", option(section, key)), 1);
    }
    for key in BodyProperty::ALL.map(BodyProperty::key).into_iter().filter(|key| key.contains('_')) {
        for section in ["material", "counterface"] {
            message = message.replace(&format!("{section}.{key}"), &option(section, key));
        }
        message =
            message.replace(key, &option(if section == "counterface" { section } else { "material" }, key));
    }
    let message = message.strip_prefix("key ").unwrap_or(&message);
    let key = before.rsplit('\n').next().and_then(|line| line.split_once(" = ")).map(|(key, _)| key);
    let value = value.trim_matches('"');
    let Some(key) = key.filter(|_| !value.contains('\n')) else { return message.to_owned() };
    let typed = if value.contains(' ') { format!("\"{value}\"") } else { value.to_owned() };
    let option = option(section, key);
    let (gap, carets) = (" ".repeat(option.len() + 1), "^".repeat(typed.chars().count()));
    format!("{message}\n  {option} {typed}\n  {gap}{carets}")
}

/// A quantity with a space before its unit: `10 MPa` of `10MPa`; text that is none stays as typed.
fn spaced(text: &str) -> String {
    if text.parse::<Pressure>().is_err() {
        return text.to_owned();
    }
    let unit = text.trim_end_matches(|c: char| !c.is_ascii_digit());
    let (number, unit) = text.split_at(unit.len());
    if number.is_empty() || unit.is_empty() || unit.starts_with(' ') {
        return text.to_owned();
    }
    format!("{number} {unit}")
}

/// `flange and 2 more scans`, after the first file.
fn default_title(files: &[ScanRequest]) -> String {
    match files.len() {
        0 | 1 => stem(files),
        2 => format!("{} and 1 more scan", stem(files)),
        count => format!("{} and {} more scans", stem(files), count - 1),
    }
}

fn default_folder(files: &[ScanRequest]) -> PathBuf {
    PathBuf::from(format!("{}-report", stem(files)))
}

/// The name of the first file without folder and extension.
fn stem(files: &[ScanRequest]) -> String {
    let name = files.first().map_or("", |file| file.path.as_str());
    let name = name.strip_prefix("builtin:").unwrap_or(name);
    Path::new(name)
        .file_stem()
        .map_or_else(|| "surface".to_owned(), |stem| stem.to_string_lossy().into_owned())
}
