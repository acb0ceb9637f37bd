//! Work of the main kernels and of the whole paper, one piece at a time, for counting instructions: `cargo xtask
//! instructions` runs this under valgrind and compares the counts with the accepted ones.
//!
//! Without an argument it prints the names of the pieces. With one it does that piece twice: first to initialise what
//! is built at its first use, then inside [`counted`], where valgrind counts.

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::hint::black_box;
use std::process::ExitCode;

use asperity::{
    ElasticBody, ElasticPlasticSinusoid, ElasticSinusoid, Hardness, JacksonGreen, MaterialPair, NixGao,
};
use elements::half_space::{Elements, Grid, Loading};
use judge::JudgePlan;
use measurements::{CompositeOfFiles, RoughnessOfFiles, RoughnessSettings, ScanRequest, read_channels};
use numerics::parallel::Unobserved;
use scans::{HeightMap, ScanOptions};
use scene::{Overrides, Scene, Template};
use spectrum::{
    AmplitudeDefinition, AsperityParameters, Normalisation, amplitudes, cumulative_moments, fit_self_affine,
};
use stacked_contact::{Scale, StackedModel, levels};
use stat_contact::{AsperityLaw, InterferenceLaw, Population, StatisticalContact};
use study::NoFiles;
use topography::{Preparation, Recipe, areal_spectrum, map_line_spectrum};
use uncertainty::UncertaintyPlan;

/// Work that is counted.
type Work = Box<dyn Fn()>;

/// Name and preparation of a piece of work.
type Piece = (&'static str, fn() -> Work);

const PIECES: [Piece; 31] = [
    ("sphere", || sphere(Hardness::JacksonGreen2005)),
    ("sphere-cosine-hardness", || sphere(Hardness::Cosine)),
    ("sinusoid-elastic", sinusoid_elastic),
    ("sinusoid-elastic-plastic", sinusoid_elastic_plastic),
    ("stack-elastic", || stack(StackedModel::Elastic { pair: pair() })),
    ("stack-elastic-plastic", || {
        stack(StackedModel::ElasticPlastic { pair: pair(), strength: strength(), area: Default::default() })
    }),
    ("stack-strain-gradient", || {
        stack(StackedModel::ElasticPlastic {
            pair: pair(),
            strength: growing_strength(),
            area: Default::default(),
        })
    }),
    ("pair-hertz", pair_hertz),
    ("states-hertz", || states(AsperityLaw::Hertz)),
    ("states-ep-sphere", || {
        states(AsperityLaw::EpSphere { strength: strength(), hardness: Hardness::default(), held_from: None })
    }),
    ("states-ep-sphere-strain-gradient", || {
        states(AsperityLaw::EpSphere {
            strength: growing_strength(),
            hardness: Hardness::default(),
            held_from: None,
        })
    }),
    ("states-elastic-sine", || {
        states(AsperityLaw::ElasticSine { interference: InterferenceLaw::RostamiJackson })
    }),
    ("states-elastic-sine-bem", || states(AsperityLaw::ElasticSine { interference: InterferenceLaw::Bem })),
    ("states-ep-sine", || states(AsperityLaw::EpSine { strength: strength() })),
    ("states-ep-sine-strain-gradient", || states(AsperityLaw::EpSine { strength: growing_strength() })),
    ("persson-growing-hardness", persson_growing_hardness),
    ("moments-and-amplitudes", moments_and_amplitudes),
    ("self-affine-fit", self_affine_fit),
    ("map-line-by-line", || map(|map| drop(black_box(map_line_spectrum(map, Preparation::default()))))),
    ("map-areal", || map(|map| drop(black_box(areal_spectrum(map, Preparation::default()))))),
    ("half-space-elastic", || half_space(None)),
    ("half-space-saturated", || half_space(Some(4e8))),
    ("paper", paper),
    ("judge", || judge(1)),
    ("judge-tenfold", || judge(10)),
    ("draws", || draws(1)),
    ("draws-tenfold", || draws(10)),
    ("reader", || reader(1)),
    ("reader-tenfold", || reader(10)),
    ("files", || files(10, 20)),
    ("files-tenfold", || files(1, 200)),
];

fn main() -> ExitCode {
    let Some(wanted) = std::env::args().nth(1) else {
        PIECES.iter().for_each(|(name, _)| println!("{name}"));
        return ExitCode::SUCCESS;
    };
    let Some((_, prepare)) = PIECES.iter().find(|(name, _)| *name == wanted) else {
        eprintln!("error: {wanted} is not a piece of work; without an argument all of them are named");
        return ExitCode::from(2);
    };
    // All on this thread, because valgrind counts per thread.
    let one_thread = rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread().build();
    one_thread.expect("a pool of the thread there is").install(|| {
        let work = prepare();
        work();
        counted(&work);
    });
    ExitCode::SUCCESS
}

/// Function in which valgrind counts, by name.
#[inline(never)]
fn counted(work: &dyn Fn()) {
    work();
}

/// Diamond against a rigid flat.
fn pair() -> MaterialPair {
    MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2).expect("diamond"))
}

fn strength() -> NixGao {
    NixGao::constant(1.8e9).expect("diamond")
}

fn growing_strength() -> NixGao {
    strength().with_strain_gradient(5e-6).expect("diamond")
}

/// Returns `count` numbers, evenly over the decades from `first` on.
fn over_decades(count: usize, first: f64, decades: f64) -> impl Iterator<Item = f64> + Clone {
    (0..count).map(move |i| first * 10f64.powf(decades * i as f64 / (count - 1) as f64))
}

/// Force and area at a thousand interferences, from within Hertz's range to the cap of the area.
fn sphere(hardness: Hardness) -> Work {
    let law = JacksonGreen::new(&pair(), 1e-6, 1.8e9, hardness);
    let interferences_m: Vec<f64> = over_decades(1000, 1e-12, 6.5).collect();
    Box::new(move || {
        for &interference_m in &interferences_m {
            black_box(law.force_and_area(interference_m));
        }
    })
}

/// Areas under a thousand pressures, from light to complete contact.
fn sinusoid_elastic() -> Work {
    let law = ElasticSinusoid::new(&pair(), 0.03);
    let pressures_pa: Vec<f64> = over_decades(1000, 1e3, 8.0).collect();
    Box::new(move || {
        for &pressure_pa in &pressures_pa {
            black_box(law.area_fraction(pressure_pa));
        }
    })
}

fn sinusoid_elastic_plastic() -> Work {
    let law = ElasticPlasticSinusoid::new(&pair(), 0.03, 1.8e9);
    let pressures_pa: Vec<f64> = over_decades(1000, 1e3, 8.0).collect();
    Box::new(move || {
        for &pressure_pa in &pressures_pa {
            black_box((law.area_fraction(pressure_pa), law.deformation_over_amplitude(pressure_pa)));
        }
    })
}

/// A thousand scales under five loads; the aspect ratio peaks at 10 nm.
fn stack(model: StackedModel) -> Work {
    let scale = |wavelength_m: f64| {
        let decades_off_peak = (wavelength_m / 1e-8).log10();
        let aspect_ratio = 0.04 * (-0.3 * decades_off_peak * decades_off_peak).exp();
        Scale { wavelength_m, amplitude_m: wavelength_m * aspect_ratio }
    };
    let scales: Vec<Scale> = over_decades(1000, 1e-2, -7.3).map(scale).collect();
    Box::new(move || {
        for load_pa in [5.4e5, 5.4e6, 5.4e7, 5.4e8, 5.4e9] {
            black_box(levels(&model, load_pa, scales.iter().copied()).last());
        }
    })
}

/// Asperities of diamond down to a nanometre, and to a micrometre.
fn populations() -> [Population; 2] {
    [(45.6e-9, 26e12, 6.66e-9), (37e-6, 1.07e9, 42.9e-9)].map(|(radius_m, density_per_m2, sigma_s_m)| {
        Population::new(radius_m, density_per_m2, sigma_s_m).expect("asperities of diamond")
    })
}

/// Area and pressure of Hertz's spheres at given separations, to twelve digits.
fn pair_hertz() -> Work {
    Box::new(|| {
        for population in populations() {
            let contact = StatisticalContact::new(&pair(), &population, &AsperityLaw::Hertz);
            for u in [-3.0, 0.0, 3.0, 6.0, 20.0] {
                let separation_m = u * population.sigma_s_m();
                black_box(contact.at_separation(separation_m, 1e-12).expect("a finite separation"));
            }
        }
    })
}

/// Unrelated states at given loads, to ten digits.
fn states(law: AsperityLaw) -> Work {
    Box::new(move || {
        for population in populations() {
            for load_pa in [5.4e3, 5.4e5, 5.4e7] {
                let contact = StatisticalContact::new(&pair(), &population, &law);
                black_box(contact.at_pressure(load_pa, 1e-10, None).expect("a positive load"));
            }
        }
    })
}

/// Areas by Persson's theory on a surface of 55 wavelengths, whose hardness grows with the wavevector, under one load.
fn persson_growing_hardness() -> Work {
    let scene = Scene::parse(
        "[surface]\npsd = \"builtin:contact-challenge\"\n\
         [material]\nyoungs_modulus = \"463 GPa\"\npoisson_ratio = 0.2\nyield_strength = \"1.8 GPa\"\n\
         [loads]\npressures = [\"54 MPa\"]\n\
         [[curve]]\nmodel = \"persson-plastic\"\nhardness_law = \"power:0.1\"\n",
        &NoFiles,
        &Overrides::default(),
    )
    .expect("a sound scene");
    Box::new(move || drop(black_box(scene.plan().compute().expect("a sound scene"))))
}

fn diamond() -> Scene {
    Scene::builtin(Template::UncdReconstructed).expect("a scene that comes with the program")
}

fn moments_and_amplitudes() -> Work {
    let psd = diamond().surface.psd;
    Box::new(move || {
        let moments = cumulative_moments(&psd, Normalisation::default());
        black_box(moments.last().and_then(AsperityParameters::from_moments));
        black_box(amplitudes(&psd, AmplitudeDefinition::default()));
    })
}

fn self_affine_fit() -> Work {
    let psd = diamond().surface.psd;
    Box::new(move || {
        black_box(fit_self_affine(&psd, 0.0..=f64::INFINITY).expect("enough samples"));
    })
}

/// Rows and columns of the maps.
const SIZE: usize = 128;

/// Heights of two waves across each other.
fn crossing_waves_m() -> Vec<f64> {
    let height_m = |i: usize| {
        let (x, y) = ((i % SIZE) as f64, (i / SIZE) as f64);
        1e-9 * ((0.3 * x + 0.2 * y).sin() + (1.7 * x - 2.1 * y).cos())
    };
    (0..SIZE * SIZE).map(height_m).collect()
}

/// The two waves, repeated with their cliffs at the edges, pressed onto a half-space at a load that closes a fifth of
/// it.
fn half_space(saturation_pa: Option<f64>) -> Work {
    let side_m = SIZE as f64 * 1e-9;
    let grid = Grid::new(SIZE, SIZE, side_m, side_m).expect("a grid");
    let heights_m = crossing_waves_m();
    let loading =
        Loading { contact_modulus_pa: 1e9, nominal_pressure_pa: 1e8, saturation_pa, tolerance: 1e-8 };
    Box::new(move || {
        let mut elements = Elements::periodic(grid, &heights_m).expect("finite heights");
        black_box(elements.press(&loading, &Unobserved).expect("a load that can be carried"));
    })
}

/// Map of 128 rows of 128 heights.
fn map(transform: fn(&HeightMap)) -> Work {
    let heights_m = crossing_waves_m();
    let map = HeightMap::new(SIZE, 1e-9, 1e-9, heights_m).expect("a map without gaps");
    Box::new(move || transform(&map))
}

/// Everything that the figures of the reconstructed spectrum show, at the tolerance of ten digits.
fn paper() -> Work {
    let mut scene = diamond();
    scene.needs.tolerance = study::plan::Tolerance::new(1e-10).expect("a tolerance");
    Box::new(move || drop(black_box(scene.plan().compute().expect("a sound scene"))))
}

/// A scene of one body under one load, said so many times: every repeat has another name and needs nothing new.
fn repeated(times: usize, surface: &str) -> Scene {
    let curves: String =
        (0..times).map(|at| format!("[[curve]]\nmodel = \"persson\"\nname = \"c{at}\"\n")).collect();
    let figures: String = (0..times)
        .map(|at| format!("[[figure]]\nname = \"f{at}\"\nshows = \"area\"\ncurves = [\"c0\"]\n"))
        .collect();
    // "1 MPa", "10e-1 MPa", "100e-2 MPa": one load.
    let loads: Vec<String> = (0..times).map(|at| format!("\"1{}e-{at} MPa\"", "0".repeat(at))).collect();
    let text = format!(
        "[surface]\n{surface}\n\
         [material]\nyoungs_modulus = \"463 GPa +- 20 GPa\"\npoisson_ratio = 0.2\n\
         [loads]\npressures = [{}]\n[judge]\ngrid = 48\nrealisations = 2\n[uncertainty]\ndraws = 100\n\
         {curves}{figures}",
        loads.join(", ")
    );
    Scene::parse(&text, &NoFiles, &Overrides::default()).expect("a sound scene")
}

/// The verdicts on a scene that is said so many times.
fn judge(times: usize) -> Work {
    let scene = repeated(times, "psd = \"builtin:uncd-measured\"");
    let results = scene.plan().compute().expect("a sound scene");
    let settings = scene.judge.unwrap_or_default();
    Box::new(move || {
        black_box(JudgePlan::new(&scene, &results, &settings).run(&Unobserved).expect("a sound scene"));
    })
}

/// The intervals of a scene that is said so many times, whose spectrum and modulus are uncertain.
fn draws(times: usize) -> Work {
    let scene = repeated(times, "rms_height = \"20 nm\"\nrms_slope = 0.1\nmean_width = \"1 um\"");
    let results = scene.plan().compute().expect("a sound scene");
    let settings = scene.uncertainty.unwrap_or_default();
    Box::new(move || {
        let plan = UncertaintyPlan::new(&scene, &results, &settings).expect("uncertain inputs");
        black_box(plan.run(&Unobserved).expect("a sound scene"));
    })
}

/// The first of so many maps in a file of Gwyddion, with ten times the points that kernels take.
fn reader(maps: usize) -> Work {
    let side = 10 * SIZE as i32;
    let count = side * side;
    let heights: Vec<u8> = crossing_waves_m()
        .iter()
        .cycle()
        .take(count as usize)
        .flat_map(|height| height.to_le_bytes())
        .collect();
    let component =
        |name: &str, letter: char, value: &[u8]| [name.as_bytes(), &[0, letter as u8], value].concat();
    let object = |class: &str, parts: &[Vec<u8>]| {
        let body = parts.concat();
        [class.as_bytes(), &[0], &(body.len() as u32).to_le_bytes(), &body].concat()
    };
    let unit = |name: &str| component(name, 'o', &object("GwySIUnit", &[component("unitstr", 's', b"m\0")]));
    let map = [
        component("xres", 'i', &side.to_le_bytes()),
        component("yres", 'i', &side.to_le_bytes()),
        component("xreal", 'd', &1e-6f64.to_le_bytes()),
        component("yreal", 'd', &1e-6f64.to_le_bytes()),
        unit("si_unit_xy"),
        unit("si_unit_z"),
        component("data", 'D', &[&count.to_le_bytes()[..], &heights].concat()),
    ];
    let map = object("GwyDataField", &map);
    let all: Vec<Vec<u8>> = (0..maps).map(|at| component(&format!("/{at}/data"), 'o', &map)).collect();
    let file = [b"GWYP".to_vec(), object("GwyContainer", &all)].concat();
    Box::new(move || {
        black_box(scans::read_scans(&file, "maps.gwy", &ScanOptions::default()).expect("a sound file"));
    })
}

/// Sets of texts, two hundred files together: as `scan`, `roughness`, `psd` and the draws of `report` take them.
fn files(sets: usize, files: usize) -> Work {
    let heights = |file: usize| -> String {
        let height = |at: usize| ((at * at * (7 * file + 13)) % 997) as f64 / 997.0;
        (0..64).map(|at| format!("{at} {}\n", height(at))).collect()
    };
    let names: Vec<String> = (0..files).map(|file| format!("{file}.txt")).collect();
    let texts: BTreeMap<String, Vec<u8>> =
        names.iter().enumerate().map(|(file, name)| (name.clone(), heights(file).into_bytes())).collect();
    let typed = |name: &String| format!("{name}:unit=um").parse::<ScanRequest>().expect("a request");
    let requests: Vec<ScanRequest> = names.iter().map(typed).collect();
    let listed: Vec<String> =
        names.iter().map(|name| format!("{{ file = \"{name}\", unit = \"um\" }}")).collect();
    let text = format!(
        "[surface]\nscans = [{}]\n[material]\nyoungs_modulus = \"463 GPa\"\npoisson_ratio = 0.2\n\
         [loads]\npressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"persson\"\n[uncertainty]\ndraws = 20\n",
        listed.join(", ")
    );
    Box::new(move || {
        for _ in 0..sets {
            let visit = |_: &ScanRequest, _: &_| Ok::<(), Infallible>(());
            black_box(read_channels(&requests, &texts, false, visit).expect("sound files").table());
            black_box(RoughnessOfFiles::read(&requests, &texts, &RoughnessSettings::default()).table());
            let composite =
                CompositeOfFiles::read(&requests, &texts, &Recipe::default()).expect("sound files");
            black_box((composite.provenance(), composite.spectrum.remarks(), composite.series_table()));
            let scene = Scene::parse(&text, &texts, &Overrides::default()).expect("a sound scene");
            let results = scene.plan().compute().expect("a sound scene");
            let settings = scene.uncertainty.unwrap_or_default();
            let plan = UncertaintyPlan::new(&scene, &results, &settings).expect("uncertain inputs");
            black_box(plan.run(&Unobserved).expect("a sound scene"));
        }
    })
}
