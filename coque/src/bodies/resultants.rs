//! What loads and supports amount to: force and moment of each, and the side on which pressure is positive.

use serde::{Deserialize, Serialize};

/// Forces reduced to a point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Resultant {
    /// Force \[F\].
    pub force: [f64; 3],
    /// Moment \[F L\].
    pub moment: [f64; 3],
}

/// The loads of a body at level one on its shape at rest, reduced to its centroid.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct LoadResultants {
    /// The area centroid, about which moments are taken \[L\].
    pub about: [f64; 3],
    /// To which side the normals point.
    pub normals: String,
    /// What each load is, and what it amounts to.
    pub loads: Vec<(String, Resultant)>,
}
