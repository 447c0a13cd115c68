//! What messages cost between the processes that are there, and what a march of a sheet would cost on more of them:
//! `mpirun -n 2 target/release/examples/network [ns of a particle and step on one core]`.
//!
//! Measured: a step of a lane with one partner, by the length of its rows, and a sum. Predicted, and printed as that: a sheet in rows, of whose
//! rows each process has the same number. A process moves its own particles, sweeps the row of cells on each border
//! and on each seam between border and interior once more, starts two sends and two receives, and waits for the sum; rows travel while the
//! interior is swept.

#![allow(clippy::unwrap_used)] // an example may stop where it stands

use std::time::Instant;

use coque::ProcessGroup;
use coque_mpi::World;
use peers::{Exact, Greatest, Lists, Partner, Peers};

/// Numbers of a row of position and director.
const WIDTH: usize = 6;
/// Steps of a window; the least of so many windows counts.
const STEPS: u32 = 200;
const WINDOWS: usize = 15;
/// Sums of a step: kinetic energy, work, change, what supports resist.
const SUMS: usize = 4;

fn main() {
    let nanoseconds: f64 = std::env::args().nth(1).map_or(30.0, |given| given.parse().unwrap());
    let Some(world) = World::join().unwrap() else {
        println!("start it by mpirun, with two processes at least, an even number");
        return;
    };
    let mut peers = world.peers();
    let (rank, count) = (peers.rank(), peers.count());
    let says = rank == 0;
    let mut rows = Vec::new();
    if says {
        println!("{count} processes here, measured\n{:>10}{:>12}{:>12}", "rows", "bytes", "µs a step");
    }
    for length in [1, 10, 100, 1000, 10_000, 100_000] {
        let numbers: Vec<u32> = (0..length).collect();
        let partner = Partner { rank: rank ^ 1, send: numbers.clone(), take: numbers };
        let lane = peers.open(&Lists::new(vec![partner]), WIDTH);
        let mut into = vec![0.0; WIDTH * length as usize];
        let took = least(&mut *peers, &mut |peers| {
            peers.send(&lane, &|a, row| row.fill(f64::from(a)));
            peers.take(&lane, &mut |a, row| into[WIDTH * a as usize..][..WIDTH].copy_from_slice(row));
        });
        peers.close(lane);
        let bytes = 8.0 * (WIDTH * length as usize) as f64;
        rows.push((bytes, took));
        if says {
            println!("{length:>10}{bytes:>12}{:>12.2}", 1e6 * took);
        }
    }
    let sum = least(&mut *peers, &mut |peers| {
        peers.add(&mut [const { Exact::new() }; SUMS], &mut [0; 2]);
    });
    let latency = rows[0].1;
    let (bytes, took) = rows[rows.len() - 1];
    let bandwidth = bytes / (took - latency);
    if says {
        println!("{:>22}{:>12.2}   a sum of {SUMS}", 8 * (SUMS * Exact::WORDS + 2), 1e6 * sum);
        println!("\npredicted, {nanoseconds} ns a particle and step, µs a step, efficiency");
        println!(
            "{:>8}{:>11}{:>10}{:>10}{:>10}{:>10}{:>10}{:>8}",
            "side", "processes", "own", "twice", "calls", "late", "sum", ""
        );
        for side in [100.0_f64, 1000.0, 3162.0, 31_623.0] {
            for processes in [2_u32, 8, 64, 512] {
                let own = side * side / f64::from(processes);
                // Chunks are whole, and no process has fewer rows than one.
                if own < side.max(2.0 * peers::CHUNK as f64) {
                    continue;
                }
                let [moved, twice] = [own, 3.0 * side].map(|particles| 1e-9 * nanoseconds * particles);
                let calls = 2.0 * latency;
                let travels = latency + 8.0 * WIDTH as f64 * side / bandwidth;
                let late = (travels - moved).max(0.0);
                let added = sum * f64::from(processes.ilog2()) / f64::from(count.ilog2().max(1));
                let all = moved + twice + calls + late + added;
                let [own, twice, calls, late, added] =
                    [moved, twice, calls, late, added].map(|seconds| 1e6 * seconds);
                println!(
                    "{side:>8}{processes:>11}{own:>10.1}{twice:>10.1}{calls:>10.1}{late:>10.1}{added:>10.1}{:>7.0} %",
                    100.0 * moved / all
                );
            }
        }
    }
}

/// Seconds of a step, the same for all processes: the least of some windows, each that of the slowest.
fn least(peers: &mut dyn Peers, step: &mut dyn FnMut(&mut dyn Peers)) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..WINDOWS {
        peers.add(&mut [], &mut []);
        let begun = Instant::now();
        (0..STEPS).for_each(|_| step(peers));
        let mut slowest = [Greatest::of(begun.elapsed().as_secs_f64() / f64::from(STEPS), 0)];
        peers.greatest(&mut slowest);
        least = least.min(slowest[0].value());
    }
    least
}
