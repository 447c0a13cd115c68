//! A body over its frames: its shape once, its motion and fields frame by frame, all at its points.

use std::collections::BTreeMap;

use mesh_io::{Array, Sheet};

use crate::faces::{Faces, toward};
use crate::track::Track;

/// The field that moves the points, where it is there.
const MOTION: &str = "displacement";
/// What each particle stands for, and the root that is its size.
const SIZES: [(&str, f64); 2] = [("area", 1.0 / 2.0), ("volume", 1.0 / 3.0)];

/// The field of what is seen through: tools.
const GLASS: &str = "tool";

/// A frame of another shape than those before it.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("a frame of {body} has {found} points where the first has {needed}")]
pub struct OtherShape {
    /// Name of the body.
    pub body: String,
    /// Points of the frame.
    pub found: usize,
    /// Points of the first one.
    pub needed: usize,
}

/// A body over its frames.
#[derive(Clone, Debug)]
pub struct Body {
    /// Its name.
    pub name: String,
    /// Points by name of the set that they belong to.
    pub sets: BTreeMap<String, Vec<u32>>,
    pub(crate) rest: Vec<[f64; 3]>,
    pub(crate) faces: Faces,
    /// Thickness of a shell, or size of a particle \[L\], at each point; empty of bodies without either.
    pub(crate) sizes: Vec<f32>,
    pub(crate) shell: bool,
    /// Whether it is drawn so that what is behind it is seen, without a field.
    pub(crate) glass: bool,
    /// Displacements \[L\].
    pub(crate) motion: Track,
    /// Whether the motion is a field of the frames, and not only what their points did.
    pub(crate) displaced: bool,
    pub(crate) fields: Vec<Track>,
    /// Cells as they stand in the frames, for their fields.
    cells: Vec<Vec<usize>>,
}

impl Body {
    /// A body without frames, of the shape of its first one.
    pub fn new(name: &str, first: &Sheet) -> Self {
        let motion = first.point_data.get(MOTION).filter(|array| array.width == 3);
        let moved = |i: usize| motion.map_or([0.0; 3], |u| [0, 1, 2].map(|k| u.numbers[3 * i + k]));
        let rest: Vec<[f64; 3]> = first.points.iter().enumerate().map(|(i, x)| less(*x, moved(i))).collect();
        let number = |name: &str| first.point_data.get(name).filter(|array| array.width == 1);
        let thickness = number("thickness");
        let mut faces = Faces::of(&first.cells);
        if let Some(director) = first.point_data.get("director").filter(|array| array.width == 3) {
            toward(&mut faces, &first.points, &director.numbers);
        }
        let shell = thickness.is_some() && !faces.faces.is_empty();
        let particle = || SIZES.iter().find_map(|&(name, root)| Some((number(name)?, root)));
        let sizes = match (thickness, faces.faces.is_empty()) {
            (Some(thickness), false) => thickness.numbers.iter().map(|&t| t as f32).collect(),
            (None, false) => Vec::new(),
            (_, true) => particle().map_or(Vec::new(), |(array, root)| {
                array.numbers.iter().map(|v| libm::pow(*v, root) as f32).collect()
            }),
        };
        let unit = motion.and_then(|array| array.unit.clone());
        let glass = first.point_data.contains_key(GLASS);
        let listed = |array: &Array| (1..=9).contains(&array.width) && !glass;
        let of = |(name, array): (&String, &Array)| Track::new(name, array);
        let fields = first.point_data.iter().filter(|&(name, array)| name != MOTION && listed(array)).map(of);
        let of_cells = first.cell_data.iter().filter(|&(name, _)| !first.point_data.contains_key(name));
        let fields = fields.chain(of_cells.map(of)).collect();
        Self {
            name: name.into(),
            sets: BTreeMap::new(),
            rest,
            faces,
            sizes,
            shell,
            glass,
            motion: Track { name: MOTION.into(), unit, components: Vec::new(), width: 3, frames: Vec::new() },
            displaced: motion.is_some() && !glass,
            fields,
            cells: first.cells.clone(),
        }
    }

    /// Adds a frame; a field that it lacks is no number in it.
    ///
    /// # Errors
    /// [`OtherShape`] for a frame with other points.
    pub fn add(&mut self, frame: &Sheet) -> Result<(), OtherShape> {
        let needed = self.rest.len();
        if frame.points.len() != needed {
            return Err(OtherShape { body: self.name.clone(), found: frame.points.len(), needed });
        }
        // Of a small displacement a difference of positions would keep little more than round-off.
        let given = frame.point_data.get(MOTION).filter(|array| array.width == 3);
        self.motion.frames.push(match given {
            Some(array) => array.numbers.iter().map(|&u| u as f32).collect(),
            None => {
                let moved = frame.points.iter().zip(&self.rest).map(|(&x, &from)| less(x, from));
                moved.flatten().map(|u| u as f32).collect()
            }
        });
        for track in &mut self.fields {
            let width = track.width;
            let fits = |array: &&Array| array.width == width;
            let points = frame.point_data.get(&track.name).filter(fits);
            let cells = frame.cell_data.get(&track.name).filter(fits);
            track.frames.push(match (points, cells) {
                (Some(array), _) => array.numbers.iter().map(|&x| x as f32).collect(),
                (None, Some(array)) if frame.cells.len() == self.cells.len() => {
                    at_points(&self.cells, array, needed)
                }
                _ => vec![f32::NAN; needed * width],
            });
        }
        Ok(())
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.rest.len()
    }

    /// All tracks, the motion first.
    pub(crate) fn tracks(&self) -> impl Iterator<Item = &Track> {
        std::iter::once(&self.motion).chain(&self.fields)
    }

    pub(crate) fn tracks_mut(&mut self) -> impl Iterator<Item = &mut Track> {
        std::iter::once(&mut self.motion).chain(&mut self.fields)
    }
}

fn less(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// A field of cells at the points: the mean over the cells round each; no number where there are none.
fn at_points(cells: &[Vec<usize>], array: &Array, points: usize) -> Vec<f32> {
    let width = array.width;
    let (mut sums, mut counts) = (vec![0.0; points * width], vec![0.0; points]);
    for (cell, row) in cells.iter().zip(array.numbers.chunks_exact(width)) {
        for &point in cell {
            counts[point] += 1.0;
            let own = &mut sums[point * width..][..width];
            own.iter_mut().zip(row).for_each(|(sum, x)| *sum += x);
        }
    }
    let mean = |(i, sum): (usize, &f64)| (sum / counts[i / width]) as f32;
    sums.iter().enumerate().map(mean).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn array(width: usize, numbers: &[f64]) -> Array {
        Array { components: Vec::new(), unit: None, width, numbers: numbers.into() }
    }

    /// Two triangles over a square that moved by 1 along x.
    fn sheet() -> Sheet {
        Sheet {
            points: vec![[1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 0.0], [1.0, 1.0, 0.0]],
            cells: vec![vec![0, 1, 2], vec![0, 2, 3]],
            point_data: [("displacement".to_string(), array(3, &[1.0, 0.0, 0.0].repeat(4)))].into(),
            cell_data: [("moment".to_string(), array(2, &[1.0, 10.0, 3.0, 30.0]))].into(),
            ..Sheet::default()
        }
    }

    #[test]
    fn points_stand_at_rest_and_cells_give_means() {
        let mut body = Body::new("plate", &sheet());
        body.add(&sheet()).unwrap();
        assert_eq!(body.rest[2], [1.0, 1.0, 0.0]);
        assert!(body.displaced);
        let moment = &body.fields[0];
        assert_eq!((moment.name.as_str(), moment.width), ("moment", 2));
        assert_eq!(moment.frames[0], [2.0, 20.0, 1.0, 10.0, 2.0, 20.0, 3.0, 30.0]);
    }

    #[test]
    fn without_displacements_points_tell_the_motion_and_missing_fields_are_no_numbers() {
        let first = Sheet { point_data: BTreeMap::new(), ..sheet() };
        let mut body = Body::new("wall", &first);
        body.add(&first).unwrap();
        let mut next = Sheet { cell_data: BTreeMap::new(), ..first.clone() };
        next.points[1] = [2.0, 0.5, 0.0];
        body.add(&next).unwrap();
        assert!(!body.displaced);
        assert_eq!(body.motion.frames[1][3..6], [0.0, 0.5, 0.0]);
        assert!(body.fields[0].frames[1].iter().all(|x| x.is_nan()));
        let other = Sheet { points: vec![[0.0; 3]; 3], ..Sheet::default() };
        assert_eq!(
            body.add(&other).unwrap_err().to_string(),
            "a frame of wall has 3 points where the first has 4"
        );
    }

    #[test]
    fn sizes_are_thickness_or_roots_of_what_a_particle_stands_for() {
        let particles = |name: &str, x: f64| Sheet {
            points: vec![[0.0; 3]],
            cells: vec![vec![0]],
            point_data: [(name.to_string(), array(1, &[x]))].into(),
            ..Sheet::default()
        };
        for (name, x) in [("area", 4.0), ("volume", 8.0)] {
            let body = Body::new("water", &particles(name, x));
            assert_eq!((body.sizes, body.shell), (vec![2.0], false));
        }
        let mut plate = sheet();
        plate.point_data.insert("thickness".into(), array(1, &[0.5; 4]));
        assert!(Body::new("plate", &plate).shell);
    }
}
