#include <algorithm>

#include "tissue/agents/Chunks.h"
#include "tissue/neighbours/CellGrid.h"
#include "tissue/neighbours/NeighbourList.h"

namespace restenosis {
namespace {

// Agents searched for by one thread at a time, and how many of these chunks are found before
// their lists are appended, so that few are in memory twice. Speed and memory only.
constexpr std::ptrdiff_t agentsOfChunk = 512;
constexpr std::size_t chunksAtOnce = 128;
// Memory for the lists, over what the first of them let expect: they grow by half or more before the list is
// built again.
constexpr double reserved = 2;

/// Finds the neighbours of every agent, reading agents in the order of the cells of a grid.
class SearchOfAll {
 public:
  SearchOfAll(const std::vector<ListedAgent>& agents, const NeighbourRange& range, double largestRadius)
      : agents_(agents),
        range_(range),
        largestRadius_(largestRadius),
        grid_(
            agents.size(), [&](std::size_t i) -> const Vec3& { return agents[i].position; },
            range.widestReach(largestRadius)),
        candidates_(agents.size()) {
    forEachInChunks(agents.size(), [&](std::size_t n) {
      const Index j = grid_.order()[n];
      candidates_[n] = {agents[j], j};
    });
  }

  /// Appends the neighbours of agent i, in ascending order.
  void append(Index i, std::vector<Index>& list) const {
    const ListedAgent& agent = agents_[i];
    const std::size_t first = list.size();
    std::size_t end = first;
    grid_.forEachCandidateRange(
        agent.position, reachOf(range_, agent, largestRadius_), [&](std::uint32_t from, std::uint32_t to) {
          // Each is written, and kept by counting it: no branch to be guessed wrong.
          list.resize(end + (to - from));
          Index* out = list.data() + end;
          for (std::uint32_t n = from; n < to; ++n) {
            *out = candidates_[n].index;
            out += int{inRange(range_, agent, candidates_[n].agent)} & int{candidates_[n].index != i};
          }
          end = static_cast<std::size_t>(out - list.data());
        });
    list.resize(end);
    std::sort(list.begin() + static_cast<std::ptrdiff_t>(first), list.end());
  }

 private:
  struct Candidate {
    ListedAgent agent;
    Index index;
  };

  const std::vector<ListedAgent>& agents_;
  NeighbourRange range_;
  double largestRadius_;
  CellGrid grid_;
  std::vector<Candidate> candidates_;
};

/// The lists of consecutive agents, one after the other.
struct FoundLists {
  std::vector<Index> elements;
  std::vector<std::size_t> ends;
};

}  // namespace

void NeighbourList::build(const AgentStore& agents, const NeighbourRange& range) {
  range_ = range;
  lists_ = {};  // should a position be found wrong below, there is no list
  grid_.reset();
  listed_.resize(agents.size());
  largestRadius_ = 0;
  for (Index i = 0; i < agents.size(); ++i) {
    listed_[i] = ListedAgent(agents, i, range);
    largestRadius_ = std::max(largestRadius_, listed_[i].radius());
  }
  noteIds(agents);

  const SearchOfAll search(listed_, range, largestRadius_);
  std::vector<FoundLists> chunks(chunksAtOnce);
  JaggedArray<Index> lists;
  for (std::size_t first = 0; first < listed_.size(); first += chunksAtOnce * agentsOfChunk) {
    const std::size_t count = std::min(listed_.size() - first, chunksAtOnce * agentsOfChunk);
    const auto find = [&](std::size_t begin, std::size_t end) {
      FoundLists& found = chunks[begin / agentsOfChunk];
      found.elements.clear(), found.ends.clear();
      for (std::size_t i = first + begin; i < first + end; ++i) {
        search.append(static_cast<Index>(i), found.elements);
        found.ends.push_back(found.elements.size());
      }
    };
    forEachChunk(count, find, agentsOfChunk, agentsOfChunk);
    const auto used = std::span(chunks).first((count + agentsOfChunk - 1) / agentsOfChunk);
    if (first == 0) {
      std::size_t found = 0;
      for (const FoundLists& chunk : used) found += chunk.elements.size();
      const double ofAll = static_cast<double>(found) / static_cast<double>(count) * size();
      lists.reserve(size(), static_cast<std::size_t>(reserved * ofAll));
    }
    for (const FoundLists& chunk : used) {
      std::size_t begin = 0;
      for (const std::size_t end : chunk.ends) {
        lists.addList(std::span(chunk.elements).subspan(begin, end - begin));
        begin = end;
      }
    }
  }
  lists_ = std::move(lists);
}

}  // namespace restenosis
