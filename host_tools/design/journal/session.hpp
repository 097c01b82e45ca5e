// A project being edited: commands, undo, redo, and crash recovery.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "journal/journal_file.hpp"
#include "model/project.hpp"
#include "ufo/ufo.hpp"

namespace inkcell::design {

/// A change with a name for the history: "Move points of a".
struct Step {
  Change change;
  std::string title;
  /// The step that this one takes back for its glyph alone: an undo of a
  /// change, or a redo of such an undo.
  std::optional<size_t> takes_back;
  bool is_redo = false;
};

/// What a command does, for the history.
std::string title_of(const Value& command, const Change& change);

/// Runs the records of a journal or a script: commands, undo, redo, and other
/// records of a session.
class Player {
 public:
  explicit Player(Project project) : project_(std::move(project)) {}

  /// Throws Error; the project is then unchanged.
  void play(const Value& record);

  const Project& project() const { return project_; }
  /// The step to undo or to redo; null if there is none. Valid until apply().
  const Step* last() const { return done_ == 0 ? nullptr : &steps_[done_ - 1]; }
  const Step* next() const {
    return done_ == steps_.size() ? nullptr : &steps_[done_];
  }
  const std::vector<Step>& steps() const { return steps_; }
  /// The step that undo, or redo, of this glyph alone takes back.
  std::optional<size_t> last_of(size_t layer,
                                const std::string& glyph,
                                bool is_redo) const;
  /// Steps that undo() takes back.
  size_t done() const { return done_; }

  /// False if there is nothing to undo or redo.
  bool undo();
  bool redo();
  /// Applies a change that can be undone. Discards undone steps.
  void apply(Step step);

 private:
  void restore(const Value& record);

  Project project_;
  std::vector<Step> steps_;
  size_t done_ = 0;
};

/// The state of all that `change` touches, after it or before it, as a record:
/// an undo or redo for a journal that does not contain the step.
Value restore_record(const Change& change, bool after);

/// The result of opening a project after a crash.
struct Recovery {
  size_t commands = 0;    // unsaved, and recovered
  size_t lost_bytes = 0;  // of a record that was cut
};

class Session {
 public:
  /// Opens `folder` and recovers the unsaved commands in its journal
  /// (`folder`.journal).
  ///
  /// Throws Error also if another program changed the project since the journal
  /// was written.
  Session(const std::filesystem::path& folder,
          JournalFile::Flush flush = JournalFile::Flush::always);

  const Recovery& recovery() const { return recovery_; }
  const Project& project() const { return player_->project(); }
  const UfoFiles& files() const { return files_; }

  /// Runs a command; it is written to the journal before project() changes.
  void run(const Value& command);
  /// The same if change_of(project(), command) is known.
  void run(const Value& command, Change change);
  bool undo() { return step(false); }
  bool redo() { return step(true); }
  /// Takes back the last change of a glyph, or such an undo, and leaves the
  /// changes of others since: a step of its own. Returns the title of what it
  /// took back; nothing if there was nothing.
  std::optional<std::string> step_glyph(size_t layer,
                                        const std::string& glyph,
                                        bool is_redo);
  /// All steps since the project was opened, and how many of them are done.
  const std::vector<Step>& history() const { return player_->steps(); }
  size_t done() const { return player_->done(); }

  /// Writes the project and empties the journal. After a crash at any moment
  /// there is either the old project and its journal, or the new project.
  void save();
  /// Removes the journal. Commands since the last save are lost.
  void close();

  bool has_changes() const { return records_ != 0; }

 private:
  void begin_journal();
  void recover(const std::string& digest);
  bool step(bool is_redo);

  std::filesystem::path journal_path_;
  JournalFile::Flush flush_;
  UfoFiles files_;
  std::unique_ptr<Player> player_;
  std::unique_ptr<JournalFile> journal_;
  Recovery recovery_;
  size_t base_ = 0;     // steps before the journal began
  size_t records_ = 0;  // since the journal began
};

/// The journal of a project: P.ufo.journal.
std::filesystem::path journal_of(const std::filesystem::path& folder);

}  // namespace inkcell::design
