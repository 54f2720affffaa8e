// region: 4.3
// fails: task_4_3_threads_in_other_regions_go_on
// story: A lock around all changes makes a deadlock impossible, and makes all threads wait for each other.
static GATE: std::sync::Mutex<()> = std::sync::Mutex::new(());
let _gate = GATE.lock().expect("no thread has panicked");
let (from, old) = regions.cut.find(change.from);
let (to, new) = regions.cut.find(change.to);
if from == to {
    let mut region = meter.lock(&regions.locks[from]);
    remove(&mut region[old], change.particle);
    region[new].push(change.particle);
    return;
}
let mut lower = meter.lock(&regions.locks[from.min(to)]);
let mut upper = meter.lock(&regions.locks[from.max(to)]);
let (source, target) =
    if from < to { (&mut lower, &mut upper) } else { (&mut upper, &mut lower) };
remove(&mut source[old], change.particle);
target[new].push(change.particle);
