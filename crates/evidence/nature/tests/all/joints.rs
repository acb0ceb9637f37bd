//! Closures and apertures of joints, on made files.

use elements::SpecimenCompliance;
use nature::NatureError;
use nature::joint::{ApertureMap, Seat, read_closure};

fn closure(steps: &[(f64, f64)]) -> String {
    let line = |(at, (closure_m, stress_pa)): (usize, &(f64, f64))| format!("{at},{closure_m},{stress_pa}\n");
    let lines: String = steps.iter().enumerate().map(line).collect();
    format!("step,closure_m,normal_stress_pa\n{lines}")
}

#[test]
fn the_slope_of_a_parabola_is_exact_within_and_unloading_is_left_out() {
    // p = 1e16 u^2, in uneven steps; the last row unloads.
    let stress_pa = |closure_m: f64| 1e16 * closure_m * closure_m;
    let steps = [10e-6, 15e-6, 28e-6, 30e-6].map(|closure_m| (closure_m, stress_pa(closure_m)));
    let unloads = [(29e-6, 1e6)];
    let read = read_closure(closure(&[&steps[..], &unloads].concat()).as_bytes()).unwrap();
    assert_eq!(read.len(), 4);
    for at in [1, 2] {
        assert!((read[at].stiffness_pa_per_m / (2e16 * steps[at].0) - 1.0).abs() < 1e-9);
    }
    // The ends have one neighbour.
    assert!((read[3].stiffness_pa_per_m / 5.8e11 - 1.0).abs() < 1e-9);
    assert!(matches!(read_closure(closure(&steps[..2]).as_bytes()), Err(NatureError::Closure(2))));
}

/// Bytes of a NumPy array of apertures in steps of 2 um.
fn array(side: usize, steps: impl Fn(usize) -> i16) -> Vec<u8> {
    let header = format!("{{'descr': '<i2', 'fortran_order': False, 'shape': ({side}, {side}), }}\n");
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend((0..side * side).flat_map(|point| steps(point).to_le_bytes()));
    bytes
}

#[test]
fn a_joint_stiffens_and_a_levelled_one_forgets_its_tilt() {
    let side = 59;
    // Bumps whose apertures differ by hundreds of um, on a tilt, with a hole.
    let bumps = |point: usize| {
        let [row, column] = [point / side, point % side];
        (100.0 + 40.0 * ((row as f64 / 3.0).sin() + (column as f64 / 4.0).cos())) as i16
    };
    let press = |steps: &dyn Fn(usize) -> i16| {
        let map = ApertureMap::read(&array(side, steps), "made.npy").unwrap();
        let steps = [(0.0, 1e6), (1e-6, 2e6), (2e-6, 4e6)];
        map.press("made", &read_closure(closure(&steps).as_bytes()).unwrap()).unwrap()
    };
    let with_hole = |point: usize| if point == 29 * side + 29 { -1 } else { bumps(point) };
    let even = press(&with_hole);
    // Two seats, three moduli, two compliances, three loads.
    assert_eq!(even.len(), 36);
    let of = |rows: &[nature::joint::JointRow], seat, compliance| -> Vec<f64> {
        let chosen = |row: &&nature::joint::JointRow| {
            row.seat == seat && row.compliance == compliance && row.youngs_modulus_gpa == 11.0
        };
        rows.iter().filter(chosen).map(|row| row.stiffness_pa_per_m).collect()
    };
    let punch = of(&even, Seat::Levelled, SpecimenCompliance::Punch);
    assert!(punch.windows(2).all(|pair| pair[1] > pair[0]), "{punch:?}");
    // The mean displacement under even pressure is larger than that of a punch, so that more is taken out.
    let evenly = of(&even, Seat::Levelled, SpecimenCompliance::Even);
    assert!(evenly.iter().zip(&punch).all(|(even, punch)| even > punch));
    let tilted = press(&|point| if with_hole(point) < 0 { -1 } else { bumps(point) + (point % side) as i16 });
    let again = of(&tilted, Seat::Levelled, SpecimenCompliance::Punch);
    for (one, other) in punch.iter().zip(&again) {
        assert!((one / other - 1.0).abs() < 0.02, "{one:e} {other:e}");
    }
    let tilted = of(&tilted, Seat::Published, SpecimenCompliance::Punch);
    assert!(tilted.iter().zip(&punch).all(|(tilted, even)| tilted < even));
}

#[test]
fn a_line_is_no_map() {
    let header =
        b"\x93NUMPY\x01\x00\x46\x00{'descr': '<i2', 'fortran_order': False, 'shape': (4,), }             \n";
    let bytes = [&header[..], &[0; 8]].concat();
    assert!(ApertureMap::read(&bytes, "line.npy").is_err());
}
