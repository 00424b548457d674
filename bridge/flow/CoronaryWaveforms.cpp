#include "bridge/flow/CoronaryWaveforms.h"

#include <array>

#include "tissue/parameters/NamedTable.h"

namespace restenosis {
namespace {

/// Flow rates over their mean, evenly spaced over the period [s] from its beginning to its end.
struct Beat {
  double period;
  std::array<double, 26> flowRates;
};

constexpr std::array beatTable{
    Named<Beat>{"coronaryLeft", {0.852, {0.3845, 0.09097, 0.234, 0.3808, 0.4417, 0.468, 0.5,   0.5586, 0.6872,
                                         0.8221, 1.104,   1.373, 1.523,  1.6,    1.64,  1.598, 1.53,   1.488,
                                         1.438,  1.371,   1.314, 1.286,  1.249,  1.127, 0.792, 0.3845}}},
    Named<Beat>{"coronaryRight", {1.0, {0.7984, 1.018,  1.14,   1.168,  1.2,    1.222,  1.199,  1.141, 1.032,
                                        0.9373, 0.9514, 1.052,  1.138,  1.156,  1.143,  1.106,  1.04,  0.9772,
                                        0.9222, 0.8675, 0.8281, 0.7852, 0.7462, 0.7249, 0.7069, 0.7984}}}};

}  // namespace

std::vector<std::string_view> coronaryWaveformNames() { return namesOf(beatTable); }

std::vector<WaveformPoint> coronaryWaveform(std::string_view name) {
  const Beat& beat = findNamed(beatTable, "waveform", name).value;
  std::vector<WaveformPoint> points;
  for (std::size_t n = 0; n < beat.flowRates.size(); ++n)
    points.push_back({beat.period * static_cast<double>(n) / static_cast<double>(beat.flowRates.size() - 1),
                      beat.flowRates[n]});
  return points;
}

}  // namespace restenosis
