// region: 8.13
// fails: task_8_13_the_bits_of_one_rank
// story: After twenty rounds what is still open is left undone.
for _ in 0..20 {
    take_certain(&mut engine.decisions);
    let untold = engine.decisions.taken.len() - engine.decisions.told;
    if engine.add_up(engine.decisions.front.len() + untold) == 0 {
        return;
    }
    let news = partners.iter().map(|&partner| news_for(&engine.decisions, partner)).collect();
    engine.decisions.told = engine.decisions.taken.len();
    let (arrived, ()) = engine.exchange(partners, news, || ());
    hear(&mut engine.decisions, &arrived.concat());
}
