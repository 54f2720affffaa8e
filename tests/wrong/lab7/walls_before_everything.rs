// region: 7.3
// fails: task_7_3_the_order_of_candidates, task_7_7_crafted_scenes
// story: All wall collisions come before all pairs, also the later ones. The report's «we will first consider the particle-wall collision» can be read so.
let pair = |c: &Candidate| matches!(c.hit, hard_discs::Hit::Pair(..));
let by_time = a.time.partial_cmp(&b.time).expect("no time is NaN");
pair(a).cmp(&pair(b)).then(by_time).then(a.hit.cmp(&b.hit))
