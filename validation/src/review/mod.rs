//! Review of results that are not as they were: the values that were reviewed, those of now and the reference side by side.

mod change;
mod curves;
mod page;
mod reviewed;

pub use change::Change;
pub use page::page;
pub use reviewed::Reviewed;
