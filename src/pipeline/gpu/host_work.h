// The native kernels of a recording, each in its place among the commands.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/command_pool.h"
#include "pipeline/gpu/native_kernel.h"

namespace macula::gpu {

// One native kernel, which runs after the commands in `before`, and before those recorded later.
struct HostStep {
    CommandPool::Commands before;
    bool isEmpty = false;  // nothing was recorded in `before`
    NativeKernel kernel;
    NativeDispatch dispatch;
    std::span<const std::byte> groups = {};  // of an indirect dispatch: where to read them; else empty
};

class HostWork {
  public:
    void add(HostStep step) { steps_.push_back(std::move(step)); }

    // Calls complete(commands, isEmpty) for the commands before each kernel, which must return when they and
    // all submitted earlier are done, and then runs the kernel. outOfMemory names the recording by `label`.
    using Complete = std::function<Result<void>(const CommandPool::Commands& commands, bool isEmpty)>;
    Result<void> run(const Complete& complete, const std::string& label);

    // Calls give(commands) for the commands of all steps.
    void giveBack(const std::function<void(const CommandPool::Commands&)>& give) const;

  private:
    std::vector<HostStep> steps_;
};

}  // namespace macula::gpu
