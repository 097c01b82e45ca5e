#include "font_builder.hpp"

#include "inkcell/version.hpp"

namespace font_builder {
namespace {

namespace format = inkcell::format;

int32_t root(uint64_t value) {
  uint64_t low = 0;
  uint64_t high = uint64_t{1} << 24;
  while (low + 1 < high) {
    const uint64_t middle = (low + high) / 2;
    (middle * middle <= value ? low : high) = middle;
  }
  return static_cast<int32_t>(low);
}

int32_t hypotenuse_q6(int32_t x_u, int32_t y_u) {
  const auto square = static_cast<uint64_t>(x_u * x_u + y_u * y_u);
  return root(square << 12);
}

// Writes one after the other and counts; stops writing when the room ends.
class Writer {
 public:
  explicit Writer(Span<uint8_t> out) : out_(out) {}

  size_t at() const { return at_; }
  bool fits() const { return at_ <= out_.size; }

  void u8(uint32_t value) {
    if (at_ < out_.size) {
      out_[at_] = static_cast<uint8_t>(value);
    }
    ++at_;
  }
  void u16(uint32_t value) {
    u8(value);
    u8(value >> 8);
  }
  void u32(uint32_t value) {
    u16(value);
    u16(value >> 16);
  }
  void bytes(Span<const uint8_t> bytes) {
    for (const uint8_t byte : bytes) {
      u8(byte);
    }
  }
  void i16(int32_t value) { u16(static_cast<uint32_t>(value)); }
  void align() {
    while (at_ % 4 != 0) {
      u8(0);
    }
  }
  void record(const Record& record) {
    if (at_ + record.size() <= out_.size) {
      record.write(out_.data + at_);
    }
    at_ += record.size();
  }
  void patch_u16(size_t at, uint32_t value) {
    if (at + 2 <= out_.size) {
      put_u16(out_.data + at, value);
    }
  }
  void patch_u32(size_t at, uint32_t value) {
    if (at + 4 <= out_.size) {
      put_u32(out_.data + at, value);
    }
  }

 private:
  Span<uint8_t> out_;
  size_t at_ = 0;
};

void write_cmap(const FontSpec& spec, Writer& out) {
  for (const CmapEntry& entry : spec.cmap) {
    out.u32(entry.first);
    out.u16(entry.extra);
    out.u16(entry.first_glyph);
  }
}

// Numbers of the bit tables take one or two whole bytes, so that tests can
// break them one by one. Other widths are the business of test_bit_table.cpp
// and of the generator's tests.
void write_number(uint32_t value, uint32_t bits, Writer& out) {
  bits == 16 ? out.u16(value) : out.u8(value);
}

void write_metrics(const FontSpec& spec, Writer& out) {
  for (uint32_t i = 0; i < format::metrics::kColumns; ++i) {
    out.u16(0);
  }
  out.u16(static_cast<uint32_t>(spec.glyphs.size));  // all have an advance
  for (uint32_t i = 0; i < format::metrics::kColumns; ++i) {
    out.u8(16);
  }
  for (const GlyphSpec& glyph : spec.glyphs) {
    out.u16(glyph.advance);
    for (const int16_t side : glyph.box) {
      out.i16(side);
    }
  }
}

void write_kerning(const FontSpec& spec, Writer& out) {
  const KerningSpec& kerning = spec.kerning;
  if (kerning.left_classes == 0) {
    return;
  }
  const uint32_t bits =
      kerning.left_classes > 255 || kerning.right_classes > 255 ? 16 : 8;
  uint32_t pairs = 0;
  for (const int16_t value : kerning.values) {
    pairs += value != 0 ? 1u : 0u;
  }
  out.u32(pairs);
  out.u16(static_cast<uint32_t>(kerning.left.size));
  out.u16(kerning.left_classes);
  out.u16(kerning.right_classes);
  out.i16(0);
  const uint32_t widths[] = {8, bits, bits, 16, 16};
  for (const uint32_t width : widths) {
    out.u8(width);
  }
  for (uint32_t i = 0; i < kerning.left.size; ++i) {
    out.u8(i);
    write_number(kerning.left[i], bits, out);
    write_number(kerning.right[i], bits, out);
  }
  uint32_t start = 0;
  out.u16(start);
  for (uint32_t i = 0; i < kerning.values.size; ++i) {
    start += kerning.values[i] != 0 ? 1u : 0u;
    if ((i + 1) % kerning.right_classes == 0) {
      out.u16(start);
    }
  }
  for (uint32_t i = 0; i < kerning.values.size; ++i) {
    if (kerning.values[i] != 0) {
      write_number(i % kerning.right_classes + 1, bits, out);
      out.i16(kerning.values[i]);
    }
  }
}

void write_glyphs(const FontSpec& spec, Writer& out) {
  static Record drawn;  // too large for the stack of a small board
  const size_t begin = out.at();
  // Cells begin at even bytes, outlines anywhere.
  const uint32_t unit_log2 = spec.outlines.code.size == 0 ? 1 : 0;
  out.u8(16);  // bits of an offset
  out.u8(unit_log2);
  const size_t offsets = out.at();
  for (size_t i = 0; i <= spec.glyphs.size; ++i) {
    out.u16(0);
  }
  for (size_t i = 0; i < spec.glyphs.size; ++i) {
    out.patch_u16(offsets + 2 * i,
                  static_cast<uint32_t>(out.at() - begin) >> unit_log2);
    const GlyphSpec& glyph = spec.glyphs[i];
    out.bytes(glyph.bytes);
    if (unit_log2 != 0 && out.at() % 2 != 0) {
      out.u8(0);
    }
    if (glyph.record != nullptr) {
      out.record(*glyph.record);
    } else if (glyph.shape != nullptr) {
      drawn.reset();
      drawn.fill(glyph.shape);
      out.record(drawn);
    }
  }
  out.patch_u16(offsets + 2 * spec.glyphs.size,
                static_cast<uint32_t>(out.at() - begin) >> unit_log2);
}

void write_name(const FontSpec& spec, Writer& out) {
  for (const char* at = spec.name; *at != '\0'; ++at) {
    out.u8(static_cast<uint8_t>(*at));
  }
}

void write_header(const FontSpec& spec, uint32_t sections, Writer& out) {
  out.u32(format::kMagic);
  out.u8(inkcell::kFormatMinor);
  out.u8(inkcell::kFormatMajor);
  out.u16(format::header::kBytes + sections * format::section::kBytes);
  out.u32(0);  // total bytes, and two checksums: when they are known
  out.u32(0);
  out.u32(0);
  out.u16(static_cast<uint32_t>(spec.glyphs.size));
  out.u16(spec.units_per_em);
  const int32_t lines[] = {800, -200, 90, 500, 700};
  for (const int32_t line : lines) {
    out.i16(line);
  }
  out.u16(12);  // px
  out.u16(64);
  out.u8(16);
  const OutlineSpec& outlines = spec.outlines;
  out.u8(static_cast<uint32_t>(outlines.code.size == 0
                                   ? format::Coding::field
                                   : format::Coding::outline));
  out.u8(0);
  out.u8(static_cast<uint32_t>(format::Predicate::size_aware));
  out.u16(sections);
  out.u16(Record::kMaxCells);
  out.u16(Record::kMaxReferences / 4);
  out.u8(2);
  out.u8(0);
  out.u16(64);
  const int32_t box[] = {82, 0, 668, 668};
  for (const int32_t side : box) {
    out.i16(side);
  }
  out.u8(static_cast<uint8_t>(outlines.grid_shift));
  out.u8(outlines.code_bits);
  out.u16(outlines.max_points);
}

using WriteSection = void (*)(const FontSpec&, Writer&);

struct Section {
  bool exists;
  uint32_t tag;
  uint32_t must_understand;
  WriteSection write;  // null: bytes as they are
  Span<const uint8_t> bytes = {};
};

// None without bytes.
Section section_of(uint32_t tag,
                   uint32_t must_understand,
                   Span<const uint8_t> bytes) {
  return {bytes.size != 0, tag, must_understand, nullptr, bytes};
}

void write_section(const FontSpec& spec,
                   const Section& section,
                   size_t entry,
                   Writer& out) {
  const auto begin = static_cast<uint32_t>(out.at());
  if (section.write != nullptr) {
    section.write(spec, out);
  }
  out.bytes(section.bytes);
  out.patch_u32(entry + format::section::kTag, section.tag);
  out.patch_u32(entry + format::section::kOffset,
                begin | section.must_understand);
  out.patch_u32(entry + format::section::kSize,
                static_cast<uint32_t>(out.at()) - begin);
  out.align();
}

}  // namespace

void put_u16(uint8_t* at, uint32_t value) {
  at[0] = static_cast<uint8_t>(value);
  at[1] = static_cast<uint8_t>(value >> 8);
}

void put_u32(uint8_t* at, uint32_t value) {
  put_u16(at, value);
  put_u16(at + 2, value >> 16);
}

uint32_t get_u16(const uint8_t* at) {
  return at[0] + at[1] * 256u;
}

uint32_t get_u32(const uint8_t* at) {
  return get_u16(at) + get_u16(at + 2) * 65536u;
}

uint32_t crc32(uint32_t crc, Span<const uint8_t> bytes) {
  crc = ~crc;
  for (const uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0u);
    }
  }
  return ~crc;
}

bool repair_checksums(Span<uint8_t> font) {
  namespace header = format::header;
  if (font.size < header::kBytes) {
    return false;
  }
  const uint32_t header_bytes = get_u16(font.data + header::kHeaderBytes);
  const uint32_t total = get_u32(font.data + header::kTotalBytes);
  if (header_bytes < header::kBytes || total < header_bytes ||
      total > font.size) {
    return false;
  }
  put_u32(font.data + header::kContentCrc,
          crc32(0, {font.data + header_bytes, total - header_bytes}));
  uint32_t crc = crc32(0, {font.data, header::kHeaderCrc});
  crc = crc32(crc, {font.data + header::kContentCrc,
                    header_bytes - header::kContentCrc});
  put_u32(font.data + header::kHeaderCrc, crc);
  return true;
}

int32_t disc(int32_t x_u, int32_t y_u) {
  return 300 * 64 - hypotenuse_q6(x_u - 384, y_u - 384);
}

int32_t ring(int32_t x_u, int32_t y_u) {
  const int32_t away = hypotenuse_q6(x_u - 384, y_u - 384) - 200 * 64;
  return 60 * 64 - (away < 0 ? -away : away);
}

int32_t bar(int32_t x_u, int32_t y_u) {
  const int32_t x = x_u < 320 ? 200 - x_u : x_u - 440;
  const int32_t y = y_u < 320 ? -y_u : y_u - 640;
  if (x > 0 && y > 0) {
    return -hypotenuse_q6(x, y);
  }
  return -64 * (x > y ? x : y);
}

// Not by assigning a new one, which would pass over the stack.
void Record::reset() {
  tile_log2 = 8;
  x0_u = -128;
  y0_u = -128;
  tiles_x = 4;
  tiles_y = 4;
  reference_count = 16;
  cell_count = 0;
  for (uint16_t& reference : references) {
    reference = format::glyph::kOutside;
  }
}

uint16_t Record::add_node() {
  if (reference_count + 4 > kMaxReferences) {
    return format::glyph::kOutside;
  }
  const uint32_t node = node_count();
  reference_count += 4;
  return static_cast<uint16_t>(format::glyph::kFirstNode + node);
}

uint16_t& Record::child(uint16_t node, uint32_t child) {
  const uint32_t index = node - uint32_t{format::glyph::kFirstNode};
  return references[uint32_t{tiles_x} * tiles_y + 4 * index + child];
}

uint16_t Record::add_raw_cell(int32_t centre_q6, const int8_t (&offsets)[8]) {
  if (cell_count == kMaxCells) {
    return format::glyph::kOutside;
  }
  uint8_t* cell = cells[cell_count];
  put_u16(cell, static_cast<uint32_t>(centre_q6));
  for (int i = 0; i < 8; ++i) {
    cell[format::samples::kOffsets + static_cast<uint32_t>(i)] =
        static_cast<uint8_t>(offsets[i]);
  }
  return static_cast<uint16_t>(format::glyph::kCellFlag | cell_count++);
}

uint16_t Record::add_cell(const int32_t (&distances_q6)[9],
                          uint32_t size_log2) {
  // A quantum is 2^size_log2 / 128 u, in Q6 half of 2^size_log2.
  const int32_t quantum_q6 = size_log2 == 0 ? 1 : 1 << (size_log2 - 1);
  int8_t offsets[8];
  for (int i = 0; i < 8; ++i) {
    const int32_t offset =
        (distances_q6[i < 4 ? i : i + 1] - distances_q6[4]) / quantum_q6;
    offsets[i] = static_cast<int8_t>(offset < -128  ? -128
                                     : offset > 127 ? 127
                                                    : offset);
  }
  return add_raw_cell(distances_q6[4], offsets);
}

uint16_t Record::square(Shape shape, int32_t x_u, int32_t y_u, uint32_t log2) {
  const int32_t half = 1 << (log2 - 1);
  const int32_t centre_q6 = shape(x_u + half, y_u + half);
  const int32_t far_q6 = (half * 91 / 64 + 48) * 64;
  if (centre_q6 > far_q6 || centre_q6 < -far_q6) {
    return centre_q6 > 0 ? format::glyph::kInside : format::glyph::kOutside;
  }
  if (log2 == 6) {
    int32_t distances_q6[9];
    for (int i = 0; i < 9; ++i) {
      distances_q6[i] = shape(x_u + i % 3 * half, y_u + i / 3 * half);
    }
    return add_cell(distances_q6, log2);
  }
  const uint16_t node = add_node();
  for (uint32_t i = 0; i < 4 && node != format::glyph::kOutside; ++i) {
    const uint16_t part =
        square(shape, x_u + static_cast<int32_t>(i % 2) * half,
               y_u + static_cast<int32_t>(i / 2) * half, log2 - 1);
    child(node, i) = part;
  }
  return node;
}

void Record::fill(Shape shape) {
  reference_count = uint32_t{tiles_x} * tiles_y;
  for (int32_t tile = 0; tile < tiles_x * tiles_y; ++tile) {
    references[tile] = square(shape, x0_u + (tile % tiles_x << tile_log2),
                              y0_u + (tile / tiles_x << tile_log2), tile_log2);
  }
}

size_t Record::size() const {
  return format::glyph::kBytes + 2 * reference_count +
         format::samples::kBytes * cell_count;
}

void Record::write(uint8_t* at) const {
  namespace glyph = format::glyph;
  at[glyph::kType] = glyph::kTypeSamples;
  at[glyph::kTileLog2] = tile_log2;
  put_u16(at + glyph::kX0, static_cast<uint32_t>(x0_u));
  put_u16(at + glyph::kY0, static_cast<uint32_t>(y0_u));
  at[glyph::kTilesX] = tiles_x;
  at[glyph::kTilesY] = tiles_y;
  put_u16(at + glyph::kNodeCount, node_count());
  put_u16(at + glyph::kCellCount, cell_count);
  at += glyph::kBytes;
  for (uint32_t i = 0; i < reference_count; ++i, at += 2) {
    put_u16(at, references[i]);
  }
  for (uint32_t i = 0; i < cell_count; ++i) {
    for (const uint8_t byte : cells[i]) {
      *at++ = byte;
    }
  }
}

size_t build_font(const FontSpec& spec, Span<uint8_t> out) {
  namespace section = format::section;
  const Section all[] = {
      {true, section::kCmap, section::kMustUnderstand, write_cmap},
      section_of(section::kCodePages, section::kMustUnderstand,
                 spec.code_pages),
      {true, section::kMetrics, section::kMustUnderstand, write_metrics},
      {true, section::kGlyphs, section::kMustUnderstand, write_glyphs},
      section_of(section::kCode, section::kMustUnderstand, spec.outlines.code),
      {spec.kerning.left_classes != 0, section::kKerning, 0, write_kerning},
      section_of(section::kGrid, 0, spec.hints),
      section_of(section::kMorphs, 0, spec.morphs),
      {spec.name[0] != '\0', section::kName, 0, write_name},
      {spec.extra_section != 0, spec.extra_section, spec.extra_flags, nullptr}};
  uint32_t count = 0;
  for (const Section& each : all) {
    count += each.exists ? 1 : 0;
  }
  Writer writer(out);
  write_header(spec, count, writer);
  size_t entry = writer.at();
  for (uint32_t i = 0; i < count * section::kBytes; ++i) {
    writer.u8(0);
  }
  for (const Section& each : all) {
    if (each.exists) {
      write_section(spec, each, entry, writer);
      entry += section::kBytes;
    }
  }
  if (!writer.fits()) {
    return 0;
  }
  put_u32(out.data + format::header::kTotalBytes,
          static_cast<uint32_t>(writer.at()));
  repair_checksums({out.data, writer.at()});
  return writer.at();
}

size_t build_sample_font(Span<uint8_t> out) {
  static constexpr CmapEntry kCmap[] = {
      {' ', 0, 1}, {'A', 2, 2}, {0x1f600, 0, 3}};
  static constexpr GlyphSpec kGlyphs[] = {
      {600, {195, 0, 430, 625}, bar, nullptr},
      {300, {0, 0, 0, 0}, nullptr, nullptr},
      {750, {82, 82, 668, 668}, disc, nullptr},
      {700, {121, 121, 629, 629}, ring, nullptr},
      {625, {195, 0, 430, 625}, bar, nullptr}};
  static constexpr uint16_t kLeft[] = {0, 0, 1, 2, 0};
  static constexpr uint16_t kRight[] = {0, 0, 1, 2, 3};
  static constexpr int16_t kValues[] = {0, -100, 0, -50, 0, 25};
  FontSpec spec;
  spec.cmap = {kCmap, 3};
  spec.glyphs = {kGlyphs, 5};
  spec.kerning = {2, 3, {kLeft, 5}, {kRight, 5}, {kValues, 6}};
  spec.name = "Inkcell Sample";
  return build_font(spec, out);
}

}  // namespace font_builder
