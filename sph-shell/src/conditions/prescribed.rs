//! What supports prescribe: displacements and rotations of directors, by load level and time.

use explicit_dynamics::{Amplitude, Instant};
use sph_core::Vec3;

use crate::conditions::case::LoadCase;
use crate::conditions::turn::{Turn, rotated};

/// A prescribed displacement.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// Displacement at load level one and amplitude one \[L\].
    pub displacement: Vec3,
    /// Its course in time.
    pub amplitude: Amplitude,
    /// What a preload adds to it, in full \[L\].
    pub preload: Option<Vec3>,
    /// A turn about an axis that comes on top.
    pub turn: Option<Turn>,
}

/// A prescribed rotation of a director: `d = R(axis, angle) D`, D its direction at rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Rotation {
    /// Axis, a unit vector.
    pub axis: Vec3,
    /// Angle at load level one and amplitude one \[rad\].
    pub angle: f64,
    /// Its course in time.
    pub amplitude: Amplitude,
    /// The load case to which it belongs.
    pub case: LoadCase,
}

impl Motion {
    /// A displacement \[L\] with its course in time.
    pub(crate) fn by(displacement: Vec3, amplitude: Amplitude) -> Self {
        Self { displacement, amplitude, preload: None, turn: None }
    }

    /// The same motion as one of the preload.
    pub(crate) fn preloaded(self) -> Self {
        let turn = self.turn.map(|turn| Turn { case: LoadCase::Preload, ..turn });
        Self { displacement: Vec3::zeros(), preload: Some(self.displacement), turn, ..self }
    }

    /// Both at once, where their courses agree.
    pub(crate) fn joined(self, other: &Self) -> Option<Self> {
        let preload = match (self.preload, other.preload) {
            (Some(one), Some(two)) => Some(one + two),
            (one, two) => one.or(two),
        };
        let displacement = self.displacement + other.displacement;
        let turn = self.turn.or(other.turn);
        let agree = self.amplitude == other.amplitude && !(self.turn.is_some() && other.turn.is_some());
        agree.then_some(Self { displacement, preload, turn, ..self })
    }

    /// Where it leads a particle with a position at rest, by the loading, by the preload and by a turn \[L\].
    pub(crate) fn parts(&self, rest: &Vec3) -> impl Iterator<Item = Vec3> {
        let [along, across] = self.turn.map_or([None, None], |turn| turn.ways(rest).map(Some));
        [Some(self.displacement), self.preload, along, across].into_iter().flatten()
    }

    /// Displacement of a particle with a position at rest, at an instant of the case that is under way \[L\].
    pub(crate) fn at(&self, rest: &Vec3, at: Instant, under_way: LoadCase) -> Vec3 {
        let course = self.amplitude.value(at.time);
        let part = |case: LoadCase| case.factor(under_way, at.level) * course;
        let mut sum = self.displacement * part(LoadCase::Loading);
        if let Some(preload) = self.preload {
            sum += preload * part(LoadCase::Preload);
        }
        if let Some(turn) = &self.turn {
            sum += turn.displacement(rest, part(turn.case));
        }
        sum
    }

    /// Its derivative with respect to the level of the case that is under way, without time \[L\].
    pub(super) fn rate(&self, rest: &Vec3, level: f64, under_way: LoadCase) -> Vec3 {
        let course = self.amplitude.value(0.0);
        let moving = match under_way {
            LoadCase::Preload => self.preload.unwrap_or_default(),
            LoadCase::Loading => self.displacement,
        };
        let turn = self.turn.filter(|turn| turn.case == under_way);
        turn.map_or(moving, |turn| moving + turn.rate(rest, level * course)) * course
    }

    /// Mean velocity of a particle with a position at rest between two instants \[L/T\].
    pub(crate) fn velocity(&self, rest: &Vec3, from: Instant, to: Instant) -> [f64; 3] {
        if self.turn.is_some() {
            let place = |at: Instant| self.at(rest, at, LoadCase::Loading);
            return ((place(to) - place(from)) / (to.time - from.time)).into();
        }
        let place = |at: Instant| at.level * self.amplitude.value(at.time);
        let rate = (place(to) - place(from)) / (to.time - from.time);
        (self.displacement * rate).into()
    }
}

impl Rotation {
    /// The director at an instant of the case that is under way, by Rodrigues' formula, from its direction at rest.
    pub(crate) fn at(&self, rest: &Vec3, at: Instant, under_way: LoadCase) -> Vec3 {
        let level = self.case.factor(under_way, at.level);
        rotated(&self.axis, self.angle * level * self.amplitude.value(at.time), rest)
    }

    /// Mean spin between two instants \[1/T\].
    pub(crate) fn spin(&self, from: Instant, to: Instant) -> Vec3 {
        let angle = |at: Instant| self.angle * at.level * self.amplitude.value(at.time);
        self.axis * ((angle(to) - angle(from)) / (to.time - from.time))
    }

    /// Rate that carries the director `d` along a great circle to where it stands at `to`, in the time from `from` \[1/T\].
    pub(crate) fn rate(&self, rest: &Vec3, d: &Vec3, from: Instant, to: Instant) -> [f64; 3] {
        let target = self.at(rest, to, LoadCase::Loading);
        let cos = d.dot(&target);
        let across = target - d * cos;
        let sin = across.norm();
        if sin == 0.0 {
            return [0.0; 3];
        }
        (across * (libm::atan2(sin, cos) / (sin * (to.time - from.time)))).into()
    }
}
