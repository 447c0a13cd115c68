//! Bonds that yield: what of their extensions is plastic, and how a family returns to its yield surface.
//!
//! Ordinary state-based plasticity \[mitchell2011\], with isotropic hardening as \[madenci2016\] has it, in the norm of the stored
//! energy. Each end of a bond has a plastic extension p of its own. Half of the stiffness c of a bond belongs to each end, and a
//! node stores
//!
//! ```text
//! Uᵢ = ½ (λ − μ) Vᵢ θᵢ² + ½ Σⱼ ½c (e − pᵢⱼ)²           pull of a bond  c [e − ½(pᵢⱼ + pⱼᵢ)] + θ̂ᵢ Dᵢⱼ + θ̂ⱼ Dⱼᵢ
//! ```
//!
//! θ is that of the whole extensions: flow keeps the volume. What drives p is `−∂U/∂p = ½c a`, `a = e − p`. Flow may follow every
//! uniform strain that keeps the volume, as the family sees it: with ρ the round part of a bond,
//!
//! ```text
//! ρ = r n·B n        Σ c ρ r n⊗n = (z/3) 1        Σ c ρ p = 0        z = Σ c r²
//! ```
//!
//! B is the unit matrix inside, where `Σ c r² n⊗n` is even, and ρ = r; where a family is cut it is not, and with r in place of ρ a
//! flow that keeps the volume would meet ever more pressure there. The deviatoric part of a is what is left at right angles to ρ in
//! the norm of c,
//!
//! ```text
//! sᵢ = Σ c ρ a / Σ c ρ²        e^d = a − s ρ        ψ = ½ Σ ½c (e^d)²
//! ```
//!
//! so that inside, where all bonds stretch alike, ψ = 0: pressure does no yielding. A family yields at `ψ = ψ₀`, and flows along
//! the normal of that surface in the metric of the energy, `ṗ = λ̇ e^d`. The work that is lost, `Σ ½c a ṗ = 2ψ λ̇`, is never
//! below zero. The return from a trial state is a scaling of e^d, closed for any influence (in the norm `Σ t² V` of \[mitchell2011\]
//! it is so for constant influence alone):
//!
//! ```text
//! Δp = β e^d        σ = √(6 μᵢ ψ/V)        Δε^p = (σ − σ_y(ε^p))/(3μᵢ + H)        β = 3μᵢ Δε^p/σ
//! ```
//!
//! σ is von Mises' stress: in a uniform strain `ψ = V μ ε':ε'`, and Δε^p is the equivalent plastic strain, `√(2/3 Δε^p:Δε^p)`. So
//! the discrete family decides about ψ₀ `= V σ_y²/(6μᵢ)`, with its own shear modulus `μᵢ = z/(30V)`, the mean over all deviators.
//! With it a body in a uniform flow does the work `V σ_y ε̇` at each node whatever its weights, as far as the family is alike in all
//! directions. Weights that even out energies are, for uniform strains: a node inside yields at von Mises' stress in all directions.
//! At faces halves of bonds are not, and single directions differ; there pressure counts a little too.
//!
//! In planes the stress across, or the plastic strain across, takes part in yielding (\[mousavi2021\]), which no bond there carries:
//! they are refused. So are weights that see a dilatation in uniform strains that keep the volume, as uncorrected families do at faces:
//! there θ grows with the flow, and the body locks. Where bonds have broken the elastic law sees some, too.
//!
//! A broken bond takes with it the energy of its elastic part. Of a family with broken bonds c, ρ and z are those of the bonds left,
//! and ψ₀ goes with `Σ c ρ²`: as with stiffness, what is left neither stiffens nor hardens. Bonds break by their whole stretch,
//! elastic or not.

use lanes::{LANES, Lanes, Pack, Reals};
use sph_core::Vec3;

use crate::plastic::Plastic;

/// What a node went through, and what that took.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Past {
    /// Equivalent plastic strain ε^p \[–\].
    pub strain: f64,
    /// Plastic work \[F L\].
    pub work: f64,
}

/// The plastic extensions of a network, and what flows from there in the state last evaluated.
#[derive(Clone, Debug)]
pub(crate) struct Flow {
    pub plastic: Plastic,
    pub surfaces: Vec<Surface>,
    /// p of each directed bond at its own node \[L\].
    pub own: Vec<Pack>,
    /// The same at the other node \[L\].
    pub twin: Vec<Pack>,
    /// ρ of each directed bond at its own node \[L\].
    pub round: Vec<Pack>,
    /// The same at the other node \[L\].
    pub round_twin: Vec<Pack>,
    /// Places of nodes and images at rest \[L\].
    pub places: Vec<Vec3>,
    pub past: Vec<Past>,
    /// `[β, β s]` of nodes, and of images behind them; zero once it is kept.
    pub trial: Vec<[f64; 2]>,
    /// What of the past is added then.
    pub coming: Vec<Past>,
    /// Whether any node flows.
    pub flows: bool,
    /// Work of each chunk of nodes.
    pub works: Vec<f64>,
}

/// The yield surface of a node.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface {
    /// Shear modulus μᵢ of its family at the start, the mean over all deviators \[F/L²\].
    pub shear: f64,
    /// V over `Σ c ρ²` of the family at the start \[L²/F\].
    pub share: f64,
}

/// `Σ c a²`, `Σ c ρ a` and `Σ c ρ²` of a family.
pub(crate) type Sums = [f64; 3];

/// What is kept once a step: of each end of the bonds plastic extensions, to change, and round parts.
pub(crate) struct Kept<'a> {
    pub ends: [(&'a mut [Pack], &'a [Pack]); 2],
    pub past: &'a mut [Past],
    pub trial: &'a [[f64; 2]],
    pub coming: &'a [Past],
    pub works: &'a mut Vec<f64>,
}

impl Surface {
    /// Von Mises' stress of a family \[F/L²\].
    pub fn stress(&self, [square, along, whole]: Sums) -> f64 {
        let deviatoric = (square - along * (along / whole)).max(0.0);
        (1.5 * self.shear / self.share * (deviatoric / whole)).sqrt()
    }

    /// The return to the surface: `[β, β s]`, and what the node then went through; nothing inside the surface.
    pub fn flow(&self, plastic: &Plastic, strain: f64, sums: Sums) -> ([f64; 2], Past) {
        let [_, along, whole] = sums;
        let (stress, limit) = (self.stress(sums), plastic.limit(strain));
        // A family without bonds has no stress.
        if stress.is_nan() || stress <= limit {
            return Default::default();
        }
        let more = (stress - limit) / (3.0 * self.shear + plastic.hardening);
        let part = 3.0 * self.shear * more / stress;
        let work = self.share * whole * (limit + 0.5 * plastic.hardening * more) * more;
        ([part, part * along / whole], Past { strain: more, work })
    }
}

/// Pairs of numbers of the other ends of four bonds.
#[inline(always)]
pub(super) fn pairs<L: Lanes>(lanes: L, of: &[[f64; 2]], [a, b, c, d]: &[u32; LANES]) -> [Reals<L>; 2] {
    let [first, second] =
        lanes.columns_of_two([&of[*a as usize], &of[*b as usize], &of[*c as usize], &of[*d as usize]]);
    [Reals { lanes, four: first }, Reals { lanes, four: second }]
}

impl Flow {
    /// Elastic parts of the extensions of four bonds, as their own node has them and as the others have them.
    #[inline(always)]
    pub fn elastic<L: Lanes>(
        &self,
        lanes: L,
        pack: usize,
        here: [Reals<L>; 2],
        others: &[u32; LANES],
        extension: Reals<L>,
    ) -> [Reals<L>; 2] {
        let there = pairs(lanes, &self.trial, others);
        let near = Self::left(lanes, (&self.own[pack], &self.round[pack]), here, extension);
        let far = Self::left(lanes, (&self.twin[pack], &self.round_twin[pack]), there, extension);
        [near, far]
    }

    /// What of four extensions is elastic at one end.
    #[inline(always)]
    fn left<L: Lanes>(
        lanes: L,
        (plastic, round): (&Pack, &Pack),
        [part, expansion]: [Reals<L>; 2],
        extension: Reals<L>,
    ) -> Reals<L> {
        let elastic = extension - lanes.read(plastic);
        elastic - (elastic * part - lanes.read(round) * expansion)
    }

    /// Half of the plastic extensions of both ends of four bonds \[L\], as they were kept.
    #[inline(always)]
    pub fn mean<L: Lanes>(&self, lanes: L, pack: usize) -> Reals<L> {
        (lanes.read(&self.own[pack]) + lanes.read(&self.twin[pack])) * 0.5
    }

    /// Plastic extensions of a lane at both ends, as they were kept, and its round parts ρ \[L\].
    pub fn of_lane(&self, lane: usize) -> [[f64; 2]; 2] {
        let of = |packs: &[Pack]| packs[lane / LANES][lane % LANES];
        [[of(&self.own), of(&self.twin)], [of(&self.round), of(&self.round_twin)]]
    }

    /// All that is kept of the bonds at one end, at the other, and their round parts there.
    pub fn kept(&mut self) -> Kept<'_> {
        let Self { own, twin, round, round_twin, past, trial, coming, works, .. } = self;
        Kept { ends: [(own, round), (twin, round_twin)], past, trial, coming, works }
    }

    /// All that flow changes: plastic extensions of all lanes at both ends; strains and works of all nodes.
    pub fn state(&self) -> [Vec<f64>; 2] {
        let extensions = self.own.iter().chain(&self.twin).flatten().copied().collect();
        [extensions, self.past.iter().flat_map(|past| [past.strain, past.work]).collect()]
    }

    /// Takes up such a state; false, and nothing changed, for that of another body.
    pub fn take_up(&mut self, [extensions, past]: [&[f64]; 2]) -> bool {
        if extensions.len() != 2 * LANES * self.own.len() || past.len() != 2 * self.past.len() {
            return false;
        }
        let packs = self.own.iter_mut().chain(&mut self.twin);
        packs.zip(extensions.chunks_exact(LANES)).for_each(|(pack, from)| pack.copy_from_slice(from));
        for (own, from) in self.past.iter_mut().zip(past.chunks_exact(2)) {
            *own = Past { strain: from[0], work: from[1] };
        }
        self.forget();
        true
    }

    /// Forgets what flows in the state last evaluated.
    pub fn forget(&mut self) {
        self.trial.fill([0.0; 2]);
        self.coming.fill(Past::default());
        self.flows = false;
    }

    /// Memory \[bytes\].
    pub fn bytes(&self) -> usize {
        4 * self.own.len() * size_of::<Pack>()
            + self.places.len() * size_of::<Vec3>()
            + self.surfaces.len() * (size_of::<Surface>() + 2 * size_of::<Past>())
            + self.trial.len() * size_of::<[f64; 2]>()
    }
}
