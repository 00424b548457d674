#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "tissue/agents/PlainArray.h"

namespace restenosis {

/// Thrown when a stored state is shorter than what is read from it.
struct ArchiveTruncated : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Base of the archives: `a(x, y, z)` passes each value on in order. A type with a member
/// `archive(Archive&)` passes its own parts; trivially copyable types go as bytes, containers with their
/// size.
template <class Derived>
class StateArchive {
 public:
  template <class... T>
  void operator()(T&... values) {
    (pass(values), ...);
  }

 private:
  Derived& self() { return static_cast<Derived&>(*this); }

  template <class T>
  void pass(T& value) {
    if constexpr (requires { value.archive(self()); }) {
      value.archive(self());
    } else {
      static_assert(std::is_trivially_copyable_v<T>);
      self().bytes(&value, sizeof(T));
    }
  }
  template <class T>
  void pass(std::vector<T>& values) {
    if constexpr (std::is_trivially_copyable_v<T> && !requires(T t) { t.archive(self()); }) {
      passBytes(values);
    } else {
      values.resize(passSize(values.size()));
      for (auto& value : values) pass(value);
    }
  }
  template <class T>
  void pass(PlainArray<T>& values) {
    passBytes(values);
  }
  template <class Array>
  void passBytes(Array& values) {
    values.resize(passSize(values.size()));
    self().bytes(values.data(), values.size() * sizeof(*values.data()));
  }
  void pass(std::string& text) {
    text.resize(passSize(text.size()));
    self().bytes(text.data(), text.size());
  }
  template <class K, class V>
  void pass(std::map<K, V>& map) {
    auto size = passSize(map.size());
    if (size == map.size()) {
      std::vector<std::pair<K, V>> entries(map.begin(), map.end());
      map.clear();
      for (auto& [key, value] : entries) pass(key), pass(value), map[key] = value;
    } else {
      map.clear();
      for (std::size_t n = 0; n < size; ++n) {
        K key{};
        V value{};
        pass(key), pass(value), map[key] = value;
      }
    }
  }
  template <class T>
  void pass(std::optional<T>& value) {
    std::uint8_t present = value.has_value();
    pass(present);
    if (present && !value) value.emplace();
    if (!present) value.reset();
    if (value) pass(*value);
  }
  std::size_t passSize(std::size_t size) {
    auto stored = static_cast<std::uint64_t>(size);
    self().bytes(&stored, sizeof(stored));
    self().checkSize(stored);
    return static_cast<std::size_t>(stored);
  }
};

/// Appends a state to a buffer.
class WritingArchive : public StateArchive<WritingArchive> {
 public:
  void bytes(const void* data, std::size_t size);
  void checkSize(std::uint64_t) {}
  const std::string& buffer() const { return buffer_; }

 private:
  std::string buffer_;
};

/// Passes a state to a function, part by part, without a copy of it.
class StreamingArchive : public StateArchive<StreamingArchive> {
 public:
  using Sink = std::function<void(std::string_view)>;
  explicit StreamingArchive(Sink sink) : sink_(std::move(sink)) {}
  void bytes(const void* data, std::size_t size);
  void checkSize(std::uint64_t) {}

 private:
  Sink sink_;
};

/// Fills a state from a buffer; throws ArchiveTruncated when it is too short.
class ReadingArchive : public StateArchive<ReadingArchive> {
 public:
  explicit ReadingArchive(std::string buffer) : buffer_(std::move(buffer)) {}
  void bytes(void* data, std::size_t size);
  void checkSize(std::uint64_t size) const;
  bool atEnd() const { return position_ == buffer_.size(); }

 private:
  std::string buffer_;
  std::size_t position_ = 0;
};

/// Hashes a state with XXH3 (64 bits).
class HashingArchive : public StateArchive<HashingArchive> {
 public:
  HashingArchive();
  ~HashingArchive();
  HashingArchive(const HashingArchive&) = delete;
  HashingArchive& operator=(const HashingArchive&) = delete;
  void bytes(const void* data, std::size_t size);
  void checkSize(std::uint64_t) {}
  /// Sixteen hexadecimal digits.
  std::string digest() const;

 private:
  void* state_;
};

/// XXH3 of a buffer as sixteen hexadecimal digits.
std::string digestOf(const std::string& buffer);

}  // namespace restenosis
