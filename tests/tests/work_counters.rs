//! What a scene does not need is not computed: exact counters, so that a change that does more work fails review.

use std::path::Path;

use cli::plan::Work;
use cli::scene::{Overrides, Scene, Template};
use insta::assert_debug_snapshot;

fn work(sections: &str) -> Work {
    let text = format!("[surface]\npsd = \"builtin:uncd-measured\"\n{sections}");
    let scene = Scene::parse(&text, "counted", Path::new("."), &Overrides::default()).unwrap();
    scene.plan().compute().unwrap().work
}

fn shipped(template: Template) -> Work {
    Scene::builtin(template).unwrap().plan().compute().unwrap().work
}

#[test]
fn a_figure_of_the_spectrum_computes_nothing_of_it() {
    assert_eq!(work("[[figure]]\nname = \"f\"\nshows = \"psd\""), Work::default());
}

#[test]
fn a_figure_of_moments_computes_moments_alone() {
    let expected = Work { moment_cutoffs: 45, ..Work::default() };
    assert_eq!(work("[[figure]]\nname = \"f\"\nshows = \"moments\""), expected);
}

#[test]
fn a_figure_of_aspect_ratios_computes_amplitudes_alone() {
    let expected = Work { amplitude_scales: 46, ..Work::default() };
    assert_eq!(work("[[figure]]\nname = \"f\"\nshows = \"aspect-ratio\""), expected);
}

#[test]
fn a_stacked_curve_computes_no_moments_and_no_scale_below_the_cutoff() {
    let curve = "[material]\nyoungs_modulus = \"1 GPa\"\npoisson_ratio = 0.4\n\
                 [loads]\npressures = [\"1 kPa\", \"1 MPa\"]\n[[curve]]\nmodel = \"elastic\"\n";
    let expected = Work { amplitude_scales: 46, stacked_levels: 2 * 46, ..Work::default() };
    assert_eq!(work(curve), expected);
    let cut = format!("{curve}[cutoffs]\nshortest_wavelength = \"1 um\"");
    let expected = Work { amplitude_scales: 21, stacked_levels: 2 * 21, ..Work::default() };
    assert_eq!(work(&cut), expected);
}

/// Three stacked and six statistical curves at four loads, and the sweeps over loads of figure 5: two curves, three
/// cutoffs, 41 loads.
#[test]
fn the_shipped_scenes_do_this_much_and_no_more() {
    assert_debug_snapshot!(shipped(Template::UncdReconstructed), @r"
    Work {
        moment_cutoffs: 73,
        asperity_cutoffs: 73,
        amplitude_scales: 74,
        stacked_levels: 888,
        statistical_states: 1998,
        law_evaluations: 124465,
        fitted_samples: 0,
    }
    ");
    assert_debug_snapshot!(shipped(Template::UncdMeasured), @r"
    Work {
        moment_cutoffs: 45,
        asperity_cutoffs: 45,
        amplitude_scales: 46,
        stacked_levels: 552,
        statistical_states: 1326,
        law_evaluations: 89831,
        fitted_samples: 0,
    }
    ");
}

#[test]
fn the_template_of_a_new_scene_does_this_much_and_no_more() {
    let text = Template::New.text().replace("my_psd.csv", "builtin:uncd-measured");
    let scene = Scene::parse(&text, "new", Path::new("."), &Overrides::default()).unwrap();
    assert_debug_snapshot!(scene.plan().compute().unwrap().work, @r"
    Work {
        moment_cutoffs: 0,
        asperity_cutoffs: 0,
        amplitude_scales: 46,
        stacked_levels: 184,
        statistical_states: 0,
        law_evaluations: 0,
        fitted_samples: 0,
    }
    ");
}

#[test]
fn a_statistical_curve_computes_no_amplitudes() {
    let curve = "[material]\nyoungs_modulus = \"1 GPa\"\npoisson_ratio = 0.4\n\
                 [loads]\npressures = [\"1 kPa\"]\n[[curve]]\nmodel = \"hertz\"\n";
    assert_debug_snapshot!(work(curve), @r"
    Work {
        moment_cutoffs: 45,
        asperity_cutoffs: 45,
        amplitude_scales: 0,
        stacked_levels: 0,
        statistical_states: 45,
        law_evaluations: 837,
        fitted_samples: 0,
    }
    ");
}
