// A font of ESPHome that draws with Inkcell.
#pragma once

#include "esphome/components/display/display.h"
#include "inkcell/fit.hpp"
#include "inkcell/font.hpp"
#include "inkcell/style.hpp"

namespace esphome {
namespace inkcell_font {

class InkcellFont : public display::BaseFont {
 public:
  /// `rom` must outlive it. Px to the em in 1/64 px. With two colours text is
  /// fitted to their grid, and pixels are either the colour or untouched, as on
  /// any display of two colours.
  InkcellFont(const uint8_t* rom,
              size_t rom_size,
              int32_t size_q6,
              bool two_colours);
  InkcellFont(const InkcellFont&) = delete;

  /// (x, y) is the upper left corner of the line.
  void print(int x,
             int y,
             display::Display* display,
             Color color,
             const char* text,
             Color background) override;
  void measure(const char* text,
               int* width,
               int* x_offset,
               int* baseline,
               int* height) override;

 private:
  int ascent() const;

  ::inkcell::Font font_;
  ::inkcell::Style style_;
  ::inkcell::Fit fit_;
  bool is_open_;
  bool two_colours_;
};

}  // namespace inkcell_font
}  // namespace esphome
