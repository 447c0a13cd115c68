//! Rows of particles that are walls of a fluid.

mod basin;
mod cover;
mod offsets;
mod oriented;
mod polyline_rows;
mod stretch;
mod surface_rows;
mod wall_rows;

pub use basin::{basin_rows, block_rows};
pub use polyline_rows::{LineSide, polyline_first_row, polyline_rows};
pub use surface_rows::{surface_first_row, surface_rows};
pub use wall_rows::leaks;
