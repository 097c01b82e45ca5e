#include "shaping/shape_check.hpp"

#include <hb-ot.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>

#include "base/error.hpp"
#include "inkcell/font.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/shaping/devanagari.hpp"
#include "inkcell/shaping/shaping.hpp"

namespace inkcell::gen {
namespace {

// Random words of each plan.
constexpr int kWords = 400;
constexpr size_t kLongestWord = 8;

struct Destroy {
  void operator()(hb_buffer_t* x) const { hb_buffer_destroy(x); }
  void operator()(hb_font_t* x) const { hb_font_destroy(x); }
  void operator()(hb_font_funcs_t* x) const { hb_font_funcs_destroy(x); }
};
template <typename T>
using Owner = std::unique_ptr<T, Destroy>;

// Glyph, cluster, advance, x and y of each glyph.
using Shaped = std::vector<std::array<int, 5>>;

std::string to_text(const std::u32string& text) {
  std::string out;
  for (const char32_t c : text) {
    out += to_utf8(c);
  }
  return out;
}

std::string to_text(const Shaped& shaped) {
  std::string out;
  for (const auto& glyph : shaped) {
    out += (out.empty() ? "" : " | ") + std::to_string(glyph[0]) + "=" +
           std::to_string(glyph[1]) + "@" + std::to_string(glyph[3]) + "," +
           std::to_string(glyph[4]) + "+" + std::to_string(glyph[2]);
  }
  return out;
}

hb_bool_t glyph_of_font(hb_font_t* font,
                        void* data,
                        hb_codepoint_t c,
                        hb_codepoint_t* glyph,
                        void*) {
  const auto& source = *static_cast<const ShapeSource*>(data);
  return source.characters.count(c) != 0 &&
         hb_font_get_nominal_glyph(hb_font_get_parent(font), c, glyph);
}

// HarfBuzz on the face with the characters of the font alone.
class Reference {
 public:
  explicit Reference(const ShapeSource& source)
      : source_(source),
        font_(hb_font_create_sub_font(source.file.hb())),
        functions_(hb_font_funcs_create()) {
    hb_font_funcs_set_nominal_glyph_func(functions_.get(), glyph_of_font,
                                         nullptr, nullptr);
    hb_font_set_funcs(font_.get(), functions_.get(),
                      const_cast<ShapeSource*>(&source_), nullptr);
  }

  Shaped shape(const std::u32string& text, const ShapePlan& plan) {
    lookups_.clear();
    const Owner<hb_buffer_t> owner(hb_buffer_create());
    hb_buffer_t* buffer = owner.get();
    const std::vector<uint32_t> codes(text.begin(), text.end());
    hb_buffer_add_utf32(buffer, codes.data(), static_cast<int>(codes.size()), 0,
                        static_cast<int>(codes.size()));
    hb_buffer_set_direction(
        buffer, plan.is_right_to_left ? HB_DIRECTION_RTL : HB_DIRECTION_LTR);
    hb_buffer_set_script(buffer, plan.hb_script);
    hb_buffer_set_flags(buffer, HB_BUFFER_FLAG_DO_NOT_INSERT_DOTTED_CIRCLE);
    if (!plan.language.empty()) {
      hb_buffer_set_language(buffer, hb_ot_tag_to_language(hb_tag_from_string(
                                         plan.language.data(), 4)));
    }
    hb_buffer_set_message_func(buffer, &Reference::listen, this, nullptr);
    std::vector<hb_feature_t> features;
    for (const std::string& tag : plan.features) {
      features.push_back({hb_tag_from_string(tag.data(), 4), 1, 0, UINT_MAX});
    }
    const char* const shapers[] = {"ot", nullptr};
    hb_shape_full(font_.get(), buffer, features.data(),
                  static_cast<unsigned>(features.size()), shapers);
    unsigned count = 0;
    const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer, &count);
    const hb_glyph_position_t* places =
        hb_buffer_get_glyph_positions(buffer, &count);
    Shaped out;
    for (unsigned i = 0; i < count; ++i) {
      const auto found = source_.glyphs.find(infos[i].codepoint);
      out.push_back({found == source_.glyphs.end() ? -1 : found->second,
                     static_cast<int>(infos[i].cluster), places[i].x_advance,
                     places[i].x_offset, places[i].y_offset});
    }
    return out;
  }

  /// Lookups that the last word met, for messages.
  const std::string& lookups() const { return lookups_; }

 private:
  static std::string ids_of(hb_buffer_t* buffer) {
    unsigned count = 0;
    const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer, &count);
    std::string ids;
    for (unsigned i = 0; i < count; ++i) {
      ids += std::to_string(infos[i].codepoint) + " ";
    }
    return ids;
  }

  static hb_bool_t listen(hb_buffer_t* buffer,
                          hb_font_t*,
                          const char* message,
                          void* data) {
    Reference& self = *static_cast<Reference*>(data);
    if (std::strncmp(message, "start lookup", 12) == 0) {
      self.before_ = ids_of(buffer);
      self.started_ = message + 6;
    } else if (std::strncmp(message, "end lookup", 10) == 0 &&
               self.before_ != ids_of(buffer)) {
      self.lookups_ += (self.lookups_.empty() ? "" : ", ") + self.started_;
    }
    return 1;
  }

  const ShapeSource& source_;
  Owner<hb_font_t> font_;
  Owner<hb_font_funcs_t> functions_;
  std::string lookups_;
  std::string before_;
  std::string started_;
};

// The same numbers on every machine.
class Random {
 public:
  size_t below(size_t limit) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<size_t>(state_ >> 33) % limit;
  }

 private:
  uint64_t state_ = 1;
};

// Spaces, and controls and ends of lines, which HarfBuzz draws and devices
// hide.
bool is_hidden(char32_t c) {
  return c <= ' ' || (c >= 0x7f && c < 0xa0) || c == 0x2028 || c == 0x2029 ||
         (c >= 0xfff9 && c <= 0xfffb);
}

// A word of the characters of a plan, the first of which is of its script.
std::u32string random_word(const std::vector<char32_t>& letters,
                           const std::vector<char32_t>& all,
                           Random& random) {
  std::u32string word(1, letters[random.below(letters.size())]);
  for (size_t count = random.below(kLongestWord); count > 0; --count) {
    word += random.below(8) == 0 ? all[random.below(all.size())]
                                 : letters[random.below(letters.size())];
  }
  return word;
}

// What the device is given: a program and its text.
struct Word {
  size_t plan;
  std::u32string text;
};

class Checker {
 public:
  Checker(const ShapeSource& source, const Bytes& rom)
      : source_(source), rom_(rom), reference_(source) {
    open();
  }

  unsigned check(const std::vector<std::u32string>& texts) {
    std::vector<Word> words = words_of(texts);
    for (const Word& word : words) {
      compare(word);
    }
    unsigned steps = 16;
    for (; steps < format::shaping::kMaxSteps; steps *= 2) {
      set_steps(steps);
      if (std::all_of(words.begin(), words.end(), [&](const Word& word) {
            return status_of(word) == Status::ok;
          })) {
        break;
      }
    }
    return steps;
  }

 private:
  void open() {
    const bool is_open =
        Font::open({rom_.data(), rom_.size()}, font_) == Status::ok &&
        Shaping::open(font_, kDevanagari, shaping_) == Status::ok;
    if (!is_open) {
      throw Error("internal error: the device does not open section SHAP");
    }
  }

  void set_steps(unsigned steps) {
    const uint8_t* section = font_.section(format::section::kShaping).data;
    set_u16(
        rom_,
        static_cast<size_t>(section - rom_.data()) + format::shaping::kSteps,
        steps);
  }

  std::vector<Word> words_of(const std::vector<std::u32string>& texts) {
    std::vector<Word> words;
    for (const std::u32string& text : texts) {
      const std::string bytes = to_text(text);
      const Text whole(bytes.data(), bytes.size());
      for (size_t i = 0; i < source_.plans.size(); ++i) {
        if (!text.empty() &&
            shaping_.first_run(whole, 0, whole.size).program == first_plan(i) &&
            shaping_.first_run(whole, 0, whole.size).end == whole.size) {
          words.push_back({i, text});
        }
      }
    }
    Random random;
    for (size_t i = 0; i < source_.plans.size(); ++i) {
      std::vector<char32_t> letters;
      std::vector<char32_t> all;
      for (const auto& [c, glyph] : source_.characters) {
        const hb_script_t script = shaped_script(c);
        const bool is_own = script == source_.plans[i].hb_script;
        const bool is_common = script == HB_SCRIPT_COMMON;
        if (is_own && (!is_common || is_emoji(c) || c == 0x200d)) {
          letters.push_back(c);
          all.push_back(c);
        } else if (!is_own && is_common && !is_hidden(c)) {
          all.push_back(c);
        }
      }
      for (int k = 0; k < kWords && !letters.empty(); ++k) {
        words.push_back({i, random_word(letters, all, random)});
      }
    }
    return words;
  }

  // The default program of the script.
  size_t first_plan(size_t plan) const {
    while (plan > 0 &&
           source_.plans[plan - 1].script == source_.plans[plan].script) {
      --plan;
    }
    return plan;
  }

  Status shape(const Word& word, Span<TextGlyph>& glyphs) {
    const ShapePlan& plan = source_.plans[word.plan];
    const std::string bytes = to_text(word.text);
    const std::string& tag = plan.language;
    shaping_.set_language(
        tag.empty() ? 0 : format::tag(tag[0], tag[1], tag[2], tag[3]));
    ScriptRun run;
    run.end = bytes.size();
    run.program = static_cast<uint8_t>(first_plan(word.plan));
    run.is_right_to_left = plan.is_right_to_left;
    room_.resize(8 * word.text.size() + 64);
    glyphs = {room_.data(), room_.size()};
    return shaping_.shape({bytes.data(), bytes.size()}, run, glyphs);
  }

  Status status_of(const Word& word) {
    Span<TextGlyph> glyphs;
    return shape(word, glyphs);
  }

  void compare(const Word& word) {
    Span<TextGlyph> glyphs;
    const Status status = shape(word, glyphs);
    Shaped own;
    for (const TextGlyph& glyph : glyphs) {
      own.push_back(
          {glyph.glyph, glyph.cluster, glyph.advance, glyph.x, glyph.y});
    }
    const ShapePlan& plan = source_.plans[word.plan];
    const Shaped wanted = reference_.shape(word.text, plan);
    if (status == Status::ok && own == wanted) {
      return;
    }
    std::string codes;
    for (const char32_t c : word.text) {
      codes += (codes.empty() ? "" : " ") + describe(c);
    }
    source_.file.refuse(
        "the device shapes '" + to_text(word.text) + "' (" + codes +
        ") of --shape " + plan.script +
        (plan.language.empty() ? "" : ":" + plan.language) +
        " otherwise than HarfBuzz, whose glyphs are changed by " +
        (reference_.lookups().empty() ? "no lookup" : reference_.lookups()) +
        "; leave the script out, or choose another face. HarfBuzz: " +
        to_text(wanted) + "; the device: " +
        (status == Status::ok
             ? to_text(own)
             : "status " + std::to_string(static_cast<int>(status))));
  }

  const ShapeSource& source_;
  Bytes rom_;
  Reference reference_;
  Font font_;
  Shaping shaping_;
  std::vector<TextGlyph> room_;
};

}  // namespace

unsigned check_shaping(const ShapeSource& source,
                       const Bytes& rom,
                       const std::vector<std::u32string>& texts) {
  return Checker(source, rom).check(texts);
}

}  // namespace inkcell::gen
