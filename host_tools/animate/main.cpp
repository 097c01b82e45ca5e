// inkcell-animate: plays a scene of the boards into an animated picture.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string_view>

#include <nettle/sha2.h>

#include "apng.hpp"
#include "canvas.hpp"
#include "clock_scene.hpp"
#include "convert.hpp"
#include "display.hpp"
#include "files.hpp"
#include "gif.hpp"
#include "icon_scene.hpp"
#include "paper.hpp"
#include "player.hpp"
#include "program.hpp"
#include "progress.hpp"
#include "reel.hpp"
#include "scene_files.hpp"

namespace inkcell::tools {
namespace {

constexpr const char* kDefaultFont =
    "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf";

// The scenes of the classic reel, row by row.
constexpr int kReelColumns = 5;
constexpr int kReelRows = 2;
constexpr const char* kReelSize = "800x160";
// A scene of this size has text of 8 px.
constexpr int kLeastReelWidth = 64;
constexpr int kLeastReelHeight = 32;
constexpr std::array<std::string_view, kReelColumns* kReelRows> kReel = {
    "clock", "count", "icons",  "typewriter", "charge",
    "wipe",  "pulse", "bounce", "ticker",     "splash"};

struct Arguments {
  gen::GenerateRequest request;
  std::string scene;
  std::string font = kDefaultFont;
  std::optional<std::string> text;
  std::string size = "320x240";
  double seconds = 10;
  double from = 0;  // [s]
  int frames_per_second = scenes::kFramesPerSecond;
  std::string format;  // by the name of `out`
  std::string out;
  std::string stats;
  std::string print;
  int rows = 16;
  int zoom = 1;
  bool classic = false;
};

struct Size {
  int width = 0;
  int height = 0;
};

// The frames that are played.
struct Frames {
  uint32_t first = 0;
  uint32_t step = 1;
  uint32_t count = 0;
};

Frames frames_of(const Arguments& arguments) {
  const auto count = [](double seconds, int frames_per_second) {
    return static_cast<uint32_t>(std::lround(seconds * frames_per_second));
  };
  return {count(arguments.from, scenes::kFramesPerSecond),
          static_cast<uint32_t>(scenes::kFramesPerSecond /
                                arguments.frames_per_second),
          std::max(1U, count(arguments.seconds, arguments.frames_per_second))};
}

Size read_size(const std::string& text) {
  Size size;
  int end = 0;
  if (std::sscanf(text.c_str(), "%dx%d%n", &size.width, &size.height, &end) !=
          2 ||
      static_cast<size_t>(end) != text.size() || size.width < 16 ||
      size.height < 8 || size.width > 2048 || size.height > 2048) {
    throw std::runtime_error(
        "--size " + text +
        ": say WIDTHxHEIGHT in px, from 16x8 to 2048x2048, such as 320x240");
  }
  return size;
}

// The styles of --print.
const std::map<std::string, simulation::PrintStyle>& print_styles() {
  using simulation::PrintStyle;
  static const std::map<std::string, PrintStyle> styles = {
      {"rings", PrintStyle::rings},
      {"engraving", PrintStyle::engraving},
      {"hatching", PrintStyle::hatching},
      {"halftone", PrintStyle::halftone},
      {"relief", PrintStyle::relief}};
  return styles;
}

class Sha256 {
 public:
  Sha256() { sha256_init(&context_); }
  void add(const std::vector<uint8_t>& bytes) {
    sha256_update(&context_, bytes.size(), bytes.data());
  }
  std::string finish() {
    std::array<uint8_t, SHA256_DIGEST_SIZE> digest{};
    sha256_digest(&context_, digest.size(), digest.data());
    std::ostringstream text;
    for (const uint8_t byte : digest) {
      text << std::hex << std::setw(2) << std::setfill('0') << int{byte};
    }
    return text.str();
  }

 private:
  sha256_ctx context_;
};

// Figures of the frames that were played.
struct Tally {
  Sha256 all;
  Sha256 states;
  Sha256 pictures;
  uint64_t dirty_pixels = 0;
  uint64_t changed_pixels = 0;
  uint64_t missed_pixels = 0;  // changed outside of dirty rectangles
  uint32_t still_frames = 0;   // without a dirty rectangle
  uint32_t missed_frames = 0;  // changed before they were due
  std::optional<BodyFigures> bodies;
};

// Compares a frame with the one before and with the scene's dirty rectangles.
void compare(const Image& before,
             const Image& frame,
             Span<const Rect> dirty,
             bool is_due,
             Tally& tally) {
  uint64_t changed = 0;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      if (std::memcmp(before.at(x, y), frame.at(x, y), 3) == 0) {
        continue;
      }
      ++changed;
      bool is_known = false;
      for (const Rect& r : dirty) {
        is_known = is_known || (x >= r.x0 && x < r.x1 && y >= r.y0 && y < r.y1);
      }
      tally.missed_pixels += is_known ? 0 : 1;
    }
  }
  for (const Rect& r : dirty) {
    tally.dirty_pixels +=
        static_cast<uint64_t>(r.x1 - r.x0) * static_cast<uint64_t>(r.y1 - r.y0);
  }
  tally.changed_pixels += changed;
  tally.still_frames += dirty.size == 0 ? 1 : 0;
  tally.missed_frames += changed != 0 && !is_due ? 1 : 0;
}

// The output: a function for each frame, and one for the end.
struct Output {
  std::function<void(const Image& frame, uint32_t number)> add;
  std::function<void()> finish = [] {};
  std::function<void()> begin_part = [] {};  // the next frame is of another
};

// A frame's time, black on white. [s]
Image time_label(const Font& font, uint32_t frame, int width, int height) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2)
       << static_cast<double>(frame) / scenes::kFramesPerSecond << " s";
  const Style style(Q26_6::from_int(height * 3 / 4));
  Image label(width, height, 3);
  draw_lines(font, lay_out_lines(font, text.str(), Kerning::none, style), style,
             make_point(1, height * 0.75), label);
  invert(label);
  return label;
}

// All frames in one picture, in rows of up to 8, with their times below them.
Output open_sheet(const Arguments& arguments, Size size, int frames) {
  constexpr int kColumns = 8;
  constexpr int kGap = 4;  // [px]
  constexpr int kLabelHeight = 16;
  const int columns = std::min(frames, kColumns);
  const int rows = (frames + columns - 1) / columns;
  const int cell_height = size.height + kLabelHeight + kGap;
  const auto sheet = std::make_shared<Image>(
      columns * (size.width + kGap) - kGap, rows * cell_height - kGap, 3, 255);
  const auto font = std::make_shared<RomFile>(
      load_font_file(arguments.font, Conversion(), "0123456789. s"));
  const auto count = std::make_shared<int>(0);
  const std::string file = arguments.out;
  return {[=](const Image& frame, uint32_t number) {
            const int x = *count % columns * (size.width + kGap);
            const int y = *count / columns * cell_height;
            paste(frame, x, y, *sheet);
            paste(time_label(font->font(), number, size.width, kLabelHeight), x,
                  y + size.height, *sheet);
            ++*count;
          },
          [=] { write_image(file, *sheet); }};
}

Output open_output(const Arguments& arguments, Size size, uint32_t frames) {
  size = {size.width * arguments.zoom, size.height * arguments.zoom};
  if (arguments.format == "frames") {
    const std::filesystem::path folder = arguments.out;
    std::filesystem::create_directories(folder);
    return {[folder](const Image& frame, uint32_t number) {
      std::ostringstream name;
      name << std::setw(5) << std::setfill('0') << number << ".png";
      write_image(folder / name.str(), frame);
    }};
  }
  check_folder_of(arguments.out);
  if (arguments.format == "sheet") {
    check_image_file(arguments.out, 3);
    return open_sheet(arguments, size, static_cast<int>(frames));
  }
  if (arguments.format == "gif") {
    auto gif = std::make_shared<GifWriter>(
        arguments.out, size.width, size.height, arguments.frames_per_second);
    return {[gif](const Image& frame, uint32_t) { gif->add(frame); },
            [gif] { gif->finish(); }, [gif] { gif->begin_part(); }};
  }
  auto apng =
      std::make_shared<ApngWriter>(arguments.out, size.width, size.height,
                                   frames, arguments.frames_per_second);
  return {[apng](const Image& frame, uint32_t) { apng->add(frame); },
          [apng] { apng->finish(); }};
}

void write_stats(const Arguments& arguments,
                 const Player& player,
                 Size size,
                 const Frames& frames,
                 Tally& tally) {
  const auto mean = [&](uint64_t sum) {
    return static_cast<double>(sum) / frames.count;
  };
  nlohmann::ordered_json json = {
      {"scene", arguments.scene},
      {"width", size.width},
      {"height", size.height},
      {"from", frames.first},
      {"frames", frames.count},
      {"sha256", tally.all.finish()},
      {"sha256_state", tally.states.finish()},
      {"sha256_frames", tally.pictures.finish()},
      {"state_bytes", player.state_bytes()},
      {"dirty_pixels_mean", mean(tally.dirty_pixels)},
      {"changed_pixels_mean", mean(tally.changed_pixels)},
      {"missed_pixels", tally.missed_pixels},
      {"still_frames", tally.still_frames},
      {"missed_frames", tally.missed_frames},
  };
  if (tally.bodies) {
    const BodyFigures& all = *tally.bodies;
    json["worst_penetration_px"] = all.drawn;
    json["worst_rigid_penetration_px"] = all.rigid;
    json["worst_squash"] = all.squash;
    json["ink_of_a_letter"] = {all.least_body_ink, all.greatest_body_ink};
    json["ink_of_a_frame"] = {all.least_ink, all.greatest_ink};
    json["resting_off_floor"] = all.off_floor;
  }
  std::ofstream out(arguments.stats);
  out << json.dump(2) << '\n';
  if (!out.flush()) {
    throw std::runtime_error(arguments.stats + ": cannot be written");
  }
}

// Draws the frames, and writes each. Cuts are where parts of frames differ.
void write_frames(
    const Arguments& arguments,
    Size size,
    const std::function<Image(uint32_t number)>& draw,
    size_t (*part_of)(uint32_t number) = [](uint32_t) { return size_t{0}; }) {
  const Frames frames = frames_of(arguments);
  const Output output = open_output(arguments, size, frames.count);
  Progress progress(false, "frames");
  for (uint32_t i = 0; i < frames.count; ++i) {
    const uint32_t number = frames.first + i * frames.step;
    const Image frame = draw(number);
    if (i > 0 && part_of(number) != part_of(number - frames.step)) {
      output.begin_part();
    }
    output.add(arguments.zoom == 1 ? frame : enlarge(frame, arguments.zoom),
               number);
    progress.update(i + 1, frames.count);
  }
  output.finish();
}

void play(const Arguments& arguments, Player& player, Size size) {
  DisplayMemory memory(Display::xrgb8888, size.width, size.height);
  Image before;
  Tally tally;
  uint32_t due = 0;
  write_frames(arguments, size, [&](uint32_t number) {
    player.set_frame(number);
    Image frame = draw_frame(player, memory, arguments.rows);
    std::array<Rect, 8> room;
    DirtyRects dirty({room.data(), room.size()});
    player.add_changes(dirty);
    if (before.width != 0) {
      compare(before, frame, dirty.rects(), number >= due, tally);
    }
    due = player.next_due();
    const std::vector<uint8_t> state = player.state();
    if (const std::optional<BodyFigures> now = player.figures()) {
      tally.bodies = tally.bodies.value_or(BodyFigures());
      tally.bodies->add(*now);
    }
    tally.all.add(state);
    tally.all.add(frame.pixels);
    tally.states.add(state);
    tally.pictures.add(frame.pixels);
    before = frame;
    return frame;
  });
  if (!arguments.stats.empty()) {
    write_stats(arguments, player, size, frames_of(arguments), tally);
  }
}

// Plays scenes beside one another.
void play_reel(const Arguments& arguments, const Font& font, Size size) {
  const int width = size.width / kReelColumns;
  const int height = size.height / kReelRows;
  std::vector<std::unique_ptr<Player>> players;
  for (const std::string_view name : kReel) {
    const SceneKind& kind = find_scene(std::string(name));
    players.push_back(open_scene(kind, font, kind.text, width, height));
  }
  DisplayMemory memory(Display::xrgb8888, width, height);
  write_frames(arguments, size, [&](uint32_t number) {
    Image whole(size.width, size.height, 3);
    for (size_t k = 0; k < players.size(); ++k) {
      players[k]->set_frame(number);
      paste(draw_frame(*players[k], memory, arguments.rows),
            static_cast<int>(k) % kReelColumns * width,
            static_cast<int>(k) / kReelColumns * height, whole);
    }
    return whole;
  });
}

// Ten scenes beside one another.
void run_classic_reel(Arguments& arguments, const CLI::App& app) {
  const Size size =
      read_size(app.count("--size") == 0 ? kReelSize : arguments.size);
  if (size.width < kReelColumns * kLeastReelWidth ||
      size.height < kReelRows * kLeastReelHeight) {
    throw std::runtime_error(
        "--size " + arguments.size + ": the reel shows " +
        std::to_string(kReelColumns) + "x" + std::to_string(kReelRows) +
        " scenes and takes " + std::to_string(kReelColumns * kLeastReelWidth) +
        "x" + std::to_string(kReelRows * kLeastReelHeight) +
        " to 2048x2048 px");
  }
  std::string text;
  for (const std::string_view name : kReel) {
    text += find_scene(std::string(name)).text;
  }
  arguments.request.symbols += "0123456789:";
  arguments.request.svg_folders.emplace_back(kSceneIcons);
  arguments.request.morphs = {scenes::ClockScene::kMorphs,
                              scenes::IconScene::kMorphs};
  const RomFile rom = load_font_file(
      arguments.font, conversion_of(app, arguments.request), text);
  play_reel(arguments, rom.font(), size);
}

void run_reel(Arguments& arguments, const CLI::App& app) {
  const char* const changing =
      arguments.classic ? "--text" : "--size";  // not of this reel
  for (const char* option : {changing, "--stats", "--morph", "--print"}) {
    if (app.count(option) != 0) {
      throw std::runtime_error(std::string(option) +
                               ": the reel plays scenes as they are; say it "
                               "with one of them");
    }
  }
  if (arguments.classic) {
    run_classic_reel(arguments, app);
    return;
  }
  if (app.count("--seconds") == 0) {
    arguments.seconds = Reel::kFrames / double{scenes::kFramesPerSecond};
  }
  const std::string word = arguments.text.value_or(Reel::kWord);
  const RomFile rom = load_font_file(
      arguments.font, conversion_of(app, arguments.request), word);
  const RomFile labels = load_font_file(kDefaultFont, Conversion(), "");
  Reel reel(rom.font(), word, labels.font());
  write_frames(
      arguments, {Reel::kWidth, Reel::kHeight},
      [&reel](uint32_t number) { return reel.draw(number); }, Reel::window_of);
}

void run(Arguments& arguments, const CLI::App& app) {
  if (arguments.format.empty()) {
    arguments.format =
        std::filesystem::path(arguments.out).extension() == ".gif" ? "gif"
                                                                   : "apng";
  }
  if (arguments.scene == "reel") {
    run_reel(arguments, app);
    return;
  }
  const SceneKind& kind = find_scene(arguments.scene);
  if (arguments.classic) {
    throw std::runtime_error("--classic: is of the reel");
  }
  std::optional<simulation::PrintStyle> print;
  if (!arguments.print.empty()) {
    if (arguments.scene != "figure15") {
      throw std::runtime_error("--print: " + arguments.scene +
                               " is not printed; figure15 is");
    }
    print = print_styles().at(arguments.print);
  }
  const Size size = read_size(arguments.size);
  check_apart({arguments.out, arguments.stats}, {arguments.font});
  if (!arguments.stats.empty()) {
    check_folder_of(arguments.stats);
  }
  const std::string text = arguments.text.value_or(std::string(kind.text));
  if (app.count("--chars") == 0) {
    arguments.request.symbols += "0123456789:";
  }
  if (app.count("--morph") == 0 && !kind.morphs.empty()) {
    arguments.request.morphs = {std::string(kind.morphs)};
  }
  if (arguments.scene == "icons" && !arguments.text) {
    arguments.request.svg_folders.emplace_back(kSceneIcons);
    arguments.request.morphs = {scenes::IconScene::kMorphs};
  }
  const RomFile rom = load_font_file(
      arguments.font, conversion_of(app, arguments.request), text);
  const std::unique_ptr<Player> player =
      open_scene(kind, rom.font(), text, size.width, size.height, print);
  play(arguments, *player, size);
}

void add_arguments(CLI::App& app, Arguments& arguments) {
  std::string scenes = "One of:";
  for (const SceneKind& kind : scene_kinds()) {
    scenes += "\n" + std::string(kind.name) + ": " + std::string(kind.what) +
              " (--text: " + std::string(kind.takes) + ")";
  }
  scenes +=
      "\nreel: a word (--text) through eleven of them on a watch and on "
      "e-paper, 656x300 px, 6 s; with --classic ten scenes side by side, "
      "800x160 px";
  app.add_option("scene", arguments.scene, scenes)->required();
  app.add_option("--out", arguments.out,
                 "The animated picture; with --format frames a folder")
      ->required()
      ->type_name("FILE");
  app.add_option("--font", arguments.font,
                 "ROM font, or TTF or OTF to convert in memory")
      ->type_name("FILE")
      ->capture_default_str();
  app.add_option("--text", arguments.text,
                 "What the scene shows, instead of its own text");
  app.add_option("--size", arguments.size, "Of the screen [px]")
      ->type_name("WxH")
      ->capture_default_str();
  app.add_option("--seconds", arguments.seconds,
                 "How long; 0: one frame; every scene repeats after 10 s")
      ->check(CLI::Range(0.0, 3600.0))
      ->capture_default_str();
  app.add_option("--from", arguments.from, "Where to begin [s]")
      ->check(CLI::Range(0.0, 36000.0))
      ->capture_default_str();
  app.add_option("--fps", arguments.frames_per_second,
                 "Frames a second; fewer make smaller files")
      ->check(CLI::IsMember({1, 2, 3, 5, 6, 10, 15, 30}))
      ->type_name("N")
      ->capture_default_str();
  app.add_option(
         "--format", arguments.format,
         "apng, gif, frames (PNG), or sheet: all frames in one PNG, with "
         "their times; "
         "without it gif for names that end so, otherwise apng")
      ->check(CLI::IsMember({"apng", "gif", "frames", "sheet"}));
  app.add_option("--print", arguments.print,
                 "Draw the letter of figure15 as a print")
      ->check(CLI::IsMember(print_styles()))
      ->type_name("STYLE");
  app.add_flag("--classic", arguments.classic,
               "The reel of ten scenes beside one another");
  app.add_option("--rows", arguments.rows,
                 "Rows of a strip; the frames are the same for every number")
      ->check(CLI::Range(1, 2048))
      ->capture_default_str();
  app.add_option("--zoom", arguments.zoom, "Draw each pixel N x N")
      ->check(CLI::Range(1, 16))
      ->capture_default_str();
  app.add_option("--stats", arguments.stats,
                 "What was played: hashes, RAM, pixels that changed")
      ->type_name("FILE.json");
  add_conversion_options(app, arguments.request);
}

}  // namespace
}  // namespace inkcell::tools

int main(int argc, char** argv) {
  CLI::App app("Plays type that moves, drawn by Inkcell's device code.");
  inkcell::tools::Arguments arguments;
  inkcell::tools::add_arguments(app, arguments);
  return inkcell::tools::run_program(app, argc, argv, [&] {
    inkcell::tools::run(arguments, app);
    return 0;
  });
}
