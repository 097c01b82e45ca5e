//! Fonts in ROM.
use crate::{made, sys, tried, Status};
use core::marker::PhantomData;

/// Bytes at a multiple of 4, where a font must lie.
#[repr(C, align(4))]
pub struct Aligned<T: ?Sized>(pub T);

/// A font of a file, which `inkcell-fontgen --format bin` made, as a
/// `&'static [u8]` at a multiple of 4. The path is that of `include_bytes!`.
#[macro_export]
macro_rules! include_font {
    ($path:expr $(,)?) => {{
        static ROM: &$crate::Aligned<[u8]> = &$crate::Aligned(*include_bytes!($path));
        &ROM.0
    }};
}

/// A view of a font in read-only memory.
#[derive(Clone, Copy)]
pub struct Font<'rom> {
    pub(crate) raw: sys::inkcell_font_t,
    of: PhantomData<&'rom [u8]>,
}

// Nothing changes a font: any number of tasks may read one.
unsafe impl Send for Font<'_> {}
unsafe impl Sync for Font<'_> {}

/// Measures of a font in font units, y up.
pub type FontMetrics = sys::inkcell_font_metrics_t;

impl<'rom> Font<'rom> {
    /// Opens a font of outlines, in constant time. Its address is a multiple of
    /// 4: [`include_font!`](crate::include_font).
    ///
    /// Fails with bad_magic, bad_version, misaligned, corrupt or unsupported.
    pub fn open(rom: &'rom [u8]) -> Result<Font<'rom>, Status> {
        let (bytes, size) = (rom.as_ptr().cast(), rom.len());
        let raw = tried(|out| unsafe { sys::inkcell_font_open(bytes, size, out) })?;
        Ok(Font { raw, of: PhantomData })
    }

    /// Measures of the font.
    pub fn metrics(&self) -> FontMetrics {
        made(|out| unsafe { sys::inkcell_font_metrics(&self.raw, out) })
    }

    /// Whether the font has a glyph for a character.
    pub fn has(&self, character: char) -> bool {
        let code = character.into();
        tried(|out| unsafe { sys::inkcell_font_glyph_of(&self.raw, code, out) }).is_ok()
    }
}
