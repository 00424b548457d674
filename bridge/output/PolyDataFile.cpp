#include "bridge/output/PolyDataFile.h"

#include <fmt/format.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include "bridge/output/DeflateCompressor.h"
#include "bridge/system/AtomicFile.h"
#include "tissue/parameters/SecondsPerDay.h"

namespace restenosis {

void writePolyData(const std::filesystem::path& file, vtkPolyData* data, double time) {
  vtkNew<vtkDoubleArray> timeValue;
  timeValue->SetName("TimeValue");
  timeValue->InsertNextValue(time / secondsPerDay);
  data->GetFieldData()->AddArray(timeValue);

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressor(vtkNew<DeflateCompressor>());
  writer->SetCompressionLevel(1);  // coordinates hardly compress; higher levels cost three times as long
  writer->SetHeaderTypeToUInt64();
  writer->WriteToOutputStringOn();
  if (writer->Write() == 0) throw WriteFailed(fmt::format("cannot encode {}", file.string()));
  atomicWrite(file, writer->GetOutputString());
}

}  // namespace restenosis
