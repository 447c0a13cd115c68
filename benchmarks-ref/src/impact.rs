//! What a mass feels that hits a wide plate or the end of a bar.

use libm::exp;

/// Steps of the march through one passage of a wave to and fro.
const STEPS: usize = 4000;

/// Velocity over that of the impact of a mass on a wide plate of a point impedance `Z = 8 √(B ρt)`, after a time `Z t/M`.
pub fn velocity_on_a_plate(time: f64) -> f64 {
    exp(-time)
}

/// Velocities v/v₀ of a rigid mass that hits the end of a bar, whose other end is held, at times c t/L until it parts, by Saint-Venant's waves.
///
/// With μ the mass of the bar over that of the body, each wave that comes back from the held end doubles where it meets the body:
/// `dv/dτ = −μ [v(τ) + 2 v(τ − 2) + 2 v(τ − 4) + …]`, until the bracket, the force over that at the start, is zero. By the rule of trapezoids.
pub fn struck_bar(ratio: f64) -> Vec<[f64; 2]> {
    let step = 2.0 / STEPS as f64;
    let half = 0.5 * step * ratio;
    let mut found = vec![[0.0, 1.0]];
    // What waves bring at a moment, with those whose front is there or without.
    let brought = |found: &[[f64; 2]], now: usize, front: usize| -> f64 {
        let passages = (1..).map(|k| k * STEPS).take_while(|gone| gone + front <= now);
        passages.map(|gone| 2.0 * found[now - gone][1]).sum()
    };
    loop {
        let now = found.len() - 1;
        let [time, speed] = found[now];
        let force = speed + brought(&found, now, 0);
        if force <= 0.0 {
            return found;
        }
        let next = brought(&found, now + 1, 1);
        let later = (speed - half * (force + next)) / (1.0 + half);
        found.push([time + step, later]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Durations of the contact: `2 + (1 + ½ e^{−2μ})/μ` where it ends on the first wave that comes back; on later ones by Saint-Venant, as in
    /// Timoshenko and Goodier's Theory of Elasticity.
    #[test]
    fn the_bar_parts_when_saint_venant_says() {
        let first = |ratio: f64| (ratio, 2.0 + (1.0 + 0.5 * exp(-2.0 * ratio)) / ratio);
        for (ratio, duration) in [first(2.0), first(1.0), (0.5, 4.708), (0.25, 5.900)] {
            let found = struck_bar(ratio);
            let last = found[found.len() - 1];
            assert!((last[0] - duration).abs() < 2e-3, "{ratio}: {last:?}");
        }
    }

    /// Until the first wave is back the bar is endless; halves of the step change nothing that is seen.
    #[test]
    fn at_first_the_bar_is_endless() {
        let found = struck_bar(0.5);
        for [time, speed] in &found[..STEPS] {
            assert!((speed - velocity_on_a_plate(0.5 * time)).abs() < 1e-7, "{time}: {speed}");
        }
        // What is left in the bar is energy that the body has lost.
        let rebound = -found[found.len() - 1][1];
        assert!(rebound > 0.5 && rebound < 1.0, "{rebound}");
    }
}
