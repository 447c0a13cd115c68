//! What is shown of a run: fields, pages, pictures, the guide.

#![allow(clippy::unwrap_used)] // a failed test may stop here

#[path = "../common/browser.rs"]
mod browser;
#[path = "../common/mod.rs"]
mod common;

mod fields;
mod fields_whole;
mod frames;
mod guide;
mod meshio;
mod view;
