//! A figure as a Python script that draws its table with matplotlib, for those who finish figures by hand.

use std::borrow::Cow;
use std::collections::BTreeSet;

use study::figure::{AxisKind, AxisScale, FigureData, FigureStyle, Series};
use tables::Format;

use super::canvas::LETTERS_PX;
use super::ink::{Ink, band_colour, label, label_group, labels_name_models, mark_colour, opacity};
use super::{FONT_SIZE_PT, HEIGHT_PX, POINTS_PER_MM, WIDTH_PX};

const POINTS_PER_INCH: f64 = 72.0;

/// The script, with names between at signs for what differs from figure to figure.
const TEMPLATE: &str = r##"# Draws the figure from the table of its name: python @NAME@.py [FILE.pdf]. Edit a copy: the program replaces this file.
import @READER@, sys
from pathlib import Path
import matplotlib.pyplot as plt
import numpy as np

here = Path(__file__).resolve().parent
table = next(place / "@TABLE@" for place in [here, here.parent / "data"] if (place / "@TABLE@").exists())
rows = list(@ROWS@)

def points(*columns):
    filled = [row for row in rows if row.get(columns[0]) not in (None, "")]
    return np.array([[float(row[name]) for row in filled] for name in ("@X@", *columns)])

plt.rcParams.update({"font.family": ["sans-serif", "DejaVu Sans"], "font.sans-serif": ["Helvetica", "Arial", "Liberation Sans"]})
plt.rcParams.update({"font.size": @SIZE@, "xtick.direction": "in", "ytick.direction": "in", "lines.scale_dashes": False, "pdf.fonttype": 42})
figure, axes = plt.subplots(figsize=(@WIDTH@, @HEIGHT@), layout="constrained", subplot_kw={"xmargin": 0.02, "ymargin": 0.1})
for column, label, text, colour, width, dashes in [
@LINES@]:
    x, y = points(column)
    axes.plot(x, y, label=label, color=colour, linewidth=width, linestyle=(0, dashes))
    axes.annotate(text, (x[-1], y[-1]), @BESIDE@, textcoords="offset points", color=colour)
@BANDS@@MARKS@@HOLES@axes.set(xscale="@XSCALE@", yscale="@YSCALE@", xlabel=@XLABEL@, ylabel=@YLABEL@, title=@TITLE@)
@FORMATS@entries = {label: handle for handle, label in zip(*axes.get_legend_handles_labels())}
figure.legend(entries.values(), entries.keys(), loc="outside lower left", ncols=@COLUMNS@, frameon=False)
figure.savefig(sys.argv[1], dpi=600) if len(sys.argv) > 1 else plt.show()
"##;

/// The most entries of a legend, and the width of a figure in letters that has room for two beside each other.
const MOST_ENTRIES: usize = 24;
const WIDE_LETTERS: f64 = 40.0;

/// Writes a Python script that draws a figure with matplotlib from its table in a format, with the colours and dashes of its
/// picture. The script takes the name of the file to write, or opens a window without one. The first line of `provenance`
/// is put above it; the table has all of them.
#[must_use]
pub fn script(figure: &FigureData, style: &FigureStyle, provenance: &[String], format: Format) -> String {
    let size_pt = style.font_size_pt.unwrap_or(FONT_SIZE_PT);
    let points_of_px = size_pt / LETTERS_PX;
    let width_pt = style.width_mm.map_or(WIDTH_PX * points_of_px, |width_mm| width_mm * POINTS_PER_MM);
    let scale = |scale| if scale == AxisScale::Linear { "linear" } else { "log" };
    let is_legible = figure.series.len() <= MOST_ENTRIES;
    let drawn = (0..figure.series.len()).filter(|at| !figure.series[*at].points.is_empty());
    let lines: String = drawn.map(|at| line(figure, at, points_of_px, is_legible)).collect();
    // Rows of the legend are one and a half times as high as their letters.
    let name = |series: &Series| if series.look.is_some() { series.curve.clone() } else { both(series) };
    let entries = figure.series.iter().map(name).collect::<BTreeSet<_>>().len().min(MOST_ENTRIES) + 3;
    let columns = if width_pt / size_pt < WIDE_LETTERS { 1 } else { 2 };
    let legend_pt = 1.5 * size_pt * entries.div_ceil(columns) as f64;
    let height = (width_pt * HEIGHT_PX / WIDTH_PX + legend_pt) / POINTS_PER_INCH;
    let value = |name: &str| -> String {
        match name {
            "NAME" => figure.name.clone(),
            "TABLE" => format!("{}.{}", figure.name, format.extension()),
            "READER" => format.extension().to_owned(),
            "ROWS" => match format {
                Format::Csv => {
                    "csv.DictReader(line for line in table.open(encoding=\"utf-8\") if line[0] != \"#\")"
                }
                Format::Json => "json.load(table.open(encoding=\"utf-8\"))",
            }
            .to_owned(),
            "LINES" => lines.clone(),
            "BANDS" => bands(figure),
            "MARKS" => marks(figure),
            "HOLES" => figure
                .gaps
                .iter()
                .map(|(from, to)| format!("axes.axvspan({from:e}, {to:e}, color=\"0.88\", linewidth=0, zorder=3)  # not measured\n"))
                .collect(),
            "X" => figure.x.column.to_owned(),
            "SIZE" => size_pt.to_string(),
            "WIDTH" => format!("{:.4}", width_pt / POINTS_PER_INCH),
            // Lines of areas rise from their shortest wavelength, and towards their largest load.
            "BESIDE" => match figure.x.kind() {
                AxisKind::Other => "(0, 4), ha=\"right\"",
                _ => "(0, -5), va=\"top\"",
            }
            .to_owned(),
            "COLUMNS" => columns.to_string(),
            "HEIGHT" => format!("{height:.4}"),
            "XSCALE" => scale(figure.x_scale).to_owned(),
            "YSCALE" => scale(figure.y_scale).to_owned(),
            "XLABEL" => literal(figure.x_label.strip_suffix(" (m)").unwrap_or(&figure.x_label)),
            "YLABEL" => literal(figure.y_label),
            "TITLE" => literal(if style.hides_title { "" } else { &figure.title }),
            "FORMATS" => formats(figure),
            _ => unreachable!("the template has no @{name}@"),
        }
    };
    let mut script = String::new();
    if let Some(line) = provenance.first() {
        script += &format!("# {}\n", line.replace(char::is_control, " "));
    }
    let parts = TEMPLATE.split('@').enumerate();
    script.extend(parts.map(|(at, part)| if at % 2 == 0 { Cow::from(part) } else { value(part).into() }));
    script
}

/// The entry of a line: its column, its words in the legend and beside it, and its look in points.
fn line(figure: &FigureData, at: usize, points_of_px: f64, is_legible: bool) -> String {
    let series = &figure.series[at];
    let Ink { dark, width_px, dash, .. } = Ink::new(figure, series);
    let is_first = (0..at).all(|other| label_group(figure, other) != label_group(figure, at));
    let (in_legend, beside) = match series.look {
        Some(_) if labels_name_models(figure) => (series.condition_in_full.clone(), label(figure, series)),
        Some(_) => (series.curve.clone(), if is_first { label(figure, series) } else { String::new() }),
        None => (both(series), String::new()),
    };
    let in_legend = if is_legible { literal(&in_legend) } else { "None".to_owned() };
    let lengths = dash.split(' ').filter_map(|px| px.parse::<f64>().ok());
    let dashes: Vec<String> = lengths.map(|px| format!("{:.3}", px * points_of_px)).collect();
    let dashes = if dashes.is_empty() { "None".to_owned() } else { format!("({})", dashes.join(", ")) };
    let (column, width_pt) = (text(&series.column), width_px * points_of_px);
    format!("    ({column}, {in_legend}, {}, \"{dark}\", {width_pt:.3}, {dashes}),\n", literal(&beside))
}

/// The names of a line of no model: of its curve and of its condition.
fn both(series: &Series) -> String {
    let names = [series.curve.as_str(), series.condition.as_str()];
    names.into_iter().filter(|name| !name.is_empty()).collect::<Vec<_>>().join(", ")
}

/// The bands.
fn bands(figure: &FigureData) -> String {
    loops(figure.named_bands().map(|(column, band)| {
        let body = format!(
            "    axes.fill_between(*points(f\"{{column}} low\", f\"{{column}} high\"), label={}, color=\"{}\", alpha={}, linewidth=0)\n",
            literal(&band.label),
            band_colour(figure, band),
            opacity(band.kind)
        );
        (column, body)
    }))
}

/// The marks with their bars.
fn marks(figure: &FigureData) -> String {
    loops(figure.marks.iter().map(|mark| {
        let colour = mark_colour(figure, mark.condition_index);
        let face = if mark.is_ring { "white" } else { &colour };
        let body = format!(
            "    x, y, low, high = points(column, f\"{{column}} low\", f\"{{column}} high\")\n    \
             axes.errorbar(x, y, [y - low, high - y], label={}, fmt=\"o\", color=\"{colour}\", mfc=\"{face}\", ms=4, lw=1, capsize=2)\n",
            literal(&mark.label)
        );
        (mark.column.clone(), body)
    }))
}

/// A loop over the columns that are drawn alike, each with its body.
fn loops(columns: impl Iterator<Item = (String, String)>) -> String {
    let mut loops: Vec<(String, Vec<String>)> = Vec::new();
    for (column, body) in columns {
        let column = text(&column);
        match loops.iter_mut().find(|(other, _)| *other == body) {
            Some((_, columns)) if columns.contains(&column) => {}
            Some((_, columns)) => columns.push(column),
            None => loops.push((body, vec![column])),
        }
    }
    loops.iter().map(|(body, columns)| format!("for column in [{}]:\n{body}", columns.join(", "))).collect()
}

/// Ticks that spell out lengths and shares.
fn formats(figure: &FigureData) -> String {
    let mut formats = String::new();
    if figure.x.kind() == AxisKind::Length {
        formats += "axes.xaxis.set_major_formatter(plt.matplotlib.ticker.EngFormatter(\"m\"))\n";
    }
    if figure.shows.draws_areas() {
        formats += "axes.yaxis.set_major_formatter(lambda share, _: f\"{100 * share:g} %\")\n";
    }
    formats
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
fn literal(content: &str) -> String {
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
            "# from a scan\n",
            "import csv, sys\n",
            "place / \"f.csv\" for place in",
            "csv.DictReader(",
            "    (\"10 \\\"MPa\\\"\", \"10 \\\"MPa\\\"\", \"\", \"#0072b2\", 1.000, None),\n",
            "axes.axvspan(2e-6, 4e-6, ",
            "(\"wavelength_m\", *columns)",
            "title=\"say \\\"\\\\$x\\\\$\\\" @TABLE@ \\\\\"",
        ] {
            assert!(csv.contains(line), "{line}: {csv}");
        }
        assert!(csv.lines().count() <= 40, "{csv}");
        assert!(drawn(Format::Json).contains("rows = list(json.load(table.open("));
        let linear = script(&figure().with_linear_axes(), &FigureStyle::default(), &[], Format::Csv);
        assert!(linear.contains("xscale=\"linear\", yscale=\"linear\""), "{linear}");
    }

    #[test]
    fn a_figure_of_85_mm_has_that_width() {
        let style = FigureStyle { width_mm: Some(85.0), ..FigureStyle::default() };
        assert!(script(&figure(), &style, &[], Format::Csv).contains("figsize=(3.3465, "));
    }
}
