//! What the program says where something is wrong or to be remarked: one snapshot of all of it.

mod support;

use std::fmt::Write;

use support::Bench;

const PSD: &str = "wavelength_m,C1D_m3\n1e-5,1e-20\n1e-6,1e-23\n1e-7,1e-26\n";
const SCENE: &str = "title = \"t\"\n[surface]\npsd = \"psd.csv\"\n[material]\nyoungs_modulus = \"1 GPa\"\n\
                     poisson_ratio = 0.3\n[loads]\npressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"elastic\"\n\
                     [[curve]]\nmodel = \"hertz\"\n";

/// A call a line, as in a shell without quotes.
const CALLS: &str = "\
stack psd.csv
moments psd.csv --hardness cosine
moments psd.csv --cutof 1um
moments psd.csv --cutoff 1nm
moments psd.csv --cutoff 1m
moments psd.csv --format json --provenance
moments psd.csv --figure m.gif
moments psd.csv --figure m.svg --output m.svg
moments psd.csv --output psd.csv
moments psd.csv --output folder
moments bare.txt
moments areas.csv
moments several.csv
moments series.csv
moments psd.csv --x-unit furlong
moments psd.csv --x-unit um
moments map.001
moments map.nc
moments absent.csv
amplitude psd.csv --normalisation as-printed
fit psd.csv --amplitude parseval
fit psd.csv
asperity sphere --strength-cap 1GPa
--normalisation parseval stacked psd.csv --model elastic --pressure 1MPa
stacked psd.csv --model elastic --pressure 1MPa
stacked psd.csv --model elastic --pressure 1MPa --youngs-modulus 1GPa
stacked psd.csv --model elastic --pressure 1H --youngs-modulus 1GPa --poisson-ratio 0.3
stacked psd.csv --model elastic --pressure 1MPa --youngs-modulus 1GPa --poisson-ratio 0.3 --strength-cap 1GPa
stacked psd.csv --model elastic-plastic --pressure 1MPa --youngs-modulus 1GPa --poisson-ratio 0.3 --yield-strength 1MPa --strength-cap 1GPa
stacked psd.csv --model elastic-plastic --pressure 1MPa --youngs-modulus 1GPa --poisson-ratio 0.3
stacked psd.csv --model elastic-plastic --pressure 1H --youngs-modulus 1GPa --poisson-ratio 0.3 --indentation-hardness 3MPa
stacked psd.csv --model elastic --pressure 1H --youngs-modulus 1GPa --poisson-ratio 0.3 --indentation-hardness 3MPa
stacked psd.csv --model elastic-plastic --pressure 1MPa --youngs-modulus 1GPa --poisson-ratio 0.3 --indentation-hardness 3MPa --yield-strength 2MPa
stacked psd.csv --model elastic-plastic --pressure 1MPa --youngs-modulus 1GPa --poisson-ratio 0.3 --indentation-hardness 1H
statistical --input rows.csv --indentation-hardness 300HV --yield-strength 2MPa
asperity sphere --input spheres.csv --indentation-hardness 300HV
asperity sphere --input hard.csv
asperity sphere --input empty.csv
stacked psd.csv --model elastic --pressures 1kPa:1MPa:100 --youngs-modulus 1GPa --poisson-ratio 0.3 --figure many.svg
stacked psd.csv --model elastic --pressure 1MPa --counterface-youngs-modulus 1GPa
statistical psd.csv --model hertz --pressure 1MPa --youngs-modulus 1GPa --poisson-ratio 0.3 --hardness cosine
statistical psd.csv --model hertz --pressure 1MPa --youngs-modulus 1GPa --poisson-ratio 0.3 --interference-law bem
statistical psd.csv --model hertz --pressure 1MPa --youngs-modulus 1GPa --poisson-ratio 0.3 --strength-cap 1GPa
statistical psd.csv --model hertz --pressure 1MPa --youngs-modulus 210GPa+-5GPa --poisson-ratio 0.3
statistical psd.csv --model hertz --pressure 1MPa --youngs-modulus 210GPa --poisson-ratio 0.3+-0.02
statistical --input rows.csv --cutoff 1um
statistical --input rows.csv --column C1D_m3
statistical --input rows.csv --output folder
psd line.txt --unit nm --cutoff 1um
psd line.txt --unit nm --out a.csv --output b.csv
psd line.txt --unit nm --areal --average log
psd line.txt --unit nm --figure line.txt
psd line.txt --unit nm --figure absent/figure.svg
run absent.toml
run scene.toml --out psd.csv
run scene.toml --output scene.toml
run scene.toml --output psd.csv
run scene.toml --hardness cosine
run scene.toml --strength-cap 1GPa
run scene.toml --cutoff 1nm
run hard.toml
run in-hardnesses.toml
run scene.toml --explain --no-report
run of-scan.toml
run bare.toml
run series.toml
run furlong.toml
man --out psd.csv
completions bash --output folder
";

#[test]
fn all_messages() {
    let bench = Bench::new();
    let height = |i: usize| ((i * 7919) % 1009) as f64 / 100.0;
    let line: String = (0..512).map(|i| format!("{i} {}\n", height(i))).collect();
    bench.write("psd.csv", PSD).write("scene.toml", SCENE).write("line.txt", line);
    bench.write("map.001", "\\*File list\r\n\\Version: 0x05120000\r\n").write("map.nc", "CDF\x01\0\0\0\0");
    bench.write("rows.csv", "model\nhertz\n").write("of-scan.toml", SCENE.replace("psd.csv", "map.001"));
    bench.write("bare.txt", "1e-5 1e-20\n1e-6 1e-23\n").write("areas.csv", "q,psd_m4\n1,2\n2,3\n");
    bench.write("several.csv", "lambda_m,psd_m3,Ciso_m4\n1,2,3\n2,3,4\n");
    bench.write(
        "series.csv",
        "Subject,Series,Wavevector (1/m),PSD (m\u{b3})\na,x,1,2\na,x,2,1\nb,y,1,2\nb,y,2,1\n",
    );
    for (name, psd) in [("bare", "bare.txt"), ("series", "series.csv")] {
        bench.write(&format!("{name}.toml"), SCENE.replace("psd.csv", psd));
    }
    bench.write("furlong.toml", SCENE.replace("[material]", "x_unit = \"furlong\"\n[material]"));
    let spheres = "youngs_modulus_pa,poisson_ratio,radius_m,interference_m\n1e11,0.3,1e-6,1e-9\n";
    let strengths = |cells: &str| {
        let [header, row] = ["yield_strength_pa,indentation_hardness_pa,", cells].map(str::to_owned);
        spheres.replacen('y', &format!("{header}y"), 1).replace("1e11", &format!("{row}1e11"))
    };
    bench.write("spheres.csv", spheres).write("hard.csv", strengths("1e9,4e9,"));
    bench.write("empty.csv", strengths(",,"));
    let hard = "yield_strength = \"1 GPa\"\nindentation_hardness = \"300 HV\"\n[loads]";
    bench.write("hard.toml", SCENE.replace("[loads]", hard));
    bench.write("in-hardnesses.toml", SCENE.replace("1 MPa", "1 H"));
    std::fs::create_dir(bench.path("folder")).unwrap();
    let files = bench.files();
    // Every platform has its own words for it.
    let not_found = std::fs::read(bench.path("absent")).unwrap_err().to_string();
    let mut said = String::new();
    for call in CALLS.lines() {
        let ran = bench.run(&call.split(' ').collect::<Vec<_>>());
        let _ = writeln!(
            said,
            "$ truearea {call}\n[{}]\n{}",
            ran.status,
            ran.stderr.replace(&not_found, "NOT FOUND")
        );
        assert_eq!(bench.files(), files, "{call}");
    }
    insta::assert_snapshot!(said);
}

#[test]
fn an_option_before_its_command_means_what_it_means_behind() {
    let bench = Bench::new();
    let model = "stacked psd.csv --model elastic-plastic --pressure 1MPa --youngs-modulus 1GPa --poisson-ratio 0.3 \
                 --yield-strength 1MPa --strain-gradient-length 1um";
    let statistical = model.replace("stacked", "statistical").replace("elastic-plastic", "ep-sphere");
    let counterface = "--counterface-youngs-modulus 2GPa --counterface-poisson-ratio 0.2";
    bench.write("psd.csv", PSD).write(
        "rows.csv",
        "youngs_modulus_pa,poisson_ratio,yield_strength_pa,radius_m,interference_m\n1e11,0.3,1e9,1e-6,1e-9\n",
    );
    for (option, command) in [
        ("--format json", "moments psd.csv"),
        ("--timings", "scene new"),
        ("--normalisation as-printed", "moments psd.csv"),
        ("--normalisation as-printed", &statistical),
        ("--cutoff 1um", "moments psd.csv"),
        ("--cutoff=1um", "amplitude psd.csv"),
        ("--scales-per-decade 3", "fit psd.csv"),
        ("--scales-per-decade 3", model),
        ("--cutoff 1um", &statistical),
        ("--amplitude parseval", "amplitude psd.csv"),
        ("--amplitude parseval", model),
        ("--hardness cosine", &statistical),
        ("--strength-cap 5MPa", model),
        ("--strength-cap 5MPa", &statistical),
        (counterface, model),
        (counterface, &statistical),
        (counterface, "asperity sphere --input rows.csv"),
    ] {
        let run = |line: String| bench.run(&line.split_whitespace().collect::<Vec<_>>()).ok();
        let before = run(format!("{option} {command}"));
        assert_eq!(before, run(format!("{command} {option}")), "{option} {command}");
        let changes_nothing = option == "--timings";
        assert_eq!(before == run(command.to_owned()), changes_nothing, "{option} {command}");
    }
}
