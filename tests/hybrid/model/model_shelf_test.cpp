// What is kept of what was shown before.
#include "pipeline/hybrid/model/model_shelf.h"

#include <gtest/gtest.h>

namespace macula::hybrid {
namespace {

std::shared_ptr<const PeripheralState> of(const std::string& key, std::size_t pixels,
                                          std::size_t splats = 0) {
    auto state = std::make_shared<PeripheralState>();
    state->training.options.key = key;
    state->training.splats.resize(splats);
    splat::TrainingView view;
    view.pixels.resize(pixels);
    state->training.views.push_back({.given = std::make_shared<const splat::TrainingView>(view)});
    state->heldOut.push_back(std::make_shared<const splat::TrainingView>(view));
    return state;
}

TEST(ModelShelf, KeepsTheLastOnesThereIsRoomFor) {
    EXPECT_EQ(bytesOf(*of("a", 10)), 320u);
    EXPECT_EQ(bytesOf(*of("a", 10, 3)), 320u + 3 * (3 * 4 * 14 + 20));
    ModelShelf shelf(1000);
    EXPECT_EQ(shelf.find("a"), nullptr);
    const auto a = of("a", 10);
    shelf.put(a);
    shelf.put(of("b", 10));
    shelf.put(of("c", 10));
    EXPECT_EQ(shelf.find("a"), a);
    EXPECT_EQ(shelf.size(), 3u);
    const auto newer = of("a", 11);
    shelf.put(newer);
    EXPECT_EQ(shelf.find("a"), newer) << "instead of the one of the same key";
    EXPECT_EQ(shelf.size(), 3u);
    shelf.put(of("d", 10));
    EXPECT_EQ(shelf.find("b"), nullptr) << "the oldest goes";
    EXPECT_EQ(shelf.find("a"), newer);
    shelf.put(of("large", 100));
    EXPECT_EQ(shelf.find("large"), nullptr);
    EXPECT_EQ(shelf.size(), 3u) << "and pushes nothing off";
}

TEST(ModelShelf, WhatIsLookedForIsNotPushedOffByWhatItReplaces) {
    ModelShelf shelf(1000);
    for (const char* key : {"a", "b", "c"}) shelf.put(of(key, 10));
    ASSERT_NE(shelf.find("a"), nullptr);
    shelf.put(of("d", 10));
    EXPECT_NE(shelf.find("a"), nullptr);
    EXPECT_EQ(shelf.find("b"), nullptr);
}

}  // namespace
}  // namespace macula::hybrid
