// The picture behind a glyph. A font keeps only pictures that its glyphs use.
#include <algorithm>

#include "model/base64.hpp"
#include "model/command_table.hpp"

namespace inkcell::design {
namespace {

constexpr uint8_t kPngBegin[] = {0x89, 'P', 'N', 'G'};

void check_name(const std::string& name, const Arguments& arguments) {
  const std::string ending = ".png";
  const bool ok = name.size() > ending.size() && name[0] != '.' &&
                  name.find_first_of("/\\") == std::string::npos &&
                  name.substr(name.size() - ending.size()) == ending;
  if (!ok) {
    arguments.refuse("\"file\" is '" + name +
                     "'; it is the name of a PNG in the folder images, such "
                     "as a.png");
  }
}

ImageBytes parse_data(const Arguments& arguments) {
  std::vector<uint8_t> bytes = decode_base64(arguments.text("data"));
  if (bytes.size() < sizeof kPngBegin ||
      !std::equal(std::begin(kPngBegin), std::end(kPngBegin), bytes.begin())) {
    arguments.refuse("\"data\" is no PNG in Base64");
  }
  return std::make_shared<const std::vector<uint8_t>>(std::move(bytes));
}

// The pictures of the font, and the one in the command.
Images with_data(const Project& project,
                 const std::string& name,
                 const Arguments& arguments) {
  Images images = project.font->images;
  const auto known = images.find(name);
  if (!arguments.has("data")) {
    if (known == images.end()) {
      arguments.refuse("images/" + name +
                       " is missing; give its bytes in Base64 as \"data\"");
    }
    return images;
  }
  const ImageBytes bytes = parse_data(arguments);
  if (known != images.end() && *known->second != *bytes) {
    arguments.refuse("images/" + name +
                     " is another picture already; choose another name");
  }
  images.emplace(name, bytes);
  return images;
}

// Keeps the `images` that a glyph still uses after `change`.
void keep_named(const Project& project, const Images& images, Change& change) {
  Project after = project;
  after.apply(change);
  const std::set<std::string> names = image_names(after);
  Images named;
  for (const auto& [name, bytes] : images) {
    if (names.count(name) != 0) {
      named.emplace(name, bytes);
    }
  }
  if (named != project.font->images) {
    FontData data = *project.font;
    data.images = std::move(named);
    change.font_before = project.font;
    change.font_after = std::make_shared<const FontData>(std::move(data));
  }
}

Change set_image(const Project& project, const Arguments& arguments) {
  Images images = project.font->images;
  std::optional<GlyphImage> image;
  if (arguments.has("file")) {
    image = GlyphImage{arguments.text("file"), arguments.matrix("matrix"),
                       arguments.text("color", "")};
    check_name(image->file, arguments);
    images = with_data(project, image->file, arguments);
  }
  Change change = edited(project, arguments,
                         [&image](Glyph& glyph) { glyph.image = image; });
  keep_named(project, images, change);
  return change;
}

}  // namespace

void drop_unnamed_images(const Project& project, Change& change) {
  keep_named(project, project.font->images, change);
}

void add_image_commands(CommandTable& table) {
  table["set_image"] = set_image;
}

}  // namespace inkcell::design
