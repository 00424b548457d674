#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace restenosis {

/// An array for plain elements that are many. Unlike a std::vector it grows where it is, if the system can
/// give it more memory there, instead of being in memory twice for a while; and what it grows by is not set,
/// so that no memory is taken before it is.
template <class T>
class PlainArray {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignof(std::max_align_t));

 public:
  PlainArray() = default;
  PlainArray(const PlainArray& other) {
    resize(other.size());
    std::copy_n(other.data(), size_, data());
  }
  PlainArray(PlainArray&& other) noexcept { swap(other); }
  PlainArray& operator=(PlainArray other) noexcept {
    swap(other);
    return *this;
  }
  ~PlainArray() = default;

  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  T* data() { return memory_.get(); }
  const T* data() const { return memory_.get(); }
  T* begin() { return data(); }
  const T* begin() const { return data(); }
  T* end() { return data() + size_; }
  const T* end() const { return data() + size_; }

  /// Reserves memory for so many elements. Throws std::bad_alloc.
  void reserve(std::size_t count) {
    if (count <= capacity_) return;
    if (count > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_alloc();
    T* const moved = static_cast<T*>(std::realloc(memory_.get(), count * sizeof(T)));
    if (!moved) throw std::bad_alloc();
    static_cast<void>(memory_.release());  // realloc has freed it
    memory_.reset(moved);
    capacity_ = count;
  }
  /// Appends elements that are yet to be set, or drops the last, until there are so many.
  void resize(std::size_t count) {
    reserve(count);
    size_ = count;
  }
  void swap(PlainArray& other) noexcept {
    std::swap(memory_, other.memory_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

 private:
  struct Free {
    void operator()(T* memory) const { std::free(memory); }
  };

  std::unique_ptr<T[], Free> memory_;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace restenosis
