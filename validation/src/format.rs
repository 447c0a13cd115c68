//! Numbers in a few characters.

/// Four significant digits, without trailing zeros; powers of ten outside 1e-4 … 1e6.
pub fn short(value: f64) -> String {
    digits(value, 4)
}

/// Three significant digits, as [`short`].
pub fn three(value: f64) -> String {
    digits(value, 3)
}

/// A time in three digits with its unit.
pub fn duration(seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s < 1e-3 => (1e6 * s, "µs"),
        s if s < 1.0 => (1e3 * s, "ms"),
        s if s < 120.0 => (s, "s"),
        s => (s / 60.0, "min"),
    };
    format!("{} {unit}", three(value))
}

fn digits(value: f64, count: i32) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let size = libm::log10(value.abs()).floor() as i32;
    if !(-4..6).contains(&size) {
        let text = format!("{value:.*e}", count as usize - 1);
        let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{power}", digits.trim_end_matches('0').trim_end_matches('.'));
    }
    let decimals = (count - 1 - size).max(0) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
}

#[test]
fn numbers_are_short() {
    for (value, text) in [
        (0.0, "0"),
        (2.22194, "2.222"),
        (0.27594, "0.2759"),
        (0.4, "0.4"),
        (-12.0, "-12"),
        (123_456.7, "123457"),
        (1.5e-11, "1.5e-11"),
        (3.2e7, "3.2e7"),
        (1e-9, "1e-9"),
    ] {
        assert_eq!(short(value), text);
    }
}

#[test]
fn times_have_three_digits_and_a_unit() {
    for (seconds, text) in
        [(4.21e-4, "421 µs"), (0.034567, "34.6 ms"), (2.0, "2 s"), (75.25, "75.2 s"), (150.0, "2.5 min")]
    {
        assert_eq!(duration(seconds), text);
    }
}
