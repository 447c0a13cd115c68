//! From a scene file to results: reads and checks scenes, builds shells, runs them, writes curves.
//!
//! Data flow one way: [`Scene`] (plain, validated) → [`Model`] (a shell ready to move) → [`Outcome`]
//! (curve, summary, shapes). The command `coque` is a thin wrapper round these three.
//!
//! | where is | look in |
//! |---|---|
//! | what a scene may say | `scene/*.rs` |
//! | what is refused, and why | `scene/check*.rs`, `rigid.rs` |
//! | scene → shell | `build.rs`, `places.rs`, `matter.rs` |
//! | files of surfaces | `mesh/*.rs`; into a scene: `imported.rs` |
//! | the run and what it records | `run.rs`, `probe.rs` |
//! | in time, without time, linear, as modes | `march.rs`, `path.rs`, `linear.rs`, `modes.rs` |
//! | results on disk | `curve.rs`, `summary.rs`, `plot.rs`, `fields.rs` |
//! | a deformed shape as a picture | `picture.rs` |
//! | what a run goes on from | `checkpoint.rs` |
//! | what a scene may name, its schema, what a run will cost | `catalogue.rs`, `schema.rs`, `estimate.rs` |

mod build;
mod catalogue;
mod checkpoint;
mod curve;
mod error;
mod estimate;
mod fields;
mod imported;
mod linear;
mod march;
mod matter;
pub mod mesh;
mod modes;
mod nearest;
mod overrides;
mod path;
mod picture;
mod places;
mod plot;
mod probe;
mod render;
mod rigid;
mod run;
pub mod scene;
mod schema;
mod sets;
mod source;
mod summary;
mod units;

pub use build::Model;
pub use catalogue::{Shelf, catalogue};
pub use checkpoint::{CHECKPOINT, Checkpoint, CheckpointError, Checkpoints, Origin, SCENE_COPY};
pub use curve::{Column, Curve, NotACurve};
pub use error::{Fault, Place, SceneError};
pub use estimate::Estimate;
pub use fields::{
    Array, FieldError, FieldFiles, FieldSink, Frame, LinearForces, ReadError, Sheet, State, listed,
};
pub use picture::{FieldNotThere, Picture, picture_svg};
pub use plot::{PlotError, plot_svg};
pub use render::{Rendering, render};
pub use run::{Ended, Failure, News, Outcome, Progress, RunOptions, Shape, Silent};
pub use scene::Scene;
pub use schema::{schema, schema_text};
pub use source::Source;
pub use summary::{CriticalSummary, Energies, LevelSummary, Modelled, Summary};
pub use units::{Force, Length, Quantity, Time, Units};
