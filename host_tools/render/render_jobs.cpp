// Reads job files and draws their pictures on all cores.
#include "render_jobs.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "canvas.hpp"
#include "convert.hpp"
#include "parallel.hpp"

namespace inkcell::tools {
namespace {

using Json = nlohmann::json;

// A key of a job, and how its value is read.
struct JobKey {
  const char* name;
  void (*read)(const Json& value, RenderJob& job);
  bool is_needed = false;
};

template <auto kMember>
void read_member(const Json& value, RenderJob& job) {
  value.get_to(job.*kMember);
}

void read_kind(const Json& value, RenderJob& job) {
  const auto kind = value.get<std::string>();
  if (kind != "static" && kind != "anim") {
    throw std::runtime_error("kind '" + kind + "' is not static or anim");
  }
  job.use = kind == "anim" ? Use::moving : Use::still;
}

constexpr bool kNeeded = true;
constexpr JobKey kJobKeys[] = {{"font", read_member<&RenderJob::font>, kNeeded},
                               {"text", read_member<&RenderJob::text>, kNeeded},
                               {"size", read_member<&RenderJob::size>, kNeeded},
                               {"w", read_member<&RenderJob::w>, kNeeded},
                               {"h", read_member<&RenderJob::h>, kNeeded},
                               {"out", read_member<&RenderJob::out>, kNeeded},
                               {"ox", read_member<&RenderJob::ox>},
                               {"oy", read_member<&RenderJob::oy>},
                               {"dx", read_member<&RenderJob::dx>},
                               {"dy", read_member<&RenderJob::dy>},
                               {"angle", read_member<&RenderJob::angle>},
                               {"kind", read_kind}};

// Whether two words differ by one letter, or by two that changed places.
bool is_slip(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty() && a.front() == b.front()) {
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  while (!a.empty() && !b.empty() && a.back() == b.back()) {
    a.remove_suffix(1);
    b.remove_suffix(1);
  }
  const bool is_swap =
      a.size() == 2 && b.size() == 2 && a[0] == b[1] && a[1] == b[0];
  return is_swap || (a.size() <= 1 && b.size() <= 1);
}

[[noreturn]] void refuse_key(const std::string& name) {
  // Short names are near to too many others.
  constexpr size_t kLeastLetters = 3;
  std::string names;
  std::string meant;
  for (const JobKey& key : kJobKeys) {
    names += std::string(" ") + key.name;
    if (name.size() >= kLeastLetters && is_slip(name, key.name)) {
      meant = std::string(", '") + key.name + "' may be meant";
    }
  }
  throw std::runtime_error("key '" + name + "' is unknown" + meant +
                           "; there are:" + names);
}

const JobKey& job_key(const std::string& name) {
  for (const JobKey& key : kJobKeys) {
    if (key.name == name) {
      return key;
    }
  }
  refuse_key(name);
}

void read_value(const std::string& name, const Json& value, RenderJob& job) {
  const JobKey& key = job_key(name);
  try {
    key.read(value, job);
  } catch (const Json::type_error&) {
    throw std::runtime_error("key '" + name + "' cannot be of type " +
                             value.type_name());
  }
}

RenderJob read_job(const std::string& line) {
  std::set<std::string> names;
  const auto meet = [&names](int depth, Json::parse_event_t event,
                             Json& parsed) {
    if (depth == 1 && event == Json::parse_event_t::key &&
        !names.insert(parsed.get<std::string>()).second) {
      throw std::runtime_error("key '" + parsed.get<std::string>() +
                               "' stands twice");
    }
    return true;
  };
  const Json json = Json::parse(line, meet);
  if (!json.is_object()) {
    throw std::runtime_error("is no JSON object");
  }
  RenderJob job;
  for (const auto& [name, value] : json.items()) {
    read_value(name, value, job);
  }
  for (const JobKey& key : kJobKeys) {
    if (key.is_needed && !json.contains(key.name)) {
      throw std::runtime_error(std::string("key '") + key.name +
                               "' is missing");
    }
  }
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
