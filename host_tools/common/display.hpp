// Displays of every kind: ink for a strip, memory, and what the eye sees.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "counting_sink.hpp"
#include "image.hpp"
#include "ink.hpp"
#include "paper.hpp"

namespace inkcell::tools {

struct LookOptions;

enum class Display {
  mono,
  mono_pages,
  grey2,
  grey4,
  grey8,
  rgb565,
  xrgb8888,
  lcd
};

/// How a display is named in scripts, and shown.
struct DisplayInfo {
  Display display;
  const char* name;
  const char* label;
  const char* hint;
  port::PixelFormat format;
};
const std::vector<DisplayInfo>& display_list();
const DisplayInfo& display_info(Display display);

/// Throws std::runtime_error that lists the names.
Display display_of(const std::string& name);

/// Sets the levels and the sub-pixels that a display has.
void suit_display(Display display, LookOptions& look);

/// A strip in the format of a display, and ink of any colour.
class DisplayPaper {
 public:
  /// Counts what is drawn if `stats` are given. Throws std::runtime_error if
  /// the strip is none of that display.
  DisplayPaper(Display display, const Strip& strip, DrawStats* stats = nullptr);
  DisplayPaper(const DisplayPaper&) = delete;
  DisplayPaper& operator=(const DisplayPaper&) = delete;

  /// Uses this object.
  scenes::Paper paper();

 private:
  using Target = std::variant<port::MonoRowsTarget,
                              port::MonoPagesTarget,
                              port::Grey2Target,
                              port::Grey4Target,
                              port::Grey8Target,
                              port::Rgb565Target,
                              port::Xrgb8888Target,
                              port::Rgb888Target>;

  static Target target_for(Display display);
  Sink sink_for(bool has_sub_pixels);

  Target target_;
  DrawStats unused_;
  CountingSink counting_;
  Sink sink_;
};

/// The memory that a display shows.
class DisplayMemory {
 public:
  /// All bits 0. Throws std::runtime_error if a side is not within 1..32767 px.
  DisplayMemory(Display display, int width, int height);

  /// Draws strips of `rows` rows, or whole pages, and copies each to its place;
  /// draws in place if the first strip is all. `draw` fills all of a strip.
  /// Throws std::runtime_error if strips are no whole bytes.
  void show(int rows, const std::function<void(const Strip&)>& draw);

  /// Bytes of a strip of so many rows.
  size_t strip_bytes(int rows) const;
  /// So many rows, or the next whole page.
  int whole_rows(int rows) const;

  Display display() const { return info_.display; }
  int width() const { return width_; }
  int height() const { return height_; }
  const std::vector<uint8_t>& bytes() const { return bytes_; }

  /// Colours as they reach the eye: 3 channels.
  Image picture() const;

 private:
  void see(int x, int y, uint8_t* rgb) const;

  const DisplayInfo& info_;
  int width_;
  int height_;
  int stride_;
  std::vector<uint8_t> bytes_;
};

}  // namespace inkcell::tools
