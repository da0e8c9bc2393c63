// Counters, gauges and histograms that any thread may write and /metrics shows (Prometheus text format 0.0.4).
#pragma once
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace cloudscape {

// A name may carry labels: `cloudscape_frames_dropped_total{reason="replaced"}`. Thread-safe.
class Metrics {
 public:
  void count(const std::string& name, double by = 1.0);
  void set(const std::string& name, double value);
  void observe_ms(const std::string& name, double value_ms);  // into buckets from 1 ms to 10 s
  double value(const std::string& name) const;                // of a counter or gauge; 0 where there is none
  std::string prometheus_text() const;

 private:
  struct Histogram {
    std::vector<double> counts;
    double sum = 0;
    double total = 0;
  };
  mutable std::mutex mutex_;
  std::map<std::string, double> counters_, gauges_;
  std::map<std::string, Histogram> histograms_;
};

}  // namespace cloudscape
