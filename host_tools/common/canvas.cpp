// Runs the strip loop of the core over a whole picture.
#include "canvas.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "inkcell/format/rom.hpp"
#include "inkcell/layers/colour_glyphs.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/port/colour.hpp"
#include "inkcell/port/lcd.hpp"
#include "inkcell/port/strip_loop.hpp"
#include "inkcell/shaped_run.hpp"

namespace inkcell::tools {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int32_t kMaxSide = 32767;        // [px], as strip.hpp says
constexpr double kMaxPosition = 16777215;  // [px]

Fixed<int32_t, 30> to_q30(double value) {
  return Fixed<int32_t, 30>::from_raw(
      static_cast<int32_t>(std::lround(value * (1 << 30))));
}

double from_q30(Fixed<int32_t, 30> value) {
  return value.raw / 1073741824.0;
}

// Right angles give exact vectors.
Direction direction_of(double degrees) {
  const double turns = std::remainder(degrees, 360) / 90;
  Direction direction;
  if (turns == std::round(turns)) {
    const int quarter = (static_cast<int>(turns) + 4) % 4;
    constexpr int kCosine[4] = {1, 0, -1, 0};
    constexpr int kSine[4] = {0, 1, 0, -1};
    direction.cosine = to_q30(kCosine[quarter]);
    direction.sine = to_q30(kSine[quarter]);
    return direction;
  }
  direction.cosine = to_q30(std::cos(degrees * kPi / 180));
  direction.sine = to_q30(std::sin(degrees * kPi / 180));
  return direction;
}

// The data of the strip loop.
struct Scene {
  const Font& font;
  const std::vector<Line>& lines;
  const std::vector<Point>& origins;  // of the lines
  const Style& style;
  Image& image;
  DrawStats* stats;
};

Status draw_strip(void* context, const Strip& strip) {
  const Scene& scene = *static_cast<const Scene*>(context);
  std::memset(
      strip.pixels.data, 0,
      static_cast<size_t>(strip.stride) * static_cast<size_t>(strip.height));
  const port::A8Canvas grey(strip);
  port::Rgb888Canvas colour(strip);  // white: coverage itself
  port::set_sub_pixels(colour);
  const bool is_grey = scene.image.channels == 1;
  const Sink& sink = is_grey ? static_cast<const Sink&>(grey) : colour;
  if (scene.stats == nullptr) {
    draw_lines(scene.font, scene.lines, scene.origins, scene.style, sink);
    return Status::ok;
  }
  ++scene.stats->strips;
  CountingSink counting(sink, *scene.stats);
  draw_lines(scene.font, scene.lines, scene.origins, scene.style,
             counting.sink());
  return Status::ok;
}

// Lays the strip over the picture, as sinks blend coverage.
Status flush_strip(void* context, const Strip& strip) {
  Image& image = static_cast<Scene*>(context)->image;
  for (int32_t y = 0; y < strip.height; ++y) {
    const uint8_t* from = strip.pixels.data + y * strip.stride;
    uint8_t* to = image.at(strip.x0, strip.y0 + y);
    for (int32_t i = 0; i < strip.width * image.channels; ++i) {
      const unsigned over = from[i];
      to[i] = static_cast<uint8_t>(over + ((255 - over) * to[i] + 127) / 255);
    }
  }
  return Status::ok;
}

}  // namespace

Style make_style(double px, double angle, const Filter& filter) {
  const double raw = std::round(px * 64);
  const bool in_range = raw >= kMinSize.raw && raw <= kMaxSize.raw;
  if (!in_range) {
    std::ostringstream text;
    text << px << " px: sizes go from 4 to 1024 px";
    throw std::runtime_error(text.str());
  }
  if (!std::isfinite(angle * kPi)) {
    throw std::runtime_error("the angle is not a number of degrees");
  }
  return Style(Q26_6::from_raw(static_cast<int32_t>(raw)), filter,
               direction_of(angle));
}

bool is_turned(double angle) {
  return !make_style(16, angle, kFilterText).is_upright();
}

Line lay_out(const Font& font,
             std::string_view text,
             Kerning kerning,
             const Style& style) {
  Line line;
  std::vector<ShapedGlyph> run;
  TextCursor cursor(font, Text(text.data(), text.size()), style);
  PositionedGlyph at;
  while (cursor.next(at)) {
    line.glyphs.push_back(at);
    const int32_t x = run.empty() ? 0 : font.advance(run.back().glyph);
    run.push_back({at.glyph, static_cast<int16_t>(std::min(x, 32767)), 0});
  }
  if (kerning == Kerning::none) {
    std::vector<PositionedGlyph> room(run.size());
    Span<const PositionedGlyph> glyphs;
    static_cast<void>(Painter().lay_out(font, style,
                                        ShapedRun{{run.data(), run.size()}, 0},
                                        {room.data(), room.size()}, glyphs));
    for (size_t i = 0; i != glyphs.size; ++i) {
      line.glyphs[i].x = glyphs[i].x;
    }
  }
  return line;
}

std::vector<Line> lay_out_lines(const Font& font,
                                std::string_view text,
                                Kerning kerning,
                                const Style& style,
                                const Wrapping& wrapping) {
  const FontMetrics metrics = font.metrics();
  const int32_t height =
      metrics.ascender - metrics.descender + metrics.line_gap;
  const Text whole(text.data(), text.size());
  std::vector<uint16_t> cells(text.size());
  Bidi bidi({cells.data(), cells.size()});
  LayoutOptions options(font, style);
  options.set_bidi(bidi);
  options.wraps = wrapping.width.has_value();
  options.align = wrapping.align;
  std::vector<Line> lines;
  std::vector<PositionedGlyph> room(text.size() + 4);
  TextLine line;
  Q26_6 width = wrapping.width.value_or(Q26_6{});
  for (int32_t y = 0; next_line(options, {}, whole, width, line); y -= height) {
    if (kerning == Kerning::none) {
      lines.push_back(
          lay_out(font, text.substr(line.begin, line.length), kerning, style));
    } else {
      Span<const PositionedGlyph> glyphs;
      if (!options.wraps) {
        width = to_px(font, style, line.width);
      }
      if (lay_out(options, {}, whole, line, width, {room.data(), room.size()},
                  glyphs) != Status::ok) {
        throw std::runtime_error("a line has more glyphs than its text");
      }
      lines.push_back({{glyphs.begin(), glyphs.end()}, 0});
    }
    lines.back().y = y;
  }
  return lines;
}

InkBox ink_box(const Font& font,
               const std::vector<Line>& lines,
               const Style& style) {
  const double scale = style.size().raw / 64.0 / font.units_per_em();
  const double cosine = scale * from_q30(style.direction().cosine);
  const double sine = scale * from_q30(style.direction().sine);
  InkBox box;
  bool inked = false;
  const auto add = [&](int x, int y) {
    const double right = x * cosine - y * sine;
    const double down = -(x * sine + y * cosine);
    box.x0 = inked ? std::min(box.x0, right) : right;
    box.x1 = inked ? std::max(box.x1, right) : right;
    box.y0 = inked ? std::min(box.y0, down) : down;
    box.y1 = inked ? std::max(box.y1, down) : down;
    inked = true;
  };
  for (const Line& line : lines) {
    for (const PositionedGlyph& at : line.glyphs) {
      GlyphMetrics glyph;
      if (font.glyph_metrics(at.glyph, glyph) != Status::ok ||
          glyph.x_max <= glyph.x_min) {
        continue;
      }
      add(at.x + glyph.x_min, line.y + glyph.y_min);
      add(at.x + glyph.x_max, line.y + glyph.y_min);
      add(at.x + glyph.x_min, line.y + glyph.y_max);
      add(at.x + glyph.x_max, line.y + glyph.y_max);
    }
  }
  return box;
}

std::vector<Point> line_origins(const Font& font,
                                const std::vector<Line>& lines,
                                const Style& style,
                                Point origin) {
  const double em = style.size().raw / 64.0;
  const Direction direction = style.direction();
  std::vector<Point> origins;
  for (const Line& line : lines) {
    const double up = em * line.y / font.units_per_em();
    const Point shift = make_point(-up * from_q30(direction.sine),
                                   -up * from_q30(direction.cosine));
    origins.push_back({Q26_6::from_raw(origin.x.raw + shift.x.raw),
                       Q26_6::from_raw(origin.y.raw + shift.y.raw)});
  }
  return origins;
}

void draw_lines(const Font& font,
                const std::vector<Line>& lines,
                const std::vector<Point>& origins,
                const Style& style,
                const Sink& sink) {
  for (size_t i = 0; i < lines.size(); ++i) {
    const std::vector<PositionedGlyph>& glyphs = lines[i].glyphs;
    Painter(sink).glyphs(font, style, origins[i],
                         {glyphs.data(), glyphs.size()});
  }
}

void draw_lines(const Font& font,
                const std::vector<Line>& lines,
                const Style& style,
                Point origin,
                Image& image,
                DrawStats* stats,
                int32_t rows) {
  if (image.width > kMaxSide || image.height > kMaxSide) {
    throw std::runtime_error("pictures are at most 32767 px wide and high");
  }
  const std::vector<Point> origins = line_origins(font, lines, style, origin);
  Scene scene{font, lines, origins, style, image, stats};
  const int32_t stride = image.width * image.channels;
  std::vector<uint8_t> buffer(static_cast<size_t>(stride) *
                              static_cast<size_t>(rows));
  port::StripLoop loop;
  loop.buffer = {buffer.data(), buffer.size()};
  loop.width = image.width;
  loop.height = image.height;
  loop.format = image.channels == 1 ? port::PixelFormat::grey8
                                    : port::PixelFormat::rgb888;
  loop.context = &scene;
  loop.display = &scene;
  loop.draw = draw_strip;
  loop.flush = flush_strip;
  if (run_strips(loop) != Status::ok) {
    throw std::runtime_error("a picture is at least 1 px wide and high");
  }
}

Point make_point(double x, double y) {
  // Written so that NaN is refused, too.
  if (!(std::abs(x) <= kMaxPosition && std::abs(y) <= kMaxPosition)) {
    throw std::runtime_error("positions lie within 16777215 px of the origin");
  }
  return {Q26_6::from_raw(static_cast<int32_t>(std::lround(x * 64))),
          Q26_6::from_raw(static_cast<int32_t>(std::lround(y * 64)))};
}

bool has_layers(const Font& font) {
  return font.section(format::section::kLayers).size != 0;
}

void draw_colours(const Font& font,
                  const std::vector<Line>& lines,
                  const Style& style,
                  Point origin,
                  uint32_t ink,
                  Image& image) {
  Strip strip;
  strip.pixels = {image.pixels.data(), image.pixels.size()};
  strip.width = image.width;
  strip.height = image.height;
  strip.stride = 3 * image.width;
  port::Rgb888Canvas canvas(strip, ink);
  if (canvas.status() != Status::ok) {
    throw std::runtime_error("a picture of colours is at most 21845 px wide");
  }
  const ColourGlyphs colours(port::colour_of(canvas));
  const Painter painter(canvas, {}, &colours);
  const std::vector<Point> origins = line_origins(font, lines, style, origin);
  for (size_t i = 0; i != lines.size(); ++i) {
    painter.glyphs(font, style, origins[i],
                   {lines[i].glyphs.data(), lines[i].glyphs.size()});
  }
}

}  // namespace inkcell::tools
