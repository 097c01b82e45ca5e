#include "import/font_import.hpp"

#include "source/font_source.hpp"

#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H
#include <hb-ot.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "export/tables.hpp"
#include "model/contours.hpp"
#include "model/error.hpp"
#include "model/glyph_names.hpp"
#include "ufo/ufo.hpp"

namespace inkcell::design {
namespace {

constexpr size_t kLongestName = 128;
constexpr size_t kLongestText = 8192;  // of the table name

// One contour of FreeType, point by point. The first point is that of the file;
// types describe the curve that ends there.
PointContour contour_of(const FT_Outline& outline, int first, int last) {
  PointContour contour;
  const auto tag_of = [&outline](int i) {
    return FT_CURVE_TAG(outline.tags[i]);
  };
  // What arrives at the first point is what leaves the last.
  int controls = 0;
  bool after_cubic = false;
  for (int i = last; i >= first && tag_of(i) != FT_CURVE_TAG_ON; --i) {
    after_cubic = tag_of(i) == FT_CURVE_TAG_CUBIC;
    ++controls;
  }
  for (int i = first; i <= last; ++i) {
    const int tag = tag_of(i);
    GlyphPoint point;
    point.x = static_cast<double>(outline.points[i].x);
    point.y = static_cast<double>(outline.points[i].y);
    if (tag != FT_CURVE_TAG_ON) {
      point.type = PointType::offcurve;
      after_cubic = tag == FT_CURVE_TAG_CUBIC;
      ++controls;
    } else {
      point.type = controls == 0 ? PointType::line
                   : after_cubic ? PointType::curve
                                 : PointType::qcurve;
      controls = 0;
    }
    contour.points.push_back(point);
  }
  return contour;
}

// TrueType does not mark smooth points: marks those whose handles are in line,
// to within a degree.
void mark_smooth(PointContour& contour) {
  constexpr double kLeastCosine = 0.99985;
  std::vector<GlyphPoint>& points = contour.points;
  for (size_t i = 0; i < points.size(); ++i) {
    GlyphPoint& point = points[i];
    const GlyphPoint& a = points[(i + points.size() - 1) % points.size()];
    const GlyphPoint& b = points[(i + 1) % points.size()];
    if (!point.on_curve() || (a.on_curve() && b.on_curve())) {
      continue;
    }
    const double ax = point.x - a.x;
    const double ay = point.y - a.y;
    const double bx = b.x - point.x;
    const double by = b.y - point.y;
    const double product = std::hypot(ax, ay) * std::hypot(bx, by);
    point.smooth = product > 0 && ax * bx + ay * by >= kLeastCosine * product;
  }
}

// Without contours of a single point, which enclose nothing.
std::vector<PointContour> contours_of(const FT_Outline& outline) {
  std::vector<PointContour> contours;
  int first = 0;
  for (int i = 0; i < outline.n_contours; ++i) {
    const int last = outline.contours[i];
    if (last > first) {
      contours.push_back(contour_of(outline, first, last));
      mark_smooth(contours.back());
    }
    first = last + 1;
  }
  return contours;
}

bool are_same(const FT_Outline& outline, const std::vector<FT_Vector>& points) {
  return std::equal(points.begin(), points.end(), outline.points,
                    outline.points + outline.n_points,
                    [](const FT_Vector& a, const FT_Vector& b) {
                      return a.x == b.x && a.y == b.y;
                    });
}

bool boxes_meet(const FT_BBox& a, const FT_BBox& b) {
  return a.xMin <= b.xMax && b.xMin <= a.xMax && a.yMin <= b.yMax &&
         b.yMin <= a.yMax;
}

Matrix matrix_of(const gen::OutlineReference& reference) {
  const auto entry = [&reference](size_t i) {
    return std::ldexp(reference.matrix_q14[i], -14);
  };
  return {entry(0),
          entry(2),
          entry(1),
          entry(3),
          static_cast<double>(reference.dx),
          static_cast<double>(reference.dy)};
}

std::string printable(const std::string& name) {
  const bool ok = !name.empty() && name.size() <= kLongestName &&
                  std::all_of(name.begin(), name.end(),
                              [](char c) { return c > ' ' && c < 127; });
  return ok ? name : "";
}

class FontImporter {
 public:
  FontImporter(const std::filesystem::path& path, gen::Warnings& warnings)
      : file_(path, 0, {}), path_(path), warnings_(warnings) {}

  Project run(gen::CharSet characters, Composites composites) {
    if (characters.empty()) {
      characters = all_characters();
    }
    gen::FontRequest request;
    request.file = path_;
    request.characters = characters;
    request.with_components = composites == Composites::keep;
    source_ = gen::load_font(request, 1, warnings_);
    for (const gen::SourceGlyph& glyph : source_.glyphs) {
      names_.push_back(name_of(glyph));
    }
    for (size_t i = 0; i < source_.glyphs.size(); ++i) {
      add(i);
    }
    FontData font;
    fill_info(font);
    fill_kerning(font);
    font.lib["public.glyphOrder"] = names_;
    project_.font = std::make_shared<const FontData>(std::move(font));
    return std::move(project_);
  }

 private:
  gen::CharSet all_characters() const {
    gen::CharSet characters;
    FT_UInt glyph = 0;
    for (FT_ULong c = FT_Get_First_Char(file_.ft(), &glyph); glyph != 0;
         c = FT_Get_Next_Char(file_.ft(), c, &glyph)) {
      characters.insert(static_cast<char32_t>(c));
    }
    return characters;
  }

  std::string name_of(const gen::SourceGlyph& glyph) {
    std::string name = name_in_file(glyph);
    if (name.empty() && !glyph.code_points.empty()) {
      name = name_of_character(glyph.code_points.front());
    }
    if (name.empty() || !used_.insert(name).second) {
      char buffer[32];
      std::snprintf(buffer, sizeof buffer, "glyph%05u", glyph.source);
      name = buffer;
      used_.insert(name);
    }
    return name;
  }

  std::string name_in_file(const gen::SourceGlyph& glyph) const {
    if (glyph.source == 0) {
      return ".notdef";
    }
    char buffer[256] = "";
    const bool is_there =
        FT_HAS_GLYPH_NAMES(file_.ft()) &&
        FT_Get_Glyph_Name(file_.ft(), glyph.source, buffer, sizeof buffer) == 0;
    return is_there ? printable(buffer) : "";
  }

  const FT_Outline& outline_of(const gen::SourceGlyph& glyph) const {
    if (FT_Load_Glyph(file_.ft(), glyph.source,
                      FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING) != 0) {
      file_.refuse(glyph.name() + " cannot be read");
    }
    return file_.ft()->glyph->outline;
  }

  void add(size_t i) {
    const gen::SourceGlyph& source = source_.glyphs[i];
    Glyph glyph;
    glyph.name = names_[i];
    glyph.unicodes = source.code_points;
    glyph.width = source.advance;
    if (is_made_of_components(i)) {
      for (const gen::OutlineReference& reference : source_.components[i]) {
        glyph.components.push_back(
            {names_[reference.glyph], matrix_of(reference), ""});
      }
    } else {
      glyph.contours = contours_of(outline_of(source));
    }
    project_.front().glyphs[names_[i]] =
        std::make_shared<const Glyph>(std::move(glyph));
  }

  // Whether components give exactly the points of the glyph, and none of them
  // is reflected close to another one, as their contours would cancel.
  bool is_made_of_components(size_t glyph) const {
    if (source_.components.empty() || source_.components[glyph].empty()) {
      return false;
    }
    std::vector<FT_Vector> points;
    std::vector<FT_BBox> boxes;
    bool is_reflected = false;
    bool any_overlap = false;
    for (const gen::OutlineReference& use : source_.components[glyph]) {
      const auto& m = use.matrix_q14;
      FT_Matrix matrix = {m[0] * 4, m[1] * 4, m[2] * 4, m[3] * 4};
      FT_Outline outline = outline_of(source_.glyphs[use.glyph]);
      FT_Outline_Transform(&outline, &matrix);
      FT_Outline_Translate(&outline, use.dx, use.dy);
      FT_BBox box;
      FT_Outline_Get_CBox(&outline, &box);
      any_overlap |= std::any_of(
          boxes.begin(), boxes.end(),
          [&box](const FT_BBox& other) { return boxes_meet(box, other); });
      boxes.push_back(box);
      is_reflected |= matrix_of(use).determinant() < 0;
      points.insert(points.end(), outline.points,
                    outline.points + outline.n_points);
    }
    return !(is_reflected && any_overlap) &&
           are_same(outline_of(source_.glyphs[glyph]), points);
  }

  void fill_info(FontData& font) const {
    const gen::SourceMetrics& m = source_.metrics;
    font.info = {{"unitsPerEm", static_cast<unsigned>(m.units_per_em)},
                 {"ascender", m.ascender},
                 {"descender", m.descender},
                 {"openTypeHheaAscender", m.ascender},
                 {"openTypeHheaDescender", m.descender},
                 {"openTypeHheaLineGap", m.line_gap},
                 {"xHeight", m.x_height},
                 {"capHeight", m.cap_height}};
    const auto put = [&font](const char* key, const char* text) {
      if (text != nullptr && *text != '\0') {
        font.info[key] = text;
      }
    };
    put("familyName", file_.ft()->family_name);
    put("styleName", file_.ft()->style_name);
    for (const NameKey& name : kNameKeys) {
      std::vector<char> text(kLongestText);
      auto size = static_cast<unsigned>(text.size());
      hb_ot_name_get_utf8(file_.hb_face(), name.id,
                          hb_language_from_string("en", -1), &size,
                          text.data());
      put(name.key, text.data());
    }
    fill_tables(font.info);
  }

  // The heights of hhea and OS/2 as they are, and what else these tables say.
  void fill_tables(Value& info) const {
    const auto* hhea = static_cast<const TT_HoriHeader*>(
        FT_Get_Sfnt_Table(file_.ft(), FT_SFNT_HHEA));
    if (hhea != nullptr && (hhea->Ascender != 0 || hhea->Descender != 0)) {
      info["openTypeHheaAscender"] = hhea->Ascender;
      info["openTypeHheaDescender"] = hhea->Descender;
      info["openTypeHheaLineGap"] = hhea->Line_Gap;
    }
    const auto* post = static_cast<const TT_Postscript*>(
        FT_Get_Sfnt_Table(file_.ft(), FT_SFNT_POST));
    if (post != nullptr) {
      info["italicAngle"] = static_cast<double>(post->italicAngle) / 65536;
      info["postscriptUnderlinePosition"] = post->underlinePosition;
      info["postscriptUnderlineThickness"] = post->underlineThickness;
    }
    const auto* os2 =
        static_cast<const TT_OS2*>(FT_Get_Sfnt_Table(file_.ft(), FT_SFNT_OS2));
    if (os2 == nullptr || os2->version == 0xffff) {
      return;
    }
    info["openTypeOS2TypoAscender"] = os2->sTypoAscender;
    info["openTypeOS2TypoDescender"] = os2->sTypoDescender;
    info["openTypeOS2TypoLineGap"] = os2->sTypoLineGap;
    info["openTypeOS2WinAscent"] = os2->usWinAscent;
    info["openTypeOS2WinDescent"] = os2->usWinDescent;
    info["openTypeOS2WeightClass"] = os2->usWeightClass;
    if (os2->usWidthClass >= 1 && os2->usWidthClass <= 9) {
      info["openTypeOS2WidthClass"] = os2->usWidthClass;
    }
    info["openTypeOS2Panose"] = os2->panose;
    const std::string vendor = printable(
        std::string(reinterpret_cast<const char*>(os2->achVendID), 4));
    if (!vendor.empty()) {
      info["openTypeOS2VendorID"] = vendor;
    }
    constexpr unsigned kItalic = 1, kBold = 0x20, kRegular = 0x40;
    const unsigned selection = os2->fsSelection;
    info["styleMapStyleName"] =
        (selection & kBold) != 0
            ? ((selection & kItalic) != 0 ? "bold italic" : "bold")
            : ((selection & kItalic) != 0 ? "italic" : "regular");
    const auto bits = [](unsigned value) {
      Value list = Value::array();
      for (unsigned bit = 0; bit < 16; ++bit) {
        if ((value >> bit & 1) != 0) {
          list.push_back(bit);
        }
      }
      return list;
    };
    info["openTypeOS2Selection"] =
        bits(selection & ~(kItalic | kBold | kRegular));
    info["openTypeOS2Type"] = bits(os2->fsType);
  }

  // Classes become groups; a class of one glyph needs none.
  void fill_kerning(FontData& font) const {
    const gen::KerningMatrix& matrix = source_.kerning;
    if (matrix.empty()) {
      return;
    }
    const auto groups = [&](const std::vector<uint16_t>& classes, int count,
                            const char* prefix) {
      std::vector<std::string> names(static_cast<size_t>(count));
      std::vector<Value> members(names.size(), Value::array());
      for (size_t i = 0; i < classes.size(); ++i) {
        if (classes[i] != 0) {
          members[classes[i] - 1u].push_back(names_[i]);
        }
      }
      for (size_t k = 0; k < names.size(); ++k) {
        names[k] = members[k].size() == 1
                       ? members[k][0].get<std::string>()
                       : prefix + members[k][0].get<std::string>();
        if (members[k].size() > 1) {
          font.groups[names[k]] = members[k];
        }
      }
      return names;
    };
    const std::vector<std::string> left =
        groups(matrix.left_class, matrix.left_classes, "public.kern1.");
    const std::vector<std::string> right =
        groups(matrix.right_class, matrix.right_classes, "public.kern2.");
    for (size_t l = 0; l < left.size(); ++l) {
      for (size_t r = 0; r < right.size(); ++r) {
        const int value = matrix.values[l * right.size() + r];
        if (value != 0) {
          font.kerning[left[l]][right[r]] = value;
        }
      }
    }
  }

  gen::FontFile file_;
  std::filesystem::path path_;
  gen::Warnings& warnings_;
  gen::SourceFont source_;
  Project project_;
  std::vector<std::string> names_;
  std::set<std::string> used_;
};

// Without the spaces at its end.
std::string name_of(hb_tag_t tag) {
  char name[5] = {};
  hb_tag_to_string(tag, name);
  return std::string(name, std::find(name, name + 4, ' '));
}

// What GSUB or GPOS has, for messages.
std::string layout_of(hb_face_t* face, hb_tag_t table) {
  const auto names = [&](const auto& query) {
    constexpr unsigned kMost = 512;
    hb_tag_t tags[kMost];
    unsigned count = kMost;
    query(face, table, 0, &count, tags);
    std::set<std::string> sorted;  // a feature is there for each language
    std::transform(tags, tags + count, std::inserter(sorted, sorted.end()),
                   name_of);
    std::string text;
    for (const std::string& name : sorted) {
      text += " " + name;
    }
    return text;
  };
  return " (scripts" + names(hb_ot_layout_table_get_script_tags) +
         "; features" + names(hb_ot_layout_table_get_feature_tags) +
         "; lookups: " +
         std::to_string(hb_ot_layout_table_get_lookup_count(face, table)) + ")";
}

std::string tables_left_out(const std::filesystem::path& path) {
  static const std::set<std::string> known = {
      "head", "hhea", "maxp", "OS/2", "hmtx", "cmap", "loca",
      "glyf", "CFF",  "CFF2", "name", "post", "kern"};
  const gen::FontFile file(path, 0, {});
  std::string names;
  FT_ULong tag = 0;
  FT_ULong length = 0;
  for (FT_UInt i = 0; FT_Sfnt_Table_Info(file.ft(), i, &tag, &length) == 0;
       ++i) {
    const std::string name = name_of(static_cast<hb_tag_t>(tag));
    if (known.count(name) == 0) {
      names += "\n  " + name + (name == "GPOS" ? " except kerning" : "");
      if (name == "GSUB" || name == "GPOS") {
        names += layout_of(file.hb_face(), static_cast<hb_tag_t>(tag));
      }
    }
  }
  return names;
}

}  // namespace

Project import_font(const std::filesystem::path& file,
                    const gen::CharSet& characters,
                    gen::Warnings& warnings,
                    Composites composites) {
  return FontImporter(file, warnings).run(characters, composites);
}

std::string import_project(const std::filesystem::path& file,
                           const std::filesystem::path& folder,
                           const std::vector<std::string>& chars,
                           gen::Warnings& warnings,
                           Composites composites) {
  if (std::filesystem::exists(folder)) {
    throw Error(folder.string() +
                ": exists; open it, or name another project for " +
                file.string());
  }
  gen::CharSet characters;
  for (const std::string& list : chars) {
    gen::add_ranges(list, characters);
  }
  const Project project = import_font(file, characters, warnings, composites);
  UfoFiles files;
  write_ufo(project, folder, files);
  const std::string name = file.filename().string();
  const std::string left_out = tables_left_out(file);
  return "Imported " + std::to_string(project.front().glyphs.size()) +
         " glyphs of " + name +
         (left_out.empty() ? ""
                           : "\ntables of " + name + " that are left out:") +
         left_out;
}

}  // namespace inkcell::design
