// Runs work on a second thread while this one does something else, such as wait for the graphics card.
#pragma once

#include <exception>
#include <functional>
#include <thread>

namespace macula {

// Runs one piece of work at a time, in the order of the calls. Used by one thread.
class Aside {
  public:
    Aside() = default;
    Aside(const Aside&) = delete;
    Aside& operator=(const Aside&) = delete;
    ~Aside();  // waits; drops an exception of the work, because the caller is failing already

    // Waits for the previous work, and rethrows its exception. `work` may use all cores (parallel.h). If the
    // process cannot start a thread, this call does the work itself.
    void begin(std::function<void()> work);
    // Waits for the work, and rethrows its exception. The caller then sees everything that the work wrote.
    void wait();
    // The run time of all work that has been waited for.
    double seconds() const { return seconds_; }

  private:
    std::jthread thread_;
    std::exception_ptr thrown_;  // by the work under way
    double took_ = 0.0;          // seconds that the work under way took
    double seconds_ = 0.0;
};

}  // namespace macula
