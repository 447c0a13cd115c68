//! The shape of a buckling mode as a deflection of the unstrained body.

use implicit_statics::{BucklingOptions, Prebuckling, Sign, linear_buckling, sign_of_greatest, unwatched};
use sph_core::Vec3;

use super::body::{StaticBody, extent};
use crate::bodies::refusal::body_error;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::bounded::Modes;
use crate::scene::error::SceneError;
use crate::scene::{Analysis, Buckling, Imperfection, Scene};

/// Part of the extent by which the largest entry of a mode moves the body while its shape is read; differences both ways leave
/// its square.
const READ: f64 = 1e-5;
/// Levels that differ by less have modes of which any sum is one.
const APART: f64 = 1e-6;

/// A deflection of the unstrained body.
pub(super) struct Deflection {
    /// Displacement of each particle \[L\].
    pub displacements: Vec<Vec3>,
    /// Change of its director \[–\]; none where bodies have none of their own.
    pub turns: Vec<Vec3>,
}

/// The scene whose buckling modes are looked for: loads and motions not in time.
pub(super) fn of_modes(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    scene.analysis = Analysis::Buckling(Buckling {
        modes: Modes::usual(1),
        sign: Default::default(),
        prebuckling: Default::default(),
    });
    scene.supports.iter_mut().for_each(|support| support.amplitude = None);
    scene.loads.iter_mut().for_each(|load| load.amplitude = None);
    scene.curve.clear();
    scene
}

/// The deflection by a mode of the perfect body; `read` gives positions and directors, `back` turns a vector into the axes
/// of the scene, in which its sign is defined.
///
/// # Errors
/// [`SceneError`] for a body that does not buckle in so many modes, and for one of two modes at one level.
pub(super) fn deflection<S: StaticBody>(
    scene: &BodyInScene<'_>,
    imperfection: &Imperfection,
    system: &mut S,
    read: impl Fn(&S) -> [Vec<Vec3>; 2],
    back: impl Fn(&Vec3) -> Vec3,
) -> Result<Deflection, SceneError> {
    let number = imperfection.mode.map_or(1, |mode| mode.get());
    let refused = |message: &str| body_error(scene, "imperfection.mode", message);
    let count = (number + 1).min(system.unknowns());
    let options = BucklingOptions { count, sign: Sign::Positive, prebuckling: Prebuckling::Rotations };
    let spectrum = linear_buckling(system, 0.0, &options, &mut unwatched).map_err(|cause| {
        refused(&format!(
            "the body has no buckling modes ({cause}); remove the imperfection, or load it in compression"
        ))
    })?;
    let levels: Vec<f64> = spectrum.modes.iter().map(|mode| mode.level).collect();
    let Some(mode) = spectrum.modes.get(number - 1) else {
        let found = levels.len();
        return Err(refused(&format!(
            "is {number}, but the body has {found} buckling modes; ask for one of these"
        )));
    };
    let same = |other: Option<usize>| {
        let other = other.and_then(|other| levels.get(other));
        other.is_some_and(|&other| (other / mode.level - 1.0).abs() < APART)
    };
    if same(Some(number)) || same(number.checked_sub(2)) {
        return Err(refused(&format!(
            "{number} has the level {:.6} of another mode, and any sum of the two is a mode; hold one of them by a plane of symmetry",
            mode.level
        )));
    }
    let rest = system.save();
    let extent = extent(&read(system)[0]);
    let mut at = |factor: f64| {
        let step: Vec<f64> = mode.shape.iter().map(|q| q * factor * READ * extent).collect();
        system.update(&step);
        let found = read(system);
        system.restore(&rest);
        found
    };
    let [ahead, behind] = [at(1.0), at(-1.0)];
    let [moved, turned] =
        [0, 1].map(|k| -> Vec<Vec3> { ahead[k].iter().zip(&behind[k]).map(|(a, b)| a - b).collect() });
    let largest = moved.iter().map(|u| u.norm()).fold(0.0, f64::max);
    let own: Vec<Vec3> = moved.iter().map(back).collect();
    let factor =
        imperfection.amplitude * sign_of_greatest(own.iter().flat_map(|u| [u.x, u.y, u.z])) / largest;
    let scaled = |list: Vec<Vec3>| list.into_iter().map(|u| u * factor).collect();
    Ok(Deflection { displacements: scaled(moved), turns: scaled(turned) })
}
