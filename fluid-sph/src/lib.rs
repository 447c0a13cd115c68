//! Weakly compressible fluids of SPH particles, their walls and wet boundaries, in a plane and in space from one code.
//!
//! Each particle carries a mass m = ρ₀Δxᵈ, a place r, a velocity v and a density ρ; a liquid ([`Liquid`]) gives its pressure.
//! With `r_ab = r_a − r_b`, `v_ab = v_a − v_b` and Wendland's kernel of support 2h \[wendland1995\], `∇W = F r_ab`:
//!
//! ```text
//! dρ_a/dt = Σ_b m F v_ab·r_ab  +  δ h c₀ Σ_b 2ψ_ab (−F r²)/(r² + η²) 2m/(ρ_a + ρ_b)
//! dv_a/dt = −Σ_b m (P_a/ρ_a² + P_b/ρ_b² + Π_ab) F r_ab  +  g
//! P = (ρ₀c₀²/7) [(ρ/ρ₀)⁷ − 1],   Π_ab = −α c̄ μ/ρ̄ − 4(d + 2) ν v_ab·r_ab/[(ρ_a + ρ_b) κh²],   μ = h min(v_ab·r_ab, 0)/(r² + η²)
//! ψ_ab = ρ_b − ρ_a − (ρ₀/c₀²) g·(r_b − r_a),   η² = 0.01 h²
//! ```
//!
//! \[monaghan1992, monaghan1994\] for the sums, \[cole1948\] for the state, \[molteni2009\] for the diffusion of density, which
//! runs between particles of the fluid only and is free of what gravity makes of the density, as in \[fourtakas2019\];
//! the term of ν is laminar friction along the line of centres (src/momentum.rs). Every expression of a pair is symmetric,
//! so that forces are opposite to the bit, and acts along r_ab, so that momentum and its moment are kept.
//!
//! Two sums over a lattice are wrong at any Δx, and choose h = 1.55 Δx. One is its modulus of shear under pressure, which makes
//! water a crystal: .109 P at h = 1.3 Δx in a plane, less than .012 P at 1.55 (src/lattice.rs). The other is `−Σ V F x²`, .974 at
//! 1.3 and .997 at 1.55: pressure gradients come out so much too small, and water at rest has one of ρg/0.974 instead.
//!
//! # Walls
//!
//! Particles of a [`Wall`] and points of a [`Structure`] have the mass of a particle and, by [`WallRule::Extrapolated`],
//! the pressure of the fluid beside them carried there by gravity \[adami2012\], never below zero unless the fluid is
//! confined; by [`WallRule::Dynamic`] a density of their own \[crespo2007\]. Artificial viscosity acts against them, so that
//! inviscid walls rub a little: without it the front of a falling column runs 12 % ahead of experiments, with it 4 to 8 %.
//! Laminar flow is held at the face: boundary velocities are mirrored, `2v_w − v` of the fluid beside, for friction.
//! Instruments at walls read the fluid's own mean ([`Fluid::wall_pressures`]), never the particles of the wall.
//!
//! A structure thinner than the kernel is wide tells its middle surface; by the side on which a particle of the fluid
//! is it sees the points of one face, and of the fluid its own side and what lies past a free edge.
//!
//! # The step
//!
//! [`Scheme::KickDriftKick`] fits central differences: forces at rⁿ with velocities of half a step before, rates of density
//! in the middle of the step, boundaries half a step of their mean velocities behind there. It asks for one sweep of forces
//! and one of rates. [`Scheme::PredictorCorrector`] takes the whole step in its drift.
//!
//! ```text
//! Δt ≤ courant · min(√(h/|a|), h/(c_a + max_b |h v_ab·r_ab/(r² + η²)|)),   Δt ≤ h²/(8ν),   Δt ≤ h/(4|v_boundary|)
//! ```
//!
//! # Energy
//!
//! Kinetic energy T, compression `U = Σ m ∫P/ρ² dρ`, losses D to friction and to the diffusion of density, and the work W of
//! gravity and of boundaries: that of their motion, and that of the pressure they have of themselves, which fluid that comes
//! nearer works against (src/boundary/points.rs). `T + U + D − W` is kept but for the step. Falling columns lose 0.5 % of
//! what they release at worst, water at rest 3·10⁻⁴ of its weight's half height in ten times √(H/g); of the work of a tank
//! that rolls for four periods 0.04 % is missing, of a cylinder that turns in viscous water 0.5 %.
//!
//! # The sweep
//!
//! Particles are sorted into cells as wide as the kernel reaches, those of one cell by their numbers; so sums depend on
//! places alone. All that stand in a cell and beside it are put side by side once, in single precision; each particle of the
//! cell holds eight of them at a time against a reach that is longer by what single precision may be wrong, lists those
//! within, and runs its pairs four at a time over the list. Chunks are of fixed size: the same bits for any number of
//! threads, and with AVX2 or without.
//!
//! # Periodic sides and currents
//!
//! [`Fluid::repeated`] makes sides of a box one ([`Periods`]). Before each sort particles within the reach of the kernel from such a side are given copies
//! beyond the opposite one, and so are points of walls: copies are among the neighbours, are not swept, and take velocities after a kick, pressures of
//! walls and drags from whom they copy (src/periods.rs). [`Fluid::carry`] draws the water of a zone to a velocity ([`Current`]).
//!
//! # Marched by several
//!
//! [`Fluid::share`] makes one of several who have built the same fluid (crate `peers`). Cells are owned by those who march it, along a curve through
//! those with particles, in parts of as many pairs that are looked at; particles belong to the owner of the cell in which they were
//! dealt out, until one may have gone half the reach of the kernel or a wall has (src/share/deal.rs). Each sweeps the particles that
//! he moves and those in his cells, and knows two rings of cells about them, three where there are walls. Velocities of what others
//! move come in after a kick, densities after a drift: 32 bytes a particle and step, 24 more with XSPH.
//!
//! What a step records is added plainly within a cell, in the order of its particles, and the cells exactly; of boundaries point by point.
//! That depends on places alone, so that all records have the bits of one who marches alone, who adds the same way. Whole arrays
//! are brought by [`Fluid::bring`]. Predictor and corrector are refused, so are walls of the published method.
//!
//! Structures are whole with each of them, who all march them with the same bits. A point belongs to the owner of the cell in which it
//! was dealt out, who brings the force on it to all: 24 bytes a point and step. What points resisted goes to the particles that each
//! moves; he knows all that such a point sees. Their velocities come in once more then, and work and speed are added and compared.
//! A structure is put into its next place within the drift, so that all can be dealt out anew before, where it was when forces were
//! found (src/boundary/settling.rs).
//!
//! # What holds, and the test that says so
//!
//! | invariant | test |
//! |---|---|
//! | forces sum to the weight less what walls bear; momentum is kept | `forces_sum_to_the_weight_and_what_walls_bear`, `a_block_that_flies_keeps_its_momentum` (tests/pairs.rs) |
//! | moments sum to those of the weight and of what walls bear | `moments_sum_to_the_weight_and_what_walls_bear` (tests/pairs.rs) |
//! | torques, profile and ledger of the flow between two cylinders | tests/couette.rs |
//! | a lattice under pressure hardly resists shear | src/lattice.rs |
//! | laminar friction hardly depends on the direction of a lattice | src/momentum.rs |
//! | the same bits for 1, 2 and 4 threads, and after a resume; no step allocates | tests/threads.rs |
//! | the same bits for one to seven who march together: motion, works, records, gauges, refusals | tests/shared/ |
//! | the same with structures: two clocks in both orders, structures that go far, states taken up | tests/coupled |
//! | a flow turned or mirrored is the same | `quarters_and_mirrors` (tests/turned.rs) |
//! | water at rest is hydrostatic and stays at rest | `in_a_plane`, `in_space` (tests/water.rs) |
//! | the axes of a drop are those of an ideal fluid | `in_a_plane`, `in_space` (tests/drop.rs) |
//! | the front of a falling column, and its energy | tests/dam.rs |
//! | walls hand over impulses and work; laminar flow decays as its mode | tests/moving_walls.rs |
//! | a closed fluid gains of a compression what walls leave that give way as layers of it, .57 h thick | tests/closed.rs |
//! | each face of a thin plate bears its own water; past its edge both sides meet | tests/thin.rs |
//! | instruments read what is known; bad parts are refused; what leaves its bounds is named | tests/gauges.rs |
//! | a flux sums up to what has passed; moments are those of the forces | tests/flux.rs |
//! | through periodic sides momentum is kept, uniform states stay so, flows and waves are as their closed forms | tests/periodic.rs |
//! | a zone keeps the water going, its work is counted | tests/current.rs |
//! | the kernel is one in sum, its factor its slope; the state has its sound and energy | src/kernel.rs, src/liquid.rs |
//! | sums by cells do not depend on who adds them | src/books.rs |
//! | cells beside each other and single precision hold all neighbours; chunks are the same for any threads | src/cells.rs, crate `parallel` |
#![warn(missing_docs)]

mod beach;
mod books;
mod boundary;
mod cells;
mod continuity;
mod current;
mod driven;
mod energies;
mod error;
mod fluid;
mod flux;
mod formulation;
mod gauges;
mod impulses;
mod kept;
mod kernel;
mod lattice;
mod ledger;
mod liquid;
mod momentum;
mod neighbours;
mod opened;
mod openings;
mod overlap;
mod pair;
mod parts;
mod periods;
mod round;
mod share;
mod sharing;
mod sorted;
mod spectrum;
mod start;
mod state;
mod still;
mod sweeps;
mod time;
mod transport;
mod walls;
mod waves;

pub use beach::Beach;
pub use current::Current;
pub use energies::Energies;
pub use error::FluidError;
pub use fluid::Fluid;
pub use flux::Section;
pub use formulation::{Formulation, Scheme, WallRule};
pub use lattice::lattice_moduli;
pub use liquid::Liquid;
pub use openings::{Given, Opening};
pub use parts::{Course, Motion, Parts, Rotation, Start, Structure, Wall};
pub use periods::Periods;
pub use spectrum::{Component, Spectrum, way_of_wall};
pub use still::{Screen, StillError, StillParts, StillWater, WetSite};
pub use waves::Waves;
