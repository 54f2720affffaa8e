//! The device: found once, shared by all engines of a program.

use std::env;
use std::sync::OnceLock;

use bytemuck::NoUninit;
use thiserror::Error;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{
    Adapter, AdapterInfo, Backends, Buffer, BufferDescriptor, BufferUsages, Device,
    DeviceDescriptor, DeviceType, Features, Instance, InstanceDescriptor, Limits, PowerPreference,
    Queue, RequestAdapterOptions,
};

use super::{LaunchError, Real};

/// An open device and its queue.
///
/// A queue takes work in the order in which it is submitted and runs it while the host goes on.
/// Nothing comes back unless the host waits for it.
pub struct Gpu {
    /// Makes buffers, kernels and command buffers.
    pub device: Device,
    /// Runs them.
    pub queue: Queue,
    info: AdapterInfo,
}

/// Why this lab's programs cannot run here, or a kernel was not run.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum GpuError {
    /// No driver, or no device behind it.
    #[error(
        "no adapter: this machine offers no Vulkan, Metal or DirectX 12 device (on Debian and \
         Ubuntu the packages mesa-vulkan-drivers and libvulkan1 bring one made of software)"
    )]
    NoAdapter,
    /// `WGPU_ADAPTER_NAME` asks for a device that is not there.
    #[error("no adapter: none is called '{wanted}', as WGPU_ADAPTER_NAME asks; there is {found}")]
    NoSuchAdapter {
        /// What the variable says.
        wanted: String,
        /// The names of what was found.
        found: String,
    },
    /// The driver does not let us in.
    #[error("the device {name} cannot be opened: {why}")]
    Closed {
        /// The device.
        name: String,
        /// The driver's words.
        why: String,
    },
    /// Half of all graphics processors compute in single precision only.
    #[error("the device {0} has no double precision; choose a variant that ends in f32")]
    NoDoubles(String),
    /// More memory in one piece than the device hands out.
    #[error("{what} needs {bytes} bytes in one buffer, and the device {name} gives at most {most}")]
    Memory {
        /// What should be stored.
        what: &'static str,
        /// Its size.
        bytes: u64,
        /// The greatest size of a buffer.
        most: u64,
        /// The device.
        name: String,
    },
    /// The launch is larger than the device's limits.
    #[error(transparent)]
    Launch(#[from] LaunchError),
    /// A choice that goes on in rounds made no progress.
    #[error(
        "the choice among {open} candidates does not settle: each round takes one or more, but \
         after {rounds} rounds {left} are still open"
    )]
    Unsettled {
        /// Rounds that were run.
        rounds: usize,
        /// Candidates that were open before them.
        open: u32,
        /// Candidates that are open after them.
        left: u32,
    },
    /// The driver or wgpu's validation said no. Nothing was run.
    #[error("{what} was refused, so it did not run: {why}")]
    Refused {
        /// A kernel's name.
        what: String,
        /// The reason, with the line of a WGSL source where there is one.
        why: String,
    },
}

impl Gpu {
    /// This program's device: the one named by the environment variable `WGPU_ADAPTER_NAME`, or
    /// else the fastest kind there is. It is opened at the first call.
    ///
    /// # Errors
    /// There is none, or it cannot be opened.
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

    /// What it is called. Where the device is a program on the host's own processor, the name
    /// says so, because such a device must not be compared with a graphics processor.
    pub fn name(&self) -> String {
        let note =
            if self.is_software() { " (software on the host's processor, not a GPU)" } else { "" };
        format!("{}{note}", self.info.name)
    }

    /// Whether the device is a program on the host's own processor.
    pub fn is_software(&self) -> bool {
        self.info.device_type == DeviceType::Cpu
    }

    pub(super) fn info(&self) -> &AdapterInfo {
        &self.info
    }

    /// Makes sure that kernels may compute with `R`.
    ///
    /// # Errors
    /// `R` is f64, and the device has none.
    pub fn expect_real<R: Real>(&self) -> Result<(), GpuError> {
        if R::DOUBLE && !self.device.features().contains(Features::SHADER_F64) {
            return Err(GpuError::NoDoubles(self.name()));
        }
        Ok(())
    }

    /// Whether the device can note the time between two kernels.
    pub fn has_timestamps(&self) -> bool {
        self.device.features().contains(Features::TIMESTAMP_QUERY)
    }

    /// What the device can take: threads in a workgroup, workgroups in a launch, bytes in a buffer.
    pub fn limits(&self) -> Limits {
        self.device.limits()
    }

    /// The most bytes that a kernel can see in one buffer.
    pub fn most_bytes(&self) -> u64 {
        let limits = self.limits();
        limits.max_storage_buffer_binding_size.min(limits.max_buffer_size)
    }

    /// Device memory of `bytes` bytes, all zero, that kernels read and write.
    ///
    /// # Errors
    /// The device gives no buffer so large.
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

    /// A small block of parameters that every invocation reads and none writes.
    pub fn uniform(&self, bytes: &[u8]) -> Buffer {
        let mut contents = bytes.to_vec();
        contents.resize(bytes.len().next_multiple_of(16), 0);
        self.device.create_buffer_init(&BufferInitDescriptor {
            label: Some("parameters"),
            contents: &contents,
            usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
        })
    }

    /// Copies `values` to the start of `buffer`, before whatever is submitted next.
    pub fn upload<T: NoUninit>(&self, buffer: &Buffer, values: &[T]) {
        self.queue.write_buffer(buffer, 0, bytemuck::cast_slice(values));
    }
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
    let name = |adapter: &Adapter| adapter.get_info().name;
    let found: Vec<String> = adapters.iter().map(name).collect();
    let lower = wanted.to_lowercase();
    adapters.into_iter().find(|a| name(a).to_lowercase().contains(&lower)).ok_or_else(|| {
        let found = if found.is_empty() { "none at all".into() } else { found.join(", ") };
        GpuError::NoSuchAdapter { wanted, found }
    })
}
