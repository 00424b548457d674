#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace restenosis {

/// A table that cannot be used; the message begins with the file and, where there is one, the line.
struct TableError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The lines of a table of values between commas, one after another. A comment goes from # to the end of its
/// line; lines without anything else are left out. Lines end with LF, CRLF, or CR alone (old spreadsheets),
/// and blanks and quotes around a line or a cell are none of it, nor is the mark that spreadsheets put before
/// UTF-8 text.
class CsvLines {
 public:
  /// Throws TableError if the file cannot be opened.
  explicit CsvLines(const std::filesystem::path& file);

  /// Goes to the next line, or says that there is none. Throws TableError if the file cannot be read.
  bool next();
  /// The present line, until the next one.
  std::string_view text() const { return text_; }
  std::vector<std::string_view> cells() const;
  /// Its number in the file, from 1.
  std::size_t number() const { return number_; }

  /// Throws TableError about the present line.
  [[noreturn]] void fail(const std::string& message) const;
  /// Throws TableError about the whole table.
  [[noreturn]] void failWhole(const std::string& message) const;

 private:
  std::optional<std::string_view> readLine();

  std::filesystem::path file_;
  std::ifstream stream_;
  std::string buffer_;                    ///< up to a line feed
  std::optional<std::string_view> rest_;  ///< unread lines of the buffer, if any
  std::string_view text_;
  std::size_t number_ = 0;
};

/// A cell without blanks and quotes around it.
std::string_view cellOf(std::string_view text);

/// The finite number that a cell is, or nothing.
std::optional<double> finiteNumber(std::string_view cell);

}  // namespace restenosis
