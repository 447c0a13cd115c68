//! Bodies that nothing keeps apart: whether they have come nearer to each other than their faces allow.

use contact::{Bystander, TooNear};
use sph_core::Vec3;

use super::body::{Body, Configuration};
use super::outline::Outline;
use crate::scene::glued::glued;
use crate::scene::joints::joints;
use crate::scene::linked::links;
use crate::scene::{JointScene, Scene};

/// Way over the greatest coordinate beyond which a body is near nothing.
const FAR: f64 = 10.0;

/// Pairs of bodies of a scene between which it names no contact, and shells that do not touch themselves.
#[derive(Debug)]
pub(crate) struct Unseen {
    pairs: Vec<Pair>,
}

/// Two of the bodies, or one with itself.
#[derive(Debug)]
struct Pair {
    of: [usize; 2],
    /// Whether springs, links or glue join them.
    joined: bool,
}

impl Unseen {
    /// What nothing keeps apart among the bodies of a scene; none where all of it touches.
    pub fn of(scene: &Scene, body: &dyn Body) -> Option<Self> {
        let outlines = body.outlines();
        let joints = joints(scene).unwrap_or_default();
        let glue = match outlines.len() {
            0 | 1 => Vec::new(),
            _ => glued(scene).unwrap_or_default(),
        };
        let links = links(scene).unwrap_or_default();
        let name = |number: usize| outlines[number].name.as_deref();
        let touch = |i: usize, j: usize| {
            let [of_i, of_j] = [i, j].map(|number| name(number).unwrap_or_default());
            scene.contact.iter().any(|own| match i == j {
                true => own.is_of_itself(of_i),
                false => own.other(of_i) == Some(of_j),
            })
        };
        let joined = |i: usize, j: usize| {
            let of = [i, j].map(|number| name(number).unwrap_or_default());
            joints.iter().any(|joint| joint.ends.iter().all(|(body, _)| of.contains(body)))
                || i != j && links.iter().any(|link| of.iter().all(|body| link.is_of(body)))
                || i != j && glue.iter().any(|glue| of.iter().all(|body| glue.is_of(body)))
        };
        // Bodies on a joint that are drawn through each other, as two bars about their pin, are meant to pass.
        let rest = body.configuration().rest;
        let crossed = |i: usize, j: usize| {
            let shown = |number: usize| (&outlines[number], &rest[outlines[number].particles.clone()]);
            let [(one, here), (other, there)] = [shown(i), shown(j)];
            // As if the other came from far away: all that is near counts.
            let size = here.iter().chain(there).fold(0.0_f64, |most, x| most.max(x.amax()));
            let away: Vec<Vec3> = there.iter().map(|x| x.add_scalar(FAR * size)).collect();
            let one = Bystander { cells: &one.cells, rest: here, now: here, half: one.half };
            let other = Bystander { cells: &other.cells, rest: &away, now: there, half: other.half };
            one.in_each_other(&other, false).is_some()
        };
        let pinned = |i: usize, j: usize| {
            let of = [i, j].map(|number| name(number).unwrap_or_default());
            let on = |joint: &JointScene| of.iter().all(|body| joint.is_of(body));
            i != j && scene.joints.iter().any(on) && crossed(i, j)
        };
        let mut pairs = Vec::new();
        for i in 0..outlines.len() {
            for j in i..outlines.len() {
                if (i != j || outlines[i].sheet) && !touch(i, j) && !pinned(i, j) {
                    pairs.push(Pair { of: [i, j], joined: joined(i, j) });
                }
            }
        }
        (!pairs.is_empty()).then_some(Self { pairs })
    }

    /// What has come too near to what, at a moment in words; none where nothing has.
    pub fn look(&self, body: &dyn Body, when: &str) -> Option<String> {
        let Configuration { rest, present, .. } = body.configuration();
        // Outlines are made for a look: no run holds them between two.
        let outlines = body.outlines();
        let shown = |number: usize| {
            let Outline { particles, cells, half, .. } = &outlines[number];
            Bystander { cells, rest: &rest[particles.clone()], now: &present[particles.clone()], half: *half }
        };
        self.pairs.iter().find_map(|pair| {
            let [i, j] = pair.of;
            let found = match i == j {
                true => shown(i).in_itself(),
                false => shown(i).in_each_other(&shown(j), pair.joined),
            };
            Some(self.said(pair, &found?, when, &outlines))
        })
    }

    fn said(&self, pair: &Pair, found: &TooNear, when: &str, outlines: &[Outline]) -> String {
        let TooNear { places, distance, touching } = *found;
        let [here, there] = places.map(|x| format!("[{:.4}, {:.4}, {:.4}]", x.x, x.y, x.z));
        let how = if distance > 0.0 {
            format!("{here} and {there} are {distance:.4e} apart, where faces touch at {touching:.4e}")
        } else {
            format!("one goes through the other at {here}")
        };
        let name = |number: usize| outlines[number].name.as_deref();
        let repair = "or end the run before";
        match pair.of.map(name) {
            [Some(a), Some(b)] if a != b => {
                let add = format!("nothing keeps them apart: add [[contact]] between = [\"{a}\", \"{b}\"], ");
                format!("`{a}` and `{b}` are in each other {when}: {how}; {add}{repair}")
            }
            [name, _] => {
                let who = name.map_or_else(|| "the shell".into(), |name| format!("`{name}`"));
                let between =
                    name.map_or_else(String::new, |name| format!(" between = [\"{name}\", \"{name}\"]"));
                let add = format!("add [[contact]]{between}, ");
                format!("{who} is in itself {when}: {how}; nothing keeps its parts apart: {add}{repair}")
            }
        }
    }
}
