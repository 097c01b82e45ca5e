// Textures, cached as long as they are shown.
#pragma once

#include <SDL.h>
#include <imgui.h>

#include <map>
#include <memory>

#include "image.hpp"

namespace inkcell::tools {

class Textures {
 public:
  explicit Textures(SDL_Renderer* renderer) : renderer_(renderer) {}

  /// The texture of a picture with 3 channels, or 1: the alpha of ink. `owner`
  /// keeps the memory at `key` alive, so that no other picture gets its
  /// address. Null for an empty picture.
  ImTextureID of(const std::shared_ptr<const void>& owner,
                 const void* key,
                 const Image& image);
  /// The texture that of() made for `key`, if any.
  ImTextureID find(const void* key) const;
  /// Drops textures that were not used in the last two frames.
  void end_frame();

 private:
  struct Release {
    void operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }
  };
  struct Entry {
    std::unique_ptr<SDL_Texture, Release> texture;
    std::shared_ptr<const void> owner;
    mutable int age = 0;  // frames since the last use
  };

  SDL_Renderer* renderer_;
  std::map<const void*, Entry> entries_;
};

}  // namespace inkcell::tools
