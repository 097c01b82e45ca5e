#include "recording.hpp"

#include <algorithm>
#include <stdexcept>

#include "gif.hpp"
#include "paper.hpp"

namespace inkcell::tools {
namespace {

constexpr int kDemoFrames = 480;  // a minute of its clock

// With three channels.
Image in_colour(const Image& image) {
  if (image.channels == 3) {
    return image;
  }
  Image result(image.width, image.height, 3);
  for (size_t i = 0; i < image.pixels.size(); ++i) {
    std::fill_n(result.pixels.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                image.pixels[i]);
  }
  return result;
}

void add_frames(Simulator& simulator, const std::filesystem::path& file) {
  const Settings& settings = simulator.settings;
  const int zoom = std::max(settings.zoom, 1);
  GifWriter gif(file, zoom * settings.width, zoom * settings.height,
                scenes::kFramesPerSecond);
  for (int i = 0; i < loop_frames(settings); ++i) {
    simulator.settings.frame = static_cast<uint32_t>(i);
    simulator.update();
    if (simulator.frame() == nullptr) {
      throw std::runtime_error("the font is being made; record again then");
    }
    gif.add(enlarge(in_colour(simulator.frame()->picture), zoom));
  }
  gif.finish();
}

}  // namespace

bool is_moving(const Settings& settings) {
  return settings.scene != kTextScene;
}

int loop_frames(const Settings& settings) {
  return settings.scene == kDemoScene ? kDemoFrames
                                      : static_cast<int>(scenes::kLoopFrames);
}

void record(Simulator& simulator, const std::filesystem::path& file) {
  if (!is_moving(simulator.settings)) {
    throw std::runtime_error(
        "the scene 'text' does not move; choose another one to record, or save "
        "a picture");
  }
  if (file.extension() != ".gif") {
    throw std::runtime_error(file.string() +
                             ": the name of a recording ends with .gif");
  }
  check_folder_of(file);
  const uint32_t frame = simulator.settings.frame;
  try {
    add_frames(simulator, file);
  } catch (...) {
    simulator.settings.frame = frame;
    throw;
  }
  simulator.settings.frame = frame;
}

}  // namespace inkcell::tools
