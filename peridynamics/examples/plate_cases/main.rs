//! A thin plate of two peridynamic sheets, stretched, shortened until it buckles and beyond:
//!
//! ```text
//! cargo run --release -p peridynamics --example plate_cases
//! cargo run --release -p peridynamics --example plate_cases -- linear 10 5
//! ```
//!
//! The plate is 300 × 200 × 2 mm, E = 69 kN/mm², ν = 0.33. Its ends x = 0 and x = 300 are drawn apart or together by 1.2 mm;
//! each table has the figures of plate theory beside its own.

mod cracked;
mod linear;
mod path;
mod plate;
mod tear;

use implicit_statics::EquilibriumError;

fn main() -> Result<(), EquilibriumError> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let wanted = |name: &str| words.first().is_none_or(|word| word == name);
    let mut spacings: Vec<f64> = words.iter().skip(1).filter_map(|word| word.parse().ok()).collect();
    if spacings.is_empty() {
        spacings = vec![10.0, 5.0];
    }
    if wanted("linear") {
        linear::table(&spacings)?;
    }
    if wanted("path") {
        for &spacing in &spacings {
            path::table(spacing)?;
        }
    }
    if wanted("relax") {
        path::relaxation(spacings[0])?;
    }
    if wanted("cracked") {
        cracked::table(&spacings)?;
    }
    if wanted("tear") {
        tear::run(spacings[0])?;
    }
    Ok(())
}
