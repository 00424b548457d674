#pragma once

#include <memory>

#include "bridge/flow/FlowBackend.h"

namespace restenosis {

/// A backend that solves by another one in its own way; all else is the other's.
class WrappedBackend : public FlowBackend {
 public:
  explicit WrappedBackend(std::unique_ptr<FlowBackend> backend) : backend_(std::move(backend)) {}
  std::string_view name() const override { return backend_->name(); }
  void startFrom(const std::filesystem::path& formerCase) override { backend_->startFrom(formerCase); }
  bool needsFormerCase() const override { return backend_->needsFormerCase(); }
  std::vector<std::filesystem::path> filesToStartFrom(
      const std::filesystem::path& formerCase) const override {
    return backend_->filesToStartFrom(formerCase);
  }
  std::vector<Vec3> velocities(const std::vector<Vec3>& points) const override {
    return backend_->velocities(points);
  }

 protected:
  FlowBackend& wrapped() { return *backend_; }

 private:
  std::unique_ptr<FlowBackend> backend_;
};

}  // namespace restenosis
