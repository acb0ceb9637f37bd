//! `bem`: a surface pressed by boundary elements.

use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use elements::half_space::HalfSpaceError;
use elements::{Boundary, ContactField, ElementsError, IndenterShape, Relief, Surfaces};
use measurements::{ScanProblem, ScanRequest, TopographyError};
use questions::flow::{GapFlow, PressedFlow};
use questions::spots::PressedSpots;
use questions::{
    AdhesionQuestion, Answer, ElementsLoad, ElementsQuestion, IndenterQuestion, Prepared, QuestionError,
    relief_of_map,
};
use report::chart::maps::FieldPicture;
use report::provenance::program;
use report::{elements_figure, elements_words};
use spectrum::ReadOptions;
use study::measured::{Kind, Measured, MeasuredOptions};
use study::surface::{Surface, SurfaceError};
use tables::staging::{NewFolder, StagedFiles, folder_of};
use topography::{GapTreatment, Recipe};
use units::{Length, Remark, RemarkCode, WorkOfAdhesion};

use super::{Context, FaceReader, announce_figure, psd, reading_options, say_all};
use crate::args::{BemArgs, refuse_replaced};
use crate::failure::Failure;
use crate::files::Folder;
use crate::flags::{Flags, refuse_first};
use crate::inputs::announce;
use crate::memory;
use crate::output::{new_folder, stage};
use crate::picture::png_of_field;
use crate::place::Place;
use crate::progress::Progress;
use crate::timings::Timings;

pub(super) fn run(args: &BemArgs, context: &Context<'_>) -> Result<(), Failure> {
    if let Some(other) = args.leaves_strength_unused() {
        let strengths = args.material.given_strengths();
        refuse_first(strengths, Remark::new(RemarkCode::Replaced).with("other", other))?;
    }
    memory::refuse_beyond(args.random.grid)?;
    if let Some((radius, force)) = args.ball_radius.zip(args.force) {
        return press_indenter(args, IndenterShape::Ball, (radius.m, force.n), context);
    }
    if let Some((radius, force)) = args.cylinder_radius.zip(args.force_per_length) {
        return press_indenter(args, IndenterShape::Cylinder, (radius.m, force.n_per_m), context);
    }
    if let Some((work, range)) = args.work_of_adhesion.zip(args.adhesion_range) {
        return press_adhesive(args, work, range, context);
    }
    let question = ElementsQuestion {
        material: args.material(),
        loads: args.loads.pressures.clone().into_iter().map(ElementsLoad::Pressure).collect(),
        pressure_ranges: args.loads.pressure_ranges.clone(),
        saturation: args.saturation,
        tolerance: Some(args.tolerance),
        random: args.random.input(),
        compliance: args.map.compliance,
    };
    question.check()?;
    let spots_file = args.spots.spots.clone();
    let spots = spots_file.as_ref().map(|_| PressedSpots::new(&args.spots_input(), &question)).transpose()?;
    let mut timings = Timings::start();
    let boundary = args.map.boundary;
    let (prepared, comments) =
        prepare(args, context, boundary, |map| question.on_maps(vec![map]), |surface| question.on(surface))?;
    let fields = args.fields.as_deref().map(|folder| FieldFiles::new(folder, args)).transpose()?;
    timings.lap("reading");
    let progress = Progress::towards(prepared.steps(), "steps");
    let files = Mutex::new(StagedFiles::default());
    let patches = Mutex::new(Vec::new());
    let flow = args.flow.then(|| PressedFlow::new(args.flow_edges, &prepared.surfaces)).transpose()?;
    let see = |field: &ContactField<'_>| {
        if args.patches.is_some() {
            let found = field.patches().map_err(ElementsError::from)?;
            patches.lock().unwrap_or_else(PoisonError::into_inner).push(found);
        }
        let flow = flow.as_ref().map(|flow| flow.solve(field, &progress)).transpose()?;
        let shares = spots.as_ref().map(|spots| spots.solve(field, fields.is_some())).transpose()?.flatten();
        match &fields {
            Some(fields) => fields.stage(field, flow, shares, &files),
            None => Ok(()),
        }
    };
    let (mut pressed, mut notes) = prepared.answer::<Failure>(see, &progress)?;
    drop(progress);
    timings.lap("pressing");
    let mut table = match flow {
        Some(flow) => flow.table(&mut pressed, &mut notes, args.per_realisation),
        None if args.per_realisation => elements::states_table(&pressed),
        None => elements::means_table(&pressed),
    };
    let mut tables = Vec::new();
    if let Some((spots, path)) = spots.zip(spots_file) {
        let [with_resistances, of_spots] = spots.tables(table, &pressed, &mut notes, args.per_realisation)?;
        table = with_resistances;
        tables.push((of_spots, path));
    }
    if let Some(path) = &args.patches {
        let patches = patches.into_inner().unwrap_or_else(PoisonError::into_inner);
        tables.push((elements::patches_table(patches), path.clone()));
    }
    say_all(&notes, &Flags);
    let mut files = files.into_inner().unwrap_or_else(PoisonError::into_inner);
    if let Some(picture) = &args.figure.figure {
        let figure = elements_figure::area_against_load(&pressed);
        context.stage_picture(&mut files, picture, &figure, &args.surface.path, &comments)?;
    }
    context.stage_table(&mut files, &context.shared.output, context.wanted(&comments), &table)?;
    for (table, path) in tables {
        context.stage_table(&mut files, &Place::File(path), context.wanted(&comments), &table)?;
    }
    context.finish(files, timings)
}

impl From<ElementsError> for Failure {
    fn from(error: ElementsError) -> Self {
        match error {
            ElementsError::HalfSpace(HalfSpaceError::Cancelled) => Failure::Interrupted,
            error => Failure::input(error),
        }
    }
}

/// Presses a ball \[m, N\] or a cylinder \[m, N/m\] in place of a flat.
fn press_indenter(
    args: &BemArgs,
    shape: IndenterShape,
    (radius_m, force): (f64, f64),
    context: &Context<'_>,
) -> Result<(), Failure> {
    let question = IndenterQuestion {
        material: args.material(),
        shape,
        radius_m,
        force,
        tolerance: Some(args.tolerance),
        random: args.random.input(),
    };
    question.check()?;
    let mut timings = Timings::start();
    let boundary = (shape == IndenterShape::Ball).then_some(Boundary::Free);
    let (prepared, comments) =
        prepare(args, context, boundary, |map| question.on_map(map), |surface| question.on(surface))?;
    timings.lap("reading");
    write(|progress| prepared.answer(progress), args, &comments, timings, context)
}

/// Presses surfaces that attract each other, or pulls them apart.
fn press_adhesive(
    args: &BemArgs,
    work: WorkOfAdhesion,
    range: Length,
    context: &Context<'_>,
) -> Result<(), Failure> {
    let question = AdhesionQuestion {
        material: args.material(),
        pressures: args.loads.pressures.clone(),
        pressure_ranges: args.loads.pressure_ranges.clone(),
        work_of_adhesion_j_per_m2: work.j_per_m2,
        range_m: range.m,
        branch: args.branch.unwrap_or_default(),
        pull_off: args.pull_off,
        tolerance: Some(args.tolerance),
        per_realisation: args.per_realisation,
        random: args.random.input(),
    };
    question.check()?;
    let mut timings = Timings::start();
    let boundary = args.map.boundary;
    let (prepared, comments) =
        prepare(args, context, boundary, |map| question.on_maps(vec![map]), |surface| question.on(surface))?;
    timings.lap("reading");
    write(|progress| prepared.answer(progress), args, &comments, timings, context)
}

/// Finds an answer, says its notes, and writes its table and its figure.
fn write(
    answer: impl FnOnce(&Progress) -> Result<Answer, QuestionError>,
    args: &BemArgs,
    comments: &[String],
    mut timings: Timings,
    context: &Context<'_>,
) -> Result<(), Failure> {
    let progress = Progress::counting("steps");
    let answer = answer(&progress)?;
    drop(progress);
    timings.lap("pressing");
    context.publish_answer(&answer, &args.surface.path, comments, args.figure.figure.as_ref(), timings)
}

/// Map or spectrum of the file, and comments on where it comes from.
fn load(args: &BemArgs, context: &Context<'_>) -> Result<(Measured, Vec<String>), Failure> {
    let other = &args.reading.other;
    refuse_replaced(
        &[std::slice::from_ref(&args.surface), &other.counterface_scans].concat(),
        args.map.given(),
    )?;
    let complete = |file: &ScanRequest| args.map.treatment.complete(args.map.defaults.complete(file));
    let facing = match &other.counterface_scans[..] {
        [one] => Some(complete(one)),
        _ => None,
    };
    // Heights that nobody measured are not added to those of the other face.
    let gaps = if facing.is_some() { GapTreatment::Keep } else { GapTreatment::default() };
    let options = MeasuredOptions {
        kind: args.kind,
        spectrum: reading_options(&args.reading),
        recipe: Recipe { detrend: args.map.detrend, gaps, ..Recipe::default() },
        repeats: args.map.boundary == Some(Boundary::Periodic),
        facing,
    };
    let foreign = |kind: Kind| Remark::new(RemarkCode::OtherKindOfFile).with("kind", kind.to_string());
    announce_figure(args.figure.figure.as_ref())?;
    announce("--patches", args.patches.clone().map(Place::File))?;
    announce("--spots", args.spots.spots.clone().map(Place::File))?;
    let folder = Folder::current();
    let found = Measured::load(&complete(&args.surface), &folder, &options).map_err(|error| match error {
        SurfaceError::Scans(TopographyError {
            problem: ScanProblem::HoldsASpectrum,
            file: Some(file),
            ..
        }) => beside_a_map(&args.surface, &file),
        SurfaceError::Scans(error) => psd::refused(error),
        error => Failure::input(error),
    })?;
    let found = match found {
        Measured::Spectrum(own) => {
            let recipe = Recipe { gaps: GapTreatment::default(), ..options.recipe };
            let reader = FaceReader { folder: &folder, options: options.spectrum, recipe };
            Measured::Spectrum(match reader.counterface(other)? {
                Some(other) => Box::new(own.against(other)),
                None => own,
            })
        }
        map @ Measured::Map(_) => match (&other.counterface_psd, &other.counterface_scans[..]) {
            (Some(psd), _) => {
                return Err(beside_a_map(&args.surface, &psd.path));
            }
            (None, several @ [_, _, ..]) => {
                return Err(Failure::Input(format!(
                    "--counterface-scans: {} files are given, and a map is pressed onto one other map; give the one that faces {}",
                    several.len(),
                    args.surface.path
                )));
            }
            _ => map,
        },
    };
    let mut comments = vec![program(context.typed)];
    match &found {
        Measured::Map(map) => {
            let is_read = ("reading", reading_options(&args.reading) != ReadOptions::default());
            refuse_first(args.random.input().given().into_iter().chain([is_read]), foreign(Kind::Scan))?;
            say_all(&map.remarks, &Flags);
            comments.push(map.provenance.clone());
        }
        Measured::Spectrum(surface) => {
            refuse_first(args.map.given(), foreign(Kind::Spectrum))?;
            args.surface.check_takes(&[]).map_err(psd::refused)?;
            comments.extend(report::provenance::of_surface(surface));
        }
    }
    Ok((found, comments))
}

/// Refuses a spectrum that faces a map.
fn beside_a_map(own: &ScanRequest, other: &str) -> Failure {
    let own = &own.path;
    Failure::Input(format!(
        "{other}: a spectrum has no heights to add to those of {own}; give its map as --counterface-scans, or press the sum of both \
         spectra: `truearea psd {own} {other} --sum`"
    ))
}

/// Reads the surfaces and prepares them by one of two methods of a question; says the notes on them, and returns comments on where
/// they come from and how they were made.
fn prepare<P>(
    args: &BemArgs,
    context: &Context<'_>,
    boundary: Option<Boundary>,
    on_map: impl FnOnce(Relief) -> Result<Prepared<P>, QuestionError>,
    on: impl FnOnce(&Surface) -> Result<Prepared<P>, QuestionError>,
) -> Result<(Prepared<P>, Vec<String>), Failure> {
    let (measured, mut comments) = load(args, context)?;
    let prepared = match measured {
        Measured::Map(map) => {
            let own = if map.is_periodic { Boundary::Periodic } else { Boundary::Free };
            on_map(relief_of_map(&map.heights, boundary.unwrap_or(own)))?
        }
        Measured::Spectrum(surface) => on(&surface)?,
    };
    say_all(&prepared.notes, &Flags);
    if let Surfaces::Random(random) = &prepared.surfaces {
        comments.push(elements_words::random_surfaces(random));
    }
    Ok((prepared, comments))
}

/// The files of pressures and gaps, in a folder of their own.
struct FieldFiles {
    folder: PathBuf,
    /// The folder where it was made for them, which goes again where nothing comes of it.
    _made: Option<NewFolder>,
}

impl FieldFiles {
    fn new(folder: &Path, args: &BemArgs) -> Result<Self, Failure> {
        // A link and the file that it leads to may lie in two folders.
        let surface = Path::new(&args.surface.path);
        let names = [Some(surface.to_owned()), surface.canonicalize().ok()];
        let lies_in_folder =
            |file: &PathBuf| folder.canonicalize().ok() == folder_of(file).canonicalize().ok();
        if surface.is_file() && names.iter().flatten().any(lies_in_folder) {
            return Err(Failure::Input(format!(
                "--fields {}: the surface is a file of this folder, and results might replace it; name another folder",
                folder.display()
            )));
        }
        Ok(FieldFiles { folder: folder.to_owned(), _made: new_folder("--fields", folder)? })
    }

    /// Writes one surface under one load aside: `load-1-surface-1.nc`, and two pictures, with the flow two more, with shares of the
    /// current one more.
    fn stage(
        &self,
        field: &ContactField<'_>,
        flow: Option<GapFlow>,
        shares: Option<Vec<f64>>,
        files: &Mutex<StagedFiles>,
    ) -> Result<(), Failure> {
        let stem = format!("load-{}-surface-{}", field.load + 1, field.surface + 1);
        let mut pictures =
            vec![("pressure", FieldPicture::of_pressure(field)), ("gap", FieldPicture::of_gap(field))];
        let further = flow.iter().flat_map(|flow| flow.variables(field.gaps_m.len())).collect::<Vec<_>>();
        if let Some(GapFlow { along_x, along_y, .. }) = &flow {
            let Relief { columns, length_x_m, length_y_m, .. } = *field.relief;
            let (load, gaps_m) = (Some(field.nominal_pressure_pa), field.closed_gaps_m());
            for (axis, name, flow) in [("x", "flow-x", along_x), ("y", "flow-y", along_y)] {
                let size_m = [length_x_m, length_y_m];
                let picture = FieldPicture::of_flow(axis, load, &flow.flux, &gaps_m, columns, size_m);
                pictures.push((name, picture));
            }
        }
        pictures.extend(shares.map(|shares| ("current", FieldPicture::of_current(field, &shares))));
        let mut contents = Vec::new();
        for (what, picture) in pictures {
            if let Some(bytes) = png_of_field(&picture).map_err(|error| Failure::System(error.to_string()))? {
                contents.push((format!("{stem}-{what}.png"), bytes));
            }
        }
        let mut netcdf = Vec::new();
        field.write_netcdf(&further, &mut netcdf).map_err(|error| Failure::writing(&stem, &error))?;
        contents.push((format!("{stem}.nc"), netcdf));
        let mut files = files.lock().unwrap_or_else(PoisonError::into_inner);
        for (name, bytes) in contents {
            stage(&mut files, &self.folder.join(name), |out| out.write_all(&bytes))?;
        }
        Ok(())
    }
}
