#include "editor/preview_worker.hpp"

namespace inkcell::design::editor {

PreviewWorker::PreviewWorker() : thread_([this] { work(); }) {}

PreviewWorker::~PreviewWorker() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void PreviewWorker::request(PreviewJob job) {
  {
    const std::lock_guard lock(mutex_);
    next_ = std::move(job);
  }
  wake_.notify_one();
}

std::shared_ptr<const Preview> PreviewWorker::latest() const {
  const std::lock_guard lock(mutex_);
  return latest_;
}

bool PreviewWorker::is_busy() const {
  const std::lock_guard lock(mutex_);
  return working_ || next_.has_value();
}

void PreviewWorker::work() {
  gen::BuiltGlyphs glyphs;
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return ending_ || next_.has_value(); });
    if (ending_) {
      return;
    }
    const PreviewJob job = std::move(*next_);
    next_.reset();
    working_ = true;
    lock.unlock();
    auto preview = std::make_shared<const Preview>(draw_preview(job, &glyphs));
    lock.lock();
    latest_ = std::move(preview);
    working_ = false;
  }
}

}  // namespace inkcell::design::editor
