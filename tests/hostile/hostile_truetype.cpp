// TrueType files with wrong bytes, cut files, and files whose bytes change as
// they are drawn.
//
//   hostile_truetype [changing]
//
// The same files in storage that also fails and changes bytes as they are read.
//
// Files are in heap blocks of exactly their size, so that the sanitizers see a
// read of a single byte too much.
#include <stdio.h>
#include <string.h>

#include <algorithm>
#include <memory>
#include <vector>

#if defined(__linux__) && defined(__x86_64__)
#  include "changing_bytes.hpp"
#endif
#include "exercise.hpp"
#include "inkcell/edge_contrast.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/prepared_glyph.hpp"
#include "inkcell/supersample.hpp"
#include "inkcell/truetype/plain_truetype.hpp"
#include "inkcell/truetype/stored_truetype.hpp"
#include "inkcell/truetype/truetype_font.hpp"
#include "random.hpp"
#include "sfnt_font.hpp"

namespace {

using namespace inkcell;
using hostile::require;
using Bytes = std::vector<uint8_t>;

constexpr Supersample kSampled;
constexpr EdgeContrast kContrast;

Bytes build(const sfnt_font::Options& options) {
  Bytes file(4096);
  file.resize(sfnt_font::build({file.data(), file.size()}, options));
  return file;
}

// The sample in all of its forms.
std::vector<Bytes> good_files() {
  std::vector<Bytes> files;
  int32_t gpos = 0;
  for (const int32_t format : {4, 12, 6, 0}) {
    sfnt_font::Options options;
    options.cmap_format = format;
    options.is_long = format != 12;
    options.gpos_format = gpos++ % 3;
    options.is_extension = gpos == 3;
    options.is_glyf_last = format == 12 || format == 6;
    files.push_back(build(options));
  }
  return files;
}

struct Count {
  int64_t opened = 0;
  int64_t glyphs = 0;
};

Style style_of(Random& random) {
  const auto size = Q26_6::from_raw(random.between(4 * 64, 60 * 64));
  switch (random.below(6)) {
    case 0:
      return Style(Q26_6::from_raw(random.between(4 * 64, 1024 * 64)));
    case 1:
      return Style({Q16_16::from_int(random.between(5, 40)),
                    Q16_16::from_int(random.between(-20, 20)),
                    Q16_16::from_int(random.between(-20, 20)),
                    Q16_16::from_int(random.between(5, 40))});
    case 2:
      return Style(size).set_effect(kSampled);
    case 3:
      return Style(size).set_effect(kContrast);
    case 4:
      return Style(size).set_fit(kFitTwoLevels, nullptr);
    default:
      return Style(size);
  }
}

void use_numbers(const Font& font, Random& random) {
  const FontMetrics all = font.metrics();
  require(all.units_per_em >= 16 && all.units_per_em <= 16384, "the em");
  for (int32_t i = 0; i < 8; ++i) {
    uint16_t glyph = 1;
    const bool found =
        font.glyph_of(random.next() >> random.below(32), glyph) == Status::ok;
    GlyphMetrics metrics;
    require(
        found ? font.glyph_metrics(glyph, metrics) == Status::ok : glyph == 0,
        "glyphs of code points have metrics");
    require(metrics.advance >= 0 && metrics.advance <= 65535, "advance");
    require(hostile::bytes_may_change() ||
                font.advance(glyph) == metrics.advance || !found,
            "one advance");
    const auto left = static_cast<uint16_t>(random.below(20));
    const auto right = static_cast<uint16_t>(random.below(20));
    const int32_t kerning = font.kerning(left, right);
    require(kerning >= -(1 << 20) && kerning <= 1 << 20, "kerning");
  }
}

void use(const Font& font, Random& random, int32_t glyphs, Count& count) {
  use_numbers(font, random);
  for (int32_t i = 0; i < glyphs; ++i) {
    const Style style = style_of(random);
    const auto glyph = static_cast<uint16_t>(random.below(15));
    const Point origin = {Q26_6::from_raw(random.between(-2000, 2000)),
                          Q26_6::from_raw(random.between(-1000, 3000))};
    hostile::draw_checked(font, glyph, style, origin);
    ++count.glyphs;
  }
  const auto ram = std::make_unique<uint64_t[]>(200);
  const Workspace workspace = {reinterpret_cast<uint8_t*>(ram.get()), 1600};
  PreparedGlyph prepared;
  const Status status =
      PreparedGlyph::make(font, static_cast<uint16_t>(random.below(16)),
                          Style(20_px), {3_px, 15_px}, workspace, prepared);
  require(status == Status::ok || status == Status::no_glyph, "prepared");
  hostile::use_text(font, "ABC LK", Style(11_px), {2_px, 12_px});
}

// Bytes that differ in some places, or end early.
void spoil(Bytes& file, Random& random) {
  for (uint32_t i = random.below(6); i != 0; --i) {
    const uint32_t kinds[] = {0, 1, 0x7f, 0x80, 0xff, random.next()};
    // Most of the file's first bytes are its directory.
    const auto size = static_cast<uint32_t>(file.size());
    const uint32_t at = random.below(random.below(4) == 0 ? 200 : size);
    file[at] = static_cast<uint8_t>(kinds[random.below(6)]);
  }
  if (random.below(4) == 0) {
    file.resize(random.below(static_cast<uint32_t>(file.size())) + 1);
  }
}

// A file in storage that fails, or gives other bytes, once in so many reads.
struct BadCard {
  const Bytes& file;
  Random random;
  uint32_t one_in;

  static bool read(void* context,
                   uint32_t offset,
                   uint8_t* bytes,
                   uint32_t count) {
    BadCard& self = *static_cast<BadCard*>(context);
    require(offset % 512 == 0 && count == 512, "a block");
    for (uint32_t i = 0; i < count && offset + i < self.file.size(); ++i) {
      bytes[i] = self.file[offset + i];
    }
    if (self.one_in != 0 && self.random.below(self.one_in) == 0) {
      for (int32_t i = 0; i < 20; ++i) {
        bytes[self.random.below(count)] =
            static_cast<uint8_t>(self.random.next());
      }
      return self.random.below(2) == 0;
    }
    return offset < self.file.size();
  }
};

// In RAM of exactly its size.
void use_stored(const Bytes& file,
                uint32_t round,
                Random& random,
                Count& count) {
  BadCard card = {file, Random(round), round % 3 * 9};
  const uint32_t record_bytes = 1 + random.below(1000);
  const size_t size =
      StoredTrueType::ram_bytes(1 + random.below(4), record_bytes);
  const auto ram = std::make_unique<uint64_t[]>(size / 8);
  StoredTrueTypeOptions options;
  options.record_bytes = record_bytes;
  options.coding = round % 2 == 0 ? &kPlainTrueTypeCoding : &kTrueTypeCoding;
  StoredTrueType stored;
  if (StoredTrueType::open(
          {BadCard::read, &card},
          {reinterpret_cast<uint8_t*>(ram.get()), size / 8 * 8}, stored,
          options) == Status::ok) {
    ++count.opened;
    // Bytes differ each time.
    hostile::use_text(stored.font(), "ABC LK", Style(11_px), {2_px, 12_px});
    for (int32_t i = 0; i < 3; ++i) {
      const auto glyph = static_cast<uint16_t>(random.below(15));
      GlyphMetrics metrics;
      static_cast<void>(stored.font().glyph_metrics(glyph, metrics));
      hostile::draw_checked(stored.font(), glyph, style_of(random),
                            {3_px, 15_px});
      ++count.glyphs;
    }
  }
}

void run_wrong() {
  const std::vector<Bytes> good = good_files();
  Random random(1);
  Count count;
  for (int32_t round = 0; round < 12000; ++round) {
    Bytes spoiled = good[random.below(static_cast<uint32_t>(good.size()))];
    if (round >= 8) {
      spoil(spoiled, random);
    }
    const auto block = std::make_unique<uint8_t[]>(spoiled.size());
    std::copy(spoiled.begin(), spoiled.end(), block.get());
    TrueTypeFont font;
    const Coding& coding =
        round % 3 == 0 ? kPlainTrueTypeCoding : kTrueTypeCoding;
    const bool is_open =
        font.open({block.get(), spoiled.size()}, coding,
                  round % 50 == 9 ? random.below(3) : 0) == Status::ok;
    require(is_open || round >= 8, "good files open");
    if (is_open) {
      ++count.opened;
      use(font.font(), random, 6, count);
    }
  }
  printf("%lld of 12000 files opened, %lld glyphs drawn\n",
         static_cast<long long>(count.opened),
         static_cast<long long>(count.glyphs));
  require(count.opened > 6000, "many files open");
  hostile::expect_changing_bytes();
  count = {};
  for (uint32_t round = 0; round < 6000; ++round) {
    Bytes spoiled = good[random.below(static_cast<uint32_t>(good.size()))];
    if (round % 4 != 0) {
      spoil(spoiled, random);
    }
    use_stored(spoiled, round, random, count);
  }
  printf("%lld of 6000 stored files opened, %lld glyphs drawn\n",
         static_cast<long long>(count.opened),
         static_cast<long long>(count.glyphs));
  require(count.opened > 1500, "many stored files open");
}

#if defined(__linux__) && defined(__x86_64__)
void run_changing() {
  hostile::expect_changing_bytes();
  Random random(2);
  Count count;
  for (const Bytes& good : good_files()) {
    for (const bool is_at_end : {true, false}) {
      hostile::ChangingBytes memory({good.data(), good.size()}, is_at_end);
      for (const uint32_t one_in : {3u, 40u, 400u}) {
        for (uint32_t round = 1; round <= 2; ++round) {
          TrueTypeFont font;
          memory.start(round, one_in);
          if (font.open(memory.bytes()) != Status::ok) {
            memory.stop();
            require(font.open(memory.bytes()) == Status::ok, "it opens");
            memory.start(round, one_in);
          }
          ++count.opened;
          use(font.font(), random, 4, count);
          memory.stop();
        }
      }
    }
  }
  const int64_t loads = hostile::ChangingBytes::load_count();
  const int64_t changes = hostile::ChangingBytes::change_count();
  printf("%lld glyphs, %lld loads, %lld of other bytes\n",
         static_cast<long long>(count.glyphs), static_cast<long long>(loads),
         static_cast<long long>(changes));
  require(changes > 1000 && loads > 20 * 1000, "loads are changed");
}
#endif

}  // namespace

int main(int argc, char** argv) {
#if defined(__linux__) && defined(__x86_64__)
  if (argc > 1 && strcmp(argv[1], "changing") == 0) {
    run_changing();
    return 0;
  }
#endif
  static_cast<void>(argc);
  static_cast<void>(argv);
  run_wrong();
  return 0;
}
