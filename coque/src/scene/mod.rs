//! A scene: a problem as plain, validated data.

mod absent;
mod amount;
mod analysis;
mod analysis_kind;
pub(crate) mod body_in_scene;
pub mod bounded;
mod cases;
pub(crate) mod catalogue;
mod check;
mod checked;
mod column_names;
mod column_unit;
mod combination;
mod compatibility;
mod contact;
mod coupling;
mod criterion;
mod curve;
pub(crate) mod error;
mod expression;
pub(crate) mod fluid;
mod forms;
mod glue;
pub(crate) mod glued;
mod harmonic;
mod heat;
mod imperfection;
mod includes;
pub(crate) mod joints;
mod levels;
pub(crate) mod linked;
mod links;
mod lists;
mod loads;
mod measured;
mod nearest;
mod output;
mod overrides;
pub(crate) mod owner;
mod parameters;
mod per_axis;
mod problem;
mod random_vibration;
mod record;
mod records;
pub(crate) mod reference;
pub(crate) mod render;
mod response_spectrum;
mod rigid;
mod rigid_joints;
pub(crate) mod schema;
pub(crate) mod scope;
pub(crate) mod sets;
mod shaken_base;
mod shell;
pub(crate) mod solid;
pub(crate) mod source;
mod statics;
mod supports;
mod tables;
mod through;
mod tools;
mod touched_walls;
pub(crate) mod units;
mod velocity;
mod walls;
mod waves;

pub use analysis::{Analysis, Damping, Explicit, MovingBase, QuasiStatic, Transient};
pub use analysis_kind::{ANALYSES, AnalysisKind, Contacts};
pub(crate) use cases::CASE;
pub use cases::LoadSet;
pub use checked::Checked;
pub(crate) use column_names::{mean_of, phase_of};
pub use combination::Combination;
pub use contact::ContactScene;
pub use coupling::{Coupling, CouplingOrder};
pub use criterion::{Criterion, PlyComponent, ShellFace};
pub use curve::{Measured, Probe, Take};
pub use explicit_dynamics::Amplitude;
pub use fluid::current::Current;
pub use fluid::formulation::{FluidFormulation, FluidMethod, FluidStart, WallMethod, WeaklyCompressible};
pub use fluid::geometry::{Annulus, Disc, FluidBlock, FluidBlocks, FluidBox, FluidGeometry};
pub use fluid::openings::FluidOpening;
pub use fluid::periodic::PeriodicSides;
pub use fluid::{FluidMaterial, FluidScene, Liquid};
pub use glue::{Followed, GlueScene};
pub use harmonic::{
    BaseResponse, Frequencies, FrequencyRange, FrequencySpacing, Harmonic, RayleighDamping, ShakenBase,
    VibrationDamping,
};
pub(crate) use heat::count as faces_count;
pub use heat::{Conducted, Film, HeatScene, RadiationScene};
pub use imperfection::Imperfection;
pub use levels::Levels;
pub use links::{LinkScene, Side};
pub use loads::{Axis, Couple, Force, Gas, Gravity, Load, LoadKind, Pressure, Temperature, Traction, Volume};
pub use output::{ErrorBars, ErrorProbe, Fields, Output, Plot};
pub use per_axis::PerAxis;
pub use problem::{BodyScene, Scene};
pub use random_vibration::{NoisyBase, NoisyLoads, RandomVibration};
pub use record::{Baseline, ColumnOfFile, Record};
pub use response_spectrum::{DampedSpectrum, SpectrumAnalysis, SpectrumBase};
pub use rigid::{Coat, RigidBall, RigidBox, RigidGeometry, RigidScene};
pub use rigid_joints::{AlongAxis, BallJoint, JointScene};
pub use sets::{Box3, Layer, Near, OnPlane, Region};
pub use shell::ShellScene;
pub use shell::by_temperature::ByTemperature;
pub use shell::formulation::{Formulation, Nodal, Reach, StressPoint, StrongForm};
pub use shell::geometry::{
    Cylinder, Disorder, Geometry, Orientation, Placed, Placing, Plate, Scattered, Sphere, Twisted,
};
pub use shell::initial_stress::InitialStress;
pub use shell::material::{Elastic, Material, OfFile, Orthotropic};
pub use shell::mesh::Mesh;
pub use shell::parts::{LumpedMass, PartFormulation, PartStressPoint, RigidBody, ShellPart, ShellTie};
pub use shell::plastic::{
    Anisotropy, BackStress, CowperSymonds, Hardening, JohnsonCook, Linear as LinearHardening, Plastic, Rate,
    Swift, Voce,
};
pub use shell::plies::{Layered, Ply};
pub use shell::rubber::{MooneyRivlin, NeoHooke, Rubber, RubberLaw};
pub(crate) use shell::section::MaterialSection;
pub use shell::section::{Homogeneous, Section, Taper, ThicknessTable};
pub use shell::stiffeners::{
    StiffenerElastic, StiffenerInSurface, StiffenerMaterial, StiffenerProfile, StiffenerRectangle,
    StiffenerScene, StiffenerSection, StiffenerSide,
};
pub use shell::strength::FibreStrength;
pub use solid::SolidScene;
pub use solid::formulation::{Bonds, Correction, Influence, Plane, SolidFormulation, TwoSheets};
pub use solid::fracture::{BondMeasure, Contact, Crack, Fracture, Stretches, Wall};
pub use solid::galerkin::{
    Across, Galerkin, GalerkinBasis, GalerkinEssential, GalerkinLaw, GalerkinSupport, GalerkinTangent,
    GalerkinUpdate, GalerkinVolumes,
};
pub use solid::geometry::{
    Arc, Ball, Block, Cuboid, CutOut, FilledSurface, NodeDisorder, NodePlaces, Polygon, RoundHole,
    SolidGeometry,
};
pub use solid::material::{OrthotropicSolid, SolidMaterial};
pub use sph_core::LineSide;
pub use sph_shell::{Divergence, WetFaces};
pub use statics::{
    ArcLength, Branches, Buckling, Heat, HeatInTime, LevelSign, Linear, LinearSolver, Modal, Prebuckling,
    Relaxation, RelaxationDamping, Static, Stop,
};
pub use supports::*;
pub use through::Through;
pub use tools::{ToolBlock, ToolCapsule, ToolCylinder, ToolPlane, ToolScene, ToolSphere};
pub use velocity::{Spin, Velocity};
pub use walls::{
    Basin, Obstacle, Polyline, WallGeometry, WallMotion, WallRotation, WallSurface, WallTranslation,
    WallsScene,
};
pub use waves::{Beach, SpectrumShape, WallWaves, WaveSpectrum};
