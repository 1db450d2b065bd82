// The radiance cache as a shader looks it up.
#include "pipeline/hybrid/light/light_slots.h"

#include <gtest/gtest.h>

#include <bit>
#include <optional>
#include <random>
#include <vector>

namespace macula::hybrid {
namespace {

// As cellAt in shaders/lib/light_cells.glsl.
std::optional<std::size_t> cellAt(const LightSlots& table, std::uint64_t key) {
    const std::size_t mask = table.slots().size() - 1;
    std::size_t slot = LightInSpace::hashOf(key) & mask;
    for (std::size_t n = 0; n <= mask; ++n) {
        const shared::LightSlot& found = table.slots()[slot];
        if (found.high == shared::kFreeSlot) return {};
        if ((std::uint64_t(found.high) << 32 | found.low) == key) return found.cell;
        slot = (slot + 1) & mask;
    }
    return {};
}

// Cells of 1 mm within a cube of so many mm about a place.
LightInSpace lightIn(int cells, double sideMm, const glm::dvec3& aboutMm) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> even(-0.5 * sideMm, 0.5 * sideMm);
    LightInSpace light(1.0);
    for (int i = 0; i < cells; ++i) {
        const double x = even(random);
        const double y = even(random);
        light.add(aboutMm + glm::dvec3(x, y, even(random)), {0.6, 0.0, 0.8},
                  glm::vec3(float(i % 17), 1.0f, 2.0f));
    }
    light.finish();
    return light;
}

void expectWhole(const LightInSpace& light) {
    const LightSlots table(light);
    ASSERT_TRUE(std::has_single_bit(table.slots().size()));
    ASSERT_GE(table.slots().size(), 2 * light.cells());
    ASSERT_EQ(table.cells().size(), std::max<std::size_t>(6 * light.cells(), 6));
    std::size_t taken = 0;
    for (const shared::LightSlot& slot : table.slots()) taken += slot.high == shared::kFreeSlot ? 0 : 1;
    EXPECT_EQ(taken, light.cells());
    std::size_t found = 0;
    for (std::size_t t = 0; t < LightInSpace::kTables; ++t) {
        light.forEachKeyOf(t, [&](std::uint64_t key, std::size_t cell) {
            const std::optional<std::size_t> at = cellAt(table, key);
            ASSERT_TRUE(at.has_value());
            ++found;
            for (std::size_t lobe = 0; lobe < 6; ++lobe) {
                const glm::vec4& mean = light.cellsOf(t)[cell][lobe];
                const glm::vec4& texel = table.cells()[6 * *at + lobe];
                ASSERT_EQ(glm::vec3(texel), glm::vec3(mean));
                ASSERT_EQ(texel.w, float(LightInSpace::trust(mean.w)));
            }
        });
    }
    EXPECT_EQ(found, light.cells());
    EXPECT_FALSE(cellAt(table, 12345));  // 2^20 cells away
}

// Few, of which the parts of the slots have hardly one, and many, of which some lie beyond their part.
TEST(LightSlots, HoldEachCell) {
    for (const int cells : {1, 2, 7, 8, 15, 16, 500, 30000}) {
        SCOPED_TRACE(cells);
        expectWhole(lightIn(cells, 40.0, {}));
        expectWhole(lightIn(cells, 1000.0, {-900'000.0, 12.0, 900'000.0}));
    }
}

TEST(LightSlots, OfNothingAreFree) {
    LightInSpace nothing(1.0);
    nothing.finish();
    expectWhole(nothing);
    const LightSlots slots(nothing);
    for (const glm::vec4& texel : slots.cells()) EXPECT_EQ(texel, glm::vec4(0.0f));
}

}  // namespace
}  // namespace macula::hybrid
