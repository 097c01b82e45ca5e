#include "settings.hpp"

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <tuple>

#include "boards.hpp"
#include "player.hpp"

namespace inkcell::tools {
namespace {

constexpr int kMaxScreen = 2048;  // [px]

using Words = std::vector<std::string>;

[[noreturn]] void refuse(const std::string& value, const std::string& allowed) {
  throw std::runtime_error("'" + value + "': " + allowed);
}

double number_in(const std::string& value, double low, double high) {
  size_t end = 0;
  double number = NAN;
  try {
    number = std::stod(value, &end);
  } catch (const std::exception&) {
    end = 0;
  }
  if (end == 0 || end != value.size() || !(number >= low && number <= high)) {
    char range[64];
    std::snprintf(range, sizeof range, "a number from %g to %g", low, high);
    refuse(value, range);
  }
  return number;
}

int whole_in(const std::string& value, int low, int high) {
  const double number = number_in(value, low, high);
  if (number != std::floor(number)) {
    refuse(value, "a whole number");
  }
  return static_cast<int>(number);
}

std::string word_in(const std::string& value, const Words& words) {
  std::string known;
  for (const std::string& word : words) {
    if (word == value) {
      return value;
    }
    known += " " + word;
  }
  refuse(value, "one of" + known);
}

bool switch_in(const std::string& value) {
  return word_in(value, {"on", "off"}) == "on";
}

void set_size(Settings& settings, const std::string& value) {
  int width = 0;
  int height = 0;
  int end = 0;
  if (std::sscanf(value.c_str(), "%dx%d%n", &width, &height, &end) != 2 ||
      static_cast<size_t>(end) != value.size() || width < 16 || height < 8 ||
      width > kMaxScreen || height > kMaxScreen || width % 8 != 0 ||
      height % 8 != 0) {
    refuse(value,
           "WIDTHxHEIGHT in px, multiples of 8 from 16x8 to 2048x2048, such as "
           "128x64");
  }
  settings.width = width;
  settings.height = height;
  settings.board.clear();
}

void set_shift(Settings& settings, const std::string& value) {
  const size_t comma = value.find(',');
  if (comma == std::string::npos) {
    refuse(value, "X,Y in px");
  }
  settings.shift_x = number_in(value.substr(0, comma), -2048, 2048);
  settings.shift_y = number_in(value.substr(comma + 1), -2048, 2048);
}

void set_text(Settings& settings, const std::string& value) {
  settings.text.clear();
  for (size_t i = 0; i < value.size(); ++i) {
    const bool is_feed = value.compare(i, 2, "\\n") == 0;
    settings.text += is_feed ? '\n' : value[i];
    i += is_feed ? 1 : 0;
  }
}

std::string known_scenes() {
  std::string names;
  for (const std::string& name : scene_names()) {
    names += (names.empty() ? "" : " ") + name;
  }
  return names;
}

}  // namespace

std::vector<std::string> scene_names() {
  std::vector<std::string> names = {kTextScene, kDemoScene};
  for (const SceneKind& kind : scene_kinds()) {
    names.emplace_back(kind.name);
  }
  return names;
}

bool draws_same(const Settings& a, const Settings& b) {
  const auto all = [](const Settings& s) {
    return std::tie(s.scene, s.board, s.display, s.width, s.height, s.rows,
                    s.frame, s.text, s.coding, s.px, s.filter, s.hint, s.weight,
                    s.angle, s.shift_x, s.shift_y, s.is_dark);
  };
  return all(a) == all(b);
}

void choose_scene(Settings& settings, const std::string& name) {
  if (name == kTextScene) {
    settings.text = Settings().text;
  } else if (name == kDemoScene) {
    if (settings.board.empty()) {
      choose_board(settings, board_displays().front()->name);
    }
  } else {
    bool is_known = false;
    for (const SceneKind& kind : scene_kinds()) {
      if (kind.name == name) {
        settings.text = kind.text;
        is_known = true;
      }
    }
    if (!is_known) {
      refuse(name, "no such scene; there are " + known_scenes());
    }
  }
  settings.scene = name;
  settings.frame = 0;
}

void choose_board(Settings& settings, const std::string& name) {
  if (name == "none") {
    settings.board.clear();
  } else {
    const BoardDisplay& board = find_board(name);
    settings.board = board.name;
    settings.display = display_of(board.display);
    settings.width = board.width;
    settings.height = board.height;
    settings.rows = board.rows;
  }
  if (settings.board.empty() && settings.scene == kDemoScene) {
    choose_scene(settings, kTextScene);
  }
}

void choose_display(Settings& settings, Display display) {
  settings.display = display;
  choose_board(settings, "none");
}

const std::vector<SettingInfo>& setting_list() {
  static const std::vector<SettingInfo> list = {
      {"board", "NAME", "display, size and strips of a board; none",
       choose_board},
      {"scene", "NAME", "text, demo (of a board), path, clock, ...",
       choose_scene},
      {"display", "NAME",
       "mono, mono_pages, grey2, grey4, grey8, rgb565, xrgb8888 or lcd",
       [](Settings& s, const std::string& value) {
         choose_display(s, display_of(value));
       }},
      {"size", "WxH", "of the display [px]", set_size},
      {"rows", "N", "of a strip",
       [](Settings& s, const std::string& value) {
         s.rows = whole_in(value, 1, kMaxScreen);
       }},
      {"theme", "dark|light", "white text on black, or black on white",
       [](Settings& s, const std::string& value) {
         s.is_dark = word_in(value, {"dark", "light"}) == "dark";
       }},
      {"text", "TEXT", "what the scene shows; \\n begins a line", set_text},
      {"coding", "NAME", "of the font: outline or field",
       [](Settings& s, const std::string& value) {
         s.coding = word_in(value, {"outline", "field"});
       }},
      {"px", "SIZE", "of text [px/em]",
       [](Settings& s, const std::string& value) {
         s.px = number_in(value, 4, 1024);
       }},
      {"filter", "NAME", "text, motion, paper_display, paper_body or area",
       [](Settings& s, const std::string& value) {
         s.filter = word_in(
             value, {"text", "motion", "paper_display", "paper_body", "area"});
       }},
      {"hint", "NAME",
       "grid fitting: none, vertical, both, auto, or display, as its canvas",
       [](Settings& s, const std::string& value) {
         s.hint =
             word_in(value, {"none", "vertical", "both", "auto", "display"});
       }},
      {"weight", "PX", "how far edges move outwards",
       [](Settings& s, const std::string& value) {
         s.weight = number_in(value, -2, 2);
       }},
      {"angle", "DEGREES", "of the baseline, counter-clockwise",
       [](Settings& s, const std::string& value) {
         s.angle = number_in(value, -360, 360);
       }},
      {"shift", "X,Y", "of text, from the middle of the display [px]",
       set_shift},
      {"frame", "N", "of a scene that moves, 30 a second",
       [](Settings& s, const std::string& value) {
         s.frame = static_cast<uint32_t>(whole_in(value, 0, 1000000));
       }},
      {"zoom", "N", "pixels of the screen a pixel; 0: fills the window",
       [](Settings& s, const std::string& value) {
         s.zoom = whole_in(value, 0, 64);
       }},
      {"grid", "on|off", "lines between enlarged pixels",
       [](Settings& s, const std::string& value) {
         s.has_grid = switch_in(value);
       }},
      {"overlay", "on|off", "cells of text, or the points of its outlines",
       [](Settings& s, const std::string& value) {
         s.has_overlay = switch_in(value);
       }},
  };
  return list;
}

void set_option(Settings& settings,
                const std::string& name,
                const std::string& value) {
  for (const SettingInfo& info : setting_list()) {
    if (name == info.name) {
      info.set(settings, value);
      return;
    }
  }
  throw std::runtime_error("command '" + name + "' is not known; see --help");
}

}  // namespace inkcell::tools
