// Makes previews on a thread of its own.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "editor/preview.hpp"

namespace inkcell::design::editor {

/// Works on the latest job; replaced jobs are dropped.
class PreviewWorker {
 public:
  PreviewWorker();
  ~PreviewWorker();
  PreviewWorker(const PreviewWorker&) = delete;
  PreviewWorker& operator=(const PreviewWorker&) = delete;

  void request(PreviewJob job);
  /// The latest finished preview, null before the first.
  std::shared_ptr<const Preview> latest() const;
  bool is_busy() const;

 private:
  void work();

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<PreviewJob> next_;
  std::shared_ptr<const Preview> latest_;
  bool working_ = false;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace inkcell::design::editor
