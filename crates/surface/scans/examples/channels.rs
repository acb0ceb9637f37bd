//! Lists the channels of the files given: points, size, rms height, peak to valley, missing points.

use scans::{ScanOptions, Statistics, visit_channels};

fn main() {
    for path in std::env::args().skip(1) {
        let bytes = std::fs::read(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
        // Text files without a unit are read in nm here.
        let options = ScanOptions {
            fallback_unit: "nm".parse().ok(),
            fallback_size: Some(scans::ScanSize { x_m: 1e-6, y_m: None }),
            ..ScanOptions::default()
        };
        let result = visit_channels(&bytes, &path, &options, true, |channel| match channel {
            Err(error) => println!("{path}: {error}"),
            Ok(file) => {
                let found = Statistics::from_scan(&file.scan);
                println!(
                    "{path} ({}), {}: {} in {:?}, size {:?} m, rms {:.9e}, range {:.9e}, {} missing points, axis {:?}, {:?} {:?}",
                    file.format,
                    file.channel.as_deref().unwrap_or("unnamed"),
                    file.measure,
                    file.scan.points(),
                    file.scan.size_m(),
                    found.map_or(0.0, |found| found.rms_height_m),
                    found.map_or(0.0, |found| found.peak_to_valley_m),
                    file.scan.missing_points().count(),
                    file.fast_axis,
                    file.probe,
                    file.notes,
                );
            }
        });
        if let Err(error) = result {
            println!("{path}: {error}");
        }
    }
}
