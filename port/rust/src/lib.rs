//! Scalable, antialiased type for microcontrollers: one font in ROM draws every
//! size. Without std, without alloc.
//!
//! ```no_run
//! use inkcell::{Filter, Font, Grey8, Painter, Status, Strip, Style};
//!
//! fn draw(rom: &[u8], pixels: &mut [u8]) -> Result<(), Status> {
//!     let font = Font::open(rom)?;
//!     let style = Style::new(24, Filter::area())?;
//!     let mut grey = Grey8::new(Strip::new(pixels, 128, 32), 255);
//!     let mut sink = grey.sink()?;
//!     Painter::new(&mut sink).text(&font, "Hello", &style, 4, 24);
//!     Ok(())
//! }
//! ```
//!
//! Memory is the caller's: lifetimes say what must outlive what. Coordinates
//! are px, x to the right and y down; the origin of a text is the left end of
//! its baseline. Drawing clips to the sink and cannot fail. Fonts are safe with
//! any bytes. [`sys`] has all functions of the interface for C.
#![no_std]
#![warn(missing_docs)]

mod font;
#[cfg(feature = "embedded-graphics")]
pub mod graphics;
mod painter;
mod sink;
mod style;
mod text_box;

pub use font::{Aligned, Font, FontMetrics};
pub use painter::{Cache, Measure, Painter, Report};
pub use sink::{
    run_strips, Grey2, Grey4, Grey8, MonoPages, MonoRows, Pixels, Rgb565, Rgb888, Screen, Sink,
    Strip, Xrgb8888, A8,
};
pub use style::{Filter, FilterTable, Fit, Style};
pub use text_box::{Align, Ellipsis, Line, Lines, TextBox, VerticalAlign};

/// Declarations of the interface for C, made from its tables.
#[allow(non_camel_case_types, missing_docs)]
pub mod sys {
    include!(concat!(env!("OUT_DIR"), "/sys.rs"));
}

/// Why a call failed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Status(pub(crate) u8);

impl Status {
    /// Of a number, such as `sys::INKCELL_READ_FAILED`.
    pub const fn new(code: u8) -> Status {
        Status(code)
    }

    /// The number, which never changes: `sys::INKCELL_CORRUPT` and others.
    pub fn code(self) -> u8 {
        self.0
    }

    fn check(code: u8) -> Result<(), Status> {
        (code == sys::INKCELL_OK).then_some(()).ok_or(Status(code))
    }
}

/// A plain object that C fills in; all zero before.
fn made<T: Copy>(make: impl FnOnce(*mut T)) -> T {
    // Types of C: numbers, pointers and pointers to functions, which may be 0.
    let mut out = unsafe { core::mem::zeroed() };
    make(&mut out);
    out
}

/// The same, of a function of C that may fail.
fn tried<T: Copy>(make: impl FnOnce(*mut T) -> u8) -> Result<T, Status> {
    let mut code = sys::INKCELL_OK;
    let out = made(|out| code = make(out));
    Status::check(code).map(|()| out)
}

impl core::fmt::Debug for Status {
    fn fmt(&self, to: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        to.write_str(string(unsafe { sys::inkcell_status_name(self.0) }))
    }
}

/// Text of the library, which ends at its zero byte.
fn string<'a>(text: *const u8) -> &'a str {
    let mut size = 0;
    while unsafe { *text.add(size) } != 0 {
        size += 1;
    }
    let bytes = unsafe { core::slice::from_raw_parts(text, size) };
    core::str::from_utf8(bytes).unwrap_or("")
}

/// A length in px, in 64ths. Whole px are `5.into()`; functions take both.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Px(i32);

impl Px {
    /// 64ths of a px.
    pub const fn from_q6(q6: i32) -> Px {
        Px(q6)
    }
    /// In 64ths of a px.
    pub const fn q6(self) -> i32 {
        self.0
    }
    /// To the nearest whole px.
    pub const fn round(self) -> i32 {
        (self.0 >> 6) + (self.0 >> 5 & 1)
    }
}

impl From<i32> for Px {
    fn from(px: i32) -> Px {
        Px(px.saturating_mul(64))
    }
}

/// Pixels of the screen: x0 <= x < x1, y0 <= y < y1.
pub type Rect = sys::inkcell_rect_t;
