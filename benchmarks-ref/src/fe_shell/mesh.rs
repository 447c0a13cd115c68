//! Structured meshes of quadrilaterals on a parametric patch.

use nalgebra::Vector3;

/// Four-node elements in rows and columns over ξ, η ∈ \[0, 1\], with the surface's normal at each node.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    columns: usize,
    rows: usize,
    /// Reference positions \[L\], row by row.
    pub positions: Vec<Vector3<f64>>,
    /// Reference directors: unit normals of the surface that was meshed, not of the facets.
    pub directors: Vec<Vector3<f64>>,
}

/// A side of the patch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// ξ = 0.
    XiStart,
    /// ξ = 1.
    XiEnd,
    /// η = 0.
    EtaStart,
    /// η = 1.
    EtaEnd,
}

impl Mesh {
    /// `columns` × `rows` elements; `surface(ξ, η)` gives a position and a unit normal, seen from which ξ, η turn
    /// counter-clockwise.
    pub fn patch(
        columns: usize,
        rows: usize,
        surface: impl Fn(f64, f64) -> (Vector3<f64>, Vector3<f64>),
    ) -> Self {
        assert!(columns > 0 && rows > 0, "a patch has at least one element");
        let (positions, directors) = (0..=rows)
            .flat_map(|j| (0..=columns).map(move |i| (i as f64 / columns as f64, j as f64 / rows as f64)))
            .map(|(xi, eta)| surface(xi, eta))
            .unzip();
        Self { columns, rows, positions, directors }
    }

    /// A plate in the plane z = 0 with corner at the origin and sides \[L\] along x and y.
    pub fn plate(columns: usize, rows: usize, length: f64, width: f64) -> Self {
        Self::patch(columns, rows, |xi, eta| (Vector3::new(length * xi, width * eta, 0.0), Vector3::z()))
    }

    /// A cylinder's part with axis x: ξ along the axis from 0 to `length` \[L\], η over the angle φ from the z axis
    /// towards y, from 0 to `angle` \[rad\]; director outward. Both run with the power `grading` of the lattice:
    /// 1 is uniform, more crowds the corner ξ = η = 0.
    pub fn cylinder(columns: usize, rows: usize, radius: f64, length: f64, angle: f64, grading: f64) -> Self {
        Self::patch(columns, rows, |xi, eta| {
            let (xi, eta) = (libm::pow(xi, grading), libm::pow(eta, grading));
            let normal = Vector3::new(0.0, libm::sin(angle * eta), libm::cos(angle * eta));
            (normal * radius + Vector3::x() * (length * xi), normal)
        })
    }

    /// A quarter of a sphere's belt: ξ over the longitude from x to y, η over the latitude from the equator to
    /// `latitude` \[rad\]; director outward.
    pub fn belt(columns: usize, rows: usize, radius: f64, latitude: f64) -> Self {
        Self::patch(columns, rows, |xi, eta| {
            let (along, up) = (std::f64::consts::FRAC_PI_2 * xi, latitude * eta);
            let flat = libm::cos(up);
            let normal = Vector3::new(flat * libm::cos(along), flat * libm::sin(along), libm::sin(up));
            (normal * radius, normal)
        })
    }

    /// A beam along x of `length` and `width` \[L\] whose width turns from y to z: a helicoid.
    pub fn twisted(columns: usize, rows: usize, length: f64, width: f64) -> Self {
        let rate = std::f64::consts::FRAC_PI_2 / length;
        Self::patch(columns, rows, |xi, eta| {
            let (x, across) = (length * xi, width * (eta - 0.5));
            let direction = Vector3::new(0.0, libm::cos(rate * x), libm::sin(rate * x));
            let turn = Vector3::new(0.0, -libm::sin(rate * x), libm::cos(rate * x));
            let normal = (Vector3::x() + turn * (rate * across)).cross(&direction).normalize();
            (Vector3::x() * x + direction * across, normal)
        })
    }

    /// The node in column i and row j of the lattice.
    pub fn node(&self, i: usize, j: usize) -> usize {
        debug_assert!(i <= self.columns && j <= self.rows, "no node ({i}, {j})");
        i + j * (self.columns + 1)
    }

    /// The nodes of a side, in order.
    pub fn side(&self, side: Side) -> Vec<usize> {
        match side {
            Side::XiStart => (0..=self.rows).map(|j| self.node(0, j)).collect(),
            Side::XiEnd => (0..=self.rows).map(|j| self.node(self.columns, j)).collect(),
            Side::EtaStart => (0..=self.columns).map(|i| self.node(i, 0)).collect(),
            Side::EtaEnd => (0..=self.columns).map(|i| self.node(i, self.rows)).collect(),
        }
    }

    /// The four nodes of each element, counter-clockwise seen from the director's side.
    pub fn elements(&self) -> Vec<[usize; 4]> {
        let corner =
            |i, j| [self.node(i, j), self.node(i + 1, j), self.node(i + 1, j + 1), self.node(i, j + 1)];
        (0..self.rows).flat_map(|j| (0..self.columns).map(move |i| corner(i, j))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directors_are_unit_normals_on_the_counter_clockwise_side() {
        let meshes = [
            Mesh::plate(3, 4, 2.0, 1.0),
            Mesh::cylinder(5, 6, 3.0, 2.0, 1.2, 1.5),
            Mesh::belt(6, 5, 2.0, 1.2),
            Mesh::twisted(12, 3, 12.0, 1.1),
        ];
        for mesh in &meshes {
            for nodes in mesh.elements() {
                let x = nodes.map(|node| mesh.positions[node]);
                let normal = (x[2] - x[0]).cross(&(x[3] - x[1])).normalize();
                for node in nodes {
                    let director = mesh.directors[node];
                    assert!((director.norm() - 1.0).abs() < 1e-14);
                    assert!(director.dot(&normal) > 0.95, "{node}: {director} against {normal}");
                }
            }
        }
    }

    #[test]
    fn sides_meet_in_corners() {
        let mesh = Mesh::plate(3, 2, 3.0, 2.0);
        assert_eq!(mesh.side(Side::XiStart), [0, 4, 8]);
        assert_eq!(mesh.side(Side::XiEnd), [3, 7, 11]);
        assert_eq!(mesh.side(Side::EtaStart), [0, 1, 2, 3]);
        assert_eq!(mesh.side(Side::EtaEnd), [8, 9, 10, 11]);
        assert_eq!(mesh.elements().len(), 6);
    }
}
