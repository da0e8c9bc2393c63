// Latest-wins sending.
#include "viewer/outbox.h"

#include <utility>

namespace cloudscape::viewer {
namespace {

template <class T>
void take(std::optional<T>& into, const std::optional<T>& change) {
  if (change) into = change;
}

}  // namespace

void merge(wire::Settings& into, const wire::Settings& changes) {
  if (changes.cloudscape || changes.cloudscape_document) {
    into.cloudscape = changes.cloudscape;
    into.cloudscape_document = changes.cloudscape_document;
  }
  if (changes.reset_sun) {
    into.sun_azimuth_deg.reset();
    into.sun_elevation_deg.reset();
    into.sun_time_rate.reset();
    into.reset_sun = true;
  }
  take(into.size_px, changes.size_px);
  take(into.pose, changes.pose);
  take(into.lens, changes.lens);
  take(into.display, changes.display);
  take(into.march, changes.march);
  take(into.quality, changes.quality);
  take(into.sun_azimuth_deg, changes.sun_azimuth_deg);
  take(into.sun_elevation_deg, changes.sun_elevation_deg);
  take(into.sun_time_rate, changes.sun_time_rate);
  if (changes.follow_clock) into.time_s.reset(), into.follow_clock = true;
  take(into.time_s, changes.time_s);
}

Outbox::Outbox(wire::Settings start) : view_(std::move(start)) {}

void Outbox::connected() {
  connected_ = hello_due_ = true;
  settings_.reset();  // the hello holds them
  clock_.reset();     // it has run on without this viewer
  camera_due_ = newest_camera_.has_value();
}

void Outbox::disconnected() {
  connected_ = false;
  acks_.clear();
}

void Outbox::look(const wire::Camera& camera) {
  newest_camera_ = camera;
  camera_due_ = true;
  view_.pose = camera.pose;
  take(view_.time_s, camera.time_s);
}

void Outbox::change(const wire::Settings& settings) {
  merge(view_, settings);
  if (!settings_) settings_.emplace();
  merge(*settings_, settings);
}

void Outbox::turn(const ClockChange& change) {
  if (!clock_) clock_.emplace();
  take(clock_->time_s, change.time_s);
  take(clock_->rate, change.rate);
  take(clock_->paused, change.paused);
  view_.time_s.reset();
}

void Outbox::acknowledge(const wire::Ack& ack) {
  if (connected_) acks_.push_back(ack);
}

std::optional<wire::ClientMessage> Outbox::next() {
  if (!connected_) return std::nullopt;
  if (std::exchange(hello_due_, false)) return wire::Hello{1, view_};
  if (!acks_.empty()) {
    const wire::Ack ack = acks_.front();
    acks_.pop_front();
    return ack;
  }
  if (settings_) return *std::exchange(settings_, std::nullopt);
  if (clock_) return *std::exchange(clock_, std::nullopt);
  if (std::exchange(camera_due_, false)) return *newest_camera_;
  return std::nullopt;
}

}  // namespace cloudscape::viewer
