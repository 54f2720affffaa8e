//! The device, if there is one. On a machine without a device, tests cannot run and report this.

use std::collections::BTreeSet;
use std::io::{self, Write};
use std::sync::Mutex;

use device::{Gpu, GpuError, Launcher, refuse_todo};
use device_discs::hard::HardKernels;
use device_discs::soft::SoftKernels;
use lab9::Lab9;

/// Returns the device for a question of a task. `None` if there is no device.
///
/// # Panics
/// If the task is still open, with or without a device.
pub(crate) fn adapter(task: &str) -> Option<&'static Gpu> {
    visit(task);
    match Gpu::shared() {
        Ok(gpu) => Some(gpu),
        Err(error @ (GpuError::NoAdapter | GpuError::NoSuchAdapter { .. })) => {
            skip("skipped", &error);
            None
        }
        Err(error) => panic!("{error}"),
    }
}

/// Returns the device. `None` if no device computes in double precision.
pub(crate) fn adapter_with_doubles(task: &str) -> Option<&'static Gpu> {
    adapter(task)
        .filter(|gpu| gpu.expect_real::<f64>().inspect_err(|error| skip("left out", error)).is_ok())
}

/// Stops at the `todo!` of a task before anything else can stop.
fn visit(task: &str) {
    let source = match task {
        "9.1" => {
            let _ = Lab9::launch(1, 1, &wgpu::Limits::default());
            return;
        }
        "9.2" => Lab9::filter(),
        "9.3" => Lab9::basic(),
        "9.4" => Lab9::balanced(),
        "9.5" => Lab9::choose(),
        "9.6" => <Lab9 as SoftKernels>::scan(),
        "9.7" => Lab9::sort(),
        "9.8" => Lab9::position_f32(),
        _ => return,
    };
    refuse_todo(&[source]);
}

/// Reports once that tests, or parts of them, do not run here. The test harness would hide the
/// output of `eprintln`, because a test that cannot run passes.
fn skip(what: &str, why: &GpuError) {
    static PRINTED: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());
    let line = format!("{what}: {why}\n");
    if PRINTED.lock().expect("no test panics here").insert(line.clone()) {
        io::stderr().write_all(line.as_bytes()).expect("standard error is open");
    }
}
