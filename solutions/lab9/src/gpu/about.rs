//! What there is to know about a device.

use wgpu::DeviceType;

use super::Gpu;

impl Gpu {
    /// What a reader of measurements wants to know, besides [`name`](Self::name): names and values
    /// in words.
    pub fn about(&self) -> Vec<(&'static str, String)> {
        let limits = self.limits();
        let yes = |is: bool| if is { "yes" } else { "no" }.to_owned();
        let kind = match self.info().device_type {
            DeviceType::Cpu => "software on the host's processor, not a GPU",
            DeviceType::DiscreteGpu => "GPU with memory of its own",
            DeviceType::IntegratedGpu => "GPU that shares the host's memory",
            DeviceType::VirtualGpu => "GPU shared with other machines",
            DeviceType::Other => "unknown",
        };
        let info = self.info();
        let rows = limits.max_compute_workgroups_per_dimension;
        let most = limits.max_compute_invocations_per_workgroup;
        vec![
            ("kind", kind.into()),
            ("driver", format!("{}, {} {}", info.backend, info.driver, info.driver_info)),
            ("double precision", yes(self.expect_real::<f64>().is_ok())),
            ("timestamps", yes(self.has_timestamps())),
            ("a workgroup", format!("{} threads", most.min(limits.max_compute_workgroup_size_x))),
            ("a launch", format!("{rows} by {rows} workgroups")),
            ("a buffer", format!("{} bytes", self.most_bytes())),
        ]
    }
}
