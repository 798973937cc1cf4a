//! `hearth info`: the graphics driver.

use clap::Args;
use serde_json::json;

use super::options::DriverOptions;
use crate::error::Error;
use crate::{egl, output};

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
        let (offscreen, shared) = self.driver.open()?;
        let driver = offscreen.driver();
        let (devices, format) = (egl::device_count()?, shared.target_format().name());
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
             devices         {devices}\nlargest side    {} pixels\nhalf floats     {}\n\
             format          {format}\ntimer queries   {}\n",
            driver.renderer,
            driver.vendor,
            driver.version,
            driver.platform,
            driver.max_side,
            yes(driver.half_float),
            yes(driver.timer_queries),
        );
        output::print(text.as_bytes())
    }
}
