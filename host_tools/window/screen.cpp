#include "window/screen.hpp"

#include <backends/imgui_impl_sdl.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "image.hpp"
#include "window/theme.hpp"

namespace inkcell::tools {
namespace {

constexpr int kWidth = 1440;
constexpr int kHeight = 900;
constexpr float kNormalDpi = 96;
constexpr float kFrameSeconds = 1.0f / 60;
constexpr int kSettlingFrames = 2;

[[noreturn]] void refuse(const char* what) {
  throw std::runtime_error(std::string(what) + ": " + SDL_GetError());
}

// Such as ctrl+shift+z.
std::string key_name(const SDL_Keysym& key) {
  std::string name = SDL_GetKeyName(key.sym);
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  std::string before;
  if ((key.mod & (KMOD_CTRL | KMOD_GUI)) != 0) {
    before += "ctrl+";
  }
  if ((key.mod & KMOD_SHIFT) != 0) {
    before += "shift+";
  }
  return before + name;
}

// 1 to 4, in quarters.
float display_scale() {
  float dpi = kNormalDpi;
  if (SDL_GetDisplayDPI(0, nullptr, &dpi, nullptr) != 0) {
    dpi = kNormalDpi;
  }
  return std::clamp(std::round(4 * dpi / kNormalDpi) / 4, 1.0f, 4.0f);
}

// A window of this size; where the desktop has less room, one that fills it.
SDL_Window* open_window(const char* title, int width, int height) {
  uint32_t flags = SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI;
  SDL_Rect room;
  if (SDL_GetDisplayUsableBounds(0, &room) == 0 &&
      (room.w < width || room.h < height)) {
    width = std::min(width, room.w);
    height = std::min(height, room.h);
    flags |= SDL_WINDOW_MAXIMIZED;
  }
  return SDL_CreateWindow(title, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                          width, height, flags);
}

// ImGui sees states, once a frame: two changes in one frame would be lost.
bool needs_frame(const SDL_Event& event) {
  return event.type == SDL_KEYDOWN || event.type == SDL_KEYUP ||
         event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEBUTTONUP;
}

}  // namespace

Screen::Screen(const std::string& title, float scale)
    : settling_{kSettlingFrames} {
  if (SDL_Init(SDL_INIT_VIDEO) != 0) {
    refuse("no display");
  }
  // Drivers that draw nowhere are for those who ask for them.
  const std::string driver = SDL_GetCurrentVideoDriver();
  if (SDL_getenv("SDL_VIDEODRIVER") == nullptr &&
      (driver == "offscreen" || driver == "dummy" || driver == "evdev")) {
    SDL_Quit();
    throw std::runtime_error(
        "no display: DISPLAY and WAYLAND_DISPLAY are not set; --script works "
        "without one");
  }
  if (scale == 0) {
    scale = display_scale();
  }
  const auto side = [scale](int value) {
    return static_cast<int>(static_cast<float>(value) * scale);
  };
  window_ = open_window(title.c_str(), side(kWidth), side(kHeight));
  if (window_ == nullptr) {
    refuse("no window");
  }
  renderer_ = SDL_CreateRenderer(window_, -1, SDL_RENDERER_PRESENTVSYNC);
  if (renderer_ == nullptr) {
    refuse("no renderer");
  }
  begin_imgui(scale);
  ImGui_ImplSDL2_InitForSDLRenderer(window_);
}

Screen::Screen(int width, int height, float scale) {
  // The format of windows; with other formats SDL rounds blends differently.
  surface_ = SDL_CreateRGBSurfaceWithFormat(0, width, height, 32,
                                            SDL_PIXELFORMAT_RGB888);
  renderer_ =
      surface_ == nullptr ? nullptr : SDL_CreateSoftwareRenderer(surface_);
  if (renderer_ == nullptr) {
    refuse("no picture");
  }
  begin_imgui(scale);
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
}

void Screen::begin_imgui(float scale) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  io.ConfigInputTextCursorBlink = window_ != nullptr;
  apply_theme(scale);
  add_fonts(scale);
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  font_ = SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_RGBA32,
                            SDL_TEXTUREACCESS_STATIC, width, height);
  if (font_ == nullptr) {
    refuse("no font");
  }
  SDL_UpdateTexture(font_, nullptr, pixels, 4 * width);
  SDL_SetTextureBlendMode(font_, SDL_BLENDMODE_BLEND);
  io.Fonts->SetTexID(font_);
  textures_ = std::make_unique<Textures>(renderer_);
}

Screen::~Screen() {
  textures_.reset();
  if (window_ != nullptr) {
    ImGui_ImplSDL2_Shutdown();
  }
  ImGui::DestroyContext();
  SDL_DestroyTexture(font_);
  SDL_DestroyRenderer(renderer_);
  SDL_FreeSurface(surface_);
  if (window_ != nullptr) {
    SDL_DestroyWindow(window_);
    SDL_Quit();
  }
}

bool Screen::read_input(int wait_ms,
                        const std::function<void(const std::string&)>& on_key) {
  SDL_Event event;
  if (SDL_WaitEventTimeout(&event, settling_ > 0 ? 0 : wait_ms) == 0) {
    settling_ = std::max(settling_ - 1, 0);
    return true;
  }
  do {
    settling_ = needs_frame(event) ? kSettlingFrames : settling_;
    ImGui_ImplSDL2_ProcessEvent(&event);
    follow_pointer(event);
    if (event.type == SDL_QUIT) {
      return false;
    }
    if (event.type == SDL_KEYDOWN && !ImGui::GetIO().WantTextInput) {
      on_key(key_name(event.key.keysym));
    }
  } while (!needs_frame(event) && SDL_PollEvent(&event) != 0);
  return true;
}

void Screen::follow_pointer(const SDL_Event& event) {
  const auto place = [this](int x, int y) {
    pointer_ = {static_cast<float>(x), static_cast<float>(y)};
  };
  if (event.type == SDL_MOUSEMOTION) {
    place(event.motion.x, event.motion.y);
  } else if (event.type == SDL_MOUSEBUTTONDOWN ||
             event.type == SDL_MOUSEBUTTONUP) {
    place(event.button.x, event.button.y);
    const int button = event.button.button == SDL_BUTTON_LEFT     ? 0
                       : event.button.button == SDL_BUTTON_RIGHT  ? 1
                       : event.button.button == SDL_BUTTON_MIDDLE ? 2
                                                                  : -1;
    if (button >= 0) {
      is_down_[button] = event.type == SDL_MOUSEBUTTONDOWN;
    }
  } else if (event.type == SDL_WINDOWEVENT &&
             event.window.event == SDL_WINDOWEVENT_LEAVE &&
             std::count(std::begin(is_down_), std::end(is_down_), true) == 0) {
    pointer_ = {-FLT_MAX, -FLT_MAX};
  }
}

void Screen::draw_frame(const std::function<void()>& panels) {
  if (window_ != nullptr) {
    ImGui_ImplSDL2_NewFrame();
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = pointer_;
    std::copy(std::begin(is_down_), std::end(is_down_), io.MouseDown);
  } else {
    ImGui::GetIO().DeltaTime = kFrameSeconds;
  }
  ImGui::NewFrame();
  panels();
  ImGui::Render();
  render();
  textures_->end_frame();
}

void Screen::render() {
  const ImDrawData& data = *ImGui::GetDrawData();
  SDL_RenderSetScale(renderer_, data.FramebufferScale.x,
                     data.FramebufferScale.y);
  SDL_SetRenderDrawColor(renderer_, 247, 248, 250, 255);
  SDL_RenderClear(renderer_);
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const ImVec4& clip = command.ClipRect;
      const SDL_Rect rect = {static_cast<int>(clip.x), static_cast<int>(clip.y),
                             static_cast<int>(clip.z - clip.x),
                             static_cast<int>(clip.w - clip.y)};
      if (rect.w <= 0 || rect.h <= 0) {
        continue;
      }
      SDL_RenderSetClipRect(renderer_, &rect);
      const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
      SDL_RenderGeometryRaw(
          renderer_, static_cast<SDL_Texture*>(command.GetTexID()),
          &vertices->pos.x, sizeof(ImDrawVert),
          reinterpret_cast<const SDL_Color*>(&vertices->col),
          sizeof(ImDrawVert), &vertices->uv.x, sizeof(ImDrawVert),
          list.VtxBuffer.Size - static_cast<int>(command.VtxOffset),
          list.IdxBuffer.Data + command.IdxOffset,
          static_cast<int>(command.ElemCount), sizeof(ImDrawIdx));
    }
  }
  SDL_RenderSetClipRect(renderer_, nullptr);
  SDL_RenderPresent(renderer_);
}

void Screen::write_picture(const std::filesystem::path& file) {
  int width = 0;
  int height = 0;
  SDL_GetRendererOutputSize(renderer_, &width, &height);
  Image image(width, height, 3);
  if (SDL_RenderReadPixels(renderer_, nullptr, SDL_PIXELFORMAT_RGB24,
                           image.pixels.data(), 3 * width) != 0) {
    refuse("no picture");
  }
  write_image(file, image);
}

}  // namespace inkcell::tools
