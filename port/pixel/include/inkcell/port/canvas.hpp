// What all canvases have: a strip, and the sink that draws into it.
//
//   Rgb565Canvas canvas(strip, rgb565(255, 200, 0));
//   Painter(canvas).text(font, style, pen, "Hello");
//
// A canvas is a Sink: it goes wherever a `const Sink&` goes, and must outlive
// what keeps a copy of that sink. Each format has a canvas in a header of its
// own (pixel.hpp lists them), made from a strip, the colour of the foreground
// and, if the strip shall be filled first, that of a background.
#pragma once

#include <stdint.h>

#include "inkcell/geometry.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {
namespace detail {

// The memory layout of a format.
struct Layout {
  uint8_t bits;       // of a pixel along the row
  uint8_t rows_log2;  // rows of pixels in a stride
};

// The functions and the layout of a sink for one format. Their context is the
// format's struct of pixels: a strip, and what the sink draws there.
struct SinkKind {
  decltype(Sink::coverage) coverage;
  decltype(Sink::solid) solid;
  decltype(Sink::block) block;
  decltype(Sink::painted) painted;
  Layout layout;
  decltype(Sink::levels) levels = nullptr;
};

// What is wrong with a strip: see pixel.hpp.
Status check_layout(const Strip& strip, Layout layout) noexcept;

// Cuts a strip to the rows that its bytes hold, to none if it is wrong in
// another way. Returns what was wrong.
Status cut_strip(Strip& strip, Layout layout) noexcept;

// The same, and makes its sink.
Status open_sink(Strip& strip,
                 const SinkKind& kind,
                 void* pixels,
                 Sink& out) noexcept;

// For Sink::levels, of canvases of 1 and 2 bits that dither or have another
// threshold.
decltype(Sink::levels) shifted_two_level_rule() noexcept;
decltype(Sink::levels) shifted_four_level_rule() noexcept;

// Draws all pixels of a sink's window.
void fill(const Sink& sink) noexcept;

}  // namespace detail

/// `Pixels` is what the functions of the sink take.
template <typename Pixels>
class Canvas : public Sink {
 public:
  Canvas(const Canvas& other) noexcept
      : Sink(other), pixels_(other.pixels_), status_(other.status_) {
    context = &pixels_;
  }
  Canvas& operator=(const Canvas& other) noexcept {
    Sink::operator=(other);
    pixels_ = other.pixels_;
    status_ = other.status_;
    context = &pixels_;
    return *this;
  }

  /// What is wrong with the strip: see pixel.hpp. Nothing fails, but pixels
  /// that its bytes do not hold are outside of the window, and lost.
  Status status() const noexcept { return status_; }

  /// The rows that it draws into.
  const Strip& strip() const noexcept { return pixels_.strip; }
  /// From here on it draws into another strip, in the same way.
  void set_strip(const Strip& strip) noexcept {
    pixels_.strip = strip;
    status_ = detail::cut_strip(pixels_.strip, Pixels::kKind.layout);
    window = pixels_.strip.rect();
  }

  /// Fills the window with the foreground.
  void fill() const noexcept { detail::fill(*this); }

  const Pixels& pixels() const noexcept { return pixels_; }

 protected:
  template <typename... Ink>
  explicit Canvas(const Strip& strip, Ink... ink) noexcept
      : pixels_{strip, ink...},
        status_(
            detail::open_sink(pixels_.strip, Pixels::kKind, &pixels_, *this)) {}

  Pixels pixels_;

 private:
  Status status_;
};

}  // namespace inkcell::port
