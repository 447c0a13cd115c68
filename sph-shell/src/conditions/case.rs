//! Load cases: a preload that is applied first and then held, and the loads of the analysis that goes on from there.
//!
//! A static shell is under one case at a time, and the level counts that one:
//!
//! | under way | preloads and preloaded motions | all others |
//! |---|---|---|
//! | [`LoadCase::Preload`] | level | 0 |
//! | [`LoadCase::Loading`], the usual | 1 | level |
//!
//! Follower preloads keep their stiffness in the tangent; the load rate is that of the case under way alone. Without a preload
//! the second row is all there is.

/// To which load case a load or a prescribed motion belongs, and which of them is under way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LoadCase {
    /// Applied first, in full, and held from then on.
    Preload,
    /// What the level of the analysis counts.
    #[default]
    Loading,
}

impl LoadCase {
    /// Factor of what belongs to this case at a level of the case that is under way \[–\].
    pub(crate) fn factor(self, under_way: Self, level: f64) -> f64 {
        match (self, under_way) {
            (Self::Preload, Self::Loading) => 1.0,
            (Self::Loading, Self::Preload) => 0.0,
            _ => level,
        }
    }
}
