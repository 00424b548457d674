#include "bridge/coupling/GrowthStep.h"

#include <array>

#include "bridge/coupling/parts/CrossCheckPart.h"
#include "bridge/coupling/parts/CyclePart.h"
#include "bridge/coupling/parts/EndotheliumPart.h"
#include "bridge/coupling/parts/ExposurePart.h"
#include "bridge/coupling/parts/FlowPart.h"
#include "bridge/coupling/parts/LumenPart.h"
#include "bridge/coupling/parts/NitricOxidePart.h"
#include "bridge/coupling/parts/RecordPart.h"
#include "bridge/coupling/parts/RelaxPart.h"
#include "bridge/coupling/parts/WallShearPart.h"

namespace restenosis {
namespace {

template <class MyPart>
constexpr PartEntry entry{MyPart::explain, [](const PartContext& context) -> std::unique_ptr<Part> {
                            return MyPart::make(context);
                          }};

constexpr std::array partsInOrder{
    entry<RelaxPart>,        // mechanical equilibrium, after cells have grown or divided
    entry<ExposurePart>,     // which cells face the lumen, which are crowded
    entry<EndotheliumPart>,  // returns over exposed cells
    entry<LumenPart>,        // its shape among the agents
    entry<FlowPart>,         // blood flow in it
    entry<CrossCheckPart>,   // by another method
    entry<WallShearPart>,    // stress from the wall's faces to the cells
    entry<NitricOxidePart>,  // of covered cells, from their stress
    entry<RecordPart>,       // the state for the user
    entry<CyclePart>,        // growth, rest, division
};

}  // namespace

std::span<const PartEntry> growthStep() { return partsInOrder; }

}  // namespace restenosis
