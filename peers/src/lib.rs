//! Those who march one model together: processes on several machines, or, in tests, threads.
//!
//! One model is shared by *peers*. Each owns a range of its particles, sweeps every point or bond that touches them, and needs the rows of
//! some particles of others, its *ghosts*. This crate has what any model needs for that, and knows no model: sums and maxima that
//! do not depend on how many peers there are, the cut of a model, the lists of what is exchanged, and the trait [`Peers`] for who
//! carries it. It sends nothing between machines itself.
//!
//! | question | answer | file |
//! |---|---|---|
//! | a sum with the same bits for any number of peers | [`Exact`] | `exact.rs` |
//! | a maximum, and who has it | [`Greatest`] | `greatest.rs` |
//! | in which order particles are numbered, so that shares are compact | [`along_curve`] | `curve.rs` |
//! | who owns which particles | [`Cut`] | `cut.rs` |
//! | whose rows go where | [`Lists`]; made by [`agree`] | `lists.rs`, `halo.rs` |
//! | sums, maxima, rows between peers | [`Peers`]; [`Alone`], which costs nothing | `peers.rs` |
//! | sums of chunks, products of vectors, the greatest of values, over all | methods of `dyn Peers` | `over_all.rs` |
//! | threads as peers, for tests | [`together`] | `threads/` |
//!
//! # The same bits
//!
//! What is marched by peers has to be, to the bit, what one process marches; else no result could be compared and no
//! error found. So:
//!
//! - **Order and grouping belong to the model, not to the peers.** The model adds what it has in chunks of [`CHUNK`] particles, in their
//!   order, and shares begin at whole chunks. Only the sums of chunks are added across peers, and those without rounding.
//! - **Sums are exact** ([`Exact::add`]): a number of 2176 bits takes in each double whole; the one rounding is that of the total.
//! - **Rows are copied**, never added: each peer calculates what it needs of particles on its border itself.
//!
//! One process goes the same way, as [`Alone`]: with it a model has one code and one set of bits.
//!
//! # A march by peers
//!
//! A chain of masses and springs, each peer a piece of it. Forces are calculated on both sides of a border, places are sent in each step,
//! energy is added once:
//!
//! ```
//! use peers::{Alone, CHUNK, Cut, Exact, Peers, agree, together};
//!
//! let masses = 3 * CHUNK + 100;
//! let march = |mut peers: Box<dyn Peers>| {
//!     let (mut x, mut v) = (vec![0.0; masses], vec![0.0; masses]);
//!     v[0] = 1.0;
//!     let cut = Cut::even(masses, peers.count());
//!     let own = cut.own(peers.rank());
//!     let needs: Vec<u32> = own.clone().flat_map(|a| [a.max(1) - 1, (a + 1).min(masses - 1)]).map(|a| a as u32).collect();
//!     let lists = agree(&mut *peers, &cut, &needs);
//!     let lane = peers.open(&lists, 1);
//!     let mut kinetic = [Exact::new()];
//!     for _ in 0..10 {
//!         peers.send(&lane, &|a, row| row[0] = x[a as usize]);
//!         peers.take(&lane, &mut |a, row| x[a as usize] = row[0]);
//!         for a in own.clone() {
//!             let stretch = |a: usize| if a + 1 < masses { x[a + 1] - x[a] } else { 0.0 };
//!             v[a] += 0.3 * (stretch(a) - if a > 0 { stretch(a - 1) } else { 0.0 });
//!         }
//!         own.clone().for_each(|a| x[a] += v[a]);
//!         kinetic[0].clear();
//!         kinetic[0].add_in_chunks(own.clone().map(|a| 0.5 * v[a] * v[a]));
//!         peers.add(&mut kinetic, &mut []);
//!     }
//!     kinetic[0].value().to_bits()
//! };
//! let alone = march(Box::new(Alone));
//! for count in 1..=5 {
//!     assert_eq!(together(count, march)?, vec![alone; count]);
//! }
//! # Ok::<(), peers::Failure>(())
//! ```
//!
//! # What holds, and the test that says so
//!
//! | invariant | test |
//! |---|---|
//! | a sum is the double nearest to the exact one, in any order and any split | `tests/exact.rs` |
//! | carries are passed on before a digit overflows | `carries_are_passed_on_before_a_digit_overflows` |
//! | sums, maxima and rows are the same on 1 to 7 peers | `tests/together.rs` |
//! | what is recorded and what decides is that of one | `what_is_found_over_all_is_what_one_finds` |
//! | who fails, panics or leaves ends all with one message; nobody hangs | `tests/endings.rs` |
//! | a step of peers allocates nothing | `tests/allocations.rs` |
//! | each ghost gets the row of its step, other rows stay | `lists_agreed_on_are_those_planned_and_lanes_carry_every_row` |
//! | the curve walks from cell to neighbouring cell | `the_curve_walks_from_cell_to_neighbouring_cell` |
//! | shares are whole chunks and even to a chunk; how many ghosts and partners they have | `shares_are_even_to_a_chunk`, `tests/shares.rs` |
//!
//! # What it costs
//!
//! `cargo bench -p peers`: a number added exactly takes 3.5 times as long as one added plainly, one added in chunks no longer; taking the
//! value a hundred times as long, once for each sum.
//!
//! `cargo run -p peers --example shares` counts what lattices exchange, cut into equal shares of whole chunks. By ghosts over own particles,
//! and partners of a peer:
//!
//! | lattice | peers | in rows | along the curve |
//! |---|---|---|---|
//! | sheet of 1000 × 1000, cells | 64 | .126, 2.0 | .031, 5.3 |
//! | the same, cells swept in packs of four | 64 | .126, 2.0 | .049, 5.3 |
//! | block of 64³, horizon of three spacings | 8 | .656, 1.8 | .293, 7.0 |
//! | the same | 64 | 5.81, 5.8 | .955, 14.6 |
#![warn(missing_docs)]

mod curve;
mod cut;
mod exact;
mod greatest;
mod halo;
mod lists;
mod over_all;
mod peers;
mod threads;

pub use curve::along_curve;
pub use cut::Cut;
pub use exact::Exact;
pub use greatest::Greatest;
pub use halo::{agree, plan};
pub use lists::{Lists, Partner};
pub use peers::{Alone, Lane, Peers};
pub use threads::{Failure, together};

/// Particles that are added plainly, in their order; their sum goes on as one number. Shares of a model begin at whole chunks.
///
/// The same as the chunk of loops (`parallel::CHUNK`), which crates that use both hold together.
pub const CHUNK: usize = 512;
