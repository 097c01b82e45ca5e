// Reads job files and draws their pictures on all cores.
#include "render_jobs.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "canvas.hpp"
#include "convert.hpp"
#include "parallel.hpp"

namespace inkcell::tools {
namespace {

RenderJob read_job(const std::string& line) {
  const nlohmann::json json = nlohmann::json::parse(line);
  RenderJob job;
  json.at("font").get_to(job.font);
  json.at("text").get_to(job.text);
  json.at("size").get_to(job.size);
  json.at("w").get_to(job.w);
  json.at("h").get_to(job.h);
  json.at("out").get_to(job.out);
  job.ox = json.value("ox", 0.0);
  job.oy = json.value("oy", 0.0);
  job.dx = json.value("dx", 0.0);
  job.dy = json.value("dy", 0.0);
  job.angle = json.value("angle", 0.0);
  const std::string kind = json.value("kind", "static");
  if (kind != "static" && kind != "anim") {
    throw std::runtime_error("kind '" + kind + "' is not static or anim");
  }
  job.use = kind == "anim" ? Use::moving : Use::still;
  return job;
}

SampleTotal render(const RenderJob& job,
                   const Font& font,
                   const LookOptions& options,
                   bool inverted) {
  if (job.w <= 0 || job.h <= 0) {
    throw std::runtime_error("w and h must be positive");
  }
  const Look look(options, font, job.size, job.angle, job.use);
  Image image(job.w, job.h, look.channels());
  draw_lines(font, {lay_out(font, job.text, Kerning::none)}, look.brush(),
             make_point(job.ox + job.dx / 64, job.oy + job.dy / 64), image);
  SampleTotal total;
  add_samples(image, look, total);
  if (inverted) {
    invert(image);
  }
  write_image(job.out, image);
  return total;
}

}  // namespace

void add_samples(const Image& image, const Look& look, SampleTotal& total) {
  constexpr int kNear = 3;
  total.uses_radius |= look.uses_radius();
  if (look.brush().painter() != nullptr && !look.is_adaptive()) {
    return;
  }
  // Near in a row first, then near such a row: a square is a disc but for its
  // corners, and these are cut off by the way that is left.
  std::vector<int> way(static_cast<size_t>(image.width) *
                       static_cast<size_t>(image.height));
  const auto at = [&](int x, int y) -> int& {
    return way[static_cast<size_t>(y) * static_cast<size_t>(image.width) +
               static_cast<size_t>(x)];
  };
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      at(x, y) = kNear + 1;
      for (int i = -kNear; i <= kNear; ++i) {
        if (x + i >= 0 && x + i < image.width && *image.at(x + i, y) != 0) {
          at(x, y) = std::min(at(x, y), std::abs(i));
        }
      }
    }
  }
  uint64_t pixels = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      bool is_near = false;
      for (int i = -kNear; i <= kNear; ++i) {
        is_near |= y + i >= 0 && y + i < image.height &&
                   at(x, y + i) * at(x, y + i) + i * i <= kNear * kNear;
      }
      pixels += is_near ? 1 : 0;
    }
  }
  total.pixels += pixels;
  total.samples += pixels + look.more_samples();
}

std::vector<RenderJob> read_jobs(const std::filesystem::path& file) {
  const std::vector<uint8_t> bytes = read_file(file);
  std::istringstream in(std::string(bytes.begin(), bytes.end()));
  std::vector<RenderJob> jobs;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) {
      continue;
    }
    try {
      jobs.push_back(read_job(line));
    } catch (const std::exception& error) {
      throw std::runtime_error(file.string() + ":" + std::to_string(number) +
                               ": " + error.what());
    }
  }
  return jobs;
}

SampleTotal render_jobs(const std::vector<RenderJob>& jobs,
                        const Conversion& conversion,
                        const LookOptions& look,
                        bool inverted) {
  const bool all_turned =
      !jobs.empty() &&
      std::all_of(jobs.begin(), jobs.end(),
                  [](const RenderJob& job) { return is_turned(job.angle); });
  check_hint(look, all_turned, "the angle of every job");
  std::map<std::string, std::string> texts;
  for (const RenderJob& job : jobs) {
    texts[job.font] += job.text;
  }
  // An option is not in vain if one of the fonts is converted.
  Conversion shared = conversion;
  for (const auto& entry : texts) {
    if (!is_rom_font(read_file(entry.first))) {
      shared.option.clear();
    }
  }
  std::map<std::string, RomFile> fonts;
  for (const auto& [file, text] : texts) {
    fonts.emplace(file, load_font_file(file, shared, text));
  }
  std::vector<SampleTotal> costs(jobs.size());
  parallel_for(jobs.size(), 0, [&](size_t i) {
    try {
      costs[i] = render(jobs[i], fonts.at(jobs[i].font).font(), look, inverted);
    } catch (const std::exception& error) {
      throw std::runtime_error("job " + std::to_string(i + 1) + " (" +
                               jobs[i].out + "): " + error.what());
    }
  });
  SampleTotal total;
  for (const SampleTotal& cost : costs) {
    total.pixels += cost.pixels;
    total.samples += cost.samples;
    total.uses_radius |= cost.uses_radius;
  }
  check_radius(look, total.uses_radius);
  return total;
}

}  // namespace inkcell::tools
