// The demo's pictures, rendered by this machine as a display would show them:
//
//     scene_host scene FRAME OUT.ppm
//     scene_host pattern OUT.ppm
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

#include "pattern.hpp"
#include "scene.hpp"
#include "screen_memory.hpp"
#include "show.hpp"

namespace {

namespace demo = inkcell::demo;

bool render_scene(uint32_t frame) {
  static demo::Scene scene;
  if (scene.open() != inkcell::Status::ok) {
    std::cerr << "the scene's font does not open\n";
    return false;
  }
  if (scene.missing_characters() != 0) {
    std::cerr << scene.missing_characters()
              << " characters of the scene are not in its font\n";
    return false;
  }
  scene.set_frame(frame);
  demo::show([](void*, const inkcell::Strip& strip) {
    scene.draw(strip);
    return inkcell::Status::ok;
  });
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() == 3 && arguments[0] == "scene") {
    const auto frame = static_cast<uint32_t>(std::stoul(arguments[1]));
    return render_scene(frame) && write_ppm(arguments[2]) ? 0 : 1;
  }
  if (arguments.size() == 2 && arguments[0] == "pattern") {
    demo::show_pattern();
    return write_ppm(arguments[1]) ? 0 : 1;
  }
  std::cerr << "usage: scene_host scene FRAME OUT.ppm | pattern OUT.ppm\n";
  return 64;
}
