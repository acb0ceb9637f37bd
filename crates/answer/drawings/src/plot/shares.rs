//! Bars of the share of each decade of wavelengths, over a logarithmic axis.

use kuva::TickFormat;
use kuva::render::color::Color;
use kuva::render::layout::{ComputedLayout, Layout};
use kuva::render::render::{Primitive, Scene, TextAnchor};
use uncertainty::DecadeOfVariance;

use super::canvas::{self, Stroke};
use super::decades::{Decades, lengths};
use super::ruler::Ruler;
use super::style::{NEUTRAL, colour, tint};
use super::{WIDE_PX, frame, page_element, ticks_below, with_room_at_the_end};

/// The height of the picture, lower than that of a figure of curves.
const LOW_PX: f64 = 230.0;
const LABEL_PX: f64 = 11.0;
/// Between labelled ticks, in percent.
const STEP: f64 = 20.0;

/// Draws shares of decades as an element of a page, like [`element`](super::element). `None` if there is nothing to
/// draw.
pub fn shares_of_decades(
    decades: &[DecadeOfVariance],
    y_label: &str,
    id: &str,
    words: &str,
) -> Option<String> {
    let bars: Vec<&DecadeOfVariance> = decades.iter().filter(|decade| is_drawable(decade)).collect();
    if bars.is_empty() {
        return None;
    }
    let x = Decades::around(bars.iter().flat_map(|bar| [bar.longest_m, bar.shortest_m]));
    let highest = bars.iter().map(|bar| percent(bar)).fold(STEP, f64::max);
    let layout = Layout::new((0.0, 1.0), (0.0, 1.0))
        .with_height(LOW_PX)
        .with_width(WIDE_PX)
        .with_x_axis_min(x.first)
        .with_x_axis_max(x.last)
        .with_x_tick_step(x.step)
        .with_x_tick_format(lengths())
        .with_y_axis_min(0.0)
        .with_y_axis_max(((highest + 0.5 * STEP) / STEP).ceil() * STEP)
        .with_y_tick_step(STEP)
        .with_y_tick_format(TickFormat::Fixed(0))
        .with_box_axes()
        .with_label_size(13)
        .with_x_label("wavelength".to_owned())
        .with_y_label(y_label.to_owned());
    let layout = with_room_at_the_end(layout, &Ruler::Decades(x));
    let computed = ComputedLayout::from_layout(&layout);
    let mut scene = canvas::with_axes(layout, id, |computed| {
        let stroke = Stroke { colour: "black", width_px: 0.7, dash: None };
        vec![canvas::line(computed, &[(x.first, 0.0), (x.last, 0.0)], stroke)]
    });
    ticks_below(&mut scene, &computed, frame(&computed), &Ruler::Decades(x));
    for bar in bars {
        draw(&mut scene, &computed, bar);
    }
    Some(page_element(&scene, words))
}

/// True for a decade with positive wavelengths and a finite share.
fn is_drawable(decade: &DecadeOfVariance) -> bool {
    decade.shortest_m > 0.0 && decade.longest_m > decade.shortest_m && decade.share.is_finite()
}

/// The share in percent; a share below 0 is within its own error.
fn percent(decade: &DecadeOfVariance) -> f64 {
    100.0 * decade.share.clamp(0.0, 1.0)
}

fn draw(scene: &mut Scene, computed: &ComputedLayout, decade: &DecadeOfVariance) {
    let [left, right] = [decade.shortest_m, decade.longest_m].map(|edge_m| computed.map_x(edge_m.log10()));
    let percent = percent(decade);
    let [top, ground] = [percent, 0.0].map(|height| computed.map_y(height));
    scene.add(Primitive::Rect {
        x: left,
        y: top,
        width: right - left,
        height: ground - top,
        fill: Color::from(tint(0).as_str()),
        stroke: Some(Color::from(colour(0).as_str())),
        stroke_width: Some(1.0),
        opacity: None,
    });
    scene.add(Primitive::Text {
        x: 0.5 * (left + right),
        y: top - 0.4 * LABEL_PX,
        content: format!("{percent:.0} %"),
        size: LABEL_PX as u32,
        anchor: TextAnchor::Middle,
        rotate: None,
        bold: false,
        color: Some(Color::from(colour(NEUTRAL).as_str())),
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_decade_with_a_share_has_a_bar_with_its_number() {
        let decade =
            |longest_m: f64, share| DecadeOfVariance { longest_m, shortest_m: longest_m / 10.0, share };
        let decades = [decade(1e-5, 0.1), decade(1e-6, 0.914), decade(1e-7, -0.01), decade(1e-8, f64::NAN)];
        let drawn = shares_of_decades(&decades, "share (%)", "shares", "shares").unwrap();
        for label in [">10 %<", ">91 %<", ">0 %<"] {
            assert_eq!(drawn.matches(label).count(), 1, "{label}: {drawn}");
        }
        assert!(shares_of_decades(&decades[3..], "", "", "").is_none());
    }
}
