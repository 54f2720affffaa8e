// region: 7.3
// fails: task_7_3_the_order_of_candidates
// loses: 7.4
// story: Numbers are compared in 16 bits.
let by_time = a.time.partial_cmp(&b.time).expect("no time is NaN");
let low = |hit: hard_discs::Hit| match hit {
    hard_discs::Hit::Pair(a, b) => (3, a as u16, b as u16),
    hard_discs::Hit::WallY(a) => (2, a as u16, 0),
    hard_discs::Hit::WallX(a) => (1, a as u16, 0),
    hard_discs::Hit::Corner(a) => (0, a as u16, 0),
};
by_time.then(low(a.hit).cmp(&low(b.hit)))
