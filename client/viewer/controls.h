// Keyboard, mouse and game controller: what the hands did since they were last asked.
#pragma once
#include <SDL.h>

#include <memory>

#include "viewer/flight.h"
#include "viewer/sight.h"

namespace cloudscape::viewer {

struct Commands {
  bool quit = false, resized = false, exposed = false, toggle_hud = false, toggle_pointer = false, toggle_clock = false,
       release_pointer = false;
  double speed_notches = 0;
};

class Controls {
 public:
  void handle(const SDL_Event& event);
  Commands take_commands();
  // Held keys, stick and the mouse's way; the latter only while a button or the window holds the pointer.
  FlightInput take_flight(double degrees_per_pixel, bool pointer_held, double duration_s);
  Adjustment adjustment() const;  // of keys held now

 private:
  void handle_key(const SDL_KeyboardEvent& key);
  void handle_button(const SDL_MouseButtonEvent& button);
  void handle_controller_button(Uint8 button);

  Commands commands_;
  double mouse_x_px_ = 0, mouse_y_px_ = 0;
  bool dragging_ = false;
  std::unique_ptr<SDL_GameController, void (*)(SDL_GameController*)> controller_{nullptr, SDL_GameControllerClose};
};

}  // namespace cloudscape::viewer
