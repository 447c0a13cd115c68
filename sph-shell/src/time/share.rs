//! Who marches a shell together: whose particles are whose, what they exchange, sums over all of them.
//!
//! Each has the whole arrays, sweeps every pack that touches particles of its own and moves these alone; positions and directors of the
//! particles of others in such packs come in before a sweep. Works of chunks, energies of packs and products of vectors are added exactly
//! ([`peers::Exact`]), so that a march has the same bits whoever marches it, alone too.

use std::ops::Range;
use std::sync::{Mutex, MutexGuard, PoisonError};

use peers::{Alone, Cut, Exact, Greatest, Lane, Peers, agree};

use crate::packs::Row;

/// Numbers of a row of position and director.
const WIDTH: usize = 6;

/// Shares begin where chunks do.
const _: () = assert!(peers::CHUNK == parallel::CHUNK);

/// One of those who march a shell.
pub(crate) struct Share {
    peers: Mutex<Box<dyn Peers>>,
    cut: Cut,
    own: Range<usize>,
    lane: Option<Lane>,
    /// Whether this one adds the energy of a pack, of which there may be several copies; all of them where it is alone.
    packs: Vec<bool>,
}

impl Share {
    /// Of a shell that is marched by one.
    pub fn alone(particles: usize) -> Self {
        Self {
            peers: Mutex::new(Box::new(Alone)),
            cut: Cut::even(particles, 1),
            own: 0..particles,
            lane: None,
            packs: Vec::new(),
        }
    }

    /// Of one of several, from the particles of each pack.
    pub fn new(mut peers: Box<dyn Peers>, particles: usize, packs: &[Vec<u32>]) -> Self {
        let cut = Cut::even(particles, peers.count());
        let own = cut.own(peers.rank());
        let is_own = |a: &u32| own.contains(&(*a as usize));
        let touched = packs.iter().filter(|pack| pack.iter().any(is_own));
        let needs: Vec<u32> = touched.flatten().copied().collect();
        let lists = agree(&mut *peers, &cut, &needs);
        let lane = (peers.count() > 1).then(|| peers.open(&lists, WIDTH));
        // The owner of its least particle adds the energy of a pack.
        let first = |pack: &Vec<u32>| pack.iter().min().is_some_and(is_own);
        let packs = packs.iter().map(first).collect();
        Self { peers: Mutex::new(peers), cut, own, lane, packs }
    }

    fn peers(&self) -> MutexGuard<'_, Box<dyn Peers>> {
        self.peers.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The particles that this one moves.
    pub fn own(&self) -> Range<usize> {
        self.own.clone()
    }

    /// Their chunks.
    pub fn chunks(&self) -> Range<usize> {
        self.own.start / parallel::CHUNK..self.own.end.div_ceil(parallel::CHUNK)
    }

    /// Whether there are others.
    pub fn is_shared(&self) -> bool {
        self.lane.is_some()
    }

    /// Brings rows of the particles that its packs touch.
    pub fn exchange(&self, rows: &mut [Row]) {
        let Some(lane) = &self.lane else { return };
        let mut peers = self.peers();
        peers.send(lane, &|a, row| row.copy_from_slice(&rows[a as usize]));
        peers.take(lane, &mut |a, row| rows[a as usize].copy_from_slice(row));
    }

    /// Brings rows of all particles to all.
    pub fn bring(&self, rows: &mut [Row]) {
        if self.is_shared() {
            self.peers().gather_to_all(&self.cut, rows.as_flattened_mut(), WIDTH);
        }
    }

    /// Adds numbers of chunks over all.
    pub fn sum<const N: usize>(&self, mut numbers: impl Iterator<Item = [f64; N]>) -> [f64; N] {
        // Of two numbers at most the plain sum is the nearest to the exact one; that of zeros is +0.
        let [first, second, third] = [numbers.next(), numbers.next(), numbers.next()];
        if !self.is_shared() && third.is_none() {
            let [first, second] = [first, second].map(|own| own.unwrap_or([0.0; N]));
            return std::array::from_fn(|k| 0.0 + first[k] + second[k]);
        }
        let numbers = [first, second, third].into_iter().flatten().chain(numbers);
        let mut sums = [const { Exact::new() }; N];
        for own in numbers {
            sums.iter_mut().zip(own).for_each(|(sum, number)| sum.add(number));
        }
        self.peers().add(&mut sums, &mut []);
        sums.map(|sum| sum.value())
    }

    /// Adds energies of so many packs over all, each once.
    pub fn energy(&self, packs: usize, of: impl Fn(usize) -> f64) -> f64 {
        let own = (0..packs).filter(|&pack| self.packs.get(pack).is_none_or(|own| *own));
        let [sum] = self.sum(own.map(|pack| [of(pack)]));
        sum
    }

    /// `a·b` of vectors of so many numbers a particle, of all their parts.
    pub fn dot(&self, a: &[f64], b: &[f64], width: usize) -> f64 {
        let own = self.own.start * width..self.own.end * width;
        let chunks =
            a[own.clone()].chunks(parallel::CHUNK * width).zip(b[own].chunks(parallel::CHUNK * width));
        let product = |(a, b): (&[f64], &[f64])| [a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>()];
        let [sum] = self.sum(chunks.map(product));
        sum
    }

    /// The greatest of values of all, each with its number.
    pub fn greatest(&self, own: impl Iterator<Item = (f64, usize)>) -> (f64, usize) {
        let found =
            own.fold(Greatest::NONE, |best, (value, number)| best.or(Greatest::of(value, number as u64)));
        let mut found = [found];
        self.peers().greatest(&mut found);
        (found[0].value(), found[0].number() as usize)
    }
}
