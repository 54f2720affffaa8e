//! What can go wrong on the way to a device and on it.

use thiserror::Error;

/// Why a program cannot run on this machine's device, or a kernel was not run.
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
        /// The names of the devices found.
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
    /// The driver or wgpu's validation said no. Nothing was run.
    #[error("{what} was refused, so it did not run: {why}")]
    Refused {
        /// A kernel's name.
        what: String,
        /// The reason, with the line of a WGSL source where there is one.
        why: String,
    },
}

/// A launch that the device cannot run.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum LaunchError {
    /// No workgroup, or none in it.
    #[error("a launch needs at least one workgroup of one thread, not {blocks} of {threads}")]
    Nothing {
        /// Workgroups asked for.
        blocks: u32,
        /// Threads a workgroup asked for.
        threads: u32,
    },
    /// The workgroup does not fit on one multiprocessor.
    #[error("a workgroup of {threads} threads is too large: this device runs at most {most}")]
    Threads {
        /// Threads a workgroup asked for.
        threads: u32,
        /// The device's limit.
        most: u32,
    },
    /// More workgroups than the device counts.
    #[error("{blocks} workgroups are too many: this device takes at most {most} by {most}")]
    Blocks {
        /// Workgroups asked for.
        blocks: u32,
        /// The device's limit along x and along y.
        most: u32,
    },
}
