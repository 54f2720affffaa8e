// region: 8.13b
// fails: task_8_13_ranks_talk_to_the_two_beside_them
// story: Every rank sends to every other in each round, also where strips are high and discs slow: most of these lists are empty.
let range = engine.range();
let partners: Vec<usize> = (0..engine.ranks()).filter(|&rank| rank != engine.rank()).collect();
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
