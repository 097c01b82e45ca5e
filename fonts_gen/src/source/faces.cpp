#include "source/faces.hpp"

#include <hb.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "shape/affine.hpp"
#include "source/glyph_reader.hpp"

namespace inkcell::gen {
namespace {

CharSet without(const CharSet& all, const CharSet& taken) {
  CharSet rest;
  std::set_difference(all.begin(), all.end(), taken.begin(), taken.end(),
                      std::inserter(rest, rest.end()));
  return rest;
}

void add_characters_of(const SourceFont& font, CharSet& out) {
  for (const SourceGlyph& glyph : font.glyphs) {
    out.insert(glyph.code_points.begin(), glyph.code_points.end());
  }
}

// Appends the classes of `part` to those of `matrix`; its glyphs follow the
// glyphs of `matrix`. Pairs across both do not kern.
void append_kerning(const KerningMatrix& part,
                    const UnitScale& scale,
                    KerningMatrix& matrix) {
  const auto append = [](const std::vector<uint16_t>& classes, int offset,
                         std::vector<uint16_t>& out) {
    for (size_t i = 1; i < classes.size(); ++i) {
      out.push_back(classes[i] == 0
                        ? uint16_t{0}
                        : static_cast<uint16_t>(classes[i] + offset));
    }
  };
  append(part.left_class, matrix.left_classes, matrix.left_class);
  append(part.right_class, matrix.right_classes, matrix.right_class);
  const auto left = static_cast<size_t>(matrix.left_classes);
  const auto right = static_cast<size_t>(matrix.right_classes);
  const auto part_left = static_cast<size_t>(part.left_classes);
  const auto part_right = static_cast<size_t>(part.right_classes);
  std::vector<int16_t> values((left + part_left) * (right + part_right));
  for (size_t row = 0; row < left; ++row) {
    for (size_t column = 0; column < right; ++column) {
      values[row * (right + part_right) + column] =
          matrix.values[row * right + column];
    }
  }
  for (size_t row = 0; row < part_left; ++row) {
    for (size_t column = 0; column < part_right; ++column) {
      values[(left + row) * (right + part_right) + right + column] =
          static_cast<int16_t>(std::clamp(
              scale(part.values[row * part_right + column]), -32768, 32767));
    }
  }
  matrix.values = std::move(values);
  matrix.left_classes += part.left_classes;
  matrix.right_classes += part.right_classes;
}

// Moves references of a glyph of `part` to a font in which its glyph 1 has the
// index `first`; none if one is to .notdef, which is dropped.
OutlineReferences moved(const OutlineReferences& references, size_t first) {
  OutlineReferences result;
  for (OutlineReference reference : references) {
    if (reference.glyph == 0) {
      return {};
    }
    reference.glyph += first - 1;
    result.push_back(reference);
  }
  return result;
}

CharSet characters_in(const FontFile& file, const CharSet& characters) {
  CharSet found;
  for (const char32_t c : characters) {
    if (file.glyph_of(c) != 0) {
      found.insert(c);
    }
  }
  return found;
}

bool is_letter_mark_or_digit(char32_t c) {
  const auto category =
      hb_unicode_general_category(hb_unicode_funcs_get_default(), c);
  // HarfBuzz numbers kinds of letters, then of marks, then of numbers.
  return category >= HB_UNICODE_GENERAL_CATEGORY_LOWERCASE_LETTER &&
         category <= HB_UNICODE_GENERAL_CATEGORY_OTHER_NUMBER;
}

}  // namespace

CharSet additions_to(const CharSet& asked,
                     Additions additions,
                     const std::function<bool(char32_t)>& is_in_files) {
  CharSet added;
  if (additions == Additions::none ||
      std::none_of(asked.begin(), asked.end(), is_in_files)) {
    return added;
  }
  // Adds the first of `signs` that a file has, unless one is there already.
  const auto add_one_of = [&](std::initializer_list<char32_t> signs) {
    if (std::any_of(signs.begin(), signs.end(), [&](char32_t c) {
          return asked.count(c) != 0 && is_in_files(c);
        })) {
      return;
    }
    const auto found = std::find_if(signs.begin(), signs.end(), is_in_files);
    if (found != signs.end()) {
      added.insert(*found);
    }
  };
  add_one_of({U' '});
  if (additions == Additions::signs &&
      std::any_of(asked.begin(), asked.end(), is_letter_mark_or_digit)) {
    add_one_of({U'.', U'\u2026'});
    add_one_of({U'-', U'\u2010'});
  }
  return added;
}

namespace {

// Whether a face gives icons. Glyphs of lines without a character are forms of
// letters.
bool gives_icons(const FontFile& file, const FontRequest& request) {
  CharSet taken = characters_in(file, request.characters);
  taken.insert(request.lines.characters.begin(),
               request.lines.characters.end());
  std::set<uint32_t> nameless = request.lines.glyphs;
  for (const char32_t c : taken) {
    nameless.erase(file.glyph_of(c));
  }
  const bool has_latin = file.glyph_of(U'A') != 0 || file.glyph_of(U'a') != 0;
  return !taken.empty() && nameless.empty() &&
         std::none_of(taken.begin(), taken.end(), is_letter_mark_or_digit) &&
         (!has_latin || std::any_of(taken.begin(), taken.end(), is_private));
}

// The position of a face's em square beside the font's letters. [u]
IconBox box_of(const MergedFace& face, const SourceMetrics& letters) {
  try {
    return icon_box(face.place, letters);
  } catch (const Error& error) {
    throw Error("--merge '" + face.file.string() + "': " + error.what());
  }
}

// The shift of a face above its baseline. Its em square is centred in its line:
// in 12 sets of icons (Material Symbols, Font Awesome, MDI, Bootstrap, Remix,
// Phosphor, ...) the middle of the median drawing is within 0.001 em of that,
// whatever the baseline.
double shift_em(const MergedFace& face,
                bool is_icons,
                const SourceMetrics& own,
                const SourceMetrics& letters) {
  const bool is_placed = face.baseline == MergedFace::Baseline::placed ||
                         (face.baseline == MergedFace::Baseline::by_kind &&
                          is_icons && letters.cap_height > 0);
  if (!is_placed) {
    return 0;
  }
  const IconBox box = box_of(face, letters);
  const double middle = (own.ascender + own.descender) / 2.0 / own.units_per_em;
  return (box.bottom - box.height * (middle - 0.5)) / kUPerEm;
}

std::vector<ShapedLine> shape_lines(const std::vector<FontFile>& files,
                                    const std::vector<double>& scales,
                                    const std::vector<LineText>& lines) {
  std::vector<ShapingFace> faces;
  for (size_t i = 0; i < files.size(); ++i) {
    faces.emplace_back(&files[i], scales[i]);
  }
  std::vector<ShapedLine> shaped;
  for (const LineText& line : lines) {
    shaped.push_back(shape_line(faces, line));
  }
  return shaped;
}

// The glyphs of the lines by face. A character comes from the first face that
// has it.
std::vector<LineShare> share_lines(const std::vector<FontFile>& files,
                                   const std::vector<LineText>& lines,
                                   const std::vector<ShapedLine>& shaped) {
  std::vector<LineShare> shares(files.size());
  for (const ShapedLine& line : shaped) {
    for (const LineGlyph& glyph : line.glyphs) {
      if (glyph.source != 0) {
        shares[glyph.face].glyphs.insert(glyph.source);
      }
    }
  }
  for (const LineText& line : lines) {
    for (const char32_t c : line.text) {
      const auto found = std::find_if(
          files.begin(), files.end(),
          [&](const FontFile& file) { return file.glyph_of(c) != 0; });
      if (found == files.end()) {
        continue;
      }
      LineShare& share =
          shares[static_cast<size_t>(std::distance(files.begin(), found))];
      if (share.glyphs.count(found->glyph_of(c)) != 0) {
        share.characters.insert(c);
      }
    }
  }
  return shares;
}

void warn_of_unused(const FontFile& file, Warnings& warnings) {
  warnings.push_back({Warning::Kind::unused_face,
                      file.file_name() +
                          ": is not used: it has no character that is asked "
                          "for and that the faces before it lack"});
}

// Warns of defaults such as "Thin (wght 100 of 100..900)" that nobody chose.
void tell_of_default(const FontFile& file,
                     bool is_chosen,
                     const std::string& remedy,
                     Warnings& warnings) {
  const Variation& variation = file.variation();
  if (variation.axes.empty() || is_chosen) {
    return;
  }
  const std::string names = variation.instance_names();
  warnings.push_back({Warning::Kind::default_instance,
                      file.file_name() +
                          ": is a variable font, taken at its default, " +
                          variation.place() + "; choose with " + remedy +
                          (names.empty() ? "" : ", instances: " + names)});
}

template <typename Item>
void permute(const std::vector<size_t>& order, std::vector<Item>& items) {
  std::vector<Item> result;
  for (const size_t i : order) {
    result.push_back(std::move(items[i]));
  }
  items = std::move(result);
}

}  // namespace

void sort_glyphs(SourceFont& font) {
  std::vector<size_t> order(font.glyphs.size());
  for (size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
  }
  const auto rank = [&font](size_t i) {
    const std::vector<char32_t>& codes = font.glyphs[i].code_points;
    return i == 0          ? char32_t{0}
           : codes.empty() ? char32_t{0xffffffff}
                           : codes.front();
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return rank(a) < rank(b); });
  std::vector<size_t> place(order.size());
  for (size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
  }
  font.components.resize(font.glyphs.size());
  for (OutlineReferences& references : font.components) {
    for (OutlineReference& reference : references) {
      reference.glyph = place[reference.glyph];
    }
  }
  permute(order, font.glyphs);
  permute(order, font.components);
  permute(order, font.kerning.left_class);
  permute(order, font.kerning.right_class);
}

void merge_font(SourceFont part, SourceFont& font) {
  const SourceFace& face = part.faces.front();
  const UnitScale scale(part.metrics.units_per_em, font.metrics.units_per_em,
                        face.scale);
  const bool is_moved = face.scale != 1 || face.shift_em != 0;
  const size_t first = font.glyphs.size();
  if (first + part.glyphs.size() - 1 > kMostGlyphs) {
    throw Error(part.file_name + ": with it the font has more than " +
                std::to_string(kMostGlyphs) +
                " glyphs; ask for fewer characters");
  }
  font.components.resize(first);
  part.components.resize(part.glyphs.size());
  for (size_t i = 1; i < part.glyphs.size(); ++i) {
    SourceGlyph& glyph = part.glyphs[i];
    glyph.advance = std::clamp(scale(glyph.advance), 0, 65535);
    if (is_moved) {
      const Affine to_font = {face.scale, 0, 0,
                              face.scale, 0, face.shift_em * kUPerEm};
      map(to_font, glyph.outline);
      for (PaintedOutline& layer : glyph.painted) {
        map(to_font, layer.outline);
      }
    }
    font.glyphs.push_back(std::move(glyph));
    // Offsets of components are whole font units, which scaled ones would not
    // be.
    font.components.push_back(scale.is_one() && !is_moved
                                  ? moved(part.components[i], first)
                                  : OutlineReferences());
  }
  append_kerning(part.kerning, scale, font.kerning);
  font.pixel_px = std::max(font.pixel_px, part.pixel_px);
  font.pixel_bits = std::max(font.pixel_bits, part.pixel_bits);
  font.file_name += ", " + part.file_name;
  font.faces.insert(font.faces.end(), part.faces.begin(), part.faces.end());
  sort_glyphs(font);
}

SourceFont load_faces(const FontRequest& first,
                      const std::vector<MergedFace>& more,
                      const std::vector<LineText>& lines,
                      int jobs,
                      Warnings& warnings) {
  std::vector<FontFile> files;
  files.reserve(1 + more.size());
  files.emplace_back(first.file, first.face.value_or(0), first.axes,
                     first.instance);
  Warnings ignored;  // load_font gives them
  const SourceMetrics letters = read_metrics(files.front(), ignored);
  std::vector<double> scales = {1};
  for (const MergedFace& face : more) {
    files.emplace_back(face.file, face.face.value_or(0), face.axes,
                       face.instance);
    scales.push_back(box_of(face, letters).height / kUPerEm);
  }
  const std::vector<ShapedLine> shaped = shape_lines(files, scales, lines);
  const std::vector<LineShare> shares = share_lines(files, lines, shaped);

  CharSet all = first.characters;
  for (const MergedFace& face : more) {
    all.insert(face.characters.begin(), face.characters.end());
  }
  const CharSet added = additions_to(all, first.additions, [&](char32_t c) {
    return std::any_of(files.begin(), files.end(), [c](const FontFile& file) {
      return file.glyph_of(c) != 0;
    });
  });

  FontRequest request = first;
  request.lines = shares.front();
  request.characters.merge(characters_in(files.front(), added));
  if (!request.shapes.empty()) {
    const auto plans = shape_plans(files.front(), request.shapes);
    request.characters.merge(characters_in(
        files.front(), shape_additions(plans, request.characters)));
    request.lines.glyphs.merge(
        shape_closure(files.front(), plans, request.characters));
  }
  if (request.keep_layout) {
    request.characters.merge(
        characters_in(files.front(), decompositions(request.characters)));
    request.lines.glyphs.merge(
        layout_closure(files.front(), request.characters));
  }
  SourceFont font = load_font(files.front(), request, jobs, warnings);
  tell_of_default(files.front(), !first.axes.empty() || !first.instance.empty(),
                  "--instance NAME or --axis TAG=VALUE", warnings);
  CharSet asked = first.characters;
  CharSet given;
  add_characters_of(font, given);
  for (size_t i = 0; i < more.size(); ++i) {
    const FontFile& file = files[i + 1];
    const CharSet& list = more[i].characters;
    asked.insert(list.begin(), list.end());
    request.file = more[i].file;
    request.face = more[i].face;
    request.lines = shares[i + 1];
    request.characters = without(list.empty() ? asked : list, given);
    if (list.empty()) {
      request.characters = characters_in(file, request.characters);
    }
    request.characters.merge(characters_in(file, without(added, given)));
    if (request.characters.empty() && request.lines.glyphs.empty()) {
      warn_of_unused(file, warnings);
      continue;
    }
    const bool is_icons = gives_icons(file, request);
    SourceFont part = load_font(file, request, jobs, warnings);
    part.faces.front().scale = scales[i + 1];
    part.faces.front().shift_em =
        shift_em(more[i], is_icons, part.metrics, letters);
    tell_of_default(file, !more[i].axes.empty() || !more[i].instance.empty(),
                    "--merge FILE:instance=NAME or FILE:TAG=VALUE", warnings);
    for (SourceGlyph& glyph : part.glyphs) {
      glyph.face = i + 1;
    }
    add_characters_of(part, given);
    merge_font(std::move(part), font);
  }
  font.lines = shaped;
  font.added = added;
  CharSet missing = missing_in_lines(font);
  for (const char32_t c : without(asked, given)) {
    if (is_missed(c)) {
      missing.insert(c);
    }
  }
  font.missing.assign(missing.begin(), missing.end());
  if (font.glyphs.size() == 1 && !missing.empty()) {
    refuse_all(files.front(), missing.size());
  }
  renew_missing_warning(font, warnings);
  return font;
}

}  // namespace inkcell::gen
