//! Surfaces pressed by boundary elements.

use std::ops::RangeInclusive;
use std::str::FromStr;
use std::sync::{Mutex, PoisonError};

use findings::doubts::Doubt;
use gaussian_surfaces::{AreaSpectrum, Phases};
use half_space::HalfSpaceError;
use numpy::{PyArrayDyn, PyArrayMethods, PyReadonlyArray2, PyReadwriteArrayDyn};
use parallel::Progress;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyCFunction, PyDict, PyString, PyTuple};
use report::{doubt_words, elements_words};
use rough_bem::{Boundary, ElementsError, Field, PressedLoad, Pressing, RandomChoices, RandomSurfaces};
use rough_bem::{Relief, Surfaces};
use scans::HeightMap;
use study::material::Material;
use topography::{Detrend, Recipe, detrended_m};
use units::{Length, Pressure, UnknownName};

use crate::errors::{input, of_argument};
use crate::material::{PyMaterial, loads};
use crate::quantities::{Given, optional, quantity, type_name};
use crate::surface::{PySurface, named, notes};
use crate::tables::columns;
use crate::work::carry_out;

/// Choices for random surfaces.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct GivenRandom<'py> {
    grid: Option<Bound<'py, PyAny>>,
    realisations: Option<Bound<'py, PyAny>>,
    seed: Option<Bound<'py, PyAny>>,
    longest: Option<Bound<'py, PyAny>>,
    shortest: Option<Bound<'py, PyAny>>,
    side: Option<Bound<'py, PyAny>>,
    phases: Option<Bound<'py, PyAny>>,
}

/// Result of a call: a table, the fields where they are asked for, and the notes.
type Found<'py> = (Bound<'py, PyDict>, Option<Fields<'py>>, Vec<String>);

/// Pressures \[Pa\] and gaps \[m\] of surface after surface under load after load, and the heights \[m\] of the surfaces.
type Fields<'py> = (Bound<'py, PyArrayDyn<f64>>, Bound<'py, PyArrayDyn<f64>>, Bound<'py, PyArrayDyn<f64>>);

/// Presses a map of heights \[m\], row by row along x. `repeats` says whether the heights repeat themselves beyond the map, and
/// `periodic` whether they are pressed so.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the arguments of a call from Python, by name")]
pub fn press_heights<'py>(
    py: Python<'py>,
    heights_m: PyReadonlyArray2<'py, f64>,
    size: [Given<'py>; 2],
    repeats: bool,
    periodic: bool,
    detrend: Option<&str>,
    material: &PyMaterial,
    pressure: &Given<'py>,
    saturation: Option<&Given<'py>>,
    tolerance: f64,
    fields: bool,
    observer: Option<Py<PyAny>>,
) -> PyResult<Found<'py>> {
    let material = &material.material;
    let pressing = pressing(material, pressures_pa(material, pressure)?, saturation, tolerance)?;
    let [x, y] = &size;
    let [length_x, length_y]: [Length; 2] = [quantity("size[0]", x)?, quantity("size[1]", y)?];
    let detrend = detrend.map(|name| named::<Detrend>("detrend", name)).transpose()?;
    let boundary = if periodic { Boundary::Periodic } else { Boundary::Free };
    let detrend = Recipe { detrend, ..Recipe::default() }.preparation(repeats).detrend;
    let relief = relief(&heights_m, [length_x.m, length_y.m], boundary, detrend)?;
    let asked = Asked { table: Table::Means, fields, observer };
    press(py, &Surfaces::Map(relief), &pressing, asked, of_material(material))
}

/// Presses random surfaces that have a spectrum.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the arguments of a call from Python, by name")]
pub fn press_spectrum<'py>(
    py: Python<'py>,
    surface: &PySurface,
    random: GivenRandom<'py>,
    material: &PyMaterial,
    pressure: &Given<'py>,
    saturation: Option<&Given<'py>>,
    tolerance: f64,
    per_realisation: bool,
    fields: bool,
    observer: Option<Py<PyAny>>,
) -> PyResult<Found<'py>> {
    let material = &material.material;
    let pressing = pressing(material, pressures_pa(material, pressure)?, saturation, tolerance)?;
    let mut said = notes(&surface.surface);
    said.extend(of_material(material));
    let (random, words) = random_surfaces(surface, &random.choices()?, &pressing)?;
    said.extend(words);
    let table = if per_realisation { Table::States } else { Table::Means };
    let asked = Asked { table, fields, observer };
    press(py, &Surfaces::Random(random), &pressing, asked, said)
}

/// Requested results, and the observer of the steps.
struct Asked {
    table: Table,
    fields: bool,
    observer: Option<Py<PyAny>>,
}

/// Rows of the table under a load.
#[derive(Clone, Copy)]
enum Table {
    /// Their mean.
    Means,
    /// Each of them.
    States,
}

fn press<'py>(
    py: Python<'py>,
    surfaces: &Surfaces,
    pressing: &Pressing,
    Asked { table, fields, observer }: Asked,
    mut said: Vec<String>,
) -> PyResult<Found<'py>> {
    let fields = fields.then(|| empty_fields(py, surfaces, pressing.pressures_pa.len())).transpose()?;
    let loads = match &fields {
        None => pressed(py, surfaces, pressing, observer, |_| ())?,
        Some((pressures_pa, gaps_m, heights_m)) => {
            let mut written = [pressures_pa, gaps_m, heights_m].map(|array| array.readwrite());
            let [pressures_pa, gaps_m, heights_m] = written.each_mut().map(|array| maps(array, surfaces));
            let (pressures_pa, gaps_m, heights_m) = (pressures_pa?, gaps_m?, heights_m?);
            let count = surfaces.count();
            pressed(py, surfaces, pressing, observer, |field| {
                let at = field.load * count + field.surface;
                write(&pressures_pa[at], field.pressures_pa);
                write(&gaps_m[at], field.gaps_m);
                write(&heights_m[field.surface], &field.relief.heights_m);
            })?
        }
    };
    said.extend(elements_words::of_results(&loads));
    let table = match table {
        Table::Means => rough_bem::means_table(&loads),
        Table::States => rough_bem::states_table(&loads),
    };
    Ok((columns(py, &table)?, fields, said))
}

/// Every surface under every load; `observer` is told of the steps, and `see` is shown each surface as it is solved.
pub fn pressed(
    py: Python<'_>,
    surfaces: &Surfaces,
    pressing: &Pressing,
    observer: Option<Py<PyAny>>,
    see: impl Fn(&Field<'_>) + Sync + Send,
) -> PyResult<Vec<PressedLoad>> {
    let seen = |field: &Field<'_>| -> Result<(), ElementsError> {
        see(field);
        Ok(())
    };
    let steps = rough_bem::progress_steps(surfaces, pressing);
    let told = |observer: Py<PyAny>| {
        PyCFunction::new_closure(py, None, None, move |done: &Bound<'_, PyTuple>, _| -> PyResult<()> {
            observer.call1(done.py(), ("steps", done.get_item(0)?, steps)).map(drop)
        })
    };
    let observer = observer.map(told).transpose()?;
    let press = |progress: &dyn Progress| rough_bem::press(surfaces, pressing, seen, progress);
    carry_out(py, observer.as_ref().map(|observer| observer.as_any()), press)?.map_err(input)
}

/// Arrays of zeros as large as the fields, which numpy refuses where there is no room for them.
fn empty_fields<'py>(py: Python<'py>, surfaces: &Surfaces, loads: usize) -> PyResult<Fields<'py>> {
    let (rows, columns) = points(surfaces);
    let of_map = match surfaces {
        Surfaces::Random(random) => vec![random.realisations, rows, columns],
        _ => vec![rows, columns],
    };
    let of_load = [vec![loads], of_map.clone()].concat();
    let zeros = |shape: &[usize]| -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let zeros = py.import("numpy")?.call_method1("zeros", (PyTuple::new(py, shape)?,))?;
        Ok(zeros.cast_into()?)
    };
    Ok((zeros(&of_load)?, zeros(&of_load)?, zeros(&of_map)?))
}

/// Points along y and along x.
fn points(surfaces: &Surfaces) -> (usize, usize) {
    match surfaces {
        Surfaces::Map(relief) => (relief.rows, relief.columns),
        Surfaces::Random(random) => (random.synthesis.points_y, random.synthesis.points_x),
        _ => (0, 0),
    }
}

/// The maps in an array, one after the other.
fn maps<'a>(
    array: &'a mut PyReadwriteArrayDyn<'_, f64>,
    surfaces: &Surfaces,
) -> PyResult<Vec<Mutex<&'a mut [f64]>>> {
    let (rows, columns) = points(surfaces);
    let slice = array.as_slice_mut().map_err(input)?;
    Ok(slice.chunks_exact_mut((rows * columns).max(1)).map(Mutex::new).collect())
}

fn write(map: &Mutex<&mut [f64]>, values: &[f64]) {
    map.lock().unwrap_or_else(PoisonError::into_inner).copy_from_slice(values);
}

/// A map as it is pressed: less its trend.
fn relief(
    heights_m: &PyReadonlyArray2<'_, f64>,
    [length_x_m, length_y_m]: [f64; 2],
    boundary: Boundary,
    detrend: Detrend,
) -> PyResult<Relief> {
    let view = heights_m.as_array();
    let (rows, columns) = view.dim();
    let spacings_m = [length_x_m / columns as f64, length_y_m / rows as f64];
    let map = HeightMap::new(columns, spacings_m[0], spacings_m[1], view.iter().copied().collect());
    let map = map.map_err(|error| of_argument("h", error))?;
    Ok(Relief { rows, columns, length_x_m, length_y_m, heights_m: detrended_m(&map, detrend), boundary })
}

fn pressures_pa(material: &Material, pressure: &Given<'_>) -> PyResult<Vec<f64>> {
    let loads = loads("pressure", pressure, material)?;
    Ok(loads.iter().map(|load| load.nominal_pressure_pa()).collect())
}

/// Material, loads and tolerance; what cannot be carried is refused.
pub fn pressing(
    material: &Material,
    pressures_pa: Vec<f64>,
    saturation: Option<&Given<'_>>,
    tolerance: f64,
) -> PyResult<Pressing> {
    let saturation: Option<Pressure> = optional("saturation", saturation)?;
    let saturation_pa = saturation.map(|saturation| {
        saturation.pascals(material.hardness_pa()).ok_or_else(|| {
            input(
                "saturation is given in H, and the material has no hardness: give the material indentation_hardness or \
                 yield_strength",
            )
        })
    });
    let pressing = Pressing {
        pressures_pa,
        saturation_pa: saturation_pa.transpose()?,
        tolerance,
        stiffness: true,
        ..Pressing::elastic(material.pair.composite_modulus_pa())
    };
    pressing.check().map_err(|error| match error {
        HalfSpaceError::CannotBeCarried { nominal_pressure_pa, saturation_pa } => {
            input(elements_words::cannot_be_carried(nominal_pressure_pa, saturation_pa, "saturation"))
        }
        error => input(error),
    })?;
    Ok(pressing)
}

/// Surfaces that have a spectrum in the band that the grid holds, and what there is to say of them.
pub fn random_surfaces(
    surface: &PySurface,
    choices: &RandomChoices,
    pressing: &Pressing,
) -> PyResult<(RandomSurfaces, Vec<String>)> {
    let surface = &surface.surface;
    let named = |error: gaussian_surfaces::SurfaceError| of_argument(&surface.name, error);
    let area = match &surface.of_area {
        Some(psd) => AreaSpectrum::from_psd(psd),
        None => AreaSpectrum::from_profile(&surface.psd),
    };
    let area = area.map_err(named)?;
    let (random, grid) = choices.surfaces(&area).map_err(named)?;
    let mut said: Vec<String> =
        surface.of_area.iter().map(|_| elements_words::TAKEN_AS_IT_IS.to_owned()).collect();
    said.extend(elements_words::of_surfaces(&area, &random, &grid, pressing.contact_modulus_pa));
    Ok((random, said))
}

/// Words the doubts about a material.
fn of_material(material: &Material) -> Vec<String> {
    Doubt::of_material(material)
        .iter()
        .map(|doubt| format!("doubtful: {}", doubt_words::line(doubt)))
        .collect()
}

impl GivenRandom<'_> {
    /// The first argument that is given.
    pub fn given(&self) -> Option<&'static str> {
        let given = [
            ("grid", self.grid.is_some()),
            ("realisations", self.realisations.is_some()),
            ("seed", self.seed.is_some()),
            ("longest", self.longest.is_some()),
            ("shortest", self.shortest.is_some()),
            ("side", self.side.is_some()),
            ("phases", self.phases.is_some()),
        ];
        given.into_iter().find_map(|(argument, is_given)| is_given.then_some(argument))
    }

    /// The choices, with the usual ones for what is not given.
    pub fn choices(&self) -> PyResult<RandomChoices> {
        let usual = RandomChoices::default();
        let points = u64::from(*RandomChoices::POINTS.start())..=u64::from(*RandomChoices::POINTS.end());
        let grid = self.grid.as_ref().map(|grid| whole("grid", grid, points)).transpose()?;
        let counts = 1..=u64::from(u32::MAX);
        let count = |given| whole("realisations", given, counts.clone());
        let realisations = self.realisations.as_ref().map(count).transpose()?;
        let seed = self.seed.as_ref().map(|seed| whole("seed", seed, 0..=u64::MAX)).transpose()?;
        let longest: Option<Length> = optional("longest", self.longest.as_ref())?;
        let shortest: Option<Length> = optional("shortest", self.shortest.as_ref())?;
        let side: Option<Length> = optional("side", self.side.as_ref())?;
        let phases = word::<Phases>("phases", self.phases.as_ref())?;
        Ok(RandomChoices {
            points: grid.map_or(usual.points, |points| points as usize),
            realisations: realisations.map_or(usual.realisations, |count| count as usize),
            seed: seed.unwrap_or(usual.seed),
            longest_m: longest.map(|length| length.m),
            shortest_m: shortest.map(|length| length.m),
            side_m: side.map(|length| length.m),
            phases: phases.unwrap_or(usual.phases),
        })
    }
}

/// The text of an argument that may be left out.
pub fn text(argument: &str, given: Option<&Given<'_>>) -> PyResult<Option<String>> {
    let one = |given: &Given<'_>| match given.cast::<PyString>() {
        Ok(text) => text.extract(),
        Err(_) => Err(of_argument(argument, format!("text is needed, and this is {}", type_name(given)))),
    };
    given.map(one).transpose()
}

/// Parses a named choice of an argument that may be left out.
pub fn word<T: FromStr<Err = UnknownName>>(argument: &str, given: Option<&Given<'_>>) -> PyResult<Option<T>> {
    text(argument, given)?.map(|name| named(argument, &name)).transpose()
}

/// A whole number in a range.
pub fn whole(argument: &str, given: &Given<'_>, range: RangeInclusive<u64>) -> PyResult<u64> {
    let (least, most) = (range.start(), range.end());
    let must = format!("it must be a whole number from {least} to {most}");
    let refused = |what: String| input(format!("{argument} is {what}; {must}"));
    if given.is_instance_of::<PyBool>() {
        return Err(refused(type_name(given)));
    }
    match given.extract::<i128>() {
        Ok(number) => match u64::try_from(number).ok().filter(|number| range.contains(number)) {
            Some(number) => Ok(number),
            None => Err(refused(number.to_string())),
        },
        Err(_) => Err(refused(given.str().map_or_else(|_| type_name(given), |text| text.to_string()))),
    }
}
