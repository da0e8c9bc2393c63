// Encoded stills by ETag, the least recently used ones forgotten above a number of bytes.
#pragma once
#include <list>
#include <map>
#include <memory>
#include <string>

#include "core/frame.h"

namespace cloudscape::net {

class StillCache {
 public:
  explicit StillCache(std::size_t max_bytes) : max_bytes_(max_bytes) {}
  std::shared_ptr<const EncodedFrame> find(const std::string& etag);  // nullptr where there is none
  void put(const std::string& etag, std::shared_ptr<const EncodedFrame> image);
  std::size_t bytes() const { return bytes_; }

 private:
  struct Entry {
    std::string etag;
    std::shared_ptr<const EncodedFrame> image;
  };
  void forget_oldest();
  std::size_t max_bytes_, bytes_ = 0;
  std::list<Entry> entries_;  // the newest first
  std::map<std::string, std::list<Entry>::iterator> by_etag_;
};

}  // namespace cloudscape::net
