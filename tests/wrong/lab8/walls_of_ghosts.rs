// region: 8.13b
// fails: task_8_13_the_bits_of_one_rank, task_8_13_counts_every_candidate_once
// story: The walls are looked for among all discs seen, ghosts too: the wall collision of a disc near a cut is found by every rank that has it.
let range = self.range();
let partners = self.strips.partners(self.rank(), range.furthest);
let ghosts = ghosts_for(&partners, &self.own, &self.strips, range.reach);
let (arrived, ()) = self.exchange(&partners, ghosts, || ());
let all: Vec<DiscWire> = self.own.iter().chain(arrived.iter().flatten()).copied().collect();
let walls = walls_of(&all, self.square);
self.see(&arrived, range);
self.find(walls);
self.decide(&partners);
let Seen { discs, owns, .. } = &mut self.seen;
let moved = move_on(discs, owns, &self.decisions, self.square);
self.tally.taken(&self.decisions.taken);
self.bring(&partners, moved);
