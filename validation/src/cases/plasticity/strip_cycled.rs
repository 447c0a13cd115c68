//! strip-cycled: a strip drawn and pushed back three times, with back stresses that recover.
//!
//! ```text
//!  ▐━━━━━━━━━◀▶ u        σ = ±σ_y + Σ X_k      X_k = ±H/g + (X_k0 ∓ H/g) e^(−gΔ)      Δ: plastic strain since the way was turned
//! ```

use libm::{exp, log};

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/strip-cycled.toml");
const OFF: &str = "greatest error of the force";
const LOST: &str = "error of the work dissipated";
const COARSE: &str = "20 levels a half";
const FINE: &str = "40 levels a half";

/// Errors \[%\].
const FORCE: Measured = Measured(&[(STATIC, &[(COARSE, 0.41), (FINE, 0.21)])]);
const WORK: Measured = Measured(&[(STATIC, &[(COARSE, 0.10), (FINE, 0.047)])]);

const YOUNG: f64 = 2e5;
const YIELD: f64 = 250.0;
/// H \[F/L²\] and g of both.
const BACKS: [[f64; 2]; 2] = [[20_000.0, 100.0], [2000.0, 10.0]];
/// Width and thickness \[L\]; its length is one.
const SECTION: f64 = 0.5 * 0.01;

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "strip-cycled",
        title: "A strip in three cycles of stretch",
        about: "Two back stresses by Armstrong and Frederick: the force at every level of three cycles between no stretch and one per cent, and the work dissipated, against the \
                exponentials of each half.",
        citation: "[armstrong1966], [chaboche1986]: uniaxial stress in closed form",
        variants: vec![halves(20, COARSE).quick_if(true), halves(40, FINE)],
        each,
        headline: Some(Headline::new(OFF, 1.0)),
        ..Case::default()
    }
}

/// Six halves of so many levels.
fn halves(count: u32, grid: &str) -> Variant {
    let up = |i: u32| f64::from(i) / f64::from(count);
    let half =
        |half: u32| (1..=count).map(move |i| if half.is_multiple_of(2) { up(i) } else { up(count - i) });
    let levels: Vec<f64> = (0..6).flat_map(half).collect();
    Variant::scene(STATIC, SCENE, grid).set("analysis.static.levels", format!("{levels:?}"))
}

/// A bar of one stress.
#[derive(Clone, Copy, Default)]
struct Bar {
    plastic: f64,
    backs: [f64; 2],
    /// Work dissipated by volume.
    lost: f64,
}

impl Bar {
    /// Flowed on by an amount in a direction.
    fn flowed(&self, amount: f64, sign: f64) -> Self {
        let mut next = Self { plastic: self.plastic + sign * amount, ..*self };
        let (mut work, mut stored) = (YIELD * amount, 0.0);
        for ((x, from), [h, g]) in next.backs.iter_mut().zip(self.backs).zip(BACKS) {
            let (end, kept) = (sign * h / g, exp(-g * amount));
            *x = end + (from - end) * kept;
            work += sign * (end * amount + (from - end) * (1.0 - kept) / g);
            stored += (*x * *x - from * from) / (2.0 * h);
        }
        next.lost += work - stored;
        next
    }

    fn back(&self) -> f64 {
        self.backs.iter().sum()
    }

    fn stress(&self, strain: f64) -> f64 {
        YOUNG * (strain - self.plastic)
    }

    /// Drawn or pushed to a strain.
    fn at(&self, strain: f64) -> Self {
        let sign = (self.stress(strain) - self.back()).signum();
        let beyond = |bar: &Self| sign * (bar.stress(strain) - bar.back()) > YIELD;
        if !beyond(self) {
            return *self;
        }
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if beyond(&self.flowed(middle, sign)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        self.flowed(low, sign)
    }
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (stretch, force, lost) = (run.column("stretch")?, run.column("F")?, run.column("lost")?);
    let (mut bar, mut worst, mut most) = (Bar::default(), 0.0_f64, 0.0_f64);
    for (stretch, force) in stretch.iter().zip(force).skip(1) {
        let strain = log(*stretch);
        bar = bar.at(strain);
        let exact = bar.stress(strain) * exp(-strain) * SECTION;
        (worst, most) = (worst.max((force - exact).abs()), most.max(exact.abs()));
    }
    let off = run.done().then(|| 100.0 * worst / most);
    let work = lost.last().filter(|_| run.done()).map(|lost| 100.0 * (lost / (bar.lost * SECTION) - 1.0));
    let reason =
        "a step of backward Euler follows the recovery to its first order: twice the levels, half of it";
    Ok(vec![
        Metric::error(OFF, off, "%").near(FORCE.of(run)?, reason),
        Metric::error(LOST, work, "%").near(WORK.of(run)?, reason),
    ])
}
