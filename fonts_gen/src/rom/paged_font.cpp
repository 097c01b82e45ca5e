#include "rom/paged_font.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/byte_writer.hpp"
#include "base/error.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/stored/paged.hpp"
#include "inkcell/version.hpp"
#include "rom/character_runs.hpp"
#include "rom/font_sections.hpp"
#include "source/char_set.hpp"

namespace inkcell::gen {
namespace {

namespace entry = format::paged::entry;
namespace paged = format::paged;
namespace section = format::section;
namespace trailer = format::paged::trailer;

using Characters = std::vector<std::pair<char32_t, uint16_t>>;

// A glyph without what its record was made of.
RomGlyph bare(const RomGlyph& glyph) {
  RomGlyph copy;
  copy.outline_record = glyph.outline_record;
  copy.record_bits = glyph.record_bits;
  copy.metrics = glyph.metrics;
  return copy;
}

// The pictures of some glyphs, behind empty ones; none of outlines.
std::vector<RomStrike> strikes_of(const RomContent& content,
                                  size_t empty,
                                  const std::vector<uint16_t>& glyphs) {
  std::vector<RomStrike> strikes;
  for (const RomStrike& strike : content.strikes) {
    strikes.push_back({strike.target, std::vector<Picture>(empty)});
    for (const uint16_t glyph : glyphs) {
      strikes.back().pictures.push_back(strike.pictures[glyph]);
    }
  }
  return strikes;
}

// What draws a glyph, without tables. [bytes]
size_t drawn_bytes(const RomContent& content, uint16_t glyph) {
  return content.strikes.empty()
             ? content.glyphs[glyph].outline_record.size()
             : strikes_section(strikes_of(content, 0, {glyph}), true).size() -
                   strikes_section(strikes_of(content, 1, {}), true).size();
}

// In the place of a character: a layer has none. Pages of layers are the last.
constexpr char32_t kNoCharacter = 0x110000;

// The first glyph of the first page; before it there is .notdef.
constexpr size_t kFirstGlyph = 1;

// The glyphs that are layers.
std::set<uint16_t> layers_of(const RomContent& content) {
  std::set<uint16_t> glyphs;
  for (const RomLayers::Glyph& of : content.layers.glyphs) {
    for (const RomLayers::Layer& layer : of.layers) {
      glyphs.insert(static_cast<uint16_t>(layer.glyph));
    }
  }
  return glyphs;
}

struct Page {
  char32_t first_code_point = 0;
  std::vector<uint16_t> glyphs;  // of the font, without the empty glyph 0
  Bytes bytes;                   // a block but for first_glyph in its trailer
};

class PageMaker {
 public:
  PageMaker(const RomContent& content, const HintCode& code)
      : content_(content), code_(code) {}

  std::vector<Page> pages() const {
    std::vector<Page> pages;
    Characters taken;
    std::optional<Page> made;
    Characters all(content_.glyph_of.begin(), content_.glyph_of.end());
    for (const uint16_t layer : layers_of(content_)) {
      all.emplace_back(kNoCharacter, layer);
    }
    for (const auto& character : all) {
      taken.push_back(character);
      std::optional<Page> next = page(taken);
      if (!next.has_value() && made.has_value()) {
        pages.push_back(std::move(*made));
        taken.erase(taken.begin(), taken.end() - 1);
        next = page(taken);
      }
      if (!next.has_value()) {
        refuse(character);
      }
      made = std::move(next);
    }
    if (made.has_value()) {
      pages.push_back(std::move(*made));
    }
    return pages;
  }

 private:
  // None if they do not fit.
  std::optional<Page> page(const Characters& characters) const {
    RomContent part;
    part.options = content_.options;
    std::vector<uint16_t> glyphs;
    std::map<uint16_t, uint16_t> place_of;
    part.glyphs.emplace_back();
    part.hints.glyphs.resize(content_.hints.empty() ? 0 : 1);
    for (const auto& [code_point, glyph] : characters) {
      const auto [place, is_new] =
          place_of.emplace(glyph, static_cast<uint16_t>(part.glyphs.size()));
      if (is_new) {
        glyphs.push_back(glyph);
        part.glyphs.push_back(bare(content_.glyphs[glyph]));
        if (!content_.hints.empty()) {
          part.hints.glyphs.push_back(content_.hints.glyphs[glyph]);
        }
      }
      if (code_point != kNoCharacter) {
        part.glyph_of[code_point] = place->second;
      }
    }
    // Widens no column.
    part.glyphs[0].metrics = part.glyphs[1].metrics;
    part.strikes = strikes_of(content_, 1, glyphs);
    const Bytes runs = CharacterRuns(part.glyph_of).cmap_of_all();
    constexpr size_t kMostRuns = 255;
    constexpr size_t kMostGlyphs = 255;
    if (part.glyphs.size() > kMostGlyphs ||
        runs.size() / format::cmap::kBytes > kMostRuns) {
      return std::nullopt;
    }
    Page page;
    page.first_code_point = characters.front().first;
    page.glyphs = glyphs;
    Bytes out = metrics_section(part);
    // Entries of strikes lie at multiples of 4.
    pad(out, part.strikes.empty() ? 0 : 2);
    const size_t records = out.size();
    const Bytes drawn = glyphs_section(part, code_);
    out.insert(out.end(), drawn.begin(), drawn.end());
    const size_t end = content_.block_bytes - trailer::kBytes;
    if (out.size() + runs.size() > end) {
      return std::nullopt;
    }
    out.resize(end - runs.size());
    out.insert(out.end(), runs.begin(), runs.end());
    out.resize(content_.block_bytes);
    out[end + trailer::kGlyphs] = static_cast<uint8_t>(part.glyphs.size());
    out[end + trailer::kRuns] =
        static_cast<uint8_t>(runs.size() / format::cmap::kBytes);
    set_u16(out, end + trailer::kRecords, static_cast<unsigned>(records));
    page.bytes = std::move(out);
    return page;
  }

  [[noreturn]] void refuse(
      const std::pair<const char32_t, uint16_t>& character) const {
    const bool is_largest = content_.block_bytes == paged::kMaxBlockBytes;
    throw Error(
        content_.name + ": " +
        (character.first == kNoCharacter ? "a layer"
                                         : describe(character.first)) +
        " takes " + std::to_string(drawn_bytes(content_, character.second)) +
        " bytes beside its tables, a block " +
        std::to_string(content_.block_bytes) + "; " +
        (!is_largest ? "use --paged " + std::to_string(2 * content_.block_bytes)
         : content_.strikes.empty() ? "raise --tolerance, or lower --max-px"
                                    : "take a smaller --strike"));
  }

  const RomContent& content_;
  const HintCode& code_;
};

// COLR of the ids of pages, empty if there are no layers.
Bytes paged_layers(const RomContent& content,
                   const std::vector<Page>& pages,
                   size_t first_glyph) {
  std::vector<size_t> glyphs;
  std::map<size_t, size_t> id_of;  // of a layer, which is there once
  for (const Page& page : pages) {
    for (const uint16_t glyph : page.glyphs) {
      id_of[glyph] = first_glyph + glyphs.size();
      glyphs.push_back(glyph);
    }
  }
  std::map<size_t, const RomLayers::Glyph*> list_of;
  for (const RomLayers::Glyph& of : content.layers.glyphs) {
    list_of[of.glyph] = &of;
  }
  RomLayers made;
  made.palettes = content.layers.palettes;
  for (size_t i = 0; i < glyphs.size(); ++i) {
    const auto found = list_of.find(glyphs[i]);
    if (found != list_of.end()) {
      made.glyphs.push_back({first_glyph + i, found->second->layers});
      for (RomLayers::Layer& layer : made.glyphs.back().layers) {
        layer.glyph = id_of[layer.glyph];
      }
    }
  }
  return layers_section(made);
}

// The font of .notdef.
Bytes resident_font(const RomContent& content,
                    const HintCode& code,
                    size_t layers_bytes) {
  RomContent part;
  part.options = content.options;
  part.glyphs.push_back(bare(content.glyphs[0]));
  part.strikes = strikes_of(content, 0, {0});
  if (!content.hints.empty()) {
    part.hints.glyphs.push_back(content.hints.glyphs[0]);
  }
  constexpr uint32_t kNeeded = section::kMustUnderstand;
  std::vector<FontSection> sections = {
      {section::kMetrics, kNeeded, metrics_section(part), &PartBytes::metrics},
      {section::kGlyphs, kNeeded, glyphs_section(part, code),
       &PartBytes::glyphs}};
  if (part.strikes.empty()) {
    sections.insert(
        sections.begin() + 1,
        {section::kCode, kNeeded, code_section(content), &PartBytes::glyphs});
  }
  if (!content.hints.empty()) {
    sections.push_back({section::kGrid, 0, code.section(), &PartBytes::hints});
  }
  if (layers_bytes != 0) {
    Bytes size;
    put_u32(size, static_cast<uint32_t>(layers_bytes));
    sections.push_back({section::kLayers, 0, size, &PartBytes::layers});
  }
  PartBytes parts;
  return assemble_font(content, part.glyphs.size(), sections, parts);
}

// An entry of the index for each page, then one for each block of entries, and
// so on: from the pages to the roots.
std::vector<std::vector<Bytes>> index_levels(const std::vector<Page>& pages,
                                             size_t first_glyph,
                                             size_t most_roots,
                                             size_t fan_out) {
  std::vector<std::vector<Bytes>> levels(1);
  for (const Page& page : pages) {
    Bytes made;
    put_u16(made, static_cast<unsigned>(first_glyph));
    put_u16(made, page.first_code_point & 0xffff);
    put_u16(made, page.first_code_point >> 16);
    levels[0].push_back(std::move(made));
    first_glyph += page.glyphs.size();
  }
  while (levels.back().size() > most_roots) {
    std::vector<Bytes> above;
    for (size_t i = 0; i < levels.back().size(); i += fan_out) {
      above.push_back(levels.back()[i]);
    }
    levels.push_back(std::move(above));
  }
  return levels;
}

// KERN of the ids of pages; empty if no pair kerns or a block has no room. Sets
// kern_end of the header.
Bytes kerning_block(const RomContent& content,
                    const std::vector<Page>& pages,
                    size_t first_glyph,
                    Bytes& header) {
  RomContent part;
  part.name = content.name;
  part.kerning = content.kerning;
  if (content.kerning.empty()) {
    return {};
  }
  std::vector<uint16_t>& left = part.kerning.left_class;
  std::vector<uint16_t>& right = part.kerning.right_class;
  left.assign(first_glyph, 0);
  right.assign(first_glyph, 0);
  size_t kern_end = 0;
  for (const Page& page : pages) {
    for (const uint16_t glyph : page.glyphs) {
      left.push_back(content.kerning.left_class[glyph]);
      right.push_back(content.kerning.right_class[glyph]);
      if (left.back() != 0 || right.back() != 0) {
        kern_end = left.size();
      }
    }
  }
  Bytes section;
  if (kern_end != 0) {
    section = kerning_section(part);
  }
  if (section.empty() || section.size() > content.block_bytes) {
    return {};
  }
  set_u16(header, paged::kKernEnd, static_cast<unsigned>(kern_end));
  section.resize(content.block_bytes);
  return section;
}

}  // namespace

std::vector<uint8_t> write_paged_font(const RomContent& content,
                                      PartBytes& parts) {
  const HintCode code = content.hint_code();
  std::vector<Page> pages = PageMaker(content, code).pages();
  const size_t block = content.block_bytes;
  Bytes layers = paged_layers(content, pages, kFirstGlyph);
  const Bytes font = resident_font(content, code, layers.size());
  const size_t taken = paged::kBytes + entry::kBytes + font.size();
  if (taken > paged::kMaxResidentBytes) {
    throw Error(content.name + ": the resident part takes " +
                std::to_string(taken) + " bytes, at most " +
                std::to_string(paged::kMaxResidentBytes) +
                " are possible; .notdef takes " +
                std::to_string(drawn_bytes(content, 0)) +
                " of them: use a font file with a simpler one");
  }
  const size_t room = (paged::kMaxResidentBytes - paged::kBytes - font.size()) &
                      ~(size_t{format::kAlignment} - 1);
  const size_t fan_out = block / entry::kBytes;
  const auto levels =
      index_levels(pages, kFirstGlyph, room / entry::kBytes, fan_out);
  size_t glyph_end = kFirstGlyph;
  for (const Page& page : pages) {
    glyph_end += page.glyphs.size();
  }
  if (levels.size() > paged::kMaxLevels + 1 || glyph_end > UINT16_MAX) {
    throw Error(content.name + ": " + std::to_string(glyph_end) +
                " glyphs on " + std::to_string(pages.size()) +
                " pages; at most 65535 are possible, and an index of two "
                "levels: use larger blocks, or ask for fewer characters");
  }

  Bytes out(paged::kBytes);
  set_u32(out, paged::kMagicAt, paged::kMagic);
  out[paged::kFormatMinor] = kFormatMinor;
  out[paged::kFormatMajor] = kFormatMajor;
  for (const Bytes& root : levels.back()) {
    out.insert(out.end(), root.begin(), root.end());
  }
  pad(out, 2);
  set_u16(out, paged::kFontOffset, static_cast<unsigned>(out.size()));
  out.insert(out.end(), font.begin(), font.end());
  const size_t resident = out.size();
  set_u16(out, paged::kResidentBytes, static_cast<unsigned>(resident));
  set_u16(out, paged::kBlockBytes, static_cast<unsigned>(block));
  set_u16(out, paged::kGlyphEnd, static_cast<unsigned>(glyph_end));
  out[paged::kLevels] = static_cast<uint8_t>(levels.size() - 1);
  out[paged::kRoots] = static_cast<uint8_t>(levels.back().size());
  set_u16(out, paged::kPages, static_cast<unsigned>(pages.size()));
  const Bytes kerning = kerning_block(content, pages, kFirstGlyph, out);
  out.resize(block);
  for (size_t level = levels.size() - 1; level-- != 0;) {
    for (size_t i = 0; i < levels[level].size(); ++i) {
      out.resize(i % fan_out == 0 ? (out.size() + block - 1) / block * block
                                  : out.size());
      out.insert(out.end(), levels[level][i].begin(), levels[level][i].end());
    }
    out.resize((out.size() + block - 1) / block * block);
  }
  parts = PartBytes{};
  parts.header = block;
  parts.cmap = out.size() - block;
  size_t first_glyph = kFirstGlyph;
  for (Page& page : pages) {
    set_u16(page.bytes, block - trailer::kBytes + trailer::kFirstGlyph,
            static_cast<unsigned>(first_glyph));
    first_glyph += page.glyphs.size();
    out.insert(out.end(), page.bytes.begin(), page.bytes.end());
  }
  parts.glyphs = out.size() - parts.total();
  out.insert(out.end(), kerning.begin(), kerning.end());
  parts.kerning = kerning.size();
  if (!layers.empty()) {
    // A reader takes four bytes at once.
    layers.resize((layers.size() + 2) / block * block + block);
  }
  out.insert(out.end(), layers.begin(), layers.end());
  parts.layers = layers.size();
  set_u32(out, paged::kContentCrc,
          crc32(out.data() + block, out.size() - block));
  set_u32(out, paged::kHeaderCrc,
          crc32(out.data() + paged::kContentCrc, resident - paged::kContentCrc,
                crc32(out.data(), paged::kHeaderCrc)));
  return out;
}

}  // namespace inkcell::gen
