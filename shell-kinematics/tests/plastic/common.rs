//! Materials, strains and random numbers of these tests.

use shell_kinematics::{
    Hardening, Isotropic, LANES, Memory, Pack, Plastic, PlasticSection, Resultants, Section, Strains,
};

pub const YOUNG: f64 = 200e3;
pub const POISSON: f64 = 0.3;
pub const YIELD: f64 = 250.0;
pub const THICKNESS: f64 = 0.8;

/// Every kind of hardening, with its name.
pub fn hardenings() -> Vec<(&'static str, Hardening)> {
    vec![
        ("none", Hardening::linear(YIELD, 0.0).unwrap()),
        ("linear", Hardening::linear(YIELD, 2000.0).unwrap()),
        ("Voce", Hardening::voce(YIELD, 200.0, 12.0).unwrap()),
        ("Swift .01", Hardening::swift(500.0, 0.01, 0.2).unwrap()),
        ("Swift .001", Hardening::swift(500.0, 0.001, 0.2).unwrap()),
        (
            "table of four",
            Hardening::table(&[[0.0, 250.0], [0.02, 300.0], [0.1, 360.0], [0.3, 420.0]]).unwrap(),
        ),
    ]
}

pub fn elastic() -> Isotropic {
    Isotropic::new(YOUNG, POISSON).unwrap()
}

pub fn section(hardening: Hardening, slices: usize) -> PlasticSection {
    PlasticSection::new(Plastic::new(elastic(), hardening), THICKNESS, slices).unwrap()
}

pub fn linear(slope: f64, slices: usize) -> PlasticSection {
    section(Hardening::linear(YIELD, slope).unwrap(), slices)
}

/// Numbers from 0 to 1, the same on every run.
pub struct Random(pub u64);

impl Random {
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// A size between two bounds, evenly in its logarithm.
    pub fn size(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf_of(self.unit())
    }

    /// Strains with that membrane size and that size of curvature times thickness.
    pub fn strains(&mut self, membrane: f64, bending: f64) -> Strains {
        let mut pack = |size: f64| Pack::from_fn(|_| size * self.signed());
        Strains {
            membrane: std::array::from_fn(|_| pack(membrane)),
            curvature: std::array::from_fn(|_| pack(bending / THICKNESS)),
            shear: std::array::from_fn(|_| pack(membrane)),
        }
    }
}

trait Power {
    fn powf_of(self, exponent: f64) -> f64;
}

impl Power for f64 {
    fn powf_of(self, exponent: f64) -> f64 {
        libm::pow(self, exponent)
    }
}

pub fn membrane(e: [f64; 3]) -> Strains {
    Strains { membrane: e.map(Pack::splat), ..Strains::default() }
}

pub fn bent(k: [f64; 3]) -> Strains {
    Strains { curvature: k.map(Pack::splat), ..Strains::default() }
}

/// Strains as eight numbers a lane, and back.
pub fn components(s: &Strains) -> [Pack; 8] {
    let [a, b, c] = s.membrane;
    let [d, e, f] = s.curvature;
    let [g, h] = s.shear;
    [a, b, c, d, e, f, g, h]
}

pub fn strains([a, b, c, d, e, f, g, h]: [Pack; 8]) -> Strains {
    Strains { membrane: [a, b, c], curvature: [d, e, f], shear: [g, h] }
}

pub fn forces(r: &Resultants) -> [Pack; 8] {
    let [a, b, c] = r.membrane;
    let [d, e, f] = r.moment;
    let [g, h] = r.shear;
    [a, b, c, d, e, f, g, h]
}

pub fn plus(a: &Strains, b: &Strains, factor: f64) -> Strains {
    let (a, b) = (components(a), components(b));
    strains(std::array::from_fn(|i| a[i] + b[i] * factor))
}

/// A section with the history that it has gone through.
pub struct Specimen {
    pub section: PlasticSection,
    pub history: Vec<Pack>,
}

impl Specimen {
    pub fn new(section: PlasticSection) -> Self {
        let history = vec![Pack::ZERO; section.history_len()];
        Self { section, history }
    }

    pub fn commit(&mut self, strains: &Strains) {
        self.commit_in(strains, f64::INFINITY);
    }

    /// A step that takes some time.
    pub fn commit_in(&mut self, strains: &Strains, duration: f64) {
        let mut trial = vec![Pack::ZERO; self.history.len()];
        self.section.history_from(strains, duration, &self.history, &mut trial);
        self.history = trial;
    }

    pub fn resultants(&self, strains: &Strains) -> Resultants {
        self.section.resultants_from(strains, &self.history)
    }

    /// Resultants of the first lane, the free components chosen so that they vanish there; the others are imposed.
    ///
    /// Newton's method with the consistent tangent.
    pub fn solved(&self, start: &Strains, free: &[usize]) -> Strains {
        let mut now = *start;
        for _ in 0..60 {
            let forces = forces(&self.resultants(&now));
            let tangent = self.section.tangent_from(&now, &self.history);
            let n = free.len();
            let matrix = nalgebra::DMatrix::from_fn(n, n, |i, j| tangent[free[i]][free[j]].lanes()[0]);
            let right = nalgebra::DVector::from_fn(n, |i, _| -forces[free[i]].lanes()[0]);
            let step = matrix.lu().solve(&right).unwrap();
            let mut parts = components(&now);
            for (place, value) in free.iter().zip(step.iter()) {
                parts[*place] += Pack::splat(*value);
            }
            now = strains(parts);
            if step.amax() < 1e-15 {
                break;
            }
        }
        now
    }
}

/// A strip of thickness one in plane strain with ν next to ½, which keeps σ22 = ½σ11 inside the yield surface and on it: a law of one stress. Yield
/// strains of 1e-6: stretch and thickness do nothing.
pub fn strip(slices: usize, slope: f64, kinematic: f64) -> Specimen {
    let elastic = Isotropic::new(1.0, 0.5 - 1e-10).unwrap();
    let plastic =
        Plastic::new(elastic, Hardening::linear(1e-6, slope).unwrap()).kinematic(kinematic).unwrap();
    Specimen::new(PlasticSection::new(plastic, 1.0, slices).unwrap())
}

/// First yield of the strip: moment `σt²/6` and curvature `2σ/Et` with `σ = 2σ_y/√3`, `E/(1 − ν²) = 4E/3`.
pub fn first_yield() -> [f64; 2] {
    let stress = 2e-6 / 3.0_f64.sqrt();
    [stress / 6.0, 2.0 * stress * 0.75]
}

/// The greatest of the lanes in size.
pub fn most(pack: Pack) -> f64 {
    pack.lanes().into_iter().fold(0.0, |most: f64, value| most.max(value.abs()))
}

/// One lane of four.
pub fn first(pack: Pack) -> f64 {
    pack.lanes()[0]
}

/// The scales of eight resultants: yield stress times thickness, or thickness squared.
pub fn sizes() -> [f64; 8] {
    std::array::from_fn(|i| YIELD * if (3..6).contains(&i) { THICKNESS * THICKNESS } else { THICKNESS })
}

/// The lanes of a pack.
pub const COUNT: usize = LANES;

/// Resultants of a section that nothing has strained.
pub fn fresh(section: &dyn Section, strains: &Strains) -> [Pack; 8] {
    forces(&section.resultants(strains))
}

/// Components of a tensor in a frame turned by an angle; the last is `mixed` times the component 12.
pub fn turned(s: [Pack; 3], angle: f64, mixed: f64) -> [Pack; 3] {
    let (sin, cos) = libm::sincos(angle);
    let t = s[2] * (1.0 / mixed);
    [
        s[0] * (cos * cos) + s[1] * (sin * sin) + t * (2.0 * sin * cos),
        s[0] * (sin * sin) + s[1] * (cos * cos) - t * (2.0 * sin * cos),
        ((s[1] - s[0]) * (sin * cos) + t * (cos * cos - sin * sin)) * mixed,
    ]
}
