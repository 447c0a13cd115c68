//! Joints of rigid bodies, to each other and to the ground: exact constraints in time.
//!
//! A joint is a few scalar constraints `g(q) = 0` of two frames, of which the first may be the ground:
//!
//! ```text
//! a place in both     g = n·(x₂ − x₁)        n fixed in space, or in the first frame
//! two axes            g = e₁·f₂              square to each other at rest
//! ```
//!
//! A ball joint has three places along three directions; a hinge also its axis square to two directions of the first frame; a slider the place on the line
//! of its axis, and three pairs of axes. In a step of central differences the impulses `Gᵀλ`, G the derivative of g at the places where the forces are
//! evaluated, are such that g vanishes where the drift arrives [ryckaert1977], [andersen1983]:
//!
//! ```text
//! q₊ = drift(kick(f + Gᵀλ/κ))        g(q₊) = 0        λ ← λ − (G M⁻¹ Gᵀ)⁺ g(q₊)/Δt
//! ```
//!
//! Each round gains a factor of the turn in a step, until g is rounding; nothing of it is left for the next step to inherit. Both bodies of a joint feel opposite
//! forces at one place and opposite couples: momentum and moment of momentum are kept to rounding. Constraints of which some follow from others, as in a
//! plane chain of hinges, are found by eigenvalues; of them the least impulses are taken.

use explicit_dynamics::{Step, Work};
use nalgebra::{DMatrix, DVector, Matrix3, SymmetricEigen};
use sph_core::Vec3;

use crate::body::{Motion, RigidBody};
use crate::conditions::Wrench;

/// Rounds of the solution, at most.
const ROUNDS: usize = 50;
/// Rounds of the search for eigenvalues, at most.
const SWEEPS: usize = 10_000;
/// What rounding leaves of a constraint, over its size.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Part of its size by which a joint may be missed.
const MISSED: f64 = 1e-7;
/// Eigenvalues of the constraints, scaled, below which one follows from others, over the greatest.
const FOLLOWS: f64 = 1e-11;

/// What a joint leaves free.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum JointKind {
    /// All turns about its place.
    Ball,
    /// Turns about an axis (any length) through its place.
    Hinge(Vec3),
    /// Ways along an axis (any length) through its place.
    Slider(Vec3),
}

/// A joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// The body on which it is, by its number.
    pub on: usize,
    /// The body to which it joins that one; none for the ground.
    pub to: Option<usize>,
    /// Where it is at rest \[L\].
    pub at: Vec3,
    /// What it leaves free.
    pub kind: JointKind,
}

/// A scalar constraint of the first frame, that of `to`, and the second, that of `on`; arms and axes in the axes of each.
#[derive(Clone, Copy, Debug)]
enum Constraint {
    /// `n·(x₂ − x₁)`, n turning with the first frame or fixed in space.
    Place { arms: [Vec3; 2], along: Vec3, turning: bool },
    /// `e₁·f₂`.
    Square { axes: [Vec3; 2] },
}

/// Where a body, or the ground, is.
#[derive(Clone, Copy, Debug)]
struct Frame {
    pole: Vec3,
    axes: Matrix3<f64>,
}

impl Frame {
    const fn ground() -> Self {
        Self {
            pole: Vec3::new(0.0, 0.0, 0.0),
            axes: Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
        }
    }

    fn of(motion: &Motion) -> Self {
        Self { pole: motion.pole, axes: motion.turn.axes() }
    }

    /// A vector of space in its axes.
    fn own(&self, v: &Vec3) -> Vec3 {
        self.axes.tr_mul(v)
    }
}

impl Constraint {
    /// Its value, and the length of which rounding is a part; none of axes.
    fn value(&self, [first, second]: [&Frame; 2]) -> [f64; 2] {
        match self {
            Self::Place { arms, along, turning } => {
                let n = if *turning { first.axes * along } else { *along };
                let [a, b] = [first.axes * arms[0], second.axes * arms[1]];
                let apart = (second.pole + b) - (first.pole + a);
                [n.dot(&apart), first.pole.norm() + second.pole.norm() + a.norm() + b.norm()]
            }
            Self::Square { axes } => [(first.axes * axes[0]).dot(&(second.axes * axes[1])), 0.0],
        }
    }

    /// Its derivative by the motions of both frames: a force and a moment about the pole each.
    fn wrenches(&self, [first, second]: [&Frame; 2]) -> [Wrench; 2] {
        let mut out = [Wrench::default(); 2];
        match self {
            Self::Place { arms, along, turning } => {
                let n = if *turning { first.axes * along } else { *along };
                // Both feel it at one place, where the two of a joint without a slider are but for rounding.
                let place = second.pole + second.axes * arms[1];
                out[0].add(&-n, &(place - first.pole));
                out[1].add(&n, &(place - second.pole));
            }
            Self::Square { axes } => {
                let couple = (first.axes * axes[0]).cross(&(second.axes * axes[1]));
                (out[0].moment, out[1].moment) = (couple, -couple);
            }
        }
        out
    }
}

/// Joints of bodies, and what they exert.
#[derive(Clone, Debug, Default)]
pub struct Joints {
    /// Constraints with the numbers of their bodies, the ground none.
    constraints: Vec<([Option<usize>; 2], Constraint)>,
    /// The joint of each, by its number.
    joint_of: Vec<usize>,
    /// What each joint exerts on the body on which it is, about the origin.
    of_joints: Vec<Wrench>,
    /// What they exert on each body in this step, and its velocity and moment of momentum before it.
    exerted: Vec<(Wrench, [Vec3; 2])>,
    /// By how much the joints were missed at the end of the last step, over their size.
    missed: f64,
}

impl Joints {
    /// Joints of bodies as they stand at rest; a number beyond them has no constraint.
    pub fn new(bodies: &[&RigidBody], joints: &[Joint]) -> Self {
        let mut all = Self { of_joints: vec![Wrench::default(); joints.len()], ..Self::default() };
        for (number, Joint { on, to, at, kind }) in joints.iter().enumerate() {
            let frame = |body: usize| bodies.get(body).map(|body| Frame::of(&body.motion));
            let (Some(second), Some(first)) = (frame(*on), to.map_or(Some(Frame::ground()), frame)) else {
                continue;
            };
            let frames = [&first, &second];
            let arms = frames.map(|frame| frame.own(&(at - frame.pole)));
            let square = |e: &Vec3, f: &Vec3| Constraint::Square { axes: [first.own(e), second.own(f)] };
            let mut put = |constraint| {
                all.constraints.push(([*to, Some(*on)], constraint));
                all.joint_of.push(number);
            };
            match kind {
                JointKind::Ball | JointKind::Hinge(_) => {
                    for along in [Vec3::x(), Vec3::y(), Vec3::z()] {
                        put(Constraint::Place { arms, along, turning: false });
                    }
                    if let JointKind::Hinge(axis) = kind {
                        let [n, e, f] = triad(axis);
                        put(square(&e, &n));
                        put(square(&f, &n));
                    }
                }
                JointKind::Slider(axis) => {
                    let [n, e, f] = triad(axis);
                    for across in [e, f] {
                        put(Constraint::Place { arms, along: first.own(&across), turning: true });
                    }
                    put(square(&e, &n));
                    put(square(&f, &n));
                    put(square(&e, &f));
                }
            }
        }
        all
    }

    /// Number of scalar constraints.
    pub fn len(&self) -> usize {
        self.constraints.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.constraints.is_empty()
    }

    /// Before a kick, its forces evaluated: adds what the joints exert to the forces on the bodies. A kick of no span gives and takes velocities at once, so
    /// that the joints bear them.
    pub fn brace(&mut self, bodies: &mut [&mut RigidBody], step: &Step) {
        let frames: Vec<Frame> = bodies.iter().map(|body| Frame::of(&body.motion)).collect();
        let rows: Vec<[Wrench; 2]> =
            self.constraints.iter().map(|(of, own)| own.wrenches(of_both(of, &frames))).collect();
        let flexible = self.flexible(bodies, &rows);
        let mut impulses = DVector::zeros(self.constraints.len());
        if step.kick == 0.0 || step.drift() == 0.0 {
            let rates = self.constraints.iter().zip(&rows).map(|((of, _), rows)| {
                of.iter()
                    .zip(rows)
                    .map(|(of, row)| of.map_or(0.0, |body| row.rate(bodies[body])))
                    .sum::<f64>()
            });
            impulses -= &flexible * DVector::from_iterator(self.constraints.len(), rates);
            for (body, impulse) in bodies.iter_mut().zip(self.on_bodies(&rows, &impulses, frames.len())) {
                body.strike(&impulse);
            }
            let before =
                |body: &&mut RigidBody| (Wrench::default(), [body.motion.velocity, body.motion.spin]);
            self.exerted = bodies.iter().map(before).collect();
            return;
        }
        let span = step.drift() * step.decay().after;
        let mut last = f64::INFINITY;
        let mut found = impulses.clone();
        for _ in 0..ROUNDS {
            let wrenches = self.on_bodies(&rows, &impulses, frames.len());
            let ends: Vec<Frame> =
                bodies.iter().zip(&wrenches).map(|(body, own)| end(body, own, step)).collect();
            let values = self.constraints.iter().map(|(of, own)| own.value(of_both(of, &ends)));
            let values: Vec<[f64; 2]> = values.collect();
            // One length for all: a joint at a centre in the origin has none of its own.
            let length = values.iter().map(|[_, size]| *size).fold(0.0, f64::max);
            let part =
                |[value, size]: &[f64; 2]| value.abs() * if *size > 0.0 { inverse(length) } else { 1.0 };
            let most = values.iter().map(part).fold(0.0, f64::max);
            if most < last {
                (found, last) = (impulses.clone(), most);
            }
            if most <= ROUNDING || most > last {
                break;
            }
            let missed = DVector::from_iterator(values.len(), values.iter().map(|[value, _]| *value));
            impulses -= &flexible * missed / span;
        }
        self.missed = last;
        self.take_note(&rows, &found, &frames, step.kick);
        let wrenches = self.on_bodies(&rows, &found, frames.len());
        self.exerted.clear();
        for (body, impulse) in bodies.iter_mut().zip(wrenches) {
            let force = impulse.scaled(1.0 / step.kick);
            body.external = body.external + force;
            self.exerted.push((force, [body.motion.velocity, body.motion.spin]));
        }
    }

    /// Behind the kick: takes what the joints did out of the work of loads. Joints do none but what the way of a step leaves.
    pub fn settle(&self, bodies: &[&RigidBody], step: &Step, work: &mut Work) {
        for (body, (force, [old, old_spin])) in bodies.iter().zip(&self.exerted) {
            let mean = (old + body.motion.velocity) * 0.5;
            let mean_spin = body.spin_of(&((old_spin + body.motion.spin) * 0.5));
            work.external -= step.kick * (force.force.dot(&mean) + force.moment.dot(&mean_spin));
        }
    }

    /// Force \[F\] on a body and its moment about the centre \[F L\] in the last step.
    pub fn exerted(&self, body: usize) -> [Vec3; 2] {
        self.exerted.get(body).map_or([Vec3::zeros(); 2], |(force, _)| [force.force, force.moment])
    }

    /// Force \[F\] of a joint on the body on which it is, in the last step, and its moment about the origin \[F L\]; the body that it joins to that one feels the
    /// opposite. Of supports and constraints that say the same, as hinges of a plane chain do, each bears the least that serves.
    pub fn of_joint(&self, joint: usize) -> [Vec3; 2] {
        self.of_joints.get(joint).map_or([Vec3::zeros(); 2], |own| [own.force, own.moment])
    }

    /// Keeps what each joint exerts, of impulses along the constraints in a kick of this span.
    fn take_note(&mut self, rows: &[[Wrench; 2]], impulses: &DVector<f64>, frames: &[Frame], span: f64) {
        self.of_joints.fill(Wrench::default());
        for (i, (of, _)) in self.constraints.iter().enumerate() {
            let (Some(body), joint) = (of[1], self.joint_of[i]) else { continue };
            let own = rows[i][1].scaled(impulses[i] / span);
            let about = Wrench { moment: own.moment + frames[body].pole.cross(&own.force), ..own };
            self.of_joints[joint] = self.of_joints[joint] + about;
        }
    }

    /// By how much joints were missed at the end of the last step, over their size, beyond what the solution leaves: supports say otherwise. None where they hold.
    pub fn missed(&self) -> Option<f64> {
        // What is no number is missed as well.
        (self.missed > MISSED || self.missed.is_nan()).then_some(self.missed)
    }

    /// `(G M⁻¹ Gᵀ)⁺`, of scaled constraints; what supports hold of a body gives no way to a constraint.
    fn flexible(&self, bodies: &[&mut RigidBody], rows: &[[Wrench; 2]]) -> DMatrix<f64> {
        let count = rows.len();
        let mut all = DMatrix::<f64>::zeros(count, count);
        for (number, body) in bodies.iter().enumerate() {
            let own = |(i, (of, _)): (usize, &([Option<usize>; 2], Constraint))| {
                let side = of.iter().position(|of| *of == Some(number))?;
                Some((i, body.scaled_wrench(&rows[i][side])))
            };
            let own: Vec<_> = self.constraints.iter().enumerate().filter_map(own).collect();
            for (i, left) in &own {
                own.iter().for_each(|(j, right)| all[(*i, *j)] += left.dot(right));
            }
        }
        let mut whole = vec![0.0; count];
        for (i, (of, _)) in self.constraints.iter().enumerate() {
            for (of, row) in of.iter().zip(&rows[i]) {
                whole[i] += of.map_or(0.0, |body| bodies[body].yields_to(row));
            }
        }
        let scale =
            |i: usize| if all[(i, i)] > FOLLOWS * whole[i] { inverse(all[(i, i)].sqrt()) } else { 0.0 };
        let scale = DVector::from_iterator(count, (0..count).map(scale));
        for i in 0..count {
            (0..count).for_each(|j| all[(i, j)] *= scale[i] * scale[j]);
        }
        // What is no number, of a march that blows up, has no eigenvalues.
        let Some(eigen) = SymmetricEigen::try_new(all, f64::EPSILON, SWEEPS) else {
            return DMatrix::zeros(count, count);
        };
        let least = FOLLOWS * eigen.eigenvalues.max();
        let inverses = eigen.eigenvalues.map(|value| if value > least { 1.0 / value } else { 0.0 });
        let mut out =
            &eigen.eigenvectors * DMatrix::from_diagonal(&inverses) * eigen.eigenvectors.transpose();
        for i in 0..count {
            (0..count).for_each(|j| out[(i, j)] *= scale[i] * scale[j]);
        }
        out
    }

    /// What impulses along the constraints amount to on each body.
    fn on_bodies(&self, rows: &[[Wrench; 2]], impulses: &DVector<f64>, bodies: usize) -> Vec<Wrench> {
        let mut sums = vec![Wrench::default(); bodies];
        for (((of, _), rows), impulse) in self.constraints.iter().zip(rows).zip(impulses.iter()) {
            for (of, row) in of.iter().zip(rows) {
                if let Some(body) = of {
                    sums[*body] = sums[*body] + row.scaled(*impulse);
                }
            }
        }
        sums
    }
}

/// Where a body arrives at the end of a step with an impulse more.
fn end(body: &RigidBody, impulse: &Wrench, step: &Step) -> Frame {
    let push = body.external + impulse.scaled(1.0 / step.kick) - body.internal;
    let [velocity, spin] = body.kicked(step, &push);
    Frame::of(&body.drifted(Motion { velocity, spin, ..body.motion }, step.drift()))
}

/// The two frames of a constraint.
fn of_both<'a>(of: &[Option<usize>; 2], frames: &'a [Frame]) -> [&'a Frame; 2] {
    const GROUND: Frame = Frame::ground();
    of.map(|body| body.map_or(&GROUND, |body| &frames[body]))
}

fn inverse(x: f64) -> f64 {
    if x > 0.0 { 1.0 / x } else { 0.0 }
}

/// A unit vector along an axis, and two square to it and to each other.
fn triad(axis: &Vec3) -> [Vec3; 3] {
    let n = axis.normalize();
    let e = n.cross(&Vec3::ith(n.iamin(), 1.0)).normalize();
    [n, e, n.cross(&e)]
}

impl Wrench {
    fn scaled(&self, factor: f64) -> Self {
        Self { force: self.force * factor, moment: self.moment * factor }
    }

    /// Its power in the motion of a body.
    fn rate(&self, body: &RigidBody) -> f64 {
        self.force.dot(&body.motion.velocity) + self.moment.dot(&body.spin())
    }
}
