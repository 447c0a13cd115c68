//! The report: one page that shows every case.

mod cost;
mod html;

pub use html::html;
