//! Golden curves of every figure. `cargo xtask golden` shows how far each has moved, `--accept` rewrites them.

use insta::{Settings, assert_snapshot};
use tests::golden::{Numbers, TOLERANCE, deviations, figures, readme_picture_is_current};

#[test]
fn every_figure_is_as_accepted() {
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path("../golden");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_comparator(Box::new(Numbers));
    settings.bind(|| {
        for figure in figures() {
            assert_snapshot!(figure.name.clone(), figure.text());
        }
    });
}

#[test]
fn a_change_of_1e_10_passes_and_one_of_1e_6_does_not() {
    let snapshot = |value: f64| format!("x,y\n1.00000000000e0,{value:.11e}");
    let moved = |by: f64| deviations(&snapshot(0.3), &snapshot(0.3 * (1.0 + by))).unwrap()[1].1;
    assert!(moved(1e-10) <= TOLERANCE);
    assert!(moved(1e-6) > TOLERANCE);
}

#[test]
fn golden_files_stay_readable_in_a_review() {
    for figure in figures() {
        let bytes = std::fs::metadata(figure.path()).unwrap().len();
        assert!(bytes < 20 * 1024, "{} has {bytes} bytes", figure.path().display());
    }
}

#[test]
fn the_readme_shows_the_figure_as_drawn_now() {
    assert!(readme_picture_is_current(), "docs/contact-area.svg differs; run cargo xtask golden --accept");
}
