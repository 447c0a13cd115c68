//! What it costs to march together: several peers against one thread, and what each sends.
//!
//! `cargo bench -p fluid-sph --bench shared -- [NAME | sent | wall]`. Times are those of the processor, of the slowest peer and the least of
//! some rounds, so that other work on the machine counts little and waiting not at all; `wall` tells those of the wall, of two threads too,
//! which hold on a quiet machine only.

mod waters;

use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::sync::{Barrier, OnceLock};
use std::time::Instant;

use explicit_dynamics::Clock;
use fluid_sph::{Fluid, Parts, Scheme};
use peers::{Cut, Exact, Greatest, Lane, Lists, Peers, together};
use waters::{Water, dam, steps, thread_seconds};

const ROUNDS: usize = 7;
/// Particle-steps of one measurement, about.
const WORK: usize = 400_000;

const WATERS: [Water; 4] = [
    Water::new("plane-1e4", 2, 100, Scheme::KickDriftKick),
    Water::new("plane-5e4", 2, 224, Scheme::KickDriftKick),
    Water::new("space-1e4", 3, 22, Scheme::KickDriftKick),
    Water::new("space-5e4", 3, 37, Scheme::KickDriftKick),
];

fn main() {
    let wanted = std::env::args().skip(1).find(|argument| !argument.starts_with("--")).unwrap_or_default();
    for water in WATERS.iter().filter(|water| wanted == "wall" || water.name.contains(&wanted)) {
        if wanted == "wall" {
            let [one, two, both] =
                least(|| [threads(water, 1), threads(water, 2), shared_by(water, 2, wall)]);
            let (name, threads, peers) = (water.name, one / two, one / both);
            println!("{name}: two threads are {threads:.2} times as fast as one, two peers {peers:.2} times");
            continue;
        }
        let [one, two, four] = least(|| [1, 2, 4].map(|count| shared_by(water, count, thread_seconds)));
        println!(
            "{}: {:.0} ns a particle-step of a peer alone; the slowest of two takes {:.3} of that, of four {:.3}",
            water.name,
            1e9 * one,
            two / one,
            four / one
        );
    }
    for (dimensions, spacing) in [(2, 0.01), (2, 0.005), (3, 0.025)] {
        let parts = dam(dimensions, spacing);
        for count in [2, 4, 8].into_iter().filter(|_| "sent".contains(&wanted)) {
            sent(&parts, count);
        }
    }
}

/// The least of some rounds, one after the other.
fn least<const N: usize>(mut round: impl FnMut() -> [f64; N]) -> [f64; N] {
    let mut least = [f64::INFINITY; N];
    for _ in 0..ROUNDS {
        least.iter_mut().zip(round()).for_each(|(least, time)| *least = least.min(time));
    }
    least
}

/// Time of the wall for a particle-step with so many threads \[s\].
fn threads(water: &Water, threads: usize) -> f64 {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
    pool.install(|| {
        let (mut fluid, mut clock) = water.fluid(threads);
        timed(&mut fluid, &mut clock, wall)
    })
}

/// Time of a particle-step with so many peers, a thread each, by a clock; the slowest counts.
fn shared_by(water: &Water, count: usize, seconds: fn() -> f64) -> f64 {
    let barrier = Barrier::new(count);
    let each = |peers: Box<dyn Peers>| {
        let (mut fluid, mut clock) = water.fluid(1);
        fluid.share(peers).expect("a fluid alone in its walls");
        steps(&mut fluid, &mut clock, 1);
        barrier.wait();
        timed(&mut fluid, &mut clock, seconds)
    };
    together(count, each).expect("all come through").into_iter().fold(0.0, f64::max)
}

fn timed(fluid: &mut Fluid, clock: &mut Clock, seconds: fn() -> f64) -> f64 {
    let count = (WORK / fluid.len()).max(2);
    let start = seconds();
    steps(fluid, clock, count);
    (seconds() - start) / (count * fluid.len()) as f64
}

/// Time of the wall since the first call \[s\].
fn wall() -> f64 {
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed().as_secs_f64()
}

/// What peers send in a dam break, the one who sends most.
fn sent(parts: &Parts, count: usize) {
    let (steps_made, every) = (400, [const { AtomicUsize::new(0) }; 4]);
    let each = |peers: Box<dyn Peers>| {
        let sent = Box::leak(Box::new([const { AtomicUsize::new(0) }; 4]));
        let mut fluid = Fluid::new(parts.clone()).expect("a dam");
        fluid.share(Box::new(Counted { peers, sent })).expect("a fluid alone in its walls");
        let mut clock = Clock::start(&mut fluid, 1.0, 1.0, 0.0).expect("a step");
        sent.iter().for_each(|count| count.store(0, Relaxed));
        steps(&mut fluid, &mut clock, steps_made);
        sent.iter().zip(&every).for_each(|(sent, most)| _ = most.fetch_max(sent.load(Relaxed), Relaxed));
    };
    together(count, each).expect("all come through");
    let [rows, gathered, gathers, met] = every.map(|count| count.into_inner() as f64 / steps_made as f64);
    println!(
        "dam in {} dimensions, {} particles, {count} peers: {:.1} kB a step in rows to neighbours; all dealt out every {:.0} steps, {:.0} kB of \
         one's own to all each time; {met:.1} sums and maxima a step",
        parts.dimensions,
        parts.positions.len(),
        1e-3 * rows,
        // Particles and points of walls.
        2.0 / gathers,
        2e-3 * gathered / gathers,
    );
}

/// Peers whose bytes are counted: sent in rows, gathered of one's own, and how often; sums and maxima.
struct Counted {
    peers: Box<dyn Peers>,
    sent: &'static [AtomicUsize; 4],
}

impl Peers for Counted {
    fn rank(&self) -> usize {
        self.peers.rank()
    }

    fn count(&self) -> usize {
        self.peers.count()
    }

    fn add(&mut self, sums: &mut [Exact], counts: &mut [i64]) {
        self.sent[3].fetch_add(1, Relaxed);
        self.peers.add(sums, counts);
    }

    fn greatest(&mut self, found: &mut [Greatest]) {
        self.sent[3].fetch_add(1, Relaxed);
        self.peers.greatest(found);
    }

    fn open(&mut self, lists: &Lists, width: usize) -> Lane {
        self.peers.open(lists, width)
    }

    fn send(&mut self, lane: &Lane, row: &dyn Fn(u32, &mut [f64])) {
        let sent = self.sent;
        self.peers.send(lane, &|particle, numbers| {
            sent[0].fetch_add(8 * numbers.len(), Relaxed);
            row(particle, numbers);
        });
    }

    fn take(&mut self, lane: &Lane, row: &mut dyn FnMut(u32, &[f64])) {
        self.peers.take(lane, row);
    }

    fn close(&mut self, lane: Lane) {
        self.peers.close(lane);
    }

    fn gather(&mut self, cut: &Cut, rows: &mut [f64], width: usize) {
        self.peers.gather(cut, rows, width);
    }

    fn gather_to_all(&mut self, cut: &Cut, rows: &mut [f64], width: usize) {
        self.sent[1].fetch_add(8 * width * cut.own(self.peers.rank()).len(), Relaxed);
        self.sent[2].fetch_add(1, Relaxed);
        self.peers.gather_to_all(cut, rows, width);
    }

    fn fail(&self, message: &str) -> ! {
        self.peers.fail(message)
    }
}
