//! Coulomb friction on a tool: elastic stick to an anchor that goes with the tool, slip beyond μ N, and what is lost.
//!
//! ```text
//! r = x − anchor,  s = r − (r·n) n        how far a vertex stands from its anchor along the face
//! force −k s                              k = κ A, as stiff as contact is across the face
//! k |s| > μ N:  s ← s μN/(k |s|),  anchor ← x − s
//! lost ½ k (s_old + s)·(s_trial − s)      the mean of the forces before and after, times the slip; ½ k s_old² where the vertex parts
//! ```
//!
//! Anchors are history: forces are found from those that were committed, and leave trial ones, which become them with
//! [`Friction::commit`].

use nalgebra::Matrix3;
use sph_core::Vec3;

use crate::pose::ToolFrame;

/// Friction of a surface on a tool.
#[derive(Clone, Debug, PartialEq)]
pub struct Friction {
    coefficient: f64,
    /// What grips the tool, by number of the vertex, as it was committed.
    kept: Vec<Grip>,
    /// The same for the forces last evaluated, with what parted since.
    trial: Vec<Grip>,
}

/// A vertex that grips the tool, in the frame of the tool.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Grip {
    vertex: u32,
    /// Where it would stand without a force along the face \[L\].
    anchor: Vec3,
    /// How far it stood from there \[L\].
    stretch: Vec3,
    /// Energy that was lost on the way to it \[F L\].
    lost: f64,
    /// Whether it touches.
    holds: bool,
}

/// A vertex on a face: its place, the normal there, how stiffly it sticks (k = κ A) and the force N on it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OnFace {
    pub vertex: u32,
    pub place: Vec3,
    pub normal: Vec3,
    pub stiffness: f64,
    pub pressed: f64,
}

impl Friction {
    /// Friction with the coefficient μ \[–\] of a surface of so many vertices, which touches nothing yet; none for a coefficient that is
    /// negative or not finite.
    pub fn new(coefficient: f64, vertices: usize) -> Option<Self> {
        (coefficient >= 0.0 && coefficient.is_finite()).then(|| Self {
            coefficient,
            kept: Vec::with_capacity(vertices),
            trial: Vec::with_capacity(vertices),
        })
    }

    /// Makes the anchors of the forces last evaluated those that count; hands to `lose` the energy that each vertex has lost \[F L\].
    pub fn commit(&mut self, mut lose: impl FnMut(u32, f64)) {
        self.kept.clear();
        self.kept.extend(self.trial.iter().filter(|grip| grip.holds));
        for grip in &mut self.trial {
            lose(grip.vertex, std::mem::take(&mut grip.lost));
        }
    }

    /// Energy lost on the way to the forces last evaluated, not committed yet \[F L\].
    pub fn lost(&self) -> f64 {
        self.trial.iter().map(|grip| grip.lost).sum()
    }

    /// How far a vertex that touches stood from its anchor when forces were last evaluated, in the frame of the tool \[L\], and the
    /// coefficient μ; none of one that had no anchor.
    pub(crate) fn held(&self, vertex: u32) -> Option<(Vec3, f64)> {
        let number = self.trial.binary_search_by_key(&vertex, |grip| grip.vertex).ok()?;
        let grip = self.trial.get(number).filter(|grip| grip.holds)?;
        Some((grip.stretch, self.coefficient))
    }

    /// The same anchors in a friction without a limit: nothing slips.
    pub fn without_slip(&self) -> Self {
        Self { coefficient: f64::INFINITY, ..self.clone() }
    }

    /// The committed anchors as seven numbers a vertex.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        let of = |grip: &Grip| {
            let [a, s] = [grip.anchor, grip.stretch];
            [f64::from(grip.vertex), a.x, a.y, a.z, s.x, s.y, s.z]
        };
        self.kept.iter().flat_map(of)
    }

    /// Takes up anchors that [`Friction::numbers`] gave.
    pub fn take_up(&mut self, rows: &[[f64; 7]]) {
        let of = |&[vertex, a, b, c, d, e, f]: &[f64; 7]| Grip {
            vertex: vertex as u32,
            anchor: Vec3::new(a, b, c),
            stretch: Vec3::new(d, e, f),
            lost: 0.0,
            holds: true,
        };
        self.kept.clear();
        self.kept.extend(rows.iter().map(of));
        self.trial.clone_from(&self.kept);
    }

    /// Bytes that it holds.
    pub fn bytes(&self) -> usize {
        size_of::<Grip>() * (self.kept.capacity() + self.trial.capacity())
    }

    /// Begins an evaluation of forces.
    pub(crate) fn begin(&mut self) -> Sticking<'_> {
        self.trial.clear();
        Sticking { friction: self, next: 0 }
    }

    /// Derivatives by its place of the force along the face on a vertex, without that of N, and its anchor in space; none for a vertex
    /// that has no anchor yet.
    ///
    /// Stick `−k (1 − n nᵀ)`, slip `−(μN/|s_trial|) (1 − n nᵀ − ŝ ŝᵀ)`.
    pub(crate) fn stiffness(&self, frame: &ToolFrame, on: &OnFace) -> Option<(Matrix3<f64>, Vec3)> {
        let number = self.kept.binary_search_by_key(&on.vertex, |grip| grip.vertex).ok()?;
        let along = Matrix3::identity() - on.normal * on.normal.transpose();
        let anchor = frame.in_space(&self.kept[number].anchor);
        let trial = on.away_from(&anchor);
        let (size, most) = (trial.norm(), self.coefficient * on.pressed);
        if on.stiffness * size <= most {
            return Some((along * -on.stiffness, anchor));
        }
        let way = trial / size;
        Some(((along - way * way.transpose()) * (-most / size), anchor))
    }
}

impl OnFace {
    /// How far it stands from an anchor along the face.
    fn away_from(&self, anchor: &Vec3) -> Vec3 {
        let r = self.place - anchor;
        r - self.normal * self.normal.dot(&r)
    }
}

/// An evaluation of forces under way: vertices come in the order of their numbers.
pub(crate) struct Sticking<'a> {
    friction: &'a mut Friction,
    /// The committed anchor that comes next.
    next: usize,
}

impl Sticking<'_> {
    /// Force along the face on a vertex that touches \[F\]; `stiffness` is that of a vertex that parted.
    pub fn hold(&mut self, frame: &ToolFrame, on: &OnFace, stiffness: impl Fn(u32) -> f64) -> Vec3 {
        self.part(Some(on.vertex), stiffness);
        let Friction { coefficient, kept, trial } = &mut *self.friction;
        let grip = kept.get(self.next).filter(|grip| grip.vertex == on.vertex);
        let Some(&grip) = grip else {
            let anchor = frame.on_tool(&on.place);
            let new = Grip { vertex: on.vertex, anchor, stretch: Vec3::zeros(), lost: 0.0, holds: true };
            trial.push(new);
            return Vec3::zeros();
        };
        self.next += 1;
        let (k, most) = (on.stiffness, *coefficient * on.pressed);
        let away = on.away_from(&frame.in_space(&grip.anchor));
        let size = away.norm();
        let mut new = Grip { lost: 0.0, holds: true, ..grip };
        let mut stretch = away;
        if k * size > most {
            stretch = away * (most / (k * size));
            new.lost = 0.5 * k * (frame.turned(&grip.stretch) + stretch).dot(&(away - stretch));
            new.anchor = frame.on_tool(&(on.place - stretch));
        }
        new.stretch = frame.turned_back(&stretch);
        trial.push(new);
        stretch * -k
    }

    /// Lets go of all that has an anchor and does not touch, up to a vertex, or of all that is left.
    pub fn part(&mut self, before: Option<u32>, stiffness: impl Fn(u32) -> f64) {
        let Friction { kept, trial, .. } = &mut *self.friction;
        while let Some(grip) = kept.get(self.next)
            && before.is_none_or(|vertex| grip.vertex < vertex)
        {
            let lost = 0.5 * stiffness(grip.vertex) * grip.stretch.norm_squared();
            trial.push(Grip { lost, holds: false, ..*grip });
            self.next += 1;
        }
    }
}
