//! Threads as peers: what is marched together is tested without any library for messages.

mod meeting;

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::thread;

use thiserror::Error;

use crate::cut::Cut;
use crate::exact::Exact;
use crate::greatest::Greatest;
use crate::lists::Lists;
use crate::peers::{Lane, Peers};
use meeting::{Board, Call, Doing, Met, Shared};

/// What ended all: the message of the first that failed or panicked.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("peer {rank} of {count}: {message}")]
pub struct Failure {
    /// The rank that ended all.
    pub rank: usize,
    /// Number of peers.
    pub count: usize,
    /// Why.
    pub message: String,
}

/// Runs `each` on as many threads, each of them one of the peers, and returns what they found, by rank.
///
/// # Errors
/// The message of the first that failed, panicked, or called something else than the others. Peers that wait for each other and
/// cannot go on, one of them because another has returned, are such a failure too: nothing hangs. A peer at its own work ends at its
/// next call.
///
/// # Panics
/// If `count` is zero.
///
/// ```
/// use peers::{Exact, together};
///
/// let sums = together(3, |mut peers| {
///     let mut sum = [Exact::new()];
///     sum[0].add(0.1 * peers.rank() as f64);
///     peers.add(&mut sum, &mut []);
///     sum[0].value()
/// })?;
/// assert_eq!(sums, [0.1 + 0.2; 3]);
///
/// let failure = together(2, |peers| if peers.rank() == 1 { peers.fail("no room on the disk") });
/// assert_eq!(failure.unwrap_err().to_string(), "peer 1 of 2: no room on the disk");
/// # Ok::<(), peers::Failure>(())
/// ```
pub fn together<R: Send>(count: usize, each: impl Fn(Box<dyn Peers>) -> R + Sync) -> Result<Vec<R>, Failure> {
    assert!(count > 0, "nobody");
    let shared = Arc::new(Shared::new(count));
    let run = |rank: usize| {
        let peer = Thread { rank, shared: Arc::clone(&shared), meetings: 0, lanes: Vec::new() };
        let found = catch_unwind(AssertUnwindSafe(|| each(Box::new(peer))));
        shared.leave(rank, found.as_ref().err().map(|payload| message(payload.as_ref())));
        found.ok()
    };
    let found: Vec<Option<R>> = thread::scope(|scope| {
        let run = &run;
        let peers: Vec<_> = (0..count).map(|rank| scope.spawn(move || run(rank))).collect();
        peers.into_iter().map(|peer| peer.join().ok().flatten()).collect()
    });
    match shared.failure() {
        Some(failure) => Err(failure),
        None => Ok(found.into_iter().flatten().collect()),
    }
}

/// What a panic says.
fn message(payload: &(dyn Any + Send)) -> String {
    let text = payload.downcast_ref::<&str>().map(|text| (*text).to_owned());
    text.or_else(|| payload.downcast_ref::<String>().cloned()).unwrap_or_else(|| "a panic".to_owned())
}

/// One of the threads.
struct Thread {
    rank: usize,
    shared: Arc<Shared>,
    /// Meetings so far, the same for all.
    meetings: u64,
    /// Those it has opened, by number; none once closed.
    lanes: Vec<Option<Ends>>,
}

/// A peer's ends of a lane.
struct Ends {
    width: usize,
    send: Vec<End>,
    take: Vec<End>,
    /// Whether a take is due.
    sent: bool,
}

/// What goes to a partner, or comes from it.
struct End {
    partner: usize,
    particles: Vec<u32>,
    rows: Vec<f64>,
}

impl Ends {
    fn new(lists: &Lists, width: usize) -> Self {
        let end = |partner: usize, particles: &[u32]| End {
            partner,
            particles: particles.to_vec(),
            rows: vec![0.0; particles.len() * width],
        };
        let full = |end: &End| !end.particles.is_empty();
        let partners = lists.partners().iter();
        let send = partners.clone().map(|partner| end(partner.rank, &partner.send)).filter(full).collect();
        let take = partners.map(|partner| end(partner.rank, &partner.take)).filter(full).collect();
        Self { width, send, take, sent: false }
    }
}

impl Thread {
    fn meet(&mut self, call: Call, bring: impl FnOnce(&mut Board, bool)) -> Met<'_> {
        self.meetings += 1;
        self.shared.meet(self.rank, self.meetings, call, bring)
    }

    /// Its ends of an open lane, on which a take is due or none.
    fn ends(&mut self, lane: &Lane, sent: bool) -> &mut Ends {
        let (number, rank) = (lane.number(), self.rank);
        match self.lanes.get_mut(number) {
            Some(Some(ends)) if ends.sent == sent => ends,
            Some(Some(_)) if sent => {
                self.shared.fail(rank, format!("a take on lane {number} without a send"))
            }
            Some(Some(_)) => self.shared.fail(rank, format!("lane {number} was sent on and not taken from")),
            _ => self.shared.fail(rank, format!("lane {number} is not open")),
        }
    }

    fn bring(&mut self, call: Call, cut: &Cut, rows: &mut [f64], width: usize, takes: bool) {
        if cut.peers() != self.count() || cut.particles() * width != rows.len() {
            let (peers, particles, rows) = (cut.peers(), cut.particles(), rows.len());
            self.fail(&format!(
                "{rows} numbers in rows of {width}, of {peers} peers with {particles} particles"
            ));
        }
        let own = cut.own(self.rank);
        let own = own.start * width..own.end * width;
        let met = self.meet(call, |board, _| {
            board.rows.resize(rows.len(), 0.0);
            board.rows[own.clone()].copy_from_slice(&rows[own]);
        });
        if takes {
            rows.copy_from_slice(&met.board().rows);
        }
    }
}

impl Peers for Thread {
    fn rank(&self) -> usize {
        self.rank
    }

    fn count(&self) -> usize {
        self.shared.count()
    }

    fn add(&mut self, sums: &mut [Exact], counts: &mut [i64]) {
        let call = Call::Add { sums: sums.len(), counts: counts.len() };
        let met = self.meet(call, |board, first| {
            let words = sums.iter_mut().flat_map(Exact::words_mut).chain(&mut *counts);
            if first {
                board.words.clear();
                board.words.extend(words.map(|word| *word));
            } else {
                board.words.iter_mut().zip(words).for_each(|(whole, word)| *whole += *word);
            }
        });
        let words = sums.iter_mut().flat_map(Exact::words_mut).chain(counts);
        words.zip(&met.board().words).for_each(|(word, whole)| *word = *whole);
    }

    fn greatest(&mut self, found: &mut [Greatest]) {
        let met = self.meet(Call::Greatest { values: found.len() }, |board, first| {
            if first {
                board.found.clear();
                board.found.extend_from_slice(found);
            } else {
                board.found.iter_mut().zip(&*found).for_each(|(all, own)| *all = all.or(*own));
            }
        });
        found.copy_from_slice(&met.board().found);
    }

    fn open(&mut self, lists: &Lists, width: usize) -> Lane {
        let (rank, count, number) = (self.rank, self.count(), self.lanes.len());
        if let Some(odd) =
            lists.partners().iter().find(|partner| partner.rank >= count || partner.rank == rank)
        {
            self.fail(&format!("a lane to peer {}, which is no other of {count}", odd.rank));
        }
        if width == 0 {
            self.fail("a lane for rows of no numbers");
        }
        let ends = Ends::new(lists, width);
        let mut met = self.meet(Call::Open { width }, |board, first| {
            if first {
                board.words.clear();
                board.words.resize(count * count, 0);
            }
            for end in &ends.send {
                board.words[rank * count + end.partner] = end.particles.len() as i64;
            }
        });
        let taken = |other: usize| {
            ends.take.iter().find(|end| end.partner == other).map_or(0, |end| end.particles.len())
        };
        let sent = |other: usize| met.board().words[other * count + rank];
        if let Some(other) = (0..count).find(|&other| sent(other) != taken(other) as i64) {
            let (sent, taken) = (sent(other), taken(other));
            drop(met);
            self.fail(&format!("peer {other} sends {sent} rows of which {taken} are taken"));
        }
        for end in &ends.send {
            met.state.post(number, rank, end.partner).rows = end.rows.clone();
        }
        drop(met);
        self.lanes.push(Some(ends));
        Lane::numbered(number)
    }

    fn send(&mut self, lane: &Lane, row: &dyn Fn(u32, &mut [f64])) {
        let (shared, rank, number) = (Arc::clone(&self.shared), self.rank, lane.number());
        let ends = self.ends(lane, false);
        ends.sent = true;
        for End { partner, particles, rows } in &mut ends.send {
            for (particle, numbers) in particles.iter().zip(rows.chunks_exact_mut(ends.width)) {
                row(*particle, numbers);
            }
            shared.when(rank, Doing::Sends { lane: number, to: *partner }, |state| {
                let post = state.post(number, rank, *partner);
                std::mem::swap(&mut post.rows, rows);
                post.full = true;
            });
        }
    }

    fn take(&mut self, lane: &Lane, row: &mut dyn FnMut(u32, &[f64])) {
        let (shared, rank, number) = (Arc::clone(&self.shared), self.rank, lane.number());
        let ends = self.ends(lane, true);
        ends.sent = false;
        for End { partner, particles, rows } in &mut ends.take {
            shared.when(rank, Doing::Takes { lane: number, from: *partner }, |state| {
                let post = state.post(number, *partner, rank);
                std::mem::swap(&mut post.rows, rows);
                post.full = false;
            });
            for (particle, numbers) in particles.iter().zip(rows.chunks_exact(ends.width)) {
                row(*particle, numbers);
            }
        }
    }

    fn close(&mut self, lane: Lane) {
        self.ends(&lane, false);
        let number = lane.number();
        self.meet(Call::Close { lane: number }, |_, _| {}).state.forget(number);
        self.lanes[number] = None;
    }

    fn gather(&mut self, cut: &Cut, rows: &mut [f64], width: usize) {
        let takes = self.rank == 0;
        self.bring(Call::Gather { rows: rows.len(), width }, cut, rows, width, takes);
    }

    fn gather_to_all(&mut self, cut: &Cut, rows: &mut [f64], width: usize) {
        self.bring(Call::GatherToAll { rows: rows.len(), width }, cut, rows, width, true);
    }

    fn fail(&self, message: &str) -> ! {
        self.shared.fail(self.rank, message.to_owned())
    }
}
