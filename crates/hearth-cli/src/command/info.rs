//! `hearth info`: the graphics driver.

use clap::Args;
use serde_json::json;

use super::options::DriverOptions;
use crate::error::Error;
use crate::{Offscreen, egl, output};

/// Arguments of `hearth info`.
#[derive(Args)]
pub struct Info {
    /// Prints JSON.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    driver: DriverOptions,
}

impl Info {
    /// Prints names, limits and formats of the driver.
    ///
    /// # Errors
    /// The machine has no such driver, or standard output fails.
    pub fn run(&self) -> Result<(), Error> {
        let devices: Vec<_> = (0..egl::device_count()?).map(device).collect();
        let (offscreen, shared) = self.driver.open()?;
        let driver = offscreen.driver();
        let format = shared.target_format().name();
        if self.json {
            let record = json!({
                "vendor": driver.vendor,
                "renderer": driver.renderer,
                "version": driver.version,
                "platform": driver.platform,
                "devices": devices,
                "maxSide": driver.max_side,
                "halfFloat": driver.half_float,
                "format": format,
                "timerQueries": driver.timer_queries,
            });
            return output::print(format!("{record:#}\n").as_bytes());
        }
        let yes = |it| if it { "yes" } else { "no" };
        let text = format!(
            "renderer        {}\nvendor          {}\nversion         {}\nplatform        {} of EGL\n\
             largest side    {} pixels\nhalf floats     {}\n\
             format          {format}\ntimer queries   {}\n",
            driver.renderer,
            driver.vendor,
            driver.version,
            driver.platform,
            driver.max_side,
            yes(driver.half_float),
            yes(driver.timer_queries),
        );
        let devices = devices.iter().enumerate();
        let devices = devices.map(|(number, name)| format!("device {number:<9}{name}\n"));
        output::print((text + &devices.collect::<String>()).as_bytes())
    }
}

/// The renderer of a device, or why it has none.
fn device(number: usize) -> String {
    match Offscreen::on(Some(number)) {
        Ok(offscreen) => offscreen.driver().renderer,
        Err(error) => error.to_string(),
    }
}
