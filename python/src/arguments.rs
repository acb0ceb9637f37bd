//! Arguments of calls: numbers in SI units or text with a unit, names, and what questions take of them.

use std::num::NonZeroU32;
use std::ops::RangeInclusive;
use std::str::FromStr;

use asperity::Hardness;
use numpy::PyReadonlyArray1;
use persson::hardness_laws::HardnessTable;
use persson::{EnergyFactor, EnergyFactorError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyString};
use questions::{LoadInput, RandomInput, SamplingInput};
use rough_bem::RandomChoices;
use study::growth_law::GrowthLaw;
use study::models::ModelOptions;
use units::{
    Area, Bound, Force, IndentationHardness, Length, Modulus, Pressure, QuantityError, Resistivity,
    SignedLength, ThermalConductivity, UnknownName, WorkOfAdhesion, display,
};

use crate::errors::{input, of_argument};

pub type Given<'py> = pyo3::Bound<'py, PyAny>;

/// The arguments of a call by their names. An argument that is None is not given.
#[derive(FromPyObject)]
pub struct Arguments<'py>(pyo3::Bound<'py, PyDict>);

impl<'py> Arguments<'py> {
    /// An argument as it is, None if it is not given.
    pub fn raw(&self, name: &str) -> PyResult<Given<'py>> {
        Ok(self.0.get_item(name)?.unwrap_or_else(|| self.0.py().None().into_bound(self.0.py())))
    }

    /// Converts an argument that is needed.
    pub fn required<T>(&self, name: &str, convert: impl Fn(&str, &Given<'py>) -> PyResult<T>) -> PyResult<T> {
        convert(name, &self.raw(name)?)
    }

    /// An argument, if it is given.
    pub fn get(&self, name: &str) -> PyResult<Option<Given<'py>>> {
        Ok(Some(self.raw(name)?).filter(|given| !given.is_none()))
    }

    /// Converts an argument, if it is given.
    pub fn convert<T>(
        &self,
        name: &str,
        convert: impl Fn(&str, &Given<'py>) -> PyResult<T>,
    ) -> PyResult<Option<T>> {
        self.get(name)?.map(|given| convert(name, &given)).transpose()
    }

    pub fn quantity<Q: Quantity>(&self, name: &str) -> PyResult<Option<Q>> {
        self.convert(name, quantity)
    }

    pub fn length_m(&self, name: &str) -> PyResult<Option<f64>> {
        Ok(self.quantity::<Length>(name)?.map(|length| length.m))
    }

    /// A number within its bound.
    pub fn number(&self, name: &str, bound: Option<Bound>) -> PyResult<Option<f64>> {
        let number = self.convert(name, number)?;
        number.map(|number| bound.map_or(Ok(number), |bound| checked(name, bound, number))).transpose()
    }

    pub fn whole(&self, name: &str, range: RangeInclusive<u64>) -> PyResult<Option<u64>> {
        self.convert(name, |name, given| whole(name, given, &range))
    }

    /// A whole number of at least 1.
    pub fn count(&self, name: &str) -> PyResult<Option<NonZeroU32>> {
        let count = self.whole(name, 1..=u64::from(u32::MAX))?;
        Ok(count.and_then(|count| NonZeroU32::new(count as u32)))
    }

    pub fn text(&self, name: &str) -> PyResult<Option<String>> {
        self.convert(name, text)
    }

    /// A choice by its name.
    pub fn named<T: FromStr<Err = UnknownName>>(&self, name: &str) -> PyResult<Option<T>> {
        self.text(name)?.map(|choice| named(name, &choice)).transpose()
    }

    /// An argument that is true or false; false if it is not given.
    pub fn flag(&self, name: &str) -> PyResult<bool> {
        let flag = |name: &str, given: &Given<'py>| {
            let told =
                || of_argument(name, format!("True or False is needed, and this is {}", type_name(given)));
            given.extract::<bool>().map_err(|_| told())
        };
        Ok(self.convert(name, flag)?.unwrap_or_default())
    }

    pub fn sampling(&self) -> PyResult<SamplingInput> {
        let scales_per_decade = self.count("scales_per_decade")?;
        Ok(SamplingInput { scales_per_decade, cutoff_m: self.length_m("cutoff")? })
    }

    /// The form of the hardness of spheres, by its name or by `hardness`, the former one.
    pub fn hardness_form(&self) -> PyResult<Option<Hardness>> {
        let [is_new, is_former] =
            [self.get("hardness_formula")?, self.get("hardness")?].map(|given| given.is_some());
        if is_new && is_former {
            return Err(input("hardness_formula and hardness, its former name, are both given; give one"));
        }
        let argument = if is_new { "hardness_formula" } else { "hardness" };
        let form = |name: String| {
            let found = Hardness::ALL.into_iter().find(|hardness| hardness.name() == name);
            found.ok_or_else(|| {
                let names = Hardness::ALL.map(Hardness::name).join(", ");
                of_argument(argument, format!("'{name}' is none of {names}"))
            })
        };
        self.text(argument)?.map(form).transpose()
    }

    pub fn model_options(&self) -> PyResult<ModelOptions> {
        // A look through the few names that are given costs less than a question for each.
        if !self.0.keys().iter().any(|key| key.cast::<PyString>().is_ok_and(|name| of_model(name))) {
            return Ok(ModelOptions::default());
        }
        Ok(ModelOptions {
            strain_gradient: self.flag("strain_gradient")?,
            hardness: self.hardness_form()?,
            interference_law: self.named("interference_law")?,
            correction: self.named("correction")?,
            band: self.named("band")?,
            gamma: self.convert("gamma", energy_factor)?,
            hardness_law: self.convert("hardness_law", growth_law)?,
        })
    }

    pub fn random(&self) -> PyResult<RandomInput> {
        let [least, most] =
            [RandomChoices::POINTS.start(), RandomChoices::POINTS.end()].map(|n| u64::from(*n));
        Ok(RandomInput {
            grid: self.whole("grid", least..=most)?.map(|points| points as usize),
            realisations: self.count("realisations")?.map(|count| count.get() as usize),
            seed: self.whole("seed", 0..=u64::MAX)?,
            longest_m: self.length_m("longest")?,
            shortest_m: self.length_m("shortest")?,
            side_m: self.length_m("side")?,
            phases: self.named("phases")?,
        })
    }

    /// Nominal pressures: one, or several.
    pub fn pressures(&self) -> PyResult<Vec<LoadInput>> {
        let loads = self.several("pressure", load)?;
        match loads {
            Some(loads) if loads.is_empty() => {
                Err(of_argument("pressure", "it is empty; give at least one pressure"))
            }
            loads => Ok(loads.unwrap_or_default()),
        }
    }

    /// Separations \[m\]: one, or several.
    pub fn separations_m(&self) -> PyResult<Vec<f64>> {
        let one = |argument: &str, given: &Given<'py>| quantity::<SignedLength>(argument, given);
        let separations = self.several("separation", one)?;
        Ok(separations.unwrap_or_default().iter().map(|length| length.m).collect())
    }

    /// One thing, or each of a list, an array of one axis, or anything else with a length and an order; text is one thing.
    pub fn several<T>(
        &self,
        name: &str,
        one: impl Fn(&str, &Given<'py>) -> PyResult<T>,
    ) -> PyResult<Option<Vec<T>>> {
        self.convert(name, |_, given| {
            let is_text = given.is_instance_of::<PyString>() || given.is_instance_of::<PyBytes>();
            if is_text || given.len().is_err() {
                return Ok(vec![one(name, given)?]);
            }
            if given.is_instance_of::<PyDict>() || !given.hasattr("__getitem__")? {
                let what = type_name(given);
                return Err(of_argument(
                    name,
                    format!("it has no order, being {what}; give a list or an array"),
                ));
            }
            let each = given.try_iter()?.enumerate();
            each.map(|(at, given)| one(&format!("{name}[{at}]"), &given?)).collect()
        })
    }
}

/// Returns true for the name of an argument that is an option of models.
fn of_model(name: &pyo3::Bound<'_, PyString>) -> bool {
    const NAMES: [&str; 8] = [
        "strain_gradient",
        "hardness_formula",
        "hardness",
        "interference_law",
        "correction",
        "band",
        "gamma",
        "hardness_law",
    ];
    name.to_str().is_ok_and(|name| NAMES.contains(&name))
}

/// A nominal pressure and how it was given.
pub fn load(argument: &str, given: &Given<'_>) -> PyResult<LoadInput> {
    load_within(argument, given, Pressure::BOUND)
}

/// A nominal pressure, whose number in Pa lies within a bound, and how it was given.
pub fn load_within(argument: &str, given: &Given<'_>, bound: Bound) -> PyResult<LoadInput> {
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
        return law.ok_or_else(|| of_argument(argument, format!("'{name}' is none of power:N, nix-gao")));
    }
    let told =
        || of_argument(argument, format!("a name or a table is needed, and this is {}", type_name(given)));
    let (sizes_m, hardnesses_pa): (PyReadonlyArray1<'_, f64>, PyReadonlyArray1<'_, f64>) =
        given.extract().map_err(|_| told())?;
    let rows = sizes_m.as_array().to_vec().into_iter().zip(hardnesses_pa.as_array().to_vec());
    HardnessTable::new(rows).map(GrowthLaw::Table).map_err(|error| of_argument(argument, error))
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
    /// The SI unit.
    const UNIT: &'static str;
    /// An example of its text, for messages.
    const EXAMPLE: &'static str;
    /// The bound on its number.
    const BOUND: Bound = Bound::Positive;

    /// Makes the quantity of a number in SI units.
    fn of_si(number: f64) -> Self;
}

macro_rules! quantities {
    ($($type:ty, $unit:literal, $example:literal, $bound:expr, $of_si:expr;)*) => {
        $(impl Quantity for $type {
            const UNIT: &'static str = $unit;
            const EXAMPLE: &'static str = $example;
            const BOUND: Bound = $bound;

            fn of_si(number: f64) -> Self {
                $of_si(number)
            }
        })*
    };
}

quantities! {
    Length, "m", "5 um", Bound::Positive, |m| Length { m };
    SignedLength, "m", "-5 nm", Bound::Finite, |m| SignedLength { m };
    Modulus, "Pa", "210 GPa", Bound::Positive, |pa| Modulus { pa };
    Force, "N", "10 mN", Bound::Positive, |n| Force { n };
    IndentationHardness, "Pa", "3 GPa", Bound::Positive, |pa| IndentationHardness { pa };
    Pressure, "Pa", "5 MPa", Bound::Positive, Pressure::Pascals;
    ThermalConductivity, "W/(m*K)", "46 W/(m K)", Bound::Positive, |w_per_m_k| ThermalConductivity { w_per_m_k };
    WorkOfAdhesion, "J/m**2", "50 mJ/m^2", Bound::Positive, |j_per_m2| WorkOfAdhesion { j_per_m2 };
    Resistivity, "ohm*m", "1.7e-8 ohm m", Bound::Positive, |ohm_m| Resistivity { ohm_m };
}

/// The quantity that an argument gives.
pub fn quantity<Q: Quantity>(argument: &str, given: &Given<'_>) -> PyResult<Q> {
    quantity_within(argument, given, Q::BOUND)
}

fn quantity_within<Q: Quantity>(argument: &str, given: &Given<'_>, bound: Bound) -> PyResult<Q> {
    if let Ok(text) = given.cast::<PyString>() {
        return text.to_str()?.parse().map_err(|error| of_argument(argument, error));
    }
    let bare = without_unit(argument, Q::UNIT, given)?;
    let number = bare_number(argument, &bare).map_err(|_| {
        let (unit, example, what) = (Q::UNIT, Q::EXAMPLE, type_name(given));
        of_argument(
            argument,
            format!("a number in {unit} is needed, or text such as '{example}', and this is {what}"),
        )
    })?;
    checked(argument, bound, number).map(Q::of_si)
}

/// A number within its bound.
pub fn checked(argument: &str, bound: Bound, number: f64) -> PyResult<f64> {
    bound
        .check("", number)
        .map_err(|error| input(format!("{argument} is {number}; it must be {}", error.bound)))
}

/// Numbers in a unit: those of a quantity of pint, astropy or unyt converted to it, anything else as it is.
#[pyfunction]
pub fn without_unit<'py>(argument: &str, unit: &str, given: &Given<'py>) -> PyResult<Given<'py>> {
    // pint's and astropy's, and unyt's.
    for method in ["m_as", "to_value"] {
        if given.hasattr(method)? {
            let converted = given.call_method1(method, (unit,));
            return converted.map_err(|error| {
                let unit = if unit.is_empty() { "a plain number" } else { unit };
                of_argument(argument, format!("cannot be converted to {unit}: {}", error.value(given.py())))
            });
        }
    }
    Ok(given.clone())
}

/// The number in SI units of text with a unit, or of anything else that is one number: in m, Pa, m², 1/m², or without a unit.
#[pyfunction]
pub fn si_number(argument: &str, unit: &str, given: &Given<'_>) -> PyResult<f64> {
    let Ok(text) = given.cast::<PyString>() else {
        return bare_number(argument, &without_unit(argument, unit, given)?);
    };
    let text = text.to_str()?;
    let parsed = match unit {
        "m" => text.parse::<SignedLength>().map(|length| length.m),
        "Pa" => text.parse::<Modulus>().map(|modulus| modulus.pa),
        "m**2" => text.parse::<Area>().map(|area| area.m2),
        "1/m**2" => {
            let none =
                || of_argument(argument, format!("'{text}' is no number per area, such as '1e12 1/m2'"));
            return per_area(text).ok_or_else(none);
        }
        _ => {
            let number = text.trim().parse().ok().filter(|number: &f64| number.is_finite());
            return number.ok_or_else(|| of_argument(argument, format!("'{text}' is no number")));
        }
    };
    parsed.map_err(|error| of_argument(argument, error))
}

/// A density such as `1e12 1/m2` or `0.5 /um2`.
fn per_area(text: &str) -> Option<f64> {
    let (number, area) = text.rsplit_once('/')?;
    let number = number.trim_end();
    let number: f64 = number.strip_suffix(" 1").unwrap_or(number).trim().parse().ok()?;
    format!("1 {area}").parse::<Area>().ok().map(|area| number / area.m2)
}

/// A number without a unit.
pub fn number(argument: &str, given: &Given<'_>) -> PyResult<f64> {
    bare_number(argument, &without_unit(argument, "", given)?)
}

/// A plain number.
fn bare_number(argument: &str, given: &Given<'_>) -> PyResult<f64> {
    let refused = || of_argument(argument, format!("a number is needed, and this is {}", type_name(given)));
    // The truths of numpy are no PyBool, and would be 0 and 1.
    let is_truth = given.get_type().name().is_ok_and(|name| name.to_string_lossy().starts_with("bool"));
    if is_truth || given.is_instance_of::<PyString>() {
        return Err(refused());
    }
    given.extract().map_err(|_| refused())
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

/// The text of an argument.
pub fn text(argument: &str, given: &Given<'_>) -> PyResult<String> {
    match given.cast::<PyString>() {
        Ok(text) => text.extract(),
        Err(_) => Err(of_argument(argument, format!("text is needed, and this is {}", type_name(given)))),
    }
}

/// Parses a named choice.
pub fn named<T: FromStr<Err = UnknownName>>(argument: &str, name: &str) -> PyResult<T> {
    name.parse().map_err(|error| of_argument(argument, error))
}

/// Describes the type of an argument, for messages.
pub fn type_name(given: &Given<'_>) -> String {
    given.get_type().name().map_or_else(|_| "something else".to_owned(), |name| format!("of type {name}"))
}
