//! Processes of a selftest end with it.
use std::io::Write;
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// Workers that nobody asks any more leave at once, whatever they have to do.
#[test]
fn workers_of_a_selftest_that_is_gone_leave() {
    let mut worker = Command::new(env!("CARGO_BIN_EXE_recede"))
        .args(["selftest", "--worker", "--seed", "1", "--verify"])
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    // scenes for a long time
    let numbers: String = (0..5000).map(|number| format!("{number}\n")).collect();
    worker.stdin.take().unwrap().write_all(numbers.as_bytes()).unwrap();
    let begin = Instant::now();
    while worker.try_wait().unwrap().is_none() {
        if begin.elapsed() > Duration::from_secs(20) {
            worker.kill().unwrap();
            panic!("it is still there");
        }
        thread::sleep(Duration::from_millis(10));
    }
}
