//! Bodies whose nodes fill a closed surface: a thick hollow sphere under inner pressure beside Lamé's closed form.
#![allow(clippy::unwrap_used)] // set-up that fails is a test that fails

mod lattices;

use explicit_dynamics::Amplitude;
use implicit_statics::{Equilibrium, linear_response};
use lattices::{formulation, parts};
use peridynamics::*;
use sph_core::{Carried, ClosedSurface, Facet, Filled, Vec3, by_node, spread};

/// An eighth of a hollow sphere, its faces triangles; those of the cavity come first, then those of the outer sphere.
fn octant(inner: f64, outer: f64, n: usize) -> (Vec<Vec3>, Vec<[u32; 3]>, usize) {
    let mut vertices = Vec::new();
    let mut grid = vec![vec![0; n + 1]; n + 1];
    for i in 0..=n {
        for j in 0..=n - i {
            grid[i][j] = vertices.len() as u32;
            vertices.push(Vec3::new(i as f64, j as f64, (n - i - j) as f64).normalize());
        }
    }
    let mut sphere = Vec::new();
    for i in 0..n {
        for j in 0..n - i {
            sphere.push([grid[i][j], grid[i + 1][j], grid[i][j + 1]]);
            if i + j + 2 <= n {
                sphere.push([grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1]]);
            }
        }
    }
    // Out by as much as makes the volume under the triangles that of the sphere.
    let cone = |&[a, b, c]: &[u32; 3]| {
        let [a, b, c] = [a, b, c].map(|k| vertices[k as usize]);
        a.dot(&b.cross(&c)) / 6.0
    };
    let out = libm::cbrt(std::f64::consts::PI / 6.0 / sphere.iter().map(cone).sum::<f64>());
    let count = vertices.len() as u32;
    let of = |radius: f64| vertices.iter().map(move |x| x * (radius * out)).collect::<Vec<_>>();
    let all = [of(inner), of(outer)].concat();
    let mut triangles: Vec<[u32; 3]> = sphere.iter().map(|&[a, b, c]| [a, c, b]).collect();
    triangles.extend(sphere.iter().map(|corners| corners.map(|k| k + count)));
    let mut edges: Vec<Vec<u32>> = vec![(0..=n).map(|j| grid[0][j]).collect()];
    edges.push((0..=n).map(|i| grid[n - i][0]).collect());
    edges.push((0..=n).map(|i| grid[i][n - i]).collect());
    for edge in edges {
        for pair in edge.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            triangles.extend([[a + count, b + count, b], [a + count, b, a]]);
        }
    }
    (all, triangles, n * n)
}

fn pressed(filled: &Filled, cavity: usize, pressure: f64, law: Law, horizon: f64) -> StaticSolid {
    let of_cavity = filled.facets.iter().filter(|facet| (facet.triangle as usize) < cavity);
    let forces: Vec<(Facet, Vec3)> = of_cavity.map(|facet| (*facet, facet.area * -pressure)).collect();
    let forces = spread(&filled.block, &[0, 1, 2].map(|axis| (axis, 0.0)), &forces).forces;
    let material = Elastic { young: 1.0, poisson: 0.25, density: 1.0 };
    let formulation = Formulation { horizon, ..formulation(Space::Solid, law) };
    let loads = vec![AppliedLoad { forces, amplitude: Amplitude::Constant }];
    let parts = Parts { loads, ..parts(filled.block.clone(), material, formulation) };
    let planes = [0, 1, 2].map(|axis| Mirror { axis, at: 0.0 });
    StaticSolid::new(Solid::mirrored(parts, &planes).unwrap())
}

/// Radial displacement of Lamé's sphere of unit Young's modulus under a pressure of one inside.
fn lame(r: f64, [a, b]: [f64; 2]) -> f64 {
    let nu = 0.25;
    let (a3, b3) = (a.powi(3), b.powi(3));
    a3 / (b3 - a3) * ((1.0 - 2.0 * nu) * r + (1.0 + nu) * b3 / (2.0 * r * r))
}

/// The forces on nodes of a pressure that follows all of a hollow ball, its nodes put to places; and the volume under the triangles that they carry.
fn followed(filled: &Filled, surface: &Carried, place: impl Fn(&Vec3) -> Vec3) -> (Vec<Vec3>, f64) {
    let material = Elastic { young: 1.0, poisson: 0.25, density: 1.0 };
    let formulation = Formulation { horizon: 2.015, ..formulation(Space::Solid, Law::StateBased) };
    let mut solid = Solid::new(parts(filled.block.clone(), material, formulation)).unwrap();
    let pressure =
        FollowingPressure { surface: surface.clone(), pressure: 0.3, amplitude: Amplitude::Constant };
    solid.follow(pressure).unwrap();
    for (node, x) in filled.block.positions.iter().enumerate() {
        solid.put(node, place(x));
    }
    let mut system = StaticSolid::new(solid);
    system.evaluate(1.0);
    let forces = (0..filled.block.len()).map(|node| system.solid().external_force(node)).collect();
    let places = surface.places(|node| place(&filled.block.positions[node as usize]));
    let cone = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(|corner| places[corner as usize]);
        a.dot(&b.cross(&c)) / 6.0
    };
    (forces, surface.triangles.iter().map(cone).sum())
}

#[test]
fn a_pressure_that_follows_does_the_work_of_the_volume_it_takes() {
    let (vertices, triangles, cavity) = octant(1.0, 2.0, 6);
    let surface = ClosedSurface::new(vertices, triangles).unwrap();
    let filled = surface.filled(0.25).unwrap();
    let carried = surface.carried(&filled.block, 0.25);
    let edges = carried.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    let length = |(a, b): (u32, u32)| (carried.vertices[a as usize] - carried.vertices[b as usize]).norm();
    assert!(edges.map(length).fold(0.0, f64::max) <= 0.25);
    let bend = |x: &Vec3| x + Vec3::new(0.1 * x.y * x.z, 0.2 * x.x * x.x - 0.1 * x.z, 0.15 * x.y * x.y);
    let (forces, volume) = followed(&filled, &carried, bend);
    let size: f64 = forces.iter().map(|force| force.norm()).sum();
    // Closed: neither resultant nor moment, whatever the nodes do. Measured 1e-15.
    let resultant: Vec3 = forces.iter().sum();
    let moment: Vec3 =
        filled.block.positions.iter().zip(&forces).map(|(x, force)| bend(x).cross(force)).sum();
    assert!(resultant.norm() < 1e-13 * size && moment.norm() < 1e-12 * size, "{resultant} {moment}");
    // −p ∂V/∂x along a way of the nodes, against the difference of the volume.
    let way = |x: &Vec3| Vec3::new(x.z * x.z, x.x * x.y, -x.x);
    let step = 1e-5;
    let at = |sign: f64| followed(&filled, &carried, |x| bend(x) + way(x) * (sign * step)).1;
    let (taken, work): (f64, f64) = (
        (at(1.0) - at(-1.0)) / (2.0 * step),
        filled.block.positions.iter().zip(&forces).map(|(x, f)| f.dot(&way(x))).sum(),
    );
    assert!((work + 0.3 * taken).abs() < 1e-9 * size, "{work} {taken} {volume}");
    // Turned with the nodes.
    let turn = nalgebra::Rotation3::new(Vec3::new(0.4, -1.1, 0.7));
    let (turned, _) = followed(&filled, &carried, |x| turn * bend(x) + Vec3::new(3.0, 1.0, -2.0));
    let off = forces.iter().zip(&turned).map(|(f, g)| (turn * f - g).norm()).fold(0.0, f64::max);
    assert!(off < 1e-13 * size, "{off}");
    // At rest and on a part: the pressure times the area of the triangles, a uniform stretch by the cofactor.
    let part = carried.only(|number| (carried.part_of[number] as usize) < cavity);
    let stretch = nalgebra::Matrix3::new(1.2, 0.1, 0.0, 0.0, 0.9, 0.2, -0.1, 0.0, 1.1);
    let area: Vec3 =
        filled.facets.iter().filter(|f| (f.triangle as usize) < cavity).map(|facet| facet.area).sum();
    let wanted = stretch.try_inverse().unwrap().transpose() * stretch.determinant() * area * -0.3;
    let found: Vec3 = followed(&filled, &part, |x| stretch * x).0.iter().sum();
    assert!((found - wanted).norm() < 1e-13 * size, "{found} {wanted}");
}

/// Mean radial displacement of the nodes of a part of the surface over that of Lamé at their places.
fn over_lame(filled: &Filled, solid: &Solid, pressure: f64, wanted: std::ops::Range<usize>) -> f64 {
    let part = filled.facets.iter().filter(|facet| wanted.contains(&(facet.triangle as usize)));
    let nodes = by_node(part);
    let of = |node: usize| {
        let x = solid.block().positions[node];
        solid.displacement(node).dot(&x.normalize()) / pressure / lame(x.norm(), [1.0, 2.0])
    };
    let area: f64 = nodes.iter().map(|(_, area, _)| area).sum();
    nodes.iter().map(|&(node, part, _)| part * of(node as usize)).sum::<f64>() / area
}

#[test]
fn a_hollow_sphere_widens_as_lame_says() {
    let (vertices, triangles, cavity) = octant(1.0, 2.0, 24);
    let surface = ClosedSurface::new(vertices, triangles).unwrap();
    let pressure = 1e-6;
    let mut off = Vec::new();
    let measured =
        [(0.125, 1.5, 0.102), (0.125, 2.015, 0.179), (0.125, 3.015, 0.421), (0.0909, 2.015, 0.127)];
    for (spacing, horizon, too_far) in measured {
        let filled = surface.filled(spacing).unwrap();
        let mut system = pressed(&filled, cavity, pressure, Law::StateBased, horizon);
        let answer = linear_response(&mut system, 0.0).unwrap();
        system.update(&answer);
        let outer = over_lame(&filled, system.solid(), pressure, cavity..2 * cavity);
        let inner = over_lame(&filled, system.solid(), pressure, 0..cavity);
        println!("{spacing}, {horizon}: outer {outer:.4}, inner {inner:.4}");
        // Asked 2 %; measured 1.7, .9, .6 and .6 % too stiff.
        assert!((outer - 1.0).abs() < 0.02, "{outer}");
        off.push((outer - 1.0).abs());
        // The loaded face lacks bonds and moves too far, the more the wider the horizon: as it was measured, to a tenth of it
        // (docs/peridynamics.md).
        assert!((inner - 1.0 - too_far).abs() < 0.1 * too_far, "{inner}");
    }
    assert!(off[3] < off[1], "it falls with the spacing: {off:?}");
}
