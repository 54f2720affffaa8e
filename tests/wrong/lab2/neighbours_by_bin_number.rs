// region: 2.4
// fails: task_2_4_rebuild_crowds, task_2_4_rebuild_steps
// story: The bins around are found by adding to the bin number: at a wall that is the far end of another row, and in a narrow box a bin counts twice.
let mut a = Vec2::ZERO;
let columns = self.grid.columns() as i64;
let own = self.grid.bin(particle) as i64;
for step in [-columns, 0, columns] {
    for bin in own + step - 1..=own + step + 1 {
        if let Some(bin) = self.bins.get(bin as usize) {
            observer.tested(bin.len() as u64);
            for neighbour in bin {
                add_pair(&mut a, particle.to(neighbour), observer);
            }
        }
    }
}
a
