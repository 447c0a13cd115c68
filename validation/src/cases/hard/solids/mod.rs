//! Hard cases of peridynamic solids: horizons, Poisson's ratios and nodes out of order, threads and turns, loose pieces.

pub mod pieces;
pub mod same_damage;
pub mod tension;
