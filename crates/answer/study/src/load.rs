//! Nominal pressures: one type with one bound, whoever gives them and whatever model takes them.

use serde::Serialize;
use units::display::pressure;
use units::{Bound, OutOfBounds};

/// A pressure on the nominal area \[Pa\], above 0 and within thirty decades of 1 ([`Bound::Magnitude`]): what every model
/// takes without leaving the range of doubles.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Serialize)]
pub struct NominalPressure(f64);

impl NominalPressure {
    /// The bound of every nominal pressure, in Pa.
    pub const BOUND: Bound = Bound::Magnitude;

    /// A nominal pressure \[Pa\].
    ///
    /// # Errors
    /// [`OutOfBounds`] with the value and [`BOUND`](Self::BOUND).
    pub fn new(pressure_pa: f64) -> Result<Self, OutOfBounds> {
        Self::BOUND.check("nominal pressure in Pa", pressure_pa).map(NominalPressure)
    }

    /// As a number \[Pa\].
    #[must_use]
    pub fn pa(self) -> f64 {
        self.0
    }

    /// The name of a load that nobody has named, e.g. `1 kPa`.
    #[must_use]
    pub fn label(self) -> String {
        pressure(self.0)
    }
}

/// A nominal pressure and how it was given.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Load {
    /// The nominal pressure.
    pub nominal_pressure: NominalPressure,
    /// As typed, e.g. `1e-3 H`.
    pub label: String,
}

impl Load {
    /// The nominal pressure \[Pa\].
    #[must_use]
    pub fn nominal_pressure_pa(&self) -> f64 {
        self.nominal_pressure.pa()
    }
}

/// Nominal pressures evenly spaced in their logarithms. Each is made when its turn comes, so that a range takes no memory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadRange {
    from: NominalPressure,
    to: NominalPressure,
    points: u32,
}

impl LoadRange {
    /// Creates a range of pressures from one to another, both included; at least two pressures.
    #[must_use]
    pub fn new(from: NominalPressure, to: NominalPressure, points: u32) -> Self {
        LoadRange { from, to, points: points.max(2) }
    }

    /// Number of pressures in the range.
    #[must_use]
    pub fn points(self) -> usize {
        self.points as usize
    }

    /// The pressures, in order. Between two admitted pressures every one is admitted.
    pub fn pressures(self) -> impl Iterator<Item = NominalPressure> + Clone {
        units::log_spaced(self.from.0, self.to.0, self.points).map(NominalPressure)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_nominal_pressure_is_refused_with_its_value_and_bound() {
        let told = |pressure_pa| NominalPressure::new(pressure_pa).map_err(|error| error.to_string());
        assert_eq!(told(1e30).map(NominalPressure::pa), Ok(1e30));
        assert_eq!(told(1e31).unwrap_err(), "nominal pressure in Pa is 1e31; it must be from 1e-30 to 1e30");
        assert_eq!(
            told(f64::INFINITY).unwrap_err(),
            "nominal pressure in Pa is inf; it must be finite and greater than 0"
        );
    }

    #[test]
    fn a_range_has_both_its_ends() {
        let [from, to] = [1e-30, 1e30].map(|pa| NominalPressure::new(pa).unwrap());
        let range = LoadRange::new(from, to, 7);
        let pressures: Vec<f64> = range.pressures().map(NominalPressure::pa).collect();
        assert_eq!((pressures.len(), pressures[0], pressures[6]), (range.points(), 1e-30, 1e30));
        assert!((pressures[3] - 1.0).abs() < 1e-12);
    }
}
