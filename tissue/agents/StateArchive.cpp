#include "tissue/agents/StateArchive.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <cstring>

namespace restenosis {

void WritingArchive::bytes(const void* data, std::size_t size) {
  if (size > 0) buffer_.append(static_cast<const char*>(data), size);
}

void StreamingArchive::bytes(const void* data, std::size_t size) {
  if (size > 0) sink_({static_cast<const char*>(data), size});
}

void ReadingArchive::bytes(void* data, std::size_t size) {
  checkSize(size);
  if (size > 0) std::memcpy(data, buffer_.data() + position_, size);
  position_ += size;
}

void ReadingArchive::checkSize(std::uint64_t size) const {
  // Every stored element has at least one byte, so a larger count can only be damage.
  if (size > buffer_.size() - position_) throw ArchiveTruncated("the stored state ends too early");
}

HashingArchive::HashingArchive() : state_(XXH3_createState()) {
  XXH3_64bits_reset(static_cast<XXH3_state_t*>(state_));
}

HashingArchive::~HashingArchive() { XXH3_freeState(static_cast<XXH3_state_t*>(state_)); }

void HashingArchive::bytes(const void* data, std::size_t size) {
  if (size > 0) XXH3_64bits_update(static_cast<XXH3_state_t*>(state_), data, size);
}

std::string HashingArchive::digest() const {
  return fmt::format("{:016x}", XXH3_64bits_digest(static_cast<const XXH3_state_t*>(state_)));
}

std::string digestOf(const std::string& buffer) {
  return fmt::format("{:016x}", XXH3_64bits(buffer.data(), buffer.size()));
}

}  // namespace restenosis
