//! Wall time of one call, and how it is written.
use std::time::Instant;

/// A call is repeated for so long, and at least and at most so many times; the median counts.
const LONG: f64 = 0.5;
const FEWEST: usize = 3;
const MOST: usize = 101;

/// The median time of a call, in seconds, and what it returned last.
pub fn time<T>(mut call: impl FnMut() -> T) -> (f64, T) {
    let mut times = Vec::new();
    loop {
        let start = Instant::now();
        let result = std::hint::black_box(call());
        times.push(start.elapsed().as_secs_f64());
        let total: f64 = times.iter().sum();
        if times.len() >= MOST || times.len() >= FEWEST && total > LONG {
            times.sort_by(f64::total_cmp);
            return (times[times.len() / 2], result);
        }
    }
}

/// Three digits and a unit.
pub fn seconds(seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s < 1e-3 => (1e6 * s, "µs"),
        s if s < 1.0 => (1e3 * s, "ms"),
        s => (s, "s"),
    };
    match value {
        v if v < 10.0 => format!("{v:.2} {unit}"),
        v if v < 100.0 => format!("{v:.1} {unit}"),
        v => format!("{v:.0} {unit}"),
    }
}
