//! `cargo xtask publish`: all that a release needs, in `dist/release`, with a list of what a person
//! does by hand. Nothing here uploads.

use std::path::PathBuf;

use anyhow::{Context, Result, ensure};
use serde_json::Value;
use xshell::cmd;

use crate::pages::Places;
use crate::shell::{self, Shell};
use crate::{links, package, pages, paths, tools};

/// The version of every crate and of the package.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Makes the release of the last commit.
pub(crate) fn make(places: &Places) -> Result<()> {
    let sh = Shell::new()?;
    let changed = cmd!(sh, "git status --porcelain").read()?;
    ensure!(
        changed.is_empty(),
        "a release is of a commit, and these files have changes:\n{changed}"
    );
    let commit = cmd!(sh, "git rev-parse HEAD").read()?;
    let notes = notes(&sh.read_file("CHANGELOG.md")?, VERSION)?;
    let crates = published(&tools::metadata(&["--no-deps"])?);

    package::build()?;
    finish_site(places)?;
    let _lock = tools::writing(&paths::dist())?;
    let release = folder();
    sh.remove_path(&release)?;
    for part in ["crates", "npm"] {
        sh.create_dir(release.join(part))?;
    }
    crate::site::copy_folder(&sh, &paths::site(), &release.join("site"))?;
    let npm = shell::find("npm").unwrap_or_else(|| "npm".into());
    let to = release.join("npm");
    let pack = sh.cmd(npm).args(["pack", "--silent", "--pack-destination"]);
    let package = package::folder();
    pack.arg(to).arg(package).run()?;
    pack_crates(&sh, &crates)?;
    sh.write_file(release.join("NOTES.md"), notes)?;
    let by_hand = by_hand(&commit, &crates, places);
    sh.write_file(release.join("BY-HAND.md"), &by_hand)?;
    let packaging = paths::packaging();
    cmd!(sh, "node {packaging}/checksums.mjs {release}").run()?;
    println!("\n{by_hand}\nAll of it is in {}.", paths::shown(&release));
    Ok(())
}

/// Makes the release of the last commit, and in a folder with another name once more, and compares both.
pub(crate) fn reproduce() -> Result<()> {
    make(&Places::default())?;
    let (sh, scripts) = (Shell::new()?, paths::packaging());
    Ok(cmd!(sh, "node {scripts}/reproduce.mjs").run()?)
}

/// Writes what the built site says about where it is.
pub(crate) fn finish_site(places: &Places) -> Result<()> {
    pages::write(&paths::root(), &paths::site(), places)?;
    match places.url {
        Some(base) => links::make_absolute(&paths::site(), base),
        None => Ok(()),
    }
}

/// Where the release is made.
fn folder() -> PathBuf {
    paths::dist().join("release")
}

/// Packs the crates as crates.io gets them. The stage `publish` compiles what is packed.
fn pack_crates(sh: &Shell, crates: &[String]) -> Result<()> {
    let target = tools::target()?.join("release-crates");
    sh.remove_path(&target)?;
    let packages = crates.iter().flat_map(|name| ["--package", name]);
    // The notices of the command are made, not in git, which cargo takes for a change.
    let cargo = sh.cargo("package --quiet --locked --no-verify --allow-dirty --target-dir");
    cargo.arg(&target).args(packages).run()?;
    for name in crates {
        let file = format!("{name}-{VERSION}.crate");
        let packed = target.join("package").join(&file);
        sh.copy_file(packed, folder().join("crates"))
            .with_context(|| format!("cargo packed no {file}"))?;
    }
    Ok(sh.remove_path(&target)?)
}

/// The crates of the workspace that may be published, by name.
fn published(metadata: &Value) -> Vec<String> {
    let packages = metadata["packages"].as_array().into_iter().flatten();
    // `publish = false` is an empty list of registries.
    let packages = packages.filter(|package| package["publish"].is_null());
    let mut names: Vec<_> = packages
        .filter_map(|package| package["name"].as_str().map(str::to_owned))
        .collect();
    names.sort();
    names
}

/// What the changelog says of a version, or of what is not released yet.
fn notes(changelog: &str, version: &str) -> Result<String> {
    let sections = changelog.split("\n## ").skip(1);
    let mut sections = sections.filter_map(|section| section.split_once('\n'));
    let named = |heading: &str| heading.split_whitespace().next() == Some(version);
    let of_version = sections.clone().find(|(heading, _)| named(heading));
    let unreleased = || sections.find(|(heading, _)| heading.trim() == "Unreleased");
    let (_, text) = of_version.or_else(unreleased).with_context(|| {
        format!("CHANGELOG.md has neither a section \"{version}\" nor \"Unreleased\"")
    })?;
    let text = text.trim();
    ensure!(
        !text.is_empty(),
        "CHANGELOG.md says nothing about {version}"
    );
    Ok(format!("# Hearth {version}\n\n{text}\n"))
}

/// What is left to do after the release is made, in order.
fn by_hand(commit: &str, crates: &[String], places: &Places) -> String {
    let crates = crates.join(", ");
    let missing = [
        (
            places.url.is_none(),
            "--url ADDRESS, so previews of links lack their picture, and there is no sitemap",
        ),
        (
            places.repository.is_none(),
            "--repository ADDRESS, so the documentation links no sources",
        ),
    ];
    let missing = missing.iter().filter(|(missing, _)| *missing);
    let missing: String = missing
        .map(|(_, what)| format!("   The site was made without {what}.\n"))
        .collect();
    format!(
        "# What is left to do by hand for Hearth {VERSION}\n\n\
         Nothing has been uploaded. The folder is made of the commit {commit}.\n\n\
         1. Check that commit: `cargo xtask test --all`, then `cargo xtask reproduce`, which needs minutes each.\n\
         2. In CHANGELOG.md, name the section \"Unreleased\" \"{VERSION}\" with the day, and commit that; make this folder again.\n\
         3. Sign the checksums and the commit: `gpg --armor --detach-sign SHA256SUMS`, `git tag --sign v{VERSION}`, \
         `git push --tags`.\n\
         4. Publish the crates, which cannot be taken back: `cargo login`, then `cargo publish --workspace --allow-dirty` \
         in the checkout, which has the notices of the command beside what is in git. \
         They are {crates}. `crates/` has their archives to compare.\n\
         5. Publish the package, which cannot be replaced: `npm login`, then \
         `npm publish npm/hearth-fire-{VERSION}.tgz --access public`.\n\
         6. Copy `site/` to the host. It must serve `.wasm` as `application/wasm` and compress it; `404.html` is for \
         addresses that lead nowhere.\n{missing}\
         7. Make a release of the tag where the sources are, with NOTES.md, the archives of `crates/` and `npm/`, SHA256SUMS and \
         its signature.\n\
         8. Try it on a machine that has never seen Hearth: `sha256sum --check SHA256SUMS`, `npm install hearth-fire`, \
         `cargo add hearth-fire`, `cargo install hearth-fire-cli`, the site on a phone.\n\
         9. In CHANGELOG.md, begin a section \"Unreleased\"; in Cargo.toml, raise the version.\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn notes_are_those_of_the_version_or_of_what_is_not_released() -> Result<()> {
        let unreleased = "# Changelog\n\nIntro.\n\n## Unreleased\n\n### Latest\n\n- New.\n";
        let released =
            format!("{unreleased}\n## 0.2.0 (a day)\n\n- Old.\n\n## 0.1.0\n\n- First.\n");
        let latest = "# Hearth 0.2.0\n\n### Latest\n\n- New.\n";
        assert_eq!(notes(unreleased, "0.2.0")?, latest);
        assert_eq!(notes(&released, "0.2.0")?, "# Hearth 0.2.0\n\n- Old.\n");
        assert_eq!(notes(&released, "0.1.0")?, "# Hearth 0.1.0\n\n- First.\n");
        for empty in [
            "# Changelog\n",
            "# Changelog\n\n## Unreleased\n\n## 0.1.0\n\n- First.\n",
        ] {
            let refused = notes(empty, "0.2.0").err().map(|why| why.to_string());
            assert!(refused.is_some_and(|why| why.contains("0.2.0")), "{empty}");
        }
        let sh = Shell::new()?;
        assert!(notes(&sh.read_file("CHANGELOG.md")?, VERSION)?.len() > 1000);
        Ok(())
    }

    #[test]
    fn the_crates_that_users_add_are_published_and_no_tool_is() -> Result<()> {
        let crates = published(&tools::metadata(&["--no-deps"])?);
        for name in ["hearth-fire", "hearth-fire-cli", "hearth-fire-core"] {
            assert!(crates.contains(&name.to_owned()), "{name}: {crates:?}");
        }
        assert!(
            crates.iter().all(|name| name.starts_with("hearth-fire")),
            "{crates:?}"
        );
        Ok(())
    }

    #[test]
    fn what_is_left_names_each_place_and_what_the_site_lacks() -> Result<()> {
        let crates = ["a-crate".to_owned()];
        let (url, repository) = ("https://a.example".parse()?, "https://b.example".parse()?);
        let whole = Places {
            url: Some(&url),
            repository: Some(&repository),
        };
        let text = by_hand("0123abc", &crates, &whole);
        for named in [
            "0123abc",
            "a-crate",
            "cargo publish",
            "npm publish",
            "site/",
            "SHA256SUMS",
            "NOTES.md",
            "git tag",
        ] {
            assert!(text.contains(named), "{named}");
        }
        assert!(!text.contains("--url") && !text.contains("--repository"));
        let text = by_hand("0123abc", &crates, &Places::default());
        assert!(text.contains("--url") && text.contains("--repository"));
        Ok(())
    }
}
