//! Shows on a terminal what the examples draw.
#![forbid(unsafe_code)]

fn main() -> Result<(), inkcell::Status> {
    let mut pages = [0; 192];
    inkcell_example::label("Hello, Rust!", &mut pages)?;
    for y in 0..16 {
        let row = &pages[y / 8 * 96..][..96];
        let is_set = |byte: &u8| byte >> (y % 8) & 1 == 1;
        let line: String = row.iter().map(|byte| if is_set(byte) { '#' } else { ' ' }).collect();
        println!("{}", line.trim_end());
    }
    Ok(())
}
