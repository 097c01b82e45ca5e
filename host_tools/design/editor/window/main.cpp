// inkcell-editor: a window for designing type.
#include <CLI/CLI.hpp>
#include <map>
#include <optional>
#include <sstream>

#include "editor/actions.hpp"
#include "editor/exact_preview.hpp"
#include "editor/preview_worker.hpp"
#include "editor/script.hpp"
#include "editor/window/panels.hpp"
#include "program.hpp"
#include "window/screen.hpp"

namespace inkcell::design::editor {
namespace {

constexpr int kPictureWidth = 1440;
constexpr int kPictureHeight = 900;
constexpr int kFrameWait = 16;    // while something moves [ms]
constexpr int kIdleWait = 250;    // [ms]
constexpr int kSettleFrames = 3;  // until sizes of widgets are known

struct Arguments {
  std::string file;
  std::string project;
  std::vector<std::string> chars;
  std::string script;
  std::string screenshot;
  float scale = 0;
};

// The system's clipboard.
Clipboard screen_clipboard() {
  return {[] {
            const std::unique_ptr<char, void (*)(void*)> text(
                SDL_GetClipboardText(), SDL_free);
            return std::string(text == nullptr ? "" : text.get());
          },
          [](const std::string& text) { SDL_SetClipboardText(text.c_str()); }};
}

// Everything that a preview depends on.
struct PreviewKey {
  GlyphPointer glyph;
  FontDataPointer font;
  std::string settings;

  bool operator==(const PreviewKey& other) const {
    return glyph == other.glyph && font == other.font &&
           settings == other.settings;
  }
};

PreviewKey key_of(const Editor& editor) {
  std::ostringstream text;
  const PreviewSettings& s = editor.preview;
  text << static_cast<int>(s.display) << s.dark << s.cells << ' ' << s.glyph_px
       << ' ' << s.text << ' ' << editor.master() << ' ' << editor.part_between;
  return {editor.glyph(), editor.shown_project().font, text.str()};
}

void handle_window_key(Panels& panels, const std::string& key) {
  static const std::map<std::string, const char*> kDialogs = {
      {"ctrl+n", "New font"},
      {"ctrl+o", "Open"},
      {"ctrl+shift+s", "Save as"},
      {"ctrl+shift+n", "Add glyphs"},
      {"ctrl+shift+c", "Add component"},
      {"ctrl+e", "Export"}};
  const auto dialog = kDialogs.find(key);
  if (key == "ctrl+q") {
    quit(panels);
  } else if (dialog != kDialogs.end()) {
    if (panels.editor.is_open() || key == "ctrl+n" || key == "ctrl+o") {
      open_dialog(panels, dialog->second);
    }
  } else if (panels.dialog.empty() && !panels.editor.pending &&
             panels.editor.imported.empty()) {
    attempt(panels.editor, [&] { press_key(panels.editor, key); });
  }
}

// Requests the device's preview. Returns the exact one if it can be drawn at
// once.
std::shared_ptr<const Preview> ask_for_preview(const Editor& editor,
                                               PreviewWorker& worker) {
  const PreviewJob job = editor.preview_job();
  const std::shared_ptr<const Preview> last = worker.latest();
  worker.request(job);
  return last == nullptr ? nullptr : draw_exact_preview(*last, job);
}

void run_window(const Arguments& arguments) {
  Editor editor;
  if (!arguments.file.empty()) {
    editor.open(arguments.file, arguments.project, arguments.chars);
  }
  tools::Screen screen("Inkcell", arguments.scale);
  editor.clipboard = screen_clipboard();
  PreviewWorker worker;
  Panels panels(editor, screen.textures());
  std::optional<PreviewKey> asked;
  std::shared_ptr<const Preview> exact;  // until the worker is done
  while (!panels.wants_quit) {
    const bool is_open = screen.read_input(
        panels.preview_is_busy ? kFrameWait : kIdleWait,
        [&](const std::string& key) { handle_window_key(panels, key); });
    if (!is_open) {
      quit(panels);
    }
    if (editor.glyph() != nullptr) {
      const PreviewKey key = key_of(editor);
      if (!asked || !(*asked == key)) {
        attempt(editor, [&] { exact = ask_for_preview(editor, worker); });
        asked = key;
      }
    }
    panels.preview_is_busy = worker.is_busy();
    panels.preview =
        panels.preview_is_busy && exact != nullptr ? exact : worker.latest();
    screen.draw_frame([&] { draw_window(panels); });
  }
}

// A picture of the window after all pending work.
void write_screenshot(Editor& editor,
                      float scale,
                      const std::filesystem::path& file) {
  const auto side = [scale](int pixels) {
    return static_cast<int>(static_cast<float>(pixels) * scale);
  };
  tools::Screen screen(side(kPictureWidth), side(kPictureHeight), scale);
  editor.imported.clear();
  Panels panels(editor, screen.textures());
  if (editor.glyph() != nullptr) {
    panels.preview =
        std::make_shared<const Preview>(draw_preview(editor.preview_job()));
  }
  for (int i = 0; i < kSettleFrames; ++i) {
    screen.draw_frame([&] { draw_window(panels); });
  }
  screen.write_picture(file);
}

void run(const Arguments& arguments) {
  if (arguments.script.empty()) {
    run_window(arguments);
    return;
  }
  const auto screenshot = [&arguments](Editor& editor,
                                       const std::filesystem::path& file) {
    write_screenshot(editor, arguments.scale == 0 ? 1 : arguments.scale, file);
  };
  Editor editor;
  if (!arguments.file.empty()) {
    editor.open(arguments.file, arguments.project, arguments.chars);
  }
  run_script(editor, arguments.script, screenshot);
  if (!arguments.screenshot.empty()) {
    screenshot(editor, arguments.screenshot);
  }
}

void add_arguments(CLI::App& app, Arguments& arguments) {
  app.add_option("font", arguments.file,
                 "A project (UFO), or a TTF or OTF to make one of");
  app.add_option("--project", arguments.project,
                 "The project that is made of a font [its name, in the current "
                 "folder]")
      ->type_name("P.ufo");
  tools::take_one(
      app.add_option("--chars", arguments.chars,
                     "Characters to take of a font: 0x20-0x7E,A-Z; repeatable "
                     "[all]"))
      ->type_name("LIST");
  app.add_option("--script", arguments.script,
                 "Carry out the lines of a file instead of opening a window")
      ->type_name("FILE");
  app.add_option("--screenshot", arguments.screenshot,
                 "Write a picture of the window at the end of the script")
      ->type_name("FILE.png");
  app.add_option("--scale", arguments.scale,
                 "Of the window's widgets [that of the display; 1 in scripts]")
      ->check(CLI::Range(1.0, 4.0));
  std::string help = "Lines of a script:\n";
  for (const ScriptCommand& command : script_commands()) {
    help += std::string("  ") + command.name + " " + command.arguments + ": " +
            command.task + "\n";
  }
  app.footer(help);
}

}  // namespace
}  // namespace inkcell::design::editor

int main(int argc, char** argv) {
  using namespace inkcell::design::editor;
  CLI::App app(
      "Designs type in a window whose preview is what the device will draw.");
  Arguments arguments;
  add_arguments(app, arguments);
  return inkcell::tools::run_program(app, argc, argv, [&arguments] {
    run(arguments);
    return 0;
  });
}
