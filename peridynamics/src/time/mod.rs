//! The body in time: its march, and the spectrum that its stable step comes from.

mod joined;
mod kick;
mod march;
