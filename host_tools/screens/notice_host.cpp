// Notices whose words HarfBuzz shapes, rendered by this machine as a display
// would show them:
//
//     notice_host NOTICES.txt OUT.ppm
#include <hb-ot.h>

#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "notice.hpp"
#include "screen_memory.hpp"
#include "source/faces.hpp"

namespace {

using namespace inkcell;

struct Destroy {
  void operator()(hb_buffer_t* x) const { hb_buffer_destroy(x); }
  void operator()(hb_font_t* x) const { hb_font_destroy(x); }
  void operator()(hb_font_funcs_t* x) const { hb_font_funcs_destroy(x); }
};
template <typename T>
using Owner = std::unique_ptr<T, Destroy>;

// A face of HarfBuzz with the characters of a font alone.
class HarfBuzzFace {
 public:
  HarfBuzzFace(const Font& font,
               const std::string& path,
               const std::string& script,
               const std::string& chars)
      : font_(font),
        file_(path, 0, {}, {}),
        script_(gen::script_of(gen::parse_shape_scripts(script).at(0))),
        hb_(hb_font_create_sub_font(file_.hb())),
        functions_(hb_font_funcs_create()) {
    gen::FontRequest request;
    gen::Warnings warnings;
    request.file = path;
    gen::add_ranges(chars, request.characters);
    request.with_components = true;
    request.shapes = gen::parse_shape_scripts(script);
    const gen::SourceFont source = load_faces(request, {}, {}, 1, warnings);
    for (size_t i = 0; i < source.glyphs.size() && source.is_shown(i); ++i) {
      const auto id = static_cast<uint16_t>(i);
      for (const char32_t c : source.glyphs[i].code_points) {
        uint16_t own = 0;
        if (font.glyph_of(c, own) != Status::ok || own != id) {
          throw std::runtime_error(path + ": not that of the font");
        }
      }
      glyphs_.emplace(source.glyphs[i].source, id);
    }
    hb_font_funcs_set_nominal_glyph_func(functions_.get(), glyph_of, nullptr,
                                         nullptr);
    hb_font_set_funcs(hb_.get(), functions_.get(), this, nullptr);
  }
  HarfBuzzFace(const HarfBuzzFace&) = delete;

  const Font& font() const { return font_; }
  bool joins() const { return script_ == HB_SCRIPT_ARABIC; }

  std::vector<TextGlyph> shape(const Text& text,
                               uint32_t begin,
                               uint32_t end,
                               bool is_right_to_left) const {
    const Owner<hb_buffer_t> owner(hb_buffer_create());
    hb_buffer_t* const buffer = owner.get();
    hb_buffer_add_utf8(buffer, text.data, static_cast<int>(text.size), begin,
                       static_cast<int>(end - begin));
    hb_buffer_set_direction(
        buffer, is_right_to_left ? HB_DIRECTION_RTL : HB_DIRECTION_LTR);
    hb_buffer_set_script(buffer, script_);
    hb_shape(hb_.get(), buffer, nullptr, 0);
    unsigned count = 0;
    const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer, &count);
    const hb_glyph_position_t* at =
        hb_buffer_get_glyph_positions(buffer, &count);
    std::vector<TextGlyph> out(count);
    for (unsigned i = 0; i < count; ++i) {
      out[i].glyph = glyphs_.at(infos[i].codepoint);
      out[i].cluster = static_cast<uint16_t>(infos[i].cluster - begin);
      out[i].advance = static_cast<int16_t>(at[i].x_advance);
      out[i].x = static_cast<int16_t>(at[i].x_offset);
      out[i].y = static_cast<int16_t>(at[i].y_offset);
    }
    return out;
  }

 private:
  static hb_bool_t glyph_of(hb_font_t* hb,
                            void* face,
                            hb_codepoint_t code_point,
                            hb_codepoint_t* glyph,
                            void*) {
    uint16_t own = 0;
    return static_cast<HarfBuzzFace*>(face)->font_.glyph_of(code_point, own) ==
               Status::ok &&
           hb_font_get_nominal_glyph(hb_font_get_parent(hb), code_point, glyph);
  }

  const Font& font_;
  gen::FontFile file_;
  hb_script_t script_;
  Owner<hb_font_t> hb_;
  Owner<hb_font_funcs_t> functions_;
  std::map<uint32_t, uint16_t> glyphs_;  // of the font, by those of the file
};

// HarfBuzz in place of the device's shaper; sentences are shaped whole.
class HarfBuzzShaper : public WordShaper {
 public:
  HarfBuzzShaper() : WordShaper(open_face, shape_part, 1000) {
    std::istringstream list(INKCELL_NOTICE_LIST);
    std::string id;
    std::string path;
    std::string script;
    std::string chars;
    for (const Font& font : demo::notice_fonts()) {
      list >> id >> path >> script >> chars;
      faces_.push_back(std::make_unique<HarfBuzzFace>(
          font, INKCELL_NOTICE_FOLDER "/" + path, script, chars));
    }
  }

 private:
  static bool open_face(WordShaper& shaper, const Font& font) noexcept {
    auto& own = static_cast<HarfBuzzShaper&>(shaper);
    for (const auto& face : own.faces_) {
      own.face_ = &face->font() == &font ? face.get() : own.face_;
    }
    return true;
  }
  static uint32_t shape_part(WordShaper& shaper,
                             const Text& text,
                             uint32_t begin,
                             uint32_t end,
                             bool is_right_to_left) noexcept {
    auto& own = static_cast<HarfBuzzShaper&>(shaper);
    own.room_ = own.face_->shape(text, begin, end, is_right_to_left);
    own.glyphs = {own.room_.data(), own.room_.size()};
    own.joins = own.face_->joins();
    return end;
  }

  std::vector<std::unique_ptr<HarfBuzzFace>> faces_;
  const HarfBuzzFace* face_ = nullptr;
  std::vector<TextGlyph> room_;
};

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() != 2) {
    std::cerr << "usage: notice_host NOTICES.txt OUT.ppm\n";
    return 64;
  }
  std::ifstream file(arguments[0], std::ios::binary);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    lines.push_back(line);
  }
  std::vector<demo::Notice> notices;
  for (const std::string& line : lines) {
    notices.emplace_back(line.data(), line.size());
  }
  if (notices.size() > demo::kMostNotices ||
      demo::open_notices() != Status::ok) {
    std::cerr << arguments[0] << ": too many notices, or damaged fonts\n";
    return 1;
  }
  HarfBuzzShaper shaper;
  demo::show_notices({notices.data(), notices.size()}, shaper);
  return write_ppm(arguments[1]) ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
