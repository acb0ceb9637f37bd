//! Labels at the lines themselves: one per group of lines, left out if every place overlaps something.

use super::canvas::{Rect, text_width_px};

/// Height of a label's letters, and its distance from lines: from its own group, and from others.
pub(crate) const SIZE_PX: f64 = 11.0;
const GAP_PX: f64 = 4.0;
const BERTH_PX: f64 = 4.5;
/// The distance of a label from the frame.
const MARGIN_PX: f64 = 2.0;

/// Spacing at which lines are probed; less than a label is high.
const PROBE_PX: f64 = 3.0;

/// The places of a label along a line, from its last point to its first, near which lines of areas meet.
const PLACES: [f64; 7] = [1.0, 0.875, 0.75, 0.5, 0.25, 0.125, 0.0];

/// A line in pixels. The first line of a group with room for it gets the label.
pub(crate) struct Track {
    /// Its label.
    pub label: String,
    /// Lines that share it share a label.
    pub group: usize,
    /// Its points.
    pub points: Vec<(f64, f64)>,
}

/// A label and its place.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Placed {
    pub text: String,
    pub group: usize,
    pub place: Rect,
}

/// The labels in letters of a size that find a place inside the frame.
pub(crate) fn place(tracks: &[Track], frame: Rect, size_px: f64) -> Vec<Placed> {
    let probes: Vec<(usize, Vec<(f64, f64)>)> =
        tracks.iter().map(|track| (track.group, probed(&track.points))).collect();
    let mut placed: Vec<Placed> = Vec::new();
    let mut seen: Vec<usize> = Vec::new();
    for track in tracks.iter().filter(|track| !track.label.is_empty()) {
        if seen.contains(&track.group) {
            continue;
        }
        seen.push(track.group);
        let free = |candidate: &Rect| {
            candidate.within(&frame.grown(-MARGIN_PX))
                && placed.iter().all(|other| !candidate.overlaps(&other.place.grown(GAP_PX / 2.0)))
                && probes.iter().all(|(group, points)| {
                    let berth = if *group == track.group { 1.0 } else { BERTH_PX };
                    let kept_clear = candidate.grown(berth);
                    !points.iter().any(|point| kept_clear.holds(*point))
                })
        };
        let of_group = || probes.iter().filter(|(group, _)| *group == track.group);
        let found = PLACES.iter().find_map(|&along| {
            of_group()
                .flat_map(|(_, line)| around(line, along, &track.label, frame.top, size_px))
                .find(|candidate| free(candidate))
        });
        placed.extend(found.map(|place| Placed { text: track.label.clone(), group: track.group, place }));
    }
    placed
}

/// The places around a point of a line: beside it on either side, above and below. Along the upper edge of the frame, lines
/// of full contact lie on each other.
fn around(line: &[(f64, f64)], along: f64, label: &str, top: f64, size_px: f64) -> Vec<Rect> {
    let Some(last) = line.len().checked_sub(1) else { return Vec::new() };
    let (x, y) = line[(along * last as f64).round() as usize];
    if y < top + 0.5 {
        return Vec::new();
    }
    let (width, half) = (text_width_px(label, size_px), size_px / 2.0);
    let at = |left: f64, top: f64| Rect { left, top, right: left + width, bottom: top + size_px };
    let (above, below) = (y - GAP_PX - size_px, y + GAP_PX);
    vec![
        at(x - GAP_PX - width, y - half),
        at(x + GAP_PX, y - half),
        at(x, below),
        at(x - width, below),
        at(x, below + BERTH_PX),
        at(x - width, below + BERTH_PX),
        at(x, above),
        at(x - width, above),
        at(x, above - BERTH_PX),
        at(x - width, above - BERTH_PX),
        at(x - width / 2.0, above - GAP_PX),
        at(x - width / 2.0, below + GAP_PX),
        at(x + GAP_PX, above),
        at(x - GAP_PX - width, above),
        at(x + GAP_PX, below),
        at(x - GAP_PX - width, below),
    ]
}

/// Points along a line, close to each other.
fn probed(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut probes: Vec<(f64, f64)> = points.first().copied().into_iter().collect();
    for pair in points.windows(2) {
        let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
        let steps = ((x1 - x0).hypot(y1 - y0) / PROBE_PX).ceil().max(1.0);
        probes.extend((1..=steps as usize).map(|i| {
            let along = i as f64 / steps;
            (x0 + along * (x1 - x0), y0 + along * (y1 - y0))
        }));
    }
    probes
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Rect = Rect { left: 0.0, top: 0.0, right: 400.0, bottom: 300.0 };

    fn level(group: usize, y: f64) -> Track {
        let label = ["first", "second", "third"][group].to_owned();
        Track { label, group, points: vec![(350.0, y), (60.0, y)] }
    }

    #[test]
    fn lines_apart_are_labelled_beside_their_ends() {
        let placed = place(&[level(0, 50.0), level(1, 150.0)], FRAME, SIZE_PX);
        assert_eq!(placed.iter().map(|label| label.text.as_str()).collect::<Vec<_>>(), ["first", "second"]);
        for (label, y) in placed.iter().zip([50.0, 150.0]) {
            assert!(label.place.right < 60.0 && label.place.top < y && label.place.bottom > y, "{label:?}");
        }
    }

    #[test]
    fn labels_keep_clear_of_each_other_and_of_other_lines() {
        let tracks = [level(0, 50.0), level(1, 58.0), level(2, 66.0)];
        let placed = place(&tracks, FRAME, SIZE_PX);
        for (i, label) in placed.iter().enumerate() {
            assert!(placed[..i].iter().all(|other| !label.place.overlaps(&other.place)));
            let others = tracks.iter().filter(|track| track.group != label.group);
            assert!(others.flat_map(|track| probed(&track.points)).all(|point| !label.place.holds(point)));
        }
        assert!(
            !placed.iter().any(|label| label.text == "second"),
            "no room between its neighbours: {placed:?}"
        );
    }

    #[test]
    fn one_label_stands_for_every_line_of_a_group() {
        assert_eq!(place(&[level(0, 50.0), level(0, 100.0)], FRAME, SIZE_PX).len(), 1);
    }

    #[test]
    fn a_point_alone_is_labelled_inside_the_frame() {
        let alone = Track { label: "first".to_owned(), group: 0, points: vec![(1.0, 1.0)] };
        let placed = place(&[alone], FRAME, SIZE_PX);
        assert!(placed[0].place.within(&FRAME), "{placed:?}");
    }
}
