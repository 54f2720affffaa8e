//! A clock on the device.

use std::cell::RefCell;

use wgpu::{
    Buffer, BufferDescriptor, BufferUsages, MapMode, QuerySet, QuerySetDescriptor, QueryType,
};

use crate::device::Gpu;

/// Greatest number of launches that are timed in one piece of work.
const MOST: u32 = 256;
/// Bytes of the timestamps of these launches, two for each.
const BYTES: u64 = MOST as u64 * 2 * 8;

/// The time that each kernel ran, measured with *timestamp queries*.
///
/// The device reads its clock before and after a launch. The host's clock would also measure the
/// communication with the device.
pub struct Stopwatch {
    queries: QuerySet,
    resolved: Buffer,
    staging: Buffer,
    seconds: RefCell<Vec<(&'static str, f64)>>,
}

impl Stopwatch {
    /// Returns a stopwatch, or `None` if the device has no clock.
    pub fn new(gpu: &Gpu) -> Option<Self> {
        gpu.has_timestamps().then(|| Self {
            queries: gpu.device.create_query_set(&QuerySetDescriptor {
                label: Some("timestamps"),
                ty: QueryType::Timestamp,
                count: MOST * 2,
            }),
            resolved: buffer(gpu, BufferUsages::QUERY_RESOLVE | BufferUsages::COPY_SRC),
            staging: buffer(gpu, BufferUsages::MAP_READ | BufferUsages::COPY_DST),
            seconds: RefCell::default(),
        })
    }

    /// Forgets all measurements.
    pub fn reset(&self) {
        self.seconds.borrow_mut().clear();
    }

    /// Returns the seconds that each kernel has run since the last reset. Kernels are in the order
    /// of their first launches.
    pub fn seconds(&self) -> Vec<(&'static str, f64)> {
        self.seconds.borrow().clone()
    }

    pub(crate) fn has_room(&self, launches: usize) -> bool {
        launches < MOST as usize
    }

    pub(crate) fn writes(&self, launch: usize) -> wgpu::ComputePassTimestampWrites<'_> {
        let first = launch as u32 * 2;
        wgpu::ComputePassTimestampWrites {
            query_set: &self.queries,
            beginning_of_pass_write_index: Some(first),
            end_of_pass_write_index: Some(first + 1),
        }
    }

    pub(crate) fn resolve(&self, encoder: &mut wgpu::CommandEncoder, launches: usize) {
        encoder.resolve_query_set(&self.queries, 0..launches as u32 * 2, &self.resolved, 0);
        encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.staging, 0, BYTES);
    }

    /// Waits for the work and adds its time.
    pub(crate) fn collect(&self, gpu: &Gpu, launches: &[&'static str]) {
        self.staging.map_async(MapMode::Read, .., |result| {
            result.expect("a finished copy can be mapped");
        });
        gpu.wait();
        let view = self.staging.get_mapped_range(..).expect("it was just mapped");
        let ticks: Vec<u64> = bytemuck::pod_collect_to_vec(&view);
        drop(view);
        self.staging.unmap();
        let tick = f64::from(gpu.queue.get_timestamp_period()) * 1e-9;
        let mut seconds = self.seconds.borrow_mut();
        for (name, ticks) in launches.iter().zip(ticks.chunks_exact(2)) {
            let took = ticks[1].saturating_sub(ticks[0]) as f64 * tick;
            match seconds.iter_mut().find(|(known, _)| known == name) {
                Some((_, sum)) => *sum += took,
                None => seconds.push((name, took)),
            }
        }
    }
}

/// Makes a buffer for timestamps.
fn buffer(gpu: &Gpu, usage: BufferUsages) -> Buffer {
    gpu.device.create_buffer(&BufferDescriptor {
        label: Some("timestamps"),
        size: BYTES,
        usage,
        mapped_at_creation: false,
    })
}
