//! Pressures and gaps of one surface under one load.

use std::borrow::Cow;
use std::io::{self, Write};

use crate::half_space::Loading;

use crate::boundary::Boundary;
use crate::netcdf_classic::{Attribute, NetcdfFile, Variable};
use crate::pressing::Pressing;
use crate::relief::Relief;

/// Surface under one load, point by point.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct ContactField<'s> {
    /// Index of the load.
    pub load: usize,
    /// Number of the surface.
    pub surface: usize,
    /// Heights of the surface.
    pub relief: &'s Relief,
    /// The nominal pressure \[Pa\].
    pub nominal_pressure_pa: f64,
    /// Contact modulus E* \[Pa\].
    pub contact_modulus_pa: f64,
    /// The pressure at which the surface yields \[Pa\]; `None` if it is elastic throughout.
    pub saturation_pa: Option<f64>,
    /// Pressure \[Pa\] at every point, row by row.
    pub pressures_pa: &'s [f64],
    /// Gap \[m\] at every point, row by row; negative where the surfaces overlap, infinite at missing points.
    pub gaps_m: &'s [f64],
}

/// State of a point of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointState {
    /// The surfaces are apart.
    Open,
    /// The surfaces touch elastically.
    Touching,
    /// The surfaces touch at the saturation.
    Yielding,
}

impl ContactField<'_> {
    /// Iterates over the states of the points, row by row, as the areas count them.
    pub fn states(&self) -> impl ExactSizeIterator<Item = PointState> {
        let loading = Loading {
            contact_modulus_pa: self.contact_modulus_pa,
            nominal_pressure_pa: self.nominal_pressure_pa,
            saturation_pa: self.saturation_pa,
            tolerance: Pressing::TOLERANCE,
        };
        self.pressures_pa.iter().map(move |&pressure_pa| match () {
            () if loading.yields_at(pressure_pa) => PointState::Yielding,
            () if loading.touches_at(pressure_pa) => PointState::Touching,
            () => PointState::Open,
        })
    }

    /// Returns the gap \[m\] at every point, row by row: 0 where the surfaces touch elastically, which the solver reaches within its
    /// tolerance; negative where they have yielded; infinite at missing points.
    #[must_use]
    pub fn closed_gaps_m(&self) -> Vec<f64> {
        let gaps_m = self.gaps_m.iter().zip(self.states());
        gaps_m
            .map(|(&gap_m, state)| match state {
                PointState::Open => gap_m,
                PointState::Touching => 0.0,
                PointState::Yielding => gap_m.min(0.0),
            })
            .collect()
    }

    /// Writes the field as NetCDF classic in the layout of contact.engineering: dimensions `y` and `x` with their
    /// coordinates, the variables `heights`, `pressure` and [`gap`](Self::closed_gaps_m) over both, and the attributes
    /// `nominal_pressure_pa`, `contact_modulus_pa` and `boundary`. Heights and gaps of missing points are NaN, which readers of NetCDF
    /// take for missing. Further variables over both are numbers without a unit, by their names.
    ///
    /// # Errors
    /// The errors of `out`.
    pub fn write_netcdf(&self, further: &[(&'static str, Vec<f64>)], out: &mut dyn Write) -> io::Result<()> {
        let Relief { rows, columns, length_x_m, length_y_m, boundary, ref heights_m, ref is_missing } =
            *self.relief;
        let gaps_m = self.closed_gaps_m();
        let [heights_m, gaps_m] = [heights_m, &gaps_m].map(|values_m| with_nan(values_m, is_missing));
        // The unit under the names of contact.engineering, whose layout this is, and of the CF conventions.
        let in_unit = |unit: &str| {
            ["unit", "units"]
                .map(|name| (name, Attribute::Text(unit.to_owned())))
                .into_iter()
                .collect::<Vec<_>>()
        };
        let periodic = f64::from(u8::from(boundary == Boundary::Periodic));
        let coordinate = |name, dimension, points: usize, length_m: f64| Variable {
            name,
            dimensions: vec![dimension],
            attributes: [
                in_unit("m"),
                vec![("length", Attribute::Number(length_m)), ("periodic", Attribute::Number(periodic))],
            ]
            .into_iter()
            .flatten()
            .collect(),
            values: (0..points).map(|point| point as f64 * length_m / points as f64).collect(),
        };
        let over_both =
            |name, unit, values| Variable { name, dimensions: vec![0, 1], attributes: in_unit(unit), values };
        let file = NetcdfFile {
            dimensions: vec![("y", rows), ("x", columns)],
            attributes: vec![
                ("nominal_pressure_pa", Attribute::Number(self.nominal_pressure_pa)),
                ("contact_modulus_pa", Attribute::Number(self.contact_modulus_pa)),
                ("boundary", Attribute::Text(boundary.to_string())),
            ],
            variables: [
                coordinate("y", 0, rows, length_y_m),
                coordinate("x", 1, columns, length_x_m),
                over_both("heights", "m", heights_m),
                over_both("pressure", "Pa", Cow::Borrowed(self.pressures_pa)),
                over_both("gap", "m", gaps_m),
            ]
            .into_iter()
            .chain(further.iter().map(|(name, values)| over_both(name, "1", Cow::Borrowed(&values[..]))))
            .collect(),
        };
        file.write(out)
    }
}

/// Returns the values with NaN at missing points, as files and arrays mark them.
#[must_use]
pub fn with_nan<'v>(values: &'v [f64], is_missing: &[bool]) -> Cow<'v, [f64]> {
    if is_missing.is_empty() {
        return Cow::Borrowed(values);
    }
    values
        .iter()
        .zip(is_missing)
        .map(|(&value, &is_missing)| if is_missing { f64::NAN } else { value })
        .collect()
}
