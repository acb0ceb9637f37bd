//! What a scene does not need is not computed: exact counters, so that a change that does more work fails review.

use std::path::Path;

use cli::plan::Work;
use cli::scene::{Overrides, Scene, Template};

const NOTHING: Work = Work {
    moment_cutoffs: 0,
    asperity_cutoffs: 0,
    amplitude_scales: 0,
    stacked_levels: 0,
    statistical_states: 0,
    fitted_samples: 0,
};

fn work(sections: &str) -> Work {
    let text = format!("[surface]\npsd = \"builtin:uncd-measured\"\n{sections}");
    let scene = Scene::parse(&text, "counted", Path::new("."), &Overrides::default()).unwrap();
    scene.plan().compute().unwrap().work
}

#[test]
fn a_figure_of_the_spectrum_computes_nothing_of_it() {
    assert_eq!(work("[[figure]]\nname = \"f\"\nshows = \"psd\""), NOTHING);
}

#[test]
fn a_figure_of_moments_computes_moments_alone() {
    assert_eq!(work("[[figure]]\nname = \"f\"\nshows = \"moments\""), Work { moment_cutoffs: 45, ..NOTHING });
}

#[test]
fn a_figure_of_aspect_ratios_computes_amplitudes_alone() {
    assert_eq!(
        work("[[figure]]\nname = \"f\"\nshows = \"aspect-ratio\""),
        Work { amplitude_scales: 46, ..NOTHING }
    );
}

#[test]
fn a_stacked_curve_computes_no_moments_and_no_scale_below_the_cutoff() {
    let curve = "[material]\nyoungs_modulus = \"1 GPa\"\npoisson_ratio = 0.4\n\
                 [loads]\npressures = [\"1 kPa\", \"1 MPa\"]\n[[curve]]\nmodel = \"elastic\"\n";
    assert_eq!(work(curve), Work { amplitude_scales: 46, stacked_levels: 2 * 46, ..NOTHING });
    let cut = format!("{curve}[cutoffs]\nshortest_wavelength = \"1 um\"");
    assert_eq!(work(&cut), Work { amplitude_scales: 21, stacked_levels: 2 * 21, ..NOTHING });
}

#[test]
fn the_paper_s_figures_take_three_stacked_and_six_statistical_curves_at_four_loads() {
    let scene = Scene::builtin(Template::UncdReconstructed).unwrap();
    let work = scene.plan().compute().unwrap().work;
    // The sweeps over loads of figure 5: two curves, three cutoffs, 41 loads.
    let statistical_states = 6 * 4 * 73 + 2 * 3 * 41;
    assert_eq!(
        work,
        Work {
            moment_cutoffs: 73,
            asperity_cutoffs: 73,
            amplitude_scales: 74,
            stacked_levels: 3 * 4 * 74,
            statistical_states,
            fitted_samples: 0,
        }
    );
}

#[test]
fn a_statistical_curve_computes_no_amplitudes() {
    let curve = "[material]\nyoungs_modulus = \"1 GPa\"\npoisson_ratio = 0.4\n\
                 [loads]\npressures = [\"1 kPa\"]\n[[curve]]\nmodel = \"hertz\"\n";
    let expected = Work { moment_cutoffs: 45, asperity_cutoffs: 45, statistical_states: 45, ..NOTHING };
    assert_eq!(work(curve), expected);
}
