// region: 13.6
// fails: task_13_6_one_rank_decides_for_all
// story: Each rank makes its list anew when its own has expired: it sends movers while its neighbour sends places.
let _ = (world.rank(), SystemOperation::max());
list_has_expired || 2.0 * moved > width - CUTOFF
