#include "export/rom.hpp"

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <string>
#include <system_error>

#include "app/output.hpp"

namespace inkcell::design {
namespace {

namespace fs = std::filesystem;

// A file that is deleted at the end.
class TemporaryFile {
 public:
  TemporaryFile() {
    static std::atomic<unsigned> number{0};
    path_ = fs::temp_directory_path() /
            ("inkcell-design-" + std::to_string(::getpid()) + "-" +
             std::to_string(number++) + ".ttf");
  }
  ~TemporaryFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

gen::RomFont make_rom(const Project& project,
                      gen::GenerateRequest request,
                      TtfReport* report) {
  const TemporaryFile file;
  write_bytes(file.path(), write_ttf(project, report));
  request.font = file.path();
  if (request.chars.empty() && request.symbols.empty() &&
      request.text_files.empty()) {
    for (const auto& [name, glyph] : project.front().glyphs) {
      if (name[0] == '_') {
        continue;
      }
      for (const char32_t c : glyph->unicodes) {
        request.chars.push_back(std::to_string(static_cast<uint32_t>(c)));
      }
    }
  }
  return gen::generate(request);
}

void write_bytes(const fs::path& file, const std::vector<uint8_t>& bytes) {
  gen::OutputFile out(file);
  out.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  out.commit();
}

}  // namespace inkcell::design
