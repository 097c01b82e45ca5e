#include "source/kerning.hpp"

#include <hb-ot.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <type_traits>

#include "parallel.hpp"

namespace inkcell::gen {
namespace {

// HarfBuzz shapes characters, but a pair consists of glyphs: glyph g is passed
// as this plus g, in a private plane without character properties.
constexpr hb_codepoint_t kGlyphPlane = 0xf0000;

// Pairs shaped in one call.
constexpr size_t kBatch = 64;

constexpr hb_tag_t kKern = HB_TAG('k', 'e', 'r', 'n');

struct Destroy {
  void operator()(hb_set_t* x) const { hb_set_destroy(x); }
  void operator()(hb_buffer_t* x) const { hb_buffer_destroy(x); }
  void operator()(hb_font_t* x) const { hb_font_destroy(x); }
  void operator()(hb_font_funcs_t* x) const { hb_font_funcs_destroy(x); }
  void operator()(hb_shape_plan_t* x) const { hb_shape_plan_destroy(x); }
  void operator()(hb_blob_t* x) const { hb_blob_destroy(x); }
};
template <typename T>
using Owner = std::unique_ptr<T, Destroy>;
using GlyphSet = Owner<hb_set_t>;

GlyphSet make_set() {
  return GlyphSet(hb_set_create());
}

// The glyphs that the font's kerning mentions.
struct Coverage {
  GlyphSet left = make_set();
  GlyphSet right = make_set();
  // All glyphs that a lookup can see, also as context. A glyph that is not in
  // it and has no GDEF class separates its neighbours.
  GlyphSet seen = make_set();
};

void cover_gpos(hb_face_t* face, Coverage& coverage) {
  const hb_tag_t features[] = {kKern, HB_TAG_NONE};
  const GlyphSet lookups = make_set();
  hb_ot_layout_collect_lookups(face, HB_OT_TAG_GPOS, nullptr, nullptr, features,
                               lookups.get());
  hb_codepoint_t lookup = HB_SET_VALUE_INVALID;
  while (hb_set_next(lookups.get(), &lookup)) {
    hb_ot_layout_lookup_collect_glyphs(
        face, HB_OT_TAG_GPOS, lookup, coverage.seen.get(), coverage.left.get(),
        coverage.seen.get(), coverage.seen.get());
  }
  hb_set_union(coverage.right.get(), coverage.left.get());
  hb_set_union(coverage.seen.get(), coverage.left.get());
}

// Adds the glyphs of a kern table of version 0 whose subtables all have format
// 0, the only kind in OpenType fonts. False for any other.
bool cover_kern_pairs(hb_blob_t* table, Coverage& coverage) {
  unsigned size = 0;
  const auto* data =
      reinterpret_cast<const uint8_t*>(hb_blob_get_data(table, &size));
  const auto u16 = [&](size_t at) {
    return at + 2 <= size ? unsigned{data[at]} << 8 | data[at + 1] : 0u;
  };
  if (size < 4 || u16(0) != 0) {
    return false;
  }
  size_t at = 4;
  for (unsigned left = u16(2); left > 0; --left) {
    if (u16(at + 4) >> 8 != 0) {
      return false;
    }
    const unsigned pairs = u16(at + 6);
    for (size_t i = 0; i < pairs; ++i) {
      hb_set_add(coverage.left.get(), u16(at + 14 + 6 * i));
      hb_set_add(coverage.right.get(), u16(at + 16 + 6 * i));
    }
    // The 16-bit length overflows in large tables; the number of pairs does
    // not.
    at += std::max<size_t>(u16(at + 2), 14 + 6 * size_t{pairs});
  }
  hb_set_union(coverage.seen.get(), coverage.left.get());
  hb_set_union(coverage.seen.get(), coverage.right.get());
  return true;
}

Coverage kerning_coverage(const FontFile& font) {
  Coverage coverage;
  cover_gpos(font.hb_face(), coverage);
  const auto table = [&](hb_tag_t tag) {
    return Owner<hb_blob_t>(hb_face_reference_table(font.hb_face(), tag));
  };
  const Owner<hb_blob_t> kern = table(kKern);
  const bool apple =
      hb_blob_get_length(table(HB_TAG('k', 'e', 'r', 'x')).get()) != 0;
  const bool pairs_known = hb_blob_get_length(kern.get()) == 0 ||
                           cover_kern_pairs(kern.get(), coverage);
  if (apple || !pairs_known) {
    const auto last = static_cast<hb_codepoint_t>(font.ft()->num_glyphs - 1);
    for (hb_set_t* set :
         {coverage.left.get(), coverage.right.get(), coverage.seen.get()}) {
      hb_set_add_range(set, 0, last);
    }
  }
  return coverage;
}

// A glyph that no kerning sees and no lookup flag skips; none if all glyphs
// take part.
std::optional<uint32_t> find_separator(const FontFile& font,
                                       const Coverage& coverage) {
  const auto count = static_cast<uint32_t>(font.ft()->num_glyphs);
  for (uint32_t glyph = 0; glyph < count; ++glyph) {
    if (!hb_set_has(coverage.seen.get(), glyph) &&
        hb_ot_layout_get_glyph_class(font.hb_face(), glyph) ==
            HB_OT_LAYOUT_GLYPH_CLASS_UNCLASSIFIED) {
      return glyph;
    }
  }
  return std::nullopt;
}

hb_bool_t glyph_from_plane(
    hb_font_t*, void*, hb_codepoint_t character, hb_codepoint_t* glyph, void*) {
  *glyph = character - kGlyphPlane;
  return character >= kGlyphPlane;
}

// Shapes pairs of glyphs of one script with the kern feature alone.
class PairShaper {
 public:
  PairShaper(const FontFile& font,
             hb_script_t script,
             std::optional<uint32_t> separator)
      : separator_(separator),
        font_(hb_font_create_sub_font(font.hb())),
        buffer_(hb_buffer_create()) {
    const Owner<hb_font_funcs_t> functions(hb_font_funcs_create());
    hb_font_funcs_set_nominal_glyph_func(functions.get(), glyph_from_plane,
                                         nullptr, nullptr);
    hb_font_set_funcs(font_.get(), functions.get(), nullptr, nullptr);
    properties_.direction = HB_DIRECTION_LTR;
    // As HarfBuzz does for text without a script.
    properties_.script =
        script == HB_SCRIPT_COMMON ? HB_SCRIPT_INVALID : script;
    for (const char* name :
         {"kern", "ccmp", "locl", "rlig", "rclt", "rvrn", "liga", "clig",
          "calt", "ltra", "ltrm", "mark", "mkmk", "curs", "dist"}) {
      const uint32_t value = features_.empty() ? 1 : 0;
      features_.push_back({hb_tag_from_string(name, 4), value, 0, UINT_MAX});
    }
    plan_.reset(hb_shape_plan_create(
        hb_font_get_face(font_.get()), &properties_, features_.data(),
        static_cast<unsigned>(features_.size()), nullptr));
  }

  /// The kerning of `left` with each of `rights`.
  void kern(uint32_t left,
            const std::vector<uint32_t>& rights,
            std::vector<int>& out) {
    out.assign(rights.size(), 0);
    const size_t batch = separator_ ? kBatch : 1;
    for (size_t i = 0; i < rights.size(); i += batch) {
      const size_t count = std::min(batch, rights.size() - i);
      kern_batch(left, &rights[i], count, &out[i]);
    }
  }

 private:
  void add(uint32_t glyph) {
    hb_buffer_add(buffer_.get(), kGlyphPlane + glyph, cluster_++);
  }

  // left r0 | left r1 | left r2 ..., with the separator as |.
  void kern_batch(uint32_t left,
                  const uint32_t* rights,
                  size_t count,
                  int* out) {
    hb_buffer_t* buffer = buffer_.get();
    hb_buffer_reset(buffer);
    hb_buffer_set_unicode_funcs(buffer, hb_unicode_funcs_get_empty());
    cluster_ = 0;
    for (size_t i = 0; i < count; ++i) {
      if (i > 0) {
        add(*separator_);
      }
      add(left);
      add(rights[i]);
    }
    hb_buffer_set_content_type(buffer, HB_BUFFER_CONTENT_TYPE_UNICODE);
    hb_buffer_set_segment_properties(buffer, &properties_);
    hb_shape_plan_execute(plan_.get(), font_.get(), buffer, features_.data(),
                          static_cast<unsigned>(features_.size()));
    unsigned length = 0;
    const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer, &length);
    const hb_glyph_position_t* positions =
        hb_buffer_get_glyph_positions(buffer, &length);
    if (length != 3 * count - 1) {
      return;  // the script's shaper replaces the glyphs
    }
    const hb_position_t advance =
        hb_font_get_glyph_h_advance(font_.get(), left);
    for (size_t i = 0; i < count; ++i) {
      const hb_glyph_position_t* pair = positions + 3 * i;
      if (infos[3 * i].codepoint == left &&
          infos[3 * i + 1].codepoint == rights[i]) {
        out[i] =
            pair[0].x_advance - advance + pair[1].x_offset - pair[0].x_offset;
      }
    }
  }

  std::optional<uint32_t> separator_;
  Owner<hb_font_t> font_;
  Owner<hb_buffer_t> buffer_;
  Owner<hb_shape_plan_t> plan_;
  hb_segment_properties_t properties_ = HB_SEGMENT_PROPERTIES_DEFAULT;
  std::vector<hb_feature_t> features_;
  unsigned cluster_ = 0;
};

// Glyphs of one script that can be on the right, and their columns in the
// matrix.
struct Column {
  std::vector<uint32_t> sources;
  std::vector<size_t> glyphs;
};

bool runs_left_to_right(hb_script_t script) {
  return hb_script_get_horizontal_direction(script) != HB_DIRECTION_RTL;
}

// Reads the row of a left glyph, all columns.
class RowReader {
 public:
  RowReader(const FontFile& font,
            const std::vector<KerningGlyph>& glyphs,
            const std::map<hb_script_t, Column>& columns,
            std::optional<uint32_t> separator)
      : font_(font),
        glyphs_(glyphs),
        columns_(columns),
        separator_(separator) {}

  std::vector<int16_t> read(size_t left) {
    std::vector<int16_t> row(glyphs_.size());
    const KerningGlyph& glyph = glyphs_[left];
    std::vector<int> kerns;
    for (const auto& [script, column] : columns_) {
      const bool common = glyph.script == HB_SCRIPT_COMMON;
      if (!common && script != HB_SCRIPT_COMMON && script != glyph.script) {
        continue;
      }
      shaper(common ? script : glyph.script)
          .kern(glyph.source, column.sources, kerns);
      for (size_t i = 0; i < kerns.size(); ++i) {
        row[column.glyphs[i]] =
            static_cast<int16_t>(std::clamp(kerns[i], -32768, 32767));
      }
    }
    return row;
  }

 private:
  PairShaper& shaper(hb_script_t script) {
    std::unique_ptr<PairShaper>& found = shapers_[script];
    if (!found) {
      found = std::make_unique<PairShaper>(font_, script, separator_);
    }
    return *found;
  }

  const FontFile& font_;
  const std::vector<KerningGlyph>& glyphs_;
  const std::map<hb_script_t, Column>& columns_;
  std::optional<uint32_t> separator_;
  std::map<hb_script_t, std::unique_ptr<PairShaper>> shapers_;
};

// Numbers equal keys in order of appearance, from 1; `zero` gets 0.
template <typename Key>
class Classes {
 public:
  explicit Classes(Key zero) { numbers_.emplace(std::move(zero), 0); }

  uint16_t of(const Key& key) {
    const auto [found, is_new] = numbers_.try_emplace(key, next_);
    next_ = static_cast<uint16_t>(next_ + (is_new ? 1 : 0));
    return found->second;
  }
  int count() const { return next_ - 1; }

 private:
  std::map<Key, uint16_t> numbers_;
  uint16_t next_ = 1;
};

}  // namespace

int KerningMatrix::value(size_t left, size_t right) const {
  const int row = left_class[left];
  const int column = right_class[right];
  return row == 0 || column == 0
             ? 0
             : values[static_cast<size_t>(row - 1) *
                          static_cast<size_t>(right_classes) +
                      static_cast<size_t>(column - 1)];
}

KerningMatrix join_classes(size_t glyph_count,
                           const std::vector<size_t>& rows_of,
                           const std::vector<std::vector<int16_t>>& rows) {
  using Values = std::vector<int16_t>;
  KerningMatrix matrix;
  matrix.left_class.assign(glyph_count, 0);
  matrix.right_class.assign(glyph_count, 0);

  Classes<Values> left{Values(glyph_count)};
  std::vector<const Values*> unique_rows;
  for (size_t i = 0; i < rows.size(); ++i) {
    const uint16_t number = left.of(rows[i]);
    matrix.left_class[rows_of[i]] = number;
    if (number > unique_rows.size()) {
      unique_rows.push_back(&rows[i]);
    }
  }
  Classes<Values> right{Values(unique_rows.size())};
  std::vector<Values> unique_columns;
  for (size_t glyph = 0; glyph < glyph_count; ++glyph) {
    Values column;
    for (const Values* row : unique_rows) {
      column.push_back((*row)[glyph]);
    }
    const uint16_t number = right.of(column);
    matrix.right_class[glyph] = number;
    if (number > unique_columns.size()) {
      unique_columns.push_back(std::move(column));
    }
  }
  matrix.left_classes = left.count();
  matrix.right_classes = right.count();
  for (size_t row = 0; row < unique_rows.size(); ++row) {
    for (const Values& column : unique_columns) {
      matrix.values.push_back(column[row]);
    }
  }
  return matrix;
}

KerningMatrix read_kerning(const FontFile& font,
                           const std::vector<KerningGlyph>& glyphs,
                           int jobs) {
  const Coverage coverage = kerning_coverage(font);
  std::vector<size_t> lefts;
  std::map<hb_script_t, Column> columns;
  for (size_t i = 0; i < glyphs.size(); ++i) {
    const KerningGlyph& glyph = glyphs[i];
    if (!runs_left_to_right(glyph.script)) {
      continue;
    }
    if (hb_set_has(coverage.left.get(), glyph.source)) {
      lefts.push_back(i);
    }
    if (hb_set_has(coverage.right.get(), glyph.source)) {
      columns[glyph.script].sources.push_back(glyph.source);
      columns[glyph.script].glyphs.push_back(i);
    }
  }
  const std::optional<uint32_t> separator = find_separator(font, coverage);
  std::vector<std::vector<int16_t>> rows(lefts.size());
  // A shaper is costly to make and used by one thread only: each thread gets a
  // block of rows.
  constexpr size_t kBlock = 32;
  parallel_for((lefts.size() + kBlock - 1) / kBlock, jobs, [&](size_t block) {
    RowReader reader(font, glyphs, columns, separator);
    const size_t end = std::min(lefts.size(), (block + 1) * kBlock);
    for (size_t i = block * kBlock; i < end; ++i) {
      rows[i] = reader.read(lefts[i]);
    }
  });
  return join_classes(glyphs.size(), lefts, rows);
}

}  // namespace inkcell::gen
