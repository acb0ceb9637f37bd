//! A figure as a Python script that draws its table with matplotlib, for those who finish figures by hand.

use std::borrow::Cow;

use study::figure::{AxisScale, FigureData, FigureStyle, Mark, Series};
use tables::Format;
use units::display::typeset;

use super::canvas::LETTERS_PX;
use super::ink::{Ink, mark_colour};
use super::palette::INTERVAL_OPACITY;
use super::{FONT_SIZE_PT, HEIGHT_PX, POINTS_PER_MM, WIDTH_PX};

const POINTS_PER_INCH: f64 = 72.0;

/// The script, with names between at signs for what differs from figure to figure.
const TEMPLATE: &str = r##"# Draws the figure with matplotlib from the table of its name: python @NAME@.py [FILE.pdf]
# Edit a copy: the program replaces this file when it writes the figure again.
import @READER@
import os
import sys
from pathlib import Path

import matplotlib.pyplot as plt

# Columns of the table: label, colour, width and dashes of their lines.
LINES = {
@LINES@}
# Marks with error bars: abscissa, lower limit, ordinate, upper limit, colour and label.
MARKS = [
@MARKS@]
# Stretches of the abscissa without a measurement.
HOLES = [@HOLES@]

here = Path(__file__).resolve().parent
places = [here / "@TABLE@", here.parent / "data" / "@TABLE@"]
with next((place for place in places if place.exists()), places[0]).open(encoding="utf-8") as file:
    rows = list(@ROWS@)


def points(column):
    filled = [row for row in rows if row.get(column) not in (None, "")]
    return [float(row["@X@"]) for row in filled], [float(row[column]) for row in filled]


plt.rcParams.update({"font.size": @SIZE@, "lines.scale_dashes": False, "pdf.fonttype": 42})
figure, axes = plt.subplots(figsize=(@WIDTH@, @HEIGHT@), layout="constrained")
for column, (label, colour, width, dashes) in LINES.items():
    axes.plot(*points(column), label=label, color=colour, linewidth=width, linestyle=(0, dashes))
    (x, low), (_, high) = points(f"{column} low"), points(f"{column} high")
    axes.fill_between(x, low, high, color=colour, alpha=@OPACITY@)
for x, low, y, high, colour, label in MARKS:
    axes.errorbar(x, y, [[y - low], [high - y]], label=label, color=colour, fmt="o", capsize=2, markersize=3)
for start, end in HOLES:
    axes.axvspan(start, end, color="0.85", linewidth=0, zorder=3)
axes.set(xscale="@XSCALE@", yscale="@YSCALE@", xlabel=@XLABEL@, ylabel=@YLABEL@, title=@TITLE@)
handles = {label: handle for handle, label in zip(*axes.get_legend_handles_labels())}
if 0 < len(handles) <= @MOST@:
    figure.legend(handles.values(), handles.keys(), loc="outside lower left", frameon=False)
os.environ.setdefault("SOURCE_DATE_EPOCH", "0")  # equal runs give equal files
figure.savefig(sys.argv[1], dpi=300) if len(sys.argv) > 1 else plt.show()
"##;

/// The most entries of a legend.
const MOST_ENTRIES: usize = 24;

/// Writes a Python script that draws a figure with matplotlib from its table in a format, with the colours and dashes of its
/// picture. The script takes the name of the file to write, or opens a window without one. `provenance` is put above it
/// as comments.
#[must_use]
pub fn script(figure: &FigureData, style: &FigureStyle, provenance: &[String], format: Format) -> String {
    let size_pt = style.font_size_pt.unwrap_or(FONT_SIZE_PT);
    let points_of_px = size_pt / LETTERS_PX;
    let width_pt = style.width_mm.map_or(WIDTH_PX * points_of_px, |width_mm| width_mm * POINTS_PER_MM);
    // Rows of the legend, each one and a half times as high as its letters.
    let entries = figure.series.len() + figure.marks.len().min(2);
    let legend_pt = if entries <= MOST_ENTRIES { 1.5 * size_pt * (entries + 1) as f64 } else { 0.0 };
    let (width, height) =
        (width_pt / POINTS_PER_INCH, (width_pt * HEIGHT_PX / WIDTH_PX + legend_pt) / POINTS_PER_INCH);
    let scale = |scale| if scale == AxisScale::Linear { "linear" } else { "log" };
    let holes: Vec<String> = figure.gaps.iter().map(|(from, to)| format!("({from:e}, {to:e})")).collect();
    let value = |name: &str| -> String {
        match name {
            "NAME" => figure.name.clone(),
            "TABLE" => format!("{}.{}", figure.name, format.extension()),
            "READER" => format.extension().to_owned(),
            "ROWS" => match format {
                Format::Csv => {
                    "csv.DictReader(line for line in file if not line.startswith(\"#\"))".to_owned()
                }
                Format::Json => "json.load(file)".to_owned(),
            },
            "LINES" => figure.series.iter().map(|series| line(figure, series, points_of_px)).collect(),
            "MARKS" => figure.marks.iter().map(|of| mark(figure, of)).collect(),
            "HOLES" => holes.join(", "),
            "X" => figure.x.column.to_owned(),
            "SIZE" => size_pt.to_string(),
            "WIDTH" => format!("{width:.4}"),
            "HEIGHT" => format!("{height:.4}"),
            "OPACITY" => INTERVAL_OPACITY.to_string(),
            "MOST" => MOST_ENTRIES.to_string(),
            "XSCALE" => scale(figure.x_scale).to_owned(),
            "YSCALE" => scale(figure.y_scale).to_owned(),
            "XLABEL" => label(&figure.x_label),
            "YLABEL" => label(figure.y_label),
            "TITLE" => label(if style.hides_title { "" } else { &figure.title }),
            _ => unreachable!("the template has no @{name}@"),
        }
    };
    let mut script = String::from("#!/usr/bin/env python3\n");
    for line in provenance.iter().flat_map(|lines| lines.lines()) {
        script += &format!("# {}\n", line.replace(char::is_control, " "));
    }
    let parts = TEMPLATE.split('@').enumerate();
    script.extend(parts.map(|(at, part)| if at % 2 == 0 { Cow::from(part) } else { value(part).into() }));
    script
}

/// The entry of a line, in points.
fn line(figure: &FigureData, series: &Series, points_of_px: f64) -> String {
    let Ink { dark, width_px, dash, .. } = Ink::new(figure, series);
    let names = [series.curve.clone(), typeset(&series.condition)];
    let name = names.into_iter().filter(|name| !name.is_empty()).collect::<Vec<_>>().join(", ");
    let lengths = dash.split(' ').filter_map(|px| px.parse::<f64>().ok());
    let dashes: Vec<String> = lengths.map(|px| format!("{:.3}", px * points_of_px)).collect();
    let dashes = if dashes.is_empty() { "None".to_owned() } else { format!("({})", dashes.join(", ")) };
    let width_pt = width_px * points_of_px;
    format!("    {}: ({}, \"{dark}\", {width_pt:.3}, {dashes}),\n", text(&series.column), label(&name))
}

fn mark(figure: &FigureData, mark: &Mark) -> String {
    let Mark { x, y, low, high, .. } = mark;
    let colour = mark_colour(figure, mark.condition_index);
    format!("    ({x:e}, {low:e}, {y:e}, {high:e}, \"{colour}\", {}),\n", label(&mark.label))
}

/// A text as a literal of Python.
fn text(content: &str) -> String {
    let escaped = |letter: char| match letter {
        '"' | '\\' => format!("\\{letter}"),
        letter if letter.is_control() => " ".to_owned(),
        letter => letter.to_string(),
    };
    format!("\"{}\"", content.chars().map(escaped).collect::<String>())
}

/// A text as a literal of Python that matplotlib takes for no formula.
fn label(content: &str) -> String {
    text(&content.replace('$', "\\$"))
}

#[cfg(test)]
mod tests {
    use study::figure::{Axis, Shows};

    use super::*;

    fn figure() -> FigureData {
        let x = Axis { column: "wavelength_m", label: "wavelength (m)" };
        let series = vec![Series::under("10 \"MPa\"", 0, vec![(8e-6, 0.1), (1e-6, 0.4)])];
        FigureData {
            title: "say \"$x$\" @TABLE@\n\\".to_owned(),
            gaps: vec![(2e-6, 4e-6)],
            ..FigureData::new("f", Shows::Area, x, "contact area / nominal area", series)
        }
    }

    #[test]
    fn a_script_of_few_lines_reads_the_table_of_its_figure() {
        let drawn = |format| script(&figure(), &FigureStyle::default(), &["from a\nscan".to_owned()], format);
        let csv = drawn(Format::Csv);
        for line in [
            "# from a\n# scan\n",
            "import csv\n",
            "here / \"f.csv\"",
            "csv.DictReader(",
            "    \"10 \\\"MPa\\\"\": (\"10 \\\"MPa\\\"\", \"#0072b2\", 1.067, None),\n",
            "HOLES = [(2e-6, 4e-6)]",
            "row[\"wavelength_m\"]",
            "title=\"say \\\"\\\\$x\\\\$\\\" @TABLE@ \\\\\"",
        ] {
            assert!(csv.contains(line), "{line}: {csv}");
        }
        assert!(csv.lines().count() < 60, "{csv}");
        assert!(drawn(Format::Json).contains("rows = list(json.load(file))"));
        let linear = script(&figure().with_linear_axes(), &FigureStyle::default(), &[], Format::Csv);
        assert!(linear.contains("xscale=\"linear\", yscale=\"linear\""), "{linear}");
    }

    #[test]
    fn a_figure_of_85_mm_has_that_width() {
        let style = FigureStyle { width_mm: Some(85.0), ..FigureStyle::default() };
        assert!(script(&figure(), &style, &[], Format::Csv).contains("figsize=(3.3465, "));
    }
}
