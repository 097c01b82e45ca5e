#include "rows/outline_draw.hpp"

#include "base/math.hpp"
#include "base/words.hpp"
#include "inkcell/prepared_glyph.hpp"
#include "rows/area_painter.hpp"
#include "rows/cover_areas.hpp"
#include "rows/cover_distances.hpp"
#include "rows/distance_painter.hpp"
#include "rows/outline_mixer.hpp"
#include "rows/outline_open.hpp"
#include "rows/wide_painter.hpp"
#include "sink/emit.hpp"

namespace inkcell {
namespace detail {
namespace {

// More is not used: sizes stay below 2^31.
constexpr size_t kMostBytes = 1 << 20;
// Rows above and below a band, and a word before the first: see Band.
constexpr int32_t kGuardRows = 2;
constexpr int32_t kGuardBytes = 4;

// Bands that are cut in columns have at least so many rows.
constexpr int32_t kLeastRows = 4;

// What such a band of one column takes of bytes: of the widest margin, 4 + 6
// rows and 16 columns.
constexpr int32_t kLeastBand = kGuardBytes + 10 * 16;

// Points at a time of a glyph that has more than there is room for: few, as
// each row that a band has less costs more than they do.
constexpr int32_t kPortion = 16;

// Rows of that many samples and the pixel after them. [bytes]
int32_t stride_of(int32_t width) noexcept {
  return (width + 4) & ~3;
}

// Points, and room for bands of rows behind them.
struct PreparedPoints {
  PaintedBand at;       // the band at hand
  ScreenPoint* points;  // room for all of them, or for some
  ScreenPoint* points_end;
  int32_t band_bytes;  // behind the points
  bool has_all;        // points
};

// A glyph in RAM.
struct __attribute__((may_alias)) Prepared : PreparedPoints, OpenGlyph {
  OutlineCursor cursor;
};

// The least RAM that a glyph is drawn in, and what it takes of the stack where
// no RAM is lent. [bytes]
constexpr size_t kLeastBytes = sizeof(Prepared) + sizeof(GlyphWarp) +
                               kPortion * sizeof(ScreenPoint) + kLeastBand;

// Not inline: most bands have all points, and fewer registers then.
__attribute__((noinline)) ScreenPoint* read_points(Prepared& prepared,
                                                   ScreenPoint* points,
                                                   int32_t room) noexcept {
  ScreenPoint* const end = prepared.glyph.read(points, room);
  if (prepared.warp != nullptr) {
    prepared.at.style->outline_fitter().apply(prepared, points, end);
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
    static_assert(sizeof(GlyphWarp) % sizeof(uint32_t) == 0, "aligned");
    points = reinterpret_cast<ScreenPoint*>(reinterpret_cast<uint8_t*>(points) +
                                            sizeof(GlyphWarp));
    size -= int32_t{sizeof(GlyphWarp)};
  }
  // Half of it for points at most.
  const int32_t room =
      min(size / 2, size - kLeastBand) / int32_t{sizeof(ScreenPoint)};
  glyph.rewind();
  ScreenPoint* end = read_points(prepared, points, room);
  prepared.has_all = glyph.is_done();
  if (!prepared.has_all) {
    end = points + min(kPortion, room);
  }
  prepared.points = points;
  prepared.points_end = end;
  prepared.band_bytes =
      size - static_cast<int32_t>(end - points) * int32_t{sizeof(ScreenPoint)};
  Band& band = prepared.at.band;
  const OutlinePlan& plan = prepared.plan;
  band.outside_q8 = plan.outside_q8;
  band.inside_q8 = plan.inside_q8;
  band.reach_q8 = max(plan.outside_q8, plan.inside_q8);
  if (plan.painter->reach_q8 == 0) {
    band.fall_q14 = static_cast<int32_t>((254u << 14) /
                                         static_cast<uint32_t>(band.reach_q8));
  }
  band.is_mirrored = glyph.is_mirrored();
  return end != points;
}

// All points, or portions of those for which there is no room.
void paint_band(Prepared& prepared) noexcept {
  prepared.cursor.begin();
  ScreenPoint* const points = prepared.points;
  const ScreenPoint* end = prepared.points_end;
  const auto room = static_cast<int32_t>(end - points);
  if (!prepared.has_all) {
    prepared.glyph.rewind();
  }
  do {
    if (!prepared.has_all) {
      end = read_points(prepared, points, room);
    }
    prepared.plan.painter->paint(prepared.at.band, prepared.cursor, points,
                                 end);
  } while (!prepared.glyph.is_done());
}

// The band of prepared.at.pixels.
__attribute__((noinline)) void draw_band(Prepared& prepared) noexcept {
  const OutlineGlyph& glyph = prepared.glyph;
  const OutlinePlan& plan = prepared.plan;
  const Rect& pixels = prepared.at.pixels;
  auto* const bytes = reinterpret_cast<uint8_t*>(prepared.points_end);
  Band& band = prepared.at.band;
  const int32_t column = plan.columns_before(pixels.x0);
  const int32_t width = plan.width_of(column, pixels);
  prepared.at.column = column;
  prepared.at.row = plan.margin_y;
  band.stride = stride_of(width);
  band.rows = (pixels.y1 - pixels.y0) * plan.rows + 2 * plan.margin_y;
  band.bytes = bytes + kGuardBytes + band.stride;
  band.last_column = width - 1;
  band.x_q8 = (pixels.x0 * plan.columns - column - glyph.x0()) * 256;
  band.y_q8 = (pixels.y0 * plan.rows - plan.margin_y - glyph.y0()) * 256;
  band.is_whole = pixels.y1 - pixels.y0 == glyph.box().y1 - glyph.box().y0;
  clear_pixels(bytes, kGuardBytes + (band.rows + kGuardRows) * band.stride);
  paint_band(prepared);
  const TextStyle& style = *prepared.at.style;
  if (const OutlineMixer* const mixer = style.effect().outlines) {
    mixer->mix(prepared.at);
    return;
  }
  plan.painter->cover(band, style.filter());
  emit(*prepared.at.sink, pixels, band.bytes + prepared.at.column, band.stride);
}

void draw_prepared(Prepared& prepared, const Sink& sink) noexcept {
  const Rect all = intersect(prepared.glyph.box(), sink.window);
  if (is_empty(all)) {
    return;
  }
  const OutlinePlan& plan = prepared.plan;
  const int32_t bytes = prepared.band_bytes - kGuardBytes;
  // Of samples.
  const int32_t more_rows = kGuardRows + 2 * plan.margin_y;
  int32_t rows =
      bytes / stride_of(plan.width_of(plan.columns_before(all.x0), all)) -
      more_rows;
  int32_t columns = all.x1 - all.x0;
  const int32_t least =
      min(all.y1 - all.y0, plan.rows == 1 ? kLeastRows : kLeastRows / 2);
  if (rows < least * plan.rows) {
    rows = least * plan.rows;
    columns = (bytes / (rows + more_rows) & ~3) - 8 - 2 * plan.margin_x;
    columns = plan.columns == 1 ? columns : columns / plan.columns;
  }
  rows = plan.rows == 1 ? rows : rows / plan.rows;
  prepared.at.sink = &sink;
  Rect& part = prepared.at.pixels;
  for (part.y0 = all.y0; part.y0 < all.y1; part.y0 = part.y1) {
    part.y1 = min(part.y0 + rows, all.y1);
    for (part.x0 = all.x0; part.x0 < all.x1; part.x0 = part.x1) {
      part.x1 = min(part.x0 + columns, all.x1);
      draw_band(prepared);
    }
  }
}

// The maps lie behind the glyph.
bool open(Prepared& prepared, const OutlineJob& job) noexcept {
  prepared.at.style = &job.style;
  prepared.warp = reinterpret_cast<GlyphWarp*>(&prepared + 1);
  return open_outline(prepared, job);
}

void draw_in(Prepared& prepared,
             int32_t size,
             const OutlineJob& job,
             const Sink& sink) noexcept {
  if (open(prepared, job) &&
      !is_empty(intersect(prepared.glyph.box(), sink.window)) &&
      prepare(prepared, size)) {
    draw_prepared(prepared, sink);
  }
}

__attribute__((noinline)) void draw_on_stack(const OutlineJob& job,
                                             const Sink& sink) noexcept {
  struct {
    Prepared prepared;
    uint8_t bytes[kLeastBytes - sizeof(Prepared)];
  } ram;
  draw_in(ram.prepared, kLeastBytes, job, sink);
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

const OutlinePainter kPaintPixelRamp = {paint_distances, cover_linear, 128,
                                        128};
const OutlinePainter kPaintDistances = {paint_distances, cover_filtered, 128,
                                        128};
const OutlinePainter kPaintWideDistances = {paint_wide_distances,
                                            cover_filtered, 128, 0};
const OutlinePainter kPaintAreas = {paint_areas, cover_areas, 0, 128};

void draw_outline(const Font& font,
                  uint16_t glyph,
                  Span<const uint8_t> record,
                  const TextStyle& style,
                  const Placed& placed,
                  const Sink& sink,
                  Workspace workspace) noexcept {
  const OutlineJob job = {font, record, style, placed, glyph};
  const Workspace ram = aligned(workspace);
  if (ram.size == 0) {
    draw_on_stack(job, sink);
    return;
  }
  draw_in(*reinterpret_cast<Prepared*>(ram.data),
          static_cast<int32_t>(ram.size), job, sink);
}

}  // namespace detail

Status PreparedGlyph::make(const Font& font,
                           uint16_t glyph,
                           const TextStyle& style,
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
             open(*prepared, {font, record, style, placed, glyph}) &&
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
