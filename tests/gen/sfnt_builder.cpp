#include "sfnt_builder.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <initializer_list>
#include <iterator>

namespace inkcell::gen::test {
namespace {

using Bytes = std::vector<uint8_t>;

// Appends big-endian numbers.
class Table {
 public:
  Table& u8(int value) {
    bytes.push_back(static_cast<uint8_t>(value));
    return *this;
  }
  Table& u16(int value) { return u8(value >> 8 & 0xff).u8(value & 0xff); }
  Table& u16s(std::initializer_list<int> values) {
    for (const int value : values) {
      u16(value);
    }
    return *this;
  }
  Table& u32(uint32_t value) {
    return u16(static_cast<int>(value >> 16)).u16(static_cast<int>(value));
  }
  Table& tag(const std::string& text) {
    bytes.insert(bytes.end(), text.begin(), text.end());
    return *this;
  }
  Table& zeros(size_t count) {
    bytes.resize(bytes.size() + count);
    return *this;
  }
  Table& add(const Bytes& more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
    return *this;
  }

  Bytes bytes;
};

Bytes head_table(const Sfnt& font) {
  return Table()
      .u32(0x10000)     // version
      .u32(0x10000)     // revision
      .u32(0)           // checksum, never checked
      .u32(0x5f0f3cf5)  // magic
      .u16s({0, font.units_per_em})
      .zeros(16)  // dates
      .u16s({-2000, -2000, 2000, 2000, 0, 6, 2})
      .u16s({1, 0})  // long offsets in loca
      .bytes;
}

Bytes hhea_table(const Sfnt& font) {
  return Table()
      .u32(0x10000)
      .u16s({font.ascender, font.descender, font.line_gap, 2000})
      .zeros(20)
      .u16s({0, static_cast<int>(font.glyphs.size())})
      .bytes;
}

Bytes maxp_table(const Sfnt& font) {
  return Table()
      .u32(0x10000)
      .u16s({static_cast<int>(font.glyphs.size()), 1000, 100})
      .zeros(4)
      .u16(2)
      .zeros(16)
      .bytes;
}

// Version 2: the first with x-height and cap-height. Typographic measures that
// differ from hhea's, and no USE_TYPO_METRICS.
Bytes os2_table(const Sfnt& font) {
  return Table()
      .u16s({2, 500, 400, 5, font.fs_type})
      .zeros(52)
      .u16s({0x40, 0x20, 0x7e})  // fsSelection: regular
      .u16s({font.ascender - 50, font.descender + 50, 0})
      .u16s({font.ascender, -font.descender})
      .zeros(8)
      .u16s({font.x_height, font.cap_height, 0, 0x20, 1})
      .bytes;
}

Bytes cmap_table(const Sfnt& font) {
  std::map<char32_t, uint32_t> glyph_of;
  for (size_t i = 1; i < font.glyphs.size(); ++i) {
    if (font.glyphs[i].code_point != 0) {
      glyph_of[font.glyphs[i].code_point] = static_cast<uint32_t>(i);
    }
  }
  const auto groups = static_cast<uint32_t>(glyph_of.size());
  Table table;
  table.u16(0).u16(1).u16(3).u16(font.is_symbol ? 0 : 10).u32(12);
  table.u16(12).u16(0).u32(16 + 12 * groups).u32(0).u32(groups);
  for (const auto& [code_point, glyph] : glyph_of) {
    table.u32(code_point).u32(code_point).u32(glyph);
  }
  return table.bytes;
}

size_t point_count(const SfntGlyph& glyph) {
  size_t count = 0;
  for (const Polygon& polygon : glyph.contours) {
    count += polygon.size();
  }
  return count;
}

struct Corners {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
};

Corners corners_of(const SfntGlyph& glyph) {
  Corners box;
  bool first = true;
  for (const Polygon& polygon : glyph.contours) {
    for (const auto& [x, y] : polygon) {
      box.x0 = first ? x : std::min(box.x0, x);
      box.y0 = first ? y : std::min(box.y0, y);
      box.x1 = first ? x : std::max(box.x1, x);
      box.y1 = first ? y : std::max(box.y1, y);
      first = false;
    }
  }
  return box;
}

Bytes composite_data(const SfntGlyph& glyph) {
  constexpr int kWords = 1;    // 16-bit offsets
  constexpr int kOffsets = 2;  // not numbers of points
  constexpr int kMore = 0x20;  // another component follows
  constexpr int kMatrix = 0x80;
  Table table;
  table.u16(-1).zeros(8);
  for (size_t i = 0; i < glyph.components.size(); ++i) {
    const SfntComponent& part = glyph.components[i];
    table.u16(kWords | kOffsets |
              (i + 1 < glyph.components.size() ? kMore : 0) |
              (part.matrix_q14.empty() ? 0 : kMatrix));
    table.u16(part.glyph).u16(part.dx).u16(part.dy);
    for (const int value : part.matrix_q14) {
      table.u16(value);
    }
  }
  table.zeros((4 - table.bytes.size() % 4) % 4);
  return table.bytes;
}

Bytes glyph_data(const SfntGlyph& glyph) {
  if (!glyph.components.empty()) {
    return composite_data(glyph);
  }
  const size_t points = point_count(glyph);
  if (points == 0) {
    return {};
  }
  Table table;
  table.u16(static_cast<int>(glyph.contours.size()));
  const Corners box = corners_of(glyph);
  table.u16(box.x0).u16(box.y0).u16(box.x1).u16(box.y1);
  int last = -1;
  for (const Polygon& polygon : glyph.contours) {
    last += static_cast<int>(polygon.size());
    table.u16(last);
  }
  table.u16(0);
  for (size_t i = 0; i < points; ++i) {
    table.u8(1);  // on the curve, 16-bit steps
  }
  for (const bool want_x : {true, false}) {
    int at = 0;
    for (const Polygon& polygon : glyph.contours) {
      for (const auto& [x, y] : polygon) {
        table.u16((want_x ? x : y) - at);
        at = want_x ? x : y;
      }
    }
  }
  table.zeros((4 - table.bytes.size() % 4) % 4);
  return table.bytes;
}

Bytes kern_table(const Sfnt& font) {
  const int pairs = static_cast<int>(font.kern_pairs.size());
  Table table;
  table.u16(0).u16(1);
  table.u16(0).u16(14 + 6 * pairs).u16(1).u16(pairs).zeros(6);
  for (const auto& [pair, value] : font.kern_pairs) {
    table.u16(pair.first).u16(pair.second).u16(value);
  }
  return table.bytes;
}

constexpr int kFirstInstanceName = 256;

Bytes fvar_table(const Sfnt& font) {
  Table table;
  const int instances = static_cast<int>(font.instances.size());
  table.u32(0x10000).u16s({16, 2, 1, 20, instances, 8}).tag("wght");
  table.u32(100u << 16).u32(400u << 16).u32(900u << 16).u16s({0, 1});
  int name = kFirstInstanceName;
  for (const auto& [text, wght] : font.instances) {
    table.u16(name++).u16(0).u32(static_cast<uint32_t>(wght) << 16);
  }
  return table.bytes;
}

// One tuple with its peak at the end of the axis: all points and the second
// phantom point, the advance, move in x by `shift`.
Bytes variation_data(const SfntGlyph& glyph, int shift) {
  Table deltas;
  deltas.u8(0);  // all points
  const auto put_run = [&](int count, int value) {
    for (; count > 0; count -= 64) {
      const int run = std::min(count, 64);
      deltas.u8(0x40 | (run - 1));
      for (int i = 0; i < run; ++i) {
        deltas.u16(value);
      }
    }
  };
  const int points = static_cast<int>(point_count(glyph));
  put_run(points, shift);
  put_run(1, 0);
  put_run(1, shift);
  put_run(2, 0);
  put_run(points + 4, 0);  // nothing moves in y
  const int size = static_cast<int>(deltas.bytes.size());
  Table table;
  table.u16(1).u16(10).u16(size).u16(0xa000).u16(0x4000).add(deltas.bytes);
  table.zeros((4 - table.bytes.size() % 4) % 4);
  return table.bytes;
}

// Offsets of `parts` laid end to end, one more than there are parts.
void put_offsets(Table& table, const std::vector<Bytes>& parts) {
  uint32_t offset = 0;
  table.u32(0);
  for (const Bytes& part : parts) {
    offset += static_cast<uint32_t>(part.size());
    table.u32(offset);
  }
}

Bytes joined(const std::vector<Bytes>& parts) {
  Table table;
  for (const Bytes& part : parts) {
    table.add(part);
  }
  return table.bytes;
}

Bytes gvar_table(const Sfnt& font) {
  std::vector<Bytes> parts;
  for (const SfntGlyph& glyph : font.glyphs) {
    parts.push_back(variation_data(glyph, font.wght_shift));
  }
  const auto glyphs = static_cast<uint32_t>(font.glyphs.size());
  const uint32_t data = 20 + 4 * (glyphs + 1);
  Table table;
  table.u16(1).u16(0).u16(1).u16(0).u32(data);
  table.u16(static_cast<int>(glyphs)).u16(1).u32(data);
  put_offsets(table, parts);
  table.add(joined(parts));
  return table.bytes;
}

Bytes name_table(const Sfnt& font) {
  std::vector<std::pair<int, std::string>> names = {{1, "Test"}};
  for (const auto& instance : font.instances) {
    names.emplace_back(kFirstInstanceName + static_cast<int>(names.size()) - 1,
                       instance.first);
  }
  const int count = static_cast<int>(names.size());
  Table table;
  table.u16(0).u16(count).u16(6 + 12 * count);
  Table texts;
  for (const auto& [id, text] : names) {
    table.u16(1).u16(0).u16(0).u16(id).u16(static_cast<int>(text.size()));
    table.u16(static_cast<int>(texts.bytes.size()));
    texts.tag(text);
  }
  return table.add(texts.bytes).bytes;
}

std::map<std::string, Bytes> make_tables(const Sfnt& font) {
  std::map<std::string, Bytes> tables;
  tables["head"] = head_table(font);
  tables["hhea"] = hhea_table(font);
  tables["maxp"] = maxp_table(font);
  tables["OS/2"] = os2_table(font);
  tables["cmap"] = cmap_table(font);
  tables["name"] = name_table(font);
  tables["post"] = Table().u32(0x30000).zeros(28).bytes;
  std::vector<Bytes> outlines;
  Table metrics;
  for (const SfntGlyph& glyph : font.glyphs) {
    outlines.push_back(glyph_data(glyph));
    metrics.u16(glyph.advance).u16(corners_of(glyph).x0);
  }
  Table loca;
  put_offsets(loca, outlines);
  tables["hmtx"] = metrics.bytes;
  tables["loca"] = loca.bytes;
  tables["glyf"] = joined(outlines);
  if (!font.kern_pairs.empty()) {
    tables["kern"] = kern_table(font);
  }
  if (font.wght_shift != 0) {
    tables["fvar"] = fvar_table(font);
    tables["gvar"] = gvar_table(font);
  }
  for (const auto& [name, bytes] : font.tables) {
    tables[name] = bytes;
    if (bytes.empty()) {
      tables.erase(name);
    }
  }
  return tables;
}

// A font whose first byte lies at `base` of the file.
Bytes build_at(const Sfnt& font, size_t base) {
  const std::map<std::string, Bytes> tables = make_tables(font);
  Table file;
  file.u32(0x10000).u16(static_cast<int>(tables.size())).zeros(6);
  size_t offset = base + 12 + 16 * tables.size();
  for (const auto& [name, bytes] : tables) {
    file.tag(name).u32(0).u32(static_cast<uint32_t>(offset));
    file.u32(static_cast<uint32_t>(bytes.size()));
    offset += (bytes.size() + 3) / 4 * 4;
  }
  for (const auto& entry : tables) {
    file.add(entry.second).zeros((4 - entry.second.size() % 4) % 4);
  }
  return file.bytes;
}

}  // namespace

Polygon sfnt_rectangle(int x0, int y0, int x1, int y1) {
  return {{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}};
}

Sfnt Sfnt::plain() {
  Sfnt font;
  font.glyphs = {{0, 600, {sfnt_rectangle(50, 0, 550, 700)}},
                 {U' ', 250, {}},
                 {U'.', 300, {sfnt_rectangle(100, 0, 200, 100)}},
                 {U'H', 800, {sfnt_rectangle(100, 0, 700, 700)}}};
  return font;
}

Bytes Sfnt::build() const {
  return build_at(*this, 0);
}

Bytes build_collection(const std::vector<Sfnt>& fonts) {
  Table header;
  header.tag("ttcf").u32(0x10000).u32(static_cast<uint32_t>(fonts.size()));
  Table body;
  const size_t first = 12 + 4 * fonts.size();
  for (const Sfnt& font : fonts) {
    header.u32(static_cast<uint32_t>(first + body.bytes.size()));
    body.add(build_at(font, first + body.bytes.size()));
  }
  return header.add(body.bytes).bytes;
}

TestFolder::TestFolder() {
  static std::atomic<int> next{0};
  path_ = std::filesystem::temp_directory_path() /
          ("inkcell-test-" + std::to_string(getpid()) + "-" +
           std::to_string(next++));
  std::filesystem::create_directories(path_);
}

TestFolder::~TestFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path TestFolder::write(const std::string& name,
                                        const Bytes& bytes) const {
  const std::filesystem::path file = path_ / name;
  std::filesystem::create_directories(file.parent_path());
  // A file that is emptied and written anew goes to the disk at once (ext4).
  std::filesystem::remove(file);
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  return file;
}

std::vector<std::string> TestFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Bytes read_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(in), {});
}

std::string read_text(const std::filesystem::path& file) {
  const Bytes bytes = read_file(file);
  return {bytes.begin(), bytes.end()};
}

}  // namespace inkcell::gen::test
