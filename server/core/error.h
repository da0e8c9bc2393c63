// Errors that people read: one sentence that says what is wrong, where, and what would be right.
#pragma once
#include <stdexcept>
#include <string>
#include <utility>

namespace cloudscape {

// Something outside the program is wrong (a file, the driver, a port): what() is the sentence for the user.
class Error : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A value that was given is not acceptable. `pointer` is an RFC 6901 JSON pointer ("/medium/phase/asymmetry_g"), or the
// option's name where it came from the command line. what() holds the whole sentence, the pointer included.
class InvalidInput : public Error {
 public:
  InvalidInput(std::string where, const std::string& message)
      : Error(where.empty() ? message : where + " " + message), pointer(std::move(where)) {}
  std::string pointer;
};

// A file that a document names cannot be used: it is missing, damaged, or not what it should be.
class UnusableFile : public Error {
  using Error::Error;
};

// A name that nothing has.
class NotFound : public Error {
  using Error::Error;
};

// Acceptable, but above a limit of this server.
class OverLimit : public InvalidInput {
  using InvalidInput::InvalidInput;
};

}  // namespace cloudscape
