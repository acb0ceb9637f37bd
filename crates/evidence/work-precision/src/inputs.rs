//! Inputs of any size for the program: tables of states, maps, lines and scenes, as files in one folder.

use std::fmt::Write as _;
use std::path::PathBuf;

use crate::uncertain_scene::SceneFiles;

/// Points of a line.
const POINTS_OF_A_LINE: usize = 4096;
/// Options that give the program unit and size of heights, whose files have neither.
const UNITS: [&str; 4] = ["--unit", "nm", "--size", "100 um"];

/// Folder for the files. Errors of writing are left to the program, which then lacks its input.
#[derive(Debug)]
pub struct Inputs {
    folder: PathBuf,
}

impl Inputs {
    /// Takes a folder, made with the first file.
    pub fn new(folder: PathBuf) -> Self {
        Inputs { folder }
    }

    /// Writes a table of unrelated populations under unrelated loads, and returns its path.
    pub fn states(&self, rows: usize) -> String {
        let mut text =
            "model,youngs_modulus_pa,poisson_ratio,yield_strength_pa,radius_m,density_per_m2,sigma_s_m,\
             pressure_pa\n"
                .to_owned();
        for row in 0..rows {
            let [a, b, c] = [0, 1, 2].map(|step| fraction(row, step));
            let (sigma_m, radius_m) = (1e-9 * 10f64.powf(2.0 * a), 1e-7 * 10f64.powf(2.0 * b));
            let (density, pressure_pa) = (0.03 / (sigma_m * radius_m), 1e3 * 10f64.powf(5.0 * c));
            let _ = writeln!(
                text,
                "ep-sphere,4.63e11,0.2,1.8e9,{radius_m:e},{density:e},{sigma_m:e},{pressure_pa:e}"
            );
        }
        self.write(&format!("states-{rows}.csv"), text.as_bytes())
    }

    /// Arguments for the spectrum of a square map of about this many points.
    pub fn map(&self, points: f64) -> Vec<String> {
        let side = points.sqrt().round() as usize;
        let heights = (0..side * side).map(|point| fraction(point, 0)).collect::<Vec<f64>>();
        let bytes = array(&heights, &format!("({side}, {side})"));
        self.spectrum(vec![self.write(&format!("map-{side}.npy"), &bytes)])
    }

    /// Arguments for the composite spectrum of this many lines.
    pub fn lines(&self, count: usize) -> Vec<String> {
        let line = |number: usize| {
            let points = number * POINTS_OF_A_LINE..(number + 1) * POINTS_OF_A_LINE;
            let heights: Vec<f64> = points.map(|point| fraction(point, 0)).collect();
            self.write(&format!("line-{number}.npy"), &array(&heights, &format!("({POINTS_OF_A_LINE},)")))
        };
        self.spectrum((0..count).map(line).collect())
    }

    /// Arguments for intervals from this many draws.
    pub fn draws(&self, files: &SceneFiles, draws: usize) -> Vec<String> {
        self.write(SceneFiles::PSD, files.psd.as_bytes());
        let scene = format!("{}\n[uncertainty]\ndraws = {draws}\n", files.scene);
        let scene = self.write(&format!("draws-{draws}.toml"), scene.as_bytes());
        let results = self.folder.join("results").display().to_string();
        let arguments = ["run", &scene, "--no-judge", "--no-report", "--out", &results];
        arguments.map(str::to_owned).to_vec()
    }

    /// Removes all files.
    pub fn remove(self) {
        let _ = std::fs::remove_dir_all(self.folder);
    }

    fn spectrum(&self, files: Vec<String>) -> Vec<String> {
        let words = std::iter::once("psd".to_owned()).chain(files);
        words.chain(UNITS.map(str::to_owned)).collect()
    }

    fn write(&self, name: &str, bytes: &[u8]) -> String {
        let path = self.folder.join(name);
        let _ = std::fs::create_dir_all(&self.folder).and_then(|()| std::fs::write(&path, bytes));
        path.display().to_string()
    }
}

/// Numbers from 0 to 1, spread evenly for any count: fractions of multiples of three irrational numbers.
fn fraction(at: usize, sequence: usize) -> f64 {
    let steps = [0.618_033_988_75, 0.754_877_666_25, 0.569_840_290_99];
    (steps[sequence] * at as f64).fract()
}

/// Heights as an array of NumPy.
fn array(heights: &[f64], shape: &str) -> Vec<u8> {
    let header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}\n");
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend(heights.iter().flat_map(|height| height.to_le_bytes()));
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_array_is_read_as_a_map() {
        let bytes = array(&[1.0, 2.0, 3.0, 5.0, 8.0, 13.0], "(2, 3)");
        let options = scans::ScanOptions {
            unit: Some("nm".parse().unwrap()),
            size: Some(scans::ScanSize { x_m: 3e-6, y_m: None }),
            ..Default::default()
        };
        let read = scans::read_scans(&bytes, "map.npy", &options).unwrap();
        let scans::Scan::Map(map) = read[0].scan.clone().complete().unwrap() else { panic!("a map") };
        assert_eq!((map.columns(), map.rows(), map.heights_m()[5]), (3, 2, 13e-9));
    }
}
