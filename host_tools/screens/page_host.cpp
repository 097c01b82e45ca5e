// A page of Chinese from a font in memory, rendered by this machine as a
// display would show it:
//
//     page_host FONT.bin PAGE OUT.ppm
#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "inkcell/strike/strike.hpp"
#include "page.hpp"
#include "screen_memory.hpp"

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() != 3) {
    std::cerr << "usage: page_host FONT.bin PAGE OUT.ppm\n";
    return 64;
  }
  std::ifstream file(arguments[0], std::ios::binary);
  const std::vector<uint8_t> bytes((std::istreambuf_iterator<char>(file)), {});
  inkcell::Font font;
  const inkcell::Span<const uint8_t> rom = {bytes.data(), bytes.size()};
  if (inkcell::Font::open(rom, font) != inkcell::Status::ok &&
      inkcell::Font::open(rom, inkcell::kStrikeCoding, font) !=
          inkcell::Status::ok) {
    std::cerr << arguments[0] << ": does not open\n";
    return 1;
  }
  const auto page = static_cast<uint32_t>(std::stoul(arguments[1]));
  if (inkcell::demo::show_page(font, page) != inkcell::Status::ok) {
    std::cerr << arguments[0] << ": lacks characters of page " << page << '\n';
    return 1;
  }
  return write_ppm(arguments[2]) ? 0 : 1;
}
