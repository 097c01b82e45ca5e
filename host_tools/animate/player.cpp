#include "player.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <type_traits>

#include "body_scene.hpp"
#include "charge_scene.hpp"
#include "clock_scene.hpp"
#include "count_scene.hpp"
#include "icon_scene.hpp"
#include "inkcell/simulation/body_draw.hpp"
#include "letters_scene.hpp"
#include "melt_scene.hpp"
#include "offset_scene.hpp"
#include "particle_scene.hpp"
#include "path_scene.hpp"
#include "print_scene.hpp"
#include "pulse_scene.hpp"
#include "rom_file.hpp"
#include "ticker_scene.hpp"
#include "typewriter_scene.hpp"
#include "vortex_scene.hpp"
#include "wipe_scene.hpp"

namespace inkcell::tools {
namespace {

using simulation::PrintStyle;

constexpr size_t kWorkspaceBytes = 4096;

// The coverage of a body for each pixel of its box. Through a filter of +-4 px
// it is the distance inside, 32 for each px and 128 at the edge.
struct DrawnBody {
  Rect box;
  std::vector<uint8_t> coverage;

  DrawnBody(Span<const simulation::Body> bodies,
            size_t index,
            const simulation::BodyRules& rules,
            const Filter& filter)
      : box(intersect(simulation::box_of(bodies[index]), rules.walls)) {
    if (bodies[index].shape == nullptr || is_empty(box)) {
      box = {};
      return;
    }
    coverage.resize(static_cast<size_t>(box.x1 - box.x0) *
                    static_cast<size_t>(box.y1 - box.y0));
    Sink sink;
    sink.window = box;
    sink.context = this;
    sink.coverage = [](void* context, int32_t x, int32_t y,
                       const uint8_t* values, int32_t count) {
      std::copy_n(values, count, static_cast<DrawnBody*>(context)->at(x, y));
    };
    sink.solid = [](void* context, int32_t x, int32_t y, int32_t count) {
      std::fill_n(static_cast<DrawnBody*>(context)->at(x, y), count,
                  uint8_t{255});
    };
    simulation::draw_body(bodies, index, rules, filter, sink);
  }
  uint8_t* at(int x, int y) {
    return &coverage[static_cast<size_t>(y - box.y0) *
                         static_cast<size_t>(box.x1 - box.x0) +
                     static_cast<size_t>(x - box.x0)];
  }
};

// The deepest overlap of two bodies: as drawn, or else beyond what rules allow.
// Where two edges overlap by d, the middle is d / 2 inside of both.
double penetration_of(Span<const simulation::Body> bodies,
                      const simulation::BodyRules& rules,
                      bool is_drawn) {
  std::vector<DrawnBody> drawn;
  for (size_t i = 0; i < bodies.size; ++i) {
    drawn.emplace_back(bodies, i, rules, motion::kFilterDistance);
  }
  double most = 0;
  for (size_t i = 0; i < drawn.size(); ++i) {
    for (size_t k = 0; k < i; ++k) {
      const Rect box = intersect(drawn[i].box, drawn[k].box);
      int deepest = 128;
      for (int y = box.y0; y < box.y1; ++y) {
        for (int x = box.x0; x < box.x1; ++x) {
          deepest = std::max<int>(
              deepest, std::min(*drawn[i].at(x, y), *drawn[k].at(x, y)));
        }
      }
      if (deepest > 128) {
        const int32_t allowed = std::min({int32_t{rules.overlap.raw},
                                          bodies[i].shape->depth_q10() / 3,
                                          bodies[k].shape->depth_q10() / 3});
        most = std::max(most, 2 * (deepest - 128) / 32.0 -
                                  (is_drawn ? 0 : allowed / 1024.0));
      }
    }
  }
  return most;
}

double ink_of(Span<const simulation::Body> bodies,
              size_t index,
              const simulation::BodyRules& rules) {
  const DrawnBody drawn(bodies, index, rules, kFilterMotion);
  return std::accumulate(drawn.coverage.begin(), drawn.coverage.end(), 0.0);
}

BodyFigures figures_of(Span<const simulation::Body> bodies,
                       const simulation::BodyRules& rules) {
  // The same bodies, without neighbours, walls and squash.
  std::vector<simulation::Body> rigid(bodies.begin(), bodies.end());
  for (simulation::Body& body : rigid) {
    body.squash = {};
    for (simulation::BodyTouch& touch : body.touches) {
      touch = {};
    }
  }
  const Span<const simulation::Body> undeformed = {rigid.data(), rigid.size()};
  simulation::BodyRules open = rules;
  open.walls = {-8191, -8191, 8191, 8191};
  BodyFigures figures;
  figures.drawn = penetration_of(bodies, rules, true);
  figures.rigid = penetration_of(undeformed, rules, false);
  double ink = 0;
  double whole = 0;
  for (size_t i = 0; i < bodies.size; ++i) {
    const double now = ink_of(bodies, i, rules);
    const double alone = ink_of(undeformed, i, open);
    ink += now;
    whole += alone;
    if (alone > 0) {
      figures.least_body_ink = std::min(figures.least_body_ink, now / alone);
      figures.greatest_body_ink =
          std::max(figures.greatest_body_ink, now / alone);
    }
    const simulation::Body& body = bodies[i];
    figures.squash = std::max(figures.squash, body.squash.raw / 16384.0);
    bool is_off = body.still_steps > 0;
    for (const simulation::BodyTouch& touch : body.touches) {
      is_off = is_off && touch.with != simulation::BodyTouch::kWalls + 3;
    }
    figures.off_floor += is_off ? 1 : 0;
  }
  if (whole > 0) {
    figures.least_ink = figures.greatest_ink = ink / whole;
  }
  return figures;
}

template <typename Scene>
class ScenePlayer : public Player {
 public:
  ScenePlayer(const Font& font,
              std::string_view text,
              int width,
              int height,
              std::optional<PrintStyle> print)
      : grid_(needs_of(font, text, width, height).grid),
        particles_(Scene::needs(width, height).particles),
        homes_(Scene::needs(width, height).homes),
        scene_({&font,
                {text.data(), text.size()},
                width,
                height,
                {{grid_.data(), grid_.size()},
                 {particles_.data(), particles_.size()},
                 {homes_.data(), homes_.size()}},
                {workspace_.data(), workspace_.size()}}) {
    if constexpr (std::is_same_v<Scene, scenes::VortexScene>) {
      if (print) {
        scene_.print_as(*print);
      }
    }
  }

  Status open() override { return scene_.open(); }
  void set_frame(uint32_t frame) override { scene_.set_frame(frame); }

  void draw(const scenes::Paper& paper) override { scene_.draw(paper); }
  void add_changes(DirtyRects& dirty) const override {
    scene_.add_changes(dirty);
  }
  uint32_t next_due() const override { return scene_.next_due(); }

  std::vector<uint8_t> state() const override {
    std::vector<uint8_t> bytes;
    scene_.tell_state({&bytes, [](void* context, int32_t value) {
                         auto& out =
                             *static_cast<std::vector<uint8_t>*>(context);
                         for (uint32_t shift = 0; shift < 32; shift += 8) {
                           out.push_back(static_cast<uint8_t>(
                               static_cast<uint32_t>(value) >> shift));
                         }
                       }});
    return bytes;
  }
  size_t state_bytes() const override {
    return sizeof(Scene) + grid_.size() +
           particles_.size() * sizeof particles_[0] +
           homes_.size() * sizeof homes_[0];
  }

  std::optional<BodyFigures> figures() const override {
    if constexpr (std::is_same_v<Scene, scenes::BodyScene>) {
      return figures_of(scene_.bodies(), scene_.rules());
    } else {
      return std::nullopt;
    }
  }

 private:
  static scenes::SceneNeeds needs_of(const Font& font,
                                     std::string_view text,
                                     int width,
                                     int height) {
    if constexpr (std::is_same_v<Scene, scenes::BodyScene>) {
      return Scene::needs(font, {text.data(), text.size()}, height);
    }
    return Scene::needs(width, height);
  }

  std::vector<int8_t> grid_;
  std::vector<simulation::Particle> particles_;
  std::vector<simulation::ParticleHome> homes_;
  alignas(4) std::array<uint8_t, kWorkspaceBytes> workspace_{};
  Scene scene_;
};

template <typename Scene>
SceneKind kind_of(std::string_view name,
                  std::string_view what,
                  std::string_view takes,
                  std::string_view morphs = {}) {
  return {name,
          what,
          Scene::kText,
          takes,
          morphs,
          [](const Font& font, std::string_view text, int width, int height,
             std::optional<PrintStyle> print) -> std::unique_ptr<Player> {
            return std::make_unique<ScenePlayer<Scene>>(font, text, width,
                                                        height, print);
          }};
}

}  // namespace

void BodyFigures::add(const BodyFigures& frame) {
  drawn = std::max(drawn, frame.drawn);
  rigid = std::max(rigid, frame.rigid);
  squash = std::max(squash, frame.squash);
  least_body_ink = std::min(least_body_ink, frame.least_body_ink);
  greatest_body_ink = std::max(greatest_body_ink, frame.greatest_body_ink);
  least_ink = std::min(least_ink, frame.least_ink);
  greatest_ink = std::max(greatest_ink, frame.greatest_ink);
  off_floor = frame.off_floor;
}

const std::vector<SceneKind>& scene_kinds() {
  static const std::vector<SceneKind> kinds = {
      kind_of<scenes::PathScene>("path", "letters on a wave",
                                 "a line of up to 24 letters"),
      kind_of<scenes::ClockScene>("clock", "digits that become others",
                                  "a time, H:MM or HH:MM",
                                  scenes::ClockScene::kMorphs),
      kind_of<scenes::ParticleScene>(
          "particles", "a word bursts and becomes another", "two words"),
      kind_of<scenes::BodyScene>("figure13", "soft letters fall in a heap",
                                 "up to 8 letters"),
      kind_of<scenes::OffsetScene>(
          "figure14", "surfaces swell and throw particles off", "a word"),
      kind_of<scenes::VortexScene>("figure15",
                                   "a vortex winds a letter up, and runs back",
                                   "a letter, or a short word"),
      kind_of<scenes::MeltScene>(
          "melt", "a word melts, and another one freezes", "two words"),
      kind_of<scenes::PrintScene>("print", "light goes round five prints",
                                  "a word"),
      kind_of<scenes::CountScene>("count", "a number rolls up",
                                  "a number of up to 9 digits"),
      kind_of<scenes::TickerScene>("ticker", "a line runs by",
                                   "a line of up to 64 letters"),
      kind_of<scenes::TypewriterScene>(
          "typewriter", "a line is typed, and erased",
          "a line that fits the width at 8 px to the em"),
      kind_of<scenes::WipeScene>("wipe", "a soft edge reveals a word",
                                 "two words"),
      kind_of<scenes::LettersScene<scenes::Letters::bounce>>(
          "bounce", "letters hop", "a line of up to 24 letters"),
      kind_of<scenes::PulseScene>("pulse", "weight runs along a word",
                                  "a line of up to 24 letters"),
      kind_of<scenes::LettersScene<scenes::Letters::splash>>(
          "splash", "a title comes and goes", "a line of up to 24 letters"),
      kind_of<scenes::IconScene>("icons", "icons become others",
                                 "one to four pairs of icons that --morph "
                                 "pairs"),
      kind_of<scenes::ChargeScene>(
          "charge", "a battery fills, its number glows", "1% to 100%"),
  };
  return kinds;
}

const SceneKind& find_scene(const std::string& name) {
  for (const SceneKind& kind : scene_kinds()) {
    if (kind.name == name) {
      return kind;
    }
  }
  std::string known;
  for (const SceneKind& kind : scene_kinds()) {
    known += " " + std::string(kind.name);
  }
  known += " reel";
  throw std::runtime_error(name + ": no such scene; there are" + known);
}

Image draw_frame(Player& player, DisplayMemory& memory, int rows) {
  memory.show(rows, [&](const Strip& strip) {
    DisplayPaper paper(memory.display(), strip);
    player.draw(paper.paper());
  });
  return memory.picture();
}

std::unique_ptr<Player> open_scene(const SceneKind& kind,
                                   const Font& font,
                                   std::string_view text,
                                   int width,
                                   int height,
                                   std::optional<PrintStyle> print) {
  std::unique_ptr<Player> player = kind.make(font, text, width, height, print);
  const Status status = player->open();
  if (status != Status::ok) {
    const bool is_text =
        status == Status::bad_argument || status == Status::buffer_small;
    throw std::runtime_error(
        "'" + std::string(text) + "' on " + std::to_string(width) + "x" +
        std::to_string(height) + " px: " + std::string(kind.name) + " takes " +
        std::string(kind.takes) +
        (is_text ? "" : ": " + std::string(status_name(status))));
  }
  return player;
}

}  // namespace inkcell::tools
