// The claims of docs/DRAW.md on the RAM of a cache, with a real face.
#include <gtest/gtest.h>

#include "inkcell/cache/glyph_cache.hpp"

#include "pipeline/generate.hpp"

namespace inkcell::gen::test {
namespace {

void count(void* sum, int32_t, int32_t, const uint8_t*, int32_t pixels) {
  *static_cast<int64_t*>(sum) += pixels;
}
void count_solid(void* sum, int32_t, int32_t, int32_t pixels) {
  *static_cast<int64_t*>(sum) += pixels;
}

TEST(GlyphCache, TenDigitsOf32PxFitInto2Kb) {
  GenerateRequest request;
  request.font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
  request.chars = {"0-9"};
  const std::vector<uint8_t> bytes = generate(request).bytes;
  Font font;
  ASSERT_EQ(Font::open({bytes.data(), bytes.size()}, font), Status::ok);
  const Style style(32_px, kFilterText);
  alignas(8) uint8_t ram[2048];
  GlyphCache cache;
  ASSERT_EQ(GlyphCache::make(ram, {}, cache), Status::ok);
  int64_t pixels = 0;
  const Sink sink = {{0, 0, 400, 60}, &pixels, count, count_solid};
  const inkcell::Point origin = {Q26_6::from_int(4), Q26_6::from_int(40)};
  // Each at the same phase.
  for (int round = 0; round < 2; ++round) {
    for (char digit = '0'; digit <= '9'; ++digit) {
      Painter(sink, {}, &cache).text(font, style, origin, Text(&digit, 1));
    }
  }
  EXPECT_GT(pixels, 0);
  EXPECT_EQ(cache.stats().misses, 10u);
  EXPECT_EQ(cache.stats().hits, 10u);
  EXPECT_EQ(cache.stats().evictions, 0u);
}

}  // namespace
}  // namespace inkcell::gen::test
