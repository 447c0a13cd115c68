//! Whether a boundary fits its layout.

use explicit_dynamics::{BoundaryLayout, BoundaryState};

use crate::error::FluidError;

/// Refuses lists of other lengths than those of the layout, and what is no number.
pub(crate) fn check(
    structure: usize,
    layout: &BoundaryLayout,
    state: &BoundaryState,
) -> Result<(), FluidError> {
    let same = |what, found: usize, expected: usize| {
        let good = found == expected;
        if good { Ok(()) } else { Err(FluidError::Boundary { structure, what, found, expected }) }
    };
    same("areas", layout.areas.len(), layout.points)?;
    same("points", state.points.len(), layout.points)?;
    let middle = layout.thin.as_ref().map_or(0, |thin| thin.edges.len());
    same("middle", state.middle.len(), middle)?;
    same("normals", state.normals.len(), middle)?;
    if let Some(thin) = &layout.thin {
        same("faces", thin.faces.len(), layout.points)?;
        let value = thin.thickness;
        if !(value > 0.0 && value.is_finite()) {
            return Err(FluidError::Option { key: "thickness", value, bound: "positive and finite" });
        }
    }
    for (what, list) in
        [("boundary point", &state.points), ("middle place", &state.middle), ("normal", &state.normals)]
    {
        if let Some(index) = list.iter().position(|place| !place.iter().all(|x| x.is_finite())) {
            return Err(FluidError::NotFinite { what, index });
        }
    }
    Ok(())
}
