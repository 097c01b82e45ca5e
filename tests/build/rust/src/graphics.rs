//! Text of embedded-graphics on a display of its own.
use embedded_graphics::{
    draw_target::DrawTarget,
    pixelcolor::{BinaryColor, Gray8, Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
    text::{renderer::CharacterStyle, renderer::TextRenderer, Baseline, Text},
};
use inkcell::graphics::TextStyle;
use inkcell::{Filter, Font, Status, Style};
use std::convert::Infallible;

const WIDTH: usize = 96;
const HEIGHT: usize = 56;

struct Display<C> {
    pixels: Vec<C>,
    calls: usize,
}

impl<C: PixelColor> Display<C> {
    fn new(colour: C) -> Self {
        Display { pixels: vec![colour; WIDTH * HEIGHT], calls: 0 }
    }
}

impl<C> OriginDimensions for Display<C> {
    fn size(&self) -> Size {
        Size::new(WIDTH as u32, HEIGHT as u32)
    }
}

impl<C: PixelColor> DrawTarget for Display<C> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<C>>,
    {
        for Pixel(at, colour) in pixels {
            if self.bounding_box().contains(at) {
                self.pixels[at.y as usize * WIDTH + at.x as usize] = colour;
            }
        }
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colours: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = C>,
    {
        self.calls += 1;
        let count = (area.size.width * area.size.height) as usize;
        let colours: Vec<C> = colours.into_iter().collect();
        assert_eq!(colours.len(), count, "pixels of {area:?}");
        let at = area.points().zip(colours).map(|(at, c)| Pixel(at, c));
        self.draw_iter(at)
    }
}

/// What every part of the display has been asked for once, as bytes.
pub fn all(font: &Font<'_>) -> Result<Vec<u8>, Status> {
    let mut bytes = Vec::new();
    let mut put565 = |display: Display<Rgb565>| {
        for pixel in display.pixels {
            bytes.extend(pixel.into_storage().to_le_bytes());
        }
    };
    let mut greeting = Display::new(Rgb565::BLACK);
    inkcell_example::greet(&mut greeting).unwrap();
    put565(greeting);

    // Over a colour, of tiles of any size: the same picture.
    let style = Style::new(30, Filter::area())?;
    let mut pictures = Vec::new();
    let navy = Rgb565::new(1, 2, 12);
    let own = TextStyle::new(font, &style, Rgb565::new(31, 50, 0)).over(navy);
    let at = Point::new(-3, 40);
    for tiny in [false, true] {
        let mut display = Display::new(navy);
        let next = if tiny {
            Text::new("Wave 0", at, own.bytes::<64>()).draw(&mut display)
        } else {
            Text::new("Wave 0", at, own).draw(&mut display)
        };
        println!("next {}", next.unwrap().x);
        pictures.push(display.pixels);
    }
    println!("tiles equal {}", pictures[0] == pictures[1]);
    put565(Display { pixels: pictures.remove(0), calls: 0 });

    // With a background, which fills the line and no more.
    let mut filled = own;
    filled.set_background_color(Some(navy));
    let mut display = Display::new(Rgb565::new(20, 40, 20));
    let metrics = own.measure_string("Line", Point::new(8, 4), Baseline::Top);
    filled.draw_string("Line", Point::new(8, 4), Baseline::Top, &mut display).unwrap();
    let line = metrics.bounding_box;
    let inside = line.points().filter(|at| {
        let pixel = display.pixels[at.y as usize * WIDTH + at.x as usize];
        pixel == Rgb565::new(20, 40, 20)
    });
    println!("not filled {}", inside.count());
    println!("line {} {}", line.size.height, own.line_height());
    put565(display);

    let mut grey = Display::new(Gray8::new(30));
    let over = TextStyle::new(font, &style, Gray8::new(220));
    let over = over.over(Gray8::new(30));
    Text::new("Grey", Point::new(2, 40), over).draw(&mut grey).unwrap();
    bytes.extend(grey.pixels.iter().map(|pixel| pixel.luma()));

    let mut rgb = Display::new(Rgb888::new(0, 20, 40));
    let over = TextStyle::new(font, &style, Rgb888::new(250, 99, 3));
    let over = over.over(Rgb888::new(0, 20, 40));
    Text::new("Rgb", Point::new(2, 40), over).draw(&mut rgb).unwrap();
    for pixel in &rgb.pixels {
        bytes.extend([pixel.r(), pixel.g(), pixel.b()]);
    }

    let mut fitted = Style::new(14, Filter::text())?;
    fitted.fit_levels(2);
    let mut mono = Display::new(BinaryColor::Off);
    let on = TextStyle::new(font, &fitted, BinaryColor::On);
    Text::new("1 bit: in", Point::new(2, 30), on).draw(&mut mono).unwrap();
    println!("calls {}", mono.calls);
    bytes.extend(mono.pixels.iter().map(|pixel| pixel.is_on() as u8));
    Ok(bytes)
}
