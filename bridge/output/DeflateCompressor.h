#pragma once

#include <vtkZLibDataCompressor.h>

struct libdeflate_compressor;

namespace restenosis {

/// Writes the format of vtkZLibDataCompressor (RFC 1950) by libdeflate, which is faster. Goes by its base's
/// name, which files note for those who read them.
class DeflateCompressor : public vtkZLibDataCompressor {
 public:
  static DeflateCompressor* New();
  DeflateCompressor(const DeflateCompressor&) = delete;
  DeflateCompressor& operator=(const DeflateCompressor&) = delete;

  std::size_t GetMaximumCompressionSpace(std::size_t size) override;
  /// `level` is one of 1 (fast, as a new one has it) to 9 (small).
  void SetCompressionLevel(int level) override;

 protected:
  DeflateCompressor();
  ~DeflateCompressor() override;

  /// Returns the compressed size [bytes], 0 where `space` does not suffice.
  std::size_t CompressBuffer(const unsigned char* data, std::size_t size, unsigned char* compressed,
                             std::size_t space) override;

 private:
  libdeflate_compressor* compressor_;
};

}  // namespace restenosis
