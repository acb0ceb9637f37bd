//! Responses of a contact as questions draw them: the pull-off of a wave, and the loops of a tangential load.

use std::f64::consts::TAU;

use elements::{Boundary, Relief};
use numerics::parallel::Unobserved;
use questions::{AdhesionQuestion, Answer, GapModel, LoadInput, MaterialInput, TangentialQuestion};
use report::chart;
use spectrum::ReadOptions;
use study::NoFiles;
use study::models;
use study::surface::Surface;

use super::{PROVENANCE, Picture};

/// Points along the wave.
const POINTS: usize = 1024;
/// Wavelength and amplitude of the wave \[m\].
const WAVE_M: [f64; 2] = [100e-6, 1e-6];

/// Draws mean pressure over mean gap of a wave of soft rubber that is pulled off.
pub(super) fn pull_off() -> Picture {
    let question = AdhesionQuestion {
        material: material(3e6, 0.5),
        work_of_adhesion_j_per_m2: 10e-3,
        range_m: 50e-9,
        pull_off: true,
        ..AdhesionQuestion::default()
    };
    let [length_m, amplitude_m] = WAVE_M;
    let height_m = |at: usize| amplitude_m * (TAU * at as f64 / POINTS as f64).cos();
    let wave = Relief {
        rows: 1,
        columns: POINTS,
        length_x_m: length_m,
        length_y_m: length_m,
        heights_m: (0..POINTS).map(height_m).collect(),
        boundary: Boundary::Periodic,
        is_missing: Vec::new(),
    };
    let answer = question.on_maps(vec![wave]).and_then(|prepared| prepared.answer(&Unobserved));
    let subject = "wave, E* = 4 MPa, w = 10 mJ/m², ρ = 50 nm";
    drawn("pull-off", subject, answer.expect("a wave that is pulled off"))
}

/// Draws the loops of the measured diamond film on itself under three shares of sliding.
pub(super) fn shear_loop() -> Picture {
    let surface = Surface::load("builtin:uncd-measured", &NoFiles, &ReadOptions::default());
    let question = TangentialQuestion {
        by: GapModel {
            model: models::with_gaps().find(|entry| entry.name == "persson"),
            material: material(463e9, 0.2),
            ..GapModel::default()
        },
        friction: Some(0.1),
        pressures: vec![LoadInput { pressure: units::Pressure::Pascals(10e6), label: "10 MPa".to_owned() }],
        figure: true,
        ..TangentialQuestion::default()
    };
    let answer = question.answer(&surface.expect("a spectrum of the program"), &Unobserved);
    let subject = "UNCD, E = 463 GPa, ν = 0.2, 10 MPa, f = 0.1";
    drawn("shear-loop", subject, answer.expect("loads that stick"))
}

fn material(youngs_modulus_pa: f64, poisson_ratio: f64) -> MaterialInput {
    MaterialInput {
        youngs_modulus_pa: Some(youngs_modulus_pa),
        poisson_ratio: Some(poisson_ratio),
        ..MaterialInput::default()
    }
}

fn drawn(name: &'static str, subject: &str, answer: Answer) -> Picture {
    let figure = answer.figure.expect("a figure was asked for");
    Picture { name, svg: chart::svg(&figure, subject, &[PROVENANCE.to_owned()]) }
}
