#include "core/metrics.h"

#include <array>
#include <compare>
#include <sstream>

namespace cloudscape {
namespace {

// Doubling and halving steps over what a frame can take, ms.
constexpr std::array bucket_ms{1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0, 5000.0, 10000.0};

// `name{labels}` in two.
struct Name {
  std::string family, labels;
  auto operator<=>(const Name&) const = default;
};

Name name_in(const std::string& text) {
  const auto brace = text.find('{');
  if (brace == std::string::npos) return {text, ""};
  return {text.substr(0, brace), text.substr(brace + 1, text.size() - brace - 2)};
}

// Calls write(name, value) for each; a family's lines follow its TYPE without others between, as the format demands.
template <class Value>
void write_families(std::ostream& out, const std::map<std::string, Value>& values, const char* type, auto&& write) {
  std::map<Name, const Value*> by_family;
  for (const auto& [text, value] : values) by_family[name_in(text)] = &value;
  std::string last;
  for (const auto& [name, value] : by_family) {
    if (name.family != last) out << "# TYPE " << (last = name.family) << ' ' << type << '\n';
    write(name, *value);
  }
}

void write_values(std::ostream& out, const std::map<std::string, double>& values, const char* type) {
  write_families(out, values, type, [&](const Name& name, double value) {
    out << name.family << (name.labels.empty() ? "" : "{" + name.labels + "}") << ' ' << value << '\n';
  });
}

// One histogram's lines: `family_bucket{labels,le="5"} 3`, ..., sum and count.
void write_histogram(std::ostream& out, const Name& name, const std::vector<double>& counts, double sum, double total) {
  const std::string bucket = name.family + "_bucket{" + name.labels + (name.labels.empty() ? "" : ",") + "le=\"";
  const std::string labels = name.labels.empty() ? "" : "{" + name.labels + "}";
  for (std::size_t i = 0; i < counts.size(); ++i) out << bucket << bucket_ms[i] << "\"} " << counts[i] << '\n';
  out << bucket << "+Inf\"} " << total << '\n';
  out << name.family << "_sum" << labels << ' ' << sum << '\n'
      << name.family << "_count" << labels << ' ' << total << '\n';
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
  write_families(out, histograms_, "histogram", [&](const Name& name, const Histogram& histogram) {
    write_histogram(out, name, histogram.counts, histogram.sum, histogram.total);
  });
  return out.str();
}

}  // namespace cloudscape
