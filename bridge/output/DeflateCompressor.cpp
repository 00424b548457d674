#include "bridge/output/DeflateCompressor.h"

#include <libdeflate.h>
#include <vtkObjectFactory.h>

#include <new>

namespace restenosis {
namespace {

libdeflate_compressor* allocate(int level) {
  libdeflate_compressor* compressor = libdeflate_alloc_compressor(level);
  if (compressor == nullptr) throw std::bad_alloc();
  return compressor;
}

}  // namespace

vtkStandardNewMacro(DeflateCompressor);

DeflateCompressor::DeflateCompressor() {
  CompressionLevel = 1;
  compressor_ = allocate(CompressionLevel);
}

DeflateCompressor::~DeflateCompressor() { libdeflate_free_compressor(compressor_); }

std::size_t DeflateCompressor::GetMaximumCompressionSpace(std::size_t size) {
  return libdeflate_zlib_compress_bound(compressor_, size);
}

void DeflateCompressor::SetCompressionLevel(int level) {
  vtkZLibDataCompressor::SetCompressionLevel(level);
  libdeflate_compressor* another = allocate(CompressionLevel);
  libdeflate_free_compressor(compressor_);
  compressor_ = another;
}

std::size_t DeflateCompressor::CompressBuffer(const unsigned char* data, std::size_t size,
                                              unsigned char* compressed, std::size_t space) {
  return libdeflate_zlib_compress(compressor_, data, size, compressed, space);
}

}  // namespace restenosis
