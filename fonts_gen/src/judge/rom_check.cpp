#include "judge/rom_check.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "inkcell/field/cell.hpp"
#include "inkcell/field/verify.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/layers/verify.hpp"
#include "inkcell/shaping/verify.hpp"
#include "inkcell/stored/stored_font.hpp"
#include "inkcell/strike/strike.hpp"
#include "inkcell/strike/verify.hpp"
#include "judge/strike_pictures.hpp"
#include "rom/rom_font.hpp"

namespace inkcell::gen {
namespace {

[[noreturn]] void differ(const RomContent& content, const std::string& what) {
  throw Error(content.name + ": the finished font differs from its source in " +
              what +
              "; nothing was written. This is an error of the "
              "generator: please report it");
}

std::string of_glyph(size_t glyph) {
  return " of glyph " + std::to_string(glyph);
}

// A glyph of the source, and its id in the font.
struct ReadGlyph {
  size_t source;
  uint16_t id;
};

void check_header(const Font& font, const RomContent& content) {
  const FontMetrics m = font.metrics();
  const SourceMetrics& s = content.metrics;
  const FontRange range = font.range();
  const bool same =
      font.glyph_count() == content.glyphs.size() &&
      m.units_per_em == s.units_per_em && m.ascender == s.ascender &&
      m.descender == s.descender && m.line_gap == s.line_gap &&
      m.x_height == s.x_height && m.cap_height == s.cap_height &&
      range.min_px == content.options.min_px &&
      range.max_px == content.options.max_px &&
      (content.options.coding == Coding::strike ||
       std::string(font.name().begin(), font.name().end()) == content.name);
  if (!same) {
    differ(content, "its header");
  }
}

void check_cmap(const Font& font, const RomContent& content) {
  const auto expect = [&](char32_t code_point) {
    uint16_t glyph = 0;
    const Status status = font.glyph_of(code_point, glyph);
    const auto found = content.glyph_of.find(code_point);
    const bool known = found != content.glyph_of.end();
    if ((status == Status::ok) != known ||
        (status != Status::ok && status != Status::no_glyph) ||
        glyph != (known ? found->second : 0)) {
      differ(content, "the glyph of " + describe(code_point));
    }
  };
  for (const auto& entry : content.glyph_of) {
    expect(entry.first);
    expect(entry.first - 1);
    expect(entry.first + 1);
  }
}

void check_metrics(const Font& font,
                   const ReadGlyph& glyph,
                   const RomContent& content) {
  GlyphMetrics m;
  const GlyphMetrics& s = content.glyphs[glyph.source].metrics;
  const Status status = font.glyph_metrics(glyph.id, m);
  if (status != Status::ok || m.advance != s.advance || m.x_min != s.x_min ||
      m.y_min != s.y_min || m.x_max != s.x_max || m.y_max != s.y_max) {
    differ(content, "the metrics" + of_glyph(glyph.source));
  }
}

// `page` has the glyph; `id` is its id there.
void check_record(const Font& page,
                  uint16_t id,
                  const RomContent& content,
                  const HintCode& code,
                  size_t source) {
  const Span<const uint8_t> record = page.record(id);
  const std::vector<uint8_t> wanted = hinted_record(content, source, code);
  if (!std::equal(record.begin(), record.end(), wanted.begin(), wanted.end())) {
    differ(content, "the record" + of_glyph(source));
  }
}

// One glyph of each class, 0 included if it has any.
std::vector<ReadGlyph> representatives(const std::vector<ReadGlyph>& glyphs,
                                       const std::vector<uint16_t>& classes,
                                       int count) {
  std::vector<ReadGlyph> found;
  std::vector<bool> seen(static_cast<size_t>(count) + 1);
  for (const ReadGlyph& glyph : glyphs) {
    if (!seen[classes[glyph.source]]) {
      seen[classes[glyph.source]] = true;
      found.push_back(glyph);
    }
  }
  return found;
}

// Every glyph against one of each class of the other side. That settles every
// pair: the reader's answer depends on nothing but the two classes.
void check_kerning(const Font& font,
                   const std::vector<ReadGlyph>& glyphs,
                   const RomContent& content) {
  const KerningMatrix& kerning = content.kerning;
  if (kerning.left_class.empty()) {
    return;
  }
  const auto expect = [&](const ReadGlyph& left, const ReadGlyph& right) {
    if (font.kerning(left.id, right.id) !=
        kerning.value(left.source, right.source)) {
      differ(content, "the kerning of glyphs " + std::to_string(left.source) +
                          " and " + std::to_string(right.source));
    }
  };
  const std::vector<ReadGlyph> lefts =
      representatives(glyphs, kerning.left_class, kerning.left_classes);
  const std::vector<ReadGlyph> rights =
      representatives(glyphs, kerning.right_class, kerning.right_classes);
  for (const ReadGlyph& glyph : glyphs) {
    for (const ReadGlyph& right : rights) {
      expect(glyph, right);
    }
    for (const ReadGlyph& left : lefts) {
      expect(left, glyph);
    }
  }
}

// Fitting reads the section; how well it does is tested glyph by glyph.
void check_hints(const Font& font, const RomContent& content) {
  const Span<const uint8_t> read = font.section(format::section::kGrid);
  const std::vector<uint8_t> source = content.hint_code().section();
  if (read.size < source.size() ||
      !std::equal(source.begin(), source.end(), read.begin())) {
    differ(content, "its hints");
  }
}

// Walks the tree of the source and looks each leaf up in the font.
class CellCheck {
 public:
  CellCheck(const SampleTree& source, const GlyphField& field)
      : source_(source), field_(field) {}

  bool equal() const {
    const bool same_grid =
        field_.tile_log2 == source_.tile_log2 && field_.x0_u == source_.x0_u &&
        field_.y0_u == source_.y0_u && field_.tiles_x == source_.tiles_x &&
        field_.tiles_y == source_.tiles_y &&
        field_.node_count == source_.node_count() &&
        field_.cell_count == source_.cells.size();
    if (!same_grid) {
      return false;
    }
    const int size = 1 << source_.tile_log2;
    size_t tile = 0;
    for (int row = 0; row < source_.tiles_y; ++row) {
      for (int column = 0; column < source_.tiles_x; ++column, ++tile) {
        if (!equal_below(source_.references[tile], source_.x0_u + column * size,
                         source_.y0_u + row * size, source_.tile_log2)) {
          return false;
        }
      }
    }
    return true;
  }

 private:
  bool equal_below(uint16_t reference, int x_u, int y_u, int log2) const {
    namespace glyph = format::glyph;
    if (reference < glyph::kFirstNode || reference >= glyph::kCellFlag) {
      return equal_leaf(reference, x_u, y_u, log2);
    }
    if (log2 == 0) {
      return false;
    }
    const int half = 1 << (log2 - 1);
    const auto tiles = static_cast<size_t>(source_.tiles_x) *
                       static_cast<size_t>(source_.tiles_y);
    const size_t first = tiles + 4u * (reference - glyph::kFirstNode);
    for (size_t child = 0; child < 4; ++child) {
      if (!equal_below(source_.references.at(first + child),
                       x_u + (child % 2 != 0 ? half : 0),
                       y_u + (child / 2 != 0 ? half : 0), log2 - 1)) {
        return false;
      }
    }
    return true;
  }

  // The leaf is found from both of its ends.
  bool equal_leaf(uint16_t reference, int x_u, int y_u, int log2) const {
    const int last = (1 << log2) - 1;
    return equal_cell(locate(field_, x_u, y_u), reference, x_u, y_u, log2) &&
           equal_cell(locate(field_, x_u + last, y_u + last), reference, x_u,
                      y_u, log2);
  }

  bool equal_cell(
      const Cell& cell, uint16_t reference, int x_u, int y_u, int log2) const {
    if (cell.x0_u != x_u || cell.y0_u != y_u || cell.size_log2 != log2) {
      return false;
    }
    if (reference < format::glyph::kFirstNode) {
      return cell.samples == nullptr &&
             cell.inside == (reference == format::glyph::kInside);
    }
    const SampleCell& samples =
        source_.cells.at(reference - format::glyph::kCellFlag);
    return cell.samples != nullptr &&
           std::memcmp(cell.samples, samples.data(), samples.size()) == 0;
  }

  const SampleTree& source_;
  const GlyphField& field_;
};

void check_cells(const Font& font,
                 const ReadGlyph& glyph,
                 const RomContent& content) {
  GlyphField field;
  const Status status = read_field(font, glyph.id, field);
  if (status != Status::ok ||
      !CellCheck(content.glyphs[glyph.source].field, field).equal()) {
    differ(content, "the cells" + of_glyph(glyph.source));
  }
}

bool read_bytes(void* context,
                uint32_t offset,
                uint8_t* bytes,
                uint32_t count) {
  const auto& from = *static_cast<const std::vector<uint8_t>*>(context);
  if (offset > from.size() || count > from.size() - offset) {
    return false;
  }
  std::copy_n(from.begin() + offset, count, bytes);
  return true;
}

}  // namespace

void check_rom_font(const std::vector<uint8_t>& bytes,
                    const RomContent& content) {
  Font font;
  const Status opened = open_font(bytes, font);
  if (opened != Status::ok) {
    differ(content, "that the device does not open it (status " +
                        std::to_string(static_cast<int>(opened)) + ")");
  }
  const Status strikes = verify_strikes(font);
  const bool is_field = content.options.coding == Coding::field;
  const Status shaping = verify_shaping(font);
  const Status layers = verify_layers(font);
  const Status verified = strikes != Status::ok   ? strikes
                          : shaping != Status::ok ? shaping
                          : layers != Status::ok  ? layers
                          : is_field              ? verify_fields(font)
                                                  : font.verify();
  if (verified != Status::ok) {
    differ(content, "that the device does not verify it (status " +
                        std::to_string(static_cast<int>(verified)) + ")");
  }
  check_header(font, content);
  check_cmap(font, content);
  const HintCode code = content.hint_code();
  std::vector<ReadGlyph> glyphs;
  for (size_t i = 0; i < content.glyphs.size(); ++i) {
    glyphs.push_back({i, static_cast<uint16_t>(i)});
    check_metrics(font, glyphs.back(), content);
    if (content.options.coding == Coding::outline) {
      check_record(font, glyphs.back().id, content, code, i);
    } else if (is_field) {
      check_cells(font, glyphs.back(), content);
    }
  }
  check_kerning(font, glyphs, content);
  check_hints(font, content);
}

void check_paged_font(const std::vector<uint8_t>& bytes,
                      const RomContent& content) {
  std::vector<uint64_t> ram(
      StoredFont::ram_bytes(content.block_bytes, 4) / sizeof(uint64_t) + 1);
  auto file = bytes;
  StoredFont stored;
  const bool is_strike = content.options.coding == Coding::strike;
  const Status status = StoredFont::open(
      {read_bytes, &file},
      {reinterpret_cast<uint8_t*>(ram.data()), ram.size() * sizeof(uint64_t)},
      is_strike ? kStrikeCoding : kStoredOutlineCoding, stored);
  if (status != Status::ok || stored.verify() != Status::ok) {
    differ(content, "that the device does not open it");
  }
  const Font& font = stored.font();
  const HintCode code = content.hint_code();
  std::vector<ReadGlyph> glyphs;
  for (const auto& [code_point, source] : content.glyph_of) {
    uint16_t glyph = 0;
    const bool is_there = font.glyph_of(code_point, glyph) == Status::ok;
    uint32_t id = glyph;
    const Font* const page = is_there ? font.page_of(id) : nullptr;
    if (page == nullptr) {
      differ(content, "the glyph of " + describe(code_point));
    }
    glyphs.push_back({source, glyph});
    if (is_strike) {
      check_picture(content, source, font, glyph);
    } else {
      check_record(*page, static_cast<uint16_t>(id), content, code, source);
    }
    check_metrics(font, glyphs.back(), content);
  }
  check_kerning(font, glyphs, content);
  const StoredLayers layers = stored.layers();
  if (verify_layers(font, &layers) != Status::ok ||
      (layers.bytes == 0) != content.layers.glyphs.empty()) {
    differ(content, "its layers");
  }
}

}  // namespace inkcell::gen
