// Reads UFO 3 folders.
#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "model/error.hpp"
#include "ufo/glif.hpp"
#include "ufo/plist.hpp"
#include "ufo/ufo.hpp"

namespace inkcell::design {
namespace {

namespace fs = std::filesystem;

class Reader {
 public:
  explicit Reader(const fs::path& folder) { files_.folder = folder; }

  UfoFiles read() {
    if (!fs::is_directory(files_.folder)) {
      throw Error(files_.folder.string() +
                  ": is no folder; a project is a UFO 3 folder, such as "
                  "My-Font.ufo");
    }
    check_version();
    FontData font;
    font.info = dictionary("fontinfo.plist");
    font.groups = dictionary("groups.plist");
    font.kerning = dictionary("kerning.plist");
    font.lib = dictionary("lib.plist");
    load("features.fea", font.features);
    read_layers();
    read_images(font.images);
    files_.project.font = std::make_shared<const FontData>(std::move(font));
    find_foreign();
    return std::move(files_);
  }

 private:
  std::string path_of(const std::string& file) const {
    return (files_.folder / file).string();
  }

  // False if there is no such file.
  bool load(const std::string& file, std::string& text) {
    std::ifstream in(files_.folder / file, std::ios::binary);
    if (!in) {
      return false;
    }
    std::ostringstream all;
    all << in.rdbuf();
    text = all.str();
    files_.texts[file] = text;
    return true;
  }

  Value dictionary(const std::string& file) {
    std::string text;
    if (!load(file, text)) {
      return Value::object();
    }
    Value value = parse_plist(text, path_of(file));
    if (!value.is_object()) {
      throw Error(path_of(file) + ": is no dictionary");
    }
    return value;
  }

  void check_version() {
    const Value meta = dictionary("metainfo.plist");
    const auto version = meta.find("formatVersion");
    if (version == meta.end() || *version != 3) {
      throw Error(path_of("metainfo.plist") +
                  (version == meta.end()
                       ? std::string(": does not say what format it is")
                       : ": format version " + version->dump()) +
                  "; only UFO 3 can be read, convert the project with the "
                  "editor that made it");
    }
  }

  void read_layers() {
    std::string text;
    Value list = {{"public.default", "glyphs"}};
    if (load("layercontents.plist", text)) {
      list = parse_plist(text, path_of("layercontents.plist"));
    }
    std::vector<Layer> layers;
    for (const Value& entry : list) {
      if (!entry.is_array() || entry.size() != 2 || !entry[0].is_string() ||
          !entry[1].is_string()) {
        throw Error(path_of("layercontents.plist") +
                    ": lists pairs of a name and a folder");
      }
      layers.push_back(
          read_layer(entry[0].get<std::string>(), entry[1].get<std::string>()));
    }
    // The folder name tells the default layer.
    const auto front =
        std::find_if(layers.begin(), layers.end(),
                     [](const Layer& l) { return l.folder == "glyphs"; });
    if (front == layers.end()) {
      throw Error(path_of("layercontents.plist") +
                  ": names no default layer, whose folder is glyphs");
    }
    std::rotate(layers.begin(), front, front + 1);
    files_.project.layers = std::move(layers);
  }

  Layer read_layer(const std::string& name, const std::string& folder) {
    Layer layer;
    layer.name = name;
    layer.folder = folder;
    layer.info = dictionary(folder + "/layerinfo.plist");
    const std::string contents = folder + "/contents.plist";
    const Value names = dictionary(contents);
    for (const auto& [glyph, file] : names.items()) {
      if (!file.is_string()) {
        throw Error(path_of(contents) + ": the glyph '" + glyph +
                    "' has no file");
      }
      const std::string path = folder + "/" + file.get<std::string>();
      std::string text;
      if (!load(path, text)) {
        throw Error(path_of(path) + ": is missing; " + contents +
                    " lists it for the glyph '" + glyph + "'");
      }
      Glyph parsed = parse_glif(text, path_of(path));
      parsed.name = glyph;  // contents.plist decides
      layer.glyphs[glyph] = std::make_shared<const Glyph>(std::move(parsed));
      files_.glyph_files[folder][glyph] = file.get<std::string>();
    }
    return layer;
  }

  // A missing picture does not matter until it is shown.
  void read_images(Images& images) {
    for (const std::string& name : image_names(files_.project)) {
      std::string text;
      if (name.find('/') == std::string::npos && load("images/" + name, text)) {
        images[name] = std::make_shared<const std::vector<uint8_t>>(
            text.begin(), text.end());
      }
    }
  }

  void find_foreign() {
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(files_.folder)) {
      const std::string path =
          fs::relative(entry.path(), files_.folder).generic_string();
      if (entry.is_regular_file() && files_.texts.count(path) == 0) {
        files_.foreign.push_back(path);
      }
    }
    std::sort(files_.foreign.begin(), files_.foreign.end());
  }

  UfoFiles files_;
};

}  // namespace

UfoFiles read_ufo(const fs::path& folder) {
  return Reader(folder).read();
}

}  // namespace inkcell::design
