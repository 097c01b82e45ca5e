//! Draws what expected.cpp draws, and the examples, into a file; tells where
//! members of types lie.
//!
//! Usage: inkcell-check FILE
#![forbid(unsafe_code)]
use inkcell::*;
use std::io::Write;

#[cfg(feature = "embedded-graphics")]
mod graphics;
mod layout;

/// The darkest of all coverages, as a sink of its own.
struct Darkest {
    pixels: [u8; 64 * 24],
}

impl Pixels for Darkest {
    fn coverage(&mut self, x: i32, y: i32, coverage: &[u8]) {
        for (i, coverage) in coverage.iter().enumerate() {
            let pixel = &mut self.pixels[(y * 64 + x) as usize + i];
            *pixel = (*pixel).max(*coverage);
        }
    }
    fn solid(&mut self, x: i32, y: i32, count: i32) {
        let begin = (y * 64 + x) as usize;
        self.pixels[begin..begin + count as usize].fill(255);
    }
}

fn plot(font: &Font<'_>) -> Result<Vec<u8>, Status> {
    let style = Style::turned(16, Filter::text(), 1053110176, 209476638)?;
    let mut own = Darkest { pixels: [0; 64 * 24] };
    let mut sink = Sink::of(&mut own, Rect { x0: 0, y0: 0, x1: 64, y1: 24 });
    let y = Px::from_q6(20 * 64 + 32);
    Painter::new(&mut sink).text(font, "Plot 7", &style, 2, y);
    Ok(own.pixels.to_vec())
}

/// Text of every format, heavier than designed, with and without lent RAM.
fn formats(font: &Font<'_>, to: &mut Vec<u8>) -> Result<(), Status> {
    let mut table = FilterTable::default();
    let filter = Filter::text().with_weight(256, &mut table);
    let base = Style::new(18, filter)?;
    let fit = Fit::new(font, &base, true, 0)?;
    let mut style = base;
    style.set_fit(&fit);
    let mut ram = [0; 640];
    macro_rules! draw {
        ($name:ident $bytes:literal ($($more:expr),*)) => {{
            let mut pixels = vec![0u8; $bytes];
            let strip = Strip::new(&mut pixels, 60, 24).at(-2, 0);
            let mut target = $name::new(strip, $($more),*);
            let mut sink = target.sink()?;
            let mut painter = Painter::new(&mut sink).ram(&mut ram);
            painter.text(font, "Weight", &style, 0, 18);
            to.extend(pixels);
        }};
    }
    draw!(A8 1440 ());
    draw!(Grey8 1440 (200));
    draw!(Grey4 720 (15, sys::INKCELL_LOW_LEFT));
    draw!(Grey2 360 (3, sys::INKCELL_HIGH_LEFT));
    draw!(MonoRows 192 (128, 1, sys::INKCELL_HIGH_LEFT));
    draw!(MonoPages 180 (128, 1));
    draw!(Rgb565 2880 (0xfe40));
    draw!(Rgb888 4320 (0x123456, sys::INKCELL_RED_FIRST));
    draw!(Xrgb8888 5760 (0x123456));
    Ok(())
}

/// What fails says why, and what is missing is told.
fn refusals(font: &Font<'_>) -> Result<(), Status> {
    let mut small = [0; 10];
    let mut grey = Grey8::new(Strip::new(&mut small, 16, 16), 255);
    let mut grey4 = [0; 16];
    let mut level = Grey4::new(Strip::new(&mut grey4, 8, 4), 16, 0);
    println!("font {:?}", Font::open(&Aligned([0; 64]).0).err());
    println!("sink {:?} {:?}", grey.sink().err(), level.sink().err());
    println!("style {:?}", Style::new(3, Filter::area()).err());
    println!("cache {:?}", Cache::new(&mut [0; 8], 1).err());
    let style = Style::new(20, Filter::area())?;
    let mut report = Report::default().instead(None);
    let mut painter = Painter::none().report(&mut report);
    let measure = painter.measure(font, "\u{416}A", &style);
    drop(painter);
    let (count, first) = report.missing();
    println!("missing {count} {first:?} {:?}", report.status());
    println!("has {} {}", font.has('A'), font.has('\u{416}'));
    println!("advance {} of 13", measure.advance.round());
    let rect = Rect { x0: 0, y0: 0, x1: 20, y1: 60 };
    let mut room = [Line::EMPTY; 1];
    let text_box = TextBox::new(font, &style, rect);
    let lines = text_box.lay_out(&mut Painter::none(), "a b c d", &mut room);
    println!("lines {:?}", lines.err());
    Ok(())
}

fn main() -> Result<(), Status> {
    let font = inkcell_example::font()?;
    let mut all = Vec::new();
    let mut pages = [0; 192];
    inkcell_example::label("23.5 \u{b0}C", &mut pages)?;
    all.extend(pages);
    inkcell_example::clock("12:34", |pixels, _| all.extend(pixels))?;
    let mut grey = [0; 5120];
    inkcell_example::paragraph(
        "A paragraph that has more words than there is room for",
        &mut grey,
    )?;
    all.extend(grey);
    all.extend(plot(&font)?);
    formats(&font, &mut all)?;
    #[cfg(feature = "embedded-graphics")]
    all.extend(graphics::all(&font)?);
    let file = std::env::args().nth(1).expect("a file");
    std::fs::File::create(file).unwrap().write_all(&all).unwrap();
    refusals(&font)?;
    layout::print();
    Ok(())
}

/// Programs whose memory is gone before it is used.
#[allow(dead_code, unused)]
mod refused {
    use inkcell::*;

    #[cfg(feature = "gone_font")]
    fn program() -> Result<(), Status> {
        let rom = vec![0; 64];
        let font = Font::open(&rom)?;
        #[cfg(feature = "mistake")]
        drop(rom);
        font.metrics();
        Ok(())
    }

    #[cfg(feature = "gone_pixels")]
    fn program() -> Result<(), Status> {
        let mut pixels = [0; 64];
        let mut grey = Grey8::new(Strip::new(&mut pixels, 8, 8), 255);
        let mut sink = grey.sink()?;
        #[cfg(feature = "mistake")]
        pixels.fill(0);
        sink.fill();
        Ok(())
    }

    #[cfg(feature = "gone_fit")]
    fn program(font: &Font<'_>) -> Result<(), Status> {
        let base = Style::new(12, Filter::area())?;
        let fit = Fit::new(font, &base, true, 0)?;
        let mut style = base;
        style.set_fit(&fit);
        #[cfg(feature = "mistake")]
        drop(fit);
        Painter::none().measure(font, "a", &style);
        Ok(())
    }

    #[cfg(feature = "gone_text")]
    fn program(text_box: &TextBox<'_>) -> Result<(), Status> {
        let text = String::from("a text");
        let mut room = [Line::EMPTY; 4];
        let painter = &mut Painter::none();
        let lines = text_box.lay_out(painter, &text, &mut room)?;
        #[cfg(feature = "mistake")]
        drop(text);
        text_box.draw(painter, &lines);
        Ok(())
    }

    #[cfg(feature = "two_sinks")]
    fn program() -> Result<(), Status> {
        let mut pixels = [0; 64];
        let mut grey = Grey8::new(Strip::new(&mut pixels, 8, 8), 255);
        let mut first = grey.sink()?;
        #[cfg(feature = "mistake")]
        let mut second = grey.sink()?;
        first.fill();
        Ok(())
    }
}
