//! The body in time: its march, and the spectrum that its stable step comes from.

mod kick;
mod march;
