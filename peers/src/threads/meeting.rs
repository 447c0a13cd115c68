//! What threads that stand for peers share: where they meet, the mail between them, and what each is doing.
//!
//! One lock holds all of it. Whoever has to wait says for what; so the last who still could go on, and has to wait too, sees that nobody can,
//! and ends all instead of waiting for ever.

use std::panic::resume_unwind;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

use crate::greatest::Greatest;
use crate::threads::Failure;

/// What unwinds a peer once there is a message; its own would not count.
struct Ended;

/// What all do together, with the sizes that have to agree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Call {
    Add { sums: usize, counts: usize },
    Greatest { values: usize },
    Open { width: usize },
    Close { lane: usize },
    Gather { rows: usize, width: usize },
    GatherToAll { rows: usize, width: usize },
}

/// What a peer is doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Doing {
    /// Its own work.
    Works,
    /// It waits until all have come to this meeting.
    Meets { meeting: u64, call: Call },
    /// It waits until its last rows on a lane are taken.
    Sends { lane: usize, to: usize },
    /// It waits for rows on a lane.
    Takes { lane: usize, from: usize },
    /// It has returned.
    Left,
}

/// What peers bring to a meeting.
#[derive(Default)]
pub struct Board {
    /// Which meeting it serves, and what is done there.
    meeting: u64,
    call: Option<Call>,
    arrived: usize,
    /// Of sums, one after another, then counts: added word by word, as any library of messages does.
    pub words: Vec<i64>,
    pub found: Vec<Greatest>,
    pub rows: Vec<f64>,
}

/// Rows on their way from one peer to another.
#[derive(Default)]
pub struct Post {
    pub rows: Vec<f64>,
    pub full: bool,
}

pub struct State {
    doing: Vec<Doing>,
    /// Of meetings of even and of odd number: one begins when all have left the one but last.
    boards: [Board; 2],
    /// For each lane the rows from each peer to each.
    mail: Vec<Vec<Post>>,
    failure: Option<Failure>,
}

/// A meeting to which all have come.
pub struct Met<'a> {
    pub state: MutexGuard<'a, State>,
    meeting: u64,
}

pub struct Shared {
    count: usize,
    state: Mutex<State>,
    changed: Condvar,
}

impl State {
    /// Whether nothing keeps a peer from going on.
    fn can_go_on(&self, rank: usize) -> bool {
        match self.doing[rank] {
            Doing::Works => true,
            Doing::Meets { meeting, .. } => self.board(meeting).arrived == self.doing.len(),
            Doing::Sends { lane, to } => !self.posted(lane, rank, to),
            Doing::Takes { lane, from } => self.posted(lane, from, rank),
            Doing::Left => false,
        }
    }

    fn posted(&self, lane: usize, from: usize, to: usize) -> bool {
        let count = self.doing.len();
        self.mail.get(lane).and_then(|posts| posts.get(from * count + to)).is_some_and(|post| post.full)
    }

    fn board(&self, meeting: u64) -> &Board {
        &self.boards[(meeting % 2) as usize]
    }

    /// The rows on a lane from one peer to another.
    pub fn post(&mut self, lane: usize, from: usize, to: usize) -> &mut Post {
        let count = self.doing.len();
        if self.mail.len() <= lane {
            self.mail.resize_with(lane + 1, Vec::new);
        }
        let posts = &mut self.mail[lane];
        posts.resize_with(count * count, Post::default);
        &mut posts[from * count + to]
    }

    /// Forgets what was on a lane.
    pub fn forget(&mut self, lane: usize) {
        if let Some(posts) = self.mail.get_mut(lane) {
            *posts = Vec::new();
        }
    }
}

impl Met<'_> {
    /// What all have brought.
    pub fn board(&self) -> &Board {
        self.state.board(self.meeting)
    }
}

impl Shared {
    pub fn new(count: usize) -> Self {
        let state = State {
            doing: vec![Doing::Works; count],
            boards: Default::default(),
            mail: Vec::new(),
            failure: None,
        };
        Self { count, state: Mutex::new(state), changed: Condvar::new() }
    }

    /// Number of peers.
    pub fn count(&self) -> usize {
        self.count
    }

    /// A lock held by one who panicked is as good as any: all end.
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// All come, and each adds what it brings (`first` if nobody has before); returns when all have.
    pub fn meet(
        &self,
        rank: usize,
        meeting: u64,
        call: Call,
        bring: impl FnOnce(&mut Board, bool),
    ) -> Met<'_> {
        let mut state = self.lock();
        let board = &mut state.boards[(meeting % 2) as usize];
        if board.meeting != meeting {
            (board.meeting, board.call, board.arrived) = (meeting, Some(call), 0);
        }
        if let Some(other) = board.call.filter(|&other| other != call) {
            drop(state);
            self.fail(rank, format!("{call:?} where another peer calls {other:?}"));
        }
        bring(board, board.arrived == 0);
        board.arrived += 1;
        if board.arrived == self.count {
            self.changed.notify_all();
        }
        Met { state: self.wait(state, rank, Doing::Meets { meeting, call }), meeting }
    }

    /// Waits until a peer can go on, then acts on what is shared.
    pub fn when<R>(&self, rank: usize, doing: Doing, act: impl FnOnce(&mut State) -> R) -> R {
        let found = act(&mut self.wait(self.lock(), rank, doing));
        self.changed.notify_all();
        found
    }

    fn wait<'a>(&self, mut state: MutexGuard<'a, State>, rank: usize, doing: Doing) -> MutexGuard<'a, State> {
        state.doing[rank] = doing;
        loop {
            if state.failure.is_some() {
                drop(state);
                resume_unwind(Box::new(Ended));
            }
            if state.can_go_on(rank) {
                state.doing[rank] = Doing::Works;
                return state;
            }
            if (0..self.count).any(|rank| state.can_go_on(rank)) {
                state = self.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
                continue;
            }
            let all: Vec<_> = state.doing.iter().map(|doing| format!("{doing:?}")).collect();
            let message = format!("no peer can go on: {}", all.join(", "));
            self.end(&mut state, rank, message);
        }
    }

    /// Ends all with a message. Who calls it holds no lock.
    pub fn fail(&self, rank: usize, message: String) -> ! {
        self.end(&mut self.lock(), rank, message);
        resume_unwind(Box::new(Ended))
    }

    /// The first message counts.
    fn end(&self, state: &mut State, rank: usize, message: String) {
        state.failure.get_or_insert(Failure { rank, count: self.count, message });
        self.changed.notify_all();
    }

    /// One has returned, or panicked with a message.
    pub fn leave(&self, rank: usize, message: Option<String>) {
        let mut state = self.lock();
        state.doing[rank] = Doing::Left;
        if let Some(message) = message {
            self.end(&mut state, rank, message);
        }
        self.changed.notify_all();
    }

    /// What ended all, if anything did.
    pub fn failure(&self) -> Option<Failure> {
        self.lock().failure.clone()
    }
}
