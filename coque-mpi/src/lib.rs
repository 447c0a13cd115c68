//! Processes that a launcher of MPI started together, as those who march one model of coque (`Peers`); the command `coque-mpi` is
//! `coque` for them.
//!
//! MPI moves the bytes, by the bindings of the crate `ferrompi`; nothing here knows a model. All of it is behind the feature `mpi`, which takes
//! an MPI library and its `mpicc` to build: without the feature the crate is empty.
//!
//! | question | answer | file |
//! |---|---|---|
//! | who was started with this process | `World` | `world.rs` |
//! | how all of them end at once | `Ending` | `ending.rs` |
//! | sums, maxima and rows between them | `Messages` | `messages.rs` |
//! | what the command does with them | `coque::command_line_in` | `main.rs` |
//!
//! # What is asked of MPI
//!
//! Version 3 or later, calls from one thread at a time (`MPI_THREAD_SERIALIZED`). A step takes one reduction of integers and, for each partner of a lane,
//! a persistent send and a persistent receive; they are made with their buffers when the lane is opened. Messages have at most 2²⁴ numbers.
//!
//! # What holds, and the test that says so
//!
//! | invariant | test |
//! |---|---|
//! | sums, maxima, rows, gathers are those of threads as peers | `messages_carry_what_threads_carry` (tests/messages.rs, under `mpirun`) |
//! | whoever panics, fails or leaves ends all | `one_ends_all` (the same) |
//! | runs of scenes, how they end | tests/runs.rs |
#![warn(missing_docs)]
#![cfg(feature = "mpi")]

mod ending;
mod messages;
mod world;

pub use ending::{CANNOT_GO_ON, Ending};
pub use messages::Messages;
pub use world::{JoinError, World};
