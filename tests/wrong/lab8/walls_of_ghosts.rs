// region: 8.13b
// fails: task_8_13_the_bits_of_one_rank, task_8_13_counts_every_candidate_once
// story: The walls are looked for among all discs seen, ghosts too: the wall collision of a disc near a cut is found by every rank that has it.
let range = engine.range();
let partners = engine.strips.partners(engine.rank(), range.furthest);
let ghosts = ghosts_for(&partners, &engine.own, &engine.strips, range.reach);
let (arrived, ()) = engine.exchange(&partners, ghosts, || ());
let all: Vec<hard_disc_ranks::DiscWire> = engine.own.iter().chain(arrived.iter().flatten()).copied().collect();
let walls = walls_of::<Lab7>(&all, engine.square);
engine.see(&arrived, range);
engine.find(walls);
decide(engine, &partners);
let Seen { discs, owns, .. } = &mut engine.seen;
let moved = move_on(discs, owns, &engine.decisions, engine.square);
engine.tally.taken(&engine.decisions.taken);
engine.bring(&partners, moved);
