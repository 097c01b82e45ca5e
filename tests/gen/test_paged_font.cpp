// Paged fonts: every glyph is drawn as from the font in mapped memory.
#include <gtest/gtest.h>

#include "rom/paged_font.hpp"

#include <algorithm>
#include <utility>

#include "inkcell/fit.hpp"
#include "inkcell/layers/colour_glyphs.hpp"
#include "inkcell/layers/verify.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/stored/paged.hpp"
#include "inkcell/stored/stored_font.hpp"
#include "inkcell/strike/strike.hpp"
#include "messages.hpp"
#include "pipeline/generate.hpp"
#include "sfnt_builder.hpp"

namespace inkcell::gen::test {
namespace {

GenerateRequest paged_request() {
  GenerateRequest request;
  request.font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
  request.target.min_px = 12;
  request.target.max_px = 16;
  request.chars = {"0x21-0x5A,0x400-0x42F"};
  request.layout_glyphs = false;
  return request;
}

bool read_file(void* context, uint32_t offset, uint8_t* bytes, uint32_t count) {
  const auto& file = *static_cast<std::vector<uint8_t>*>(context);
  if (offset > file.size() || count > file.size() - offset) {
    return false;
  }
  std::copy_n(file.begin() + offset, count, bytes);
  return true;
}

constexpr int kPagedSide = 40;

struct PagedPicture {
  std::vector<uint8_t> pixels = std::vector<uint8_t>(kPagedSide * kPagedSide);

  static void put(void* context,
                  int32_t x,
                  int32_t y,
                  const uint8_t* coverage,
                  int32_t count) {
    auto& pixels = static_cast<PagedPicture*>(context)->pixels;
    std::copy_n(coverage, count, pixels.begin() + y * kPagedSide + x);
  }
  static void solid(void* context, int32_t x, int32_t y, int32_t count) {
    auto& pixels = static_cast<PagedPicture*>(context)->pixels;
    std::fill_n(pixels.begin() + y * kPagedSide + x, count, uint8_t{255});
  }
};

PagedPicture draw_style(const Font& font, const Style& style, char32_t c) {
  PagedPicture picture;
  const Sink sink = {{0, 0, kPagedSide, kPagedSide},
                     &picture,
                     PagedPicture::put,
                     PagedPicture::solid};
  Painter(sink).glyph(font, style, {Q26_6::from_int(4), Q26_6::from_int(30)},
                      font.glyph_or_notdef(c));
  return picture;
}

PagedPicture draw_paged(const Font& font, int px, char32_t c) {
  Style style(Q26_6::from_int(px));
  Fit fit;
  FitOptions options;
  options.across = px == 11;
  EXPECT_EQ(Fit::make(font, style, options, fit), Status::ok);
  style.set_fit(fit);
  return draw_style(font, style, c);
}

TEST(PagedFont, DrawsAsTheFontInMappedMemory) {
  GenerateRequest request = paged_request();
  const std::vector<uint8_t> mapped_bytes = generate(request).bytes;
  Font mapped;
  ASSERT_EQ(Font::open({mapped_bytes.data(), mapped_bytes.size()}, mapped),
            Status::ok);
  for (const int block : {512, 1024}) {
    request.paged = block;
    std::vector<uint8_t> file = generate(request).bytes;
    EXPECT_EQ(file.size() % static_cast<size_t>(block), 0u);
    std::vector<uint64_t> ram(
        StoredFont::ram_bytes(static_cast<size_t>(block), 1) / 8 + 1);
    StoredFont stored;
    ASSERT_EQ(
        StoredFont::open(
            {read_file, &file},
            {reinterpret_cast<uint8_t*>(ram.data()), 8 * ram.size()}, stored),
        Status::ok);
    EXPECT_EQ(stored.verify(), Status::ok);
    const Font& font = stored.font();
    EXPECT_EQ(font.metrics().ascender, mapped.metrics().ascender);
    for (const char32_t c : std::u32string(U"!0AQ\u0416\u042f")) {
      for (const int px : {11, 13, 24}) {
        EXPECT_EQ(draw_paged(font, px, c).pixels,
                  draw_paged(mapped, px, c).pixels)
            << block << " " << px << " " << static_cast<unsigned>(c);
      }
      EXPECT_EQ(font.advance(font.glyph_or_notdef(c)),
                mapped.advance(mapped.glyph_or_notdef(c)));
    }
    int32_t kerned = 0;
    for (char32_t left = 0x21; left <= 0x42f; left += left == 0x5a ? 934 : 1) {
      for (const char32_t right : std::u32string(U"AVTYo.\u0410\u0422")) {
        const int32_t expected = mapped.kerning(mapped.glyph_or_notdef(left),
                                                mapped.glyph_or_notdef(right));
        EXPECT_EQ(font.kerning(font.glyph_or_notdef(left),
                               font.glyph_or_notdef(right)),
                  expected);
        kerned += expected != 0 ? 1 : 0;
      }
    }
    EXPECT_GT(kerned, 20);
    EXPECT_EQ(stored.status(), Status::ok);
    file.back() ^= 1;
    EXPECT_EQ(stored.verify(), Status::corrupt);
    // It is no font for mapped memory.
    Font other;
    EXPECT_EQ(Font::open({reinterpret_cast<uint8_t*>(ram.data()), 512}, other),
              Status::bad_magic);
  }
}

TEST(PagedFont, DrawsStrikesAsTheFontInMappedMemory) {
  GenerateRequest request = paged_request();
  request.strike_only = true;
  for (const int bits : {1, 4}) {
    request.strikes = {{16, bits, format::StrikeFit::both}};
    request.paged = 0;
    const std::vector<uint8_t> mapped_bytes = generate(request).bytes;
    Font mapped;
    ASSERT_EQ(Font::open({mapped_bytes.data(), mapped_bytes.size()},
                         kStrikeCoding, mapped),
              Status::ok);
    request.paged = 1024;
    std::vector<uint8_t> file = generate(request).bytes;
    EXPECT_GE(file.size(), 4096u);  // several pages
    std::vector<uint64_t> ram(StoredFont::ram_bytes(1024, 2) / 8 + 1);
    StoredFont stored;
    ASSERT_EQ(StoredFont::open(
                  {read_file, &file},
                  {reinterpret_cast<uint8_t*>(ram.data()), 8 * ram.size()},
                  kStrikeCoding, stored),
              Status::ok);
    EXPECT_EQ(stored.verify(), Status::ok);
    const Font& font = stored.font();
    EXPECT_EQ(font.metrics().ascender, mapped.metrics().ascender);
    int inked = 0;
    for (char32_t c = 0x21; c < 0x430; c += c == 0x5a ? 934 : 1) {
      const auto picture = draw_style(mapped, Style(16_px), c).pixels;
      inked += picture != PagedPicture().pixels ? 1 : 0;
      EXPECT_EQ(draw_style(font, Style(16_px), c).pixels, picture)
          << static_cast<unsigned>(c);
      EXPECT_EQ(font.advance(font.glyph_or_notdef(c)),
                mapped.advance(mapped.glyph_or_notdef(c)));
    }
    EXPECT_EQ(inked, 0x3a + 0x30);
    EXPECT_NE(mapped.kerning(mapped.glyph_or_notdef(U'A'),
                             mapped.glyph_or_notdef(U'V')),
              0);
    EXPECT_EQ(
        font.kerning(font.glyph_or_notdef(U'A'), font.glyph_or_notdef(U'V')),
        mapped.kerning(mapped.glyph_or_notdef(U'A'),
                       mapped.glyph_or_notdef(U'V')));
    EXPECT_EQ(stored.status(), Status::ok);
    // Nothing of outlines opens it.
    EXPECT_EQ(
        StoredFont::open(
            {read_file, &file},
            {reinterpret_cast<uint8_t*>(ram.data()), 8 * ram.size()}, stored),
        Status::unsupported);
  }
  request.strikes = {{160, 4, format::StrikeFit::none}};
  request.chars = {"0x40"};
  request.paged = 512;
  EXPECT_TRUE(
      contains(error_of([&] { generate(request); }), "use --paged 1024"));
  request.strike_only = false;
  request.paged = 1024;
  EXPECT_TRUE(
      contains(error_of([&] { generate(request); }), "add --strike-only"));
}

// Three channels, each over what was there.
struct ColourPaper {
  std::vector<uint8_t> pixels =
      std::vector<uint8_t>(3 * kPagedSide * kPagedSide, 90);
  uint32_t colour = 0x102030;

  static void put(void* context,
                  int32_t x,
                  int32_t y,
                  const uint8_t* coverage,
                  int32_t count) {
    auto& self = *static_cast<ColourPaper*>(context);
    for (int32_t i = 0; i < 3 * count; ++i) {
      uint8_t& channel =
          self.pixels[static_cast<size_t>(3 * (y * kPagedSide + x) + i)];
      const int share = coverage == nullptr ? 255 : coverage[i / 3];
      const int above = static_cast<uint8_t>(self.colour >> 8 * (i % 3));
      channel = static_cast<uint8_t>(channel + (above - channel) * share / 255);
    }
  }
  static void solid(void* context, int32_t x, int32_t y, int32_t count) {
    put(context, x, y, nullptr, count);
  }
  static uint32_t exchange(void* context, uint32_t pixel) noexcept {
    return std::exchange(static_cast<ColourPaper*>(context)->colour, pixel);
  }
  static uint32_t pixel_of(const LayerColour& colour) noexcept {
    return colour.red | uint32_t{colour.green} << 8 |
           uint32_t{colour.blue} << 16;
  }
};

// `layers`: null of a font in mapped memory.
std::vector<uint8_t> draw_layers(const Font& font,
                                 const StoredLayers* layers,
                                 char32_t c) {
  ColourPaper paper;
  ColourGlyphs colours({&paper, ColourPaper::exchange, ColourPaper::pixel_of});
  if (layers != nullptr) {
    colours.set_stored(*layers);
  }
  const Sink sink = {{0, 0, kPagedSide, kPagedSide},
                     &paper,
                     ColourPaper::put,
                     ColourPaper::solid};
  Painter(sink, {}, &colours)
      .glyph(font, Style(24_px), {Q26_6::from_int(4), Q26_6::from_int(30)},
             font.glyph_or_notdef(c));
  EXPECT_EQ(paper.colour, 0x102030u);
  return paper.pixels;
}

TEST(PagedFont, DrawsLayersAsTheFontInMappedMemory) {
  // So many that COLR takes several blocks.
  constexpr int kDrawings = 24;
  const TestFolder folder;
  for (int i = 0; i < kDrawings; ++i) {
    std::string text = "<svg viewBox='0 0 36 36'>";
    for (int j = 0; j < 16; ++j) {
      text += "<rect x='" + std::to_string(j) + "' y='" +
              std::to_string(i % 6 + j) + "' width='" +
              std::to_string(20 - i % 4) + "' height='" +
              std::to_string(18 - j) + "' fill='#" +
              std::to_string(100 + 37 * i + j) + "' opacity='" +
              (j % 5 == 4 ? ".4'/>" : "1'/>");
    }
    folder.write("0x" + std::to_string(6000 + i) + ".svg",
                 text +
                     "<circle cx='18' cy='18' r='6' "
                     "fill='currentColor'/></svg>");
  }
  GenerateRequest request = paged_request();
  request.svg_folders = {folder.path()};
  request.has_colours = true;
  const std::vector<uint8_t> mapped_bytes = generate(request).bytes;
  Font mapped;
  ASSERT_EQ(Font::open({mapped_bytes.data(), mapped_bytes.size()}, mapped),
            Status::ok);
  request.paged = 512;
  const std::vector<uint8_t> good = generate(request).bytes;
  for (const size_t blocks : {1u, 4u, 30u}) {
    std::vector<uint8_t> file = good;
    std::vector<uint64_t> ram(StoredFont::ram_bytes(512, blocks) / 8 + 1);
    StoredFont stored;
    ASSERT_EQ(
        StoredFont::open(
            {read_file, &file},
            {reinterpret_cast<uint8_t*>(ram.data()), 8 * ram.size()}, stored),
        Status::ok);
    EXPECT_EQ(stored.verify(), Status::ok);
    const Font& font = stored.font();
    const StoredLayers layers = stored.layers();
    EXPECT_GT(layers.bytes, 1024u);
    EXPECT_EQ(verify_layers(font, &layers), Status::ok);
    for (char32_t c = 0x6000; c < 0x6000 + 24; c += c % 16 == 9 ? 7 : 1) {
      const auto expected = draw_layers(mapped, nullptr, c);
      const auto plain = draw_layers(font, nullptr, c);
      EXPECT_EQ(draw_layers(font, &layers, c), expected);
      // Without layers, the form of one colour.
      EXPECT_NE(plain, expected);
    }
    EXPECT_EQ(draw_layers(font, &layers, U'A'),
              draw_layers(mapped, nullptr, U'A'));
    EXPECT_EQ(draw_layers(mapped, &layers, 0x6001),
              draw_layers(mapped, nullptr, 0x6001));
    EXPECT_EQ(stored.status(), Status::ok);
    // A card that is gone, or of other bytes.
    const auto plain = draw_layers(font, nullptr, 0x6001);
    file.resize(file.size() - (layers.bytes + 514) / 512 * 512);
    stored.clear();
    EXPECT_EQ(draw_layers(font, &layers, 0x6001), plain);
    EXPECT_EQ(stored.status(), Status::read_failed);
    file = good;
    stored.clear();
    EXPECT_EQ(draw_layers(font, &layers, 0x6001),
              draw_layers(mapped, nullptr, 0x6001));
    for (size_t at = good.size() - 2048; at < good.size(); ++at) {
      file[at] ^= static_cast<uint8_t>(at * 7);
    }
    stored.clear();
    draw_layers(font, &layers, 0x6001);
    EXPECT_EQ(verify_layers(font, &layers), Status::corrupt);
    EXPECT_EQ(stored.verify(), Status::corrupt);
  }
}

TEST(PagedFont, SaysWhatItDoesNotHold) {
  GenerateRequest request = paged_request();
  request.paged = 512;
  request.target.max_px = 12;
  request.chars = {"0x41-0x17F"};
  const RomFont font = generate(request);
  EXPECT_EQ(font.report.bytes.kerning, 0u);
  EXPECT_TRUE(std::any_of(
      font.warnings.begin(), font.warnings.end(), [](const Warning& warning) {
        return warning.kind == Warning::Kind::no_kerning &&
               warning.text ==
                   "DejaVu Sans Book: no pair kerns, because a block of 512 "
                   "bytes has no room for all that do; use larger blocks, or "
                   "put letters into a font in mapped memory, and this one "
                   "behind it as a fallback";
      }));
  request.paged = 700;
  EXPECT_EQ(error_of([&] { generate(request); }),
            "--paged 700: blocks have 512, 1024, 2048 or 4096 bytes");
  request.paged = 512;
  request.target.coding = Coding::field;
  EXPECT_EQ(error_of([&] { generate(request); }),
            "--paged is for outlines; leave --coding field out");
}

TEST(PagedFont, NamesAGlyphThatIsLargerThanABlock) {
  RomContent content;
  content.name = "Face";
  content.metrics.units_per_em = 1000;
  content.options = paged_request().target;
  content.outlines.code_bits = 4;
  content.outlines.table.resize(16, 1);
  content.glyphs.resize(2);
  content.glyphs[1].outline_record.resize(600, 0x80);
  content.glyph_of[0x9f98] = 1;
  content.block_bytes = 512;
  PartBytes parts;
  const std::string text = error_of([&] { write_paged_font(content, parts); });
  EXPECT_TRUE(contains(text, "U+9F98"));
  EXPECT_TRUE(contains(text, "takes 600 bytes"));
  EXPECT_TRUE(contains(text, "use --paged 1024"));
  content.block_bytes = 1024;
  EXPECT_EQ(write_paged_font(content, parts).size(), 2048u);
}

}  // namespace
}  // namespace inkcell::gen::test
