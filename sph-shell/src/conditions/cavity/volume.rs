//! The volume of cells over a field of divergence one, and the areas by which it changes.

use nalgebra::Matrix3;
use sph_core::{Cell, Vec3};

/// The linear field `F(x) = P (x − o)`, tr P = 1: the flux through a closed surface is the volume inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Field {
    /// o, where it vanishes \[L\].
    pub origin: Vec3,
    /// P: a third of one, or half of it without an axis.
    pub matrix: Matrix3<f64>,
}

/// A cell as triangles, corner numbers and weight: a quadrangle is halved both ways, each by one half.
fn triangles(cell: &Cell) -> impl Iterator<Item = ([usize; 3], f64)> {
    const WHOLE: [([usize; 3], f64); 1] = [([0, 1, 2], 1.0)];
    const HALVED: [([usize; 3], f64); 4] =
        [([0, 1, 2], 0.5), ([0, 2, 3], 0.5), ([0, 1, 3], 0.5), ([1, 2, 3], 0.5)];
    let all: &[_] = if cell.count == 3 { &WHOLE } else { &HALVED };
    all.iter().copied()
}

impl Field {
    /// Flux through a cell whose corners are at places \[L³\].
    pub fn volume(&self, cell: &Cell, at: impl Fn(u32) -> Vec3) -> f64 {
        let x = cell.corners.map(at);
        let of = |([a, b, c], weight): ([usize; 3], f64)| {
            let middle = (x[a] + x[b] + x[c]) / 3.0 - self.origin;
            let area = (x[b] - x[a]).cross(&(x[c] - x[a])) * 0.5;
            weight * (self.matrix * middle).dot(&area)
        };
        triangles(cell).map(of).sum()
    }
}

/// A third of the area vectors of its triangles on each corner \[L²\]: of all cells round a corner that is inside, the derivative of the volume by its place.
///
/// At a rim the derivative of a flux has a part more, of what closes the rim; it lies along directions that are held, and no pressure on the cells.
pub(crate) fn areas(cell: &Cell, at: impl Fn(u32) -> Vec3) -> [Vec3; 4] {
    let x = cell.corners.map(at);
    let mut sum = [Vec3::zeros(); 4];
    for (corners, weight) in triangles(cell) {
        let [a, b, c] = corners.map(|corner| x[corner]);
        let area = (b - a).cross(&(c - a)) * (weight / 6.0);
        corners.iter().for_each(|&corner| sum[corner] += area);
    }
    sum
}

/// Derivatives of [`areas`] by the places of the corners \[L\], those of the second corner by column: with the side s_b opposite to b, `∂A/∂b = −½ [s_b]×`.
pub(crate) fn area_changes(cell: &Cell, at: impl Fn(u32) -> Vec3) -> [[Matrix3<f64>; 4]; 4] {
    let x = cell.corners.map(at);
    let mut sum = [[Matrix3::zeros(); 4]; 4];
    for (corners, weight) in triangles(cell) {
        let [a, b, c] = corners.map(|corner| x[corner]);
        for (moved, side) in corners.into_iter().zip([b - c, c - a, a - b]) {
            let change = side.cross_matrix() * (-weight / 6.0);
            corners.iter().for_each(|&corner| sum[corner][moved] += change);
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places() -> [Vec3; 4] {
        [
            Vec3::new(0.1, 0.2, 1.0),
            Vec3::new(1.3, -0.1, 1.2),
            Vec3::new(1.1, 1.4, 0.7),
            Vec3::new(-0.2, 0.9, 1.1),
        ]
    }

    /// Two warped quadrangles and four triangles round one corner: areas there are the slope of the flux, of either field, as far as it goes; their
    /// changes are the slopes of areas.
    #[test]
    fn areas_are_slopes_of_the_volume() {
        let third = Field { origin: Vec3::new(0.3, -0.2, 0.4), matrix: Matrix3::identity() / 3.0 };
        let half = Field { matrix: Matrix3::from_diagonal(&Vec3::new(0.5, 0.5, 0.0)), ..third };
        // Corner 0 inside a ring of 1 to 6.
        let ring = |k: f64| Vec3::new(libm::cos(k), libm::sin(k), 0.3 * libm::sin(3.0 * k));
        let home: Vec<Vec3> =
            [Vec3::new(0.1, -0.05, 0.2)].into_iter().chain((0..6).map(|k| ring(f64::from(k)))).collect();
        let cells = [
            Cell { corners: [0, 1, 2, 3], count: 4 },
            Cell { corners: [0, 3, 4, 4], count: 3 },
            Cell { corners: [0, 4, 5, 6], count: 4 },
            Cell { corners: [0, 6, 1, 1], count: 3 },
        ];
        for field in [third, half] {
            for k in 0..3 {
                let volume = |by: f64| -> f64 {
                    let mut x = home.clone();
                    x[0][k] += by;
                    cells.iter().map(|cell| field.volume(cell, |a| x[a as usize])).sum()
                };
                let step = 1e-3;
                let slope = (8.0 * (volume(step) - volume(-step)) - volume(2.0 * step) + volume(-2.0 * step))
                    / (12.0 * step);
                let area: f64 = cells.iter().map(|cell| areas(cell, |a| home[a as usize])[0][k]).sum();
                assert!((slope - area).abs() < 1e-12, "{field:?} {k}: {slope} {area}");
            }
        }
        for count in [3, 4] {
            let cell = Cell { corners: if count == 3 { [0, 1, 2, 2] } else { [0, 1, 2, 3] }, count };
            let changes = area_changes(&cell, |a| places()[a as usize]);
            for (moved, k) in (0..count as usize).flat_map(|moved| (0..3).map(move |k| (moved, k))) {
                let at = |by: f64| {
                    let mut x = places();
                    x[moved][k] += by;
                    areas(&cell, |a| x[a as usize])
                };
                let (plus, minus) = (at(1e-3), at(-1e-3));
                for corner in 0..count as usize {
                    let slope = (plus[corner] - minus[corner]) / 2e-3;
                    assert!(
                        (slope - changes[corner][moved].column(k)).norm() < 1e-12,
                        "{count} {moved} {k} {corner}"
                    );
                }
            }
        }
    }
}
