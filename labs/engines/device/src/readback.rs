//! Copies from device memory to the host.

use std::ops::Range;

use bytemuck::Pod;
use wgpu::{Buffer, BufferDescriptor, BufferUsages, MapMode};

use crate::device::Gpu;
use crate::work::Work;

/// Host memory that the device can write to, kept from one read to the next.
///
/// A graphics card computes in memory that the host cannot access. To read a buffer, the host has
/// the buffer copied to memory that both can access, and *maps* this memory when the copy is done.
/// CUDA's `cudaMemcpy(…, cudaMemcpyDeviceToHost)` does both steps. The report used unified memory:
/// the driver makes the same copy page by page, whenever either side touches a page that is on the
/// other side.
#[derive(Default)]
pub struct Readback {
    staging: Option<Buffer>,
}

impl Readback {
    /// Submits `work`, waits for all work, and returns the items `range` of each of `sources`.
    pub fn read<T: Pod, const K: usize>(
        &mut self,
        gpu: &Gpu,
        mut work: Work<'_>,
        sources: [(&Buffer, Range<u64>); K],
    ) -> [Vec<T>; K] {
        let item = size_of::<T>() as u64;
        let sources =
            sources.map(|(source, Range { start, end })| (source, start * item..end * item));
        let total: u64 = sources.iter().map(|(_, bytes)| bytes.end - bytes.start).sum();
        let staging = self.at_least(gpu, total);
        let mut offset = 0;
        for (source, bytes) in &sources {
            let len = bytes.end - bytes.start;
            work.copy(source, bytes.start, staging, offset, len);
            offset += len;
        }
        work.submit();
        if total == 0 {
            gpu.wait();
            return std::array::from_fn(|_| Vec::new());
        }
        staging.map_async(MapMode::Read, ..total, |result| {
            result.expect("a finished copy can be mapped");
        });
        gpu.wait();
        let view = staging.get_mapped_range(..total).expect("it was just mapped");
        let mut offset = 0;
        let values = sources.map(|(_, bytes)| {
            let start = offset as usize;
            offset += bytes.end - bytes.start;
            bytemuck::pod_collect_to_vec(&view[start..offset as usize])
        });
        drop(view);
        staging.unmap();
        values
    }

    fn at_least(&mut self, gpu: &Gpu, bytes: u64) -> &Buffer {
        if self.staging.as_ref().is_none_or(|staging| staging.size() < bytes) {
            self.staging = None;
        }
        self.staging.get_or_insert_with(|| {
            gpu.device.create_buffer(&BufferDescriptor {
                label: Some("staging"),
                size: bytes.next_power_of_two().max(256),
                usage: BufferUsages::MAP_READ | BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        })
    }
}
