//! Walking contexts: a folder with a file of every kind, and all that a command puts out in it.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use crate::messages::workbook;
use crate::nanoscope::{Image, NanoscopeFile};
use crate::support::Bench;

/// A folder with a file of every kind.
pub struct Folder {
    pub bench: Bench,
    inputs: BTreeSet<String>,
}

/// Output of a command: its status, what it printed, the files that it wrote, and its messages.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    pub status: i32,
    pub printed: String,
    pub files: BTreeMap<String, Vec<u8>>,
    pub said: String,
}

impl Folder {
    fn new() -> Self {
        let bench = bench();
        let inputs = bench.files().into_iter().collect();
        Folder { bench, inputs }
    }

    /// Writes a file that commands read.
    pub fn write(&mut self, name: &str, content: &str) {
        self.bench.write(name, content);
        self.inputs.insert(name.to_owned());
    }

    /// Runs a command and takes the files that it writes away.
    pub fn run(&self, words: &[String]) -> Outcome {
        let ran = self.bench.run(&words.iter().map(String::as_str).collect::<Vec<_>>());
        let mut files = BTreeMap::new();
        for name in self.bench.files().into_iter().filter(|name| !self.inputs.contains(name)) {
            take(&self.bench.path(&name), &name, &mut files);
        }
        // The record of what was written holds the digests of files before they are made plain.
        files.retain(|name, _| !name.ends_with(".truearea-files"));
        // The command is quoted in comments, which run over several lines in the input of finite element programs.
        let without_blanks = |text: &str| text.split([' ', '*']).collect::<String>();
        let typed = without_blanks(&words.join(" "));
        let plain = |text: &str| without_blanks(&text.replace("\n**", "")).replace(&typed, "");
        for bytes in files.values_mut() {
            if let Ok(text) = std::str::from_utf8(bytes) {
                *bytes = plain(text).into_bytes();
            }
        }
        Outcome { status: ran.status, printed: plain(&ran.stdout), files, said: ran.stderr }
    }
}

impl Outcome {
    /// Returns the outcome without the comments in tables and pictures, which repeat what was typed.
    pub fn without_comments(mut self) -> Self {
        for (name, bytes) in &mut self.files {
            let text = String::from_utf8_lossy(bytes).into_owned();
            if name.ends_with(".csv") {
                *bytes = text
                    .lines()
                    .filter(|line| !line.starts_with('#'))
                    .collect::<Vec<_>>()
                    .join("\n")
                    .into_bytes();
            } else if let Some((before, rest)) = text.split_once("<!--") {
                let after = rest.split_once("-->").map_or("", |(_, after)| after);
                *bytes = format!("{before}{after}").into_bytes();
            }
        }
        self
    }
}

/// Applies a function in every context, two at once, each in a folder of its own; returns all that it found, in the order of contexts.
pub fn in_every<C: Sync>(
    contexts: &[C],
    of_context: impl Fn(&mut Folder, &C) -> Vec<String> + Sync,
) -> Vec<String> {
    let next = AtomicUsize::new(0);
    let found = Mutex::new(BTreeMap::new());
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                let mut folder = Folder::new();
                loop {
                    let at = next.fetch_add(1, Ordering::Relaxed);
                    let Some(context) = contexts.get(at) else { break };
                    let of_this = of_context(&mut folder, context);
                    found.lock().unwrap_or_else(PoisonError::into_inner).insert(at, of_this);
                }
            });
        }
    });
    found.into_inner().unwrap_or_else(PoisonError::into_inner).into_values().flatten().collect()
}

fn take(path: &Path, name: &str, files: &mut BTreeMap<String, Vec<u8>>) {
    if path.is_dir() {
        for entry in std::fs::read_dir(path).unwrap() {
            let entry = entry.unwrap();
            take(&entry.path(), &format!("{name}/{}", entry.file_name().to_string_lossy()), files);
        }
        std::fs::remove_dir(path).unwrap();
    } else {
        files.insert(name.to_owned(), std::fs::read(path).unwrap());
        std::fs::remove_file(path).unwrap();
    }
}

pub fn split(words: &str) -> Vec<String> {
    words.split_whitespace().map(str::to_owned).collect()
}

/// Heights [um] of points `step` apart, of many wavelengths.
fn height(x: f64) -> f64 {
    (1..40)
        .map(|n| {
            0.05 / f64::from(n * n) * (f64::from(n) * 0.7 * x + f64::from(n * n)).sin() * f64::from(n).sqrt()
        })
        .sum()
}

fn bench() -> Bench {
    let bench = Bench::new();
    let psd: String = (0..24)
        .map(|at| {
            let wavelength = 1e-5 * 10f64.powf(-f64::from(at) / 12.0);
            // Resampling changes a spectrum with noise, and not a power law.
            let noise = 1.0 + 0.4 * (2.3 * f64::from(at * at)).sin();
            format!("{wavelength:e},{:e}\n", 4e-21 * noise * (wavelength / 1e-5f64).powf(2.6))
        })
        .collect();
    bench.write("psd.csv", format!("wavelength_m,C1D_m3\n{psd}"));
    let trace: String =
        (0..512).map(|at| format!("{} {}\n", f64::from(at) * 0.1, height(f64::from(at) * 0.1))).collect();
    bench.write("named.txt", format!("x (um), z (um)\n{}", trace.replace(' ', ", ")));
    bench.write("trace.txt", trace);
    let row = |y: i32| {
        (0..32)
            .map(|x| height(f64::from(x) * 0.3 + f64::from(y) * 1.7).to_string())
            .collect::<Vec<_>>()
            .join(" ")
    };
    bench.write("map.txt", (0..32).map(|y| row(y) + "\n").collect::<String>());
    bench.write("list.csv", "file,unit\ntrace.txt,um\n").write("other.csv", "file,unit\ntrace.txt,nm\n");
    let holed = |y: i32| {
        if y % 5 == 2 {
            row(y).replacen(' ', " nan ", 1).rsplit_once(' ').unwrap().0.to_owned()
        } else {
            row(y)
        }
    };
    let header = "# Channel: Topo\n# Width: 10 um\n# Height: 10 um\n# Value units: um\n";
    bench.write("holed.txt", header.to_owned() + &(0..32).map(|y| holed(y) + "\n").collect::<String>());
    let heights_m: Vec<f64> = (0..32 * 16).map(|at| height(f64::from(at) * 0.3) * 1e-7).collect();
    let others_m: Vec<f64> = heights_m.iter().rev().map(|height_m| 0.8 * height_m).collect();
    let image = |name, heights_m| Image { name, direction: "Trace", heights_m };
    let images =
        vec![image("Height", &heights_m[..]), image("Height Sensor", &others_m), image("Phase", &heights_m)];
    let one = NanoscopeFile { scan_size: "10000 5000 nm", ..NanoscopeFile::new(32, 16, &heights_m) };
    bench.write("one.001", one.to_bytes()).write("two.001", NanoscopeFile { images, ..one }.to_bytes());
    bench.write("heights.xlsx", workbook());
    bench.write(
        "rows.csv",
        "radius_m,density_per_m2,sigma_s_m,m0_m2,m2,m4_per_m2\n1e-6,1e12,1e-8,1e-15,1e-3,1e10\n",
    );
    bench.write(
        "full.csv",
        "model,youngs_modulus_pa,poisson_ratio,yield_strength_pa,strain_gradient_length_m,radius_m,density_per_m2,sigma_s_m,separation_m,pressure_pa\n\
         hertz,2e11,0.3,,,1e-6,1e12,1e-8,1e-8,\nep-sphere,2e11,0.3,1e8,1e-6,1e-6,1e12,1e-8,,1e7\n",
    );
    bench.write("flat.csv", "pressure_pa,rms_pressure_pa\n1e7,1e9\n");
    bench.write("hard.csv", "pressure_pa,rms_pressure_pa,hardness_pa,hardness_growth\n1e7,1e9,3e8,0.1\n");
    bench.write(
        "spheres.csv",
        "youngs_modulus_pa,poisson_ratio,yield_strength_pa,radius_m,interference_m\n2e11,0.3,1e8,1e-6,1e-8\n",
    );
    bench.write(
        "sinusoids.csv",
        "youngs_modulus_pa,poisson_ratio,yield_strength_pa,aspect_ratio,pressure_pa\n2e11,0.3,1e8,0.01,1e7\n",
    );
    bench.write(
        "pressed.csv",
        "youngs_modulus_pa,poisson_ratio,yield_strength_pa,wavelength_m,aspect_ratio,interference_m\n2e11,0.3,1e8,1e-6,0.01,1e-9\n",
    );
    bench.write(
        "scene.toml",
        "[surface]\npsd = \"psd.csv\"\n[material]\nyoungs_modulus = \"200 GPa +- 10 GPa\"\npoisson_ratio = 0.3\nyield_strength = \"100 MPa\"\n\
         [loads]\npressures = [\"10 MPa\", \"100 MPa\"]\n[[curve]]\nmodel = \"elastic\"\n[[curve]]\nmodel = \"persson\"\n\
         [[figure]]\nname = \"area\"\nshows = \"area\"\n[[figure]]\nname = \"moments\"\nshows = \"moments\"\n\
         [judge]\ngrid = 32\nrealisations = 2\n[uncertainty]\ndraws = 20\n",
    );
    // Of files in folders, provenance quotes the names or the whole paths.
    std::fs::create_dir(bench.path("in")).unwrap();
    for name in bench.files().iter().filter(|name| *name != "in") {
        std::fs::copy(bench.path(name), bench.path("in").join(name)).unwrap();
    }
    bench
}
