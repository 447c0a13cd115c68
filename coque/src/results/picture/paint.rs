//! The drawing itself: projection, colours and SVG elements.

use std::fmt::Write;

/// Size of the picture in pixels; the colour bar takes the right side, titles the top, the axes of space the bottom.
pub(super) const WIDTH: f64 = 860.0;
pub(super) const HEIGHT: f64 = 620.0;
const LEFT: f64 = 30.0;
const RIGHT: f64 = 160.0;
const TOP: f64 = 64.0;
const BOTTOM: f64 = 78.0;
/// Height of letters; of a title at most.
const LETTERS: f64 = 15.0;
const TITLE: f64 = 18.0;
/// Width of a letter in its height, about.
const LETTER_WIDTH: f64 = 0.53;
/// Share of its length that an axis of space must show to be drawn.
const SHOWN: f64 = 0.1;
/// Stripes of the colour bar.
const STRIPES: usize = 64;

/// Where the viewer stands, far away.
pub(super) struct Camera {
    /// To the right, up, and towards the viewer.
    axes: [[f64; 3]; 3],
}

impl Camera {
    pub fn new([azimuth, height]: [f64; 2]) -> Self {
        let (sa, ca) = libm::sincos(azimuth.to_radians());
        let (sh, ch) = libm::sincos(height.to_radians());
        Self { axes: [[-sa, ca, 0.0], [-ca * sh, -sa * sh, ch], [ca * ch, sa * ch, sh]] }
    }

    /// Right, up and nearness of a point \[L\].
    pub fn see(&self, x: &[f64; 3]) -> [f64; 3] {
        self.axes.map(|axis| axis[0] * x[0] + axis[1] * x[1] + axis[2] * x[2])
    }
}

/// From dark blue over green to yellow, even to the eye: six colours of the map viridis.
const MAP: [[f64; 3]; 6] = [
    [68.0, 1.0, 84.0],
    [65.0, 68.0, 135.0],
    [42.0, 120.0, 142.0],
    [34.0, 168.0, 132.0],
    [122.0, 209.0, 81.0],
    [253.0, 231.0, 37.0],
];

/// Colour of a value between two others; grey for what is no number.
pub(super) fn colour(value: f64, [low, high]: [f64; 2]) -> String {
    if !value.is_finite() {
        return "#bbbbbb".into();
    }
    let share = if high > low { ((value - low) / (high - low)).clamp(0.0, 1.0) } else { 0.5 };
    let at = share * (MAP.len() - 1) as f64;
    let first = (at as usize).min(MAP.len() - 2);
    let mixed =
        |i: usize| (MAP[first][i] + (at - first as f64) * (MAP[first + 1][i] - MAP[first][i])).round() as u8;
    format!("#{:02x}{:02x}{:02x}", mixed(0), mixed(1), mixed(2))
}

/// An SVG under way. Writing into a `String` cannot fail, so that results of `write!` are dropped.
pub(super) struct Canvas {
    svg: String,
    /// Pixels a unit of length, and the middle of what is drawn.
    scale: f64,
    middle: [f64; 2],
}

impl Canvas {
    /// A canvas for what lies within bounds to the right and up \[L\].
    pub fn showing(bounds: &[[f64; 2]; 2]) -> Self {
        let [wide, high] = bounds.map(|[low, high]| if high > low { high - low } else { 0.0 });
        let fit = ((WIDTH - LEFT - RIGHT) / wide).min((HEIGHT - TOP - BOTTOM) / high);
        let scale = if fit.is_finite() && fit > 0.0 { fit } else { 1.0 };
        let middle = bounds.map(|[low, high]| if high >= low { 0.5 * (low + high) } else { 0.0 });
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{HEIGHT}\" \
             viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"sans-serif\" font-size=\"{LETTERS}\">\n\
             <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
        );
        Self { svg, scale, middle }
    }

    pub fn end(mut self) -> String {
        self.svg += "</svg>\n";
        self.svg
    }

    fn place(&self, point: &[f64; 3]) -> [f64; 2] {
        [
            0.5 * (LEFT + WIDTH - RIGHT) + self.scale * (point[0] - self.middle[0]),
            0.5 * (TOP + HEIGHT - BOTTOM) - self.scale * (point[1] - self.middle[1]),
        ]
    }

    /// The title, and smaller words below it; a long one has smaller letters.
    pub fn titles(&mut self, title: &str, below: &str) {
        let fitting = |text: &str, most: f64| {
            let widest = (WIDTH - 2.0 * LEFT) / (LETTER_WIDTH * text.chars().count().max(1) as f64);
            most.min(widest)
        };
        for (y, text, most) in [(28.0, title, TITLE), (51.0, below, LETTERS)] {
            let _ = write!(self.svg, "<g font-size=\"{:.1}\">", fitting(text, most));
            self.text([LEFT, y], "start", text);
            self.svg += "</g>\n";
        }
    }

    fn text(&mut self, [x, y]: [f64; 2], anchor: &str, text: &str) {
        let safe = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        let _ = writeln!(self.svg, "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{safe}</text>");
    }

    /// Pieces of the undeformed outline.
    pub fn dashed<'a>(&mut self, pieces: impl Iterator<Item = [&'a [f64; 3]; 2]>) {
        self.svg += "<g class=\"outline\" stroke=\"#888888\" stroke-dasharray=\"5 4\">\n";
        for ends in pieces {
            let [[x1, y1], [x2, y2]] = ends.map(|end| self.place(end));
            let _ = writeln!(self.svg, "<path d=\"M{x1:.1} {y1:.1}L{x2:.1} {y2:.1}\"/>");
        }
        self.svg += "</g>\n";
    }

    /// Cells with their colours, squares of a side \[L\] or dots where they are particles alone; lines of their own colours
    /// close the gaps between neighbours where edges are not wanted.
    pub fn cells<'a>(
        &mut self,
        cells: impl Iterator<Item = (Vec<&'a [f64; 3]>, Option<f64>, String)>,
        edged: bool,
    ) {
        let edge = if edged { " stroke=\"#333333\"" } else { "" };
        let _ =
            writeln!(self.svg, "<g class=\"cells\"{edge} stroke-width=\"0.4\" stroke-linejoin=\"round\">");
        for (corners, side, fill) in cells {
            let own = if edged { String::new() } else { format!(" stroke=\"{fill}\"") };
            if let [only] = corners[..] {
                let [x, y] = self.place(only);
                let Some(side) = side.map(|side| self.scale * side) else {
                    let _ =
                        writeln!(self.svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2\" fill=\"{fill}\"/>");
                    continue;
                };
                let [left, top] = [x, y].map(|middle| middle - 0.5 * side);
                // Squares of particles have no edges: they stand for no part of space.
                let own = format!(" stroke=\"{fill}\"");
                let _ = writeln!(
                    self.svg,
                    "<rect x=\"{left:.1}\" y=\"{top:.1}\" width=\"{side:.1}\" height=\"{side:.1}\" fill=\"{fill}\"{own}/>"
                );
                continue;
            }
            let places = corners.iter().map(|&corner| self.place(corner).map(|x| (10.0 * x).round() as i64));
            let _ = writeln!(self.svg, "<path fill=\"{fill}\"{own} d=\"{}\"/>", polygon(places));
        }
        self.svg += "</g>\n";
    }

    /// The three axes of space, in the lower left corner; one that points at the viewer is left out.
    pub fn axes(&mut self, camera: &Camera) {
        let [x0, y0] = [LEFT + 14.0, HEIGHT - 24.0];
        for (i, name) in ["x", "y", "z"].into_iter().enumerate() {
            let mut unit = [0.0; 3];
            unit[i] = 1.0;
            let [right, up, _] = camera.see(&unit);
            if libm::hypot(right, up) < SHOWN {
                continue;
            }
            let tip = |length: f64| [x0 + length * right, y0 - length * up];
            let [x, y] = tip(30.0);
            let _ = writeln!(
                self.svg,
                "<line x1=\"{x0:.1}\" y1=\"{y0:.1}\" x2=\"{x:.1}\" y2=\"{y:.1}\" stroke=\"black\"/>"
            );
            let [x, y] = tip(41.0);
            self.text([x, y + 5.0], "middle", name);
        }
    }

    /// The colour bar with round numbers beside it, name and unit above, the least and the greatest value below.
    pub fn bar(&mut self, bar: &Bar<'_>) {
        let [low, high] = bar.range;
        let (x, top) = (WIDTH - RIGHT + 30.0, TOP + 44.0);
        let tall = HEIGHT - BOTTOM - 24.0 - top;
        let stripe = tall / STRIPES as f64;
        for i in 0..STRIPES {
            let share = (i as f64 + 0.5) / STRIPES as f64;
            let y = top + tall - (i as f64 + 1.0) * stripe;
            let fill = colour(share, [0.0, 1.0]);
            // A little taller than its place, so that no gap shows between stripes.
            let _ = writeln!(
                self.svg,
                "<rect x=\"{x:.1}\" y=\"{y:.2}\" width=\"18\" height=\"{:.2}\" fill=\"{fill}\"/>",
                stripe + 0.4
            );
        }
        self.text([WIDTH - 12.0, top - 32.0], "end", bar.name);
        if let Some(unit) = bar.unit {
            self.text([WIDTH - 12.0, top - 14.0], "end", &format!("[{unit}]"));
        }
        if low > high {
            return; // no number at all
        }
        for value in marks(low, high) {
            let share = if high > low { (value - low) / (high - low) } else { 0.5 };
            let y = top + tall * (1.0 - share);
            let _ = writeln!(
                self.svg,
                "<line x1=\"{:.1}\" y1=\"{y:.1}\" x2=\"{:.1}\" y2=\"{y:.1}\" stroke=\"black\"/>",
                x + 18.0,
                x + 23.0
            );
            self.text([x + 27.0, y + 5.0], "start", &short(value));
        }
        let mut below = Vec::new();
        if bar.clipped {
            below.push("colours: 2–98 %".to_owned());
        }
        if let Some(all) = bar.all {
            // What is but rounding beside the other end is nothing.
            let size = all[0].abs().max(all[1].abs());
            let [least, greatest] = all.map(|end| if end.abs() <= 1e-9 * size { 0.0 } else { end });
            below.extend([format!("least {}", short(least)), format!("greatest {}", short(greatest))]);
        }
        for (i, words) in below.iter().enumerate() {
            self.text([x - 12.0, top + tall + 26.0 + 19.0 * i as f64], "start", words);
        }
    }
}

/// What a colour bar says.
pub(super) struct Bar<'a> {
    pub name: &'a str,
    pub unit: Option<&'a str>,
    /// Its ends.
    pub range: [f64; 2],
    /// Whether values lie beyond them that would leave all others one colour.
    pub clipped: bool,
    /// Least and greatest value, where they say something.
    pub all: Option<[f64; 2]>,
}

/// Round numbers between two others: steps of 1, 2 or 5 times a power of ten, four to ten of them; a lone number itself.
fn marks(low: f64, high: f64) -> Vec<f64> {
    let exact = (high - low) / 4.0;
    if !(exact.is_finite() && exact > 0.0) {
        return vec![low];
    }
    let power = 10.0_f64.powi(libm::log10(exact).floor() as i32);
    let step = [5.0, 2.0].into_iter().map(|digit| digit * power).find(|step| *step <= exact).unwrap_or(power);
    let slack = 1e-9 * step;
    let (first, last) = (((low - slack) / step).ceil() as i64, ((high + slack) / step).floor() as i64);
    (first..=last).map(|number| number as f64 * step).collect()
}

/// A closed path through places in tenths of a pixel, each counted from the one before: half as long as written out.
fn polygon(places: impl Iterator<Item = [i64; 2]>) -> String {
    let mut path = String::new();
    let mut last = [0; 2];
    for (i, place) in places.enumerate() {
        path += match i {
            0 => "M",
            1 => "l",
            _ => "",
        };
        for (axis, (to, from)) in place.iter().zip(last).enumerate() {
            let step = to - from;
            // A minus sign parts numbers too.
            if step >= 0 && (i > 1 || axis == 1) {
                path.push(' ');
            }
            let _ = write!(path, "{}", step as f64 / 10.0);
        }
        last = place;
    }
    path + "z"
}

/// Four digits, powers of ten where zero after zero would come.
fn short(x: f64) -> String {
    let rounded: f64 = format!("{x:.3e}").parse().unwrap_or(x);
    match rounded.abs() {
        0.0 => "0".into(),
        size if (1e-3..1e5).contains(&size) => format!("{rounded}"),
        _ => format!("{rounded:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_viewer_sees_right_up_and_near() {
        // From the x axis, level: y is to the right, z up, x near.
        let seen = Camera::new([0.0, 0.0]).see(&[1.0, 2.0, 3.0]);
        assert_eq!(seen, [2.0, 3.0, 1.0]);
        // From above, looking along −z with x near the viewer's feet.
        let seen = Camera::new([-90.0, 90.0]).see(&[1.0, 2.0, 3.0]);
        for (found, expected) in seen.iter().zip([1.0, 2.0, 3.0]) {
            assert!((found - expected).abs() < 1e-15, "{seen:?}");
        }
    }

    #[test]
    fn marks_are_round() {
        let near = |found: Vec<f64>, expected: &[f64]| {
            assert_eq!(found.len(), expected.len(), "{found:?}");
            assert!(found.iter().zip(expected).all(|(x, y)| (x - y).abs() <= 1e-12 * y.abs()), "{found:?}");
        };
        near(marks(2.0, 6.0), &[2.0, 3.0, 4.0, 5.0, 6.0]);
        near(marks(-513.0, 1606.0), &[-500.0, 0.0, 500.0, 1000.0, 1500.0]);
        near(marks(2e-17, 0.2174), &[0.0, 0.05, 0.1, 0.15, 0.2]);
        near(marks(377.0, 377.0), &[377.0]);
    }

    #[test]
    fn polygons_go_step_by_step() {
        let places = [[100, 205], [150, 200], [140, 310], [-5, 310]];
        assert_eq!(polygon(places.into_iter()), "M10 20.5l5-0.5-1 11-14.5 0z");
    }

    #[test]
    fn colours_run_from_end_to_end() {
        let range = [-1.0, 3.0];
        assert_eq!([colour(-1.0, range), colour(3.0, range)], ["#440154", "#fde725"]);
        // A fifth of the way is the second colour of the map.
        assert_eq!(colour(-0.2, range), "#414487");
        assert_eq!([colour(9.0, range), colour(f64::NAN, range)], ["#fde725", "#bbbbbb"]);
        assert_eq!(colour(2.0, [2.0, 2.0]), colour(0.5, [0.0, 1.0]));
    }
}
