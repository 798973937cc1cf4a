//! The order of birth.

/// The indices from 0 to `len` in the order of their ids, all less than `next_id`.
pub(crate) fn in_order(len: usize, next_id: u64, id: &dyn Fn(usize) -> u64) -> Vec<usize> {
    // A radix sort is faster than the standard library's sort.
    let mut order: Vec<usize> = (0..len).collect();
    let mut sorted = order.clone();
    let mut byte = 0;
    while byte < 8 && next_id >> (8 * byte) != 0 {
        let digit = |i: usize| (id(i) >> (8 * byte)) as usize & 0xff;
        let mut starts = [0; 257];
        for &i in &order {
            starts[digit(i) + 1] += 1;
        }
        for at in 1..starts.len() {
            starts[at] += starts[at - 1];
        }
        for &i in &order {
            let start = &mut starts[digit(i)];
            sorted[*start] = i;
            *start += 1;
        }
        std::mem::swap(&mut order, &mut sorted);
        byte += 1;
    }
    order
}
