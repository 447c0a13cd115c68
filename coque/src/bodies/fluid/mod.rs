//! Fluids and their walls: from the scene's words to `fluid-sph`.
//!
//! | where is | look in |
//! |---|---|
//! | particles at the start; rows of walls | `places.rs`; `walls.rs` |
//! | liquid, method, motion of walls | `parts.rs` |
//! | sets of particles, of places of walls | `sets.rs` |
//! | fields; figures and warnings; how late fronts come; fluid that left its basin | `fields.rs`; `figures.rs`; `late.rs`; `escaped.rs` |
//! | descriptions | `describe.rs` |

pub(in crate::bodies) mod describe;
pub(in crate::bodies) mod escaped;
pub(in crate::bodies) mod fields;
pub(in crate::bodies) mod figures;
mod late;
pub(in crate::bodies) mod parts;
pub(in crate::bodies) mod places;
pub(in crate::bodies) mod sets;
pub(in crate::bodies) mod walls;
