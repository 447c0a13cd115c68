//! Processes under `mpirun` exchange what threads as peers exchange, to the bit.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

use std::alloc::System;
use std::process::Command;

use coque::ProcessGroup;
use coque_mpi::{Messages, World};
use peers::{CHUNK, Cut, Exact, Greatest, Peers, agree, together};
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// Says to a process that it is one of those who were started.
const STARTED: &str = "COQUE_MPI_TEST";
/// Particles: shares of seven differ, one of them ends within a chunk.
const PARTICLES: usize = 9 * CHUNK + 100;
/// Numbers of a row.
const WIDTH: usize = 6;

/// What a share needs beside its own: its neighbours in a strip of fifty particles across, and two of the far end.
fn needs(cut: &Cut, rank: usize) -> Vec<u32> {
    let own = cut.own(rank);
    let near = own.start.max(50) - 50..(own.end + 50).min(PARTICLES);
    near.chain([0, PARTICLES - 1]).map(|a| a as u32).collect()
}

/// Some steps of a march that sends all there is to send; everything that comes back, as bits.
fn march(mut peers: Box<dyn Peers>) -> Vec<u64> {
    let (rank, count) = (peers.rank(), peers.count());
    let cut = Cut::even(PARTICLES, count);
    let own = cut.own(rank);
    let mut bits = vec![rank as u64, count as u64];
    let lists = agree(&mut *peers, &cut, &needs(&cut, rank));
    let (lane, thin) = (peers.open(&lists, WIDTH), peers.open(&lists, 1));
    let mut rows = vec![0.0; WIDTH * PARTICLES];
    for a in own.clone() {
        (0..WIDTH).for_each(|k| rows[WIDTH * a + k] = ((WIDTH * a + k) as f64).sqrt());
    }
    for step in 0..5 {
        peers.send(&lane, &|a, row| row.copy_from_slice(&rows[WIDTH * a as usize..][..WIDTH]));
        peers.send(&thin, &|a, row| row[0] = f64::from(a) + 0.5);
        peers.take(&lane, &mut |a, row| rows[WIDTH * a as usize..][..WIDTH].copy_from_slice(row));
        peers.take(&thin, &mut |a, row| assert_eq!(row[0], f64::from(a) + 0.5));
        let mean = |a: usize| rows[WIDTH * a] + rows[WIDTH * ((a + 50).min(PARTICLES - 1))];
        let moved: Vec<f64> = own.clone().map(|a| 0.3 * mean(a)).collect();
        own.clone().zip(moved).for_each(|(a, x)| rows[WIDTH * a] = x);
        let mut sums = [Exact::new(), Exact::new()];
        sums[0].add_in_chunks(own.clone().map(|a| rows[WIDTH * a]));
        own.clone().for_each(|a| sums[1].add(rows[WIDTH * a + 1] - 40.0));
        let mut counts = [own.len() as i64, i64::from(rank == 1 && step == 3)];
        peers.add(&mut sums, &mut counts);
        bits.extend(sums.map(|sum| sum.value().to_bits()));
        bits.extend(counts.map(|count| count as u64));
        let best = |k| {
            own.clone().fold(Greatest::NONE, |best: Greatest, a| {
                best.or(Greatest::of(rows[WIDTH * a + k], a as u64))
            })
        };
        let mut found = [best(0), Greatest::of(7.0, rank as u64), Greatest::NONE, Greatest::of(f64::NAN, 3)];
        peers.greatest(&mut found);
        bits.extend(found.iter().flat_map(|found| [found.value().to_bits(), found.number()]));
    }
    peers.close(thin);
    let again = peers.open(&lists, 2);
    peers.send(&again, &|a, row| row.fill(f64::from(a)));
    peers.take(&again, &mut |a, row| assert_eq!(row, [f64::from(a); 2]));
    let mut first = rows.clone();
    peers.gather(&cut, &mut first, WIDTH);
    peers.gather_to_all(&cut, &mut rows, WIDTH);
    bits.extend(first.iter().chain(&rows).map(|x| x.to_bits()));
    bits
}

/// Allocations of Rust code in ten steps, once all is open, and bytes handed to MPI, beside those of the plan.
fn counted(mut peers: Messages) -> [usize; 3] {
    let cut = Cut::even(PARTICLES, peers.count());
    let needs = needs(&cut, peers.rank());
    let lists = agree(&mut peers, &cut, &needs);
    let lane = peers.open(&lists, WIDTH);
    let mut last = 0.0;
    let mut step = |peers: &mut Messages| {
        peers.send(&lane, &|a, row| row.fill(f64::from(a)));
        peers.take(&lane, &mut |_, row| last += row[0]);
        peers.add(&mut [Exact::new()], &mut [0]);
        peers.greatest(&mut [Greatest::of(1.0, 1)]);
    };
    step(&mut peers);
    let (region, before) = (Region::new(ALLOCATOR), peers.bytes_sent());
    (0..10).for_each(|_| step(&mut peers));
    let allocations = region.change().allocations;
    [allocations, (peers.bytes_sent() - before) as usize, 10 * lists.bytes_sent(WIDTH)]
}

/// What each of the processes does.
#[test]
fn one_of_those_who_were_started() {
    if std::env::var_os(STARTED).is_none() {
        return;
    }
    let world = World::join().unwrap().unwrap();
    let found = march(world.peers());
    let peers = world.messages();
    let (rank, count) = (peers.rank(), peers.count());
    let expected = together(count, march).unwrap();
    assert!(found == expected[rank], "rank {rank} of {count}");
    let [allocations, sent, planned] = counted(peers);
    assert_eq!(allocations, 0, "allocations of rank {rank} of {count}");
    assert!(planned > 0 && sent == planned, "{sent} bytes sent, {planned} planned");
}

/// One of three cannot go on, in a way that each of the others is not: all end.
#[test]
fn one_of_those_who_end() {
    let Some(how) = std::env::var_os(STARTED) else { return };
    let world = World::join().unwrap().unwrap();
    world.end_on_panic();
    let mut peers = world.peers();
    let lists = agree(&mut *peers, &Cut::even(PARTICLES, 3), &[0, 1, 2]);
    let lane = peers.open(&lists, 1);
    if peers.rank() == 1 {
        match how.to_str().unwrap() {
            "panics" => panic!("what was not foreseen"),
            "fails" => peers.fail("what cannot be mended"),
            _ => std::process::exit(3),
        }
    }
    peers.send(&lane, &|_, row| row[0] = 1.0);
    peers.take(&lane, &mut |_, _| ());
    peers.add(&mut [], &mut [1]);
    unreachable!("rank 1 has taken part");
}

/// Starts so many of this program, each of which does one of the tests.
fn started(count: usize, test: &str, how: &str) -> (std::process::ExitStatus, String) {
    let run = Command::new("mpirun")
        .args(["-n", &count.to_string()])
        .arg(std::env::current_exe().unwrap())
        .args(["--exact", test, "--nocapture"])
        .env(STARTED, how)
        .env("OMPI_MCA_rmaps_base_oversubscribe", "1")
        .env("OMPI_MCA_mpi_yield_when_idle", "1")
        .env("OMPI_ALLOW_RUN_AS_ROOT", "1")
        .env("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1")
        .output()
        .unwrap();
    let text = [run.stdout, run.stderr].map(|text| String::from_utf8_lossy(&text).into_owned()).concat();
    (run.status, text)
}

#[test]
fn messages_carry_what_threads_carry() {
    for count in [2, 3, 4, 7] {
        let (status, text) = started(count, "one_of_those_who_were_started", "1");
        assert!(status.success(), "{count} processes: {text}");
        assert_eq!(text.matches("1 passed").count(), count, "{text}");
    }
}

/// Whoever panics, fails or leaves ends all, with one message and a code that is not zero.
#[test]
fn one_ends_all() {
    for (how, said) in [
        ("panics", "rank 1 of 3: panicked at "),
        ("fails", "rank 1 of 3: what cannot be mended"),
        ("leaves", ""),
    ] {
        let (status, text) = started(3, "one_of_those_who_end", how);
        println!("{how}: {status}");
        assert!(!status.success(), "{text}");
        assert!(text.contains(said), "{text}");
        assert!(!text.contains("has taken part"), "{text}");
        assert_eq!(text.matches("rank 1 of 3").count(), usize::from(!said.is_empty()), "{text}");
    }
}
