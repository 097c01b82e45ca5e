// Text on the display objects of TFT_eSPI, Adafruit_GFX and their children, by
// the calls that sketches know.
//
//   InkcellPrint text(tft);
//   text.setFont(fonts::sans, 24);          // any size of one font
//   text.setTextColor(TFT_WHITE, TFT_NAVY);  // ink and paper
//   text.setCursor(4, 28);                  // left end of the baseline
//   text.print("Out: ");
//   text.println(21.5, 1);
//
// Text is UTF-8, and fitted to the grid of pixels up to 40 px. It is drawn in
// tiles of 1 KB, which this object holds, and sent by pushImage(),
// drawRGBBitmap() or, on 1-bit displays, drawBitmap(): rotation, sprites and
// canvases of those libraries work. Call display() of an OLED yourself.
#pragma once

#include <Arduino.h>
#include <stddef.h>
#include <stdint.h>

#include "inkcell/fit.hpp"
#include "inkcell/inkcell.hpp"
#include "inkcell/layout/layout.hpp"
#include "inkcell/port/gfx_canvas.hpp"
#include "inkcell/strike/strike.hpp"

namespace inkcell::arduino {

// What a tile is sent with.
struct Colours {
  uint16_t ink = 0xffff;
  uint16_t paper = 0;
  bool has_paper = false;
};

// The functions of a display. `read` may be null.
struct DisplayKind {
  int32_t (*width)(void* display);
  int32_t (*height)(void* display);
  ByteOrder (*order)(void* display);
  uint16_t (*read)(void* display, int32_t x, int32_t y);
  void (*send)(void* display, const Strip& tile);
  void (*send_bits)(void* display, const Strip& tile, const Colours& colours);
};

// Each pair below: what a class has, and what holds if it has not.
template <typename Display>
auto send_to(Display& display, const Strip& tile, int)
    -> decltype(display.getSwapBytes(), void()) {
  display.pushImage(tile.x0, tile.y0, tile.width, tile.height,
                    reinterpret_cast<uint16_t*>(tile.pixels.data));
}
template <typename Display>
void send_to(Display& display, const Strip& tile, long) {
  display.drawRGBBitmap(
      static_cast<int16_t>(tile.x0), static_cast<int16_t>(tile.y0),
      reinterpret_cast<uint16_t*>(tile.pixels.data),
      static_cast<int16_t>(tile.width), static_cast<int16_t>(tile.height));
}

template <typename Display>
auto order_of(Display& display, int)
    -> decltype(display.getSwapBytes(), ByteOrder()) {
  return display.getSwapBytes() ? ByteOrder::low_first : ByteOrder::high_first;
}
template <typename Display>
ByteOrder order_of(Display&, long) {
  return port::kNativeOrder;
}

// Panels cannot be read, canvases and sprites can.
template <typename Display>
constexpr auto reader_of(int)
    -> decltype(static_cast<Display*>(nullptr)->getPixel(0, 0),
                static_cast<uint16_t (*)(void*, int32_t, int32_t)>(nullptr)) {
  return [](void* display, int32_t x, int32_t y) {
    return static_cast<uint16_t>(static_cast<Display*>(display)->getPixel(
        static_cast<int16_t>(x), static_cast<int16_t>(y)));
  };
}
template <typename Display>
constexpr auto reader_of(long)
    -> decltype(static_cast<Display*>(nullptr)->getPointer(),
                static_cast<uint16_t (*)(void*, int32_t, int32_t)>(nullptr)) {
  return [](void* display, int32_t x, int32_t y) {
    return static_cast<Display*>(display)->readPixel(x, y);
  };
}
template <typename Display>
constexpr uint16_t (*reader_of(...))(void*, int32_t, int32_t) {
  return nullptr;
}

// A buffer of bytes is one of 1-bit pixels: OLEDs, GFXcanvas1.
inline constexpr bool is_bytes(uint8_t*) {
  return true;
}
template <typename Pixel>
constexpr bool is_bytes(Pixel*) {
  return false;
}
template <typename Display>
auto is_bilevel(Display& display, int)
    -> decltype(display.getBuffer(), bool()) {
  return is_bytes(static_cast<decltype(display.getBuffer())>(nullptr));
}
template <typename Display>
bool is_bilevel(Display&, long) {
  return false;
}

template <typename Display>
const DisplayKind& kind_of() {
  static constexpr DisplayKind kKind = {
      [](void* display) -> int32_t {
        return static_cast<Display*>(display)->width();
      },
      [](void* display) -> int32_t {
        return static_cast<Display*>(display)->height();
      },
      [](void* display) {
        return order_of(*static_cast<Display*>(display), 0);
      },
      reader_of<Display>(0),
      [](void* display, const Strip& tile) {
        send_to(*static_cast<Display*>(display), tile, 0);
      },
      [](void* display, const Strip& tile, const Colours& colours) {
        auto& target = *static_cast<Display*>(display);
        const auto x = static_cast<int16_t>(tile.x0);
        const auto y = static_cast<int16_t>(tile.y0);
        const auto width = static_cast<int16_t>(tile.width);
        const auto height = static_cast<int16_t>(tile.height);
        if (colours.has_paper) {
          target.drawBitmap(x, y, tile.pixels.data, width, height, colours.ink,
                            colours.paper);
        } else {
          target.drawBitmap(x, y, tile.pixels.data, width, height, colours.ink);
        }
      }};
  return kKind;
}

}  // namespace inkcell::arduino

/// Prints on a display, which must outlive it. print(), println() and printf()
/// are those of Arduino's Print.
class InkcellPrint : public Print {
 public:
  /// Displays whose getBuffer() returns bytes get 1-bit pixels.
  template <typename Display>
  explicit InkcellPrint(Display& display)
      : display_(&display),
        kind_(inkcell::arduino::kind_of<Display>()),
        is_mono_(inkcell::arduino::is_bilevel(display, 0)) {}
  InkcellPrint(const InkcellPrint&) = delete;
  InkcellPrint& operator=(const InkcellPrint&) = delete;

  /// A font, which must outlive it, and px to the em: 24, 13.5 or 13.5_px.
  /// False: the size is not above 0, or the bytes are no outlines of this
  /// version, such as strikes, which setStrikes() takes; nothing is printed
  /// then. A line that a line feed has begun keeps its top, so that its paper
  /// does not cover the line before.
  bool setFont(inkcell::Span<const uint8_t> font, inkcell::Q26_6 size) {
    style_ = inkcell::Style(size);
    is_open_ =
        size.raw > 0 && inkcell::Font::open(font, font_) == inkcell::Status::ok;
    fit();
    keep_top();
    return is_open_;
  }
  bool setFont(inkcell::Span<const uint8_t> font, double size) {
    return setFont(font,
                   inkcell::Q26_6::from_raw(static_cast<int32_t>(size * 64)));
  }
  bool setFont(inkcell::Span<const uint8_t> font, int size) {
    return setFont(font, static_cast<double>(size));
  }

  /// The same of strikes of 1 bit, pictures of letters at one size that
  /// `inkcell-fontgen --strike 11:1 --strike-only` makes. A sketch that calls
  /// setFont() nowhere takes 15 KB less flash. False: `size` is no multiple,
  /// or the font has outlines, which setFont() takes.
  bool setStrikes(inkcell::Span<const uint8_t> font, int size) {
    style_ = inkcell::Style(inkcell::Q26_6::from_int(size));
    is_open_ = inkcell::Font::open(font, inkcell::kBitStrikeCoding, font_) ==
                   inkcell::Status::ok &&
               font_.check(style_) == inkcell::Status::ok;
    keep_top();
    return is_open_;
  }

  /// For displays of two colours that the constructor does not know: e-paper.
  void setMonochrome(bool is_mono) {
    is_mono_ = is_mono;
    fit();
  }

  /// RGB565, or the colours of a 1-bit display. Without a paper text is drawn
  /// on what is there, where that can be read: 1-bit displays, canvases,
  /// sprites. On panels the paper is black then.
  void setTextColor(uint16_t ink) { colours_ = {ink, 0, false}; }
  void setTextColor(uint16_t ink, uint16_t paper) {
    colours_ = {ink, paper, true};
  }

  /// Where the next character stands: the left end of its baseline.
  void setCursor(int x, int y) {
    x_ = inkcell::Q26_6::from_int(x);
    y_ = y;
    new_line_ascent_ = 0;
    held_count_ = 0;
  }
  int16_t getCursorX() const { return static_cast<int16_t>(ceil_px(x_)); }
  int16_t getCursorY() const { return static_cast<int16_t>(y_); }

  /// Whether lines end at the right edge, between words where possible.
  void setTextWrap(bool wraps) { wraps_ = wraps; }

  /// Px from one baseline to the next, and from the top of a line to its
  /// baseline.
  int16_t fontHeight() const {
    return static_cast<int16_t>(
        is_open_ ? inkcell::line_height(options()).floor() : 0);
  }
  int16_t fontAscent() const {
    return static_cast<int16_t>(is_open_ ? inkcell::baseline(options()).floor()
                                         : 0);
  }

  /// Whether the font has each character of a text; others are drawn as boxes.
  bool hasGlyphs(const char* text) const {
    inkcell::Text rest = text;
    uint16_t glyph = 0;
    while (rest.size > 0) {
      const uint32_t code = inkcell::next_code_point(rest);
      if (code >= ' ' && font_.glyph_of(code, glyph) != inkcell::Status::ok) {
        return false;
      }
    }
    return is_open_;
  }

  /// How far the cursor goes.
  int16_t textWidth(const char* text) const {
    return static_cast<int16_t>(is_open_ ? ceil_px(width_of(text)) : 0);
  }
  int16_t textWidth(const String& text) const {
    return textWidth(text.c_str());
  }

  /// The pixels that a line at (x, y) may touch.
  void getTextBounds(const char* text,
                     int16_t x,
                     int16_t y,
                     int16_t* left,
                     int16_t* top,
                     uint16_t* width,
                     uint16_t* height) const {
    inkcell::Rect box;
    if (is_open_) {
      box = inkcell::Painter().box(font_, style_, {x, y}, text);
    }
    *left = static_cast<int16_t>(box.x0);
    *top = static_cast<int16_t>(box.y0);
    *width = static_cast<uint16_t>(box.x1 - box.x0);
    *height = static_cast<uint16_t>(box.y1 - box.y0);
  }
  void getTextBounds(const String& text,
                     int16_t x,
                     int16_t y,
                     int16_t* left,
                     int16_t* top,
                     uint16_t* width,
                     uint16_t* height) const {
    getTextBounds(text.c_str(), x, y, left, top, width, height);
  }

  using Print::write;
  size_t write(uint8_t byte) override { return write(&byte, 1); }
  /// The bytes of a character may come in several calls.
  size_t write(const uint8_t* bytes, size_t count) override {
    if (!is_open_) {
      setWriteError();
      return 0;
    }
    size_t done = 0;
    while (held_count_ > 0 && done < count) {
      held_[held_count_++] = bytes[done++];
      if (held_count_ == sizeof held_ || unfinished(held_, held_count_) == 0) {
        print_text({reinterpret_cast<char*>(held_), held_count_});
        held_count_ = 0;
      }
    }
    const size_t rest = count - done;
    const size_t open = unfinished(bytes + done, rest);
    print_text({reinterpret_cast<const char*>(bytes) + done, rest - open});
    for (size_t i = count - open; i < count; ++i) {
      held_[held_count_++] = bytes[i];
    }
    return count;
  }

 private:
  static constexpr size_t kTileBytes = 1024;

  static int32_t ceil_px(inkcell::Q26_6 value) { return (value.raw + 63) >> 6; }

  // Bytes at the end of a text that begin a character and do not end it.
  static size_t unfinished(const uint8_t* bytes, size_t count) {
    for (size_t back = 1; back <= 3 && back <= count; ++back) {
      const uint8_t byte = bytes[count - back];
      if (byte >= 0xc0) {
        const size_t length = byte >= 0xf0 ? 4 : byte >= 0xe0 ? 3 : 2;
        return length > back ? back : 0;
      }
      if (byte < 0x80) {
        return 0;
      }
    }
    return 0;
  }

  void fit() {
    if (!is_open_) {
      return;
    }
    inkcell::FitOptions options;
    options.across = is_mono_ || style_.size().raw < 12 * 64;
    options.levels = is_mono_ ? 2 : 0;
    style_ = inkcell::Style(style_.size());
    if (inkcell::Fit::make(font_, style_, options, fit_) ==
        inkcell::Status::ok) {
      style_.set_fit(fit_);
    }
  }

  inkcell::LayoutOptions options() const { return {font_, style_}; }

  inkcell::Q26_6 width_of(inkcell::Text text) const {
    return inkcell::Painter().measure(font_, style_, text).advance;
  }

  // Whether a text, less the spaces that end it, has room in the line.
  bool has_room(const char* text, size_t count) const {
    while (count > 0 && (text[count - 1] == ' ' || text[count - 1] == '\n' ||
                         text[count - 1] == '\r')) {
      --count;
    }
    return !wraps_ ||
           x_.raw + width_of({text, count}).raw <= kind_.width(display_) * 64;
  }

  void end_line() {
    x_ = {};
    y_ += fontHeight();
    new_line_ascent_ = fontAscent();
  }

  // Another font begins: no character goes on, and an empty line moves its
  // baseline.
  void keep_top() {
    held_count_ = 0;
    if (new_line_ascent_ > 0 && is_open_) {
      y_ += fontAscent() - new_line_ascent_;
      new_line_ascent_ = fontAscent();
    }
  }

  // Goes from one place where a line may end to the next, and draws when there
  // is no more room, or a line ends.
  void print_text(inkcell::Text text) {
    inkcell::LineBreaker breaker(text);
    inkcell::LineBreak place;
    size_t begin = 0;
    for (size_t last = 0; breaker.next(place); last = place.offset) {
      const size_t end = place.offset;
      if (!has_room(text.data + begin, end - begin)) {
        draw({text.data + begin, last - begin});
        begin = last;
        if (x_.raw > 0) {
          end_line();
        }
        begin += draw_long({text.data + begin, end - begin});
      }
      if (place.is_mandatory) {
        draw({text.data + begin, end - begin});
        if (text.data[end - 1] == '\n') {
          end_line();
        }
        begin = end;
      }
    }
  }

  // Draws the lines of a word that is longer than a line, but for the last one.
  size_t draw_long(inkcell::Text word) {
    size_t begin = 0;
    while (!has_room(word.data + begin, word.size - begin)) {
      inkcell::Text rest = {word.data + begin, word.size - begin};
      size_t fits = 0;
      do {
        static_cast<void>(inkcell::next_code_point(rest));
        const size_t end = word.size - begin - rest.size;
        if (fits > 0 && !has_room(word.data + begin, end)) {
          break;
        }
        fits = end;
      } while (rest.size > 0);
      draw({word.data + begin, fits});
      end_line();
      begin += fits;
      if (begin == word.size) {
        break;
      }
    }
    return begin;
  }

  // Draws a run at the cursor, with the paper of its line, and goes past it.
  void draw(inkcell::Text run) {
    new_line_ascent_ = run.size > 0 ? 0 : new_line_ascent_;
    const inkcell::Point origin = {x_, inkcell::Q26_6::from_int(y_)};
    const int32_t first = x_.floor();
    x_.raw += width_of(run).raw;
    inkcell::Rect area = inkcell::Painter().box(font_, style_, origin, run);
    if (colours_.has_paper && ceil_px(x_) > first) {
      const int32_t top = y_ - fontAscent();
      const inkcell::Rect cell = {first, top, ceil_px(x_), top + fontHeight()};
      area = inkcell::is_empty(area)
                 ? cell
                 : inkcell::Rect{area.x0 < cell.x0 ? area.x0 : cell.x0,
                                 area.y0 < cell.y0 ? area.y0 : cell.y0,
                                 area.x1 > cell.x1 ? area.x1 : cell.x1,
                                 area.y1 > cell.y1 ? area.y1 : cell.y1};
    }
    area = inkcell::intersect(
        area, {0, 0, kind_.width(display_), kind_.height(display_)});
    const inkcell::ByteOrder order = kind_.order(display_);
    const int32_t most = is_mono_ ? 8 * 64 : 256;  // a tile's columns
    for (int32_t x = area.x0; x < area.x1; x += most) {
      const int32_t width = area.x1 - x < most ? area.x1 - x : most;
      const int32_t stride = is_mono_ ? (width + 7) / 8 : 2 * width;
      const int32_t rows = static_cast<int32_t>(kTileBytes) / stride;
      for (int32_t y = area.y0; y < area.y1; y += rows) {
        const int32_t height = area.y1 - y < rows ? area.y1 - y : rows;
        draw_tile({tile_, x, y, width, height, stride, order}, origin, run);
      }
    }
  }

  void draw_tile(const inkcell::Strip& tile,
                 inkcell::Point origin,
                 inkcell::Text run) {
    if (is_mono_) {
      const inkcell::port::MonoRowsCanvas canvas(tile, 1, 0);
      inkcell::Painter(canvas).text(font_, style_, origin, run);
      kind_.send_bits(display_, tile, colours_);
      return;
    }
    inkcell::port::Rgb565Canvas canvas(tile, colours_.paper);
    if (!colours_.has_paper && kind_.read != nullptr) {
      read_tile(tile);
    } else {
      canvas.fill();
    }
    canvas.set_colour(colours_.ink);
    inkcell::Painter(canvas).text(font_, style_, origin, run);
    kind_.send(display_, tile);
  }

  void read_tile(const inkcell::Strip& tile) {
    uint8_t* byte = tile_;
    const int high = tile.order == inkcell::ByteOrder::high_first ? 0 : 1;
    for (int32_t y = tile.y0; y < tile.y0 + tile.height; ++y) {
      for (int32_t x = tile.x0; x < tile.x0 + tile.width; ++x, byte += 2) {
        const uint16_t colour = kind_.read(display_, x, y);
        byte[high] = static_cast<uint8_t>(colour >> 8);
        byte[1 - high] = static_cast<uint8_t>(colour & 0xff);
      }
    }
  }

  void* display_;
  const inkcell::arduino::DisplayKind& kind_;
  bool is_mono_;
  bool is_open_ = false;
  bool wraps_ = true;
  inkcell::arduino::Colours colours_;
  inkcell::Q26_6 x_;
  int32_t y_ = 0;
  int32_t new_line_ascent_ = 0;  // of a line without text; 0: of others
  inkcell::Font font_;
  inkcell::Style style_;
  inkcell::Fit fit_;
  uint8_t held_[4];
  size_t held_count_ = 0;
  alignas(4) uint8_t tile_[kTileBytes];
};
