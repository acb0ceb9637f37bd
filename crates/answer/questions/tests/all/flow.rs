//! Flow through the gaps of pressed surfaces.

use std::f64::consts::{PI, TAU};

use elements::half_space::{Grid, Sides, open_paths};
use elements::{Boundary, ContactField, PointState, PressedLoad, Relief};
use numerics::parallel::Unobserved;
use questions::flow::{FlowEdges, GapMap, PressedFlow};
use questions::{ElementsLoad, ElementsQuestion, PreparedElements, QuestionError};
use tables::Table;
use units::{Remark, RemarkCode};

use crate::common::{
    Counted, STEEL_MODULUS_PA, assert_near, filled, has, loads, small, steel, surface, text_of,
};
use crate::elements::{map, ridge, ridge_along_x};

/// Mean pressure that flattens the ridge \[Pa\].
const FLATTENS_PA: f64 = PI * STEEL_MODULUS_PA * 1e-8 / 3.2e-5;

fn under(pressures_pa: &[f64]) -> ElementsQuestion {
    let loads = loads(pressures_pa).into_iter().map(ElementsLoad::from).collect();
    ElementsQuestion { material: steel(), loads, random: small(3), ..ElementsQuestion::default() }
}

fn flow(
    prepared: &PreparedElements,
    edges: Option<FlowEdges>,
    of_each: bool,
) -> (Table, Vec<PressedLoad>, Vec<Remark>) {
    let flow = PressedFlow::new(edges, &prepared.surfaces).unwrap();
    let see = |field: &ContactField<'_>| flow.solve(field, &Unobserved).map(drop);
    let (mut loads, mut notes) = prepared.answer::<QuestionError>(see, &Unobserved).unwrap();
    let table = flow.table(&mut loads, &mut notes, of_each);
    (table, loads, notes)
}

/// A surface without direction: channels between summits.
fn summits(boundary: Boundary) -> Relief {
    map(boundary, |x, y| 1e-8 * ((TAU * x).cos() + (TAU * 2.0 * y + 3.0 * (TAU * x).sin()).cos()))
}

#[test]
fn a_ridge_lets_fluid_along_it_alone_and_the_note_is_on_the_flow() {
    let pressures_pa = [0.1 * FLATTENS_PA, 0.5 * FLATTENS_PA];
    let paths = |map| {
        let (table, _, notes) = flow(&under(&pressures_pa).on_maps(vec![map]).unwrap(), None, false);
        assert!(!has(&notes, RemarkCode::ClosedPaths));
        (table, text_of(&notes, RemarkCode::FlowPaths, "paths"))
    };
    let (along_y, words) = paths(ridge());
    assert_eq!(filled(&along_y, "flow_factor_x"), [0.0; 2]);
    assert!(words.contains("along x closed from A =") && !words.contains("along y"), "{words}");
    let (along_x, turned) = paths(ridge_along_x());
    assert_eq!(turned.replace("along y", "along x"), words);
    let [x, y] =
        [(&along_x, "flow_factor_x"), (&along_y, "flow_factor_y")].map(|(table, name)| filled(table, name));
    assert_near(x[1], y[1], 1e-6);
    assert!(y.iter().all(|factor| *factor > 1.0), "{y:?}");
}

#[test]
fn areas_are_named_up_to_which_paths_are_open_and_from_which_they_are_closed() {
    let pressures_pa: Vec<f64> = (0..8).map(|n| FLATTENS_PA * 400.0 * 0.4f64.powi(n)).collect();
    let (_, loads, notes) = flow(&under(&pressures_pa).on(&surface()).unwrap(), None, false);
    let words = text_of(&notes, RemarkCode::FlowPaths, "paths");
    assert!(
        words.contains("open on every surface up to A =") && words.contains("on none from A ="),
        "{words}"
    );
    let open: Vec<f64> = loads.iter().map(|load| load.mean().open_along_x).collect();
    assert!(open.is_sorted() && open[0] == 0.0 && open[7] == 1.0, "{open:?}");
}

#[test]
fn paths_of_the_flow_are_those_of_percolation_with_the_same_edges() {
    let pressures_pa: Vec<f64> = (0..6).map(|n| FLATTENS_PA * 4.0 * 0.5f64.powi(n)).collect();
    for (boundary, edges, sides) in [
        (Boundary::Free, None, Sides::Walls),
        (Boundary::Free, Some(FlowEdges::Reservoirs), Sides::Periodic),
        (Boundary::Periodic, Some(FlowEdges::Channel), Sides::Walls),
        (Boundary::Periodic, Some(FlowEdges::Reservoirs), Sides::Periodic),
    ] {
        let prepared = under(&pressures_pa).on_maps(vec![summits(boundary)]).unwrap();
        let flow = PressedFlow::new(edges, &prepared.surfaces).unwrap();
        let see = |field: &ContactField<'_>| {
            let touches: Vec<bool> = field.states().map(|state| state != PointState::Open).collect();
            let closed: Vec<bool> = field.closed_gaps_m().iter().map(|gap_m| *gap_m <= 0.0).collect();
            assert_eq!(touches, closed);
            let expected = open_paths(&field.relief.grid().unwrap(), sides, &touches).unwrap();
            assert_eq!(flow.solve(field, &Unobserved)?.open_paths(), expected);
            Ok(())
        };
        prepared.answer::<QuestionError>(see, &Unobserved).unwrap();
    }
}

#[test]
fn missing_points_are_refused_and_work_may_be_ended() {
    let holed =
        Relief { is_missing: (0..1024).map(|point| point == 40).collect(), ..summits(Boundary::Free) };
    let prepared = under(&[1e6]).on_maps(vec![holed]).unwrap();
    assert!(matches!(PressedFlow::new(None, &prepared.surfaces), Err(QuestionError::Other(_))));
    let gap = GapMap {
        grid: Grid::new(4, 4, 1.0, 1.0).unwrap(),
        gaps_m: vec![1e-6; 16],
        own_edges: Some(FlowEdges::Periodic),
        notes: Vec::new(),
        provenance: String::new(),
    };
    assert!(gap.flow(None, &Counted::cancelled()).is_err_and(|error| error.is_cancelled()));
    let (flow, answer) = gap.flow(None, &Unobserved).unwrap();
    assert!(
        answer.notes.is_empty() && flow.along_x.flux.iter().all(|[x, y]| (x - 1.0).abs() + y.abs() < 1e-12)
    );
    let closed = GapMap { gaps_m: vec![f64::NAN; 16], ..gap };
    let (flow, answer) = closed.flow(Some(FlowEdges::Channel), &Unobserved).unwrap();
    assert_eq!((flow.spacing_errors, filled(&answer.table, "flow_factor_x")), ([None; 2], vec![0.0]));
    assert!(filled(&answer.table, "mean_gap_m")[0].is_sign_positive());
}
