//! What to cite with an answer.

use crate::drawn_scenes::Answered;

/// What each publication is used for, by its first author.
fn cited(text: &str) -> Vec<(String, String)> {
    let found = Answered::new(text).conclusions().publications;
    let author = |publication: &str| publication.split([' ', ',']).next().unwrap().to_owned();
    found.into_iter().map(|one| (one.used_for, author(one.publication))).collect()
}

fn has(found: &[(String, String)], used_for: &str, author: &str) -> bool {
    found.iter().any(|(use_of, of)| use_of == used_for && of == author)
}

const SURFACE: &str = "surface = { psd = \"plain.csv\" }\n";
const LOADS: &str = "[loads]\npressures = [\"10 MPa\"]\n";

#[test]
fn elements_are_cited_if_they_pressed_and_each_publication_once() {
    let steel = "material = { youngs_modulus = \"200 GPa\", poisson_ratio = 0.3 }\n";
    let curves = "[[curve]]\nmodel = \"persson\"\n[[curve]]\nname = \"again\"\nmodel = \"persson\"\n";
    let of = |judge: &str| cited(&format!("{SURFACE}{steel}{LOADS}{curves}[judge]\n{judge}\n"));
    let models = [("persson".to_owned(), "Persson".to_owned())];
    assert_eq!(of("off = true"), models);
    let judged = of("grid = 32\nrealisations = 2");
    assert_eq!(judged[0], ("boundary elements".to_owned(), "Westergaard".to_owned()));
    assert_eq!(judged[1..], models);
}

#[test]
fn yielding_growth_and_what_is_asked_are_cited() {
    let soft = "material = { youngs_modulus = \"70 GPa\", poisson_ratio = 0.33, indentation_hardness = \"1 GPa\", strain_gradient_length = \"1 um\" }\n";
    let plastic = "[[curve]]\nmodel = \"persson-plastic\"\nstrain_gradient = false\n";
    let judge = "[judge]\ngrid = 32\nrealisations = 2\n";
    let constant = cited(&format!("{SURFACE}{soft}{LOADS}{plastic}{judge}[seal]\n"));
    assert!(has(&constant, "boundary elements that yield", "Almqvist"), "{constant:?}");
    assert!(has(&constant, "pressure that makes it tight", "Persson"), "{constant:?}");
    let grows = "strength that grows at small scales";
    assert!(!has(&constant, grows, "Nix"), "{constant:?}");
    let by_law = "[[curve]]\nmodel = \"persson-plastic\"\nhardness_law = \"nix-gao\"\n";
    let by_gradient = "[[curve]]\nmodel = \"elastic-plastic\"\nstrain_gradient = true\n";
    let by_power = by_law.replace("nix-gao", "power:0.3");
    let powers = cited(&format!("{SURFACE}{soft}{LOADS}{by_power}[judge]\noff = true\n"));
    assert!(!has(&powers, grows, "Nix"), "{powers:?}");
    for growing in [by_law, by_gradient] {
        let found = cited(&format!("{SURFACE}{soft}{LOADS}{growing}[judge]\noff = true\n"));
        assert!(has(&found, grows, "Nix"), "{found:?}");
    }
}
