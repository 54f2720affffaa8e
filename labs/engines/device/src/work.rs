//! A piece of work for the device: a list of commands.

use wgpu::{Buffer, CommandEncoder, ComputePass, ComputePassDescriptor};

use crate::device::Gpu;
use crate::kernel::Bound;
use crate::launch::Launch;
use crate::stopwatch::Stopwatch;

/// Commands that are recorded first and then submitted together.
///
/// They run one after the other: each launch sees all results of the launches before it.
pub struct Work<'a> {
    gpu: &'a Gpu,
    stopwatch: Option<&'a Stopwatch>,
    encoder: CommandEncoder,
    pass: Option<ComputePass<'static>>,
    launches: Vec<&'static str>,
}

impl<'a> Work<'a> {
    /// Makes an empty piece of work. With a stopwatch, each launch is timed separately, and
    /// `submit` waits for the device.
    pub fn new(gpu: &'a Gpu, stopwatch: Option<&'a Stopwatch>) -> Self {
        let encoder = gpu.device.create_command_encoder(&Default::default());
        Self { gpu, stopwatch, encoder, pass: None, launches: Vec::new() }
    }

    /// Sets a buffer to zero, as `cudaMemset` does.
    pub fn clear(&mut self, buffer: &Buffer) {
        self.pass = None;
        self.encoder.clear_buffer(buffer, 0, None);
    }

    /// Copies from one buffer to another on the device. Offsets and size are in bytes.
    pub fn copy(&mut self, from: &Buffer, start: u64, to: &Buffer, offset: u64, bytes: u64) {
        self.pass = None;
        if bytes > 0 {
            self.encoder.copy_buffer_to_buffer(from, start, to, offset, bytes);
        }
    }

    /// Records the launch of a kernel.
    pub fn launch(&mut self, kernel: &Bound, launch: Launch) {
        let timed = self.stopwatch.filter(|watch| watch.has_room(self.launches.len()));
        if timed.is_some() {
            self.pass = None;
        }
        let encoder = &mut self.encoder;
        let number = self.launches.len();
        let pass = self.pass.get_or_insert_with(|| {
            let timestamp_writes = timed.map(|watch| watch.writes(number));
            let descriptor = ComputePassDescriptor { label: Some(kernel.name), timestamp_writes };
            encoder.begin_compute_pass(&descriptor).forget_lifetime()
        });
        pass.set_pipeline(&kernel.pipeline);
        pass.set_bind_group(0, &kernel.buffers, &[]);
        let [x, y] = launch.groups;
        pass.dispatch_workgroups(x, y, 1);
        if timed.is_some() {
            self.launches.push(kernel.name);
        }
    }

    /// Submits the work. Waits for the device only if there is a stopwatch.
    ///
    /// If the device refuses any part of the work, the device runs nothing.
    ///
    /// # Panics
    /// If the device refuses the work and no error scope is open. The device never refuses a launch
    /// of a compiled kernel that is within the device's limits.
    pub fn submit(mut self) {
        self.pass = None;
        let timed = self.stopwatch.filter(|_| !self.launches.is_empty());
        if let Some(watch) = timed {
            watch.resolve(&mut self.encoder, self.launches.len());
        }
        self.gpu.queue.submit([self.encoder.finish()]);
        if let Some(watch) = timed {
            watch.collect(self.gpu, &self.launches);
        }
    }
}
