// Measures the time of work, and compares contenders that alternate: ratios are comparable between machines,
// milliseconds are not.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/result.h"

namespace macula::evaluate {

// The error of a cancelled measurement.
inline Error cancelledError() {
    return {ErrorCode::cancelled, Text("The measurement was cancelled."), {}, {}};
}

// CPU time is that of all threads of this process: on a CPU device it hardly depends on other load; on a GPU
// it covers only host and driver.
struct Spent {
    double wallMs = 0.0;
    double cpuMs = 0.0;
};

inline Spent operator+(const Spent& a, const Spent& b) {
    return {a.wallMs + b.wallMs, a.cpuMs + b.cpuMs};
}
// The difference, but not below 0.
inline Spent operator-(const Spent& a, const Spent& b) {
    return {std::max(a.wallMs - b.wallMs, 0.0), std::max(a.cpuMs - b.cpuMs, 0.0)};
}
inline Spent operator/(const Spent& a, double divisor) {
    return {a.wallMs / divisor, a.cpuMs / divisor};
}

class Watch {
  public:
    // The time since the last call, or since construction.
    Spent lap() {
        const auto wall = std::chrono::steady_clock::now();
        const std::clock_t cpu = std::clock();
        const Spent spent{std::chrono::duration<double, std::milli>(wall - wall_).count(),
                          1000.0 * double(cpu - cpu_) / CLOCKS_PER_SEC};
        wall_ = wall;
        cpu_ = cpu;
        return spent;
    }

  private:
    std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
    std::clock_t cpu_ = std::clock();
};

// The time of `work`, which returns a Result<void>; fails if that does.
template <class Work>
Result<Spent> timed(const Work& work) {
    Watch watch;
    MACULA_TRY_VOID(work());
    return watch.lap();
}

// The same, but only wall time, in ms.
template <class Work>
Result<double> timedMs(const Work& work) {
    MACULA_TRY(const Spent spent, timed(work));
    return spent.wallMs;
}

// The mean of the two middle values if their number is even. There must be at least one.
inline double median(std::vector<double> values) {
    MACULA_CHECK(!values.empty());
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

// The median of `turns` times, after an unmeasured first one, which compiles kernels or fills caches.
template <class Work>
Result<double> medianMs(int turns, const Work& work) {
    MACULA_TRY_VOID(work());
    std::vector<double> times;
    for (int i = 0; i < turns; ++i) {
        MACULA_TRY(const double ms, timedMs(work));
        times.push_back(ms);
    }
    return median(std::move(times));
}

struct Ratio {
    double wall = 0.0;
    double cpu = 0.0;
};

// One of several contenders that alternate, so that other load affects all of them.
struct Contender {
    std::vector<Spent> turns;

    Spent medians() const {
        return {median(numbers([](const Spent& spent) { return spent.wallMs; })),
                median(numbers([](const Spent& spent) { return spent.cpuMs; }))};
    }

    // Medians of the ratios of each turn; `other` must have as many turns.
    Ratio ratioTo(const Contender& other) const {
        MACULA_CHECK(turns.size() == other.turns.size());
        constexpr double kTickMs = 1e-3;  // resolution of a clock: a measured 0 means at most this
        std::vector<double> wall;
        std::vector<double> cpu;
        for (std::size_t i = 0; i < turns.size(); ++i) {
            wall.push_back(turns[i].wallMs / std::max(other.turns[i].wallMs, kTickMs));
            cpu.push_back(turns[i].cpuMs / std::max(other.turns[i].cpuMs, kTickMs));
        }
        return {median(std::move(wall)), median(std::move(cpu))};
    }

  private:
    template <class Number>
    std::vector<double> numbers(const Number& of) const {
        std::vector<double> all;
        for (const Spent& spent : turns) all.push_back(of(spent));
        return all;
    }
};

}  // namespace macula::evaluate
