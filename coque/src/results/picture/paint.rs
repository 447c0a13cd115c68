//! The drawing itself: projection, colours and SVG elements.

use std::fmt::Write;

/// Size of the picture in pixels; the colour bar takes the right side.
pub(super) const WIDTH: f64 = 860.0;
pub(super) const HEIGHT: f64 = 620.0;
const LEFT: f64 = 30.0;
const RIGHT: f64 = 150.0;
const TOP: f64 = 50.0;
const BOTTOM: f64 = 40.0;
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
    /// A canvas that all the points seen fit on.
    pub fn fitting<'a>(points: impl Iterator<Item = &'a [f64; 3]>) -> Self {
        let mut range = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for point in points {
            for (bounds, x) in range.iter_mut().zip(point).filter(|(_, x)| x.is_finite()) {
                *bounds = [bounds[0].min(*x), bounds[1].max(*x)];
            }
        }
        let [wide, high] = range.map(|[low, high]| if high > low { high - low } else { 0.0 });
        let fit = ((WIDTH - LEFT - RIGHT) / wide).min((HEIGHT - TOP - BOTTOM) / high);
        let scale = if fit.is_finite() && fit > 0.0 { fit } else { 1.0 };
        let middle = range.map(|[low, high]| if high >= low { 0.5 * (low + high) } else { 0.0 });
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{HEIGHT}\" \
             viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"sans-serif\" font-size=\"14\">\n\
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

    pub fn title(&mut self, text: &str) {
        self.text([LEFT, 28.0], "start", text);
    }

    fn text(&mut self, [x, y]: [f64; 2], anchor: &str, text: &str) {
        let safe = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        let _ = writeln!(self.svg, "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{safe}</text>");
    }

    /// Words in the lower right corner.
    pub fn remark(&mut self, text: &str) {
        self.text([WIDTH - LEFT, HEIGHT - 14.0], "end", text);
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

    /// The three axes of space, in the lower left corner.
    pub fn axes(&mut self, camera: &Camera) {
        let [x0, y0] = [LEFT + 30.0, HEIGHT - BOTTOM - 10.0];
        for (i, name) in ["x", "y", "z"].into_iter().enumerate() {
            let mut unit = [0.0; 3];
            unit[i] = 1.0;
            let [right, up, _] = camera.see(&unit);
            let tip = |length: f64| [x0 + length * right, y0 - length * up];
            let [x, y] = tip(30.0);
            let _ = writeln!(
                self.svg,
                "<line x1=\"{x0:.1}\" y1=\"{y0:.1}\" x2=\"{x:.1}\" y2=\"{y:.1}\" stroke=\"black\"/>"
            );
            let [x, y] = tip(40.0);
            self.text([x, y + 5.0], "middle", name);
        }
    }

    /// The colour bar with its ends and quarters, name and unit above it.
    pub fn bar(&mut self, name: &str, unit: Option<&str>, [low, high]: [f64; 2]) {
        let (x, top, tall) = (WIDTH - RIGHT + 30.0, TOP + 40.0, HEIGHT - TOP - BOTTOM - 80.0);
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
        self.text([x + 110.0, top - 36.0], "end", name);
        if let Some(unit) = unit {
            self.text([x + 110.0, top - 18.0], "end", &format!("[{unit}]"));
        }
        if low > high {
            return; // no number at all
        }
        let marks: &[f64] = if low < high { &[0.0, 0.25, 0.5, 0.75, 1.0] } else { &[0.5] };
        for share in marks {
            let label = short(low + share * (high - low));
            self.text([x + 26.0, top + tall * (1.0 - share) + 5.0], "start", &label);
        }
    }
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
