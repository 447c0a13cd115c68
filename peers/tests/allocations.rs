//! A step of peers allocates nothing: sums, maxima and rows, once all is open.

use std::alloc::System;

use peers::{Cut, Exact, Greatest, Peers, agree, together};
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// A strip of which each peer owns a piece, with a row of neighbours on both sides.
#[test]
fn a_step_allocates_nothing() {
    let particles = 8 * peers::CHUNK;
    for count in 1..=5 {
        let found = together(count, |mut peers| {
            let cut = Cut::even(particles, peers.count());
            let own = cut.own(peers.rank());
            let needs: Vec<u32> =
                (own.start.max(50) - 50..(own.end + 50).min(particles)).map(|a| a as u32).collect();
            let lists = agree(&mut *peers, &cut, &needs);
            let lane = peers.open(&lists, 6);
            let mut rows = vec![1.0; 6 * particles];
            let mut sums = [Exact::new(), Exact::new()];
            let step = |peers: &mut dyn Peers, rows: &mut Vec<f64>, sums: &mut [Exact; 2]| {
                peers.send(&lane, &|a, row| row.copy_from_slice(&rows[6 * a as usize..][..6]));
                peers.take(&lane, &mut |a, row| rows[6 * a as usize..][..6].copy_from_slice(row));
                for sum in &mut *sums {
                    sum.clear();
                    sum.add_in_chunks(own.clone().map(|a| rows[6 * a]));
                }
                peers.add(sums, &mut [0, 1]);
                peers.greatest(&mut [Greatest::of(sums[0].value(), 1)]);
            };
            // Buffers of both boards and both ends of a lane, in all their turns.
            (0..4).for_each(|_| step(&mut *peers, &mut rows, &mut sums));
            // The counter belongs to the process: it starts and ends between two meetings of all.
            peers.add(&mut [], &mut []);
            let region = Region::new(ALLOCATOR);
            peers.add(&mut [], &mut []);
            (0..100).for_each(|_| step(&mut *peers, &mut rows, &mut sums));
            peers.add(&mut [], &mut []);
            let change = region.change();
            peers.add(&mut [], &mut []);
            (change.allocations, change.reallocations, sums[0].value())
        });
        assert_eq!(found.unwrap(), vec![(0, 0, particles as f64); count]);
    }
    // The counter counts.
    let region = Region::new(ALLOCATOR);
    drop(std::hint::black_box(vec![1; 10]));
    assert_eq!(region.change().allocations, 1);
}
