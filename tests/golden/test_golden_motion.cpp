// Scenes of motion have one hash each, on every machine.
#include "clock_scene.hpp"
#include "count_scene.hpp"
#include "letters_scene.hpp"
#include "path_scene.hpp"
#include "scene_hash.hpp"
#include "ticker_scene.hpp"
#include "typewriter_scene.hpp"
#include "wipe_scene.hpp"

using namespace golden;

TEST(path_has_one_hash) {
  check_scene<scenes::PathScene>("path", "Inkcel Inkcel", kPathHash);
}

TEST(clock_has_one_hash) {
  // The font has two digits; others are .notdef.
  check_scene<scenes::ClockScene>("clock", "22:39", kClockHash);
}

TEST(recipes_have_one_hash_each) {
  check_scene<scenes::CountScene>("count", "4224", kCountHash);
  check_played_scene<scenes::TickerScene>("ticker", "Inkcel 42", kTickerHash);
  check_scene<scenes::TypewriterScene>("typewriter", "Inkcel", kTypewriterHash);
  check_scene<scenes::WipeScene>("wipe", "Ink cell", kWipeHash);
  check_played_scene<scenes::LettersScene<scenes::Letters::bounce>>(
      "bounce", "Inkcel", kBounceHash);
  check_played_scene<scenes::LettersScene<scenes::Letters::splash>>(
      "splash", "Inkcel", kSplashHash);
}
