#include "journal/session.hpp"

#include <algorithm>

#include "model/commands.hpp"
#include "model/error.hpp"
#include "ufo/glif.hpp"

namespace inkcell::design {

namespace fs = std::filesystem;

fs::path journal_of(const fs::path& folder) {
  fs::path file = folder;
  if (!file.has_filename()) {
    file = file.parent_path();  // P.ufo/
  }
  file += ".journal";
  return file;
}

Session::Session(const fs::path& folder, JournalFile::Flush flush)
    : journal_path_(journal_of(folder)),
      flush_(flush),
      files_(read_ufo(folder)),
      player_(std::make_unique<Player>(files_.project)) {
  const std::string digest = digest_of(files_.texts);
  if (fs::exists(journal_path_)) {
    recover(digest);
  } else {
    begin_journal();
  }
}

// Replaces the old journal atomically.
void Session::begin_journal() {
  fs::path fresh = journal_path_;
  fresh += ".new";
  journal_.reset();
  {
    JournalFile file(fresh, 0, flush_);
    file.append({{"do", "begin"},
                 {"project", files_.folder.filename().string()},
                 {"digest", digest_of(files_.texts)}});
  }
  fs::rename(fresh, journal_path_);
  journal_ = std::make_unique<JournalFile>(
      journal_path_, fs::file_size(journal_path_), flush_);
  records_ = 0;
  base_ = player_->done();
}

void Session::recover(const std::string& digest) {
  const JournalRecords found = read_journal(journal_path_);
  recovery_.lost_bytes = found.lost_bytes;
  if (found.records.size() <= 1) {  // no command to carry out
    begin_journal();
    return;
  }
  const Value& last = found.records.back();
  if (last.value("do", "") == "save" && last.value("digest", "") == digest) {
    begin_journal();  // the save was finished, the journal was not
    return;
  }
  if (found.records.front().value("digest", "") != digest) {
    throw Error(files_.folder.string() +
                ": was changed by another program since " +
                journal_path_.string() +
                " was written; to carry the journal out all the same use "
                "inkcell-design replay, to forget it remove it");
  }
  for (size_t i = 1; i < found.records.size(); ++i) {
    player_->play(found.records[i]);
    ++recovery_.commands;
  }
  journal_ =
      std::make_unique<JournalFile>(journal_path_, found.good_bytes, flush_);
  records_ = recovery_.commands;
}

// Tries it first, so that the journal only has commands that work.
void Session::run(const Value& command) {
  run(command, change_of(player_->project(), command));
}

void Session::run(const Value& command, Change change) {
  const size_t position = player_->done();
  journal_->append(command);
  std::string title = title_of(command, change);
  player_->apply({std::move(change), std::move(title), std::nullopt, false});
  ++records_;
  base_ = std::min(base_, position);
}

// A step before the journal began is written out.
bool Session::step(bool is_redo) {
  const Step* step = is_redo ? player_->next() : player_->last();
  if (step == nullptr) {
    return false;
  }
  const bool is_held = player_->done() + (is_redo ? 1 : 0) > base_;
  journal_->append(is_held ? Value{{"do", is_redo ? "redo" : "undo"}}
                           : restore_record(step->change, is_redo));
  ++records_;
  return is_redo ? player_->redo() : player_->undo();
}

std::optional<std::string> Session::step_glyph(size_t layer,
                                               const std::string& glyph,
                                               bool is_redo) {
  const auto target = player_->last_of(layer, glyph, is_redo);
  if (!target) {
    return std::nullopt;
  }
  const std::vector<Step>& steps = player_->steps();
  std::string title =
      steps[is_redo ? *steps[*target].takes_back : *target].title;
  GlyphPointer old;
  for (const GlyphChange& entry : steps[*target].change.glyphs) {
    if (entry.layer == layer && entry.name == glyph) {
      old = entry.before;
    }
  }
  const Project& now = player_->project();
  const Value command = {{"do", "set_glyph"},
                         {"glyph", glyph},
                         {"layer", now.layers[layer].name},
                         {"glif", write_glif(*old)}};
  Change change = change_of(now, command);
  const size_t position = player_->done();
  journal_->append(command);
  player_->apply({std::move(change), (is_redo ? "Redo: " : "Undo: ") + title,
                  target, is_redo});
  ++records_;
  base_ = std::min(base_, position);
  return title;
}

void Session::save() {
  const std::string digest = digest_of(ufo_texts(player_->project(), files_));
  journal_->append({{"do", "save"}, {"digest", digest}});
  write_ufo(player_->project(), files_.folder, files_);
  begin_journal();
}

void Session::close() {
  journal_.reset();
  fs::remove(journal_path_);
}

}  // namespace inkcell::design
