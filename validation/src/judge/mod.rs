//! The judge: what a case is, how its runs are carried out, what is said of them.

mod asked;
mod case;
mod commit;
mod film;
mod lattices;
pub mod measure;
mod measured;
mod metric;
mod outcome;
mod peers;
mod pictured;
mod record;
mod run;
mod variant;

pub use asked::silent;
pub use case::{Case, Headline, Published, Recorded};
pub use lattices::Lattices;
pub use measured::Measured;
pub use metric::{Found, Metric, Verdict};
pub use outcome::{Outcome, Solver};
pub use peers::{Peer, Peers};
pub use pictured::Pictured;
pub use record::{Record, Table};
pub use run::{CaseResult, Selection, exit_code, judge};
pub(crate) use run::{choose, metrics};
pub use variant::{Effort, LOST, MET, Problem, Run, Runs, Study, Variant};
