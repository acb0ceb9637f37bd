//! Figures of the page: ratios to boundary elements, on logarithmic axes with steps of a factor of two, because half
//! of the data lies within one.

use std::sync::Arc;

use kuva::TickFormat;
use kuva::backend::svg::SvgBackend;
use kuva::plot::ScatterPlot;
use kuva::plot::legend::LegendPosition;
use kuva::plot::scatter::MarkerShape;
use kuva::render::annotations::{ReferenceLine, ShadedRegion};
use kuva::render::layout::Layout;
use kuva::render::plots::Plot;
use kuva::render::render::render_multiple;
use units::display::three_digits;

use crate::ratios::RatioRow;

const WIDTH_PX: f64 = 860.0;
const HEIGHT_PX: f64 = 440.0;

/// Colours that are distinct with any colour vision (Okabe & Ito), and the markers that go with them.
const COLOURS: [&str; 7] = ["#0072b2", "#d55e00", "#009e73", "#b0568a", "#c28400", "#000000", "#56b4e9"];
const MARKERS: [MarkerShape; 4] =
    [MarkerShape::Circle, MarkerShape::Square, MarkerShape::Triangle, MarkerShape::Diamond];

/// Ratio at which smaller ones are drawn.
const LEAST_RATIO: f64 = 1.0 / 64.0;

/// Width of a group of bars, in decades (or in steps of an axis that is not logarithmic).
const GROUP: f64 = 0.34;

/// Figure: the name of its file without extension, and the document.
pub type Picture = (&'static str, String);

/// Draws all figures.
#[must_use]
pub fn pictures(rows: &[RatioRow]) -> Vec<Picture> {
    vec![
        ("ratios-by-pressure", by_pressure(rows)),
        ("ratios-by-alpha-light", by_alpha(rows, 0.01)),
        ("ratios-by-alpha-medium", by_alpha(rows, 0.15)),
        ("ratios-by-hardness", by_hardness(rows)),
    ]
}

/// Models of some rows, in their order.
#[must_use]
pub fn models(rows: &[&RatioRow]) -> Vec<String> {
    let mut models: Vec<String> = Vec::new();
    for row in rows {
        if !models.contains(&row.model) {
            models.push(row.model.clone());
        }
    }
    models
}

/// Draws for every model and load the range over all spectra, with its median.
fn by_pressure(rows: &[RatioRow]) -> String {
    let elastic: Vec<&RatioRow> = rows
        .iter()
        .filter(|row| {
            row.spread_over_hardness.is_none()
                && crate::programme::PRESSURES.contains(&row.pressure_over_gradient)
        })
        .collect();
    bars(
        &elastic,
        "Elastic models over boundary elements: the range over all spectra, and its median",
        ("p/(E* h′)", powers()),
        |row| row.pressure_over_gradient.log10(),
    )
}

fn by_hardness(rows: &[RatioRow]) -> String {
    let yielding: Vec<&RatioRow> = rows.iter().filter(|row| row.spread_over_hardness.is_some()).collect();
    bars(
        &yielding,
        "Models that yield over elements saturated at H: the range over spectra and loads, and its median",
        ("s/H, the rms pressure of full contact over the hardness", plain()),
        |row| row.spread_over_hardness.unwrap_or(0.0),
    )
}

/// Draws for every model and abscissa a bar from the smallest to the largest ratio, and a marker at the median.
fn bars(
    rows: &[&RatioRow],
    title: &str,
    (x_label, x_format): (&str, TickFormat),
    x: impl Fn(&RatioRow) -> f64,
) -> String {
    let models = models(rows);
    let of_model = |(at, model): (usize, &String)| {
        let shift = GROUP * (at as f64 / (models.len() - 1).max(1) as f64 - 0.5);
        let mut places: Vec<f64> = rows.iter().map(|row| x(row)).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        let range = |&place: &f64| {
            let mut ratios: Vec<f64> = rows
                .iter()
                .filter(|row| row.model == *model && x(row) == place)
                .map(|row| height(row.ratio))
                .collect();
            ratios.sort_by(f64::total_cmp);
            let median = *ratios.get(ratios.len() / 2)?;
            Some(((place + shift, median), (median - ratios[0], ratios[ratios.len() - 1] - median)))
        };
        let (points, errors): (Vec<_>, Vec<_>) = places.iter().filter_map(range).unzip();
        let plot = ScatterPlot::new().with_data(points).with_y_err_asymmetric(errors);
        Plot::Scatter(styled(plot, at, model))
    };
    drawn(models.iter().enumerate().map(of_model).collect(), title, (x_label, x_format), rows, &x)
}

/// Draws the ratios of all elastic models over alpha, at one load.
fn by_alpha(rows: &[RatioRow], pressure_over_gradient: f64) -> String {
    let rows: Vec<&RatioRow> = rows
        .iter()
        .filter(|row| {
            row.spread_over_hardness.is_none() && row.pressure_over_gradient == pressure_over_gradient
        })
        .collect();
    let x = |row: &RatioRow| row.alpha.log10();
    let of_model = |(at, model): (usize, &String)| {
        let of_model = rows.iter().filter(|row| row.model == *model);
        let points: Vec<(f64, f64)> = of_model.map(|row| (x(row), height(row.ratio))).collect();
        Plot::Scatter(styled(ScatterPlot::new().with_data(points), at, model))
    };
    let title = format!(
        "Elastic models over boundary elements at p/(E* h′) = {}, a mark for every spectrum",
        three_digits(pressure_over_gradient)
    );
    let plots = models(&rows).iter().enumerate().map(of_model).collect();
    drawn(plots, &title, ("α = m₀m₄/m₂²", powers()), &rows, &x)
}

fn styled(plot: ScatterPlot, at: usize, model: &str) -> ScatterPlot {
    plot.with_color(COLOURS[at % COLOURS.len()])
        .with_marker(MARKERS[at % MARKERS.len()])
        .with_size(4.0)
        .with_legend(model)
}

fn drawn(
    plots: Vec<Plot>,
    title: &str,
    (x_label, x_format): (&str, TickFormat),
    rows: &[&RatioRow],
    x: &impl Fn(&RatioRow) -> f64,
) -> String {
    let range = |values: &mut dyn Iterator<Item = f64>| {
        values
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
    };
    let (left, right) = range(&mut rows.iter().map(|row| x(row)));
    let (low, high) = range(&mut rows.iter().map(|row| height(row.ratio)));
    let outwards = |value: f64, round: fn(f64) -> f64| round(2.0 * value) / 2.0;
    let mut layout = Layout::new((0.0, 1.0), (0.0, 1.0))
        .with_width(WIDTH_PX)
        .with_height(HEIGHT_PX)
        .with_title(title)
        .with_title_size(14)
        .with_label_size(13)
        .with_box_axes()
        .with_x_label(x_label)
        .with_x_axis_min(outwards(left - 0.5 * GROUP, f64::floor))
        .with_x_axis_max(outwards(right + 0.5 * GROUP, f64::ceil))
        .with_x_tick_step(if right - left > 1.5 { 1.0 } else { 0.5 })
        .with_x_tick_format(x_format)
        .with_y_label("area over that of boundary elements")
        .with_y_axis_min(low.min(-1.0).floor())
        .with_y_axis_max(high.max(1.0).ceil())
        .with_y_tick_step(1.0)
        .with_y_tick_format(powers_of_two())
        .with_legend_position(LegendPosition::OutsideRightTop)
        .with_shaded_region(ShadedRegion::horizontal(height(0.75), height(4.0 / 3.0)).with_color("#888888"))
        .with_reference_line(ReferenceLine::horizontal(0.0).with_color("#666666"));
    layout.show_legend = true;
    layout = layout.with_legend_width(legend_px(rows));
    let scene = render_multiple(plots, layout);
    let svg = SvgBackend::default().render_scene(&scene);
    // A picture without a view box is cropped where it should shrink.
    match svg.split_once('>') {
        Some((opening, inside)) => {
            format!(
                "{opening} viewBox=\"0 0 {} {}\">\n<!-- drawn by cargo xtask model-trials; do not edit -->\n{inside}",
                scene.width, scene.height
            )
        }
        None => svg,
    }
}

/// Width of the longest name with its mark.
fn legend_px(rows: &[&RatioRow]) -> f64 {
    const LETTER_PX: f64 = 7.2;
    const MARK_PX: f64 = 44.0;
    let letters = rows.iter().map(|row| row.model.chars().count()).max().unwrap_or(0);
    MARK_PX + LETTER_PX * letters as f64
}

/// Ordinate of a ratio: its logarithm to the base of two.
fn height(ratio: f64) -> f64 {
    ratio.max(LEAST_RATIO).log2()
}

fn powers_of_two() -> TickFormat {
    TickFormat::Custom(Arc::new(|power| {
        let value = 2f64.powf(power.abs().round());
        if power < -0.5 { format!("1/{value}") } else { format!("{value}") }
    }))
}

fn powers() -> TickFormat {
    TickFormat::Custom(Arc::new(|power| three_digits(10f64.powf(power))))
}

fn plain() -> TickFormat {
    TickFormat::Custom(Arc::new(three_digits))
}
