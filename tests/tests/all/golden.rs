//! Golden curves of every figure. `cargo xtask golden` shows how far each has moved, `--accept` rewrites them.

use insta::{Settings, assert_snapshot};
use tests::golden::{Numbers, TOLERANCE, curves, deviations, readme_picture_is_current, summary};
use tests::write_differences;

fn settings() -> Settings {
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path("../../golden");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings
}

#[test]
fn every_curve_is_as_accepted() {
    let curves = curves();
    if let Some(page) = write_differences(&curves) {
        println!("old and new are drawn over each other in {}", page.display());
    }
    let mut settings = settings();
    settings.set_comparator(Box::new(Numbers));
    settings.bind(|| {
        for curve in &curves {
            assert_snapshot!(curve.name.clone(), curve.text());
        }
    });
}

#[test]
fn the_summary_is_as_accepted() {
    settings().bind(|| assert_snapshot!("summary", summary(&curves())));
}

#[test]
fn every_snapshot_belongs_to_a_curve() {
    let mut expected: Vec<_> = curves().iter().map(|curve| curve.path()).collect();
    let folder = expected[0].parent().expect("a folder").to_owned();
    expected.push(folder.join("summary.snap"));
    for file in std::fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        assert!(expected.contains(&path), "{} is nobody's", path.display());
    }
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
    for curve in curves() {
        let bytes = std::fs::metadata(curve.path()).unwrap().len();
        assert!(bytes < 20 * 1024, "{} has {bytes} bytes", curve.path().display());
    }
}

#[test]
fn the_readme_shows_the_figure_as_drawn_now() {
    assert!(readme_picture_is_current(), "docs/contact-area.svg differs; run cargo xtask golden --accept");
}
