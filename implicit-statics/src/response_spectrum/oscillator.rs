//! One mass on a spring under a record: how far it goes at most.

/// Part of a radian of the oscillator between two looks at the sign of its velocity.
const LOOK: f64 = 0.3;
/// Halvings by which the time of an extreme is found: its way is off by the square of what they leave of a look.
const HALVINGS: usize = 30;

/// Greatest `ω²|u|` of `ü + 2ζω u̇ + ω² u = −a(t)` from rest \[as a\]: a of straight lines between points `[time, a]`, zero before the first and after
/// the last. The motion is that of the closed form in each piece \[nigam1969\], its extremes are found there, those of the free swing after the end too.
pub fn pseudo_acceleration(record: &[[f64; 2]], omega: f64, zeta: f64) -> f64 {
    let own = Oscillator { omega, zeta };
    let mut motion = [0.0; 2];
    let mut most = 0.0_f64;
    for piece in record.windows(2) {
        let [[from, a], [to, b]] = [piece[0], piece[1]];
        let piece = Piece::new(own, motion, a, (b - a) / (to - from));
        most = most.max(piece.farthest(to - from));
        motion = piece.at(to - from);
    }
    // Within a period it goes as far as it ever will.
    let free = Piece::new(own, motion, 0.0, 0.0);
    most = most.max(free.farthest(std::f64::consts::TAU / omega));
    omega * omega * most
}

#[derive(Clone, Copy)]
struct Oscillator {
    omega: f64,
    zeta: f64,
}

impl Oscillator {
    /// `e^{−ζωt}` times cosine, and sine by ω, of the damped frequency; beyond the critical damping what these become.
    fn waves(self, t: f64) -> [f64; 2] {
        let Self { omega, zeta } = self;
        let apart = (1.0 - zeta) * (1.0 + zeta);
        if apart > 0.0 {
            let damped = omega * apart.sqrt();
            let (sin, cos) = libm::sincos(damped * t);
            let falls = libm::exp(-zeta * omega * t);
            return [falls * cos, falls * sin / damped];
        }
        let rate = omega * (-apart).sqrt();
        if rate * t < 1e-6 {
            let falls = libm::exp(-zeta * omega * t);
            return [falls, falls * t];
        }
        let [slow, fast] = [-1.0, 1.0].map(|sign| libm::exp(-(zeta * omega + sign * rate) * t));
        [0.5 * (slow + fast), 0.5 * (slow - fast) / rate]
    }
}

/// A piece of the motion, under `a + b t`: `u = α + βt + w`, w free.
struct Piece {
    own: Oscillator,
    /// α and β.
    follows: [f64; 2],
    /// w and its rate at the beginning.
    free: [f64; 2],
}

impl Piece {
    fn new(own: Oscillator, [u, v]: [f64; 2], a: f64, b: f64) -> Self {
        let square = own.omega * own.omega;
        let beta = -b / square;
        let alpha = -(a + 2.0 * own.zeta * own.omega * beta) / square;
        Self { own, follows: [alpha, beta], free: [u - alpha, v - beta] }
    }

    /// Way and velocity so long after the beginning.
    fn at(&self, t: f64) -> [f64; 2] {
        let ([c, s], [w, rate], [alpha, beta]) = (self.own.waves(t), self.free, self.follows);
        let Oscillator { omega, zeta } = self.own;
        let u = w * (c + zeta * omega * s) + rate * s;
        let v = -omega * omega * s * w + rate * (c - zeta * omega * s);
        [alpha + beta * t + u, beta + v]
    }

    /// How far it goes within a time: near an end of it, for what it swings about goes along a line, and what it swings by falls along a curve that bends upwards.
    fn farthest(&self, duration: f64) -> f64 {
        let period = std::f64::consts::TAU / self.own.omega;
        if duration <= 2.0 * period {
            return self.farthest_between([0.0, duration]);
        }
        self.farthest_between([0.0, period]).max(self.farthest_between([duration - period, duration]))
    }

    fn farthest_between(&self, [from, to]: [f64; 2]) -> f64 {
        let looks = (self.own.omega * (to - from) / LOOK).ceil().max(1.0);
        let mut before = (from, self.at(from));
        let mut most = before.1[0].abs();
        for look in 1..=looks as usize {
            let time = from + (to - from) * look as f64 / looks;
            let now = self.at(time);
            most = most.max(now[0].abs());
            if now[1] * before.1[1] < 0.0 {
                most = most.max(self.turning([before.0, time], before.1[1]).abs());
            }
            before = (time, now);
        }
        most
    }

    /// Its way where the velocity, at the first of two times of this sign and at the other of the other, is zero.
    fn turning(&self, [mut from, mut to]: [f64; 2], sign: f64) -> f64 {
        for _ in 0..HALVINGS {
            let middle = 0.5 * (from + to);
            if self.at(middle)[1] * sign > 0.0 { from = middle } else { to = middle }
        }
        self.at(0.5 * (from + to))[0]
    }
}
