// Spans of a paragraph: together they are the paragraph, each lies where its
// characters do, and lines under and through them have no gaps.
#include "inkcell/layout/spans.hpp"

#include <inkcell/c/text_box.h>

#include "check.hpp"
#include "fonts.hpp"
#include "inkcell/layout/bidi.hpp"
#include "inkcell/layout/text_box.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "layout_font.hpp"
#include "picture.hpp"

namespace {

using namespace inkcell;

// Letters are 9 px wide, spaces 6.
constexpr Style kStyle = Style(12_px);
constexpr Rect kRoom = {2, 2, 62, 46};
constexpr const char* kWords = "AB AA BA AB BB A";
constexpr size_t kEnd = 16;

using Paper = Picture<64, 48>;

uint8_t rom[layout_font::kBytes];

TextBox make_box(const Font& font) {
  return TextBox(font, kStyle, kRoom);
}

// Draws spans from one cut to the next.
void draw_cut(const TextBox& box,
              Text text,
              Span<const size_t> cuts,
              Paper& paper) {
  size_t begin = 0;
  for (size_t i = 0; i <= cuts.size; ++i) {
    const size_t end = i == cuts.size ? SIZE_MAX : cuts[i];
    draw_span(box, text, {begin, end}, paper.sink());
    paper.next_glyph();
    begin = end;
  }
}

}  // namespace

TEST(spans_together_are_the_paragraph) {
  const Font font = layout_font::open(rom);
  TextBox box = make_box(font);
  Paper whole;
  box.draw(kWords, whole.sink());
  CHECK(whole.ink() > 0);
  for (size_t first = 0; first <= kEnd; ++first) {
    for (size_t second = first; second <= kEnd; second += 3) {
      const size_t cuts[] = {first, second};
      Paper paper;
      draw_cut(box, kWords, cuts, paper);
      CHECK(paper == whole);
    }
  }
  // Lines that end with a hyphen or an ellipsis, and right-to-left text.
  constexpr const char* kOthers[] = {
      "AB\xc2\xad"
      "BA\xc2\xad"
      "AB A AB AB AB",
      "AB \xd7\x90\xd7\x91 AA \xd7\x90 BA"};
  uint16_t levels[64];
  Bidi bidi(levels);
  for (const char* text : kOthers) {
    box.options.set_bidi(bidi);
    box.options.ellipsis = Ellipsis::end;
    box.rect.y1 = 32;
    whole.clear();
    box.draw(text, whole.sink());
    for (size_t cut = 0; cut < 24; ++cut) {
      Paper paper;
      draw_cut(box, text, {&cut, 1}, paper);
      CHECK(paper == whole);
    }
  }
}

TEST(spans_lie_where_their_characters_do) {
  const Font font = layout_font::open(rom);
  const TextBox box = make_box(font);
  // "AB AA" in the first line: the second word is from 24 to 42 px.
  Paper paper;
  draw_span(box, kWords, {3, 5}, paper.sink());
  CHECK(paper.ink() > 0 && paper.lies_in({26, 2, 44, 14}));
  const Rect around = span_box(box, kWords, {3, 5}, paper.sink());
  CHECK(paper.lies_in(around) && around.x0 >= 24 && around.x1 <= 46);
  // The second line alone.
  TextLine room[8];
  Span<const TextLine> lines;
  CHECK_OK(box.lay_out(kWords, paper.sink(), room, lines));
  CHECK(lines.size >= 2);
  Paper second;
  const TextSpan span = {lines[1].begin, lines[1].next};
  draw_span(box, kWords, span, second.sink(), lines);
  const int32_t height = line_height(box.options).floor();
  CHECK(second.ink() > 0 &&
        second.lies_in({0, 2 + height, 64, 2 + 2 * height}));
  Paper none;
  draw_span(box, kWords, {5, 5}, none.sink());
  draw_span(box, kWords, {90, 99}, none.sink());
  CHECK_EQ(none.ink(), 0);
  CHECK(is_empty(span_box(box, kWords, {5, 5}, none.sink())));
}

TEST(spans_are_underlined_and_struck_through) {
  const Font font = layout_font::open(rom);
  const TextBox box = make_box(font);
  const int32_t base = 2 + baseline(box.options).floor();
  // "B AA" with its space: from 9 to 42 px.
  const TextSpan both = {1, 5, nullptr,
                         TextSpan::kUnderline | TextSpan::kStrikeThrough};
  Picture<64, 48, Overlap::greatest> paper;
  draw_span(box, kWords, both, paper.sink());
  int32_t under = 0;
  int32_t through = 0;
  for (int32_t x = 0; x < 64; ++x) {
    under += paper.at(x, base + 1) == 255 ? 1 : 0;
    int32_t column = 0;
    for (int32_t y = 2; y < base; ++y) {
      column += paper.at(x, y) == 255 && x >= 20 && x < 26 ? 1 : 0;
    }
    through += column;
  }
  CHECK_EQ(under, 33);
  CHECK_EQ(through, 6);  // of the space
  CHECK_EQ(paper.at(10, base + 1), 0);
  CHECK_EQ(paper.at(11, base + 1), 255);
  CHECK_EQ(paper.at(43, base + 1), 255);
  CHECK_EQ(paper.at(44, base + 1), 0);
  const Rect around = span_box(box, kWords, both, paper.sink());
  CHECK(around.y1 >= base + 2 && paper.ink() == paper.ink(around));
  // In strips, and cut by the clip: karaoke.
  Picture<64, 48, Overlap::greatest> strips;
  strips.draw_strips(5, [&](const Sink& sink) {
    TextBox part = box;
    part.clip.x1 = 30;
    draw_span(part, kWords, both, sink);
    part.clip.x1 = 64;
    part.clip.x0 = 30;
    draw_span(part, kWords, both, sink);
  });
  CHECK(strips == paper);
}

TEST(spans_have_a_style) {
  const Font font = layout_font::open(rom);
  const TextBox box = make_box(font);
  static constexpr Filter kBolder =
      with_weight(kFilterText, Q6_10::from_raw(384));
  const Style bold(12_px, kBolder);
  Paper plain;
  Paper bolder;
  draw_span(box, kWords, {3, 5}, plain.sink());
  draw_span(box, kWords, {3, 5, &bold}, bolder.sink());
  CHECK(bolder.ink() > plain.ink() + 1000);
  CHECK(bolder.lies_in(span_box(box, kWords, {3, 5, &bold}, bolder.sink())));
}

TEST(spans_have_a_size) {
  constexpr const char* kText = "AB AA A";
  const Font font = layout_font::open(rom);
  const Style large(24_px);
  const Face faces[] = {{&font, &large}};
  const FaceSpan list[] = {{3, 5, 1}};
  const FaceSpans spans(list);
  TextBox box = make_box(font);
  box.options.line_height = 24_px;
  box.options.fallback = faces;
  CHECK_EQ(box.measure("AB AA", Painter()).width.raw, (4 * 9 + 6) * 64);
  box.options.spans = &spans;
  CHECK_EQ(box.measure("AB AA", Painter()).width.raw, (6 * 9 + 6) * 64);
  // Lines break by advances: 60 px hold no more than "AB AA".
  TextLine room[3];
  Span<const TextLine> lines;
  CHECK_OK(box.lay_out(kText, Painter(), room, lines));
  CHECK(lines.size == 2 && lines[0].length == 5);
  // As by hand, on one baseline; and in parts, of other colours perhaps.
  const auto at = [&](int32_t x) {
    return Point{Q26_6::from_int(x),
                 Q26_6::from_raw(2 * 64 + baseline(box.options).raw)};
  };
  Paper whole;
  box.draw("AB AA", whole.sink());
  Paper parts;
  const Sink sink = parts.sink();
  const Painter painter(sink);
  painter.text(font, kStyle, at(2), "AB");
  painter.text(font, large, at(26), "A");
  parts.next_glyph();
  painter.text(font, large, at(44), "A");
  CHECK(whole.ink() > 0 && whole == parts);
  parts.clear();
  draw_span(box, "AB AA", {0, 3}, painter);
  CHECK(parts.ink() > 0 && parts.lies_in({0, 0, 26, 48}));
  draw_span(box, "AB AA", {3}, painter);
  CHECK(parts == whole);
  // From C.
  const inkcell_face_span_t list_in_c = {3, 5, 1};
  inkcell_face_spans_t in_c;
  inkcell_face_spans_init(&list_in_c, 1, &in_c);
  box.options.spans = reinterpret_cast<const FaceSpans*>(&in_c);
  CHECK_EQ(box.measure("AB AA", Painter()).width.raw, (6 * 9 + 6) * 64);
  // An ellipsis is of the box's face; no face, no span.
  const FaceSpan all[] = {{0, SIZE_MAX, 1}};
  const FaceSpans whole_text(all);
  box.options.spans = &whole_text;
  box.options.ellipsis = Ellipsis::end;
  box.rect.y1 = 26;
  CHECK_OK(box.lay_out(kText, Painter(), room, lines));
  CHECK(lines.size == 1 && lines[0].has_ellipsis);
  PositionedGlyph glyph_room[12];
  Span<const PositionedGlyph> glyphs;
  CHECK_OK(lay_out(box.options, Painter(), kText, lines[0], 60_px, glyph_room,
                   glyphs));
  CHECK(glyphs.size > 1 && glyphs[0].face == 1);
  CHECK_EQ(int{glyphs[glyphs.size - 1].face}, 0);
  const FaceSpan beyond[] = {{0, SIZE_MAX, 2}};
  const FaceSpans none(beyond);
  box.options.spans = &none;
  CHECK_EQ(box.measure("AB AA", Painter()).width.raw, (4 * 9 + 6) * 64);
}

TEST(spans_are_the_same_in_c) {
  static_assert(INKCELL_SPAN_UNDERLINE == TextSpan::kUnderline, "");
  static_assert(INKCELL_SPAN_STRIKE_THROUGH == TextSpan::kStrikeThrough, "");
  const Font font = layout_font::open(rom);
  const TextBox box = make_box(font);
  const inkcell_text_span_t span = {1, 5, nullptr, INKCELL_SPAN_UNDERLINE};
  Picture<64, 48, Overlap::greatest> papers[2];
  const Sink sinks[] = {papers[0].sink(), papers[1].sink()};
  inkcell_painter_t painter = {};
  painter.sink = reinterpret_cast<const inkcell_sink_t*>(&sinks[0]);
  const auto* in_c = reinterpret_cast<const inkcell_text_box_t*>(&box);
  inkcell_draw_span(in_c, &painter, kWords, kEnd, &span, nullptr, 0);
  const TextSpan same = {1, 5, nullptr, TextSpan::kUnderline};
  draw_span(box, kWords, same, sinks[1]);
  CHECK(papers[0] == papers[1] && papers[0].ink() > 0);
  inkcell_rect_t around;
  inkcell_span_box(in_c, &painter, kWords, kEnd, &span, nullptr, 0, &around);
  const Rect expected = span_box(box, kWords, same, sinks[1]);
  CHECK(around.x0 == expected.x0 && around.y1 == expected.y1);
}

TEST(boxes_kern_what_the_canvas_fits) {
  // The canvas fits a style that leaves it open: pairs are as with its own.
  Font font;
  CHECK_OK(Font::open(golden::font_bytes(golden::FontId::dejavu_sans_outline),
                      font));
  const Style own = port::MonoRowsCanvas::style(16_px);
  const Style plain(16_px);
  static uint8_t pixels[3][16 * 80];
  constexpr const char* kText =
      "Ready. Valve 7 is running dry: Ty, AV, y. of 2024.";
  const Style* const styles[] = {&own, &plain, &plain};
  for (size_t i = 0; i != 3; ++i) {
    const port::MonoRowsCanvas canvas(Strip{pixels[i], 0, 0, 128, 80, 16});
    const TextBox box(font, *styles[i], {0, 0, 128, 80});
    if (i != 2) {
      box.draw(kText, canvas);
    } else {
      draw_span(box, kText, {0, 7}, canvas);
      draw_span(box, kText, {7}, canvas);
    }
  }
  int32_t ink = 0;
  for (size_t at = 0; at != sizeof pixels[0]; ++at) {
    CHECK_EQ(pixels[0][at], pixels[1][at]);
    CHECK_EQ(pixels[0][at], pixels[2][at]);
    ink += pixels[0][at] != 0 ? 1 : 0;
  }
  CHECK(ink > 60);
}
