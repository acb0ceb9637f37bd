//! The Contact-Mechanics Challenge without adhesion: one large grid, the judge in windows, and closed forms.

use questions::{RunOptions, Unwatched, run_scene};
use report::chart;
use scene::{Scene, Template};
use study::figure::{Axis, FigureData, Mark, Series, Shows};
use study::plan::{Load, NominalPressure};

use super::{PROVENANCE, Picture, dashed, geometric, line};

/// E* times the rms gradient \[Pa\].
const GRADIENT_PA: f64 = 25e6;

/// Nominal pressure \[Pa\], and the area fraction of `truearea bem` on 4096^2 points, four on the shortest wave, with the half
/// range of three surfaces relative to it (`docs/guide/contact-challenge.md`).
pub const GRID: [[f64; 3]; 5] = [
    [25e3, 0.002027, 0.020],
    [250e3, 0.01997, 0.008],
    [1e6, 0.07794, 0.003],
    [2.5e6, 0.18788, 0.001],
    [6e6, 0.41558, 0.001],
];

/// Curves that are drawn, with their names in the legend.
const CURVES: [(&str, &str); 4] = [
    ("persson-algebraic-nayak", "Persson, with Nayak's α"),
    ("persson", "Persson"),
    ("bgt", "Bush, Gibson & Thomas"),
    ("elastic", "stack, elastic"),
];

/// Area over load against load.
pub(super) fn area_over_load() -> Picture {
    let mut scene = Scene::builtin(Template::ContactChallenge).expect("the scene of the program");
    let options = RunOptions { report: true, judge: None, uncertainty: None };
    let outcome = run_scene(&scene, options, &Unwatched).expect("the scene runs");
    let judgement = outcome.judgement.as_ref().expect("the scene is judged");
    let over_load = |pressure_pa: f64, area: f64| area * GRADIENT_PA / pressure_pa;
    let mark = |label: &str, is_ring: bool, pressure_pa: f64, [low, area, high]: [f64; 3]| Mark {
        label: label.to_owned(),
        column: label.to_owned(),
        is_ring,
        condition_index: None,
        x: pressure_pa / GRADIENT_PA,
        y: over_load(pressure_pa, area),
        low: over_load(pressure_pa, low),
        high: over_load(pressure_pa, high),
    };
    let of_grid = GRID.iter().map(|&[pressure_pa, area, scatter]| {
        let ends = [area * (1.0 - scatter), area, area * (1.0 + scatter)];
        mark("grid of 4096²", false, pressure_pa, ends)
    });
    let of_judge = judgement.references.iter().filter_map(|found| {
        let elements = found.elements?;
        let pressure_pa = scene.needs.loads[found.load].nominal_pressure_pa();
        let ends = [elements.low(), elements.area_fraction, elements.high()];
        Some(mark("judge, windows of 128²", true, pressure_pa, ends))
    });
    // The grid is drawn over the rings.
    let marks: Vec<Mark> = of_judge.chain(of_grid).collect();

    let pressures_pa = geometric([5e3, 20e6], 25);
    let load = |pressure_pa: &f64| Load {
        nominal_pressure: NominalPressure::new(*pressure_pa).expect("a pressure within its bounds"),
        label: String::new(),
    };
    scene.needs.loads = pressures_pa.iter().map(load).collect();
    let results = scene.plan().compute().expect("the curves of the scene");
    let drawn = |(colour, (name, label)): (usize, &(&str, &str))| -> Series {
        let at =
            scene.needs.curves.iter().position(|curve| curve.name == *name).expect("a curve of the scene");
        let area =
            |load: usize| results.curves[at].area_fractions(load).last().map_or(0.0, |(_, area)| *area);
        let point = |(load, &pressure_pa): (usize, &f64)| {
            (pressure_pa / GRADIENT_PA, over_load(pressure_pa, area(load)))
        };
        let points = pressures_pa.iter().enumerate().map(point).collect();
        dashed("", 0, line(label, colour, points))
    };
    let x = Axis { column: "x", label: "nominal pressure p/(E* h')" };
    let series = CURVES.iter().enumerate().map(drawn).collect();
    let figure = FigureData {
        title: "Contact-Mechanics Challenge without adhesion".to_owned(),
        marks,
        ..FigureData::new("contact-challenge", Shows::Response, x, "area over load, A/(p/E* h')", series)
    };
    let subject = "area over load: one large grid, the judge, closed forms";
    Picture { name: "contact-challenge", svg: chart::svg(&figure, subject, &[PROVENANCE.to_owned()]) }
}
