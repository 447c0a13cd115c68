//! Element-free Galerkin on the strain and rotation of increments: solids in space through large displacements and rotations.
//!
//! A [`Galerkin`] body is built from [`Parts`]: nodes with moving least squares, background cells, a material, conditions, loads. It is an
//! [`Equilibrium`](implicit_statics::Equilibrium): Newton's method, arc length, modes and relaxation are those of
//! `implicit-statics`. After \[song2018\], with what that paper prints wrongly put right.
//!
//! # Displacements
//!
//! `u(X) = Σ_I φ_I(X) d_I` with the shape functions of [`MovingLeastSquares`](sph_core::MovingLeastSquares) at rest \[belytschko1994\], computed once;
//! `F = I + Σ_I d_I ⊗ ∂φ_I/∂X`. The parameters d are no displacements, not even at nodes ([`Galerkin::displacement`] sums). Which
//! basis and support suit what (simply supported plate, 11×11×3 nodes, deflection over the exact one):
//!
//! | basis, support | a/h = 100 | a/h = 20 | for |
//! |---|---|---|---|
//! | linear, ball of 2.5 spacings | .866 | .990 | what the paper did |
//! | quadratic, ellipsoid of 2.5 | .824 | .999 | solids |
//! | plate17, box of (3.5, 3.5, 2.5) | 1.001 | 1.022 | plates, thin ones too |
//!
//! # Forces and stiffness
//!
//! [`Material::trial`](solid_kinematics::Material::trial) leads every Gauss point from the state last accepted over the whole step, and
//!
//! ```text
//! f_iI = Σ_g V_g P_iJ ∂φ_I/∂X_J        K_iI,kK = Σ_g V_g ∂φ_I/∂X_J A_iJkL ∂φ_K/∂X_L        A ≈ ∂P/∂F
//! ```
//!
//! The paper's stiffness `K_L − K_N` of four terms is, signs put right,
//!
//! ```text
//! K = ∫ B^sᵀ(D − 2σ₁)B^s + ∫ σ_ij ∂_iφ_I ∂_jφ_K · I₃,    A_ijkl = C_ijkl + δ_ik τ_jl − ½(δ_ik τ_jl + δ_il τ_jk + δ_jk τ_il + δ_jl τ_ik)
//! ```
//!
//! drawn back to rest by F⁻¹. It is symmetric and exact where a step begins; within one it is off by the order of the step. A step that it
//! does not find is made again with the exact derivative, symmetrised as the house's solver asks, and only then halved ([`lead`]; other
//! drivers halve at once and go on with the exact one). A factor is kept while the residual falls to .03 in an iteration
//! ([`keeps_factor`](implicit_statics::Equilibrium::keeps_factor)): the cantilever to K = 10 takes 41 tangents and 70 iterations in place of
//! 66 and 65. Newton's method takes whole steps best (`line_search: false`; 65 iterations, 86 with a search): along a straight way a body
//! that turns is stretched by the square of the way, which raises the residual by two orders; the next whole step takes that out, where
//! a search waits until it is small. To start a step from states extrapolated through the last ones does not pay for the same
//! reason: 61 iterations and 42 tangents at best, and the line through the last two does not converge.
//!
//! Above ν = ⅓ the change of volume that varies within a cell is held back less and less, else the solid locks ([`Volumes`]; derived in
//! `volumes.rs`): `P` is then that of a gradient F̄ whose determinant is nearer to the mean of the cell, and a cell has two products of vectors
//! beside the moduli of its points.
//!
//! # Flow
//!
//! A material with a [`Plastic`](solid_kinematics::Plastic) yields at its Gauss points; curves of hardening are those of shells ([`Hardened`]). Flow
//! keeps the volume, so that 27 points a cell would lock at any Poisson's ratio: such a body wants [`Volumes::Mean`]. Plastic strain and back stress
//! are part of the state that a step starts from: trials leave them alone, a state that is accepted takes them along, and what is
//! saved holds them. [`energy`](implicit_statics::Equilibrium::energy) is then the work of the way, stored or dissipated. A step
//! begins with the derivative of flow that goes on where a point stands on the surface.
//!
//! # Planes of symmetry
//!
//! Behind a [`Mirror`] nodes have images, with parameters `R d` and `R = I − 2 n nᵀ`: shape functions are those of the whole, and so are the
//! displacements. The condition on the plane, `Σ_J φ_J n·d_J = 0` of its nodes, is then one on their own parameters: those of the others
//! cancel their images'.
//!
//! # Conditions
//!
//! Fixing parameters does not fix displacements ([`Essential::Direct`], the paper's way: a clamped cantilever bends .9 to 2 % more).
//! [`Essential::Collocation`] asks `Σ_J φ_J(X_I) n·d_J = λū` at every node of a condition. The equations are solved for as many parameters by
//! elimination, `d_h = T q + λg`, and these are taken out: with `Z = K_hf + ½K_hhT`
//!
//! ```text
//! f̂ = f_f + Tᵀf_h        K̂ = K_ff + TᵀZ + ZᵀT
//! ```
//!
//! The same solution as the system bordered by multipliers has, but definite where the body is stable: its inertia counts what is unstable.
//! [`Galerkin::reactions`] are the forces of the conditions. Equations that depend on others drop out
//! ([`Galerkin::dependent_conditions`]) or contradict them, an error.
//!
//! A simply supported plate is held on the **line** of its mid-plane: held over its face an edge cannot turn without stretching, 3.5 %
//! stiffer with immovable edges, 10 to 13 % with movable ones. Symmetry planes are held along their normal.
//!
//! # Loads
//!
//! Dead tractions, forces per volume and at points; pressure that follows, on the deformed tangents `a_α = F e_α`:
//!
//! ```text
//! f_I = −∫ p φ_I a₁ × a₂        ∂f_I/∂d_K = −∫ p φ_I ( −[a₂]× φ_K,1 + [a₁]× φ_K,2 )
//! ```
//!
//! Its stiffness is not symmetric; the solver gets the symmetric part, so that Newton converges fast but not quadratically.
//! [`Galerkin::exact_tangent`] has all of it.
//!
//! # Cost
//!
//! A stiffness takes 27 products for every pair of nodes that a Gauss point sees, symmetric half only. Elimination goes along slender
//! bodies and by nested dissection of others, whichever multiplies less: 61 440 unknowns of 20 736 nodes on 81×16×16 (linear basis, balls
//! of 1.8 spacings: 23 million entries) make 1.6·10⁸ entries of the factor in 2·10¹¹ multiplications: 41 s of one core
//! of a shared Xeon (2.5 GHz), 31 of them for the factor, and 3.5 GB; minimum degree
//! needs three to eight times as many multiplications on slender bodies, as many on a cube. `cargo bench -p sr-galerkin --bench newton` measures.
//!
//! # What the method does not do
//!
//! [`OneSolve`](implicit_statics::OneSolve) is the source's scheme, one solve a step and no iteration for balance.
//!
//! An affine displacement of held nodes does not go through exactly. Its parameters meet all conditions; they balance if its stress
//! does no work on any motion δd that the conditions allow,
//!
//! ```text
//! P : Σ_I δd_I ⊗ b_I = 0        b_I = Σ_g V_g ∂φ_I/∂X_g   →   ∮ φ_I n dA   with exact integrals, the sum then being   ∮ Pn·δu dA
//! ```
//!
//! Motions vanish at held nodes and not on the boundary between them: the integral stays, however exact the quadrature. Measured
//! on 5×4×4 to 9×7×7 nodes, .11 to .21 % of the greatest displacement on lattices and .2 to .5 % with nodes displaced by a
//! quarter, the same to a hundredth for 4 Gauss points in cells of a half and of a third; three points in whole cells add as much
//! again at most. Tractions work between nodes as well: an affine state under tractions is found as well as the quadrature is.
//! Conditions whose forces act along the whole face would mend it at the price of a tangent that is not symmetric or
//! of multipliers; that is not offered. The law of increments is hypoelastic: strains below .2.
//!
//! # What holds, and the test that says so
//!
//! | invariant | test |
//! |---|---|
//! | the cantilever, K = 1 … 10: prototype to five digits, beam theory within 1.2 %, St Venant's solid within .7 %, Holden | `loaded_on_its_upper_face`, `loaded_through_its_volume`, `half_as_thick_it_is_holdens` (tests/cantilever.rs) |
//! | the paper's basis; half the step; the update to the letter; conditions on parameters | `with_the_basis_of_the_source` |
//! | pressure that follows: near the elastica; quadratic with the whole stiffness and not without | `a_pressure_that_follows`, `newton_is_quadratic_with_the_whole_load_stiffness` |
//! | the consistent tangent helps where the other fails | `a_step_that_fails_is_made_again_with_the_consistent_tangent` |
//! | thin plates, isotropic and orthotropic, to von Kármán's within .5 % | `an_isotropic_plate_with_immovable_edges`, `an_isotropic_plate_with_edges_that_move_along_their_normals`, `an_orthotropic_plate`, `the_basis_of_the_source_locks` (tests/plates.rs) |
//! | affine parameters: one stress everywhere, any nodes | `affine_parameters_give_the_same_stress_everywhere` (tests/patch.rs) |
//! | an affine boundary goes through but for the boundary between nodes; tractions, to the quadrature | `an_affine_displacement_of_the_boundary_goes_through`, `an_affine_displacement_is_left_by_the_boundary_between_nodes_and_by_the_quadrature` |
//! | one change of volume a cell: the same, derivatives of energy and forces, six zero modes; a cantilever and Cook's panel to ν = .4999 | `a_cantilever_bends_as_far_whatever_poissons_ratio`, `cooks_panel_is_sheared_as_far_as_by_finer_cells` and others (tests/volumes.rs) |
//! | a thick cylinder: Lamé's displacement and pressure for any Poisson's ratio; Hill's pressure by its elastic-plastic radius, its limit | `lames_cylinder_whatever_poissons_ratio`, `hills_cylinder_yields_from_within` (tests/cylinder.rs) |
//! | a body that yields: derivatives of forces, elastic bits below yield, the same bits for any number of threads, work stored or dissipated; from what was saved to the same bits | tests/plastic.rs; `a_body_that_yields_goes_on_to_the_same_bits` (tests/resumed.rs) |
//! | a half, a quarter, an eighth move as the whole | `a_part_behind_planes_moves_as_the_whole`, `between_two_planes_the_body_repeats` (tests/mirrors.rs) |
//! | what is taken up from a saved state goes on to the same bits | `a_march_goes_on_from_what_was_saved_to_the_same_bits` (tests/resumed.rs) |
//! | forces without sum and moment; six zero modes | `internal_forces_have_neither_sum_nor_moment`, `a_free_body_has_six_zero_modes` |
//! | a turned frame turns forces and leaves the energy | `a_turned_frame_turns_the_forces` |
//! | forces are the derivative of St Venant's energy, tangents of forces and loads | `forces_are_the_derivative_of_st_venants_energy`, `tangents_are_derivatives_of_the_forces` |
//! | any number of threads: the same bits | `threads_do_not_change_a_bit` |
//! | held nodes stand where the level has them; the load rate is a derivative | `an_end_that_is_moved_stands_where_the_level_has_it`, `the_load_rate_is_a_derivative` (tests/statics.rs) |
//! | reactions balance the loads and are the derivative of the energy | `reactions_balance_the_loads`, `the_force_of_a_moved_end_is_the_derivative_of_the_energy` |
//! | one solve a step, as the source | `one_solve_a_step_as_in_the_source` |
//! | arc length, modes, relaxation | `arc_length_and_load_control_meet`, `modes_of_a_beam`, `relaxation_finds_what_newton_finds` |
//! | states are kept and given up with their history | `states_are_kept_and_given_up_whole` |
//! | dependent conditions drop out, contradictions are refused; parameters leak | `conditions_that_say_the_same_drop_out_and_those_that_contradict_are_refused`, `fixed_parameters_leak` |
//! | what cannot be followed, turns too far, moves freely, or is bad input, is named | `what_cannot_be_followed_is_named`, `a_step_that_turns_too_far_is_refused`, `a_free_motion_is_named`, `bad_input_is_refused_with_value_and_repair` |

#![deny(clippy::print_stdout, clippy::print_stderr)]

mod assembly;
mod blocks;
mod body;
mod conduction;
mod discretisation;
mod error;
mod essential;
mod hardened;
mod heat;
mod images;
mod joined;
mod loads;
mod parts;
mod reactions;
mod reduction;
mod results;
mod statics;
mod steps;
mod stiffness;
mod sweep;
mod volumes;
mod warm;

pub use body::Galerkin;
pub use conduction::{Conduction, Gradients};
pub use error::GalerkinError;
pub use hardened::Hardened;
pub use images::Mirror;
pub use parts::{Condition, CutCells, Essential, Load, Parts, Volumes};
pub use reactions::Supports;
pub use results::PointResult;
pub use steps::{Step, lead};
