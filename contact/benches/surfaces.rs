//! What two sheets of 22 500 particles cost together: a look at what touches with its forces, far, near and touching all over; a list.
//!
//! Times are per particle. `cargo bench -p contact --bench surfaces`

use contact::{Law, Mesh, Node, SurfaceContact, Touching};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use sph_core::{Cell, Vec3};

/// Particles along a side of a sheet.
const SIDE: u32 = 106;
/// Distance at which faces touch; cells are one wide.
const DISTANCE: f64 = 0.1;

/// A sheet a little off the places of another, at a height, waved so that no two faces are alike.
fn sheet(shift: f64, height: f64) -> (Vec<Cell>, Vec<Vec3>) {
    let place = |a: u32| {
        let [x, y] = [a % SIDE, a / SIDE].map(|i| f64::from(i) + shift);
        Vec3::new(x, 1.03 * y, height + 0.2 * libm::sin(0.1 * x) * libm::cos(0.07 * y))
    };
    let cell = |a: u32| Cell { corners: [a, a + 1, a + SIDE + 1, a + SIDE], count: 4 };
    let cells = (0..SIDE * (SIDE - 1)).filter(|a| a % SIDE < SIDE - 1).map(cell).collect();
    (cells, (0..SIDE * SIDE).map(place).collect())
}

/// Two sheets in one surface that touches itself, at a distance of their middles.
fn stack(distance: f64, edges: bool) -> (SurfaceContact, Vec<Vec3>) {
    let (mut cells, mut places) = sheet(0.0, 0.0);
    let (others, above) = sheet(0.3, distance);
    let moved = |cell: Cell| Cell { corners: cell.corners.map(|a| a + SIDE * SIDE), ..cell };
    cells.extend(others.into_iter().map(moved));
    places.extend(above);
    let law = Law::new(0.05).expect("a law");
    let touching = Touching { distance: DISTANCE, law, stiffness: 1.0, skin: 0.3, edges };
    let mesh = Mesh::new(&cells, &places, |_| 0.5 * DISTANCE);
    (SurfaceContact::itself(mesh, &places, touching), places)
}

fn look(c: &mut Criterion) {
    let mut group = c.benchmark_group("a look, two sheets of 11 236 particles");
    group.throughput(Throughput::Elements(u64::from(2 * SIDE * SIDE))).sample_size(20);
    for (name, distance) in [("far", 5.0), ("near", 0.25), ("touching", 0.08)] {
        for edges in [false, true] {
            let (mut contact, places) = stack(distance, edges);
            let mut forces = vec![Vec3::zeros(); places.len()];
            contact.list(|(_, a)| places[a as usize]);
            // As far as half of a list's life.
            let at = |(_, a): Node| places[a as usize] + Vec3::x() * if a % 2 == 0 { 0.075 } else { 0.0 };
            group.bench_function(format!("{name}, edges {edges}"), |b| {
                b.iter(|| {
                    contact.look(at);
                    contact.forces(|(_, a), force| forces[a as usize] += force);
                });
            });
        }
    }
}

fn list(c: &mut Criterion) {
    let mut group = c.benchmark_group("a list, two sheets of 11 236 particles");
    group.throughput(Throughput::Elements(u64::from(2 * SIDE * SIDE))).sample_size(20);
    for (name, distance) in [("far", 5.0), ("near", 0.25), ("touching", 0.08)] {
        for edges in [false, true] {
            let (mut contact, places) = stack(distance, edges);
            group.bench_function(format!("{name}, edges {edges}"), |b| {
                b.iter(|| contact.list(|(_, a)| places[a as usize]));
            });
        }
    }
}

criterion_group!(benches, look, list);
criterion_main!(benches);
