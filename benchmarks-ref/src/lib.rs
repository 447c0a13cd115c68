//! The truth that coque is judged by: published curves with their provenance, closed forms, an independent shell.
//!
//! Of the workspace it uses `implicit-statics` alone, and only `validation` may read it: a solver that could see the
//! answer would be no test of the method.
//!
//! - [`mod@catalogue`]: the table of references, each with citation, quantity, units, values and uncertainty;
//! - [`curve`]: what is done with a curve: interpolate, find a limit point, measure a distance;
//! - [`elastica`]: the inextensible cantilever bent by an end moment or an end load;
//! - [`impact`]: a mass that hits a wide plate or the end of a bar;
//! - [`pressed`]: a drum and a ball pressed on a block between planes of symmetry;
//! - [`rolled_strip`]: the same strip with a Green–Lagrange strain, which is *not* the elastica when it is thick;
//! - [`external_pressure`]: when rings and long cylinders buckle under pressure that follows them;
//! - [`vibration`]: the first natural frequency of a cantilever;
//! - [`kirsch`]: a plate with a circular hole under tension;
//! - [`waves`]: speeds of waves along a surface and along a bar;
//! - [`fluids`]: fronts and wall pressures of dam breaks, a box in one;
//! - [`fluid_structure`]: a gate, plates, a bar, a wedge, in experiments and published simulations;
//! - [`fluid_structure_forms`]: strips and rings, dry and in a fluid, in closed form;
//! - [`floating_box`]: a box that swings in the water of a tank, by linear potential flow;
//! - [`floating_cylinder`]: a cylinder that swings in deep water and in a tank, by Ursell's flow;
//! - [`box_in_waves`]: a box that floats in waves or is let go, by linear potential flow without ends;
//! - [`hinged_box`]: a box under water that swings about a hinge, by potential flow;
//! - [`wedge_entry`]: a wedge that enters water at constant speed, by similarity flow;
//! - [`wedge_on_spring`]: one on a spring, by momentum;
//! - [`fe_shell`]: an independent implicit finite-element shell;
//! - [`fe_solid`]: bricks of twenty nodes.
//!
//! ```
//! use benchmarks_ref::{elastica, reference, rolled_strip};
//!
//! // Half a circle: the tip stands over the clamp, 2/π of the length above it.
//! let tip = elastica::end_moment(std::f64::consts::PI);
//! assert!((tip.u - 1.0).abs() < 1e-15);
//! assert!((tip.w - 2.0 / std::f64::consts::PI).abs() < 1e-15);
//!
//! // The same moment on a strip of t/L = 1/10 whose strain is Green–Lagrange turns it farther.
//! let strip = rolled_strip::under_moment(std::f64::consts::PI, 0.1)?;
//! assert!(strip.theta > std::f64::consts::PI && strip.stretch < 1.0);
//!
//! // Published curves come with their source.
//! let panel = reference("sze_hinged_roof_t12p7_isotropic")?;
//! assert!(panel.citation.contains("Sze"));
//! # Ok::<(), benchmarks_ref::ReferenceError>(())
//! ```
//!
//! # Closed forms
//!
//! Lengths are parts of L, EI is the bending stiffness, θ the rotation of the end section.
//!
//! **End moment**, [`elastica::end_moment`] (\[simo1989\], and tabulated in \[sze2004\]): the strip is an arc,
//!
//! ```text
//! θ = ML/EI      u/L = 1 − sin θ/θ      w/L = (1 − cos θ)/θ
//! ```
//!
//! u is the shortening, w the deflection of the tip. **End load**, [`elastica::end_load`] \[mattiasson1981\]: with
//! `m = (1 + sin θ)/2`, `sin²φ₁ = 1/(2m)`, α = PL²/EI
//!
//! ```text
//! √α = K(m) − F(φ₁, m)      w/L = 1 − 2/√α [E(m) − E(φ₁, m)]      u/L = 1 − √(2 sin θ/α)
//! ```
//!
//! K, E, F the elliptic integrals, by Carlson's duplication \[carlson1995\].
//!
//! **Rolled strip**, [`rolled_strip`]: a shell whose strain is `½(λ² − 1) + ζλk`, stretch λ, turn k per reference
//! length, has the energy `½Et[½(λ² − 1)]² + ½(Et³/12)(λk)²` per width, and in equilibrium
//!
//! ```text
//! λ² = 1 − (kt)²/6      M/(EIk) = 1 − (kt)²/6      greatest M t/EI = 2√2/3, at kt = √2
//! ```
//!
//! This is the law of the Green–Lagrange split, 6.6 % below the elastica at t/L = 0.1 and a full turn: a formulation
//! that obeys it is right about its own strain and wrong about the ring.
//!
//! **Pressure from outside**, [`external_pressure`] \[timoshenko1961\]: a ring ovals at `3 EI/R³` where the pressure follows it, at
//! `4 EI/R³` where it keeps its direction; a cylinder between diaphragms by the formula of von Mises.
//!
//! **Cantilever**, [`vibration`]: `ω₁ = (β₁L)² √(EI/(ρA))/L²`, β₁L the first root of `cos β cosh β = −1`.
//!
//! The struck plate is that of \[kalthoff1988\]. Plates of the catalogue follow \[timoshenko1959\] and \[timoshenko1961\], the linear obstacle course
//! \[macneal1985\], large displacements \[sze2004\]. Each JSON file in `data/` says how its numbers were obtained, how
//! solid they are held to be, and against what that was checked ([`Reference`]).
//!
//! # The finite-element shell
//!
//! Four nodes with position and director, both bilinear, 2×2 Gauss points: the degenerated solid with resultants
//! \[hughes1981\]. Membrane strains are tied after \[ko2017\] and enhanced after \[simo1990\] and \[andelfinger1993\],
//! shears tied after \[dvorkin1984\]:
//!
//! ```text
//! membrane   E_αβ = ½(a_α·a_β − A_α·A_β), tied at edges and centre (MITC4+)
//!            relaxed by seven enhanced modes, eliminated once
//! bending    κ_ab = sym(k_ab − E_ac k_cb) − B_ab,  k_ab = a_a·d,_b, arcs for chords
//! shear      γ_α = a_α·d − A_α·D, tied at the middle of the edges (MITC4)
//! ```
//!
//! Sections are those of classical lamination with 5/6 of the shear stiffness ([`fe_shell::Section`]). It shares no
//! code with the particle shell and no choice of strain but that of curvature free of stretch, which it writes in
//! another way; both are solved by `implicit-statics`. Where particles and elements agree with each other and with what
//! is published, the reference is confirmed; where only one does, the report shows it.
//!
//! # Bricks
//!
//! [`fe_solid`]: twenty nodes, 3×3×3 Gauss points, Green's strain and St Venant's law from rest; no code and no choice shared with the
//! solids without elements or those of bonds.
//!
//! # What holds, and the test that says so
//!
//! | invariant | test |
//! |---|---|
//! | every entry names source, units, how obtained, how certain | `every_entry_is_complete` (tests/catalogue.rs) |
//! | tabulated rings are the elastica, to their printed digits | `the_seed_ring_is_the_elastica`, `the_sze_ring_is_the_elastica` |
//! | the elastica satisfies its differential equation, keeps its length | `end_load_satisfies_the_differential_equation`, `end_moment_keeps_the_length_and_closes_the_circle` (src/elastica.rs) |
//! | the rolled strip is in equilibrium, and without thickness the elastica | `equilibrium_is_the_derivative_of_the_energy`, `a_strip_without_thickness_is_the_elastica` (src/rolled_strip.rs) |
//! | long cylinders are rings in plane strain, short ones shallow shells | `an_endless_cylinder_is_a_ring_in_plane_strain`, `many_waves_are_those_of_shallow_shells` (src/external_pressure.rs) |
//! | elliptic integrals: published values, Legendre's relation | `published_values`, `legendre_relation` (src/elliptic.rs) |
//! | rings between plates are those of the table and of small deflections; strips on drums are in balance; collapsed rings touch once | `the_pressed_ring_is_that_of_the_table`, `a_ring_hardly_pressed_is_that_of_small_deflections`, `strips_are_in_balance_with_their_curvature_on_the_drum`, `rings_touch_once_and_bear_more_and_more` (src/touching.rs) |
//! | a struck bar parts when Saint-Venant says | `the_bar_parts_when_saint_venant_says`, `at_first_the_bar_is_endless` (src/impact.rs) |
//! | drums and balls on a block are Hertz's where the contact is small, and fit the face within it | `a_small_contact_is_that_of_hertz`, `the_face_fits_the_drum_within_the_contact` (src/pressed.rs) |
//! | rings and strips in fluids are those of the tables | `the_ring_meets_the_table_dry_and_wet`, `the_taut_strip_meets_the_converged_elements` (src/fluid_structure_forms.rs) |
//! | cantilevers that vibrate are those at rest, and those of Euler and Bernoulli; their end lags | `slow_loads_are_those_at_rest`, `slender_beams_are_those_of_euler_and_bernoulli`, `the_end_lags_behind_the_force` (src/shaken_beam.rs) |
//! | a plate with a bar along its middle buckles a little below what two terms of a series say | `two_terms_of_a_series_lie_a_little_above`, `a_plate_without_a_bar_is_that_of_bryan` (src/stiffened_plate.rs) |
//! | plates that shear are those of the tables where they are thin, and add the deflection of shear | `a_thin_plate_is_that_of_the_tables`, `shear_adds_its_own_deflection` (src/sheared_plate.rs) |
//! | a box on a hinge: added mass of a square, order of its corners | `on_a_long_arm_it_has_the_added_mass_of_a_square`, `it_converges_with_the_order_of_the_corner` (src/hinged_box.rs) |
//! | a wedge that enters water: its surface closes and no water is lost; Wagner's force of low ones | `the_surface_closes_and_no_water_is_lost`, `low_wedges_go_to_wagners_force_and_half_of_it_as_added_mass`, `a_flat_plate_has_its_added_mass` (src/wedge_entry.rs) |
//! | a wedge on a spring: a swing without water, momentum without a spring | `without_water_it_swings`, `without_a_spring_its_momentum_goes_to_the_water`, `water_that_does_not_pull_leaves_it_to_its_spring` (src/wedge_on_spring.rs) |
//! | a floating box: half of the added mass of a square, order of its corners, energy | `a_fast_box_has_half_of_the_added_mass_of_a_square`, `times_converge_with_the_order_of_the_corner`, `energy_is_kept` (src/floating_box.rs) |
//! | a floating cylinder: published values of Ei, energy, slow and fast limits, Vugts' measured points, start and end of its motion; the tank is the same where it is wide and deep | `the_exponential_integral_has_its_published_values`, `waves_carry_what_damping_takes`, `slow_it_is_a_source_and_fast_half_of_a_whole_cylinder`, `it_is_what_vugts_measured`, `it_begins_at_rest_and_ends_without_swinging`, `in_a_wide_and_deep_tank_it_moves_as_in_water_without_ends`, `pieces_converge` (src/floating_cylinder/mod.rs) |
//! | a box in waves: Haskind's relation, energy, reciprocity, long waves, convergence, finite volumes | `waves_carry_what_damping_takes_and_push_by_haskinds_relation`, `masses_are_reciprocal_and_moments_go_with_the_centre`, `in_long_waves_it_goes_with_the_water`, `terms_converge`, `it_heaves_as_by_finite_volumes` (src/box_in_waves/mod.rs) |
//! | an added mass is the energy of its fluid | `the_added_mass_is_the_energy_of_the_fluid` |
//! | plates buckle and bend by their closed forms | `the_plate_buckles_by_its_closed_forms`, `thin_square_plates_are_those_of_the_tables` |
//! | elements: forces and tangent are slopes of the energy; six zero modes; rigid motion free | `forces_are_the_slope_of_the_energy_and_the_tangent_the_slope_of_the_forces`, `a_free_patch_has_six_zero_modes_and_no_more`, `a_rigid_motion_of_any_size_meets_no_force` (tests/fe_shell_element.rs) |
//! | elements: patch tests on distorted meshes | `a_homogeneous_stretch_of_any_size_is_in_balance_on_a_distorted_mesh`, `constant_curvatures_are_in_balance_on_a_distorted_mesh` |
//! | bricks: slopes, zero modes, rigid motions, patches on distorted meshes, a bar under its own weight | `forces_are_the_slope_of_the_energy_and_the_tangent_the_slope_of_the_forces`, `a_free_brick_has_six_zero_modes_and_with_two_points_six_more`, `a_homogeneous_deformation_is_in_balance_on_a_distorted_mesh`, `a_heavy_bar_stretches_by_its_closed_form` (tests/fe_solid.rs) |
//! | bricks: those of another program to its digits, a beam, a thin plate | `the_cantilever_is_that_of_calculix`, `a_small_load_bends_the_beam_by_its_closed_form`, `a_thin_plate_is_von_karmans` |
//! | elements: published problems | `the_linear_obstacle_course`, `the_panel_snaps_through`, `point_forces_on_doubly_curved_shells` and others (tests/fe_shell_cases.rs) |

#![deny(clippy::print_stdout, clippy::print_stderr)]

pub mod box_in_waves;
pub mod catalogue;
pub mod curve;
pub mod elastica;
pub mod external_pressure;
pub mod fe_shell;
pub mod fe_solid;
pub mod floating_box;
pub mod floating_cylinder;
pub mod fluid_structure;
pub mod fluid_structure_forms;
pub mod fluids;
pub mod hinged_box;
pub mod impact;
pub mod kirsch;
pub mod on_flats;
pub mod pressed;
pub mod rolled_strip;
pub mod shaken_beam;
pub mod sheared_plate;
pub mod stiffened_plate;
pub mod touching;
pub mod vibration;
pub mod waves;
pub mod wedge_entry;
pub mod wedge_on_spring;

mod elliptic;
mod error;

pub use catalogue::{Reference, catalogue, reference};
pub use curve::{Curve, Extremum};
pub use error::ReferenceError;
