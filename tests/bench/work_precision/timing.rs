//! Time of one call, and how it is written.
use std::sync::LazyLock;
use std::time::Instant;

/// A call is repeated for so long.
const LONG: f64 = 0.5;
/// So long calls are timed together: looking at the clock takes time, too, and it goes in ticks of the scheduler.
const TOGETHER: f64 = 0.02;

/// The mean time of a call, in seconds, and what it returned last.
pub fn time<T>(mut call: impl FnMut() -> T) -> (f64, T) {
    // the first call may prepare what the others use
    let first = now();
    let mut result = std::hint::black_box(call());
    if now() - first > LONG {
        return (now() - first, result);
    }
    let once = Instant::now();
    drop(std::hint::black_box(call()));
    let begin = now();
    let calls = (TOGETHER / once.elapsed().as_secs_f64()).ceil().clamp(1.0, 1e4);
    let mut count = 0.0;
    loop {
        for _ in 0..calls as usize {
            result = std::hint::black_box(call());
        }
        count += calls;
        let spent = now() - begin;
        if spent > LONG {
            return (spent / count, result);
        }
    }
}

/// Seconds for which this thread has had a processor, where the system reports it (Linux): on an idle machine wall time, and on a
/// busy one what wall time would be. Else wall time.
fn now() -> f64 {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    let told = std::fs::read_to_string("/proc/thread-self/schedstat");
    let nanoseconds = told.ok().and_then(|text| text.split_whitespace().next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| START.elapsed().as_secs_f64(), |nanoseconds| 1e-9 * nanoseconds)
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
