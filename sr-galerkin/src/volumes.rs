//! Changes of volume within a cell, held back no more than a solid of moderate Poisson's ratio holds them: what keeps one that
//! hardly changes its volume from locking.
//!
//! With a value of its own in every point the change of volume has more conditions to meet than there are parameters. So that only its
//! mean over a cell has to vanish, a point takes part in that mean \[moran1990\]: with `J = det F`, `J̄ = Σ V J/Σ V`
//!
//! ```text
//! F̄ = r F     r = (J̄/J)^β     β = α/3     P̄ = P(F̄)     π = P̄ : F̄     p̄ = Σ V π/Σ V
//! ε = F⁻ᵀ : δF     w = V J/(J̄ Σ V)     ε̄ = Σ w ε     δF̄ = L δF + c ε̄     L = r I − β F̄ ⊗ e     c = β F̄     e = F⁻ᵀ
//! ```
//!
//! At α = 1 all points have J̄. What varies within a cell then has no bulk modulus at all, which is right for ν → ½ and wrong before:
//! two cells across a beam of ν = 0 bend 10 % too easily. ([`Volumes::Mean`](crate::Volumes::Mean) takes it all the same, for plastic flow keeps the
//! volume whatever ν.) At α the bulk modulus K meets a variation as `(1 − α)² K`, and `α = 1 − 3K₀/K`
//! with the K₀ that there is without Poisson's ratios: `6ν − 2` of an isotropic solid, from ν = ⅓ on; below it nothing is changed.
//!
//! The work `Σ V P̄ : δF̄` is that of the stress `r P̄ + β (p̄ J/J̄ − π) F⁻ᵀ` on δF. Its derivative is, with s = r P̄, T the derivative of
//! −F⁻ᵀ and Ā = ∂P̄/∂F̄,
//!
//! ```text
//! Σ V (δF·M δF + 2 δF·y ε̄) + S ε̄²
//! M = LᵀĀL − β(e sᵀ + s eᵀ) + β²π e eᵀ + βπ T + β p̄ J/J̄ (e eᵀ − T)
//! y = LᵀĀc + β s − β²π e     S = Σ V c·Āc + (β² − β) p̄ Σ V
//! ```

use solid_kinematics::{Moduli, PointError, PointTangent, Tensor, Trial};

/// K/K₀ from which on points share their changes of volume.
const MOST: f64 = 3.0;

/// A tensor of second order by `3i + J`.
pub(crate) type Nine = [f64; 9];

/// How far the points of a cell share one change of volume.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sharing {
    /// β = α/3.
    beta: f64,
}

/// What sharing does to a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shared {
    /// r.
    pub ratio: f64,
    /// J/J̄.
    pub change: f64,
}

impl Shared {
    /// Left as it is.
    pub const ALONE: Self = Self { ratio: 1.0, change: 1.0 };
}

impl Sharing {
    /// All points have the mean of their cell.
    pub const WHOLE: Self = Self { beta: 1.0 / 3.0 };

    /// None where a material is far from incompressible.
    pub fn of(moduli: &Moduli) -> Option<Self> {
        let coupling = moduli.coupling();
        (coupling > MOST).then(|| Self { beta: (1.0 - MOST / coupling) / 3.0 })
    }
}

/// Turns gradients F into F̄.
///
/// # Errors
/// The first point that is turned inside out.
pub(crate) fn share(
    sharing: Sharing,
    gradients: &mut [Tensor],
    volumes: &[f64],
    shared: &mut [Shared],
) -> Result<(), (u32, PointError)> {
    let (mut sum, mut whole) = (0.0, 0.0);
    for (point, gradient) in gradients.iter().enumerate() {
        let determinant = gradient.determinant();
        if determinant.is_nan() || determinant <= 0.0 {
            return Err((point as u32, PointError::Inverted { determinant }));
        }
        shared[point].change = determinant;
        sum += volumes[point] * determinant;
        whole += volumes[point];
    }
    for (gradient, shared) in gradients.iter_mut().zip(shared) {
        shared.change *= whole / sum;
        shared.ratio = libm::pow(shared.change, -sharing.beta);
        *gradient *= shared.ratio;
    }
    Ok(())
}

/// p̄ \[F/L²\].
pub(crate) fn mean_pressure(trials: &[Trial], volumes: &[f64]) -> f64 {
    let sum: f64 = trials.iter().zip(volumes).map(|(trial, volume)| volume * trial.kirchhoff.trace()).sum();
    sum / volumes.iter().sum::<f64>()
}

/// The stress that does work on the gradient of the point itself.
pub(crate) fn shared_piola(sharing: Sharing, trial: &Trial, shared: Shared, mean: f64) -> Tensor {
    let pressure = mean * shared.change - trial.kirchhoff.trace();
    (trial.piola + trial.inverse.transpose() * (sharing.beta * pressure)) * shared.ratio
}

/// What the derivative of a cell has beside the moduli M of its points.
pub(crate) struct Coupled {
    /// `w e`, whose product with δF makes ε̄.
    pub mean: Vec<Nine>,
    /// `V y` of rows, and of columns: they differ where Ā is not symmetric.
    pub rows: Vec<Nine>,
    pub columns: Vec<Nine>,
    /// S.
    pub scalar: f64,
}

/// Turns moduli Ā of the points of a cell into M.
pub(crate) fn couple(
    Sharing { beta }: Sharing,
    (trials, shared): (&[Trial], &[Shared]),
    volumes: &[f64],
    moduli: &mut [PointTangent],
) -> Coupled {
    let whole: f64 = volumes.iter().sum();
    let pressure = mean_pressure(trials, volumes);
    let (mean, rows, columns) = (Vec::new(), Vec::new(), Vec::new());
    let mut out = Coupled { mean, rows, columns, scalar: (beta * beta - beta) * pressure * whole };
    for (((trial, shared), &volume), moduli) in trials.iter().zip(shared).zip(volumes).zip(moduli) {
        let of = |tensor: &Tensor| -> Nine { std::array::from_fn(|i| tensor[(i / 3, i % 3)]) };
        let own = trial.kirchhoff.trace();
        let Shared { ratio: r, change } = *shared;
        let e = of(&(trial.inverse.transpose() * r));
        let s = of(&(trial.piola * r));
        let f = of(&trial.state.gradient);
        let c = f.map(|f| beta * f);
        // Ā L, Ā c, and then with Lᵀ from the left: Lᵀ x = r x − e (c·x)
        let right: Nine = std::array::from_fn(|i| dot(&moduli[i], &c));
        let left: Nine = std::array::from_fn(|j| (0..9).map(|i| c[i] * moduli[i][j]).sum());
        let half: PointTangent =
            std::array::from_fn(|i| std::array::from_fn(|j| r * moduli[i][j] - right[i] * e[j]));
        let down: Nine = std::array::from_fn(|j| (0..9).map(|i| c[i] * half[i][j]).sum());
        let inverse = |i: usize, j: usize| r * trial.inverse[(i, j)];
        let share = beta * pressure * change;
        for i in 0..9 {
            for j in 0..9 {
                let turned = inverse(j % 3, i / 3) * inverse(i % 3, j / 3);
                moduli[i][j] = r * half[i][j] - e[i] * down[j] - beta * (e[i] * s[j] + s[i] * e[j])
                    + (beta * beta * own + share) * e[i] * e[j]
                    + (beta * own - share) * turned;
            }
        }
        let both = dot(&c, &right);
        let with = |x: &Nine| -> Nine {
            std::array::from_fn(|i| {
                volume * (r * x[i] - e[i] * both + beta * s[i] - beta * beta * own * e[i])
            })
        };
        out.rows.push(with(&right));
        out.columns.push(with(&left));
        out.mean.push(e.map(|e| volume * change / whole * e));
        out.scalar += volume * both;
    }
    out
}

fn dot(a: &Nine, b: &Nine) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
