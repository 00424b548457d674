#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>

#include "bridge/output/TissueWriter.h"
#include "bridge/system/AtomicFile.h"
#include "tests/support/FileSizeLimit.h"
#include "tests/support/TemporaryFolder.h"

namespace restenosis {
namespace {

AgentStore twoAgents() {
  AgentStore agents;
  agents.append(AgentKind::smc, {1e-4, 2e-4, 3e-4}, 15e-6);
  agents.append(AgentKind::strut, {0, 0, 5e-4}, 22e-6);
  agents.state[0] = CycleState::sg2m;
  agents.set(0, covered, true), agents.set(0, daughter, true);
  agents.stress[0] = -1234.5, agents.nitricOxide[0] = 0.0025, agents.wss[0] = 1.6;
  return agents;
}

double value(vtkPolyData* data, const char* array, vtkIdType agent) {
  auto* found = data->GetPointData()->GetArray(array);
  return found == nullptr ? std::nan("") : found->GetTuple1(agent);
}

TEST(TissueWriter, WritesEveryArrayOfTheContract) {
  TemporaryFolder folder;
  writeTissue(folder / "tissue.vtp", twoAgents(), 86400);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((folder / "tissue.vtp").c_str());
  reader->Update();
  auto* data = reader->GetOutput();
  ASSERT_EQ(data->GetNumberOfPoints(), 2);
  EXPECT_EQ(data->GetNumberOfVerts(), 2);
  EXPECT_FLOAT_EQ(static_cast<float>(data->GetPoint(0)[2]), 3e-4f);
  EXPECT_FLOAT_EQ(static_cast<float>(value(data, "radius", 0)), 15e-6f);
  EXPECT_EQ(value(data, "kind", 0), 0);
  EXPECT_EQ(value(data, "kind", 1), 3);
  EXPECT_EQ(value(data, "state", 0), 2);
  EXPECT_EQ(value(data, "stress", 0), -1234.5);
  EXPECT_FLOAT_EQ(static_cast<float>(value(data, "NO", 0)), 0.0025f);
  EXPECT_FLOAT_EQ(static_cast<float>(value(data, "wss", 0)), 1.6f);
  EXPECT_EQ(value(data, "covered", 0), 1);
  EXPECT_EQ(value(data, "covered", 1), 0);
  EXPECT_EQ(value(data, "daughter", 0), 1);
  EXPECT_EQ(value(data, "fixed", 0), 0);
  EXPECT_EQ(value(data, "id", 1), 1);
  EXPECT_EQ(data->GetFieldData()->GetArray("TimeValue")->GetTuple1(0), 1.0);
}

TEST(TissueWriter, WritesAnEmptyTissue) {
  TemporaryFolder folder;
  writeTissue(folder / "tissue.vtp", AgentStore(), 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "tissue.vtp"));
}

TEST(TissueWriter, LeavesNoFileWhenTheDiskIsFull) {
  TemporaryFolder folder;
  FileSizeLimit full(512);
  EXPECT_THROW(writeTissue(folder / "tissue.vtp", twoAgents(), 0), WriteFailed);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace restenosis
