//! Deformed shapes as axonometric wireframes, hidden faces behind.

use coque::Shape;

use super::legend::{self, Colour, Line};

/// Longer side of a picture in pixels.
const SIZE: f64 = 700.0;
const MARGIN: f64 = 14.0;

/// Wireframes in one picture.
#[derive(Clone, Debug)]
pub struct Shapes {
    /// What is drawn.
    pub title: String,
    /// What to see in it.
    pub caption: String,
    /// Where the viewer stands: azimuth from +x towards +y and elevation, in degrees.
    pub view: (f64, f64),
    /// What is drawn; nearer faces hide farther ones.
    pub sheets: Vec<Sheet>,
}

/// One wireframe.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Words in the legend.
    pub label: String,
    /// Particles.
    pub points: Vec<[f64; 3]>,
    /// Cells: numbers of particles.
    pub faces: Vec<Vec<usize>>,
    /// Colour of the lines.
    pub colour: Colour,
}

impl Sheet {
    /// A recorded shape of a run, with its cells.
    pub fn new(label: &str, faces: &[Vec<usize>], shape: &Shape, colour: Colour) -> Self {
        let points = shape.positions.iter().map(|p| [p[0], p[1], p[2]]).collect();
        Self { label: label.into(), points, faces: faces.to_vec(), colour }
    }

    /// Completes a part by its mirror image in the plane through the origin across an axis (0 to 2).
    #[must_use]
    pub fn mirrored(mut self, axis: usize) -> Self {
        let count = self.points.len();
        let image = self.points.clone().into_iter().map(|mut p| {
            p[axis] = -p[axis];
            p
        });
        self.points.extend(image);
        let faces: Vec<Vec<usize>> =
            self.faces.iter().map(|face| face.iter().rev().map(|a| a + count).collect()).collect();
        self.faces.extend(faces);
        self
    }

    /// Stretches along an axis (0 to 2), to make a flat shape visible.
    #[must_use]
    pub fn stretched(mut self, axis: usize, factor: f64) -> Self {
        for point in &mut self.points {
            point[axis] *= factor;
        }
        self
    }

    /// Shifts along an axis (0 to 2).
    #[must_use]
    pub fn shifted(mut self, axis: usize, by: f64) -> Self {
        for point in &mut self.points {
            point[axis] += by;
        }
        self
    }
}

/// A face in the picture: distance towards the viewer, sheet, corners.
struct Face {
    near: f64,
    sheet: usize,
    corners: Vec<(f64, f64)>,
}

impl Shapes {
    /// The picture, followed by its legend.
    pub fn html(&self) -> String {
        let mut faces = self.faces();
        faces.sort_by(|a, b| a.near.total_cmp(&b.near));
        let ends = (f64::INFINITY, f64::NEG_INFINITY);
        let bound = |(low, high): (f64, f64), value: f64| (low.min(value), high.max(value));
        let corners = || faces.iter().flat_map(|face| &face.corners);
        let (left, right) = corners().map(|c| c.0).fold(ends, bound);
        let (low, high) = corners().map(|c| c.1).fold(ends, bound);
        let scale = (SIZE - 2.0 * MARGIN) / (right - left).max(high - low).max(f64::MIN_POSITIVE);
        let (width, height) = ((right - left) * scale + 2.0 * MARGIN, (high - low) * scale + 2.0 * MARGIN);
        let mut svg = format!(
            "<svg width='{width:.0}' height='{height:.0}' viewBox='0 0 {width:.0} {height:.0}' role='img'>\
             <g fill='#ffffff' fill-opacity='0.82' stroke-width='0.8' stroke-linejoin='round'>"
        );
        for face in &faces {
            let points: Vec<String> = face
                .corners
                .iter()
                .map(|(x, y)| {
                    format!("{:.1} {:.1}", (x - left) * scale + MARGIN, (high - y) * scale + MARGIN)
                })
                .collect();
            let colour = self.sheets[face.sheet].colour.hex();
            svg.push_str(&format!("<path stroke='{colour}' d='M{}Z'/>", points.join("L")));
        }
        let entries: String = self
            .sheets
            .iter()
            .map(|sheet| legend::entry(&sheet.label, sheet.colour, None, Some(Line::Solid)))
            .collect();
        format!("{svg}</g></svg><ul class='legend'>{entries}</ul>")
    }

    fn faces(&self) -> Vec<Face> {
        let (azimuth, elevation) = (self.view.0.to_radians(), self.view.1.to_radians());
        let (sa, ca) = libm::sincos(azimuth);
        let (se, ce) = libm::sincos(elevation);
        let along = |p: &[f64; 3], v: [f64; 3]| p[0] * v[0] + p[1] * v[1] + p[2] * v[2];
        let (right, up, towards) = ([-sa, ca, 0.0], [-se * ca, -se * sa, ce], [ce * ca, ce * sa, se]);
        let mut faces = Vec::new();
        for (sheet, shape) in self.sheets.iter().enumerate() {
            for face in &shape.faces {
                let points = || face.iter().map(|&a| &shape.points[a]);
                faces.push(Face {
                    near: points().map(|p| along(p, towards)).sum::<f64>() / face.len() as f64,
                    sheet,
                    corners: points().map(|p| (along(p, right), along(p, up))).collect(),
                });
            }
        }
        faces
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figures::BLUE;

    fn square() -> Sheet {
        Sheet {
            label: "square".into(),
            points: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
            faces: vec![vec![0, 1, 2, 3]],
            colour: BLUE,
        }
    }

    #[test]
    fn mirrors_complete_a_quarter() {
        let whole = square().mirrored(0).mirrored(1).stretched(0, 2.0).shifted(2, 5.0);
        assert_eq!((whole.points.len(), whole.faces.len()), (16, 4));
        let corner = whole.points.iter().any(|p| *p == [-2.0, -1.0, 5.0]);
        assert!(corner, "{:?}", whole.points);
    }

    #[test]
    fn nearer_faces_are_drawn_later() {
        let shapes = Shapes {
            title: String::new(),
            caption: String::new(),
            view: (0.0, 90.0),
            sheets: vec![
                square().shifted(2, 1.0),
                Sheet { label: "below".into(), colour: crate::figures::GREEN, ..square() },
            ],
        };
        let html = shapes.html();
        let place = |colour: Colour| html.find(&colour.hex()).unwrap();
        assert!(place(crate::figures::GREEN) < place(BLUE));
    }
}
