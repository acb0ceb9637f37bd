//! `bem`: a surface pressed by boundary elements.

use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use gaussian_surfaces::AreaSpectrum;
use half_space::HalfSpaceError;
use measurements::MapOfFile;
use report::provenance::program;
use report::{elements_figure, elements_words, field_picture};
use rough_bem::{Boundary, ElementsError, Field, Pressing, RandomChoices, RandomSurfaces, Relief, Surfaces};
use spectrum::ReadOptions;
use staging::{NewFolder, StagedFiles};
use study::measured::{Kind, Measured, MeasuredOptions};
use study::surface::{Surface, SurfaceError};
use topography::Recipe;

use super::material_options::{loads, material};
use super::{Context, psd, reading_options, say_notes, say_surface};
use crate::args::{BemArgs, RandomArgs};
use crate::failure::Failure;
use crate::files::Folder;
use crate::output::{publish, stage};
use crate::picture::png_of_field;
use crate::progress::Progress;
use crate::timings::Timings;

pub(super) fn run(args: &BemArgs, context: &Context<'_>) -> Result<(), Failure> {
    let pressing = pressing(args)?;
    let mut timings = Timings::start();
    let (surfaces, comments) = load(args, &pressing, context)?;
    let fields = args.fields.as_deref().map(|folder| FieldFiles::new(folder, args)).transpose()?;
    timings.lap("reading");
    let progress = Progress::towards(rough_bem::progress_steps(&surfaces, &pressing), "steps");
    let files = Mutex::new(StagedFiles::default());
    let see = |field: &Field<'_>| match &fields {
        Some(fields) => fields.stage(field, &files),
        None => Ok(()),
    };
    let pressed = rough_bem::press::<Failure>(&surfaces, &pressing, see, &progress)?;
    drop(progress);
    timings.lap("pressing");
    say_notes(elements_words::of_results(&pressed));
    let table = if args.per_realisation {
        rough_bem::states_table(&pressed)
    } else {
        rough_bem::means_table(&pressed)
    };
    let mut files = files.into_inner().unwrap_or_else(PoisonError::into_inner);
    if let Some(picture) = &args.figure.figure {
        let figure = elements_figure::area_against_load(&pressed);
        context.stage_picture(&mut files, picture, &figure, &args.surface.path, &comments)?;
    }
    context.stage_blocks(&mut files, &context.shared.output, context.wanted(&comments), |out| {
        Ok(out.block(&table)?)
    })?;
    publish(files)?;
    if let Some(fields) = fields {
        fields.keep();
    }
    timings.lap("writing");
    timings.report(context.shared.timings);
    Ok(())
}

impl From<ElementsError> for Failure {
    fn from(error: ElementsError) -> Self {
        match error {
            ElementsError::HalfSpace(HalfSpaceError::Cancelled) => Failure::Interrupted,
            error => Failure::input(error),
        }
    }
}

/// Material, loads and tolerance, all refused that cannot be before anything is read.
fn pressing(args: &BemArgs) -> Result<Pressing, Failure> {
    let material = material(&args.material.without_growth())?;
    let (loads, ranges) = loads(&args.pressures, &args.pressure_ranges, &material)?;
    let of_ranges = ranges.into_iter().flat_map(|range| range.pressures().map(|pressure| pressure.pa()));
    let saturation_pa = args.saturation.map(|saturation| {
        saturation.pascals(material.hardness_pa()).ok_or_else(|| {
            Failure::input(
                "--saturation is given in H, and the material has no hardness: add --indentation-hardness or \
                            --yield-strength",
            )
        })
    });
    let pressing = Pressing {
        pressures_pa: loads.iter().map(|load| load.nominal_pressure_pa()).chain(of_ranges).collect(),
        saturation_pa: saturation_pa.transpose()?,
        tolerance: args.tolerance,
        stiffness: true,
        ..Pressing::elastic(material.pair.composite_modulus_pa())
    };
    pressing.check().map_err(|error| match error {
        HalfSpaceError::CannotBeCarried { nominal_pressure_pa, saturation_pa } => Failure::Input(
            elements_words::cannot_be_carried(nominal_pressure_pa, saturation_pa, "--saturation"),
        ),
        error => Failure::input(error),
    })?;
    Ok(pressing)
}

/// The surfaces, and where they come from.
fn load(
    args: &BemArgs,
    pressing: &Pressing,
    context: &Context<'_>,
) -> Result<(Surfaces, Vec<String>), Failure> {
    let request = args.map.treatment.told_of(args.map.untold.told_of(&args.surface));
    let options = MeasuredOptions {
        kind: args.kind,
        spectrum: reading_options(&args.reading),
        recipe: Recipe { detrend: args.map.detrend, ..Recipe::default() },
    };
    let folder = Folder::current(context.targets(args.figure.figure.as_ref())?);
    let found = Measured::load(&request, &folder, &options).map_err(|error| match error {
        SurfaceError::Scans(error) => psd::refused(error),
        error => Failure::input(error),
    })?;
    let mut comments = vec![program(context.typed)];
    match found {
        Measured::Map(map) => {
            refuse_foreign(Kind::Scan, args.random.given(), &args.reading)?;
            psd::say_remarks(&map.remarks);
            comments.push(map.provenance.clone());
            Ok((Surfaces::Map(relief(*map, args.map.boundary)), comments))
        }
        Measured::Spectrum(surface) => {
            refuse_foreign(Kind::Spectrum, args.map.given(), &args.reading)?;
            say_surface(&surface);
            let random = random_surfaces(&surface, &args.random, pressing)?;
            comments.extend(report::provenance::of_surface(&surface));
            comments.push(elements_words::random_surfaces(&random));
            Ok((Surfaces::Random(random), comments))
        }
    }
}

/// Refuses options that mean something for the other kind of file.
fn refuse_foreign(
    kind: Kind,
    mut given: impl Iterator<Item = &'static str>,
    reading: &crate::args::ReadingArgs,
) -> Result<(), Failure> {
    let of_spectra = (kind == Kind::Scan && reading_options(reading) != ReadOptions::default())
        .then_some("an option for reading spectra");
    match given.next().or(of_spectra) {
        None => Ok(()),
        Some(option) => Err(Failure::Input(format!(
            "{option} has no bearing on a {kind}; leave it out, or say what the file is with --as"
        ))),
    }
}

/// A map as it is pressed.
fn relief(map: MapOfFile, boundary: Option<Boundary>) -> Relief {
    let of_file = if map.is_periodic { Boundary::Periodic } else { Boundary::Free };
    let map_m = &map.map;
    Relief {
        rows: map_m.rows(),
        columns: map_m.columns(),
        length_x_m: map_m.columns() as f64 * map_m.spacing_x_m(),
        length_y_m: map_m.rows() as f64 * map_m.spacing_y_m(),
        heights_m: map_m.heights_m().to_vec(),
        boundary: boundary.unwrap_or(of_file),
    }
}

/// Surfaces that have a spectrum in the band that the grid holds.
pub(super) fn random_surfaces(
    surface: &Surface,
    random: &RandomArgs,
    pressing: &Pressing,
) -> Result<RandomSurfaces, Failure> {
    let named = |error: gaussian_surfaces::SurfaceError| Failure::Input(format!("{}: {error}", surface.name));
    say_notes(surface.of_area.iter().map(|_| elements_words::TAKEN_AS_IT_IS.to_owned()));
    let area = match &surface.of_area {
        Some(psd) => AreaSpectrum::from_psd(psd),
        None => AreaSpectrum::from_profile(&surface.psd),
    };
    let area = area.map_err(named)?;
    let usual = RandomChoices::default();
    let [longest_m, shortest_m, side_m] =
        [random.longest, random.shortest, random.side].map(|length| length.map(|length| length.m));
    let choices = RandomChoices {
        points: random.grid.map_or(usual.points, |points| points as usize),
        realisations: random.realisations.map_or(usual.realisations, |count| count.get() as usize),
        seed: random.seed.unwrap_or(usual.seed),
        longest_m,
        shortest_m,
        side_m,
        phases: random.phases.unwrap_or_default(),
    };
    let (random, grid) = choices.surfaces(&area).map_err(named)?;
    say_notes(elements_words::of_surfaces(&area, &random, &grid, pressing.contact_modulus_pa));
    Ok(random)
}

/// The files of pressures and gaps, in a folder of their own.
struct FieldFiles {
    folder: PathBuf,
    /// The folder where it was made for them, which goes again where nothing comes of it.
    made: Option<NewFolder>,
}

impl FieldFiles {
    fn new(folder: &Path, args: &BemArgs) -> Result<Self, Failure> {
        let name = folder.display();
        if folder.is_file() {
            return Err(Failure::Input(format!(
                "--fields {name}: results go into a folder, and this is a file; name a folder"
            )));
        }
        let surface = Path::new(&args.surface.path);
        let beside =
            surface.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        if surface.is_file() && folder.canonicalize().ok() == beside.canonicalize().ok() {
            return Err(Failure::Input(format!(
                "--fields {name}: the surface is a file of this folder, and results might replace it; name another folder"
            )));
        }
        let made = NewFolder::make(folder).map_err(|error| Failure::writing(&name.to_string(), &error))?;
        Ok(FieldFiles { folder: folder.to_owned(), made })
    }

    /// Writes one surface under one load aside: `load-1-surface-1.nc`, and two pictures.
    fn stage(&self, field: &Field<'_>, files: &Mutex<StagedFiles>) -> Result<(), Failure> {
        let stem = format!("load-{}-surface-{}", field.load + 1, field.surface + 1);
        let pictures =
            [("pressure", field_picture::of_pressure(field)), ("gap", field_picture::of_gap(field))];
        let mut contents = Vec::new();
        for (what, picture) in pictures {
            if let Some(bytes) = png_of_field(&picture).map_err(|error| Failure::System(error.to_string()))? {
                contents.push((format!("{stem}-{what}.png"), bytes));
            }
        }
        let mut netcdf = Vec::new();
        field.write_netcdf(&mut netcdf).map_err(|error| Failure::writing(&stem, &error))?;
        contents.push((format!("{stem}.nc"), netcdf));
        let mut files = files.lock().unwrap_or_else(PoisonError::into_inner);
        for (name, bytes) in contents {
            stage(&mut files, &self.folder.join(name), |out| out.write_all(&bytes))?;
        }
        Ok(())
    }

    /// The folder stays, with what is in it.
    fn keep(self) {
        if let Some(made) = self.made {
            made.keep();
        }
    }
}
