// Sheets of the same text, drawn by different methods.
#include "compare.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "canvas.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/supersample.hpp"
#include "sheet.hpp"

namespace inkcell::tools {
namespace {

// A line of a sample. [px]
struct Entry {
  const char* text;
  double px;
  double x;
  double y;
};

template <size_t kCount>
using Entries = std::array<Entry, kCount>;

// Black on white in three channels. `ink`: one channel, 255 is full ink.
void print(const Image& ink, Image& image) {
  for (size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = static_cast<uint8_t>(255 - ink.pixels[i / 3]);
  }
}

template <size_t kCount>
Image compare(const Font& font,
              PeerFont& peers,
              const std::string& sizes,
              const SheetLayout& layout,
              const Entries<kCount>& entries) {
  Sheet sheet(font, sizes, layout);
  const auto add_peer = [&](const char* label, Peer peer) {
    sheet.add(label, 0xffffff, [&](Image& image) {
      Image ink(image.width, image.height);
      for (const Entry& e : entries) {
        peers.write(peer, e.text, e.px, e.x, e.y, ink);
      }
      print(ink, image);
    });
  };
  // `set_up` may change the style for the size.
  const auto add_ours = [&](const char* label, const auto& filter,
                            const std::function<void(Style&)>& set_up) {
    sheet.add(label, 0xffffff, [&](Image& image) {
      for (const Entry& e : entries) {
        Style style = make_style(e.px, 0, filter);
        set_up(style);
        write_text(font, e.text, style, e.x, e.y, 0, image);
      }
    });
  };
  add_peer("4 samples a pixel, box filter", Peer::box4);
  add_peer("16 samples a pixel, Gaussian filter", Peer::gauss16);
  add_peer("FreeType, not hinted", Peer::freetype);
  add_peer("FreeType, light hinting", Peer::light);
  const auto plain = [](Style&) {};
  add_ours("Inkcell, filter text", kFilterText, plain);
  add_ours("Inkcell, filter paper_body", kFilterPaperBody, plain);
  add_ours("Inkcell, filter paper_display", kFilterPaperDisplay, plain);
  Fit fit;
  add_ours("Inkcell, fitted to the grid", kFilterText, [&](Style& style) {
    if (Fit::make(font, style, {}, fit) != Status::ok) {
      throw std::runtime_error("the font's hints are broken");
    }
    style.set_fit(fit);
  });
  if (font.has_outlines()) {
    add_ours("Inkcell, filter area", kFilterArea, plain);
    return sheet.finish();
  }
  const Supersample supersample;
  add_ours("Inkcell, up to 13 samples a pixel", kFilterText,
           [&](Style& style) { style.set_effect(supersample); });
  return sheet.finish();
}

}  // namespace

Image compare_body(const Font& font, PeerFont& peers) {
  constexpr const char* kText = "Sphinx of black quartz";
  const Entries<4> entries = {{{kText, 8, 3, 9},
                               {kText, 10, 3, 21},
                               {kText, 12, 3, 34},
                               {kText, 16, 3, 52}}};
  return compare(font, peers, "8, 10, 12 and 16", {164, 58, 3, 0, 164},
                 entries);
}

Image compare_display(const Font& font, PeerFont& peers) {
  const Entries<2> entries = {{{"HPJE", 40, 4.3, 40}, {"g", 40, 112.3, 34}}};
  return compare(font, peers, "40", {140, 48, 3, 0, 140}, entries);
}

}  // namespace inkcell::tools
