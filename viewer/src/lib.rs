//! The frames of a run as one page for a browser: no server, no library, nothing fetched.
//!
//! The crate knows shapes and names of arrays, no scene, no model, and no meaning of a number. Frames go in as
//! [`mesh_io::Sheet`]s, one after the other, into the [`Body`] that they show; [`Show`] is all bodies with what is said
//! beside them, and [`page()`] makes the text.
//!
//! Numbers stand in the page as shares of their range over all frames, in 16 bits: the error is at most the range over
//! 131068, beside the rounding to single precision. From the second frame on the difference to the frame before is
//! kept, low bytes first, then high ones, deflated and written in base64; the browser inflates them.
//!
//! ```
//! use mesh_io::{Sheet, Array};
//! use viewer::{Body, Instant, Show, page};
//!
//! let moved = |by: f64| Sheet {
//!     points: vec![[by, 0.0, 0.0], [1.0 + by, 0.0, 0.0], [by, 1.0, 0.0]],
//!     cells: vec![vec![0, 1, 2]],
//!     ..Sheet::default()
//! };
//! let mut body = Body::new("plate", &moved(0.0));
//! body.add(&moved(0.0))?;
//! body.add(&moved(0.5))?;
//! let instant = |along: f64| Instant { along, label: format!("time {along}"), row: None };
//! let show = Show { title: "A plate".into(), frames: vec![instant(0.0), instant(1.0)], bodies: vec![body], ..Show::default() };
//! assert!(page(show, 30_000_000, 1)?.html.starts_with("<!DOCTYPE html>"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | where is | look in |
//! |---|---|
//! | what a page is made of | `show.rs` |
//! | a body over its frames; fields of cells at points | `body.rs` |
//! | faces that can be seen, and their border | `faces.rs` |
//! | numbers to 16 bits, differences, deflate, base64 | `pack.rs`; ranges and percentiles: `track.rs` |
//! | what goes when a page would be too large | `budget.rs` |
//! | data beside the numbers; the page put together, nothing in it escapes | `head.rs`, `page.rs` |
//! | what the browser runs | `page/`: one file an idea, joined in the order of `page.rs` |

mod body;
mod budget;
mod faces;
mod head;
mod pack;
mod page;
mod show;
mod track;

pub use body::{Body, OtherShape};
pub use page::{EncodeError, Written, page};
pub use show::{Column, Instant, Show};
