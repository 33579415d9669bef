//! Worker processes, each of which solves one scene: a scene that takes too much memory or time ends its worker, and is counted as
//! killed.
use std::io::{self, Read, Write};
use std::process::{Command, Stdio};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use recede::selftest::{CheckedScene, Comparison, compare};
use recede::{Contact, Options};
use serde::{Deserialize, Serialize};

use super::super::Failure;
use super::SelftestArguments;

/// The result of one scene.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct Ended {
    pub(super) number: u64,
    /// Status in one word, and the reason.
    pub(super) status: String,
    pub(super) reason: String,
    /// Whether the result must never happen, such as a panic.
    pub(super) is_wrong: bool,
    /// How long the contact problem took.
    pub(super) seconds: f64,
    /// Figures of the answer, if there is one.
    pub(super) answer: Option<AnswerNumbers>,
    /// `None` if not requested, or if there is no answer, or no stricter one.
    pub(super) comparisons: Option<Vec<Comparison>>,
}

/// Figures of an answer.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct AnswerNumbers {
    pub(super) modes: usize,
    pub(super) wavenumbers: usize,
    pub(super) newton_steps: usize,
    /// Half-length under the punch over thickness; `None` without layers.
    pub(super) relative_half_length: Option<f64>,
    /// The largest of the relative error estimates.
    pub(super) worst: f64,
    pub(super) warned: bool,
}

impl SelftestArguments {
    /// Solves the scene whose number is the first line of standard input, and writes the result in RON, which has infinite numbers.
    pub(super) fn work(&self, out: &mut dyn Write) -> Result<(), Failure> {
        limit_memory(self.memory)?;
        let mut number = String::new();
        io::stdin().read_line(&mut number)?;
        thread::Builder::new().spawn(|| {
            // whoever has asked is gone, and nobody waits for the scene that is being solved
            if io::copy(&mut io::stdin(), &mut io::sink()).is_ok() {
                leave();
            }
        })?;
        let ended = self.one(number.trim().parse().map_err(io::Error::other)?)?;
        Ok(write!(out, "{}", ron::to_string(&ended).map_err(io::Error::other)?)?)
    }

    fn one(&self, number: u64) -> Result<Ended, recede::Error> {
        let scene = self.scene(number)?;
        let thickness = scene.stack()?.total_thickness();
        let options = Options { tolerance: self.tolerance };
        let CheckedScene { outcome, seconds } =
            CheckedScene::run(&scene, &options, number.is_multiple_of(super::PICTURED));
        let solution = outcome.solution();
        let answer = solution.map(|solution| {
            let of = |contact: &Contact| {
                let end = contact.intervals().last().map_or(0.0, |last| last.right_error / last.right);
                [end, contact.central_pressure_error / contact.central_pressure]
            };
            let first = solution.contacts().first().map_or(0.0, Contact::reach);
            AnswerNumbers {
                modes: solution.modes(),
                wavenumbers: solution.wavenumbers(),
                newton_steps: solution.newton_steps(),
                relative_half_length: (thickness > 0.0).then_some(first / thickness),
                worst: solution.contacts().iter().flat_map(of).fold(0.0, f64::max),
                warned: !solution.warnings().is_empty(),
            }
        });
        let comparisons = solution.filter(|_| self.verify).and_then(|solution| compare(&scene, solution).ok());
        Ok(Ended {
            number,
            status: outcome.status().to_owned(),
            reason: outcome.reason(),
            is_wrong: outcome.is_wrong(),
            seconds,
            answer,
            comparisons,
        })
    }
}

/// Solves one scene in a process of its own.
pub(super) fn run(selftest: &SelftestArguments, number: u64) -> Result<Ended, Failure> {
    // with the same options
    let mut process = Command::new(std::env::current_exe()?)
        .args(std::env::args_os().skip(1))
        .arg("--worker")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()?;
    let (Some(mut asked), Some(mut output)) = (process.stdin.take(), process.stdout.take()) else {
        return Err(io::Error::other("a process without input and output").into());
    };
    let (found, answer) = channel();
    thread::spawn(move || {
        let mut text = String::new();
        if output.read_to_string(&mut text).is_ok() {
            let _ = found.send(text);
        }
    });
    // it may have ended by itself
    let _ = writeln!(asked, "{number}");
    let answer = answer.recv_timeout(Duration::from_secs(selftest.seconds));
    let _ = process.kill();
    let _ = process.wait();
    let reason = match answer {
        Ok(text) if !text.is_empty() => return Ok(ron::from_str(&text).map_err(io::Error::other)?),
        Err(RecvTimeoutError::Timeout) => format!("longer than {} s", selftest.seconds),
        _ => format!("aborted, or more memory than {} MB", selftest.memory),
    };
    let (status, seconds) = ("killed".to_owned(), selftest.seconds as f64);
    Ok(Ended { number, status, reason, is_wrong: true, seconds, ..Ended::default() })
}

/// Ends this process at once, whatever its other threads do.
#[expect(clippy::disallowed_methods, reason = "nobody is left who could be told an exit status")]
fn leave() -> ! {
    std::process::exit(0)
}

/// Limits the memory of this process; a request for more ends it.
#[cfg(unix)]
fn limit_memory(megabytes: u64) -> Result<(), Failure> {
    use rustix::process::{Resource, Rlimit, setrlimit};
    let bytes = Some(megabytes.saturating_mul(1 << 20));
    setrlimit(Resource::As, Rlimit { current: bytes, maximum: bytes }).map_err(io::Error::from)?;
    Ok(())
}

/// Without such a limit on this operating system, memory is unlimited.
#[cfg(not(unix))]
fn limit_memory(_: u64) -> Result<(), Failure> {
    Ok(())
}
