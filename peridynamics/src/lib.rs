//! Peridynamic solids \[silling2000\]: nodes joined by bonds that break.
//!
//! Each node owns a volume V and has a **family**: the nodes within a horizon δ at the start. A bond ξ of length r has the
//! extension `e = |ξ + η| − r`. One energy serves two and three dimensions (\[silling2007\], with the dilatation left to
//! the bonds' own share where λ = μ, which is PMB \[silling2005\]):
//!
//! ```text
//! θᵢ = (d/mᵢ) Σⱼ w r e V̄ⱼ          mᵢ = Σⱼ w r² V̄ⱼ          V̄ the partial volume inside the horizon
//! U  = Σᵢ Vᵢ [ ½(λ − μ) θᵢ² + ½ d(d+2) (μ/mᵢ) Σⱼ w e² V̄ⱼ ]
//! ```
//!
//! Bonds of a state-based solid may yield ([`Plastic`]): each end of a bond has a plastic extension, and von Mises' stress of a node
//! is that of its family.
//!
//! A thin plate is two networks in plane stress on directors, with transverse shear between columns ([`Sheets`]).
//!
//! Several may march a solid together ([`Solid::share`]), each the nodes of its share, to the bits of one who marches it alone.
//!
//! In a fluid ([`Solid::wet`]) the nodes are the points of the boundary; damage changes nothing of that.
#![warn(missing_docs)]

mod bonds;
mod conditions;
mod conduction;
mod constraint;
mod contact;
mod cracks;
mod error;
mod exerted;
mod following;
mod formulation;
mod fracture;
mod heat;
mod material;
mod mirror;
mod parts;
mod plastic;
mod readings;
mod share;
mod sharing;
mod sheets;
mod solid;
mod statics;
mod time;
mod unknowns;
mod warm;
mod wetted;

pub use conditions::{AppliedLoad, Support, Supported};
pub use contact::Contact;
pub use error::SolidError;
pub use following::FollowingPressure;
pub use formulation::{Correction, Formulation, Influence, Law, Volumes};
pub use fracture::{Crack, Criterion, Fracture};
pub use material::{Elastic, Moduli, Space};
pub use mirror::Mirror;
pub use parts::{Idealisation, Parts, Sheets};
pub use plastic::Plastic;
pub use solid::Solid;
pub use statics::StaticSolid;
