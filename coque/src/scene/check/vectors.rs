//! Vectors of as many numbers as a body has dimensions, and vectors that must lie in its plane.

use crate::scene::error::Verdict;
use crate::scene::scope::Scope;

impl Scope<'_> {
    /// As many numbers as there are dimensions, each of a size that arithmetic can hold.
    pub(super) fn coordinates(&self, path: &str, v: &[f64], dimensions: usize) -> Verdict {
        self.as_many(path, v, dimensions, "geometry.block.lengths")
    }

    /// As many numbers as another list has.
    pub(super) fn as_many(&self, path: &str, v: &[f64], dimensions: usize, other: &str) -> Verdict {
        if v.len() == dimensions {
            return self.sized_all(path, v);
        }
        let value = format!("a list of {} numbers", v.len());
        let repair = format!("give as many as `{other}` has");
        Err(self.value(path, value, &format!("a list of {dimensions}"), &repair))
    }

    /// A vector without a component across the plane of a plane block.
    pub(super) fn in_plane(&self, path: &str, v: [f64; 3], plane: bool) -> Verdict {
        if !plane || v[2] == 0.0 {
            return Ok(());
        }
        let repair = "set its third component to zero: nodes of a plane block move in it alone";
        Err(self.value(path, format!("{v:?}"), "in the plane of x and y", repair))
    }
}
