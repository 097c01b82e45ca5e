// Scenes of motion have one hash each, on every machine.
#include "clock_scene.hpp"
#include "count_scene.hpp"
#include "letters_scene.hpp"
#include "path_scene.hpp"
#include "scene_hash.hpp"
#include "ticker_scene.hpp"
#include "typewriter_scene.hpp"
#include "wipe_scene.hpp"

namespace {

using namespace golden;

scenes::SceneSetting setting_of(Text text) {
  return {&golden_font(), text, kWidth, kHeight, {}};
}

}  // namespace

TEST(path_has_one_hash) {
  static scenes::PathScene scene(setting_of("Inkcel Inkcel"));
  check_played("path", scene, kPathHash);
  check_sought(scene);
}

TEST(clock_has_one_hash) {
  // The font has two digits; others are .notdef.
  static scenes::ClockScene scene(setting_of("22:39"));
  check_played("clock", scene, kClockHash);
  check_sought(scene);
}

TEST(recipes_have_one_hash_each) {
  static scenes::CountScene count(setting_of("4224"));
  check_played("count", count, kCountHash);
  check_sought(count);
  static scenes::TickerScene ticker(setting_of("Inkcel 42"));
  check_played("ticker", ticker, kTickerHash);
  static scenes::TypewriterScene line(setting_of("Inkcel"));
  check_played("typewriter", line, kTypewriterHash);
  check_sought(line);
  static scenes::WipeScene wipe(setting_of("Ink cell"));
  check_played("wipe", wipe, kWipeHash);
  check_sought(wipe);
  static scenes::LettersScene<scenes::Letters::bounce> bounce(
      setting_of("Inkcel"));
  check_played("bounce", bounce, kBounceHash);
  static scenes::LettersScene<scenes::Letters::splash> splash(
      setting_of("Inkcel"));
  check_played("splash", splash, kSplashHash);
}
