// region: 8.13
// fails: task_8_13_cuts_that_move
// story: A rank with nothing open and nothing to tell stops, and goes on to move its discs. The other ranks wait for its news.
loop {
    take_certain(&mut engine.decisions);
    let untold = engine.decisions.taken.len() - engine.decisions.told;
    if engine.decisions.front.len() + untold == 0 {
        return;
    }
    let news = partners.iter().map(|&partner| news_for(&engine.decisions, partner)).collect();
    engine.decisions.told = engine.decisions.taken.len();
    let (arrived, ()) = engine.exchange(partners, news, || ());
    hear(&mut engine.decisions, &arrived.concat());
}
