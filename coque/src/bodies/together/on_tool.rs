//! A solid on a rigid tool: the surface by which other bodies touch it, the tool's distance, and, in time, friction with its history.

use contact::{Friction, Pose, ToolContact, ToolShape, Touch, Watch};
use explicit_dynamics::{Amplitude, Instant};
use nalgebra::Matrix3;
use sph_core::Vec3;

use super::contact::Side;
use super::rough_tool::RoughTool;
use super::rows::Rows;
use super::skin::Skin;

/// How much farther than they touch vertices share blocks of the tangent, over the spacing.
const SKIN: f64 = 0.3;

/// A body and one of its tools.
pub(in crate::bodies) struct OnTool {
    /// Number of the body.
    pub body: usize,
    /// Number of the tool among those of the body.
    pub number: usize,
    /// Names of the body and of the tool.
    names: [String; 2],
    /// Particles of each body that carry the surface, those of others empty.
    particles: Vec<Vec<u32>>,
    /// How places carry it.
    skin: Skin,
    pub contact: ToolContact,
    /// The tool as it stands at level zero.
    pub shape: ToolShape,
    /// How the contact is counted in rows.
    pub(super) rows: Option<Rows>,
    watch: Watch,
    /// Friction; none of a smooth tool.
    pub(super) rough: Option<RoughTool>,
    /// How far the tool has moved and turned at level one.
    motion: Pose,
    amplitude: Amplitude,
    /// Where it stands.
    pub stood: Pose,
    pub touch: Touch,
    /// How far from faces that touch vertices are listed \[L\].
    near: f64,
    /// Vertices that are near, ascending.
    listed: Vec<u32>,
    /// Pairs of places that share a block, ascending; those of this list.
    pairs: Vec<[usize; 2]>,
    /// Whether the list was taken up from a state, so that the pairs are others than those at hand.
    taken_up: bool,
}

/// A tool as it meets a body.
pub(super) struct ToolAt {
    /// Its number among those of the body.
    pub number: usize,
    /// Its name.
    pub name: String,
    /// Its shape at level zero.
    pub shape: ToolShape,
    /// The contact with the surface of the body.
    pub contact: ToolContact,
    /// Coefficient of friction μ \[–\], zero of a smooth one.
    pub friction: f64,
    /// How far it has moved and turned at level one.
    pub motion: Pose,
    /// What of that a time brings.
    pub amplitude: Amplitude,
}

impl OnTool {
    /// A body, one of so many, on a tool.
    pub(super) fn new(side: &Side, tool: ToolAt, bodies: usize) -> Self {
        let ToolAt { number, name, shape, contact, friction, motion, amplitude } = tool;
        let mut nodes: Vec<u32> =
            contact.surface.vertices().iter().flat_map(|vertex| vertex.nodes().iter().copied()).collect();
        nodes.sort_unstable();
        nodes.dedup();
        let (skin, [own, _]) = Skin::new([&nodes, &[]], [side.inside.as_deref(), None]);
        let mut particles = vec![Vec::new(); bodies];
        let places = own.len();
        particles[side.body] = own;
        Self {
            body: side.body,
            number,
            names: [side.name.clone(), name],
            particles,
            skin,
            rows: side.rows.clone(),
            watch: Watch::new(&contact.surface),
            rough: RoughTool::new(friction, &contact, places),
            contact,
            shape,
            motion,
            amplitude,
            stood: Pose::default(),
            touch: Touch::NONE,
            near: SKIN * side.spacing,
            listed: Vec::new(),
            pairs: Vec::new(),
            taken_up: false,
        }
    }

    /// A line for the summary.
    pub fn line(&self) -> String {
        let [body, tool] = &self.names;
        let friction = self.rough.as_ref().map(|rough| format!(", friction {}", rough.coefficient()));
        format!(
            "contact of {body} with the tool `{tool}`: stiffness {:.3e} by area{}",
            self.contact.stiffness,
            friction.unwrap_or_default()
        )
    }

    /// Where a node of the surface is, all particles of the body being at places \[L\].
    pub fn node_at(&self, at: &[Vec3], node: u32) -> Vec3 {
        let mut sum = Vec3::zeros();
        let own = &self.particles[self.body];
        self.skin.each((0, node), |place, weight| sum += at[own[place] as usize] * weight);
        sum
    }

    /// The skin of the surface, and the particles that carry it.
    pub(super) fn carried(&self) -> (&Skin, &[u32]) {
        (&self.skin, &self.particles[self.body])
    }

    fn stand(&mut self, at: Instant) {
        self.stood = share(&self.motion, at.level * self.amplitude.value(at.time));
    }

    fn evaluated(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) {
        forces.fill([0.0; 3]);
        let Self { skin, contact, watch, rough, stood, touch, .. } = self;
        // Nothing bounds how far places have moved since.
        watch.forget();
        *touch = contact.forces(
            watch,
            rough.as_mut().map(RoughTool::friction_mut),
            stood,
            |node| skin.place(places, (0, node)),
            |node, force| {
                skin.each((0, node), |a, weight| (0..3).for_each(|k| forces[a][k] += weight * force[k]));
            },
        );
    }

    /// Hands the second derivatives of the energy between places to `put`.
    fn second(&self, places: &[[f64; 3]], mut put: impl FnMut(usize, usize, &Matrix3<f64>)) {
        let skin = &self.skin;
        self.contact.tangent(
            self.friction(),
            &self.stood,
            |node| skin.place(places, (0, node)),
            |a, b, change| {
                skin.each((0, a), |a, own| {
                    skin.each((0, b), |b, other| put(a, b, &(change * -(own * other))));
                });
            },
        );
    }

    /// Its friction.
    pub(super) fn friction(&self) -> Option<&Friction> {
        self.rough.as_ref().map(RoughTool::friction)
    }

    /// Reads the pairs that share a block from the list.
    fn read_pairs(&mut self) {
        let Self { skin, contact, pairs, listed, .. } = self;
        pairs.clear();
        for &number in &*listed {
            let nodes = contact.surface.vertices()[number as usize].nodes();
            for &a in nodes {
                for &b in nodes {
                    skin.each((0, a), |a, _| {
                        skin.each((0, b), |b, _| {
                            if a <= b {
                                pairs.push([a, b]);
                            }
                        });
                    });
                }
            }
        }
        pairs.sort_unstable();
        pairs.dedup();
    }
}

impl explicit_dynamics::Interaction for OnTool {
    fn particles(&self) -> Vec<Vec<u32>> {
        self.particles.clone()
    }

    fn put(&mut self, at: Instant) {
        self.stand(at);
    }

    fn is_external(&self) -> bool {
        true
    }

    fn evaluate(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        self.evaluated(places, forces);
        0.0
    }

    fn resist(&self, at: &[[f64; 3]], motion: &[[f64; 3]], forces: &mut [[f64; 3]]) {
        forces.fill([0.0; 3]);
        self.second(at, |a, b, block| {
            let moved = block * Vec3::from(motion[b]);
            (0..3).for_each(|k| forces[a][k] += moved[k]);
        });
    }

    /// As if all of the surface touched: what does not yet it may within a step.
    fn fastest(&self, masses: &[f64]) -> f64 {
        let of = |vertex: &contact::Vertex| {
            let inverse = |&node: &u32| vertex.share().powi(2) / self.skin.mass(masses, (0, node));
            self.contact.bound(vertex) * vertex.nodes().iter().map(inverse).sum::<f64>()
        };
        self.contact.surface.vertices().iter().map(of).fold(0.0, f64::max)
    }

    fn lost(&self) -> f64 {
        self.friction().map_or(0.0, Friction::lost)
    }

    fn commit(&mut self) {
        let Self { rough, contact, skin, .. } = self;
        if let Some(rough) = rough {
            rough.commit(contact, skin);
        }
    }

    fn lost_at(&self, place: usize) -> f64 {
        self.rough.as_ref().map_or(0.0, |rough| rough.lost_at(place))
    }

    fn kept(&self) -> Vec<f64> {
        self.rough.as_ref().map_or_else(Vec::new, RoughTool::numbers)
    }

    fn take_up(&mut self, kept: &[f64], _masses: &[f64]) -> bool {
        let vertices = self.contact.surface.vertices().len();
        self.rough.as_mut().map_or(kept.is_empty(), |rough| rough.take_up(kept, vertices))
    }
}

impl implicit_statics::Interaction for OnTool {
    fn particles(&self) -> Vec<Vec<u32>> {
        self.particles.clone()
    }

    fn put(&mut self, level: f64) {
        self.stand(Instant { time: 0.0, level });
    }

    fn moves(&self) -> bool {
        self.motion != Pose::default()
    }

    fn pairs(&self) -> Vec<[usize; 2]> {
        self.pairs.clone()
    }

    fn pairs_changed(&mut self, places: &[[f64; 3]]) -> bool {
        let Self { skin, contact, stood, near, listed, .. } = self;
        let (mut all, mut known) = (Vec::new(), true);
        for (number, vertex) in (0..).zip(contact.surface.vertices()) {
            let place = vertex.place(|node| skin.place(places, (0, node)));
            let gap = contact.tool.face(&place, &stood.moved).distance - vertex.half;
            if gap < *near {
                all.push(number);
                known &= gap >= 0.0 || listed.binary_search(&number).is_ok();
            }
        }
        if known {
            return std::mem::take(&mut self.taken_up);
        }
        self.taken_up = false;
        self.listed = all;
        self.read_pairs();
        true
    }

    fn kept(&self) -> Vec<f64> {
        self.listed.iter().map(|&number| f64::from(number)).collect()
    }

    fn take_up(&mut self, kept: &[f64]) -> bool {
        let count = self.contact.surface.vertices().len() as f64;
        if kept.iter().any(|number| !(0.0..count).contains(number)) {
            return false;
        }
        self.listed = kept.iter().map(|&number| number as u32).collect();
        self.read_pairs();
        self.taken_up = true;
        true
    }

    fn evaluate(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        self.evaluated(places, forces);
        0.0
    }

    fn rates(&self, at: &[[f64; 3]], rates: &mut [[f64; 3]]) -> bool {
        rates.fill([0.0; 3]);
        let (skin, rate) = (&self.skin, share(&self.motion, self.amplitude.value(0.0)));
        self.contact.rates(
            None,
            &self.stood,
            &rate,
            |node| skin.place(at, (0, node)),
            |node, force| {
                skin.each((0, node), |a, weight| (0..3).for_each(|k| rates[a][k] += weight * force[k]));
            },
        );
        implicit_statics::Interaction::moves(self)
    }

    fn stiffness(&self, at: &[[f64; 3]], blocks: &mut [[[f64; 3]; 3]]) {
        blocks.fill([[0.0; 3]; 3]);
        self.second(at, |a, b, change| {
            let Ok(block) = self.pairs.binary_search(&[a, b]) else { return };
            for i in 0..3 {
                (0..3).for_each(|j| blocks[block][i][j] += change[(i, j)]);
            }
        });
    }
}

/// A share of a motion.
fn share(motion: &Pose, share: f64) -> Pose {
    Pose { moved: motion.moved * share, angle: motion.angle * share }
}
