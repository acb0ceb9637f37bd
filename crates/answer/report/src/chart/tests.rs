use super::*;
use study::figure::{Axis, AxisScale, CurveLook, Series, Shows, Variant};

fn figure(name: &str) -> FigureData {
    let series = Series {
        condition_in_full: "10 MPa = 10⁻³ H".to_owned(),
        ..Series::under("1e-3 H", 0, vec![(1.0, 1e-30), (10.0, 1e-20)])
    };
    let x = Axis { column: "x", label: "x" };
    FigureData { title: String::new(), ..FigureData::new(name, Shows::Psd, x, "y", vec![series]) }
}

fn count(svg: &str, what: &str) -> usize {
    svg.matches(what).count()
}

fn units_wide(svg: &str) -> f64 {
    svg.split_once("viewBox=\"0 0 ").unwrap().1.split(' ').next().unwrap().parse().unwrap()
}

#[test]
fn a_load_is_labelled_at_its_line_and_spelt_out_in_the_legend() {
    let svg = svg(&figure("a"), "", &[]);
    assert!(svg.contains(">10⁻³ H</text>") && svg.contains(">10 MPa = 10⁻³ H</text>"), "{svg}");
}

#[test]
fn what_was_not_measured_is_shaded_and_no_line_crosses_it() {
    let mut figure = figure("a");
    figure.series[0].points = vec![(1.0, 1.0), (2.0, 2.0), (20.0, 3.0), (40.0, 4.0)];
    let whole = svg(&figure, "", &[]);
    figure.gaps = vec![(2.0, 20.0)];
    let broken = svg(&figure, "", &[]);
    let lines = |svg: &str| count(svg, "stroke-width=\"1.5\"");
    assert_eq!(lines(&broken), lines(&whole) + 1, "{broken}");
    assert!(broken.contains("class=\"hole\"") && !whole.contains("class=\"hole\""), "{broken}");
}

#[test]
fn a_band_is_drawn_inside_the_frame_and_named_once() {
    let mut figure = figure("a");
    let whole = svg(&figure, "", &[]);
    let band = |load, share: f64| FigureBand {
        label: "linear laws".to_owned(),
        kind: BandKind::Yardstick,
        load: Some(load),
        curve_index: 0,
        points: [1.0, 3.0, 10.0].map(|x| (x, [1e-26 * share, 3e-26 * share])).to_vec(),
    };
    // The last lies beside the decades that are drawn.
    figure.bands = vec![band(0, 1.0), band(1, 100.0), band(2, 1e30)];
    let banded = svg(&figure, "", &[]);
    // Two bands, and the sample of the legend.
    assert_eq!(count(&banded, "opacity=\"0.18\"") - count(&whole, "opacity=\"0.18\""), 3, "{banded}");
    assert_eq!(count(&banded, ">linear laws</text>"), 1);
    figure.gaps = vec![(1.0, 3.0)];
    assert_eq!(count(&svg(&figure, "", &[]), "opacity=\"0.18\""), 5, "each band in two pieces");
}

#[test]
fn an_interval_is_named_once_and_belongs_on_the_axes() {
    let mut figure = figure("a");
    let held_against = Series { curve_index: 1, ..figure.series[0].clone() };
    figure.series.push(held_against);
    figure.bands = vec![FigureBand {
        label: "95 % coverage interval".to_owned(),
        kind: BandKind::Interval,
        load: None,
        curve_index: 0,
        points: vec![(1.0, [1e-33, 1e-29]), (10.0, [1e-21, 1e-19])],
    }];
    let banded = svg(&figure, "", &[]);
    assert_eq!(count(&banded, "class=\"band\""), 1, "{banded}");
    assert_eq!(count(&banded, ">95 % coverage interval</text>"), 1);
    assert!(banded.contains(">10⁻³⁴</text>"), "{banded}");
}

#[test]
fn a_model_has_its_colour_and_dash_in_any_figure_and_its_ticks_have_units() {
    let look = |model| Some(CurveLook { model, variant: Variant::Plain, repeat: 0 });
    let line = |model: &'static str, curve_index| Series {
        curve: model.to_owned(),
        curve_index,
        look: look(model),
        ..Series::under("1 MPa", 0, vec![(1e-9, 1e-5), (1e-6, 1e-2)])
    };
    let with = |series: Vec<Series>| {
        let x = Axis { column: "wavelength_m", label: "wavelength (m)" };
        let x_label = x.label.to_owned();
        svg(&FigureData { shows: Shows::Area, series, x, x_label, ..figure("a") }, "", &[])
    };
    let style = palette::ModelStyle::new(look("persson").unwrap());
    for drawn in [with(vec![line("persson", 0)]), with(vec![line("hertz", 0), line("persson", 1)])] {
        assert!(drawn.contains(style.colour) && drawn.contains(&style.dash), "{drawn}");
        for label in [">1 nm</text>", ">1 µm</text>", ">10 ppm</text>", ">1 %</text>", ">wavelength</text>"]
        {
            assert!(drawn.contains(label), "{label}: {drawn}");
        }
    }
}

#[test]
fn lines_of_models_have_a_label_for_each_load_and_lines_of_one_load_the_names_of_their_models() {
    let look = Some(CurveLook { model: "persson", variant: Variant::Plain, repeat: 0 });
    let line = |condition: &str, index, y: f64| Series {
        curve: "persson".to_owned(),
        look,
        ..Series::under(condition, index, vec![(1e-9, y), (1e-6, 10.0 * y)])
    };
    let drawn = |series: Vec<Series>| svg(&FigureData { series, ..figure("a") }, "", &[]);
    let other = |condition, index, y| Series { curve: "hertz".to_owned(), ..line(condition, index, y) };
    let two_loads = drawn(vec![
        line("1 MPa", 0, 1e-6),
        other("1 MPa", 0, 2e-6),
        line("2 MPa", 1, 1e-4),
        other("2 MPa", 1, 2e-4),
    ]);
    let labels = |drawn: &str| {
        ["1 MPa", "2 MPa", "persson", "hertz"].map(|label| count(drawn, &format!(">{label}</text>")))
    };
    assert_eq!(labels(&two_loads), [1; 4], "{two_loads}");
    let two_models = drawn(vec![line("1 MPa", 0, 1e-6), other("1 MPa", 0, 1e-4)]);
    assert_eq!(labels(&two_models), [1, 0, 1, 1], "{two_models}");
    // The legend of the first has samples of the lines; the labels of the second stand at theirs.
    assert_eq!(count(&two_loads, "class=\"line\""), 4 + 2, "{two_loads}");
    assert_eq!(count(&two_models, "class=\"line\""), 2, "{two_models}");
}

#[test]
fn a_legend_is_no_larger_than_its_plot() {
    let line = |at: usize| Series::under(&format!("scan {at}"), at, vec![(1.0, 1e-30), (10.0, 1e-20)]);
    let many = FigureData { series: (0..300).map(line).collect(), ..figure("a") };
    let drawn = svg(&many, "", &[]);
    let height: f64 = drawn.split_once(" height=\"").unwrap().1.split('"').next().unwrap().parse().unwrap();
    assert!(height < 2.0 * HEIGHT_PX && drawn.contains(" more</text>"), "{height}");
}

#[test]
fn labels_end_inside_the_picture_and_long_ones_take_two_lines() {
    let x = Axis { column: "wavelength_m", label: "wavelength (m)" };
    let series = vec![Series::under("1 MPa", 0, vec![(1e-6, 1e-5), (1e-4, 1e-2)])];
    let figure = FigureData {
        series,
        x,
        y_label: "the share of the area that touches of the whole nominal area",
        ..figure("a")
    };
    let drawn = svg(&figure, "", &[]);
    let label = drawn.split("<text ").find(|text| text.contains(">100 µm</text>")).unwrap();
    let place: f64 = label.split_once("x=\"").unwrap().1.split('"').next().unwrap().parse().unwrap();
    assert!(place + 0.5 * canvas::text_width_px("100 µm", LETTERS_PX) <= units_wide(&drawn), "{label}");
    assert!(
        drawn.contains(">the share of the area") && !drawn.contains("nominal area</text></g>\n<g"),
        "{drawn}"
    );
    assert!(!drawn.contains(figure.y_label), "{drawn}");
}

#[test]
fn a_width_in_print_keeps_the_size_of_letters() {
    let titled = FigureData { title: "title".to_owned(), ..figure("a") };
    let drawn = |width_mm, font_size_pt, hides_title| {
        styled_svg(&titled, &FigureStyle { width_mm, font_size_pt, hides_title }, "", &[])
    };
    let [narrow, wide] = [85.0, 170.0].map(|width_mm| drawn(Some(width_mm), Some(8.0), true));
    assert!(narrow.contains(" width=\"85.00mm\"") && !narrow.contains(">title</text>"), "{narrow}");
    // 12 units of the drawing are 8 points, a point is 1/72 inch.
    assert!((units_wide(&narrow) - 85.0 * 72.0 / 25.4 * 1.5).abs() < 0.01, "{narrow}");
    assert!((units_wide(&wide) - 2.0 * units_wide(&narrow)).abs() < 0.02, "{wide}");
    assert!((units_wide(&drawn(Some(85.0), Some(16.0), true)) - 0.5 * units_wide(&narrow)).abs() < 0.01);
    assert_eq!(drawn(None, None, false), svg(&titled, "", &[]));
}

#[test]
fn linear_axes_have_negative_values_prefixes_and_lines_at_zero() {
    let x = Axis { column: "shear_m", label: "shear (m)" };
    let line = |name, index, sign: f64| {
        Series::under(name, index, vec![(-3e-9, -sign * 2e6), (0.0, sign * 1e6), (3e-9, 2e6)])
    };
    let lines = vec![line("back", 0, -1.0), line("forth", 1, 1.0)];
    let figure = FigureData::new("a", Shows::Response, x, "stress (Pa)", lines).with_linear_axes();
    let drawn = svg(&figure, "", &[]);
    for label in [">shear (nm)</text>", ">stress (MPa)</text>", ">\u{2212}2</text>", ">0</text>"] {
        assert!(drawn.contains(label), "{label}: {drawn}");
    }
    // A line at zero of each axis.
    assert_eq!(count(&drawn, palette::ZERO), 2, "{drawn}");
    let (x_scale, y_scale) = (AxisScale::Logarithmic, AxisScale::Logarithmic);
    assert_eq!(count(&svg(&FigureData { x_scale, y_scale, ..figure }, "", &[]), palette::ZERO), 0);
}

#[test]
fn every_bar_has_its_number() {
    let drawn =
        bars(&[([1e-5, 1e-6], 10.0), ([1e-6, 1e-7], 91.4), ([1e-7, 1e-8], 0.0)], "share (%)", "").unwrap();
    for label in [">10 %<", ">91 %<", ">0 %<"] {
        assert_eq!(count(&drawn, label), 1, "{label}: {drawn}");
    }
    assert!(bars(&[], "", "").is_none());
}
