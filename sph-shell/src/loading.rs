//! What acts on a shell from outside: loads, springs and a fluid, and the rows in which their forces are summed.

use explicit_dynamics::{Instant, Push};
use sph_core::Vec3;

use crate::conditions::body::{Block, Body};
use crate::conditions::case::LoadCase;
use crate::conditions::cavity::Enclosed;
use crate::conditions::frozen::FrozenContact;
use crate::conditions::loads::AppliedLoad;
use crate::conditions::on_share::OnShare;
use crate::conditions::own_contact::SelfContact;
use crate::conditions::springs::Springs;
use crate::conditions::tools::Tools;
use crate::dependents::Dependents;
use crate::junction::group::{Group, Junctions};
use crate::junction::springs::BodySprings;
use crate::motion::{Moving, row_of};
use crate::packs::Row;
use crate::reference::Reference;
use crate::wetted::surface::Surface;

/// Loads, springs, contact and the wet surface, with their forces as last evaluated.
pub(crate) struct Loading {
    pub loads: Vec<AppliedLoad>,
    /// The load case that is under way.
    pub case: LoadCase,
    pub springs: Springs,
    /// What the shell may touch.
    pub tools: Tools,
    /// The shell as it touches itself.
    pub own_contact: Option<Box<SelfContact>>,
    /// Contact as it stood in a state, in place of what touches now.
    pub frozen: Option<Box<FrozenContact>>,
    /// What a fluid wets.
    pub wetted: Option<Box<Surface>>,
    /// Forces that a function exerts.
    pub push: Option<Box<Push>>,
    /// Forces that other bodies exert on particles, and couples on directors by their numbers behind them; empty of a shell alone.
    pub exerted: Vec<(u32, [f64; 3])>,
    /// The part of loads and springs that is evaluated here, where others march the shell too.
    pub on_share: Option<Box<OnShare>>,
    /// External forces; empty without loads.
    external: Vec<Row>,
    /// Whether all of them are zero: there are tools alone, and nothing touches them.
    idle: bool,
    /// Forces of the springs on each particle; empty without springs on particles.
    pub spring_forces: Vec<Row>,
}

/// Which of the forces are summed.
#[derive(Clone, Copy)]
enum Part {
    /// All of them at an instant.
    Whole(Instant),
    /// All but contact.
    Loads(Instant),
    /// What a unit of level adds to them.
    Rate { level: f64 },
}

impl Loading {
    /// What acts on so many particles.
    pub fn new(
        loads: Vec<AppliedLoad>,
        springs: Springs,
        tools: Tools,
        own_contact: Option<Box<SelfContact>>,
        wetted: Option<Box<Surface>>,
        particles: usize,
    ) -> Self {
        let rows = |wanted: bool| vec![[0.0; 6]; if wanted { particles } else { 0 }];
        let acts = !loads.is_empty() || !springs.is_empty() || !tools.is_empty();
        Self {
            external: rows(acts || own_contact.is_some() || wetted.is_some()),
            spring_forces: rows(springs.any_on_particles()),
            idle: false,
            case: LoadCase::Loading,
            loads,
            springs,
            tools,
            own_contact,
            frozen: None,
            wetted,
            push: None,
            exerted: Vec::new(),
            on_share: None,
        }
    }

    /// Adds the forces of the springs on particles in a state.
    pub fn add_springs(&self, body: &Body<'_>, rows: &mut [Row]) {
        OnShare::springs(self.on_share.as_deref(), &self.springs).add(body, rows);
    }

    /// Lets a function exert forces on so many particles.
    pub fn push(&mut self, push: Push, particles: usize) {
        self.external.resize(particles, [0.0; 6]);
        self.push = Some(Box::new(push));
    }

    /// External forces for a march; empty where there are none.
    pub fn in_march(&self) -> &[Row] {
        if self.idle { &[] } else { &self.external }
    }

    /// The rows of external forces last evaluated, empty without loads, and those of springs among them.
    pub fn rows_mut(&mut self) -> [&mut [Row]; 2] {
        [&mut self.external, &mut self.spring_forces]
    }

    /// Takes away what other bodies exert.
    pub fn release(&mut self) {
        self.exerted.clear();
    }

    /// Adds what other bodies exert on some of so many particles, from now on until [`Loading::release`].
    pub fn exert(&mut self, particles: &[u32], forces: &[[f64; 3]], count: usize) {
        self.external.resize(count, [0.0; 6]);
        self.exerted.extend(particles.iter().copied().zip(forces.iter().copied()));
    }

    /// Load on a particle for the last forces evaluated \[F, F L\].
    pub fn external_force(&self, particle: usize) -> Row {
        self.external.get(particle).copied().unwrap_or_default()
    }

    /// What its springs exert on a particle \[F, F L\], for the last forces evaluated.
    pub fn spring_force(&self, particle: usize) -> Row {
        self.spring_forces.get(particle).copied().unwrap_or_default()
    }

    /// The springs of rigid bodies in a state.
    pub fn of_bodies<'a>(
        &'a self,
        reference: &'a Reference,
        junctions: &'a Junctions,
        state: &'a [Row],
    ) -> BodySprings<'a> {
        BodySprings { springs: &self.springs.of_bodies, junctions, reference, state }
    }

    /// Evaluates the loads at an instant of the case that is under way, with the springs, what the fluid and what a function exerts. Before forces
    /// go on to what bears a particle, `bring` sees to those that others evaluate.
    pub fn evaluate(
        &mut self,
        at: Instant,
        reference: &Reference,
        dependents: &mut Dependents,
        motion: &mut Moving,
        bring: impl FnOnce(&mut [Row]),
    ) {
        let (part, under_way) = (Part::Whole(at), self.case);
        self.sum(part, |applied| applied.scale(at, under_way), reference, dependents, motion, bring);
    }

    /// The same without contact.
    pub fn evaluate_loads(
        &mut self,
        at: Instant,
        reference: &Reference,
        dependents: &mut Dependents,
        motion: &mut Moving,
    ) {
        let under_way = self.case;
        let scale = |applied: &AppliedLoad| applied.scale(at, under_way);
        self.sum(Part::Loads(at), scale, reference, dependents, motion, |_| ());
    }

    /// Energy of contact for the forces last evaluated \[F L\].
    pub fn contact_energy(&self) -> f64 {
        let own = self.own_contact.as_ref().map_or(0.0, |own| own.touch().energy);
        self.tools.touches().iter().map(|touch| touch.energy).sum::<f64>() + own
    }

    /// Evaluates what a unit of level adds at a level to the loads of the case that is under way.
    pub fn evaluate_rate(
        &mut self,
        level: f64,
        reference: &Reference,
        dependents: &mut Dependents,
        motion: &mut Moving,
    ) {
        let (at, under_way) = (Instant { time: 0.0, level: 1.0 }, self.case);
        let scale = |applied: &AppliedLoad| {
            if applied.load.case() == under_way { applied.scale(at, under_way) } else { 0.0 }
        };
        self.sum(Part::Rate { level }, scale, reference, dependents, motion, |_| ());
    }

    /// Sums the loads, each times a factor, with what tools exert; at an instant, with the springs and what a function exerts then.
    fn sum(
        &mut self,
        part: Part,
        scale: impl Fn(&AppliedLoad) -> f64,
        reference: &Reference,
        dependents: &mut Dependents,
        motion: &mut Moving,
        bring: impl FnOnce(&mut [Row]),
    ) {
        if self.external.is_empty() {
            return;
        }
        dependents.ties.put(&mut motion.state);
        let now = match part {
            Part::Whole(at) | Part::Loads(at) => Some(at),
            Part::Rate { .. } => None,
        };
        let touching = match part {
            Part::Whole(at) if self.frozen.is_none() => self.tools.evaluate(at, self.case, &motion.state),
            _ => true,
        };
        let tools_alone = self.loads.is_empty()
            && self.spring_forces.is_empty()
            && self.wetted.is_none()
            && self.push.is_none()
            && self.own_contact.as_ref().is_none_or(|own| own.rests())
            && self.exerted.is_empty()
            && dependents.is_empty();
        if tools_alone && !touching && self.idle {
            return;
        }
        self.idle = tools_alone && !touching;
        self.evaluate_bodies(now.is_some(), &scale, reference, &mut dependents.junctions, &motion.state);
        let Self {
            loads,
            case,
            springs,
            tools,
            own_contact,
            frozen,
            wetted,
            push,
            exerted,
            on_share,
            external,
            spring_forces,
            ..
        } = self;
        let body = dependents.loaded(reference, &motion.state);
        let on_share = on_share.as_deref();
        let own = OnShare::clear(on_share, external);
        for (number, applied) in loads.iter().enumerate() {
            match (applied.load.enclosed(), part) {
                (Some(enclosed), Part::Rate { .. }) => enclosed.add_rate(scale(applied), &body, external),
                _ => OnShare::add(on_share, (number, applied), scale(applied), &body, external),
            }
        }
        if let Some(surface) = wetted {
            surface.add(&motion.rates, external);
        }
        if let (Some(push), Some(now)) = (push, now) {
            let vector = |row: &Row| [row[0], row[1], row[2]];
            let of = |a: usize| [reference.from_zero(motion.place(a)).into(), vector(&motion.rates[a])];
            for (sum, force) in external[own.clone()].iter_mut().zip(&push.forces(now, of)[own.clone()]) {
                (0..3).for_each(|k| sum[k] += force[k]);
            }
        }
        for (number, force) in exerted.iter().filter(|_| now.is_some()) {
            let (a, place) = row_of(*number, external.len());
            (0..3).for_each(|k| external[a][place + k] += force[k]);
        }
        if now.is_some() && !spring_forces.is_empty() {
            OnShare::clear(on_share, spring_forces);
            OnShare::springs(on_share, springs).add(&body, spring_forces);
            for (sum, row) in external[own.clone()].iter_mut().zip(&spring_forces[own]) {
                (0..6).for_each(|k| sum[k] += row[k]);
            }
        }
        match part {
            Part::Whole(_) => match (frozen, own_contact) {
                (Some(frozen), _) => frozen.add(&motion.state, external),
                (None, own) => {
                    tools.add(external);
                    own.iter_mut().for_each(|own| own.add(&motion.state, external));
                }
            },
            Part::Loads(_) => {}
            Part::Rate { level } => {
                tools.add_rates(Instant { time: 0.0, level }, *case, &motion.state, external)
            }
        }
        bring(external);
        dependents.ties.condense_external(&motion.state, external);
    }

    /// Evaluates the loads on rigid bodies, each load times a factor, with what springs exert on them where that is wanted.
    fn evaluate_bodies(
        &self,
        springs: bool,
        scale: impl Fn(&AppliedLoad) -> f64,
        reference: &Reference,
        junctions: &mut Junctions,
        state: &[Row],
    ) {
        for number in 0..junctions.groups.len() {
            let group = &junctions.groups[number];
            let Some(body) = &group.body else { continue };
            let triad = group.triad(state);
            let mut sum = match springs {
                true => self.of_bodies(reference, junctions, state).on_body(body.number),
                false => [Vec3::zeros(); 2],
            };
            for applied in &self.loads {
                let Some(own) = applied.load.on_body(body.number, body.mass) else { continue };
                let factor = scale(applied);
                sum.iter_mut().zip(own).for_each(|(sum, part)| *sum += part * factor);
            }
            if let Some(body) = &mut junctions.groups[number].body {
                body.take(&triad, sum);
            }
        }
    }

    /// What is enclosed, with its share at a level of the case that is under way.
    pub fn enclosed(&self, level: f64) -> impl Iterator<Item = (&Enclosed, f64)> {
        let at = Instant { time: 0.0, level };
        self.loads
            .iter()
            .filter_map(move |applied| Some((applied.load.enclosed()?, applied.scale(at, self.case))))
    }

    /// The derivatives of all loads at a level, of the springs on particles, of what tools and of what the shell exerts on itself, block by
    /// block; the last for the forces last evaluated.
    pub fn stiffness(&self, level: f64, body: &Body<'_>, put: &mut dyn FnMut(u32, u32, &Block)) {
        for applied in &self.loads {
            let scale = applied.scale(Instant { time: 0.0, level }, self.case);
            applied.load.stiffness(scale, body, put);
        }
        self.springs.stiffness(body, put);
        if let Some(frozen) = &self.frozen {
            return frozen.stiffness(put);
        }
        self.tools.stiffness(Instant { time: 0.0, level }, self.case, body.state, put);
        if let Some(own) = &self.own_contact {
            own.tangent(body.state, put);
        }
    }

    /// Freezes contact as it stands at a level in a state, at which forces were last evaluated.
    pub fn freeze(&mut self, level: f64, state: &[Row]) {
        let mut blocks = Vec::new();
        let mut put = |a: u32, b: u32, block: &Block| blocks.push((a, b, *block));
        self.tools.stiffness_that_sticks(Instant { time: 0.0, level }, self.case, state, &mut put);
        let mut forces = vec![[0.0; 6]; state.len()];
        self.tools.add(&mut forces);
        if let Some(own) = &mut self.own_contact {
            own.tangent(state, &mut put);
            own.add(state, &mut forces);
        }
        self.frozen = Some(Box::new(FrozenContact::new(state, forces, blocks)));
    }

    /// Couples of the loads on rigid bodies at level one, with the particle that stands for each body \[F L\].
    pub fn couples_on_bodies(&self, junctions: &Junctions) -> Vec<(u32, Vec3)> {
        let at = Instant { time: 0.0, level: 1.0 };
        let couple = |group: &Group| {
            let body = group.body.as_ref()?;
            let own = |applied: &AppliedLoad| {
                Some(applied.load.on_body(body.number, body.mass)?[1] * applied.scale(at, self.case))
            };
            Some((group.first() as u32, self.loads.iter().filter_map(own).sum::<Vec3>()))
        };
        let couples = junctions.groups.iter().filter_map(couple);
        couples.filter(|(_, couple)| *couple != Vec3::zeros()).collect()
    }

    /// Energy that friction took on the way to the forces last evaluated, from what was committed \[F L\].
    pub fn rubbed(&self) -> f64 {
        self.tools.lost() + self.own_contact.as_ref().map_or(0.0, |own| own.friction().lost())
    }

    /// Whether the shell may touch anything, itself or a tool.
    pub fn touches(&self) -> bool {
        !self.tools.is_empty() || self.own_contact.is_some()
    }

    /// Adds the forces of contact that a small motion from a state meets at most, as if all of the shell touched.
    pub fn add_contact_bounds(&self, state: &[Row], home: &[Row], forces: &mut [Row]) {
        self.tools.add_bounds(state, home, forces);
        if let Some(own) = &self.own_contact {
            own.add_bounds(state, home, forces);
        }
    }

    /// Bytes of the rows and of the wet surface.
    pub fn bytes(&self) -> usize {
        size_of::<Row>() * (self.external.len() + self.spring_forces.len())
            + self.tools.bytes()
            + self.own_contact.as_ref().map_or(0, |own| own.bytes())
            + self.wetted.as_ref().map_or(0, |surface| surface.bytes())
            + self.push.as_ref().map_or(0, |push| push.bytes())
            + size_of::<(u32, [f64; 3])>() * self.exerted.len()
    }
}
