//! One cell of a cloud: three or four particles around a sampling point, and its flat geometry.

use crate::Vec3;

/// Three or four particles in counter-clockwise order about the normal; a triangle repeats its last corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Particle indices.
    pub corners: [u32; 4],
    /// Number of different corners, 3 or 4.
    pub count: u8,
}

/// Area centroid, unit normal and area of a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellGeometry {
    /// Area centroid `[L]`.
    pub centroid: Vec3,
    /// Unit normal, the direction of the sum of the area vectors; not finite for a cell without area.
    pub normal: Vec3,
    /// Area `[L²]`.
    pub area: f64,
}

impl Cell {
    /// Triangle.
    pub fn triangle(corners: [u32; 3]) -> Cell {
        Cell { corners: [corners[0], corners[1], corners[2], corners[2]], count: 3 }
    }

    /// Quadrangle.
    pub fn quadrangle(corners: [u32; 4]) -> Cell {
        Cell { corners, count: 4 }
    }

    /// The three or four particles.
    pub fn particles(&self) -> &[u32] {
        &self.corners[..usize::from(self.count)]
    }

    /// Directed edges, counter-clockwise.
    pub fn edges(&self) -> impl Iterator<Item = (u32, u32)> + '_ {
        let corners = self.particles();
        (0..corners.len()).map(move |i| (corners[i], corners[(i + 1) % corners.len()]))
    }

    /// Geometry from the cell's triangles.
    ///
    /// A quadrangle is cut along both diagonals and the two answers are averaged: for a flat cell they agree, and for a
    /// warped one the result does not depend on which corner comes first.
    pub fn geometry(&self, positions: &[Vec3]) -> CellGeometry {
        let x: Vec<Vec3> = self.particles().iter().map(|&b| positions[b as usize]).collect();
        let (cuts, share): (&[[usize; 3]], f64) = if x.len() == 3 {
            (&[[0, 1, 2]], 1.0)
        } else {
            (&[[0, 1, 2], [0, 2, 3], [1, 2, 3], [1, 3, 0]], 0.5)
        };
        let vector = |cut: &[usize; 3]| 0.5 * (x[cut[1]] - x[cut[0]]).cross(&(x[cut[2]] - x[cut[0]]));
        let normal = cuts.iter().map(vector).sum::<Vec3>().normalize();
        let mut area = 0.0;
        let mut moment = Vec3::zeros();
        for cut in cuts {
            // Signed by the side it shows, so that cells with an inner corner still add up.
            let part = share * vector(cut).norm().copysign(vector(cut).dot(&normal));
            area += part;
            moment += part / 3.0 * (x[cut[0]] - x[0] + x[cut[1]] - x[0] + x[cut[2]] - x[0]);
        }
        CellGeometry { centroid: x[0] + moment / area, normal, area }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn flat_cells_have_their_schoolbook_area_and_centroid() {
        let corners = |list: &[[f64; 2]]| -> Vec<Vec3> {
            list.iter().map(|c| Vec3::new(c[0] + 5.0, c[1] - 2.0, 1.0)).collect()
        };
        let centre = |x: f64, y: f64| Vec3::new(x + 5.0, y - 2.0, 1.0);
        // Trapezoid with parallel sides 4 and 2, height 3: centroid height h(a+2b)/(3(a+b)) = 4/3.
        let trapezoid = corners(&[[0.0, 0.0], [4.0, 0.0], [3.0, 3.0], [1.0, 3.0]]);
        // Right triangle of area 2 less the sliver (0,0),(2,2),(1.2,0.8) of area 0.4: an inner corner.
        let arrow = corners(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.2, 0.8]]);
        let triangle = corners(&[[0.0, 0.0], [3.0, 0.0], [0.0, 3.0]]);
        for (cell, x, area, centroid) in [
            (Cell::quadrangle([0, 1, 2, 3]), &trapezoid, 9.0, centre(2.0, 4.0 / 3.0)),
            (Cell::quadrangle([0, 1, 2, 3]), &arrow, 1.6, centre(1.4, 0.6)),
            (Cell::triangle([0, 1, 2]), &triangle, 4.5, centre(1.0, 1.0)),
        ] {
            let geometry = cell.geometry(x);
            assert_relative_eq!(geometry.area, area, epsilon = 1e-13);
            assert_relative_eq!(geometry.centroid, centroid, epsilon = 1e-13);
            assert_relative_eq!(geometry.normal, Vec3::z(), epsilon = 1e-13);
        }
    }

    #[test]
    fn a_warped_cell_does_not_know_its_first_corner() {
        let x =
            [Vec3::zeros(), Vec3::new(1.0, 0.1, 0.3), Vec3::new(1.2, 1.0, -0.1), Vec3::new(-0.1, 0.8, 0.2)];
        let first = Cell::quadrangle([0, 1, 2, 3]).geometry(&x);
        let second = Cell::quadrangle([1, 2, 3, 0]).geometry(&x);
        assert_relative_eq!(first.area, second.area, epsilon = 1e-14);
        assert_relative_eq!(first.centroid, second.centroid, epsilon = 1e-14);
        assert_relative_eq!(first.normal, second.normal, epsilon = 1e-14);
    }
}
