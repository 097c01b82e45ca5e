// The drawing surface of the demo: a strip in the display's format, and four
// inks.
//
// The build sets size and format: INKCELL_DISPLAY_WIDTH, INKCELL_DISPLAY_HEIGHT
// [px], INKCELL_DEMO_FORMAT (an enumerator of port::PixelFormat), and
// INKCELL_DEMO_NAME, the namespace of the demo, so that one program can hold
// the demos of several displays.
#pragma once

#include <stdint.h>

#include "inkcell/port/grey4.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/port/rgb565.hpp"
#include "inkcell/port/xrgb8888.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::demo {
inline namespace INKCELL_DEMO_NAME {

inline constexpr int32_t kWidth = INKCELL_DISPLAY_WIDTH;
inline constexpr int32_t kHeight = INKCELL_DISPLAY_HEIGHT;
inline constexpr port::PixelFormat kFormat =
    port::PixelFormat::INKCELL_DEMO_FORMAT;

enum class Ink : uint8_t { background, clock, text, moving };

// The colour of each ink in each format.
namespace detail {

inline constexpr uint32_t kColours[] = {  // 0xRRGGBB
    0x101820, 0xffb000, 0xf0f0f0, 0x40c0ff};
inline constexpr uint8_t kGreys[] = {0, 15, 11, 13};

constexpr uint32_t colour(Ink ink) noexcept {
  return kColours[static_cast<uint8_t>(ink)];
}

template <port::PixelFormat>
struct Paint;

template <>
struct Paint<port::PixelFormat::grey4> {
  using Canvas = port::Grey4Canvas;
  static void set(Canvas& canvas, Ink ink) noexcept {
    canvas.set_level(kGreys[static_cast<uint8_t>(ink)]);
  }
};

template <>
struct Paint<port::PixelFormat::mono_pages> {
  using Canvas = port::MonoPagesCanvas;
  static void set(Canvas& canvas, Ink ink) noexcept {
    canvas.set_level(ink == Ink::background ? 0 : 1);
  }
};

template <>
struct Paint<port::PixelFormat::rgb565> {
  using Canvas = port::Rgb565Canvas;
  static void set(Canvas& canvas, Ink ink) noexcept {
    canvas.set_colour(port::rgb565(static_cast<uint8_t>(colour(ink) >> 16),
                                   static_cast<uint8_t>(colour(ink) >> 8),
                                   static_cast<uint8_t>(colour(ink))));
  }
};

template <>
struct Paint<port::PixelFormat::xrgb8888> {
  using Canvas = port::Xrgb8888Canvas;
  static void set(Canvas& canvas, Ink ink) noexcept {
    canvas.set_colour(0xff000000 | colour(ink));
  }
};

}  // namespace detail

/// A strip filled with the background, and its sinks.
class Canvas {
 public:
  explicit Canvas(const Strip& strip) noexcept : canvas_(strip) {
    Paint::set(canvas_, Ink::background);
    canvas_.fill();
  }

  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// A sink for this ink, valid until the next call.
  const Sink& sink(Ink ink) noexcept {
    Paint::set(canvas_, ink);
    return canvas_;
  }

 private:
  using Paint = detail::Paint<kFormat>;

  Paint::Canvas canvas_;
};

}  // namespace INKCELL_DEMO_NAME
}  // namespace inkcell::demo
