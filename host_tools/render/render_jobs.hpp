// Many pictures in one run, from a file with one JSON object a line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "canvas.hpp"
#include "convert.hpp"
#include "image.hpp"
#include "look.hpp"

namespace inkcell::tools {

inline constexpr double kMaxSide = 32767;  // of a picture [px]

/// One picture: `text` on a canvas of `w` x `h` px, its origin
/// (left end of the baseline) at (ox + dx / 64, oy + dy / 64) px, y down.
struct RenderJob {
  std::string font;
  std::string text;
  double size = 0;   // [px/em], rounded to 1/64
  double angle = 0;  // [degrees], counter-clockwise about the origin
  Use use = Use::still;
  double ox = 0;  // [px]
  double oy = 0;
  double dx = 0;  // [1/64 px]
  double dy = 0;
  int w = 0;  // [px]
  int h = 0;
  std::string out;
  std::string place;  // FILE:LINE, for messages
};

/// The cost of pictures: pixels within 3 px of ink, and the distances computed
/// for them, at least one each. Counts only styles with one sample a pixel or
/// adaptive sampling.
struct SampleTotal {
  uint64_t pixels = 0;
  uint64_t samples = 0;
  bool uses_radius = false;  // whether anything used it
};

/// Adds a picture drawn with the look.
void add_samples(const Image& image, const Look& look, SampleTotal& total);

/// Reads the file. `kind` "anim" is a frame of an animation, "static" (the
/// default) a still picture. Throws std::runtime_error that names file and
/// line: also for unknown keys, numbers that are not integers or out of range
/// where they must be, and pictures that would replace each other or an input
/// file. A file without jobs is refused.
std::vector<RenderJob> read_jobs(const std::filesystem::path& file);

/// Draws all pictures, at least one, on all cores. Each font file is opened or
/// converted once, with the characters of all its jobs. Throws
/// std::runtime_error that begins with the place of the job.
SampleTotal render_jobs(const std::vector<RenderJob>& jobs,
                        const Conversion& conversion,
                        const LookOptions& look,
                        Kerning kerning,
                        bool inverted);

}  // namespace inkcell::tools
