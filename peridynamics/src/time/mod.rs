//! The body in time: its march, and the spectrum that its stable step comes from.

mod boundary;
mod kick;
mod march;
mod spectrum;
