#include "export/ttf.hpp"

#include <algorithm>
#include <cmath>

#include "export/glyf_components.hpp"
#include "export/sfnt.hpp"
#include "export/tables.hpp"
#include "files.hpp"
#include "model/error.hpp"
#include "rom_file.hpp"

namespace inkcell::design {
namespace {

// 1 January 2000, in seconds since 1904: equal projects give equal fonts.
constexpr uint64_t kDate = 3029529600;

struct ExportGlyph {
  std::string name;
  std::vector<char32_t> unicodes;
  int advance = 0;
  GlyfGlyph outline;
  GlyfBox box;
};

class TtfWriter {
 public:
  TtfWriter(const Project& project, TtfReport& report)
      : project_(project), report_(report) {
    collect();
  }

  std::vector<uint8_t> write() {
    add_outlines();
    tables_["head"] = head();
    tables_["hhea"] = hhea();
    tables_["hmtx"] = hmtx();
    tables_["maxp"] = maxp();
    tables_["OS/2"] = os2();
    tables_["cmap"] = cmap();
    tables_["name"] = name();
    tables_["post"] = post();
    add_kerning();
    return write_sfnt(tables_);
  }

 private:
  int info(const char* key, double otherwise) const {
    const auto found = project_.font->info.find(key);
    const double value =
        found != project_.font->info.end() && found->is_number()
            ? found->get<double>()
            : otherwise;
    return static_cast<int>(std::lround(std::clamp(value, -32768.0, 32767.0)));
  }
  std::string text(const char* key, const std::string& otherwise) const {
    const auto found = project_.font->info.find(key);
    return found != project_.font->info.end() && found->is_string()
               ? found->get<std::string>()
               : otherwise;
  }
  int em() const { return info("unitsPerEm", 1000); }
  // A list of numbers; empty without one.
  std::vector<unsigned> numbers(const char* key) const {
    std::vector<unsigned> list;
    const auto found = project_.font->info.find(key);
    if (found != project_.font->info.end() && found->is_array()) {
      for (const Value& value : *found) {
        if (value.is_number_unsigned()) {
          list.push_back(value.get<unsigned>());
        }
      }
    }
    return list;
  }
  unsigned bits(const char* key) const {
    unsigned sum = 0;
    for (const unsigned bit : numbers(key)) {
      sum |= bit < 16 ? 1u << bit : 0;
    }
    return sum;
  }
  bool is_style(const char* word) const {
    return text("styleMapStyleName", "").find(word) != std::string::npos;
  }

  void collect() {
    std::vector<std::string> names = glyph_order(project_);
    const auto notdef = std::find(names.begin(), names.end(), ".notdef");
    if (notdef != names.end()) {
      std::rotate(names.begin(), notdef, notdef + 1);
    } else {
      add_box();
    }
    for (const std::string& glyph_name : names) {
      const Glyph& glyph = *project_.glyph(glyph_name);
      if (glyph_name == ".notdef" ||
          (glyph_name[0] != '_' && !glyph.unicodes.empty())) {
        want(glyph_name);
      }
    }
    for (const std::string& glyph_name : names) {
      if (outlines_.count(glyph_name) != 0) {
        const Glyph& glyph = *project_.glyph(glyph_name);
        if (is_undrawn(glyph)) {
          ++report_.undrawn;
        }
        if (std::any_of(glyph.contours.begin(), glyph.contours.end(),
                        [](const PointContour& one) {
                          return one.open() && one.points.size() > 1;
                        })) {
          report_.open.push_back(glyph_name);
        }
        add_glyph(glyph);
      } else {
        report_.left_out.push_back(glyph_name);
      }
    }
    report_.glyphs = glyphs_.size();
    report_.has_features = !project_.font->features.empty();
    if (glyphs_.size() > 65535) {
      throw Error("the project has more than 65535 glyphs, the limit of fonts");
    }
  }

  // A glyph that the font has, and the components that it needs.
  void want(const std::string& name) {
    if (outlines_.count(name) != 0) {
      return;
    }
    try {
      outlines_[name] = glyf_glyph(project_, *project_.glyph(name));
    } catch (const Error& error) {
      throw Error("glyph '" + name + "': " + error.what());
    }
    for (const GlyfComponent& component : outlines_[name].components) {
      want(component.base);
    }
  }

  // An empty box in the place of .notdef.
  void add_box() {
    const int line = em() / 20;
    const int right = em() / 2 - line;
    const int top = std::max(info("capHeight", 0.7 * em()), 3 * line);
    ExportGlyph glyph;
    glyph.name = ".notdef";
    glyph.advance = em() / 2;
    glyph.outline.contours = {
        {{line, 0}, {line, top}, {right, top}, {right, 0}},
        {{2 * line, line},
         {right - line, line},
         {right - line, top - line},
         {2 * line, top - line}}};
    glyph.box = box_of(glyph.outline.contours);
    glyphs_.push_back(std::move(glyph));
  }

  void add_glyph(const Glyph& source) {
    ExportGlyph glyph;
    glyph.name = source.name;
    glyph.unicodes = source.unicodes;
    glyph.advance =
        static_cast<int>(std::lround(std::clamp(source.width, 0.0, 65535.0)));
    glyph.outline = std::move(outlines_[source.name]);
    glyph.box = box_of(glyph.outline.contours);
    glyphs_.push_back(std::move(glyph));
  }

  void add_outlines() {
    std::map<std::string, unsigned> ids;
    for (size_t i = 0; i < glyphs_.size(); ++i) {
      ids[glyphs_[i].name] = static_cast<unsigned>(i);
    }
    BigEndian glyf;
    BigEndian loca;
    for (const ExportGlyph& glyph : glyphs_) {
      loca.u32(static_cast<uint32_t>(glyf.size()));
      glyf.append(glyph.outline.components.empty()
                      ? glyf_record(glyph.outline.contours)
                      : composite_record(glyph.outline, ids));
      glyf.align(4);
    }
    loca.u32(static_cast<uint32_t>(glyf.size()));
    if (glyf.size() == 0) {
      glyf.u8(0);  // FreeType refuses an empty table
    }
    tables_["glyf"] = std::move(glyf);
    tables_["loca"] = std::move(loca);
  }

  int least(int GlyfBox::*side) const {
    int result = 0;
    for (const ExportGlyph& glyph : glyphs_) {
      result = std::min(result, glyph.box.*side);
    }
    return result;
  }
  int most(int GlyfBox::*side) const {
    int result = 0;
    for (const ExportGlyph& glyph : glyphs_) {
      result = std::max(result, glyph.box.*side);
    }
    return result;
  }

  BigEndian head() const {
    BigEndian table;
    table.u32(0x00010000);
    table.u32(0x00010000);  // revision
    table.u32(0);           // write_sfnt() fills it in
    table.u32(0x5f0f3cf5);
    table.words(0x000b, em());  // baseline and bearing at 0, whole px
    table.u64(kDate);
    table.u64(kDate);
    table.words(least(&GlyfBox::x0), least(&GlyfBox::y0), most(&GlyfBox::x1),
                most(&GlyfBox::y1));
    table.u16((is_style("bold") ? 1u : 0u) | (is_style("italic") ? 2u : 0u));
    table.words(6, 2, 1, 0);  // least size; long offsets
    return table;
  }

  int ascender() const {
    return info("openTypeHheaAscender", info("ascender", 0.8 * em()));
  }
  int descender() const {
    return info("openTypeHheaDescender", info("descender", -0.2 * em()));
  }
  int line_gap() const { return info("openTypeHheaLineGap", 0); }

  BigEndian hhea() const {
    int widest = 0, left = 32767, right = 32767, extent = 0;
    for (const ExportGlyph& glyph : glyphs_) {
      widest = std::max(widest, glyph.advance);
      if (!glyph.outline.contours.empty()) {
        left = std::min(left, glyph.box.x0);
        right = std::min(right, glyph.advance - glyph.box.x1);
        extent = std::max(extent, glyph.box.x1);
      }
    }
    BigEndian table;
    table.u32(0x00010000);
    table.words(ascender(), descender(), line_gap(), widest,
                left == 32767 ? 0 : left,
                right == 32767 ? 0 : std::max(right, -32768), extent);
    table.words(1, 0, 0, 0, 0, 0, 0, 0, glyphs_.size());  // caret upright
    return table;
  }

  BigEndian hmtx() const {
    BigEndian table;
    for (const ExportGlyph& glyph : glyphs_) {
      table.words(glyph.advance, glyph.box.x0);
    }
    return table;
  }

  BigEndian maxp() const {
    size_t points[2] = {}, contours[2] = {};  // simple glyphs, composites
    size_t components = 0;
    int depth = 0;
    for (const ExportGlyph& glyph : glyphs_) {
      const GlyfGlyph& outline = glyph.outline;
      size_t count = 0;
      for (const GlyfContour& contour : outline.contours) {
        count += contour.size();
      }
      const size_t kind = outline.components.empty() ? 0 : 1;
      points[kind] = std::max(points[kind], count);
      contours[kind] = std::max(contours[kind], outline.contours.size());
      components = std::max(components, outline.components.size());
      depth = std::max(depth, outline.depth);
    }
    BigEndian table;
    table.u32(0x00010000);
    table.words(glyphs_.size(), points[0], contours[0], points[1], contours[1]);
    table.words(2, 0, 0, 0, 0, 0, 0, components, depth);  // two zones
    return table;
  }

  BigEndian os2() const {
    int sum = 0, count = 0;
    char32_t first = 0xffff, last = 0;
    for (const ExportGlyph& glyph : glyphs_) {
      sum += glyph.advance;
      count += glyph.advance > 0 ? 1 : 0;
      for (const char32_t c : glyph.unicodes) {
        first = std::min(first, c);
        last = std::max(last, c);
      }
    }
    BigEndian table;
    table.words(4, count == 0 ? 0 : std::min(sum / count, 32767),
                info("openTypeOS2WeightClass", 400),
                info("openTypeOS2WidthClass", 5), bits("openTypeOS2Type"));
    for (const double part : {0.65, 0.7, 0.0, 0.14, 0.65, 0.7, 0.0, 0.48, 0.05,
                              0.26}) {  // sub-, superscripts, strike-out
      table.i16(static_cast<int>(part * em()));
    }
    table.u16(0);  // class
    std::vector<unsigned> panose = numbers("openTypeOS2Panose");
    panose.resize(10 + 16);  // and ranges of characters
    for (const unsigned value : panose) {
      table.u8(value);
    }
    std::string vendor = text("openTypeOS2VendorID", "NONE");
    vendor.resize(4, ' ');
    table.text(vendor);
    const unsigned style =
        (is_style("italic") ? 1u : 0u) | (is_style("bold") ? 0x20u : 0u);
    table.words(
        bits("openTypeOS2Selection") | (style == 0 ? 0x40 : style),
        std::min<char32_t>(first, 0xffff), std::min<char32_t>(last, 0xffff),
        info("openTypeOS2TypoAscender", ascender()),
        info("openTypeOS2TypoDescender", descender()),
        info("openTypeOS2TypoLineGap", line_gap()),
        std::max(info("openTypeOS2WinAscent", most(&GlyfBox::y1)), 0),
        std::max(info("openTypeOS2WinDescent", -least(&GlyfBox::y0)), 0));
    table.u32(1);  // code page of Latin 1
    table.u32(0);
    table.words(info("xHeight", 0), info("capHeight", 0), 0, 32, 2);
    return table;
  }

  BigEndian cmap() const {
    std::map<char32_t, unsigned> map;
    for (size_t i = 0; i < glyphs_.size(); ++i) {
      for (const char32_t c : glyphs_[i].unicodes) {
        const auto [found, is_new] = map.emplace(c, static_cast<unsigned>(i));
        if (!is_new) {
          throw Error("glyph '" + glyphs_[i].name +
                      "': its code point is that "
                      "of '" +
                      glyphs_[found->second].name + "' too");
        }
      }
    }
    return cmap_table(map);
  }

  BigEndian name() const {
    const std::string family = text("familyName", "Untitled");
    const std::string style = text("styleName", "Regular");
    std::string script = text("postscriptFontName", family + "-" + style);
    script.erase(std::remove_if(script.begin(), script.end(),
                                [](char c) {
                                  return c <= ' ' || c > '~' ||
                                         std::string("[](){}<>/%").find(c) !=
                                             std::string::npos;
                                }),
                 script.end());
    std::map<unsigned, std::string> entries = {
        {1, family},
        {2, style},
        {3, script + ";" + text("versionMajor", "1")},
        {4, family + " " + style},
        {5, "Version 1.000" + std::string(tools::kExportMark)},
        {6, script}};
    for (const NameKey& name : kNameKeys) {
      if (!text(name.key, "").empty()) {
        entries[name.id] = text(name.key, "");
      }
    }
    BigEndian records;
    BigEndian strings;
    for (const auto& [id, value] : entries) {
      BigEndian utf16;
      for (const char32_t c : tools::from_utf8(value)) {
        if (c > 0xffff) {
          utf16.words(0xd800 + ((c - 0x10000) >> 10),
                      0xdc00 + ((c - 0x10000) & 0x3ff));
        } else {
          utf16.u16(c);
        }
      }
      records.words(3, 1, 0x409, id, utf16.size(), strings.size());
      strings.append(utf16);
    }
    BigEndian table;
    table.words(0, entries.size(), 6 + records.size());
    table.append(records);
    table.append(strings);
    return table;
  }

  BigEndian post() const {
    BigEndian table;
    table.u32(0x00020000);
    table.u32(static_cast<uint32_t>(info("italicAngle", 0) * 65536));
    table.words(info("postscriptUnderlinePosition", -0.1 * em()),
                info("postscriptUnderlineThickness", 0.05 * em()));
    table.words(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, glyphs_.size());
    BigEndian names;
    for (size_t i = 0; i < glyphs_.size(); ++i) {
      table.u16(static_cast<unsigned>(258 + i));  // after Apple's standard ones
      const std::string short_name = glyphs_[i].name.substr(0, 63);
      names.u8(static_cast<unsigned>(short_name.size()));
      names.text(short_name);
    }
    table.append(names);
    return table;
  }

  void add_kerning() {
    std::vector<std::string> names;
    for (const ExportGlyph& glyph : glyphs_) {
      names.push_back(glyph.name);
    }
    const gen::KerningMatrix kerning = kerning_of(*project_.font, names);
    if (!kerning.empty()) {
      tables_["kern"] = kern_table(kerning);
      tables_["GPOS"] = gpos_table(kerning);
      report_.kerned_pairs = kerned_pairs(kerning);
    }
  }

  const Project& project_;
  TtfReport& report_;
  std::map<std::string, GlyfGlyph> outlines_;
  std::vector<ExportGlyph> glyphs_;
  std::map<std::string, BigEndian> tables_;
};

// "a, b, c, d, e and 3 more"
std::string list_of(const std::vector<std::string>& names) {
  constexpr size_t kMost = 5;
  std::string list;
  for (size_t i = 0; i < std::min(names.size(), kMost); ++i) {
    list += (i == 0 ? "" : ", ") + names[i];
  }
  return names.size() <= kMost
             ? list
             : list + " and " + std::to_string(names.size() - kMost) + " more";
}

}  // namespace

std::string TtfReport::text() const {
  std::string result =
      std::to_string(glyphs) + (glyphs == 1 ? " glyph" : " glyphs");
  if (undrawn != 0) {
    result += ", " + std::to_string(undrawn) + " of them empty";
  }
  if (kerned_pairs != 0) {
    result += ", " + std::to_string(kerned_pairs) + " pairs of kerning";
  }
  std::string missing;
  const auto add = [&missing](const std::string& what) {
    missing += (missing.empty() ? "; left out: " : "; ") + what;
  };
  if (!left_out.empty()) {
    add("glyphs without a code point: " + list_of(left_out));
  }
  if (!open.empty()) {
    add("open contours of " + list_of(open));
  }
  if (has_features) {
    add("features.fea");
  }
  return result + missing;
}

std::vector<uint8_t> write_ttf(const Project& project, TtfReport* report) {
  TtfReport unread;
  return TtfWriter(project, report == nullptr ? unread : *report).write();
}

}  // namespace inkcell::design
