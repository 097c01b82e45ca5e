#include "outlines/outline_draw.hpp"

#include "inkcell/prepared_glyph.hpp"
#include "order.hpp"
#include "outlines/area_painter.hpp"
#include "outlines/cover.hpp"
#include "outlines/distance_painter.hpp"
#include "outlines/outline_mixer.hpp"
#include "outlines/point_warp.hpp"
#include "outlines/wide_painter.hpp"
#include "outlines/words.hpp"

namespace inkcell {
namespace detail {
namespace {

// The least RAM that a glyph is drawn in, and what it takes of the stack where
// no RAM is lent. [bytes]
constexpr int32_t kLeastBytes = 704;

// More is not used: sizes stay below 2^31.
constexpr size_t kMostBytes = 1 << 20;

// Rows above and below a band, and a word before the first: see Band.
constexpr int32_t kGuardRows = 2;
constexpr int32_t kGuardBytes = 4;

// Bands that are cut in columns have at least so many rows.
constexpr int32_t kLeastRows = 4;

// `bytes` is a multiple of 4.
void clear(uint8_t* at, int32_t bytes) noexcept {
  for (; bytes >= 32; bytes -= 32) {
    store_pixels(at, 0);
    store_pixels(at + 4, 0);
    store_pixels(at + 8, 0);
    store_pixels(at + 12, 0);
    store_pixels(at + 16, 0);
    store_pixels(at + 20, 0);
    store_pixels(at + 24, 0);
    store_pixels(at + 28, 0);
    at += 32;
  }
  for (; bytes != 0; bytes -= 4) {
    store_pixels(at, 0);
    at += 4;
  }
}

// The next pixels of a row up to the end of a word: 0 or ~0 if the word is all
// of that, else any other value.
inline uint32_t next_pixels(const uint8_t* at, int32_t count) noexcept {
  return count == 4 ? load_pixels(at) : 1;
}

}  // namespace

// To a sink that takes no blocks: runs of words that are covered, not covered,
// or in part.
void emit_row(const Sink& sink,
              int32_t x,
              int32_t y,
              const uint8_t* coverage,
              int32_t count) noexcept {
  const int32_t end = x + count;
  int32_t next = lesser((x | 3) + 1, end);
  uint32_t pixels = next_pixels(coverage, next - x);
  while (x != end) {
    const uint8_t* const begin = coverage;
    const int32_t from = x;
    const bool is_mixed = pixels + 1 > 1;
    const int32_t most = is_mixed ? kMaxSpan - 4 : count;
    const uint32_t first = pixels;
    do {
      coverage += next - x;
      x = next;
      next = lesser(x + 4, end);
      pixels = next_pixels(coverage, next - x);
    } while (x != end && x - from <= most &&
             (is_mixed ? pixels + 1 > 1 : pixels == first));
    if (is_mixed) {
      sink.coverage(sink.context, from, y, begin, x - from);
    } else if (first != 0) {
      sink.solid(sink.context, from, y, x - from);
    }
  }
}

void emit(const Sink& sink,
          const Rect& pixels,
          const uint8_t* coverage,
          int32_t stride) noexcept {
  if (sink.block != nullptr) {
    sink.block(sink.context, {pixels, coverage, stride});
    return;
  }
  for (int32_t y = pixels.y0; y != pixels.y1; ++y) {
    emit_row(sink, pixels.x0, y, coverage, pixels.x1 - pixels.x0);
    coverage += stride;
  }
}

namespace {

int32_t stride_of(int32_t x0, int32_t x1) noexcept {
  // From the word that holds the pixel before the first one to the pixel after
  // the last one.
  return (x1 - ((x0 - 1) & ~3) + 4) & ~3;
}

// Points at a time of a glyph that has more than there is room for: few, as
// each row that a band has less costs more than they do.
constexpr int32_t kPortion = 16;

const OutlinePainter& painter_of(const Brush& brush) noexcept {
  const OutlineMixer* const mixer = brush.painter().outlines;
  return mixer == nullptr ? brush.outline_painter() : *mixer->painter;
}

OutlinePlan plan_of(const Brush& brush) noexcept {
  // Room for roundings.
  constexpr int32_t kMore = 4;
  const OutlinePainter& painter = painter_of(brush);
  OutlinePlan plan;
  if (painter.reach_q8 != 0) {
    plan.outside_q8 = painter.reach_q8;
    plan.shown_q8 = 128 + kMore;
  } else {
    const Filter& filter = brush.filter();
    plan.widen(filter);
    plan.shown_q8 = (greater(-filter.outside_q10, 0) >> 2) + kMore;
  }
  if (brush.painter().outlines != nullptr) {
    brush.painter().outlines->plan(brush, plan);
  }
  return plan;
}

// A glyph in RAM: where it stands, its points, and room for bands of rows.
struct __attribute__((may_alias)) Prepared {
  OutlineGlyph glyph;
  const Brush* brush;
  OutlinePlan plan;
  const PointWarp* warp;  // null if the glyph is not fitted
  ScreenPoint* points;  // all of them if the glyph is done, else room for some
  ScreenPoint* points_end;
  int32_t band_bytes;  // behind the points
};

ScreenPoint* read_points(Prepared& prepared,
                         ScreenPoint* points,
                         int32_t room) noexcept {
  ScreenPoint* const end = prepared.glyph.read(points, room);
  if (prepared.warp != nullptr) {
    prepared.warp->apply(points, end);
  }
  return end;
}

// False if there is nothing to draw. `data` is a multiple of 4, `size` at least
// kLeastBytes.
bool prepare(Prepared& prepared, int32_t size) noexcept {
  OutlineGlyph& glyph = prepared.glyph;
  auto* points = reinterpret_cast<ScreenPoint*>(&prepared + 1);
  size -= int32_t{sizeof(Prepared)};
  if (prepared.warp != nullptr) {
    static_assert(sizeof(PointWarp) % sizeof(uint32_t) == 0, "aligned");
    points = reinterpret_cast<ScreenPoint*>(reinterpret_cast<uint8_t*>(points) +
                                            sizeof(PointWarp));
    size -= int32_t{sizeof(PointWarp)};
  }
  // Half of it for points at most.
  glyph.rewind();
  ScreenPoint* end =
      read_points(prepared, points, size / 2 / int32_t{sizeof(ScreenPoint)});
  if (!glyph.is_done()) {
    end = points + kPortion;
  }
  prepared.points = points;
  prepared.points_end = end;
  prepared.band_bytes =
      size - static_cast<int32_t>(end - points) * int32_t{sizeof(ScreenPoint)};
  return end != points;
}

// Points for which there is no room: anew for each band.
__attribute__((noinline)) void paint_portions(Prepared& prepared,
                                              const Band& band) noexcept {
  OutlineGlyph& glyph = prepared.glyph;
  const auto room = static_cast<int32_t>(prepared.points_end - prepared.points);
  OutlineCursor cursor;
  glyph.rewind();
  do {
    const ScreenPoint* const end = read_points(prepared, prepared.points, room);
    painter_of(*prepared.brush).paint(band, cursor, prepared.points, end);
  } while (!glyph.is_done());
  glyph.rewind();  // so that it is not done
}

// The samples that pixels are made of.
Rect samples_of(const OutlinePlan& plan, const Rect& pixels) noexcept {
  return {pixels.x0 * plan.columns - plan.margin_x,
          pixels.y0 * plan.rows - plan.margin_y,
          pixels.x1 * plan.columns + plan.margin_x,
          pixels.y1 * plan.rows + plan.margin_y};
}

void draw_band(Prepared& prepared,
               const Rect& pixels,
               const Sink& sink) noexcept {
  const OutlineGlyph& glyph = prepared.glyph;
  const OutlinePlan& plan = prepared.plan;
  const OutlinePainter& painter = painter_of(*prepared.brush);
  const Rect samples = samples_of(plan, pixels);
  const int32_t first = (samples.x0 - 1) & ~3;  // of columns
  auto* const bytes = reinterpret_cast<uint8_t*>(prepared.points_end);
  Band band;
  band.stride = stride_of(samples.x0, samples.x1);
  band.rows = samples.y1 - samples.y0;
  band.bytes = bytes + kGuardBytes + band.stride;
  band.last_column = samples.x1 - 1 - first;
  band.x_q8 = (first - glyph.x0()) * 256;
  band.y_q8 = (samples.y0 - glyph.y0()) * 256;
  band.outside_q8 = plan.outside_q8;
  band.inside_q8 = plan.inside_q8;
  band.reach_q8 = plan.reach_q8();
  band.fall_q14 =
      static_cast<int32_t>((254u << 14) / static_cast<uint32_t>(band.reach_q8));
  band.is_whole = pixels.y1 - pixels.y0 == glyph.box().y1 - glyph.box().y0;
  band.is_mirrored = glyph.is_mirrored();
  clear(bytes, kGuardBytes + (band.rows + kGuardRows) * band.stride);
  if (glyph.is_done()) {
    OutlineCursor cursor;
    painter.paint(band, cursor, prepared.points, prepared.points_end);
  } else {
    paint_portions(prepared, band);
  }
  if (const OutlineMixer* const mixer = prepared.brush->painter().outlines) {
    mixer->mix({band, *prepared.brush, pixels,
                samples.x0 + plan.margin_x - first, plan.margin_y, sink});
    return;
  }
  painter.cover(band, prepared.brush->filter());
  emit(sink, pixels, band.bytes + (pixels.x0 - first), band.stride);
}

void draw_prepared(Prepared& prepared, const Sink& sink) noexcept {
  const Rect pixels = intersect(prepared.glyph.box(), sink.window);
  if (is_empty(pixels)) {
    return;
  }
  const OutlinePlan& plan = prepared.plan;
  const int32_t bytes = prepared.band_bytes - kGuardBytes;
  const int32_t height = pixels.y1 - pixels.y0;
  const Rect samples = samples_of(plan, pixels);
  // Of samples.
  const int32_t more_rows = kGuardRows + 2 * plan.margin_y;
  int32_t rows = bytes / stride_of(samples.x0, samples.x1) - more_rows;
  int32_t columns = pixels.x1 - pixels.x0;
  const int32_t least =
      lesser(height, plan.rows == 1 ? kLeastRows : kLeastRows / 2);
  if (rows < least * plan.rows) {
    rows = least * plan.rows;
    columns = (bytes / (rows + more_rows) & ~3) - 8 - 2 * plan.margin_x;
    columns = plan.columns == 1 ? columns : columns / plan.columns;
  }
  rows = plan.rows == 1 ? rows : rows / plan.rows;
  Rect band = pixels;
  for (; band.y0 < pixels.y1; band.y0 = band.y1) {
    band.y1 = lesser(band.y0 + rows, pixels.y1);
    for (band.x0 = pixels.x0; band.x0 < pixels.x1; band.x0 = band.x1) {
      band.x1 = lesser(band.x0 + columns, pixels.x1);
      draw_band(prepared, band, sink);
    }
  }
}

// A glyph to draw, and where.
struct Job {
  const Font& font;
  Span<const uint8_t> record;
  const Brush& brush;
  const Placed& placed;
  uint16_t glyph;
};

// Where samples are, and how far pixels show: `more` is what fitting may move.
OutlineSampling sampling_of(const Prepared& prepared,
                            int32_t more_q8) noexcept {
  const OutlinePlan& plan = prepared.plan;
  return {painter_of(*prepared.brush).origin_q8, plan.shown_q8 + more_q8,
          plan.columns, plan.rows};
}

// The same of a glyph that is moved to the grid of pixels; its map lies behind
// it.
__attribute__((noinline)) bool open_fitted(Prepared& prepared,
                                           const Job& job) noexcept {
  RowMap rows;
  FinePoint origin = job.placed.origin();
  job.brush.fitter()(job.glyph, job.brush, job.brush.fitter_options(), origin,
                     rows);
  Placed placed;
  // No point moves by more than a pixel.
  if (!placed.set(origin) ||
      !prepared.glyph.open(job.font, job.glyph, job.record, job.brush, placed,
                           sampling_of(prepared, 256))) {
    return false;
  }
  if (rows.count != 0) {
    auto* const warp = reinterpret_cast<PointWarp*>(&prepared + 1);
    warp->x.clear();
    warp->y.set(rows, prepared.glyph.baseline_q8(), prepared.plan.rows);
    prepared.warp = warp;
  }
  return true;
}

bool open(Prepared& prepared, const Job& job) noexcept {
  prepared.brush = &job.brush;
  prepared.warp = nullptr;
  prepared.plan = plan_of(job.brush);
  if (job.brush.is_fitted()) {
    return open_fitted(prepared, job);
  }
  return prepared.glyph.open(job.font, job.glyph, job.record, job.brush,
                             job.placed, sampling_of(prepared, 0));
}

bool is_in(const Prepared& prepared, const Rect& window) noexcept {
  return !is_empty(intersect(prepared.glyph.box(), window));
}

__attribute__((noinline)) void draw_on_stack(const Job& job,
                                             const Sink& sink) noexcept {
  struct {
    Prepared prepared;
    uint8_t bytes[kLeastBytes - sizeof(Prepared)];
  } ram;
  if (open(ram.prepared, job) && is_in(ram.prepared, sink.window) &&
      prepare(ram.prepared, kLeastBytes)) {
    draw_prepared(ram.prepared, sink);
  }
}

// The part of a workspace that begins where pointers may lie; none if that is
// too small.
Workspace aligned(const Workspace& workspace) noexcept {
  const uintptr_t skipped = (0u - reinterpret_cast<uintptr_t>(workspace.data)) &
                            (alignof(Prepared) - 1);
  if (workspace.size < kLeastBytes + skipped) {
    return {};
  }
  const size_t size = workspace.size - skipped;
  return {workspace.data + skipped,
          (size < kMostBytes ? size : kMostBytes) & ~size_t{3}};
}

}  // namespace

const OutlinePainter kPaintDistances = {paint_distances, cover_distances, 128,
                                        128};
const OutlinePainter kPaintWideDistances = {paint_wide_distances,
                                            cover_distances, 128, 0};
const OutlinePainter kPaintAreas = {paint_areas, cover_areas, 0, 128};

void draw_outline(const Font& font,
                  uint16_t glyph,
                  Span<const uint8_t> record,
                  const Brush& brush,
                  const Placed& placed,
                  const Sink& sink,
                  Workspace workspace) noexcept {
  const Job job = {font, record, brush, placed, glyph};
  const Workspace ram = aligned(workspace);
  if (ram.size == 0) {
    draw_on_stack(job, sink);
    return;
  }
  Prepared& prepared = *reinterpret_cast<Prepared*>(ram.data);
  if (open(prepared, job) && is_in(prepared, sink.window) &&
      prepare(prepared, static_cast<int32_t>(ram.size))) {
    draw_prepared(prepared, sink);
  }
}

}  // namespace detail

Status PreparedGlyph::make(const Font& font,
                           uint16_t glyph,
                           const Brush& brush,
                           Point origin,
                           Workspace workspace,
                           PreparedGlyph& out) noexcept {
  using namespace detail;
  const Workspace ram = aligned(workspace);
  if (ram.size == 0) {
    return Status::buffer_small;
  }
  PreparedGlyph made;
  const Span<const uint8_t> record = font.record(glyph);
  Placed placed;
  auto* const prepared = reinterpret_cast<Prepared*>(ram.data);
  if (record.size == 0) {
    if (glyph >= font.glyph_count()) {
      return Status::no_glyph;
    }
  } else if (!is_outline(record)) {
    return Status::unsupported;
  } else if (placed.set(origin) &&
             open(*prepared, {font, record, brush, placed, glyph}) &&
             prepare(*prepared, static_cast<int32_t>(ram.size))) {
    made.prepared_ = prepared;
  }
  out = made;
  return Status::ok;
}

Rect PreparedGlyph::box() const noexcept {
  return prepared_ == nullptr
             ? Rect{}
             : static_cast<detail::Prepared*>(prepared_)->glyph.box();
}

void PreparedGlyph::draw(const Sink& sink) const noexcept {
  if (prepared_ != nullptr) {
    detail::draw_prepared(*static_cast<detail::Prepared*>(prepared_), sink);
  }
}

}  // namespace inkcell
