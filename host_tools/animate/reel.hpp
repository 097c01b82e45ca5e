// The reel: a word goes through scenes, on a watch and on e-paper.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "image.hpp"
#include "player.hpp"

namespace inkcell::tools {

/// Six seconds that repeat without a seam.
class Reel {
 public:
  static constexpr int kWidth = 656;  // [px]
  static constexpr int kHeight = 300;
  static constexpr int kWatch = 240;
  static constexpr uint32_t kFrames = 180;
  static constexpr const char* kWord = "Inkcell";

  /// The word is of `font`, which must outlive the reel as `labels` must, the
  /// font of all else. Throws std::runtime_error if a scene does not take the
  /// word, or there are no figures of it.
  Reel(const Font& font, const std::string& word, const Font& labels);

  Image draw(uint32_t frame);

  /// Which scene it shows, from 0.
  static size_t window_of(uint32_t frame);

 private:
  /// A scene, and what stands still while it plays.
  struct Shown {
    std::string text;
    Rect screen = {0, 0, kWatch, kWatch};  // on the watch
    std::unique_ptr<Player> player;
    Image around;
  };
  std::vector<Shown> shown_;
};

}  // namespace inkcell::tools
