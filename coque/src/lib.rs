//! From a scene file to results: reads and checks scenes, builds bodies, runs them, writes curves.
//!
//! Data flow one way: [`Scene`] (plain, validated) → [`Model`] (a body ready to move) → [`Outcome`] (curve, summary,
//! shapes). The command `coque` is a thin wrapper round these three. [`Simulation`] leads a model event by event.
//!
//! ```
//! use coque::{Scene, Silent};
//!
//! let text = r#"
//! title = "Cantilever, linear"
//! units = { length = "m", force = "N", time = "s" }
//! geometry.plate = { lengths = [10.0, 1.0], particles = [21, 3] }
//! material.elastic = { young = 1.2e6, poisson = 0.0, density = 1.0 }
//! section.homogeneous = { thickness = 0.1 }
//! supports = [{ on = "u0", clamped = {} }]
//! loads = [{ on = "u1", force = { total = [0.0, 0.0, 1.0] } }]
//! analysis.linear = {}
//! curve = [{ name = "w_tip", of = "displacement", on = "u1", direction = [0.0, 0.0, 1.0] }]
//! "#;
//! let outcome = Scene::parse(text, "cantilever.toml")?.build(1)?.run(&mut Silent);
//! let tip = outcome.curve.column("w_tip").ok_or("no such column")?[0];
//! let beam = 1.0 * 1000.0 / (3.0 * 100.0); // PL³/3EI
//! assert!((tip / beam - 1.0).abs() < 5e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | where is | look in |
//! |---|---|
//! | what a scene may say, its two forms | [`scene`], `scene/problem.rs`, `scene/forms.rs` |
//! | numbers with a bound, refused as they are read | `scene/bounded.rs` |
//! | what is refused, and why; what alone is built | `scene/check/`; [`Checked`], `scene/checked.rs` |
//! | the lists, the schema, the page of all keys | `scene/catalogue.rs`, `scene/schema.rs`, `scene/reference.rs` |
//! | what any body offers, columns of the curve | [`Body`], `bodies/body.rs`; `bodies/probe.rs` |
//! | which kind of body is built | `bodies/build.rs` |
//! | scene → shell; scene → solid; scene → fluid and walls | `bodies/shell/build.rs`, `bodies/solid/build.rs`, `bodies/fluid/` and their neighbours |
//! | a fluid with the structures in it: each in its scene; one body of all | `scene/body_in_scene.rs`; `bodies/coupled/` |
//! | files of surfaces | [`mesh`], that is `mesh-io`; into a scene: `bodies/shell/imported.rs` |
//! | fields of a body; which frames, and where they go | `bodies/shell/fields.rs`, `bodies/solid/fields.rs`; `fields/` |
//! | the run, its figures, what it goes on from | `run/active_run.rs`, `run/record.rs`, `run/checkpoint/` |
//! | in time, without time, linear, as modes, what it will cost | `analyses/`, one file each |
//! | led event by event | [`Simulation`], `analyses/simulation.rs`; how far an analysis has come: `analyses/course.rs` |
//! | which lattice reaches an accuracy; the error of every number | [`accuracy`]; [`Checked::errors`] |
//! | what is known to make a number wrong | `bodies/shell/warnings/`, `bodies/solid/warnings.rs`; the words: `warning.rs` |
//! | what the folder of a run shows, for pages and pictures | `shown/`; [`page_of`], of one in memory [`RunPage`] |
//! | the words of the command line | `commands/`; [`command_line`] |
//! | the curve, plots, a deformed shape as a picture | `results/` |
//!
//! # From words to the mechanics
//!
//! The crate adds no mechanics: it chooses among that of the layers below.
//!
//! | a scene says | and gets |
//! |---|---|
//! | `geometry` | a cloud of `sph-core`, or a mesh by [`mesh::Surface::cloud`] |
//! | `material`, `section` | a section of `shell-kinematics`; of `layered` the plies with a material axis, of `stiffness` its matrices |
//! | `parts` | regions of `sph-shell`: cells with a section and height of their own |
//! | `formulation` | the formulation in `sph-shell`, with the strain measure |
//! | `supports`, `loads` | supports and loads of `sph-shell` on named sets of particles |
//! | `analysis` | see below |
//!
//! | `analysis.` | solves | by |
//! |---|---|---|
//! | `explicit.quasi-static` | equilibria along load levels, by damped marching of true masses | `explicit_dynamics::QuasiStatic` |
//! | `explicit.transient` | `M q̈ + cM q̇ + ∂U/∂q = f(t)` | `explicit_dynamics::Transient` |
//! | `linear` | `K u = p` at the unloaded shell | `implicit_statics::linear_response` |
//! | `static` | `∂U/∂q = λ p` at given levels λ | `implicit_statics::follow`, load control; displacement control for the motion of one particle |
//! | `arc-length` | the same along a path past limit and turning points | `implicit_statics::follow`, arc length |
//! | `relaxation` | the same at given levels, by a fictitious motion | `implicit_statics::Relaxation` |
//! | `modal` | `K φ = ω² M φ` | `implicit_statics::natural_modes` |
//! | `buckling` | `(K + μ K_g) φ = 0` | `implicit_statics::linear_buckling` |
//!
//! `buckling` linearises about the unloaded shell. K_g = dK/dλ is taken along the whole linear response, its rotations and
//! stretches as well as its stresses (`prebuckling = "rotations"`, the default), or along its stresses alone in the undeformed
//! shape (`"stress"`, what most finite-element programs have). The two agree for plates and columns loaded in their plane. Where edges bend
//! before buckling, as on a clamped cap, they differ, and the limit of the nonlinear path is another number still: follow
//! the path by `arc-length`. Modes are counted by inertia, none is missing; `residual` bounds the relative distance to an exact one.
//!
//! Prescribed motions stand where the level puts them. Where the motion of one particle alone drives a linear, static,
//! arc-length or buckling analysis, the force along it is sought instead; it is the level of the last two.
//!
//! # What a column means
//!
//! Over the particles of a set, a the particle, e the unit direction ([`scene::Measured`]):
//!
//! ```text
//! displacement    mean of u_a·e           reaction   sum of (∂U/∂x_a − f_a)·e, f_a the loads
//! position        mean of x_a·e           rotation   mean of the angle by which d_a has turned about e, counted on beyond π
//! director        mean of d_a·e           velocity   mean of ẋ_a·e
//! damage          mean of φ_a             fracture-energy   sum of what the broken bonds of a held
//! strain-energy   mean of W_a             all times the column's factor; `take` has another than mean or sum
//! pressure        mean of p_a; on walls the mean of the fluid before the place, carried there by gravity, zero where dry
//! density         mean of ρ_a             level      mean height of the surface over places of walls
//! force           sum of a fluid's forces on walls or a structure, moment likewise; by depth in a plane
//! reaction-moment sum of (x_a − p) × reaction_a + d_a × what supports exert on the director, along e
//! ```
//!
//! Over the cells of a set, from strains and section forces at their middle, e in the surface at rest:
//!
//! ```text
//! membrane-force, bending-moment   mean of e·N·e, e·M·e         shear-force   mean of Q·e
//! stress                           mean of e·σ·e at a face      von-mises     largest at both faces, or at one
//! max-, min-principal, tresca      largest, least, largest      principal-angle   mean of the angle from e to the axis of the greatest
//! ply-stress                       mean of σ₁, σ₂ or τ          reserve-factor, failure-index   least, largest over the plies and the set
//! energy                           sum of ½ w (N:e_m + M:κ + Q·γ)
//! ```
//!
//! Through a plane with the point p and the normal n, over the particles of a set beyond it at rest, (X_a − p)·n > 0:
//!
//! ```text
//! section-force   sum of ∂U/∂x_a·e        section-moment   sum of (x_a − q) × ∂U/∂x_a + d_a × ∂U/∂d_a, along e, about q
//! ```
//!
//! A linear answer has no state: a column v is differentiated along the motion, by central differences over ε and 2ε,
//!
//! ```text
//! v(0) + (4 s(ε) − s(2ε))/3,     s(ε) = (v(ε) − v(−ε))/2ε,     ε of a hundredth of a thickness
//! ```
//!
//! Stresses at the faces of a homogeneous section at the height e are `σ = N/t ± 6(M − eN)/t²`; von Mises is
//! `√(σ11² + σ22² − σ11σ22 + 3σ12²)`, plane stress.
//!
//! # Surfaces from files
//!
//! Every reader takes text to what stands in it and allocates no more than the text is long; [`mesh::Surface`] then
//! makes it sound: faces turned the same way, edges of three faces, one-sided sheets and hanging nodes refused with
//! file and line. Without normals in the file they are means over the faces by area, turned into the symmetry planes of
//! the scene. Triangles are joined in pairs. Nodes are numbered anew along the surface \[cuthill1969\] where their own
//! order would cost much. A force on a set along the boundary is shared by tributary length, else in equal parts.
//!
//! # What holds, and the test that says so
//!
//! | invariant | test |
//! |---|---|
//! | exact answers: uniform strain of the patch test, the closed ring | `patch_test_strains_uniformly`, `the_ring_closes` (tests/run.rs), `the_ring_closes_without_time` (tests/statics.rs) |
//! | a body that no scene knows goes through every analysis, checkpoints, fields and the estimate | tests/own_body.rs |
//! | a turned scene answers the same; threads change no bit | `a_turned_scene_answers_the_same`, `threads_change_no_bit` |
//! | with and without time the same equilibria | `time_changes_no_equilibrium` (tests/statics.rs) |
//! | a linear answer is the limit of small loads, and linear | `a_linear_answer_is_the_limit_of_small_loads`, `a_factor_on_the_load_is_one_on_the_answer` (tests/linear.rs) |
//! | every kind of load in one scene: the energy balances | `a_scene_with_everything_keeps_its_energy_balance` |
//! | plates of any thickness do not lock, on lattices and in disorder | `plates_of_any_thickness_bend`, `clamped_plates_of_any_thickness_keep_their_deflection_on_any_cloud` (tests/scattered.rs) |
//! | every format gives the same plate; the same particles the same limit load | `every_format_gives_the_same_plate` (mesh-io/tests/formats.rs), `the_same_particles_give_the_same_limit_load` (tests/mesh_panel.rs) |
//! | what settles is right to 1 %, for any damping and any period, or says that it did not settle | `what_settles_is_right_whatever_the_damping_and_the_period` (tests/at_rest.rs) |
//! | a state of rest that is not stable is warned of; the look changes no bit | `a_perfect_column_above_its_critical_load_is_warned_of`, `a_look_at_stability_changes_no_bit_and_what_was_not_looked_at_is_said` |
//! | no damaged scene or mesh panics | `damaged_scenes_never_panic` (tests/no_panic.rs), `damaged_meshes_never_panic` (mesh-io/tests/no_panic.rs) |
//! | what is refused is refused in these words | `broken_scenes` and its neighbours (tests/refusals.rs) |
//! | a run killed at any moment and resumed ends in the same bytes | `killed_at_any_moment_it_ends_in_the_same_bytes` (tests/interrupted.rs), `every_formulation_goes_on_to_the_same_bits` (tests/resume.rs) |
//! | a run that is led event by event, read and put back in between has the bits of one that is not | `every_analysis_is_led_to_its_end_with_the_same_bits`, `what_is_read_and_put_back_changes_no_bit` (tests/steps.rs) |
//! | frames are whole, and other readers read them | `a_killed_program_leaves_whole_frames_and_a_list_of_them` (tests/fields.rs), `meshio_reads_what_the_run_wrote` (tests/meshio.rs) |
//! | solids: a bar stretched as Hooke says, a plate that breaks, the same bits for any number of threads | tests/solid.rs |
//! | what is refused of solids, and warned of | tests/solid_refusals.rs, tests/solid_warnings.rs |
//! | a run of a breaking solid goes on to the same bits | `a_breaking_solid_goes_on_to_the_same_bits` (tests/resume.rs) |
//! | every rule of the table of warnings fires on a scene made to break it; scenes of the repository raise none | `each_rule_fires_on_a_scene_that_breaks_it`, `scenes_of_the_repository_raise_no_warning` (tests/warnings.rs) |
//! | a fluid: still water presses as it is deep, the energy of a dam break balances, threads change no bit | tests/fluid.rs |
//! | a fluid with a shell or a solid in it goes on to the same bits | `a_fluid_and_what_is_in_it_go_on_to_the_same_bits` (tests/resume.rs) |
//! | what is refused of fluids, walls and what is in them | tests/fluid_refusals.rs |
//! | bars hold the true error, the run is not touched, what has no bar is said | tests/errors.rs |
//! | results outlive terminal, disk and a second run in their folder | tests/kept.rs |
//! | what no run can be made of costs nothing: pipes, devices, too little memory, nothing free | tests/inputs.rs |
//! | loads on cells, parts and sections of files as closed forms have them; columns of strains are those of a beam | tests/parts.rs |
//! | surface stresses integrate to the resultants | `faces_integrate_back_to_the_resultants` (src/bodies/sampled.rs) |

pub mod accuracy;
mod analyses;
mod bodies;
mod commands;
mod fields;
mod kept;
pub mod mesh;
mod plain;
mod ranks;
mod results;
mod run;
pub mod scene;
mod shown;
mod warning;

pub use analyses::{Estimate, Event, RunOptions, Simulation};
pub use bodies::shell::warnings::warnings;
pub use bodies::{
    Body, Configuration, Description, Diagnostics, DynamicBody, FieldRequest, FieldSource, FluidFigures,
    LoadResultants, Memory, Mismatch, Model, NoPush, NotShared, OneProcess, Outline, Part, PrescribedPoint,
    Probe, Ready, Resultant, Shape, Spanned, State, StateArray, StaticBody, StressFields, Surrounding,
    TangentCost, Task,
};
pub use commands::{Launched, ProcessGroup, command_line, command_line_in, launched};
pub use explicit_dynamics::Exert;
pub use fields::{Extreme, FieldEnvelope, FieldFiles, FieldSink, Frame, FrameFields, SETS, Written};
pub use kept::Kept;
pub use mesh_io::{
    Array, At, Connectivity, FieldError, FieldWriter, Kind, ReadError, Rows, Sheet, Values, Whole, listed,
    read_text, rows, write_whole,
};
pub use plain::plain_text;
pub use ranks::Ranks;
pub use results::chart::{Costs, costs_svg};
pub use results::curve::{Column, Curve, NotACurve};
pub use results::error_bars::{
    ColumnErrors, CriticalError, ErrorBar, Errors, LatticeRun, Probed, ProbedColumn, Verdict,
};
pub use results::growing::GrowingCurve;
pub use results::picture::{
    FieldNotThere, Picture, PictureExtent, picture_extent, picture_svg, strip, together, usual_field,
};
pub use results::plot::{PlotError, plot_svg};
pub use run::cases_summary::{CaseSummary, CasesSummary, Envelope};
pub use run::checkpoint::{
    CHECKPOINT, CHECKPOINT_ROWS, Checkpoint, CheckpointError, Checkpoints, Origin, SCENE_COPY,
};
pub use run::folder::ResultFolder;
pub use run::outcome::{Ended, Failure, Outcome};
pub use run::over_time::OverTime;
pub use run::progress::{Progress, ProgressReport, Silent};
pub use run::record::{BalanceSummary, CountSummary, CriticalSummary, Energies, LevelSummary, RunRecord};
pub use run::summary::Summary;
pub use run::vibration_summary::{
    BaseSummary, CasePeak, ExcitedMode, NoiseSummary, SwingingCase, SwingingMode, VibrationSummary,
};
pub use scene::catalogue::{CatalogueEntry, catalogue};
pub use scene::error::{Fault, Place, SceneError};
pub use scene::reference::reference_page;
pub use scene::render::{Rendering, render};
pub use scene::schema::{schema, schema_text};
pub use scene::source::Source;
pub use scene::units::{Force, Length, Quantity, Time, Units};
pub use scene::{Checked, Scene};
pub use shown::frames::page_of;
pub use shown::page::RunPage;
pub use warning::{Warning, WarningKind};
