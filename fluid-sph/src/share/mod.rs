//! Who marches a fluid together: sums and maxima over all of them, what they exchange, and when all is dealt out anew.
//!
//! Each keeps a state of the particles that he knows alone, in the order of their numbers, so that cells hold the same in the same
//! order as with one who knows all. He sweeps those that he moves and those in his cells. Velocities of what others move come in after
//! each kick, densities after each drift; places follow from velocities. One who marches alone knows, moves and adds all.

pub(crate) mod deal;

use std::fmt;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use peers::{Exact, Greatest, Lane, Peers};

use crate::cells::{Extent, Grid};
use crate::share::deal::{Deal, Dealt};
use crate::state::State;

/// A fluid's part among those who march it; alone there is none.
#[derive(Clone, Debug, Default)]
pub(crate) struct Share(Option<Box<Shared>>);

/// One of several.
pub(crate) struct Shared {
    peers: Arc<Mutex<Box<dyn Peers>>>,
    pub deal: Deal,
    /// All particles, as they were brought last.
    pub whole: State,
    /// How far the fastest particle and the fastest point of a boundary may have gone since all was dealt out \[L\].
    pub gone: [f64; 2],
    /// For vectors and for numbers; opened when first needed.
    lanes: Option<[Lane; 2]>,
    /// Forces on the way to all.
    forces: Vec<[f64; 3]>,
}

/// A copy exchanges on lanes of its own: all make one, or none does.
impl Clone for Shared {
    fn clone(&self) -> Self {
        let Self { peers, deal, whole, gone, .. } = self;
        let (peers, deal, whole) = (Arc::clone(peers), deal.clone(), whole.clone());
        Self { peers, deal, whole, gone: *gone, lanes: None, forces: Vec::new() }
    }
}

impl fmt::Debug for Shared {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Shared").field("known", &self.deal.known.len()).finish_non_exhaustive()
    }
}

impl Share {
    /// That of one of several, by how it was dealt out to a rank of so many.
    pub fn new(peers: Box<dyn Peers>, whole: State, deal: impl FnOnce(usize, usize) -> Deal) -> Self {
        let deal = deal(peers.rank(), peers.count());
        let peers = Arc::new(Mutex::new(peers));
        let (gone, lanes, forces) = ([0.0; 2], None, Vec::new());
        Self(Some(Box::new(Shared { peers, deal, whole, gone, lanes, forces })))
    }

    /// What there is of one of several.
    pub fn shared(&self) -> Option<&Shared> {
        self.0.as_deref()
    }

    /// The same, to be changed.
    pub fn shared_mut(&mut self) -> Option<&mut Shared> {
        self.0.as_deref_mut()
    }

    /// By particle known: whether this one moves it; empty where all are its own.
    pub fn moves(&self) -> &[bool] {
        self.shared().map_or(&[], |shared| &shared.deal.moves)
    }

    /// By point of the boundary: whether its forces are this one's; empty where all are.
    pub fn owns(&self) -> &[bool] {
        self.shared().map_or(&[], |shared| &shared.deal.owns)
    }

    /// By point of the boundary: whether this one has to know it; empty where it has to know all.
    pub fn near(&self) -> &[bool] {
        self.shared().map_or(&[], |shared| &shared.deal.near)
    }

    /// Whether this one adds what is in a cell.
    pub fn adds(&self, grid: &Grid, cell: usize) -> bool {
        self.shared().is_none_or(|shared| shared.deal.adds(grid, cell))
    }

    /// The number of a particle known.
    pub fn number(&self, known: usize) -> usize {
        self.shared().map_or(known, |shared| shared.deal.known[known] as usize)
    }

    /// Number of all particles, of whom so many are known.
    pub fn all(&self, known: usize) -> usize {
        self.shared().map_or(known, |shared| shared.whole.densities.len())
    }

    /// Adds over all.
    pub fn add<const N: usize>(&self, mut sums: [Exact; N]) -> [f64; N] {
        if let Some(shared) = self.shared() {
            shared.peers().add(&mut sums, &mut []);
        }
        sums.map(|sum| sum.value())
    }

    /// The greatest of all, number by number.
    pub fn greatest<const N: usize>(&self, numbers: [f64; N]) -> [f64; N] {
        let Some(shared) = self.shared() else { return numbers };
        let mut found = numbers.map(|number| Greatest::of(number, 0));
        shared.peers().greatest(&mut found);
        found.map(Greatest::value)
    }

    /// The greatest of values, each with a number; none if nobody has one.
    pub fn greatest_of(&self, own: Option<(f64, usize)>) -> Option<(f64, usize)> {
        let mut found = [own.map_or(Greatest::NONE, |(value, number)| Greatest::of(value, number as u64))];
        if let Some(shared) = self.shared() {
            shared.peers().greatest(&mut found);
        }
        (found[0] != Greatest::NONE).then(|| (found[0].value(), found[0].number() as usize))
    }

    /// What the one who moves a particle says of it, for all.
    pub fn reported<const N: usize>(&self, number: usize, say: impl Fn(usize) -> [f64; N]) -> [f64; N] {
        let Some(shared) = self.shared() else { return say(number) };
        let Deal { known, moves, .. } = &shared.deal;
        let own = known.binary_search(&(number as u32)).ok().filter(|&known| moves[known]);
        let mut words = own.map_or([0; N], |known| say(known).map(|number| number.to_bits() as i64));
        shared.peers().add(&mut [], &mut words);
        words.map(|word| f64::from_bits(word as u64))
    }

    /// The box of the particles of all.
    pub fn widened(&self, extent: Extent) -> Extent {
        if self.shared().is_none() {
            return extent;
        }
        let Extent { low: [x, y, z], high: [u, v, w] } = extent;
        let [x, y, z, u, v, w] = self.greatest([-x, -y, -z, u, v, w]);
        Extent { low: [-x, -y, -z], high: [u, v, w] }
    }

    /// Brings vectors of particles that others move, each at its place.
    pub fn bring_vectors<T>(&mut self, rows: &mut [T], at: impl Fn(usize) -> usize)
    where
        T: From<[f64; 3]> + Into<[f64; 3]> + Copy,
    {
        let read = |row: &T, numbers: &mut [f64]| numbers.copy_from_slice(&(*row).into());
        let write = |row: &mut T, numbers: &[f64]| *row = [numbers[0], numbers[1], numbers[2]].into();
        self.exchange(0, rows, at, read, write);
    }

    /// Brings numbers of particles that others move.
    pub fn bring_numbers(&mut self, numbers: &mut [f64]) {
        self.exchange(1, numbers, |known| known, |own, out| out[0] = *own, |own, found| *own = found[0]);
    }

    /// Brings the forces on all points of structures to all.
    pub fn bring_forces(&mut self, on_points: &mut [[f64; 3]]) {
        let Some(Shared { peers, deal, forces, .. }) = self.shared_mut() else { return };
        if on_points.is_empty() {
            return;
        }
        let (Dealt { order, cut }, mut peers) = (&deal.wet, locked(peers));
        forces.resize(order.len(), [0.0; 3]);
        for place in cut.own(peers.rank()) {
            forces[place] = on_points[order[place] as usize];
        }
        peers.gather_to_all(cut, forces.as_flattened_mut(), 3);
        for (&point, force) in order.iter().zip(forces) {
            on_points[point as usize] = *force;
        }
    }

    fn exchange<T>(
        &mut self,
        lane: usize,
        rows: &mut [T],
        at: impl Fn(usize) -> usize,
        read: impl Fn(&T, &mut [f64]),
        write: impl Fn(&mut T, &[f64]),
    ) {
        let Some(Shared { peers, deal, lanes, .. }) = self.shared_mut() else { return };
        let mut peers = locked(peers);
        let lanes = lanes.get_or_insert_with(|| [3, 1].map(|width| peers.open(&deal.lists, width)));
        peers.send(&lanes[lane], &|known, numbers| read(&rows[at(known as usize)], numbers));
        peers.take(&lanes[lane], &mut |known, numbers| write(&mut rows[at(known as usize)], numbers));
    }
}

impl Shared {
    fn peers(&self) -> MutexGuard<'_, Box<dyn Peers>> {
        locked(&self.peers)
    }

    /// Brings rows of all to all: `own` says what this one has of one of its own, `put` takes it of each.
    pub fn gather<const N: usize>(
        &self,
        dealt: &Dealt,
        own: impl Fn(usize) -> [f64; N],
        mut put: impl FnMut(usize, [f64; N]),
    ) {
        let Dealt { order, cut } = dealt;
        let mut peers = self.peers();
        let mut rows = vec![[0.0; N]; order.len()];
        for place in cut.own(peers.rank()) {
            rows[place] = own(order[place] as usize);
        }
        peers.gather_to_all(cut, rows.as_flattened_mut(), N);
        for (&number, row) in order.iter().zip(rows) {
            put(number as usize, row);
        }
    }

    /// Takes up another deal.
    pub fn take_up(&mut self, deal: impl FnOnce(usize, usize) -> Deal) {
        let mut peers = locked(&self.peers);
        self.deal = deal(peers.rank(), peers.count());
        self.gone = [0.0; 2];
        if let Some(lanes) = self.lanes.take() {
            lanes.into_iter().for_each(|lane| peers.close(lane));
        }
    }
}

fn locked(peers: &Mutex<Box<dyn Peers>>) -> MutexGuard<'_, Box<dyn Peers>> {
    peers.lock().unwrap_or_else(PoisonError::into_inner)
}
