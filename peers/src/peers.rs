//! What a model asks of those with whom it is marched, and the answer of one who is alone.

use crate::cut::Cut;
use crate::exact::Exact;
use crate::greatest::Greatest;
use crate::lists::Lists;

/// A way to exchange rows, opened once and used in every step.
#[derive(Debug)]
pub struct Lane(usize);

impl Lane {
    /// The handle of the lane of this number; only implementations of [`Peers`] make one.
    pub fn numbered(number: usize) -> Self {
        Self(number)
    }

    /// Its number.
    pub fn number(&self) -> usize {
        self.0
    }
}

/// Those who march one model together.
///
/// All are equal and do the same: **every method but `rank`, `count` and `fail` is called by all peers, in the same order, with slices
/// and widths of the same lengths**, also by one who has nothing to give. Who owns no particle adds zero, gives
/// [`Greatest::NONE`], opens empty lists. Then no call waits for ever, and what comes back is the same to the bit on each
/// peer and for any number of peers:
///
/// - `add` is exact, so that what the model is added up from alone decides, chunks in their order ([`Exact::add_in_chunks`]);
/// - `greatest` does not depend on order;
/// - rows are copied, never calculated with.
///
/// What depends on one process alone, a wall clock, Ctrl-C, a full disk, must never decide on its own: it rides as a count in
/// the sum of the step, and all act on the total.
///
/// A failure of the others is not returned: whoever cannot go on calls `fail` or panics, and that ends all.
///
/// # For a library of messages
///
/// - `add` is one reduction of 64-bit integers by sum, over the [words](Exact::words_mut) of all sums and the counts, put back in place.
/// - `greatest` is one by maximum of the values, then one by minimum of the numbers of those that have it; [`Greatest::of`] makes it again.
/// - `open` makes a buffer and a request that lasts for each partner and way; `send` waits for its own last requests, fills the buffers and
///   starts; `take` waits, hands over and lets the next rows come. As all call in the same order nobody waits for ever.
/// - `fail` writes the message and ends every process with a code that is not zero; it must not unwind, and neither may a panic.
pub trait Peers: Send {
    /// Which of them this one is, from zero.
    fn rank(&self) -> usize;

    /// How many they are.
    fn count(&self) -> usize;

    /// Adds: each entry becomes the sum of those of all peers. `counts` go along in the same message: whole numbers, and words of
    /// which one peer alone knows (its total is above zero where any gave one). Both empty, all wait for each other.
    fn add(&mut self, sums: &mut [Exact], counts: &mut [i64]);

    /// Each entry becomes the greatest of those of all peers.
    fn greatest(&mut self, found: &mut [Greatest]);

    /// Opens a lane for rows of `width` numbers; what one sends another must take. Makes its buffers, so that a step allocates nothing.
    fn open(&mut self, lists: &Lists, width: usize) -> Lane;

    /// Sends rows: `row(particle, numbers)` writes those of each particle that partners need. Returns as soon as they are written, so
    /// that what needs no ghost can be done before [`take`](Self::take). On a lane a send is followed by a take before the next send.
    fn send(&mut self, lane: &Lane, row: &dyn Fn(u32, &mut [f64]));

    /// Waits for what partners sent and hands over `row(particle, numbers)` of each ghost once.
    fn take(&mut self, lane: &Lane, row: &mut dyn FnMut(u32, &[f64]));

    /// Closes a lane: between a take and the next send.
    fn close(&mut self, lane: Lane);

    /// Brings rows to rank 0. Each has `rows` for all particles, of `width` numbers, and gives those that it owns by the cut; on rank 0 all
    /// are right afterwards, on others nothing changes.
    fn gather(&mut self, cut: &Cut, rows: &mut [f64], width: usize);

    /// Brings rows to all: like [`gather`](Self::gather), and right on every peer.
    fn gather_to_all(&mut self, cut: &Cut, rows: &mut [f64], width: usize);

    /// Ends all peers with one message, whatever they are doing: for what befalls one alone and leaves no way to go on.
    fn fail(&self, message: &str) -> !;
}

/// One who marches alone: nothing to exchange, nothing to pay.
#[derive(Clone, Copy, Debug, Default)]
pub struct Alone;

impl Peers for Alone {
    fn rank(&self) -> usize {
        0
    }

    fn count(&self) -> usize {
        1
    }

    fn add(&mut self, _: &mut [Exact], _: &mut [i64]) {}

    fn greatest(&mut self, _: &mut [Greatest]) {}

    fn open(&mut self, lists: &Lists, _: usize) -> Lane {
        if let Some(partner) = lists.partners().first() {
            self.fail(&format!("a lane to peer {}, but there is none beside this one", partner.rank));
        }
        Lane(0)
    }

    fn send(&mut self, _: &Lane, _: &dyn Fn(u32, &mut [f64])) {}

    fn take(&mut self, _: &Lane, _: &mut dyn FnMut(u32, &[f64])) {}

    fn close(&mut self, _: Lane) {}

    fn gather(&mut self, _: &Cut, _: &mut [f64], _: usize) {}

    fn gather_to_all(&mut self, _: &Cut, _: &mut [f64], _: usize) {}

    /// # Panics
    /// Always, with the message.
    fn fail(&self, message: &str) -> ! {
        panic!("{message}")
    }
}
