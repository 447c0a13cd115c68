//! Files of surfaces and of fields: meshes in, frames out and back, each file whole or not at all.
//!
//! The crate knows shapes and names of arrays, no scene, no model, and no meaning of a number. A mesh goes from text to
//! what stands in it, then to a sound [`surface::Surface`]; no reader trusts a count in a file: what it allocates is
//! bounded by the length of the text. Fields go through one trait, [`FieldWriter`], into a file ([`Vtu`]) or into
//! memory ([`Sheet`]); files of frames are read back into the same [`Sheet`].
//!
//! ```
//! use mesh_io::{At, Connectivity, FieldWriter, Kind, Sheet, Values, Vtu, rows};
//!
//! fn write(to: &mut dyn FieldWriter) -> std::io::Result<()> {
//!     let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
//!     let cell = |_| (Kind::Triangle, [0, 1, 2, 0, 0, 0, 0, 0]);
//!     to.geometry(&rows(3, |a| points[a]), Connectivity { count: 1, cell: &cell })?;
//!     to.numbers(At::Cells, "pressure", "Pa", &[], Values::Double(&rows(1, |_| [1e5])))
//! }
//!
//! let mut sheet = Sheet::default();
//! write(&mut sheet)?;
//! assert_eq!(sheet.cell_data["pressure"].numbers, [1e5]);
//! let mut file = Vtu::begin(Vec::new())?;
//! write(&mut file)?;
//! assert!(String::from_utf8_lossy(&file.end()?).contains("unit=\"Pa\""));
//! # Ok::<(), std::io::Error>(())
//! ```
//!
//! | where is | look in |
//! |---|---|
//! | a format of meshes, and which gives what | `surface/formats.rs`; one file a format in `surface/formats/` |
//! | what a reader hands on | `surface/raw.rs` |
//! | what makes a surface sound: directions, edges, numbers | `surface/orient.rs`, `boundary.rs`, `order.rs` |
//! | the cloud of a surface, and what the cloud refuses | `surface.rs`, `surface/refusal.rs` |
//! | what is reported of a file | `surface/report.rs`, `quality.rs` |
//! | what fields are written through | `writer.rs` |
//! | a frame in memory | `sheet.rs` |
//! | the VTU format: written, read, its XML | `vtu/write.rs`, `vtu/read.rs`, `vtu/xml.rs` |
//! | frames in a folder, the list of them | `series.rs` |
//! | files that exist whole or not at all | `whole.rs` |
//! | files that are read, of a bounded size | `input.rs` |
//!
//! | from | sets | normals | faces |
//! |---|---|---|---|
//! | Gmsh 2.2, 4.1 ASCII | physical groups | a view called "normals" | triangles, quadrangles |
//! | Abaqus `.inp`, with homogeneous `*Shell Section` and `*Material` | `*Nset`, `*Elset` | direction cosines after the coordinates | S3, S3R, STRI3, S4, S4R |
//! | STL, ASCII or binary | solids, if there are several | – | triangles |
//! | OBJ | groups, objects | `vn` | triangles, quadrangles |
//! | PLY, ASCII or binary | – | `nx`, `ny`, `nz` | triangles, quadrangles |
//! | VTU, ASCII or inline base64 | point data of 0 and 1 | point data "Normals" | triangles, quadrangles |
//! | points in CSV | – | columns | none: areas are columns |
//!
//! # What holds, and the test that says so
//!
//! | invariant | test |
//! |---|---|
//! | every format gives the same plate | `every_format_gives_the_same_plate` (tests/formats.rs) |
//! | groups of a file are sets | `groups_of_the_file_are_sets` (tests/formats.rs) |
//! | groups of faces stay groups of cells; sections of a file | `groups_of_faces_stay_groups_of_cells`, `sections_of_abaqus_files_are_read` (tests/sections.rs) |
//! | tetrahedra of a body are bounded by their outer faces | `tetrahedra_are_bounded_by_their_outer_faces` (tests/bodies.rs) |
//! | faces agree in direction, one-sided sheets are refused | `faces_are_turned_to_agree` and its neighbours (tests/sheets.rs) |
//! | a refusal names file, line, entity and repair | `broken_files` (tests/refusals.rs), tests/cells.rs |
//! | no damaged mesh panics or takes without end | `damaged_meshes_never_panic`, `any_bytes_never_panic` (tests/no_panic.rs) |
//! | no short file asks for much | `short_lines_cannot_ask_for_long_sets`, `crowds_and_needles_are_answered_soon` (tests/formats.rs) |
//! | counts that contradict their data are refused | `counts_that_contradict_their_data_are_refused` (tests/refusals.rs) |
//! | arrays of any length come back to the last bit | `arrays_of_every_length_come_back` (src/vtu/write.rs) |
//! | a file reads as what memory was given | `a_file_reads_as_what_memory_was_given` (src/sheet.rs) |
//! | a damaged frame is refused or sound | `damaged_frames_are_refused_or_sound` (src/sheet.rs) |
//! | a write that fails leaves the old file; no link is followed | `a_write_that_fails_leaves_the_old_file`, `links_are_not_followed` (src/whole.rs) |

mod atomic_file;
mod input;
mod series;
mod sheet;
pub mod surface;
mod vtu;
mod writer;

pub use atomic_file::{Whole, under_way, write_whole};
pub use input::{read_bytes, read_text};
pub use series::{FieldError, Series, listed};
pub use sheet::{Array, ReadError, Sheet};
pub use vtu::write::Vtu;
pub use writer::{At, Connectivity, FieldWriter, Kind, Rows, Values, rows};
