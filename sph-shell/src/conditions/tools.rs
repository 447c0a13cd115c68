//! Rigid tools that a shell may touch: they push by a potential, in every analysis, and move as level and time say.

use contact::{Law, Surface, ToolContact, ToolShape, Touch, Watch};
use explicit_dynamics::{Amplitude, Instant};
use sph_core::Vec3;

use crate::conditions::case::LoadCase;
use crate::conditions::loads::{Block, place_block};
use crate::error::ShellError;
use crate::packs::Row;
use crate::reference::Reference;

/// A tool before the shell is built.
///
/// It pushes on both faces of the shell, whose particles lie in the middle of its thickness: the mid-surface stands half a thickness off the
/// tool when they touch (crate `contact`). The loss of friction is none: tools are smooth.
#[derive(Clone, Debug)]
pub struct Tool {
    /// Its shape and place at level zero, from zero.
    pub shape: ToolShape,
    /// How far it has moved at level one \[L\].
    pub moved: Vec3,
    /// What of that a time brings.
    pub amplitude: Amplitude,
    /// The law of contact.
    pub law: Law,
    /// Stiffness κ of a unit of area \[F/L³\]; [`contact::stiffness`] has one.
    pub stiffness: f64,
}

/// Bound of the speed of any particle of a march over the speed of sound.
const FASTEST: f64 = 2.0;

/// A tool with the surface that it may touch.
#[derive(Clone, Debug)]
struct Touched {
    contact: ToolContact,
    watch: Watch,
    moved: Vec3,
    amplitude: Amplitude,
    /// Where it stood when forces were last evaluated.
    stood: Vec3,
}

/// All tools of a shell.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tools {
    tools: Vec<Touched>,
    /// What each of them and the shell do to each other, for the forces last evaluated.
    touches: Vec<Touch>,
    /// Forces of all of them on each particle.
    forces: Vec<Row>,
    /// Whether any of these is not zero.
    touching: bool,
    origin: Vec3,
    /// No particle of a march is faster \[L/T\].
    fastest: f64,
    /// When forces were last evaluated; infinite if the shell was moved by hand since.
    time: f64,
}

impl Tools {
    /// The tools of a shell with half of its thickness at each particle \[L\].
    ///
    /// # Errors
    /// [`ShellError`] for shapes without sense and a stiffness that is not positive.
    pub fn new(tools: Vec<Tool>, reference: &Reference, half: &[f64]) -> Result<Self, ShellError> {
        let cloud = &reference.cloud;
        let surface = Surface::new(&cloud.cells, &cloud.positions, |a| half[a as usize]);
        let touched = |tool: Tool| {
            let Tool { shape, moved, amplitude, law, stiffness } = tool;
            if !(stiffness > 0.0 && stiffness.is_finite()) {
                return Err(ShellError::ToolStiffness(stiffness));
            }
            let contact = ToolContact { tool: shape.checked()?, surface: surface.clone(), law, stiffness };
            let watch = Watch::new(&contact.surface);
            Ok(Touched { contact, watch, moved, amplitude, stood: Vec3::zeros() })
        };
        let tools = tools.into_iter().map(touched).collect::<Result<Vec<_>, ShellError>>()?;
        Ok(Self {
            tools,
            touches: Vec::new(),
            forces: vec![[0.0; 6]; cloud.len()],
            touching: false,
            origin: reference.origin,
            fastest: FASTEST * reference.sound_speed,
            time: f64::INFINITY,
        })
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
        let Self { tools, touches, forces, touching, origin, fastest, time } = self;
        touches.clear();
        if std::mem::take(touching) {
            forces.fill([0.0; 6]);
        }
        let gone = if at.time > *time { Some(*fastest * (at.time - *time)) } else { None };
        *time = at.time;
        for tool in tools.iter_mut() {
            let moved = tool.moved_at(at, under_way) - *origin;
            match gone {
                Some(gone) => tool.watch.count(gone + (moved - tool.stood).norm()),
                None => tool.watch.forget(),
            }
            tool.stood = moved;
            let push = |a, force: Vec3| push(forces, a, &force);
            let touch = tool.contact.forces(&mut tool.watch, &moved, place(state), push);
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
            tool.contact.least_gap(&(tool.moved_at(at, under_way) - self.origin), place(state))
        };
        self.tools.iter().map(gap).collect()
    }

    /// Force of all tools on a particle, for the forces last evaluated.
    pub fn force(&self, particle: usize) -> Vec3 {
        self.forces.get(particle).map_or_else(Vec3::zeros, |row| Vec3::new(row[0], row[1], row[2]))
    }

    /// Stiffness of each tool.
    pub fn stiffnesses(&self) -> impl Iterator<Item = f64> {
        self.tools.iter().map(|tool| tool.contact.stiffness)
    }

    /// Adds what a unit of level adds to their forces, where it moves them.
    pub fn add_rates(&self, at: Instant, under_way: LoadCase, state: &[Row], forces: &mut [Row]) {
        if under_way != LoadCase::Loading {
            return;
        }
        for tool in self.tools.iter().filter(|tool| tool.moved != Vec3::zeros()) {
            let moved = tool.moved_at(at, under_way) - self.origin;
            let rate = tool.moved * tool.amplitude.value(at.time);
            tool.contact.rates(&moved, &rate, place(state), |a, force| push(forces, a, &force));
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
            let moved = tool.moved_at(at, under_way) - self.origin;
            tool.contact.tangent(&moved, place(state), |a, b, change| put(a, b, &place_block(0, 0, change)));
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

    /// Bytes that they hold.
    pub fn bytes(&self) -> usize {
        let of = |tool: &Touched| size_of_val(tool.contact.surface.vertices()) + tool.watch.bytes();
        self.tools.iter().map(of).sum::<usize>() + size_of_val(&self.forces[..])
    }
}

impl Touched {
    /// How far it has moved at an instant; it stands while a preload is brought up.
    fn moved_at(&self, at: Instant, under_way: LoadCase) -> Vec3 {
        self.moved * (LoadCase::Loading.factor(under_way, at.level) * self.amplitude.value(at.time))
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
