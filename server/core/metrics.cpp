#include "core/metrics.h"

#include <array>
#include <sstream>

namespace cloudscape {
namespace {

// Doubling and halving steps over what a frame can take, ms.
constexpr std::array bucket_ms{1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0, 5000.0, 10000.0};

std::string family(const std::string& name) { return name.substr(0, name.find('{')); }

void write_values(std::ostream& out, const std::map<std::string, double>& values, const char* type) {
  std::string last;
  for (const auto& [name, value] : values) {
    if (family(name) != last) out << "# TYPE " << (last = family(name)) << ' ' << type << '\n';
    out << name << ' ' << value << '\n';
  }
}

}  // namespace

void Metrics::count(const std::string& name, double by) {
  const std::lock_guard lock(mutex_);
  counters_[name] += by;
}

void Metrics::set(const std::string& name, double value) {
  const std::lock_guard lock(mutex_);
  gauges_[name] = value;
}

void Metrics::observe_ms(const std::string& name, double value_ms) {
  const std::lock_guard lock(mutex_);
  Histogram& histogram = histograms_[name];
  histogram.counts.resize(bucket_ms.size());
  for (std::size_t i = 0; i < bucket_ms.size(); ++i)
    if (value_ms <= bucket_ms[i]) histogram.counts[i] += 1;
  histogram.sum += value_ms;
  histogram.total += 1;
}

double Metrics::value(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  if (const auto counter = counters_.find(name); counter != counters_.end()) return counter->second;
  if (const auto gauge = gauges_.find(name); gauge != gauges_.end()) return gauge->second;
  return 0;
}

std::string Metrics::prometheus_text() const {
  const std::lock_guard lock(mutex_);
  std::ostringstream out;
  out.precision(12);
  write_values(out, counters_, "counter");
  write_values(out, gauges_, "gauge");
  for (const auto& [name, histogram] : histograms_) {
    out << "# TYPE " << name << " histogram\n";
    for (std::size_t i = 0; i < bucket_ms.size(); ++i)
      out << name << "_bucket{le=\"" << bucket_ms[i] << "\"} " << histogram.counts[i] << '\n';
    out << name << "_bucket{le=\"+Inf\"} " << histogram.total << '\n';
    out << name << "_sum " << histogram.sum << '\n' << name << "_count " << histogram.total << '\n';
  }
  return out.str();
}

}  // namespace cloudscape
