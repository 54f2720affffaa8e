//! Questions about positions in single precision: the column and the offset of a particle after a
//! move.

use device::{Gpu, Kernel, Launch, Launcher, Readback, Real, Work};
use device_discs::soft::SoftKernels;
use lab9::Lab9;
use oracle::{Ask, Random};

use super::adapter::adapter;

/// A kernel that calls `carry`. It replaces a column, an offset and a distance by a column, an
/// offset and a velocity.
const PROBE: &str = "
const DT: real = 0.0005;

@group(0) @binding(8) var<storage, read_write> places: array<vec4<f32>>;

@compute @workgroup_size(THREADS)
fn probe(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let i = invocation(id, groups);
    if i < arrayLength(&places) {
        let place = places[i];
        let to = carry(Along(i32(place.x), place.y, 2.0), place.z);
        places[i] = vec4<f32>(f32(to.column), to.offset, to.v, 0.0);
    }
}
";

/// Asks about long and short distances from the middle of a bin and from its edges. The distances
/// are forwards and backwards, and some are lost by rounding.
pub(crate) fn carried(random: &mut Random, ask: &mut impl Ask) {
    let Some(gpu) = adapter("9.8") else { return };
    let edge = 1.0_f32.next_down();
    let mut places = Vec::new();
    for offset in [0.0, edge, 0.5, random.between(0.0, 1.0) as f32] {
        for distance in [0.0, 1e-9, 1e-8, 3e-8, 6e-8, 0.5, 1.0, 3.75] {
            places.push([7.0, offset, distance, 0.0]);
            places.push([7.0, offset, -distance, 0.0]);
        }
        for _ in 0..100 {
            places.push([7.0, offset, random.signed(1e-10, 100.0) as f32, 0.0]);
        }
    }
    let question = format!(
        "{} particles in column 7 with velocity 2: column, offset and velocity of each particle after the call of \
         `carry`",
        places.len()
    );
    ask.judge(&question, || probed(gpu, &places), |found| are_carried(found, &places));
}

fn probed(gpu: &Gpu, places: &[[f32; 4]]) -> Vec<f64> {
    let sources = [PROBE, Lab9::position_f32(), Lab9::discs(), f32::ALIAS];
    let kernel = Lab9::checked(gpu, "probe", || Kernel::new(gpu, "probe", &sources, 64, &[]));
    let kernel = kernel.unwrap_or_else(|error| panic!("{error}"));
    let memory = gpu.storage("the test's memory", size_of_val(places) as u64);
    let memory = memory.expect("the device has enough memory");
    gpu.upload(&memory, places);
    let mut work = Work::new(gpu, None);
    let groups = [(places.len() as u32).div_ceil(64), 1];
    work.launch(&kernel.bind(gpu, &[(8, &memory)]), Launch { groups, threads: 64 });
    let all = [(&memory, 0..places.len() as u64)];
    let [found] = Readback::default().read::<[f32; 4], 1>(gpu, work, all);
    found.iter().flat_map(|place| place[..3].iter().copied().map(f64::from)).collect()
}

fn are_carried(found: &[f64], places: &[[f32; 4]]) -> Result<(), String> {
    let (found, _) = found.as_chunks::<3>();
    if found.len() != places.len() {
        return Err("the list is not complete".into());
    }
    for ([column, offset, v], place) in found.iter().zip(places) {
        let [from, at, distance] = [place[0], place[1], place[2]].map(f64::from);
        let way = format!("offset {at:?} and distance {distance:?}");
        if !(0.0..1.0).contains(offset) {
            return Err(format!(
                "{way}: the new offset is {offset:?}, but must be at least 0 and below 1"
            ));
        }
        let right = from + at + distance;
        let rounding = f64::from(f32::EPSILON) * (1.0 + (at + distance).abs());
        if (column + offset - right).abs() > rounding || *v != 2.0 {
            return Err(format!(
                "{way}: the particle is in column {column} at offset {offset:?} with velocity {v}. Column and offset \
                 must add up to {right:?}, and the velocity must be 2"
            ));
        }
    }
    Ok(())
}
