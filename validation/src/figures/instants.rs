//! Particles at several instants, side by side, all to one scale.

use std::collections::BTreeSet;

use super::escape;
use super::legend::{self, Colour, Mark};

/// Width of one picture in pixels, and how many stand in a row.
const WIDTH: f64 = 300.0;
const ACROSS: usize = 3;
const GAP: f64 = 12.0;
/// Height of the words above a picture.
const WORDS: f64 = 18.0;

/// Pictures of one plane at several instants.
#[derive(Clone, Debug)]
pub struct Instants {
    /// What is drawn.
    pub title: String,
    /// What to see in it.
    pub caption: String,
    /// Least and greatest place that is drawn \[L\].
    pub window: [[f64; 2]; 2],
    /// Spacing of the particles, the side of the square that each is drawn as \[L\].
    pub spacing: f64,
    /// Names and colours of the groups of particles; later ones cover earlier ones.
    pub groups: Vec<(String, Colour)>,
    /// The pictures.
    pub frames: Vec<Instant>,
}

/// One picture.
#[derive(Clone, Debug)]
pub struct Instant {
    /// Words above it.
    pub label: String,
    /// Places of the particles of each group \[L\].
    pub points: Vec<Vec<[f64; 2]>>,
}

impl Instants {
    /// The pictures, followed by their legend.
    pub fn html(&self) -> String {
        let [low, high] = self.window;
        let scale = WIDTH / (high[0] - low[0]);
        let height = ((high[1] - low[1]) * scale).ceil();
        let rows = self.frames.len().div_ceil(ACROSS);
        let whole = ACROSS as f64 * (WIDTH + GAP) - GAP;
        let tall = rows as f64 * (height + WORDS + GAP) - GAP;
        let mut svg = format!(
            "<svg width='{whole:.0}' height='{tall:.0}' viewBox='0 0 {whole:.0} {tall:.0}' role='img'>"
        );
        for (number, frame) in self.frames.iter().enumerate() {
            let left = (number % ACROSS) as f64 * (WIDTH + GAP);
            let top = (number / ACROSS) as f64 * (height + WORDS + GAP);
            svg.push_str(&format!(
                "<g transform='translate({left:.0} {top:.0})'><text x='0' y='13' font-size='13'>{}</text>\
                 <g transform='translate(0 {WORDS:.0})'><rect width='{WIDTH:.0}' height='{height:.0}' fill='none' stroke='#cccccc'/>",
                escape(&frame.label)
            ));
            for ((_, colour), points) in self.groups.iter().zip(&frame.points) {
                let runs = self.runs(points, scale, [WIDTH as i32, height as i32]);
                svg.push_str(&format!("<path stroke='{}' d='{runs}'/>", colour.hex()));
            }
            svg.push_str("</g></g>");
        }
        let entry = |(name, colour): &(String, Colour)| legend::entry(name, *colour, Some(Mark::Disc), None);
        let entries: String = self.groups.iter().map(entry).collect();
        format!("{svg}</svg><ul class='legend'>{entries}</ul>")
    }

    /// The pixels that particles cover, as horizontal strokes: a dense fluid takes a few for each line of pixels.
    fn runs(&self, points: &[[f64; 2]], scale: f64, size: [i32; 2]) -> String {
        let [low, high] = self.window;
        let side = ((self.spacing * scale).ceil() as i32).max(1);
        let mut pixels = BTreeSet::new();
        for point in points {
            let x = ((point[0] - low[0] - 0.5 * self.spacing) * scale).round() as i32;
            let y = ((high[1] - point[1] - 0.5 * self.spacing) * scale).round() as i32;
            let inside = |&(y, x): &(i32, i32)| (0..size[0]).contains(&x) && (0..size[1]).contains(&y);
            let square = (0..side * side).map(|k| (y + k / side, x + k % side));
            pixels.extend(square.filter(inside));
        }
        let mut path = String::new();
        let mut run: Option<(i32, i32, i32)> = None;
        for (y, x) in pixels {
            run = match run {
                Some((line, from, to)) if line == y && to == x => Some((line, from, x + 1)),
                before => {
                    push(&mut path, before);
                    Some((y, x, x + 1))
                }
            };
        }
        push(&mut path, run);
        path
    }
}

fn push(path: &mut String, run: Option<(i32, i32, i32)>) {
    if let Some((line, from, to)) = run {
        path.push_str(&format!("M{from} {line}.5H{to}"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figures::{BLUE, GREY};

    #[test]
    fn particles_side_by_side_are_one_stroke_and_those_outside_none() {
        let instants = Instants {
            title: String::new(),
            caption: String::new(),
            window: [[0.0, 0.0], [1.0, 0.5]],
            spacing: 1.0 / WIDTH,
            groups: vec![("water".into(), BLUE), ("gate".into(), GREY)],
            frames: Vec::new(),
        };
        let at = |x: f64, y: f64| [(x + 0.5) / WIDTH, 0.5 - (y + 0.5) / WIDTH];
        let points = [at(3.0, 2.0), at(4.0, 2.0), at(6.0, 2.0), at(-1.0, 0.0), at(0.0, 200.0)];
        assert_eq!(instants.runs(&points, WIDTH, [300, 150]), "M3 2.5H5M6 2.5H7");
    }
}
