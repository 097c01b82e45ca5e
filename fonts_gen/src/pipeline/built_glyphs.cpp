#include "pipeline/built_glyphs.hpp"

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "base/error.hpp"
#include "inkcell/version.hpp"

namespace inkcell::gen {
namespace {

// Begins the bytes. Other byte orders read another number.
constexpr uint32_t kMark = 0x474b4e49;
constexpr uint32_t kVersion = kLibraryVersionMajor << 16 |
                              kLibraryVersionMinor << 8 | kLibraryVersionPatch;

// Appends numbers, and lists with their length.
struct Writer {
  std::string bytes;

  template <typename Number>
  void operator()(const Number& number) {
    static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  template <typename Item>
  void list(const std::vector<Item>& items) {
    (*this)(static_cast<uint32_t>(items.size()));
  }
};

// Reads them again.
struct Reader {
  std::string_view bytes;
  const std::string& name;

  template <typename Number>
  void operator()(Number& number) {
    static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
    if (bytes.size() < sizeof number) {
      refuse();
    }
    std::memcpy(&number, bytes.data(), sizeof number);
    bytes.remove_prefix(sizeof number);
  }
  template <typename Item>
  void list(std::vector<Item>& items) {
    uint32_t count = 0;
    (*this)(count);
    if (count > bytes.size()) {  // an item has a byte at least
      refuse();
    }
    items.resize(count);
  }
  [[noreturn]] void refuse() const {
    throw Error(name +
                ": no glyphs that this version of inkcell-fontgen built "
                "with --part; build them again");
  }
};

template <typename Archive, typename Miss>
void transfer_miss(Archive& archive, Miss& miss) {
  archive(miss.x_u), archive(miss.y_u), archive(miss.px), archive(miss.error);
}

template <typename Archive, typename Errors>
void transfer_errors(Archive& archive, Errors& errors) {
  archive.list(errors.sizes);
  for (auto& size : errors.sizes) {
    archive(size.px), archive(size.worst), archive(size.mean);
  }
  archive.list(errors.misses);
  for (auto& miss : errors.misses) {
    transfer_miss(archive, miss);
  }
  transfer_miss(archive, errors.worst_pixel);
  archive(errors.miss_count), archive(errors.worst), archive(errors.worst_mean);
}

// The members of a glyph, in the order of the bytes; glyphs of outlines have
// no others yet.
template <typename Archive, typename Glyph>
void transfer(Archive& archive, Glyph& built) {
  auto& metrics = built.glyph.metrics;
  archive(metrics.x_min), archive(metrics.y_min);
  archive(metrics.x_max), archive(metrics.y_max);
  auto& contours = built.glyph.outline.contours;
  archive.list(contours);
  for (auto& contour : contours) {
    archive.list(contour.points);
    for (auto& point : contour.points) {
      archive(point.x), archive(point.y), archive(point.kind);
    }
  }
  transfer_errors(archive, built.errors.promised);
  transfer_errors(archive, built.errors.distance);
}

template <typename Archive, typename Key>
void transfer_key(Archive& archive, Key& key) {
  archive.list(key);
  for (auto& number : key) {
    archive(number);
  }
}

std::vector<double> conditions_of(const Target& target,
                                  const RefitOptions& refit) {
  return {static_cast<double>(target.coding),
          target.min_px,
          target.max_px,
          target.tolerance,
          static_cast<double>(target.predicate),
          target.band_px,
          static_cast<double>(target.effort),
          static_cast<double>(refit.units_per_em),
          static_cast<double>(refit.grid_shift),
          refit.tolerance_u};
}

}  // namespace

void BuiltGlyphs::begin(const Target& target, const RefitOptions& refit) {
  Key conditions = conditions_of(target, refit);
  if (conditions != conditions_) {
    glyphs_.clear();
    conditions_ = std::move(conditions);
  }
}

const BuiltGlyph* BuiltGlyphs::find(const Outline& outline) const {
  const auto found = glyphs_.find(key_of(outline));
  return found == glyphs_.end() ? nullptr : &found->second;
}

void BuiltGlyphs::keep(const std::vector<SourceGlyph>& sources,
                       const std::vector<RomGlyph>& glyphs,
                       const std::vector<GlyphErrors>& errors) {
  std::map<Key, BuiltGlyph> kept;
  reused_ = 0;
  for (size_t i = 0; i < sources.size(); ++i) {
    Key key = key_of(sources[i].outline);
    if (auto old = glyphs_.extract(key)) {
      kept.insert(std::move(old));
      ++reused_;
    } else {
      kept.try_emplace(std::move(key), BuiltGlyph{glyphs[i], errors[i]});
    }
  }
  glyphs_ = std::move(kept);
}

std::string BuiltGlyphs::bytes() const {
  Writer writer;
  writer(kMark);
  writer(kVersion);
  transfer_key(writer, conditions_);
  for (const auto& [key, built] : glyphs_) {
    transfer_key(writer, key);
    transfer(writer, built);
  }
  return std::move(writer.bytes);
}

void BuiltGlyphs::add(std::string_view bytes, const std::string& name) {
  Reader reader{bytes, name};
  uint32_t mark = 0;
  uint32_t version = 0;
  reader(mark);
  reader(version);
  if (mark != kMark || version != kVersion) {
    reader.refuse();
  }
  Key conditions;
  transfer_key(reader, conditions);
  if (conditions != conditions_) {
    glyphs_.clear();
    conditions_ = std::move(conditions);
  }
  while (!reader.bytes.empty()) {
    Key key;
    BuiltGlyph built;
    transfer_key(reader, key);
    transfer(reader, built);
    glyphs_.insert_or_assign(std::move(key), std::move(built));
  }
}

// Contours with their number of segments, segments with their kind: no two
// outlines have one key.
BuiltGlyphs::Key BuiltGlyphs::key_of(const Outline& outline) {
  Key key;
  for (const Contour& contour : outline.contours) {
    key.push_back(static_cast<double>(contour.segments.size()));
    for (const Segment& segment : contour.segments) {
      key.push_back(static_cast<double>(segment.kind));
      for (int i = 0; i <= degree_of(segment); ++i) {
        key.push_back(segment.p[i].x);
        key.push_back(segment.p[i].y);
      }
    }
  }
  return key;
}

}  // namespace inkcell::gen
