//! Makes the font of the example.

fn main() {
    let font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
    inkcell_fonts::make("sans", font, &["--chars=0x20-0x7E,0xB0"]);
}
