//! Supports: which displacements and which turns of a node are held.

use super::director::Director;
use nalgebra::Vector3;

/// What the support lets the director do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Turning {
    /// Turn as it likes.
    Free,
    /// Stay in the plane with this unit normal.
    InPlane(Vector3<f64>),
    /// Stay as it is.
    Held,
}

/// The same support of several nodes.
#[derive(Debug, Clone, PartialEq)]
pub struct Support {
    /// The nodes.
    pub nodes: Vec<usize>,
    /// Unit directions in which they cannot move.
    pub held: Vec<Vector3<f64>>,
    /// Their directors.
    pub director: Turning,
}

impl Support {
    /// Nothing moves, nothing turns.
    pub fn clamp(nodes: Vec<usize>) -> Self {
        Self { nodes, held: axes().to_vec(), director: Turning::Held }
    }

    /// Nothing moves, everything turns.
    pub fn hinge(nodes: Vec<usize>) -> Self {
        Self { nodes, held: axes().to_vec(), director: Turning::Free }
    }

    /// The mirror plane with unit normal ν: u·ν = 0, d·ν = 0.
    pub fn symmetry(nodes: Vec<usize>, normal: Vector3<f64>) -> Self {
        Self { nodes, held: vec![normal], director: Turning::InPlane(normal) }
    }

    /// A membrane across the unit `axis`, rigid in its plane: only the motion along the axis is free.
    pub fn diaphragm(nodes: Vec<usize>, axis: Vector3<f64>) -> Self {
        let [_, first, second] = completed(&[axis]).0;
        Self { nodes, held: vec![first, second], director: Turning::Free }
    }

    /// A roller: no motion along one unit direction.
    pub fn roller(nodes: Vec<usize>, direction: Vector3<f64>) -> Self {
        Self { nodes, held: vec![direction], director: Turning::Free }
    }
}

/// The degrees of freedom of one node: three displacements along `axes`, the first `held` of which are zero, then the director's.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// Orthonormal directions of displacement.
    pub axes: [Vector3<f64>; 3],
    /// How many of them are held.
    pub held: usize,
    /// How many tangent axes of the director are free, first one first.
    pub turns: usize,
}

/// Collects the supports of one node, and turns the director's axes so that what is held is the second axis.
///
/// `Err` holds the normal of a plane in which the director does not lie.
pub fn frame(supports: &[&Support], director: &mut Director) -> Result<Frame, Vector3<f64>> {
    let (mut directions, mut planes) = (Vec::new(), Vec::<Vector3<f64>>::new());
    let mut turns = 2;
    for support in supports {
        directions.extend_from_slice(&support.held);
        match support.director {
            Turning::Free => {}
            Turning::Held => turns = 0,
            Turning::InPlane(normal) if director.normal.dot(&normal).abs() > 1e-9 => return Err(normal),
            Turning::InPlane(normal) => planes.push(normal),
        }
    }
    if let (Some(plane), true) = (planes.first(), turns > 0) {
        let same = planes.iter().all(|other| other.cross(plane).norm() < 1e-9);
        turns = usize::from(same);
        *director = Director::in_plane(director.normal, *plane);
    }
    let (axes, held) = completed(&directions);
    Ok(Frame { axes, held, turns })
}

fn axes() -> [Vector3<f64>; 3] {
    [Vector3::x(), Vector3::y(), Vector3::z()]
}

/// An orthonormal basis whose first vectors span the given directions, and how many those are.
fn completed(directions: &[Vector3<f64>]) -> ([Vector3<f64>; 3], usize) {
    let mut basis: Vec<Vector3<f64>> = Vec::with_capacity(3);
    let rest = |basis: &[Vector3<f64>], direction: &Vector3<f64>| {
        basis.iter().fold(*direction, |rest, unit| rest - unit * unit.dot(&rest))
    };
    for direction in directions {
        if let Some(unit) = rest(&basis, direction).try_normalize(1e-9) {
            basis.push(unit);
        }
    }
    let held = basis.len();
    while basis.len() < 3 {
        let rests = axes().map(|axis| rest(&basis, &axis));
        let longest = rests
            .iter()
            .fold(rests[0], |best, rest| if rest.norm() > best.norm() + 1e-9 { *rest } else { best });
        basis.push(longest.normalize());
    }
    ([basis[0], basis[1], basis[2]], held)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn two_planes_of_symmetry_hold_the_director() {
        let supports = [Support::symmetry(vec![0], Vector3::x()), Support::symmetry(vec![0], Vector3::y())];
        let mut director = Director::new(Vector3::z());
        let frame = frame(&supports.each_ref(), &mut director).unwrap();
        assert_eq!((frame.held, frame.turns), (2, 0));
        assert_relative_eq!(frame.axes[2], Vector3::z());
    }

    #[test]
    fn a_plane_across_the_director_is_refused() {
        let supports = [Support::symmetry(vec![0], Vector3::z())];
        assert_eq!(frame(&supports.each_ref(), &mut Director::new(Vector3::z())), Err(Vector3::z()));
    }

    #[test]
    fn the_basis_is_orthonormal_and_repeated_directions_count_once() {
        let oblique = Vector3::new(0.0, 0.6, 0.8);
        let (basis, held) = completed(&[oblique, oblique, Vector3::y()]);
        assert_eq!(held, 2);
        for (i, first) in basis.iter().enumerate() {
            for (j, second) in basis.iter().enumerate() {
                assert_relative_eq!(first.dot(second), f64::from(u8::from(i == j)), epsilon = 1e-14);
            }
        }
        assert_relative_eq!(basis[0], oblique);
    }
}
