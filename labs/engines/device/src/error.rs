//! Errors of the device: the device is missing, lacks a feature, or refuses a launch.

use thiserror::Error;

/// The reason why a program cannot run on this machine's device, or why a kernel did not run.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum GpuError {
    /// There is no driver, or the driver has no device.
    #[error(
        "no adapter: this machine offers no Vulkan, Metal or DirectX 12 device (on Debian and \
         Ubuntu the packages mesa-vulkan-drivers and libvulkan1 bring one made of software)"
    )]
    NoAdapter,
    /// `WGPU_ADAPTER_NAME` names a device that the machine does not have.
    #[error("no adapter: none is called '{wanted}', as WGPU_ADAPTER_NAME asks; there is {found}")]
    NoSuchAdapter {
        /// The value of the variable.
        wanted: String,
        /// The names of the devices that the machine has.
        found: String,
    },
    /// The driver cannot open the device.
    #[error("the device {name} cannot be opened: {why}")]
    Closed {
        /// The name of the device.
        name: String,
        /// The driver's message.
        why: String,
    },
    /// The device has no double precision. Half of all graphics processors compute in single
    /// precision only.
    #[error("the device {0} has no double precision; choose a variant that ends in f32")]
    NoDoubles(String),
    /// A buffer is larger than the device allows.
    #[error("{what} needs {bytes} bytes in one buffer, and the device {name} gives at most {most}")]
    Memory {
        /// The contents of the buffer, in words.
        what: &'static str,
        /// The size of the buffer.
        bytes: u64,
        /// The greatest size of a buffer.
        most: u64,
        /// The name of the device.
        name: String,
    },
    /// The launch exceeds the device's limits.
    #[error(transparent)]
    Launch(#[from] LaunchError),
    /// The driver or wgpu's validation refused a call. No kernel was run.
    #[error("{what} was refused, so it did not run: {why}")]
    Refused {
        /// The name of the kernel or of the call.
        what: String,
        /// The reason, with the line of the WGSL source if there is one.
        why: String,
    },
}

/// A launch that the device cannot run.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum LaunchError {
    /// The launch has no workgroup, or a workgroup has no thread.
    #[error("a launch needs at least one workgroup of one thread, not {blocks} of {threads}")]
    Nothing {
        /// Number of workgroups.
        blocks: u32,
        /// Number of threads in a workgroup.
        threads: u32,
    },
    /// The workgroup has too many threads for a multiprocessor.
    #[error("a workgroup of {threads} threads is too large: this device runs at most {most}")]
    Threads {
        /// Number of threads in a workgroup.
        threads: u32,
        /// The device's limit.
        most: u32,
    },
    /// There are more workgroups than the device allows.
    #[error("{blocks} workgroups are too many: this device takes at most {most} by {most}")]
    Blocks {
        /// Number of workgroups.
        blocks: u32,
        /// The device's limit along x and along y.
        most: u32,
    },
}
