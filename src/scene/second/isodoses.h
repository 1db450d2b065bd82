// The isodose lines of a dose that lies over the study.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace macula::scene {

struct Isodose {
    double level = 0.0;                 // above 0; in percent, or in the unit of the dose
    std::array<std::uint8_t, 3> rgb{};  // sRGB

    bool operator==(const Isodose&) const = default;
};

inline constexpr std::size_t kMostIsodoses = 16;
inline constexpr double kHighestIsodose = 1e6;

struct Isodoses {
    bool areShown = true;
    bool areInPercent = true;          // of the reference
    std::vector<Isodose> levels = {};  // at most kMostIsodoses
    // What 100 percent are, in the unit of the dose; nothing: the prescription, else the maximum.
    std::optional<double> reference = {};

    bool operator==(const Isodoses&) const = default;
};

// 107, 100, 95, 80, 50, 30 and 10 percent, from red to blue.
Isodoses usualIsodoses();

// Positive, finite, not too many.
bool isUsable(const Isodoses& isodoses);

}  // namespace macula::scene
