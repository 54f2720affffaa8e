// Functions of every kernel: the number of an invocation, and the number of all invocations.
//
// CUDA                                      WGSL
// threadIdx.x                               @builtin(local_invocation_id).x
// blockIdx.x                                @builtin(workgroup_id).x
// blockDim.x                                THREADS, set by the host when the kernel is built
// gridDim.x                                 @builtin(num_workgroups).x
// blockIdx.x * blockDim.x + threadIdx.x     @builtin(global_invocation_id).x

override THREADS: u32 = 64u;

// Returns the number of an invocation, from its global id and the number of workgroups. A launch
// with more workgroups than fit in a row has several rows.
fn invocation(id: vec3<u32>, groups: vec3<u32>) -> u32 {
    return id.x + id.y * groups.x * THREADS;
}

// Returns the number of invocations of the launch.
fn invocations(groups: vec3<u32>) -> u32 {
    return groups.x * groups.y * THREADS;
}
