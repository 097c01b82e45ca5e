// A TrueType file in memory, rendered by this machine as a display would show
// it:
//
//     face_host FONT.ttf FRAME OUT.ppm
#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "face.hpp"
#include "inkcell/truetype/truetype_font.hpp"
#include "screen_memory.hpp"

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() != 3) {
    std::cerr << "usage: face_host FONT.ttf FRAME OUT.ppm\n";
    return 64;
  }
  std::ifstream file(arguments[0], std::ios::binary);
  const std::vector<uint8_t> bytes((std::istreambuf_iterator<char>(file)), {});
  inkcell::TrueTypeFont font;
  if (font.open({bytes.data(), bytes.size()}) != inkcell::Status::ok ||
      inkcell::demo::show_face(font.font()) != inkcell::Status::ok) {
    std::cerr << arguments[0] << ": does not show\n";
    return 1;
  }
  return write_ppm(arguments[2]) ? 0 : 1;
}
