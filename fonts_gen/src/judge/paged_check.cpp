#include "judge/paged_check.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "base/error.hpp"
#include "inkcell/stored/stored_font.hpp"
#include "rom/rom_font.hpp"
#include "source/char_set.hpp"

namespace inkcell::gen {
namespace {

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

bool is_same(const std::vector<uint8_t>& bytes,
             const Span<const uint8_t>& read) {
  return std::equal(bytes.begin(), bytes.end(), read.begin(), read.end());
}

bool is_right(const Font& font,
              const RomContent& content,
              const HintCode& code,
              char32_t code_point,
              size_t source) {
  uint16_t glyph = 0;
  if (font.glyph_of(code_point, glyph) != Status::ok) {
    return false;
  }
  GlyphMetrics m;
  const GlyphMetrics& s = content.glyphs[source].metrics;
  if (font.glyph_metrics(glyph, m) != Status::ok || m.advance != s.advance ||
      m.x_min != s.x_min || m.y_min != s.y_min || m.x_max != s.x_max ||
      m.y_max != s.y_max) {
    return false;
  }
  uint32_t id = glyph;
  const Font* const page = font.page_of(id);
  return page != nullptr && is_same(hinted_record(content, source, code),
                                    page->record(static_cast<uint16_t>(id)));
}

// One character of each class, on a side.
std::map<uint16_t, char32_t> characters_of_classes(
    const RomContent& content, const std::vector<uint16_t>& classes) {
  std::map<uint16_t, char32_t> found;
  for (const auto& [code_point, glyph] : content.glyph_of) {
    found.emplace(classes[glyph], code_point);
  }
  return found;
}

// As for fonts in mapped memory: the answer depends on the classes alone.
bool is_kerning_right(const Font& font, const RomContent& content) {
  const KerningMatrix& kerning = content.kerning;
  if (kerning.empty()) {
    return true;
  }
  const auto is_pair_right = [&](char32_t left, char32_t right) {
    return font.kerning(font.glyph_or_notdef(left),
                        font.glyph_or_notdef(right)) ==
           kerning.value(content.glyph_of.at(left), content.glyph_of.at(right));
  };
  const auto lefts = characters_of_classes(content, kerning.left_class);
  const auto rights = characters_of_classes(content, kerning.right_class);
  for (const auto& [code_point, glyph] : content.glyph_of) {
    const bool kerns =
        kerning.left_class[glyph] != 0 || kerning.right_class[glyph] != 0;
    for (const auto& [number, other] : rights) {
      if (kerns && !is_pair_right(code_point, other)) {
        return false;
      }
    }
    for (const auto& [number, other] : lefts) {
      if (kerns && !is_pair_right(other, code_point)) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

void check_paged_font(const std::vector<uint8_t>& bytes,
                      const RomContent& content) {
  std::vector<uint64_t> ram(
      StoredFont::ram_bytes(content.block_bytes, 4) / sizeof(uint64_t) + 1);
  auto file = bytes;
  StoredFont stored;
  const Status status = StoredFont::open(
      {read_bytes, &file},
      {reinterpret_cast<uint8_t*>(ram.data()), ram.size() * sizeof(uint64_t)},
      stored);
  const HintCode code = content.hint_code();
  std::string wrong;
  if (status != Status::ok || stored.verify() != Status::ok) {
    wrong = "that the device does not open it";
  }
  for (const auto& [code_point, glyph] : content.glyph_of) {
    if (wrong.empty() &&
        !is_right(stored.font(), content, code, code_point, glyph)) {
      wrong = "the glyph of " + describe(code_point);
    }
  }
  if (wrong.empty() && !is_kerning_right(stored.font(), content)) {
    wrong = "the kerning";
  }
  if (!wrong.empty()) {
    throw Error(content.name +
                ": the finished font differs from its source in " + wrong +
                "; nothing was written. This is an error of the generator: "
                "please report it");
  }
}

}  // namespace inkcell::gen
