// Makes fonts in a background thread.
#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "rom_file.hpp"

namespace inkcell::tools {

/// The font to make: its coding, and a text with its characters.
struct FontWish {
  std::string coding;
  std::string text;
  std::string morphs;  // pairs that it holds, as --morph takes them

  bool operator==(const FontWish& other) const {
    return coding == other.coding && text == other.text &&
           morphs == other.morphs;
  }
};

/// Makes one font at a time.
class FontWorker {
 public:
  /// Called with the glyphs done and their total number; throws to stop.
  using Progress = std::function<void(size_t done, size_t count)>;
  /// Runs on a thread of its own. May throw.
  using Maker = std::function<RomFile(const FontWish& wish, const Progress&)>;

  explicit FontWorker(Maker make) : make_(std::move(make)) {}
  /// Stops running work.
  ~FontWorker();
  FontWorker(const FontWorker&) = delete;
  FontWorker& operator=(const FontWorker&) = delete;

  /// The font, if it is ready. The first call starts the work; another wish
  /// stops it and starts anew. Throws what the maker threw.
  std::optional<RomFile> take(const FontWish& wish);

  struct Work {
    std::string coding;
    size_t done = 0;   // glyphs
    size_t count = 0;  // 0: not known yet
  };
  /// Progress of running work.
  std::optional<Work> work() const;

 private:
  struct Job {
    FontWish wish;
    std::atomic<bool> is_dropped{false};
    std::atomic<size_t> done{0};
    std::atomic<size_t> count{0};
    std::future<RomFile> result;
  };

  void begin(const FontWish& wish);

  Maker make_;
  std::unique_ptr<Job> job_;
};

}  // namespace inkcell::tools
