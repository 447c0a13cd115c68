//! Tables over the results of all cases: what is printed, and what the report begins with.

mod list;
mod overview;
mod survival;
mod text;
mod trust;

pub use list::list;
pub use overview::{Answer, answers, overview, side_by_side, unit_of_answers};
pub use survival::survival;
pub use text::{counts, numbers, table, unit, words};
pub use trust::{Trust, trust};
