// inkcell-fontgen: makes a ROM font from a font file.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <list>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "app/budget.hpp"
#include "app/encode.hpp"
#include "app/face_options.hpp"
#include "app/options.hpp"
#include "app/output.hpp"
#include "app/report.hpp"
#include "files.hpp"
#include "pipeline/built_glyphs.hpp"
#include "pipeline/generate.hpp"
#include "program.hpp"
#include "progress.hpp"

namespace inkcell::gen {
namespace {

constexpr const char* kAbout =
    R"(Makes a font with which a microcontroller draws text of any size:

    inkcell-fontgen --font DejaVuSans.ttf --symbols 'Hello, 12' --out sans.hpp

sans.hpp has the array fonts::DejaVuSans, with these characters. A program says

    Font::open(fonts::DejaVuSans, font);
    Painter(canvas).text(font, Style(24_px), {4, 28}, "Hello, 12");

For C write --out sans.c --header sans.h. Text that changes takes whole sets,
such as --set latin-1; texts of sources and translations --strings-from
'src/*.c'. Arabic, Indic and Thai are shaped by --strings.
)";

// The options by what they are for.
const std::pair<const char*, std::vector<const char*>> kGroups[] = {
    {"Font, and where it goes",
     {"--font", "--face", "--instance", "--axis", "--out", "--format", "--name",
      "--header", "--section"}},
    {"Characters and texts",
     {"--symbols", "--chars", "--set", "--text-file", "--strings-from",
      "--strings", "--strict", "--no-layout-glyphs", "--shape", "--compose",
      "--keep-layout"}},
    {"More faces, and icons",
     {"--merge", "--svg", "--svg-dir", "--svg-height", "--svg-baseline",
      "--colour"}},
    {"Sizes and quality",
     {"--min-px", "--max-px", "--tolerance", "--best-effort", "--budget",
      "--strike", "--strike-only", "--hints", "--morph", "--band-px",
      "--coding", "--predicate", "--effort", "--paged"}},
    {"Reports and builds",
     {"--report", "--preview", "--depfile", "--part", "--built", "--threads",
      "--quiet"}}};

void group_options(CLI::App& app) {
  for (const auto& [group, options] : kGroups) {
    for (const char* option : options) {
      app.get_option(option)->group(group);
    }
  }
}

struct Arguments {
  GenerateRequest request;
  std::optional<OutputFormat> format;
  std::string name;
  std::string section;
  std::vector<std::string> out;  // one at least
  std::string header;
  std::string report;
  std::string depfile;
  std::string preview;
  std::optional<GlyphPart> part;
  std::vector<std::filesystem::path> built;
  size_t budget = 0;  // [bytes]; 0: none
  bool quiet = false;
};

void add_arguments(CLI::App& app, Arguments& arguments) {
  GenerateRequest& request = arguments.request;
  app.add_option(
         "--font", request.font,
         "Font file: TTF, OTF, TTC, OTC, WOFF, WOFF2, or a bitmap font: BDF, "
         "PCF, .hex of Unifont, .bin of LVGL; needed unless there are "
         "icons")
      ->type_name("FILE");
  app.add_option("--text-file", request.text_files,
                 "Take the characters of a UTF-8 text file; repeatable")
      ->type_name("FILE");
  app.add_option(
         "--strings-from", request.strings_from,
         "Take the characters of translations (.po, .json, .csv) and of "
         "string literals in C and C++ sources: files or patterns such as "
         "'src/**/*.c', in quotes; repeatable")
      ->type_name("PATTERN");
  app.add_option(
         "--strings", request.string_files,
         "Shape the strings of a UTF-8 file, lines of name = text, into "
         "runs of glyphs beside the font; repeatable")
      ->type_name("FILE");
  app.add_flag("--strict", request.strict,
               "Fail if the font lacks a character: the error says which file "
               "and line ask for it");
  add_generator_options(app, request);
  add_face_options(app, request);
  app.add_option_function<std::string>(
         "--format",
         [&arguments](const std::string& value) {
           const std::map<std::string, OutputFormat> formats = {
               {"bin", OutputFormat::bin},
               {"hpp", OutputFormat::hpp},
               {"c", OutputFormat::c}};
           const auto found = formats.find(value);
           if (found == formats.end()) {
             throw CLI::ValidationError(
                 "--format",
                 "'" + value + "' is not known; use 'bin', 'hpp' or 'c'");
           }
           arguments.format = found->second;
         },
         "Form of the output [hpp, a header of C++, if --out ends in .hpp, .h, "
         ".hh or .hxx; c if in .c; else bin]")
      ->type_name("bin|hpp|c");
  app.add_option("--name", arguments.name,
                 "Identifier in hpp and c [from the font file]")
      ->type_name("ID");
  app.add_option_function<std::string>(
         "--section",
         [&arguments](const std::string& name) {
           check_section(name);
           arguments.section = name;
         },
         "Section of the array in hpp and c, such as .ext_flash; in hpp each "
         "font needs one of its own")
      ->type_name("NAME");
  app.add_option_function<std::string>(
         "--budget",
         [&arguments](const std::string& text) {
           arguments.budget = parse_bytes(text);
         },
         "Largest font: take the finest tolerance, of 1/255 to 64/255, that "
         "fits into so many bytes")
      ->type_name("24K")
      ->excludes("--tolerance");
  tools::take_one(
      app.add_option("--out", arguments.out,
                     "A file to write; repeatable: one font in several forms"))
      ->required()
      ->type_name("FILE");
  app.add_option("--header", arguments.header,
                 "With --format c, write a header that declares the font and "
                 "its strings; with --paged one of C++, of what StoredFont "
                 "needs to know")
      ->type_name("FILE");
  app.add_option("--report", arguments.report, "Write the report as JSON")
      ->type_name("FILE");
  app.add_option("--preview", arguments.preview,
                 "Draw every glyph, and below it the bytes it takes and its "
                 "worst error in 1/255")
      ->type_name("FILE.png");
  app.add_option(
         "--depfile", arguments.depfile,
         "Write the files and folders that were read as a rule of Make, "
         "for builds that make the font anew after a change")
      ->type_name("FILE");
  app.add_option_function<std::string>(
         "--part",
         [&arguments](const std::string& text) {
           arguments.part = parse_part(text);
         },
         "Build part K of N of the glyphs, K = 0..N-1; --out is a file for "
         "--built then")
      ->type_name("K/N");
  tools::take_one(
      app.add_option("--built", arguments.built,
                     "Take the glyphs that --part has built with the same "
                     "options, and build the others; repeatable"))
      ->type_name("FILE");
  app.add_option("--threads", request.threads, "Threads [all cores]")
      ->check(CLI::Range(0, 1024).description(""))
      ->type_name("INT");
  app.add_flag("--quiet", arguments.quiet, "No report, no progress");
}

std::string read_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)),
                    std::istreambuf_iterator<char>());
  if (!in.is_open() || in.bad()) {
    throw Error(file.string() + ": cannot be read");
  }
  return bytes;
}

OutputFormat format_of(const Arguments& arguments, const std::string& out) {
  const std::string ending = std::filesystem::path(out).extension().string();
  if (arguments.format.has_value()) {
    return *arguments.format;
  }
  for (const char* source : {".cpp", ".cc", ".cxx"}) {
    if (ending == source) {
      throw Error(out + ": add --format hpp, for C++, or --format c");
    }
  }
  // A header with an array is one of C++: C has it in a source.
  for (const char* header : {".hpp", ".h", ".hh", ".hxx"}) {
    if (ending == header) {
      return OutputFormat::hpp;
    }
  }
  return ending == ".c" ? OutputFormat::c : OutputFormat::bin;
}

// A path in a Makefile rule.
std::string escape(const std::string& path) {
  std::string out;
  for (const char c : path) {
    if (c == ' ' || c == '#' || c == '\\') {
      out += '\\';
    }
    out += c == '$' ? std::string("$$") : std::string(1, c);
  }
  return out;
}

// Folders whose files are icons: one that comes or goes changes the font. Not
// those in which a build writes, too, and would change them each time.
std::vector<std::filesystem::path> watched_folders(const Arguments& arguments) {
  std::vector<std::filesystem::path> folders;
  for (const std::filesystem::path& folder : arguments.request.svg_folders) {
    const auto is_written = [&folder](const std::filesystem::path& out) {
      return tools::is_same_file(folder, tools::folder_of(out));
    };
    if (!is_written("out") &&
        std::none_of(arguments.out.begin(), arguments.out.end(), is_written)) {
      folders.push_back(folder);
    }
  }
  return folders;
}

// A rule for Make and Ninja. Inputs are targets without a rule, too: Make then
// takes one that is gone for changed.
std::string dependencies(const Arguments& arguments) {
  std::vector<std::filesystem::path> inputs = inputs_of(arguments.request);
  for (const std::filesystem::path& folder : watched_folders(arguments)) {
    inputs.push_back(folder);
  }
  std::string rule;
  std::string absent;
  for (const std::string& out : arguments.out) {
    rule += (rule.empty() ? "" : " ") + escape(out);
  }
  rule += ":";
  for (const std::filesystem::path& file : inputs) {
    const std::string path = escape(std::filesystem::absolute(file).string());
    rule += " " + path;
    absent += path + ":\n";
  }
  return rule + "\n" + absent;
}

// Writes all files first, then moves them to their places, the font last: if
// the disk is full, no file appears.
void write_files(const Arguments& arguments, const RomFont& font) {
  std::list<OutputFile> files;
  const auto write = [&files](const std::string& file, const auto& content) {
    if (!file.empty()) {
      files.emplace_back(file).write(content());
    }
  };
  write(arguments.preview, [&] { return encode_png(draw_preview(font)); });
  write(arguments.header, [&] {
    return arguments.request.paged != 0
               ? encode_stored_header(font, arguments.name)
               : encode_c_header(font, arguments.name);
  });
  write(arguments.report, [&] { return report_as_json(font.report); });
  write(arguments.depfile, [&] { return dependencies(arguments); });
  for (const std::string& out : arguments.out) {
    write(out, [&] {
      return encode(font, format_of(arguments, out), arguments.name,
                    arguments.section);
    });
  }
  for (OutputFile& file : files) {
    file.commit();
  }
}

// Refuses formats that cannot hold what was asked for.
void check_forms(const Arguments& arguments) {
  const bool is_stored = arguments.request.paged != 0;
  bool has_c = false;
  bool has_bin = false;
  for (const std::string& out : arguments.out) {
    const OutputFormat format = format_of(arguments, out);
    has_c = has_c || format == OutputFormat::c;
    has_bin = has_bin || format == OutputFormat::bin;
    if (is_stored && format != OutputFormat::bin) {
      throw Error(out +
                  ": a font of --paged is read from storage, and no array of a "
                  "program; write the font to --out " +
                  arguments.name + ".bin and its numbers to --header " +
                  arguments.name + ".hpp, or leave --paged out");
    }
  }
  if (arguments.format.has_value() && arguments.out.size() > 1) {
    throw Error(
        "--format: with more than one --out the ending of each says its form, "
        ".hpp or .h, .c, or another one, which is bin; leave --format out");
  }
  if (!arguments.header.empty() && !has_c && !is_stored) {
    throw Error(
        "--header is for --format c and for --paged; --format hpp is a header");
  }
  if (!arguments.section.empty() && has_bin) {
    throw Error("--section: --format bin has no array; use hpp or c");
  }
  if (!arguments.request.string_files.empty() && has_bin) {
    throw Error(
        "--strings: --format bin has no place for runs of glyphs; use hpp or "
        "c");
  }
}

// Refuses, before work begins, what would fail or do harm later.
void check_files(const Arguments& arguments) {
  std::vector<std::filesystem::path> targets(arguments.out.begin(),
                                             arguments.out.end());
  for (const std::string& file : {arguments.header, arguments.report,
                                  arguments.depfile, arguments.preview}) {
    targets.emplace_back(file);
  }
  for (const std::filesystem::path& file : targets) {
    if (!file.empty()) {
      check_writable(file);
    }
  }
  tools::check_apart(targets, inputs_of(arguments.request));
}

// Measures the bytes of a wide band against the font without it.
void measure_band(const GenerateRequest& request, FontReport& report) {
  if (request.target.band_px != 0) {
    GenerateRequest usual = request;
    usual.target.band_px = 0;
    report.band_bytes =
        static_cast<int64_t>(report.bytes.total()) -
        static_cast<int64_t>(generate(usual).report.bytes.total());
  }
}

// Makes the finest font that fits, with a line for each trial, or the font as
// asked for.
RomFont make_font(const Arguments& arguments,
                  std::optional<tools::Progress>& progress) {
  if (arguments.budget != 0) {
    return generate_within(arguments.request, arguments.budget,
                           [&](const std::string& line) {
                             if (!arguments.quiet) {
                               progress.emplace(false);
                               std::fprintf(stderr, "%s\n", line.c_str());
                             }
                           });
  }
  RomFont font = generate(arguments.request);
  if (!arguments.quiet || !arguments.report.empty()) {
    measure_band(arguments.request, font.report);
  }
  return font;
}

// Refuses what --part has no use for.
void check_part(const Arguments& arguments) {
  if (!arguments.part) {
    return;
  }
  if (arguments.budget != 0 || arguments.out.size() != 1 ||
      arguments.request.target.coding != Coding::outline) {
    throw Error(
        "--part: glyphs of outlines are built into one --out, without "
        "--budget; leave --part out");
  }
}

void build_part(const Arguments& arguments) {
  generate_part(arguments.request, *arguments.part);
  OutputFile out(arguments.out[0]);
  out.write(arguments.request.built_glyphs->bytes());
  out.commit();
}

void make_files(const Arguments& arguments,
                std::optional<tools::Progress>& progress) {
  const RomFont font = make_font(arguments, progress);
  progress.reset();
  for (const Warning& warning : font.warnings) {
    std::fprintf(stderr, "%s\n", warning.message().c_str());
  }
  write_files(arguments, font);
  if (!arguments.quiet) {
    std::fputs(report_for_people(font.report).c_str(), stdout);
  }
}

void run(Arguments& arguments) {
  if (arguments.name.empty()) {
    const std::filesystem::path& font = arguments.request.font;
    arguments.name = identifier_of(font.empty() ? "icons" : font);
  }
  check_identifier(arguments.name);
  check_part(arguments);
  check_forms(arguments);
  check_files(arguments);
  BuiltGlyphs built;
  for (const std::filesystem::path& file : arguments.built) {
    built.add(read_file(file), file.string());
  }
  if (arguments.part || !arguments.built.empty()) {
    arguments.request.built_glyphs = &built;
  }
  std::optional<tools::Progress> progress(arguments.quiet);
  arguments.request.progress = [&](size_t done, size_t count) {
    progress->update(done, count);
  };
  if (arguments.part) {
    build_part(arguments);
  } else {
    make_files(arguments, progress);
  }
}

}  // namespace
}  // namespace inkcell::gen

int main(int argc, char** argv) {
  CLI::App app(inkcell::gen::kAbout);
  inkcell::gen::Arguments arguments;
  inkcell::gen::add_arguments(app, arguments);
  inkcell::gen::group_options(app);
  return inkcell::tools::run_program(app, argc, argv, [&] {
    inkcell::gen::run(arguments);
    return 0;
  });
}
