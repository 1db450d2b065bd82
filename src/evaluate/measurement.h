// Time that work took, and how contenders that take turns compare: a ratio means something on every machine,
// milliseconds only on one.
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

// What a measurement that was cancelled fails with.
inline Error cancelledError() {
    return {ErrorCode::cancelled, Text("The measurement was cancelled."), {}, {}};
}

// CPU time is that of all threads of this process: on a CPU device it hardly depends on who else is running;
// on a GPU it is only what host and driver used.
struct Spent {
    double wallMs = 0.0;
    double cpuMs = 0.0;
};

inline Spent operator+(const Spent& a, const Spent& b) {
    return {a.wallMs + b.wallMs, a.cpuMs + b.cpuMs};
}
// Not below 0.
inline Spent operator-(const Spent& a, const Spent& b) {
    return {std::max(a.wallMs - b.wallMs, 0.0), std::max(a.cpuMs - b.cpuMs, 0.0)};
}
inline Spent operator/(const Spent& a, double divisor) {
    return {a.wallMs / divisor, a.cpuMs / divisor};
}

class Watch {
  public:
    // Since the last call, or since this was made.
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

// `work` returns a Result<void>, and fails for this.
template <class Work>
Result<Spent> timed(const Work& work) {
    Watch watch;
    MACULA_TRY_VOID(work());
    return watch.lap();
}

// The same: only its time by the clock, in ms.
template <class Work>
Result<double> timedMs(const Work& work) {
    MACULA_TRY(const Spent spent, timed(work));
    return spent.wallMs;
}

// The mean of both in the middle where their number is even. There must be at least one.
inline double median(std::vector<double> values) {
    MACULA_CHECK(!values.empty());
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

// The median of so many times, after one that does not count: it compiles kernels, or fills caches.
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

// One of those that take turns, so that a busy neighbour hits all of them.
struct Contender {
    std::vector<Spent> turns;

    Spent medians() const {
        return {median(numbers([](const Spent& spent) { return spent.wallMs; })),
                median(numbers([](const Spent& spent) { return spent.cpuMs; }))};
    }

    // Medians of the ratios of each turn; `other` has had as many.
    Ratio ratioTo(const Contender& other) const {
        MACULA_CHECK(turns.size() == other.turns.size());
        constexpr double kTickMs = 1e-3;  // of a clock: what took no time took at most that
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
