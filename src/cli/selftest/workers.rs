//! Worker processes, each of which solves scenes one after the other: a scene that takes too much memory or time ends its
//! worker, and is counted as killed.
use std::io::{self, BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use recede::selftest::{Check, Comparison, Outcome, compare};
use recede::{Options, Scene};
use serde::{Deserialize, Serialize};

use super::super::Failure;
use super::Selftest;

/// The result of one scene.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct Ended {
    pub(super) number: u64,
    /// Status in one word, and the reason.
    pub(super) status: String,
    pub(super) reason: String,
    /// The contact that the reason names.
    pub(super) interface: String,
    /// Whether it must never happen.
    pub(super) is_wrong: bool,
    /// How long the contact problem took.
    pub(super) seconds: f64,
    /// Figures of the answer, if there is one.
    pub(super) answer: Option<Answer>,
    /// `None` if not requested, or if there is no answer, or no stricter one.
    pub(super) comparisons: Option<Vec<Compared>>,
}

/// Figures of an answer.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Answer {
    pub(super) modes: usize,
    pub(super) wavenumbers: usize,
    pub(super) newton_steps: usize,
    /// Half-length under the punch over thickness; `None` without layers.
    pub(super) relative_half_length: Option<f64>,
    /// The largest of the relative error estimates; `None` if that is not finite.
    pub(super) worst: Option<f64>,
    pub(super) warned: bool,
}

/// A number of an answer compared with that of the strictest answer.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Compared {
    pub(super) interface: String,
    pub(super) quantity: String,
    pub(super) error: Option<f64>,
    pub(super) estimate: f64,
    pub(super) blur: f64,
    pub(super) excess: Option<f64>,
    pub(super) caution: f64,
}

impl From<Comparison> for Compared {
    fn from(one: Comparison) -> Self {
        // what is not finite is no number in JSON
        let finite = |value: f64| value.is_finite().then_some(value);
        Self {
            interface: one.interface.to_string(),
            quantity: one.quantity.to_owned(),
            error: finite(one.error),
            estimate: one.estimate,
            blur: one.blur,
            excess: finite(one.excess()),
            caution: one.caution(),
        }
    }
}

impl Ended {
    /// A scene whose process was ended.
    fn killed(number: u64, reason: &str, seconds: f64) -> Self {
        let (status, reason) = ("killed".to_owned(), reason.to_owned());
        Self { number, status, reason, is_wrong: true, seconds, ..Self::default() }
    }
}

impl Selftest {
    /// Solves the scenes whose numbers are read from standard input, one per line; writes the result of each as a line of JSON.
    pub(super) fn work(&self, out: &mut dyn Write) -> Result<(), Failure> {
        limit_memory(self.memory)?;
        let (asked, numbers) = channel();
        thread::Builder::new().spawn(move || {
            let lines = io::stdin().lines().map_while(Result::ok);
            for number in lines.map_while(|line| line.trim().parse().ok()) {
                if asked.send(number).is_err() {
                    return;
                }
            }
            // whoever has asked is gone, and nobody waits for the scene that is being solved
            leave();
        })?;
        for number in numbers {
            serde_json::to_writer(&mut *out, &self.one(number)?).map_err(io::Error::from)?;
            writeln!(out)?;
            out.flush()?;
        }
        Ok(())
    }

    fn one(&self, number: u64) -> Result<Ended, recede::Error> {
        let scene = self.scene(number)?;
        let thickness = scene.stack()?.total_thickness();
        let options = Options { tolerance: self.tolerance, ..Options::default() };
        let check = Check::run(&scene, &options, number.is_multiple_of(super::PICTURED));
        Ok(self.ended(number, &scene, thickness, &check))
    }

    fn ended(&self, number: u64, scene: &Scene, thickness: f64, check: &Check) -> Ended {
        let outcome: &Outcome = &check.outcome;
        let solution = outcome.solution();
        let answer = solution.map(|solution| {
            let contacts = solution.contacts();
            let worst = contacts.iter().fold(0.0, |worst: f64, contact| {
                worst
                    .max(contact.intervals().last().map_or(0.0, |last| last.right_error / last.right))
                    .max(contact.central_pressure_error / contact.central_pressure)
            });
            let first = contacts.first().map_or(0.0, |contact| contact.reach());
            Answer {
                modes: solution.modes(),
                wavenumbers: solution.wavenumbers(),
                newton_steps: solution.newton_steps(),
                relative_half_length: (thickness > 0.0).then_some(first / thickness),
                worst: worst.is_finite().then_some(worst),
                warned: !solution.warnings().is_empty(),
            }
        });
        let comparisons = solution.filter(|_| self.verify).and_then(|solution| compare(scene, solution).ok());
        Ended {
            number,
            status: outcome.status().to_owned(),
            reason: outcome.reason(),
            interface: outcome.interface().map_or(String::new(), |interface| interface.to_string()),
            is_wrong: outcome.is_wrong(),
            seconds: check.seconds,
            answer,
            comparisons: comparisons.map(|all| all.into_iter().map(Compared::from).collect()),
        }
    }
}

/// A worker process, started when it is first needed, and again after it was ended.
pub(super) struct Worker<'a> {
    selftest: &'a Selftest,
    running: Option<Running>,
}

struct Running {
    process: Child,
    numbers: ChildStdin,
    lines: Receiver<String>,
}

impl<'a> Worker<'a> {
    pub(super) fn new(selftest: &'a Selftest) -> Self {
        Self { selftest, running: None }
    }

    /// Solves one scene.
    pub(super) fn run(&mut self, number: u64) -> Result<Ended, Failure> {
        let mut running = match self.running.take() {
            Some(running) => running,
            None => Running::start(self.selftest)?,
        };
        let limit = Duration::from_secs(self.selftest.seconds);
        let asked = writeln!(running.numbers, "{number}").and_then(|()| running.numbers.flush());
        let answer =
            if asked.is_ok() { running.lines.recv_timeout(limit) } else { Err(RecvTimeoutError::Disconnected) };
        let reason = match answer {
            Ok(line) => {
                self.running = Some(running);
                return Ok(serde_json::from_str(&line).map_err(io::Error::from)?);
            }
            Err(RecvTimeoutError::Timeout) => format!("longer than {} s", self.selftest.seconds),
            Err(RecvTimeoutError::Disconnected) => format!("aborted, or more memory than {} MB", self.selftest.memory),
        };
        running.end();
        Ok(Ended::killed(number, &reason, self.selftest.seconds as f64))
    }
}

impl Drop for Worker<'_> {
    fn drop(&mut self) {
        if let Some(running) = self.running.take() {
            running.end();
        }
    }
}

impl Running {
    fn start(selftest: &Selftest) -> Result<Self, Failure> {
        let mut process = Command::new(std::env::current_exe()?)
            .args(selftest.arguments())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()?;
        let (Some(numbers), Some(output)) = (process.stdin.take(), process.stdout.take()) else {
            return Err(io::Error::other("a process without input and output").into());
        };
        let (found, lines) = channel();
        thread::spawn(move || {
            for line in BufReader::new(output).lines().map_while(Result::ok) {
                if found.send(line).is_err() {
                    return;
                }
            }
        });
        Ok(Self { process, numbers, lines })
    }

    fn end(mut self) {
        // it may have ended by itself
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
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
