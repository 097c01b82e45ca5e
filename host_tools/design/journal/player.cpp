// Runs records; undo and redo.
#include <algorithm>

#include "journal/session.hpp"
#include "model/base64.hpp"
#include "model/commands.hpp"
#include "model/error.hpp"
#include "ufo/glif.hpp"

namespace inkcell::design {
namespace {

Value images_value(const Images& images) {
  Value value = Value::object();
  for (const auto& [name, bytes] : images) {
    value[name] = encode_base64(*bytes);
  }
  return value;
}

Images parse_images(const Value& value) {
  Images images;
  for (const auto& [name, text] : value.items()) {
    images[name] = std::make_shared<const std::vector<uint8_t>>(
        decode_base64(text.get<std::string>()));
  }
  return images;
}

Value font_value(const FontData& font) {
  return {{"images", images_value(font.images)},
          {"info", font.info},
          {"groups", font.groups},
          {"kerning", font.kerning},
          {"lib", font.lib},
          {"features", font.features}};
}

}  // namespace

std::string title_of(const Value& command, const Change& change) {
  const Value* named = &command;
  while (named->at("do") == "batch" && !named->contains("title") &&
         !named->at("commands").empty()) {
    named = &named->at("commands").front();
  }
  const bool is_batch = named->at("do") == "batch";
  std::string title = named->value(is_batch ? "title" : "do", "batch");
  std::replace(title.begin(), title.end(), '_', ' ');
  if (!title.empty() && title[0] >= 'a' && title[0] <= 'z') {
    title[0] = static_cast<char>(title[0] - 'a' + 'A');
  }
  if (change.glyphs.size() == 1) {
    title += " of " + change.glyphs.front().name;
  } else if (change.glyphs.size() > 1) {
    title += " of " + std::to_string(change.glyphs.size()) + " glyphs";
  }
  return title;
}

Value restore_record(const Change& change, bool after) {
  Value glyphs = Value::array();
  for (const GlyphChange& glyph : change.glyphs) {
    const GlyphPointer& state = after ? glyph.after : glyph.before;
    glyphs.push_back({glyph.layer, glyph.name,
                      state == nullptr ? Value() : Value(write_glif(*state))});
  }
  Value record = {{"do", "restore"}, {"glyphs", std::move(glyphs)}};
  const FontDataPointer& font = after ? change.font_after : change.font_before;
  if (font != nullptr) {
    record["font"] = font_value(*font);
  }
  return record;
}

bool Player::undo() {
  if (done_ == 0) {
    return false;
  }
  project_.revert(steps_[--done_].change);
  return true;
}

bool Player::redo() {
  if (done_ == steps_.size()) {
    return false;
  }
  project_.apply(steps_[done_++].change);
  return true;
}

std::optional<size_t> Player::last_of(size_t layer,
                                      const std::string& glyph,
                                      bool is_redo) const {
  for (size_t i = done_; i-- > 0;) {
    const auto& glyphs = steps_[i].change.glyphs;
    const auto found = std::find_if(
        glyphs.begin(), glyphs.end(), [&](const GlyphChange& entry) {
          return entry.layer == layer && entry.name == glyph;
        });
    if (found == glyphs.end()) {
      continue;
    }
    const Step& step = steps_[i];
    const bool is_undo = step.takes_back && !step.is_redo;
    if (is_redo ? is_undo : !step.takes_back) {
      return found->before != nullptr && found->after != nullptr
                 ? std::optional<size_t>(i)
                 : std::nullopt;
    }
    if (!step.takes_back) {
      return std::nullopt;  // a change since: nothing to do again
    }
    i = *step.takes_back;  // goes on before it
  }
  return std::nullopt;
}

void Player::apply(Step step) {
  project_.apply(step.change);
  steps_.resize(done_);
  steps_.push_back(std::move(step));
  ++done_;
}

void Player::restore(const Value& record) {
  Change change;
  for (const Value& entry : record.at("glyphs")) {
    GlyphChange glyph;
    glyph.layer = entry.at(0).get<size_t>();
    glyph.name = entry.at(1).get<std::string>();
    if (!entry.at(2).is_null()) {
      glyph.after = std::make_shared<const Glyph>(
          parse_glif(entry.at(2).get<std::string>(), "journal"));
    }
    change.glyphs.push_back(std::move(glyph));
  }
  if (record.contains("font")) {
    const Value& data = record["font"];
    change.font_after = std::make_shared<const FontData>(
        FontData{data.at("info"), data.at("groups"), data.at("kerning"),
                 data.at("lib"), data.at("features").get<std::string>(),
                 parse_images(data.at("images"))});
  }
  project_.apply(change);
}

void Player::play(const Value& record) {
  const std::string name = record.value("do", "");
  if (name == "begin" || name == "save") {
    return;
  }
  if (name == "undo" || name == "redo") {
    if (!(name == "undo" ? undo() : redo())) {
      throw Error("command '" + name + "': there is nothing to " + name);
    }
  } else if (name == "restore") {
    try {
      restore(record);
    } catch (const Value::exception& error) {
      throw Error(std::string("command 'restore': ") + error.what());
    }
  } else {
    Change change = change_of(project_, record);
    std::string title = title_of(record, change);
    apply({std::move(change), std::move(title), std::nullopt, false});
  }
}

}  // namespace inkcell::design
