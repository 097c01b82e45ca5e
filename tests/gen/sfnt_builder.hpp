// Makes small TrueType fonts for tests: exact, odd or broken on purpose.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace inkcell::gen::test {

/// Corners of a closed polygon in font units, y up.
using Polygon = std::vector<std::pair<int, int>>;

/// A rectangle, clockwise as outer contours in TrueType.
Polygon sfnt_rectangle(int x0, int y0, int x1, int y1);

/// A part of a composite glyph.
struct SfntComponent {
  int glyph = 0;
  int dx = 0;
  int dy = 0;
  /// If not empty, xx, yx, xy, yy in Q2.14, as stored in TrueType.
  std::vector<int> matrix_q14 = {};
};

struct SfntGlyph {
  char32_t code_point = 0;  // 0: in no character map
  int advance = 500;
  std::vector<Polygon> contours;
  /// If not empty, the glyph is a composite without contours of its own.
  std::vector<SfntComponent> components = {};
};

/// A font to build. Glyph 0 is .notdef, whatever its code point.
struct Sfnt {
  int units_per_em = 1000;
  int ascender = 800;
  int descender = -200;
  int line_gap = 90;
  int x_height = 480;
  int cap_height = 700;
  uint16_t fs_type = 0;
  std::vector<SfntGlyph> glyphs;
  /// Pairs of glyph ids and their values: a kern table if there are any.
  std::map<std::pair<int, int>, int> kern_pairs;
  /// If not 0: a variable font with the axis wght 100..900, default 400, that
  /// at 900 moves each point by this in x, and the advance too.
  int wght_shift = 0;
  /// Its named instances, and their wght.
  std::vector<std::pair<std::string, int>> instances;
  /// The character map is a symbol map, not Unicode.
  bool is_symbol = false;
  /// Replaces tables; an empty one is left out.
  std::map<std::string, std::vector<uint8_t>> tables;

  /// A font of .notdef, space, '.', and 'H' that is like a square.
  static Sfnt plain();

  std::vector<uint8_t> build() const;
};

/// A TTC file of several fonts.
std::vector<uint8_t> build_collection(const std::vector<Sfnt>& fonts);

/// A folder for a test's files, removed at the end.
class TestFolder {
 public:
  TestFolder();
  ~TestFolder();
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Writes a file, whose folders are made; returns its path.
  std::filesystem::path write(const std::string& name,
                              const std::vector<uint8_t>& bytes) const;
  std::filesystem::path write(const std::string& name,
                              const std::string& text) const {
    return write(name, std::vector<uint8_t>(text.begin(), text.end()));
  }
  std::filesystem::path write(const std::string& name, const Sfnt& font) const {
    return write(name, font.build());
  }
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

std::vector<uint8_t> read_file(const std::filesystem::path& file);
std::string read_text(const std::filesystem::path& file);

}  // namespace inkcell::gen::test
