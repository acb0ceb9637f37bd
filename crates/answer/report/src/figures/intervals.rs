//! Coverage intervals, on figures of areas.

use crate::uncertainty_words::level;
use scene::Scene;
use study::figure::{BandKind, Figure, FigureBand, FigureData, Mark, Series, Shows};
use uncertainty::{AreaBand, AreaInterval, Uncertainty};

/// Adds coverage intervals to a figure of areas: bands behind the lines against the cutoff, and bars at the loads of
/// the scene on lines against the load that end at the shortest wavelength. Its lines have the curves' own names.
pub(crate) fn with_intervals(
    data: FigureData,
    figure: &Figure,
    scene: &Scene,
    uncertainty: &Uncertainty,
) -> FigureData {
    let label = format!("{} coverage interval", level(uncertainty));
    match data.shows {
        Shows::Area => {
            let bands = uncertainty.bands.iter().filter_map(|area| band(&data, scene, &label, area));
            let intervals: Vec<FigureBand> = bands.collect();
            FigureData { bands: data.bands.into_iter().chain(intervals).collect(), ..data }
        }
        // Bars on the lines would be taken for those of boundary elements.
        Shows::AreaAgainstLoad if data.marks.is_empty() => {
            FigureData { marks: bars(&data, figure, scene, &label, uncertainty), ..data }
        }
        _ => data,
    }
}

/// The band of a line that the figure shows.
fn band(data: &FigureData, scene: &Scene, label: &str, area: &AreaBand) -> Option<FigureBand> {
    let name = &scene.needs.curves.get(area.curve)?.name;
    let line = data.series.iter().find(|line| line.curve == *name && line.load == Some(area.load))?;
    let points = area.points.iter().map(|point| (point.wavelength_m, [point.low, point.high]));
    Some(FigureBand {
        label: label.to_owned(),
        kind: BandKind::Interval,
        load: line.load,
        curve_index: line.curve_index,
        points: points.collect(),
    })
}

/// The intervals at the scene's loads, for lines that use the whole spectrum.
fn bars(
    data: &FigureData,
    figure: &Figure,
    scene: &Scene,
    label: &str,
    uncertainty: &Uncertainty,
) -> Vec<Mark> {
    let ends = figure.sweeps.iter().zip(&data.series).filter_map(|(&sweep, line)| {
        let sweep = scene.needs.sweeps.get(sweep)?;
        (sweep.cutoff_multiple == 1.0).then_some((sweep.curve, line))
    });
    let bar = |area: &AreaInterval, line: &Series| Mark {
        label: label.to_owned(),
        column: format!("{} interval", line.column),
        is_ring: false,
        condition_index: line.condition_index,
        x: scene.needs.loads[area.load].nominal_pressure_pa(),
        y: area.area_fraction,
        low: area.low,
        high: area.high,
    };
    ends.flat_map(|(curve, line)| {
        uncertainty.areas.iter().filter(move |area| area.curve == curve).map(move |area| bar(area, line))
    })
    .filter(|mark| mark.low > 0.0)
    .collect()
}
