//! What the test needs of embedded-graphics, where its sources are not given.
#![no_std]

pub mod geometry {
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Point {
        pub x: i32,
        pub y: i32,
    }
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Size {
        pub width: u32,
        pub height: u32,
    }
    impl Point {
        pub fn new(x: i32, y: i32) -> Self {
            Point { x, y }
        }
        pub fn component_min(self, other: Self) -> Self {
            Point { x: self.x.min(other.x), y: self.y.min(other.y) }
        }
        pub fn component_max(self, other: Self) -> Self {
            Point { x: self.x.max(other.x), y: self.y.max(other.y) }
        }
    }
    impl core::ops::Add for Point {
        type Output = Point;
        fn add(self, other: Point) -> Point {
            Point { x: self.x + other.x, y: self.y + other.y }
        }
    }
    impl Size {
        pub fn new(width: u32, height: u32) -> Self {
            Size { width, height }
        }
    }
    pub trait OriginDimensions {
        fn size(&self) -> Size;
    }
    pub trait Dimensions {
        fn bounding_box(&self) -> crate::primitives::Rectangle;
    }
    impl<T: OriginDimensions> Dimensions for T {
        fn bounding_box(&self) -> crate::primitives::Rectangle {
            crate::primitives::Rectangle::new(Point::new(0, 0), self.size())
        }
    }
}

pub mod primitives {
    use crate::geometry::{Point, Size};
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Rectangle {
        pub top_left: Point,
        pub size: Size,
    }
    impl Rectangle {
        pub fn new(top_left: Point, size: Size) -> Self {
            Rectangle { top_left, size }
        }
        pub fn with_corners(a: Point, b: Point) -> Self {
            let (from, to) = (a.component_min(b), a.component_max(b));
            let size = Size::new((to.x - from.x) as u32 + 1, (to.y - from.y) as u32 + 1);
            Rectangle::new(from, size)
        }
        pub fn bottom_right(&self) -> Option<Point> {
            let Size { width, height } = self.size;
            (width > 0 && height > 0)
                .then(|| self.top_left + Point::new(width as i32 - 1, height as i32 - 1))
        }
        pub fn contains(&self, at: Point) -> bool {
            let end = self.top_left + Point::new(self.size.width as i32, self.size.height as i32);
            (self.top_left.x..end.x).contains(&at.x) && (self.top_left.y..end.y).contains(&at.y)
        }
        pub fn intersection(&self, other: &Self) -> Self {
            match (self.bottom_right(), other.bottom_right()) {
                (Some(a), Some(b)) => {
                    let from = self.top_left.component_max(other.top_left);
                    let to = a.component_min(b);
                    if from.x > to.x || from.y > to.y {
                        return Rectangle::new(from, Size::new(0, 0));
                    }
                    Rectangle::with_corners(from, to)
                }
                _ => Rectangle::new(self.top_left, Size::new(0, 0)),
            }
        }
        pub fn points(&self) -> impl Iterator<Item = Point> {
            let Rectangle { top_left, size } = *self;
            (0..size.height as i32)
                .flat_map(move |y| (0..size.width as i32).map(move |x| top_left + Point::new(x, y)))
        }
    }
}

pub mod pixelcolor {
    pub trait PixelColor: Copy + PartialEq {}
    pub trait RgbColor: PixelColor {
        const BLACK: Self;
        const WHITE: Self;
        fn r(&self) -> u8;
        fn g(&self) -> u8;
        fn b(&self) -> u8;
    }
    pub trait GrayColor: PixelColor {
        fn luma(&self) -> u8;
    }
    macro_rules! rgb {
        ($($name:ident $r:literal $g:literal $b:literal)*) => {$(
            #[derive(Clone, Copy, Debug, PartialEq, Eq)]
            pub struct $name(u8, u8, u8);
            impl $name {
                pub const fn new(r: u8, g: u8, b: u8) -> Self {
                    $name(r & $r, g & $g, b & $b)
                }
            }
            impl PixelColor for $name {}
            impl RgbColor for $name {
                const BLACK: Self = $name::new(0, 0, 0);
                const WHITE: Self = $name::new(255, 255, 255);
                fn r(&self) -> u8 {
                    self.0
                }
                fn g(&self) -> u8 {
                    self.1
                }
                fn b(&self) -> u8 {
                    self.2
                }
            }
        )*};
    }
    rgb!(Rgb565 31 63 31 Bgr565 31 63 31 Rgb555 31 31 31 Bgr555 31 31 31);
    rgb!(Rgb666 63 63 63 Bgr666 63 63 63 Rgb888 255 255 255 Bgr888 255 255 255);
    impl Rgb565 {
        pub fn into_storage(self) -> u16 {
            u16::from(self.0) << 11 | u16::from(self.1) << 5 | u16::from(self.2)
        }
    }
    macro_rules! grey {
        ($($name:ident)*) => {$(
            #[derive(Clone, Copy, Debug, PartialEq, Eq)]
            pub struct $name(u8);
            impl $name {
                pub const fn new(luma: u8) -> Self {
                    $name(luma)
                }
            }
            impl PixelColor for $name {}
            impl GrayColor for $name {
                fn luma(&self) -> u8 {
                    self.0
                }
            }
        )*};
    }
    grey!(Gray2 Gray4 Gray8);
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum BinaryColor {
        Off,
        On,
    }
    impl PixelColor for BinaryColor {}
    impl BinaryColor {
        pub fn is_on(self) -> bool {
            self == BinaryColor::On
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub struct Pixel<C>(pub geometry::Point, pub C);

pub mod draw_target {
    use crate::primitives::Rectangle;
    pub trait DrawTarget: crate::geometry::Dimensions {
        type Color: crate::pixelcolor::PixelColor;
        type Error;
        fn draw_iter<I: IntoIterator<Item = crate::Pixel<Self::Color>>>(
            &mut self,
            pixels: I,
        ) -> Result<(), Self::Error>;
        fn fill_contiguous<I: IntoIterator<Item = Self::Color>>(
            &mut self,
            area: &Rectangle,
            colours: I,
        ) -> Result<(), Self::Error> {
            self.draw_iter(area.points().zip(colours).map(|(at, c)| crate::Pixel(at, c)))
        }
        fn fill_solid(&mut self, area: &Rectangle, colour: Self::Color) -> Result<(), Self::Error> {
            self.fill_contiguous(area, core::iter::repeat(colour))
        }
    }
}

pub mod text {
    use crate::{draw_target::DrawTarget, geometry::Point};
    #[derive(Clone, Copy)]
    pub enum Baseline {
        Top,
        Bottom,
        Middle,
        Alphabetic,
    }
    pub mod renderer {
        use super::*;
        use crate::primitives::Rectangle;
        pub struct TextMetrics {
            pub bounding_box: Rectangle,
            pub next_position: Point,
        }
        pub trait TextRenderer {
            type Color: crate::pixelcolor::PixelColor;
            fn draw_string<D: DrawTarget<Color = Self::Color>>(
                &self,
                text: &str,
                position: Point,
                baseline: Baseline,
                target: &mut D,
            ) -> Result<Point, D::Error>;
            fn draw_whitespace<D: DrawTarget<Color = Self::Color>>(
                &self,
                width: u32,
                position: Point,
                baseline: Baseline,
                target: &mut D,
            ) -> Result<Point, D::Error>;
            fn measure_string(
                &self,
                text: &str,
                position: Point,
                baseline: Baseline,
            ) -> TextMetrics;
            fn line_height(&self) -> u32;
        }
        pub trait CharacterStyle: Clone {
            type Color: crate::pixelcolor::PixelColor;
            fn set_text_color(&mut self, _: Option<Self::Color>) {}
            fn set_background_color(&mut self, _: Option<Self::Color>) {}
        }
    }
    pub struct Text<'t, S> {
        text: &'t str,
        position: Point,
        style: S,
    }
    impl<'t, S: renderer::TextRenderer> Text<'t, S> {
        pub fn new(text: &'t str, position: Point, style: S) -> Self {
            Text { text, position, style }
        }
    }
    impl<S: renderer::TextRenderer> crate::Drawable for Text<'_, S> {
        type Color = S::Color;
        type Output = Point;
        fn draw<D: DrawTarget<Color = S::Color>>(&self, to: &mut D) -> Result<Point, D::Error> {
            let mut at = self.position;
            let mut next = at;
            for line in self.text.split('\n') {
                next = self.style.draw_string(line, at, Baseline::Alphabetic, to)?;
                at.y += self.style.line_height() as i32;
            }
            Ok(next)
        }
    }
}

pub trait Drawable {
    type Color: pixelcolor::PixelColor;
    type Output;
    fn draw<D: draw_target::DrawTarget<Color = Self::Color>>(
        &self,
        target: &mut D,
    ) -> Result<Self::Output, D::Error>;
}

pub mod prelude {
    pub use crate::draw_target::DrawTarget;
    pub use crate::geometry::{Dimensions, OriginDimensions, Point, Size};
    pub use crate::pixelcolor::{GrayColor, PixelColor, RgbColor};
    pub use crate::{Drawable, Pixel};
}
