#include "reel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>
#include <stdexcept>

#include "canvas.hpp"
#include "rom_file.hpp"
#include "scene_files.hpp"

namespace inkcell::tools {
namespace {

// A part of a scene. The first goes on where the last ends.
struct Window {
  std::string_view scene;
  std::string_view title;
  uint32_t from;   // [frames]
  uint32_t count;  // [frames] Even: many play every second frame.
  uint32_t still;  // the frame on the e-paper
};
constexpr std::array<Window, 12> kWindows = {
    {{"figure14", "swell", 84, 14, 92},
     {"bounce", "bounce", 8, 16, 16},
     {"particles", "particles", 42, 16, 48},
     {"path", "path", 84, 16, 92},
     {"wipe", "wipe", 8, 16, 16},
     {"figure15", "vortex", 34, 16, 46},
     {"pulse", "pulse", 8, 16, 16},
     {"print", "print", 46, 16, 60},
     {"splash", "splash", 68, 16, 80},
     {"melt", "melt", 12, 16, 20},
     {"figure13", "soft letters", 80, 16, 72},
     {"figure14", "swell", 78, 6, 92}}};

constexpr int kRows = 16;  // of a strip
// Round, in the picture.
constexpr int kWatch = Reel::kWatch;
constexpr int kWatchX = 36;
constexpr int kWatchY = 30;
constexpr int kPaperWidth = 296;
constexpr int kPaperHeight = 128;
constexpr int kPaperX = 326;
constexpr int kPaperY = 36;

constexpr uint32_t kGround = 0xe4e2dd;
constexpr uint32_t kInk = 0x23262c;
constexpr uint32_t kFloor = 0x39404c;

constexpr double kSharp = 0.5;

void lay_over(Image& image, int x, int y, uint32_t rgb, double part) {
  uint8_t* to = image.at(x, y);
  for (int i = 0; i < 3; ++i) {
    const double ink = rgb >> (16 - 8 * i) & 255;
    to[i] = static_cast<uint8_t>(std::lround(to[i] + (ink - to[i]) * part));
  }
}

uint32_t rgb_at(const Image& image, int x, int y) {
  const uint8_t* rgb = image.at(x, y);
  return static_cast<uint32_t>(rgb[0] << 16 | rgb[1] << 8 | rgb[2]);
}

// A box with round corners; a disc if the radius is half of its side, and a
// radius of half a pixel keeps corners sharp.
void fill_box(Image& image, const Rect& box, double radius, uint32_t rgb) {
  const double x = (box.x0 + box.x1) / 2.0;
  const double y = (box.y0 + box.y1) / 2.0;
  for (int row = std::max(0, box.y0); row < std::min(image.height, box.y1);
       ++row) {
    for (int column = box.x0; column < box.x1; ++column) {
      const double across = std::max(
          0.0, std::abs(column + 0.5 - x) - (box.x1 - box.x0) / 2.0 + radius);
      const double down = std::max(
          0.0, std::abs(row + 0.5 - y) - (box.y1 - box.y0) / 2.0 + radius);
      const double inside = radius - std::hypot(across, down) + 0.5;
      lay_over(image, column, row, rgb, std::clamp(inside, 0.0, 1.0));
    }
  }
}

Rect disc(double radius) {
  const auto side = static_cast<int32_t>(radius);
  constexpr int32_t kX = kWatchX + kWatch / 2;
  constexpr int32_t kY = kWatchY + kWatch / 2;
  return {kX - side, kY - side, kX + side, kY + side};
}

// A watch and e-paper, without what they show.
Image devices() {
  Image image(Reel::kWidth, Reel::kHeight, 3);
  fill_box(image, {0, 0, image.width, image.height}, kSharp, kGround);
  const Rect around = disc(132);
  fill_box(image, {around.x0 + 66, -20, around.x1 - 66, image.height + 20},
           kSharp, 0x3a3f48);
  fill_box(image, {around.x1 - 4, 134, around.x1 + 8, 166}, 4, 0x747b86);
  fill_box(image, around, 132, 0x8d949f);
  fill_box(image, disc(127), 127, 0x0b0c0f);
  const Rect paper = {kPaperX, kPaperY, kPaperX + kPaperWidth,
                      kPaperY + kPaperHeight};
  fill_box(image, {paper.x0 - 11, paper.y0 - 11, paper.x1 + 11, paper.y1 + 11},
           9, 0xb9b7b1);
  fill_box(image, {paper.x0 - 10, paper.y0 - 10, paper.x1 + 10, paper.y1 + 10},
           8, 0xfbfaf7);
  return image;
}

void write_label(const Font& font,
                 const std::string& text,
                 int px,
                 int baseline,
                 uint32_t rgb,
                 Image& image) {
  const Style style(Q26_6::from_int(px));
  Image label(image.width, image.height);
  draw_lines(font, lay_out_lines(font, text, Kerning::font, style), style,
             make_point(kPaperX - 10, baseline), label);
  for (int y = 0; y < label.height; ++y) {
    for (int x = 0; x < label.width; ++x) {
      lay_over(image, x, y, rgb, *label.at(x, y) / 255.0);
    }
  }
}

// What the table of scenes says of a scene on the watch: RAM, and instructions.
std::array<std::string, 3> figures_of(const std::string& document,
                                      std::string_view scene) {
  const std::regex row("\\| `" + std::string(scene) +
                       "`[^|]*\\| 240 x 240 \\|[^|]*"
                       "\\| ([0-9.]+) M, ([0-9.]+) M \\| ([^|]*) \\|");
  std::smatch found;
  if (!std::regex_search(document, found, row)) {
    throw std::runtime_error(std::string(kSceneFigures) + ": no row of " +
                             std::string(scene) + " at 240 x 240");
  }
  const auto thousands = [](const std::string& millions) {
    return std::to_string(std::lround(1000 * std::stod(millions))) + " k";
  };
  return {found.str(3) + " of RAM",
          thousands(found.str(1)) + " instructions a frame",
          "at worst " + thousands(found.str(2)) + " (Cortex-M4)"};
}

// Dark on light, four greys.
Image on_paper(const Image& light) {
  Image dark = light;
  for (uint8_t& value : dark.pixels) {
    value = static_cast<uint8_t>(0xee - value * (0xee - 0x22) / 255);
  }
  return dark;
}

}  // namespace

Reel::Reel(const Font& font, const std::string& word, const Font& labels) {
  const std::vector<uint8_t> bytes = read_file(kSceneFigures);
  const std::string document(bytes.begin(), bytes.end());
  const Image bare = devices();
  shown_.resize(kWindows.size());
  for (size_t i = 0; i < kWindows.size(); ++i) {
    const Window& window = kWindows[i];
    Shown& shown = shown_[i];
    const SceneKind& kind = find_scene(std::string(window.scene));
    shown.text = kind.takes == "two words" ? word + " " + word : word;
    DisplayMemory memory(Display::grey2, kPaperWidth, kPaperHeight);
    const std::unique_ptr<Player> still =
        open_scene(kind, font, shown.text, kPaperWidth, kPaperHeight);
    still->set_frame(window.still);
    shown.around = bare;
    paste(on_paper(draw_frame(*still, memory, kRows)), kPaperX, kPaperY,
          shown.around);
    if (window.scene == "figure13") {
      shown.screen = {45, 0, 195, 212};  // the floor is a chord of the watch
    }
    shown.player =
        open_scene(kind, font, shown.text, shown.screen.x1 - shown.screen.x0,
                   shown.screen.y1);
    write_label(labels, std::string(window.title), 28, 210, kInk, shown.around);
    int baseline = 238;
    for (const std::string& line : figures_of(document, window.scene)) {
      write_label(labels, line, 14, baseline, kInk, shown.around);
      baseline += 21;
    }
  }
}

size_t Reel::window_of(uint32_t frame) {
  frame %= kFrames;
  size_t index = 0;
  while (frame >= kWindows[index].count) {
    frame -= kWindows[index++].count;
  }
  return index;
}

Image Reel::draw(uint32_t frame) {
  const size_t index = window_of(frame);
  frame %= kFrames;
  for (size_t i = 0; i < index; ++i) {
    frame -= kWindows[i].count;
  }
  const Shown& shown = shown_[index];
  const Rect part = shown.screen;
  shown.player->set_frame(kWindows[index].from + frame);
  DisplayMemory memory(Display::xrgb8888, part.x1 - part.x0, part.y1 - part.y0);
  const Image scene = draw_frame(*shown.player, memory, kRows);
  Image screen(kWatch, kWatch, 3);
  fill_box(screen, {0, 0, kWatch, kWatch}, kSharp, rgb_at(scene, 0, 0));
  fill_box(screen, {0, part.y1, kWatch, kWatch}, kSharp, kFloor);
  paste(scene, part.x0, part.y0, screen);
  Image image = shown.around;
  for (int y = 0; y < kWatch; ++y) {
    for (int x = 0; x < kWatch; ++x) {
      const double inside =
          kWatch / 2.0 + 0.5 -
          std::hypot(x + 0.5 - kWatch / 2.0, y + 0.5 - kWatch / 2.0);
      lay_over(image, kWatchX + x, kWatchY + y, rgb_at(screen, x, y),
               std::clamp(inside, 0.0, 1.0));
    }
  }
  return image;
}

}  // namespace inkcell::tools
