// Random numbers for training.
#pragma once

#include <cstdint>
#include <random>

namespace macula::splat {

// Random numbers for one step: a function of the seed, the step and the purpose.
class Dice {
  public:
    Dice(std::uint32_t seed, std::uint64_t step, std::uint32_t purpose) {
        std::seed_seq sequence{seed, static_cast<std::uint32_t>(step), static_cast<std::uint32_t>(step >> 32),
                               purpose};
        engine_.seed(sequence);
    }
    double operator()() { return (engine_() + 0.5) / 4294967296.0; }  // above 0 and below 1

  private:
    std::mt19937 engine_;
};

}  // namespace macula::splat
