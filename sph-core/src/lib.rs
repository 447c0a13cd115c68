//! Space: particles on a surface, their neighbours, and gradients that are exact where they promise to be.
//!
//! A [`Cloud`] is the immutable reference geometry; a [`SamplingOperator`] turns nodal fields of that cloud into values
//! and surface gradients at sampling points, and its transpose turns point quantities into nodal sums. There is no
//! mechanics and no time in this crate.
//!
//! ```
//! use sph_core::{EndWeights, Plate, cell_operator, lattice};
//! let plate = Plate { lengths: [2.0, 1.0] };
//! let cloud = lattice(&plate, [21, 11], EndWeights::Trapezoid)?;
//! let operator = cell_operator(&cloud)?;
//! let height: Vec<f64> = cloud.positions.iter().map(|x| 3.0 * x.x - x.y).collect();
//! let slope = operator.gradient(&height);
//! assert!(slope.iter().all(|g| (g[0] - 3.0).abs() < 1e-12 && (g[1] + 1.0).abs() < 1e-12));
//! # Ok::<(), sph_core::SpaceError>(())
//! ```
//!
//! # Sampling and its transpose
//!
//! A sampling point p has a position, a frame t₁ t₂ n and an area w_p; its stencil is a list of particles b with three
//! numbers each. The rest of the workspace sees particles through these sums:
//!
//! ```text
//! f(p)   = Σ_b φ_b f_b                                 SamplingOperator::value
//! f,α(p) = Σ_b G_αb f_b                                SamplingOperator::gradient
//! F_b    = Σ_p w_p (φ_b q + G₁_b n₁ + G₂_b n₂)         SamplingOperator::gather
//! ```
//!
//! The third is the transpose of the first two under the weights: `Σ_b F_b f_b = Σ_p w_p (q f + n₁ f,₁ + n₂ f,₂)` for
//! any field f and any q, n₁, n₂. Forces built with it are the derivative of an energy sampled with the others. Frames
//! belong to the reference surface; [`SamplingOperator::align`] rotates them until t₁ follows a material axis, and leaves
//! the gradients as vectors of space what they are.
//!
//! # Kernels
//!
//! `W(r, h) = w(q)/h²` with `q = r/h` and `∫ w(q) 2πq dq = 1` on the surface, behind the trait [`Kernel`]:
//!
//! ```text
//! CubicSpline      10/(7π)   · { 1 − 3q²/2 + 3q³/4 | q < 1 ;  (2−q)³/4 | q < 2 }
//! WendlandC2        7/(4π)   · (1−q/2)⁴ (1+2q)
//! WendlandC4        9/(4π)   · (1−q/2)⁶ (1+3q+35q²/12)
//! QuinticSpline     7/(478π) · [(3−q)⁵₊ − 6(2−q)⁵₊ + 15(1−q)⁵₊]
//! ```
//!
//! from \[monaghan1985\], \[wendland1995\] (two) and \[morris1997\]. Plain SPH sums \[gingold1977\] differentiate
//! nothing exactly near an edge or in disorder: every operator below corrects them.
//!
//! # Three operators
//!
//! ξ_b, η_b are coordinates of particle b from the point, along t₁ and t₂ of the point.
//!
//! **Cells**, [`cell_operator`]: one point at the area centroid of each quadrangle or triangle; the stencil is its m
//! corners, counter-clockwise. With `A = ½Σ(ξ_b η_{b+1} − ξ_{b+1} η_b)`
//!
//! ```text
//! G₁_b = (η_{b+1} − η_{b−1})/2A      G₂_b = −(ξ_{b+1} − ξ_{b−1})/2A
//! φ_b  = 1/m + B_bᵀ(BBᵀ)⁻¹[(1,0,0)ᵀ − (1/m)Σ_c B_c],     B_b = (1, ξ_b, η_b)ᵀ
//! ```
//!
//! G is the mean gradient over the cell: the uniform-gradient quadrilateral \[flanagan1981\]. One point does not see
//! the pattern (1, −1, 1, −1); what holds that is the business of `sph-shell`.
//!
//! **Corrected kernels at the cells**, [`kernel_operator`]: moving least squares of order one \[belytschko1996\],
//! [`LinearlyExact`], over the particles within `reach · r₄`, r₄ the distance to the fourth nearest:
//!
//! ```text
//! p_b = (1, ξ_b/h, η_b/h)     𝓜 = Σ_b W_b p_b p_bᵀ
//! φ_b = W_b e₁ᵀ𝓜⁻¹p_b        G₁_b = W_b e₂ᵀ𝓜⁻¹p_b / h        G₂_b = W_b e₃ᵀ𝓜⁻¹p_b / h
//! ```
//!
//! **Least squares at the particles**, [`nodal_operator`] with [`ThroughParticle`]: `f_b − f_a ≈` a polynomial of order
//! 1, 2 or 3 without constant, with weights `W A_b`; order 1 takes `−W′A_b/r`, the corrective smoothed particle method
//! \[chen1999\] in its symmetric form. Particles on an edge get order 2 at most. Smoothing lengths follow the local
//! spacing.
//!
//! Supports grow by 1.1 until the moment matrix has a condition number below 1e7 ([`Correction::shape`]); the order
//! each point reached stands in [`SamplingOperator::orders`].
//!
//! # Divergence consistency
//!
//! A constant stress is in equilibrium only if its nodal sums are the edge tractions. With the edge normals r_b
//! (outward normal of the edge at b times its tributary length, zero inside: [`Cloud::edge_normals`]) that asks of
//! every particle b and its tangents T₁, T₂
//!
//! ```text
//! T_βb · Σ_p w_p (G₁_b t₁ + G₂_b t₂) = T_βb · r_b
//! ```
//!
//! the discrete divergence theorem, known as the integration constraint of meshless methods \[chen2001\].
//! [`cell_operator`] obeys it on any flat cloud. The two others are changed by [`make_divergence_consistent`], which
//! takes the least `Σ δG²/ω`, ω the kernel weight of an entry, among all changes that leave rows exact on polynomials
//! up to their order:
//!
//! ```text
//! (C Q Cᵀ + ε) λ = residual     δG = Q Cᵀλ     Q = Ω − ΩBᵀ(BΩBᵀ)⁺BΩ   (per point)
//! ```
//!
//! solved by conjugate gradients: C are the conditions above, Ω the weights ω, B the polynomials at the stencil, ε a
//! regularisation of 1e-9 of the mean diagonal. On curved clouds, and where areas do not integrate the polynomials that
//! the rows keep, the conditions contradict each other; what remains is in [`ConsistencyReport`].
//!
//! # Clouds
//!
//! | cloud | made by | areas A_a |
//! |---|---|---|
//! | rows and columns | [`lattice`] on a [`Patch`]: [`Plate`], [`Cylinder`], [`Sphere`], [`Twisted`], [`Parametric`] | end weights × Jacobian: trapezoid or Gregory ([`EndWeights`], \[davis1984\]) |
//! | disorder; growing spacings | [`jittered_lattice`]; on a [`Graded`] patch | `Σ_cells w_p/m` |
//! | no lattice | [`poisson_cloud`]: dart throwing \[bridson2007\] with the random numbers of \[steele2014\] | the same |
//! | any cells, a mesh | [`Cloud::from_cells`]; triangles joined by [`pair_triangles`] | the same |
//!
//! Scattered particles are triangulated in the parameter plane, flipped until Delaunay by their angles in space
//! \[lawson1977\] and joined to quadrangles: best corners first, then exchanged along alternating paths, since a
//! triangle has one sampling point for half the area and many of them lock. [`Cloud::check`] refuses what no operator
//! can be built on, with particle or cell, value, bound and repair ([`SpaceError`]).
//!
//! # Blocks
//!
//! A [`Block`] is the nodes of a solid, each with a volume and, at the border of the box, with its share of the faces. A
//! [`BlockLattice`] places them, [`Block::without`] cuts holes. A [`ClosedSurface`] is filled with nodes whose volumes it cuts, and [`spread`] makes
//! forces on it forces on them.
//!
//! # Walls
//!
//! Walls of fluids are rows of particles outside the fluid, the first half a spacing behind the face: [`basin_rows`] round
//! a box, [`block_rows`] in an obstacle, [`polyline_rows`] in the plane, [`surface_rows`] behind triangles in space. Rows
//! are the lines or surfaces at a distance from the face; corners are closed, no two particles are nearer than half a
//! spacing, and [`leaks`] counts gaps.
//!
//! [`MovingLeastSquares`] gives shape functions on nodes in space, with exact gradients, that reproduce a [`Basis`]; [`Hexahedra`] are the
//! background cells with Gauss points, over which a method without elements integrates.
//!
//! # What holds, and the test that says so
//!
//! | invariant | test |
//! |---|---|
//! | values and gradients exact on constant and linear fields | `constants_and_linear_fields_are_exact` (tests/operators.rs) |
//! | nodal gradients exact up to the order they report | `nodal_gradients_are_exact_up_to_the_order_they_report` |
//! | `gather` is the transpose | `gather_is_the_transpose_of_value_and_gradient` |
//! | rigid motion leaves φ and G | `rigid_motion_leaves_the_numbers` |
//! | rotated frames: the same gradients in space | `aligned_frames_keep_gradients_in_space` |
//! | cells: a constant flux sums to the edge normals | `cells_sum_a_constant_flux_to_the_edge_normals` |
//! | kernels and nodal stencils do once changed, rows kept | `kernel_stencils_become_consistent_on_flat_clouds`, `nodal_stencils_become_consistent_on_flat_clouds` (tests/consistency.rs) |
//! | on four corners the consistent kernel *is* the cell operator | `the_consistent_operator_on_the_corners_of_a_cell_is_the_cell_operator` |
//! | flat clouds: `Σ r·X = 2ΣA`, `Σ r = 0` | `flat_clouds_obey_the_divergence_theorem` (tests/clouds.rs) |
//! | kernels: integral one, slope the derivative, smooth end | `every_kernel_integrates_to_one`, `every_slope_is_the_derivative_of_the_value`, `every_kernel_falls_smoothly_to_zero_at_its_support` (src/kernel.rs) |
//! | the same seed, the same cloud | `the_same_seed_gives_the_same_cloud_and_neighbours_have_near_numbers` (tests/scattered.rs) |
//! | volumes of a block sum to its box, shares of a face to its area | `volumes_and_faces_sum_to_those_of_the_box` (tests/blocks.rs) |
//! | nodes in a surface: its volume, centroid and area, wherever it lies in the lattice | `volume_centroid_and_area_are_those_of_the_surface` and its neighbours (tests/enclosed.rs) |
//! | forces on it keep resultant, moment and work | `forces_on_the_surface_keep_their_resultant_moment_and_work` |
//! | fluid in a basin has the neighbours of an endless lattice | `fluid_in_a_closed_basin_has_the_neighbours_of_an_endless_lattice` (tests/walls.rs) |
//! | walls are closed at corners of any angle, no two particles too near | `corners_of_any_angle_are_closed_outside`, `round_any_star_of_fluid_the_wall_is_closed` |
//! | surfaces: no hole, one particle for each square of the spacing | `the_row_behind_a_face_has_no_hole`, `a_box_of_triangles_is_closed_outside_and_inside` (tests/surface_walls.rs) |
//! | moving least squares reproduce their basis and its gradient; gradients are derivatives | `shape_functions_reproduce_their_basis_and_its_gradient`, `gradients_are_the_derivatives_of_the_values` (tests/least_squares.rs) |
//! | hexahedra integrate to the degree of their rule; faces close | `hexahedra_integrate_volumes_and_areas` |
//! | what is refused names its place | `wrong_clouds_are_refused_with_the_place` and its neighbours (tests/clouds.rs) |

#![deny(clippy::print_stdout, clippy::print_stderr)]

mod block;
mod error;
mod held_directions;
mod kernel;
mod neighbours;
mod random;
mod rotation;
mod sampling;
mod surface;
mod walls;

pub use block::{Block, BlockLattice, CutOut, NodePlaces};
pub use block::{Carried, ClosedSurface, Facet, Filled, FilledCells, Spread, SurfaceFault, by_node, spread};
pub use block::{FacePoint, Hexahedra, HexahedraError, VolumePoint};
pub use error::SpaceError;
pub use held_directions::HeldDirections;
pub use kernel::{CubicSpline, Kernel, QuinticSpline, WendlandC2, WendlandC4, kernel, kernels};
pub use neighbours::CellList;
pub use rotation::rotated;
pub use sampling::cell_stencil::cell_operator;
pub use sampling::consistent::{ConsistencyReport, make_divergence_consistent};
pub use sampling::correction::{
    Correction, LinearlyExact, Neighbourhood, Shape, ThroughParticle, corrections,
};
pub use sampling::kernel_operator::kernel_operator;
pub use sampling::moving_least_squares::{
    Basis, MovingLeastSquares, PointShape, ShapeError, Support, Weight,
};
pub use sampling::nodal_operator::nodal_operator;
pub use sampling::operator::{SamplingOperator, SamplingPoint, Stencil};
pub use sampling::spin::{fitted_spins, follow_turn};
pub use surface::cell::{Cell, CellGeometry};
pub use surface::cloud::Cloud;
pub use surface::frame::Frame;
pub use surface::graded::Graded;
pub use surface::jitter::jittered_lattice;
pub use surface::lattice::{EndWeights, lattice};
pub use surface::numbering::Lattice;
pub use surface::pairing::pair_triangles;
pub use surface::patch::{Cylinder, Parametric, Patch, Plate, Sphere, Twisted};
pub use surface::poisson::poisson_cloud;
pub use surface::sides::{Side, Sides};
pub use walls::{LineSide, basin_rows, block_rows, leaks, polyline_first_row, polyline_rows};
pub use walls::{surface_first_row, surface_rows};

/// A point or vector of space; positions are in `[L]`.
pub type Vec3 = nalgebra::Vector3<f64>;
