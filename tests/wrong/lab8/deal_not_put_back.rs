// region: 8.7
// fails: task_8_7_blocks_travel_once
// story: The deal is taken out and not put back: every step is the first, deals again and sends all discs again. Only the traffic shows it.
let first = self.deal.is_none();
let deal = self.deal.take().unwrap_or_else(|| Deal::new(self.team.workers));
let lists = if self.is_master() { self.lists(&deal, first) } else { Vec::new() };
let arrived = self.send(&lists);
let worker = self.team.worker(self.world.rank());
if let Some(worker) = worker.filter(|_| !self.is_master()) {
    let held: Vec<_> =
        deal.blocks(worker).into_iter().map(|block| self.blocks.block(block)).collect();
    update(&mut self.discs, &held, !first && self.keep, &arrived);
}
let found = worker.map_or_else(Vec::new, |worker| self.find(&deal, worker));
let candidates = self.receive(&found);
if self.is_master() {
    self.decide(candidates);
}
