//! How far a long computation has come: a bar on a terminal, elsewhere a line from time to time.
use std::io::{self, IsTerminal};
use std::sync::Mutex;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

use super::tell;

const BAR: &str = "{wide_bar} {pos}/{len}  {per_sec}  {eta} left";
/// Time between two lines.
const PAUSE: Duration = Duration::from_secs(10);

/// How many of a number of things are done; on standard error.
pub(super) struct Progress {
    bar: ProgressBar,
    /// When the last line was written; `None` if there are none.
    told: Option<Mutex<Instant>>,
    what: &'static str,
}

impl Progress {
    /// Some of them, `what` for instance `rows`, were done before.
    pub(super) fn new(what: &'static str, count: u64, done: u64) -> Self {
        let bar = ProgressBar::new(count).with_position(done);
        bar.reset_eta();
        if let Ok(style) = ProgressStyle::with_template(BAR) {
            bar.set_style(style);
        }
        let told = (!io::stderr().is_terminal()).then(|| Mutex::new(Instant::now()));
        Self { bar, told, what }
    }

    /// One more is done.
    pub(super) fn step(&self) {
        self.bar.inc(1);
        let Some(Ok(mut told)) = self.told.as_ref().map(Mutex::try_lock) else { return };
        if told.elapsed() >= PAUSE {
            *told = Instant::now();
            let (done, count) = (self.bar.position(), self.bar.length().unwrap_or_default());
            let left = self.bar.eta().as_secs();
            tell(&format!("{done} of {count} {}, about {left} s left\n", self.what));
        }
    }

    /// All are done.
    pub(super) fn finish(&self) {
        self.bar.finish_and_clear();
    }
}
