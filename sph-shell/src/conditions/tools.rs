//! Rigid tools that a shell may touch: they push by a potential, in every analysis, and move as level and time say.

mod frozen;

use contact::{Friction, Law, NodalContact, Pose, Surface, ToolContact, ToolShape, Touch, Watch};
use explicit_dynamics::{Amplitude, Instant};
use implicit_statics::Front;
use sph_core::Vec3;

use crate::conditions::body::{Block, place_block};
use crate::conditions::case::LoadCase;
use crate::conditions::stages::{self, Stages};
use crate::error::ShellError;
use crate::packs::Row;
use crate::reference::Reference;

/// A tool before the shell is built.
///
/// It pushes on both faces of the shell, whose particles lie in the middle of its thickness: the mid-surface stands half a thickness off the
/// tool when they touch (crate `contact`).
#[derive(Clone, Debug)]
pub struct Tool {
    /// Its shape and place at level zero, from zero.
    pub shape: ToolShape,
    /// How far it has moved at level one \[L\].
    pub moved: Vec3,
    /// How far it has turned about its own axis at level one \[rad\].
    pub turn: f64,
    /// What of that a time brings.
    pub amplitude: Amplitude,
    /// Whether its motion belongs to the preload or to the loads of the analysis.
    pub case: LoadCase,
    /// The law of contact.
    pub law: Law,
    /// Stiffness κ of a unit of area \[F/L³\]; [`contact::stiffness`] has one.
    pub stiffness: f64,
    /// Coefficient of friction μ \[–\]; zero of a smooth one.
    pub friction: f64,
}

/// Numbers of an anchor.
const ANCHOR: usize = 7;
/// Bound of the speed of any particle of a march over the speed of sound.
const FASTEST: f64 = 2.0;

/// A tool with the surface that it may touch.
#[derive(Clone, Debug)]
struct Touched {
    contact: ToolContact,
    /// Its law and stiffness, which a stage of Newton's method may soften.
    own: (Law, f64),
    watch: Watch,
    friction: Option<Friction>,
    /// How far it has moved and turned at level one.
    motion: Pose,
    amplitude: Amplitude,
    case: LoadCase,
    /// Where it stood when forces were last evaluated.
    stood: Pose,
}

/// All tools of a shell.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tools {
    tools: Vec<Touched>,
    /// What each of them and the shell do to each other, for the forces last evaluated.
    touches: Vec<Touch>,
    /// Forces of all of them on each particle.
    forces: Vec<Row>,
    /// Energy that friction has taken at each particle \[F L\]; empty where all are smooth.
    lost: Vec<f64>,
    /// Whether any of the forces is not zero.
    touching: bool,
    stages: Stages,
    origin: Vec3,
    /// No particle of a march is faster \[L/T\].
    fastest: f64,
    /// When forces were last evaluated; infinite if the shell was moved by hand since.
    time: f64,
}

impl Tools {
    /// The tools of a shell with half of its thickness at each particle \[L\], and the stages in which its contact may be softened.
    ///
    /// # Errors
    /// [`ShellError`] for shapes without sense, a stiffness that is not positive, and a friction that is negative.
    pub fn new(
        tools: Vec<Tool>,
        reference: &Reference,
        half: &[f64],
        stages: Stages,
    ) -> Result<Self, ShellError> {
        let cloud = &reference.cloud;
        let surface = Surface::new(&cloud.cells, &cloud.positions, |a| half[a as usize]);
        let touched = |tool: Tool| {
            let Tool { shape, moved, turn, amplitude, case, law, stiffness, friction } = tool;
            if !(stiffness > 0.0 && stiffness.is_finite()) {
                return Err(ShellError::ToolStiffness(stiffness));
            }
            let contact = ToolContact { tool: shape.checked()?, surface: surface.clone(), law, stiffness };
            let watch = Watch::new(&contact.surface);
            let rubs = Friction::new(friction, surface.vertices().len());
            let rubs = rubs.ok_or(ShellError::ToolFriction(friction))?;
            let friction = if friction > 0.0 { Some(rubs) } else { None };
            let motion = Pose { moved, angle: turn };
            Ok(Touched {
                contact,
                own: (law, stiffness),
                watch,
                friction,
                motion,
                amplitude,
                case,
                stood: Pose::default(),
            })
        };
        let tools = tools.into_iter().map(touched).collect::<Result<Vec<_>, ShellError>>()?;
        let rough = tools.iter().any(|tool| tool.friction.is_some());
        Ok(Self {
            tools,
            touches: Vec::new(),
            forces: vec![[0.0; 6]; cloud.len()],
            lost: vec![0.0; if rough { cloud.len() } else { 0 }],
            touching: false,
            stages,
            origin: reference.origin,
            fastest: FASTEST * reference.sound_speed,
            time: f64::INFINITY,
        })
    }

    /// Whether the motion of any of them belongs to a load case.
    pub fn move_in(&self, case: LoadCase) -> bool {
        self.tools.iter().any(|tool| tool.case == case && tool.motion != Pose::default())
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.tools.is_empty()
    }

    /// What each tool and the shell do to each other.
    pub fn touches(&self) -> &[Touch] {
        &self.touches
    }

    /// Evaluates the forces of all tools at an instant of a load case; whether there are any.
    ///
    /// In time the shell moves no faster than a bound, so that far parts of it need no look; without time all of it is looked at.
    pub fn evaluate(&mut self, at: Instant, under_way: LoadCase, state: &[Row]) -> bool {
        let Self { tools, touches, forces, touching, origin, fastest, time, .. } = self;
        touches.clear();
        if std::mem::take(touching) {
            forces.fill([0.0; 6]);
        }
        let gone = if at.time > *time { Some(*fastest * (at.time - *time)) } else { None };
        *time = at.time;
        for tool in tools.iter_mut() {
            let pose = tool.pose(at, under_way, origin);
            match gone {
                Some(gone) => tool.watch.count(gone + (pose.moved - tool.stood.moved).norm()),
                None => tool.watch.forget(),
            }
            tool.stood = pose;
            let push = |a, force: Vec3| push(forces, a, &force);
            let Touched { contact, watch, friction, .. } = tool;
            let touch = contact.forces(watch, friction.as_mut(), &pose, place(state), push);
            *touching |= touch.area > 0.0;
            touches.push(touch);
        }
        *touching
    }

    /// Adds the forces last evaluated.
    pub fn add(&self, forces: &mut [Row]) {
        for (sum, row) in forces.iter_mut().zip(&self.forces).filter(|_| self.touching) {
            (0..3).for_each(|k| sum[k] += row[k]);
        }
    }

    /// Takes note that the shell was moved by hand.
    pub fn forget(&mut self) {
        self.time = f64::INFINITY;
    }

    /// Least gaps between the faces of the shell and of each tool at an instant of a load case \[L\], negative where they are in each other.
    pub fn least_gaps(&self, at: Instant, under_way: LoadCase, state: &[Row]) -> Vec<f64> {
        let gap = |tool: &Touched| {
            tool.contact.least_gap(&tool.pose(at, under_way, &self.origin).moved, place(state))
        };
        self.tools.iter().map(gap).collect()
    }

    /// The lengths of stages softer than any of them, ascending in stiffness; none where one has friction, whose slip goes by the way taken.
    pub fn stages(&self) -> Vec<f64> {
        if self.remember() {
            return Vec::new();
        }
        let stiffest = self.tools.iter().map(|tool| tool.own.1).fold(0.0, f64::max);
        self.stages.softer_than(stiffest).collect()
    }

    /// Softens them to a stage, without a barrier; none: back to their own law.
    pub fn soften(&mut self, stage: Option<f64>) {
        for Touched { contact, own: (law, stiffness), .. } in &mut self.tools {
            contact.stiffness = self.stages.softened(*stiffness, stage);
            contact.law = if stage.is_some() { law.open() } else { *law };
        }
    }

    /// Takes what touches them at an instant of a load case into what is known of that.
    pub fn see(&self, at: Instant, under_way: LoadCase, state: &[Row], front: &mut Front) {
        for tool in &self.tools {
            let moved = tool.pose(at, under_way, &self.origin).moved;
            tool.contact.each_touching(&moved, place(state), |number, depth| {
                stages::take(front, u64::from(number), depth);
            });
            stages::take(front, u64::from(u32::MAX), 0.0);
        }
    }

    /// Force of all tools on a particle, for the forces last evaluated.
    pub fn force(&self, particle: usize) -> Vec3 {
        self.forces.get(particle).map_or_else(Vec3::zeros, |row| Vec3::new(row[0], row[1], row[2]))
    }

    /// Gap between the faces of the shell and of the nearest tool at a particle, where tools stood as forces were last evaluated \[L\].
    pub fn gap_at(&self, particle: usize, state: &[Row]) -> f64 {
        let (a, at) = (particle as u32, place(state)(particle as u32));
        let gap = |tool: &Touched| tool.contact.gap_at(a, &tool.stood.moved, &at);
        self.tools.iter().filter_map(gap).fold(f64::INFINITY, f64::min)
    }

    /// What each particle feels of all tools, where they stood as forces were last evaluated.
    pub fn nodal_contact(&self, state: &[Row], nodal: &mut [NodalContact]) {
        let mut own = vec![NodalContact::default(); nodal.len()];
        for Touched { contact, friction, stood, .. } in &self.tools {
            own.fill(NodalContact::default());
            contact.nodal_contact(friction.as_ref(), stood, place(state), &mut own);
            nodal.iter_mut().zip(&own).for_each(|(sum, own)| sum.join(own));
        }
    }

    /// The shape of each tool at level zero, and how far it had moved and turned, from zero, as forces were last evaluated.
    pub fn stood(&self) -> impl Iterator<Item = (ToolShape, Pose)> {
        self.tools.iter().map(|Touched { contact, stood, .. }| {
            (contact.tool, Pose { moved: stood.moved + self.origin, ..*stood })
        })
    }

    /// The place that is deepest in a tool, likewise, from the origin \[L\]; none without such a tool.
    pub fn deepest(&self, tool: usize, state: &[Row]) -> Option<Vec3> {
        let Touched { contact, stood, .. } = self.tools.get(tool)?;
        contact.deepest(stood, place(state)).map(|(_, place)| place)
    }

    /// Stiffness of each tool.
    pub fn stiffnesses(&self) -> impl Iterator<Item = f64> {
        self.tools.iter().map(|tool| tool.contact.stiffness)
    }

    /// Adds what a unit of level adds to their forces, where it moves them.
    pub fn add_rates(&self, at: Instant, under_way: LoadCase, state: &[Row], forces: &mut [Row]) {
        let driven = |tool: &&Touched| tool.case == under_way && tool.motion != Pose::default();
        for tool in self.tools.iter().filter(driven) {
            let pose = tool.pose(at, under_way, &self.origin);
            let share = tool.amplitude.value(at.time);
            let rate = Pose { moved: tool.motion.moved * share, angle: tool.motion.angle * share };
            let push = |a, force: Vec3| push(forces, a, &force);
            tool.contact.rates(tool.friction.as_ref(), &pose, &rate, place(state), push);
        }
    }

    /// Hands the derivatives of their forces to `put`, as loads do theirs. All pairs of the particles of a cell share a block.
    pub fn stiffness(
        &self,
        at: Instant,
        under_way: LoadCase,
        state: &[Row],
        put: &mut dyn FnMut(u32, u32, &Block),
    ) {
        for tool in &self.tools {
            let pose = tool.pose(at, under_way, &self.origin);
            let put = |a, b, change: &_| put(a, b, &place_block(0, 0, change));
            tool.contact.tangent(tool.friction.as_ref(), &pose, place(state), put);
        }
    }

    /// Adds the forces that a small motion meets at most, as if all of the shell touched every tool: `−κ A u` at each vertex. What a
    /// march does not touch yet it may touch within a step.
    pub fn add_bounds(&self, state: &[Row], home: &[Row], forces: &mut [Row]) {
        for tool in &self.tools {
            for vertex in tool.contact.surface.vertices() {
                let way = vertex.place(place(state)) - vertex.place(place(home));
                let share = way * (-tool.contact.bound(vertex) * vertex.share());
                vertex.nodes().iter().for_each(|&a| push(forces, a, &share));
            }
        }
    }

    /// The greatest depth of any vertex in a tool, for the forces last evaluated, over that at which mid-surfaces come through.
    pub fn greatest_depth(&self) -> f64 {
        self.touches.iter().fold(0.0, |deepest, touch| touch.greatest_depth.max(deepest))
    }

    /// Whether any of them has friction, whose anchors are history.
    pub fn remember(&self) -> bool {
        !self.lost.is_empty()
    }

    /// Energy that friction has taken at a particle until the last commit \[F L\].
    pub fn lost_at(&self, particle: usize) -> f64 {
        self.lost.get(particle).copied().unwrap_or_default()
    }

    /// Energy that friction took on the way to the forces last evaluated, from what was committed \[F L\].
    pub fn lost(&self) -> f64 {
        self.tools.iter().filter_map(|tool| tool.friction.as_ref()).map(Friction::lost).sum()
    }

    /// Commits the anchors of the forces last evaluated.
    pub fn commit(&mut self) {
        for Touched { contact, friction, .. } in &mut self.tools {
            let Some(friction) = friction else { continue };
            friction.commit(|vertex, energy| {
                let vertex = &contact.surface.vertices()[vertex as usize];
                vertex.nodes().iter().for_each(|&a| self.lost[a as usize] += energy * vertex.share());
            });
        }
    }

    /// The committed history: losses of all particles, then of each tool with friction the number of its anchors, and these.
    pub fn history(&self) -> impl Iterator<Item = f64> {
        let anchors = |friction: &Friction| {
            let numbers: Vec<f64> = friction.numbers().collect();
            std::iter::once((numbers.len() / ANCHOR) as f64).chain(numbers)
        };
        let of_tools = self.tools.iter().filter_map(|tool| tool.friction.as_ref()).flat_map(anchors);
        self.lost.iter().copied().chain(of_tools)
    }

    /// Takes up a history; false, and nothing changed, if it is that of other tools.
    pub fn take_up(&mut self, history: &[f64]) -> bool {
        let Some((lost, mut rest)) = history.split_at_checked(self.lost.len()) else { return false };
        let mut anchors = Vec::new();
        for tool in self.tools.iter().filter(|tool| tool.friction.is_some()) {
            let vertices = tool.contact.surface.vertices().len();
            let Some((&count, after)) = rest.split_first() else { return false };
            let Some((own, after)) = after.split_at_checked(count as usize * ANCHOR) else { return false };
            let rows = own.as_chunks::<ANCHOR>().0;
            if rows.iter().any(|row| row[0] < 0.0 || row[0] >= vertices as f64) {
                return false;
            }
            anchors.push(rows);
            rest = after;
        }
        if rest.is_empty() {
            self.lost.copy_from_slice(lost);
            let tools = self.tools.iter_mut().filter_map(|tool| tool.friction.as_mut());
            tools.zip(anchors).for_each(|(friction, rows)| friction.take_up(rows));
        }
        rest.is_empty()
    }

    /// Bytes that they hold.
    pub fn bytes(&self) -> usize {
        let of = |tool: &Touched| {
            size_of_val(tool.contact.surface.vertices())
                + tool.watch.bytes()
                + tool.friction.as_ref().map_or(0, Friction::bytes)
        };
        self.tools.iter().map(of).sum::<usize>() + size_of_val(&self.forces[..]) + size_of_val(&self.lost[..])
    }
}

impl Touched {
    /// How far it has moved and turned at an instant, from an origin, by the load case that its motion belongs to.
    fn pose(&self, at: Instant, under_way: LoadCase, origin: &Vec3) -> Pose {
        let share = self.case.factor(under_way, at.level) * self.amplitude.value(at.time);
        Pose { moved: self.motion.moved * share - origin, angle: self.motion.angle * share }
    }
}

fn place(state: &[Row]) -> impl Fn(u32) -> Vec3 {
    |a| {
        let row = &state[a as usize];
        Vec3::new(row[0], row[1], row[2])
    }
}

fn push(forces: &mut [Row], a: u32, force: &Vec3) {
    (0..3).for_each(|k| forces[a as usize][k] += force[k]);
}
