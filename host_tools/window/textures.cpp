#include "window/textures.hpp"

#include <vector>

namespace inkcell::tools {
namespace {

constexpr int kMostAge = 120;  // [frames]

std::vector<uint8_t> to_rgba(const Image& image) {
  std::vector<uint8_t> rgba;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const uint8_t* p = image.at(x, y);
      if (image.channels == 3) {
        rgba.insert(rgba.end(), {p[0], p[1], p[2], 255});
      } else {
        rgba.insert(rgba.end(), {255, 255, 255, p[0]});  // tinted
      }
    }
  }
  return rgba;
}

}  // namespace

ImTextureID Textures::of(const std::shared_ptr<const void>& owner,
                         const void* key,
                         const Image& image) {
  if (ImTextureID known = find(key)) {
    return known;
  }
  if (image.width == 0 || image.height == 0) {
    return nullptr;
  }
  SDL_Texture* texture =
      SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_RGBA32,
                        SDL_TEXTUREACCESS_STATIC, image.width, image.height);
  if (texture == nullptr) {
    return nullptr;
  }
  const std::vector<uint8_t> rgba = to_rgba(image);
  SDL_UpdateTexture(texture, nullptr, rgba.data(), 4 * image.width);
  SDL_SetTextureBlendMode(texture, SDL_BLENDMODE_BLEND);
  SDL_SetTextureScaleMode(texture, SDL_ScaleModeNearest);
  Entry& entry = entries_[key];
  entry.texture.reset(texture);
  entry.owner = owner;
  return texture;
}

ImTextureID Textures::find(const void* key) const {
  const auto found = entries_.find(key);
  if (found == entries_.end()) {
    return nullptr;
  }
  found->second.age = 0;
  return found->second.texture.get();
}

void Textures::end_frame() {
  for (auto entry = entries_.begin(); entry != entries_.end();) {
    entry = ++entry->second.age > kMostAge ? entries_.erase(entry)
                                           : std::next(entry);
  }
}

}  // namespace inkcell::tools
