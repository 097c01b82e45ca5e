// Reads job files and draws their pictures on all cores.
#include "render_jobs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <new>
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

// Calls work() and prefixes errors with the place, FILE:LINE.
template <typename Work>
auto at_place(const std::string& place, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw std::runtime_error(place + ": there is not enough memory for that");
  } catch (const std::exception& error) {
    throw std::runtime_error(place + ": " + error.what());
  }
}

// A key of a job, its allowed values, and its parser, which returns false for
// others.
struct JobKey {
  const char* name;
  const char* wanted;
  bool (*read)(const Json& value, RenderJob& job);
  bool is_needed = false;
};

template <double RenderJob::*kMember>
bool read_number(const Json& value, RenderJob& job) {
  if (!value.is_number()) {  // Json would convert true to 1
    return false;
  }
  value.get_to(job.*kMember);
  return true;
}

template <int RenderJob::*kMember>
bool read_side(const Json& value, RenderJob& job) {
  const double side = value.is_number() ? value.get<double>() : 0;
  if (side < 1 || side > kMaxSide || side != std::floor(side)) {
    return false;
  }
  job.*kMember = static_cast<int>(side);
  return true;
}

bool read_text(const Json& value, RenderJob& job) {
  if (!value.is_string()) {
    return false;
  }
  value.get_to(job.text);
  return true;
}

template <std::string RenderJob::*kMember>
bool read_file_name(const Json& value, RenderJob& job) {
  if (!value.is_string()) {
    return false;
  }
  value.get_to(job.*kMember);
  // The system would end a name at a zero byte.
  return !(job.*kMember).empty() &&
         (job.*kMember).find('\0') == std::string::npos;
}

bool read_kind(const Json& value, RenderJob& job) {
  if (value != "static" && value != "anim") {
    return false;
  }
  job.use = value == "anim" ? Use::moving : Use::still;
  return true;
}

constexpr const char* kSide = "a whole number of 1 to 32767 px";
constexpr const char* kFileName = "the name of a file in double quotes";
constexpr const char* kPixels = "a number of px";
constexpr const char* kParts = "a number of 1/64 px";
constexpr bool kNeeded = true;
constexpr JobKey kJobKeys[] = {
    {"font", kFileName, read_file_name<&RenderJob::font>, kNeeded},
    {"text", "a text in double quotes", read_text, kNeeded},
    {"size", "a number of px/em", read_number<&RenderJob::size>, kNeeded},
    {"w", kSide, read_side<&RenderJob::w>, kNeeded},
    {"h", kSide, read_side<&RenderJob::h>, kNeeded},
    {"out", kFileName, read_file_name<&RenderJob::out>, kNeeded},
    {"ox", kPixels, read_number<&RenderJob::ox>},
    {"oy", kPixels, read_number<&RenderJob::oy>},
    {"dx", kParts, read_number<&RenderJob::dx>},
    {"dy", kParts, read_number<&RenderJob::dy>},
    {"angle", "a number of degrees", read_number<&RenderJob::angle>},
    {"kind", "\"static\" or \"anim\"", read_kind}};

constexpr const char* kOneLine = "write each job as one {...} on one line";

[[noreturn]] void refuse_other_kind() {
  throw std::runtime_error(std::string("is no JSON object; ") + kOneLine);
}

// Whether two words differ by one letter, or by two swapped letters.
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
  // Short names are similar to too many others.
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

[[noreturn]] void refuse_value(const std::string& name,
                               const std::string& value) {
  const JobKey& key = job_key(name);
  throw std::runtime_error(std::string("key '") + key.name + "' must be " +
                           key.wanted + ", not " + value);
}

void read_value(const std::string& name, const Json& value, RenderJob& job) {
  if (!job_key(name).read(value, job)) {
    refuse_value(name, value.is_object()  ? "an object"
                       : value.is_array() ? "an array"
                                          : value.dump());
  }
}

// What was parsed of a line before the error.
struct Met {
  std::set<std::string> keys;
  std::string key;         // the last one
  bool is_object = false;  // it began with {
};

bool meet(int depth, Json::parse_event_t event, const Json& parsed, Met& met) {
  if (depth == 0) {
    met.is_object |= event == Json::parse_event_t::object_start;
  } else if (depth == 1 && event == Json::parse_event_t::key) {
    parsed.get_to(met.key);
    if (!met.keys.insert(met.key).second) {
      throw std::runtime_error("key '" + met.key + "' stands twice");
    }
  }
  return true;
}

// The position and the reason of a syntax error, without the line's text, which
// may not be UTF-8.
std::string fault_of(const Json::parse_error& error) {
  const std::string what = error.what();
  const size_t column = what.find("column ");
  const size_t begin = column == std::string::npos ? 0 : column;
  return what.substr(begin, what.find("; last read", begin) - begin);
}

Json parse_line(const std::string& line) {
  Met met;
  try {
    return Json::parse(
        line, [&met](int depth, Json::parse_event_t event, Json& parsed) {
          return meet(depth, event, parsed, met);
        });
  } catch (const Json::parse_error& error) {
    if (!met.is_object) {
      refuse_other_kind();
    }
    throw std::runtime_error(fault_of(error) + "; " + kOneLine);
  } catch (const Json::out_of_range&) {  // of a number
    if (!met.is_object) {
      refuse_other_kind();
    }
    refuse_value(met.key, "one beyond 1e308");
  }
}

RenderJob read_job(const std::string& line) {
  const Json json = parse_line(line);
  if (!json.is_object()) {
    refuse_other_kind();
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

// The files and their uses, by identity: a file can have several names, also by
// links.
class Files {
 public:
  /// Adds a file. Returns its use if it is there already, else "".
  std::string add(const std::filesystem::path& name, const std::string& use) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path absolute = fs::absolute(name, error).lexically_normal();
    fs::path path = fs::weakly_canonical(absolute, error);
    if (error) {
      path = absolute;
    }
    const auto [known, is_new] = uses_.emplace(path, use);
    if (!is_new) {
      return known->second;
    }
    const auto links = fs::hard_link_count(path, error);
    if (!error && links > 1) {
      for (const auto& [other, other_use] : linked_) {
        if (fs::equivalent(path, other, error)) {
          return other_use;
        }
      }
      linked_.emplace(path, use);
    }
    return {};
  }

 private:
  std::map<std::filesystem::path, std::string> uses_;
  std::map<std::filesystem::path, std::string> linked_;  // with hard links
};

// Refuses pictures that would replace each other, or an input file.
void check_outputs(const std::filesystem::path& file,
                   const std::vector<RenderJob>& jobs) {
  Files files;
  files.add(file, "is the file of the jobs");
  for (const RenderJob& job : jobs) {
    files.add(job.font, "is the font of " + job.place);
  }
  for (const RenderJob& job : jobs) {
    const std::string use =
        files.add(job.out, "is the picture of " + job.place);
    if (!use.empty()) {
      throw std::runtime_error(job.place + ": key 'out': " + job.out + " " +
                               use + "; name another file");
    }
  }
}

SampleTotal render(const RenderJob& job,
                   const Font& font,
                   const LookOptions& options,
                   Kerning kerning,
                   bool inverted) {
  const Look look(options, font, job.size, job.angle, job.use);
  Image image(job.w, job.h, look.channels());
  draw_lines(font, {lay_out(font, job.text, kerning, look.style())},
             look.style(),
             make_point(job.ox + job.dx / 64, job.oy + job.dy / 64), image);
  SampleTotal total;
  add_samples(image, look, total);
  round_to_levels(image, options.levels);
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
  if (look.style().effect() != nullptr && !look.counts_samples()) {
    return;
  }
  // First along rows, then along columns: a disc is a square without its
  // corners, which the remaining distance cuts off.
  std::vector<int> distances(static_cast<size_t>(image.width) *
                             static_cast<size_t>(image.height));
  const auto at = [&](int x, int y) -> int& {
    return distances[static_cast<size_t>(y) * static_cast<size_t>(image.width) +
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
    line.erase(line.find_last_not_of(" \t\r") + 1);
    if (line.empty()) {
      continue;
    }
    const std::string place = file.string() + ":" + std::to_string(number);
    jobs.push_back(at_place(place, [&line] { return read_job(line); }));
    jobs.back().place = place;
  }
  if (jobs.empty()) {
    throw std::runtime_error(
        file.string() +
        ": holds no jobs; write each as a JSON object on one line, with the "
        "keys that --help lists");
  }
  check_outputs(file, jobs);
  return jobs;
}

SampleTotal render_jobs(const std::vector<RenderJob>& jobs,
                        const Conversion& conversion,
                        const LookOptions& look,
                        Kerning kerning,
                        bool inverted) {
  const bool all_turned =
      std::all_of(jobs.begin(), jobs.end(), [](const RenderJob& job) {
        return at_place(job.place, [&job] { return is_turned(job.angle); });
      });
  check_hint(look, all_turned, "the angle of every job");
  struct FontUse {
    std::string place;  // of the first job that reads it
    std::string text;
  };
  std::map<std::string, FontUse> uses;
  for (const RenderJob& job : jobs) {
    at_place(job.place,
             [&] { check_image_file(job.out, look.lcd == "none" ? 1 : 3); });
    uses.emplace(job.font, FontUse{job.place, {}}).first->second.text +=
        job.text;
  }
  // Options of conversion are used if one of the fonts is converted.
  Conversion shared = conversion;
  std::map<std::string, RomFile> fonts;
  for (const auto& entry : uses) {
    at_place(entry.second.place, [&] {
      if (!is_rom_font(read_file(entry.first))) {
        shared.option.clear();
      }
    });
  }
  for (const auto& entry : uses) {
    at_place(entry.second.place, [&] {
      fonts.emplace(entry.first,
                    load_font_file(entry.first, shared, entry.second.text));
    });
  }
  std::vector<SampleTotal> costs(jobs.size());
  parallel_for(jobs.size(), 0, [&](size_t i) {
    costs[i] = at_place(jobs[i].place, [&] {
      return render(jobs[i], fonts.at(jobs[i].font).font(), look, kerning,
                    inverted);
    });
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
