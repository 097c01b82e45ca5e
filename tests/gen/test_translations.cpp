// What files of translations show, one file of each kind, and wrong ones.
#include <gtest/gtest.h>

#include <map>

#include "base/error.hpp"
#include "messages.hpp"
#include "sfnt_builder.hpp"
#include "source/char_set.hpp"
#include "texts/language_name.hpp"
#include "texts/shown_texts.hpp"

namespace inkcell::gen::test {
namespace {

using Texts = std::map<std::string, std::string>;

class Translations : public testing::Test {
 protected:
  std::vector<LanguageText> read(const std::string& name,
                                 const std::string& content) {
    return shown_texts(folder_.write(name, content), "--strings-from");
  }
  // The text of each language.
  Texts texts(const std::string& name, const std::string& content) {
    Texts all;
    for (const LanguageText& shown : read(name, content)) {
      for (const LocatedCharacter& c : shown.text) {
        all[shown.language] += to_utf8(c.value);
      }
    }
    return all;
  }
  // The error of a file, without its folder.
  std::string refusal(const std::string& name, const std::string& content) {
    const std::string said = error_of([&] { read(name, content); });
    const std::string folder = folder_.path().string() + "/";
    return begins_with(said, folder) ? said.substr(folder.size()) : said;
  }
  void check_refused(const std::string& name,
                     const std::string& content,
                     const std::string& said) {
    EXPECT_TRUE(begins_with(refusal(name, content), name + ":" + said));
  }

  TestFolder folder_;
};

TEST_F(Translations, OfGettext) {
  constexpr char kFile[] = R"(# Kommentar Ω
msgid ""
msgstr ""
"Language: de_AT\n"
"Content-Type: text/plain; charset=UTF-8\n"

#: src/main.c:3
msgctxt "menü Ж"
msgid "Settings ☃"
msgstr "Einst"
"ellungen \303\244\n"

#, c-format, fuzzy
msgid "[fuzzy µ]"
msgstr "unscharf ß"
#. A comment between.
msgid "%d file"
msgid_plural "%d files"
msgstr[0] "%d Datei"
msgstr[1] "%d Dateien\\"

msgid "not yet"
msgstr ""

#~ msgid "old"
#~ msgstr "alt Ђ"
)";
  EXPECT_EQ(texts("a.po", kFile),
            (Texts{{"de-AT",
                    "Einstellungen \u00e4[fuzzy \u00b5]%d Datei%d "
                    "Dateien\\not yet"}}));
  EXPECT_EQ(texts("po/pt_BR.po", "msgid \"a\"\r\nmsgstr \"\u00e3\"\r\n"),
            (Texts{{"pt-BR", "\u00e3"}}));
  EXPECT_EQ(texts("fr/LC_MESSAGES/thing.po", "msgid \"a\"\nmsgstr \"b\""),
            (Texts{{"fr", "b"}}));
  EXPECT_EQ(
      read("de.po", "msgid \"a\"\nmsgstr \"\"\n\n\"\u00e9\"\n")[0].text[0].line,
      4);
}

TEST_F(Translations, OfJson) {
  EXPECT_EQ(texts("locales/fr/ui-text.json",
                  "\xef\xbb\xbf{\"\u0416\": {\"b\": [\"\u00c9t\u00e9\", 3, "
                  "null, true]}, \"@c\": \"d\"}"),
            (Texts{{"fr", "\u00c9t\u00e9d"}}));
  const auto shown = read("ja.json",
                          "{ \"a\": \"\\u3042\\n\",\n\"\u03a9\": "
                          "\"\\ud83d\\ude00\" }");
  EXPECT_EQ(shown[0].text[1].value, U'\U0001f600');
  EXPECT_EQ(shown[0].text[1].line, 2);
}

// A .ts that is no XML is a source.
TEST_F(Translations, OfOtherKindsAreToBeConverted) {
  for (const char* name :
       {"app_de.ts", "values-de/strings.xml", "app_de.arb"}) {
    EXPECT_NE(
        refusal(name, "\n<TS></TS>").find("convert the file to .po or .csv"),
        std::string::npos)
        << refusal(name, "\n<TS></TS>");
  }
  EXPECT_EQ(texts("main.ts", "const a: string = \"b\";"), (Texts{{"", "b"}}));
}

TEST_F(Translations, OfTables) {
  EXPECT_EQ(texts("texts.csv",
                  "id,en,uk_UA,comment\n"
                  "a,Hello,\"\u041f, \r\n\"\"\u0454\"\"\",\u03a9\r\n"
                  "b,Bye\\u00e9\\n\\,\u0457\n"),
            (Texts{{"en", "HelloBye\u00e9\\"},
                   {"uk-UA", "\u041f, \"\u0454\"\u0457"}}));
  EXPECT_EQ(texts("a.csv", "key;de\r\na;\u00e4,\r\n"),
            (Texts{{"de", "\u00e4,"}}));
  EXPECT_EQ(texts("a.csv", "key\tde\tfr\na\tb\t"), (Texts{{"de", "b"}}));
  const auto shown = read("a.csv", "k,de,fr\na,\"\n\nb\",c\nd,,e\n");
  EXPECT_EQ(shown[0].text[0].line, 4);
  EXPECT_EQ(shown[1].text[0].line, 4);
  EXPECT_EQ(shown[1].text[1].line, 5);
}

TEST_F(Translations, HeadersAreFoundByTheirWholeName) {
  EXPECT_EQ(texts("a.po", R"(msgid ""
msgstr ""
"X-Source-Language: en\n"
"Language: de\n"

msgctxt "empty"
msgid ""
msgstr "x"
)"),
            (Texts{{"de", "x"}}));
}

TEST_F(Translations, ColumnsAndNumbersOfTables) {
  EXPECT_EQ(texts("a.csv", "key,PT-br,zh_hans,FR\nk,\\xC3\\xA9,b,c\n"),
            (Texts{{"pt-BR", "\xC3\xA9"}, {"zh-Hans", "b"}, {"fr", "c"}}));
}

TEST_F(Translations, WrongFilesNameTheLine) {
  check_refused("a.po", "msgid \"a\"\nmsgstr \"b\n",
                "2: there is no quotation mark at the end");
  check_refused("a.po", "msgid \"a\" b\nmsgstr \"b\"\n",
                "1: something follows the last quotation mark");
  check_refused("a.po", "msgid \"a\"\nmsgstr \"\\q\"\n",
                "2: a backslash is followed by no escape sequence of C");
  check_refused("a.po", "\nmsgid \"a\"\n\nmsgid \"b\"\n",
                "2: a msgid without msgstr; write msgstr \"\"");
  check_refused("a.po", "msgid \"a\"\n", "1: a msgid without msgstr");
  check_refused("a.po", "msgstr \"a\"\n", "1: a msgstr without msgid");
  check_refused("a.po", "\"a\"\n", "1: a string without msgid");
  check_refused("a.po", "msgid\n", "1: 'msgid' has no text; write \"\"");
  check_refused("a.po", "title = Settings\n",
                "1: 'title = Settings' is no keyword of gettext; write");
  check_refused("a.po", "msgid \"a\"\nmsgstr \"\xe4\"\n",
                "2: the text is not UTF-8; save the file as UTF-8");
  check_refused("a.po",
                "msgid \"\"\nmsgstr \"\"\n\"Content-Type: text/plain; "
                "charset=KOI8-R\\n\"\n",
                "1: the charset is koi8-r, only UTF-8 is read; convert");
  check_refused("a.json", "{\"a\": \"b\",\n \"c\" \"d\"}",
                "2: the JSON is wrong here: ");
  check_refused("a.json", "{\"a\": \"\xe4\"}", "1: the JSON is wrong here: ");
  check_refused("a.json", "", "1: the JSON is wrong here: ");
  check_refused("a.csv", "key,text\na,b\n",
                "1: no column after the first has the name of a language");
  check_refused("a.csv", "key,de\na,\"b\n\nc",
                "2: a cell begins with a quotation mark and has none");
  check_refused("a.csv", "key,de\na,\"b\"c\n",
                "2: something follows the last quotation mark of a cell");
  check_refused("a.csv", "key,de\na,b\nc,d,e\n",
                "3: the row has 3 cells, the first line 2");
  check_refused("a.csv", "key,de\na,\xe4\n", "2: the text is not UTF-8");
}

// Reading ends for every beginning of a file.
TEST_F(Translations, EndWhereAFileEnds) {
  const struct {
    const char* name;
    std::string content;
  } files[] = {
      {"a.po",
       "#, fuzzy\nmsgid \"a\\303\"\nmsgid_plural \"b\"\nmsgstr[0] \"c\""},
      {"a.json", "{\"@a\": {\"b\": [\"c\"]}, \"d\": \"\\u00e9\"}"},
      {"a.csv", "k,de\n\"a\",\"b\n\"\"\"\nc,\\u00e9\n"}};
  for (const auto& file : files) {
    for (size_t size = 0; size <= file.content.size(); ++size) {
      const std::string text = refusal(file.name, file.content.substr(0, size));
      EXPECT_TRUE(text == "no error" || text.find(file.name) == 0) << text;
    }
  }
}

TEST(LanguageNames, AreTagsOrNone) {
  EXPECT_EQ(language_tag("de"), "de");
  EXPECT_EQ(language_tag("zh_Hans_CN"), "zh-Hans-CN");
  EXPECT_EQ(language_tag("es-419"), "es-419");
  EXPECT_EQ(language_tag("sr-Latn"), "sr-Latn");
  for (const char* none : {"", "d", "German", "DE", "de-x", "text"}) {
    EXPECT_EQ(language_tag(none), "") << none;
  }
  EXPECT_EQ(language_of_path("po/de.po"), "de");
  EXPECT_EQ(language_of_path("app_zh_CN.po"), "zh-CN");
  EXPECT_EQ(language_of_path("ui.text.fr.json"), "fr");
  EXPECT_EQ(language_of_path("de/LC_MESSAGES/tools.po"), "de");
  EXPECT_EQ(language_of_path("de/values/strings.json"), "");
  EXPECT_EQ(language_of_path("/texts/strings.json"), "");
  EXPECT_EQ(language_of_path("fw/i18n/german.json"), "");
}

}  // namespace
}  // namespace inkcell::gen::test
