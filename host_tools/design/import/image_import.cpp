#include "import/image_import.hpp"

#include "bitmap/bitmap.hpp"
#include "model/base64.hpp"
#include "rom_file.hpp"

namespace inkcell::design {
namespace {

constexpr double kUsualDescender = -0.2;  // [em]

// The file's name, with a number if another picture has it.
std::string free_name(const Images& images,
                      const std::filesystem::path& file,
                      const std::vector<uint8_t>& bytes) {
  const std::string stem = file.stem().string();
  std::string name = stem + ".png";
  for (int number = 2;; ++number) {
    const auto known = images.find(name);
    if (known == images.end() || *known->second == bytes) {
      return name;
    }
    name = stem + std::to_string(number) + ".png";
  }
}

}  // namespace

Value image_command(const Project& project, const std::filesystem::path& file) {
  const std::vector<uint8_t> bytes = tools::read_file(file);
  const Bitmap bitmap = parse_png(bytes, file.string());
  const double em = project.units_per_em();
  const Value& info = project.font->info;
  const double bottom = info.value("descender", kUsualDescender * em);
  return {{"do", "set_image"},
          {"file", free_name(project.font->images, file, bytes)},
          {"data", encode_base64(bytes)},
          {"matrix", {{"scale", em / bitmap.height}, {"move", {0.0, bottom}}}}};
}

}  // namespace inkcell::design
