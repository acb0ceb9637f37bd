//! `flow`: flow through a gap, point by point.

use std::path::{Path, PathBuf};

use questions::flow::{GapMap, GapMapError};
use report::chart::maps::FieldPicture;
use report::provenance::program;
use tables::staging::StagedFiles;

use super::{Context, psd, say_all};
use crate::args::FlowArgs;
use crate::failure::Failure;
use crate::files::Folder;
use crate::flags::Flags;
use crate::inputs::announce;
use crate::output::stage;
use crate::picture::Picture;
use crate::place::Place;
use crate::progress::Progress;
use crate::timings::Timings;

pub(super) fn run(args: &FlowArgs, context: &Context<'_>) -> Result<(), Failure> {
    let requests = args.defaults.complete_all(std::slice::from_ref(&args.gap))?;
    args.figure.iter().try_for_each(Picture::check_of_points).map_err(Failure::input)?;
    let figures: Vec<(PathBuf, PathBuf)> =
        args.figure.iter().map(|picture| (picture.path.clone(), along_y(&picture.path))).collect();
    announce("--figure", figures.iter().flat_map(|(x, y)| [x, y]).cloned().map(Place::File))?;
    let mut timings = Timings::start();
    let gap = GapMap::read(&requests[0], &Folder::current()).map_err(|error| match error {
        GapMapError::File(error) => psd::refused(error),
        error => Failure::input(error),
    })?;
    timings.lap("reading");
    let progress = Progress::counting("steps");
    let (flow, answer) = gap.flow(args.edges, &progress)?;
    drop(progress);
    timings.lap("solving");
    say_all(&answer.notes, &Flags);
    let mut files = StagedFiles::default();
    let size_m = [gap.grid.length_x_m(), gap.grid.length_y_m()];
    if let Some(picture) = &args.figure {
        let along =
            [("x", &flow.along_x, picture.path.clone()), ("y", &flow.along_y, along_y(&picture.path))];
        for (axis, flow, path) in along {
            let drawn =
                FieldPicture::of_flow(axis, None, &flow.flux, &gap.gaps_m, gap.grid.columns(), size_m);
            let picture = picture.with_path(path);
            let bytes = picture.bytes_of_field(&drawn).map_err(|error| Failure::System(error.to_string()))?;
            stage(&mut files, &picture.path, |out| out.write_all(&bytes))?;
        }
    }
    let comments = [program(context.typed), gap.provenance];
    context.stage_table(&mut files, &context.shared.output, context.wanted(&comments), &answer.table)?;
    context.finish(files, timings)
}

/// `flow-y.png` beside `flow.png`.
fn along_y(path: &Path) -> PathBuf {
    let mut name = path.file_stem().unwrap_or_default().to_owned();
    name.push("-y.");
    name.push(path.extension().unwrap_or_default());
    path.with_file_name(name)
}
