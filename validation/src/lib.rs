//! The judge: runs scenes, holds their results against references, and says which tolerance is missed.
//!
//! Data flow one way: [`Case`] (what to run, what to compare with) → [`Run`] (what came out) → [`Record`]
//! (metrics with verdicts) → table, JSON, report.
//!
//! | where is | look in |
//! |---|---|
//! | a benchmark: its runs, references, tolerances with their reasons | `cases/*.rs`, one file each |
//! | how runs share the cores | `run.rs` |
//! | what a run leaves behind, whoever solved it | `outcome.rs` |
//! | which run of a case is drawn, and how | `pictured.rs` |
//! | what a verdict is | `record.rs` |
//! | the table of the hard cases | `survival.rs` |
//! | explicit, static, finite elements and published side by side | `answers.rs` |
//! | interpolation, order of convergence, frontier | `measure.rs` |
//! | the printed table, the HTML report | `table.rs`, `report/*.rs` |

pub mod answers;
pub mod case;
pub mod cases;
pub mod measure;
pub mod outcome;
pub mod pictured;
pub mod record;
pub mod report;
pub mod run;
pub mod survival;
pub mod table;

mod error;

pub use case::{Case, Run, Runs, Variant};
pub use error::JudgeError;
pub use outcome::{Outcome, Solver};
pub use record::{Metric, Record};
pub use run::{CaseResult, Selection, judge};
