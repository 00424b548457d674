#include "bridge/output/Provenance.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <fstream>

namespace restenosis {

namespace {

/// A word as a shell reads it back.
std::string shellWord(const std::string& word) {
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("_-./=,+:@%").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, plain)) return word;
  std::string quoted;
  for (const char c : word) quoted.append(c == '\'' ? "'\\''" : std::string_view(&c, 1));
  return fmt::format("'{}'", quoted);
}

std::string commandLine() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string text;
  for (std::string word; std::getline(file, word, '\0');)
    text.append(text.empty() ? "" : " ").append(shellWord(word));
  return text;
}

std::string hostName() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

}  // namespace

std::string timeNow() {
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

Provenance Provenance::ofThisProcess() {
  std::error_code unknown;
  const auto folder = std::filesystem::current_path(unknown);
  return {commandLine(), folder.string(), hostName(), timeNow()};
}

}  // namespace restenosis
