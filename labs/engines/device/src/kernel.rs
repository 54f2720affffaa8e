//! Kernels: functions in WGSL that many invocations run at once, and the numbers that they compute
//! with.

use bytemuck::Pod;
use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, Buffer, ComputePipeline,
    ComputePipelineDescriptor, ErrorFilter, PipelineCompilationOptions, ShaderModuleDescriptor,
    ShaderSource,
};

use crate::device::Gpu;
use crate::error::GpuError;

/// The text that marks a missing answer in a starter's source.
const TODO: &str = "// todo: task ";

/// A function in WGSL, compiled for this device.
pub struct Kernel {
    pipeline: ComputePipeline,
    name: &'static str,
}

/// A kernel with its buffers, which can be launched any number of times.
pub struct Bound {
    pub(crate) pipeline: ComputePipeline,
    pub(crate) buffers: BindGroup,
    pub(crate) name: &'static str,
}

impl Kernel {
    /// Compiles the entry point `name` of `sources`, followed by the functions of `launch.wgsl`.
    ///
    /// The sources are joined in this order. `threads` is the size of the workgroups, and
    /// `constants` contains the values of the `override`s. The device refuses sources that are not
    /// valid WGSL, or that need a feature that the device lacks.
    ///
    /// # Panics
    /// If a task in the sources is not done yet ([`refuse_todo`]), or if the device refuses the
    /// sources and no error scope is open.
    pub fn new(
        gpu: &Gpu,
        name: &'static str,
        sources: &[&str],
        threads: u32,
        constants: &[(&str, f64)],
    ) -> Self {
        refuse_todo(sources);
        let text = [sources, &[include_str!("launch.wgsl")]].concat().join("\n");
        let constants = [constants, &[("THREADS", f64::from(threads))]].concat();
        let module = gpu.device.create_shader_module(ShaderModuleDescriptor {
            label: Some(name),
            source: ShaderSource::Wgsl(text.into()),
        });
        let pipeline = gpu.device.create_compute_pipeline(&ComputePipelineDescriptor {
            label: Some(name),
            layout: None,
            module: &module,
            entry_point: Some(name),
            compilation_options: PipelineCompilationOptions {
                constants: &constants,
                ..Default::default()
            },
            cache: None,
        });
        Self { pipeline, name }
    }

    /// Binds buffers to the kernel: `(binding, buffer)` for each `@binding` that it uses.
    ///
    /// # Panics
    /// The kernel's code does not use one of the bindings, or uses a binding that is not in
    /// `buffers`.
    pub fn bind(&self, gpu: &Gpu, buffers: &[(u32, &Buffer)]) -> Bound {
        let entries: Vec<_> = buffers
            .iter()
            .map(|(binding, buffer)| BindGroupEntry {
                binding: *binding,
                resource: buffer.as_entire_binding(),
            })
            .collect();
        let scope = gpu.device.push_error_scope(ErrorFilter::Validation);
        let group = gpu.device.create_bind_group(&BindGroupDescriptor {
            label: Some(self.name),
            layout: &self.pipeline.get_bind_group_layout(0),
            entries: &entries,
        });
        if let Some(error) = pollster::block_on(scope.pop()) {
            let bindings: Vec<u32> = buffers.iter().map(|(binding, _)| *binding).collect();
            panic!(
                "the kernel '{}' must use its buffers @binding {bindings:?}, and no other: is one of them missing in its \
                 code? The device says: {error}",
                self.name
            );
        }
        Bound { pipeline: self.pipeline.clone(), buffers: group, name: self.name }
    }
}

/// Panics if a task in `sources` is not done yet, because WGSL has no `todo!`.
///
/// # Panics
/// A source has a line `// todo: task …`.
pub fn refuse_todo(sources: &[&str]) {
    for line in sources.iter().flat_map(|source| source.lines()) {
        if let Some((_, task)) = line.split_once(TODO) {
            panic!("not yet implemented: task {task}");
        }
    }
}

/// The number type that kernels call `real`: f32 or f64.
pub trait Real: Pod + Into<f64> + Send + Sync + 'static {
    /// The definition of `real` in WGSL.
    const ALIAS: &'static str;

    /// Whether the device must compute in double precision.
    const DOUBLE: bool;

    /// The greatest relative error of one rounding.
    const ROUNDING: f64;

    /// Returns the nearest number of this type, or the greatest number if `value` is beyond the
    /// range.
    fn of(value: f64) -> Self;
}

impl Real for f64 {
    const ALIAS: &'static str = "alias real = f64;\n";
    const DOUBLE: bool = true;
    const ROUNDING: f64 = f64::EPSILON / 2.0;

    fn of(value: f64) -> Self {
        value
    }
}

impl Real for f32 {
    const ALIAS: &'static str = "alias real = f32;\n";
    const DOUBLE: bool = false;
    const ROUNDING: f64 = f32::EPSILON as f64 / 2.0;

    fn of(value: f64) -> Self {
        value.clamp(f64::from(Self::MIN), f64::from(Self::MAX)) as Self
    }
}

impl Gpu {
    /// Checks that kernels may compute with `R`.
    ///
    /// # Errors
    /// `R` is f64, and the device has no double precision.
    pub fn expect_real<R: Real>(&self) -> Result<(), GpuError> {
        if R::DOUBLE && !self.has_doubles() {
            return Err(GpuError::NoDoubles(self.name()));
        }
        Ok(())
    }
}
