#include "editor/editor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/edits.hpp"
#include "editor/glyph_set.hpp"
#include "editor/masters.hpp"
#include "editor/parts.hpp"
#include "editor/sample.hpp"
#include "editor/spacing.hpp"
#include "editor/strokes.hpp"
#include "export/designspace.hpp"
#include "export/rom.hpp"
#include "export/ttf.hpp"
#include "import/font_import.hpp"
#include "model/command_table.hpp"
#include "model/commands.hpp"
#include "model/error.hpp"
#include "rom_file.hpp"
#include "shape/points.hpp"
#include "stroke/nib.hpp"

namespace inkcell::design::editor {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPreviewTextKey = "org.inkcell.previewText";
constexpr double kLeastScale = 0.02;  // [px per font unit]
constexpr double kMostScale = 64;
constexpr double kFitPart = 0.86;  // the em's part of the canvas
// A line of text leaves room for the names of heights on its left.
constexpr double kLinePart = 0.74;
constexpr double kLineShift = 0.06;

// Commands on glyphs of the default layer alone.
bool is_for_all_masters(const Value& command) {
  const std::string name = command.value("do", "");
  return name == "add_glyph" || name == "delete_glyph" ||
         name == "rename_glyph" || name == "set_unicodes";
}

bool needs_glyph(const Value& command) {
  const std::string name = command.value("do", "");
  return name != "batch" && !command.contains("glyph") &&
         !command.contains("glyphs") &&
         name.find("info") == std::string::npos &&
         name.find("kerning") == std::string::npos &&
         name.find("group") == std::string::npos && name != "set_lib" &&
         name != "set_axes" && name != "space_letters";
}

// The glyphs that a change makes outlines.
std::vector<std::string> losing_source(const Change& change) {
  std::vector<std::string> names;
  for (const GlyphChange& entry : change.glyphs) {
    for (const char* key : {kStrokesKey, kTreeKey}) {
      if (entry.before != nullptr && entry.after != nullptr &&
          entry.before->lib.contains(key) && !entry.after->lib.contains(key)) {
        names.push_back(entry.name);
      }
    }
  }
  return names;
}

void check_new(const fs::path& folder) {
  if (folder.extension() != ".ufo") {
    throw Error("'" + folder.string() +
                "': the name of a project ends with "
                ".ufo");
  }
  if (fs::exists(folder)) {
    throw Error(folder.string() + ": exists; choose another name");
  }
}

bool order_starts_with_space(const Project& project) {
  const std::vector<std::string> order = glyph_order(project);
  return order.size() > 1 && order.front() == "space";
}

}  // namespace

Value in_master(const Editor& editor, const std::string& glyph, Value command) {
  command["glyph"] = glyph;
  const size_t master = editor.master(glyph);
  if (master != 0) {
    command["layer"] = editor.project().layers[master].name;
  }
  return command;
}

Value for_glyph(const Editor& editor, Value command) {
  if (needs_glyph(command)) {
    if (is_for_all_masters(command)) {
      command["glyph"] = editor.glyph_name();
    } else {
      command = in_master(editor, editor.glyph_name(), std::move(command));
    }
  }
  if (command.contains("commands")) {
    for (Value& part : command["commands"]) {
      part = for_glyph(editor, part);
    }
  }
  return command;
}

void View::zoom(double factor, Point at) {
  const Point fixed = to_font(at);
  scale = std::clamp(scale * factor, kLeastScale, kMostScale);
  const Point moved = to_font(at);
  x += fixed.x - moved.x;
  y += fixed.y - moved.y;
}

std::string NibSettings::text() const {
  return text_of(Nib{is_rectangle ? Nib::Kind::rectangle : Nib::Kind::ellipse,
                     width, height, gen::kDegree * angle});
}

Editor::Editor() : tool_(make_tool(tool_kind_)) {
  const auto kept = std::make_shared<std::string>();
  clipboard.read = [kept] { return *kept; };
  clipboard.write = [kept](const std::string& text) { *kept = text; };
}

Editor::~Editor() = default;

void Editor::open(const fs::path& file,
                  fs::path project,
                  const std::vector<std::string>& chars) {
  fs::path given = file;
  if (!given.has_filename()) {  // P.ufo/
    given = given.parent_path();
  }
  if (given.extension() == ".ufo") {
    begin(given);
    return;
  }
  if (project.empty()) {
    project = given.filename().replace_extension(".ufo");
  }
  gen::Warnings warnings;
  const std::string text = import_project(given, project, chars, warnings);
  begin(project);
  message = {text.substr(0, text.find('\n'))};
  imported = text.substr(message.text.size());
  for (const gen::Warning& warning : warnings) {
    imported += "\n" + warning.text;
  }
}

void Editor::begin(const fs::path& folder) {
  session_ = std::make_unique<Session>(folder);
  propose(nullptr);
  glyph_.clear();
  layer_ = 0;
  const size_t recovered = session_->recovery().commands;
  message = {recovered == 0 ? "Opened " + folder.filename().string()
                            : "Recovered " + std::to_string(recovered) +
                                  (recovered == 1 ? " change that was"
                                                  : " changes that were") +
                                  " not saved"};
  const std::vector<std::string> order = glyph_order(project());
  preview.text = usual_text();
  for (const std::string& name : order) {
    if (!project().glyph(name)->contours.empty() && name != ".notdef") {
      show(name);
      return;
    }
  }
  if (!order.empty()) {
    show(order.front());
  }
}

void Editor::create(const fs::path& folder,
                    const Value& info,
                    const std::string& glyphs) {
  check_new(folder);
  const double em = info.value("unitsPerEm", 0.0);
  if (!(em >= 16 && em <= 16384 && em == std::floor(em))) {
    throw Error("Units an em are 16 to 16384, without a fraction");
  }
  if (!(info.value("ascender", 0.0) > info.value("descender", 0.0))) {
    throw Error("Ascender must be above the descender, which is below 0");
  }
  Project project;
  FontData font;
  font.info = info;
  font.info["openTypeOS2Type"] = Value::array();  // no limits of embedding
  project.font = std::make_shared<const FontData>(std::move(font));
  project.apply(change_of(project, add_glyphs(project, glyphs)));
  UfoFiles files;
  write_ufo(project, folder, files);
  begin(folder);
  step(order_starts_with_space(this->project()) ? 1 : 0);
  message = {"New font " + folder.filename().string() + " of " +
             std::to_string(project.front().glyphs.size()) +
             " glyphs: draw this one, then set its advance on the right; Page "
             "Down shows the next"};
}

void Editor::open_sample() {
  if (!fs::exists(kSampleFolder)) {
    UfoFiles files;
    write_ufo(sample_project(), kSampleFolder, files);
  }
  begin(kSampleFolder);
  preview.text = kSampleText;
  show("n");
  message = {
      "l and o are curves, n is made of strokes, b and d are blends of l and "
      "o"};
}

void Editor::save_as(const fs::path& folder) {
  check_new(folder);
  const std::string shown = glyph_;
  const std::string old = session_->files().folder.filename().string();
  UfoFiles files = session_->files();
  write_ufo(project(), folder, files);
  session_->close();
  begin(folder);
  show(shown);
  message = {"Saved as " + folder.filename().string() + "; " + old +
             " is as it was saved last"};
}

void Editor::revert() {
  const fs::path folder = session_->files().folder;
  const std::string shown = glyph_;
  tool_->cancel(*this);
  session_->close();
  begin(folder);
  if (project().find(shown) != nullptr) {
    show(shown);
  }
  message = {folder.filename().string() + " is as it was saved last"};
}

// The project's own, or what the font has of the usual one, or else some that
// it has, of drawn glyphs first: boxes would be shown.
std::string Editor::usual_text() const {
  const Value own = project().font->lib.value(kPreviewTextKey, Value());
  if (own.is_string()) {
    return own.get<std::string>();
  }
  constexpr size_t kEnough = 4;
  std::string text;
  for (const PlacedGlyph& place :
       line_of_text(project(), PreviewSettings().text)) {
    text += gen::to_utf8(place.glyph->unicodes.front());
  }
  if (text.size() >= kEnough) {
    return text;
  }
  text.clear();
  for (const bool is_undrawn_too : {false, true}) {
    for (const std::string& name : glyph_order(project())) {
      const GlyphPointer glyph = project().glyph(name);
      if (!glyph->unicodes.empty() && glyph->unicodes.front() > U' ' &&
          is_undrawn(*glyph) == is_undrawn_too && text.size() < 10) {
        text += gen::to_utf8(glyph->unicodes.front());
      }
    }
  }
  return text;
}

void Editor::save() {
  if (preview.text != usual_text()) {
    run({{"do", "set_lib"}, {"key", kPreviewTextKey}, {"value", preview.text}});
  }
  session_->save();
  message = {"Saved " + session_->files().folder.filename().string()};
}

void Editor::export_to(const fs::path& file) {
  const std::string ending = file.extension().string();
  TtfReport report;
  if (ending == ".ufo") {
    UfoFiles files = session_->files();
    write_ufo(project(), file, files);
  } else if (ending == ".ttf") {
    write_bytes(file, write_ttf(project(), &report));
  } else if (ending == ".designspace") {
    write_designspace(project(), file);
  } else if (ending == ".bin") {
    write_bytes(file, make_rom(project(), {}, &report).bytes);
  } else {
    throw Error(
        file.string() +
        ": its ending says what to write: .ttf, .bin, .ufo or .designspace");
  }
  message = {"Wrote " + file.string() +
             (report.glyphs == 0 ? "" : ": " + report.text())};
}

bool Editor::is_changed(const std::string& glyph) const {
  for (size_t i = 0; i < project().layers.size(); ++i) {
    const GlyphPointer now = project().find(glyph, i);
    const GlyphPointer saved = session_->files().project.find(glyph, i);
    if (now != saved &&
        (now == nullptr || saved == nullptr || !(*now == *saved))) {
      return true;
    }
  }
  return false;
}

void Editor::show(const std::string& glyph) {
  if (!is_open()) {
    throw Error("glyph '" + glyph + "': open a font first");
  }
  std::string name = glyph;
  if (project().find(name) == nullptr) {
    const std::vector<char32_t> text = tools::from_utf8(glyph);
    name.clear();
    for (const auto& [candidate, pointer] : project().front().glyphs) {
      const std::vector<char32_t>& codes = pointer->unicodes;
      if (text.size() == 1 &&
          std::find(codes.begin(), codes.end(), text[0]) != codes.end()) {
        name = candidate;
      }
    }
    if (name.empty()) {
      throw Error("glyph '" + glyph + "': the project has none of this name");
    }
  }
  tool_->cancel(*this);
  glyph_ = name;
  part_between = 0;
  had_source_ = has_source(*stored());
  select_nothing();
  if (tool_kind_ != ToolKind::spacing) {  // the line of text is shown
    fit_view();
  }
}

void Editor::step(int by) {
  const std::vector<std::string> order = glyph_order(project());
  const auto at = std::find(order.begin(), order.end(), glyph_);
  const auto place = (at - order.begin()) + by;
  if (at != order.end() && place >= 0 &&
      place < static_cast<std::ptrdiff_t>(order.size())) {
    show(order[static_cast<size_t>(place)]);
  }
}

GlyphPointer Editor::glyph() const {
  if (proposal_ && proposal_->glyph != nullptr) {
    return proposal_->glyph;
  }
  return is_open() ? stored() : nullptr;
}

Project Editor::shown_project() const {
  Project shown = project();
  if (proposal_) {
    shown.apply(proposal_->change);
  }
  if (master() != 0) {
    const auto others = shown.front().glyphs;
    shown.front().glyphs = shown.layers[master()].glyphs;
    shown.front().glyphs.insert(others.begin(), others.end());
  }
  return shown;
}

void Editor::run(Value command) {
  command = for_glyph(*this, std::move(command));
  tool_->interrupt(*this);
  Change change = change_of(project(), command);
  ask_before_loss(command, change);
  session_->run(command, std::move(change));
  if (command.value("do", "") == "rename_glyph" && command["glyph"] == glyph_) {
    glyph_ = command["to"].get<std::string>();
  }
  follow_change();
}

void Editor::propose(Value command) {
  proposal_.reset();
  if (command.is_null()) {
    return;
  }
  command = for_glyph(*this, std::move(command));
  Proposal proposal = {command, change_of(project(), command), nullptr};
  for (const GlyphChange& change : proposal.change.glyphs) {
    if (change.layer == master() && change.name == glyph_) {
      proposal.glyph = change.after;
    }
  }
  proposal_ = std::move(proposal);
}

void Editor::commit() {
  if (!proposal_) {
    return;
  }
  Proposal proposal = std::move(*proposal_);
  proposal_.reset();
  ask_before_loss(proposal.command, proposal.change);
  session_->run(proposal.command, std::move(proposal.change));
  follow_change();
}

void Editor::ask_before_loss(const Value& command, const Change& change) {
  const std::vector<std::string> names = losing_source(change);
  if (!names.empty()) {
    pending = command;
    throw Error("glyph '" + names.front() +
                "' is made of strokes or parts; \"Turn into outline\" lets its "
                "points change");
  }
}

void Editor::make_outline() {
  std::vector<std::string> names = {glyph_};
  std::vector<Value> commands;
  const std::optional<Value> next = std::exchange(pending, std::nullopt);
  if (next) {
    names = losing_source(change_of(project(), *next));
  }
  for (const std::string& name : names) {
    for (Value& command :
         without_source(*project().glyph(name, master(name)))) {
      commands.push_back(in_master(*this, name, std::move(command)));
    }
  }
  if (next) {
    commands.push_back(*next);
  }
  if (commands.empty()) {
    throw Error("glyph '" + glyph_ + "' is an outline already");
  }
  tool_->interrupt(*this);
  session_->run(Value{{"do", "batch"}, {"commands", commands}});
  follow_change();
}

// After a command, undo or redo.
void Editor::follow_change() {
  message = {};
  const GlyphPointer now = stored();
  if (had_source_ && now != nullptr && !has_source(*now)) {
    message = {"The glyph is an outline now; undo brings its source back"};
  }
  had_source_ = now != nullptr && has_source(*now);
  drop_lost_selection();
}

// Deselects points and glyphs that a change has removed.
void Editor::drop_lost_selection() {
  const GlyphPointer now = stored();
  if (now == nullptr) {
    select_nothing();
    return;
  }
  for (auto id = selection.begin(); id != selection.end();) {
    const bool lost = id->contour >= own_contours(*now) ||
                      id->point >= now->contours[id->contour].points.size();
    id = lost ? selection.erase(id) : std::next(id);
  }
  const std::vector<Stroke> strokes =
      knots.empty() ? std::vector<Stroke>() : strokes_of(*now);
  for (auto id = knots.begin(); id != knots.end();) {
    const bool lost = id->contour >= strokes.size() ||
                      id->point >= strokes[id->contour].points.size();
    id = lost ? knots.erase(id) : std::next(id);
  }
  if (component && *component >= now->components.size()) {
    component.reset();
  }
  if (part && *part >= parts_of(*now).size()) {
    part.reset();
  }
  if (guide && *guide >= now->guidelines.size()) {
    guide.reset();
  }
}

void Editor::select_nothing() {
  selection.clear();
  knots.clear();
  component.reset();
  guide.reset();
  part.reset();
}

void Editor::select_contour(size_t contour) {
  const size_t count = glyph()->contours[contour].points.size();
  for (size_t point = 0; point < count; ++point) {
    selection.insert({contour, point});
  }
}

void Editor::set_tool(ToolKind kind) {
  if (is_open()) {
    tool_->cancel(*this);
  }
  const bool is_other_canvas =
      (kind == ToolKind::spacing) != (tool_kind_ == ToolKind::spacing);
  tool_kind_ = kind;
  tool_ = make_tool(kind);
  if (is_other_canvas && is_open()) {
    fit_view();
  }
}

void Editor::fit_view() {
  const GlyphPointer shown = glyph();
  if (shown == nullptr) {
    return;
  }
  const Value& info = project().font->info;
  const double em = project().units_per_em();
  const double top = info.value("ascender", 0.8 * em);
  const double bottom = info.value("descender", -0.2 * em);
  const bool is_line = tool_kind_ == ToolKind::spacing;
  const double width =
      is_line ? width_of(line_of_text(project(), preview.text)) : shown->width;
  view.scale = std::min(kFitPart * view.height / std::max(top - bottom, 1.0),
                        (is_line ? kLinePart : kFitPart) * view.width /
                            std::max(width, 0.6 * em));
  view.x = width / 2 - (is_line ? kLineShift * view.width / view.scale : 0);
  view.y = (top + bottom) / 2;
}

PreviewJob Editor::preview_job() const {
  Project shown = shown_project();
  if (const auto mixed = glyph_between()) {
    shown.front().glyphs[glyph_] = std::make_shared<const Glyph>(*mixed);
  }
  return make_job(shown, glyph_, preview);
}

}  // namespace inkcell::design::editor
