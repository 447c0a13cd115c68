//! Several systems whose equilibria are sought together, and what they do to each other.
//!
//! Unknowns stand one behind the other, system after system; the tangent has their tangents on its diagonal and what an
//! [`Interaction`] adds, `JᵀKJ`: K between places, J how places move with the unknowns ([`Joinable::motion_of`]). Its forces stand among the
//! external forces of the systems, which hand them to their unknowns as they do loads; where a place does not move linearly with the
//! unknowns the tangents of the systems have that already. It depends on places alone, which no level moves at fixed unknowns: an end at a
//! prescribed motion is refused by whoever builds one, or it says that it is led ([`Interaction::is_led`]).

mod acting;
mod beside;
mod interaction;
mod led;
mod stressed;
mod system;

pub use interaction::{Interaction, Joinable};
pub use system::Several;
