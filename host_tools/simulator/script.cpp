#include "script.hpp"

#include "recording.hpp"

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace inkcell::tools {
namespace {

void print(const Frame& frame, const Settings& settings) {
  nlohmann::ordered_json json = {
      {"scene", settings.scene},
      {"board", settings.board},
      {"display", display_info(settings.display).name},
      {"width", settings.width},
      {"height", settings.height},
      {"rows", settings.rows},
      {"frame", settings.frame},
      {"strip_bytes", frame.strip_bytes},
      {"state_bytes", frame.state_bytes},
      {"font_bytes", frame.font_bytes},
      {"strips", frame.stats.strips},
      {"computed_pixels", frame.stats.coverage_pixels},
      {"filled_pixels", frame.stats.solid_pixels},
      {"leaves", frame.overlay.leaves.size()},
      {"points", frame.overlay.dots.size()},
  };
  if (frame.origin) {
    json["origin"] = {frame.origin->x.raw / 64.0, frame.origin->y.raw / 64.0};
  }
  std::printf("%s\n", json.dump().c_str());
}

void run_line(Simulator& simulator,
              const std::string& text,
              const Screenshot& screenshot) {
  std::istringstream in(text);
  std::string name;
  if (!(in >> name) || name[0] == '#') {
    return;
  }
  std::string rest;
  std::getline(in >> std::ws, rest);
  if (name == "save") {
    simulator.update();
    save_frame(*simulator.frame(), rest);
  } else if (name == "record") {
    record(simulator, rest);
  } else if (name == "screenshot") {
    simulator.update();
    screenshot(simulator, rest);
  } else if (name == "print") {
    simulator.update();
    print(*simulator.frame(), simulator.settings);
  } else {
    set_option(simulator.settings, name, rest);
  }
}

}  // namespace

const std::vector<ScriptCommand>& script_commands() {
  static const std::vector<ScriptCommand> list = {
      {"save", "FILE.png|FILE.ppm|FILE.bin",
       "write what the display shows, or the bytes of its memory"},
      {"record", "FILE.gif",
       "write the scene's loop as a GIF, its pixels as large as zoom"},
      {"screenshot", "FILE.png", "write a picture of the window"},
      {"print", "", "print the settings and the frame's figures as JSON"},
  };
  return list;
}

void run_script(Simulator& simulator,
                const std::filesystem::path& file,
                const Screenshot& screenshot) {
  std::ifstream in(file);
  if (!in) {
    throw std::runtime_error(file.string() + ": cannot be read");
  }
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    try {
      run_line(simulator, line, screenshot);
    } catch (const std::exception& error) {
      throw std::runtime_error(file.string() + ":" + std::to_string(number) +
                               ": " + error.what());
    }
  }
}

void save_frame(const Frame& frame, const std::filesystem::path& file) {
  if (file.extension() != ".bin") {
    check_image_file(file, frame.picture.channels);
    write_image(file, frame.picture);
    return;
  }
  check_folder_of(file);
  const std::vector<uint8_t>& bytes = frame.memory.bytes();
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  if (!out.flush()) {
    throw std::runtime_error(file.string() + ": cannot be written");
  }
}

}  // namespace inkcell::tools
