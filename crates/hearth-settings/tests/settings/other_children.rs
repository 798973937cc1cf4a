//! Whole settings and pages whose children have changed meanwhile, and children without room.

use crate::children::{Child, SOURCE, file, hidden, laid, list, objects};
use crate::harness::{after, imported, number, object, sent, text};
use hearth_settings::untrusted::Untrusted;
use hearth_settings::{Change, Settings, whole};

#[test]
fn a_page_source_that_a_child_hid_returns_to_its_place() {
    let other = sent([("kind", text("source")), ("x", number(0.4))]);
    let page = after(&Settings::default(), Change::AddObject(&other));
    let gone = page.with_children(&hidden(&page, &[SOURCE]), &mut Vec::new());
    assert_eq!(objects(&gone, &["x"]), ["2 source 0.4"]);
    assert_eq!(laid(&gone, &[]).scene(), page.scene());
    // A file that has a child twice has it once.
    let list = whole(&gone).field("children").list().to_vec();
    let list = [list.clone(), list].concat();
    let read = Settings::with_children_of_file(&with_list(&gone, &list));
    assert_eq!(read, Ok(gone));
}

#[test]
fn whole_settings_of_other_children_keep_each_object_once() {
    let page = Settings::default();
    let second = || Child(1002, "source", &[("x", "0.3")], &[]);
    let whole_of_both = whole(&laid(&page, &[SOURCE, second()]));
    let cases = [
        // The first source has left: the second one has the source of the page.
        (second(), vec!["1 source 0.3"]),
        // Another child has the number of a source.
        (
            Child(1001, "solid", &[("x", "0.1")], &[]),
            vec!["1 source 0", "1001 solid 0.1"],
        ),
    ];
    for (child, wanted) in cases {
        let now = file(&laid(&page, &[child]), &whole_of_both);
        assert_eq!(objects(&now, &["x"]), wanted);
    }
    // The source of the page has another id by now; undo leaves a child that has come.
    let other = laid(
        &imported(&object([(
            "objects",
            Untrusted::List(vec![object([
                ("kind", text("source")),
                ("id", number(5.0)),
            ])]),
        )])),
        &[SOURCE],
    );
    let undone = with_list(&page, whole(&other).field("children").list());
    assert_eq!(objects(&file(&other, &undone), &["x"]), ["1 source 0.2"]);
}

/// Whole settings with another list of children.
fn with_list(settings: &Settings, list: &[Untrusted]) -> Untrusted {
    let whole = whole(settings);
    let fields = whole.fields().iter().map(|(name, value)| {
        let value = match name.as_str() {
            "children" => Untrusted::List(list.to_vec()),
            _ => value.clone(),
        };
        (name.clone(), value)
    });
    Untrusted::Object(fields.collect())
}

#[test]
fn a_child_for_which_there_is_no_room_gets_its_object_when_there_is() {
    let of = |numbers: std::ops::Range<u32>| -> Vec<Child> {
        numbers
            .map(|number| Child(number, "solid", &[], &[]))
            .collect()
    };
    let mut errors = Vec::new();
    let full = Settings::default()
        .with_children(&list(&Settings::default(), &of(1001..1066)), &mut errors);
    assert_eq!(full.scene().objects().len(), 65);
    assert_eq!(errors.len(), 1);
    assert_eq!(errors[0].id, "children[64].objects");
    assert!(
        errors[0].message.contains("must be at most 64 solids"),
        "{errors:?}"
    );
    let room = after(&full, Change::RemoveObject(1002));
    assert_eq!(
        room.scene().objects().last().map(|object| object.id),
        Some(1065)
    );
    let room = laid(&full, &of(1002..1066));
    assert_eq!(
        room.scene().objects().last().map(|object| object.id),
        Some(1065)
    );
}
