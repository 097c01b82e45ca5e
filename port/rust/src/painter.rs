//! Text onto a sink.
use crate::{made, sys, tried, Font, Px, Rect, Sink, Status, Style};
use core::marker::PhantomData;

/// Draws and measures text: a sink and what is lent. It takes itself mutably,
/// so that nothing draws while it draws.
pub struct Painter<'a> {
    pub(crate) raw: sys::inkcell_painter_t,
    of: PhantomData<&'a mut ()>,
}

/// Width and ink of a line from its origin, y down, before the style turns it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Measure {
    /// To where the next text begins.
    pub advance: Px,
    /// Of the ink.
    pub left: Px,
    /// Of the ink.
    pub top: Px,
    /// Of the ink.
    pub right: Px,
    /// Of the ink.
    pub bottom: Px,
}

impl<'a> Painter<'a> {
    /// For one sink, without lent RAM: takes 1.4 to 1.9 KB of stack.
    pub fn new(sink: &'a mut Sink<'_>) -> Painter<'a> {
        let mut painter = Painter::none();
        painter.raw.sink = &sink.raw;
        painter
    }

    /// Draws nothing: for measures where no sink has 1 or 2 bits.
    pub fn none() -> Painter<'static> {
        Painter { raw: made(|_| ()), of: PhantomData }
    }

    /// Lends RAM: 2,560 bytes take 0.6 KB off the stack. The picture is the
    /// same.
    pub fn ram(mut self, ram: &'a mut [u32]) -> Self {
        self.raw.ram.data = ram.as_mut_ptr().cast();
        self.raw.ram.size = core::mem::size_of_val(ram);
        self
    }

    /// Keeps drawn glyphs.
    pub fn cache(mut self, cache: &'a mut Cache<'_>) -> Self {
        self.raw.cache = &cache.raw;
        self
    }

    /// Tells of characters that fonts lack.
    pub fn report(mut self, report: &'a mut Report) -> Self {
        self.raw.report = &mut report.raw;
        self
    }

    /// Draws a line with the left end of its baseline at (x, y).
    pub fn text(
        &mut self,
        font: &Font<'_>,
        text: &str,
        style: &Style<'_>,
        x: impl Into<Px>,
        y: impl Into<Px>,
    ) {
        let (x, y) = (x.into().q6(), y.into().q6());
        let (font, style, bytes) = (&font.raw, &style.raw, text.as_ptr());
        unsafe { sys::inkcell_draw_text(&self.raw, font, bytes, text.len(), style, x, y) }
    }

    /// Measures a line as [`Painter::text`] draws it.
    pub fn measure(&mut self, font: &Font<'_>, text: &str, style: &Style<'_>) -> Measure {
        let (font, style, bytes) = (&font.raw, &style.raw, text.as_ptr());
        let out: sys::inkcell_pixel_measure_t = made(|out| unsafe {
            sys::inkcell_measure(&self.raw, font, bytes, text.len(), style, out)
        });
        Measure {
            advance: Px::from_q6(out.advance_q6),
            left: Px::from_q6(out.left_q6),
            top: Px::from_q6(out.top_q6),
            right: Px::from_q6(out.right_q6),
            bottom: Px::from_q6(out.bottom_q6),
        }
    }

    /// The pixels that [`Painter::text`] may touch, whatever the window is.
    pub fn ink(
        &mut self,
        font: &Font<'_>,
        text: &str,
        style: &Style<'_>,
        x: impl Into<Px>,
        y: impl Into<Px>,
    ) -> Rect {
        let (x, y) = (x.into().q6(), y.into().q6());
        let (font, style, bytes) = (&font.raw, &style.raw, text.as_ptr());
        made(|out| unsafe {
            sys::inkcell_box(&self.raw, font, bytes, text.len(), style, x, y, out)
        })
    }
}

/// A cache of drawn glyphs. Filters, fits and fonts are compared by
/// address: clear it before one changes or another takes its place.
pub struct Cache<'a> {
    raw: sys::inkcell_glyph_cache_t,
    of: PhantomData<&'a mut [u64]>,
}

impl<'a> Cache<'a> {
    /// In `ram`, of 64 words for each pair of a font and a style; beyond 8191
    /// words it is not used. `styles` is the number of pairs, 1 to 16.
    pub fn new(ram: &'a mut [u64], styles: u8) -> Result<Self, Status> {
        let options = sys::inkcell_glyph_cache_options_t { bits: 0, phases: 0, styles };
        let (size, ram) = (core::mem::size_of_val(ram), ram.as_mut_ptr().cast());
        let raw = tried(|out| unsafe { sys::inkcell_glyph_cache_make(ram, size, &options, out) })?;
        Ok(Cache { raw, of: PhantomData })
    }

    /// Forgets all glyphs.
    pub fn clear(&mut self) {
        unsafe { sys::inkcell_glyph_cache_clear(&mut self.raw) }
    }
}

/// What becomes of characters that fonts lack, by default the font's box, and
/// how texts went.
pub struct Report {
    raw: sys::inkcell_text_report_t,
}

impl Report {
    /// Draws another character; None: nothing.
    pub fn instead(mut self, character: Option<char>) -> Report {
        self.raw.instead = character.map_or(u32::MAX - 1, u32::from);
        self
    }

    /// Characters that were missing, and the first of them.
    pub fn missing(&self) -> (u32, Option<char>) {
        (self.raw.missing, char::from_u32(self.raw.first_missing))
    }

    /// The first thing that went wrong: no_glyph, cut, needs_shaping.
    pub fn status(&self) -> Result<(), Status> {
        Status::check(self.raw.status)
    }
}

impl Default for Report {
    fn default() -> Self {
        Report { raw: made(|out| unsafe { sys::inkcell_text_report_init(out) }) }
    }
}
