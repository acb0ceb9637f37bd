//! The caution on adhesion.

use conclusions::Trust;
use study::interface::{Quantity, Slot};
use units::RemarkCode;

use crate::drawn_scenes::Answered;

/// The caution follows the indicator: Pastewka & Robbins' where a range is given, or else Fuller & Tabor's.
#[test]
fn areas_of_sticky_surfaces_carry_a_caution() {
    let sticky = |interface: &str| {
        let answered = Answered::new(&format!(
            "surface = {{ psd = \"plain.csv\" }}\nmaterial = {{ youngs_modulus = \"5 MPa\", poisson_ratio = 0.49 }}\n[loads]\npressures = \
             [\"1 kPa\"]\n[[curve]]\nmodel = \"persson\"\n[judge]\noff = true\n[interface]\n{interface}"
        ));
        let states = answered.scene.interface_states(&answered.results).unwrap();
        let value = |quantity| states.value(Slot { quantity, load: None, curve: None }).unwrap();
        let indicators = [value(Quantity::PastewkaRobbins), value(Quantity::FullerTabor)];
        let conclusions = answered.conclusions();
        let is_sticky = |caution: &&units::Remark| caution.code.name() == "sticky";
        let found = conclusions.cautions.iter().find(is_sticky).cloned();
        assert!(found.is_none() || conclusions.trust <= Trust::Poor);
        (found.map(|found| (found.code, found.number("left_side").or(found.number("theta")))), indicators)
    };
    let (found, [left_side, _]) =
        sticky("work_of_adhesion = \"100 J/m^2\"\nrange_of_attraction = \"10 nm\"\n");
    assert_eq!(found, Some((RemarkCode::StickyByPastewka, left_side)));
    let (found, [_, theta]) = sticky("work_of_adhesion = \"100 J/m^2\"\n");
    assert_eq!(found, Some((RemarkCode::StickyByFuller, theta)));
    for weak in [
        "work_of_adhesion = \"0.001 mJ/m^2\"\nrange_of_attraction = \"10 nm\"\n",
        "work_of_adhesion = \"0.001 mJ/m^2\"\n",
        "",
    ] {
        assert_eq!(sticky(weak).0, None, "{weak}");
    }
}
