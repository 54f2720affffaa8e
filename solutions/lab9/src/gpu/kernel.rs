//! A kernel: a function in WGSL that many invocations run at once.

use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, Buffer, ComputePipeline,
    ComputePipelineDescriptor, ErrorFilter, PipelineCompilationOptions, ShaderModuleDescriptor,
    ShaderSource,
};

use super::{Gpu, GpuError};

/// What a starter's source has where an answer is missing.
const TODO: &str = "// todo: task ";

/// A function in WGSL, compiled for this device.
pub struct Kernel {
    pipeline: ComputePipeline,
    name: &'static str,
}

/// A kernel with its buffers: ready to be launched again and again.
pub struct Bound {
    pub(super) pipeline: ComputePipeline,
    pub(super) buffers: BindGroup,
    pub(super) name: &'static str,
}

impl Kernel {
    /// Compiles the entry point `name` of `sources`, which are read as one text, in this order.
    /// `threads` is the size of its workgroups, `constants` the values of its `override`s.
    ///
    /// # Errors
    /// The sources are no WGSL, or need what the device has not.
    ///
    /// # Panics
    /// A task in the sources is still to do.
    pub fn new(
        gpu: &Gpu,
        name: &'static str,
        sources: &[&str],
        threads: u32,
        constants: &[(&str, f64)],
    ) -> Result<Self, GpuError> {
        refuse_todo(sources);
        let text = [sources, &[include_str!("launch.wgsl")]].concat().join("\n");
        let constants = [constants, &[("THREADS", f64::from(threads))]].concat();
        let pipeline = checked(gpu, name, || {
            let module = gpu.device.create_shader_module(ShaderModuleDescriptor {
                label: Some(name),
                source: ShaderSource::Wgsl(text.into()),
            });
            gpu.device.create_compute_pipeline(&ComputePipelineDescriptor {
                label: Some(name),
                layout: None,
                module: &module,
                entry_point: Some(name),
                compilation_options: PipelineCompilationOptions {
                    constants: &constants,
                    ..Default::default()
                },
                cache: None,
            })
        })?;
        Ok(Self { pipeline, name })
    }

    /// Gives the kernel its buffers: `(binding, buffer)` for each `@binding` that it uses.
    pub fn bind(&self, gpu: &Gpu, buffers: &[(u32, &Buffer)]) -> Bound {
        let entries: Vec<_> = buffers
            .iter()
            .map(|(binding, buffer)| BindGroupEntry {
                binding: *binding,
                resource: buffer.as_entire_binding(),
            })
            .collect();
        let buffers = gpu.device.create_bind_group(&BindGroupDescriptor {
            label: Some(self.name),
            layout: &self.pipeline.get_bind_group_layout(0),
            entries: &entries,
        });
        Bound { pipeline: self.pipeline.clone(), buffers, name: self.name }
    }
}

/// Does `work`, and says so if the device or wgpu refused any of it.
///
/// wgpu does not return errors from the calls that make kernels and launches: like CUDA it goes on
/// with nothing in hand, and a launch that was refused leaves all buffers as they were. An *error
/// scope* catches what went wrong inside it. Open one for [`ErrorFilter::Validation`] with
/// `gpu.device.push_error_scope`, do the work, and close it with `pop`, which gives a future
/// (`pollster::block_on` waits for it) of an `Option` of an error.
///
/// Book: chapter 9, *A launch that never ran*.
///
/// # Errors
/// [`GpuError::Refused`] with the reason, and `what` was refused.
pub fn checked<T>(gpu: &Gpu, what: &str, work: impl FnOnce() -> T) -> Result<T, GpuError> {
    // task 9.1c: a refusal is an error
    let scope = gpu.device.push_error_scope(ErrorFilter::Validation);
    let value = work();
    match pollster::block_on(scope.pop()) {
        None => Ok(value),
        Some(error) => Err(GpuError::Refused { what: what.into(), why: error.to_string() }),
    }
    // end 9.1c
}

/// Panics if a task in `sources` is still to do: `todo!` is no WGSL.
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
