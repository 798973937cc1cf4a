//! Simulates a fire and writes a sequence of PNG pictures, without a browser:
//!
//! ```sh
//! cargo run -p hearth-fire-core --release --example fire -- --frames 60 --out DIR
//! ```
//!
//! Parameters follow as `id=value`. The processor draws the pictures from the public readers of
//! the library: positions, temperatures, soot.

mod options;
mod picture;

use std::error::Error;
use std::fs::{self, File};
use std::io::BufWriter;
use std::path::Path;
use std::process::ExitCode;

use hearth_core::Simulation;

use options::Options;
use picture::Picture;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if arguments
        .iter()
        .any(|argument| argument == "--help" || argument == "-h")
    {
        print!("{}", options::HELP);
        return ExitCode::SUCCESS;
    }
    match Options::parse(&arguments).and_then(|options| burn(&options)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// Simulates the frames and writes a picture of each.
fn burn(options: &Options) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(&options.out)
        .map_err(|error| format!("cannot make {}: {error}", options.out.display()))?;
    let mut fire = Simulation::new(options.parameters.clone());
    for frame in 0..options.frames {
        let until = options.start + f64::from(frame) / options.fps;
        while fire.time() < until {
            fire.step();
        }
        let file = options.out.join(format!("{frame:04}.png"));
        write(&file, &Picture::of(&fire, options.height))
            .map_err(|error| format!("cannot write {}: {error}", file.display()))?;
    }
    println!(
        "{} pictures in {}: {} particles, {:.2} s",
        options.frames,
        options.out.display(),
        fire.count(),
        fire.time()
    );
    Ok(())
}

fn write(file: &Path, picture: &Picture) -> Result<(), Box<dyn Error>> {
    let out = BufWriter::new(File::create(file)?);
    let mut encoder = png::Encoder::new(out, picture.width, picture.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&picture.rgb)?;
    writer.finish()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::io::BufReader;

    use super::*;

    /// The size and the pixels of a PNG file.
    fn read(file: &Path) -> Result<(u32, u32, Vec<u8>), Box<dyn Error>> {
        let mut reader = png::Decoder::new(BufReader::new(File::open(file)?)).read_info()?;
        let mut rgb = vec![0; reader.output_buffer_size().ok_or("no size")?];
        let info = reader.next_frame(&mut rgb)?;
        assert_eq!(info.color_type, png::ColorType::Rgb);
        Ok((info.width, info.height, rgb))
    }

    #[test]
    fn a_run_writes_its_pictures_and_they_show_a_fire() -> Result<(), Box<dyn Error>> {
        let folder = std::env::temp_dir().join(format!("hearth-fire-{}", std::process::id()));
        let words = format!(
            "--frames 3 --size 120 --start 0.6 --out {} particles=1000",
            folder.display()
        );
        let arguments: Vec<_> = words.split(' ').map(str::to_owned).collect();
        burn(&Options::parse(&arguments)?)?;
        let mut names: Vec<_> = fs::read_dir(&folder)?
            .map(|entry| Ok(entry?.file_name()))
            .collect::<std::io::Result<_>>()?;
        names.sort();
        assert_eq!(names, ["0000.png", "0001.png", "0002.png"]);
        let pictures: Vec<_> = names
            .iter()
            .map(|name| read(&folder.join(name)))
            .collect::<Result<_, _>>()?;
        for (width, height, rgb) in &pictures {
            assert_eq!((*width, *height), (80, 120));
            let pixels = rgb.as_chunks::<3>().0;
            let glowing = pixels
                .iter()
                .filter(|[r, g, b]| r > &100 && r >= g && g >= b);
            let share = glowing.count() as f64 / pixels.len() as f64;
            assert!((0.01..0.6).contains(&share), "{share} of it glows");
        }
        assert_ne!(pictures[0], pictures[2], "the fire moves");
        fs::remove_dir_all(folder)?;
        Ok(())
    }

    #[test]
    fn a_folder_that_cannot_be_made_is_named() -> Result<(), Box<dyn Error>> {
        let file = std::env::temp_dir().join(format!("hearth-file-{}", std::process::id()));
        fs::write(&file, "")?;
        let out = file.join("frames");
        let options = Options {
            out: out.clone(),
            ..Options::default()
        };
        let message = burn(&options).err().map(|error| error.to_string());
        fs::remove_file(file)?;
        assert!(message.is_some_and(|message| message.contains(&out.display().to_string())));
        Ok(())
    }
}
