//! `scan`: what is in the files of instruments.

use std::ffi::OsString;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};

use measurements::{Channels, read_channels};
use report::chart::maps::HeightsPicture;
use report::provenance::program;
use scans::ScanFile;
use tables::staging::StagedFiles;

use super::{Context, psd};
use crate::args::ScanArgs;
use crate::failure::Failure;
use crate::files::Folder;
use crate::inputs::spare_inputs;
use crate::output::{publish, stage};
use crate::picture::Picture;
use crate::place::Place;
use crate::stderr::say;
use crate::targets::Targets;
use crate::timings::Timings;

pub(super) fn run(args: &ScanArgs, context: &Context<'_>) -> Result<(), Failure> {
    let requests = args.defaults.complete_all(&args.files)?;
    let folder = Folder::current(context.targets(args.figure.as_ref())?);
    let requests = psd::scans_in_folders(&requests, &folder)?;
    let mut timings = Timings::start();
    let mut files = StagedFiles::default();
    let mut drawn = Vec::new();
    let mut found: Channels = read_channels(&requests, &folder, args.all_channels, |request, file| {
        let Some(picture) = &args.figure else { return Ok(()) };
        let picture = picture.with_path(numbered(&picture.path, drawn.len() + 1));
        if stage_heights(&mut files, &picture, file)? {
            let channel = file.channel.as_ref().map_or_else(String::new, |channel| format!(", {channel}"));
            drawn.push((picture.path, format!("{}{channel}", request.path)));
        }
        Ok::<(), Failure>(())
    })?;
    let pictures: Vec<PathBuf> = drawn.iter().map(|(path, _)| path.clone()).collect();
    spare_inputs(&Targets::default().with_files("--figure", &pictures)?)?;
    timings.lap("reading");
    let refusals: Vec<String> = std::mem::take(&mut found.unreadable).into_iter().map(psd::refusal).collect();
    let comments = [program(context.typed)];
    let table = found.table();
    // Rows of readable files are written before the unreadable ones end the command.
    if table.rows() == 0 && !refusals.is_empty() {
        return Err(Failure::Input(refusals.join("\n")));
    }
    let shared = &context.shared;
    let for_people =
        shared.output == Place::Standard && shared.format.is_none() && shared.provenance.is_none();
    if for_people && std::io::stdout().is_terminal() {
        shared.output.stage(&mut files, |out| out.write_all(found.describe().as_bytes()))?;
    } else {
        context.stage_blocks(&mut files, &context.shared.output, context.wanted(&comments), |out| {
            Ok(out.block(&table)?)
        })?;
    }
    publish(files)?;
    if drawn.len() > 1 {
        drawn.iter().for_each(|(path, channel)| say(&format!("{}: {channel}", path.display())));
    }
    timings.lap("writing");
    timings.report(context.shared.timings);
    if refusals.is_empty() { Ok(()) } else { Err(Failure::Input(refusals.join("\n"))) }
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
