// A frame of a scene that moves, rendered by this machine as a display would
// show it:
//
//     motion_host FRAME OUT.ppm
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

#include "motion.hpp"
#include "screen_memory.hpp"

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() != 2) {
    std::cerr << "usage: motion_host FRAME OUT.ppm\n";
    return 64;
  }
  if (inkcell::demo::open_motion() != inkcell::Status::ok) {
    std::cerr << "the scene does not open\n";
    return 1;
  }
  inkcell::demo::show_motion(static_cast<uint32_t>(std::stoul(arguments[0])));
  return write_ppm(arguments[1]) ? 0 : 1;
}
