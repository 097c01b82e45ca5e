// Writes UFO 3 folders, completely or not at all.
#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <cstring>
#include <set>

#include "model/error.hpp"
#include "ufo/file_names.hpp"
#include "ufo/glif.hpp"
#include "ufo/plist.hpp"
#include "ufo/ufo.hpp"

namespace inkcell::design {
namespace {

namespace fs = std::filesystem;
using Texts = std::map<std::string, std::string>;

// Reuses the old text if its data is unchanged.
class Writer {
 public:
  Writer(const Project& project, const UfoFiles& files)
      : project_(project), files_(files) {}

  Texts write() {
    const FontData& now = *project_.font;
    const FontData& then = *files_.project.font;
    put("metainfo.plist", true, [] {
      return write_plist(
          {{"creator", "org.inkcell.design"}, {"formatVersion", 3u}});
    });
    put_dictionary("fontinfo.plist", now.info, then.info);
    put_dictionary("groups.plist", now.groups, then.groups);
    put_dictionary("kerning.plist", now.kerning, then.kerning);
    put_dictionary("lib.plist", now.lib, then.lib);
    if (!now.features.empty()) {
      texts_["features.fea"] = now.features;
    }
    put("layercontents.plist", same_layers(), [this] {
      Value list = Value::array();
      for (const Layer& layer : project_.layers) {
        list.push_back({layer.name, layer.folder});
      }
      return write_plist(list);
    });
    for (const Layer& layer : project_.layers) {
      put_layer(layer);
    }
    for (const auto& [name, bytes] : now.images) {
      texts_["images/" + name].assign(bytes->begin(), bytes->end());
    }
    return std::move(texts_);
  }

 private:
  template <typename Make>
  void put(const std::string& file, bool same, const Make& make) {
    const auto old = files_.texts.find(file);
    texts_[file] = same && old != files_.texts.end() ? old->second : make();
  }

  void put_dictionary(const std::string& file,
                      const Value& now,
                      const Value& then) {
    if (!now.empty() || (now == then && files_.texts.count(file) != 0)) {
      put(file, now == then, [&now] { return write_plist(now); });
    }
  }

  bool same_layers() const {
    const std::vector<Layer>& old = files_.project.layers;
    bool same = old.size() == project_.layers.size();
    for (size_t i = 0; same && i < old.size(); ++i) {
      same = old[i].name == project_.layers[i].name &&
             old[i].folder == project_.layers[i].folder;
    }
    return same;
  }

  const Layer* old_layer(const std::string& folder) const {
    for (const Layer& layer : files_.project.layers) {
      if (layer.folder == folder) {
        return &layer;
      }
    }
    return nullptr;
  }

  void put_layer(const Layer& layer) {
    static const Layer kNone;
    const Layer* found = old_layer(layer.folder);
    const Layer& old = found != nullptr ? *found : kNone;
    put_dictionary(layer.folder + "/layerinfo.plist", layer.info, old.info);
    const std::map<std::string, std::string> names = file_names(layer);
    bool same = old.glyphs.size() == layer.glyphs.size();
    Value contents = Value::object();
    for (const auto& [name, glyph] : layer.glyphs) {
      const std::string& file = names.at(name);
      const auto before = old.glyphs.find(name);
      same = same && before != old.glyphs.end();
      contents[name] = file;
      put(layer.folder + "/" + file,
          before != old.glyphs.end() &&
              (before->second == glyph || *before->second == *glyph),
          [glyph = glyph] { return write_glif(*glyph); });
    }
    put(layer.folder + "/contents.plist", same,
        [&contents] { return write_plist(contents); });
  }

  // A glyph keeps its file.
  std::map<std::string, std::string> file_names(const Layer& layer) const {
    std::map<std::string, std::string> names;
    std::set<std::string> taken;
    const auto old = files_.glyph_files.find(layer.folder);
    if (old != files_.glyph_files.end()) {
      for (const auto& [name, file] : old->second) {
        if (layer.glyphs.count(name) != 0) {
          names[name] = file;
          std::string lower = file;
          for (char& c : lower) {
            c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
          }
          taken.insert(lower);
        }
      }
    }
    for (const auto& [name, glyph] : layer.glyphs) {
      if (names.count(name) == 0) {
        names[name] = glif_file_name(name, taken);
      }
    }
    return names;
  }

  const Project& project_;
  const UfoFiles& files_;
  Texts texts_;
};

[[noreturn]] void fail(const fs::path& file, const char* what) {
  throw Error(file.string() + ": cannot be " + what + ": " +
              std::strerror(errno));
}

// `flush` is fsync() for the names in a folder, or syncfs() for all files of
// the file system: one wait instead of one for each file.
void flush_to_disk(const fs::path& path, int (*flush)(int)) {
  const int handle = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (handle < 0) {
    fail(path, "flushed to the disk");
  }
  const int result = flush(handle);
  ::close(handle);
  if (result != 0) {
    fail(path, "flushed to the disk");
  }
}

void write_file(const fs::path& file, const std::string& text) {
  const int handle =
      ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (handle < 0) {
    fail(file, "made");
  }
  size_t done = 0;
  while (done < text.size()) {
    const ssize_t count =
        ::write(handle, text.data() + done, text.size() - done);
    if (count < 0) {
      ::close(handle);
      fail(file, "written");
    }
    done += static_cast<size_t>(count);
  }
  if (::close(handle) != 0) {
    fail(file, "written");
  }
}

// Replaces `folder` by `fresh`; at every moment one of the two exists.
void swap_in(const fs::path& fresh, const fs::path& folder) {
  if (!fs::exists(folder)) {
    fs::rename(fresh, folder);
  } else if (::renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, folder.c_str(),
                         RENAME_EXCHANGE) == 0) {
    fs::remove_all(fresh);
  } else {
    fail(folder, "replaced");
  }
  flush_to_disk(folder.parent_path().empty() ? "." : folder.parent_path(),
                ::fsync);
}

}  // namespace

Texts ufo_texts(const Project& project, const UfoFiles& files) {
  return Writer(project, files).write();
}

std::string digest_of(const Texts& texts) {
  uint64_t hash = 0xcbf29ce484222325;  // FNV-1a, 64 bits
  const auto add = [&hash](const std::string& text) {
    for (const char c : text) {
      hash = (hash ^ static_cast<uint8_t>(c)) * 0x100000001b3;
    }
    hash = (hash ^ 0xff) * 0x100000001b3;  // no byte of UTF-8
  };
  for (const auto& [file, text] : texts) {
    add(file);
    add(text);
  }
  char digits[24];
  std::snprintf(digits, sizeof digits, "%016llx",
                static_cast<unsigned long long>(hash));
  return digits;
}

void write_ufo(const Project& project,
               const fs::path& folder,
               UfoFiles& files) {
  const Texts texts = ufo_texts(project, files);
  std::vector<std::string> foreign;
  for (const std::string& file : files.foreign) {
    if (texts.count(file) == 0) {  // else a picture replaced it
      foreign.push_back(file);
    }
  }
  fs::path fresh = folder;
  fresh += ".saving";
  try {
    fs::remove_all(fresh);
    for (const auto& [file, text] : texts) {
      fs::create_directories((fresh / file).parent_path());
      write_file(fresh / file, text);
    }
    for (const std::string& file : foreign) {
      fs::create_directories((fresh / file).parent_path());
      fs::copy_file(files.folder / file, fresh / file,
                    fs::copy_options::overwrite_existing);
    }
    flush_to_disk(fresh, ::syncfs);
    swap_in(fresh, folder);
  } catch (const fs::filesystem_error& error) {
    throw Error(folder.string() +
                ": cannot be saved: " + error.code().message());
  }
  files.texts = texts;
  files.folder = folder;
  files.foreign = std::move(foreign);
  files.project = project;
  files.glyph_files.clear();
  for (const Layer& layer : project.layers) {
    const Value names =
        parse_plist(texts.at(layer.folder + "/contents.plist"), "contents");
    for (const auto& [name, file] : names.items()) {
      files.glyph_files[layer.folder][name] = file.get<std::string>();
    }
  }
}

}  // namespace inkcell::design
