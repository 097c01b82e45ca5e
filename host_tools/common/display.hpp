// Displays of all kinds: ink for a strip, memory, and the visible picture.
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

/// A display's name in scripts, and its title.
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

/// Sets the levels and the sub-pixels of a display.
void suit_display(Display display, LookOptions& look);

/// A strip in the format of a display, with ink of any colour.
class DisplayPaper {
 public:
  /// Counts into `stats` if given. Throws std::runtime_error if the strip does
  /// not fit the display.
  DisplayPaper(Display display, const Strip& strip, DrawStats* stats = nullptr);
  DisplayPaper(const DisplayPaper&) = delete;
  DisplayPaper& operator=(const DisplayPaper&) = delete;

  /// Refers to this object.
  scenes::Paper paper();

 private:
  using Canvas = std::variant<port::MonoRowsCanvas,
                              port::MonoPagesCanvas,
                              port::Grey2Canvas,
                              port::Grey4Canvas,
                              port::Grey8Canvas,
                              port::Rgb565Canvas,
                              port::Xrgb8888Canvas,
                              port::Rgb888Canvas>;

  static Canvas canvas_for(Display display, const Strip& strip);
  Sink sink() const;

  Canvas canvas_;
  DrawStats unused_;
  CountingSink counting_;
  Sink sink_;
};

/// The memory of a display.
class DisplayMemory {
 public:
  /// All bits 0. Throws std::runtime_error if a side is not within 1..32767 px.
  DisplayMemory(Display display, int width, int height);

  /// Draws strips of `rows` rows, or whole pages, and copies each to its place;
  /// if the first strip is the whole screen, draws in place. `draw` fills a
  /// whole strip. Throws std::runtime_error if strips are not whole bytes.
  void show(int rows, const std::function<void(const Strip&)>& draw);

  /// Bytes of a strip of so many rows.
  size_t strip_bytes(int rows) const;
  /// The rows, rounded up to whole pages.
  int whole_rows(int rows) const;

  Display display() const { return info_.display; }
  int width() const { return width_; }
  int height() const { return height_; }
  const std::vector<uint8_t>& bytes() const { return bytes_; }

  /// The visible picture: 3 channels.
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
