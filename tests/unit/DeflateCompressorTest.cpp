#include <gtest/gtest.h>
#include <vtkNew.h>

#include <random>
#include <vector>

#include "bridge/output/DeflateCompressor.h"

namespace restenosis {
namespace {

using Bytes = std::vector<unsigned char>;

Bytes randomBytes(std::size_t size) {
  std::mt19937 random(1);
  Bytes bytes(size);
  for (auto& byte : bytes) byte = static_cast<unsigned char>(random());
  return bytes;
}

/// Compressed by the compressor under test.
Bytes compress(const Bytes& data, int level) {
  vtkNew<DeflateCompressor> compressor;
  compressor->SetCompressionLevel(level);
  Bytes compressed(compressor->GetMaximumCompressionSpace(data.size()));
  compressed.resize(compressor->Compress(data.data(), data.size(), compressed.data(), compressed.size()));
  return compressed;
}

/// Uncompressed by VTK.
Bytes uncompress(const Bytes& compressed, std::size_t size) {
  vtkNew<vtkZLibDataCompressor> zlib;
  Bytes data(size);
  EXPECT_EQ(zlib->Uncompress(compressed.data(), compressed.size(), data.data(), data.size()), size);
  return data;
}

TEST(DeflateCompressor, ZlibReadsWhatItWrites) {
  for (const int level : {1, 5, 9}) {
    const Bytes zeros(100'000, 0), noise = randomBytes(100'000), one{42};
    for (const Bytes& data : {zeros, noise, one})
      EXPECT_EQ(uncompress(compress(data, level), data.size()), data);
  }
}

TEST(DeflateCompressor, MakesAlikeBytesSmall) { EXPECT_LT(compress(Bytes(100'000, 7), 1).size(), 1000U); }

TEST(DeflateCompressor, HigherLevelsMakeFilesSmaller) {
  Bytes counting(100'000);
  for (std::size_t i = 0; i < counting.size(); ++i) counting[i] = static_cast<unsigned char>(i * i / 1000);
  EXPECT_LT(compress(counting, 9).size(), compress(counting, 1).size());
}

TEST(DeflateCompressor, FilesSayThatVtksOwnReadsThem) {
  vtkNew<DeflateCompressor> compressor;
  EXPECT_STREQ(compressor->GetClassName(), "vtkZLibDataCompressor");
}

TEST(DeflateCompressor, SaysWhenThereIsTooLittleRoom) {
  vtkNew<DeflateCompressor> compressor;
  const Bytes data = randomBytes(1000);
  Bytes compressed(10);
  EXPECT_EQ(compressor->Compress(data.data(), data.size(), compressed.data(), compressed.size()), 0U);
}

}  // namespace
}  // namespace restenosis
