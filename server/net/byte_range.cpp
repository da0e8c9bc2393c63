#include "net/byte_range.h"

#include <charconv>
#include <optional>

#include "net/problem.h"

namespace cloudscape::net {
namespace {

std::optional<std::size_t> number_of(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

struct Range {
  std::size_t first = 0, size = 0;  // size 0: nothing of the body
};

// nullopt: not a range that is answered.
std::optional<Range> range_of(std::string_view header, std::size_t size) {
  constexpr std::string_view unit = "bytes=";
  if (!header.starts_with(unit)) return std::nullopt;
  header.remove_prefix(unit.size());
  const auto dash = header.find('-');
  if (dash == std::string_view::npos) return std::nullopt;
  const auto first = number_of(header.substr(0, dash)), last = number_of(header.substr(dash + 1));
  if (dash == 0) {  // the last so many bytes
    if (!last) return std::nullopt;
    return Range{size - std::min(*last, size), std::min(*last, size)};
  }
  const bool open = dash + 1 == header.size();
  if (!first || (!last && !open) || (last && *last < *first)) return std::nullopt;
  if (*first >= size) return Range{};
  return Range{*first, std::min(last.value_or(size - 1), size - 1) - *first + 1};
}

}  // namespace

Response ranged(const Request& request, Response whole, const std::string& etag) {
  whole.with("accept-ranges", "bytes");
  if (request.range.empty() || (!request.if_range.empty() && request.if_range != etag)) return whole;
  const std::size_t size = whole.body.bytes.size();
  const auto range = range_of(request.range, size);
  if (!range) return whole;
  if (range->size == 0)
    return problem(416, "The body has " + std::to_string(size) + " bytes: the range lies outside.")
        .with("content-range", "bytes */" + std::to_string(size));
  whole.status = 206;
  whole.body.bytes = whole.body.bytes.substr(range->first, range->size);
  return whole.with("content-range", "bytes " + std::to_string(range->first) + "-" +
                                         std::to_string(range->first + range->size - 1) + "/" + std::to_string(size));
}

}  // namespace cloudscape::net
