#include "bridge/system/ShellCommand.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace restenosis {
namespace {

bool isPlain(char c) {
  constexpr std::string_view plain = "_-./=:,+@%";
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || plain.find(c) != std::string_view::npos;
}

std::string shellWord(const std::string& argument) {
  if (!argument.empty() && std::ranges::all_of(argument, isPlain)) return argument;
  std::string word = "'";
  for (const char c : argument) {
    if (c == '\'')
      word += "'\\''";  // a quote ends the quotes
    else
      word += c;
  }
  return word + "'";
}

}  // namespace

std::string shellCommand(std::span<const std::string> arguments) {
  std::string command;
  for (const std::string& argument : arguments)
    command.append(command.empty() ? "" : " ").append(shellWord(argument));
  return command;
}

}  // namespace restenosis
