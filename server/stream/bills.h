// What each work costs the renderer, turn by turn, by the clock and by what its timings tell when it is done.
#pragma once
#include <algorithm>
#include <map>

#include "core/milliseconds.h"
#include "stream/frame_scheduler.h"

namespace cloudscape::stream {

// A software renderer is done with a slice when it yields. A GPU is not: the time of a slice is then known only when
// the frame is done, and until then is taken for what a turn of the frame before has cost.
class Bills {
 public:
  void taken(const Work& work, Time now) {
    Bill& bill = bills_[work.request.stream];
    if (bill.turns == 0 || bill.frame_id != work.frame_id) bill = {work.frame_id, bill.turn_ms, {}, 0, 0, total_ms_, 0};
    bill.taken = now;
    bill.others_ms = total_ms_ - bill.total_before_ms - bill.charged_ms;
    ++bill.turns;
  }

  // Both: what is to be charged for it now.
  double yielded(const Work& work, Time now) {
    Bill& bill = bills_[work.request.stream];
    return charge(bill, std::max(milliseconds(now - bill.taken), bill.turn_ms));
  }
  double ended(const Work& work, const FrameTimings& timings) {
    Bill& bill = bills_[work.request.stream];
    const double cost_ms = std::max(plausible_ms(timings.render_ms), plausible_ms(timings.gpu_ms) - bill.others_ms);
    bill.turn_ms = cost_ms / std::max(bill.turns, 1);
    bill.turns = 0;
    return charge(bill, cost_ms - bill.charged_ms);
  }
  void forget(StreamId id) { bills_.erase(id); }

 private:
  struct Bill {
    std::uint32_t frame_id = 0;
    double turn_ms = 0;  // mean, of the frame before
    Time taken;
    int turns = 0;
    double charged_ms = 0;
    double total_before_ms = 0;  // when its first turn began
    double others_ms = 0;        // what others cost between its first turn and its last
  };
  double charge(Bill& bill, double ms) {
    bill.charged_ms += ms;
    total_ms_ += ms;
    return ms;
  }

  std::map<StreamId, Bill> bills_;
  double total_ms_ = 0;  // charged to all
};

}  // namespace cloudscape::stream
