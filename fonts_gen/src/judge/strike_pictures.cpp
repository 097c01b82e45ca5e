#include "judge/strike_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "base/error.hpp"
#include "inkcell/few_levels.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/strike/outline_strike.hpp"
#include "inkcell/strike/strike.hpp"
#include "inkcell/text.hpp"
#include "judge/canvas.hpp"

namespace inkcell::gen {
namespace {

// What strikes of 4 bits may differ by: half a level. [1/255]
constexpr int kHalfLevel = 8;

const detail::LevelRule* rule_of(int bits) {
  return bits == 1   ? &detail::kTwoLevelRule
         : bits == 2 ? &detail::kFourLevelRule
                     : nullptr;
}

// The style that a strike serves.
Style style_of(const StrikeTarget& target) {
  const Q26_6 size = Q26_6::from_int(target.px);
  const bool is_fitted = target.fit == format::StrikeFit::both;
  Style style = is_fitted ? strike_style(size) : Style(size).clear_fit();
  if (target.fit == format::StrikeFit::heights) {
    style = strike_height_style(size);
  } else if (target.bits < 4) {
    const detail::LevelRule& rule = *rule_of(target.bits);
    style.set_effect(*rule.effect);
    if (is_fitted) {
      style.set_fit(*rule.own, nullptr);
    }
  }
  return style;
}

// What a canvas of so many bits makes of coverage, to the nearest.
int value_of(int coverage, int bits) {
  const int full = (1 << bits) - 1;
  return bits == 1 ? (coverage >= 128 ? 1 : 0) : (coverage * full + 127) / 255;
}

// A glyph of `box` [px], with room for what fitting moves, drawn on a canvas of
// so many bits.
Canvas draw(const Font& font,
            const Style& style,
            uint16_t glyph,
            int bits,
            const Rect& box) {
  const int room = 4 + style.size().raw / 512;
  Canvas canvas(
      Rect{box.x0 - room, box.y0 - room, box.x1 + room, box.y1 + room});
  Sink sink = canvas.sink();
  sink.levels = rule_of(bits);
  inkcell::Painter(sink).glyph(font, style, {}, glyph);
  return canvas;
}

// The pixels of a glyph as designed.
Rect box_px(const RomContent& content, size_t glyph, int px) {
  const GlyphMetrics& m = content.glyphs[glyph].metrics;
  const int em = content.metrics.units_per_em;
  const auto floor_px = [&](int units) {
    return units * px / em - (units < 0 ? 1 : 0);
  };
  return {floor_px(m.x_min), floor_px(-m.y_max), floor_px(m.x_max) + 2,
          floor_px(-m.y_min) + 2};
}

// Font units to whole pixels.
int px_of(int units, int px, const RomContent& content) {
  return static_cast<int>(std::lround(static_cast<double>(units) * px /
                                      content.metrics.units_per_em));
}

// The pairs of characters that kern by whole pixels in fitted text.
KerningMatrix fitted_kerning(const SourceFont& source,
                             const RomContent& content,
                             const Font& font,
                             const Style& style,
                             const std::vector<int>& advances_px) {
  const int px = style.size().raw / 64;
  const size_t count = advances_px.size();
  std::vector<std::string> texts(count);
  for (const auto& [code_point, glyph] : content.glyph_of) {
    texts[glyph] = to_utf8(code_point);
  }
  std::vector<size_t> lefts;
  std::vector<std::vector<int16_t>> rows;
  for (size_t left = 0; left < count && !content.kerning.empty(); ++left) {
    if (content.kerning.left_class[left] == 0) {
      continue;
    }
    lefts.push_back(left);
    rows.emplace_back(count);
    for (size_t right = 0; right < count; ++right) {
      const int units = content.kerning.value(left, right);
      int kerning_px = px_of(units, px, content);
      if (units != 0 && !source.glyphs[left].picture.has_value()) {
        const std::string pair = texts[left] + texts[right];
        TextCursor cursor(font, {pair.data(), pair.size()}, style);
        PositionedGlyph at = {};
        while (cursor.next(at)) {
        }
        kerning_px = px_of(at.x, px, content) - advances_px[left];
      }
      rows.back()[right] = static_cast<int16_t>(kerning_px);
    }
  }
  return join_classes(count, lefts, rows);
}

// Throws Error unless is_same(x, y) of all pixels.
template <typename IsSame>
void check_pixels(const RomContent& content,
                  const StrikeTarget& target,
                  size_t glyph,
                  const Rect& area,
                  const IsSame& is_same) {
  for (int y = area.y0; y < area.y1; ++y) {
    for (int x = area.x0; x < area.x1; ++x) {
      if (!is_same(x, y)) {
        throw Error(content.name + ": --strike " + std::to_string(target.px) +
                    ":" + std::to_string(target.bits) +
                    " shows another picture of glyph " + std::to_string(glyph) +
                    "; nothing was written. This is an error of the "
                    "generator: please report it");
      }
    }
  }
}

// A picture of a bitmap font, with more bits.
Picture deeper(Picture picture, int from_bits, int to_bits) {
  for (uint8_t& value : picture.values) {
    value = static_cast<uint8_t>(value * ((1 << to_bits) - 1) /
                                 ((1 << from_bits) - 1));
  }
  return picture;
}

}  // namespace

Status open_font(const std::vector<uint8_t>& bytes, Font& out) {
  const Span<const uint8_t> rom = {bytes.data(), bytes.size()};
  const Status status = open_any_font(rom, out);
  return status == Status::unsupported ? Font::open(rom, kStrikeCoding, out)
                                       : status;
}

DrawnStrike draw_strike(const SourceFont& source,
                        const RomContent& content,
                        const std::vector<uint8_t>& bytes,
                        const StrikeTarget& target,
                        size_t count) {
  Font font;
  if (open_font(bytes, font) != Status::ok) {
    throw Error(content.name + ": the device cannot read its outlines");
  }
  const Style style = style_of(target);
  DrawnStrike drawn;
  drawn.strike.target = target;
  drawn.is_whole = style.has_whole_advances();
  for (size_t i = 0; i < count; ++i) {
    const auto glyph = static_cast<uint16_t>(i);
    const SourceGlyph& given = source.glyphs[i];
    Picture picture;
    if (given.picture.has_value()) {
      picture = deeper(*given.picture, source.pixel_bits, target.bits);
    } else {
      const Canvas canvas =
          draw(font, style, glyph, target.bits, box_px(content, i, target.px));
      picture = cropped(canvas.area(), [&](int x, int y) {
        return value_of(canvas.at(x, y), target.bits);
      });
    }
    if (!picture.is_in_format()) {
      drawn.too_large.push_back(i);
    }
    drawn.strike.pictures.push_back(picture.is_in_format() ? std::move(picture)
                                                           : Picture());
    if (drawn.is_whole) {
      drawn.advances_px.push_back(
          given.picture.has_value()
              ? px_of(given.advance, target.px, content)
              : style.fitter()->advance_px(font, style, glyph));
    }
  }
  if (drawn.is_whole) {
    drawn.kerning_px =
        fitted_kerning(source, content, font, style, drawn.advances_px);
  }
  return drawn;
}

void check_picture(const RomContent& content,
                   size_t source,
                   const Font& font,
                   uint16_t id) {
  const RomStrike& strike = content.strikes[0];
  const StrikeTarget& target = strike.target;
  const Picture& picture = strike.pictures[source];
  const Rect box = picture.box();
  const Style style(Q26_6::from_int(target.px));
  const Canvas canvas = draw(font, style, id, 4, box);
  check_pixels(content, target, source, canvas.area(), [&](int x, int y) {
    const bool is_in = x >= box.x0 && x < box.x1 && y >= box.y0 && y < box.y1;
    const int value = is_in ? picture.at(x - box.x0, y - box.y0) : 0;
    return canvas.at(x, y) == value * 255 / ((1 << target.bits) - 1);
  });
}

void check_strike_alone(const RomContent& content,
                        const std::vector<uint8_t>& bytes) {
  Font font;
  static_cast<void>(open_font(bytes, font));  // else nothing is drawn
  for (size_t i = 0; i < content.glyphs.size(); ++i) {
    check_picture(content, i, font, static_cast<uint16_t>(i));
  }
}

void check_strikes(const RomContent& content,
                   const std::vector<uint8_t>& bytes) {
  Font outlines;
  Font both;
  const Span<const uint8_t> rom = {bytes.data(), bytes.size()};
  const bool is_open =
      Font::open(rom, outlines) == Status::ok &&
      Font::open(rom, kOutlineStrikeCoding, both) == Status::ok;
  for (const RomStrike& strike : content.strikes) {
    const StrikeTarget& target = strike.target;
    const Style style = style_of(target);
    for (size_t i = 0; i < strike.pictures.size(); ++i) {
      const auto picture = [&](const Font& font) {
        return draw(font, style, static_cast<uint16_t>(i), target.bits,
                    box_px(content, i, target.px));
      };
      const Canvas wanted = picture(outlines);
      const Canvas found = picture(both);
      check_pixels(content, target, i, wanted.area(), [&](int x, int y) {
        const int a = wanted.at(x, y);
        const int b = found.at(x, y);
        return is_open && (target.bits < 4 ? value_of(a, target.bits) ==
                                                 value_of(b, target.bits)
                                           : std::abs(a - b) <= kHalfLevel);
      });
    }
  }
}

}  // namespace inkcell::gen
