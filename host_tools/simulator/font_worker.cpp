#include "font_worker.hpp"

#include <chrono>
#include <stdexcept>
#include <utility>

namespace inkcell::tools {
namespace {

bool is_ready(const std::future<RomFile>& result) {
  return result.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

FontWorker::~FontWorker() {
  if (job_ != nullptr) {
    job_->is_dropped = true;  // the future waits for its thread
  }
}

void FontWorker::begin(const FontWish& wish) {
  job_ = std::make_unique<Job>();
  job_->wish = wish;
  job_->result = std::async(std::launch::async, [this, job = job_.get()] {
    return make_(job->wish, [job](size_t done, size_t count) {
      if (job->is_dropped) {
        throw std::runtime_error("another font was asked for");
      }
      job->done = done;
      job->count = count;
    });
  });
}

std::optional<RomFile> FontWorker::take(const FontWish& wish) {
  if (job_ != nullptr && !(job_->wish == wish)) {
    job_->is_dropped = true;
    if (!is_ready(job_->result)) {
      return std::nullopt;
    }
    job_.reset();
  }
  if (job_ == nullptr) {
    begin(wish);
  }
  if (!is_ready(job_->result)) {
    return std::nullopt;
  }
  const std::unique_ptr<Job> job = std::move(job_);
  return job->result.get();
}

std::optional<FontWorker::Work> FontWorker::work() const {
  if (job_ == nullptr || is_ready(job_->result)) {
    return std::nullopt;
  }
  return Work{job_->wish.coding, job_->done, job_->count};
}

}  // namespace inkcell::tools
