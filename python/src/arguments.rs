//! Arguments of calls: numbers in SI units or text with a unit, names, and what questions take of them.

use std::num::NonZeroU32;
use std::ops::RangeInclusive;
use std::str::FromStr;

use asperity::Hardness;
use elements::RandomChoices;
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use persson::hardness_laws::HardnessTable;
use persson::{EnergyFactor, EnergyFactorError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyString};
use questions::{LoadInput, RandomInput, SamplingInput};
use study::growth_law::GrowthLaw;
use study::models::{Choice, MODELS, ModelEntry, ModelOptions};
use study::plan::Tolerance;
use units::{
    Area, Force, IndentationHardness, Length, LengthUnit, Modulus, Pressure, QuantityError, Resistivity,
    SignedLength, ThermalConductivity, UnknownName, WorkOfAdhesion, display,
};

use crate::errors::{input, of_argument};

pub type Given<'py> = Bound<'py, PyAny>;

/// The arguments of a call by their names. An argument that is None is not given.
#[derive(FromPyObject)]
pub struct Arguments<'py>(Bound<'py, PyDict>);

impl<'py> Arguments<'py> {
    /// An argument as it is, None if it is not given.
    pub fn raw(&self, name: &str) -> PyResult<Given<'py>> {
        Ok(self.0.get_item(name)?.unwrap_or_else(|| self.0.py().None().into_bound(self.0.py())))
    }

    /// Converts an argument that is needed.
    pub fn required<T>(&self, name: &str, convert: impl Fn(&str, &Given<'py>) -> PyResult<T>) -> PyResult<T> {
        convert(name, &self.raw(name)?)
    }

    /// Converts an argument, if it is given.
    pub fn get<T>(
        &self,
        name: &str,
        convert: impl Fn(&str, &Given<'py>) -> PyResult<T>,
    ) -> PyResult<Option<T>> {
        Some(self.raw(name)?).filter(|given| !given.is_none()).map(|given| convert(name, &given)).transpose()
    }

    /// An argument that is true or false; false if it is not given.
    pub fn flag(&self, name: &str) -> PyResult<bool> {
        Ok(self.get(name, truth)?.unwrap_or_default())
    }

    pub fn sampling(&self) -> PyResult<SamplingInput> {
        let scales_per_decade = self.get("scales_per_decade", count)?;
        Ok(SamplingInput { scales_per_decade, cutoff_m: self.get("cutoff", length_m)? })
    }

    /// The form of the hardness of spheres.
    pub fn hardness_form(&self) -> PyResult<Option<Hardness>> {
        self.get("hardness_formula", choice)
    }

    pub fn model_options(&self) -> PyResult<ModelOptions> {
        // A look through the few names that are given costs less than a question for each.
        if !self.0.keys().iter().any(|key| key.cast().is_ok_and(is_option)) {
            return Ok(ModelOptions::default());
        }
        Ok(ModelOptions {
            strain_gradient: self.flag("strain_gradient")?,
            hardness: self.hardness_form()?,
            flattening: self.get("flattening", choice)?,
            summit_heights: self.get("summit_heights", choice)?,
            elastic_plastic_area: self.get("elastic_plastic_area", choice)?,
            interference_law: self.get("interference_law", choice)?,
            correction: self.get("correction", choice)?,
            band: self.get("band", choice)?,
            gamma: self.get("gamma", energy_factor)?,
            hardness_law: self.get("hardness_law", growth_law)?,
        })
    }

    pub fn random(&self) -> PyResult<RandomInput> {
        let (least, most) = RandomChoices::POINTS.into_inner();
        let points = |name: &str, given: &Given<'py>| whole(name, given, &(least as u64..=most as u64));
        let seed = |name: &str, given: &Given<'py>| whole(name, given, &(0..=u64::MAX));
        Ok(RandomInput {
            grid: self.get("grid", points)?.map(|points| points as usize),
            realisations: self.get("realisations", count)?.map(|count| count.get() as usize),
            seed: self.get("seed", seed)?,
            longest_m: self.get("longest", length_m)?,
            shortest_m: self.get("shortest", length_m)?,
            side_m: self.get("side", length_m)?,
            phases: self.get("phases", choice)?,
        })
    }

    /// Nominal pressures: one, or several.
    pub fn pressures(&self) -> PyResult<Vec<LoadInput>> {
        match self.several("pressure", load)? {
            Some(loads) if loads.is_empty() => {
                Err(of_argument("pressure", "it is empty; give at least one pressure"))
            }
            loads => Ok(loads.unwrap_or_default()),
        }
    }

    /// One thing, or each of a list, an array of one axis, or anything else with a length and an order; text is one thing.
    pub fn several<T>(
        &self,
        name: &str,
        one: impl Fn(&str, &Given<'py>) -> PyResult<T>,
    ) -> PyResult<Option<Vec<T>>> {
        self.get(name, |_, given| {
            let is_text = given.is_instance_of::<PyString>() || given.is_instance_of::<PyBytes>();
            if is_text || given.len().is_err() {
                return Ok(vec![one(name, given)?]);
            }
            if given.is_instance_of::<PyDict>() || !given.hasattr("__getitem__")? {
                let what = type_name(given);
                let problem = format!("it has no order, being {what}; give a list or an array");
                return Err(of_argument(name, problem));
            }
            let each = given.try_iter()?.enumerate();
            each.map(|(at, given)| one(&format!("{name}[{at}]"), &given?)).collect()
        })
    }
}

/// Returns true for the name of an argument that is an option of models.
fn is_option(name: &Bound<'_, PyString>) -> bool {
    let all = Choice::OF_CURVES.into_iter().chain(Choice::OF_SCENES).chain([Choice::SummitHeights]);
    let mut of_models = all.map(Choice::key);
    name.to_str().is_ok_and(|name| of_models.any(|key| key == name))
}

/// A nominal pressure and how it was given.
pub fn load(argument: &str, given: &Given<'_>) -> PyResult<LoadInput> {
    load_within(argument, given, Pressure::BOUND)
}

/// A nominal pressure, whose number in Pa lies within a bound, and how it was given.
pub fn load_within(argument: &str, given: &Given<'_>, bound: units::Bound) -> PyResult<LoadInput> {
    let pressure: Pressure = quantity_within(argument, given, bound)?;
    let label = match (given.cast::<PyString>(), pressure) {
        (Err(_), Pressure::Pascals(pa)) => display::pressure(pa),
        _ => given.str()?.to_string(),
    };
    Ok(LoadInput { pressure, label })
}

/// The law by which a hardness grows: by its name, or a table of contact sizes \[m\] and hardnesses \[Pa\].
fn growth_law(argument: &str, given: &Given<'_>) -> PyResult<GrowthLaw> {
    if given.is_instance_of::<PyString>() {
        let name = text(argument, given)?;
        let law = GrowthLaw::named(&name).map_err(|error| of_argument(argument, error))?;
        return law.ok_or_else(|| none_of(argument, &name, ["power:N", "nix-gao"]));
    }
    let (sizes_m, hardnesses_pa): (Vec<f64>, Vec<f64>) =
        given.extract().map_err(|_| wrong_type(argument, "a name or a table is needed", given))?;
    HardnessTable::new(sizes_m.into_iter().zip(hardnesses_pa))
        .map(GrowthLaw::Table)
        .map_err(|error| of_argument(argument, error))
}

/// The relative tolerance of statistical states.
pub fn tolerance(argument: &str, given: &Given<'_>) -> PyResult<Tolerance> {
    Tolerance::new(number(argument, given)?).map_err(input)
}

/// The elastic energy factor of mean gaps: a number, or the name of a form.
fn energy_factor(argument: &str, given: &Given<'_>) -> PyResult<EnergyFactor> {
    let found = match given.is_instance_of::<PyString>() {
        true => text(argument, given)?.parse(),
        false => EnergyFactor::new(number(argument, given)?).map_err(EnergyFactorError::from),
    };
    found.map_err(|error| of_argument(argument, error))
}

/// A quantity that is typed with its unit, or is a number in SI units.
pub trait Quantity: FromStr<Err = QuantityError> {
    /// The SI unit, and an example of its text for messages.
    const UNIT: (&'static str, &'static str);
    /// The bound on its number.
    const BOUND: units::Bound;

    /// Makes the quantity of a number in SI units.
    fn of_si(number: f64) -> Self;
}

macro_rules! quantities {
    ($($type:ty, $bound:ident, $unit:literal, $example:literal, $of_si:expr;)*) => {
        $(impl Quantity for $type {
            const UNIT: (&'static str, &'static str) = ($unit, $example);
            const BOUND: units::Bound = units::Bound::$bound;

            fn of_si(number: f64) -> Self {
                $of_si(number)
            }
        })*
    };
}

quantities! {
    Length, Positive, "m", "5 um", |m| Length { m };
    SignedLength, Finite, "m", "-5 nm", |m| SignedLength { m };
    Modulus, Positive, "Pa", "210 GPa", |pa| Modulus { pa };
    Force, Positive, "N", "10 mN", |n| Force { n };
    IndentationHardness, Positive, "Pa", "3 GPa", |pa| IndentationHardness { pa };
    Pressure, Positive, "Pa", "5 MPa", Pressure::Pascals;
    ThermalConductivity, Positive, "W/(m*K)", "46 W/(m K)", |w_per_m_k| ThermalConductivity { w_per_m_k };
    WorkOfAdhesion, Positive, "J/m**2", "50 mJ/m^2", |j_per_m2| WorkOfAdhesion { j_per_m2 };
    Resistivity, Positive, "ohm*m", "1.7e-8 ohm m", |ohm_m| Resistivity { ohm_m };
}

/// The quantity that an argument gives.
pub fn quantity<Q: Quantity>(argument: &str, given: &Given<'_>) -> PyResult<Q> {
    quantity_within(argument, given, Q::BOUND)
}

fn quantity_within<Q: Quantity>(argument: &str, given: &Given<'_>, bound: units::Bound) -> PyResult<Q> {
    if let Ok(text) = given.cast::<PyString>() {
        return text.to_str()?.parse().map_err(|error| of_argument(argument, error));
    }
    let (unit, example) = Q::UNIT;
    let number = bare_number(argument, &without_unit(argument, unit, given)?).map_err(|_| {
        wrong_type(argument, &format!("a number in {unit} is needed, or text such as '{example}'"), given)
    })?;
    checked(argument, bound, number).map(Q::of_si)
}

/// A length in m.
pub fn length_m(argument: &str, given: &Given<'_>) -> PyResult<f64> {
    quantity::<Length>(argument, given).map(|length| length.m)
}

/// A number within its bound.
pub fn checked(argument: &str, bound: units::Bound, number: f64) -> PyResult<f64> {
    let refused =
        |error: units::OutOfBounds| input(format!("{argument} is {number}; it must be {}", error.bound));
    bound.check("", number).map_err(refused)
}

/// Numbers in a unit: those of a quantity of pint, astropy or unyt, or of a `DataArray` that says its own, converted to it;
/// anything else as it is.
#[pyfunction]
pub fn without_unit<'py>(argument: &str, unit: &str, given: &Given<'py>) -> PyResult<Given<'py>> {
    // pint's and astropy's, and unyt's.
    for method in ["m_as", "to_value"] {
        if given.hasattr(method)? {
            let converted = given.call_method1(method, (unit,));
            // Wavevectors of some count radians.
            let converted = converted.or_else(|error| match unit {
                "1/m" => given.call_method1(method, ("rad/m",)),
                _ => Err(error),
            });
            return converted.map_err(|error| {
                let unit = if unit.is_empty() { "a plain number" } else { unit };
                of_argument(argument, format!("cannot be converted to {unit}: {}", error.value(given.py())))
            });
        }
    }
    if given.hasattr("dims")? && given.hasattr("attrs")? {
        let data = given.getattr("data")?;
        let bare = without_unit(argument, unit, &data)?;
        let units = given.getattr("attrs")?.call_method1("get", ("units",))?;
        if !bare.is(&data) || units.is_none() {
            return Ok(bare);
        }
        let factor = si_factor(argument, unit, &text("the attribute units", &units)?)?;
        return if factor == 1.0 { Ok(bare) } else { bare.mul(factor) };
    }
    Ok(given.clone())
}

/// The number of SI units in a unit that an attribute names.
fn si_factor(argument: &str, unit: &str, named: &str) -> PyResult<f64> {
    let plain = |text: &str| {
        let text = text.replace("rad/", "1/").replace(['*', '^', ' '], "");
        text.replace('²', "2").replace('³', "3").replace('⁴', "4")
    };
    if plain(named) == plain(unit) || (unit.is_empty() && ["1", "dimensionless"].contains(&named)) {
        return Ok(1.0);
    }
    let number = format!("1 {}", named.replace("rad/", "1/").replace("**", "^"));
    si_number_of_text(argument, unit, &number).map_err(|_| {
        let needed = if unit.is_empty() { "a plain number" } else { unit };
        of_argument(argument, format!("its attribute units is '{named}', and {needed} is needed; convert it"))
    })
}

/// The number in SI units of text with a unit, or of anything else that is one number: in m, Pa, m², 1/m², or without a unit.
#[pyfunction]
pub fn si_number(argument: &str, unit: &str, given: &Given<'_>) -> PyResult<f64> {
    let Ok(text) = given.cast::<PyString>() else {
        return bare_number(argument, &without_unit(argument, unit, given)?);
    };
    si_number_of_text(argument, unit, text.to_str()?)
}

fn si_number_of_text(argument: &str, unit: &str, text: &str) -> PyResult<f64> {
    let parsed = match unit {
        "m" => text.parse().map(|SignedLength { m }| m),
        "Pa" => text.parse().map(|Modulus { pa }| pa),
        "m**2" => text.parse().map(|Area { m2 }| m2),
        "N" => text.parse().map(|Force { n }| n),
        "J/m**2" => text.parse().map(|WorkOfAdhesion { j_per_m2 }| j_per_m2),
        "W/(m*K)" => text.parse().map(|ThermalConductivity { w_per_m_k }| w_per_m_k),
        "ohm*m" => text.parse().map(|Resistivity { ohm_m }| ohm_m),
        "1/m" | "1/m**2" => {
            let refused = || {
                of_argument(argument, format!("'{text}' is not a number in {unit}, such as '1e12 {unit}'"))
            };
            let si = |of: &str| match unit {
                "1/m" => of.parse().ok().map(|Length { m }| m),
                _ => of.parse().ok().map(|Area { m2 }| m2),
            };
            return per(text, si).ok_or_else(refused);
        }
        "" => {
            let number = text.trim().parse().ok().filter(|number: &f64| number.is_finite());
            return number.ok_or_else(|| of_argument(argument, format!("'{text}' is not a number")));
        }
        _ => return Err(of_argument(argument, format!("numbers in {unit} are needed, and this is text"))),
    };
    parsed.map_err(|error: QuantityError| of_argument(argument, error))
}

/// A number per unit such as `1e12 1/m2` or `0.5 /um2`, with the size of one of the unit.
fn per(text: &str, si: impl Fn(&str) -> Option<f64>) -> Option<f64> {
    let (number, of) = text.rsplit_once('/')?;
    let number = number.trim_end();
    let number: f64 = number.strip_suffix(" 1").unwrap_or(number).trim().parse().ok()?;
    si(&format!("1 {of}")).map(|size| number / size)
}

/// Lengths in m, of lengths in a unit, each rounded once; a new array in C order.
#[pyfunction]
pub fn in_metres<'py>(
    py: Python<'py>,
    argument: &str,
    unit: &str,
    lengths: PyReadonlyArrayDyn<'py, f64>,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let unit: LengthUnit = unit.parse().map_err(|error| of_argument(argument, error))?;
    let in_m = lengths.as_array().iter().map(|length| unit.to_m(*length)).collect();
    PyArray1::from_vec(py, in_m).reshape(lengths.shape())
}

/// A number without a unit.
pub fn number(argument: &str, given: &Given<'_>) -> PyResult<f64> {
    bare_number(argument, &without_unit(argument, "", given)?)
}

/// A plain number.
fn bare_number(argument: &str, given: &Given<'_>) -> PyResult<f64> {
    // The truths of numpy are no PyBool, and would be 0 and 1.
    let is_truth = given.get_type().name().is_ok_and(|name| name.to_string_lossy().starts_with("bool"));
    let number = if is_truth || given.is_instance_of::<PyString>() { None } else { given.extract().ok() };
    number.ok_or_else(|| wrong_type(argument, "a number is needed", given))
}

/// A whole number in a range.
pub fn whole(argument: &str, given: &Given<'_>, range: &RangeInclusive<u64>) -> PyResult<u64> {
    number(argument, given)?;
    let whole = given.extract::<i128>().ok().and_then(|number| u64::try_from(number).ok());
    whole.filter(|number| range.contains(number)).ok_or_else(|| {
        let (least, most) = (range.start(), range.end());
        input(format!("{argument} is {given}; it must be a whole number from {least} to {most}"))
    })
}

/// A whole number of at least 1.
pub fn count(argument: &str, given: &Given<'_>) -> PyResult<NonZeroU32> {
    let count = whole(argument, given, &(1..=u64::from(u32::MAX)))?;
    Ok(NonZeroU32::MIN.saturating_add(count as u32 - 1))
}

/// The text of an argument.
pub fn text(argument: &str, given: &Given<'_>) -> PyResult<String> {
    let text = given.cast::<PyString>().map_err(|_| wrong_type(argument, "text is needed", given))?;
    text.extract()
}

/// True or false.
#[pyfunction]
pub fn truth(argument: &str, given: &Given<'_>) -> PyResult<bool> {
    given.extract().map_err(|_| wrong_type(argument, "True or False is needed", given))
}

/// A choice by its name.
pub fn choice<T: FromStr<Err = UnknownName>>(argument: &str, given: &Given<'_>) -> PyResult<T> {
    named(argument, &text(argument, given)?)
}

/// A choice by its name, one of which has another name elsewhere.
pub fn choice_or<T: FromStr<Err = UnknownName>>(
    [other, name]: [&str; 2],
) -> impl Fn(&str, &Given<'_>) -> PyResult<T> {
    move |argument, given| {
        let typed = text(argument, given)?;
        named(argument, if typed == other { name } else { &typed })
    }
}

/// Parses a named choice.
pub fn named<T: FromStr<Err = UnknownName>>(argument: &str, name: &str) -> PyResult<T> {
    name.parse().map_err(|error| of_argument(argument, error))
}

/// Finds a model of any framework by its name.
pub fn any_model(name: &str) -> PyResult<&'static ModelEntry> {
    let found = MODELS.iter().find(|entry| entry.name == name);
    found.ok_or_else(|| none_of("model", name, MODELS.iter().map(|entry| entry.name)))
}

/// The error of a name that is none of those known.
pub fn none_of<'n>(argument: &str, name: &str, known: impl IntoIterator<Item = &'n str>) -> PyErr {
    let known = known.into_iter().collect::<Vec<_>>().join(", ");
    of_argument(argument, format!("'{name}' is not one of {known}"))
}

/// The error of an argument of the wrong type.
pub fn wrong_type(argument: &str, needed: &str, given: &Given<'_>) -> PyErr {
    of_argument(argument, format!("{needed}, and this is {}", type_name(given)))
}

/// Describes the type of an argument, for messages.
fn type_name(given: &Given<'_>) -> String {
    given.get_type().name().map_or_else(|_| "something else".to_owned(), |name| format!("of type {name}"))
}
