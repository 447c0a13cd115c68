//! A bar drawn slowly beyond its yield stress, let go a little: force, slope, what stays.

use explicit_dynamics::{Amplitude, March, Transient};
use peridynamics::{Correction, Influence, Parts, Solid, Support, Supported};
use sph_core::Vec3;

use crate::blocks::{DX, STEEL, YOUNG, bonds, on_edges, perfect};
use crate::lattices::parts;

const YIELD: f64 = 250e6;
/// Strain drawn to: four times that of yielding.
const DRAWN: f64 = 4.0 * YIELD / YOUNG;
/// Width of the bar \[L\].
const WIDTH: f64 = 4.0 * DX;
/// Times at which the bar rests, and how much of the draw it has then.
const RESTS: [(f64, f64); 3] = [(90e-6, 0.15), (330e-6, 1.0), (440e-6, 0.85)];

/// Force over `σ_y A` at each rest, of a bar 16 × 4 × 4 mm whose ends are held along its axis alone.
fn forces(cells: usize) -> [f64; 3] {
    let dx = WIDTH / cells as f64;
    let per_width = cells + 1;
    let mut block = on_edges([4 * cells + 1, per_width, per_width]);
    let scale = dx / DX;
    block.spacing = [dx; 3];
    block.positions.iter_mut().for_each(|x| *x *= scale);
    block.volumes.iter_mut().for_each(|volume| *volume *= scale.powi(3));
    block.faces.iter_mut().flatten().for_each(|(_, area)| *area *= scale * scale);
    let layer = (per_width * per_width) as u32;
    let count = block.len() as u32;
    let axis = vec![Vec3::x()];
    let by = DRAWN * 4.0 * WIDTH;
    let us = 1e-6;
    let course = Amplitude::Table(vec![
        [0.0, 0.0],
        [40.0 * us, 0.15],
        [90.0 * us, 0.15],
        [270.0 * us, 1.0],
        [330.0 * us, 1.0],
        [380.0 * us, 0.85],
        [440.0 * us, 0.85],
    ]);
    let ends = [(0..layer), (count - layer..count)].map(Iterator::collect::<Vec<u32>>);
    let held = Support::Held { displacement: axis, director: Vec::new() };
    let moved = Support::Moved { direction: Vec3::x(), by, amplitude: course };
    let mut body = Solid::new(Parts {
        plastic: Some(perfect(YIELD)),
        supports: vec![
            Supported { nodes: ends[0].clone(), support: held },
            Supported { nodes: ends[1].clone(), support: moved },
        ],
        ..parts(block, STEEL, bonds(Correction::Balanced, Influence::Inverse, 2.015))
    })
    .unwrap();
    let run = Transient { duration: 440.0 * us, record_every: 10.0 * us, damping: 1e5, safety: 0.8 };
    let mut march = March::start(run, &mut body).unwrap();
    let mut found = [0.0; 3];
    while let Some(record) = march.next_record(&mut body).unwrap() {
        let force = ends[0].iter().map(|&node| body.reaction(node as usize).x).sum::<f64>().abs();
        for ((at, _), found) in RESTS.iter().zip(&mut found) {
            if (record.at.time - at).abs() < us {
                *found = force / (YIELD * WIDTH.powi(2));
            }
        }
    }
    found
}

#[test]
fn a_drawn_bar_flows_at_its_yield_stress_and_springs_back_elastically() {
    for cells in [3, 4] {
        let [elastic, flowing, back] = forces(cells);
        let slope = elastic / (4.0 * RESTS[0].1);
        let unloading = (flowing - back) / (4.0 * (RESTS[1].1 - RESTS[2].1));
        // What stays, over the strain of yielding: the unloading goes on as a straight line.
        let stays = 4.0 - flowing / unloading;
        println!(
            "{cells} cells: slope {slope:.4}, flows at {flowing:.4}, unloads with {unloading:.4}, {stays:.4} stays"
        );
        // Of Young's modulus: measured 0.997 and 0.994; what is left of the swings is half a per cent.
        assert!((slope - 1.0).abs() < 0.02, "{slope}");
        // Measured 0.979 and 0.980, with six cells 0.981: half a per cent is what the section has shrunk by. The rest does not go with a
        // finer lattice of the same horizon in cells; families at faces are cut, and the flow along the bar is uneven near its ends.
        assert!((0.95..1.01).contains(&flowing), "{flowing}");
        assert!((unloading - slope).abs() < 0.03, "{unloading} {slope}");
        assert!((stays - 3.0).abs() < 0.08, "{stays}");
    }
}
