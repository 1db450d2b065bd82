// The numbers that a person may turn: their ranges are what the pipeline takes, and the page tells all of
// them.
#include "scene/state/parameters.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <span>
#include <string>

#include "base/paths.h"
#include "pipeline/volume/transfer_function_json.h"

namespace macula::scene {
namespace {

TransferFunction aPreset() {
    return {.name = "a",
            .title = "A",
            .modalities = {"CT"},
            .opacity = {{.value = 0.0}, {.value = 100.0, .opacity = 1.0}},
            .colour = {{.value = 0.0}}};
}

template <class Of>
void expectTakesWhatItAllows(const ParameterOf<Of>& p) {
    EXPECT_GE(p.fallback(), p.low) << p.id;
    EXPECT_LE(p.fallback(), p.high) << p.id;
    for (const double value : {p.low, p.high}) {
        Of of;
        p.set(of, value);
        EXPECT_EQ(p.get(of), value) << p.id;
    }
}

TEST(Parameters, FallBackToWhatTheTracerHasAndTakeWhatTheyAllow) {
    for (const Parameter& p : parameters()) {
        expectTakesWhatItAllows(p);
        EXPECT_EQ(&parameter(p.id), &p);
    }
    for (const MatterParameter& p : matterParameters()) {
        expectTakesWhatItAllows(p);
        EXPECT_EQ(&matterParameter(p.id), &p);
    }
}

TEST(Parameters, OfMatterEachChangeOneNumberOfThePreset) {
    for (const MatterParameter& p : matterParameters()) {
        TransferFunction preset = aPreset();
        p.set(preset, 0.5 * (p.fallback() + p.high));
        for (const MatterParameter& other : matterParameters())
            EXPECT_EQ(other.get(preset) != other.get(aPreset()), &other == &p) << p.id << ", " << other.id;
        p.set(preset, p.fallback());
        EXPECT_EQ(preset, aPreset()) << p.id;
    }
}

// What the table allows is valid, and comes back from a file; what lies beyond does neither.
TEST(Parameters, OfMatterHaveTheRangesOfPresetsAndTheirFiles) {
    const auto isKept = [](const TransferFunction& preset) {
        if (!validate(preset)) return false;
        const auto read = transferFunctionFromJson(toJson(preset), "a.json");
        return read.ok() && read->surface == preset.surface && read->steep == preset.steep &&
               read->anisotropy == preset.anisotropy;
    };
    for (const MatterParameter& p : matterParameters()) {
        TransferFunction preset = aPreset();
        preset.surface.weight = 0.5;
        for (const double value : {p.low, p.high}) {
            p.set(preset, value);
            EXPECT_TRUE(isKept(preset)) << p.id << " " << value;
        }
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        for (const double value : {std::nextafter(p.low, -kInfinity), std::nextafter(p.high, kInfinity)}) {
            p.set(preset, value);
            EXPECT_FALSE(isKept(preset)) << p.id << " " << value;
        }
    }
}

template <class Of>
std::string tableOf(std::span<const ParameterOf<Of>> rows) {
    constexpr std::array kStale{"nothing", "display", "camera", "light", "matter", "volume"};
    std::string table = "|---|---|---|---|---|---|---|---|\n";
    for (const ParameterOf<Of>& p : rows)
        table += fmt::format("| {} | `{}` | {:g} | {:g} | {:g} |{} | {} | {} |\n", p.id, p.option, p.low,
                             p.high, p.fallback(), p.unit.empty() ? "" : fmt::format(" {}", p.unit), p.does,
                             kStale.at(std::size_t(p.stale)));
    return table + "\n";
}

TEST(Parameters, AreThoseOfThePage) {
    std::ifstream page(test::projectFolder() / "docs/parameters.md");
    const std::string text{std::istreambuf_iterator<char>(page), {}};
    for (const std::string& table : {tableOf(parameters()), tableOf(matterParameters())})
        EXPECT_NE(text.find(table), std::string::npos) << "docs/parameters.md should say:\n" << table;
}

}  // namespace
}  // namespace macula::scene
