// region: 8.7
// fails: task_8_7_only_what_collided_travels
// story: The deal is taken out and not put back: every step is the first, deals again and sends all discs again. Only the traffic shows it.
let first = engine.deal.is_none();
let deal = engine.deal.take().unwrap_or_else(|| deal_out(engine.team.workers));
let lists = if engine.is_master() { engine.lists(&deal, first) } else { Vec::new() };
let arrived = engine.send(&lists);
let worker = engine.team.worker(engine.world.rank());
if let Some(worker) = worker.filter(|_| !engine.is_master()) {
    let held: Vec<_> =
        deal.blocks(worker).into_iter().map(|block| engine.blocks.block(block)).collect();
    update(&mut engine.discs, &held, !first && engine.keep, &arrived);
}
let found = worker.map_or_else(Vec::new, |worker| engine.find(&deal, worker));
let candidates = engine.receive(&found);
if engine.is_master() {
    decide(engine, candidates);
}
