// region: 8.13
// fails: task_8_13_the_bits_of_one_rank
// story: Take, tell, take again, and done. Most steps are right. In the tower of discs a decision has to travel through several strips.
take_certain(&mut engine.decisions);
engine.add_up(engine.decisions.front.len());
let news = partners.iter().map(|&partner| news_for(&engine.decisions, partner)).collect();
engine.decisions.told = engine.decisions.taken.len();
let (arrived, ()) = engine.exchange(partners, news, || ());
hear(&mut engine.decisions, &arrived.concat());
take_certain(&mut engine.decisions);
