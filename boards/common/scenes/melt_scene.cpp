// A word melts by steps. The next one is a function of the time: the word up to
// a level that rises, and a puddle of the ink that is not in the word yet. That
// gets shallow first, and then withdraws to where the word stands.
#include "melt_scene.hpp"

#include "inkcell/motion/easing.hpp"
#include "inkcell/motion/grid_draw.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/motion/timeline.hpp"
#include "inkcell/simulation/redistance.hpp"

namespace inkcell::scenes {
namespace {

constexpr int32_t kHalfLoop = kLoopFrames / 2;
// Frames of half a loop.
constexpr int32_t kMelts = 4;
constexpr int32_t kLevels = 46;
constexpr int32_t kFreezes = 58;
constexpr int32_t kWhole = 94;  // the word is drawn as text
constexpr int32_t kRests = 106;
// Ends in motion, which hides that the grid has blunter corners than text.
constexpr motion::Easing kFreeze = motion::cubic_bezier(420, 0, 850, 900);

constexpr int32_t kSample = 32;          // in units of a grid's values
constexpr int32_t kRound = 3 * kSample;  // the radius of edges and joints
constexpr int32_t kFoot = 2 * kSample;   // the height of a letter's foot
constexpr int32_t kDrip = 8;             // [samples]

// The greater of two, or the smaller of their negatives, rounded where they
// are nearer than `wide`.
int32_t round_max(int32_t a, int32_t b, int32_t wide) noexcept {
  const int32_t apart = a > b ? a - b : b - a;
  const int32_t more =
      apart >= wide ? 0 : (wide - apart) * (wide - apart) / (4 * wide);
  return (a > b ? a : b) + more;
}
int32_t round_min(int32_t a, int32_t b, int32_t wide) noexcept {
  return -round_max(-a, -b, wide);
}

int8_t melt_sample(int32_t value) noexcept {
  return static_cast<int8_t>(value < INT8_MIN   ? INT8_MIN
                             : value > INT8_MAX ? INT8_MAX
                                                : value);
}

}  // namespace

int32_t MeltScene::height_part(const SceneSetting& setting) noexcept {
  const TextMeasure all = measure(*setting.font, setting.text);
  const TextMeasure widest =
      measure(*setting.font, wider_word(*setting.font, setting.text));
  const int32_t height = all.y_max - all.y_min;
  return height <= 0
             ? kHeightPart
             : static_cast<int32_t>(int64_t{kHeightPart} *
                                    (widest.y_max - widest.y_min) / height);
}

MeltScene::MeltScene(const SceneSetting& setting) noexcept
    : TextScene(setting,
                wider_word(*setting.font, setting.text),
                230,
                height_part(setting)) {
  Span<int8_t> memory = setting.memory.grid;
  const int32_t scale = scale_for(setting.width);
  for (Grid& grid : grids_) {
    grid = take_grid(memory, setting.width,
                     rows_for(setting.width, setting.height), scale);
  }
  away_ = take_grid(memory, setting.width, 1, scale);
  how_.beside = Q26_6::from_raw(2 * setting.width);  // 1/32 of the width
  how_.drip = Q26_6::from_int(kDrip << scale);
}

Status MeltScene::open() noexcept {
  step_ = 0;
  if (away_.width() == 0) {
    return Status::buffer_small;
  }
  const int32_t scale = grids_[0].scale_log2();
  how_.floor = origin().y;
  how_.floor.raw +=
      Painter().measure(font(), style(), wider_word(font(), text())).bottom.raw;
  // The floor is a margin above the lower edge of the grids.
  top_ = ((how_.floor.raw + 63) >> 6) + (kMargin << scale) -
         (grids_[0].height() << scale);
  how_.floor.raw -= top_ * 64;
  return paint(1, grids_[1]) && paint(0, grids_[1]) ? status()
                                                    : Status::bad_argument;
}

void MeltScene::set_frame(uint32_t to) noexcept {
  const Rect before = shown();
  if (to < step_) {
    static_cast<void>(open());  // it has been open
  }
  const bool rests = is_at_rest() && to == step_ + 1;
  while (step_ < to) {
    ++step_;
    step();
  }
  const Rect changed = bounding_box(before, shown());
  next(to, rests && is_at_rest() ? Rect() : changed);
}

void MeltScene::draw(const Paper& paper) const noexcept {
  const int32_t now = phase();
  const int32_t melted = motion::fraction(kMelts, kFreezes, now).raw;
  const int32_t frozen = motion::fraction(kFreezes, kRests, now).raw;
  const uint32_t ink = mix_rgb(0xe4f4ff, 0x3d9be0, (melted - frozen) >> 8);
  paper.fill(0x08121e);
  if (is_whole()) {
    const Text line = word(index());
    Point at = place(line);
    at.y.raw += top_ * 64;
    painter(paper, ink).text(font(), style(), at, line);
  } else {
    motion::draw_grid(grids_[0], {}, 0, top_, kFilterMotion, paper.with(ink));
  }
}

int32_t MeltScene::phase() const noexcept {
  return static_cast<int32_t>(step_ % static_cast<uint32_t>(kHalfLoop));
}

// The index of the word that is shown, or melts.
size_t MeltScene::index() const noexcept {
  const uint32_t whole = step_ / static_cast<uint32_t>(kHalfLoop);
  return (whole + (phase() >= kWhole ? 1 : 0)) % 2;
}

bool MeltScene::is_whole() const noexcept {
  return phase() < kMelts || phase() >= kWhole;
}

bool MeltScene::is_at_rest() const noexcept {
  return phase() < kMelts || phase() >= kRests;
}

Rect MeltScene::shown() const noexcept {
  Rect box = known_pixels(grids_[is_whole() ? 1 : 0]);
  box.y0 += top_;
  box.y1 += top_;
  return box;
}

bool MeltScene::paint(size_t index, Grid& grid) noexcept {
  const Text line = word(index);
  return paint_text(font(), line, {style().size(), place(line)}, workspace(),
                    grid) &&
         grid.area() > 0;
}

// Where the ink of a word stands on the floor of the grids.
Point MeltScene::place(Text line) const noexcept {
  const PixelMeasure ink = Painter().measure(font(), style(), line);
  return {centred(line).x, Q26_6::from_raw(how_.floor.raw - ink.bottom.raw)};
}

void MeltScene::step() noexcept {
  const int32_t now = phase();
  if (is_whole()) {
    return;
  }
  if (now == kMelts) {
    swap();
    how_.area = grids_[0].area();
  }
  if (now >= kFreezes) {
    if (now == kFreezes) {
      static_cast<void>(paint(1 - index(), grids_[1]));  // open() has tried
    }
    freeze_to(
        motion::ease(kFreeze, motion::fraction(kFreezes - 1, kWhole - 1, now)));
    return;
  }
  if (now < kLevels) {
    const int32_t since = now - kMelts;
    how_.speed_q8 = since < 20 ? since * 14 : 280;
    simulation::melt(grids_[0], how_, scratch_);
  } else {
    swap();
    grids_[0].clear();
    add_puddle(deepest(), INT16_MAX, kRound);
    swap();
    simulation::freeze(grids_[0], grids_[1], 8 * (now - kLevels + 1));
  }
  simulation::redistance(grids_[0], grids_[1]);
  swap();
}

void MeltScene::swap() noexcept {
  const Grid shape = grids_[0];
  grids_[0] = grids_[1];
  grids_[1] = shape;
}

// How high the middle of row y is above the floor. [1/32 of a sample]
int32_t MeltScene::height_of(int32_t y) const noexcept {
  const int32_t shift = grids_[0].scale_log2() + 1;
  return (how_.floor.raw - ((2 * y + 1) << (shift + 4))) >> shift;
}

// The first row whose middle is at most as high.
int32_t MeltScene::row_at(int32_t height) const noexcept {
  const int32_t row = (height_of(0) - height + kSample - 1) / kSample;
  return row < 0 ? 0 : row > grids_[0].height() ? grids_[0].height() : row;
}

// How far the middle of column x is from the ends of the widest puddle, above 0
// inside. [1/32 of a sample]
int32_t MeltScene::beside_of(int32_t x) const noexcept {
  const int32_t width = grids_[0].width();
  const int32_t across = (2 * x + 1 - width) * (kSample / 2);
  return width * (kSample / 2) -
         (how_.beside.raw >> (grids_[0].scale_log2() + 1)) -
         (across < 0 ? -across : across);
}

// Makes the shape what is below a level of the word that freezes.
void MeltScene::reveal(int32_t level) noexcept {
  Grid& grid = grids_[0];
  grid.clear();
  // The rows above have nothing left, those from `whole` on have all.
  const int32_t whole = row_at(level - INT8_MAX - kRound);
  for (int32_t y = row_at(level - INT8_MIN); y < grid.height(); ++y) {
    const int8_t* const from = grids_[1].row(y);
    int8_t* const row = grid.row(y);
    const int32_t left = level - height_of(y);
    for (int32_t x = 0; x < grid.width(); ++x) {
      row[x] = y < whole && from[x] != Grid::kOutside
                   ? melt_sample(round_min(from[x], left, kRound))
                   : from[x];
    }
  }
}

// How deep the puddle is when all has melted. [1/32 of a sample]
int32_t MeltScene::deepest() const noexcept {
  const int32_t half = beside_of(grids_[0].width() / 2);
  return how_.area * 8 / (half < 1 ? 1 : half);
}

// The depth of the widest puddle that adds an area to the grid.
int32_t MeltScene::depth_of(int32_t area) const noexcept {
  const Grid& grid = grids_[0];
  int32_t depth = 0;
  for (int32_t y = grid.height() - 1; y >= 0; --y) {
    const int32_t above = Grid::coverage_of(melt_sample(height_of(y)));
    int32_t room = 0;
    for (int32_t x = 0; x < grid.width(); ++x) {
      const int32_t covered = Grid::coverage_of(grid.row(y)[x]);
      if (beside_of(x) > 0 && covered < above) {
        room += above - covered;
      }
    }
    if (area < room) {
      return depth + above * area / room / 2;
    }
    area -= room;
    depth += above / 2;
  }
  return depth;
}

// How far a place is from the ink that a puddle withdraws to. `away`: columns
// from the foot of a letter. The height counts too, so that a puddle slopes
// where the grid only tells that ink is far. [1/32 of a sample]
int32_t MeltScene::apart_of(int32_t sample,
                            int32_t away,
                            int32_t height) noexcept {
  const int32_t across = kSample * away;
  return (across > -sample ? across : -sample) + (height > 0 ? height / 2 : 0);
}

// How far from ink a puddle of a depth reaches, if it adds an area to the grid.
// [1/32 of a sample] Leaves the columns' distances from feet in away_.
int32_t MeltScene::find_reach(int32_t depth, int32_t area) noexcept {
  const Grid& grid = grids_[0];
  const int32_t width = grid.width();
  int8_t* const away = away_.row(0);
  const int32_t floor = row_at(0);
  for (int32_t x = 0; x < width; ++x) {
    bool has_ink = false;
    for (int32_t y = row_at(kFoot - 1); y < floor; ++y) {
      has_ink = has_ink || grid.row(y)[x] >= 0;
    }
    const int32_t before = x == 0 ? INT8_MAX : away[x - 1];
    away[x] = static_cast<int8_t>(has_ink ? 0 : before + (before < INT8_MAX));
  }
  for (int32_t x = width - 2; x >= 0; --x) {
    away[x] =
        away[x] > away[x + 1] ? static_cast<int8_t>(away[x + 1] + 1) : away[x];
  }
  // The area that is as far from ink. [1/8 of a sample]
  scratch_ = {};
  for (int32_t y = row_at(depth - 1); y < floor; ++y) {
    const int32_t height = height_of(y);
    for (int32_t x = 0; x < width; ++x) {
      const int8_t sample = grid.row(y)[x];
      const int32_t apart =
          (apart_of(sample, away[x], height) + kSample / 2) / kSample;
      uint16_t& bin = scratch_.bins[apart < INT8_MAX ? apart : INT8_MAX];
      const int32_t room = (64 - Grid::coverage_of(sample)) / 8;
      bin = static_cast<uint16_t>(bin + (beside_of(x) > 0 ? room : 0));
    }
  }
  area /= 8;
  int32_t bin = 0;
  while (bin < INT8_MAX && area > scratch_.bins[bin]) {
    area -= scratch_.bins[bin];
    ++bin;
  }
  const int32_t room = scratch_.bins[bin];
  return kSample * bin - kSample / 2 +
         (room == 0 ? 0 : kSample * (area < room ? area : room) / room);
}

// Unites the grid with a puddle that reaches as far from columns of ink as
// find_reach() has found.
void MeltScene::add_puddle(int32_t depth,
                           int32_t reach,
                           int32_t round) noexcept {
  Grid& grid = grids_[0];
  const int8_t* const away = away_.row(0);
  // Above, nothing is near the puddle.
  for (int32_t y = row_at(depth - INT8_MIN + round); y < grid.height(); ++y) {
    int8_t* const row = grid.row(y);
    const int32_t height = height_of(y);
    for (int32_t x = 0; x < grid.width(); ++x) {
      const int32_t beside = beside_of(x);
      const int32_t side = reach - apart_of(row[x], away[x], height);
      const int32_t puddle =
          round_min(depth - height, side < beside ? side : beside, kRound);
      const int32_t both = round_max(puddle, row[x], round);
      row[x] = melt_sample(both < height ? both : height);
    }
  }
}

// Makes the shape a part of the word that freezes, and of its puddle: the area
// changes evenly.
void MeltScene::freeze_to(Q16_16 part) noexcept {
  const int32_t whole = grids_[1].area();
  const PixelMeasure ink =
      Painter().measure(font(), style(), word(1 - index()));
  const int32_t highest =
      ((ink.bottom.raw - ink.top.raw) >> (grids_[0].scale_log2() + 1)) +
      kRound * 3 / 4;
  reveal(motion::lerp(deepest() - kRound, highest, part));
  const int32_t area = motion::lerp(how_.area, whole, part) - grids_[0].area();
  if (area <= 0) {
    return;
  }
  int32_t depth = depth_of(area);
  int32_t reach = INT16_MAX;
  const int32_t shallow = deepest() * 5 / 8;
  if (depth < shallow) {
    reach = find_reach(shallow, area);
    depth = shallow;
  }
  add_puddle(depth, reach, motion::lerp(kRound, 1, part));
}

}  // namespace inkcell::scenes
