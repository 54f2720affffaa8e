//! The C program of the book's page on races. It is compiled and run if a suitable compiler is
//! installed.

use std::path::Path;
use std::process::Command;

/// Returns the output of `rebin.c`, built with these flags, on `threads` threads. `None` if the
/// program cannot be built or run.
fn printed(name: &str, flags: &[&str], threads: usize) -> Option<String> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let program = folder.join(name);
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("rebin.c");
    let mut compiler = Command::new("cc");
    compiler.args(["-Wall", "-Wextra", "-Werror", "-fopenmp"]).args(flags);
    let built = compiler.arg(source).arg("-o").arg(&program).output().ok()?;
    let errors = String::from_utf8_lossy(&built.stderr);
    // A compiler without OpenMP or without the sanitizer prints errors too. Only errors in the
    // source count.
    assert!(!errors.contains("rebin.c:"), "{errors}");
    let mut command = Command::new(program);
    let ended = command.env("OMP_NUM_THREADS", threads.to_string()).output().ok()?;
    let [stdout, stderr] = [&ended.stdout, &ended.stderr].map(|text| String::from_utf8_lossy(text));
    Some(format!("{stdout}{stderr}"))
}

#[test]
fn on_one_thread_no_particle_is_lost() {
    if let Some(printed) = printed("rebin", &["-O2"], 1) {
        assert_eq!(printed, "50 steps: all particles are in bins\n");
    }
}

#[test]
fn the_sanitizer_finds_the_race() {
    let flags = ["-g", "-O1", "-fsanitize=thread"];
    // Some kernels use a memory layout that the sanitizer cannot handle. The sanitizer reports
    // this, and finds nothing.
    if let Some(printed) = printed("rebin-watched", &flags, 2)
        && !printed.contains("unexpected memory mapping")
    {
        assert!(printed.contains("data race") && printed.contains("in put"), "{printed}");
    }
}
