//! What of a sheet is seen from where the viewer stands: its outer faces, moved as wanted, with images in planes.

use std::borrow::Cow;

use mesh_io::Sheet;

use super::Picture;
use super::extent::PictureExtent;
use super::faces::outer;
use super::field::{FieldNotThere, Values, values};
use super::paint::Camera;
use super::torn::torn;

/// The greatest displacement of a mode as it is drawn, in parts of the body's diagonal.
pub(super) const SWING: f64 = 0.1;

/// What of a sheet is drawn, and where the viewer sees it.
pub(super) struct Seen<'a> {
    /// The sheet with the outer faces of its solids.
    pub sheet: Cow<'a, Sheet>,
    pub values: Values,
    pub camera: Camera,
    /// Points at rest, images left out.
    pub start: Vec<[f64; 3]>,
    /// All points as they are drawn, and at rest: right, up, near.
    pub now: Vec<[f64; 3]>,
    pub before: Vec<[f64; 3]>,
    /// Cells that are drawn.
    pub whole: Vec<usize>,
}

impl<'a> Seen<'a> {
    pub fn of(sheet: &'a Sheet, wanted: &Picture<'_>) -> Result<Self, FieldNotThere> {
        let sheet = outer(sheet);
        let mut values = values(&sheet, wanted.field)?;
        let start = at_rest(&sheet);
        let mut scale = wanted.scale;
        if wanted.sizeless {
            values.as_shares();
            scale *= swing(&start, &sheet.points);
        }
        let moved = sheet.points.iter().zip(&start);
        let drawn: Vec<[f64; 3]> =
            moved.map(|(x, from)| [0, 1, 2].map(|i| from[i] + scale * (x[i] - from[i]))).collect();
        let whole = |&cell: &usize| !torn(&sheet, &sheet.cells[cell], &start, &drawn);
        let whole = (0..sheet.cells.len()).filter(whole).collect();
        let camera = Camera::new(wanted.view);
        let see = |points: Vec<[f64; 3]>| -> Vec<[f64; 3]> {
            mirrored(points, wanted.mirror).iter().map(|x| camera.see(x)).collect()
        };
        let (now, before) = (see(drawn), see(start.clone()));
        Ok(Self { sheet, values, camera, start, now, before, whole })
    }

    /// Cells by their numbers, followed by their images, whose points stand behind those of the sheet.
    pub fn with_images(&self, cells: &[usize]) -> Vec<Vec<usize>> {
        let shifted = |first: usize, cell: usize| self.sheet.cells[cell].iter().map(|a| a + first).collect();
        let firsts = (0..self.now.len()).step_by(self.start.len().max(1));
        firsts.flat_map(|first| cells.iter().map(move |&cell| shifted(first, cell))).collect()
    }

    pub fn extent(&self) -> PictureExtent {
        // Of points alone nothing is drawn at rest, which of a flow that goes round lies periods away.
        let drawn_at_rest = self.sheet.cells.iter().any(|cell| cell.len() > 1);
        let before = self.before.iter().filter(|_| drawn_at_rest);
        PictureExtent::of(self.now.iter().chain(before), &self.values.of_cells)
    }
}

/// Where the points of a sheet were.
fn at_rest(sheet: &Sheet) -> Vec<[f64; 3]> {
    let Some(u) = sheet.point_data.get("displacement").filter(|u| u.width == 3) else {
        return sheet.points.clone();
    };
    // Beside bodies that move, walls have no displacement.
    let way = |u: f64| if u.is_nan() { 0.0 } else { u };
    let moved = sheet.points.iter().zip(u.numbers.chunks_exact(3));
    moved.map(|(x, u)| [x[0] - way(u[0]), x[1] - way(u[1]), x[2] - way(u[2])]).collect()
}

/// The factor on a mode that makes it visible.
fn swing(start: &[[f64; 3]], points: &[[f64; 3]]) -> f64 {
    let square = |x: &[f64; 3], y: &[f64; 3]| x.iter().zip(y).map(|(x, y)| (x - y).powi(2)).sum::<f64>();
    let corner =
        |pick: fn(f64, f64) -> f64| start.iter().copied().reduce(|a, b| [0, 1, 2].map(|i| pick(a[i], b[i])));
    let (Some(low), Some(high)) = (corner(f64::min), corner(f64::max)) else { return 1.0 };
    let greatest = start.iter().zip(points).map(|(from, x)| square(from, x)).fold(0.0, f64::max);
    if greatest > 0.0 { SWING * (square(&low, &high) / greatest).sqrt() } else { 1.0 }
}

/// The points, followed by their images in each plane and, in the next, the images of all these.
fn mirrored(mut points: Vec<[f64; 3]>, planes: &[usize]) -> Vec<[f64; 3]> {
    for &axis in planes {
        let image = points.clone().into_iter().map(|mut x| {
            x[axis] = -x[axis];
            x
        });
        points.extend(image.collect::<Vec<_>>());
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn images_stand_behind_the_points() {
        let points = mirrored(vec![[1.0, 2.0, 3.0]], &[0, 2]);
        assert_eq!(points, [[1.0, 2.0, 3.0], [-1.0, 2.0, 3.0], [1.0, 2.0, -3.0], [-1.0, 2.0, -3.0]]);
    }
}
