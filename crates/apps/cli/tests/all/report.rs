//! The report of a scene: whole, self-contained, and about that scene alone.

use std::collections::HashSet;

use crate::support::Bench;
use roxmltree::{Document, ParsingOptions};

const STEEL: &str = r#"
title = "Bearing ring, <ground> & honed"
[surface]
psd = "ring.csv"
[material]
youngs_modulus = "210 GPa"
poisson_ratio = 0.3
yield_strength = "1 GPa"
[loads]
pressures = ["5 MPa", "1e-2 H"]
[[curve]]
model = "elastic"
[[curve]]
model = "elastic-plastic"
[[curve]]
model = "ep-sphere"
[[figure]]
name = "spectrum"
shows = "psd"
[[figure]]
name = "figure-2"
shows = "moments"
title = "Moments of the ring"
[[figure]]
name = "area"
shows = "area"
[[figure]]
name = "loads"
shows = "area-against-load"
curves = ["ep-sphere"]
loads = { from = "1 MPa", to = "1 GPa", points = 5 }
cutoff_multiples = [1, 10]
"#;

/// A spectrum of a user's own, falling over five decades.
fn ring() -> String {
    let row = |i: i32| {
        let wavelength_m = 1e-3 * 10f64.powf(-f64::from(i) / 6.0);
        format!("{wavelength_m:e},{:e}\n", 3e-18 / (1.0 + (1e-4 / wavelength_m).powf(2.6)))
    };
    let rows: String = (0..30).map(row).collect();
    format!("# Ground steel ring, CC BY 4.0, doi:10.1234/ring.5\nwavelength_m,C1D_m3\n{rows}")
}

fn report(bench: &Bench, scene: &str) -> String {
    bench.write("ring.csv", ring());
    bench.write("s.toml", scene).run(&["run", "s.toml"]).ok();
    bench.read("s-results/report.html")
}

/// The page as a tree; it is written so that XML's stricter rules hold as well.
fn parsed(page: &str) -> Document<'_> {
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    Document::parse_with_options(page, options).expect("well-formed")
}

#[test]
fn a_scene_of_one_s_own_has_a_report_with_every_figure_and_section() {
    let bench = Bench::new();
    let page = report(&bench, STEEL);
    let tree = parsed(&page);
    assert!(page.len() < 2_000_000, "{}", page.len());
    let count = |name: &str| tree.descendants().filter(|node| node.has_tag_name(name)).count();
    assert_eq!((count("svg"), count("figcaption"), count("h1")), (9, 6, 1));
    let sections: Vec<&str> = tree
        .descendants()
        .filter(|node| node.has_tag_name("details"))
        .filter_map(|node| node.attribute("id"))
        .collect();
    assert_eq!(
        sections,
        [
            "decades",
            "surfaces",
            "measure-next",
            "all-numbers",
            "verdict",
            "key-numbers",
            "disagreements",
            "meaning",
            "figures",
            "sensitivities",
            "validity",
            "choices",
            "provenance"
        ]
    );
    let text: String = tree.descendants().filter_map(|node| node.text()).collect();
    for said in [
        "Bearing ring, <ground> & honed",
        "5 MPa = 1.67 × 10⁻³ H",
        "Figure 2. Moments of the ring.",
        "CC BY 4.0",
    ] {
        assert!(text.contains(said), "{said}");
    }
}

#[test]
fn a_report_asks_the_network_for_nothing_and_knows_only_its_scene() {
    let bench = Bench::new();
    let page = report(&bench, STEEL);
    assert!(!page.to_lowercase().contains("uncd") && !page.contains("@import") && !page.contains("url(h"));
    let tree = parsed(&page);
    for node in tree.descendants().filter(roxmltree::Node::is_element) {
        let name = node.tag_name().name();
        assert!(!["script", "link", "img", "iframe", "object"].contains(&name), "{name}");
        let is_inside = |value: &str| value.starts_with("data:image/png;base64,");
        let linked = |value: &str| value.contains("//") && !is_inside(value);
        for attribute in node.attributes().filter(|attribute| linked(attribute.value())) {
            assert_eq!((name, attribute.value()), ("a", "https://doi.org/10.1234/ring.5"));
        }
    }
}

#[test]
fn words_of_a_user_never_become_elements_of_the_page() {
    let hostile = r#"</title><script>alert(1)</script>" onload='x' & \u0001\u0007"#;
    let bench = Bench::new();
    let file = "<img src=x onerror='y'>&.csv";
    let scene = STEEL
        .split("[[figure]]\nname = \"figure-2\"")
        .next()
        .unwrap()
        .replace("Bearing ring, <ground> & honed", &hostile.replace('"', "\\\""))
        .replace("ring.csv", file);
    bench.write(file, ring().replace("# Ground", "# <script>alert(2)</script>\u{1} Ground"));
    let scene = scene + &format!("title = \"{}\"\n", hostile.replace('"', "\\\""));
    bench.write("s.toml", scene).run(&["run", "s.toml"]).ok();
    let page = bench.read("s-results/report.html");
    let tree = parsed(&page);
    for node in tree.descendants().filter(roxmltree::Node::is_element) {
        let name = node.tag_name().name();
        assert!(!["script", "img"].contains(&name), "{name}");
        assert!(node.attributes().all(|attribute| !attribute.name().starts_with("on")));
    }
    let text: String = tree.descendants().filter_map(|node| node.text()).collect();
    assert!(text.contains("<script>alert(1)</script>") && text.contains("<script>alert(2)</script>"));
}

/// The words outside closed details, for one load and without words for screen readers alone.
fn visible_words(page: &str) -> usize {
    let tree = parsed(page);
    let is_hidden = |node: &roxmltree::Node<'_, '_>| {
        let class = node.attribute("class").unwrap_or_default();
        ["style", "head", "title"].contains(&node.tag_name().name())
            || class == "reason"
            || (node.parent().is_some_and(|parent| parent.has_tag_name("details"))
                && !node.has_tag_name("summary"))
    };
    let is_seen =
        |node: &roxmltree::Node<'_, '_>| node.is_text() && !node.ancestors().any(|of| is_hidden(&of));
    tree.descendants()
        .filter(is_seen)
        .filter_map(|node| node.text())
        .map(|text| text.split_whitespace().count())
        .sum()
}

#[test]
fn a_report_is_short_until_it_is_unfolded() {
    let bench = Bench::new();
    let options = "report builtin:uncd-measured --material diamond --yield-strength 1.8GPa --strain-gradient-length 5um \
                   --pressure 5.4MPa --pressure 54MPa --out r";
    bench.run(&options.split(' ').collect::<Vec<_>>()).ok();
    let page = bench.read("r/report.html");
    let words = visible_words(&page);
    assert!(words < 900 && page.len() < 300_000, "{words} words, {} bytes", page.len());
}

#[test]
fn a_report_can_be_read_without_seeing_it() {
    let bench = Bench::new();
    let page = report(&bench, STEEL);
    let tree = parsed(&page);
    assert_eq!(tree.root_element().attribute("lang"), Some("en"));
    let mut ids = HashSet::new();
    let mut level = 0;
    for node in tree.descendants().filter(roxmltree::Node::is_element) {
        assert!(node.attribute("id").is_none_or(|id| ids.insert(id)), "{:?} twice", node.attribute("id"));
        match node.tag_name().name() {
            "svg" => assert!(node.attribute("role") == Some("img") && node.has_attribute("aria-label")),
            "th" => assert!(node.has_attribute("scope")),
            name @ ("h1" | "h2" | "h3") => {
                let depth = name[1..].parse::<usize>().unwrap();
                assert!(depth <= level + 1, "{name} after h{level}");
                level = depth;
            }
            _ => {}
        }
    }
    let links = tree.descendants().filter_map(|node| node.attribute("href"));
    assert!(links.filter_map(|link| link.strip_prefix('#')).all(|id| ids.contains(id)));
}

#[test]
fn scenes_of_little_have_reports_too() {
    let bench = Bench::new();
    let alone = "title = \"t\"\n[surface]\npsd = \"ring.csv\"\n[[figure]]\nname = \"p\"\nshows = \"psd\"\n";
    let page = report(&bench, alone);
    assert!(parsed(&page).descendants().any(|node| node.has_tag_name("svg")));
    assert!(!page.contains("id=\"decades\""));
    let elastic = STEEL.split("[[curve]]").next().unwrap().replace("yield_strength = \"1 GPa\"\n", "");
    let elastic = elastic.replace(", \"1e-2 H\"", "") + "[[curve]]\nmodel = \"elastic\"\n";
    let page = report(&bench, &elastic);
    parsed(&page);
    assert!(page.contains("5 MPa") && !page.contains(" H<"), "no unit H without a strength");
}

#[test]
fn no_report_is_written_where_none_is_wanted() {
    let bench = Bench::new();
    bench.write("ring.csv", ring()).write("s.toml", STEEL).run(&["run", "s.toml", "--no-report"]).ok();
    assert!(!bench.path("s-results/report.html").exists());
}

#[test]
fn a_report_can_be_made_again_from_itself() {
    let bench = Bench::new();
    let scene = STEEL
        .replace("[loads]", "[counterface]\nyoungs_modulus = \"380 GPa\"\npoisson_ratio = 0.22\n[loads]");
    let page = report(&bench, &scene);
    let tree = parsed(&page);
    let text = |name: &str| -> Vec<&str> {
        let nodes = tree.descendants().filter(|node| node.has_tag_name(name));
        nodes.flat_map(|node| node.descendants()).filter_map(|node| node.text()).collect()
    };
    assert!(text("pre").iter().any(|typed| *typed == scene.trim_end()), "{:?}", text("pre"));
    let section: String = text("details").concat();
    for said in
        ["380 GPa", "0.22", concat!("truearea ", env!("CARGO_PKG_VERSION")), "truearea run s.toml", " UTC"]
    {
        assert!(section.contains(said), "{said}");
    }
    let hash =
        text("code").into_iter().find(|code| code.len() == 64).expect("the hash of the spectrum's file");
    assert!(hash.bytes().all(|digit| digit.is_ascii_hexdigit()));
    bench.write("ring.csv", ring().replace("ground", "Ground") + "\n");
    bench.run(&["run", "s.toml"]).ok();
    assert!(!bench.read("s-results/report.html").contains(hash), "another file, another hash");
}

#[test]
fn a_report_opens_with_a_figure_of_the_answer_and_shows_the_spectrum_always() {
    let bench = Bench::new();
    let page = report(&bench, STEEL.split("[[figure]]").next().unwrap());
    let tree = parsed(&page);
    let captions: Vec<String> = tree
        .descendants()
        .filter(|node| node.has_tag_name("figcaption"))
        .map(|node| node.descendants().filter_map(|node| node.text()).collect())
        .collect();
    let [of_contact, ..] = &captions[..] else { panic!() };
    assert!(of_contact.starts_with("A surface with the waves down to"), "{captions:?}");
    // Each load has a caption of the contact, and figures come after.
    let [area, spectrum] = &captions[2..] else { panic!("{captions:?}") };
    assert!(area.starts_with("Contact area / nominal area"), "{captions:?}");
    assert!(spectrum.starts_with("Power spectral density"), "{captions:?}");
    let bars = tree.descendants().filter(|node| node.attribute("class") == Some("range"));
    let heights: Vec<&str> = bars.filter_map(|node| node.attribute("height")).collect();
    assert_eq!(heights, ["12"; 2], "a bar of each load");
    let curve = page.find("<svg class=\"area\"").expect("the first screen has the curve");
    assert!(curve < page.find("<details").unwrap());
    let only_loads = STEEL.replace("shows = \"area\"\n", "shows = \"aspect-ratio\"\n");
    let page = report(&bench, &only_loads);
    assert_eq!(page.matches("<figcaption>").count(), 5, "the answer's figure besides the scene's own four");
}

#[test]
fn answers_of_surfaces_that_stick_say_that_they_leave_adhesion_out() {
    let lines = |work: &str| {
        let bench = Bench::new();
        let scene = format!(
            "surface = {{ psd = \"ring.csv\" }}\nmaterial = {{ youngs_modulus = \"5 MPa\", poisson_ratio = 0.49 }}\n[loads]\npressures = [\"10 \
             kPa\"]\n[[curve]]\nmodel = \"persson\"\n[judge]\noff = true\n[seal]\n[interface]\nwork_of_adhesion = \"{work}\"\nrange_of_attraction = \
             \"10 nm\"\n"
        );
        bench.write("ring.csv", ring());
        bench.write("s.toml", scene);
        let said = bench.run(&["run", "s.toml"]).ok();
        let page = bench.read("s-results/report.html");
        let count = |text: &str| text.matches("without adhesion").count();
        (count(&said), count(&page))
    };
    let (said, in_page) = lines("100 J/m^2");
    assert!(said > 0 && in_page > 0, "{said} {in_page}");
    assert_eq!(lines("0.001 mJ/m^2"), (0, 0));
}
