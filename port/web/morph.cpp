// A glyph between two others: inkcell/motion/morph.hpp.
#include "inkcell/motion/morph.hpp"

#include "web.h"

using namespace inkcell;

namespace {

// Grids of three boxes of 96 px, with a sample a pixel.
constexpr size_t kGridBytes = motion::morph_bytes({96, 128, 0, 0});
int8_t grids[kGridBytes];
motion::GridHistogram scratch;

}  // namespace

inkcell_status_t web_morph(const web_job_t* job,
                           int32_t width,
                           int32_t height,
                           int32_t baseline,
                           uint32_t from,
                           uint32_t to,
                           int32_t progress_q16) {
  inkcell_font_t opened;
  inkcell_sink_t sink;
  web_target_t target;
  inkcell_status_t status = inkcell_font_open(job->rom, job->rom_size, &opened);
  if (status == INKCELL_OK) {
    status = web_sink(job, &target, &sink);
  }
  if (status != INKCELL_OK) {
    return status;
  }
  // The types of C are those of C++ in the same memory (port/c/mirror.hpp).
  const Font& font = reinterpret_cast<const Font&>(opened);
  motion::GlyphMorph morph(font, Q26_6::from_raw(job->size_q6), kFilterMotion,
                           {width, height, baseline, job->size_q6 >= 80 * 64},
                           {grids, kGridBytes});
  const Status set =
      morph.set(font.glyph_or_notdef(from), font.glyph_or_notdef(to));
  if (set == Status::ok) {
    morph.step(Q16_16::from_raw(progress_q16), scratch);
    morph.draw(job->x_q6 >> 6, job->y_q6 >> 6,
               reinterpret_cast<const Sink&>(sink));
  }
  return static_cast<inkcell_status_t>(set);
}
