// Names a described value (fields.h) by what it says: equal values have equal hashes, on every machine.
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/fields.h"

namespace cloudscape {

// Lower-case hexadecimal SHA-256 of the bytes; 64 characters.
std::string sha256_hex(std::string_view bytes);

namespace detail {

// Writes every field as name=value; in the order of the description, numbers as hexadecimal floats.
class CanonicalText {
 public:
  template <Described T>
  void write(const T& value) {
    text_ << '{';
    T::fields(value, [this](std::string_view name, const auto& member, auto&&...) {
      text_ << name << '=';
      write(member);
      text_ << ';';
    });
    text_ << '}';
  }
  void write(const std::string& value) { text_ << value.size() << ':' << value; }
  void write(double value) { text_ << std::hexfloat << (value == 0 ? 0.0 : value); }  // -0 and 0 are the same
  template <class T>
  requires std::is_integral_v<T> || std::is_enum_v<T>
  void write(T value) { text_ << static_cast<long long>(value); }
  void write(const glm::dvec2& value) { write(value.x), text_ << ',', write(value.y); }
  void write(const glm::dvec3& value) { write(value.x), text_ << ',', write(value.y), text_ << ',', write(value.z); }
  template <class T>
  void write(const std::optional<T>& value) {
    value ? write(*value) : void(text_ << "null");
  }
  template <class T>
  void write(const std::vector<T>& values) {
    write_all(values);
  }
  template <class T, std::size_t size>
  void write(const std::array<T, size>& values) {
    write_all(values);
  }
  std::string text() const { return text_.str(); }

 private:
  template <class Values>
  void write_all(const Values& values) {
    text_ << '[';
    for (const auto& value : values) write(value), text_ << ',';
    text_ << ']';
  }
  std::ostringstream text_;
};

}  // namespace detail

// 64 hexadecimal characters.
template <Described T>
std::string content_hash(const T& value) {
  detail::CanonicalText canonical;
  canonical.write(value);
  return sha256_hex(canonical.text());
}

}  // namespace cloudscape
