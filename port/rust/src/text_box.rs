//! Paragraphs in boxes.
use crate::{made, sys, Font, Painter, Px, Rect, Status, Style};
use core::marker::PhantomData;

/// How lines stand across a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Align {
    /// Left; right where text begins at the right.
    Start = sys::INKCELL_ALIGN_START,
    /// Left.
    Left = sys::INKCELL_ALIGN_LEFT,
    /// In the middle.
    Centre = sys::INKCELL_ALIGN_CENTRE,
    /// Right.
    Right = sys::INKCELL_ALIGN_RIGHT,
    /// Both, but for the last line of a paragraph.
    Justify = sys::INKCELL_ALIGN_JUSTIFY,
}

/// How lines stand in the height of a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum VerticalAlign {
    /// At the top.
    Top = sys::INKCELL_VERTICAL_TOP,
    /// The lines in the middle.
    Middle = sys::INKCELL_VERTICAL_MIDDLE,
    /// The capitals in the middle.
    Optical = sys::INKCELL_VERTICAL_OPTICAL,
    /// At the bottom.
    Bottom = sys::INKCELL_VERTICAL_BOTTOM,
}

/// What shows that text was left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Ellipsis {
    /// Nothing.
    None = sys::INKCELL_ELLIPSIS_NONE,
    /// At the end.
    End = sys::INKCELL_ELLIPSIS_END,
    /// In the middle of text that does not wrap, else at the end.
    Middle = sys::INKCELL_ELLIPSIS_MIDDLE,
}

/// Text in a rectangle: wrapped, aligned, shortened.
#[derive(Clone, Copy)]
pub struct TextBox<'a> {
    raw: sys::inkcell_text_box_t,
    of: PhantomData<(&'a Font<'a>, &'a Style<'a>)>,
}

/// Memory of a line that [`TextBox::lay_out`] finds.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct Line(sys::inkcell_text_line_t);

/// A text and its lines.
#[derive(Clone, Copy)]
pub struct Lines<'l> {
    text: &'l str,
    lines: &'l [Line],
}

impl<'a> TextBox<'a> {
    /// At the top and the start of `rect`, wrapped.
    pub fn new(font: &'a Font<'a>, style: &'a Style<'a>, rect: Rect) -> Self {
        let (font, style) = (&font.raw, &style.raw);
        let raw = made(|out| unsafe { sys::inkcell_text_box_init(out, font, style, &rect) });
        TextBox { raw, of: PhantomData }
    }

    /// Across the box.
    pub fn align(mut self, align: Align) -> Self {
        self.raw.options.align = align as u8;
        self
    }

    /// In its height.
    pub fn vertical(mut self, align: VerticalAlign) -> Self {
        self.raw.vertical = align as u8;
        self
    }

    /// Of text that has no room.
    pub fn ellipsis(mut self, ellipsis: Ellipsis) -> Self {
        self.raw.options.ellipsis = ellipsis as u8;
        self
    }

    /// Whether lines wrap.
    pub fn wraps(mut self, wraps: bool) -> Self {
        self.raw.options.wraps = wraps;
        self
    }

    /// From one baseline to the next; 0 is that of the font.
    pub fn line_height(mut self, height: impl Into<Px>) -> Self {
        self.raw.options.line_height_q6 = height.into().q6();
        self
    }

    /// Finds the lines. Fails with buffer_small if there are more than `out`
    /// has room for.
    pub fn lay_out<'l>(
        &self,
        painter: &mut Painter<'_>,
        text: &'l str,
        out: &'l mut [Line],
    ) -> Result<Lines<'l>, Status> {
        let mut count = 0;
        let (bytes, size) = (text.as_ptr(), text.len());
        let (room, capacity) = (out.as_mut_ptr().cast(), out.len());
        let (box_, painter) = (&self.raw, &painter.raw);
        Status::check(unsafe {
            sys::inkcell_text_box_lay_out(box_, painter, bytes, size, room, capacity, &mut count)
        })?;
        Ok(Lines { text, lines: &out[..count] })
    }

    /// Draws lines that this box found.
    pub fn draw(&self, painter: &mut Painter<'_>, lines: &Lines<'_>) {
        let (bytes, size) = (lines.text.as_ptr(), lines.text.len());
        let (first, count) = (lines.lines.as_ptr().cast(), lines.lines.len());
        unsafe { sys::inkcell_text_box_draw(&self.raw, &painter.raw, bytes, size, first, count) }
    }
}

impl Line {
    /// For arrays: `[Line::EMPTY; 8]`.
    pub const EMPTY: Line = Line(unsafe {
        core::mem::transmute([0u8; core::mem::size_of::<sys::inkcell_text_line_t>()])
    });
}
