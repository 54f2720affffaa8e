//! Kernels that call the lab's kernels, their output, and scenes for them.

use std::collections::BTreeSet;
use std::ops::Range;

use common::hard::{Disc, Scene};
use device::{Gpu, GpuError, Kernel, Launch, Launcher, Readback, Real, Work};
use device_discs::hard::{Finder, HardKernels, Margins};
use device_discs::soft::{Scan, SoftKernels};
use lab9::Lab9;
use solution7::{Candidate, Hit, Square};

/// A launch that all devices can run. Every invocation has several turns.
pub(super) const SMALL: Launch = Launch { groups: [7, 1], threads: 32 };

const WRITE: &str = "
@group(0) @binding(0) var<storage, read_write> numbers: array<u32>;
@compute @workgroup_size(THREADS)
fn write(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let i = invocation(id, groups);
    if i < arrayLength(&numbers) {
        numbers[i] = i + 7u;
    }
}
";

/// Runs a kernel that writes 7, 8, … into four numbers, in `groups` workgroups. Returns whether the
/// launch succeeds, and the numbers.
pub(super) fn written(gpu: &Gpu, groups: u32) -> (Result<(), GpuError>, Vec<u32>) {
    let memory = Lab9::checked(gpu, "memory", || gpu.storage("numbers", 16));
    let memory =
        memory.expect("the device reports no error").expect("the device has enough memory");
    let kernel = Kernel::new(gpu, "write", &[WRITE], 4, &[]);
    let mut work = Work::new(gpu, None);
    let bound = kernel.bind(gpu, &[(0, &memory)]);
    work.launch(&bound, Launch { groups: [groups, 1], threads: 4 });
    let ended = Lab9::checked(gpu, "a launch", || work.submit());
    let [numbers] = Readback::default().read(gpu, Work::new(gpu, None), [(&memory, 0..4)]);
    (ended, numbers)
}

/// A kernel that calls the filter. Every pair a < b is tested by its own invocation.
pub(super) const ALL_PAIRS: &str = "
@compute @workgroup_size(THREADS)
fn probe(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let all = invocations(groups);
    for (var i = invocation(id, groups); i < square.n * square.n; i += all) {
        let a = i / square.n;
        let b = i % square.n;
        if a < b && may_meet(a, b) {
            append(a, b);
        }
    }
}
";

/// A kernel that calls `pair_at` and lists the pairs of some rows of the rectangle.
pub(super) const RECTANGLE: &str = "
@compute @workgroup_size(THREADS)
fn probe(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let all = invocations(groups);
    for (var i = invocation(id, groups); i < width() * (square.last - square.first); i += all) {
        let pair = pair_at(square.first + i / width(), i % width());
        if may_meet(pair.x, pair.y) {
            append(pair.x, pair.y);
        }
    }
}
";

/// A kernel that only deals pairs.
pub(super) const DEALT: &str = "
@compute @workgroup_size(THREADS)
fn probe(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    find_of_pairs(invocation(id, groups), invocations(groups));
}
";

/// Returns a kernel in which a single invocation does the work of number `turn` of four, by `find`.
pub(super) fn turn_of(find: &str, turn: u32) -> String {
    format!(
        "
@compute @workgroup_size(THREADS)
fn probe(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {{
    if invocation(id, groups) == 0u {{
        {find}({turn}u, 4u);
    }}
}}
"
    )
}

/// A run of a kernel `probe` that calls the filter.
pub(super) struct Search<'a> {
    pub(super) scene: &'a Scene,
    /// The kernel, with its functions besides the filter.
    pub(super) source: &'a str,
    /// The rows of work.
    pub(super) rows: Range<u32>,
    /// Whether every pair may collide.
    pub(super) everything: bool,
    /// Number of pairs for which the list has room.
    pub(super) room: u64,
    /// The square of the reach, and `receding`, in single precision. `None` for those of the scene.
    pub(super) bounds: Option<[f32; 2]>,
}

/// The number of pairs that a kernel has counted, and its list.
pub(super) struct Found {
    pub(super) count: u32,
    pub(super) list: Vec<[u32; 2]>,
    /// The number of pairs in the memory behind the list.
    pub(super) beyond: usize,
}

/// The length of the list, as the filter asks for it.
const LENGTH: &str = "arrayLength(&candidates)";

/// The number of pairs for which there is memory behind the list.
const BEHIND: u64 = 2;

/// Returns the filter with a list that seems to end before its memory does. `None` if the filter
/// asks for the length in other words.
///
/// A device ignores what is written behind the end of the memory, so it must not end there.
fn with_shorter_list() -> Option<String> {
    let shorter = format!("({LENGTH} - {BEHIND}u)");
    let lines = Lab9::filter().lines().map(|line| {
        let (code, comment) = line.split_at(line.find("//").unwrap_or(line.len()));
        code.replace(LENGTH, &shorter) + comment + "\n"
    });
    let filter: String = lines.collect();
    filter.contains(&shorter).then_some(filter)
}

impl<'a> Search<'a> {
    /// Returns a search with room for 100 pairs.
    pub(super) fn of(scene: &'a Scene, source: &'a str) -> Self {
        Self { scene, source, rows: 0..0, everything: false, room: 100, bounds: None }
    }

    pub(super) fn run<R: Real>(&self, gpu: &Gpu) -> Found {
        let square = Square::of(self.scene);
        let discs = self.scene.discs();
        let shorter = with_shorter_list();
        let behind = if shorter.is_some() { BEHIND } else { 0 };
        let filter = shorter.as_deref().unwrap_or(Lab9::filter());
        let sources = [self.source, filter, R::ALIAS];
        let kernel = Lab9::checked(gpu, "probe", || Kernel::new(gpu, "probe", &sources, 32, &[]))
            .unwrap_or_else(|error| panic!("{error}"));
        let everything = self.everything;
        let margins = Margins { everything, ..Margins::of::<R>(discs, square) };
        let number = |value: f64| R::of(value / square.side);
        let numbers: Vec<[R; 4]> =
            discs.iter().map(|d| [d.x, d.y, d.vx, d.vy].map(number)).collect();
        let mut parameters = margins.bytes::<R>(discs.len() as u32, self.rows.clone());
        if let Some(bounds) = self.bounds {
            // They follow four u32.
            parameters[16..24].copy_from_slice(bounds.map(f32::to_ne_bytes).as_flattened());
        }
        let parameters = gpu.uniform(&parameters);
        let positions = storage(gpu, numbers.len() as u64 * 4 * size_of::<R>() as u64);
        gpu.upload(&positions, &numbers);
        let count = storage(gpu, 4);
        let list = storage(gpu, (self.room + behind) * 8);
        let buffers = [(0, &parameters), (1, &positions), (2, &count), (3, &list)];
        let bound = kernel.bind(gpu, &buffers);
        let mut work = Work::new(gpu, None);
        work.launch(&bound, SMALL);
        let [counted] = Readback::default().read::<u32, 1>(gpu, work, [(&count, 0..1)]);
        let held = u64::from(counted[0]).min(self.room);
        let all = [(&list, 0..self.room + behind)];
        let [mut list] = Readback::default().read::<[u32; 2], 1>(gpu, Work::new(gpu, None), all);
        let beyond = list.drain(self.room as usize..).filter(|[a, b]| a < b).count();
        list.truncate(held as usize);
        Found { count: counted[0], list, beyond }
    }
}

fn storage(gpu: &Gpu, bytes: u64) -> wgpu::Buffer {
    gpu.storage("the probe's memory", bytes).expect("the device has enough memory")
}

/// Returns 100 touching pairs, at angles of `turn`, that approach extremely slowly. Single
/// precision cannot distinguish this approach from separating.
pub(super) fn touching(mut turn: impl FnMut() -> f64) -> Scene {
    let radius = 0.01;
    let apart = 2.0 * radius * (1.0 - 1e-12);
    let across = 0.003;
    let closing = -1e-9 * across;
    let mut discs = Vec::new();
    for k in 0..100 {
        let [x, y] = [k % 10, k / 10].map(|place| 0.05 + 0.09 * f64::from(place));
        let (sin, cos) = turn().sin_cos();
        discs.push(Disc::new(x, y, 0.001, 0.002));
        discs.push(Disc::new(
            x + apart * cos,
            y + apart * sin,
            0.001 + closing * cos - across * sin,
            0.002 + closing * sin + across * cos,
        ));
    }
    Scene::new(1.0, radius, discs).expect("all discs are inside the square")
}

/// Returns `n` discs on a line.
pub(super) fn line(n: usize) -> Scene {
    let discs = (0..n).map(|i| Disc::new(1.0 + i as f64, 1.0, 0.0, 0.0)).collect();
    Scene::new(n as f64 + 1.0, 1.0, discs).expect("all discs are inside the square")
}

/// Returns for each number the sum of all numbers before it, added up on the device by workgroups
/// of `threads`.
pub(super) fn sums_before(gpu: &Gpu, numbers: &[u32], threads: u32) -> Vec<u32> {
    let n = numbers.len() as u64;
    // The buffer has exactly this size, because arrayLength depends on it.
    let values = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: n * 4,
        usage: wgpu::BufferUsages::STORAGE
            | wgpu::BufferUsages::COPY_SRC
            | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    gpu.upload(&values, numbers);
    let scan = Scan::new::<Lab9>(gpu, &values, n as u32, threads)
        .unwrap_or_else(|error| panic!("{error}"));
    let mut work = Work::new(gpu, None);
    Lab9::record_scan(&scan, &mut work);
    let [sums] = Readback::default().read::<u32, 1>(gpu, work, [(&values, 0..n)]);
    sums
}

/// Returns the results of a finder if every two discs may collide, and every disc may hit a wall.
pub(super) fn everything_found<R: Real>(
    finder: &mut Finder<Lab9, R>,
    scene: &Scene,
) -> Result<Vec<[u32; 2]>, GpuError> {
    let square = Square::of(scene);
    let margins = Margins { everything: true, ..Margins::of::<R>(scene.discs(), square) };
    let mut found = Vec::new();
    finder.find(scene.discs(), margins, square, &mut found)?;
    Ok(found)
}

/// Draws candidates among 300 discs at few times, so that most candidates have a rival.
pub(super) fn rivals(count: usize, mut below: impl FnMut(usize) -> usize) -> Vec<Candidate> {
    let times = [0.0, -0.0, 0.5, 0.5 + f64::EPSILON, 1.0 / 3.0, 1.0, 5e-324, 1e-300];
    let mut hits = BTreeSet::new();
    while hits.len() < count {
        let [a, b] = [0; 2].map(|_| below(300) as u32);
        hits.insert(if a == b { Hit::WallX(a) } else { Hit::Pair(a.min(b), a.max(b)) });
    }
    hits.into_iter().map(|hit| Candidate { time: times[below(8)], hit }).collect()
}
