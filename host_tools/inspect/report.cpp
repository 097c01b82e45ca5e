// Writes a census down.
#include "report.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "rom_file.hpp"

namespace inkcell::tools {
namespace {

// Glyphs in a row of the table of cells.
constexpr size_t kColumns = 8;

// More glyphs than this are not listed one by one.
constexpr size_t kListed = 256;

[[gnu::format(printf, 2, 3)]] void append(std::string& out,
                                          const char* format,
                                          ...) {
  char line[256];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  out += line;
}

std::string code_point_ranges(const FontCensus& font) {
  std::vector<char32_t> all;
  for (const GlyphCensus& glyph : font.glyphs) {
    all.insert(all.end(), glyph.code_points.begin(), glyph.code_points.end());
  }
  std::sort(all.begin(), all.end());
  std::string text;
  size_t ranges = 0;
  for (size_t i = 0; i < all.size();) {
    size_t end = i + 1;
    while (end < all.size() && all[end] == all[end - 1] + 1) {
      ++end;
    }
    if (++ranges > 8) {
      return text + " ...";
    }
    append(text, " U+%04X", static_cast<unsigned>(all[i]));
    if (end > i + 1) {
      append(text, "-%04X", static_cast<unsigned>(all[end - 1]));
    }
    i = end;
  }
  return text;
}

void append_sections(std::string& out, const FontCensus& font) {
  const auto row = [&](const char* name, size_t offset, size_t size) {
    append(out, "    %-10s %9zu bytes at %zu\n", name, size, offset);
  };
  out += "  sections\n";
  row("header", 0, font.header_bytes);
  for (const SectionCensus& section : font.sections) {
    row(section.tag.c_str(), section.offset, section.size);
  }
}

void append_parts(std::string& out,
                  const char* title,
                  const std::vector<RecordPart>& parts) {
  append(out, "  %s\n", title);
  for (const RecordPart& part : parts) {
    append(out, "    %-18s %9zu bytes\n", part.name.c_str(), part.bytes);
  }
}

void append_cells(std::string& out, const FontCensus& font) {
  append(out, "  cells           %lld, inner nodes %lld\n",
         static_cast<long long>(font.cells()),
         static_cast<long long>(font.nodes()));
  append_parts(out, "records", font.parts());
  if (font.glyphs.size() > kListed) {
    return;
  }
  append(out, "  cells per glyph .notdef %d", font.glyphs.front().cells);
  for (size_t i = 1; i < font.glyphs.size(); ++i) {
    const GlyphCensus& glyph = font.glyphs[i];
    out += i % kColumns == 1 ? "\n    " : "  ";
    append(out, "%s %5d", glyph.name().c_str(), glyph.cells);
  }
  out += '\n';
}

std::string width_text(int bits) {
  return bits == 0 ? "0" : std::to_string(bits) + " bits";
}

// The code table, and how often records use each word.
void append_words(std::string& out, const FontCensus& font) {
  append(out, "  code tables     %d, %zu words\n",
         font.words.empty() ? 0 : font.words.back().table + 1,
         font.words.size());
  for (size_t i = 0; i < font.words.size(); ++i) {
    const CodeWord& word = font.words[i];
    const auto uses = static_cast<long long>(font.uses(i));
    if (i != 0 && word.table != font.words[i - 1].table) {
      append(out, "   table %d\n", word.table);
    }
    if (word.is_end) {
      append(out, "    %-8s end of contour %22lld uses\n", word.bits.c_str(),
             uses);
    } else {
      append(out, "    %-8s %-9s  dx %-7s dy %-7s %6lld uses\n",
             word.bits.c_str(), kind_name(word.kind),
             width_text(word.x_bits).c_str(), width_text(word.y_bits).c_str(),
             uses);
    }
  }
}

void append_outlines(std::string& out, const FontCensus& font) {
  append(out,
         "  points          %lld: %lld corners, %lld smooth, %lld off "
         "the curve\n",
         static_cast<long long>(font.points()),
         static_cast<long long>(font.points_of(PointKind::corner)),
         static_cast<long long>(font.points_of(PointKind::smooth)),
         static_cast<long long>(font.points_of(PointKind::off_curve)));
  append(out, "  grid            %g font units\n", font.grid_units);
  append(out, "  composites      %d glyphs\n", font.composites());
  append_words(out, font);
  if (font.glyphs.size() > kListed) {
    return;
  }
  append(out, "  points per glyph .notdef %d",
         font.glyphs.front().outline.points());
  for (size_t i = 1; i < font.glyphs.size(); ++i) {
    const GlyphCensus& glyph = font.glyphs[i];
    out += i % kColumns == 1 ? "\n    " : "  ";
    append(out, "%s %5d", glyph.name().c_str(), glyph.outline.points());
  }
  out += '\n';
}

void append_outline(std::string& out, const GlyphCensus& glyph) {
  const GlyphOutline& outline = glyph.outline;
  append(out,
         "  points          %d in %zu contours: %d corners, %d smooth, %d off "
         "the curve\n",
         outline.points(), outline.contours.size(),
         outline.points_of(PointKind::corner),
         outline.points_of(PointKind::smooth),
         outline.points_of(PointKind::off_curve));
  for (const OutlineComponent& part : outline.components) {
    append(out, "    refers to #%d at (%d, %d) units", part.glyph, part.dx,
           part.dy);
    if (part.xx != 1 || part.xy != 0 || part.yx != 0 || part.yy != 1) {
      append(out, ", matrix %.4f %.4f %.4f %.4f", part.xx, part.xy, part.yx,
             part.yy);
    }
    out += '\n';
  }
  append(out, "  record          %zu bytes\n", glyph.bytes);
}

nlohmann::json outline_json(const GlyphOutline& outline) {
  nlohmann::json components = nlohmann::json::array();
  for (const OutlineComponent& part : outline.components) {
    components.push_back({{"glyph", part.glyph},
                          {"matrix", {part.xx, part.xy, part.yx, part.yy}},
                          {"offset", {part.dx, part.dy}}});
  }
  return {{"points", outline.points()},
          {"corners", outline.points_of(PointKind::corner)},
          {"smooth", outline.points_of(PointKind::smooth)},
          {"off_curve", outline.points_of(PointKind::off_curve)},
          {"contours", outline.contours.size()},
          {"components", components}};
}

nlohmann::json words_json(const FontCensus& font) {
  nlohmann::json words = nlohmann::json::array();
  for (size_t i = 0; i < font.words.size(); ++i) {
    const CodeWord& word = font.words[i];
    words.push_back({{"table", word.table},
                     {"bits", word.bits},
                     {"next_table", word.next_table},
                     {"kind", word.is_end ? "end" : kind_name(word.kind)},
                     {"dx_bits", word.x_bits},
                     {"dy_bits", word.y_bits},
                     {"uses", font.uses(i)}});
  }
  return words;
}

// The tree and the cells of one glyph.
void append_cells_of(std::string& out, const GlyphCensus& glyph) {
  const GlyphField& field = glyph.field;
  append(out, "  grid            %d x %d tiles of %d u from (%d, %d) u\n",
         field.tiles_x, field.tiles_y, 1 << field.tile_log2, field.x0_u,
         field.y0_u);
  append(out, "  tree            %d nodes, depth %d\n", glyph.nodes,
         glyph.depth);
  append(out, "  cells           %d, and saturated: %d outside, %d inside\n",
         glyph.cells, glyph.outside, glyph.inside);
  for (size_t i = glyph.by_size_log2.size(); i-- > 0;) {
    if (glyph.by_size_log2[i] > 0) {
      append(out, "    %4d u        %d\n", 1 << i, glyph.by_size_log2[i]);
    }
  }
  append(out, "  record          %zu bytes\n", glyph.bytes);
  append_parts(out, "of these", glyph.parts);
}

const char* side_of(const HintZone& zone) {
  return zone.is_top ? "top" : "bottom";
}

// Hints of all glyphs whose edges lie in a zone.
int hints_in(const GridHints& hints, int zone) {
  int count = 0;
  for (const GlyphHints& glyph : hints.glyphs) {
    count += static_cast<int>(std::count_if(
        glyph.heights.begin(), glyph.heights.end(),
        [zone](const HeightHint& hint) { return hint.zone == zone; }));
  }
  return count;
}

void append_hints(std::string& out, const GridHints& hints) {
  if (!hints.is_there) {
    out += "  hints           none\n";
    return;
  }
  append(out, "  hints           %zu zones, stems %d u wide, bars %d u%s%s\n",
         hints.zones.size(), hints.stem_width_u, hints.bar_width_u,
         hints.has_contrast ? ", much contrast" : "",
         hints.has_few_bars ? ", few bars" : "");
  for (size_t i = 0; i < hints.zones.size(); ++i) {
    const auto zone = static_cast<int>(i);
    append(out, "    zone %-2d         %5d u, %s, overshoot %d u, %d edges%s\n",
           zone, hints.zones[i].flat_u, side_of(hints.zones[i]),
           hints.zones[i].overshoot_u, hints_in(hints, zone),
           zone == hints.x_zone ? ", x-height" : "");
  }
}

void append_height(std::string& out, const HeightHint& hint) {
  append(out, "    %-9s       %5d u", kind_name(hint.kind), hint.low_u);
  if (hint.high_u != hint.low_u) {
    append(out, " to %d u", hint.high_u);
  }
  if (hint.zone >= 0) {
    append(out, ", zone %d", hint.zone);
  }
  if (hint.kind == HeightHint::Kind::free_end) {
    out += hint.rises ? ", rises" : ", hangs";
  }
  out += '\n';
}

void append_hints_of(std::string& out, const GlyphHints& glyph) {
  append(out, "  hints           %zu heights, %zu stems%s\n",
         glyph.heights.size(), glyph.stems.size(),
         glyph.is_symmetric ? ", symmetric" : "");
  if (glyph.left_inset_u != 0 || glyph.right_inset_u != 0) {
    append(out, "    serifs reach    %5d u to the left, %d u to the right\n",
           glyph.left_inset_u, glyph.right_inset_u);
  }
  for (const HeightHint& hint : glyph.heights) {
    append_height(out, hint);
  }
  for (const StemHint& hint : glyph.stems) {
    append(out, "    stem            %5d u to %d u\n", hint.left_u,
           hint.right_u);
  }
}

nlohmann::json hints_json(const GridHints& hints) {
  nlohmann::json zones = nlohmann::json::array();
  for (const HintZone& zone : hints.zones) {
    zones.push_back({{"flat_u", zone.flat_u},
                     {"overshoot_u", zone.overshoot_u},
                     {"side", side_of(zone)}});
  }
  return {{"zones", zones},
          {"x_zone", hints.x_zone},
          {"stem_width_u", hints.stem_width_u},
          {"bar_width_u", hints.bar_width_u},
          {"contrast", hints.has_contrast},
          {"few_bars", hints.has_few_bars}};
}

nlohmann::json hints_json(const GlyphHints& glyph) {
  nlohmann::json heights = nlohmann::json::array();
  for (const HeightHint& hint : glyph.heights) {
    nlohmann::json json = {{"kind", kind_name(hint.kind)},
                           {"low_u", hint.low_u},
                           {"high_u", hint.high_u},
                           {"zone", hint.zone}};
    if (hint.kind == HeightHint::Kind::free_end) {
      json["rises"] = hint.rises;
    }
    heights.push_back(std::move(json));
  }
  nlohmann::json stems = nlohmann::json::array();
  for (const StemHint& hint : glyph.stems) {
    stems.push_back({{"left_u", hint.left_u}, {"right_u", hint.right_u}});
  }
  return {{"symmetric", glyph.is_symmetric},
          {"insets_u", {glyph.left_inset_u, glyph.right_inset_u}},
          {"heights", heights},
          {"stems", stems}};
}

nlohmann::json parts_json(const std::vector<RecordPart>& parts) {
  nlohmann::json json = nlohmann::json::object();
  for (const RecordPart& part : parts) {
    json[part.name] = part.bytes;
  }
  return json;
}

nlohmann::json glyph_json(const GlyphCensus& glyph, bool has_outlines) {
  nlohmann::json sizes = nlohmann::json::object();
  for (size_t i = 0; i < glyph.by_size_log2.size(); ++i) {
    if (glyph.by_size_log2[i] > 0) {
      sizes[std::to_string(1 << i)] = glyph.by_size_log2[i];
    }
  }
  nlohmann::json code_points = nlohmann::json::array();
  for (const char32_t code_point : glyph.code_points) {
    code_points.push_back(static_cast<uint32_t>(code_point));
  }
  const GlyphMetrics& m = glyph.metrics;
  nlohmann::json json = {{"glyph", glyph.glyph},
                         {"name", glyph.name()},
                         {"code_points", code_points},
                         {"advance", m.advance},
                         {"box", {m.x_min, m.y_min, m.x_max, m.y_max}},
                         {"bytes", glyph.bytes}};
  if (has_outlines) {
    json.update(outline_json(glyph.outline));
    return json;
  }
  json.update({{"record_bytes", parts_json(glyph.parts)},
               {"cells", glyph.cells},
               {"nodes", glyph.nodes},
               {"saturated_outside", glyph.outside},
               {"saturated_inside", glyph.inside},
               {"depth", glyph.depth},
               {"cells_by_size_u", sizes},
               {"grid",
                {{"x0_u", glyph.field.x0_u},
                 {"y0_u", glyph.field.y0_u},
                 {"tile_u", 1 << glyph.field.tile_log2},
                 {"tiles_x", glyph.field.tiles_x},
                 {"tiles_y", glyph.field.tiles_y}}}});
  return json;
}

nlohmann::json metrics_json(const FontMetrics& m) {
  return {{"units_per_em", m.units_per_em},
          {"ascender", m.ascender},
          {"descender", m.descender},
          {"line_gap", m.line_gap},
          {"x_height", m.x_height},
          {"cap_height", m.cap_height},
          {"box", {m.x_min, m.y_min, m.x_max, m.y_max}}};
}

}  // namespace

std::string font_report(const FontCensus& font) {
  const FontMetrics& m = font.metrics;
  std::string out = font.name.empty() ? "(no name)\n" : font.name + "\n";
  append(out, "  format          %d.%d, %zu bytes, verify: %s\n",
         font.format_major, font.format_minor, font.bytes,
         std::string(status_name(font.verified)).c_str());
  append(out, "  coding          %s\n", font.coding_name.c_str());
  append(out, "  made for        %u to %u px, tolerance %u/255, predicate %s\n",
         static_cast<unsigned>(font.range.min_px),
         static_cast<unsigned>(font.range.max_px),
         static_cast<unsigned>(font.range.tolerance),
         font.fixed_predicate ? "fixed" : "size");
  append(out,
         "  metrics         %d units/em, ascender %d, descender %d, gap %d,\n"
         "                  x-height %d, cap-height %d\n",
         m.units_per_em, m.ascender, m.descender, m.line_gap, m.x_height,
         m.cap_height);
  append(out, "  glyphs          %zu, for %zu characters:%s\n",
         font.glyphs.size(), font.characters, code_point_ranges(font).c_str());
  for (const std::string& strike : font.strikes) {
    append(out, "  strike          %s\n", strike.c_str());
  }
  if (font.layer_lists != 0) {
    append(out, "  colour glyphs   %d\n", font.layer_lists);
  }
  for (size_t i = 0; i < font.palettes.size(); ++i) {
    append(out, "  palette %-8zu", i);
    out += font.palettes[i] + "\n";
  }
  append(out, "  kerning         %d left classes, %d right\n",
         font.left_classes, font.right_classes);
  if (font.morph_pairs != 0) {
    append(out, "  morphs          %d pairs\n", font.morph_pairs);
  }
  if (font.masters != 0) {
    append(out, "  second masters  %d glyphs\n", font.masters);
  }
  if (font.has_outlines()) {
    append(out, "  at most         %d points in a glyph\n", font.max_points);
  } else {
    append(out, "  at most         %u cells, %u nodes, depth %u in a glyph\n",
           static_cast<unsigned>(font.range.max_cells),
           static_cast<unsigned>(font.range.max_nodes),
           static_cast<unsigned>(font.range.max_depth));
  }
  append_sections(out, font);
  append_hints(out, font.hints);
  if (font.has_outlines()) {
    append_outlines(out, font);
  } else {
    append_cells(out, font);
  }
  return out;
}

std::string glyph_report(const FontCensus& font, const GlyphCensus& glyph) {
  const GlyphMetrics& m = glyph.metrics;
  std::string out =
      "glyph " + std::to_string(glyph.glyph) + ", " + glyph.name();
  for (const char32_t code_point : glyph.code_points) {
    append(out, ", U+%04X", static_cast<unsigned>(code_point));
  }
  append(out, "\n  advance         %d of %d units/em\n", m.advance,
         font.metrics.units_per_em);
  append(out, "  ink             x %d to %d, y %d to %d units\n", m.x_min,
         m.x_max, m.y_min, m.y_max);
  if (font.has_outlines()) {
    append_outline(out, glyph);
  } else {
    append_cells_of(out, glyph);
  }
  if (font.hints.is_there) {
    append_hints_of(out, font.hints.glyphs[glyph.glyph]);
  }
  return out;
}

std::string json_report(const FontCensus& font, const GlyphCensus* glyph) {
  nlohmann::json sections = {{"header", font.header_bytes}};
  for (const SectionCensus& section : font.sections) {
    sections[section.tag] = section.size;
  }
  nlohmann::json glyphs = nlohmann::json::array();
  for (const GlyphCensus& each : font.glyphs) {
    if (glyph == nullptr || each.glyph == glyph->glyph) {
      glyphs.push_back(glyph_json(each, font.has_outlines()));
      if (font.hints.is_there) {
        glyphs.back()["hints"] = hints_json(font.hints.glyphs[each.glyph]);
      }
    }
  }
  nlohmann::json whole = {
      {"name", font.name},
      {"bytes", font.bytes},
      {"format", {font.format_major, font.format_minor}},
      {"verify", std::string(status_name(font.verified))},
      {"min_px", font.range.min_px},
      {"max_px", font.range.max_px},
      {"tolerance", font.range.tolerance},
      {"band_u", font.range.band_u},
      {"predicate", font.fixed_predicate ? "fixed" : "size"},
      {"metrics", metrics_json(font.metrics)},
      {"characters", font.characters},
      {"kerning_classes", {font.left_classes, font.right_classes}},
      {"morph_pairs", font.morph_pairs},
      {"masters", font.masters},
      {"section_bytes", sections},
      {"hints", hints_json(font.hints)},
      {"coding", font.coding_name},
      {"glyphs", glyphs}};
  if (font.has_outlines()) {
    whole.update({{"points", font.points()},
                  {"composites", font.composites()},
                  {"max_points", font.max_points},
                  {"grid_units", font.grid_units},
                  {"code", words_json(font)}});
  } else {
    whole.update({{"record_bytes", parts_json(font.parts())},
                  {"cells", font.cells()},
                  {"nodes", font.nodes()}});
  }
  return whole.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
         "\n";
}

}  // namespace inkcell::tools
