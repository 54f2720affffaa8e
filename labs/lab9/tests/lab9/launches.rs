//! Questions about launches: their sizes, and the launches that are refused.

use device::{Gpu, GpuError, Kernel, Launch, LaunchError, Launcher};
use lab9::{HARD_VARIANTS, Lab9};
use oracle::{Ask, Random, truth};
use wgpu::Limits;

use super::adapter::adapter;
use super::launched::written;

/// A requested launch, and the limits of the device.
struct Order {
    blocks: u32,
    threads: u32,
    /// Greatest number of workgroups along an axis.
    most: u32,
    /// Greatest number of invocations of a workgroup along x. A workgroup has at most 256
    /// invocations in total.
    wide: u32,
}

impl Order {
    /// Draws few and many workgroups: at the limits of a device, just below and above the limits,
    /// and more than 24 bits can count.
    fn drawn(random: &mut Random, case: usize) -> Self {
        let most = [65_535, 2 + random.below(2000) as u32, 65_535, 1 << 16][case % 4];
        let wide = [128, 512][random.below(2)];
        let rows = [1, 2, 300, 1000, most][random.below(5)].min(most);
        let edge = u64::from(most) * u64::from(rows) + random.below(3) as u64;
        let blocks = match random.below(5) {
            0 => random.below(10) as u32,
            1 => random.below(5_000_000) as u32,
            2 => (1 << 24) + 1,
            3 => u32::MAX - random.below(300) as u32,
            _ => u32::try_from(edge).map_or(u32::MAX, |edge| edge - 1),
        };
        let threads = [random.below(3), random.below(300), 128, 129, 256, 257][random.below(6)];
        Self { blocks, threads: threads as u32, most, wide }
    }

    fn limits(&self) -> Limits {
        Limits {
            max_compute_invocations_per_workgroup: 256,
            max_compute_workgroup_size_x: self.wide,
            max_compute_workgroups_per_dimension: self.most,
            ..Default::default()
        }
    }

    /// Returns the correct [`shape`] for this number of workgroups.
    fn right(&self, blocks: u32) -> Vec<f64> {
        let fit = self.wide.min(256);
        let rows = blocks.div_ceil(self.most);
        let numbers = match [blocks, self.threads] {
            [0, _] | [_, 0] => [1, blocks, self.threads, 0],
            _ if self.threads > fit => [2, self.threads, fit, 0],
            _ if rows > self.most => [3, blocks, self.most, 0],
            _ => [0, rows, self.threads, 1],
        };
        numbers.map(f64::from).to_vec()
    }
}

/// Returns whether a launch has at least `blocks` workgroups, no more rows than it needs, and no
/// longer rows than it needs.
pub(super) fn suffices(launch: Launch, blocks: u32, most: u32) -> bool {
    let [x, y] = launch.groups.map(u64::from);
    let all = x * y;
    let blocks = u64::from(blocks);
    x <= most.into() && all >= blocks && all - x < blocks && all - y < blocks
}

/// Returns the numbers of a launch, or of its error.
fn shape(launch: Result<Launch, LaunchError>, blocks: u32, most: u32) -> Vec<f64> {
    let numbers = match launch {
        Ok(launch) => {
            [0, launch.groups[1], launch.threads, u32::from(suffices(launch, blocks, most))]
        }
        Err(LaunchError::Nothing { blocks, threads }) => [1, blocks, threads, 0],
        Err(LaunchError::Threads { threads, most }) => [2, threads, most, 0],
        Err(LaunchError::Blocks { blocks, most }) => [3, blocks, most, 0],
    };
    numbers.map(f64::from).to_vec()
}

pub(crate) fn launches(random: &mut Random, ask: &mut impl Ask) {
    for case in 0..600 {
        let order = Order::drawn(random, case);
        let Order { blocks, threads, most, wide } = order;
        let limits = order.limits();
        let answer = format!(
            "at most {most} workgroups along an axis and {} invocations in each. If there is a launch: 0, its rows, \
             its threads, and 1 if they suffice. If there is an error: its kind (1 nothing to launch, 2 too many \
             threads, 3 too many workgroups), its two numbers, and 0",
            wide.min(256)
        );
        let question = format!("{blocks} workgroups of {threads}, {answer}");
        let launch = || Lab9::launch(blocks, threads, &limits);
        ask.exact(&question, || shape(launch(), blocks, most), || order.right(blocks));
        if threads > 0 {
            let needed = blocks.div_ceil(threads).max(1);
            let question = format!("{blocks} items in workgroups of {threads}, {answer}");
            ask.exact(
                &question,
                || shape(Lab9::launch_over(blocks, threads, &limits), needed, most),
                || order.right(needed),
            );
        }
    }
    ask.exact(
        "ten items in workgroups of 0 threads: 1 if the launch is refused, 0 if not",
        || vec![truth(Lab9::launch_over(10, 0, &Limits::default()).is_err())],
        || vec![1.0],
    );
}

/// Asks for the errors of a launch that cannot run, and of a kernel that is not valid WGSL.
pub(crate) fn refusals(_: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter("9.1") else { return };
    let limit = gpu.limits().max_compute_workgroups_per_dimension;
    let question = "a kernel that writes 7, 8, 9, 10, in one workgroup more than the device can run along an axis: 1 \
                    if the launch is refused with a reason, 0 if not; then the four numbers in memory";
    let right = || vec![1.0, 0.0, 0.0, 0.0, 0.0];
    ask.exact(question, || refused_and_written(gpu, limit + 1), right);
    let question = "a kernel that writes 7, 8, 9, 10, in one workgroup: 1 if the launch is refused, 0 if not; then \
                    the four numbers in memory";
    ask.exact(question, || refused_and_written(gpu, 1), || vec![0.0, 7.0, 8.0, 9.0, 10.0]);
    let question = "the kernel `fn write( {`: 1 if the kernel is refused, 0 if not";
    ask.exact(question, || vec![truth(refuses_no_wgsl(gpu))], || vec![1.0]);
}

fn refuses_no_wgsl(gpu: &Gpu) -> bool {
    let kernel = || Kernel::new(gpu, "write", &["fn write( {"], 4, &[]);
    matches!(Lab9::checked(gpu, "write", kernel), Err(GpuError::Refused { .. }))
}

/// Returns whether a kernel in `groups` workgroups is refused with a reason, and the numbers that
/// it has written.
fn refused_and_written(gpu: &Gpu, groups: u32) -> Vec<f64> {
    let (ended, written) = written(gpu, groups);
    let refused = matches!(ended, Err(GpuError::Refused { what, why }) if what != why);
    [truth(refused)].into_iter().chain(written.into_iter().map(f64::from)).collect()
}

pub(crate) fn large_workgroups(_: &mut Random, ask: &mut impl Ask) {
    if adapter("9.4").is_none() {
        return;
    }
    let refused = || {
        let balanced = HARD_VARIANTS.iter().find(|variant| variant.name == "balanced-f32");
        let balanced = balanced.expect("the lab has this variant");
        let mut config = balanced.config();
        balanced.set(&mut config, "workgroup", 65_536.0).expect("the variant has this parameter");
        let error = (balanced.build)(&config).err();
        error.is_some_and(|error| error.to_string().contains("workgroup of 65536"))
    };
    let question = "variant balanced-f32 with workgroups of 65536: 1 if the variant is refused with an error that \
                    contains this number, 0 if not";
    ask.exact(question, || vec![truth(refused())], || vec![1.0]);
}
