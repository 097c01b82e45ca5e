// The faces that --merge adds, as the command line has them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "source/char_set.hpp"
#include "source/icon_place.hpp"
#include "source/variation.hpp"

namespace inkcell::gen {

/// A face that gives characters which the faces before it do not.
struct MergedFace {
  std::filesystem::path file;
  std::optional<int> face;  // none: the first
  std::string instance;
  std::vector<AxisSetting> axes;
  /// The characters it is asked for; none: those that are still missing.
  CharSet characters;
  /// Where its glyphs stand: on their own baseline, or as `place` says of the
  /// face's em square. By kind: icons as `place` says, others on their own.
  enum class Baseline { by_kind, own, placed };
  Baseline baseline = Baseline::by_kind;
  /// Its height scales the face, wherever its glyphs stand.
  IconPlace place;
};

/// Reads "FILE[:SETTING,...][=LIST]" with a list of add_ranges and settings
/// TAG=VALUE, instance=NAME, face=N, height=em|cap|NUMBER and
/// baseline=own|middle|bottom|NUMBER. Text that is a file's name as a whole, or
/// up to its last '=', has no settings. Throws Error.
MergedFace parse_merged_face(const std::string& text);

}  // namespace inkcell::gen
