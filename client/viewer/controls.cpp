// SDL's events and states as flight input.
#include "viewer/controls.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cloudscape::viewer {
namespace {

constexpr double stick_turn_deg_per_s = 90.0;  // tuned: a half turn in two seconds, still fine at small deflection
constexpr double sun_azimuth_deg_per_s = 30.0, sun_elevation_deg_per_s = 10.0;  // tuned: a day's way in a few seconds
constexpr double exposure_ev_per_s = 2.0, sky_seconds_per_s = 60.0;  // tuned: seen at once, stopped where wanted

bool held(SDL_Scancode key) { return SDL_GetKeyboardState(nullptr)[key] != 0; }
double held(SDL_Scancode plus, SDL_Scancode minus) { return (held(plus) ? 1.0 : 0.0) - (held(minus) ? 1.0 : 0.0); }
bool shift() { return held(SDL_SCANCODE_LSHIFT) || held(SDL_SCANCODE_RSHIFT); }

}  // namespace

void Controls::handle(const SDL_Event& event) {
  switch (event.type) {
    case SDL_QUIT:
      commands_.quit = true;
      break;
    case SDL_WINDOWEVENT:
      commands_.exposed |= event.window.event == SDL_WINDOWEVENT_EXPOSED;
      commands_.resized |= event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED;
      break;
    case SDL_KEYDOWN:
      if (event.key.repeat == 0) handle_key(event.key);
      break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
      handle_button(event.button);
      break;
    case SDL_MOUSEMOTION:
      mouse_x_px_ += event.motion.xrel;
      mouse_y_px_ += event.motion.yrel;
      break;
    case SDL_MOUSEWHEEL:
      commands_.speed_notches += event.wheel.y;
      break;
    case SDL_CONTROLLERDEVICEADDED:
      if (!controller_) controller_.reset(SDL_GameControllerOpen(event.cdevice.which));
      break;
    case SDL_CONTROLLERDEVICEREMOVED:
      if (controller_ && !SDL_GameControllerGetAttached(controller_.get())) controller_.reset();
      break;
    case SDL_CONTROLLERBUTTONDOWN:
      handle_controller_button(event.cbutton.button);
      break;
    default:
      break;
  }
}

void Controls::handle_key(const SDL_KeyboardEvent& key) {
  commands_.release_pointer |= key.keysym.sym == SDLK_ESCAPE;
  commands_.toggle_hud |= key.keysym.sym == SDLK_h;
  commands_.toggle_pointer |= key.keysym.sym == SDLK_l;
  commands_.toggle_clock |= key.keysym.sym == SDLK_SPACE;
}

void Controls::handle_button(const SDL_MouseButtonEvent& button) {
  if (button.button == SDL_BUTTON_LEFT) dragging_ = button.state == SDL_PRESSED;
  if (button.button == SDL_BUTTON_RIGHT && button.state == SDL_PRESSED) commands_.toggle_pointer = true;
}

void Controls::handle_controller_button(Uint8 button) {
  if (button == SDL_CONTROLLER_BUTTON_RIGHTSHOULDER) commands_.speed_notches += 1;
  if (button == SDL_CONTROLLER_BUTTON_LEFTSHOULDER) commands_.speed_notches -= 1;
}

Commands Controls::take_commands() { return std::exchange(commands_, {}); }

FlightInput Controls::take_flight(double degrees_per_pixel, bool pointer_held, double duration_s) {
  const auto stick = [this](SDL_GameControllerAxis axis) {
    return controller_ ? deflection(SDL_GameControllerGetAxis(controller_.get(), axis)) : 0.0;
  };
  FlightInput input;
  input.forward = held(SDL_SCANCODE_W, SDL_SCANCODE_S) - stick(SDL_CONTROLLER_AXIS_LEFTY);
  input.right = held(SDL_SCANCODE_D, SDL_SCANCODE_A) + stick(SDL_CONTROLLER_AXIS_LEFTX);
  input.up = held(SDL_SCANCODE_E, SDL_SCANCODE_Q) + stick(SDL_CONTROLLER_AXIS_TRIGGERRIGHT) -
             stick(SDL_CONTROLLER_AXIS_TRIGGERLEFT);
  input.fast = shift();
  input.turn_right_deg = stick(SDL_CONTROLLER_AXIS_RIGHTX) * stick_turn_deg_per_s * duration_s;
  input.turn_up_deg = -stick(SDL_CONTROLLER_AXIS_RIGHTY) * stick_turn_deg_per_s * duration_s;
  const double right_px = std::exchange(mouse_x_px_, 0), down_px = std::exchange(mouse_y_px_, 0);
  if (dragging_ || pointer_held) {
    // Held, the pointer is the line of sight and goes with it; a drag pulls the sky along.
    const double sense = pointer_held ? 1.0 : -1.0;
    input.turn_right_deg += sense * right_px * degrees_per_pixel;
    input.turn_up_deg -= sense * down_px * degrees_per_pixel;
  }
  return input;
}

Adjustment Controls::adjustment() const {
  const double time = held(SDL_SCANCODE_T) ? (shift() ? -1.0 : 1.0) : 0.0;
  return {held(SDL_SCANCODE_RIGHT, SDL_SCANCODE_LEFT) * sun_azimuth_deg_per_s,
          held(SDL_SCANCODE_UP, SDL_SCANCODE_DOWN) * sun_elevation_deg_per_s,
          held(SDL_SCANCODE_RIGHTBRACKET, SDL_SCANCODE_LEFTBRACKET) * exposure_ev_per_s, time * sky_seconds_per_s};
}

}  // namespace cloudscape::viewer
