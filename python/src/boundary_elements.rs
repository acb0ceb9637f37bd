//! Surfaces pressed by boundary elements: by a flat, by a ball, or while they attract each other.

use std::sync::{Mutex, PoisonError};

use elements::{Boundary, ContactField, ElementsError, IndenterShape, Relief, SpecimenCompliance, with_nan};
use measurements::PartialMap;
use numerics::parallel::Progress;
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use questions::flow::{FlowEdges, PressedFlow};
use questions::{
    AdhesionQuestion, BranchChoice, ElementsLoad, ElementsQuestion, IndenterQuestion, LoadInput, Prepared,
    QuestionError, relief,
};
use scans::{HeightMap, MissingPoints};
use study::surface::Surface;
use topography::Recipe;
use units::{Force, Remark, WorkOfAdhesion};

use crate::answer::{PyAnswer, columns, refused};
use crate::arguments::{
    Arguments, Given, choice, choice_or, length_m, load, load_within, number, quantity, truth,
};
use crate::errors::{input, of_argument};
use crate::material::PyMaterial;
use crate::surface::PySurface;
use crate::work::{Observer, carry_out, held};

/// An answer, and beside it what is known of the surfaces by name: `fields`, `size_m`, `rms_gradient`, columns of `patches`,
/// and numbers of adhesion.
type Pressed<'py> = (PyAnswer, Bound<'py, PyDict>);

/// One map or several of heights \[m\], row by row along x, NaN at missing points, with the lengths along x and y, and whether the
/// heights repeat themselves beyond the map, if that is known.
type Heights<'py> = (PyReadonlyArrayDyn<'py, f64>, [Given<'py>; 2], Option<bool>);

/// Surfaces before they are pressed: the spectrum of random ones; or maps, and the one that faces a single one.
#[derive(FromPyObject)]
pub enum Bodies<'py> {
    Spectrum(Bound<'py, PySurface>),
    Maps(Heights<'py>, Option<Heights<'py>>),
}

impl Bodies<'_> {
    /// Prepares the surfaces by one of two methods of a question; the edges of maps are those of an argument where none are given.
    fn prepared<P>(
        &self,
        arguments: &Arguments<'_>,
        edges: Option<Boundary>,
        on_maps: impl FnOnce(Vec<Relief>) -> Result<Prepared<P>, QuestionError>,
        on: impl FnOnce(&Surface) -> Result<Prepared<P>, QuestionError>,
    ) -> PyResult<Prepared<P>> {
        match self {
            Bodies::Spectrum(surface) => {
                let of_maps = ["size", "periodic", "detrend", "gaps", "compliance"];
                refuse_idle(arguments, of_maps, "a spectrum, only on heights")?;
                on(&surface.get().surface).map_err(refused)
            }
            Bodies::Maps(heights, facing) => {
                let of_random = arguments.random()?.given().map(|(name, _)| name).into_iter();
                refuse_idle(arguments, of_random.chain(["per_realisation"]), "heights, only on a spectrum")?;
                let (reliefs, notes) = reliefs(heights, facing.as_ref(), arguments, edges)?;
                let mut prepared = on_maps(reliefs).map_err(refused)?;
                prepared.notes.splice(..0, notes);
                Ok(prepared)
            }
        }
    }

    /// True for several surfaces of which each is reported.
    fn are_reported_each(&self, arguments: &Arguments<'_>) -> PyResult<bool> {
        let are_maps = matches!(self, Bodies::Maps((heights_m, ..), _) if heights_m.ndim() == 3);
        Ok(are_maps || arguments.flag("per_realisation")?)
    }
}

/// Refuses arguments that are for the other kind of surface.
fn refuse_idle<'n>(
    arguments: &Arguments<'_>,
    names: impl IntoIterator<Item = &'n str>,
    kind: &str,
) -> PyResult<()> {
    for name in names {
        let given = arguments.raw(name)?;
        if !given.is_none() && !matches!(given.extract(), Ok(false)) {
            return Err(input(format!("{name} has no effect on {kind}; leave it out")));
        }
    }
    Ok(())
}

/// Maps as they are pressed, and notes on the sum of two.
fn reliefs(
    heights: &Heights<'_>,
    facing: Option<&Heights<'_>>,
    arguments: &Arguments<'_>,
    edges: Option<Boundary>,
) -> PyResult<(Vec<Relief>, Vec<Remark>)> {
    let mut maps = partial_maps("surface", heights)?;
    let (mut repeats, mut notes) = (heights.2, Vec::new());
    let rows = heights.0.shape().iter().rev().nth(1).copied().unwrap_or_default();
    if let Some(facing) = facing {
        let other = "counterface_surface";
        let of_other = partial_maps(other, facing)?;
        let ([own], [faced]) = (&maps[..], &of_other[..]) else {
            return Err(of_argument(other, "one map faces one map; press each pair by itself"));
        };
        let sum = own.facing(faced).map_err(|error| of_argument(other, error))?;
        notes = sum.remarks_on_sum(("surface", own), (other, faced));
        let is_whole = own.has_grid_of(faced);
        repeats = repeats.zip(facing.2).map(|(own, other)| own && other && is_whole);
        maps = vec![sum];
    }
    let periodic = arguments.get("periodic", truth)?;
    let recipe =
        Recipe { detrend: arguments.get("detrend", choice_or(["none", "mean"]))?, ..Recipe::default() };
    let detrend = recipe.preparation([repeats, periodic].contains(&Some(true))).detrend;
    let own = if periodic.or(repeats) == Some(true) { Boundary::Periodic } else { Boundary::Free };
    let boundary = edges.unwrap_or(own);
    if rows == 1 && boundary == Boundary::Free {
        return Err(of_argument("surface", "one row is a line, which is pressed only with periodic=True"));
    }
    let relief = |map: &PartialMap| {
        let whole =
            Relief { is_missing: map.is_missing(), ..relief(&map.map, map.detrended_m(detrend), boundary) };
        // A line was detrended as two equal rows.
        if rows > 1 {
            return whole;
        }
        let (mut heights_m, mut is_missing) = (whole.heights_m, whole.is_missing);
        heights_m.truncate(whole.columns);
        is_missing.truncate(whole.columns);
        Relief { rows: 1, length_y_m: 0.5 * whole.length_y_m, heights_m, is_missing, ..whole }
    };
    Ok((maps.iter().map(relief).collect(), notes))
}

/// Maps of an argument as measured; a line as two equal rows.
fn partial_maps(name: &str, (heights_m, size, _): &Heights<'_>) -> PyResult<Vec<PartialMap>> {
    let [length_x_m, length_y_m] = [length_m("size[0]", &size[0])?, length_m("size[1]", &size[1])?];
    let [.., rows, columns] = *heights_m.shape() else {
        return Err(of_argument(name, "a map of rows and columns is needed"));
    };
    let (x_m, y_m) = (length_x_m / columns as f64, length_y_m / rows as f64);
    let heights_m = heights_m.as_array();
    // In C order, without a copy of arrays that have it.
    let heights_m = heights_m.as_standard_layout();
    let heights_m = heights_m.as_slice().expect("an array in C order is a slice");
    let map = |heights_m: &[f64]| {
        let heights_m = heights_m.repeat(if rows == 1 { 2 } else { 1 });
        let missing: MissingPoints = (0..heights_m.len()).filter(|&at| heights_m[at].is_nan()).collect();
        let known_m = heights_m.iter().map(|height_m| if height_m.is_nan() { 0.0 } else { *height_m });
        let map = HeightMap::new(columns, x_m, y_m, known_m.collect());
        Ok(PartialMap { map: map.map_err(|error| of_argument(name, error))?, missing })
    };
    heights_m.chunks(rows * columns).map(map).collect()
}

/// Presses a ball onto a map, or onto random surfaces.
#[pyfunction]
pub fn press_ball<'py>(
    py: Python<'py>,
    bodies: Bodies<'py>,
    material: &PyMaterial,
    arguments: Arguments<'py>,
    observer: Option<&Observer<'py>>,
) -> PyResult<Pressed<'py>> {
    let question = IndenterQuestion {
        material: material.input,
        shape: IndenterShape::Ball,
        radius_m: arguments.required("radius", length_m)?,
        force: arguments.required("force", quantity::<Force>)?.n,
        tolerance: arguments.get("tolerance", number)?,
        random: arguments.random()?,
    };
    if matches!(&bodies, Bodies::Maps((heights_m, ..), _) if heights_m.ndim() == 3) {
        return Err(of_argument("surface", "a ball is pressed onto one map; give each by itself"));
    }
    let on_map = |mut maps: Vec<Relief>| question.on_map(maps.swap_remove(0));
    let prepared =
        bodies.prepared(&arguments, Some(Boundary::Free), on_map, |surface| question.on(surface))?;
    let answer = PyAnswer::carry_out(py, observer, |watch| prepared.answer(watch))?;
    Ok((answer.behind(prepared.notes), PyDict::new(py)))
}

/// Presses surfaces that attract each other, or pulls them apart.
#[pyfunction]
pub fn press_adhesive<'py>(
    py: Python<'py>,
    bodies: Bodies<'py>,
    material: &PyMaterial,
    arguments: Arguments<'py>,
    observer: Option<&Observer<'py>>,
) -> PyResult<Pressed<'py>> {
    let signed = |name: &str, given: &Given<'_>| match given.cast::<PyString>() {
        Ok(text) => LoadInput::parse_signed(text.to_str()?).map_err(|error| of_argument(name, error)),
        Err(_) => load_within(name, given, units::Bound::Finite),
    };
    let question = AdhesionQuestion {
        material: material.input,
        pressures: arguments.several("pressure", signed)?.unwrap_or_default(),
        work_of_adhesion_j_per_m2: arguments
            .required("work_of_adhesion", quantity::<WorkOfAdhesion>)?
            .j_per_m2,
        range_m: arguments.required("adhesion_range", length_m)?,
        branch: arguments.get("branch", choice::<BranchChoice>)?.unwrap_or_default(),
        pull_off: arguments.flag("pull_off")?,
        tolerance: arguments.get("tolerance", number)?,
        per_realisation: bodies.are_reported_each(&arguments)?,
        random: arguments.random()?,
        ..AdhesionQuestion::default()
    };
    let prepared =
        bodies.prepared(&arguments, None, |maps| question.on_maps(maps), |surface| question.on(surface))?;
    let answer = PyAnswer::carry_out(py, observer, |watch| prepared.answer(watch))?.behind(prepared.notes);
    let beside = PyDict::new(py);
    beside.set_item("rms_gradient", prepared.surfaces.rms_gradients())?;
    for note in &answer.notes {
        if note.code.name().starts_with("adhesion.") {
            let numbers = note.numbers.iter().filter_map(|(name, _)| Some((name, note.number(name)?)));
            numbers.into_iter().try_for_each(|(name, number)| beside.set_item(name, number))?;
        }
    }
    Ok((answer, beside))
}

/// Pressures, mean gaps or indentations, whichever is given.
fn loads(arguments: &Arguments<'_>) -> PyResult<Vec<ElementsLoad>> {
    let pressure = |name: &str, given: &Given<'_>| match given.cast::<PyString>() {
        Ok(text) => text.to_str()?.parse().map_err(|error| of_argument(name, error)),
        Err(_) => load(name, given).map(ElementsLoad::Pressure),
    };
    let mean_gaps = arguments.several("mean_gap", length_m)?.unwrap_or_default().into_iter();
    let indentations = arguments.several("indentation", length_m)?.unwrap_or_default().into_iter();
    let mut loads = arguments.several("pressure", pressure)?.unwrap_or_default();
    loads.extend(mean_gaps.map(|mean_gap_m| ElementsLoad::MeanGap { mean_gap_m }));
    loads.extend(indentations.map(|indentation_m| ElementsLoad::Indentation { indentation_m }));
    let names = ["pressure", "mean_gap", "indentation"];
    let given: Vec<&str> =
        names.into_iter().filter(|name| arguments.raw(name).is_ok_and(|given| !given.is_none())).collect();
    match (&given[..], loads.is_empty()) {
        ([_], false) => Ok(loads),
        ([name], true) => Err(of_argument(name, "give at least one")),
        ([], _) => Err(input("none of pressure, mean_gap and indentation is given; give one")),
        (several, _) => Err(input(format!("{} are given; give one of them", several.join(" and ")))),
    }
}

/// Presses every surface under every load.
#[pyfunction]
pub fn press_flat<'py>(
    py: Python<'py>,
    bodies: Bodies<'py>,
    material: &PyMaterial,
    arguments: Arguments<'py>,
    observer: Option<&Observer<'py>>,
) -> PyResult<Pressed<'py>> {
    let question = ElementsQuestion {
        material: material.input,
        loads: loads(&arguments)?,
        saturation: arguments.get("saturation", quantity)?,
        tolerance: arguments.get("tolerance", number)?,
        random: arguments.random()?,
        compliance: arguments.get("compliance", choice::<SpecimenCompliance>)?,
        ..ElementsQuestion::default()
    };
    let prepared =
        bodies.prepared(&arguments, None, |maps| question.on_maps(maps), |surface| question.on(surface))?;
    let (surfaces, count) = (&prepared.surfaces, prepared.surfaces.count());
    let [rows, width] = surfaces.points().unwrap_or_default();
    let points = rows * width;
    // Pressures and gaps of surface after surface under load after load, and the heights of the surfaces.
    let shapes = [vec![prepared.loads(), count, rows, width], vec![count, rows, width]];
    let [of_loads, of_surfaces] = shapes.each_ref();
    let room = || PyResult::Ok(Mutex::new([zeros(of_loads)?, zeros(of_loads)?, zeros(of_surfaces)?]));
    let fields = arguments.flag("fields")?.then(room).transpose()?;
    let patches = arguments.flag("patches")?.then(|| Mutex::new(Vec::new()));
    let edges = arguments.get("flow_edges", choice::<FlowEdges>)?;
    let flow = match (arguments.flag("flow")?, edges) {
        (true, edges) => Some(PressedFlow::new(edges, surfaces).map_err(refused)?),
        (false, None) => None,
        (false, Some(_)) => return Err(input("flow_edges has no effect without flow=True; leave it out")),
    };
    let see = |field: &ContactField<'_>, watch: &dyn Progress| -> Result<(), QuestionError> {
        if let Some(flow) = &flow {
            flow.solve(field, watch)?;
        }
        if let Some(fields) = &fields {
            let [pressures_pa, gaps_m, heights_m] = &mut *held(fields);
            let at = points * (field.load * count + field.surface);
            pressures_pa[at..at + points].copy_from_slice(field.pressures_pa);
            let is_missing = &field.relief.is_missing;
            gaps_m[at..at + points].copy_from_slice(&with_nan(&field.closed_gaps_m(), is_missing));
            let at = points * field.surface;
            heights_m[at..at + points].copy_from_slice(&with_nan(&field.relief.heights_m, is_missing));
        }
        if let Some(patches) = &patches {
            let found = field.patches().map_err(ElementsError::from)?;
            held(patches).push(found);
        }
        Ok(())
    };
    let pressed = carry_out(py, observer, |watch| {
        watch.begin("steps", Some(prepared.steps()));
        prepared.answer(|field| see(field, watch), watch)
    })?;
    let (mut loads, mut notes) = pressed.map_err(refused)?;
    let table = match (flow, bodies.are_reported_each(&arguments)?) {
        (Some(flow), of_each) => flow.table(&mut loads, &mut notes, of_each),
        (None, true) => elements::states_table(&loads),
        (None, false) => elements::means_table(&loads),
    };
    let fields = fields.map(|fields| {
        let [pressures_pa, gaps_m, heights_m] = fields.into_inner().unwrap_or_else(PoisonError::into_inner);
        let array = |values, shape: &Vec<usize>| PyArray1::from_vec(py, values).reshape(&shape[..]);
        PyResult::Ok([
            array(pressures_pa, of_loads)?,
            array(gaps_m, of_loads)?,
            array(heights_m, of_surfaces)?,
        ])
    });
    let beside = PyDict::new(py);
    beside.set_item("fields", fields.transpose()?)?;
    beside.set_item("size_m", surfaces.size_m().unwrap_or_default())?;
    beside.set_item("rms_gradient", surfaces.rms_gradients())?;
    if let Some(patches) = patches {
        let patches = patches.into_inner().unwrap_or_else(PoisonError::into_inner);
        beside.set_item("patches", columns(py, &elements::patches_table(patches))?)?;
    }
    Ok((PyAnswer::new(py, &table, [prepared.notes.clone(), notes].concat())?, beside))
}

/// Zeros of a shape.
///
/// # Errors
/// MemoryError where there is no room for them.
fn zeros(shape: &[usize]) -> PyResult<Vec<f64>> {
    let length = shape.iter().try_fold(1, |length: usize, axis| length.checked_mul(*axis));
    let (mut zeros, length) = (Vec::new(), length.unwrap_or(usize::MAX));
    let no_room = |_| PyMemoryError::new_err(format!("no room for fields of shape {shape:?}"));
    zeros.try_reserve_exact(length).map_err(no_room)?;
    zeros.resize(length, 0.0);
    Ok(zeros)
}
