// Draws any glyph: band by band, from a source into a sink.
#include "rows/source.hpp"

#include "base/math.hpp"
#include "base/words.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/prepared_glyph.hpp"
#include "place/style_parts.hpp"

namespace inkcell {
namespace detail {
namespace {

// More is not used: sizes stay below 2^31.
constexpr size_t kMostBytes = 1 << 20;
// A word before the rows of a band: see Band.
constexpr int32_t kGuardBytes = 4;

// The sink of a glyph that is prepared for any.
constexpr Sink kAnySink = {{INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX}};

// Samples before the first pixel of a band, from a multiple of 4 on: one of
// them at least, but for areas, whose first pixel holds all to its left.
int32_t columns_before(const GlyphJob& job, int32_t x0) noexcept {
  const int32_t margin = job.plan.margin_x + job.guards;
  return ((x0 * job.plan.columns - margin) & 3) + margin;
}
// Samples of a band of pixels, from there on.
int32_t width_of(const BandPlan& plan,
                 int32_t column,
                 const Rect& pixels) noexcept {
  return column + (pixels.x1 - pixels.x0) * plan.columns + plan.margin_x;
}

// False: the style was not made, or its effect does not draw the source.
bool make_plan(const Source& source,
               const Style& style,
               BandPlan& plan) noexcept {
  if (!can_draw(source, style)) {
    return false;
  }
  // Smaller than to assign a BandPlan.
  __builtin_memset(static_cast<void*>(&plan), 0, sizeof plan);
  plan.columns = 1;
  plan.rows = 1;
  plan.sample_bytes = 1;
  plan.band_kind = StyleParts::band_kind(style);
  const Effect* const effect = style.effect();
  if (effect != nullptr && effect->mixer().band_kind != nullptr) {
    plan.band_kind = effect->mixer().band_kind;
  }
  if (plan.band_kind == nullptr) {
    return false;
  }
  const int32_t reach_q8 = plan.band_kind->reach_q8;
  if (reach_q8 != 0) {
    plan.outside_q8 = reach_q8;
    plan.ink_margin_q8 = reach_q8 + 4;  // for roundings
  } else {
    plan.widen(style.filter());
    plan.show(style.filter());
  }
  if (effect != nullptr) {
    effect->mixer().plan(*effect, style, plan);
    INKCELL_ASSERT(max(plan.outside_q8, plan.inside_q8) > 0);
    INKCELL_ASSERT(plan.margin_x <= 2 && plan.margin_y <= 2);
  }
  return true;
}

// False: nothing shows. `ram`: at least room for the maps of a fitted style.
bool prepare(GlyphJob& job,
             const GlyphCall& call,
             uint8_t* ram,
             size_t bytes) noexcept {
  const Source& source = *call.ref.source;
  job.source = &source;
  job.style = &call.style;
  job.sink = call.sink;
  job.ram = ram;
  job.ram_bytes = static_cast<int32_t>(bytes);
  if (!make_plan(source, call.style, job.plan)) {
    return false;
  }
  job.guards = job.plan.band_kind->bytes == BandBytes::area ? 0 : 1;
  return source.prepare(job, call.ref, call.placed) &&
         (call.sink == nullptr || job.clip());
}

// The same of a job at the beginning of its RAM, with what it keeps there.
bool prepare_in(const Workspace& ram, const GlyphCall& call) noexcept {
  auto& job = *reinterpret_cast<GlyphJob*>(ram.data);
  const size_t job_bytes = call.ref.source->job_bytes;
  return prepare(job, call, ram.data + job_bytes, ram.size - job_bytes) &&
         job.source->load(job);
}

// How far the band's distances are good.
void set_reach(GlyphJob& job) noexcept {
  const BandPlan& plan = job.plan;
  Band& band = job.band;
  band.outside_q8 = plan.outside_q8;
  band.inside_q8 = plan.inside_q8;
  band.reach_q8 = max(plan.outside_q8, plan.inside_q8);
  if (plan.band_kind->reach_q8 == 0) {
    band.fall_q14 = static_cast<int32_t>((254u << 14) /
                                         static_cast<uint32_t>(band.reach_q8));
  }
}

// Where the samples of job.pixels lie in the rows of a band.
void arrange_rows(GlyphJob& job) noexcept {
  const BandPlan& plan = job.plan;
  const int32_t column = columns_before(job, job.pixels.x0);
  const int32_t width = width_of(plan, column, job.pixels);
  job.column = static_cast<uint8_t>(column);
  job.band.last_column = width - 1;
  // The pixel after them has room.
  job.band.stride = (width + 4) & ~3;
}

// The band of job.pixels, whose rows are laid out.
inline void draw_band(GlyphJob& job) noexcept {
  const BandPlan& plan = job.plan;
  const Rect& pixels = job.pixels;
  Band& band = job.band;
  const int32_t height = pixels.y1 - pixels.y0;
  job.row = plan.margin_y;
  band.rows = height * plan.rows + 2 * plan.margin_y;
  band.bytes = job.ram + job.guards * (kGuardBytes + band.stride);
  band.x_q8 =
      ((pixels.x0 - first_column(job.box)) * plan.columns - job.column) * 256;
  band.y_q8 = ((pixels.y0 - job.box.y0) * plan.rows - plan.margin_y) * 256;
  band.is_whole = height == job.box.y1 - job.box.y0;
  clear_and_fill(job);
  emit_band(job);
}

// Draws job.pixels, cut into bands.
void draw_prepared(GlyphJob& job) noexcept {
  set_reach(job);
  Rect& part = job.pixels;
  const Rect all = part;
  arrange_rows(job);
  const BandPlan& plan = job.plan;
  const int32_t guards = job.guards;
  const int32_t bytes = job.ram_bytes - guards * kGuardBytes;
  const int32_t more_rows = 2 * (guards + plan.margin_y);
  // Rows of bytes that a row of pixels takes.
  const int32_t row_bytes = plan.rows * plan.sample_bytes;
  int32_t columns = all.x1 - all.x0;
  int32_t stride = job.band.stride;
  int32_t rows = all.y1 - all.y0;
  if ((rows * row_bytes + more_rows) * stride > bytes) {
    // Two rows at least, or one if nothing is around it: else columns are cut.
    const int32_t least =
        more_rows == 0 ? row_bytes : 2 * row_bytes + more_rows;
    while (least * stride > bytes) {
      INKCELL_ASSERT(columns > 4);  // within what BandPlan allows
      columns = ((columns + 1) / 2 + 3) & ~3;
      stride = (columns * plan.columns + 8 + 2 * plan.margin_x) & ~3;
    }
    rows = quotient(quotient(bytes, stride) - more_rows, row_bytes);
  }
  for (; part.y0 < all.y1; part.y0 = part.y1) {
    part.y1 = min(part.y0 + rows, all.y1);
    for (part.x0 = all.x0; part.x0 < all.x1; part.x0 = part.x1) {
      part.x1 = min(part.x0 + columns, all.x1);
      arrange_rows(job);
      draw_band(job);
    }
  }
}

// The part of a workspace that begins where pointers may lie.
Workspace aligned(const Workspace& workspace) noexcept {
  const uintptr_t skipped = (0u - reinterpret_cast<uintptr_t>(workspace.data)) &
                            (alignof(GlyphJob) - 1);
  if (workspace.size < skipped) {
    return {};
  }
  const size_t size = workspace.size - skipped;
  return {workspace.data + skipped,
          (size < kMostBytes ? size : kMostBytes) & ~size_t{3}};
}

__attribute__((noinline)) void draw_in(GlyphJob& job,
                                       uint8_t* ram,
                                       size_t bytes) noexcept {
  job.ram = ram;
  job.ram_bytes = static_cast<int32_t>(bytes);
  if (job.source->load(job)) {
    draw_prepared(job);
  }
}

__attribute__((noinline)) void draw_narrow(GlyphJob& job) noexcept {
  alignas(4) uint8_t bytes[kBandRam];
  draw_in(job, bytes, sizeof bytes);
}
__attribute__((noinline)) void draw_wide(GlyphJob& job) noexcept {
  alignas(4) uint8_t bytes[kWideBandRam];
  draw_in(job, bytes, sizeof bytes);
}

// Points and bands lie deeper in the stack than what fits the glyph, which
// takes as much of it. There is more for areas of which pixels two rows away
// decide about one: their painter takes less.
void draw_apart(GlyphJob& job) noexcept {
  if (job.plan.margin_y - job.guards == 2) {
    draw_wide(job);
  } else {
    draw_narrow(job);
  }
}

__attribute__((noinline)) void draw_on_stack(const GlyphCall& call) noexcept {
  alignas(GlyphJob) uint8_t bytes[kMostJob];
  auto& job = *reinterpret_cast<GlyphJob*>(bytes);
  if (prepare(job, call, nullptr, 0)) {
    draw_apart(job);
  }
}

// The same with maps. Lent RAM that has no room for the job has some for bands,
// unless it is null.
__attribute__((noinline)) void draw_fitted_on_stack(
    const GlyphCall& call, const Workspace& ram) noexcept {
  alignas(GlyphJob) uint8_t bytes[kMostJob + kMaps];
  auto& job = *reinterpret_cast<GlyphJob*>(bytes);
  if (!prepare(job, call, bytes + call.ref.source->job_bytes, kMaps)) {
    return;
  }
  if (ram.size > kWideBandRam) {
    draw_in(job, ram.data, ram.size);
  } else {
    draw_apart(job);
  }
}

// Not inline: most glyphs do not need its part of the stack.
__attribute__((noinline)) bool prepare_fitted(GlyphJob& job,
                                              const GlyphCall& call) noexcept {
  alignas(GlyphJob) uint8_t maps[kMaps];
  return prepare(job, call, maps, sizeof maps);
}

}  // namespace

__attribute__((noinline)) void clear_and_fill(GlyphJob& job) noexcept {
  const int32_t guards = job.guards;
  clear_pixels(job.ram, guards * kGuardBytes +
                            (job.band.rows + 2 * guards) * job.band.stride);
  job.source->fill(job);
}

// Where a glyph lies while it is drawn:
//
//   lent RAM [bytes]          job, maps   points and bands
//   kWideBandRam at most      stack       stack, deeper: draw_apart()
//   below kLeastFittedRam     stack       lent
//   more                      lent        lent
//
// Styles that are not fitted have no maps. In the first row they take a frame
// without room for them.
void draw_bands(const GlyphCall& call, const Workspace& workspace) noexcept {
  const Workspace ram = aligned(workspace);
  if (ram.size <= kWideBandRam && !call.style.is_fitted()) {
    draw_on_stack(call);
    return;
  }
  if (ram.size < kLeastFittedRam) {
    draw_fitted_on_stack(call, ram);
  } else if (prepare_in(ram, call)) {
    draw_prepared(*reinterpret_cast<GlyphJob*>(ram.data));
  }
}

void draw_banded(GlyphRun& run, uint16_t glyph, const Placed& placed) noexcept {
  const Font& font = *run.font;
  INKCELL_ASSERT(font.check(*run.style) == Status::ok);
  draw_bands(
      {{font.source(), &font, glyph}, *run.style, placed, &run.painter.sink()},
      run.painter.ram());
}

Rect band_box(const GlyphCall& call) noexcept {
  alignas(GlyphJob) uint8_t bytes[kMostJob];
  auto& job = *reinterpret_cast<GlyphJob*>(bytes);
  const bool shows = call.style.is_fitted() ? prepare_fitted(job, call)
                                            : prepare(job, call, nullptr, 0);
  return shows ? job.box : Rect{};
}

}  // namespace detail

Status PreparedGlyph::make(const Font& font,
                           uint16_t glyph,
                           const Style& style,
                           Point origin,
                           Workspace workspace,
                           PreparedGlyph& out) noexcept {
  using namespace detail;
  const Workspace ram = aligned(workspace);
  const Source* const source = font.source();
  // Fonts of such sources count no glyphs.
  const bool is_large = source != nullptr && source->job_bytes > kMostJob;
  if (ram.size <
      (is_large ? size_t{kLeastLargeRam} : size_t{kLeastFittedRam})) {
    return Status::buffer_small;
  }
  if (!is_large && glyph >= font.glyph_count()) {
    return Status::no_glyph;
  }
  if (source == nullptr || source->kind == SourceKind::strikes) {
    return Status::unsupported;
  }
  PreparedGlyph made;
  Placed placed;
  auto* const job = reinterpret_cast<GlyphJob*>(ram.data);
  if (placed.set(origin) &&
      prepare_in(ram, {{source, &font, glyph}, style, placed, &kAnySink})) {
    made.job_ = job;
  }
  out = made;
  return Status::ok;
}

Rect PreparedGlyph::box() const noexcept {
  return job_ == nullptr ? Rect{} : static_cast<detail::GlyphJob*>(job_)->box;
}

void PreparedGlyph::draw(const Sink& sink) const noexcept {
  if (job_ == nullptr) {
    return;
  }
  auto& job = *static_cast<detail::GlyphJob*>(job_);
  job.sink = &sink;
  if (job.clip()) {
    detail::draw_prepared(job);
  }
}

}  // namespace inkcell
