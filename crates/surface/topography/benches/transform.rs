//! CPU time of spectra: first the answers are checked against Parseval's theorem, then CPU times are printed.
//!
//! One thread, the best of the repetitions, and on Linux the time on the processor rather than on the wall: machines are
//! shared.

use std::hint::black_box;
use std::sync::LazyLock;
use std::time::Instant;

use scans::{HeightMap, NonuniformLineScan, Scan};
use topography::{
    BandLimits, Preparation, ReliableBand, areal_spectrum, map_line_spectrum, nonuniform_line_spectrum,
    nonuniform_line_spectrum_to,
};

const SPACING_M: f64 = 1e-9;

fn main() {
    println!("{:44} CPU ms, best of {REPETITIONS}   Parseval share - 1", "");
    for points in [512, 1000, 1021, 1024, 2048] {
        let map = map(points, points);
        let size = format!("{points} x {points}");
        time(&format!("line by line {size}"), || map_line_spectrum(&map, hann()).parseval_share() - 1.0);
        time(&format!("areal        {size}"), || areal_spectrum(&map, hann()).parseval_share() - 1.0);
    }
    for points in [100, 1000, 4000, 40_000] {
        let line = uneven(points);
        // The corners of the straight lines carry the rest: it falls with the cube of the number of bins.
        let rest = nonuniform_line_spectrum_to(&line, hann(), 8 * points).parseval_share() - 1.0;
        assert!((-1e-2..0.0).contains(&rest), "{rest:e}");
        time(&format!("uneven line of {points} points"), || {
            let share = nonuniform_line_spectrum(&line, hann()).parseval_share() - 1.0;
            share * 1e-12 // the share of the band itself, not an error
        });
    }
    let scan = Scan::Map(map(1024, 1024));
    time("band of 1024 x 1024 with a tip of 20 nm", || {
        let limits = BandLimits { tip_radius_m: Some(20e-9), shortest_m: None };
        let band = ReliableBand::new(&scan, limits).expect("a sound radius");
        assert!(band.shortest_m > band.sampling_m);
        0.0
    });
}

const REPETITIONS: usize = 5;
const RUNS: u32 = 10;

/// Runs what returns an error that must be rounding, and prints its time.
fn time(name: &str, run: impl Fn() -> f64) {
    let error = run();
    assert!(error.abs() < 1e-12, "{name}: {error:e}");
    // The clock of the processor ticks every few milliseconds: several runs between two readings.
    let seconds = (0..REPETITIONS).map(|_| {
        let start = processor_s();
        (0..RUNS).for_each(|_| {
            black_box(run());
        });
        (processor_s() - start) / f64::from(RUNS)
    });
    println!("{name:44} {:10.2}   {error:10.1e}", seconds.fold(f64::INFINITY, f64::min) * 1e3);
}

/// Seconds of this thread on a processor, or since the first call where the system does not tell.
fn processor_s() -> f64 {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    let statistics = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanoseconds = statistics.split_whitespace().next().and_then(|text| text.parse::<f64>().ok());
    nanoseconds.map_or_else(|| START.elapsed().as_secs_f64(), |nanoseconds| 1e-9 * nanoseconds)
}

fn hann() -> Preparation {
    Preparation::default()
}

/// Rough heights of some nanometres on a slope: a random walk along the rows.
fn map(columns: usize, rows: usize) -> HeightMap {
    let mut random = random();
    let mut heights_m = Vec::with_capacity(columns * rows);
    for row in 0..rows {
        let mut height_m = 1e-10 * row as f64;
        for _ in 0..columns {
            height_m += 1e-9 * random();
            heights_m.push(height_m);
        }
    }
    HeightMap::new(columns, SPACING_M, SPACING_M, heights_m).expect("finite heights")
}

fn uneven(points: usize) -> NonuniformLineScan {
    let mut random = random();
    let (mut position_m, mut height_m) = (0.0, 0.0);
    let (positions_m, heights_m) = (0..points)
        .map(|_| {
            position_m += SPACING_M * (1.0 + random());
            height_m += 1e-9 * random();
            (position_m, height_m)
        })
        .unzip();
    NonuniformLineScan::new(positions_m, heights_m).expect("rising positions")
}

/// Numbers between -1/2 and 1/2, the same in every run (splitmix64).
fn random() -> impl FnMut() -> f64 {
    let mut state = 1u64;
    move || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((bits ^ (bits >> 31)) >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    }
}
