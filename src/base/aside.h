// Work on a thread beside this one, which meanwhile does something else: waits for a graphics card, say.
#pragma once

#include <exception>
#include <functional>
#include <thread>

namespace macula {

// One piece of work at a time, in the order in which they are begun. Used by one thread.
class Aside {
  public:
    Aside() = default;
    Aside(const Aside&) = delete;
    Aside& operator=(const Aside&) = delete;
    ~Aside();  // waits; what the work threw is lost, as whoever leaves without waiting fails anyway

    // Waits for the work before it, and throws what that threw. `work` may use all cores (parallel.h). Where
    // the process has no thread left it is done here and now.
    void begin(std::function<void()> work);
    // Throws what the work threw. Afterwards all that it wrote is seen.
    void wait();
    // Of all work that was waited for.
    double seconds() const { return seconds_; }

  private:
    std::jthread thread_;
    std::exception_ptr thrown_;  // of the work under way
    double took_ = 0.0;          // likewise
    double seconds_ = 0.0;
};

}  // namespace macula
