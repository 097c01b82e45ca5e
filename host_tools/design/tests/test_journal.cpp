// The journal: undo, redo, and recovery from a crash at any byte.
#include <gtest/gtest.h>

#include <fstream>

#include "fixtures.hpp"
#include "journal/session.hpp"
#include "random_commands.hpp"
#include "ufo/glif.hpp"
#include "ufo/ufo.hpp"

namespace inkcell::design::test {
namespace {

const Value kWide = {{"do", "set_advance"}, {"glyph", "o"}, {"width", 900}};

class Journal : public testing::Test {
 protected:
  Journal() : path_(folder_.path() / "Test.ufo") { make_foreign_ufo(path_); }

  Session open() const { return {path_, JournalFile::Flush::never}; }

  std::string digest(const Session& session) {
    return digest_of(ufo_texts(session.project(), session.files()));
  }

  TemporaryFolder folder_;
  std::filesystem::path path_;
};

TEST_F(Journal, HundredThousandCommandsUndoneAndRedone) {
  const UfoFiles files = read_ufo(path_);
  Player player(files.project);
  RandomCommands random(1);
  constexpr int kCommands = 100000;
  for (int i = 0; i < kCommands; ++i) {
    player.play(random.next(player.project()));
  }
  const auto changed = ufo_texts(player.project(), files);
  EXPECT_NE(changed, files.texts);
  int undone = 0;
  while (player.undo()) {
    ++undone;
  }
  EXPECT_EQ(undone, kCommands);
  EXPECT_EQ(ufo_texts(player.project(), files), files.texts);
  while (player.redo()) {
  }
  EXPECT_EQ(ufo_texts(player.project(), files), changed);
}

// Undo and redo between commands.
TEST_F(Journal, ReplayGivesWhatTheSessionHad) {
  std::string before;
  {
    Session session = open();
    RandomCommands random(2);
    std::mt19937 chance(3);
    for (int i = 0; i < 3000; ++i) {
      const auto what = chance() % 10;
      if (what == 0) {
        session.undo();
      } else if (what == 1) {
        session.redo();
      } else if (what == 2 && i % 50 == 0) {
        session.save();
      } else {
        session.run(random.next(session.project()));
      }
    }
    before = digest(session);
  }  // a crash: not closed
  Session session = open();
  EXPECT_EQ(digest(session), before);
  session.save();
  session.close();
  EXPECT_EQ(digest_of(read_ufo(path_).texts), before);
  EXPECT_FALSE(std::filesystem::exists(journal_of(path_)));
}

// Steps before the last save can be undone after it, and a crash afterwards
// loses nothing.
TEST_F(Journal, UndoesAcrossASave) {
  std::string first;
  {
    Session session = open();
    first = digest(session);
    session.run(kWide);
    session.save();
    EXPECT_TRUE(session.undo());
    EXPECT_EQ(session.project().glyph("o")->width, 512);
    EXPECT_TRUE(session.redo());
    EXPECT_TRUE(session.undo());
    session.run({{"do", "set_advance"}, {"glyph", "A"}, {"width", 1}});
    EXPECT_TRUE(session.undo());
    EXPECT_FALSE(session.undo());
  }
  Session session = open();
  EXPECT_EQ(session.project().glyph("o")->width, 512);
  EXPECT_EQ(session.project().glyph("A")->width, 700);
}

// A glyph goes back alone; others keep what was changed since.
TEST_F(Journal, UndoesByGlyph) {
  const auto widen = [](const char* glyph, int width) {
    return Value{{"do", "set_advance"}, {"glyph", glyph}, {"width", width}};
  };
  std::string last;
  {
    Session session = open();
    const auto width = [&](const char* name) {
      return session.project().glyph(name)->width;
    };
    const double first = width("o");
    session.run(widen("o", 501));
    session.run(widen("o", 502));
    session.run(widen("A", 900));
    EXPECT_EQ(session.step_glyph(0, "o", false), "Set advance of o");
    EXPECT_EQ(width("o"), 501);
    EXPECT_EQ(width("A"), 900);
    EXPECT_TRUE(session.step_glyph(0, "o", false));
    EXPECT_EQ(width("o"), first);
    EXPECT_FALSE(session.step_glyph(0, "o", false));
    EXPECT_TRUE(session.step_glyph(0, "o", true));
    EXPECT_EQ(session.step_glyph(0, "o", true), "Set advance of o");
    EXPECT_EQ(width("o"), 502);
    EXPECT_FALSE(session.step_glyph(0, "o", true));
    EXPECT_TRUE(session.step_glyph(0, "o", false));
    EXPECT_EQ(width("o"), 501);
    EXPECT_EQ(session.history()[3].title, "Undo: Set advance of o");
    EXPECT_TRUE(session.undo());  // of that undo
    EXPECT_EQ(width("o"), 502);
    last = digest(session);
  }  // a crash
  Session session = open();
  EXPECT_EQ(digest(session), last);
}

// Undo restores a picture that a save removed from the disk.
TEST_F(Journal, UndoBringsAPictureBack) {
  const auto before = contents_of(path_);
  {
    Session session = open();
    session.run({{"do", "set_image"}, {"glyph", "A"}});
    session.save();
    EXPECT_EQ(contents_of(path_).count("images/A.png"), 0u);
    EXPECT_TRUE(session.undo());
  }  // a crash
  Session session = open();
  session.save();
  session.close();
  EXPECT_EQ(contents_of(path_)["images/A.png"], before.at("images/A.png"));
  EXPECT_EQ(*read_ufo(path_).project.glyph("A"),
            parse_glif(before.at("glyphs/A_.glif"), "A_.glif"));
}

TEST_F(Journal, CutAtAnyByteRecoversTheWholeRecordsBefore) {
  constexpr int kCommands = 25;
  std::vector<std::string> states;  // after each record
  {
    Session session = open();
    RandomCommands random(5);
    states.push_back(digest(session));
    for (int i = 0; i < kCommands; ++i) {
      session.run(random.next(session.project()));
      states.push_back(digest(session));
    }
  }
  const std::filesystem::path file = journal_of(path_);
  const std::string whole = contents_of(folder_.path())["Test.ufo.journal"];
  const size_t first = whole.find('\n') + 1;
  for (size_t cut = 0; cut <= whole.size(); ++cut) {
    const std::string rest = whole.substr(0, cut);
    write_text(file, rest);
    const auto lines = std::count(rest.begin(), rest.end(), '\n');
    const size_t commands = lines == 0 ? 0 : static_cast<size_t>(lines) - 1;
    const Session session = open();
    ASSERT_EQ(session.recovery().commands, commands) << "cut at " << cut;
    ASSERT_EQ(digest(session), states[commands]) << "cut at " << cut;
    if (cut > first) {
      EXPECT_EQ(session.recovery().lost_bytes,
                rest.size() - rest.rfind('\n') - 1);
    }
  }
}

// A flipped byte ends the journal at the record before.
TEST_F(Journal, DamageIsFound) {
  {
    Session session = open();
    RandomCommands random(6);
    for (int i = 0; i < 20; ++i) {
      session.run(random.next(session.project()));
    }
  }
  const std::filesystem::path file = journal_of(path_);
  const std::string whole = contents_of(folder_.path())["Test.ufo.journal"];
  for (size_t at = 0; at < whole.size(); at += 7) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    write_text(file, damaged);
    const auto lines = std::count(
        whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    EXPECT_EQ(read_journal(file).records.size(), static_cast<size_t>(lines));
  }
}

// A crash at any moment of a save: the old or the new project, the journal
// before or after it.
TEST_F(Journal, ACrashWhileSavingLosesNothing) {
  const auto old_files = contents_of(path_);
  const std::filesystem::path file = journal_of(path_);
  std::string wanted;
  {
    Session session = open();
    session.run(kWide);
    wanted = digest(session);
  }
  JournalRecords records = read_journal(file);
  {
    JournalFile journal(file, records.good_bytes, JournalFile::Flush::never);
    journal.append({{"do", "save"}, {"digest", wanted}});
  }
  const std::string text = contents_of(folder_.path())["Test.ufo.journal"];
  {  // before the swap
    const Session session = open();
    EXPECT_EQ(digest(session), wanted);
  }
  UfoFiles files = read_ufo(path_);
  Player player(files.project);
  for (const Value& record : records.records) {
    player.play(record);
  }
  write_ufo(player.project(), path_, files);
  write_text(file, text);  // after the swap, before the journal is replaced
  const Session session = open();
  EXPECT_EQ(digest(session), wanted);
  EXPECT_FALSE(session.has_changes());
}

TEST_F(Journal, RefusesAProjectThatAnotherProgramChanged) {
  {
    Session session = open();
    session.run(kWide);
  }
  write_text(path_ / "features.fea", "# changed\n");
  EXPECT_THROW(open(), Error);
}

// Between two sessions without a command to recover.
TEST_F(Journal, OpensAProjectThatAnotherProgramChanged) {
  {
    Session session = open();
    session.run(kWide);
    session.save();
  }
  write_text(path_ / "features.fea", "# changed\n");
  const Session session = open();
  EXPECT_EQ(session.project().font->features, "# changed\n");
  EXPECT_EQ(session.recovery().commands, 0u);
}

TEST_F(Journal, ScriptsAreLinesOfJson) {
  const std::filesystem::path file = folder_.path() / "script.jsonl";
  write_text(file,
             "# wider\n\n{\"do\": \"set_advance\", \"glyph\": \"o\", "
             "\"width\": 900}\n{\"do\": \"undo\"}\n");
  EXPECT_EQ(read_script(file).size(), 2u);
  write_text(file, "{}\nnonsense\n");
  const std::string refusal = refusal_of([&] { read_script(file); });
  EXPECT_EQ(refusal.rfind(file.string() + ":2: ", 0), 0u);
}

}  // namespace
}  // namespace inkcell::design::test
