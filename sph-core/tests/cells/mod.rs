//! Nodes for shape functions in a surface, and the cells that it cuts: integrals of the first degree are those of the body.

use approx::assert_relative_eq;
use sph_core::{FacePoint, FilledCells, Hexahedra, Vec3};

use super::solids::{Triangles, cuboid, hollow};
use super::{ROUNDING, all, sum};

const RULE: usize = 3;

fn filled(shape: &Triangles, spacing: f64) -> FilledCells {
    shape.closed().unwrap().filled_cells(spacing, RULE).unwrap()
}

#[test]
fn integrals_of_the_first_degree_are_those_of_the_body() {
    for shape in all() {
        let closed = shape.closed().unwrap();
        let (whole, middle) = closed.volume();
        for spacing in [0.3, 0.1] {
            let filled = filled(&shape, spacing);
            let points = || filled.points.iter().flatten();
            assert!(filled.points.iter().all(|own| own.len() == RULE.pow(3)));
            assert!(points().all(|point| point.volume >= 0.0));
            assert_relative_eq!(sum(points().map(|point| point.volume)), whole, max_relative = ROUNDING);
            for axis in 0..3 {
                let moment = sum(points().map(|point| point.volume * point.place[axis]));
                assert_relative_eq!(moment / whole, middle[axis], epsilon = 10.0 * ROUNDING);
            }
            // Nodes share the volume out.
            assert_relative_eq!(sum(filled.block.volumes.iter().copied()), whole, max_relative = ROUNDING);
            // The theorem of Gauss for linear fields: ∮ x n dA is the volume times the unit tensor.
            let faces = filled.face_points(&filled.facets);
            let area = sum(faces.iter().map(|point| point.area().norm()));
            assert_relative_eq!(area, shape.area(), max_relative = ROUNDING);
            for row in 0..3 {
                for column in 0..3 {
                    let flux = |point: &FacePoint| (point.place[row] - middle[row]) * point.area()[column];
                    let wanted = if row == column { whole } else { 0.0 };
                    assert_relative_eq!(
                        sum(faces.iter().map(flux)),
                        wanted,
                        epsilon = 30.0 * ROUNDING * whole
                    );
                }
            }
        }
    }
}

/// Nodes lie inside or on the surface, none nearer to another than four tenths of a spacing, and of those on the surface each touches a triangle.
#[test]
fn outermost_nodes_lie_on_the_surface() {
    let spacing = 0.1;
    let filled = filled(&hollow(1.0, 0.45, 4), spacing);
    let nodes = &filled.block.positions;
    for (a, x) in nodes.iter().enumerate() {
        let apart = nodes[..a].iter().map(|y| (y - x).norm()).fold(f64::INFINITY, f64::min);
        assert!(apart >= 0.4 * spacing, "{apart}");
    }
    let mut on: Vec<u32> = filled.touching.iter().map(|own| own.0).collect();
    on.dedup();
    for &node in &on {
        let r = nodes[node as usize].norm();
        // Of the inscribed polyhedra: .003 of a radius is their sagitta.
        assert!((r - 1.0).abs() < 4e-3 || (r - 0.45).abs() < 4e-3, "{r}");
    }
    let corners: std::collections::BTreeSet<u32> =
        filled.outer.iter().flat_map(|face| face.particles().to_vec()).collect();
    assert!(corners.iter().all(|corner| on.binary_search(corner).is_ok()));
    assert!(on.len() > nodes.len() / 8, "{} of {}", on.len(), nodes.len());
}

#[test]
fn a_box_in_planes_of_the_lattice_is_the_block() {
    let (low, lengths) = (Vec3::new(0.3, -0.7, 1.1), [1.2, 0.6, 0.9]);
    let filled = filled(&cuboid(low, low + Vec3::from(lengths)).divided(), 0.1);
    let planes = [0, 1, 2].map(|axis: usize| {
        let count = (lengths[axis] / 0.1_f64).round() as usize;
        (0..=count).map(|i| low[axis] + lengths[axis] * i as f64 / count as f64).collect::<Vec<f64>>()
    });
    let block = Hexahedra::between(&planes).unwrap();
    assert_eq!((&filled.cells, filled.half_full), (&block.cells, block.cells.len()));
    for (own, other) in filled.block.positions.iter().zip(&block.corners) {
        assert!((own - other).norm() < 1e-14);
    }
    for (own, other) in
        filled.points.iter().flatten().zip(block.volume_points(RULE).unwrap().iter().flatten())
    {
        assert!((own.place - other.place).norm() < 1e-14);
        assert_relative_eq!(own.volume, other.volume, max_relative = 1e-13);
    }
    // Faces by their points, in whatever order.
    for side in 0..6 {
        let of_side: Vec<_> =
            filled.facets.iter().filter(|f| filled.flat[side][f.triangle as usize]).copied().collect();
        let own = filled.face_points(&of_side);
        let other = block.face_points(&block.faces[side], RULE).unwrap();
        assert_eq!(own.len(), other.len());
        for point in &own {
            let near = other.iter().find(|o| (o.place - point.place).norm() < 1e-13).unwrap();
            assert!((near.area() - point.area()).norm() < 1e-14);
        }
    }
}

#[test]
fn a_turned_mirrored_and_divided_surface_gives_the_same() {
    let shape = hollow(1.0, 0.5, 3);
    let own = filled(&shape, 0.17);
    let same = |other: &FilledCells, places: &dyn Fn(&Vec3) -> Vec3| {
        assert_eq!(own.block.len(), other.block.len());
        for (x, v) in own.block.positions.iter().zip(&own.block.volumes) {
            let near = |y: &Vec3| (y - places(x)).norm() < 1e-12;
            let b = other.block.positions.iter().position(near).unwrap();
            assert_relative_eq!(other.block.volumes[b], v, max_relative = 1e-11);
        }
    };
    let mirror = |x: &Vec3| Vec3::new(-x.x, x.y, x.z);
    same(&filled(&shape.clone().mapped(mirror).inside_out(), 0.17), &mirror);
    let turn = |x: &Vec3| Vec3::new(x.y, x.z, x.x);
    same(&filled(&shape.clone().mapped(turn), 0.17), &turn);
    same(&filled(&shape.clone().renumbered(), 0.17), &|x| *x);
    same(&filled(&shape.divided(), 0.17), &|x| *x);
}

/// A sheet of a third of a spacing has no cell that is half full.
#[test]
fn what_is_too_thin_is_refused() {
    let thin = cuboid(Vec3::zeros(), Vec3::new(1.0, 1.0, 0.03)).closed().unwrap();
    let fault = thin.filled_cells(0.1, RULE).unwrap_err();
    assert!(fault.to_string().contains("thinner than half a spacing"), "{fault}");
    let fine = cuboid(Vec3::zeros(), Vec3::repeat(1.0)).closed().unwrap();
    assert!(fine.filled_cells(0.006, 3).unwrap_err().to_string().contains("cells in the box"));
}
