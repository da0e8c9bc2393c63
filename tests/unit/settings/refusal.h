// The sentence and the pointer with which something refuses its input.
#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/error.h"

namespace cloudscape {

struct Refusal {
  std::string sentence, pointer;
};

template <class Failure = InvalidInput>
Refusal refusal(auto&& attempt) {
  try {
    attempt();
  } catch (const Failure& error) {
    if constexpr (std::is_base_of_v<InvalidInput, Failure>) return {error.what(), error.pointer};
    return {error.what(), ""};
  }
  return {"was not refused", ""};
}

}  // namespace cloudscape
