#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace restenosis {

/// Reads the binary lists of an OpenFOAM file: after a count, the numbers as bytes in parentheses.
class FoamBinary {
 public:
  /// Throws std::runtime_error where the file cannot be read or its header does not say that it is binary
  /// with labels of 32 and numbers of 64 bits.
  explicit FoamBinary(const std::filesystem::path& file);
  /// The same of a file's content; `file` is what messages name.
  FoamBinary(const std::filesystem::path& file, std::string content);

  /// Goes on behind the first occurrence of these words. Throws std::runtime_error where there is none.
  void skipPast(std::string_view words);
  /// The next list, of `components` numbers an entry. Both throw std::runtime_error where it is cut off.
  std::vector<double> numbers(std::size_t components);
  std::vector<std::int32_t> labels();

 private:
  [[noreturn]] void fail(std::string_view what) const;
  /// The bytes of the next list; `entry` is the size of one of its entries.
  std::string_view list(std::size_t entry);

  std::filesystem::path file_;
  std::string text_;
  std::size_t at_ = 0;
};

/// A binary list as OpenFOAM reads it, of `components` numbers an entry.
std::string foamBinaryList(const std::vector<double>& numbers, std::size_t components);
std::string foamBinaryList(const std::vector<std::int32_t>& labels);

}  // namespace restenosis
