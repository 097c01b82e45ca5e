// inkcell-simulator: the displays of the boards in a window.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>

#include "convert.hpp"
#include "program.hpp"
#include "recording.hpp"
#include "script.hpp"
#include "window/panels.hpp"
#include "window/screen.hpp"

namespace inkcell::tools {
namespace {

constexpr const char* kDefaultFont =
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr int kPictureWidth = 1280;
constexpr int kPictureHeight = 800;
constexpr int kPlayWait = 5;      // [ms]
constexpr int kIdleWait = 50;     // [ms]
constexpr int kSettleFrames = 3;  // until sizes of widgets are known

struct Arguments {
  gen::GenerateRequest request;
  std::string font = kDefaultFont;
  std::map<std::string, std::string> settings;  // by name
  std::string script;
  std::string screenshot;
  std::string save;
  std::string record;
  float scale = 1;
};

// Characters that the window's fonts have from the start, for typing.
std::string common_characters() {
  std::string all;
  for (char c = ' '; c <= '~'; ++c) {
    all += c;
  }
  return all;
}

RomFile make_font(const std::string& file,
                  Conversion conversion,
                  const FontWish& wish,
                  const FontWorker::Progress& progress) {
  conversion.request.target.coding =
      wish.coding == "outline" ? gen::Coding::outline : gen::Coding::field;
  conversion.request.progress = progress;
  if (conversion.request.morphs.empty() && !wish.morphs.empty()) {
    conversion.request.morphs = {wish.morphs};
  }
  RomFile rom = load_font_file(file, conversion, wish.text);
  if (coding_name(rom.font()) != wish.coding) {
    throw std::runtime_error(file + ": is a ROM font of " +
                             std::string(coding_name(rom.font())) +
                             ", and this scene needs one of " + wish.coding);
  }
  return rom;
}

void apply_settings(const Arguments& arguments, Settings& settings) {
  for (const SettingInfo& info : setting_list()) {
    const auto given = arguments.settings.find(info.name);
    if (given != arguments.settings.end()) {
      try {
        info.set(settings, given->second);
      } catch (const std::exception& error) {
        throw std::runtime_error("--" + given->first + ": " + error.what());
      }
    }
  }
}

// Draws the current settings, and keeps the error if that fails.
void attempt(Panels& panels) {
  try {
    panels.simulator.update();
    panels.problem.clear();
  } catch (const std::exception& error) {
    panels.problem = error.what();
    panels.is_playing = false;
  }
}

void run_window(Simulator& simulator,
                const FontWorker& worker,
                bool has_fixed_coding) {
  Screen screen("Inkcell simulator");
  Panels panels(simulator, screen.textures());
  panels.worker = &worker;
  panels.has_fixed_coding = has_fixed_coding;
  panels.is_playing = is_moving(simulator.settings);
  while (!panels.wants_quit) {
    const bool is_open = screen.read_input(
        panels.is_playing ? kPlayWait : kIdleWait,
        [&](const std::string& key) { handle_key(panels, key); });
    panels.wants_quit |= !is_open;
    attempt(panels);
    screen.draw_frame([&] { draw_window(panels); });
  }
}

// A picture of the window after all pending work.
void write_screenshot(Simulator& simulator,
                      bool has_fixed_coding,
                      float scale,
                      const std::filesystem::path& file) {
  const auto side = [scale](int pixels) {
    return static_cast<int>(static_cast<float>(pixels) * scale);
  };
  check_image_file(file, 3);
  Screen screen(side(kPictureWidth), side(kPictureHeight), scale);
  Panels panels(simulator, screen.textures());
  panels.has_fixed_coding = has_fixed_coding;
  for (int i = 0; i < kSettleFrames; ++i) {
    screen.draw_frame([&] { draw_window(panels); });
  }
  screen.write_picture(file);
}

void run(const Arguments& arguments, const CLI::App& app) {
  const Conversion conversion = conversion_of(app, arguments.request);
  const bool has_window = arguments.script.empty() &&
                          arguments.screenshot.empty() &&
                          arguments.save.empty() && arguments.record.empty();
  FontWorker worker([&](const FontWish& wish,
                        const FontWorker::Progress& progress) {
    return make_font(
        arguments.font, conversion,
        {wish.coding, wish.text + common_characters(), wish.morphs}, progress);
  });
  Simulator simulator([&](const FontWish& wish) {
    return has_window ? worker.take(wish)
                      : make_font(arguments.font, conversion, wish, {});
  });
  const bool is_rom = is_rom_font(read_file(arguments.font));
  simulator.settings.coding =
      arguments.request.target.coding == gen::Coding::outline ? "outline"
                                                              : "field";
  if (is_rom) {
    simulator.settings.coding = coding_name(load_rom(arguments.font).font());
  }
  apply_settings(arguments, simulator.settings);
  if (has_window) {
    run_window(simulator, worker, is_rom);
    return;
  }
  const auto screenshot = [&](Simulator& shown,
                              const std::filesystem::path& file) {
    write_screenshot(shown, is_rom, arguments.scale, file);
  };
  if (!arguments.script.empty()) {
    run_script(simulator, arguments.script, screenshot);
  }
  if (!arguments.save.empty()) {
    simulator.update();
    save_frame(*simulator.frame(), arguments.save);
  }
  if (!arguments.record.empty()) {
    record(simulator, arguments.record);
  }
  if (!arguments.screenshot.empty()) {
    simulator.update();
    screenshot(simulator, arguments.screenshot);
  }
}

void add_arguments(CLI::App& app, Arguments& arguments) {
  app.add_option("--font", arguments.font,
                 "ROM font, or TTF or OTF to convert in memory; on a board for "
                 "the scene text alone: others have the firmware's font")
      ->type_name("FILE")
      ->capture_default_str();
  std::string help = "Lines of a script:\n";
  const auto explain = [&help](const char* name, const char* values,
                               const char* task) {
    help += std::string("  ") + name + " " + values + ": " + task + "\n";
  };
  for (const SettingInfo& info : setting_list()) {
    explain(info.name, info.arguments, info.help);
    if (std::string(info.name) != "coding") {  // an option of conversion
      app.add_option_function<std::string>(
             "--" + std::string(info.name),
             [&arguments, &info](const std::string& value) {
               arguments.settings[info.name] = value;
             },
             info.help)
          ->type_name(info.arguments);
    }
  }
  for (const ScriptCommand& command : script_commands()) {
    explain(command.name, command.arguments, command.task);
  }
  app.add_option("--script", arguments.script,
                 "Carry out the lines of a file instead of opening a window")
      ->type_name("FILE");
  app.add_option("--save", arguments.save,
                 "Write what the display shows, or as .bin its memory, instead "
                 "of opening a window")
      ->type_name("FILE");
  app.add_option("--record", arguments.record,
                 "Write the scene's loop as a GIF instead of opening a window")
      ->type_name("FILE.gif");
  app.add_option("--screenshot", arguments.screenshot,
                 "Write a picture of the window instead of opening it")
      ->type_name("FILE.png");
  app.add_option("--scale", arguments.scale, "Of the picture's widgets")
      ->check(CLI::Range(1.0, 4.0));
  add_conversion_options(app, arguments.request);
  app.footer(help);
}

}  // namespace
}  // namespace inkcell::tools

int main(int argc, char** argv) {
  CLI::App app("Shows in a window what the boards show on their displays.");
  inkcell::tools::Arguments arguments;
  inkcell::tools::add_arguments(app, arguments);
  return inkcell::tools::run_program(app, argc, argv, [&] {
    inkcell::tools::run(arguments, app);
    return 0;
  });
}
