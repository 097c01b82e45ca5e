#include "stage.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "canvas.hpp"
#include "look.hpp"
#include "rom_file.hpp"

namespace inkcell::tools {
namespace {

constexpr uint32_t kBlack = 0x000000;
constexpr uint32_t kWhite = 0xffffff;
constexpr int kMargin = 2;  // on the left and the right of wrapped text [px]

LookOptions look_of(const Settings& settings) {
  LookOptions look;
  suit_display(settings.display, look);
  // A filter has no effect with two levels.
  look.filter = look.levels == 2 ? "" : settings.filter;
  look.hint = settings.hint;
  look.weight = settings.weight;
  check_hint(look, is_turned(settings.angle), "the angle");
  return look;
}

class TextStage : public Stage {
 public:
  TextStage(const Settings& settings, const Font& font)
      : font_(font),
        display_(settings.display),
        is_dark_(settings.is_dark),
        look_(look_of(settings), font, settings.px, settings.angle, Use::text) {
    Wrapping wrapping;
    wrapping.width = Q26_6::from_int(settings.width - 2 * kMargin);
    wrapping.align = Align::centre;
    lines_ = lay_out_lines(font, settings.text, Kerning::font, look_.style(),
                           wrapping);
    const InkBox ink = ink_box(font, lines_, look_.style());
    const auto centred = [](int side, double low, double high) {
      return std::round((side - low - high) / 2);
    };
    origin_ =
        make_point(centred(settings.width, ink.x0, ink.x1) + settings.shift_x,
                   centred(settings.height, ink.y0, ink.y1) + settings.shift_y);
    origins_ = line_origins(font, lines_, look_.style(), origin_);
  }

  void set_frame(uint32_t) override {}

  void draw(const Strip& strip, DrawStats& stats) override {
    DisplayPaper whole(display_, strip);
    whole.paper().fill(is_dark_ ? kBlack : kWhite);
    DisplayPaper counted(display_, strip, &stats);
    draw_lines(font_, lines_, origins_, look_.style(),
               counted.paper().with(is_dark_ ? kWhite : kBlack));
  }

  size_t state_bytes() const override { return sizeof(Style); }
  const Point* origin() const override { return &origin_; }
  Overlay overlay() const override {
    return make_overlay(font_, lines_, origins_, look_.style());
  }

 private:
  const Font& font_;
  Display display_;
  bool is_dark_;
  Look look_;
  std::vector<Line> lines_;
  Point origin_;
  std::vector<Point> origins_;
};

class PlayerStage : public Stage {
 public:
  PlayerStage(const Settings& settings, const SceneKind& kind, const Font& font)
      : display_(settings.display),
        text_(settings.text),
        player_(
            open_scene(kind, font, text_, settings.width, settings.height)) {}

  void set_frame(uint32_t frame) override { player_->set_frame(frame); }
  void draw(const Strip& strip, DrawStats& stats) override {
    DisplayPaper paper(display_, strip, &stats);
    player_->draw(paper.paper());
  }
  size_t state_bytes() const override { return player_->state_bytes(); }

 private:
  Display display_;
  std::string text_;
  std::unique_ptr<Player> player_;
};

class DemoStage : public Stage {
 public:
  explicit DemoStage(const BoardDisplay& board) : board_(board) {
    const Status status = board.open();
    if (status != Status::ok) {
      throw std::runtime_error(std::string(board.name) + ": the demo's font: " +
                               std::string(status_name(status)));
    }
  }

  void set_frame(uint32_t frame) override { board_.set_frame(frame); }
  void draw(const Strip& strip, DrawStats&) override { board_.draw(strip); }
  size_t state_bytes() const override { return board_.state_bytes; }

 private:
  const BoardDisplay& board_;
};

}  // namespace

std::unique_ptr<Stage> make_text_stage(const Settings& settings,
                                       const Font& font) {
  return std::make_unique<TextStage>(settings, font);
}

std::unique_ptr<Stage> make_player_stage(const Settings& settings,
                                         const SceneKind& kind,
                                         const Font& font) {
  return std::make_unique<PlayerStage>(settings, kind, font);
}

std::unique_ptr<Stage> make_demo_stage(const BoardDisplay& board) {
  return std::make_unique<DemoStage>(board);
}

}  // namespace inkcell::tools
