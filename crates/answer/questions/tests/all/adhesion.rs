//! Surfaces that attract each other.

use std::f64::consts::TAU;

use elements::{Boundary, Relief};
use numerics::parallel::Unobserved;
use questions::{AdhesionQuestion, Answer, BranchChoice, MaterialInput, QuestionError, RandomInput};
use study::figure::{AxisScale, FigureData};
use tables::Cells;
use units::{Remark, RemarkCode, display};

use crate::common::{Counted, assert_all_near, assert_near, filled, has, loads, numbers_of, spectrum_of};
use crate::elements::{map, ridge};

/// Rubber of 1 MPa.
fn rubber() -> MaterialInput {
    MaterialInput { youngs_modulus_pa: Some(0.75e6), poisson_ratio: Some(0.5), ..MaterialInput::default() }
}

fn sticky(pressures_pa: &[f64]) -> AdhesionQuestion {
    AdhesionQuestion {
        material: rubber(),
        pressures: loads(pressures_pa),
        work_of_adhesion_j_per_m2: 0.01,
        range_m: 2e-7,
        branch: BranchChoice::Both,
        random: RandomInput {
            grid: Some(32),
            realisations: Some(2),
            shortest_m: Some(8e-6),
            ..RandomInput::default()
        },
        ..AdhesionQuestion::default()
    }
}

/// Waves from 32 to 8 um whose gradient of about 0.05 rubber follows only in part.
fn bumpy() -> study::surface::Surface {
    let row = |i: i32| {
        let wavelength_m = 3.2e-5 * 0.25f64.powf(f64::from(i) / 10.0);
        format!("{wavelength_m:e},{:e}\n", 6e-20 * (wavelength_m / 8e-6).powf(2.6))
    };
    spectrum_of(&(0..=10).map(row).collect::<String>())
}

fn sticking(question: &AdhesionQuestion) -> (Vec<Remark>, Answer) {
    let prepared = question.on(&bumpy()).unwrap();
    (prepared.notes.clone(), prepared.answer(&Unobserved).unwrap())
}

fn line(figure: &FigureData, at: usize) -> (Vec<f64>, Vec<f64>) {
    figure.series[at].points.iter().copied().unzip()
}

#[test]
fn both_branches_of_a_sticky_contact_are_followed_and_their_widest_difference_is_named() {
    // A ridge of 200 nm, which rubber that has not been pressed touches at its summit alone.
    let pressures_pa = [1e3, 3e3, 0.0];
    let deep = || map(Boundary::Periodic, |x, _| 2e-7 * (TAU * x).cos());
    let question =
        AdhesionQuestion { work_of_adhesion_j_per_m2: 1e-3, range_m: 5e-8, ..sticky(&pressures_pa) };
    let found = question.on_maps(vec![deep(), deep()]).unwrap().answer(&Unobserved).unwrap();
    let areas = filled(&found.table, "area_fraction");
    let (apart, contact) = areas.split_at(3);
    assert_all_near(&filled(&found.table, "nominal_pressure_pa")[..2], &pressures_pa[..2], 1e-9);
    let Some(Cells::Words(branches)) = found.table.column("branch") else { panic!("no branches") };
    assert_eq!(branches[..], ["apart", "apart", "apart", "contact", "contact", "contact"]);
    let widest =
        (0..3).max_by(|a, b| (contact[*a] - apart[*a]).total_cmp(&(contact[*b] - apart[*b]))).unwrap();
    assert!(contact[widest] - apart[widest] > 1e-2, "{apart:?} {contact:?}");
    let names =
        ["hysteresis_pressure_pa", "hysteresis_apart_area_fraction", "hysteresis_contact_area_fraction"];
    let hysteresis = numbers_of(&found.notes, RemarkCode::Hysteresis, names);
    assert_eq!(hysteresis, [pressures_pa[widest], apart[widest], contact[widest]]);
    assert!(!has(&found.notes, RemarkCode::Metastable));
    // Lines by branch, from the least pressure on; logarithms have no place for 0.
    let figure = found.figure.unwrap();
    assert_eq!(line(&figure, 0), (vec![0.0, 1e3, 3e3], vec![apart[2], apart[0], apart[1]]));
    assert_eq!(line(&figure, 1), (vec![0.0, 1e3, 3e3], vec![contact[2], contact[0], contact[1]]));
    assert_eq!(figure.x_scale, AxisScale::Linear);
    assert_ne!(figure.title, figure.y_label);
    // A low surface touches by as much whichever way it came.
    let (before, found) = sticking(&sticky(&[2e3, 8e3]));
    assert!(!has(&found.notes, RemarkCode::Hysteresis));
    assert!(numbers_of(&before, RemarkCode::AdhesionIndicators, ["pastewka_robbins"])[0] > 0.0);
}

#[test]
fn one_branch_has_no_hysteresis_and_a_pull_is_metastable() {
    for (branch, pressures_pa, name) in
        [(BranchChoice::Apart, [2e3, 8e3], "apart"), (BranchChoice::Contact, [-1.0, 8e3], "contact")]
    {
        let question = AdhesionQuestion { branch, per_realisation: true, ..sticky(&pressures_pa) };
        let (_, found) = sticking(&question);
        assert!(!has(&found.notes, RemarkCode::Hysteresis));
        assert_eq!(has(&found.notes, RemarkCode::Metastable), pressures_pa[0] < 0.0);
        let Some(Cells::Words(branches)) = found.table.column("branch") else { panic!("no branches") };
        assert_eq!(branches[..], [name; 4]);
        assert_eq!(filled(&found.table, "realisation"), [1.0, 1.0, 2.0, 2.0]);
        // The figure has the mean of both surfaces.
        let areas = filled(&found.table, "area_fraction");
        let figure = found.figure.unwrap();
        assert_eq!(figure.series.len(), 1);
        assert_all_near(
            &line(&figure, 0).1,
            &[0.5 * (areas[0] + areas[2]), 0.5 * (areas[1] + areas[3])],
            1e-12,
        );
        let expected = if pressures_pa[0] < 0.0 { AxisScale::Linear } else { AxisScale::Logarithmic };
        assert_eq!(figure.x_scale, expected);
    }
}

#[test]
fn the_pull_off_is_the_largest_pull_of_every_surface() {
    for realisations in [1, 2] {
        let mut question = AdhesionQuestion { pull_off: true, ..sticky(&[]) };
        question.random.realisations = Some(realisations);
        let (_, found) = sticking(&question);
        let [pressures, gaps, areas] =
            ["nominal_pressure_pa", "mean_gap_m", "area_fraction"].map(|name| filled(&found.table, name));
        let surface_of = match realisations {
            1 => vec![1.0; pressures.len()],
            _ => filled(&found.table, "realisation"),
        };
        let strongest: Vec<usize> = (1..=realisations)
            .map(|surface| {
                let rows = (0..pressures.len()).filter(|row| surface_of[*row] == surface as f64);
                rows.min_by(|a, b| pressures[*a].total_cmp(&pressures[*b])).unwrap()
            })
            .collect();
        let mean =
            |column: &[f64]| strongest.iter().map(|row| column[*row]).sum::<f64>() / realisations as f64;
        let names = ["pull_off_pressure_pa", "pull_off_mean_gap_m", "pull_off_area_fraction"];
        let pull_off = numbers_of(&found.notes, RemarkCode::PullOff, names);
        assert_all_near(&pull_off, &[mean(&pressures), mean(&gaps), mean(&areas)], 1e-12);
        assert!(pull_off[0] < 0.0);
        let figure = found.figure.unwrap();
        assert_eq!((figure.series.len(), figure.x_scale), (realisations, AxisScale::Linear));
        let marks: Vec<(f64, f64)> = figure.marks.iter().map(|mark| (mark.x, mark.y)).collect();
        assert_eq!(marks, strongest.iter().map(|row| (gaps[*row], pressures[*row])).collect::<Vec<_>>());
        assert!(
            figure
                .marks
                .iter()
                .enumerate()
                .all(|(at, mark)| { mark.condition_index == (realisations > 1).then_some(at) })
        );
        let points: Vec<(f64, f64)> = figure.series.iter().flat_map(|line| line.points.clone()).collect();
        assert_eq!(points, gaps.iter().copied().zip(pressures.iter().copied()).collect::<Vec<_>>());
        assert_eq!(figure.series[0].column == "nominal_pressure_pa", realisations == 1);
        for shown in [display::pressure(-pull_off[0]), display::length(pull_off[1])] {
            assert!(figure.title.contains(&shown), "{}", figure.title);
        }
        assert_eq!(figure.title.contains('2') && figure.title.contains("surfaces"), realisations == 2);
    }
}

#[test]
fn a_grid_with_less_than_two_points_in_the_process_zone_is_called_coarse() {
    // E* rho^2/w over the spacing of 1 um.
    let points = |points: f64| {
        let range_m = (points * 1e-6 * 0.01 / 1e6f64).sqrt();
        let question = AdhesionQuestion { range_m, ..sticky(&[1e3]) };
        question.on_maps(vec![ridge()]).unwrap().notes
    };
    assert!(!has(&points(2.1), RemarkCode::ProcessZoneCoarse));
    let [found] = numbers_of(&points(1.5), RemarkCode::ProcessZoneCoarse, ["process_zone_points"]);
    assert_near(found, 1.5, 1e-9);
    let free = Relief { boundary: Boundary::Free, ..ridge() };
    assert!(matches!(sticky(&[1e3]).on_maps(vec![free]), Err(QuestionError::Adhesion(_))));
    let in_hardnesses = AdhesionQuestion { pressures: vec!["0.1 H".parse().unwrap()], ..sticky(&[]) };
    assert!(matches!(in_hardnesses.check(), Err(QuestionError::Load { option: "pressure", .. })));
    let stopped = sticky(&[1e3]).on(&bumpy()).unwrap().answer(&Counted::cancelled());
    assert!(stopped.is_err_and(|error| error.is_cancelled()));
}
