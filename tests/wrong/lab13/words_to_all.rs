// region: 13.6
// fails: task_13_6_one_rank_decides_for_all
// story: Each rank sends its word to each other one: right, and as many messages as pairs of ranks.
let expired = list_has_expired || 2.0 * moved > width - CUTOFF;
let mut any = i32::from(expired);
let ranks = world.size();
for other in (0..ranks).filter(|other| *other != world.rank()) {
    let (theirs, _): (i32, _) =
        mpi::point_to_point::send_receive(&i32::from(expired), &world.process_at_rank(other), &world.process_at_rank(other));
    any = any.max(theirs);
}
any > 0
