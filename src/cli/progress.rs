//! A progress bar.
use indicatif::{ProgressBar, ProgressStyle};

const BAR: &str = "{wide_bar} {pos}/{len}  {per_sec}  {eta} left";

/// A bar on standard error, if that is a terminal, with some of it done before.
pub(super) fn bar(count: u64, done: u64) -> ProgressBar {
    let bar = ProgressBar::new(count).with_position(done);
    bar.reset_eta();
    match ProgressStyle::with_template(BAR) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
