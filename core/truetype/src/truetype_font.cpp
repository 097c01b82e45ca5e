#include "inkcell/truetype/truetype_font.hpp"

#include "face.hpp"

namespace inkcell {
namespace detail {
namespace {

const MappedTrueType& mapped_face(const FontPages& pages) noexcept {
  return static_cast<const MappedTrueType&>(pages);
}

Status glyph_of_mapped(const FontPages& pages,
                       uint32_t code,
                       uint16_t& glyph) noexcept {
  return find_glyph(mapped_face(pages), code, glyph);
}

int32_t measure_mapped(const FontPages& pages,
                       uint16_t glyph,
                       GlyphMetrics* out) noexcept {
  return measure_in(mapped_face(pages), glyph, out);
}

int32_t kern_mapped(const FontPages& pages,
                    uint16_t left,
                    uint16_t right) noexcept {
  return pair_kerning(mapped_face(pages), left, right);
}

Table record_mapped(const TrueTypeFace& face,
                    uint32_t glyph,
                    int32_t* left_bearing) noexcept {
  const MappedTrueType& mapped = mapped_face(face);
  if (left_bearing != nullptr) {
    *left_bearing = left_bearing_in(mapped, glyph);
  }
  return record_in(mapped, glyph);
}

}  // namespace
}  // namespace detail

const detail::TrueTypeFace& TrueTypeFont::face_of(const Font& font) noexcept {
  return static_cast<const detail::TrueTypeFace&>(*font.pages_);
}

void TrueTypeFont::make_font(const detail::TrueTypeFace& face,
                             uint32_t units_per_em,
                             const Coding& coding,
                             Font& out) noexcept {
  out.rom_ = {face.header, format::header::kBytes};
  out.source_ = coding.source;
  out.pages_ = &face;
  out.units_per_em_ = static_cast<uint16_t>(units_per_em);
  out.coding_.code_bits = 1;  // has_outlines(); no record is read by it
}

Status TrueTypeFont::open(Span<const uint8_t> file,
                          const Coding& coding,
                          uint32_t face) noexcept {
  using namespace detail;
  Directory<Table> directory;
  INKCELL_TRY(directory.read(file, face));
  MappedTrueType& made = face_;
  // Smaller than to assign empty ones, and no copy on the stack.
  __builtin_memset(static_cast<void*>(&made), 0, sizeof made);
  __builtin_memset(static_cast<void*>(&font_), 0, sizeof font_);
  static_cast<FontPages&>(made) = {glyph_of_mapped, no_page_of, kern_mapped,
                                   measure_mapped};
  made.record = record_mapped;
  made.records = file;
  take_tables(directory, made);
  make_font(made, directory.units_per_em(), coding, font_);
  return Status::ok;
}

}  // namespace inkcell
