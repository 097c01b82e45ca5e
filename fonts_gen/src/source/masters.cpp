#include "source/masters.hpp"

#include <algorithm>
#include <utility>

#include "shape/points.hpp"
#include "source/glyph_reader.hpp"

namespace inkcell::gen {
namespace {

bool equal_points(const Segment& a, const Segment& b) {
  return std::equal(std::begin(a.p), std::end(a.p), std::begin(b.p));
}

}  // namespace

void add_masters(const FontRequest& request,
                 SourceFont& font,
                 Warnings& warnings) {
  const FontFile file(request.file, request.face.value_or(0),
                      second_master(request.axes), request.instance);
  const std::string place = " at " + second_values(request.axes);
  const size_t count = font.glyphs.size();
  for (size_t i = 1; i < count; ++i) {
    const SourceGlyph& plain = font.glyphs[i];
    // Icons have the names of their own files.
    if (plain.face != 0 || plain.file_name != file.file_name() ||
        !font.is_shown(i)) {
      continue;
    }
    SourceGlyph second;
    second.file_name = plain.file_name;
    second.source = plain.source;
    second.master = plain.name() + place;
    read_glyph(file, second, warnings);
    if (second.advance != plain.advance ||
        !correspond(second.outline, plain.outline, equal_points)) {
      font.glyphs.push_back(std::move(second));
    }
  }
  if (font.glyphs.size() > kMostGlyphs) {
    file.refuse(std::to_string(font.glyphs.size()) +
                " glyphs with their second masters, a font holds at most "
                "65535; ask for less with --chars");
  }
  font.components.resize(font.glyphs.size());
  font.kerning.left_class.resize(font.glyphs.size());
  font.kerning.right_class.resize(font.glyphs.size());
}

}  // namespace inkcell::gen
