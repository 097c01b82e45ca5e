//! Where pixels go: strips in memory, sinks of your own, the loop over a
//! screen.
use crate::{made, sys, tried, Rect, Status};
use core::ffi::c_void;
use core::marker::PhantomData;
use core::slice;

/// Rows of the screen in RAM.
pub struct Strip<'a> {
    raw: sys::inkcell_strip_t,
    of: PhantomData<&'a mut [u8]>,
}

impl<'a> Strip<'a> {
    /// Rows without gaps, from the top left corner of the screen on.
    pub fn new(pixels: &'a mut [u8], width: u16, height: u16) -> Strip<'a> {
        let raw = sys::inkcell_strip_t {
            pixels: pixels.as_mut_ptr(),
            size: pixels.len(),
            x0: 0,
            y0: 0,
            width: width.into(),
            height: height.into(),
            stride: 0,
            order: sys::INKCELL_LOW_FIRST,
        };
        Strip { raw, of: PhantomData }
    }

    /// The place of the first pixel on the screen.
    pub fn at(mut self, x0: i32, y0: i32) -> Self {
        (self.raw.x0, self.raw.y0) = (x0, y0);
        self
    }

    /// The high byte of a pixel of RGB565 comes first, as displays take it.
    pub fn high_first(mut self) -> Self {
        self.raw.order = sys::INKCELL_HIGH_FIRST;
        self
    }

    /// The bytes.
    pub fn pixels(&self) -> &[u8] {
        unsafe { slice::from_raw_parts(self.raw.pixels, self.raw.size) }
    }

    /// The bytes, to draw a background.
    pub fn pixels_mut(&mut self) -> &mut [u8] {
        unsafe { slice::from_raw_parts_mut(self.raw.pixels, self.raw.size) }
    }

    /// The pixels of the screen that it holds.
    pub fn rect(&self) -> Rect {
        let sys::inkcell_strip_t { x0, y0, width, height, .. } = self.raw;
        Rect { x0, y0, x1: x0 + width, y1: y0 + height }
    }
}

/// Takes what is drawn.
pub struct Sink<'a> {
    pub(crate) raw: sys::inkcell_sink_t,
    of: PhantomData<&'a mut ()>,
}

/// A pixel format of your own, for [`Sink::of`].
pub trait Pixels {
    /// Pixels from (x, y) to the right, 1 to 32, each with its coverage, 0 to
    /// 255. Glyphs may overlap: blend over what is there.
    fn coverage(&mut self, x: i32, y: i32, coverage: &[u8]);
    /// `count` pixels of full coverage, any number from 1 on.
    fn solid(&mut self, x: i32, y: i32, count: i32);
}

impl<'a> Sink<'a> {
    /// A sink that calls `pixels`, for pixels of `window` and no others. The
    /// window is clamped to +-32767 px.
    pub fn of<P: Pixels>(pixels: &'a mut P, window: Rect) -> Sink<'a> {
        let within = |at: i32| at.clamp(-32767, 32767);
        let mut raw: sys::inkcell_sink_t = made(|_| ());
        raw.window = Rect {
            x0: within(window.x0),
            y0: within(window.y0),
            x1: within(window.x1),
            y1: within(window.y1),
        };
        raw.context = (pixels as *mut P).cast();
        raw.coverage = Some(coverage_of::<P>);
        raw.solid = Some(solid_of::<P>);
        Sink { raw, of: PhantomData }
    }

    /// Draws all pixels of the window.
    pub fn fill(&mut self) {
        unsafe { sys::inkcell_fill(&self.raw) }
    }
}

/// Code of C cannot unwind: a panic within a panic ends the program.
struct NoUnwind;

impl Drop for NoUnwind {
    fn drop(&mut self) {
        panic!("a panic in a function that is called from C");
    }
}

/// Calls a function on behalf of C.
fn from_c<T>(function: impl FnOnce() -> T) -> T {
    let guard = NoUnwind;
    let result = function();
    core::mem::forget(guard);
    result
}

unsafe extern "C" fn coverage_of<P: Pixels>(
    context: *mut c_void,
    x: i32,
    y: i32,
    coverage: *const u8,
    count: i32,
) {
    let coverage = slice::from_raw_parts(coverage, count as usize);
    from_c(|| (*context.cast::<P>()).coverage(x, y, coverage))
}

unsafe extern "C" fn solid_of<P: Pixels>(context: *mut c_void, x: i32, y: i32, count: i32) {
    from_c(|| (*context.cast::<P>()).solid(x, y, count))
}

macro_rules! targets {
    ($($(#[$doc:meta])* $name:ident $raw:ident $sink:ident $bits:literal
       ($($field:ident: $kind:ty),*);)*) => {$(
        $(#[$doc])*
        pub struct $name<'a> {
            raw: sys::$raw,
            of: PhantomData<&'a mut [u8]>,
        }

        impl<'a> $name<'a> {
            /// A strip and what is drawn into it.
            pub fn new(strip: Strip<'a>, $($field: $kind),*) -> Self {
                let mut strip = strip.raw;
                if strip.stride == 0 {
                    strip.stride = (strip.width * $bits + 7) / 8;
                }
                $name { raw: sys::$raw { strip, $($field),* }, of: PhantomData }
            }

            $(
                /// For what is drawn from now on.
                pub fn $field(&mut self, $field: $kind) -> &mut Self {
                    self.raw.$field = $field;
                    self
                }
            )*

            /// What draws there. Fails with bad_argument, buffer_small or
            /// misaligned.
            pub fn sink(&mut self) -> Result<Sink<'_>, Status> {
                let raw = tried(|out| unsafe { sys::$sink(&mut self.raw, out) })?;
                Ok(Sink { raw, of: PhantomData })
            }
        }
    )*};
}

targets! {
    /// Coverage itself, 8 bits, which only grows.
    A8 inkcell_a8_target_t inkcell_a8_sink 8 ();
    /// 256 levels.
    Grey8 inkcell_grey8_target_t inkcell_grey8_sink 8 (level: u8);
    /// 16 levels, two pixels a byte. `order`: `sys::INKCELL_HIGH_LEFT` or
    /// `INKCELL_LOW_LEFT`.
    Grey4 inkcell_grey4_target_t inkcell_grey4_sink 4 (level: u8, order: u8);
    /// 4 levels, four pixels a byte.
    Grey2 inkcell_grey2_target_t inkcell_grey2_sink 2 (level: u8, order: u8);
    /// 1 bit, eight pixels of a row a byte. `threshold`: the coverage that is
    /// drawn, 128. `level`: 1 sets bits, 0 clears them.
    MonoRows inkcell_mono_rows_target_t inkcell_mono_rows_sink 1
        (threshold: u8, level: u8, order: u8);
    /// 1 bit in pages, as SSD1306 takes them.
    MonoPages inkcell_mono_pages_target_t inkcell_mono_pages_sink 8
        (threshold: u8, level: u8);
    /// 5, 6 and 5 bits.
    Rgb565 inkcell_rgb565_target_t inkcell_rgb565_sink 16 (colour: u16);
    /// Three bytes a pixel, of 0xRRGGBB. `order`: `sys::INKCELL_RED_FIRST` or
    /// `INKCELL_BLUE_FIRST`.
    Rgb888 inkcell_rgb888_target_t inkcell_rgb888_sink 24
        (colour: u32, order: u8);
    /// Four bytes a pixel, at a multiple of 4.
    Xrgb8888 inkcell_xrgb8888_target_t inkcell_xrgb8888_sink 32 (colour: u32);
}

/// A screen that is drawn strip by strip.
pub struct Screen<'a> {
    /// Memory of a strip, of a row at least.
    pub buffer: &'a mut [u8],
    /// `sys::INKCELL_RGB565` and others.
    pub format: u8,
    /// Of RGB565: `sys::INKCELL_LOW_FIRST` or `INKCELL_HIGH_FIRST`.
    pub order: u8,
    /// \[px\]
    pub width: u16,
    /// \[px\]
    pub height: u16,
}

/// Calls `draw` and `flush` for the strips of `part`, or of the whole screen,
/// from top to bottom. `flush` returns when the strip is sent.
///
/// Fails with the first error of theirs, bad_argument or buffer_small.
pub fn run_strips<D, F>(
    screen: &mut Screen<'_>,
    part: Option<Rect>,
    mut draw: D,
    mut flush: F,
) -> Result<(), Status>
where
    D: FnMut(Strip<'_>) -> Result<(), Status>,
    F: FnMut(&Strip<'_>) -> Result<(), Status>,
{
    let mut flush_one = |strip: Strip<'_>| flush(&strip);
    let (draw_step, flush_step) = (step_of(&draw), step_of(&flush_one));
    let strips = sys::inkcell_strip_loop_t {
        buffer: screen.buffer.as_mut_ptr(),
        size: screen.buffer.len(),
        second: core::ptr::null_mut(),
        format: screen.format,
        order: screen.order,
        width: screen.width.into(),
        height: screen.height.into(),
        context: (&mut draw as *mut D).cast(),
        draw: Some(draw_step),
        display: (&mut flush_one as *mut _ as *mut c_void),
        flush: Some(flush_step),
        wait: None,
    };
    let part = part.as_ref().map_or(core::ptr::null(), |part| part);
    Status::check(unsafe { sys::inkcell_run_strips(&strips, part) })
}

type Step = unsafe extern "C" fn(*mut c_void, *const sys::inkcell_strip_t) -> u8;

/// A function of C that calls a closure of this type.
fn step_of<S: FnMut(Strip<'_>) -> Result<(), Status>>(_: &S) -> Step {
    step::<S>
}

unsafe extern "C" fn step<S: FnMut(Strip<'_>) -> Result<(), Status>>(
    context: *mut c_void,
    strip: *const sys::inkcell_strip_t,
) -> u8 {
    let strip = Strip { raw: *strip, of: PhantomData };
    let done = from_c(|| (*context.cast::<S>())(strip));
    done.map_or_else(Status::code, |()| sys::INKCELL_OK)
}
