//! A thin shell carried by one layer of SPH particles: the model.
//!
//! After \[lin2013\]; shells over meshless fields go back to \[krysl1996\]. Particles hold a position x and a unit
//! director d. Strains are sampled at points whose stencils come from `sph-core`, made into resultants by
//! `shell-kinematics`, and carried back to the particles by the transposed stencils, so that forces are the exact
//! derivative of an energy. `explicit-dynamics` marches the result, `implicit-statics` balances it.
//!
//! | where is | look in |
//! |---|---|
//! | what a shell is made of, and in which order | `builder.rs`; its groups: `material.rs`, `points/scheme.rs`, `conditions/constraints.rs`, `dependents.rs`, `loading.rs`, `motion.rs`, `time/evaluation.rs` |
//! | the pipeline of a point: strain → stress → force | `points/point.rs`, [`Shell::internal_force`] |
//! | points in packs of four; equal constants kept once | `packs.rs`; `shared.rs` |
//! | where the forces on a particle lie, the transpose of the stencils | `gather.rs` |
//! | the registers of a processor, which copy of a sweep runs | `registers.rs`, `eights.rs`; `dispatch.rs` |
//! | the sweep over all points, into slots, which lie in a ring | `points/sweep.rs`; `points/ring.rs` |
//! | stresses of the unstrained shell; heat | `initial_stress.rs`, [`ShellBuilder::stresses`]; `heat.rs`, [`ShellBuilder::temperatures`] |
//! | what each formulation does beside its strains; the paper's eqs. 4, 8, 9 to the letter | `points/scheme.rs`; `points/strong_form.rs` |
//! | strains and resultants, to be read; the range of the model | `points/results.rs`, [`Shell::point_results`]; `points/bounds.rs` |
//! | zero-energy control; strains of uneven cells | `control/cells.rs`, `control/pairs.rs`; `control/arcs.rs`, `control/shear.rs` |
//! | what a clamp does; loads with their stiffness; load cases | `conditions/supports.rs`; `conditions/loads.rs` and its neighbours; `conditions/case.rs` |
//! | the step of four particles (kick, hold, drift) | `time/particle.rs` |
//! | the whole step in one sweep; the march | `time/fused.rs`; `time/march.rs` |
//! | several march it: what each owns, sends, adds up | `sharing.rs`, [`Shell::share`]; `time/share.rs`; loads on a share: `conditions/on_share.rs` |
//! | sheets that meet along a line, tied | `junction/`, [`Shell::tied`] |
//! | edges that hang on sheets whose particles stand elsewhere | `ties/`, [`ShellBuilder::ties`] |
//! | points that a fluid wets, and the way of its forces; bars along lines of particles | `wetted/`, [`ShellBuilder::wetted`]; `stiffeners/`, [`ShellBuilder::stiffeners`] |
//! | the tangent, of the energy and of the loads | `statics/stiffness.rs`, `statics/load_stiffness.rs`, [`StaticShell`] |
//!
//! A plate stretched by a tenth stores what its membrane stiffness says, and its edge bears the force:
//!
//! ```
//! use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
//! use sph_core::{EndWeights, Plate, Vec3, lattice};
//! use sph_shell::{Formulation, Parts, Reach, Shell};
//!
//! let (young, thickness) = (200.0, 0.5);
//! let cloud = lattice(&Plate { lengths: [2.0, 1.0] }, [9, 5], EndWeights::Trapezoid)?;
//! let places = cloud.positions.clone();
//! let edge = cloud.lattice.map_or(Vec::new(), |lattice| lattice.column(0));
//! let mut shell = Shell::builder(Parts {
//!     cloud,
//!     section: Box::new(IsotropicSection::new(Isotropic::new(young, 0.0)?, thickness)?),
//!     strain: &StretchCorrected,
//!     material_axis: None,
//!     density: 1.0,
//!     formulation: Formulation::StressPoint(Reach::Cell),
//!     supports: Vec::new(),
//!     loads: Vec::new(),
//!     threads: 1,
//! })
//! .build()?;
//! for (a, x) in places.iter().enumerate() {
//!     shell.set_state(a, Vec3::new(1.1 * x.x, x.y, x.z), Vec3::z());
//! }
//! shell.evaluate_internal(true);
//! let e11 = 0.5 * (1.1_f64.powi(2) - 1.0);
//! assert!((shell.stored_energy() - 0.5 * young * thickness * e11 * e11 * 2.0).abs() < 1e-12);
//! let pull: f64 = edge.iter().map(|&a| shell.internal_force(a as usize)[0]).sum();
//! assert!((pull + young * thickness * e11 * 1.1).abs() < 1e-11); // n¹ = N11 x,1 over a width of one
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # The discrete shell
//!
//! ```text
//! U = Σ_p w_p ψ(ε_p) + U_h                     ε_p from x,α = Σ G_αb x_b,  d = Σ φ_b d_b,  d,α = Σ G_αb d_b
//! f_b = −∂U/∂x_b = −Σ_p w_p (n¹ G₁_b + n² G₂_b) + …
//! τ_b = −∂U/∂d_b = −Σ_p w_p (q φ_b + m¹ G₁_b + m² G₂_b) + …
//! m_a ẍ_a = f_a + load          I_a d̈_a = (f_d)_⊥,  f_d = τ_a + load,  the part across d_a, on the sphere |d_a| = 1
//! ```
//!
//! ψ is the section's energy per area, U_h that of the zero-energy control, the dots its forces. Masses are
//! `m_a = ρ t A_a` ([`Reference::masses`]), rotary inertias `I_a = ρ t A_a max(t², Ā_a)/12` with Ā_a the mean area of
//! the cells at a ([`Reference::inertias`]): scaled up for thin shells, so that the stable step does not collapse with
//! the thickness. Modes of vibration take `ρ t A_a t²/12`, and masses that turn as the surface does (second_moments.rs). Since [`Shell`] sums forces by the transpose of the
//! stencils, a free shell keeps momentum and moment of momentum to round-off, and energy to second order of the step.
//!
//! # Formulation: where strains are sampled
//!
//! | [`Formulation`] | points | stencil | zero-energy control |
//! |---|---|---|---|
//! | `StressPoint` with [`Reach::Cell`] | one a cell | its three or four particles | hourglass of the cell |
//! | `StressPoint` with [`Reach::Kernel`] | one a cell | corrected kernel, divergence-consistent | pairs |
//! | `Nodal` | the particles | least squares of order 1, 2, 3 | pairs |
//! | `StrongForm` | the particles | least squares of order 1 | none |
//!
//! Stress points apart from the particles are a known cure of nodal sampling \[belytschko2000\]; with four particles a
//! cell it is algebraically the uniform-gradient quadrilateral \[flanagan1981\] with a director.
//!
//! # Kirchhoff-consistent shear
//!
//! On a stencil that is not exact on quadratic fields a Kirchhoff deflection of curvature κ leaves a shear in `x,α·d`.
//! What it leaves is known and taken out:
//!
//! ```text
//! γ̂_α = γ_α + E_α,βγ κ_βγ        E_α,11 = ½Σ G_α ξ²,  E_α,22 = ½Σ G_α η²,  E_α,12 = ½Σ G_α ξη
//! ```
//!
//! with κ₁₂ entering as 2κ₁₂, once. The tensor is `sph_core::SamplingOperator::second_moments`; it vanishes on
//! parallelograms.
//!
//! # Uneven cells
//!
//! Third moments `T^α = ΣG_α ξξξ` make the next error of a stencil. What neighbouring cells have in common of it particles make up
//! for; its uneven part T̃ (`sph_core::SamplingOperator::uneven_third_moments`) would lock thin shells, in the membrane because
//! chords of a curved cell fall short of arcs, and in shear. In the formulation by cells
//!
//! ```text
//! e_m ← e_m + σ L_m·(k − K)      L = ∂l/∂k at rest,  l = (1/12)(T̃^α∴kk_β + T̃^β∴kk_α) − ½ (E_α:k)(E_β:k)
//!                                σ = min(1, √(ε/12) t/|L|),  ε = 0.2
//! shear energy × t²/(t² + min(α |T̃|²/w, w/10))        α = 0.02
//! ```
//!
//! after the stabilised shear of \[lyly1993\]. K is the curvature at rest. Both are part of the energy. Lattices on developable surfaces have no uneven part and no array for it.
//! Derivations and measurements: docs/uneven-cells.md.
//!
//! # Zero-energy control of cells
//!
//! One point does not see the pattern h = (1, −1, 1, −1). With `γ_b = ¼[h_b − G₁_b(h·ξ) − G₂_b(h·η)]`, which is blind
//! to linear fields \[flanagan1981\], `q_x = Σ γ_b x_b`, `q_d = Σ γ_b d_b`, `H_αβ = Σ γ_b ξ_α ξ_β`,
//!
//! ```text
//! s1 = q_x·x,₁    s2 = q_x·x,₂    s3 = q_x·d + ½ H:k    s4 = q_d·x,₁    s5 = q_d·x,₂    s6 = x,₁·d,₂ − x,₂·d,₁
//! U_h = (4/3) [β_x k_s (s1² + s2² + s3²) + β_d D_b (s4² + s5²)] + ½ w k_a s6²           (each s less its reference)
//! k_s = (5/6)Gt · t²/(t² + w)      k_a = k_s ρ²/12      β_x = 0.1 + 0.4 t²/(t² + w)      β_d = 0.2
//! ```
//!
//! ρ² is here the mean of ξ² + η² over the four particles. s3 leaves a constant twist free, since a Kirchhoff shell has
//! `x,αβ·d = −k_αβ`; s6, the swirl, is curl of shear alone. The measurements behind β_x and β_d are in
//! docs/zero-energy-control.md.
//!
//! # Curvature along arcs
//!
//! Directors are unit vectors and their differences chords: a cell that turns by ψ finds `(2/Δ) sin ½ψ` for `ψ/Δ`.
//! Strains take `k̂ = c k`,
//!
//! ```text
//! u = 1 − d·d      z = s4² + s5²      c = 1 + u/6 + 3u²/40 + z (1/3 + 13u/30)
//! ```
//!
//! to second order the exact ratio of arc to chord for a cell that turns about one axis and swings in that plane. It is
//! part of the energy, with its forces and its tangent, for the formulation by cells.
//!
//! # Zero-energy control of wide stencils
//!
//! The residual of a pair of particles over nodal gradients of order 2, as \[ganzenmuller2015\] controls solids, made
//! blind to quadratic fields:
//!
//! ```text
//! e = x_b − x_a − (what the gradients and directors of both ends predict),     g likewise for d
//! U_h = Σ_pairs ½ (ω/|X_b − X_a|²) (β k_s |e|² + β D_b |g|²)      β = 0.1 (1 + 4t²/(t² + A)),  A the mean area of both ends
//! ```
//!
//! k_s takes A in the place of w. e and g are linear in (x, d): a constant matrix, assembled once. The full formula
//! opens `control/pairs.rs`.
//!
//! # The strong form
//!
//! [`Formulation::StrongForm`] balances forces and moments at the particles as \[lin2013\] does, with the corrected gradient
//! \[chen1999\] of the first particle of each pair:
//!
//! ```text
//! m_a ẍ_a = A_a Σ_b [(P_b ± P_a)·g_ab − ρ₀² t Π_ab F_a g_ab]     eq. 4, + as printed;  P = n¹⊗T₁ + n²⊗T₂
//! I_a ω̇_a = A_a Σ_b (μ_b ± μ_a)·g_ab + A_a T_a                   eq. 9;  μ = d × m,  T = −d,α × m^α − d × q
//! Π = (μ/ρ₀)(−c̄ϑ + 2ϑ²) for approaching particles, else 0
//! ```
//!
//! g_ab is the corrected gradient of a towards b, ϑ < 0 the rate of their distance, c̄ the sound speed, ρ₀ the density;
//! Π is subtracted as a pressure, where the paper adds it, and turned with the particle by F. The difference ([`Divergence`]) also
//! prescribes what acts at edges, `P_a·r_a = f_a`, and holds the pattern of two spacings. There is no energy behind either, the
//! stiffness is not symmetric; the tests measure that, docs/formulations.md shows the eigenvalues, and validation what the printed sum costs.
//!
//! # Several sections
//!
//! [`ShellBuilder::regions`] gives cells a section of their own, at a height e over the particles: its middle meets the membrane strain
//! `e_m + e κ`, and its membrane force has the arm e (`shell_kinematics::SectionPack`). Masses, rotary inertias and the control of
//! zero-energy modes go by cell. The page of `regions.rs` has the formulas.
//!
//! A region may have a strain measure of its own ([`Region::strain`]). [`ShellBuilder::stresses`] puts stresses on the unstrained shell ([`InitialStress`]): in
//! statics a preload, or counted by the level; in the march there from the start.
//!
//! [`ShellBuilder::stiffeners`] lays bars along lines of particles, at a height over them ([`Stiffener`]): the page of `stiffeners/mod.rs` has the formulas.
//!
//! [`ShellBuilder::masses`] adds masses to particles, which do not turn with the director.
//!
//! # Sections with memory
//!
//! Where the section has a `shell_kinematics::Memory`, each point has a history h₀ that only a commit changes; forces, tangent and energy are
//! those of the incremental potential at h₀, so that a border point may be swept twice and a trial state taken back:
//!
//! ```text
//! f = ∂/∂q Σ_p w_p W(ε_p; h₀_p)        commit: h₀ ← H(ε, h₀)        W: stored, and all that was dissipated
//! ```
//!
//! A march commits at the end of each step, [`StaticShell`] a state that is accepted; saved states and [`Shell::history`] hold h₀. The stable
//! step is that of unloading, h₀ held. The control of zero-energy modes goes with the flow of the section: of its pull S a step keeps the share χ,
//! `S = χ (S⁰ + k (s − s⁰))` (src/control/yielding.rs). Regions may have sections of their own with a memory or without, linear or not; an initial stress goes with
//! linear ones, or one without memory.
//!
//! # Supports and loads
//!
//! A [`Support`] says what it [`Holds`]: directions of no displacement, and of the director nothing, a plane `d·ν = 0`,
//! or both turns. [`Held`] is the general one; [`Clamped`], [`Hinged`], [`SymmetryPlane`], [`Diaphragm`] are named
//! cases. [`Moved`] prescribes displacements, [`Rotated`] both turns of directors, `d = R(axis, angle) D`, [`Turned`] positions and
//! directors of a set that turns as one body, by level and amplitude. Held parts are taken out of velocities in the march and are no unknowns in statics; there, prescribed values c
//! pull with `−K_fc ċ`, from the blocks of the tangent ([`StaticShell`]). In the march a director goes along the great circle to
//! where it must be at the end of the step, and the work of its support is counted. A
//! [`Load`] adds rows \[f, τ\]: [`Force`], [`Gravity`], [`Pressure`] (dead or follower; on some cells [`PressurePatch`]) and [`EdgeCouple`],
//! `τ_a = M (l_a/Σl)(e × d_a)`, whose work is M δθ for a turn δθ about e, l_a the tributary length of particle a; [`DrillingCouple`] also has the part along d.
//!
//! Loads that follow the shell have a stiffness, [`Load::stiffness`]; the tangent of statics is `∂²U/∂q² − sym ∂f/∂q`. With
//! u, v the diagonals of a cell of n corners, each of which bears `f = p (u × v)/2n`, and `τ = m (e × d)`, `e = u/|u|`:
//!
//! ```text
//! follower pressure   ∂f/∂u = −(p/2n) [v]×    ∂f/∂v = (p/2n) [u]×        [y]× z = y × z
//! couple              ∂τ/∂d = m [e]×,  about the edge also  ∂τ/∂u = −m [d]× (1 − e eᵀ)/|u|
//! ```
//!
//! Summed over a smooth surface the former is symmetric but for its free edges \[schweizerhof1984\], where pressure has no
//! potential; couples have one in the plane of bending alone. What is skew is left out of the tangent, never out of the
//! residual, and [`StaticShell::skew_load_share`] tells how much it is.
//!
//! [`ShellBuilder::springs`] holds particles elastically along directions, directors and rigid sets against turning, and joins pairs, whatever the
//! level ([`Springs`]).
//!
//! [`ShellBuilder::rigid`] makes sets move as rigid bodies, with a reference point, mass and inertia of their own ([`RigidSet`]).
//!
//! [`Preloaded`] loads and motions are applied first and held while the level counts the others: [`LoadCase`],
//! [`StaticShell::set_case`].
//!
//! # In a fluid
//!
//! [`ShellBuilder::wetted`] lays columns of points over the middle surface, as far apart as the particles of the fluid and not as those
//! of the shell, with rows at heights z below each wet face ([`Wetting`]). For `explicit_dynamics::TwoClocks` a shell is then
//! `Wetted`:
//!
//! ```text
//! x_p = Σ N_a x_a + z Σ N_a d_a        N: bilinear in a cell, the widths of a row across a strip in a plane problem
//! f_a += N_a f_p,   τ_a += N_a z f_p   the transpose: the same work for any motion, the same force and moment
//! f = −ρ₀c₀A [(v − v_seen)·n] n        while the fluid takes a step, on columns that bear a load
//! ```
//!
//! On lattices columns are even along the mean lines of both directions; on other clouds they divide cells, and those closer
//! than 0.7 spacings are left out. In a plane problem the shell is a strip across the plane, a few particles wide between
//! planes of symmetry; points stand along its middle line, and forces per depth act on its width. A dry shell has no array for
//! any of this.
//!
//! # What holds, and the test that says so
//!
//! | invariant | test |
//! |---|---|
//! | force is the derivative of the energy, every formulation and strain | `force_is_the_derivative_of_the_energy` (tests/energy.rs) |
//! | internal forces and moments cancel; rigid motion is free of force and energy | `forces_and_moments_cancel`, `finite_rigid_motion_is_free_of_force_and_energy` |
//! | a rotated shell has rotated forces | `rotated_clouds_give_rotated_forces` |
//! | patch tests: constant membrane force and constant moment are in balance, and are read exactly | `constant_membrane_force_is_balanced`, `constant_moment_is_balanced` (tests/patch.rs), `a_constant_stretch_is_read_exactly`, `a_constant_bending_is_read_exactly` (tests/results.rs) |
//! | a free shell has six zero modes and no more; no negative stiffness | `free_shells_have_exactly_six_zero_modes`, `laminated_free_shells_have_exactly_six_zero_modes` (tests/modes.rs) |
//! | tangent and forces along the unknowns are derivatives of the energy | `the_tangent_is_the_second_derivative_of_the_energy`, `forces_along_the_unknowns_are_the_first_derivative` (tests/statics.rs) |
//! | the stiffness of every load is its derivative; symmetric inside planes of symmetry | `the_stiffness_of_every_load_is_its_derivative`, `pressure_inside_planes_of_symmetry_has_a_potential_and_over_free_edges_has_none` (tests/load_stiffness.rs) |
//! | sheets at a junction: force and tangent are derivatives, six zero modes, frames and sections as beams and elements say, a free flight keeps momentum and right angles | tests/junction.rs, tests/junction_frames.rs, tests/junction_march.rs, tests/sections.rs |
//! | junctions of many sheets, nearly flat, disordered, with slivers, turned far | tests/junction_hard.rs |
//! | ties: force and tangent are derivatives, constant strains and curvatures are balanced, six zero modes, boxes and frames as closed forms say, momentum is kept | tests/ties.rs, tests/ties_answers.rs |
//! | a tube ovals at 3 D/R³ under follower pressure, at 4 under dead; Newton stays quadratic | `a_tube_buckles_at_three_under_follower_pressure_and_at_four_under_dead`, `residuals_fall_quadratically_under_follower_pressure` |
//! | sets moved or turned by level: load rates are derivatives; a column shortened by its end buckles like one pressed; a strip rolls up by its end; the march agrees | `load_rates_are_derivatives_with_respect_to_the_level`, `a_column_shortened_by_its_end_buckles_at_the_load_of_one_that_is_pressed`, `a_strip_rolls_up_to_a_ring_by_its_end`, `a_march_with_a_turned_end_finds_the_same` (tests/prescribed.rs) |
//! | bars: derivatives, zero modes, beams with a neutral axis, rings, sheets that they stand for, smeared stiffness, buckling of a plate with one, free flight, the step, bits of processes | tests/at_rest/stiffeners.rs, tests/at_rest/stiffened_answers.rs, tests/in_time/stiffened.rs |
//! | several march it to the same bits: 80 layouts with loads and springs of every kind, on one thread and two; whole marches of plates, of frames with junctions, ties and rigid sets, of what yields; words of refusals | `peers_march_to_the_same_bits_on_many_layouts` (src/time/march/tests.rs), tests/in_time/shared.rs, shared_bodies.rs |
//! | what is enclosed: volumes of open surfaces, potential, tangent beside the pattern, zero modes, tubes on liquids and gas | tests/at_rest/enclosed.rs, tests/in_time/enclosed.rs |
//! | preloads: derivatives in both load cases, frequencies of a pulled and a pressed strip, of a tube under follower pressure, buckling at what is left, order of two cases | tests/preload.rs |
//! | a set that turns as one body stores nothing, comes back, twists a strip as St Venant says, in time as at rest | tests/turned_sets.rs |
//! | springs: frequencies and deflections in closed form, tangent, momentum, the stable step | tests/springs.rs, tests/more_springs.rs, tests/beams_on_springs.rs |
//! | rigid sets: derivatives of the energy, six zero modes, beams with a heavy end, momentum in free flight, the step, supports that balance | tests/rigid.rs, tests/rigid_march.rs |
//! | rigid sets that are moved and turned, or held beside their centre of mass: as their particles one by one, pendulums, energy in time | tests/moved_bodies.rs, tests/hinged_bodies.rs |
//! | masses lumped at a junction weigh and move with it | tests/junction_masses.rs |
//! | dynamic relaxation finds what Newton's method finds | `relaxation_finds_what_newton_finds` (tests/relaxation.rs) |
//! | a polygon bends like the circle; a hourglass of directors releases nothing | `a_polygon_bends_like_the_circle`, `a_director_hourglass_releases_no_bending_energy` (tests/rolled.rs) |
//! | free flight keeps momentum and moment of momentum; the energy error falls with Δt² | `free_flight_keeps_momentum_and_moment_of_momentum`, `undamped_energy_error_is_bounded_and_falls_with_the_square_of_the_step` (tests/march.rs) |
//! | the stable step does not collapse with thickness | `stable_step_does_not_collapse_with_thickness` |
//! | a cell turned inside out, crushed or torn is named, static and dynamic | tests/bounds.rs |
//! | what a laminate and its axes promise | tests/layered.rs |
//! | regions: beams of two thicknesses and heights, derivatives, six zero modes, masses, the same bits for any threads; two strain measures in one strip; a mass at the end of one | tests/regions.rs |
//! | sections with memory: a hardening line there and back, derivatives, what is taken back and taken up, one bit for threads and parts of a step, the balance | tests/history.rs |
//! | initial stress: derivatives, relief, rolling up, rest where edges are held, energy and bits in time | tests/initial_stress.rs |
//! | plates and membranes under initial stress vibrate and buckle as closed forms say | tests/prestressed.rs |
//! | heat: derivatives, free plates and strips, held plates, buckling, two plies; conducted, in balance and in time | tests/heat.rs; tests/conduction.rs, tests/heat_in_time.rs |
//! | pressure and areas on cells add up; supports bear what the loads are | `patches_of_pressure_add_up_to_the_whole`, `areas_spread_over_cells_add_up_to_those_of_the_particles`, `supports_bear_what_the_loads_are` (tests/load_stiffness.rs) |
//! | forces on wet points and on particles do the same work for any motion, and have the same sum and moment | `virtual_work_is_the_same_on_points_and_particles`, `forces_and_moments_are_kept` (tests/wetted.rs) |
//! | wet points lie below the faces, evenly, over all of the shell | `a_strip_is_wetted_along_its_middle_line`, `points_cover_a_shell_in_space_evenly` |
//! | in two clocks: the same bits for any threads and after a pause, no allocation, the static answer at rest | tests/coupled.rs |
//! | what the strong form breaks | `it_does_not_conserve_momentum`, `its_stiffness_is_not_symmetric`, `it_fails_the_membrane_patch` (tests/strong_form.rs) |
//! | the same bits for any number of threads, one sweep or two passes; a step allocates nothing, one of peers neither | `threads_do_not_change_a_bit`, `one_sweep_and_two_passes_give_the_same_bits`, `a_step_allocates_nothing`, `a_step_of_peers_allocates_nothing` (tests/threads.rs); `one_sweep_gives_the_same_bits_on_many_layouts_and_threads` (time/march/tests.rs) |

#![deny(clippy::print_stdout, clippy::print_stderr)]

mod builder;
mod conditions;
mod conduction;
mod control;
mod dependents;
mod dispatch;
#[cfg(target_arch = "x86_64")]
mod eights;
mod enclosing;
mod error;
mod even_bed;
mod formulation;
mod gather;
mod heat;
mod initial_stress;
mod junction;
mod loading;
mod material;
mod motion;
mod on_tools;
mod packs;
mod places;
mod points;
mod reference;
mod regions;
mod registers;
mod second_moments;
mod shared;
mod sharing;
mod shell;
mod statics;
mod stiffeners;
mod ties;
mod time;
mod touching;
mod turning;
mod wetted;

use conditions::constraints::Constraints;
use dependents::Dependents;
use loading::Loading;
use material::Material;
use motion::Moving;
use points::scheme::Points;
use stiffeners::Stiffeners;
use time::evaluation::Evaluation;
use time::share::Share;

pub use builder::{Parts, ShellBuilder};
pub use conditions::body::{Block, Body, place_block};
pub use conditions::case::LoadCase;
pub use conditions::cavity::{Content, Enclosed, Volumes};
pub use conditions::couple::{CoupleAxis, DrillingCouple, EdgeCouple};
pub use conditions::loads::{AddLoad, AppliedLoad, Force, Gravity, Load, LoadOnShare};
pub use conditions::own_contact::OwnContact;
pub use conditions::preload::Preloaded;
pub use conditions::prescribed::{Motion, Rotation};
pub use conditions::pressure::{Pressure, PressurePatch};
pub use conditions::resultants::{LoadShare, Resultant};
pub use conditions::spread::spread;
pub use conditions::springs::{BodySpring, Spring, SpringBetween, Springs, TurnSpring};
pub use conditions::supports::{
    Clamped, Diaphragm, DirectorHold, Held, Hinged, Holds, Moved, Rotated, Support, Supported, SymmetryPlane,
};
pub use conditions::tools::Tool;
pub use conditions::touched::contact_stiffness;
pub use conditions::turn::Turn;
pub use conditions::turned::Turned;
pub use conduction::{
    Conduction, ConductionError, Conductor, ConductorError, HeatBalance, HeatCourse, Radiation, Temperatures,
};
pub use control::arcs::ChordLoss;
pub use error::{EnclosedError, HeatError, ShellError, StiffenerError};
pub use even_bed::{EvenBed, even_bed};
pub use formulation::{Divergence, Formulation, Reach};
pub use heat::Temperature;
pub use initial_stress::InitialStress;
pub use junction::rigid::{RigidLoad, RigidSet};
pub use points::results::{PointResult, Yielded};
pub use reference::{Reference, origin_of};
pub use regions::{PointSection, Region};
pub use statics::static_shell::StaticShell;
pub use stiffeners::{BarForce, InSurface, Stiffener};
pub use ties::list::Tie;
pub use ties::loss::TieLoss;
pub use turning::TurningInertia;
pub use wetted::{WetColumn, WetFaces, Wetting};

/// A shell of SPH particles, ready to be marched.
pub struct Shell {
    reference: Reference,
    material: Material,
    /// Where strains are sampled.
    points: Points,
    /// What supports hold.
    constraints: Constraints,
    /// What ties particles to each other.
    dependents: Dependents,
    /// Bars along its lines.
    stiffeners: Stiffeners,
    /// What acts from outside.
    loading: Loading,
    motion: Moving,
    /// What the last evaluation found.
    evaluation: Evaluation,
    /// Who marches it.
    share: Share,
}
