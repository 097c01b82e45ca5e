// The points and hints of a glyph, as the device decodes them.
#include "inkcell/grid_hints.hpp"
#include "inkcell/mixer.hpp"
#include "outlines/outline_glyph.hpp"
#include "web.h"

using namespace inkcell;

namespace {

// Writes numbers as long as there is room.
struct Numbers {
  int32_t* next;
  size_t room;

  void put(int32_t number) {
    if (room != 0) {
      *next++ = number;
      --room;
    }
  }
};

// A px is a u.
bool put_points(const Font& font, uint16_t glyph, Numbers& out) {
  detail::OutlineGlyph outline;
  detail::InkEnds ink[2];
  bool is_mirrored = false;
  if (!outline.find(font, glyph, Q26_6::from_int(1024), nullptr, ink,
                    is_mirrored)) {
    return false;
  }
  Rect box;
  outline.find_box({0, 0}, BandPlan(), 0, ink, box);
  const int32_t left_q8 = detail::first_column(box) * 256;
  const int32_t top_q8 = box.y0 * 256;
  outline.rewind();
  int32_t* const count = out.next;
  out.put(0);
  while (!outline.is_done() && out.room != 0) {
    detail::ScreenPoint points[8];
    const detail::ScreenPoint* const end = outline.read(points, 8);
    for (const detail::ScreenPoint* point = points; point != end; ++point) {
      out.put(left_q8 + point->x_q8);
      out.put(-top_q8 - point->y_q8());
      out.put(static_cast<int32_t>(point->kind()));
      ++*count;
    }
  }
  return true;
}

void put_hints(const GridHints& font,
               const Span<const uint8_t>& record,
               Numbers& out) {
  out.put(static_cast<int32_t>(font.zone_count()));
  for (uint32_t i = 0; i < font.zone_count(); ++i) {
    const GridZone zone = font.zone(i);
    out.put(zone.flat_u);
    out.put(zone.overshoot_u);
  }
  GlyphHints hints(font, record);
  out.put(static_cast<int32_t>(hints.y_count()));
  for (uint32_t i = 0; i < hints.y_count(); ++i) {
    const YHint hint = hints.next_y();
    out.put(hint.kind);
    out.put(hint.low_u);
    out.put(hint.high_u);
  }
  out.put(static_cast<int32_t>(hints.x_count()));
  for (uint32_t i = 0; i < hints.x_count(); ++i) {
    const XHint hint = hints.next_x();
    out.put(hint.left_u);
    out.put(hint.right_u);
  }
}

}  // namespace

inkcell_status_t web_points(const web_job_t* job, uint32_t code_point) {
  inkcell_font_t opened;
  const inkcell_status_t status =
      inkcell_font_open(job->rom, job->rom_size, &opened);
  if (status != INKCELL_OK) {
    return status;
  }
  // The types of C are those of C++ in the same memory (port/c/mirror.hpp).
  const Font& font = reinterpret_cast<const Font&>(opened);
  GridHints hints;
  const Status read = GridHints::open(font, hints);
  if (read != Status::ok) {
    return static_cast<inkcell_status_t>(read);
  }
  const uint16_t glyph = font.glyph_or_notdef(code_point);
  Numbers out = {reinterpret_cast<int32_t*>(job->pixels),
                 job->pixels_size / sizeof(int32_t)};
  if (!put_points(font, glyph, out)) {
    return INKCELL_NO_GLYPH;
  }
  put_hints(hints, font.record(glyph), out);
  return out.room == 0 ? INKCELL_BUFFER_SMALL : INKCELL_OK;
}
