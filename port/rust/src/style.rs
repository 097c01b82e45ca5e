//! How text looks: filter, size, direction, grid fitting.
use crate::{made, sys, tried, Font, Px, Status};
use core::marker::PhantomData;

/// From the distance to an edge to coverage.
#[derive(Clone, Copy)]
pub struct Filter<'a> {
    raw: sys::inkcell_filter_t,
    of: PhantomData<&'a FilterTable>,
}

macro_rules! presets {
    ($($(#[$doc:meta])* $name:ident $preset:ident)*) => {$(
        $(#[$doc])*
        pub fn $name() -> Filter<'static> {
            Filter { raw: unsafe { sys::$preset }, of: PhantomData }
        }
    )*};
}

impl<'a> Filter<'a> {
    presets! {
        /// Exact coverage.
        area inkcell_filter_area
        /// -0.5 to 0.5 px: right weight at text sizes.
        text inkcell_filter_text
        /// -0.6 to 0.625 px: calm, for type that moves.
        motion inkcell_filter_motion
    }

    /// The same with edges moved outwards by `weight_q10` / 1024 px; inwards if
    /// negative. Of area: that of text.
    pub fn with_weight(self, weight_q10: i16, table: &'a mut FilterTable) -> Filter<'a> {
        table.fill(|raw, out| unsafe {
            sys::inkcell_filter_with_weight(&self.raw, weight_q10, raw, out)
        })
    }

    /// A soft edge from `reach_q10` / 1024 px outside, up to 4 px, to as far
    /// inside.
    pub fn shadow(reach_q10: i16, table: &'a mut FilterTable) -> Filter<'a> {
        table.fill(|raw, out| unsafe { sys::inkcell_filter_shadow(reach_q10, raw, out) })
    }
}

/// Memory of a filter that is made at run time: 268 bytes.
pub struct FilterTable(sys::inkcell_filter_table_t);

impl FilterTable {
    fn fill<'a>(
        &'a mut self,
        make: impl FnOnce(*mut sys::inkcell_filter_table_t, *mut sys::inkcell_filter_t),
    ) -> Filter<'a> {
        Filter { raw: made(|out| make(&mut self.0, out)), of: PhantomData }
    }
}

impl Default for FilterTable {
    fn default() -> Self {
        FilterTable(made(|_| ()))
    }
}

/// Size, direction, filter, fitting and effect.
#[derive(Clone, Copy)]
pub struct Style<'a> {
    pub(crate) raw: sys::inkcell_style_t,
    of: PhantomData<Filter<'a>>,
}

// Nothing changes a style that is shared.
unsafe impl Send for Style<'_> {}
unsafe impl Sync for Style<'_> {}

impl<'a> Style<'a> {
    /// An upright style of 4 to 1024 px to the em: else bad_argument.
    pub fn new(size: impl Into<Px>, filter: Filter<'a>) -> Result<Self, Status> {
        Self::make(|out| unsafe { sys::inkcell_style_make(size.into().q6(), &filter.raw, out) })
    }

    /// The same, turned counter-clockwise by the angle of this cosine and sine,
    /// which are multiplied by 2^30.
    pub fn turned(
        size: impl Into<Px>,
        filter: Filter<'a>,
        cosine_q30: i32,
        sine_q30: i32,
    ) -> Result<Self, Status> {
        Self::make(|out| unsafe {
            let size = size.into().q6();
            let filter = &filter.raw;
            sys::inkcell_style_make_turned(size, filter, cosine_q30, sine_q30, out)
        })
    }

    /// Of the size at which capitals are `height` high.
    pub fn for_cap_height(font: &Font<'_>, height: impl Into<Px>, filter: Filter<'a>) -> Self {
        let (font, height) = (&font.raw, height.into().q6());
        let raw = made(|out| unsafe {
            sys::inkcell_style_for_cap_height(font, height, &filter.raw, out)
        });
        Style { raw, of: PhantomData }
    }

    fn make(make: impl FnOnce(*mut sys::inkcell_style_t) -> u8) -> Result<Self, Status> {
        Ok(Style { raw: tried(make)?, of: PhantomData })
    }

    /// Fits glyphs to the grid of pixels, if the style is upright.
    pub fn set_fit(&mut self, fit: &'a Fit<'a>) {
        unsafe { sys::inkcell_style_set_fit(&mut self.raw, &fit.raw) }
    }

    /// Fits text for displays of 2 levels, or of 4, as painters of sinks of 1
    /// and 2 bits do by themselves.
    pub fn fit_levels(&mut self, levels: u8) {
        unsafe { sys::inkcell_style_fit_levels(&mut self.raw, levels) }
    }

    /// Glyphs stay as designed, also on sinks of 1 and 2 bits.
    pub fn clear_fit(&mut self) {
        unsafe { sys::inkcell_style_clear_fit(&mut self.raw) }
    }
}

/// A font's hints at one size.
pub struct Fit<'rom> {
    raw: sys::inkcell_fit_t,
    of: PhantomData<Font<'rom>>,
}

impl<'rom> Fit<'rom> {
    /// For styles of this size and glyphs of this font. `across`: stems and
    /// advances are whole pixels, too. `levels` of the display: 0, many; 2 or
    /// 4. Fails with corrupt or bad_argument.
    pub fn new(
        font: &Font<'rom>,
        style: &Style<'_>,
        across: bool,
        levels: u8,
    ) -> Result<Self, Status> {
        let (font, style) = (&font.raw, &style.raw);
        let raw =
            tried(|out| unsafe { sys::inkcell_fit_make(font, style, across, levels, 256, out) })?;
        Ok(Fit { raw, of: PhantomData })
    }
}
