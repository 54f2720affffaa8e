// region: 5.8b
// fails: task_5_8_the_bits_of_all_pairs_in_a_dense_box
// story: The border is copied before those that changed their bin within the block are back in their bins: they are missing among the ghosts for one step.
take_leavers_of_block(&grid, &self.block, &mut self.changed, &mut self.remote);
let copies = border_copies(&self.bins, &self.cut, &self.block);
for particle in self.changed.drain(..) {
    self.bins.put(particle);
}
let leavers: Vec<Wire> = self.remote.drain(..).map(|p| Wire::from(&p)).collect();
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
