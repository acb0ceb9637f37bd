//! The judge on the Contact-Mechanics Challenge without adhesion, against one grid that holds the whole band.

use judge::Verdict;
use questions::{RunOptions, Unwatched, run_scene};
use scene::{Scene, Template};
use tests::pictures::contact_challenge::GRID;

#[test]
fn ranges_of_the_elements_hold_the_area_of_a_grid_of_the_whole_band() {
    let scene = Scene::builtin(Template::ContactChallenge).unwrap();
    let options = RunOptions { report: true, judge: None, uncertainty: None };
    let outcome = run_scene(&scene, options, &Unwatched).unwrap();
    let judgement = outcome.judgement.as_ref().unwrap();
    let corrected =
        scene.needs.curves.iter().position(|curve| curve.name == "persson-algebraic-nayak").unwrap();
    for (load, [pressure_pa, area, _]) in GRID.into_iter().enumerate() {
        assert_eq!(scene.needs.loads[load].nominal_pressure_pa(), pressure_pa);
        let elements = judgement.references.iter().find(|area| area.load == load).unwrap().elements.unwrap();
        assert!((elements.low()..=elements.high()).contains(&area), "{area}: {elements:?}");
        assert!((elements.area_fraction / area - 1.0).abs() < 0.06, "{area}: {elements:?}");
        assert!(elements.high() / elements.low() < 1.2, "{elements:?}");
        let verdict = judgement
            .curves
            .iter()
            .find(|verdict| verdict.curve == corrected && verdict.load == load)
            .map(|verdict| verdict.verdict);
        assert_eq!(verdict, Some(Verdict::Agrees));
    }
}
