//! Small plots as SVG: lines for theory, dots for what was measured.

use std::fmt::Write as _;

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// A line.
    Line,
    /// Dots.
    Dots,
}

/// Points that belong together.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Its name in the legend; none where empty.
    pub label: String,
    /// x and y.
    pub points: Vec<(f64, f64)>,
    /// How it is drawn.
    pub style: Style,
}

impl Series {
    /// A line through points.
    pub fn line(label: &str, points: impl IntoIterator<Item = (f64, f64)>) -> Series {
        Series {
            label: label.to_owned(),
            points: points.into_iter().collect(),
            style: Style::Line,
        }
    }

    /// Dots.
    pub fn dots(label: &str, points: impl IntoIterator<Item = (f64, f64)>) -> Series {
        Series {
            style: Style::Dots,
            ..Series::line(label, points)
        }
    }

    /// At most so many of its points, evenly chosen, so that a file stays small.
    fn thinned(&self, most: usize) -> impl Iterator<Item = (f64, f64)> {
        let stride = self.points.len().div_ceil(most).max(1);
        self.points.iter().copied().step_by(stride)
    }
}

/// A plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// Its file's name without ending.
    pub name: String,
    /// What it shows.
    pub title: String,
    /// What lies along x and y.
    pub axes: [String; 2],
    /// Whether y is drawn logarithmically.
    pub logarithmic: bool,
    /// What is drawn.
    pub series: Vec<Series>,
}

const WIDTH: f64 = 360.0;
const HEIGHT: f64 = 240.0;
const LEFT: f64 = 56.0;
const RIGHT: f64 = 12.0;
const TOP: f64 = 28.0;
const BOTTOM: f64 = 40.0;
/// Dots of one series at most.
const MOST_DOTS: usize = 60;
/// Points of one line at most.
const MOST_POINTS: usize = 160;

/// Colours that are distinct on white and on black, and without a distinction of red and green
/// (Okabe and Ito).
const COLOURS: [&str; 5] = ["#d55e00", "#0072b2", "#009e73", "#cc79a7", "#a08000"];

impl Plot {
    /// An empty plot.
    pub fn new(name: &str, title: &str, x: &str, y: &str) -> Plot {
        Plot {
            name: name.to_owned(),
            title: title.to_owned(),
            axes: [x.to_owned(), y.to_owned()],
            logarithmic: false,
            series: Vec::new(),
        }
    }

    /// The same with y drawn logarithmically.
    #[must_use]
    pub fn logarithmic_y(mut self) -> Plot {
        self.logarithmic = true;
        self
    }

    /// The same with one more series.
    #[must_use]
    pub fn showing(mut self, series: Series) -> Plot {
        self.push(series);
        self
    }

    /// One more series.
    pub fn push(&mut self, series: Series) {
        self.series.push(series);
    }

    /// The plot as an SVG file.
    pub fn svg(&self) -> String {
        let height = |y: f64| if self.logarithmic { y.log10() } else { y };
        let drawn = |series: &Series, most| -> Vec<(f64, f64)> {
            series
                .thinned(most)
                .map(|(x, y)| (x, height(y)))
                .filter(|(x, y)| x.is_finite() && y.is_finite())
                .collect()
        };
        let all: Vec<_> = self
            .series
            .iter()
            .flat_map(|series| drawn(series, usize::MAX))
            .collect();
        let across = Axis::over(all.iter().map(|p| p.0), LEFT, WIDTH - RIGHT);
        let up = Axis::over(all.iter().map(|p| p.1), HEIGHT - BOTTOM, TOP);
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" \
             font-family=\"sans-serif\" font-size=\"10\">\n\
             <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n\
             <text x=\"{LEFT}\" y=\"16\" font-size=\"12\">{}</text>\n\
             <g stroke=\"#ddd\" text-anchor=\"middle\">\n",
            escaped(&self.title)
        );
        let (bottom, right) = (HEIGHT - BOTTOM, WIDTH - RIGHT);
        for tick in across.ticks() {
            let x = across.at(tick);
            let _ = writeln!(
                svg,
                "<path d=\"M{x:.1} {TOP}V{bottom}\"/><text x=\"{x:.1}\" y=\"{:.1}\" \
                 stroke=\"none\">{}</text>",
                bottom + 13.0,
                number(tick),
            );
        }
        for tick in up.ticks() {
            let y = up.at(tick);
            let shown = if self.logarithmic {
                10f64.powf(tick)
            } else {
                tick
            };
            let _ = writeln!(
                svg,
                "<path d=\"M{LEFT} {y:.1}H{right}\"/><text x=\"{:.1}\" y=\"{:.1}\" \
                 stroke=\"none\" text-anchor=\"end\">{}</text>",
                LEFT - 4.0,
                y + 3.5,
                number(shown),
            );
        }
        let _ = writeln!(
            svg,
            "</g>\n<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>\n\
             <text transform=\"translate(12 {:.1}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
            0.5 * (LEFT + right),
            HEIGHT - 8.0,
            escaped(&self.axes[0]),
            0.5 * (TOP + bottom),
            escaped(&self.axes[1]),
        );
        let mut legend = 0.0;
        for (i, series) in self.series.iter().enumerate() {
            let colour = match series.style {
                Style::Line => "#555",
                Style::Dots => COLOURS[(i / 2) % COLOURS.len()],
            };
            match series.style {
                Style::Line => {
                    let mut path = String::new();
                    for (x, y) in drawn(series, MOST_POINTS) {
                        let start = if path.is_empty() { 'M' } else { 'L' };
                        let _ = write!(path, "{start}{:.1} {:.1}", across.at(x), up.at(y));
                    }
                    let _ = writeln!(
                        svg,
                        "<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\"/>"
                    );
                }
                Style::Dots => {
                    let _ = writeln!(svg, "<g fill=\"{colour}\">");
                    for (x, y) in drawn(series, MOST_DOTS) {
                        let (x, y) = (across.at(x), up.at(y));
                        let _ = writeln!(svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2\"/>");
                    }
                    let _ = writeln!(svg, "</g>");
                }
            }
            if !series.label.is_empty() {
                let _ = writeln!(
                    svg,
                    "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\" fill=\"{colour}\" \
                     stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\">{}</text>",
                    right - 4.0,
                    TOP + 12.0 + legend,
                    escaped(&series.label),
                );
                legend += 12.0;
            }
        }
        svg.push_str("</svg>\n");
        svg
    }
}

/// An axis: values that are drawn between two places.
struct Axis {
    low: f64,
    high: f64,
    from: f64,
    to: f64,
}

impl Axis {
    fn over(values: impl Iterator<Item = f64>, from: f64, to: f64) -> Axis {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        let (low, high) = if low < high { (low, high) } else { (0.0, 1.0) };
        // Air around the values; zero is a good end where it is near.
        let air = 0.05 * (high - low);
        let low = if low >= 0.0 && low < 0.3 * high {
            0.0
        } else {
            low - air
        };
        Axis {
            low,
            high: high + air,
            from,
            to,
        }
    }

    fn at(&self, value: f64) -> f64 {
        self.from + (value - self.low) / (self.high - self.low) * (self.to - self.from)
    }

    /// Four to nine round values.
    fn ticks(&self) -> impl Iterator<Item = f64> {
        let rough = (self.high - self.low) / 5.0;
        let power = 10f64.powf(rough.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0]
            .map(|n| n * power)
            .into_iter()
            .find(|step| *step >= 0.8 * rough)
            .unwrap_or(rough);
        let first = (self.low / step).ceil() as i64;
        let last = (self.high / step).floor() as i64;
        (first..=last).map(move |i| i as f64 * step)
    }
}

/// A number with as many digits as it needs.
fn number(value: f64) -> String {
    let text = if value != 0.0 && value.abs() < 0.01 {
        return format!("{value:.0e}");
    } else if value.abs() < 10.0 {
        format!("{value:.2}")
    } else {
        format!("{value:.0}")
    };
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plot_is_small_and_stays_inside() {
        let plot = Plot::new("p", "1 < 2 & 3", "x", "y")
            .showing(Series::line("law", (0..5000).map(|i| (f64::from(i), 2.0))))
            .showing(Series::dots(
                "seen",
                (0..5000).map(|i| (f64::from(i), f64::from(i % 7))),
            ))
            .showing(Series::dots("broken", [(f64::NAN, 1.0)]));
        let svg = plot.svg();
        assert!(svg.len() < 9000, "{}", svg.len());
        assert!(svg.contains("1 &lt; 2 &amp; 3") && !svg.contains("NaN"));
        for circle in svg.lines().filter(|line| line.starts_with("<circle")) {
            let number = |key: &str| -> f64 {
                let rest = circle.split(key).nth(1).unwrap();
                rest.split('"').next().unwrap().parse().unwrap()
            };
            assert!((LEFT..=WIDTH - RIGHT).contains(&number("cx=\"")));
            assert!((TOP..=HEIGHT - BOTTOM).contains(&number("cy=\"")));
        }
    }

    #[test]
    fn ticks_are_round_and_few() {
        for (low, high) in [(0.0, 1.0), (-3.0, 17.0), (0.2, 0.23), (0.0, 95_000.0)] {
            let axis = Axis {
                low,
                high,
                from: 0.0,
                to: 1.0,
            };
            let ticks: Vec<_> = axis.ticks().collect();
            assert!((3..=10).contains(&ticks.len()), "{ticks:?}");
        }
        assert_eq!(number(0.5), "0.5");
        assert_eq!(number(200.0), "200");
        assert_eq!(number(0.0), "0");
    }
}
