//! What firmware draws, without std and without alloc: a label for an OLED, a
//! clock in strips, and text of embedded-graphics.
#![no_std]
#![forbid(unsafe_code)]

use inkcell::{
    run_strips, sys, Align, Cache, Ellipsis, Filter, Font, Grey8, Line, MonoPages, Painter, Rect,
    Rgb565, Screen, Status, Strip, Style, TextBox, VerticalAlign,
};

/// The font that build.rs made.
pub fn font() -> Result<Font<'static>, Status> {
    Font::open(inkcell::include_font!(concat!(env!("OUT_DIR"), "/sans.bin")))
}

/// A label in the middle of 96 x 16 px of 1 bit, in pages as SSD1306 takes
/// them. `pages` are 0 at first.
pub fn label(text: &str, pages: &mut [u8; 192]) -> Result<(), Status> {
    let font = font()?;
    let style = Style::new(12, Filter::text())?;
    let mut target = MonoPages::new(Strip::new(pages, 96, 16), 128, 1);
    let mut sink = target.sink()?;
    let mut painter = Painter::new(&mut sink);
    let width = painter.measure(&font, text, &style).advance;
    let x = inkcell::Px::from_q6((96 * 64 - width.q6()) / 2);
    painter.text(&font, text, &style, x, 12);
    Ok(())
}

/// A clock of 120 x 40 px in strips of 8 rows of RGB565, from a cache of
/// glyphs. `send` gets the pixels of each strip and their place.
pub fn clock(time: &str, mut send: impl FnMut(&[u8], Rect)) -> Result<(), Status> {
    let font = font()?;
    let style = Style::new(30, Filter::area())?;
    let mut ram = [0; 256];
    let mut cache = Cache::new(&mut ram, 1)?;
    let mut screen = Screen {
        buffer: &mut [0; 120 * 8 * 2],
        format: sys::INKCELL_RGB565,
        order: sys::INKCELL_LOW_FIRST,
        width: 120,
        height: 40,
    };
    run_strips(
        &mut screen,
        None,
        |mut strip| {
            strip.pixels_mut().fill(0);
            let mut target = Rgb565::new(strip, 0xfe40);
            let mut sink = target.sink()?;
            let mut painter = Painter::new(&mut sink).cache(&mut cache);
            painter.text(&font, time, &style, 4, 32);
            Ok(())
        },
        |strip| {
            send(strip.pixels(), strip.rect());
            Ok(())
        },
    )
}

/// A wrapped, centred paragraph of 80 x 64 px in 8-bit grey, with an ellipsis
/// if it is too long. `pixels` are 0 at first.
pub fn paragraph(text: &str, pixels: &mut [u8; 5120]) -> Result<(), Status> {
    let font = font()?;
    let style = Style::new(14, Filter::text())?;
    let mut target = Grey8::new(Strip::new(pixels, 80, 64), 255);
    let mut sink = target.sink()?;
    let mut painter = Painter::new(&mut sink);
    let rect = Rect { x0: 4, y0: 4, x1: 76, y1: 60 };
    let text_box = TextBox::new(&font, &style, rect)
        .align(Align::Centre)
        .ellipsis(Ellipsis::End)
        .vertical(VerticalAlign::Middle);
    let mut lines = [Line::EMPTY; 6];
    let lines = text_box.lay_out(&mut painter, text, &mut lines)?;
    text_box.draw(&mut painter, &lines);
    Ok(())
}

/// Text of embedded-graphics on any display of RGB565 whose background is
/// black.
#[cfg(feature = "embedded-graphics")]
pub fn greet<D>(display: &mut D) -> Result<(), D::Error>
where
    D: embedded_graphics::draw_target::DrawTarget<Color = embedded_graphics::pixelcolor::Rgb565>,
{
    use embedded_graphics::{pixelcolor::Rgb565, prelude::*, text::Text};
    if let (Ok(font), Ok(style)) = (font(), Style::new(20, Filter::area())) {
        let style =
            inkcell::graphics::TextStyle::new(&font, &style, Rgb565::WHITE).over(Rgb565::BLACK);
        Text::new("Hello,\nRust!", Point::new(4, 24), style).draw(display)?;
    }
    Ok(())
}
