// SDL2's window, renderer and texture.
#include "viewer/window.h"

#include "core/error.h"

namespace cloudscape::viewer {
namespace {

template <class T>
T* need(T* made, const char* what) {
  if (!made) throw Error(std::string(what) + " cannot be opened: " + SDL_GetError() + "; --headless needs none.");
  return made;
}

}  // namespace

Window::Sdl::Sdl() {
  SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "linear");
  if (SDL_Init(SDL_INIT_VIDEO | SDL_INIT_GAMECONTROLLER) != 0) need<void>(nullptr, "A display");
}

Window::Sdl::~Sdl() { SDL_Quit(); }

Window::Window(ImageSize size_px)
    : window_(need(SDL_CreateWindow("cloudscape", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, size_px.width,
                                    size_px.height, SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI),
                   "A window"),
              SDL_DestroyWindow),
      renderer_(need(SDL_CreateRenderer(window_.get(), -1, SDL_RENDERER_PRESENTVSYNC), "The window's renderer"),
                SDL_DestroyRenderer) {
  repaint();
}

void Window::show(const Picture& picture) {
  const ImageSize size{picture.frame.header.width_px, picture.frame.header.height_px};
  if (!texture_ || size != texture_size_) {
    texture_.reset(need(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_RGB888, SDL_TEXTUREACCESS_STREAMING,
                                          size.width, size.height),
                        "The window's picture"));
    texture_size_ = size;
  }
  SDL_UpdateTexture(texture_.get(), nullptr, picture.bgrx.data(), size.width * 4);
  repaint();
}

void Window::repaint() {
  SDL_SetRenderDrawColor(renderer_.get(), 0, 0, 0, 255);
  SDL_RenderClear(renderer_.get());
  if (texture_) {
    const Rectangle place = fit(texture_size_, size_px());
    const SDL_Rect target{place.x, place.y, place.width, place.height};
    SDL_RenderCopy(renderer_.get(), texture_.get(), nullptr, &target);
  }
  SDL_RenderPresent(renderer_.get());
}

void Window::set_title(const std::string& title) { SDL_SetWindowTitle(window_.get(), title.c_str()); }

void Window::hold_pointer(bool held) { SDL_SetRelativeMouseMode(held ? SDL_TRUE : SDL_FALSE); }

ImageSize Window::size_px() const {
  ImageSize size;
  SDL_GetRendererOutputSize(renderer_.get(), &size.width, &size.height);
  return size;
}

}  // namespace cloudscape::viewer
