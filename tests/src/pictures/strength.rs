//! Strength that grows as the deformation gets shallower.

use asperity::NixGao;

use super::{Picture, along, dashed, geometric, line, picture};

/// Strength against depth for several strain-gradient lengths, and with a cap.
pub(super) fn strength() -> Picture {
    let depths_m = geometric([1e-9, 1e-3], 61);
    let of_length = |length_m: f64| {
        let strength = NixGao::constant(1.8e9).and_then(|s| s.with_strain_gradient(length_m));
        strength.expect("a strength within its bounds")
    };
    let mut series = Vec::new();
    for (colour, (length_m, name)) in
        [(0.5e-6, "h* = 0.5 µm"), (5e-6, "h* = 5 µm"), (50e-6, "h* = 50 µm")].into_iter().enumerate()
    {
        let points = along(&depths_m, |depth_m| of_length(length_m).at_depth_pa(depth_m));
        series.push(dashed("no cap", 0, line(name, colour, points)));
    }
    let capped = of_length(5e-6).with_cap(46.3e9).expect("a cap above the strength");
    let points = along(&depths_m, |depth_m| capped.at_depth_pa(depth_m));
    series.push(dashed("cap at E/10", 1, line("h* = 5 µm", 1, points)));
    picture(
        "strength",
        ["Strength against depth of deformation", "Nix & Gao, S_0 = 1.8 GPa"],
        ["depth of deformation h_p (m)", "yield strength S_y (Pa)"],
        series,
    )
}
