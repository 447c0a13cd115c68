//! Sums, maxima and rows as messages of MPI.

use std::ops::Range;

use ferrompi::{Communicator, PersistentRequest, ReduceOp};
use peers::{Cut, Exact, Greatest, Lane, Lists, Peers};

use crate::ending::Ending;

/// Numbers of a message at most: 128 MiB. Before version 4 MPI counts them in 31 bits.
const BLOCK: usize = 1 << 24;
/// Marks messages of gathers; the greatest mark that every MPI has. Those of lanes are their numbers, below it.
const GATHER: i32 = 32767;

/// One of the processes, with its open lanes.
pub struct Messages {
    all: Communicator,
    ending: Ending,
    lanes: Vec<Option<OpenLane>>,
    /// Bytes of rows handed to MPI so far.
    sent: u64,
    /// Words of sums on their way; as long as the longest was.
    words: Vec<i64>,
    /// The greatest values and their numbers on their way.
    greatest: (Vec<f64>, Vec<u64>),
}

/// What goes to partners, and what comes from them.
struct OpenLane {
    width: usize,
    out: Vec<Message>,
    back: Vec<Message>,
}

/// A message that lasts: its particles, and the request with the buffer of their rows.
struct Message {
    particles: Vec<u32>,
    request: PersistentRequest<f64>,
}

impl Messages {
    /// Over a communicator of its own.
    pub fn new(all: Communicator, ending: Ending) -> Self {
        Self {
            all,
            ending,
            lanes: Vec::new(),
            sent: 0,
            words: Vec::new(),
            greatest: (Vec::new(), Vec::new()),
        }
    }

    /// Bytes of rows that lanes have handed to MPI so far.
    pub fn bytes_sent(&self) -> u64 {
        self.sent
    }

    /// What MPI gave, or the end of all.
    fn sure<T>(&self, result: ferrompi::Result<T>) -> T {
        sure(&self.ending, result)
    }

    /// Numbers of the rows that a rank owns, in blocks.
    fn blocks(own: Range<usize>, width: usize) -> impl Iterator<Item = Range<usize>> {
        let (first, end) = (own.start * width, own.end * width);
        (first..end).step_by(BLOCK).map(move |start| start..(start + BLOCK).min(end))
    }
}

fn sure<T>(ending: &Ending, result: ferrompi::Result<T>) -> T {
    result.unwrap_or_else(|error| ending.end(&format!("a message failed: {error}")))
}

impl Peers for Messages {
    fn rank(&self) -> usize {
        self.all.rank() as usize
    }

    fn count(&self) -> usize {
        self.all.size() as usize
    }

    fn add(&mut self, sums: &mut [Exact], counts: &mut [i64]) {
        self.words.clear();
        for sum in sums.iter_mut() {
            self.words.extend_from_slice(sum.words_mut());
        }
        self.words.extend_from_slice(counts);
        if self.words.is_empty() {
            return self.sure(self.all.barrier());
        }
        let result = self.all.allreduce_inplace(&mut self.words, ReduceOp::Sum);
        self.sure(result);
        let (of_sums, of_counts) = self.words.split_at(sums.len() * Exact::WORDS);
        for (sum, words) in sums.iter_mut().zip(of_sums.chunks_exact(Exact::WORDS)) {
            sum.words_mut().copy_from_slice(words);
        }
        counts.copy_from_slice(of_counts);
    }

    fn greatest(&mut self, found: &mut [Greatest]) {
        let (values, numbers) = &mut self.greatest;
        values.clear();
        values.extend(found.iter().map(|own| own.value()));
        sure(&self.ending, self.all.allreduce_inplace(values, ReduceOp::Max));
        numbers.clear();
        // Of several that have it the one with the least number; a value that nobody has is that of nobody.
        let of =
            |(own, value): (&Greatest, &f64)| if own.value() == *value { own.number() } else { u64::MAX };
        numbers.extend(found.iter().zip(&*values).map(of));
        sure(&self.ending, self.all.allreduce_inplace(numbers, ReduceOp::Min));
        for ((found, value), number) in found.iter_mut().zip(values).zip(numbers) {
            *found = Greatest::of(*value, *number);
        }
    }

    fn open(&mut self, lists: &Lists, width: usize) -> Lane {
        let free = self.lanes.iter().position(Option::is_none);
        let number = free.unwrap_or(self.lanes.len());
        let (mut out, mut back) = (Vec::new(), Vec::new());
        for partner in lists.partners() {
            let (rank, tag) = (partner.rank as i32, number as i32);
            for block in partner.send.chunks((BLOCK / width).max(1)) {
                let request = self.all.send_init(vec![0.0; block.len() * width], rank, tag);
                out.push(Message { particles: block.to_vec(), request: self.sure(request) });
            }
            for block in partner.take.chunks((BLOCK / width).max(1)) {
                let request = self.all.recv_init(vec![0.0; block.len() * width], rank, tag);
                back.push(Message { particles: block.to_vec(), request: self.sure(request) });
            }
        }
        let open = Some(OpenLane { width, out, back });
        match free {
            Some(number) => self.lanes[number] = open,
            None => self.lanes.push(open),
        }
        Lane::numbered(number)
    }

    fn send(&mut self, lane: &Lane, row: &dyn Fn(u32, &mut [f64])) {
        let Some(Some(OpenLane { width, out, back })) = self.lanes.get_mut(lane.number()) else { return };
        for message in back {
            sure(&self.ending, message.request.start());
        }
        for Message { particles, request } in out {
            sure(&self.ending, request.wait());
            let numbers = sure(&self.ending, request.buffer_mut());
            for (&particle, numbers) in particles.iter().zip(numbers.chunks_exact_mut(*width)) {
                row(particle, numbers);
            }
            self.sent += size_of_val(numbers) as u64;
            sure(&self.ending, request.start());
        }
    }

    fn take(&mut self, lane: &Lane, row: &mut dyn FnMut(u32, &[f64])) {
        let Some(Some(OpenLane { width, back, .. })) = self.lanes.get_mut(lane.number()) else { return };
        for Message { particles, request } in back {
            sure(&self.ending, request.wait());
            let numbers = sure(&self.ending, request.buffer());
            for (&particle, numbers) in particles.iter().zip(numbers.chunks_exact(*width)) {
                row(particle, numbers);
            }
        }
    }

    fn close(&mut self, lane: Lane) {
        if let Some(open) = self.lanes.get_mut(lane.number()) {
            *open = None;
        }
    }

    fn gather(&mut self, cut: &Cut, rows: &mut [f64], width: usize) {
        let rank = self.rank();
        for owner in 1..self.count() {
            for block in Self::blocks(cut.own(owner), width) {
                if rank == 0 {
                    self.sure(self.all.recv(&mut rows[block], owner as i32, GATHER).map(|_| ()));
                } else if rank == owner {
                    self.sure(self.all.send(&rows[block], 0, GATHER));
                }
            }
        }
    }

    fn gather_to_all(&mut self, cut: &Cut, rows: &mut [f64], width: usize) {
        for owner in 0..self.count() {
            for block in Self::blocks(cut.own(owner), width) {
                self.sure(self.all.broadcast(&mut rows[block], owner as i32));
            }
        }
    }

    fn fail(&self, message: &str) -> ! {
        self.ending.end(message)
    }
}
