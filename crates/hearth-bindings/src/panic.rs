//! The text and the place of a panic.
//!
//! A panic ends in a trap, whose own text is `unreachable`. The script that catches the trap
//! reads the last panic. Without one, the allocator has trapped: no memory is left.

use std::cell::RefCell;
use std::panic;

thread_local! {
    static LAST: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Records panics from now on, instead of printing them.
pub fn record() {
    panic::set_hook(Box::new(|info| LAST.set(format!("{info}"))));
}

/// The place and the text of the last panic; empty before the first.
pub fn last() -> String {
    LAST.take()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_recorded_with_its_text_and_place() {
        let before = panic::take_hook();
        record();
        assert!(panic::catch_unwind(|| panic!("{} is a defect", 7)).is_err());
        panic::set_hook(before);
        let text = last();
        let (place, words) = text.split_once('\n').expect("two lines");
        assert!(
            place.starts_with("panicked at crates/hearth-bindings/src/panic.rs:"),
            "{place}"
        );
        assert_eq!(words, "7 is a defect");
        assert_eq!(last(), "");
    }
}
