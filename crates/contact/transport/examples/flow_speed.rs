//! Times the flow along x through pressed random surfaces, on one thread, and prints a table with the error that the spacing of the
//! points leaves. Arguments are the points along a side, 512, 1024 and 2048 by default, and files of gaps: squares of 64-bit floats,
//! little-endian, of which the flow along y is solved too.
//!
//! Result (A about 0.023, 0.21 and 0.35; 8 points to the shortest wave; an AMD EPYC of 2025, shared): 0.20, 0.14 and 0.11 s of the
//! processor on 512^2, 0.88, 0.78 and 0.59 s on 1024^2, 4.0, 3.7 and 2.7 s on 2048^2, in 17 to 23 iterations and 0.87 GiB for the
//! largest, gaps and flux included; with 4 points to the shortest wave and A = 0.20, 17.5 s, 25 iterations and 2.6 GiB on 4096^2.

use std::time::Instant;

use elements::half_space::{Elements, Grid, Loading};
use numerics::parallel::Unobserved;
use spectrum::random_surfaces::{AreaSpectrum, Phases, SelfAffine, Size, Synthesis};
use transport::GapField;
use transport::flow::{Ends, FlowDirection, solve, spacing_error};

const SIDE_M: f64 = 1e-3;
const WAVES: f64 = 8.0;
/// Points to the shortest wave.
const RESOLUTION: f64 = 8.0;
const CONTACT_MODULUS_PA: f64 = 1e11;
const RMS_GRADIENT: f64 = 0.05;
/// Pressures over E* h', for areas of about 0.02, 0.2 and 0.36.
const REDUCED_PRESSURES: [f64; 3] = [0.01, 0.1, 0.18];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    if arguments.is_empty() {
        arguments = [512, 1024, 2048].map(|points: usize| points.to_string()).into();
    }
    println!(
        "field, points, A, direction, flow factor, error of the spacing, seconds of the processor, iterations, residual, peak MiB"
    );
    for argument in arguments {
        if let Ok(points) = argument.parse() {
            for pressure in REDUCED_PRESSURES {
                let gaps_m = pressed(points, pressure)?;
                time(&format!("pressed by {pressure}"), points, &gaps_m, &[FlowDirection::X])?;
            }
        } else {
            let bytes = std::fs::read(&argument)?;
            let gaps_m: Vec<f64> =
                bytes.as_chunks().0.iter().map(|&bytes| f64::from_le_bytes(bytes)).collect();
            time(&argument, gaps_m.len().isqrt(), &gaps_m, &[FlowDirection::X, FlowDirection::Y])?;
        }
    }
    Ok(())
}

/// Gaps of a pressed surface, 0 in contact.
fn pressed(points: usize, reduced_pressure: f64) -> Result<Vec<f64>, Box<dyn std::error::Error>> {
    let spectrum = AreaSpectrum::self_affine(&SelfAffine {
        hurst_exponent: 0.8,
        longest_m: SIDE_M / WAVES,
        rolloff_m: SIDE_M / WAVES,
        shortest_m: SIDE_M * RESOLUTION / points as f64,
        size: Size::RmsGradient(RMS_GRADIENT),
    })?;
    let surface = spectrum.surface(&Synthesis::square(points, SIDE_M, 1, Phases::FixedModulus), 0)?;
    let grid = Grid::new(points, points, SIDE_M, SIDE_M)?;
    let loading = Loading {
        contact_modulus_pa: CONTACT_MODULUS_PA,
        nominal_pressure_pa: reduced_pressure * CONTACT_MODULUS_PA * RMS_GRADIENT,
        saturation_pa: None,
        tolerance: 1e-6,
    };
    let contact = Elements::periodic(grid, &surface.heights_m)?.press(&loading, &Unobserved)?;
    let gaps = contact.gaps_m.iter().zip(contact.touching());
    Ok(gaps.map(|(&gap_m, touches)| if touches { 0.0 } else { gap_m }).collect())
}

/// Prints a line for each direction.
fn time(
    name: &str,
    points: usize,
    gaps_m: &[f64],
    directions: &[FlowDirection],
) -> Result<(), Box<dyn std::error::Error>> {
    let gap = GapField::new(Grid::new(points, points, SIDE_M, SIDE_M)?, gaps_m)?;
    for &direction in directions {
        let (begin, before) = (Instant::now(), processor_seconds());
        let flow = solve(&gap, direction, Ends::Periodic, &Unobserved)?;
        let elapsed = begin.elapsed().as_secs_f64();
        let seconds = before.zip(processor_seconds()).map_or(elapsed, |(before, after)| after - before);
        let peak = peak_mebibytes();
        let error = spacing_error(flow.flow_factor, &gap, direction, Ends::Periodic, &Unobserved)?;
        println!(
            "{name}, {points}, {:.4}, {direction:?}, {:.12e}, {:.2e}, {seconds:.2}, {}, {:.1e}, {peak}",
            gap.closed_share(),
            flow.flow_factor,
            error.unwrap_or(f64::NAN),
            flow.iterations,
            flow.residual
        );
    }
    Ok(())
}

/// Time that the processor has spent on this thread, as Linux says it.
fn processor_seconds() -> Option<f64> {
    let times = std::fs::read_to_string("/proc/self/schedstat").ok()?;
    times.split_whitespace().next()?.parse::<f64>().ok().map(|nanoseconds| 1e-9 * nanoseconds)
}

/// Largest memory that the process has held, as Linux says it; empty elsewhere.
fn peak_mebibytes() -> String {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kibibytes = line.and_then(|line| line.trim().trim_end_matches(" kB").parse::<u64>().ok());
    kibibytes.map_or_else(String::new, |kibibytes| (kibibytes / 1024).to_string())
}
