use super::*;

fn points(text: &str) -> Option<String> {
    Points::parse(text).map(|points| points.text().to_owned())
}

#[test]
fn points_are_pairs_of_numbers_and_their_text_is_read_as_the_same_points() {
    for (sent, text) in [
        ("0,0 1,1", "0,0 1,1"),
        ("0,0,1,1", "0,0 1,1"),
        ("  -0.5 .25\n1e-1,  -0 ", "-0.5,0.25 0.1,0"),
        ("0.1,0.2 0.3,-10", "0.1,0.2 0.3,-10"),
        ("1e-9,0 0.0033333333,0", "1.000e-9,0 0.0033333333,0"),
    ] {
        let read = Points::parse(sent).expect(sent);
        let again = Points::parse(read.text()).expect(text);
        assert_eq!(read.all(), again.all(), "{sent}: {}", read.text());
        if !sent.contains("333") {
            assert_eq!(read.text(), text);
        }
    }
    assert_eq!(points(Points::DEFAULT).as_deref(), Some(Points::DEFAULT));
}

#[test]
fn points_of_another_form_are_refused() {
    for text in [
        "",
        " ",
        "0",
        "0,0",
        "0,0 1",
        "0,0 1,",
        "0,0 NaN,1",
        "0,0 inf,1",
        "0,0 10.1,1",
        "0,0 1,-1e9",
        "0,0;1,1",
        "[[0,0],[1,1]]",
        "0,0 1,1 https://example.com",
    ] {
        assert_eq!(points(text), None, "{text}");
    }
    assert!(points(&"0,0 ".repeat(256)).is_some());
    // The longest doubles that JavaScript writes.
    for longest in [
        "-0.0000023322064938695683",
        "-1.4821969375237396e-308",
        "9.999999999999998",
        "-0.1",
    ] {
        assert!(
            points(&format!("{longest},{longest} ").repeat(256)).is_some(),
            "{longest}"
        );
    }
    assert_eq!(points(&"0,0 ".repeat(257)), None);
    assert_eq!(points(&" ".repeat(1 << 20)), None);
}

#[test]
fn a_mask_has_the_opacity_of_its_letters() {
    let mask = Mask::parse("3x2:APIR").expect("a mask of six pixels");
    assert_eq!(mask.size(), [3, 2]);
    let row = |row| [0, 1, 2].map(|column| mask.opacity(column, row));
    assert_eq!(row(0), [0.0, 1.0, 8.0 / 15.0]);
    for (letters, pixels) in [("APIQ", "five"), ("APIS", "seven")] {
        assert!(Mask::parse(&format!("3x2:{letters}")).is_none(), "{pixels}");
    }
    assert_eq!((mask.opacity(3, 0), mask.opacity(0, 2)), (0.0, 0.0));
    assert_eq!(mask.opacity(usize::MAX, usize::MAX), 0.0);
    let square = Mask::default();
    assert_eq!((square.size(), square.opacity(15, 15)), ([16, 16], 1.0));
}

#[test]
fn masks_of_another_form_are_refused() {
    for text in [
        "",
        ":",
        "x:",
        "0x1:P",
        "1x1:",
        "1x1:PP",
        "1x1:H",
        "257x1:n",
        "1x1:!",
        "-1x1:P",
        "1x1:é",
        "4x1:PPP",
        "16x16:",
        "65536x65536:7",
        "https://example.com/a.png",
    ] {
        assert_eq!(Mask::parse(text), None, "{text}");
    }
    let noise = format!("256x256:{}", "P".repeat(256 * 256));
    assert!(Mask::parse(&noise).is_some());
    assert_eq!(Mask::parse(&format!("{noise}P")), None);
}

#[test]
fn the_text_of_points_is_read_as_these_points() {
    for text in [
        "0,0 0.1,1.8446744073709551614e-12",
        "-9e-7,1 1e-6,-2",
        "0.1,1e-6 3,0.0000012345678",
    ] {
        let points = Points::parse(text).expect(text);
        assert_eq!(Points::parse(points.text()), Some(points), "{text}");
    }
}
