//! Remarks that answers share.

use findings::doubts;
use persson::Roughness;
use persson::corrections::Correction;
use persson::separation::LightLoads;
use spectrum::ProfilePsd;
use study::material::Material;
use study::models::{Choice, ModelEntry};
use study::plan::scales_per_decade;
use units::{Remark, RemarkCode};

/// Above so many rms heights only the highest summits of a finite sample touch.
pub(crate) const FEW_TOUCH: f64 = 3.0;

/// Makes the remark on number and range of the scales of a spectrum.
#[must_use]
pub fn remark_on_sampling(psd: &ProfilePsd) -> Remark {
    let remark = Remark::new(RemarkCode::Sampling)
        .on("scales_per_decade")
        .with("scales", psd.len())
        .with("longest_m", psd.longest_wavelength_m())
        .with("shortest_m", psd.shortest_wavelength_m());
    match scales_per_decade(psd) {
        Some(per_decade) => remark.with("per_decade", per_decade),
        None => remark,
    }
}

/// The remark on how far places differ, by the real areas of each.
pub(crate) fn remark_on_places(areas: &[f64]) -> Remark {
    let [_, _, ..] = areas else { return Remark::new(RemarkCode::OnePlace) };
    let count = areas.len() as f64;
    let mean = areas.iter().sum::<f64>() / count;
    let squares = areas.iter().map(|area| (area - mean).powi(2)).sum::<f64>();
    Remark::new(RemarkCode::Places).with("scatter", (squares / (count - 1.0)).sqrt() / mean)
}

/// The remark on asperities that yield at H/3 because no strength is given (Persson's theory takes H itself), or on a layer, which
/// no model but that theory takes.
pub(crate) fn remark_on_model(material: &Material, model: &ModelEntry, psd: &ProfilePsd) -> Option<Remark> {
    if material.pair.layer().is_some() {
        return doubts::of_layer(material, psd);
    }
    let takes_strength = model.has(Choice::Strength) && !model.framework.takes_hardness();
    let strength_pa = material.assumed_yield_strength_pa().filter(|_| takes_strength)?;
    let remark = Remark::new(RemarkCode::AssumedStrength).on("yield_strength");
    Some(remark.with("yield_strength_pa", strength_pa))
}

/// Remarks on the range that a corrected form was fitted in, and on cutoffs outside.
pub(crate) fn remarks_on_correction(correction: Correction, roughness: &Roughness) -> Vec<Remark> {
    let [least, most] = Correction::FITTED_ALPHA;
    let places = roughness.places();
    let fitted = Remark::new(RemarkCode::FittedRange).with("correction", correction.to_string());
    let fitted = fitted.with("least", least).with("most", most);
    let outside: Vec<_> =
        places.iter().skip(1).filter(|place| !(least..=most).contains(&place.alpha)).collect();
    let outside_fit = outside.first().zip(outside.last()).map(|(first, last)| {
        Remark::new(RemarkCode::OutsideFit)
            .with("cutoffs", outside.len())
            .with("all", places.len() - 1)
            .with("first_m", first.wavelength_m)
            .with("last_m", last.wavelength_m)
            .with("first_alpha", first.alpha)
            .with("last_alpha", last.alpha)
    });
    std::iter::once(fitted).chain(outside_fit).collect()
}

/// Remarks on spectra and loads for which mean gap and stiffness mean little: a spectrum that begins inside its fractal range, and
/// loads (the least of them in Pa) under which few asperities touch.
#[must_use]
pub fn remarks_on_separation(
    light: &LightLoads,
    roughness: &Roughness,
    rms_height_m: f64,
    least_pa: f64,
) -> Vec<Remark> {
    let no_rolloff = light.lacks_roll_off(roughness).then(|| {
        Remark::new(RemarkCode::NoRollOff).with("share_of_first_decade", light.share_of_first_decade)
    });
    let limit_pa = light.pressure_at_gap_pa(FEW_TOUCH, rms_height_m);
    let few_touch = (least_pa < limit_pa).then(|| {
        Remark::new(RemarkCode::FewTouchBelow).with("limit_pa", limit_pa).with("few_touch", FEW_TOUCH)
    });
    no_rolloff.into_iter().chain(few_touch).collect()
}
