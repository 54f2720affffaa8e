// region: 5.8b
// fails: task_5_8_only_what_others_need_travels
// story: Each rank copies all its particles for the root in every step, not only those of its border rows: right, and the root gets everything.
take_leavers_of_block(&grid, &self.block, &mut self.changed, &mut self.remote);
for particle in self.changed.drain(..) {
    self.bins.put(particle);
}
let leavers: Vec<Wire> = self.remote.drain(..).map(|p| Wire::from(&p)).collect();
let copies: Vec<Wire> = own(&self.bins, &self.block).map(Wire::from).collect();
let all_leavers = self.gather(&leavers);
let all_copies = self.gather(&copies);
let parcels: Vec<_> = all_leavers
    .into_iter()
    .zip(all_copies)
    .map(|(leavers, copies)| Parcel { leavers, copies })
    .collect();
let lists = sort_by_receiver(&grid, &self.cut, &parcels);
let arrived = self.scatter(&lists);
replace_ghosts(&mut self.bins, &self.block, &arrived);
