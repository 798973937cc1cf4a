//! The server, asked over a real connection.

use std::fs;
use std::io::Read;

use super::*;

/// What the server of a folder with a page and a module answers to each of `requests`.
fn answers(requests: &[&str]) -> Result<Vec<String>> {
    let folder = std::env::temp_dir().join(format!(
        "hearth-serve-{}-{:?}",
        std::process::id(),
        thread::current().id()
    ));
    fs::create_dir_all(folder.join("web"))?;
    fs::write(folder.join("index.html"), "<p>fire</p>")?;
    fs::write(folder.join("web").join("engine_bg.wasm"), b"\0asm")?;
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0))?;
    let address = listener.local_addr()?;
    let mut answers = Vec::new();
    for request in requests {
        let mut visitor = TcpStream::connect(address)?;
        visitor.write_all(request.as_bytes())?;
        let (connection, _) = listener.accept()?;
        answer(connection, &folder)?;
        let mut text = Vec::new();
        visitor.read_to_end(&mut text)?;
        answers.push(String::from_utf8_lossy(&text).into_owned());
    }
    fs::remove_dir_all(folder)?;
    Ok(answers)
}

#[test]
fn files_come_with_their_type_and_are_not_kept() -> Result<()> {
    let answers = answers(&[
        "GET / HTTP/1.1\r\n\r\n",
        "GET /web/engine_bg.wasm?v=1 HTTP/1.1\r\n\r\n",
        "HEAD /index.html HTTP/1.1\r\n\r\n",
    ])?;
    for answer in &answers {
        assert!(answer.starts_with("HTTP/1.1 200 OK\r\n"));
        assert!(answer.contains("\r\nCache-Control: no-cache"));
    }
    assert!(answers[0].contains("\r\nContent-Type: text/html"));
    assert!(answers[0].ends_with("\r\n\r\n<p>fire</p>"));
    assert!(answers[1].contains("\r\nContent-Type: application/wasm\r\n"));
    assert!(answers[1].ends_with("\r\n\r\n\0asm"));
    assert!(answers[2].contains("\r\nContent-Length: 11\r\n"));
    assert!(answers[2].ends_with("\r\n\r\n"));
    Ok(())
}

#[test]
fn every_kind_of_file_of_the_site_has_its_type() {
    for (file, expected) in [
        ("index.html", "text/html; charset=utf-8"),
        ("web/embed.html", "text/html; charset=utf-8"),
        ("web/embed/main.js", "text/javascript; charset=utf-8"),
        ("web/pages/main.css", "text/css; charset=utf-8"),
        ("web/custom-elements.json", "application/json"),
        ("web/poster.jpg", "image/jpeg"),
        ("web/wasm/hearth-engine_bg.wasm", "application/wasm"),
        ("web/hearth-fire.d.ts", "text/plain; charset=utf-8"),
        ("LICENSE", "application/octet-stream"),
    ] {
        assert_eq!(mime_type(Path::new(file)), expected, "{file}");
    }
}

#[test]
fn what_is_not_there_is_said() -> Result<()> {
    let answers = answers(&[
        "GET /no.js HTTP/1.1\r\n\r\n",
        "GET /../Cargo.toml HTTP/1.1\r\n\r\n",
        "GET /web/ HTTP/1.1\r\n\r\n",
        "GET /web HTTP/1.1\r\n\r\n",
        "POST / HTTP/1.1\r\n\r\n",
        "nonsense\r\n\r\n",
    ])?;
    let statuses: Vec<_> = answers.iter().map(|answer| &answer[9..12]).collect();
    assert_eq!(statuses, ["404", "404", "404", "301", "405", "400"]);
    assert!(answers[3].contains("\r\nLocation: /web/\r\n"));
    Ok(())
}

#[test]
fn a_taken_port_is_refused_only_where_it_was_asked_for() -> Result<()> {
    let taken = TcpListener::bind((Ipv4Addr::LOCALHOST, 0))?;
    let port = taken.local_addr()?.port();
    let said = listen(Some(port)).err().map(|error| error.to_string());
    assert!(said.is_some_and(|said| said.contains(&port.to_string())));
    let (first, second) = (listen(None)?, listen(None)?);
    assert_ne!(first.local_addr()?, second.local_addr()?);
    assert!(second.local_addr()?.ip().is_loopback());
    Ok(())
}
