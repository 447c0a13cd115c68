//! A wedge that enters still water at constant speed: the similarity flow of Dobrovol'skaya, without gravity \[dobrovolskaya1969\].
//!
//! All lengths go with Vt, so that one flow is sought, of speed one at the time one. The right half of the water lies on the upper half of a plane of t: the wetted
//! face from its tip, 0, to the apex, 1, the middle of the water from there to ∞, the free surface on −∞ to 0. Let α be the deadrise and −πf the slope of the
//! surface towards the tip. Directions on the boundary, and a free surface on which fluid keeps its distances along it \[wagner1932\], give position z and
//! complex velocity w' in the similarity plane:
//!
//! ```text
//! dz/dt = −i K t^(−α/π) (t − 1)^(α/π − ½) exp ∫₀^∞ f(s)/(s + t) ds        dw'/dt dz/dt = C t^(−3/2)/(t − 1)
//! −f'(s) = |C|/π s^(−3/2)/((1 + s) |dz/dt| ℓ)                             ℓ  length of the surface from its tip
//! ```
//!
//! The first of the second row is that the surface moves with its fluid. At the apex fluid has the velocity of the wedge, at the tip it stays, which give K and C;
//! what is left is f(0), and the contact angle with it, for which the slope that is assumed is the slope that is found. Along the face the pressure follows from
//! the acceleration. Integrals go over the logarithm of t in equal steps, with errors by the square of the step.
//!
//! A wedge that gets faster or slower pushes on the same water at once as well. The potential of that is zero on the surface and its stream function is x on the face: with
//! s = √t, ψ goes on evenly to s < 0, φ is its Hilbert transform, and the added mass is twice the energy of both halves,
//!
//! ```text
//! m = (2ρ/π) ∫∫ ln |(s + s')/(s − s')| dx dx'
//! ```
//!
//! which for a flat plate, s² = 1 − x²/c², is ½πρc², and for a low wedge half of its force over V²D times D.

use std::f64::consts::PI;

/// Ends of the logarithm of s on the surface, and of t/(1 − t) on the face.
const SURFACE: [f64; 2] = [-45.0, 15.0];
const FACE: [f64; 2] = [-45.0, 70.0];
/// The same of t − 1 on the middle of the water.
const MIDDLE: [f64; 2] = [-70.0, 40.0];
/// Rounds at most, for a slope and for the contact angle; what a round may change at the end.
const ROUNDS: (usize, usize) = (2000, 40);
const SETTLED: f64 = 1e-10;
/// Part of the turn that is assumed beyond which a slope runs away.
const WILD: f64 = 1e6;

/// The flow about a wedge, over ρ, V and t.
#[derive(Clone, Debug)]
pub struct WedgeEntry {
    /// Force on the wedge over `ρV³t` \[–\].
    pub force: f64,
    /// Added mass of a change of its speed, over ρ and the square of the depth \[–\].
    pub added: f64,
    /// Greatest pressure over `½ρV²` \[–\].
    pub pressure: f64,
    /// Angle between the face and the surface at its tip \[rad\].
    pub contact: f64,
    /// Height of the tip over the level at rest, over Vt \[–\].
    pub tip: f64,
    /// Height far away, and what the water about the wedge lacks of what it displaces, over Vt and its square: errors of the solution \[–\].
    pub missing: [f64; 2],
}

/// The solution under way.
struct Flow {
    /// Deadrise over π, and the step of all logarithms.
    rise: f64,
    step: f64,
    surface: Vec<f64>,
    face: Vec<f64>,
    /// `∫ ln|1 − e^u| du` over cells, the middle one in the middle.
    singular: Vec<f64>,
    /// `−f'(s) ds/d ln s`.
    bend: Vec<f64>,
}

/// What follows from a slope.
struct Shape {
    /// Contact angle over π, and `|C|/K²`.
    contact: f64,
    ratio: f64,
    /// `|dz/dt| s/K` on the surface and its length over K; on the face `|dz/dt| t(1 − t)/K` and the rate of velocity over `|C|/K`.
    along: Vec<f64>,
    length: Vec<f64>,
    face: Vec<f64>,
    rate: Vec<f64>,
    /// The bend that is found.
    bend: Vec<f64>,
}

fn middles([first, last]: [f64; 2], step: f64) -> Vec<f64> {
    let count = libm::round((last - first) / step) as usize;
    (0..count).map(|i| first + (i as f64 + 0.5) * step).collect()
}

impl Flow {
    fn new(deadrise: f64, step: f64) -> Self {
        let surface = middles(SURFACE, step);
        let count = surface.len() as i64;
        let whole = |v: f64| if v == 0.0 { 0.0 } else { v * libm::log(v.abs()) - v };
        let cell = |k: i64| {
            let u = k as f64 * step;
            // What is left of the logarithm without that of |u| has no singularity.
            let smooth = if k == 0 { 0.0 } else { libm::log(libm::expm1(u) / u) };
            whole(u + 0.5 * step) - whole(u - 0.5 * step) + smooth * step
        };
        let bend = surface.iter().map(|x| libm::exp(-x.abs())).collect();
        let singular = (1 - count..count).map(cell).collect();
        Self { rise: deadrise / PI, step, surface, face: middles(FACE, step), singular, bend }
    }

    /// `∫ −f' ln(1 + s/t) ds`.
    fn smooth(&self, t: f64) -> f64 {
        let each = self.surface.iter().zip(&self.bend);
        each.map(|(x, bend)| self.step * bend * libm::log1p(libm::exp(*x) / t)).sum()
    }

    fn shape(&self, of_face: &[Vec<f64>]) -> Shape {
        let (a, h, count) = (self.rise, self.step, self.surface.len());
        let contact = 1.0 - a - self.bend.iter().sum::<f64>() * h;
        let along: Vec<f64> = (0..count)
            .map(|i| {
                let weights = &self.singular[count - 1 - i..2 * count - 1 - i];
                let turned: f64 = weights.iter().zip(&self.bend).map(|(weight, bend)| weight * bend).sum();
                let x = self.surface[i];
                libm::exp((1.0 - a) * x + (a - 0.5) * libm::log1p(libm::exp(x)) + turned)
            })
            .collect();
        // Before the first cell all goes with s to the contact angle over π.
        let mut sum = along[0] / contact;
        let mut length = vec![sum];
        for pair in along.windows(2) {
            sum += 0.5 * h * (pair[0] + pair[1]);
            length.push(sum);
        }
        let (mut face, mut rate) = (Vec::new(), Vec::new());
        for (y, weights) in self.face.iter().zip(of_face) {
            let turned: f64 = weights.iter().zip(&self.bend).map(|(weight, bend)| weight * bend).sum();
            let (t, rest) = (-libm::log1p(libm::exp(-y)), -libm::log1p(libm::exp(*y)));
            let speed = -a * t + (a - 0.5) * rest + turned;
            face.push(libm::exp(speed + t + rest));
            rate.push(libm::exp(-0.5 * t - speed));
        }
        let ratio = (face.iter().sum::<f64>() * h + face[0] / contact) / (rate.iter().sum::<f64>() * h);
        let found = |i: usize| {
            let x = self.surface[i];
            ratio / PI * libm::exp(0.5 * x) / ((1.0 + libm::exp(x)) * along[i] * length[i])
        };
        let bend = (0..count).map(found).collect();
        Shape { contact, ratio, along, length, face, rate, bend }
    }

    /// Settles the slope with this contact angle over π; the turn of the surface that is found over the one that is assumed.
    fn settle(&mut self, of_face: &[Vec<f64>], contact: f64) -> f64 {
        let turn = 1.0 - self.rise - contact;
        let before = self.bend.clone();
        let mut part = f64::NAN;
        for _ in 0..ROUNDS.0 {
            let sum: f64 = self.bend.iter().sum::<f64>() * self.step;
            self.bend.iter_mut().for_each(|bend| *bend *= turn / sum);
            let found = self.shape(of_face).bend;
            part = found.iter().sum::<f64>() * self.step / turn;
            if !(1.0 / WILD..WILD).contains(&part) {
                break;
            }
            let mut change = 0.0_f64;
            for (bend, found) in self.bend.iter_mut().zip(&found) {
                let step = 0.5 * (found / part - *bend);
                *bend += step;
                change = change.max(step.abs());
            }
            if change < SETTLED {
                break;
            }
        }
        // What runs away is no beginning for another contact angle.
        if !(0.5..2.0).contains(&part) {
            self.bend = before;
        }
        part
    }
}

/// The flow about a wedge of this deadrise \[rad\], between a tenth and 1.2, with steps of this size of the logarithms; none where it is not found.
pub fn wedge_entry(deadrise: f64, step: f64) -> Option<WedgeEntry> {
    let mut flow = Flow::new(deadrise, step);
    let weights = |y: &f64| -> Vec<f64> {
        let t = 1.0 / (1.0 + libm::exp(-y));
        flow.surface.iter().map(|x| step * libm::log1p(libm::exp(*x) / t)).collect()
    };
    let of_face: Vec<Vec<f64>> = flow.face.iter().map(weights).collect();
    // The turn that is found grows with the contact angle: it is one at the solution.
    let (mut low, mut high) = (1e-5, 0.02 * deadrise);
    while flow.settle(&of_face, high) < 1.0 {
        (low, high) = (high, 1.3 * high);
        if high > 0.3 {
            return None;
        }
    }
    for _ in 0..ROUNDS.1 {
        let middle = 0.5 * (low + high);
        let part = flow.settle(&of_face, middle);
        // What is no number has run away, as large contact angles do.
        if part < 1.0 {
            low = middle;
        } else {
            high = middle;
        }
        if (part - 1.0).abs() < 1e-7 {
            break;
        }
    }
    Some(flow.answer(&flow.shape(&of_face)))
}

impl Flow {
    fn answer(&self, shape: &Shape) -> WedgeEntry {
        let (a, h) = (self.rise, self.step);
        let through = |y: &f64| {
            let t = libm::log1p(libm::exp(*y));
            libm::exp(-1.5 * t + a * t + (0.5 - a) * y - self.smooth(libm::exp(t)))
        };
        let middle: f64 = middles(MIDDLE, h).iter().map(through).sum::<f64>() * h;
        let scale = 1.0 / (middle * shape.ratio);
        let wet = scale * (shape.face.iter().sum::<f64>() * h + shape.face[0] / shape.contact);
        let (sine, cosine) = (libm::sin(PI * a), libm::cos(PI * a));
        // From the apex to the tip: distance along the face, and velocity over that of the wedge.
        let (mut far, mut fast, mut force, mut pushes) = (0.0, 0.0, 0.0, Vec::new());
        for (face, rate) in shape.face.iter().zip(&shape.rate).rev() {
            let (way, gained) = (0.5 * h * scale * face, 0.5 * h / middle * rate);
            (far, fast) = (far + way, fast + gained);
            force += 2.0 * cosine * far * (fast - far) * 2.0 * gained;
            pushes.push((fast - far) * 2.0 * gained);
            (far, fast) = (far + way, fast + gained);
        }
        // Pressure is none at the tip.
        let (mut pressure, mut most) = (0.0, 0.0_f64);
        for push in pushes.iter().rev() {
            pressure += push;
            most = most.max(pressure);
        }
        let tip = -1.0 + wet * sine;
        let missing = self.missing(shape, scale, [wet * cosine, tip]);
        let cells: Vec<[f64; 2]> =
            self.face.iter().zip(&shape.face).map(|(y, face)| [*y, scale * cosine * h * face]).collect();
        let tip_of = [scale * cosine * shape.face[0] / shape.contact, 2.0 * shape.contact];
        let added = added(&cells, h, tip_of);
        WedgeEntry { force, added, pressure: 2.0 * most, contact: PI * shape.contact, tip, missing }
    }

    /// Height of the surface far away, and what the water above the level at rest is more than what the wedge displaces.
    fn missing(&self, shape: &Shape, scale: f64, [x, y]: [f64; 2]) -> [f64; 2] {
        let (mut place, mut slope) = ([x, y], 1.0 - self.rise - shape.contact);
        let mut steps = Vec::new();
        let first = scale * (shape.length[0] - 0.5 * self.step * shape.along[0]);
        steps.push((first, slope));
        for (along, bend) in shape.along.iter().zip(&self.bend) {
            let half = 0.5 * self.step * bend;
            steps.push((scale * along * self.step, slope - half));
            slope -= 2.0 * half;
        }
        let mut area = 0.5 * x * (y - 1.0);
        for (way, slope) in steps {
            let [dx, dy] = [way * libm::cos(PI * slope), -way * libm::sin(PI * slope)];
            area += dx * (place[1] + 0.5 * dy);
            place = [place[0] + dx, place[1] + dy];
        }
        [place[1], area - place[1] * place[0]]
    }
}

/// Added mass over ρ of a face in cells, each the logarithm of t/(1 − t) in its middle and how wide it is; before them lies a piece so wide that goes with this power of s.
fn added(cells: &[[f64; 2]], step: f64, [first, power]: [f64; 2]) -> f64 {
    let log_t = |y: f64| -libm::log1p(libm::exp(-y));
    let row = |&[y, wide]: &[f64; 2]| -> f64 {
        let (t, s) = (log_t(y), libm::exp(0.5 * log_t(y)));
        // t − t' = t t' exp(−y) (exp(y − y') − 1); within a cell the mean of the logarithm.
        let of = |&[z, width]: &[f64; 2]| {
            let (low, high) = if y < z { (y, z) } else { (z, y) };
            let apart = if y == z {
                t - libm::log1p(libm::exp(y)) + libm::log(step) - 1.5
            } else {
                t + log_t(z) - low + libm::log(-libm::expm1(low - high))
            };
            width * (2.0 * libm::log(s + libm::exp(0.5 * log_t(z))) - apart)
        };
        wide * cells.iter().map(of).sum::<f64>()
    };
    // ∫₀¹ ln((1 + r)/(1 − r)) dr/r = π²/4, of what goes with a small power of s.
    let before = 0.25 * PI * PI * power * first * first;
    2.0 / PI * (cells.iter().map(row).sum::<f64>() + before)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x = √(1 − t) of a flat plate: half of the added mass of a plate in water without end, to .2 % with steps of .1 and to half of that with half the steps.
    #[test]
    fn a_flat_plate_has_its_added_mass() {
        let miss = |step: f64| {
            let end = |y: f64| 1.0 / (1.0 + libm::exp(y)).sqrt();
            let cell = |y: &f64| [*y, end(y - 0.5 * step) - end(y + 0.5 * step)];
            let cells: Vec<[f64; 2]> = middles([-40.0, 60.0], step).iter().map(cell).collect();
            added(&cells, step, [0.0; 2]) / (0.5 * PI) - 1.0
        };
        let [coarse, fine] = [0.1, 0.05].map(miss);
        assert!(coarse.abs() < 3e-3 && (fine / coarse - 0.5).abs() < 0.1, "{coarse} {fine}");
    }

    /// The contour closes: far away the surface lies at the level at rest, and the water above that is what the wedge displaces. Both by the square of the step.
    #[test]
    fn the_surface_closes_and_no_water_is_lost() {
        let [coarse, fine] = [0.4, 0.2].map(|step| wedge_entry(PI / 6.0, step).unwrap());
        let displaced = 0.5 * 3.0_f64.sqrt();
        for (k, size) in [1.0, displaced].into_iter().enumerate() {
            let [coarse, fine] = [coarse.missing[k].abs() / size, fine.missing[k].abs() / size];
            assert!(fine < 5e-3 && fine < 0.4 * coarse, "{k}: {coarse} {fine}");
        }
        assert!((coarse.force / fine.force - 1.0).abs() < 0.01, "{} {}", coarse.force, fine.force);
    }

    /// Low wedges go to Wagner's force, π³/4 over the square of tan α [wagner1932], from below and the nearer the lower; their added mass, that of a plate as wide as the wetted
    /// face, to half of it from above.
    #[test]
    fn low_wedges_go_to_wagners_force_and_half_of_it_as_added_mass() {
        let over = |degrees: f64| {
            let rise = degrees.to_radians();
            let tangent = libm::tan(rise);
            let flow = wedge_entry(rise, 0.4).unwrap();
            [flow.force * tangent * tangent * 4.0 / PI.powi(3), 2.0 * flow.added / flow.force]
        };
        let [[low, least], [middle, more], [high, most]] = [12.0, 20.0, 45.0].map(over);
        assert!(high < middle && middle < low && low < 1.0 && low > 0.8, "{low} {middle} {high}");
        assert!(1.0 < least && least < 1.06 && least < more && more < most, "{least} {more} {most}");
    }
}
