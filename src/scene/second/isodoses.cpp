#include "scene/second/isodoses.h"

#include <algorithm>

namespace macula::scene {

namespace {

// A comparison with NaN is false.
bool isLevel(double value) {
    return value > 0.0 && value <= kHighestIsodose;
}

}  // namespace

Isodoses usualIsodoses() {
    return {.levels = {{.level = 107.0, .rgb = {255, 90, 220}},
                       {.level = 100.0, .rgb = {255, 60, 60}},
                       {.level = 95.0, .rgb = {255, 150, 0}},
                       {.level = 80.0, .rgb = {250, 230, 70}},
                       {.level = 50.0, .rgb = {70, 210, 90}},
                       {.level = 30.0, .rgb = {60, 210, 235}},
                       {.level = 10.0, .rgb = {110, 150, 255}}}};
}

bool isUsable(const Isodoses& isodoses) {
    return isodoses.levels.size() <= kMostIsodoses &&
           std::ranges::all_of(isodoses.levels, [](const Isodose& each) { return isLevel(each.level); }) &&
           (!isodoses.reference || isLevel(*isodoses.reference));
}

}  // namespace macula::scene
