//! `scan`: what is in the files of instruments.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use measurements::{Channels, Loaded, ScanRequest, read_channels};
use report::chart::maps::HeightsPicture;
use report::provenance::program;
use scans::ScanFile;
use tables::staging::StagedFiles;

use super::readable::Readable;
use super::{Context, announce_figure, psd};
use crate::args::ScanArgs;
use crate::failure::Failure;
use crate::files::Folder;
use crate::inputs::{announce, spare_inputs};
use crate::output::stage;
use crate::picture::Picture;
use crate::place::Place;
use crate::targets::Targets;
use crate::timings::Timings;
use crate::written::WrittenScan;

pub(super) fn run(args: &ScanArgs, context: &Context<'_>) -> Result<(), Failure> {
    let requests = args.defaults.complete_all(&args.files)?;
    announce_figure(args.figure.as_ref())?;
    announce("--write", args.write.as_ref().map(WrittenScan::place))?;
    let folder = Folder::current();
    let requests = psd::scans_in_folders(&requests, &folder)?;
    let mut timings = Timings::start();
    let mut files = StagedFiles::default();
    let mut drawn = Vec::new();
    let found: Channels = read_channels(&requests, &folder, args.all_channels, |request, file| {
        let Some(picture) = &args.figure else { return Ok(()) };
        let picture = picture.with_path(numbered(&picture.path, drawn.len() + 1));
        if stage_heights(&mut files, &picture, file)? {
            let channel = file.channel.as_ref().map_or_else(String::new, |channel| format!(", {channel}"));
            drawn.push((picture.path, format!("{}{channel}", request.path)));
        }
        Ok::<(), Failure>(())
    })?;
    let written = args.write.as_ref().map(|target| write(target, &requests, &folder, context, &mut files));
    let written = written.transpose()?;
    let pictures = drawn.iter().map(|(path, _)| Place::File(path.clone()));
    spare_inputs(&Targets::named("--figure", pictures)?)?;
    timings.lap("reading");
    let channels = drawn.iter().map(|(path, channel)| format!("{}: {channel}", path.display()));
    Readable {
        table: found.table(),
        for_people: Some(found.describe()),
        lines: channels.filter(|_| drawn.len() > 1).chain(written).collect(),
        unreadable: found.unreadable,
    }
    .write(files, timings, context)
}

/// `heights.png`, `heights-2.png`, `heights-3.png`.
fn numbered(path: &Path, number: usize) -> PathBuf {
    if number == 1 {
        return path.to_owned();
    }
    let mut name = path.file_stem().map_or_else(OsString::new, OsString::from);
    name.push(format!("-{number}"));
    if let Some(ending) = path.extension() {
        name.push(".");
        name.push(ending);
    }
    path.with_file_name(name)
}

/// Stages a picture of the heights. Returns false if there is nothing to draw.
fn stage_heights(files: &mut StagedFiles, picture: &Picture, file: &ScanFile) -> Result<bool, Failure> {
    let bytes = match HeightsPicture::new(file) {
        None => return Ok(false),
        Some(HeightsPicture::Line(svg)) => picture.bytes(svg),
        Some(HeightsPicture::Map(map)) => picture.bytes_of_field(&map),
    };
    let bytes = bytes.map_err(|error| Failure::System(error.to_string()))?;
    stage(files, &picture.path, |out| out.write_all(&bytes))?;
    Ok(true)
}

/// Stages the heights of the channel that is asked for, else of the first with heights. Returns a line on it.
fn write(
    target: &WrittenScan,
    requests: &[ScanRequest],
    folder: &Folder,
    context: &Context<'_>,
    files: &mut StagedFiles,
) -> Result<String, Failure> {
    let path = target.path.display();
    let [request] = requests else {
        return Err(Failure::Input(format!(
            "--write {path} takes one file, and {} are given: write each by a command of its own",
            requests.len()
        )));
    };
    let loaded = Loaded::read(request, folder).map_err(|error| Failure::Input(psd::refusal(error)))?;
    let [scan] = &loaded.scans[..] else {
        let names: Vec<&str> = loaded.scans.iter().map(|scan| scan.name.as_str()).collect();
        return Err(Failure::Input(format!(
            "--write {path} takes one scan, and {} holds {}: choose one with measurement=",
            request.path,
            names.join(", ")
        )));
    };
    let name = Path::new(&request.path).file_name().unwrap_or_default().display();
    let provenance = format!("{}; {name} has SHA-256 {}", program(context.typed), loaded.sha256);
    let bytes = target.format.write(scan, &provenance);
    let bytes = bytes.map_err(|error| Failure::Input(format!("writing {path}: {error}")))?;
    stage(files, &target.path, |out| out.write_all(&bytes))?;
    let channel = scan.channel.as_ref().map_or_else(String::new, |channel| format!(", {channel}"));
    Ok(format!("{path}: {}{channel}", request.path))
}
