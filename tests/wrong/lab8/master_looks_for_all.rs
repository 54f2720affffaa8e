// region: 8.7
// fails: task_8_7_no_rank_looks_at_nearly_all_pairs
// story: The workers get their discs and send back nothing; the master, which has all discs, does their jobs.
let first = engine.deal.is_none();
let deal = engine.deal.take().unwrap_or_else(|| deal_out(engine.team.workers));
let lists = if engine.is_master() { engine.lists(&deal, first) } else { Vec::new() };
engine.send(&lists);
let mut candidates = engine.receive(&[]);
if engine.is_master() {
    for worker in 0..engine.team.workers {
        candidates.extend(engine.find(&deal, worker).iter().map(Candidate::from));
    }
    decide(engine, candidates);
}
engine.deal = Some(deal);
