// region: 13.6
// fails: task_13_6_one_rank_decides_for_all
// story: Each rank rebuilds its list when its own has expired: it sends movers while its neighbour sends positions.
let _ = (world.rank(), SystemOperation::max());
list_has_expired || 2.0 * moved > width - CUTOFF
