// The loop of the window: hands, pose, picture.
#include "viewer/cockpit.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "viewer/controls.h"
#include "viewer/hello.h"
#include "viewer/sight.h"
#include "viewer/stream_client.h"
#include "viewer/title.h"
#include "viewer/window.h"

namespace cloudscape::viewer {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr auto step = milliseconds(16);           // input is read, and a pose sent, at most about 60 times a second
constexpr auto resize_rest = milliseconds(200);   // tuned: a size is asked for when the edge is let go, not all along
constexpr auto title_period = milliseconds(500);  // tuned: figures that can be read
constexpr double longest_step_s = 0.1;            // tuned: after a stall the flight goes on, it does not jump

// Wakes SDL's queue from the stream's threads.
void push_news() {
  SDL_Event event{};
  event.type = SDL_USEREVENT;
  SDL_PushEvent(&event);
}

class Cockpit {
 public:
  explicit Cockpit(const Options& options)
      : options_(options),
        window_(options.size_px),
        client_(options.endpoint, first_settings_in(options, window_.size_px()), 0, push_news) {}

  void run() {
    while (!quit_) {
      read_events();
      obey(controls_.take_commands());
      const Time now = steady_clock::now();
      if (const auto& welcome = client_.status().welcome; welcome && !sight_) sight_ = sight_of(*welcome);
      if (sight_ && now - last_step_ >= step) move(now);
      if (const auto picture = client_.take_picture(now)) show(*picture);
      if (now - last_title_ >= title_period) refresh_title(now);
      if (const auto failure = client_.failure()) throw Error(*failure);
    }
  }

 private:
  static wire::Settings first_settings_in(const Options& options, ImageSize window_px) {
    wire::Settings settings = first_settings(options);
    settings.size_px = window_px;
    return settings;
  }

  void read_events() {
    SDL_Event event;
    if (!SDL_WaitEventTimeout(&event, static_cast<int>(step.count()))) return;
    do controls_.handle(event);
    while (SDL_PollEvent(&event));
  }

  void obey(const Commands& commands) {
    quit_ |= commands.quit;
    if (commands.release_pointer) {
      if (window_.holds_pointer())
        window_.hold_pointer(false);
      else
        quit_ = true;
    }
    if (commands.toggle_pointer) window_.hold_pointer(!window_.holds_pointer());
    if (commands.toggle_clock) client_.turn_clock({{}, {}, !client_.status().clock.paused});
    if (commands.toggle_hud) with_figures_ = !with_figures_, last_title_ = {};
    if (commands.resized) resized_ = steady_clock::now();
    if (commands.resized || commands.exposed) window_.repaint();
    if (sight_) sight_->speed_m_per_s = change_speed(sight_->speed_m_per_s, commands.speed_notches);
  }

  void move(Time now) {
    const double duration_s = std::min(std::chrono::duration<double>(now - last_step_).count(), longest_step_s);
    last_step_ = now;
    const Sight before = *sight_;
    if (const auto settings = adjust(*sight_, controls_.adjustment(), duration_s)) client_.change(*settings);
    turn_clock(now, duration_s);
    const double pixel_deg = degrees_per_pixel(sight_->lens, window_.size_px().height);
    const FlightInput input = controls_.take_flight(pixel_deg, window_.holds_pointer(), duration_s);
    sight_->pose = fly(sight_->pose, input, sight_->speed_m_per_s, duration_s);
    if (sight_->pose != before.pose) latency_.sent(client_.look(sight_->pose), now);
    if (resized_ && now - *resized_ >= resize_rest) ask_for_size();
  }

  // Between two words of the server the clock's time is this viewer's own reckoning.
  void turn_clock(Time now, double duration_s) {
    const StreamStatus status = client_.status();
    if (controls_.adjustment().time_s == 0) return turning_s_.reset();
    if (!turning_s_)
      turning_s_ =
          RunningTime{status.clock.time_s, status.clock.paused ? 0 : status.clock.rate, status.clock_told}.at(now);
    const auto change = turned(*turning_s_, controls_.adjustment(), duration_s);
    turning_s_ = change->time_s;
    client_.turn_clock(*change);
  }

  void ask_for_size() {
    resized_.reset();
    wire::Settings settings;
    settings.size_px = within(window_.size_px(), client_.status().welcome->max_size_px);
    client_.change(settings);
  }

  void show(const Picture& picture) {
    window_.show(picture);
    client_.displayed(picture);
    const Time now = steady_clock::now();
    frames_.add(now, 1);
    bits_.add(now, 8.0 * static_cast<double>(picture.frame.message.size()));
    if (const auto latency_ms = latency_.displayed(picture.frame.header.pose_sequence, now))
      last_latency_ms_ = *latency_ms;
  }

  void refresh_title(Time now) {
    last_title_ = now;
    const Figures figures{frames_.per_second(now), last_latency_ms_, bits_.per_second(now),
                          sight_ ? sight_->speed_m_per_s : 0.0};
    window_.set_title(title(client_.status(), figures, with_figures_));
  }

  const Options& options_;
  Window window_;
  Controls controls_;
  StreamClient client_;
  std::optional<Sight> sight_;
  std::optional<Time> resized_;
  std::optional<double> turning_s_;  // what the clock is being turned to
  LatencyMeter latency_;
  RateMeter frames_, bits_;
  Time last_step_{}, last_title_{};
  double last_latency_ms_ = 0;
  bool quit_ = false, with_figures_ = true;
};

}  // namespace

void fly_in_window(const Options& options) { Cockpit(options).run(); }

}  // namespace cloudscape::viewer
