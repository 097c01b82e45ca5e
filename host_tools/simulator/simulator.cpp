#include "simulator.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace inkcell::tools {
namespace {

constexpr const char* kDigits = "0123456789:";

// Whether a font was made for all characters of a text; a face may lack some.
bool was_asked(const Font& font,
               const std::string& asked,
               const std::string& text) {
  const std::vector<char32_t> known = from_utf8(asked);
  const std::vector<char32_t> wanted = from_utf8(text);
  return std::all_of(wanted.begin(), wanted.end(), [&](char32_t c) {
    uint16_t glyph = 0;
    return font.glyph_of(c, glyph) == Status::ok ||
           std::find(known.begin(), known.end(), c) != known.end();
  });
}

// Whether both use the same stage.
bool plays_same(Settings a, const Settings& b) {
  a.frame = b.frame;
  a.rows = b.rows;
  return draws_same(a, b);
}

}  // namespace

// Null if it is not ready.
const Font* Simulator::font_for(const FontWish& wish) {
  const auto known = fonts_.find(wish.coding);
  FontWish wanted = wish;
  if (known != fonts_.end()) {
    const Made& made = known->second;
    if (wanted.morphs.empty()) {
      wanted.morphs = made.wish.morphs;
    }
    if (wanted.morphs == made.wish.morphs &&
        was_asked(made.rom.font(), made.wish.text, wish.text)) {
      return &made.rom.font();
    }
    wanted.text = made.wish.text + wish.text;
  }
  std::optional<RomFile> rom = make_font_(wanted);
  if (!rom) {
    return nullptr;
  }
  return &fonts_.insert_or_assign(wish.coding, Made{std::move(*rom), wanted})
              .first->second.rom.font();
}

// False if its font is not ready.
bool Simulator::open_stage() {
  font_ = nullptr;
  if (settings.scene == kDemoScene) {
    stage_ = make_demo_stage(find_board(settings.board));
    return true;
  }
  if (settings.scene == kTextScene) {
    font_ = font_for({settings.coding, settings.text, {}});
    if (font_ != nullptr) {
      stage_ = make_text_stage(settings, *font_);
    }
    return font_ != nullptr;
  }
  const std::vector<SceneKind>& kinds = scene_kinds();
  const SceneKind& kind = *std::find_if(
      kinds.begin(), kinds.end(),
      [&](const SceneKind& scene) { return scene.name == settings.scene; });
  if (settings.board.empty()) {
    font_ = font_for(
        {"outline", settings.text + kDigits, std::string(kind.morphs)});
    if (font_ == nullptr) {
      return false;
    }
  } else if (!board_font_) {
    Font font;
    if (Font::open(board_motion_font(), font) != Status::ok) {
      throw std::runtime_error("the boards' font cannot be opened");
    }
    board_font_ = font;
  }
  stage_ = make_player_stage(settings, kind,
                             font_ == nullptr ? *board_font_ : *font_);
  return true;
}

void Simulator::draw() {
  const bool is_same =
      is_tried_ && stage_ != nullptr && plays_same(tried_, settings);
  tried_ = settings;
  is_tried_ = true;
  if (!is_same) {
    stage_.reset();
    is_tried_ = open_stage();
    if (!is_tried_) {
      return;
    }
  }
  DisplayMemory memory(settings.display, settings.width, settings.height);
  DrawStats stats;
  stage_->set_frame(settings.frame);
  const int rows = memory.whole_rows(settings.rows);
  const auto begin = std::chrono::steady_clock::now();
  memory.show(rows, [&](const Strip& strip) {
    ++stats.strips;
    stage_->draw(strip, stats);
  });
  const std::chrono::duration<double> time =
      std::chrono::steady_clock::now() - begin;
  const auto frame = std::make_shared<Frame>(memory);
  frame->overlay = stage_->overlay();
  frame->stats = stats;
  frame->milliseconds = 1000 * time.count();
  frame->strip_bytes = memory.strip_bytes(rows);
  frame->state_bytes = stage_->state_bytes();
  frame->font_bytes = font_ == nullptr ? 0 : font_->rom().size;
  if (stage_->origin() != nullptr) {
    frame->origin = *stage_->origin();
  }
  frame_ = frame;
}

void Simulator::update() {
  if (!is_tried_ || !draws_same(tried_, settings)) {
    problem_.clear();
    try {
      draw();
    } catch (const std::exception& error) {
      problem_ = error.what();
    }
  }
  if (!problem_.empty()) {
    throw std::runtime_error(problem_);
  }
}

}  // namespace inkcell::tools
