#include "app/simulated_viewers.h"

#include <pthread.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/milliseconds.h"
#include "stream/quality_control.h"
#include "stream/refinement.h"

namespace cloudscape::app {
namespace {

using Clock = std::chrono::steady_clock;

Clock::duration seconds_long(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

double place_on(const settings::CameraPath& path, double start_s, double flown_s) {
  const double begin_s = path.keys.front().time_s, length_s = path.keys.back().time_s - begin_s;
  if (length_s <= 0) return begin_s;
  const double there_and_back_s = std::fmod(start_s - begin_s + flown_s, 2 * length_s);
  return begin_s + std::min(there_and_back_s, 2 * length_s - there_and_back_s);
}

SimulatedViewers::SimulatedViewers(stream::FrameScheduler& scheduler, ViewersOptions options,
                                   const std::vector<Viewer>& viewers)
    : scheduler_(scheduler), options_(std::move(options)) {
  for (const Viewer& viewer : viewers) {
    Each each{viewer, {}, {}};
    const stream::StreamView view = view_at(each, opened_);
    viewers_.emplace(scheduler_.open(view), std::move(each));
  }
  thread_ = std::thread([this] { run(); });
}

SimulatedViewers::~SimulatedViewers() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  news_.notify_all();
  thread_.join();
  for (const auto& [stream, each] : viewers_) scheduler_.close(stream);
}

std::shared_ptr<const Cloudscape> SimulatedViewers::in_other_light(const Cloudscape& sky, double open_s) const {
  auto other = std::make_shared<Cloudscape>(sky);
  double& azimuth_deg = other->sun.azimuth_deg;
  azimuth_deg = std::remainder(azimuth_deg + options_.sun_deg_per_s * open_s, 360);
  if (options_.sun_climb_deg_per_s != 0) {
    constexpr double lowest_deg = 5, highest_deg = 60, range_deg = highest_deg - lowest_deg;
    const double way_deg = std::abs(other->sun.elevation_deg - lowest_deg + options_.sun_climb_deg_per_s * open_s);
    other->sun.elevation_deg = highest_deg - std::abs(std::fmod(way_deg, 2 * range_deg) - range_deg);
  }
  return other;
}

stream::StreamView SimulatedViewers::view_at(Each& each, Time now) {
  const double open_s = milliseconds(now - opened_) / 1000, flown_s = options_.speed * open_s;
  const auto key = settings::key_at(options_.path, place_on(options_.path, each.viewer.start_s, flown_s));
  stream::StreamView view = each.viewer.view;
  view.pose = key.pose;
  view.lens.vertical_fov_deg = key.vertical_fov_deg;
  if (options_.sun_deg_per_s != 0 || options_.sun_climb_deg_per_s != 0)
    view.cloudscape = in_other_light(*view.cloudscape, open_s);
  view.pose_sequence = each.sent.size();
  each.sent.push_back(now);
  return view;
}

void SimulatedViewers::run() {
  pthread_setname_np(pthread_self(), "viewers");
  const Clock::duration between = seconds_long(1 / options_.poses_per_s);
  Time next = opened_ + between;
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    const Time due = acknowledgements_.empty() ? next : std::min(next, acknowledgements_.front().due);
    news_.wait_until(lock, due);
    const Time now = Clock::now();
    acknowledge_due(now);
    if (now < next) continue;
    send_poses(now);
    next = std::max(next + between, now);  // a late hand does not hurry
  }
}

// With the lock: the scheduler calls nobody back.
void SimulatedViewers::send_poses(Time now) {
  for (auto& [stream, each] : viewers_) scheduler_.update(stream, view_at(each, now));
}

void SimulatedViewers::acknowledge_due(Time now) {
  while (!acknowledgements_.empty() && acknowledgements_.front().due <= now) {
    scheduler_.acknowledge(acknowledgements_.front().stream, acknowledgements_.front().frame_id, 0);
    acknowledgements_.pop_front();
  }
}

FramePump::Sink SimulatedViewers::sink() {
  return {0,
          [this](const stream::Work& work, const FrameTimings& timings, const EncodedFrame& image) {
            deliver(work, timings, image);
          },
          [this](StreamId, const std::string& message, int) {
            const std::lock_guard lock(mutex_);
            if (failure_.empty()) failure_ = message;
          },
          [](StreamId, double, int) {}};
}

void SimulatedViewers::deliver(const stream::Work& work, const FrameTimings& timings, const EncodedFrame& image) {
  const Time now = Clock::now();
  const std::lock_guard lock(mutex_);
  const auto found = viewers_.find(work.request.stream);
  if (found == viewers_.end()) return;
  Each& each = found->second;
  if (work.quality_stage == stream::moving_stage)
    each.frames.push_back({milliseconds(now - measured_from_), milliseconds(now - each.sent.at(work.pose_sequence)),
                           timings.render_ms, timings.gpu_ms, timings.readback_ms, image.encode_ms,
                           static_cast<double>(image.bytes.size()), stream::moving_detail_of(work.request.quality)});
  if (options_.latency_ms <= 0) return scheduler_.acknowledge(work.request.stream, work.frame_id, 0);
  acknowledgements_.push_back({now + seconds_long(options_.latency_ms / 1000), work.request.stream, work.frame_id});
  news_.notify_all();
}

void SimulatedViewers::measure_from_now() {
  const std::lock_guard lock(mutex_);
  measured_from_ = Clock::now();
  for (auto& [stream, each] : viewers_) each.frames.clear();
}

std::size_t SimulatedViewers::delivered() const {
  const std::lock_guard lock(mutex_);
  std::size_t count = 0;
  for (const auto& [stream, each] : viewers_) count += each.frames.size();
  return count;
}

double SimulatedViewers::seconds() const {
  const std::lock_guard lock(mutex_);
  return milliseconds(Clock::now() - measured_from_) / 1000;
}

std::vector<std::vector<bench::FlownFrame>> SimulatedViewers::frames() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::vector<bench::FlownFrame>> frames;
  for (const auto& [stream, each] : viewers_) frames.push_back(each.frames);
  return frames;
}

std::string SimulatedViewers::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

}  // namespace cloudscape::app
