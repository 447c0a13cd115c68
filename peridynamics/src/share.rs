//! Who marches a solid together: whose nodes are whose, what they exchange, sums over all of them, loops over own nodes.
//!
//! Each has the whole arrays, sweeps the bonds of its own nodes and moves these alone. Places of *ghosts*, nodes of others at the
//! other ends of those bonds, come in before a sweep, and where bonds have dilatations, or yield, what was found of them. Both ends
//! of a bond see the same extension to the bit, so that each breaks its own direction of it. Sums of chunks are added exactly
//! ([`peers::Exact`]): a march has the same bits whoever marches it, alone too.

use std::ops::Range;
use std::sync::{Mutex, MutexGuard, PoisonError};

use parallel::{CHUNK, Lists};
use peers::{Alone, Cut, Exact, Lane, Peers, agree};

/// Shares begin where chunks do.
const _: () = assert!(peers::CHUNK == CHUNK);

/// One of those who march a solid.
pub(crate) struct Share {
    peers: Mutex<Box<dyn Peers>>,
    cut: Cut,
    own: Range<usize>,
    /// A run of own chunks whose bonds end at own nodes.
    inner: Range<usize>,
    /// Ways for places, and for what is found from them; none alone.
    places: Option<Lane>,
    found: Option<Lane>,
    threads: usize,
}

/// Adds the nodes at the other ends of a node's bonds to a list.
type Ends<'a> = dyn Fn(usize, &mut Vec<u32>) + 'a;

/// What the bonds of a solid need of other nodes.
pub(crate) struct Reach<'a> {
    /// Whether places of all nodes are needed, wherever bonds end.
    pub everywhere: bool,
    pub ends: Box<Ends<'a>>,
    /// Whether chunks that need no ghost may be swept before the others.
    pub in_turn: bool,
    /// Numbers of each node that follow from places and are needed at the other ends of its bonds.
    pub found: usize,
}

impl Share {
    /// Of a solid of so many rows that is marched by one.
    pub fn alone(rows: usize, threads: usize) -> Self {
        Self {
            peers: Mutex::new(Box::new(Alone)),
            cut: Cut::even(rows, 1),
            own: 0..rows,
            inner: 0..0,
            places: None,
            found: None,
            threads,
        }
    }

    /// Of one of several.
    pub fn new(mut peers: Box<dyn Peers>, nodes: usize, threads: usize, reach: &Reach<'_>) -> Self {
        let cut = Cut::even(nodes, peers.count());
        let own = cut.own(peers.rank());
        let (mut needs, mut inner, mut run) = (Vec::new(), own.start..own.start, own.start);
        let mut ends = Vec::new();
        for first in own.clone().step_by(CHUNK) {
            let chunk = first..(first + CHUNK).min(own.end);
            ends.clear();
            if reach.everywhere {
                run = chunk.end;
                continue;
            }
            chunk.clone().for_each(|node| (reach.ends)(node, &mut ends));
            ends.retain(|&node| !own.contains(&(node as usize)));
            ends.sort_unstable();
            ends.dedup();
            if !ends.is_empty() || !reach.in_turn {
                run = chunk.end;
            } else if chunk.end - run > inner.len() {
                inner = run..chunk.end;
            }
            needs.extend_from_slice(&ends);
        }
        if reach.everywhere {
            needs.extend((0..nodes as u32).filter(|&node| !own.contains(&(node as usize))));
        }
        let lists = agree(&mut *peers, &cut, &needs);
        let several = peers.count() > 1;
        let places = several.then(|| peers.open(&lists, 3));
        let found = (several && reach.found > 0).then(|| peers.open(&lists, reach.found));
        Self { peers: Mutex::new(peers), cut, own, inner, places, found, threads }
    }

    fn peers(&self) -> MutexGuard<'_, Box<dyn Peers>> {
        self.peers.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Threads, at least one.
    pub fn threads(&self) -> usize {
        self.threads
    }

    /// Whether there are others.
    pub fn is_shared(&self) -> bool {
        self.places.is_some()
    }

    /// The own ones of so many rows: of a plate, which one marches alone, nodes, or nodes and directors.
    pub fn own(&self, rows: usize) -> Range<usize> {
        self.own.start.min(rows)..self.own.end.min(rows)
    }

    /// Their chunks.
    pub fn chunks_of(&self, rows: usize) -> Range<usize> {
        let own = self.own(rows);
        own.start / CHUNK..own.end.div_ceil(CHUNK)
    }

    /// A run of own nodes that are swept while ghosts are on their way.
    pub fn inner(&self) -> Range<usize> {
        self.inner.clone()
    }

    /// The other own ones of so many nodes, swept behind that.
    pub fn outer(&self, nodes: usize) -> [Range<usize>; 2] {
        let own = self.own(nodes);
        [own.start..self.inner.start, self.inner.end..own.end]
    }

    /// Calls `work(first, chunk)` for each chunk of lists that begin with a node.
    pub fn sweep<L: Lists>(&self, from: usize, lists: L, work: impl Fn(usize, L) + Sync) {
        if !lists.is_empty() {
            parallel::chunks(self.threads, lists, |first, chunk| work(from + first, chunk));
        }
    }

    /// Sends places of nodes that others need.
    pub fn send_places(&self, rows: &[[f64; 4]]) {
        if let Some(lane) = &self.places {
            self.peers().send(lane, &|node, place| place.copy_from_slice(&rows[node as usize][..3]));
        }
    }

    /// Waits for places of ghosts.
    pub fn take_places(&self, rows: &mut [[f64; 4]]) {
        if let Some(lane) = &self.places {
            self.peers().take(lane, &mut |node, place| rows[node as usize][..3].copy_from_slice(place));
        }
    }

    /// Both.
    pub fn exchange_places(&self, rows: &mut [[f64; 4]]) {
        self.send_places(rows);
        self.take_places(rows);
    }

    /// Sends what was found of nodes that others need.
    pub fn send_found(&self, row: impl Fn(usize, &mut [f64])) {
        if let Some(lane) = &self.found {
            self.peers().send(lane, &|node, found| row(node as usize, found));
        }
    }

    /// Waits for what was found of ghosts.
    pub fn take_found(&self, mut row: impl FnMut(usize, &[f64])) {
        if let Some(lane) = &self.found {
            self.peers().take(lane, &mut |node, found| row(node as usize, found));
        }
    }

    /// Brings numbers of all nodes, so many each, to all.
    pub fn bring(&self, numbers: &mut [f64], width: usize) {
        if self.is_shared() {
            self.peers().gather_to_all(&self.cut, numbers, width);
        }
    }

    /// The same of lists that begin, node by node, where `starts` says.
    pub fn bring_lists(&self, starts: &[u32], numbers: &mut [f64], width: usize) {
        if self.is_shared() {
            let borders = (0..self.cut.peers()).map(|rank| self.cut.own(rank).end);
            let cut = Cut::at([0].into_iter().chain(borders).map(|node| starts[node] as usize).collect());
            self.peers().gather_to_all(&cut, numbers, width);
        }
    }

    /// The numbers that each has, those of all one behind the other.
    pub fn all(&self, own: Vec<usize>) -> Vec<usize> {
        if !self.is_shared() {
            return own;
        }
        let mut peers = self.peers();
        let (rank, mut counts) = (peers.rank(), vec![0; peers.count()]);
        counts[rank] = own.len() as i64;
        peers.add(&mut [], &mut counts);
        let mut borders = vec![0];
        borders.extend(counts.iter().scan(0, |end, count| {
            *end += *count as usize;
            Some(*end)
        }));
        let cut = Cut::at(borders);
        let mut all = vec![0.0; cut.particles()];
        all[cut.own(rank)].iter_mut().zip(own).for_each(|(all, own)| *all = own as f64);
        peers.gather_to_all(&cut, &mut all, 1);
        all.into_iter().map(|number| number as usize).collect()
    }

    /// Whether any of them says so.
    pub fn any(&self, here: bool) -> bool {
        if !self.is_shared() {
            return here;
        }
        let mut counts = [i64::from(here)];
        self.peers().add(&mut [], &mut counts);
        counts[0] > 0
    }

    /// Adds sums of all.
    pub fn total(&self, mut own: Exact) -> f64 {
        self.peers().add(std::slice::from_mut(&mut own), &mut []);
        own.value()
    }

    /// Adds numbers of own chunks over all.
    pub fn sum<const N: usize>(&self, numbers: impl Iterator<Item = [f64; N]>) -> [f64; N] {
        self.peers().sum(numbers)
    }

    /// `a·b` of vectors of so many numbers a row, of all their parts.
    pub fn dot(&self, a: &[f64], b: &[f64], width: usize) -> f64 {
        let own = self.own.start * width..self.own.end * width;
        self.peers().dot(&a[own.clone()], &b[own], width)
    }

    /// The greatest of values of all, each with its number.
    pub fn greatest(&self, own: impl Iterator<Item = (f64, usize)>) -> (f64, usize) {
        self.peers().greatest_of(own)
    }
}
