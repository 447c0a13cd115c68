//! Clouds and operators that the invariants run over.
#![allow(dead_code, clippy::unwrap_used)] // every test file uses its part of the tables

use nalgebra::Rotation3;
use sph_core::*;

/// Flat clouds, lattice and disordered, none aligned with the axes of the next.
pub fn flat_clouds() -> Vec<(&'static str, Cloud)> {
    let plate = Plate { lengths: [2.0, 1.5] };
    let lattice = lattice(&plate, [11, 9], EndWeights::Trapezoid).unwrap();
    let jittered = jittered_lattice(&plate, [11, 9], 0.25, 7).unwrap();
    let rotation = Rotation3::from_euler_angles(0.4, -0.7, 1.1);
    let rotated = jittered_lattice(&plate, [10, 9], 0.25, 3)
        .unwrap()
        .transformed(&rotation, &Vec3::new(1.0, -2.0, 0.5));
    let mixed = Cloud::from_cells(jittered.positions.clone(), None, mixed_cells(&jittered)).unwrap();
    let graded = Graded::new(&plate, [9, 8], [4.0, 0.2]).unwrap();
    vec![
        ("lattice", lattice),
        ("jittered", jittered),
        ("rotated", rotated),
        ("mixed", mixed),
        ("strongly jittered", jittered_lattice(&plate, [11, 9], 0.4, 2).unwrap()),
        ("graded", jittered_lattice(&graded, [9, 8], 0.0, 0).unwrap()),
        ("poisson", with_rotated_frames(poisson_cloud(&plate, 0.19, 4).unwrap(), 5)),
    ]
}

/// `cloud` with every frame rotated about its normal by an angle of its own.
pub fn with_rotated_frames(mut cloud: Cloud, seed: u64) -> Cloud {
    for (a, frame) in cloud.frames.iter_mut().enumerate() {
        // The golden angle leaves no two neighbours alike.
        let angle = 2.399_963 * (a as f64 + seed as f64);
        *frame = frame.rotated(&Rotation3::new(frame.n * angle));
    }
    cloud
}

/// The cells of `cloud`, a quarter of them cut into triangles along one diagonal or the other.
fn mixed_cells(cloud: &Cloud) -> Vec<Cell> {
    let mut cells = Vec::new();
    for (c, cell) in cloud.cells.iter().enumerate() {
        let [p, q, r, s] = cell.corners;
        match c % 8 {
            0 => cells.extend([Cell::triangle([p, q, r]), Cell::triangle([p, r, s])]),
            5 => cells.extend([Cell::triangle([q, r, s]), Cell::triangle([q, s, p])]),
            _ => cells.push(*cell),
        }
    }
    cells
}

/// Curved clouds.
pub fn curved_clouds() -> Vec<(&'static str, Cloud)> {
    let roof = Cylinder { radius: 2.0, angles: [-0.6, 0.9], length: 3.0 };
    let dome = Sphere { radius: 10.0, polar: [0.4, 1.5], azimuth: [0.0, 1.5] };
    let strip = Twisted { length: 3.0, width: 1.0, twist: 1.5 };
    let wave = Parametric {
        position: |u: f64, v: f64| Vec3::new(u, v, 0.2 * libm::sin(2.0 * u) * v),
        range: [[0.0, 2.0], [0.0, 1.0]],
    };
    vec![
        ("roof", lattice(&roof, [9, 11], EndWeights::Trapezoid).unwrap()),
        ("dome", jittered_lattice(&dome, [11, 11], 0.25, 1).unwrap()),
        ("wave", jittered_lattice(&wave, [13, 8], 0.2, 5).unwrap()),
        ("strip", jittered_lattice(&strip, [15, 7], 0.2, 2).unwrap()),
        ("scattered roof", with_rotated_frames(poisson_cloud(&roof, 0.28, 1).unwrap(), 1)),
    ]
}

/// Every operator of the crate on `cloud`, by name.
pub fn operators(cloud: &Cloud) -> Vec<(String, SamplingOperator)> {
    let mut list = vec![("cell".to_string(), cell_operator(cloud).unwrap())];
    for kernel in kernels() {
        let name = kernel.name();
        for reach in [1.4, 1.8] {
            list.push((format!("kernel {name} {reach}"), kernel_operator(cloud, kernel, reach).unwrap()));
        }
        // Supports of 2.6, 2.6 and 3.2 spacings for every kernel (the studies' 1.3 and 1.6 h of the cubic spline).
        for (order, radius) in [(1, 2.4), (2, 2.6), (3, 3.2)] {
            let smoothing = radius / kernel.support();
            list.push((
                format!("nodal {name} {order}"),
                nodal_operator(cloud, kernel, order, smoothing).unwrap(),
            ));
        }
    }
    list
}
