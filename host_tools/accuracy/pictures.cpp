#include "pictures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "canvas.hpp"
#include "rom_file.hpp"

namespace inkcell::tools {
namespace {

constexpr int kPanel = 256;  // side of the square around an enlarged glyph [px]
constexpr int kGap = 12;
constexpr int kCaption = 24;       // height of a line of caption [px]
constexpr double kCaptionPx = 12;  // its size [px/em]
constexpr int kLargestZoom = 14;
constexpr double kAmplify = 8;
constexpr int kPanels = 3;

struct Colour {
  double red;
  double green;
  double blue;
};

constexpr Colour kFrame = {214, 40, 40};

void put(Image& image, int x, int y, const Colour& colour) {
  uint8_t* pixel = image.at(x, y);
  pixel[0] = static_cast<uint8_t>(std::lround(colour.red));
  pixel[1] = static_cast<uint8_t>(std::lround(colour.green));
  pixel[2] = static_cast<uint8_t>(std::lround(colour.blue));
}

Colour grey(double coverage) {
  return {255 - coverage, 255 - coverage, 255 - coverage};
}

Colour difference(double drawn, double exact) {
  const double strength = std::min(255.0, kAmplify * std::fabs(drawn - exact));
  const double rest = 255 - strength;
  return drawn > exact ? Colour{255, rest, rest} : Colour{rest, rest, 255};
}

bool can_write(const Font& font, const std::string& text) {
  for (const char32_t c : from_utf8(text)) {
    uint16_t glyph = 0;
    if (font.glyph_of(c, glyph) != Status::ok) {
      return false;
    }
  }
  return true;
}

void write(
    const Font& font, const std::string& text, int x, int y, Image& out) {
  if (!can_write(font, text)) {
    return;
  }
  Image ink(kPanel, kCaption);
  const Style style = make_style(kCaptionPx, 0, kFilterText);
  draw_lines(font, {lay_out(font, text, Kerning::font, style)}, style,
             make_point(0, 0.7 * kCaption), ink);
  for (int row = 0; row < ink.height; ++row) {
    for (int column = 0; column < ink.width; ++column) {
      if (*ink.at(column, row) != 0) {
        put(out, x + column, y + row, grey(*ink.at(column, row)));
      }
    }
  }
}

std::string caption_of(const Exhibit& exhibit) {
  char text[96];
  std::snprintf(text, sizeof text, " %g px, %s: %d for %.1f", exhibit.px,
                std::string(exhibit.filter).c_str(), exhibit.worst.drawn,
                exhibit.worst.exact);
  return to_utf8(exhibit.worst.code_point) + text;
}

// Three panels of one glyph, their upper left corner at (x0, y0).
class Panels {
 public:
  Panels(const Exhibit& exhibit, int x0, int y0, Image& out)
      : exhibit_(exhibit), x0_(x0), y0_(y0), out_(out) {
    const Image& drawn = exhibit.picture.drawn;
    zoom_ = std::clamp(kPanel / std::max(drawn.width, drawn.height), 1,
                       kLargestZoom);
  }

  void draw() {
    const Image& drawn = exhibit_.picture.drawn;
    // A glyph larger than a panel is cut to its worst pixel.
    const int across = std::min(drawn.width, kPanel / zoom_);
    const int down = std::min(drawn.height, kPanel / zoom_);
    const int worst_x = exhibit_.worst.x - exhibit_.picture.x0;
    const int worst_y = exhibit_.worst.y - exhibit_.picture.y0;
    const int left = std::clamp(worst_x - across / 2, 0, drawn.width - across);
    const int top = std::clamp(worst_y - down / 2, 0, drawn.height - down);
    for (int y = 0; y < down; ++y) {
      for (int x = 0; x < across; ++x) {
        draw_pixel(x, y, left + x, top + y);
      }
    }
    for (int panel = 0; panel < kPanels; ++panel) {
      frame(panel, worst_x - left, worst_y - top);
    }
  }

 private:
  int panel_x(int panel) const { return x0_ + panel * (kPanel + kGap); }

  void draw_pixel(int x, int y, int from_x, int from_y) {
    const Image& image = exhibit_.picture.drawn;
    const double drawn = *image.at(from_x, from_y);
    const double exact =
        exhibit_.picture.exact[static_cast<size_t>(from_y) *
                                   static_cast<size_t>(image.width) +
                               static_cast<size_t>(from_x)];
    const Colour colours[kPanels] = {grey(drawn), grey(exact),
                                     difference(drawn, exact)};
    for (int panel = 0; panel < kPanels; ++panel) {
      for (int i = 0; i < zoom_ * zoom_; ++i) {
        put(out_, panel_x(panel) + x * zoom_ + i % zoom_,
            y0_ + y * zoom_ + i / zoom_, colours[panel]);
      }
    }
  }

  // A frame around a pixel.
  void frame(int panel, int x, int y) {
    const int left = panel_x(panel) + x * zoom_ - 1;
    const int top = y0_ + y * zoom_ - 1;
    for (int i = 0; i < zoom_ + 2; ++i) {
      put(out_, left + i, top, kFrame);
      put(out_, left + i, top + zoom_ + 1, kFrame);
      put(out_, left, top + i, kFrame);
      put(out_, left + zoom_ + 1, top + i, kFrame);
    }
  }

  const Exhibit& exhibit_;
  int x0_;
  int y0_;
  Image& out_;
  int zoom_ = 1;
};

}  // namespace

Image draw_exhibits(const Font& font, const std::vector<Exhibit>& exhibits) {
  constexpr int kHeight = kCaption + kPanel + kGap;
  const int count = static_cast<int>(exhibits.size());
  Image image(kPanels * (kPanel + kGap) + kGap, 2 * kGap + count * kHeight, 3,
              255);
  int y = kGap;
  for (const Exhibit& exhibit : exhibits) {
    const std::string titles[kPanels] = {caption_of(exhibit), "exact",
                                         "difference x 8"};
    for (int panel = 0; panel < kPanels; ++panel) {
      write(font, titles[panel], kGap + panel * (kPanel + kGap), y, image);
    }
    Panels(exhibit, kGap, y + kCaption, image).draw();
    y += kHeight;
  }
  return image;
}

}  // namespace inkcell::tools
