//! Processes that run one model together: what one of them alone knows, all act on in the same step.
//!
//! A wall clock, Ctrl-C and a full disk are known to one process. If it acted alone the others would wait for it for ever. So it says a
//! word, which rides in the next sum that all of them take ([`Peers::add`]); all hear it there, and act at the same place of their runs.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use peers::{Cut, Exact, Greatest, Lane, Lists, Peers};

/// What a process alone knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Word {
    /// The run is to end.
    Stop,
    /// A checkpoint is due.
    Checkpoint,
}

/// Words that there are.
const WORDS: usize = 2;

/// Processes that run one model together, each of which has one of these; the first speaks and writes for all.
#[derive(Clone)]
pub struct Ranks {
    rank: usize,
    count: usize,
    riding: Arc<Mutex<Riding>>,
}

/// The peers, and the words that ride in their sums.
struct Riding {
    peers: Box<dyn Peers>,
    /// Said here, not yet heard.
    said: [i64; WORDS],
    /// Heard by all in the last sums, not yet acted on.
    heard: [i64; WORDS],
    /// Counts of a sum with the words behind them; as long as the longest was.
    counts: Vec<i64>,
}

impl Ranks {
    /// Those processes.
    pub fn new(peers: Box<dyn Peers>) -> Self {
        let (rank, count) = (peers.rank(), peers.count());
        let riding = Riding { peers, said: [0; WORDS], heard: [0; WORDS], counts: Vec::new() };
        Self { rank, count, riding: Arc::new(Mutex::new(riding)) }
    }

    /// They as a body is given them.
    pub(crate) fn peers(&self) -> Box<dyn Peers> {
        Box::new(self.clone())
    }

    /// Which of them this one is, from zero.
    pub fn rank(&self) -> usize {
        self.rank
    }

    /// Whether this one speaks and writes.
    pub fn is_first(&self) -> bool {
        self.rank == 0
    }

    /// How many they are.
    pub fn number(&self) -> usize {
        self.count
    }

    /// The least of those that failed where each did something of its own; none where all did it.
    pub fn failed(&self, own: bool) -> Option<usize> {
        let mut found = [if own { Greatest::of(0.0, self.rank as u64) } else { Greatest::NONE }];
        self.riding().peers.greatest(&mut found);
        (found[0] != Greatest::NONE).then_some(found[0].number() as usize)
    }

    /// Whether a number is the same for all of them.
    pub fn same(&self, number: u32) -> bool {
        let number = f64::from(number);
        let mut found = [Greatest::of(number, 0), Greatest::of(-number, 0)];
        self.riding().peers.greatest(&mut found);
        found[0].value() == -found[1].value()
    }

    /// Says a word, which all hear in the next sum.
    pub(crate) fn say(&self, word: Word) {
        self.riding().said[word as usize] = 1;
    }

    /// Whether a word was heard since it was last asked for; for all of them the same, if they ask at the same places.
    pub(crate) fn heard(&self, word: Word) -> bool {
        let mut riding = self.riding();
        let heard = std::mem::take(&mut riding.heard[word as usize]) > 0;
        if heard {
            riding.said[word as usize] = 0;
        }
        heard
    }

    fn riding(&self) -> MutexGuard<'_, Riding> {
        self.riding.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The peers that a body is given.
impl Peers for Ranks {
    fn rank(&self) -> usize {
        self.rank
    }

    fn count(&self) -> usize {
        self.count
    }

    fn add(&mut self, sums: &mut [Exact], counts: &mut [i64]) {
        let mut riding = self.riding();
        let Riding { peers, said, heard, counts: all } = &mut *riding;
        all.clear();
        all.extend_from_slice(counts);
        all.extend_from_slice(said);
        peers.add(sums, all);
        let (own, words) = all.split_at(counts.len());
        counts.copy_from_slice(own);
        heard.iter_mut().zip(words).for_each(|(heard, word)| *heard = (*heard).max(*word));
    }

    fn greatest(&mut self, found: &mut [Greatest]) {
        self.riding().peers.greatest(found);
    }

    fn open(&mut self, lists: &Lists, width: usize) -> Lane {
        self.riding().peers.open(lists, width)
    }

    fn send(&mut self, lane: &Lane, row: &dyn Fn(u32, &mut [f64])) {
        self.riding().peers.send(lane, row);
    }

    fn take(&mut self, lane: &Lane, row: &mut dyn FnMut(u32, &[f64])) {
        self.riding().peers.take(lane, row);
    }

    fn close(&mut self, lane: Lane) {
        self.riding().peers.close(lane);
    }

    fn gather(&mut self, cut: &Cut, rows: &mut [f64], width: usize) {
        self.riding().peers.gather(cut, rows, width);
    }

    fn gather_to_all(&mut self, cut: &Cut, rows: &mut [f64], width: usize) {
        self.riding().peers.gather_to_all(cut, rows, width);
    }

    fn fail(&self, message: &str) -> ! {
        self.riding().peers.fail(message)
    }
}
