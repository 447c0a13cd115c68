//! The hard cases: every known way to break a shell or a particle method, with the defaults everywhere.
//!
//! A case that fails stays in the table, asserted as it is, with the cause.

mod bodies;
mod common;
mod disorder;
mod large;
mod loads;
mod misses;
mod sheets;
mod thickness;

use crate::Case;

/// Every hard case, in the order of the survival table.
#[rustfmt::skip] // one line a case
pub fn all() -> Vec<Case> {
    vec![
        disorder::case(),
        thickness::case(),
        large::case(),
        loads::case(),
        bodies::case(),
    ]
}
