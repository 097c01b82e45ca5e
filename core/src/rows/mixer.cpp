#include "inkcell/mixer.hpp"

#include "rows/band.hpp"
#include "rows/source.hpp"

namespace inkcell {
namespace {

using detail::GlyphJob;

const GlyphJob& job_of(const GlyphBand& band) noexcept {
  return static_cast<const GlyphJob&>(band);
}

}  // namespace

const Style& GlyphBand::style() const noexcept {
  return *job_of(*this).style;
}

const Sink& GlyphBand::sink() const noexcept {
  return *job_of(*this).sink;
}

const Rect& GlyphBand::pixels() const noexcept {
  return job_of(*this).pixels;
}

uint8_t* GlyphBand::row(int32_t y) const noexcept {
  const GlyphJob& job = job_of(*this);
  return job.band.row(y - job.pixels.y0 + job.row) + job.column;
}

int32_t GlyphBand::stride() const noexcept {
  return job_of(*this).band.stride;
}

DistanceRow GlyphBand::distances(int32_t y) const noexcept {
  const GlyphJob& job = job_of(*this);
  DistanceRow row(job.band.row(y - job.pixels.y0 + job.row), job.band.reach_q8);
  row.skip(job.column);
  return row;
}

void GlyphBand::cover() const noexcept {
  const GlyphJob& job = job_of(*this);
  job.plan.band_kind->cover(job.band, job.style->filter());
}

void GlyphBand::repaint(int32_t right_q8, int32_t down_q8) noexcept {
  auto& job = static_cast<GlyphJob&>(*this);
  job.band.x_q8 -= right_q8;
  job.band.y_q8 -= down_q8;
  detail::clear_and_fill(job);
}

uint8_t* GlyphBand::memory() const noexcept {
  const GlyphJob& job = job_of(*this);
  return job.band.row(job.band.rows + job.guards);
}

void GlyphBand::emit() const noexcept {
  const GlyphJob& job = job_of(*this);
  detail::emit(*job.sink, job.pixels, row(job.pixels.y0), job.band.stride);
}

}  // namespace inkcell
