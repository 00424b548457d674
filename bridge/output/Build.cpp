#include "bridge/output/Build.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <set>

#include "bridge/output/Version.h"

#if __has_include(<gnu/libc-version.h>)
#include <gnu/libc-version.h>
#endif

namespace restenosis {

namespace {

/// What glibc's mathematics is dispatched by.
std::string processorTraits() {
  std::string traits;
#if defined(__x86_64__)
  const auto add = [&traits](const char* name, bool supported) {
    if (supported) traits.append(traits.empty() ? "" : ", ").append(name);
  };
  __builtin_cpu_init();
  add("avx512f", __builtin_cpu_supports("avx512f") != 0);
  add("avx2", __builtin_cpu_supports("avx2") != 0);
  add("fma", __builtin_cpu_supports("fma") != 0);
  add("fma4", __builtin_cpu_supports("fma4") != 0);
  add("avx", __builtin_cpu_supports("avx") != 0);
  add("sse4.1", __builtin_cpu_supports("sse4.1") != 0);
#endif
  return traits.empty() ? "other" : traits;
}

}  // namespace

std::map<std::string, std::string> buildTraits() {
  std::map<std::string, std::string> traits{{"version", std::string(version())},
                                            {"compiler", __VERSION__},
                                            {"instructions", Eigen::SimdInstructionSetsInUse()},
                                            {"processor", processorTraits()}};
#if __has_include(<gnu/libc-version.h>)
  traits["C library"] = gnu_get_libc_version();
#endif
  return traits;
}

std::string traitsInPlace(const std::map<std::string, std::string>& before,
                          const std::map<std::string, std::string>& now) {
  std::set<std::string> names;
  for (const auto* traits : {&before, &now})
    for (const auto& [name, value] : *traits) names.insert(name);
  const auto valueIn = [](const std::map<std::string, std::string>& traits, const std::string& name) {
    const auto found = traits.find(name);
    return found == traits.end() ? std::string("none") : found->second;
  };
  std::string list;
  for (const std::string& name : names) {
    const std::string was = valueIn(before, name), is = valueIn(now, name);
    if (was != is) list += fmt::format("{}{} {} (before: {})", list.empty() ? "" : ", ", name, is, was);
  }
  return list;
}

}  // namespace restenosis
