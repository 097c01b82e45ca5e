// What TrueTypeFont draws of a file, against FreeType's outlines at 8x8
// samples a pixel.
//
//   against_freetype FILE.ttf [overlaps]
//
// Look-up, advances and boxes of U+0021..017F must be FreeType's, and kerning
// with ASCII must be HarfBuzz's. No pixel of ASCII at 12 to 96 px may be off by
// more than 8/255, and the mean by 1/255. Of a file whose contours overlap no
// more pixels may be off by 16 than FreeType has without oversampling.
#include <string.h>

#include <fstream>
#include <iterator>

#include <hb.h>

#include "glyph_pictures.hpp"

namespace {

using namespace inkcell;
using namespace glyph_pictures;

// HarfBuzz with `kern` alone, in Latin text.
class Shaper {
 public:
  explicit Shaper(const char* name) {
    hb_blob_t* const blob = hb_blob_create_from_file(name);
    hb_face_t* const face = hb_face_create(blob, 0);
    font_ = hb_font_create(face);
    hb_face_destroy(face);
    hb_blob_destroy(blob);
    buffer_ = hb_buffer_create();
    plan();
  }
  ~Shaper() {
    hb_buffer_destroy(buffer_);
    hb_font_destroy(font_);
    hb_shape_plan_destroy(plan_);
  }
  Shaper(const Shaper&) = delete;
  Shaper& operator=(const Shaper&) = delete;

  int32_t kerning(uint32_t left, uint32_t right, int32_t advance) const {
    hb_buffer_clear_contents(buffer_);
    hb_buffer_set_content_type(buffer_, HB_BUFFER_CONTENT_TYPE_UNICODE);
    hb_buffer_add(buffer_, kPrivate + left, 0);
    hb_buffer_add(buffer_, kPrivate + right, 1);
    set_direction();
    hb_shape_plan_execute(plan_, font_, buffer_, kFeatures, kCount);
    unsigned int count = 0;
    const hb_glyph_position_t* const places =
        hb_buffer_get_glyph_positions(buffer_, &count);
    require(count == 2, "two glyphs");
    return places[0].x_advance - advance;
  }

 private:
  // Code points of glyphs, by the functions of plan().
  static constexpr uint32_t kPrivate = 0xf0000;
  static constexpr unsigned int kCount = 7;
  static const hb_feature_t kFeatures[kCount];

  void set_direction() const {
    hb_buffer_set_direction(buffer_, HB_DIRECTION_LTR);
    hb_buffer_set_script(buffer_, HB_SCRIPT_LATIN);
    hb_buffer_set_language(buffer_, hb_language_from_string("en", -1));
  }
  void plan() {
    hb_font_funcs_t* const own = hb_font_funcs_create();
    hb_font_funcs_set_nominal_glyph_func(
        own,
        [](hb_font_t*, void*, hb_codepoint_t code, hb_codepoint_t* glyph,
           void*) -> hb_bool_t {
          *glyph = code - kPrivate;
          return 1;
        },
        nullptr, nullptr);
    hb_font_t* const sub = hb_font_create_sub_font(font_);
    hb_font_set_funcs(sub, own, nullptr, nullptr);
    hb_font_funcs_destroy(own);
    hb_font_destroy(font_);
    font_ = sub;
    set_direction();
    hb_segment_properties_t properties;
    hb_buffer_get_segment_properties(buffer_, &properties);
    plan_ = hb_shape_plan_create(hb_font_get_face(font_), &properties,
                                 kFeatures, kCount, nullptr);
  }

  hb_font_t* font_;
  hb_buffer_t* buffer_;
  hb_shape_plan_t* plan_;
};

hb_feature_t off(const char* tag) {
  return {hb_tag_from_string(tag, -1), 0, 0, ~0u};
}
const hb_feature_t Shaper::kFeatures[kCount] = {
    off("liga"), off("clig"), off("calt"), off("ccmp"),
    off("locl"), off("rlig"), off("rclt")};

void compare_numbers(const Font& font, FT_Face face, const char* name) {
  const Shaper shaper(name);
  int32_t kerned = 0;
  int32_t unlike = 0;
  for (uint32_t code = 0x21; code < 0x180; ++code) {
    uint16_t glyph = 0;
    static_cast<void>(font.glyph_of(code, glyph) == Status::ok);
    require(glyph == FT_Get_Char_Index(face, code), "the same glyph");
    require(FT_Load_Glyph(face, glyph, FT_LOAD_NO_SCALE) == 0, "it loads");
    const FT_Glyph_Metrics& truth = face->glyph->metrics;
    GlyphMetrics own;
    require(font.glyph_metrics(glyph, own) == Status::ok, "it has metrics");
    require(
        own.advance == truth.horiAdvance && own.advance == font.advance(glyph),
        "the same advance");
    require(own.x_min == truth.horiBearingX &&
                own.y_max == truth.horiBearingY &&
                own.x_max - own.x_min == truth.width &&
                own.y_max - own.y_min == truth.height,
            "the same box");
    for (uint32_t right = 0x21; right < 0x7f; ++right) {
      const uint16_t to = font.glyph_or_notdef(right);
      const int32_t pair = shaper.kerning(glyph, to, own.advance);
      kerned += pair != 0 ? 1 : 0;
      unlike += font.kerning(glyph, to) == pair ? 0 : 1;
    }
  }
  printf("%d pairs kern by HarfBuzz, %d of all unlike\n", kerned, unlike);
  require(unlike == 0, "the same kerning");
}

}  // namespace

int main(int argc, char** argv) {
  const bool has_overlaps = argc > 2 && strcmp(argv[2], "overlaps") == 0;
  std::ifstream in(argv[1], std::ios::binary);
  const std::vector<char> file{std::istreambuf_iterator<char>(in), {}};
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  require(FT_Init_FreeType(&library) == 0 &&
              FT_New_Face(library, argv[1], 0, &face) == 0,
          "FreeType opens the file");
  TrueTypeFont opened;
  require(opened.open({reinterpret_cast<const uint8_t*>(file.data()),
                       file.size()}) == Status::ok,
          "the file opens");
  const Font& font = opened.font();
  compare_numbers(font, face, argv[1]);
  alignas(8) static uint8_t ram[2560];
  bool is_good = true;
  for (const int32_t px : {12, 24, 48, 96}) {
    Error own;
    Error freetype;
    for (uint32_t code = 0x21; code < 0x7f; ++code) {
      const uint16_t glyph = font.glyph_or_notdef(code);
      const Picture truth = freetype_picture(face, glyph, px, kSamples);
      const Picture drawn = own_picture(font, glyph, px, ram);
      require(drawn == own_picture(font, glyph, px, {}),
              "the same picture without RAM");
      own.add(truth, drawn);
      freetype.add(truth, freetype_picture(face, glyph, px, 1));
    }
    printf(
        "%2d px: worst %5.1f, mean %.2f, %4lld px off by more than %d; "
        "FreeType %5.1f, %.2f, %lld\n",
        px, own.worst, own.mean(), static_cast<long long>(own.off), kOff,
        freetype.worst, freetype.mean(), static_cast<long long>(freetype.off));
    is_good &= has_overlaps ? own.off <= freetype.off
                            : (own.worst <= 8 && own.mean() <= 1);
  }
  FT_Done_FreeType(library);
  require(is_good, "errors are in their limits");
  return 0;
}
