//! Loops of the tangential stress over the tangential displacement.

use ::interface::tangential::{ShearCycle, ShearError, ShearedPair};
use units::display::energy_per_area;

use super::{Axis, FigureData, Series, Shows};

const DISPLACEMENT: Axis = Axis { column: "tangential_displacement_m", label: "tangential displacement (m)" };
const STRESS: &str = "tangential stress (Pa)";

/// A cycle under one pressure.
#[derive(Debug, Clone, PartialEq)]
pub struct ShearLoop {
    /// Its load in the words of a label.
    pub label: String,
    /// The cycle.
    pub cycle: ShearCycle,
    /// Energy lost in it \[J/m^2\].
    pub dissipation_j_per_m2: f64,
}

impl ShearLoop {
    /// Follows a share of friction times a nominal pressure \[Pa\] through a cycle, in some steps; `stiffness` is that of the
    /// interface under any nominal pressure \[Pa/m\].
    ///
    /// # Errors
    /// [`ShearError`] with the errors of `stiffness`.
    pub fn new<E>(
        pair: &ShearedPair,
        label: &str,
        pressure_pa: f64,
        share: f64,
        steps: usize,
        stiffness: impl Fn(f64) -> Result<f64, E>,
    ) -> Result<Self, ShearError<E>> {
        Ok(ShearLoop {
            label: label.to_owned(),
            dissipation_j_per_m2: pair.respond(pressure_pa, share, &stiffness)?.dissipation_j_per_m2,
            cycle: pair.cycle(pressure_pa, share, steps, &stiffness)?,
        })
    }
}

/// Makes the figure of loops on linear axes; `None` without one. The energy lost per cycle is in the title of a single loop, and
/// in the legend of several.
#[must_use]
pub fn shear_loops(loops: &[ShearLoop]) -> Option<FigureData> {
    let lost = |of: &ShearLoop| format!("{} lost per cycle", energy_per_area(of.dissipation_j_per_m2));
    let (series, title) = match loops {
        [] => return None,
        [only] => {
            let ShearCycle { first_loading, unloading, reloading } = only.cycle.clone();
            let series = vec![
                Series::under("first loading", 0, first_loading),
                Series::under("unloading", 1, unloading),
                Series::under("reloading", 2, reloading),
            ];
            (series, format!("Tangential loading, {}: {}", only.label, lost(only)))
        }
        several => {
            let of_loop = |(at, of): (usize, &ShearLoop)| {
                let ShearCycle { first_loading, unloading, reloading } = of.cycle.clone();
                let ways = [
                    (0, "first loading", "first loading", first_loading),
                    (1, "cycle", "unloading", unloading),
                    (1, "cycle", "reloading", reloading),
                ];
                ways.map(|(curve_index, curve, way, points)| Series {
                    column: format!("{way}, {}", of.label),
                    curve: curve.to_owned(),
                    curve_index,
                    condition_in_full: format!("{}: {}", of.label, lost(of)),
                    ..Series::under(&of.label, at, points)
                })
            };
            let series: Vec<Series> = several.iter().enumerate().flat_map(of_loop).collect();
            (series, "Tangential loading".to_owned())
        }
    };
    let figure = FigureData::new("shear-loop", Shows::Response, DISPLACEMENT, STRESS, series);
    Some(FigureData { title, ..figure.with_linear_axes() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::AxisScale;

    fn shear_loop(label: &str) -> ShearLoop {
        let cycle = ShearCycle {
            first_loading: vec![(0.0, 0.0), (1e-9, 1e6)],
            unloading: vec![(-1e-9, -1e6), (1e-9, 1e6)],
            reloading: vec![(-1e-9, -1e6), (1e-9, 1e6)],
        };
        ShearLoop { label: label.to_owned(), cycle, dissipation_j_per_m2: 1.2e-3 }
    }

    #[test]
    fn the_energy_stands_in_the_title_of_one_loop_and_in_the_legend_of_several() {
        assert!(shear_loops(&[]).is_none());
        let one = shear_loops(&[shear_loop("50 MPa")]).unwrap();
        assert!(
            one.title.contains("50 MPa") && one.title.contains("1.2 mJ/m² lost per cycle"),
            "{}",
            one.title
        );
        assert_eq!((one.series.len(), one.x_scale, one.y_scale), (3, AxisScale::Linear, AxisScale::Linear));
        let two = shear_loops(&[shear_loop("50 MPa"), shear_loop("60 MPa")]).unwrap();
        assert_eq!(two.series.len(), 6);
        assert!(two.series[5].condition_in_full.contains("1.2 mJ/m²"), "{:?}", two.series[5]);
    }
}
