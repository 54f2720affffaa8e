// region: 8.13b
// fails: task_8_13_no_rank_looks_at_nearly_all_pairs
// story: The first step sends all discs to the first rank, which then need not ask anybody.
let rows = engine.strips.cuts.starts[engine.ranks()];
if engine.ranks() > 1 && engine.strips.cuts.starts[1] < rows {
    let mut lists = vec![Vec::new(); engine.ranks()];
    lists[0] = std::mem::take(&mut engine.own);
    engine.own = solution6::exchange_all(&engine.world, &lists);
    engine.own.sort_by_key(|disc| disc.number);
    engine.strips.cuts.starts[1..].fill(rows);
}
let range = engine.range();
let partners = engine.strips.partners(engine.rank(), range.furthest);
let ghosts = ghosts_for(&partners, &engine.own, &engine.strips, range.reach);
let (own, square) = (std::mem::take(&mut engine.own), engine.square);
let (arrived, walls) = engine.exchange(&partners, ghosts, || walls_of::<Lab7>(&own, square));
engine.own = own;
engine.see(&arrived, range);
engine.find(walls);
decide(engine, &partners);
let Seen { discs, owns, .. } = &mut engine.seen;
let moved = move_on(discs, owns, &engine.decisions, engine.square);
engine.tally.taken(&engine.decisions.taken);
engine.bring(&partners, moved);
