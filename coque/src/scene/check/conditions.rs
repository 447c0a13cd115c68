//! Checks of supports and loads that need no particles.

use crate::scene::amplitude::Amplitude;
use crate::scene::error::SceneError;
use crate::scene::loads::{Axis, Load, LoadKind};
use crate::scene::problem::Scene;
use crate::scene::sets::EDGES;
use crate::scene::supports::{Held, Spring, Support, SupportKind};
use sph_core::Vec3;

/// Directions this close to the span of others are the same but for rounding or a slip.
const PARALLEL: f64 = 1e-6;

type Checked = Result<(), SceneError>;

impl Scene {
    pub(super) fn check_support(&self, at: &str, support: &Support) -> Checked {
        let s = &self.scope();
        self.check_unsupported(at)?;
        self.check_set_name(&format!("{at}.on"), &support.on)?;
        let kinds = support.kinds();
        let given: Vec<&str> = kinds.iter().map(|(word, _)| *word).collect();
        s.exactly_one(at, "condition", &given, &Support::WORDS)?;
        if let Some(solid) = self.as_solid() {
            self.check_solid_support(at, support, solid)?;
        }
        if support.amplitude.is_some() && support.motion().is_none() {
            let repair = "remove it: only `moved`, `rotated` and `turned` have a course in time";
            let fault = s.fault(&format!("{at}.amplitude"), "a course in time", "none here", repair);
            return Err(SceneError::Choice(fault));
        }
        for (_, kind) in kinds {
            match kind {
                SupportKind::Clamped | SupportKind::Hinged => {}
                SupportKind::Symmetry(plane) => {
                    s.direction(&format!("{at}.symmetry.normal"), plane.normal)?
                }
                SupportKind::Diaphragm(plane) => s.direction(&format!("{at}.diaphragm.axis"), plane.axis)?,
                SupportKind::Held(held) => self.check_held(&format!("{at}.held"), &held)?,
                SupportKind::Moved(moved) => {
                    s.direction(&format!("{at}.moved.direction"), moved.direction)?;
                    s.sized(&format!("{at}.moved.by"), moved.by)?;
                    self.check_course(at, "moved", support.amplitude.as_ref())?;
                }
                SupportKind::Rotated(rotated) => {
                    s.direction(&format!("{at}.rotated.axis"), rotated.axis)?;
                    s.sized(&format!("{at}.rotated.by"), rotated.by)?;
                    self.check_course(at, "rotated", support.amplitude.as_ref())?;
                }
                SupportKind::Turned(turned) => {
                    s.direction(&format!("{at}.turned.axis"), turned.axis)?;
                    s.sized_all(&format!("{at}.turned.point"), &turned.point)?;
                    s.sized(&format!("{at}.turned.by"), turned.by)?;
                    self.check_course(at, "turned", support.amplitude.as_ref())?;
                }
                SupportKind::Spring(spring) => {
                    self.check_spring(&format!("{at}.spring"), &support.on, &spring)?
                }
            }
        }
        Ok(())
    }

    fn check_spring(&self, at: &str, on: &str, spring: &Spring) -> Checked {
        let s = &self.scope();
        let Spring { direction, axis, stiffness, to } = spring;
        let known = ["direction", "axis"];
        let given = known.into_iter().zip([direction, axis]).filter_map(|(word, v)| v.map(|_| word));
        s.exactly_one(at, "direction or axis", &Vec::from_iter(given), &known)?;
        for (word, v) in known.into_iter().zip([direction, axis]) {
            s.direction(&format!("{at}.{word}"), v.unwrap_or([1.0; 3]))?;
        }
        s.positive(&format!("{at}.stiffness"), *stiffness)?;
        let Some(to) = to else { return Ok(()) };
        let path = format!("{at}.to");
        if axis.is_some() {
            let repair = "leave `to` out, or give a `direction`";
            let bound = "none: a spring against turning stands on the ground";
            return Err(SceneError::Choice(s.fault(&path, "another set", bound, repair)));
        }
        if to == on {
            let repair = "name the set at the other end";
            return Err(SceneError::Set(s.fault(
                &path,
                &format!("\"{to}\""),
                "another set than `on`",
                repair,
            )));
        }
        self.check_set_name(&path, to)
    }

    fn check_held(&self, at: &str, held: &Held) -> Checked {
        let s = &self.scope();
        let Held { displacement, director } = held;
        if displacement.is_empty() && director.is_empty() {
            let repair =
                "held = { displacement = [[0, 0, 1]] } holds z; `director` keeps the director in a plane";
            let bound = "`displacement`, `director` or both";
            return Err(SceneError::Choice(s.fault(at, "no direction", bound, repair)));
        }
        // Directors of a shell keep their length; one that stays in two planes does not turn at all.
        let turns = if self.as_solid().is_some() { 2 } else { 1 };
        let lists = [
            ("displacement", displacement, 3, "three hold the particle"),
            ("director", director, turns, "use `clamped` to hold both turns"),
        ];
        for (key, list, most, repair) in lists {
            let path = format!("{at}.{key}");
            if list.len() > most {
                let value = format!("{} directions", list.len());
                return Err(s.value(&path, value, &format!("at most {most}"), repair));
            }
            for (i, &v) in list.iter().enumerate() {
                s.direction(&format!("{path}[{i}]"), v)?;
            }
        }
        let mut basis: Vec<Vec3> = Vec::new();
        for (i, &v) in displacement.iter().enumerate() {
            let v = Vec3::from(v).normalize();
            let rest = basis.iter().fold(v, |rest, known| rest - known * known.dot(&rest));
            if rest.norm() < PARALLEL {
                let path = format!("{at}.displacement[{i}]");
                let value = format!("{:?}", displacement[i]);
                let repair = "remove it: the directions before it hold this one already";
                return Err(s.value(&path, value, "out of the plane or line of those before it", repair));
            }
            basis.push(rest.normalize());
        }
        Ok(())
    }

    /// A prescribed motion follows the load level, in a transient run a course that starts at zero.
    fn check_course(&self, at: &str, word: &str, amplitude: Option<&Amplitude>) -> Checked {
        let path = format!("{at}.amplitude");
        let starts_at_rest = match amplitude {
            None => !self.analysis.kind().passes_time,
            Some(amplitude) => {
                self.check_amplitude(&path, amplitude)?;
                match amplitude {
                    Amplitude::Constant => false,
                    Amplitude::Table(points) => points[0][1] == 0.0 && points[0][0] >= 0.0,
                    _ => true,
                }
            }
        };
        if starts_at_rest {
            return Ok(());
        }
        let path = if amplitude.is_none() { format!("{at}.{word}") } else { path };
        let repair =
            format!("a transient run has no load level: add amplitude = {{ ramp = time }} beside `{word}`");
        let bound = "one with a course in time that starts at zero";
        Err(SceneError::Choice(self.scope().fault(&path, "a prescribed motion", bound, &repair)))
    }

    pub(super) fn check_load(&self, at: &str, load: &Load) -> Checked {
        let s = &self.scope();
        self.check_set_name(&format!("{at}.on"), &load.on)?;
        let kinds = load.kinds();
        let given: Vec<&str> = kinds.iter().map(|(word, _)| *word).collect();
        s.exactly_one(at, "load", &given, &Load::WORDS)?;
        self.check_load_of_fluid(at, load)?;
        if let Some(solid) = self.as_solid() {
            self.check_solid_load(at, load, solid)?;
        }
        for (word, kind) in kinds {
            match kind {
                LoadKind::Force(force) => {
                    s.sized_all(&format!("{at}.force.total"), &force.total)?;
                    if force.by_area && self.as_shell().is_none() {
                        let bound = "none but on the cells of a shell";
                        let repair =
                            "remove it: a solid shares a force by volume, and takes a traction on faces";
                        let path = format!("{at}.force.by_area");
                        return Err(SceneError::Choice(s.fault(&path, "a share by area", bound, repair)));
                    }
                }
                LoadKind::Couple(couple) => {
                    s.sized(&format!("{at}.couple.moment"), couple.moment)?;
                    if let Axis::Fixed(axis) = couple.axis {
                        s.direction(&format!("{at}.couple.axis"), axis)?;
                    }
                    if couple.axis == Axis::Edge {
                        self.only_on(at, &load.on, "a couple about the edge acts on an edge", &EDGES)?;
                    }
                }
                LoadKind::Pressure(pressure) => s.sized(&format!("{at}.pressure.value"), pressure.value)?,
                LoadKind::Gravity(g) => {
                    s.sized_all(&format!("{at}.gravity.acceleration"), &g.acceleration)?
                }
                LoadKind::Traction(_) => self.check_traction(at, load)?,
            }
            if matches!(kind, LoadKind::Pressure(_)) && self.as_solid().is_some() {
                self.check_face(at, load, word)?;
            } else if matches!(kind, LoadKind::Pressure(_) | LoadKind::Gravity(_))
                && self.as_shell().is_none()
            {
                let body = self.body().word();
                self.only_on(at, &load.on, &format!("{word} acts on the whole {body}"), &["all"])?;
            }
        }
        match &load.amplitude {
            None => Ok(()),
            Some(amplitude) => self.check_amplitude(&format!("{at}.amplitude"), amplitude),
        }
    }

    pub(super) fn only_on(&self, at: &str, on: &str, why: &str, fit: &[&str]) -> Checked {
        // Whether a set of a mesh is an edge is known when its file has been read.
        let of_mesh = || self.as_shell().is_some_and(|shell| shell.geometry.mesh().is_some());
        if fit.contains(&on) || (fit == EDGES && of_mesh()) {
            return Ok(());
        }
        let repair = format!("use one of {}", fit.join(", "));
        Err(SceneError::Set(self.scope().fault(
            &format!("{at}.on"),
            &format!("\"{on}\""),
            &format!("but {why}"),
            &repair,
        )))
    }

    pub(super) fn check_amplitude(&self, at: &str, amplitude: &Amplitude) -> Checked {
        let s = &self.scope();
        if !self.analysis.kind().passes_time {
            let what = self.analysis.kind().name;
            let repair = format!("remove it: in {what} the load level takes its place");
            let fault = s.fault(at, "a course in time", &format!("none in {what}"), &repair);
            return Err(SceneError::Choice(fault));
        }
        match amplitude {
            Amplitude::Constant => Ok(()),
            Amplitude::Ramp(time) => s.positive(&format!("{at}.ramp"), *time),
            Amplitude::Smooth(time) => s.positive(&format!("{at}.smooth"), *time),
            Amplitude::Sine { period } => s.positive(&format!("{at}.sine.period"), *period),
            Amplitude::Table(points) => {
                for (i, point) in points.iter().enumerate() {
                    s.sized_all(&format!("{at}.table[{i}]"), point)?;
                }
                if !points.is_empty() && points.windows(2).all(|w| w[0][0] < w[1][0]) {
                    return Ok(());
                }
                let bound = "a list of [time, factor] with ascending times";
                Err(s.value(&format!("{at}.table"), "empty or out of order", bound, "sort it by time"))
            }
        }
    }
}
