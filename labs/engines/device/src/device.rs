//! The device: opened once, and shared by all engines of a program.

use std::env;
use std::sync::OnceLock;

use bytemuck::NoUninit;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{
    Adapter, AdapterInfo, Backends, Buffer, BufferDescriptor, BufferUsages, Device,
    DeviceDescriptor, DeviceType, Features, Instance, InstanceDescriptor, Limits, PollType,
    PowerPreference, Queue, RequestAdapterOptions,
};

use crate::error::GpuError;

/// An open device and its queue.
///
/// A queue runs work in the order of submission while the host continues. Results reach the host
/// only when the host waits for them.
pub struct Gpu {
    /// Makes buffers, kernels and command buffers.
    pub device: Device,
    /// Runs command buffers.
    pub queue: Queue,
    info: AdapterInfo,
}

impl Gpu {
    /// Returns this program's device. The first call opens the device.
    ///
    /// The environment variable `WGPU_ADAPTER_NAME` can name the device. Otherwise it is a device
    /// of the fastest kind in the machine.
    ///
    /// # Errors
    /// There is no such device, or the device cannot be opened.
    pub fn shared() -> Result<&'static Self, GpuError> {
        static SHARED: OnceLock<Result<Gpu, GpuError>> = OnceLock::new();
        SHARED.get_or_init(Self::open).as_ref().map_err(Clone::clone)
    }

    fn open() -> Result<Self, GpuError> {
        let adapter = find_adapter()?;
        let info = adapter.get_info();
        let wanted = Features::SHADER_F64 | Features::TIMESTAMP_QUERY;
        let request = adapter.request_device(&DeviceDescriptor {
            required_features: adapter.features() & wanted,
            required_limits: adapter.limits(),
            ..Default::default()
        });
        let (device, queue) = pollster::block_on(request)
            .map_err(|e| GpuError::Closed { name: info.name.clone(), why: e.to_string() })?;
        Ok(Self { device, queue, info })
    }

    /// Returns the device's name.
    ///
    /// The name shows whether the device is a program on the host's processor. Times of such a
    /// device must not be compared with times of a graphics processor.
    pub fn name(&self) -> String {
        let note =
            if self.is_software() { " (software on the host's processor, not a GPU)" } else { "" };
        format!("{}{note}", self.info.name)
    }

    /// Whether the device is a program on the host's own processor.
    pub fn is_software(&self) -> bool {
        self.info.device_type == DeviceType::Cpu
    }

    /// Whether kernels may compute in double precision.
    pub fn has_doubles(&self) -> bool {
        self.device.features().contains(Features::SHADER_F64)
    }

    /// Whether the device can measure the time between two kernels.
    pub fn has_timestamps(&self) -> bool {
        self.device.features().contains(Features::TIMESTAMP_QUERY)
    }

    /// Returns the limits of the device: threads in a workgroup, workgroups in a launch, bytes in a
    /// buffer.
    pub fn limits(&self) -> Limits {
        self.device.limits()
    }

    /// Returns the greatest number of bytes that a kernel can access in one buffer.
    pub fn most_bytes(&self) -> u64 {
        let limits = self.limits();
        limits.max_storage_buffer_binding_size.min(limits.max_buffer_size)
    }

    /// Returns device memory of `bytes` bytes, all zero, for kernels to read and write.
    ///
    /// # Errors
    /// The device cannot provide a buffer of this size.
    pub fn storage(&self, what: &'static str, bytes: u64) -> Result<Buffer, GpuError> {
        let most = self.most_bytes();
        if bytes > most {
            return Err(GpuError::Memory { what, bytes, most, name: self.info.name.clone() });
        }
        Ok(self.device.create_buffer(&BufferDescriptor {
            label: Some(what),
            size: bytes.next_multiple_of(16).max(16),
            usage: BufferUsages::STORAGE | BufferUsages::COPY_SRC | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        }))
    }

    /// Returns a small block of parameters that invocations can read but not write.
    pub fn uniform(&self, bytes: &[u8]) -> Buffer {
        let mut contents = bytes.to_vec();
        contents.resize(bytes.len().next_multiple_of(16), 0);
        self.device.create_buffer_init(&BufferInitDescriptor {
            label: Some("parameters"),
            contents: &contents,
            usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
        })
    }

    /// Copies `values` to the start of `buffer`, before any work that is submitted later.
    pub fn upload<T: NoUninit>(&self, buffer: &Buffer, values: &[T]) {
        self.queue.write_buffer(buffer, 0, bytemuck::cast_slice(values));
    }

    /// Waits until all submitted work is done, as `cudaDeviceSynchronize` does.
    pub fn wait(&self) {
        self.device.poll(PollType::wait_indefinitely()).expect("the device is not lost");
    }

    /// Returns properties of the device in words, for readers of measurements, without the
    /// [`name`](Self::name).
    pub fn about(&self) -> Vec<(&'static str, String)> {
        let limits = self.limits();
        let kind = match self.info.device_type {
            DeviceType::Cpu => "software on the host's processor, not a GPU",
            DeviceType::DiscreteGpu => "GPU with memory of its own",
            DeviceType::IntegratedGpu => "GPU that shares the host's memory",
            DeviceType::VirtualGpu => "GPU shared with other machines",
            DeviceType::Other => "unknown",
        };
        let rows = limits.max_compute_workgroups_per_dimension;
        let most = limits.max_compute_invocations_per_workgroup;
        vec![
            ("kind", kind.into()),
            (
                "driver",
                format!("{}, {} {}", self.info.backend, self.info.driver, self.info.driver_info),
            ),
            ("double precision", yes_or_no(self.has_doubles())),
            ("timestamps", yes_or_no(self.has_timestamps())),
            ("a workgroup", format!("{} threads", most.min(limits.max_compute_workgroup_size_x))),
            ("a launch", format!("{rows} by {rows} workgroups")),
            ("a buffer", format!("{} bytes", self.most_bytes())),
        ]
    }
}

fn yes_or_no(is: bool) -> String {
    if is { "yes" } else { "no" }.to_owned()
}

fn find_adapter() -> Result<Adapter, GpuError> {
    let instance = Instance::new(InstanceDescriptor::new_without_display_handle_from_env());
    let Ok(wanted) = env::var("WGPU_ADAPTER_NAME") else {
        let request = instance.request_adapter(&RequestAdapterOptions {
            power_preference: PowerPreference::HighPerformance,
            ..Default::default()
        });
        return pollster::block_on(request).map_err(|_| GpuError::NoAdapter);
    };
    let adapters = pollster::block_on(instance.enumerate_adapters(Backends::all()));
    let lower = wanted.to_lowercase();
    let mut names = Vec::new();
    for adapter in adapters {
        let name = adapter.get_info().name;
        if name.to_lowercase().contains(&lower) {
            return Ok(adapter);
        }
        names.push(name);
    }
    let found = if names.is_empty() { "none at all".into() } else { names.join(", ") };
    Err(GpuError::NoSuchAdapter { wanted, found })
}
