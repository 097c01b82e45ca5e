// inkcell-render: draws text with the device's core into PNG or PGM files.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "canvas.hpp"
#include "convert.hpp"
#include "files.hpp"
#include "inkcell/truetype/truetype_font.hpp"
#include "look.hpp"
#include "program.hpp"
#include "render_jobs.hpp"

namespace inkcell::tools {
namespace {

// The margin around the ink by default. The widest filter needs less than one
// of these pixels; the other one holds a shift by --dx, --dy, so that all
// phases of a text give pictures of one size.
constexpr int kMargin = 2;
constexpr double kShiftInMargin = 1;  // [px]

struct Arguments {
  gen::GenerateRequest request;
  std::string font;
  std::string run_time;
  std::string text;
  std::string jobs;
  std::string out;
  LookOptions look;
  double px = 0;
  double angle = 0;
  double dx = 0;  // [1/64 px]
  double dy = 0;
  std::optional<double> ox;  // [px]
  std::optional<double> oy;
  std::optional<double> wrap;  // [px]
  std::string align = "start";
  std::optional<int> width;
  std::optional<int> height;
  int zoom = 1;
  int rows = kStripRows;
  bool inverted = false;
  std::string kerning;  // on, off, or empty
  bool stats = false;
};

void add_placement(CLI::App& app, Arguments& arguments) {
  app.add_option("--dx", arguments.dx, "Shift to the right [1/64 px]");
  app.add_option("--dy", arguments.dy, "Shift down [1/64 px]");
  app.add_option("--angle", arguments.angle,
                 "Direction of the baseline, counter-clockwise [degrees]");
  app.add_option("--width", arguments.width, "Of the picture [ink + 4 px]")
      ->check(CLI::Range(1, 32767));
  app.add_option("--height", arguments.height, "Of the picture [ink + 4 px]")
      ->check(CLI::Range(1, 32767));
  app.add_option("--ox", arguments.ox, "Left end of the baseline [px]");
  app.add_option("--oy", arguments.oy, "Height of the baseline, y down [px]");
}

void add_arguments(CLI::App& app, Arguments& arguments) {
  app.add_option("--font", arguments.font,
                 "ROM font, or TTF, OTF, WOFF, WOFF2, BDF, PCF or hex, which "
                 "are converted in memory")
      ->type_name("FILE");
  app.add_option("--run-time", arguments.run_time,
                 "Instead of --font: a TrueType file that is drawn as it is,\n"
                 "by --filter area")
      ->type_name("FILE.ttf");
  app.add_option("--text", arguments.text,
                 "What to draw; a line feed begins a new line");
  app.add_option("--px", arguments.px, "Size, may be fractional [px/em]");
  app.add_option("--jobs", arguments.jobs,
                 "Draw one picture for each line, a JSON object of font, text, "
                 "size [px/em], w, h [px] and out; ox, oy [px], dx, dy "
                 "[1/64 px], angle [degrees] and kind [static, or anim] may be "
                 "left out")
      ->type_name("FILE.jsonl");
  app.add_option(
         "--out", arguments.out,
         "The picture, .png or .pgm: 255 is full ink; with --lcd .png or "
         ".ppm; .png in colours if glyphs of the font have layers")
      ->type_name("FILE");
  add_look_options(app, arguments.look);
  add_placement(app, arguments);
  app.add_option("--wrap", arguments.wrap,
                 "Break lines where they would be wider [px]")
      ->check(CLI::Range(1, 32767));
  app.add_option("--align", arguments.align, "Of lines within --wrap")
      ->check(CLI::IsMember({"start", "left", "centre", "right", "justify"}));
  app.add_option("--kerning", arguments.kerning,
                 "Whether pairs of glyphs are kerned [on; off with --jobs];\n"
                 "--wrap always does")
      ->check(CLI::IsMember({"on", "off"}).description(""))
      ->type_name("on|off");
  app.add_flag("--invert", arguments.inverted, "Black on white");
  app.add_option("--zoom", arguments.zoom, "Draw each pixel N x N")
      ->check(CLI::Range(1, 64));
  app.add_option("--rows", arguments.rows,
                 "Rows of a strip; the picture is the same for every number")
      ->check(CLI::Range(1, 32767));
  app.add_flag("--stats", arguments.stats, "Print what drawing cost");
  add_conversion_options(app, arguments.request);
}

// The position of the text, and the size of its canvas.
struct Placement {
  int width = 0;
  int height = 0;
  Point origin;
};

// One axis of a placement: the ink from `low` to `high`, relative to the
// origin. [px]
struct Extent {
  double origin = 0;  // with the shift
  int side = 0;
};

Extent place(double low,
             double high,
             double shift,
             std::optional<double> origin,
             std::optional<int> side,
             int margin) {
  // Beyond the margin the picture holds the text at both ends of the shift.
  const double beyond = std::abs(shift) <= kShiftInMargin ? 0 : shift;
  const double start =
      origin.value_or(margin - std::floor(low + std::min(beyond, 0.0)));
  const double end = std::ceil(start + high + std::max(beyond, 0.0)) + margin;
  if (!side.has_value() && !(end <= kMaxSide)) {
    throw std::runtime_error(
        "the text ends beyond 32767 px, the largest picture; say --width and "
        "--height, or look at --ox, --oy, --dx and --dy");
  }
  Extent extent;
  extent.origin = start + shift;
  extent.side = side.has_value() ? *side : static_cast<int>(std::max(end, 1.0));
  return extent;
}

Placement place(const Arguments& arguments,
                const InkBox& ink,
                const Look& look) {
  const int margin = kMargin + look.blur_px();
  const Extent x = place(ink.x0, ink.x1, arguments.dx / 64, arguments.ox,
                         arguments.width, margin);
  const Extent y = place(ink.y0, ink.y1, arguments.dy / 64, arguments.oy,
                         arguments.height, margin);
  return {x.side, y.side, make_point(x.origin, y.origin)};
}

Wrapping wrapping_of(const Arguments& arguments) {
  constexpr const char* kNames[] = {"start", "left", "centre", "right",
                                    "justify"};
  Wrapping wrapping;
  if (!arguments.wrap.has_value()) {
    return wrapping;
  }
  if (arguments.kerning == "off") {
    throw std::runtime_error("--kerning off and --wrap exclude each other");
  }
  wrapping.width =
      Q26_6::from_raw(static_cast<int32_t>(std::lround(*arguments.wrap * 64)));
  for (size_t i = 0; i != std::size(kNames); ++i) {
    if (arguments.align == kNames[i]) {
      wrapping.align = static_cast<Align>(i);
    }
  }
  return wrapping;
}

size_t glyph_count(const std::vector<Line>& lines) {
  size_t count = 0;
  for (const Line& line : lines) {
    count += line.glyphs.size();
  }
  return count;
}

// Only near ink: the rest of a picture costs next to nothing.
void print_samples(const SampleTotal& total) {
  if (total.pixels != 0) {
    std::printf(
        "samples          %.2f a pixel near ink\n",
        static_cast<double>(total.samples) / static_cast<double>(total.pixels));
  }
}

// A font and its bytes: a ROM font, made or as it is, or a TrueType file.
class AnyFile {
 public:
  AnyFile(const Arguments& arguments, const Conversion& conversion) {
    if (arguments.run_time.empty()) {
      rom_.emplace(load_font_file(arguments.font, conversion, arguments.text));
      return;
    }
    if (!conversion.option.empty()) {
      throw std::runtime_error("--run-time converts nothing, and takes no " +
                               conversion.option);
    }
    bytes_ = read_file(arguments.run_time);
    const Status status = truetype_.open({bytes_.data(), bytes_.size()});
    if (status != Status::ok) {
      throw std::runtime_error(
          arguments.run_time + ": " +
          (status == Status::unsupported
               ? "its outlines are those of CFF, and --run-time takes "
                 "TrueType's; --font converts it"
               : "it is no whole TrueType file") +
          " (" + std::string(status_name(status)) + ")");
    }
  }

  const Font& font() const {
    return rom_.has_value() ? rom_->font() : truetype_.font();
  }
  // Null: a ROM font.
  const TrueTypeFont* truetype() const {
    return rom_.has_value() ? nullptr : &truetype_;
  }
  size_t size() const {
    return rom_.has_value() ? font().rom().size : bytes_.size();
  }

 private:
  std::optional<RomFile> rom_;
  std::vector<uint8_t> bytes_;
  TrueTypeFont truetype_;
};

void print_stats(const DrawStats& stats,
                 const std::vector<Line>& lines,
                 const Image& image,
                 const AnyFile& file,
                 double seconds) {
  const TrueTypeFont* const truetype = file.truetype();
  const Font& font = file.font();
  std::printf(
      "font             %zu bytes, %u glyphs, coding %s\n", file.size(),
      static_cast<unsigned>(truetype != nullptr ? truetype->glyph_count()
                                                : font.glyph_count()),
      truetype != nullptr ? "TrueType"
                          : std::string(coding_name(font)).c_str());
  std::printf("picture          %d x %d px in %lld strips\n", image.width,
              image.height, static_cast<long long>(stats.strips));
  std::printf("glyphs           %zu\n", glyph_count(lines));
  std::printf("computed pixels  %lld in %lld spans, %lld blocks\n",
              static_cast<long long>(stats.coverage_pixels),
              static_cast<long long>(stats.coverage_spans),
              static_cast<long long>(stats.coverage_blocks));
  std::printf("filled pixels    %lld in %lld runs\n",
              static_cast<long long>(stats.solid_pixels),
              static_cast<long long>(stats.solid_runs));
  std::printf("time             %.3f ms on this machine\n", seconds * 1000);
}

// Other sizes are drawn, but without a tested accuracy.
void warn_of_size(const Font& font, double px) {
  if (coding_name(font) == "strike") {
    return;  // pictures are the same at each size that they have
  }
  const FontRange range = font.range();
  if (px < range.min_px || px > range.max_px) {
    std::fprintf(
        stderr,
        "warning: the font is made for %d to %d px (--min-px, --max-px)\n",
        range.min_px, range.max_px);
  }
}

// Whether the picture shows the colours of glyphs that have several.
bool shows_colours(const Arguments& arguments, const Font& font) {
  return has_layers(font) && arguments.look.lcd == "none" &&
         arguments.look.levels == 256 && !arguments.stats &&
         std::filesystem::path(arguments.out).extension() != ".pgm";
}

// White on black, or the other way around.
Image colour_picture(const Arguments& arguments,
                     const Font& font,
                     const std::vector<Line>& lines,
                     const Style& style,
                     const Placement& placement) {
  constexpr uint32_t kWhite = 0xffffff;
  Image image(placement.width, placement.height, 3);
  if (arguments.inverted) {
    invert(image);
  }
  draw_colours(font, lines, style, placement.origin,
               arguments.inverted ? 0 : kWhite, image);
  return image;
}

void render_text(const Arguments& arguments, const Conversion& conversion) {
  check_image_file(arguments.out, arguments.look.lcd == "none" ? 1 : 3);
  check_apart(
      {arguments.out},
      {arguments.run_time.empty() ? arguments.font : arguments.run_time});
  check_hint(arguments.look, is_turned(arguments.angle), "--angle");
  const AnyFile file(arguments, conversion);
  const Font& font = file.font();
  LookOptions options = arguments.look;
  if (file.truetype() != nullptr) {
    if (!options.filter.empty() && options.filter != "area") {
      throw std::runtime_error(
          "--run-time draws exact coverage, and takes no --filter " +
          options.filter + " but area");
    }
    options.filter = "area";
  }
  const Look look(options, font, arguments.px, arguments.angle, Use::text);
  check_radius(arguments.look, look.uses_radius());
  warn_of_size(font, arguments.px);
  const Style& style = look.style();
  const std::vector<Line> lines =
      lay_out_lines(font, arguments.text,
                    arguments.kerning == "off" ? Kerning::none : Kerning::font,
                    style, wrapping_of(arguments));
  const Placement placement =
      place(arguments, ink_box(font, lines, style), look);
  if (std::max(placement.width, placement.height) * arguments.zoom > kMaxSide) {
    throw std::runtime_error(
        "--zoom makes the picture larger than 32767 px, the largest one");
  }
  if (shows_colours(arguments, font)) {
    const Image image =
        colour_picture(arguments, font, lines, style, placement);
    write_image(arguments.out,
                arguments.zoom == 1 ? image : enlarge(image, arguments.zoom));
    return;
  }
  Image image(placement.width, placement.height, look.channels());
  DrawStats stats;
  const auto begin = std::chrono::steady_clock::now();
  draw_lines(font, lines, style, placement.origin, image,
             arguments.stats ? &stats : nullptr, arguments.rows);
  const std::chrono::duration<double> time =
      std::chrono::steady_clock::now() - begin;
  if (arguments.stats) {
    print_stats(stats, lines, image, file, time.count());
    SampleTotal total;
    add_samples(image, look, total);
    print_samples(total);
  }
  round_to_levels(image, arguments.look.levels);
  if (arguments.inverted) {
    invert(image);
  }
  write_image(arguments.out,
              arguments.zoom == 1 ? image : enlarge(image, arguments.zoom));
}

void run(const Arguments& arguments, const CLI::App& app) {
  const Conversion conversion = conversion_of(app, arguments.request);
  if (!arguments.jobs.empty()) {
    for (const char* option :
         {"--font", "--run-time", "--text", "--px", "--out", "--dx", "--dy",
          "--angle", "--wrap", "--align", "--width", "--height", "--ox", "--oy",
          "--zoom", "--rows"}) {
      if (app.count(option) != 0) {
        throw std::runtime_error(
            std::string("--jobs takes no ") + option +
            ": fonts, texts, sizes, places and outputs are in its file");
      }
    }
    const std::vector<RenderJob> jobs = read_jobs(arguments.jobs);
    const SampleTotal total =
        render_jobs(jobs, conversion, arguments.look,
                    arguments.kerning == "on" ? Kerning::font : Kerning::none,
                    arguments.inverted);
    if (arguments.stats) {
      std::printf("pictures         %zu\n", jobs.size());
      print_samples(total);
    }
    return;
  }
  const char* const font = arguments.run_time.empty() ? "--font" : "--run-time";
  for (const char* option : {font, "--text", "--px", "--out"}) {
    if (app.count(option) == 0) {
      throw std::runtime_error(std::string(option) +
                               " is missing (or use --jobs); see --help");
    }
  }
  render_text(arguments, conversion);
}

}  // namespace
}  // namespace inkcell::tools

int main(int argc, char** argv) {
  CLI::App app("Draws text with Inkcell's device core into a picture.");
  inkcell::tools::Arguments arguments;
  inkcell::tools::add_arguments(app, arguments);
  return inkcell::tools::run_program(app, argc, argv, [&] {
    inkcell::tools::run(arguments, app);
    return 0;
  });
}
