//! Who marches a shell together: whose particles are whose, what they exchange, sums over all of them.
//!
//! Each has the whole arrays, sweeps every pack that touches particles of its own and moves these alone; positions and directors of the
//! particles of others in such packs, its *ghosts*, come in before a sweep. Works of chunks, energies of packs and products of vectors are added
//! exactly ([`peers::Exact`]), so that a march has the same bits whoever marches it, alone too.
//!
//! Chunks with particles that others need are swept first, and their new rows are sent at once: they are under way while the interior is swept, and
//! are taken as the next step begins.
//!
//! Whoever marches a shell moves all of its groups and all that hangs by ties, with the same bits: the states of *bound* particles, those that
//! move with others or bear them, are ghosts everywhere, and so are their forces.

use std::ops::Range;
use std::sync::{Mutex, MutexGuard, PoisonError};

use peers::{Alone, Cut, Lane, Lists, Partner, Peers, agree};

use crate::packs::Row;

/// Numbers of a row of position and director.
const WIDTH: usize = 6;

/// An interior shorter than so many times its share is swept with the border: the points at its ends would be swept twice for little.
const LEAST_INTERIOR: f64 = 0.5;

/// Shares begin where chunks do.
const _: () = assert!(peers::CHUNK == parallel::CHUNK);

/// Where the rows of ghosts are.
#[derive(Clone, Copy, PartialEq)]
enum Ghosts {
    /// What is here is none of the present state.
    Old,
    /// They have been sent, and not yet taken.
    UnderWay,
    /// They are here.
    Here,
}

/// Who carries rows and sums, and what it carries.
struct Carrier {
    peers: Box<dyn Peers>,
    ghosts: Ghosts,
}

/// One of those who march a shell.
pub(crate) struct Share {
    carrier: Mutex<Carrier>,
    rank: u32,
    cut: Cut,
    own: Range<usize>,
    /// Own particles in whole chunks of which nobody else needs any.
    interior: Range<usize>,
    /// Particles of others whose rows come in.
    ghosts: Vec<u32>,
    lane: Option<Lane>,
    /// For the forces of bound particles, if there are any.
    bound: Option<Lane>,
    /// Who adds the energy of each pack, of which there may be several copies; empty where one is alone.
    packs: Vec<u32>,
    /// Whether a pack touches own particles; empty where one is alone.
    touched: Vec<bool>,
}

impl Share {
    /// Of a shell that is marched by one.
    pub fn alone(particles: usize) -> Self {
        Self {
            carrier: Mutex::new(Carrier { peers: Box::new(Alone), ghosts: Ghosts::Old }),
            rank: 0,
            cut: Cut::even(particles, 1),
            own: 0..particles,
            interior: 0..particles,
            ghosts: Vec::new(),
            lane: None,
            bound: None,
            packs: Vec::new(),
            touched: Vec::new(),
        }
    }

    /// Of one of several, from the particles of each pack, what it reads of others beside, and the bound ones.
    pub fn new(
        mut peers: Box<dyn Peers>,
        cut: Cut,
        packs: &[Vec<u32>],
        [reads, bound]: [Vec<u32>; 2],
    ) -> Self {
        let (rank, own) = (peers.rank(), cut.own(peers.rank()));
        let touches = |pack: &Vec<u32>| pack.iter().any(|&a| own.contains(&(a as usize)));
        let touched: Vec<bool> = packs.iter().map(touches).collect();
        let of_packs = packs.iter().zip(&touched).filter(|(_, touched)| **touched);
        let needs: Vec<u32> =
            of_packs.flat_map(|(pack, _)| pack).chain(&reads).chain(&bound).copied().collect();
        let lists = agree(&mut *peers, &cut, &needs);
        let shared = peers.count() > 1;
        let lane = shared.then(|| peers.open(&lists, WIDTH));
        let bound = (shared && !bound.is_empty()).then(|| {
            let lists = agree(&mut *peers, &cut, &bound);
            peers.open(&lists, WIDTH)
        });
        let partners = || lists.partners().iter();
        let ghosts = partners().flat_map(|partner| &partner.take).copied().collect();
        let interior = interior(&own, partners().flat_map(|partner| &partner.send).copied());
        // The owner of its least particle adds the energy of a pack; one of no particle has none.
        let first = |pack: &Vec<u32>| pack.iter().min().map_or(0, |&a| cut.owner(a as usize) as u32);
        let packs = packs.iter().map(first).collect();
        let carrier = Mutex::new(Carrier { peers, ghosts: Ghosts::Old });
        Self { carrier, rank: rank as u32, cut, own, interior, ghosts, lane, bound, packs, touched }
    }

    fn carrier(&self) -> MutexGuard<'_, Carrier> {
        self.carrier.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The particles that this one moves.
    pub fn own(&self) -> Range<usize> {
        self.own.clone()
    }

    /// Their chunks.
    pub fn chunks(&self) -> Range<usize> {
        self.own.start / parallel::CHUNK..self.own.end.div_ceil(parallel::CHUNK)
    }

    /// Those that are moved while new rows of the others are under way: all of one who is alone.
    pub fn interior(&self) -> Range<usize> {
        self.interior.clone()
    }

    /// Particles of others whose rows come in.
    pub fn ghosts(&self) -> &[u32] {
        &self.ghosts
    }

    /// Whether it is this one that adds the energy of a pack, and looks after its points.
    pub fn has(&self, pack: usize) -> bool {
        self.packs.get(pack).is_none_or(|owner| *owner == self.rank)
    }

    /// Whether each pack touches own particles; nothing where one is alone.
    pub fn touched(&self) -> &[bool] {
        &self.touched
    }

    /// Whether there are others.
    pub fn is_shared(&self) -> bool {
        self.lane.is_some()
    }

    /// Brings rows of ghosts as their owners have them now, whatever has been sent before; what comes next does not rely on them.
    pub fn exchange(&self, rows: &mut [Row]) {
        self.moved();
        self.arrive(rows);
        self.carrier().ghosts = Ghosts::Old;
    }

    /// Brings rows of ghosts, which may be under way or here already, unless [`Share::moved`] says otherwise.
    pub fn arrive(&self, rows: &mut [Row]) {
        let Some(lane) = &self.lane else { return };
        let Carrier { peers, ghosts } = &mut *self.carrier();
        if *ghosts == Ghosts::Here {
            return;
        }
        if *ghosts == Ghosts::Old {
            peers.send(lane, &|a, row| row.copy_from_slice(&rows[a as usize]));
        }
        peers.take(lane, &mut |a, row| rows[a as usize].copy_from_slice(row));
        *ghosts = Ghosts::Here;
    }

    /// Sends own rows of the next state, which begin with the first own particle: the others take them by [`Share::arrive`].
    pub fn send(&self, next: &[Row]) {
        let Some(lane) = &self.lane else { return };
        let Carrier { peers, ghosts } = &mut *self.carrier();
        peers.send(lane, &|a, row| row.copy_from_slice(&next[a as usize - self.own.start]));
        *ghosts = Ghosts::UnderWay;
    }

    /// Particles have moved otherwise than by a step whose rows were sent: what is under way is dropped.
    pub fn moved(&self) {
        let Some(lane) = &self.lane else { return };
        let Carrier { peers, ghosts } = &mut *self.carrier();
        if *ghosts == Ghosts::UnderWay {
            peers.take(lane, &mut |_, _| ());
        }
        *ghosts = Ghosts::Old;
    }

    /// Brings rows of bound particles to all from their owners.
    pub fn exchange_bound(&self, rows: &mut [Row]) {
        let Some(lane) = &self.bound else { return };
        let peers = &mut self.carrier().peers;
        peers.send(lane, &|a, row| row.copy_from_slice(&rows[a as usize]));
        peers.take(lane, &mut |a, row| rows[a as usize].copy_from_slice(row));
    }

    /// Brings numbers of packs, `width` each, to all from those who look after them.
    pub fn bring_packs(
        &self,
        width: usize,
        read: impl Fn(usize, &mut [f64]),
        mut write: impl FnMut(usize, &[f64]),
    ) {
        let numbers = |rank: u32| -> Vec<u32> {
            (0..).zip(&self.packs).filter(|(_, owner)| **owner == rank).map(|(pack, _)| pack).collect()
        };
        let own = numbers(self.rank);
        let others = (0..self.cut.peers()).filter(|&rank| rank as u32 != self.rank);
        let partners = others.map(|rank| Partner { rank, send: own.clone(), take: numbers(rank as u32) });
        let lists = Lists::new(partners.collect());
        let peers = &mut self.carrier().peers;
        let lane = peers.open(&lists, width);
        peers.send(&lane, &|pack, row| read(pack as usize, row));
        peers.take(&lane, &mut |pack, row| write(pack as usize, row));
        peers.close(lane);
    }

    /// Brings rows of all particles to all.
    pub fn bring(&self, rows: &mut [Row]) {
        if self.is_shared() {
            self.carrier().peers.gather_to_all(&self.cut, rows.as_flattened_mut(), WIDTH);
        }
    }

    /// Adds numbers of own chunks over all.
    pub fn sum<const N: usize>(&self, numbers: impl Iterator<Item = [f64; N]>) -> [f64; N] {
        self.carrier().peers.sum(numbers)
    }

    /// Adds energies of so many packs over all, each once.
    pub fn energy(&self, packs: usize, of: impl Fn(usize) -> f64) -> f64 {
        let own = (0..packs).filter(|&pack| self.has(pack));
        let [sum] = self.sum(own.map(|pack| [of(pack)]));
        sum
    }

    /// `a·b` of vectors of so many numbers a particle, of all their parts.
    pub fn dot(&self, a: &[f64], b: &[f64], width: usize) -> f64 {
        let own = self.own.start * width..self.own.end * width;
        self.carrier().peers.dot(&a[own.clone()], &b[own], width)
    }

    /// The greatest of values of all, each with its number.
    pub fn greatest(&self, own: impl Iterator<Item = (f64, usize)>) -> (f64, usize) {
        self.carrier().peers.greatest_of(own)
    }
}

/// The longest run of whole chunks of own particles without any that are sent; nothing if it is short.
fn interior(own: &Range<usize>, sent: impl Iterator<Item = u32>) -> Range<usize> {
    let mut sends = vec![false; own.len().div_ceil(parallel::CHUNK)];
    sent.for_each(|a| sends[(a as usize - own.start) / parallel::CHUNK] = true);
    let (mut longest, mut start) = (0..0, 0);
    for (chunk, sends) in sends.iter().enumerate() {
        if *sends {
            start = chunk + 1;
        } else if chunk + 1 - start > longest.len() {
            longest = start..chunk + 1;
        }
    }
    let place = |chunk: usize| (own.start + chunk * parallel::CHUNK).min(own.end);
    let found = place(longest.start)..place(longest.end);
    if found.len() as f64 >= LEAST_INTERIOR * own.len() as f64 { found } else { own.end..own.end }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is sent splits a share; the longest piece is the interior, and none that is short.
    #[test]
    fn the_interior_is_the_longest_run_of_chunks_that_nobody_needs() {
        let own = 1024..4000; // six chunks, the last of 416
        assert_eq!(interior(&own, std::iter::empty()), own);
        assert_eq!(interior(&own, [1024, 1500].into_iter()), 1536..4000);
        assert_eq!(interior(&own, [1024, 3999].into_iter()), 1536..3584);
        assert_eq!(interior(&own, [3000].into_iter()), 1024..2560);
        // Three chunks, 1440 particles of 2976.
        assert_eq!(interior(&own, [1030, 2100].into_iter()), 4000..4000);
        assert_eq!(interior(&(512..512), std::iter::empty()), 512..512);
    }
}
