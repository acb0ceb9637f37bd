//! A figure as a Python script that draws it with matplotlib, for those who finish figures by hand.

use study::figure::{AxisKind, AxisScale, BandKind, FigureData, FigureStyle, Series, pieces};

use super::bands::{self, EDGE_PX, INTERVAL_OPACITY, OPACITY};
use super::legend::{self, Entry, Sample};
use super::ruler::{Ruler, Rulers, is_length, is_share};
use super::style::{Ink, colour_index};
use super::thinned::thinned;
use super::{
    FONT_SIZE_PT, HEIGHT_PX, LETTERS_PX, POINTS_PER_MM, TITLE_PX, WIDTH_PX, drawn_points, mark_colour,
};

const POINTS_PER_INCH: f64 = 72.0;

/// Writes a Python script that draws a figure with matplotlib, with the data, colours and dashes of its picture. The script
/// takes the name of the file to write, or opens a window without one. `provenance` stands above it as comments.
#[must_use]
pub fn script(figure: &FigureData, style: &FigureStyle, provenance: &[String]) -> String {
    let font_size_pt = style.font_size_pt.unwrap_or(FONT_SIZE_PT);
    let points_of_px = font_size_pt / LETTERS_PX;
    let width_in =
        style.width_mm.map_or(WIDTH_PX * points_of_px, |width_mm| width_mm * POINTS_PER_MM) / POINTS_PER_INCH;
    let legend: Vec<String> =
        legend::entries(figure, |_| false).iter().flatten().map(|entry| key(entry, points_of_px)).collect();
    let letters_in = points_of_px * (TITLE_PX + legend.len() as f64 * legend::ROW_PX) / POINTS_PER_INCH;
    let height_in = width_in * HEIGHT_PX / WIDTH_PX + letters_in;
    let title = if style.hides_title { String::new() } else { text(&figure.title) };
    let list = |name: &str, rows: Vec<String>| match rows.is_empty() {
        true => format!("{name} = []\n"),
        false => format!("{name} = [\n    {},\n]\n", rows.join(",\n    ")),
    };
    let holes = figure.gaps.iter().map(|(from, to)| format!("({}, {})", number(*from), number(*to)));
    let mut script = String::from("#!/usr/bin/env python3\n");
    for line in provenance.iter().flat_map(|lines| lines.lines()) {
        script += &format!("# {}\n", line.replace(char::is_control, " "));
    }
    script += &format!("# Draws the figure with matplotlib: python {}.py [FILE.pdf]\n", figure.name);
    script += "# Edit a copy: the program replaces this file when it writes the figure again.\n";
    script += "import sys\nimport textwrap\n\nimport matplotlib.pyplot as plt\nfrom matplotlib.lines import Line2D\nfrom matplotlib.patches import Patch\nfrom matplotlib.ticker import FuncFormatter\n";
    script += "\n\ndef line(**style):\n    return Line2D([], [], **style)\n\n\nnan = float(\"nan\")\n";
    script += "# Lines, broken at holes of the spectrum.\n";
    let rulers = Rulers::around(figure, &drawn_points(&[figure]), None);
    let lines = figure.series.iter().map(|series| line(figure, &rulers, series, points_of_px));
    script += &list("lines", lines.collect());
    script += "# Bands: x, lower limit, upper limit.\n";
    script +=
        &list("bands", figure.bands.iter().map(|band| self::band(figure, band, points_of_px)).collect());
    script += "# Values of boundary elements with their errors.\n";
    script += &list("marks", figure.marks.iter().map(|mark| self::mark(figure, mark)).collect());
    script += "# Entries of the legend.\n";
    script += &list("keys", legend);
    script += "# Stretches of the abscissa without a measurement.\n";
    script += &list("holes", holes.collect());
    script += TICKS;
    script += &format!(
        "plt.rcParams.update({{\"font.size\": {font_size_pt}, \"lines.scale_dashes\": False, \"pdf.fonttype\": 42}})\n\
         figure, axes = plt.subplots(figsize=({width_in:.4}, {height_in:.4}), layout=\"constrained\")\n"
    );
    script += DRAWING;
    let is_x_length = figure.x.kind() == AxisKind::Length;
    let axes = [
        ("x", figure.x_scale, formatter(&rulers.x, is_x_length, false)),
        ("y", figure.y_scale, formatter(&rulers.y, is_length(figure), is_share(figure))),
    ];
    for (axis, scale, formatter) in axes {
        let scale = if scale == AxisScale::Linear { "linear" } else { "log" };
        script += &format!("axes.set_{axis}scale(\"{scale}\")\n");
        if let Some(formatter) = formatter {
            script += &format!("axes.{axis}axis.set_major_formatter(FuncFormatter({formatter}))\n");
        }
    }
    script += &format!(
        "axes.set_xlabel({})\naxes.set_ylabel({})\naxes.set_title({})\n",
        text(&rulers.x_label(figure)),
        text(&rulers.y_label(figure)),
        if title.is_empty() { "\"\"" } else { title.as_str() },
    );
    script + ENDING
}

const TICKS: &str = r#"

def length(metres, _=None):
    for unit, size in (("m", 1.0), ("mm", 1e-3), ("µm", 1e-6), ("nm", 1e-9)):
        if metres >= 0.9999 * size:
            return f"{metres / size:g} {unit}"
    return f"{metres / 1e-12:g} pm"


def share(value, _=None):
    return f"{100 * value:g} %" if value >= 0.9999e-4 else f"{1e6 * value:g} ppm"


"#;

const DRAWING: &str = "\
for start, end in holes:
    axes.axvspan(start, end, color=\"#808080\", alpha=0.15, linewidth=0)
for x, low, high, style in bands:
    axes.fill_between(x, low, high, **style)
for x, y, style in lines:
    axes.plot(x, y, **style)
for x, y, low, high, style in marks:
    axes.errorbar([x], [y], yerr=[[y - low], [high - y]], capsize=2, markersize=4, zorder=3, **style)
";

/// The function that labels the ticks of an axis, unless matplotlib does it well.
fn formatter(ruler: &Ruler, is_length: bool, is_share: bool) -> Option<String> {
    match ruler {
        Ruler::Decades(_) if is_length => Some("length".to_owned()),
        Ruler::Decades(_) => is_share.then(|| "share".to_owned()),
        Ruler::Steps(_) if is_share => Some("lambda value, _: f\"{100 * value:g} %\"".to_owned()),
        Ruler::Steps(steps) => Some(format!("lambda value, _: f\"{{value / {:e}:g}}\"", steps.scale())),
    }
}

const ENDING: &str = "\
if keys:
    handles = [kind(**style) for kind, style in keys]
    letters = int(figure.get_figwidth() * 72 / (0.62 * plt.rcParams[\"font.size\"])) - 6
    labels = [textwrap.fill(handle.get_label(), letters) for handle in handles]
    figure.legend(handles, labels, loc=\"outside lower left\", frameon=False)
if len(sys.argv) > 1:
    figure.savefig(sys.argv[1], dpi=300)
else:
    plt.show()
";

fn line(figure: &FigureData, rulers: &Rulers, series: &Series, points_of_px: f64) -> String {
    let ink = Ink::new(figure, series);
    let places = figure.pieces(series).into_iter().map(|piece| thinned(rulers.places(&piece)));
    let mut runs: Vec<Vec<(f64, f64)>> = places.filter(|run| !run.is_empty()).collect();
    let last = runs.len().saturating_sub(1);
    // A point that is not a number breaks the line.
    runs.iter_mut().take(last).for_each(|run| run.push((f64::NAN, f64::NAN)));
    let points = || runs.iter().flatten();
    let marker =
        if runs.iter().any(|run| run.len() == 1) { ", \"marker\": \"o\", \"markersize\": 3" } else { "" };
    format!(
        "([{}], [{}], {{\"color\": \"{}\", \"linewidth\": {:.3}, \"linestyle\": {}{marker}}})",
        numbers(points().map(|(x, _)| rulers.x.value(*x))),
        numbers(points().map(|(_, y)| rulers.y.value(*y))),
        ink.colour,
        ink.width_px * points_of_px,
        dashes(ink.dash.dasharray().as_deref(), points_of_px),
    )
}

fn band(figure: &FigureData, band: &study::figure::Band, points_of_px: f64) -> String {
    let ink = bands::ink(figure, band);
    let (opacity, edge_px, runs) = match band.kind {
        BandKind::Yardstick => (OPACITY, 0.0, pieces(&band.points, &figure.gaps)),
        BandKind::Interval => (INTERVAL_OPACITY, EDGE_PX, vec![band.points.clone()]),
    };
    let last = runs.len().saturating_sub(1);
    let broken = runs.into_iter().enumerate().flat_map(|(at, mut run)| {
        run.extend((at < last).then_some((f64::NAN, [f64::NAN; 2])));
        run
    });
    let points: Vec<(f64, [f64; 2])> = broken.collect();
    format!(
        "([{}], [{}], [{}], {{\"color\": \"{}\", \"alpha\": {opacity}, \"linewidth\": {:.3}}})",
        numbers(points.iter().map(|point| point.0)),
        numbers(points.iter().map(|point| point.1[0])),
        numbers(points.iter().map(|point| point.1[1])),
        ink.dark,
        edge_px * points_of_px,
    )
}

fn mark(figure: &FigureData, mark: &study::figure::Mark) -> String {
    let [x, y, low, high] = [mark.x, mark.y, mark.low, mark.high].map(number);
    let colour = mark_colour(figure, colour_index(figure, mark.condition_index));
    let face = if mark.is_ring { "white" } else { &colour };
    format!(
        "({x}, {y}, {low}, {high}, {{\"fmt\": \"o\", \"color\": \"{colour}\", \"markerfacecolor\": \"{face}\"}})"
    )
}

/// An entry of the legend: the class of its sample, and the options of that.
fn key(entry: &Entry<'_>, points_of_px: f64) -> String {
    let (class, style) = match &entry.sample {
        Sample::Line { dash, width_px } => {
            let dashes = dashes(dash.as_deref(), points_of_px);
            let width_pt = width_px * points_of_px;
            ("line", format!("\"linewidth\": {width_pt:.3}, \"linestyle\": {dashes}"))
        }
        Sample::None => ("line", "\"linestyle\": \"none\"".to_owned()),
        Sample::Disc { is_ring } => {
            let face = if *is_ring { "white" } else { &entry.colour };
            ("line", format!("\"linestyle\": \"none\", \"marker\": \"o\", \"markerfacecolor\": \"{face}\""))
        }
        Sample::Band(BandKind::Yardstick) => ("Patch", format!("\"alpha\": {OPACITY}, \"linewidth\": 0")),
        Sample::Band(BandKind::Interval) => ("Patch", format!("\"alpha\": {INTERVAL_OPACITY}")),
    };
    format!("({class}, {{\"color\": \"{}\", {style}, \"label\": {}}})", entry.colour, text(entry.label))
}

/// The dash pattern as matplotlib takes it, in points.
fn dashes(pattern: Option<&str>, points_of_px: f64) -> String {
    let Some(pattern) = pattern else { return "\"-\"".to_owned() };
    let lengths = pattern.split([' ', ',']).filter_map(|px| px.parse::<f64>().ok());
    let lengths: Vec<String> = lengths.map(|px| format!("{:.3}", px * points_of_px)).collect();
    format!("(0, ({}))", lengths.join(", "))
}

fn numbers(values: impl Iterator<Item = f64>) -> String {
    values.map(number).collect::<Vec<_>>().join(", ")
}

/// Seven digits, more than a picture shows.
fn number(value: f64) -> String {
    if value.is_nan() { "nan".to_owned() } else { format!("{value:.6e}") }
}

/// A text as a literal of Python, without the letters that matplotlib takes for formulas.
fn text(content: &str) -> String {
    let mut literal = String::from("\"");
    for letter in content.chars() {
        match letter {
            '"' => literal += "\\\"",
            '\\' => literal += "\\\\",
            '$' => literal += "\\\\$",
            letter if letter.is_control() => literal.push(' '),
            letter => literal.push(letter),
        }
    }
    literal + "\""
}

#[cfg(test)]
mod tests {
    use study::figure::{Axis, Shows};

    use super::*;

    fn figure() -> FigureData {
        let x = Axis { column: "wavelength_m", label: "wavelength (m)" };
        let points = vec![(8e-6, 0.1), (4e-6, 0.2), (2e-6, 0.3), (1e-6, 0.4)];
        FigureData {
            title: "say \"$x$\"\n\\".to_owned(),
            gaps: vec![(2e-6, 4e-6)],
            ..FigureData::new(
                "f",
                Shows::Area,
                x,
                "contact area / nominal area",
                vec![Series::under("10 MPa", 0, points)],
            )
        }
    }

    #[test]
    fn linear_axes_keep_their_values_and_name_the_prefix() {
        let x = Axis { column: "shear_m", label: "shear (m)" };
        let lines = vec![Series::under("back", 0, vec![(-3e-9, -2e6), (3e-9, 2e6)])];
        let figure = FigureData::new("f", Shows::Response, x, "stress (Pa)", lines).with_linear_axes();
        let script = script(&figure, &FigureStyle::default(), &[]);
        for line in [
            "([-3.000000e-9, 3.000000e-9], [-2.000000e6, 2.000000e6]",
            "axes.set_xscale(\"linear\")\naxes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f\"{value / 1e-9:g}\"))",
            "axes.set_ylabel(\"stress (MPa)\")",
        ] {
            assert!(script.contains(line), "{line}: {script}");
        }
    }

    #[test]
    fn lines_break_at_holes_and_axes_have_units() {
        let script = script(&figure(), &FigureStyle::default(), &["from a\nscan".to_owned()]);
        assert!(script.contains("[8.000000e-6, 4.000000e-6, nan, 2.000000e-6, 1.000000e-6]"), "{script}");
        assert!(script.contains("holes = [\n    (2.000000e-6, 4.000000e-6),\n]"));
        assert!(script.contains("xaxis.set_major_formatter(FuncFormatter(length))"));
        assert!(script.contains("yaxis.set_major_formatter(FuncFormatter(share))"));
        assert!(script.contains("# from a\n# scan\n"));
    }

    #[test]
    fn no_text_ends_its_literal_or_becomes_a_formula() {
        assert_eq!(text("say \"$x$\"\n\\"), r#""say \"\\$x\\$\" \\""#);
    }

    #[test]
    fn a_figure_of_85_mm_has_that_width() {
        let style = FigureStyle { width_mm: Some(85.0), ..FigureStyle::default() };
        assert!(script(&figure(), &style, &[]).contains("figsize=(3.3465, "));
    }
}
