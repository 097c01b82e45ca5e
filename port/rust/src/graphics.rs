//! Text of [`embedded_graphics`]: a font and a style as a `TextRenderer`.
use crate::{made, sys, Font, Painter, Px, Strip, Style, A8};
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::*;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::text::renderer::{CharacterStyle, TextMetrics, TextRenderer};
use embedded_graphics::text::Baseline;

/// A colour that can lie over another in part.
pub trait Blend: PixelColor {
    /// `self` over `behind`, of which `coverage` / 255 is covered.
    fn blend(self, behind: Self, coverage: u8) -> Self;
}

fn mix(over: u8, behind: u8, coverage: u8) -> u8 {
    let coverage = u32::from(coverage);
    let sum = coverage * u32::from(over) + (255 - coverage) * u32::from(behind);
    ((sum + 127) / 255) as u8
}

/// In 32nds, as the sink of RGB565 does.
fn mix_32(over: u8, behind: u8, coverage: u8) -> u8 {
    let share = (i32::from(coverage) + 4) >> 3;
    let (over, behind) = (i32::from(over), i32::from(behind));
    (((over - behind) * share + (behind << 5) + 16) >> 5) as u8
}

macro_rules! blend {
    ($mix:ident: $($name:ident)*) => {$(
        impl Blend for $name {
            fn blend(self, behind: Self, coverage: u8) -> Self {
                $name::new(
                    $mix(self.r(), behind.r(), coverage),
                    $mix(self.g(), behind.g(), coverage),
                    $mix(self.b(), behind.b(), coverage),
                )
            }
        }
    )*};
    ($($name:ident)*) => {$(
        impl Blend for $name {
            fn blend(self, behind: Self, coverage: u8) -> Self {
                $name::new(mix(self.luma(), behind.luma(), coverage))
            }
        }
    )*};
}

blend!(mix_32: Rgb565 Bgr565);
blend!(mix: Rgb555 Bgr555 Rgb666 Bgr666 Rgb888 Bgr888);
blend!(Gray2 Gray4 Gray8);

impl Blend for BinaryColor {
    fn blend(self, behind: Self, coverage: u8) -> Self {
        if coverage < 128 {
            behind
        } else {
            self
        }
    }
}

/// How `Text` is drawn. Its baseline is the lower edge of the row of the
/// position, as that of the mono fonts.
///
/// Edges are blended with what is known to be behind the text: a colour that is
/// there, [`over`](TextStyle::over), or one that is drawn with it,
/// `background`. With neither a pixel is drawn that is covered by half; fit the
/// style to 2 levels then, as for `BinaryColor`: [`Style::fit_levels`].
///
/// `BYTES` of the stack, at least 64, hold coverage: glyphs that they do not
/// hold whole are drawn more than once.
#[derive(Clone, Copy)]
pub struct TextStyle<'a, C, const BYTES: usize = 1024> {
    font: &'a Font<'a>,
    style: &'a Style<'a>,
    colour: Option<C>,
    over: Option<C>,
    background: Option<C>,
}

impl<'a, C: Blend> TextStyle<'a, C> {
    /// Text of one colour.
    pub fn new(font: &'a Font<'a>, style: &'a Style<'a>, colour: C) -> Self {
        let colour = Some(colour);
        TextStyle { font, style, colour, over: None, background: None }
    }
}

impl<'a, C: Blend, const BYTES: usize> TextStyle<'a, C, BYTES> {
    /// The colour that is already behind the text.
    pub fn over(mut self, colour: C) -> Self {
        self.over = Some(colour);
        self
    }

    /// Fills lines with a colour, too.
    pub fn background(mut self, colour: C) -> Self {
        self.background = Some(colour);
        self
    }

    /// With another number of bytes for coverage.
    pub fn bytes<const OTHER: usize>(self) -> TextStyle<'a, C, OTHER> {
        let TextStyle { font, style, colour, over, background } = self;
        TextStyle { font, style, colour, over, background }
    }

    /// From the top of a line to its baseline, and to its lower edge. [px]
    fn line(&self) -> (i32, i32) {
        let (font, style) = (&self.font.raw, &self.style.raw);
        let options = made(|out| unsafe { sys::inkcell_layout_options_init(out, font, style) });
        let baseline = Px::from_q6(unsafe { sys::inkcell_baseline(&options) });
        let height = Px::from_q6(unsafe { sys::inkcell_line_height(&options) });
        (baseline.round(), height.round())
    }

    /// The top row of a line.
    fn top(&self, position: Point, baseline: Baseline) -> i32 {
        let (ascent, height) = self.line();
        position.y
            - match baseline {
                Baseline::Top => 0,
                Baseline::Bottom => height - 1,
                Baseline::Middle => (height - 1) / 2,
                Baseline::Alphabetic => ascent - 1,
            }
    }

    fn line_box(&self, x: i32, top: i32, width: u32) -> Rectangle {
        let height = self.line().1.max(0) as u32;
        Rectangle::new(Point::new(x, top), Size::new(width, height))
    }

    fn advance(&self, text: &str) -> i32 {
        Painter::none().measure(self.font, text, self.style).advance.round()
    }

    /// The colour of a pixel, if it is drawn.
    fn pixel(&self, coverage: u8, is_in_line: bool) -> Option<C> {
        let background = self.background.filter(|_| is_in_line);
        let behind = background.or(self.over).or(self.background);
        match (self.colour, behind) {
            (_, _) if coverage == 0 => background,
            (Some(colour), Some(behind)) => Some(colour.blend(behind, coverage)),
            (Some(colour), None) if coverage >= 128 => Some(colour),
            _ => background,
        }
    }

    /// Draws one tile of a text, whose coverage is given: runs of pixels.
    fn send<D: DrawTarget<Color = C>>(
        &self,
        tile: &Rectangle,
        coverage: &[u8],
        line: &Rectangle,
        target: &mut D,
    ) -> Result<(), D::Error> {
        let Size { width, height } = tile.size;
        let pixels = |row: u32| {
            let begin = (row * width) as usize;
            let coverage = &coverage[begin..begin + width as usize];
            let origin = tile.top_left + Point::new(0, row as i32);
            (0..width as i32).map(move |x| {
                let at = origin + Point::new(x, 0);
                self.pixel(coverage[x as usize], line.contains(at))
            })
        };
        for row in 0..height {
            let mut x = 0;
            while x < width {
                let run = || pixels(row).skip(x as usize);
                let count = run().take_while(Option::is_some).count() as u32;
                if count != 0 {
                    let at = Point::new(x as i32, row as i32);
                    let area = Rectangle::new(tile.top_left + at, Size::new(count, 1));
                    target.fill_contiguous(&area, run().map_while(|p| p))?;
                }
                x += count + 1;
            }
        }
        Ok(())
    }
}

impl<C: Blend, const BYTES: usize> TextRenderer for TextStyle<'_, C, BYTES> {
    type Color = C;

    fn draw_string<D: DrawTarget<Color = C>>(
        &self,
        text: &str,
        position: Point,
        baseline: Baseline,
        target: &mut D,
    ) -> Result<Point, D::Error> {
        let advance = self.advance(text);
        let top = self.top(position, baseline);
        let line = self.line_box(position.x, top, advance.max(0) as u32);
        let y = top + self.line().0;
        let ink = Painter::none().ink(self.font, text, self.style, position.x, y);
        let size = Size::new((ink.x1 - ink.x0) as u32, (ink.y1 - ink.y0) as u32);
        let mut all = Rectangle::new(Point::new(ink.x0, ink.y0), size);
        if self.background.is_some() {
            all = hull(&all, &line);
        }
        let all = all.intersection(&target.bounding_box());
        let Size { width, height } = all.size;
        let rows = height.min(BYTES as u32 / 8).max(1);
        let columns = width.min(BYTES as u32 / rows).max(1);
        for y0 in (0..height).step_by(rows as usize) {
            for x0 in (0..width).step_by(columns as usize) {
                let at = Point::new(x0 as i32, y0 as i32);
                let tile = Rectangle::new(
                    all.top_left + at,
                    Size::new(columns.min(width - x0), rows.min(height - y0)),
                );
                let mut coverage = [0; BYTES];
                let Size { width, height } = tile.size;
                let strip = Strip::new(&mut coverage, width as u16, height as u16)
                    .at(tile.top_left.x, tile.top_left.y);
                if let Ok(mut sink) = A8::new(strip).sink() {
                    Painter::new(&mut sink).text(self.font, text, self.style, position.x, y);
                }
                self.send(&tile, &coverage, &line, target)?;
            }
        }
        Ok(position + Point::new(advance, 0))
    }

    fn draw_whitespace<D: DrawTarget<Color = C>>(
        &self,
        width: u32,
        position: Point,
        baseline: Baseline,
        target: &mut D,
    ) -> Result<Point, D::Error> {
        if let Some(background) = self.background {
            let top = self.top(position, baseline);
            let line = self.line_box(position.x, top, width);
            target.fill_solid(&line, background)?;
        }
        Ok(position + Point::new(width as i32, 0))
    }

    fn measure_string(&self, text: &str, position: Point, baseline: Baseline) -> TextMetrics {
        let advance = self.advance(text);
        let top = self.top(position, baseline);
        TextMetrics {
            bounding_box: self.line_box(position.x, top, advance.max(0) as u32),
            next_position: position + Point::new(advance, 0),
        }
    }

    fn line_height(&self) -> u32 {
        self.line().1.max(0) as u32
    }
}

impl<C: Blend, const BYTES: usize> CharacterStyle for TextStyle<'_, C, BYTES> {
    type Color = C;

    fn set_text_color(&mut self, colour: Option<C>) {
        self.colour = colour;
    }

    fn set_background_color(&mut self, colour: Option<C>) {
        self.background = colour;
    }
}

/// The smallest rectangle that holds both; an empty one adds nothing.
fn hull(a: &Rectangle, b: &Rectangle) -> Rectangle {
    match (a.bottom_right(), b.bottom_right()) {
        (Some(end), Some(other)) => {
            Rectangle::with_corners(a.top_left.component_min(b.top_left), end.component_max(other))
        }
        (None, _) => *b,
        _ => *a,
    }
}
