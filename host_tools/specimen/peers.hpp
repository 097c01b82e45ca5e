// Text drawn by others: supersampled, and by FreeType.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "image.hpp"

namespace inkcell::tools {

enum class Peer {
  box4,      // 2 x 2 samples a pixel, averaged
  gauss16,   // 4 x 4 a pixel, weights 2^(-3 d^2) up to d = 1 px
  freetype,  // exact coverage, not hinted
  light,     // exact coverage, heights hinted by FreeType's autohinter
};

/// Weights of samples at (x, y) from a pixel's centre [px]: a box, and 2^(-3
/// d^2) up to d = 1 px.
double box_weight(double x, double y);
double gaussian_weight(double x, double y);

/// A corner of a polygon, y down. [px]
struct PeerCorner {
  double x = 0;
  double y = 0;
};

/// The exact coverage of polygons, by FreeType. Throws std::runtime_error.
Image fill_polygons(const std::vector<std::vector<PeerCorner>>& polygons,
                    int width,
                    int height);

/// A font file, read by FreeType. Glyphs are placed by unhinted advances, with
/// kerning from the kern table, at fractions of a pixel.
class PeerFont {
 public:
  /// Throws std::runtime_error.
  explicit PeerFont(const std::filesystem::path& file);
  ~PeerFont();
  PeerFont(const PeerFont&) = delete;
  PeerFont& operator=(const PeerFont&) = delete;

  /// Draws ASCII text over a grey picture (255: full ink), its origin at (x,
  /// y). [px]
  void write(Peer peer,
             const std::string& text,
             double px,
             double x,
             double y,
             Image& image);

 private:
  friend Image fill_polygons(const std::vector<std::vector<PeerCorner>>&,
                             int,
                             int);
  struct Library;
  std::unique_ptr<Library> library_;
};

}  // namespace inkcell::tools
