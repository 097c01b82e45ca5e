// Draws outlines by FreeType, and samples them.
#include "peers.hpp"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace inkcell::tools {
namespace {

void require(FT_Error error, const std::string& what) {
  if (error != 0) {
    throw std::runtime_error(what + ": FreeType error " +
                             std::to_string(error));
  }
}

// The outline's ink on a bitmap as large as the picture, times `scale`.
std::vector<uint8_t> render(FT_Library library,
                            FT_Outline& outline,
                            int width,
                            int height,
                            FT_Pixel_Mode mode) {
  std::vector<uint8_t> buffer(static_cast<size_t>(width) *
                              static_cast<size_t>(height));
  FT_Bitmap bitmap{};
  bitmap.width = static_cast<unsigned>(width);
  bitmap.rows = static_cast<unsigned>(height);
  bitmap.pixel_mode = static_cast<unsigned char>(mode);
  bitmap.num_grays = 256;
  bitmap.pitch = mode == FT_PIXEL_MODE_MONO ? (width + 7) / 8 : width;
  bitmap.buffer = buffer.data();
  outline.flags |= FT_OUTLINE_IGNORE_DROPOUTS;
  require(FT_Outline_Get_Bitmap(library, &outline, &bitmap), "drawing");
  return buffer;
}

// 1 where a sample is in the outline.
std::vector<uint8_t> sample(FT_Library library,
                            FT_Outline& outline,
                            int width,
                            int height) {
  const std::vector<uint8_t> bits =
      render(library, outline, width, height, FT_PIXEL_MODE_MONO);
  std::vector<uint8_t> samples;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int byte = bits[static_cast<size_t>(y * ((width + 7) / 8) + x / 8)];
      samples.push_back(static_cast<uint8_t>(byte >> (7 - x % 8) & 1));
    }
  }
  return samples;
}

// Samples, `scale` x `scale` to a pixel, weighed by w(distance in px).
template <typename Weight>
std::vector<uint8_t> filter(const std::vector<uint8_t>& samples,
                            const Image& image,
                            int scale,
                            const Weight& weight) {
  const int width = image.width * scale;
  const int height = image.height * scale;
  std::vector<uint8_t> grey;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      double sum = 0;
      double all = 0;
      for (int v = (y - 1) * scale; v < (y + 2) * scale; ++v) {
        for (int u = (x - 1) * scale; u < (x + 2) * scale; ++u) {
          const double w =
              weight((u + 0.5) / scale - x - 0.5, (v + 0.5) / scale - y - 0.5);
          all += w;
          if (u >= 0 && u < width && v >= 0 && v < height) {
            sum += w * samples[static_cast<size_t>(v * width + u)];
          }
        }
      }
      grey.push_back(static_cast<uint8_t>(std::lround(255 * sum / all)));
    }
  }
  return grey;
}

void lay_over(const std::vector<uint8_t>& grey, Image& image) {
  for (size_t i = 0; i < grey.size(); ++i) {
    const int old = image.pixels[i];
    image.pixels[i] =
        static_cast<uint8_t>(grey[i] + ((255 - grey[i]) * old + 127) / 255);
  }
}

}  // namespace

double box_weight(double x, double y) {
  return std::fabs(x) < 0.5 && std::fabs(y) < 0.5 ? 1 : 0;
}

double gaussian_weight(double x, double y) {
  const double square = x * x + y * y;
  return square <= 1 ? std::exp2(-3 * square) : 0;
}

struct PeerFont::Library {
  FT_Library library = nullptr;
  FT_Face face = nullptr;  // goes with the library

  Library() { require(FT_Init_FreeType(&library), "FreeType"); }
  ~Library() { FT_Done_FreeType(library); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

PeerFont::PeerFont(const std::filesystem::path& file)
    : library_(std::make_unique<Library>()) {
  require(
      FT_New_Face(library_->library, file.string().c_str(), 0, &library_->face),
      file.string());
}

PeerFont::~PeerFont() = default;

void PeerFont::write(Peer peer,
                     const std::string& text,
                     double px,
                     double x,
                     double y,
                     Image& image) {
  FT_Library library = library_->library;
  FT_Face face = library_->face;
  const int scale = peer == Peer::box4 ? 2 : peer == Peer::gauss16 ? 4 : 1;
  require(FT_Set_Char_Size(face, 0, std::lround(px * scale * 64), 72, 72),
          "size");
  FT_UInt previous = 0;
  for (const char character : text) {
    const FT_UInt glyph =
        FT_Get_Char_Index(face, static_cast<unsigned char>(character));
    FT_Vector kerning{};
    FT_Get_Kerning(face, previous, glyph, FT_KERNING_UNSCALED, &kerning);
    x += px * static_cast<double>(kerning.x) / face->units_per_EM;
    previous = glyph;
    require(FT_Load_Glyph(face, glyph,
                          peer == Peer::light
                              ? FT_LOAD_NO_BITMAP | FT_LOAD_TARGET_LIGHT |
                                    FT_LOAD_FORCE_AUTOHINT
                              : FT_LOAD_NO_BITMAP | FT_LOAD_NO_HINTING),
            text);
    FT_Outline& outline = face->glyph->outline;
    FT_Outline_Translate(&outline, std::lround(x * scale * 64),
                         std::lround((image.height - y) * scale * 64));
    const int width = image.width * scale;
    const int height = image.height * scale;
    if (scale == 1) {
      lay_over(render(library, outline, width, height, FT_PIXEL_MODE_GRAY),
               image);
    } else {
      const std::vector<uint8_t> samples =
          sample(library, outline, width, height);
      lay_over(peer == Peer::box4
                   ? filter(samples, image, scale, box_weight)
                   : filter(samples, image, scale, gaussian_weight),
               image);
    }
    x += static_cast<double>(face->glyph->linearHoriAdvance) / 65536 / scale;
  }
}

Image fill_polygons(const std::vector<std::vector<PeerCorner>>& polygons,
                    int width,
                    int height) {
  std::vector<FT_Vector> points;
  std::vector<short> ends;
  for (const std::vector<PeerCorner>& polygon : polygons) {
    for (const PeerCorner& corner : polygon) {
      points.push_back(
          {std::lround(corner.x * 64), std::lround((height - corner.y) * 64)});
    }
    ends.push_back(static_cast<short>(points.size() - 1));
  }
  std::vector<char> tags(points.size(), FT_CURVE_TAG_ON);
  FT_Outline outline{};
  outline.n_contours = static_cast<short>(ends.size());
  outline.n_points = static_cast<short>(points.size());
  outline.points = points.data();
  outline.tags = tags.data();
  outline.contours = ends.data();
  const PeerFont::Library library;
  Image image(width, height);
  image.pixels =
      render(library.library, outline, width, height, FT_PIXEL_MODE_GRAY);
  return image;
}

}  // namespace inkcell::tools
