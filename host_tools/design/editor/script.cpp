#include "editor/script.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

#include "editor/actions.hpp"
#include "editor/glyph_set.hpp"
#include "editor/latency.hpp"
#include "editor/lua_run.hpp"
#include "editor/masters.hpp"
#include "editor/report.hpp"
#include "export/rom.hpp"
#include "import/image_import.hpp"
#include "model/error.hpp"
#include "shape/points.hpp"
#include "stroke/nib.hpp"

namespace inkcell::design::editor {
namespace {

constexpr int kMostRuns = 1000;

using Words = std::vector<std::string>;

struct Line {
  Editor& editor;
  Words words;       // after the command
  std::string rest;  // as one text
  const Screenshot& screenshot;
};

using Handler = void (*)(const Line&);

double number(const Line& line, size_t i) {
  try {
    return std::stod(line.words.at(i));
  } catch (const std::exception&) {
    throw Error("argument " + std::to_string(i + 1) + " must be a number");
  }
}

const std::string& word(const Line& line, size_t i) {
  if (i >= line.words.size()) {
    throw Error("argument " + std::to_string(i + 1) + " is missing");
  }
  return line.words[i];
}

// Points are numbered through all contours.
PointId point_of(const Line& line, size_t i) {
  const double value = number(line, i);
  auto left = static_cast<size_t>(std::max(value, 0.0));
  const GlyphPointer glyph = line.editor.glyph();
  for (size_t c = 0; c < glyph->contours.size(); ++c) {
    const size_t count = glyph->contours[c].points.size();
    if (left < count) {
      return {c, left};
    }
    left -= count;
  }
  throw Error("point " + line.words[i] + ": glyph '" +
              line.editor.glyph_name() + "' has fewer");
}

// The pointer of a line, which is where it is shown.
Pointer pointer(const Line& line, size_t first) {
  Pointer pointer;
  pointer.at = {number(line, first), number(line, first + 1)};
  pointer.reach = kReach / line.editor.view.scale;
  line.editor.hover = pointer.at;
  const auto has = [&line](const char* word) {
    return std::find(line.words.begin(), line.words.end(), word) !=
           line.words.end();
  };
  pointer.shift = has("shift");
  pointer.alt = has("alt");
  pointer.free = has("free");
  pointer.twice = has("twice");
  return pointer;
}

void open(const Line& line) {
  const bool has_project = line.words.size() > 1 && line.words[1] != "-";
  line.editor.open(word(line, 0), has_project ? line.words[1] : "",
                   line.words.size() > 2
                       ? Words(line.words.begin() + 2, line.words.end())
                       : Words());
}

void make_font(const Line& line) {
  line.editor.create(word(line, 0),
                     {{"familyName", word(line, 2)},
                      {"unitsPerEm", number(line, 3)},
                      {"ascender", number(line, 4)},
                      {"descender", number(line, 5)},
                      {"xHeight", number(line, 6)},
                      {"capHeight", number(line, 7)}},
                     word(line, 1));
}

void select(const Line& line) {
  line.editor.selection.clear();
  for (size_t i = 0; i < line.words.size(); ++i) {
    line.editor.selection.insert(point_of(line, i));
  }
}

void drag(const Line& line) {
  const PointId id = point_of(line, 0);
  const GlyphPoint point =
      line.editor.glyph()->contours[id.contour].points[id.point];
  Pointer at = pointer(line, 1);
  const Point to = {point.x + at.at.x, point.y + at.at.y};
  line.editor.set_tool(ToolKind::select);
  at.at = {point.x, point.y};
  at.free = true;
  line.editor.tool().press(line.editor, at);
  at.at = to;
  line.editor.tool().drag(line.editor, at);
  line.editor.tool().release(line.editor, at);
}

void set_tool(const Line& line) {
  for (const ToolInfo& tool : tool_list()) {
    if (word(line, 0) == tool.name) {
      line.editor.set_tool(tool.kind);
      return;
    }
  }
  throw Error("tool '" + line.words[0] + "' is not known");
}

void choose_master(const Line& line) {
  const Project& project = line.editor.project();
  for (size_t i = 0; i < project.layers.size(); ++i) {
    if (master_name(project, i) == line.rest) {
      line.editor.choose_master(i);
      return;
    }
  }
  throw Error("master '" + line.rest + "': the project has no such layer");
}

void set_preview(const Line& line) {
  PreviewSettings& settings = line.editor.preview;
  settings.glyph_px = number(line, 0);
  settings.display = tools::display_of(word(line, 1));
  settings.dark = line.words.size() > 2 && line.words[2] == "dark";
}

void set_sizes(const Line& line) {
  std::vector<double>& sizes = line.editor.preview.text_px;
  sizes.clear();
  for (size_t i = 0; i < line.words.size(); ++i) {
    sizes.push_back(number(line, i));
  }
  if (sizes.empty()) {
    throw Error("sizes are numbers of px/em");
  }
}

void set_cells(const Line& line) {
  const std::string& state = word(line, 0);
  if (state != "on" && state != "off") {
    throw Error("cells are on or off, not '" + state + "'");
  }
  line.editor.preview.cells = state == "on";
}

void set_nib(const Line& line) {
  const Nib nib = parse_nib(word(line, 0));
  line.editor.nib = {nib.kind == Nib::Kind::rectangle, nib.width, nib.height,
                     180 / gen::kPi * nib.angle};
}

Preview preview_of(const Line& line) {
  Preview preview = draw_preview(line.editor.preview_job());
  if (!preview.error.empty()) {
    throw Error(preview.error);
  }
  return preview;
}

void save_preview(const Line& line) {
  const Preview preview = preview_of(line);
  const std::filesystem::path file = word(line, 0);
  if (file.extension() == ".bin") {
    write_bytes(file, preview.rom);
  } else {
    tools::write_image(file, preview.lines.at(0).image);
  }
}

void save(const Line& line) {
  if (line.words.empty()) {
    line.editor.save();
  } else {
    line.editor.export_to(line.words[0]);
  }
}

void print(const Line& line) {
  std::printf("%s\n", report_of(line.editor, preview_of(line)).dump().c_str());
}

void try_line(const Line& line) {
  try {
    run_script_line(line.editor, line.rest, line.screenshot);
  } catch (const std::exception& error) {
    line.editor.message = {error.what(), true};
  }
}

void print_latencies(const Line& line) {
  const double runs = number(line, 0);
  if (!(runs >= 1 && runs <= kMostRuns)) {
    throw Error("runs are 1 to " + std::to_string(kMostRuns));
  }
  const Value report =
      report_of(measure_latencies(line.editor, static_cast<int>(runs)));
  std::printf("%s\n", report.dump().c_str());
}

struct Command {
  ScriptCommand text;
  Handler handler;
  bool needs_glyph = true;
};

const std::vector<Command>& command_list() {
  static const std::vector<Command> list = {
      {{"open", "FONT [PROJECT|-] [CHARS]...", "open a UFO, TTF or OTF"},
       open,
       false},
      {{"new", "P.ufo GLYPHS NAME EM ASCENDER DESCENDER XHEIGHT CAPHEIGHT",
        "make a project with glyphs A-Z,U+20 and open it"},
       make_font,
       false},
      {{"sample", "", "open the sample project, Sample.ufo"},
       [](const Line& l) { l.editor.open_sample(); },
       false},
      {{"add", "GLYPHS", "add glyphs: A-Z,U+B0 or a name, _stem"},
       [](const Line& l) {
         l.editor.run(add_glyphs(l.editor.project(), l.rest));
       }},
      {{"save_as", "P.ufo", "save as another project"},
       [](const Line& l) { l.editor.save_as(word(l, 0)); }},
      {{"add_master", "NAME", "save the project with another master"},
       [](const Line& l) { l.editor.add_master(l.rest); }},
      {{"remove_master", "NAME", "save the project without a master"},
       [](const Line& l) { l.editor.remove_master(l.rest); }},
      {{"bold_master", "UNITS NAME",
        "the same, with stems that are wider by so many units"},
       [](const Line& l) { l.editor.add_master(word(l, 1), number(l, 0)); }},
      {{"master", "NAME", "edit a master, by the name of its layer"},
       choose_master},
      {{"between", "PART", "show the glyph between the masters, 0 to 1"},
       [](const Line& l) { l.editor.part_between = number(l, 0); }},
      {{"glyph", "NAME", "show a glyph, by its name or character"},
       [](const Line& l) { l.editor.show(word(l, 0)); },
       false},
      {{"select", "POINT...", "select points, counted through all contours"},
       select},
      {{"drag", "POINT DX DY [shift]", "drag a point, which does not snap"},
       drag},
      {{"key", "KEY", "press a key: ctrl+z, shift+left, delete, v"},
       [](const Line& l) {
         if (!press_key(l.editor, word(l, 0))) {
           throw Error("key '" + l.words[0] + "' does nothing");
         }
       }},
      {{"action", "NAME", "carry out an item of the menus: Unite"},
       [](const Line& l) { action(l.rest).run(l.editor); }},
      {{"tool", "NAME", "choose a tool, as the window names it"}, set_tool},
      {{"press", "X Y [shift] [alt] [twice]",
        "press the pointer, in font units"},
       [](const Line& l) { l.editor.tool().press(l.editor, pointer(l, 0)); }},
      {{"move", "X Y [shift] [free]", "move the pressed pointer"},
       [](const Line& l) { l.editor.tool().drag(l.editor, pointer(l, 0)); }},
      {{"release", "X Y",
        "release the pointer; it is where the last move put it"},
       [](const Line& l) { l.editor.tool().release(l.editor, pointer(l, 0)); }},
      {{"hover", "X Y", "move the pointer that is not pressed"},
       [](const Line& l) { pointer(l, 0); }},
      {{"nib", "ellipse:W,H,ANGLE", "choose the nib of the Stroke tool"},
       set_nib},
      {{"try", "LINE", "carry out a line; what is wrong becomes the message"},
       try_line,
       false},
      {{"do", "COMMAND", "carry out a command of the design library"},
       [](const Line& l) {
         const Value command = Value::parse(l.rest, nullptr, false);
         if (!command.is_object()) {
           throw Error("a command is a JSON object");
         }
         l.editor.run(command);
       }},
      {{"lua", "FILE.lua [NAME=NUMBER]...", "carry out a program in Lua"},
       [](const Line& l) {
         ScriptOptions options;
         for (size_t i = 1; i < l.words.size(); ++i) {
           add_setting(l.words[i], options);
         }
         l.editor.run(
             run_lua(l.editor.project(), word(l, 0), options.settings).command);
       }},
      {{"background", "FILE.png", "put a picture behind the glyph"},
       [](const Line& l) {
         l.editor.run(image_command(l.editor.project(), word(l, 0)));
       }},
      {{"preview", "PX DISPLAY [light|dark]",
        "choose the size of the glyph's preview, and the display"},
       set_preview},
      {{"sizes", "PX...", "choose the sizes of the preview's text"}, set_sizes},
      {{"text", "TEXT", "choose the preview's text"},
       [](const Line& l) { l.editor.preview.text = l.rest; }},
      {{"cells", "on|off", "show the cells of the quadtree"}, set_cells},
      {{"save_preview", "FILE.png|FILE.bin",
        "write the text as the display shows it, in the first of its sizes, or "
        "its font"},
       save_preview},
      {{"print", "", "print the glyph and its figures as JSON"}, print},
      {{"latency", "RUNS",
        "print how long a drag, the device's preview and a stroke take"},
       print_latencies},
      {{"screenshot", "FILE.png", "write a picture of the window"},
       [](const Line& l) { l.screenshot(l.editor, word(l, 0)); },
       false},
      {{"save", "[COPY.ufo]", "save the project, or a copy of it"}, save},
      {{"export", "FILE.ttf|FILE.bin|FILE.ufo", "write the font"},
       [](const Line& l) { l.editor.export_to(word(l, 0)); }},
  };
  return list;
}

}  // namespace

const std::vector<ScriptCommand>& script_commands() {
  static const std::vector<ScriptCommand> list = [] {
    std::vector<ScriptCommand> all;
    for (const Command& command : command_list()) {
      all.push_back(command.text);
    }
    return all;
  }();
  return list;
}

void run_script_line(Editor& editor,
                     const std::string& text,
                     const Screenshot& screenshot) {
  std::istringstream in(text);
  std::string name;
  if (!(in >> name) || name[0] == '#') {
    return;
  }
  Line line{editor, {}, {}, screenshot};
  std::getline(in >> std::ws, line.rest);
  std::istringstream rest(line.rest);
  for (std::string word; rest >> word;) {
    line.words.push_back(word);
  }
  for (const Command& command : command_list()) {
    if (name == command.text.name) {
      if (command.needs_glyph && editor.glyph() == nullptr) {
        throw Error("no glyph is shown; open a font first");
      }
      command.handler(line);
      return;
    }
  }
  throw Error("command '" + name + "' is not known; see --help");
}

void run_script(Editor& editor,
                const std::filesystem::path& file,
                const Screenshot& screenshot) {
  std::ifstream in(file);
  if (!in) {
    throw Error(file.string() + ": cannot be read");
  }
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    try {
      run_script_line(editor, line, screenshot);
    } catch (const std::exception& error) {
      throw Error(file.string() + ":" + std::to_string(number) + ": " +
                  error.what());
    }
  }
}

}  // namespace inkcell::design::editor
