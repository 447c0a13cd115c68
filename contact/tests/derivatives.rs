//! Forces of a surface on every tool against differences of its energy, its tangent against differences of its forces.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use contact::{Law, Pose, Surface, ToolContact, ToolShape, Watch};
use sph_core::{Cell, Vec3};

/// Six particles, two cells that are not flat, of unlike thickness.
fn sheet() -> (Vec<Vec3>, Surface) {
    let places = [
        [0.0, 0.0, 0.01],
        [1.0, 0.1, -0.02],
        [2.1, 0.0, 0.03],
        [0.1, 0.9, 0.0],
        [1.1, 1.0, 0.02],
        [2.0, 1.1, -0.01],
    ];
    let rest: Vec<Vec3> = places.iter().map(|&[x, y, z]| Vec3::new(x, y, z)).collect();
    let cells = [Cell { corners: [0, 1, 4, 3], count: 4 }, Cell { corners: [1, 2, 5, 4], count: 4 }];
    let surface = Surface::new(&cells, &rest, |a| 0.1 + 0.01 * f64::from(a));
    (rest, surface)
}

/// Tools into which the sheet reaches to a quarter and beyond the half of its half thickness.
fn tools() -> [ToolShape; 4] {
    let below = Vec3::new(0.9, 0.5, -5.04);
    [
        ToolShape::Plane { point: Vec3::new(0.0, 0.0, -0.05), normal: Vec3::new(0.01, -0.02, 1.0) },
        ToolShape::Sphere { centre: below, radius: 5.0 },
        ToolShape::Cylinder { point: below, axis: Vec3::new(0.3, 1.0, 0.0), radius: 5.0 },
        ToolShape::Capsule { ends: [below, below + Vec3::x()], radius: 5.0 },
    ]
    .map(|tool| tool.checked().unwrap())
}

/// Differences of 1e-6 over lengths of .1: relative errors of 1e-8 measured at most.
#[test]
fn forces_and_tangent_are_derivatives() {
    let (rest, surface) = sheet();
    let (h, moved) = (1e-6, Vec3::new(0.0, 0.0, 0.013));
    for tool in tools() {
        for rounding in [0.0, 0.05] {
            let contact = ToolContact {
                tool,
                surface: surface.clone(),
                law: Law::new(rounding).unwrap(),
                stiffness: 3.0,
            };
            let forces = |places: &[Vec3], moved: &Vec3| {
                let mut rows = vec![Vec3::zeros(); places.len()];
                let touch = contact.forces(
                    &mut Watch::new(&contact.surface),
                    None,
                    &Pose::moved(*moved),
                    |a| places[a as usize],
                    |a, force| rows[a as usize] += force,
                );
                (touch, rows)
            };
            let (touch, rows) = forces(&rest, &moved);
            assert!(touch.greatest_depth > 0.3 && touch.greatest_depth < 0.9, "{tool:?}: {touch:?}");
            let scale = rows.iter().map(Vec3::norm).fold(0.0, f64::max);
            let mut tangent = vec![[[0.0; 3]; 3]; 36];
            contact.tangent(
                None,
                &Pose::moved(moved),
                |a| rest[a as usize],
                |a, b, block| {
                    for i in 0..3 {
                        for k in 0..3 {
                            tangent[6 * a as usize + b as usize][i][k] += block[(i, k)];
                        }
                    }
                },
            );
            let mut rates = [Vec3::zeros(); 6];
            let way = Vec3::new(0.2, -0.1, 1.0);
            contact.rates(
                None,
                &Pose::moved(moved),
                &Pose::moved(way),
                |a| rest[a as usize],
                |a, rate| rates[a as usize] += rate,
            );
            for b in 0..6 {
                for k in 0..3 {
                    let shifted = |by: f64| {
                        let mut places = rest.clone();
                        places[b][k] += by;
                        forces(&places, &moved)
                    };
                    let ((low, below), (high, above)) = (shifted(-h), shifted(h));
                    let slope = -(high.energy - low.energy) / (2.0 * h);
                    assert!(
                        (slope - rows[b][k]).abs() < 1e-7 * scale,
                        "{tool:?}, {rounding}: {slope} {}",
                        rows[b][k]
                    );
                    for a in 0..6 {
                        for i in 0..3 {
                            let change = (above[a][i] - below[a][i]) / (2.0 * h);
                            let own = tangent[6 * a + b][i][k];
                            assert!(
                                (change - own).abs() < 1e-5 * scale / 0.1,
                                "{tool:?}, {rounding}: {change} {own}"
                            );
                        }
                    }
                }
            }
            let [(_, below), (_, above)] = [-h, h].map(|by| forces(&rest, &(moved + way * by)));
            for a in 0..6 {
                let change = (above[a] - below[a]) / (2.0 * h);
                assert!((change - rates[a]).norm() < 1e-5 * scale / 0.1, "{tool:?}: {change} {}", rates[a]);
            }
        }
    }
}
