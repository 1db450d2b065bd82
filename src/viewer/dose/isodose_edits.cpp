#include "viewer/dose/isodose_edits.h"

#include <algorithm>
#include <utility>

namespace macula::viewer {

namespace {

constexpr double kPercent = 100.0;

}  // namespace

void IsodoseEdits::change(const std::function<void(scene::Isodoses&)>& edit) {
    if (!session_.state().secondVolume) return;
    session_.change(tr("Isodoses"), [&](scene::StudyState& next) {
        scene::Isodoses isodoses = next.secondVolume->isodoses.value_or(scene::usualIsodoses());
        edit(isodoses);
        if (scene::isUsable(isodoses)) next.secondVolume->isodoses = std::move(isodoses);
    });
}

void IsodoseEdits::show(bool areShown) {
    change([&](scene::Isodoses& each) { each.areShown = areShown; });
}

void IsodoseEdits::setInPercent(bool areInPercent, double reference) {
    change([&](scene::Isodoses& each) {
        if (each.areInPercent == areInPercent || !(reference > 0.0)) return;
        each.areInPercent = areInPercent;
        for (scene::Isodose& line : each.levels)
            line.level *= areInPercent ? kPercent / reference : reference / kPercent;
    });
}

void IsodoseEdits::setReference(std::optional<double> reference) {
    change([&](scene::Isodoses& each) { each.reference = reference; });
}

void IsodoseEdits::setLevel(std::size_t row, double level) {
    change([&](scene::Isodoses& each) {
        if (row < each.levels.size()) each.levels[row].level = level;
    });
}

void IsodoseEdits::setColour(std::size_t row, const std::array<std::uint8_t, 3>& rgb) {
    change([&](scene::Isodoses& each) {
        if (row < each.levels.size()) each.levels[row].rgb = rgb;
    });
}

void IsodoseEdits::add() {
    change([](scene::Isodoses& each) {
        constexpr std::array<std::uint8_t, 3> kWhite{240, 240, 240};
        double lowest = each.areInPercent ? kPercent : 2.0;
        for (const scene::Isodose& line : each.levels) lowest = std::min(lowest, line.level);
        each.levels.push_back({.level = 0.5 * lowest, .rgb = kWhite});
    });
}

void IsodoseEdits::remove(std::size_t row) {
    change([&](scene::Isodoses& each) {
        if (row < each.levels.size()) each.levels.erase(each.levels.begin() + std::ptrdiff_t(row));
    });
}

void IsodoseEdits::setUsual() {
    change([](scene::Isodoses& each) {
        scene::Isodoses usual = scene::usualIsodoses();
        usual.reference = each.reference;
        each = std::move(usual);
    });
}

}  // namespace macula::viewer
