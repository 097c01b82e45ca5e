#include "pipeline/font_strikes.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "judge/strike_pictures.hpp"
#include "rom/rom_font.hpp"

namespace inkcell::gen {
namespace {

using format::StrikeFit;

// The glyphs that text may show, which come before components and second
// masters.
size_t count_shown(const SourceFont& font) {
  size_t count = font.glyphs.size();
  while (count > 1 && (!font.is_shown(count - 1) ||
                       !font.glyphs[count - 1].master.empty())) {
    --count;
  }
  return count;
}

KerningMatrix scaled(KerningMatrix kerning, double scale) {
  for (int16_t& value : kerning.values) {
    value = static_cast<int16_t>(std::lround(value * scale));
  }
  return kerning;
}

// What a font of outlines keeps as one of a strike alone.
RomContent alone(const RomContent& content, const DrawnStrike& drawn) {
  const RomStrike& strike = drawn.strike;
  const int px = strike.target.px;
  // Advances that are not fitted are kept in halves of a pixel.
  const int unit = drawn.is_whole ? 1 : 2;
  const double scale =
      static_cast<double>(unit) * px / content.metrics.units_per_em;
  // Lines stand on whole pixels, and so do fitted glyphs.
  const auto whole = [&](int units) {
    return unit * static_cast<int>(std::lround(units * scale / unit));
  };
  RomContent made;
  made.name = content.name;
  made.options = content.options;
  made.options.coding = Coding::strike;
  made.options.min_px = made.options.max_px = px;
  made.metrics = content.metrics;
  made.metrics.units_per_em = unit * px;
  for (int SourceMetrics::*metric :
       {&SourceMetrics::ascender, &SourceMetrics::descender,
        &SourceMetrics::line_gap, &SourceMetrics::x_height,
        &SourceMetrics::cap_height}) {
    made.metrics.*metric = whole(content.metrics.*metric);
  }
  made.glyph_of = content.glyph_of;
  made.kerning = drawn.is_whole ? scaled(drawn.kerning_px, unit)
                                : scaled(content.kerning, scale);
  for (size_t i = 0; i < strike.pictures.size(); ++i) {
    const Picture& picture = strike.pictures[i];
    const auto units = [&](int at) { return static_cast<int16_t>(at * unit); };
    RomGlyph glyph;
    glyph.metrics.advance = static_cast<uint16_t>(
        drawn.is_whole
            ? unit * drawn.advances_px[i]
            : std::lround(content.glyphs[i].metrics.advance * scale));
    if (!picture.empty()) {
      glyph.metrics.x_min = units(picture.left);
      glyph.metrics.x_max = units(picture.left + picture.width);
      glyph.metrics.y_min = units(-picture.top - picture.height);
      glyph.metrics.y_max = units(-picture.top);
    }
    made.glyphs.push_back(std::move(glyph));
  }
  made.kerning.left_class.resize(made.glyphs.size());
  made.kerning.right_class.resize(made.glyphs.size());
  made.strikes = {strike};
  return made;
}

// Refuses glyphs that nothing else would show.
void check_room(const SourceFont& font, const DrawnStrike& drawn) {
  if (!drawn.too_large.empty()) {
    const SourceGlyph& glyph = font.glyphs[drawn.too_large.front()];
    throw Error(glyph.file_name + ": " + glyph.name() + ": its picture at " +
                std::to_string(drawn.strike.target.px) +
                " px is larger than 255 px or begins further than 128 px from "
                "its origin; " +
                glyph.remedy("take a smaller --strike"));
  }
}

// Bitmap fonts have one size.
std::vector<StrikeTarget> targets_of(const GenerateRequest& request,
                                     const SourceFont& font) {
  if (font.pixel_px == 0) {
    return request.strikes;
  }
  const StrikeTarget own = {font.pixel_px, font.pixel_bits, StrikeFit::both};
  const bool is_asked = !request.strikes.empty();
  if (is_asked ? request.strikes[0].px != own.px ||
                     request.strikes[0].bits < own.bits || !request.strike_only
               : !font.glyphs[0].picture.has_value()) {
    const std::string px = std::to_string(own.px);
    throw Error(font.file_name + ": a bitmap font of " + px +
                " px has no outlines; give --strike-only --strike " + px + ":" +
                std::to_string(own.bits));
  }
  return is_asked ? request.strikes : std::vector<StrikeTarget>{own};
}

}  // namespace

void add_strikes(const GenerateRequest& request,
                 const SourceFont& font,
                 RomContent& content) {
  PartBytes parts;
  const std::vector<StrikeTarget> targets = targets_of(request, font);
  const bool is_alone = request.strike_only || font.pixel_px != 0;
  const std::vector<uint8_t> outlines =
      targets.empty() ? std::vector<uint8_t>() : write_rom_font(content, parts);
  std::vector<RomStrike> strikes;
  for (StrikeTarget target : targets) {
    constexpr int kFirstUnfitted = 40;  // Fit::kEnds
    target.fit = target.px < kFirstUnfitted ? target.fit : StrikeFit::none;
    const DrawnStrike drawn =
        draw_strike(font, content, outlines, target, count_shown(font));
    RomContent made = alone(content, drawn);
    strikes.push_back(drawn.strike);
    check_strike_alone(made, write_rom_font(made, parts));
    if (is_alone) {
      check_room(font, drawn);
      made.block_bytes = static_cast<size_t>(request.paged);
      content = std::move(made);
      return;
    }
  }
  content.strikes = std::move(strikes);
  if (!content.strikes.empty()) {
    check_strikes(content, write_rom_font(content, parts));
  }
}

}  // namespace inkcell::gen
