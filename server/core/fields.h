// How a plain struct describes its own fields: name, limits and meaning stand once, beside the member.
//
// A struct has `static void fields(Self& self, Visit&& visit)` that calls `visit(name, member, limits, description)`
// for each field. The JSON reader, the JSON writer, the schema, the reference in the README and the content hash all
// walk these descriptions, so that none of them can disagree.
#pragma once
#include <array>
#include <cstddef>
#include <limits>
#include <string_view>
#include <type_traits>

namespace cloudscape {

// Closed interval; of a vector or an array it holds for each component.
struct Limits {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool power_of_two = false;
};

// Specialized for each enumeration that a document can name: `static constexpr std::array<std::string_view, N> names`,
// in the order of the enumerators, which start at 0.
template <class Enum>
struct EnumNames;

template <class Enum>
constexpr std::string_view name_of(Enum value) {
  return EnumNames<Enum>::names[static_cast<std::size_t>(value)];
}

namespace detail {
struct AnyVisitor {
  template <class... Arguments>
  void operator()(Arguments&&...) const {}
};
}  // namespace detail

template <class T>
concept Described = std::is_class_v<T> && requires(T& value) {
  T::fields(value, detail::AnyVisitor{});
};

}  // namespace cloudscape
