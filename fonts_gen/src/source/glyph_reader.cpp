#include "source/glyph_reader.hpp"

#include FT_OUTLINE_H
#include <hb-ot.h>

#include <algorithm>

namespace inkcell::gen {
namespace {

// FreeType halves integer sums for the implied points of quadratics.
// Coordinates are shifted by this much, so that nothing is lost. [bits]
constexpr int kWalkShift = 6;

// Receives the pieces of an outline from FreeType.
class OutlineBuilder {
 public:
  explicit OutlineBuilder(int units_per_em)
      : scale_(kUPerEm / (units_per_em << kWalkShift)) {}

  Outline build(FT_Outline& source) {
    FT_Outline_Funcs functions = {};
    functions.shift = kWalkShift;
    functions.move_to = [](const FT_Vector* to, void* self) {
      return static_cast<OutlineBuilder*>(self)->move(*to);
    };
    functions.line_to = [](const FT_Vector* to, void* self) {
      return static_cast<OutlineBuilder*>(self)->curve(Segment::Kind::line,
                                                       {to});
    };
    functions.conic_to = [](const FT_Vector* control, const FT_Vector* to,
                            void* self) {
      return static_cast<OutlineBuilder*>(self)->curve(Segment::Kind::quadratic,
                                                       {control, to});
    };
    functions.cubic_to = [](const FT_Vector* control1,
                            const FT_Vector* control2, const FT_Vector* to,
                            void* self) {
      return static_cast<OutlineBuilder*>(self)->curve(
          Segment::Kind::cubic, {control1, control2, to});
    };
    ok_ = FT_Outline_Decompose(&source, &functions, this) == 0;
    return std::move(outline_);
  }

  bool ok() const { return ok_; }

 private:
  Point to_u(const FT_Vector& v) const {
    return {static_cast<double>(v.x) * scale_,
            static_cast<double>(v.y) * scale_};
  }

  int move(const FT_Vector& to) {
    outline_.contours.emplace_back();
    at_ = to_u(to);
    return 0;
  }

  int curve(Segment::Kind kind, std::initializer_list<const FT_Vector*> rest) {
    Segment segment;
    segment.kind = kind;
    segment.p[0] = at_;
    size_t count = 1;
    for (const FT_Vector* point : rest) {
      segment.p[count++] = to_u(*point);
    }
    at_ = segment.p[count - 1];
    outline_.contours.back().segments.push_back(segment);
    return 0;
  }

  double scale_;
  Point at_;
  Outline outline_;
  bool ok_ = false;
};

// "glyph 36 (U+0041 'A')".
std::string name_of(uint32_t glyph, const std::string& character) {
  return "glyph " + std::to_string(glyph) + " (" + character + ")";
}

// Loads a glyph into FreeType's slot, in font units; returns FreeType's error.
FT_Error load_outline(const FontFile& font, uint32_t glyph) {
  const FT_Error error =
      FT_Load_Glyph(font.ft(), glyph,
                    FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP);
  const bool is_outline =
      error == 0 && font.ft()->glyph->format == FT_GLYPH_FORMAT_OUTLINE;
  return is_outline || error != 0 ? error : FT_Err_Invalid_Glyph_Format;
}

// The advance of the glyph in FreeType's slot. [font units] HarfBuzz would
// apply HVAR, but returns advances beyond 15 bits as negative.
int advance_of(const FontFile& font, uint32_t glyph) {
  const int advance = hb_font_get_glyph_h_advance(font.hb(), glyph);
  return advance >= 0 ? advance
                      : static_cast<int>(font.ft()->glyph->metrics.horiAdvance);
}

// The top of a character in font units; 0 if the font lacks it or it is
// damaged.
int top_of(const FontFile& font, char32_t code_point, Warnings& warnings) {
  const uint32_t glyph = font.glyph_of(code_point);
  if (glyph == 0) {
    return 0;
  }
  if (load_outline(font, glyph) != 0) {
    warnings.push_back(
        {Warning::Kind::measure,
         font.file_name() + ": " + name_of(glyph, describe(code_point)) +
             " cannot be read, so that its height is not known: 0 is used"});
    return 0;
  }
  FT_BBox box;
  FT_Outline_Get_CBox(&font.ft()->glyph->outline, &box);
  return static_cast<int>(box.yMax);
}

}  // namespace

void read_glyph(const FontFile& font, SourceGlyph& glyph, Warnings& warnings) {
  const std::string name = name_of(glyph.source, glyph.name());
  const FT_Error error = load_outline(font, glyph.source);
  if (error != 0) {
    font.refuse(
        name + " cannot be read (FreeType error " + std::to_string(error) +
        "); the font is damaged there: " + glyph.remedy("get the font anew"));
  }
  OutlineBuilder builder(font.units_per_em());
  glyph.outline = builder.build(font.ft()->glyph->outline);
  if (!builder.ok()) {
    font.refuse(name + " has a malformed outline; " +
                glyph.remedy("repair the font"));
  }
  const int advance = advance_of(font, glyph.source);
  glyph.advance = std::clamp(advance, 0, 65535);
  if (glyph.advance != advance) {
    warnings.push_back({Warning::Kind::measure,
                        font.file_name() + ": " + name + ": advance " +
                            std::to_string(advance) + " is out of range, " +
                            std::to_string(glyph.advance) + " is used"});
  }
}

SourceMetrics read_metrics(const FontFile& font, Warnings& warnings) {
  const auto measure = [&](hb_ot_metrics_tag_t tag, int otherwise) {
    hb_position_t value = 0;
    return hb_ot_metrics_get_position(font.hb(), tag, &value) ? value
                                                              : otherwise;
  };
  const auto clamp = [](int value) { return std::clamp(value, -32768, 32767); };
  SourceMetrics m;
  m.units_per_em = font.units_per_em();
  m.ascender = clamp(
      measure(HB_OT_METRICS_TAG_HORIZONTAL_ASCENDER, font.ft()->ascender));
  m.descender = clamp(
      measure(HB_OT_METRICS_TAG_HORIZONTAL_DESCENDER, font.ft()->descender));
  m.line_gap = clamp(measure(HB_OT_METRICS_TAG_HORIZONTAL_LINE_GAP, 0));
  // HarfBuzz uses the zeros of an empty hhea; FreeType then uses the
  // typographic heights of OS/2, or those for Windows.
  if (m.ascender == 0 && m.descender == 0) {
    m.ascender = clamp(font.ft()->ascender);
    m.descender = clamp(font.ft()->descender);
    m.line_gap = clamp(font.ft()->height - (m.ascender - m.descender));
  }
  if (m.ascender == 0 && m.descender == 0) {
    m.ascender = clamp(static_cast<int>(font.ft()->bbox.yMax));
    m.descender = clamp(static_cast<int>(font.ft()->bbox.yMin));
    m.line_gap = 0;
    warnings.push_back(
        {Warning::Kind::measure,
         font.file_name() +
             ": states no height of a line, in hhea or OS/2: the extent of "
             "its glyphs is used, ascender " +
             std::to_string(m.ascender) + ", descender " +
             std::to_string(m.descender)});
  }
  m.x_height = clamp(measure(HB_OT_METRICS_TAG_X_HEIGHT, 0));
  m.cap_height = clamp(measure(HB_OT_METRICS_TAG_CAP_HEIGHT, 0));
  // Old OS/2 tables lack these two, and some fonts leave them zero.
  if (m.x_height <= 0) {
    m.x_height = clamp(top_of(font, U'x', warnings));
  }
  if (m.cap_height <= 0) {
    m.cap_height = clamp(top_of(font, U'H', warnings));
  }
  return m;
}

}  // namespace inkcell::gen
