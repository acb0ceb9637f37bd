//! Exact counters of work: nothing is computed that a scene does not need, and a change that does more work fails.

use findings::sensitivity::sensitivities_with_work;
use insta::assert_debug_snapshot;
use scene::{Overrides, Scene, Template};
use spectrum::{Convention, ProfilePsd, Psd};
use study::plan::{Plan, Work};
use study::{NoFiles, Unobserved};

fn scene(sections: &str) -> Scene {
    let text = format!("[surface]\npsd = \"builtin:uncd-measured\"\n{sections}");
    Scene::parse(&text, &NoFiles, &Overrides::default()).unwrap()
}

fn work(sections: &str) -> Work {
    scene(sections).plan().compute().unwrap().work
}

/// The material of most scenes here.
const DIAMOND: &str = "[material]\nyoungs_modulus = \"463 GPa\"\npoisson_ratio = 0.2\n\
                       yield_strength = \"1.8 GPa\"\nstrain_gradient_length = \"5 um\"\n";

/// A model of each kind.
const MODELS: [&str; 3] =
    ["model = \"elastic-plastic\"\nstrain_gradient = true", "model = \"ep-sphere\"", "model = \"hertz\""];

/// A curve of each model, so many times over under other names, with more keys.
fn curves(times: usize, keys: &str) -> String {
    let named = |at: usize| {
        let curve = move |(place, model)| format!("[[curve]]\nname = \"c{at}-{place}\"\n{keys}{model}\n");
        MODELS.into_iter().enumerate().map(curve)
    };
    (0..times).flat_map(named).collect()
}

fn loads(pressures: &[&str]) -> String {
    format!("[loads]\npressures = {pressures:?}\n")
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
        moment_cutoffs: 189,
        asperity_cutoffs: 75,
        amplitude_scales: 74,
        stacked_levels: 888,
        statistical_states: 1992,
        law_evaluations: 97078,
        fitted_samples: 0,
        shared_levels: 0,
        shared_states: 6,
    }
    ");
    assert_debug_snapshot!(shipped(Template::UncdMeasured), @r"
    Work {
        moment_cutoffs: 106,
        asperity_cutoffs: 47,
        amplitude_scales: 46,
        stacked_levels: 552,
        statistical_states: 1324,
        law_evaluations: 74623,
        fitted_samples: 0,
        shared_levels: 0,
        shared_states: 2,
    }
    ");
}

#[test]
fn the_template_of_a_new_scene_does_this_much_and_no_more() {
    let text = Template::New.text().replace("my_psd.csv", "builtin:uncd-measured");
    let scene = Scene::parse(&text, &NoFiles, &Overrides::default()).unwrap();
    assert_debug_snapshot!(scene.plan().compute().unwrap().work, @r"
    Work {
        moment_cutoffs: 45,
        asperity_cutoffs: 45,
        amplitude_scales: 46,
        stacked_levels: 184,
        statistical_states: 438,
        law_evaluations: 37917,
        fitted_samples: 0,
        shared_levels: 0,
        shared_states: 0,
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
        law_evaluations: 0,
        fitted_samples: 0,
        shared_levels: 0,
        shared_states: 0,
    }
    ");
}

/// Compares work without the counters of shared work.
fn computed(work: Work) -> Work {
    Work { shared_levels: 0, shared_states: 0, ..work }
}

#[test]
fn ten_times_the_same_loads_under_other_labels_cost_nothing() {
    let same = [
        "1 MPa", "1000 kPa", "1e6 Pa", "1e3 kPa", "10 bar", "1.0 MPa", "1 N/mm^2", "1e-3 GPa", "1e4 hPa",
        "1e-6 TPa",
    ];
    let of = |pressures: &[&str]| work(&[DIAMOND, &loads(pressures), &curves(1, "")].concat());
    let (plain, more) = (of(&same[..1]), of(&same));
    assert_eq!(computed(more), plain);
    assert_eq!((more.shared_levels, more.shared_states), (9 * 46, 9 * 2 * 45));
}

#[test]
fn ten_times_the_same_curves_under_other_names_cost_nothing() {
    let of = |times: usize| work(&[DIAMOND, &loads(&["1 MPa", "1e-2 H"]), &curves(times, "")].concat());
    let (plain, more) = (of(1), of(10));
    assert_eq!(computed(more), plain);
    assert_eq!((more.shared_levels, more.shared_states), (9 * 2 * 46, 9 * 2 * 2 * 45));
}

#[test]
fn ten_times_the_same_figures_cost_nothing() {
    let figures = |times: usize| -> String {
        let figure = |at| {
            format!(
                "[[figure]]\nname = \"over-loads-{at}\"\nshows = \"area-against-load\"\n\
                 curves = [\"c0-1\", \"c0-2\"]\ncutoff_multiples = [1, 10]\n\
                 loads = {{ from = \"1 MPa\", to = \"1 GPa\", points = 31 }}\n\
                 [[figure]]\nname = \"over-cutoffs-{at}\"\nshows = \"area\"\n"
            )
        };
        (0..times).map(figure).collect()
    };
    let of = |times: usize| work(&[DIAMOND, &loads(&["1 MPa"]), &curves(1, ""), &figures(times)].concat());
    let (plain, more) = (of(1), of(10));
    assert_eq!(computed(more), computed(plain));
    // Both curves have the sweeps' first load at the shortest wavelength already.
    assert_eq!((plain.statistical_states, plain.shared_states), (2 * 45 + 4 * 31 - 2, 2));
    assert_eq!(more.shared_states - plain.shared_states, 9 * 4 * 31);
}

/// A spectrum with ten times as many samples below a wavelength, on the power law between the ones it has.
fn denser_below(wavelength_m: f64, psd: &ProfilePsd) -> ProfilePsd {
    let samples: Vec<(f64, f64)> =
        psd.wavelengths_m().iter().copied().zip(psd.c1d_m3().iter().copied()).collect();
    let mut denser = vec![samples[0]];
    for pair in samples.windows(2) {
        let [(from_m, from), (to_m, to)] = [pair[0], pair[1]];
        let pieces = if from_m < wavelength_m { 10 } else { 1 };
        denser.extend((1..=pieces).map(|piece| {
            let share = f64::from(piece) / f64::from(pieces);
            if piece == pieces {
                (to_m, to)
            } else {
                (from_m * (to_m / from_m).powf(share), from * (to / from).powf(share))
            }
        }));
    }
    let (wavelengths_m, values) = denser.into_iter().unzip();
    Psd::new(wavelengths_m, values, Convention::C1D).unwrap().profile().unwrap()
}

#[test]
fn ten_times_the_scales_below_the_cutoff_cost_nothing() {
    let text = [
        DIAMOND,
        &loads(&["1 MPa", "1e-2 H"]),
        &curves(1, ""),
        "[cutoffs]\nshortest_wavelength = \"150 nm\"\n",
    ];
    let scene = scene(&text.concat());
    let denser = denser_below(100e-9, &scene.surface.psd);
    assert!(denser.len() > 3 * scene.surface.psd.len());
    let of = |psd| Plan { psd, ..scene.plan() }.compute().unwrap().work;
    let (plain, more) = (of(&scene.surface.psd), of(&denser));
    assert_eq!(more, plain);
    assert!(plain.stacked_levels > 0 && plain.statistical_states > 0);
}

#[test]
fn a_curve_at_the_shortest_cutoff_alone_is_one_state_and_no_scale_that_is_flattened() {
    let of = |keys: &str| work(&[DIAMOND, &loads(&["1 MPa", "1e-2 H"]), &curves(1, keys)].concat());
    assert_debug_snapshot!(of("cutoffs = \"shortest\"\n"), @r"
    Work {
        moment_cutoffs: 45,
        asperity_cutoffs: 1,
        amplitude_scales: 46,
        stacked_levels: 82,
        statistical_states: 4,
        law_evaluations: 77,
        fitted_samples: 0,
        shared_levels: 0,
        shared_states: 0,
    }
    ");
    // At its shortest cutoff a curve has what it has there when followed.
    let followed = of("");
    assert_eq!((followed.stacked_levels, followed.statistical_states), (2 * 46, 2 * 2 * 45));
}

#[test]
fn ten_times_the_scales_of_a_converged_end_cost_a_tenth_at_most() {
    // The steepest scale is at 5.65 nm: whatever has passed it flattens what comes below.
    let text = [DIAMOND, &loads(&["1 MPa", "0.5 H"]), &curves(1, "cutoffs = \"shortest\"\n")].concat();
    let scene = scene(&text);
    let psd = Scene::builtin(Template::UncdReconstructed).unwrap().surface.psd;
    let denser = denser_below(4e-9, &psd);
    assert!(denser.len() > 2 * psd.len());
    let of = |psd| Plan { psd, ..scene.plan() }.compute().unwrap().work;
    let (plain, more) = (of(&psd), of(&denser));
    assert_eq!((more.statistical_states, more.asperity_cutoffs), (4, 1));
    assert!(10 * more.law_evaluations <= 11 * plain.law_evaluations, "{more:?} in place of {plain:?}");
    assert!(10 * more.stacked_levels <= 11 * plain.stacked_levels, "{more:?} in place of {plain:?}");
}

#[test]
fn cutoffs_that_leave_the_asperities_as_they_were_share_their_state() {
    // A spectrum that falls off a cliff: what follows changes no moment by a digit.
    let wavelengths_m: Vec<f64> = (0..40).map(|at| 1e-4 * 0.8f64.powi(at)).collect();
    let value = |(at, wavelength_m): (usize, &f64)| if at < 10 { wavelength_m.powi(3) * 1e-6 } else { 1e-90 };
    let values = wavelengths_m.iter().enumerate().map(value).collect();
    let psd = Psd::new(wavelengths_m, values, Convention::C1D).unwrap().profile().unwrap();
    let scene = scene(&[DIAMOND, &loads(&["1 MPa"]), &curves(1, "")].concat());
    let work = Plan { psd: &psd, ..scene.plan() }.compute().unwrap().work;
    assert_eq!(work.statistical_states + work.shared_states, 2 * 39);
    assert_eq!(work.statistical_states, 2 * 10);
}

#[test]
fn sensitivities_compute_no_state_that_the_scene_or_another_of_them_has() {
    let elastic = "[[curve]]\nmodel = \"elastic-sine\"\n";
    let bem = "[[curve]]\nmodel = \"elastic-sine\"\ninterference_law = \"bem\"\nname = \"bem\"\n";
    let of = |curves: &str| {
        let scene = scene(&[DIAMOND, &loads(&["1 MPa"]), curves].concat());
        sensitivities_with_work(&scene, &scene.plan().compute().unwrap(), &Unobserved).unwrap().1
    };
    // The other normalisation, three densities, the other law: five states of one curve.
    assert_eq!(of(elastic).statistical_states, 5);
    // Of two curves that are each other's other law, the laws are known.
    assert_eq!(of(&[elastic, bem].concat()).statistical_states, 2 * 4);
    let ten: String = (0..10).map(|at| format!("{elastic}name = \"c{at}\"\n")).collect();
    assert_eq!(computed(of(&ten)), of(elastic));
}
