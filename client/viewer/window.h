// The window and the picture in it, through SDL2.
#pragma once
#include <SDL.h>

#include <memory>
#include <string>

#include "core/frame.h"
#include "viewer/fit.h"
#include "viewer/picture.h"

namespace cloudscape::viewer {

class Window {
 public:
  explicit Window(ImageSize size_px);  // throws Error: no display

  void show(const Picture& picture);  // returns when it is on display, up to one refresh later
  void repaint();                     // after a change of the window
  void set_title(const std::string& title);
  void hold_pointer(bool held);  // hidden, and its motion without end
  bool holds_pointer() const { return SDL_GetRelativeMouseMode() == SDL_TRUE; }
  ImageSize size_px() const;  // in pixels of the display, which a scaled desktop has more of than it says

 private:
  struct Sdl {
    Sdl();
    ~Sdl();
    Sdl(const Sdl&) = delete;
    Sdl& operator=(const Sdl&) = delete;
  };
  template <class T>
  using Owned = std::unique_ptr<T, void (*)(T*)>;
  Sdl sdl_;
  Owned<SDL_Window> window_;
  Owned<SDL_Renderer> renderer_;
  Owned<SDL_Texture> texture_{nullptr, SDL_DestroyTexture};
  ImageSize texture_size_{0, 0};
};

}  // namespace cloudscape::viewer
