#include "source/line_shaper.hpp"

#include <fribidi.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <set>
#include <string_view>

#include "base/error.hpp"

namespace inkcell::gen {
namespace {

using Faces = std::vector<ShapingFace>;

// Characters of one direction, script and face: one call of HarfBuzz.
struct Run {
  size_t begin = 0;
  size_t end = 0;
  bool is_right_to_left = false;
  hb_script_t script = HB_SCRIPT_COMMON;
  size_t face = 0;
};

// Levels of UAX #9, and the logical position of each visual one.
struct Order {
  std::vector<FriBidiLevel> levels;
  std::vector<FriBidiStrIndex> logical;  // of each place from left to right
};

Order find_order(const LineText& line) {
  const std::vector<FriBidiChar> text(line.text.begin(), line.text.end());
  const auto count = static_cast<FriBidiStrIndex>(text.size());
  std::vector<FriBidiCharType> types(text.size());
  std::vector<FriBidiBracketType> brackets(text.size());
  fribidi_get_bidi_types(text.data(), count, types.data());
  fribidi_get_bracket_types(text.data(), count, types.data(), brackets.data());
  FriBidiParType base =
      line.direction == LineDirection::left_to_right   ? FRIBIDI_PAR_LTR
      : line.direction == LineDirection::right_to_left ? FRIBIDI_PAR_RTL
                                                       : FRIBIDI_PAR_ON;
  Order order;
  order.levels.resize(text.size());
  order.logical.resize(text.size());
  std::iota(order.logical.begin(), order.logical.end(), 0);
  // The result 0 means out of memory.
  const bool done =
      fribidi_get_par_embedding_levels_ex(types.data(), brackets.data(), count,
                                          &base, order.levels.data()) != 0 &&
      fribidi_reorder_line(0, types.data(), count, 0, base, order.levels.data(),
                           nullptr, order.logical.data()) != 0;
  if (!done) {
    throw Error("a string cannot be ordered: FriBidi has no memory left");
  }
  return order;
}

// The script of each character. Characters without a script, such as spaces and
// marks, get that of the character before; at the start that of the first
// letter.
std::vector<hb_script_t> find_scripts(const std::u32string& text) {
  hb_unicode_funcs_t* unicode = hb_unicode_funcs_get_default();
  std::vector<hb_script_t> scripts;
  hb_script_t last = HB_SCRIPT_COMMON;
  for (const char32_t c : text) {
    const hb_script_t script = hb_unicode_script(unicode, c);
    const bool has_own = script != HB_SCRIPT_COMMON &&
                         script != HB_SCRIPT_INHERITED &&
                         script != HB_SCRIPT_UNKNOWN;
    if (has_own && last == HB_SCRIPT_COMMON) {
      std::fill(scripts.begin(), scripts.end(), script);
    }
    last = has_own ? script : last;
    scripts.push_back(last);
  }
  return scripts;
}

hb_unicode_general_category_t category_of(char32_t c) {
  return hb_unicode_general_category(hb_unicode_funcs_get_default(), c);
}

// Joiners and other invisible controls.
bool is_format(char32_t c) {
  return category_of(c) == HB_UNICODE_GENERAL_CATEGORY_FORMAT;
}

// Whether a character belongs to the letter before it.
bool is_of_cluster(char32_t c) {
  switch (category_of(c)) {
    case HB_UNICODE_GENERAL_CATEGORY_FORMAT:
    case HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_SPACING_MARK:
      return true;
    default:
      return false;
  }
}

// The first face with the letter and all its marks, else with the letter; else
// 0.
size_t face_of(const Faces& faces, std::u32string_view cluster) {
  for (size_t i = 0; i < faces.size(); ++i) {
    if (std::all_of(cluster.begin(), cluster.end(), [&](char32_t c) {
          return is_format(c) || faces[i].file->glyph_of(c) != 0;
        })) {
      return i;
    }
  }
  for (size_t i = 0; i < faces.size(); ++i) {
    if (faces[i].file->glyph_of(cluster.front()) != 0) {
      return i;
    }
  }
  return 0;
}

// The face of each character.
std::vector<size_t> find_faces(const Faces& faces, std::u32string_view text) {
  std::vector<size_t> result;
  while (result.size() < text.size()) {
    const size_t begin = result.size();
    size_t end = begin + 1;
    while (end < text.size() && is_of_cluster(text[end])) {
      ++end;
    }
    result.resize(end, face_of(faces, text.substr(begin, end - begin)));
  }
  return result;
}

// The runs of a line from left to right.
std::vector<Run> find_runs(const Faces& faces, const LineText& line) {
  const Order order = find_order(line);
  const std::vector<hb_script_t> scripts = find_scripts(line.text);
  const std::vector<size_t> face_at = find_faces(faces, line.text);
  std::vector<Run> logical;
  std::vector<size_t> run_of;
  for (size_t i = 0; i < line.text.size(); ++i) {
    const bool goes_on = i != 0 && order.levels[i] == order.levels[i - 1] &&
                         scripts[i] == scripts[i - 1] &&
                         face_at[i] == face_at[i - 1];
    if (!goes_on) {
      logical.push_back(
          {i, i, order.levels[i] % 2 != 0, scripts[i], face_at[i]});
    }
    logical.back().end = i + 1;
    run_of.push_back(logical.size() - 1);
  }
  // The characters of a run stay together.
  std::vector<Run> visual;
  for (size_t i = 0; i < order.logical.size(); ++i) {
    const size_t run = run_of[static_cast<size_t>(order.logical[i])];
    if (i == 0 || run != run_of[static_cast<size_t>(order.logical[i - 1])]) {
      visual.push_back(logical[run]);
    }
  }
  return visual;
}

struct DestroyBuffer {
  void operator()(hb_buffer_t* buffer) const { hb_buffer_destroy(buffer); }
};

bool has_ink(const FontFile& font, uint32_t glyph) {
  hb_glyph_extents_t box = {};
  return hb_font_get_glyph_extents(font.hb(), glyph, &box) == 0 ||
         (box.width != 0 && box.height != 0);
}

// Appends a run to the line.
void shape_run(const Faces& faces,
               const LineText& line,
               const Run& run,
               ShapedLine& out,
               std::set<char32_t>& missing) {
  const FontFile& font = *faces[run.face].file;
  const std::unique_ptr<hb_buffer_t, DestroyBuffer> owner(hb_buffer_create());
  hb_buffer_t* buffer = owner.get();
  // With the text before and after it, as letters join there.
  std::vector<uint32_t> text(line.text.begin(), line.text.end());
  hb_buffer_add_utf32(buffer, text.data(), static_cast<int>(text.size()),
                      static_cast<unsigned>(run.begin),
                      static_cast<int>(run.end - run.begin));
  hb_buffer_set_direction(
      buffer, run.is_right_to_left ? HB_DIRECTION_RTL : HB_DIRECTION_LTR);
  hb_buffer_set_script(buffer, run.script);
  hb_buffer_set_language(
      buffer, hb_language_from_string(
                  line.language.empty() ? "und" : line.language.c_str(), -1));
  hb_buffer_set_flags(buffer, HB_BUFFER_FLAG_REMOVE_DEFAULT_IGNORABLES);
  hb_shape(font.hb(), buffer, nullptr, 0);
  unsigned count = 0;
  const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer, &count);
  const hb_glyph_position_t* places =
      hb_buffer_get_glyph_positions(buffer, &count);
  const UnitScale scaled(font.units_per_em(),
                         faces.front().file->units_per_em(),
                         faces[run.face].scale);
  int advance = 0;
  for (unsigned i = 0; i < count; ++i) {
    const uint32_t glyph = infos[i].codepoint;
    const int x = out.advance + scaled(advance + places[i].x_offset);
    const int y = scaled(places[i].y_offset);
    if (glyph == 0) {
      const char32_t lacking = line.text[infos[i].cluster];
      missing.insert(lacking);
      out.glyphs.push_back({0, 0, x, y, lacking, scaled(places[i].x_advance)});
    } else if (has_ink(font, glyph)) {
      out.glyphs.push_back({run.face, glyph, x, y});
    }
    advance += places[i].x_advance;
  }
  out.advance += scaled(advance);
}

}  // namespace

ShapedLine shape_line(const Faces& faces, const LineText& line) {
  ShapedLine out;
  std::set<char32_t> missing;
  for (const Run& run : find_runs(faces, line)) {
    shape_run(faces, line, run, out, missing);
  }
  out.missing.assign(missing.begin(), missing.end());
  return out;
}

void place_icon(char32_t code_point, int advance, ShapedLine& line) {
  int moved = 0;
  for (LineGlyph& glyph : line.glyphs) {
    glyph.x += moved;
    if (glyph.lacking == code_point) {
      moved += advance - glyph.advance;
      glyph = {kIconFace, code_point, glyph.x, glyph.y};
    }
  }
  line.advance += moved;
  line.missing.erase(
      std::remove(line.missing.begin(), line.missing.end(), code_point),
      line.missing.end());
}

}  // namespace inkcell::gen
