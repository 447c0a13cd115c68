//! Poisson clouds: distances, edges, cells, repetition; and strongly disordered lattices with cells of their own.
#![allow(clippy::unwrap_used)] // set-up that fails is a test that fails

use approx::assert_relative_eq;
use sph_core::*;

const SIDES: [Side; 4] = [Side::U0, Side::U1, Side::V0, Side::V1];

fn roof() -> Cylinder {
    Cylinder { radius: 2.0, angles: [-0.5, 0.5], length: 1.0 }
}

/// Quarter of a hemisphere with a hole of 18°: the metric along v varies by more than three.
fn dome() -> Sphere {
    Sphere { radius: 10.0, polar: [0.1 * std::f64::consts::PI, 1.57], azimuth: [0.0, 1.57] }
}

/// Least distance between any two particles.
fn nearest(cloud: &Cloud) -> f64 {
    let list = CellList::new(&cloud.positions, cloud.spacing());
    cloud.positions.iter().map(|x| list.nearest(x, 2)).fold(f64::INFINITY, f64::min)
}

/// Least and greatest corner of the cells in degrees, and the share of triangles among them.
fn corners(cloud: &Cloud) -> (f64, f64, f64) {
    let (mut least, mut greatest, mut triangles) = (180.0_f64, 0.0_f64, 0);
    for cell in &cloud.cells {
        let x: Vec<Vec3> = cell.particles().iter().map(|&a| cloud.positions[a as usize]).collect();
        let m = x.len();
        triangles += usize::from(m == 3);
        for i in 0..m {
            let angle = (x[(i + 1) % m] - x[i]).angle(&(x[(i + m - 1) % m] - x[i])).to_degrees();
            least = least.min(angle);
            greatest = greatest.max(angle);
        }
    }
    (least, greatest, triangles as f64 / cloud.cells.len() as f64)
}

#[test]
fn particles_keep_their_distance_and_fill_the_surface() {
    let plate = Plate { lengths: [2.0, 1.0] };
    // patch, area, spacing
    let cases: [(&dyn Patch, f64, f64); 3] = [
        (&plate, 2.0, 0.05),
        (&roof(), 2.0, 0.05),
        (&dome(), 100.0 * 1.57 * (libm::cos(0.1 * std::f64::consts::PI) - libm::cos(1.57_f64)), 0.4),
    ];
    for (patch, area, spacing) in cases {
        for seed in 0..3 {
            let cloud = poisson_cloud(patch, spacing, seed).unwrap();
            assert!(nearest(&cloud) >= 0.8 * spacing);
            // Flat cells inside a curved outline lack Δ²/R² of the area at most.
            assert_relative_eq!(cloud.areas.iter().sum::<f64>(), area, max_relative = 2e-3);
            // Random throws at 0.8 of the spacing leave about one particle per spacing squared.
            assert!((cloud.spacing() / spacing - 1.0).abs() < 0.05, "{}", cloud.spacing() / spacing);
            // Where no throw fits, Delaunay angles exceed 30° (circles of at most the least distance); thirty throws
            // leave a few larger gaps: 25°. Pairs are taken from 10° to 170°; a few per cent of triangles are left.
            let (least, greatest, triangles) = corners(&cloud);
            assert!(least > 25.0 && greatest < 170.1 && triangles < 0.05, "{least} {greatest} {triangles}");
        }
    }
}

#[test]
fn edges_hold_evenly_spaced_particles_in_order() {
    let dome = dome();
    let cloud = poisson_cloud(&dome, 1.0, 3).unwrap();
    let sides = cloud.sides.as_ref().unwrap();
    let [[u0, u1], [v0, v1]] = dome.range();
    let meridian = 10.0 * (u1 - u0);
    let parallels = [10.0 * libm::sin(u0) * (v1 - v0), 10.0 * libm::sin(u1) * (v1 - v0)];
    for (side, length) in SIDES.into_iter().zip([parallels[0], parallels[1], meridian, meridian]) {
        let edge = sides.edge(side);
        assert_eq!(edge.len(), length.round() as usize + 1);
        let gaps: Vec<f64> = edge
            .windows(2)
            .map(|w| (cloud.positions[w[1] as usize] - cloud.positions[w[0] as usize]).norm())
            .collect();
        for gap in &gaps {
            assert_relative_eq!(*gap, gaps[0], max_relative = 1e-9);
        }
    }
    for (first, second, u, v) in
        [(Side::U0, Side::V0, u0, v0), (Side::U1, Side::V0, u1, v0), (Side::V1, Side::U1, u1, v1)]
    {
        let corner = sides.corner(first, second).unwrap() as usize;
        assert_relative_eq!(cloud.positions[corner], dome.position(u, v), epsilon = 1e-12);
    }
    // The outline of the cells is the four edges: as many boundary particles, and their length.
    let outline = SIDES.iter().map(|&side| sides.edge(side).len() - 1).sum::<usize>();
    assert_eq!(cloud.edge_lengths.iter().filter(|&&length| length > 0.0).count(), outline);
}

#[test]
fn edges_of_a_stretched_patch_are_even_in_arc_length() {
    // u runs as its square: equal parameters would crowd the first end.
    let strip =
        Parametric { position: |u: f64, v: f64| Vec3::new(u * u, v, 0.0), range: [[0.2, 1.0], [0.0, 0.5]] };
    let cloud = poisson_cloud(&strip, 0.08, 1).unwrap();
    let edge = cloud.sides.as_ref().unwrap().edge(Side::V0).to_vec();
    assert_eq!(edge.len(), 13); // 0.96 / 0.08 + 1
    for pair in edge.windows(2) {
        let gap = cloud.positions[pair[1] as usize].x - cloud.positions[pair[0] as usize].x;
        assert_relative_eq!(gap, 0.08, max_relative = 1e-3); // straight lines between 128 places
    }
}

#[test]
fn the_same_seed_gives_the_same_cloud_and_neighbours_have_near_numbers() {
    let plate = Plate { lengths: [1.0, 1.0] };
    let cloud = poisson_cloud(&plate, 0.05, 7).unwrap();
    assert_eq!(cloud, poisson_cloud(&plate, 0.05, 7).unwrap());
    assert_ne!(cloud.positions, poisson_cloud(&plate, 0.05, 8).unwrap().positions);
    // Two to three strips of about 21 to 27 particles lie between the corners of a cell.
    let reach = cloud.cells.iter().map(|cell| {
        let corners = cell.particles();
        corners.iter().max().unwrap() - corners.iter().min().unwrap()
    });
    assert!(reach.max().unwrap() < 110);
}

#[test]
fn the_cloud_scales_with_its_unit() {
    let small = poisson_cloud(&Plate { lengths: [1.0, 0.5] }, 0.05, 2).unwrap();
    for factor in [1e-9, 1e9] {
        let plate = Plate { lengths: [factor, 0.5 * factor] };
        let cloud = poisson_cloud(&plate, 0.05 * factor, 2).unwrap();
        assert_eq!(cloud.cells, small.cells);
        for (x, y) in cloud.positions.iter().zip(&small.positions) {
            assert_relative_eq!(x / factor, y, epsilon = 1e-12);
        }
    }
}

#[test]
fn spacings_that_make_no_cloud_are_refused() {
    let plate = Plate { lengths: [2.0, 0.5] };
    for spacing in [0.0, -1.0, f64::NAN, 0.51, 1e-5] {
        let error = poisson_cloud(&plate, spacing, 1).unwrap_err();
        assert!(matches!(error, SpaceError::Spacing { .. }), "{error}");
    }
    let narrow = poisson_cloud(&plate, 0.5, 1).unwrap();
    assert_eq!(narrow.sides.as_ref().unwrap().edge(Side::U0).len(), 2);
    let message = poisson_cloud(&plate, 0.6, 1).unwrap_err().to_string();
    assert_eq!(
        message,
        "spacing = 0.6 is outside [3.162e-4, 0.500000], from ten million particles to the length of the shortest edge; \
         choose a spacing in that range"
    );
}

#[test]
fn strong_disorder_gets_cells_without_inner_corners() {
    let plate = Plate { lengths: [1.0, 1.0] };
    for seed in 0..5 {
        let cloud = jittered_lattice(&plate, [15, 15], 0.4, seed).unwrap();
        let (least, greatest, triangles) = corners(&cloud);
        assert!(least > 5.0 && greatest < 170.1 && triangles < 0.1, "{least} {greatest} {triangles}");
        assert_relative_eq!(cloud.areas.iter().sum::<f64>(), 1.0, epsilon = 1e-12);
        assert_eq!(cloud.lattice, Some(Lattice { counts: [15, 15] }));
    }
    let mild = jittered_lattice(&plate, [15, 15], 0.25, 1).unwrap();
    assert!(mild.cells.iter().all(|cell| cell.count == 4) && mild.cells.len() == 14 * 14);
}
