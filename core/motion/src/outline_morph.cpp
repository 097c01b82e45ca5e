// The source of outlines between two glyphs.
#include "inkcell/motion/outline_morph.hpp"

#include "base/bytes.hpp"
#include "base/math.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/text.hpp"
#include "limits.hpp"
#include "morph_record.hpp"
#include "morph_table.hpp"
#include "outlines/outline_glyph.hpp"
#include "rows/source.hpp"

namespace inkcell::motion {
namespace {

using detail::GlyphJob;
using detail::GlyphRef;
using detail::InkEnds;
using detail::OutlineGlyph;
using detail::Placed;
using detail::ScreenPoint;

namespace morphs = format::morphs;

constexpr int32_t kOneQ10 = 1 << 10;

// A pair at a progress. Null points: they are made anew for each call.
struct Morphing {
  const Font* font;
  Span<const uint8_t> record;
  uint16_t glyphs[2];
  int32_t progress_q10;  // 1..1023
  MorphPoints* points;
};

struct __attribute__((may_alias)) MorphJob : GlyphJob {
  const Morphing* morphing;
  InkEnds ink[2];  // of the outline on its way
  Placed placed;
  const ScreenPoint* points;
  const ScreenPoint* points_end;
  detail::OutlineCursor cursor;
};

static_assert(sizeof(MorphJob) <= detail::kMostJob);

bool find_glyph(const MorphJob& job,
                uint16_t glyph,
                OutlineGlyph& outline,
                InkEnds (&ink)[2],
                bool& is_mirrored) noexcept {
  const Style& style = *job.style;
  return outline.find(*job.morphing->font, glyph, style.size(),
                      style.is_upright() ? nullptr : &style, ink, is_mirrored);
}

// The box of the outline on its way, and where its points count from.
void find_box(const MorphJob& job, OutlineGlyph& outline, Rect& box) noexcept {
  outline.find_box(job.placed, job.plan, job.guards * 128, job.ink, box);
}

// Rounded outwards: by a 32nd of a pixel.
int32_t end_between(int32_t a, int32_t b, int32_t part, int32_t sign) noexcept {
  const int32_t whole =
      detail::wrapped(static_cast<uint32_t>(b) - static_cast<uint32_t>(a));
  return detail::sum(
      a, detail::sum(detail::product(detail::product(whole >> 12, part), 4),
                     sign * (1 << 13)));
}

// All points of a glyph, where its partner's are. Null: there is no room.
__attribute__((noinline)) ScreenPoint* read_glyph(MorphJob& job,
                                                  uint16_t glyph,
                                                  ScreenPoint* out,
                                                  ScreenPoint* end) noexcept {
  OutlineGlyph outline;
  InkEnds own[2];
  bool is_mirrored;
  if (!find_glyph(job, glyph, outline, own, is_mirrored)) {
    return nullptr;
  }
  Rect box;
  find_box(job, outline, box);
  outline.rewind();
  out = outline.read(out, static_cast<int32_t>(end - out));
  return outline.is_done() ? out : nullptr;
}

// Makes the points of the outline between both glyphs, from `begin` on. Null:
// there is no room, or nothing shows.
ScreenPoint* make_points(MorphJob& job,
                         ScreenPoint* begin,
                         ScreenPoint* end) noexcept {
  const Morphing& morphing = *job.morphing;
  // Both glyphs, and then the outline between them, which takes their place.
  ScreenPoint* const second = read_glyph(job, morphing.glyphs[0], begin, end);
  if (second == nullptr) {
    return nullptr;
  }
  ScreenPoint* const made = read_glyph(job, morphing.glyphs[1], second, end);
  if (made == nullptr) {
    return nullptr;
  }
  const MorphOutline outlines[] = {
      {begin, static_cast<int32_t>(second - begin)},
      {second, static_cast<int32_t>(made - second)}};
  const ScreenPoint* const made_end =
      write_morph(morphing.record, outlines, morphing.progress_q10, made,
                  static_cast<int32_t>(end - made));
  if (made_end == nullptr || made_end == made) {
    return nullptr;
  }
  ScreenPoint* out = begin;
  for (const ScreenPoint* from = made; from != made_end;) {
    *out++ = *from++;
  }
  return out;
}

bool load_kept(MorphJob& job, MorphPoints& kept) noexcept {
  auto* const begin = reinterpret_cast<ScreenPoint*>(kept.ram.data);
  if (kept.count < 0) {
    const size_t room = kept.ram.size / sizeof(ScreenPoint);
    const ScreenPoint* const end = make_points(job, begin, begin + room);
    kept.count = end == nullptr ? 0 : static_cast<int32_t>(end - begin);
  }
  job.points = begin;
  job.points_end = begin + kept.count;
  return kept.count != 0;
}

bool load_points(GlyphJob& base) noexcept {
  auto& job = static_cast<MorphJob&>(base);
  if (job.morphing->points != nullptr) {
    return load_kept(job, *job.morphing->points);
  }
  auto* const begin = reinterpret_cast<ScreenPoint*>(job.ram);
  const int32_t room = job.ram_bytes / int32_t{sizeof(ScreenPoint)};
  ScreenPoint* const end = make_points(job, begin, begin + room);
  if (end == nullptr) {
    return false;
  }
  job.points = begin;
  job.points_end = end;
  uint8_t* const ram_end = job.ram + job.ram_bytes;
  job.ram = reinterpret_cast<uint8_t*>(end);
  job.ram_bytes = static_cast<int32_t>(ram_end - job.ram);
  return job.ram_bytes >= detail::kLeastBand;
}

__attribute__((noinline)) bool find_morph(MorphJob& job) noexcept {
  OutlineGlyph outline;
  InkEnds to[2];
  const Morphing& morphing = *job.morphing;
  if (!find_glyph(job, morphing.glyphs[1], outline, to, job.band.is_mirrored) ||
      !find_glyph(job, morphing.glyphs[0], outline, job.ink,
                  job.band.is_mirrored)) {
    return false;
  }
  const int32_t part = morphing.progress_q10;
  for (int32_t i = 0; i != 2; ++i) {
    InkEnds& ends = job.ink[i];
    ends = {end_between(ends.low, to[i].low, part, -1),
            end_between(ends.high, to[i].high, part, 1)};
  }
  find_box(job, outline, job.box);
  return true;
}

bool prepare_morph(GlyphJob& base,
                   const GlyphRef& ref,
                   const Placed& placed) noexcept {
  auto& job = static_cast<MorphJob&>(base);
  job.morphing = static_cast<const Morphing*>(ref.from);
  job.placed = placed;
  return find_morph(job);
}

void fill_morph(GlyphJob& base) noexcept {
  auto& job = static_cast<MorphJob&>(base);
  job.cursor.begin(job.guards == 0);
  job.plan.band_kind->paint(job.band, job.cursor, job.points, job.points_end);
}

constexpr detail::Source kMorphSource = {prepare_morph,
                                         load_points,
                                         fill_morph,
                                         sizeof(MorphJob),
                                         detail::SourceKind::outlines,
                                         nullptr};

int32_t to_q10(Q16_16 progress) noexcept {
  return clamp(progress.raw, 0, 1 << 16) >> 6;
}

}  // namespace

Status OutlineMorph::open(const Font& font,
                          uint16_t from,
                          uint16_t to,
                          OutlineMorph& out) noexcept {
  if (from >= font.glyph_count() || to >= font.glyph_count()) {
    return Status::no_glyph;
  }
  OutlineMorph found;
  if (from != to) {
    found.record_ =
        MorphTable(font).find(from < to ? from : to, from < to ? to : from);
    if (found.record_.size == 0 || !font.has_outlines()) {
      return Status::no_glyph;
    }
  }
  found.font_ = &font;
  found.from_ = from;
  found.to_ = to;
  out = found;
  return Status::ok;
}

Status OutlineMorph::open_master(const Font& font,
                                 uint16_t glyph,
                                 OutlineMorph& out) noexcept {
  const uint16_t master = MorphTable(font).master_of(glyph);
  return master == glyph ? Status::no_glyph : open(font, glyph, master, out);
}

OutlineMorph OutlineMorph::to_master(const Font& font,
                                     uint16_t glyph) noexcept {
  OutlineMorph morph;
  if (open_master(font, glyph, morph) != Status::ok) {
    static_cast<void>(open(font, glyph, glyph, morph));
  }
  return morph;
}

Q26_6 OutlineMorph::advance(const Style& style,
                            Q16_16 progress) const noexcept {
  if (font_ == nullptr) {
    return {};
  }
  const auto px = [&](uint16_t glyph) {
    return to_px(*font_, style, font_->advance(glyph)).raw;
  };
  return Q26_6::from_raw(lerp(
      px(from_), px(to_), Q16_16::from_raw(clamp(progress.raw, 0, 1 << 16))));
}

void OutlineMorph::draw_or_box(const Painter& painter,
                               const Style& style,
                               Point origin,
                               Q16_16 progress,
                               MorphPoints* points,
                               Rect* box) const noexcept {
  const int32_t progress_q10 = to_q10(progress);
  Placed placed;
  if (font_ == nullptr || !placed.set(origin)) {
    return;
  }
  if (from_ == to_ || progress_q10 == 0 || progress_q10 == kOneQ10) {
    const uint16_t glyph = progress_q10 < kOneQ10 ? from_ : to_;
    if (box != nullptr) {
      *box = painter.for_motion().glyph_box(*font_, style, origin, glyph);
    } else {
      painter.for_motion().glyph(*font_, style, origin, glyph);
    }
    return;
  }
  const bool is_reverse = from_ > to_;
  const Morphing morphing = {
      font_,
      record_,
      {is_reverse ? to_ : from_, is_reverse ? from_ : to_},
      is_reverse ? kOneQ10 - progress_q10 : progress_q10,
      points};
  const detail::GlyphCall call = {{&kMorphSource, &morphing, 0},
                                  style,
                                  placed,
                                  box == nullptr ? &painter.sink() : nullptr};
  if (box != nullptr) {
    *box = detail::band_box(call);
  } else {
    detail::draw_bands(call, painter.ram());
  }
}

void OutlineMorph::draw(const Painter& painter,
                        const Style& style,
                        Point origin,
                        Q16_16 progress) const noexcept {
  draw_or_box(painter, style, origin, progress, nullptr, nullptr);
}

Rect OutlineMorph::box(const Style& style,
                       Point origin,
                       Q16_16 progress) const noexcept {
  Rect box;
  draw_or_box(Painter(), style, origin, progress, nullptr, &box);
  return box;
}

void MorphFrame::draw(const Painter& painter) noexcept {
  morph_.draw_or_box(painter, style_, origin_, progress_, &points_, nullptr);
}

size_t OutlineMorph::workspace_bytes(const Font& font) noexcept {
  const Span<const uint8_t> section = font.section(format::section::kMorphs);
  const size_t points =
      section.size < morphs::kBytes
          ? 0
          : detail::load_u16(section.data + morphs::kMaxPoints);
  constexpr size_t kOther =
      sizeof(MorphJob) + detail::kLeastBand + alignof(MorphJob);
  constexpr size_t kLeast = detail::kLeastFittedRam + alignof(MorphJob);
  const size_t bytes = points * sizeof(ScreenPoint) + kOther;
  return bytes < kLeast ? kLeast : bytes;
}

}  // namespace inkcell::motion
