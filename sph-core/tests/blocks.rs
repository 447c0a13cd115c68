//! Blocks of nodes: volumes, faces, cells; growing spacings, disorder, what is cut out.
#![allow(clippy::unwrap_used)] // set-up that fails is a test that fails

use approx::assert_relative_eq;
use sph_core::*;

/// A box of 2 × 1 × 0.5 with its corner at (1, −1, 3), about 0.1 apart.
fn brick(nodes: NodePlaces) -> BlockLattice {
    BlockLattice {
        dimensions: 3,
        lengths: [2.0, 1.0, 0.5],
        spacing: [0.11, 0.1, 0.13],
        origin: Vec3::new(1.0, -1.0, 3.0),
        nodes,
        grading: [1.0; 3],
        disorder: 0.0,
        seed: 0,
    }
}

fn plate(nodes: NodePlaces) -> BlockLattice {
    BlockLattice { dimensions: 2, ..brick(nodes) }
}

/// Both kinds of nodes, in a plane and in space, even and graded, in order and in disorder.
fn all() -> Vec<BlockLattice> {
    let mut all = Vec::new();
    for nodes in [NodePlaces::Centres, NodePlaces::Edges] {
        for lattice in [brick(nodes), plate(nodes)] {
            all.push(BlockLattice { grading: [3.0, 0.5, 1.0], disorder: 0.3, seed: 7, ..lattice.clone() });
            all.push(lattice);
        }
    }
    all
}

fn sum(list: &[(u32, f64)]) -> f64 {
    list.iter().map(|(_, area)| area).sum()
}

#[test]
fn volumes_and_faces_sum_to_those_of_the_box() {
    for lattice in all() {
        let block = lattice.block().unwrap();
        let [a, b, c] = lattice.lengths;
        assert_relative_eq!(block.volumes.iter().sum::<f64>(), a * b * c, max_relative = 1e-13);
        for (axis, area) in [b * c, c * a, a * b].into_iter().enumerate() {
            for face in &block.faces[2 * axis..2 * axis + 2] {
                assert_relative_eq!(sum(face), area, max_relative = 1e-13);
            }
        }
    }
}

#[test]
fn spacings_divide_the_lengths() {
    let centres = brick(NodePlaces::Centres).block().unwrap();
    assert_eq!(brick(NodePlaces::Centres).cells().unwrap(), [18, 10, 4]);
    assert_eq!(centres.len(), 18 * 10 * 4);
    assert_relative_eq!(centres.spacing[0], 2.0 / 18.0, max_relative = 1e-14);
    assert_eq!(centres.positions[0], Vec3::new(1.0 + 1.0 / 18.0, -0.95, 3.0625));
    let edges = brick(NodePlaces::Edges).block().unwrap();
    assert_eq!(edges.len(), 19 * 11 * 5);
    assert_eq!(edges.positions[0], Vec3::new(1.0, -1.0, 3.0));
    assert_eq!(edges.positions[edges.len() - 1], Vec3::new(3.0, 0.0, 3.5));
    // A corner has an eighth of a cell, the next node on the edge a quarter.
    let cell: f64 = edges.spacing.iter().product();
    assert_relative_eq!(edges.volumes[0], cell / 8.0, max_relative = 1e-13);
    assert_relative_eq!(edges.volumes[1], cell / 4.0, max_relative = 1e-13);
    // A plane block lies in its plane and has its thickness as its last spacing.
    let plane = plate(NodePlaces::Edges).block().unwrap();
    assert_eq!((plane.len(), plane.spacing[2]), (19 * 11, 0.5));
    assert!(plane.positions.iter().all(|x| x.z == 3.0));
    assert_eq!(plane.greatest_spacing(), plane.spacing[0]);
}

#[test]
fn cells_of_a_plane_fill_what_lies_between_its_nodes() {
    let area = |lattice: &BlockLattice| {
        let block = lattice.block().unwrap();
        block.cells.iter().map(|cell| cell.geometry(&block.positions).area).sum::<f64>()
    };
    assert_relative_eq!(area(&plate(NodePlaces::Edges)), 2.0, max_relative = 1e-13);
    assert_relative_eq!(area(&plate(NodePlaces::Centres)), (2.0 - 2.0 / 18.0) * 0.9, max_relative = 1e-13);
    let block = plate(NodePlaces::Edges).block().unwrap();
    assert!(block.cells.iter().all(|cell| cell.geometry(&block.positions).normal.z == 1.0));
    assert!(brick(NodePlaces::Edges).block().unwrap().cells.is_empty());
}

#[test]
fn graded_spacings_grow_from_end_to_end() {
    let lattice = BlockLattice { grading: [4.0, 1.0, 1.0], ..plate(NodePlaces::Edges) };
    let block = lattice.block().unwrap();
    let column: Vec<f64> = (0..19).map(|i| block.positions[11 * i].x).collect();
    let gaps: Vec<f64> = column.windows(2).map(|pair| pair[1] - pair[0]).collect();
    assert_relative_eq!(gaps[17] / gaps[0], 4.0, max_relative = 1e-12);
    assert_relative_eq!(gaps[1] / gaps[0], gaps[17] / gaps[16], max_relative = 1e-12);
    assert_eq!((column[0], column[18]), (1.0, 3.0));
    assert_relative_eq!(block.spacing[0], gaps[17], max_relative = 1e-14);
}

#[test]
fn disorder_keeps_nodes_near_their_places_and_on_their_faces() {
    let lattice = BlockLattice { disorder: 0.4, seed: 3, ..brick(NodePlaces::Edges) };
    let (block, even) = (lattice.block().unwrap(), brick(NodePlaces::Edges).block().unwrap());
    assert_eq!(block.positions, lattice.block().unwrap().positions);
    assert_ne!(block.positions, BlockLattice { seed: 4, ..lattice }.block().unwrap().positions);
    assert_eq!(block.volumes, even.volumes);
    let mut greatest = [0.0_f64; 3];
    for (x, y) in block.positions.iter().zip(&even.positions) {
        for axis in 0..3 {
            greatest[axis] = greatest[axis].max((x - y)[axis].abs() / block.spacing[axis]);
        }
    }
    assert!(greatest.iter().all(|most| (0.35..=0.4).contains(most)), "{greatest:?}");
    for (face, list) in block.faces.iter().enumerate() {
        let axis = face / 2;
        let flat =
            |&(a, _): &(u32, f64)| block.positions[a as usize][axis] == even.positions[a as usize][axis];
        assert!(list.iter().all(flat));
    }
}

#[test]
fn a_cut_out_takes_what_lies_in_it_and_nothing_else() {
    let centre = Vec3::new(2.0, -0.5, 3.25);
    let cut_outs = [
        CutOut::Ball { centre, radius: 0.2 },
        CutOut::Cylinder { point: centre, axis: Vec3::z(), radius: 0.2 },
        CutOut::Box { min: Vec3::new(0.0, -2.0, 3.0), max: Vec3::new(1.3, -0.6, 3.2) },
        // An arrow with an inner corner at (2, −0.6).
        CutOut::Prism(vec![[1.5, -1.0], [2.0, -0.6], [2.5, -1.0], [2.0, 0.0]]),
    ];
    let whole = brick(NodePlaces::Centres).block().unwrap();
    for cut_out in &cut_outs {
        let taken: Vec<&Vec3> = whole.positions.iter().filter(|x| cut_out.holds(x)).collect();
        let rest = whole.clone().without(std::slice::from_ref(cut_out));
        assert!(!taken.is_empty());
        assert_eq!(rest.len() + taken.len(), whole.len());
        assert!(rest.positions.iter().all(|x| !cut_out.holds(x)));
        assert_eq!(rest.volumes.len(), rest.len());
    }
    let inside = |x: f64, y: f64| cut_outs[3].holds(&Vec3::new(x, y, 0.0));
    assert!(inside(2.0, -0.3) && !inside(2.0, -0.7) && inside(1.7, -0.8) && !inside(1.4, -0.8));
}

#[test]
fn faces_and_cells_follow_the_nodes_that_are_left() {
    let whole = plate(NodePlaces::Centres).block().unwrap();
    let corner = CutOut::Box { min: Vec3::new(1.0, -1.0, 3.0), max: Vec3::new(2.0, -0.5, 3.0) };
    let block = whole.without(&[corner]);
    // A quarter of the plate is gone: half of the faces x0 and y0.
    assert_eq!(block.len(), 135);
    assert_relative_eq!(sum(&block.faces[0]), 0.25, max_relative = 1e-13);
    assert_relative_eq!(sum(&block.faces[2]), 0.5, max_relative = 1e-13);
    assert_relative_eq!(sum(&block.faces[1]), 0.5, max_relative = 1e-13);
    assert!(block.faces[0].iter().all(|&(a, _)| block.positions[a as usize].x < 1.1));
    assert_eq!(block.cells.len(), 17 * 9 - 9 * 5);
    let spacing = block.spacing;
    for cell in &block.cells {
        let geometry = cell.geometry(&block.positions);
        assert_relative_eq!(geometry.area, spacing[0] * spacing[1], max_relative = 1e-12);
    }
}

#[test]
fn wrong_blocks_are_refused() {
    let plate = || plate(NodePlaces::Centres);
    for (lattice, what) in [
        (BlockLattice { lengths: [0.0, 1.0, 1.0], ..plate() }, "length"),
        (BlockLattice { spacing: [0.1, -0.1, 0.1], ..plate() }, "spacing"),
        (BlockLattice { lengths: [1.0, 1.0, f64::NAN], ..plate() }, "length"),
        (BlockLattice { spacing: [1e-9, 1e-9, 0.1], ..plate() }, "number of nodes"),
        (BlockLattice { grading: [1.0, 1e4, 1.0], ..plate() }, "grading"),
        (BlockLattice { disorder: 0.5, ..plate() }, "disorder"),
    ] {
        match lattice.block() {
            Err(SpaceError::OutOfRange { what: found, .. }) => assert_eq!(found, what),
            other => panic!("{what}: {other:?}"),
        }
    }
    // The spacing across a plane does not count.
    assert!(BlockLattice { spacing: [0.1, 0.1, 0.0], ..plate() }.block().is_ok());
}
