// A peripheral model in a file: all of it comes back, and what is not whole is told.
#include "pipeline/hybrid/model/peripheral_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "pipeline/splat/files/option_lines.h"
#include "splat/chunks.h"
#include "splat/training_support.h"

namespace macula::hybrid {
namespace {

using splat::ChunkEntry;
using splat::Splats;
using splat::testing::expectSame;
using splat::testing::randomModel;
using splat::testing::randomState;
using splat::testing::replace;
using splat::testing::sameBits;
using splat::testing::TakenApart;

// Valid. `isApart`: what is shown, and the best that was, are not what was trained last.
PeripheralState randomPeripheral(std::size_t splats, int degree, bool isApart, unsigned seed) {
    PeripheralState state;
    state.training = randomState(splats, degree, 2, {5, 4}, seed);
    const splat::TrainingState other = randomState(1, 0, 3, {6, 3}, seed + 1);
    for (const auto& view : other.views) state.heldOut.push_back(view.given);
    if (isApart) {
        state.shown = std::make_shared<const Splats>(randomModel(splats + 2, degree, seed + 2));
        state.best = std::make_shared<const Splats>(randomModel(splats + 1, degree, seed + 3));
    }
    state.generation = 12345678901234567u;
    state.seenMm = {glm::dvec3(-4.0, -1.0 / 3.0, -3e5), glm::dvec3(2.0, 1.0 / 7.0, 3.0)};
    state.gain = 1.0 / 3.0;
    state.offered = 7;
    state.asked = ~std::uint64_t(0);
    state.roundViews = 5;
    state.first = state.training.options;
    state.first.capacity = 77;
    state.first.optimizer.dc = 1.0 / 9.0;
    return state;
}

std::string fileOf(const PeripheralState& state) {
    std::ostringstream stream;
    splat::PackedPictures packed;
    EXPECT_TRUE(writePeripheral(stream, state, packed).ok());
    return stream.str();
}

Result<PeripheralFile> parse(const std::string& bytes) {
    std::istringstream stream(bytes);
    return readPeripheral(stream, bytes.size());
}

// Of a file of `size` bytes, of which there are these.
Result<DrawableModel> parseDrawable(const std::string& bytes, std::uint64_t size) {
    std::istringstream stream(bytes);
    return readDrawable(stream, size);
}
Result<DrawableModel> parseDrawable(const std::string& bytes) {
    return parseDrawable(bytes, bytes.size());
}

const Splats& shownOf(const PeripheralState& state) {
    return state.shown ? *state.shown : state.training.splats;
}
const Splats& bestOf(const PeripheralState& state) {
    return state.best ? *state.best : shownOf(state);
}

void expectSameModel(const PeripheralState& a, const PeripheralState& b) {
    expectSame(a.training, b.training, "training");
    const auto judgesOf = [](const PeripheralState& state) {
        splat::TrainingState of;
        for (const auto& picture : state.heldOut) of.views.push_back({.given = picture});
        return of;
    };
    expectSame(judgesOf(a), judgesOf(b), "held out");
    EXPECT_TRUE(sameBits(shownOf(a), shownOf(b)));
    EXPECT_TRUE(sameBits(bestOf(a), bestOf(b)));
    EXPECT_EQ(a.generation, b.generation);
    EXPECT_EQ(a.seenMm.low, b.seenMm.low);
    EXPECT_EQ(a.seenMm.high, b.seenMm.high);
    EXPECT_EQ(a.gain, b.gain);
    EXPECT_EQ(a.offered, b.offered);
    EXPECT_EQ(a.asked, b.asked);
    EXPECT_EQ(a.roundViews, b.roundViews);
    EXPECT_EQ(splat::linesOf(a.first), splat::linesOf(b.first));
    EXPECT_EQ(a.first.key, b.first.key);
}

// Where the chunk of that name ends.
std::size_t endOf(const TakenApart& file, std::string_view name) {
    const auto found = std::ranges::find(file.entries(), name, &ChunkEntry::name);
    return found->offset + found->storedBytes;
}

TEST(PeripheralFile, GivesBackEveryBit) {
    splat::PackedPictures packed;  // of the one before: of no use here, and no harm
    for (const bool isApart : {false, true}) {
        for (const std::size_t splats : {0u, 50u}) {
            const PeripheralState state = randomPeripheral(splats, isApart ? 1 : 0, isApart, 11);
            ASSERT_TRUE(state.validate().ok());
            const std::string bytes = fileOf(state);
            for (int time = 0; time < 2; ++time) {
                std::ostringstream stream;
                ASSERT_TRUE(writePeripheral(stream, state, packed).ok());
                EXPECT_EQ(stream.str(), bytes);
            }
            const auto read = parse(bytes);
            ASSERT_TRUE(read.ok()) << read.error().message;
            EXPECT_FALSE(read->isTrainingOnly);
            expectSameModel(read->state, state);
            EXPECT_EQ(read->state.shown != nullptr, isApart);
            EXPECT_EQ(fileOf(read->state), bytes);
            std::istringstream stream(bytes);
            const auto training = splat::readTraining(stream, bytes.size());
            ASSERT_TRUE(training.ok());
            expectSame(*training, state.training, "by who knows the training only");
        }
    }
}

TEST(PeripheralFile, HoldsNoModelTwice) {
    PeripheralState state = randomPeripheral(50, 1, false, 13);
    const std::string bytes = fileOf(state);
    state.shown = std::make_shared<const Splats>(state.training.splats);
    state.best = std::make_shared<const Splats>(state.training.splats);
    EXPECT_EQ(fileOf(state), bytes);
    state.shown = std::make_shared<const Splats>(randomModel(50, 1, 14));
    const auto read = parse(fileOf(state));
    ASSERT_TRUE(read.ok());
    EXPECT_TRUE(sameBits(bestOf(read->state), state.training.splats)) << "the best need not be what is shown";
    state.best = state.shown;
    EXPECT_EQ(parse(fileOf(state))->state.best, nullptr);
}

TEST(PeripheralFile, WhatIsNotValidIsNotWritten) {
    const auto refused = [](const std::function<void(PeripheralState&)>& change) {
        PeripheralState state = randomPeripheral(5, 0, true, 17);
        change(state);
        std::ostringstream stream;
        splat::PackedPictures packed;
        const auto done = writePeripheral(stream, state, packed);
        ASSERT_FALSE(done.ok());
        EXPECT_EQ(done.error().code, ErrorCode::inputNotUsable);
        EXPECT_EQ(stream.str(), "");
    };
    refused([](PeripheralState& s) { s.training.optimizer.second.pop_back(); });
    refused([](PeripheralState& s) { s.heldOut[1] = nullptr; });
    refused([](PeripheralState& s) {
        splat::TrainingView small = *s.heldOut[1];
        small.pixels.pop_back();
        s.heldOut[1] = std::make_shared<const splat::TrainingView>(std::move(small));
    });
    refused([](PeripheralState& s) {
        Splats bad = *s.shown;
        bad.dc[0].x = std::nanf("");
        s.shown = std::make_shared<const Splats>(std::move(bad));
    });
    refused([](PeripheralState& s) { s.seenMm = {}; });
    refused([](PeripheralState& s) { s.seenMm.high.x = std::numeric_limits<double>::infinity(); });
    refused([](PeripheralState& s) { s.gain = std::nan(""); });
    refused([](PeripheralState& s) { s.first.key = "another"; });
}

// Whatever becomes of the rest, most of which is pictures.
TEST(PeripheralFile, WhatCanBeDrawnLiesFirst) {
    for (const bool isApart : {false, true}) {
        const PeripheralState state = randomPeripheral(6, 1, isApart, 19);
        const std::string bytes = fileOf(state);
        const TakenApart file(bytes);
        const std::size_t end = endOf(file, "notes");
        EXPECT_LT(end, endOf(file, "first"));
        EXPECT_LT(endOf(file, "key"), end);
        EXPECT_EQ(file.entries().back().name, "heldpix");
        const auto expectShown = [&](const Result<DrawableModel>& model) {
            ASSERT_TRUE(model.ok()) << model.error().message;
            EXPECT_TRUE(sameBits(*model->splats, shownOf(state)));
            EXPECT_EQ(model->key, state.training.options.key);
            EXPECT_EQ(model->trainerVersion, splat::kTrainerVersion);
            EXPECT_EQ(model->steps, state.training.steps);
            EXPECT_EQ(model->gain, state.gain);
            EXPECT_EQ(model->seenMm.low, state.seenMm.low);
            EXPECT_EQ(model->seenMm.high, state.seenMm.high);
            EXPECT_FALSE(model->isTrainingOnly);
        };
        expectShown(parseDrawable(bytes));
        expectShown(parseDrawable(bytes.substr(0, end), bytes.size()));
        EXPECT_FALSE(parseDrawable(bytes.substr(0, end - 1), bytes.size()).ok());
        // A changed bit is told, or is of what is not read: the number of chunks, and a model that is not
        // shown.
        std::size_t told = 0;
        for (std::size_t i = 0; i < end; ++i) {
            std::string bad = bytes;
            bad[i] = static_cast<char>(bad[i] ^ (1 << (i % 8)));
            const auto model = parseDrawable(bad);
            if (model.ok()) expectShown(model);
            told += model.ok() ? 0 : 1;
        }
        EXPECT_GE(told + 4 + (isApart ? endOf(file, "splats") : 0), end);
    }
}

TEST(PeripheralFile, ATrainingAloneIsToldFromIt) {
    const splat::TrainingState training = randomState(12, 1, 2, {5, 4}, 23);
    std::ostringstream stream;
    ASSERT_TRUE(splat::writeTraining(stream, training).ok());
    auto read = parse(stream.str());
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_TRUE(read->isTrainingOnly);
    expectSame(read->state.training, training, "alone");
    EXPECT_TRUE(read->state.heldOut.empty());
    EXPECT_FALSE(read->state.validate().ok()) << "what can be seen is not known";
    read->state.seenMm.high = glm::dvec3(1.0);
    EXPECT_TRUE(read->state.validate().ok());
    const auto drawable = parseDrawable(stream.str());
    ASSERT_TRUE(drawable.ok());
    EXPECT_TRUE(drawable->isTrainingOnly);
    EXPECT_TRUE(sameBits(*drawable->splats, training.splats));
    EXPECT_EQ(drawable->steps, training.steps);
}

TEST(PeripheralFile, NothingMayBeMissing) {
    const TakenApart file(fileOf(randomPeripheral(5, 0, true, 29)));
    ASSERT_TRUE(parse(file.without("none")).ok());
    const auto refused = [&](std::string_view chunk) {
        const auto read = parse(file.without(chunk));
        ASSERT_FALSE(read.ok()) << chunk;
        EXPECT_EQ(read.error().code, ErrorCode::inputNotUsable) << chunk;
    };
    for (const splat::TrainingChunk& chunk : splat::kTrainingChunks) refused(chunk.name);
    for (const splat::TrainingChunk& chunk : kPeripheralChunks) refused(chunk.name);
    for (const char* chunk : {"model", "training", "key", "notes", "shown", "shownspl"}) {
        const bool isNeeded = std::string_view(chunk) != "model";  // another one is shown
        EXPECT_EQ(parseDrawable(file.without(chunk)).ok(), !isNeeded) << chunk;
    }
}

TEST(PeripheralFile, OfAnotherTrainerItCanBeDrawn) {
    const PeripheralState state = randomPeripheral(5, 0, true, 31);
    const std::string other = TakenApart(fileOf(state)).with("training", [](std::string& text) {
        replace(text, fmt::format("trainer {}\n", splat::kTrainerVersion), "trainer 77\n");
        replace(text, "option optimizer.beta1", "option optimizer.beta9");
    });
    const auto read = parse(other);
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.error().code, ErrorCode::inputNotUsable);
    EXPECT_NE(read.error().message.english().find("version 77"), std::string::npos) << read.error().message;
    EXPECT_NE(read.error().message.english().find(fmt::format("version {}", splat::kTrainerVersion)),
              std::string::npos);
    const auto drawable = parseDrawable(other);
    ASSERT_TRUE(drawable.ok());
    EXPECT_EQ(drawable->trainerVersion, 77u);
    EXPECT_TRUE(sameBits(*drawable->splats, shownOf(state)));
}

// All with whole checksums.
TEST(PeripheralFile, WhatDoesNotFitIsRefused) {
    PeripheralState state = randomPeripheral(5, 1, true, 37);
    state.gain = 0.75;
    const TakenApart good(fileOf(state));
    const auto refused = [&](std::string_view chunk, const std::function<void(std::string&)>& change,
                             bool isDrawnBy = false) {
        const std::string bad = good.with(chunk, change);
        const auto read = parse(bad);
        ASSERT_FALSE(read.ok()) << chunk;
        EXPECT_EQ(read.error().code, ErrorCode::inputNotUsable) << chunk;
        EXPECT_EQ(parseDrawable(bad).ok(), !isDrawnBy) << chunk;
    };
    const auto put = [](std::size_t offset, auto value) {
        return [=](std::string& bytes) { std::memcpy(&bytes[offset], &value, sizeof(value)); };
    };
    const auto swapped = [](const std::string& from, const std::string& to) {
        return [=](std::string& text) { replace(text, from, to); };
    };
    for (const char* gain : {"gain nan", "gain inf", "gain 0", "gain -1", "gain 1 2", "gain 1x", "gain ",
                             "gain", "gains 0.75", "gain 1\ngain 1", "gain 1e999"})
        refused("notes", swapped("gain 0.75", gain), true);
    for (const char* box : {"seen-mm 4 ", "seen-mm -4 1 ", "seen-mm nan ", "seen-mm -inf ", "seen-mm "})
        refused("notes", swapped("seen-mm -4 ", box), true);
    for (const char* count : {"held-out 2", "held-out 4", "held-out 1048576"})
        refused("notes", swapped("held-out 3", count));
    for (const char* count : {"held-out 4000000000", "held-out -1", "held-out"})
        refused("notes", swapped("held-out 3", count), true);
    refused("notes", swapped("shown-apart 1", "shown-apart 2"), true);
    refused("notes", swapped("best-apart 1", "best-apart"), true);
    refused("notes", swapped("generation 1", "generation -1"), true);
    refused("notes", swapped("first capacity", "first capacities"));
    refused("notes", swapped("first loss.encode display", "first loss.encode other"));
    refused("notes", swapped("first seed", "first seed 1\nfirst seed"));
    refused("shown", swapped("splats 7", "splats 8"), true);
    refused("shown", swapped("degree 1", "degree 0"), true);
    refused("shownspl", put(0, std::nanf("")), true);
    refused("bestspl", put(4, std::numeric_limits<float>::infinity()));
    refused("bestspl", [](std::string& bytes) { bytes.resize(bytes.size() - 4); });
    refused("heldout", put(0, 3.0));  // no rotation
    refused("heldout", put(152, std::int32_t{1 << 30}));
    refused("heldout", put(160, 0.0f));  // weight
    refused("heldout", put(160, std::nanf("")));
    refused("heldout", put(160, 2.0f * splat::kMaxViewWeight));
    refused("heldout", put(164, std::uint32_t{3}));
    refused("heldout", [](std::string& bytes) { bytes.resize(bytes.size() - 168); });
    refused("heldpix", [](std::string& bytes) { bytes.resize(bytes.size() - 16); });
    refused("second", put(4, -1.0f));
    const TakenApart together(fileOf(randomPeripheral(5, 1, false, 37)));
    for (const char* name : {"shown-apart", "best-apart"})
        EXPECT_FALSE(
            parse(together.with("notes", swapped(std::string(name) + " 0", std::string(name) + " 1"))).ok());
}

TEST(PeripheralFile, EveryLengthIsToldThatIsNotItsOwn) {
    const std::string bytes = fileOf(randomPeripheral(4, 0, true, 41));
    const std::size_t end = endOf(TakenApart(bytes), "notes");
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        const std::string cut = bytes.substr(0, length);
        ASSERT_FALSE(parse(cut).ok()) << length;
        ASSERT_EQ(parseDrawable(cut).ok(), length >= end) << length;
        // Of a file that became shorter since its size was asked for.
        std::istringstream stream(cut);
        ASSERT_FALSE(readPeripheral(stream, bytes.size()).ok()) << length;
    }
    EXPECT_FALSE(parse(bytes + "x").ok());
}

int mutations() {
    const char* wanted = std::getenv("MACULA_MUTATIONS");  // up to a million: minutes
    return wanted == nullptr ? 10000 : std::clamp(std::atoi(wanted), 1000, 1000000);
}

// Half of it by the checksums, half of it with checksums that were made afterwards.
TEST(PeripheralFile, RandomDamage) {
    std::mt19937 random(43);
    const std::string bytes = fileOf(randomPeripheral(4, 0, true, 47));
    const TakenApart file(bytes);
    const int count = mutations();
    int refused = 0;
    for (int i = 0; i < count; ++i) {
        const bool isInside = i % 2 == 1;
        const std::string& name = file.entries()[random() % file.entries().size()].name;
        const auto damage = [&](std::string& content) { content = splat::testing::mutated(content, random); };
        const std::string bad = isInside ? file.with(name, damage) : splat::testing::mutated(bytes, random);
        const auto read = parse(bad);
        if (!isInside) {
            ASSERT_EQ(read.ok(), bad == bytes) << i;
        }
        if (read.ok()) {
            ASSERT_TRUE(read->state.validate().ok()) << i << " " << name;
        } else {
            ASSERT_EQ(read.error().code, ErrorCode::inputNotUsable) << i << " " << name;
            ++refused;
        }
        const auto drawable = parseDrawable(bad);
        if (drawable.ok()) {
            ASSERT_TRUE(drawable->splats->validate().ok()) << i << " " << name;
            ASSERT_TRUE(areUsable(drawable->seenMm, drawable->gain)) << i << " " << name;
        }
    }
    EXPECT_GT(refused, count / 2);
    EXPECT_LT(refused, count) << "a picture may be any";
}

TEST(PeripheralFile, ThePageAndTheTableSayWhatIsWritten) {
    const auto onPage = splat::testing::chunksOnThePage("| further chunk | stride |");
    EXPECT_EQ(onPage.size(), kPeripheralChunks.size());
    std::vector<ChunkEntry> written = TakenApart(fileOf(randomPeripheral(5, 1, true, 53))).entries();
    std::erase_if(written, [](const ChunkEntry& entry) {
        return std::ranges::find(splat::kTrainingChunks, entry.name, &splat::TrainingChunk::name) !=
               splat::kTrainingChunks.end();
    });
    ASSERT_EQ(written.size(), kPeripheralChunks.size() + 2) << "three pictures are held out";
    for (std::size_t i = 0; i < kPeripheralChunks.size(); ++i) {
        const splat::TrainingChunk& chunk = kPeripheralChunks[i];
        EXPECT_EQ(written[i].name, chunk.name);
        EXPECT_EQ(written[i].stride, chunk.stride) << chunk.name;
        const auto row = onPage.find(std::string(chunk.name));
        ASSERT_NE(row, onPage.end()) << chunk.name;
        EXPECT_EQ(row->second, std::to_string(chunk.stride)) << chunk.name;
    }
}

}  // namespace
}  // namespace macula::hybrid
