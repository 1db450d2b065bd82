// .macula files: all of a training comes back, and what is not whole is told.
#include "pipeline/splat/files/training_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include "base/paths.h"
#include "pipeline/splat/files/chunk_file.h"
#include "pipeline/splat/files/option_lines.h"
#include "splat/chunks.h"
#include "splat/training_support.h"

namespace macula::splat {
namespace {

namespace fs = std::filesystem;
using testing::expectSame;
using testing::randomState;
using testing::replace;

std::string fileOf(const TrainingState& state) {
    std::ostringstream stream;
    EXPECT_TRUE(writeTraining(stream, state).ok());
    return stream.str();
}

Result<TrainingState> parse(const std::string& bytes) {
    std::istringstream stream(bytes);
    return readTraining(stream, bytes.size());
}

Result<ModelFile> parseModel(const std::string& bytes) {
    std::istringstream stream(bytes);
    return readTrainedModel(stream, bytes.size(), BadSplats::refuse);
}

// With whole checksums, one chunk changed.
std::string changed(const std::string& bytes, std::string_view name,
                    const std::function<void(std::string&)>& change) {
    return testing::TakenApart(bytes).with(name, change);
}

TEST(TrainingFile, GivesBackEveryBit) {
    for (const int degree : {0, 1}) {
        const TrainingState state = randomState(100, degree, 3, {17, 9}, 11);
        ASSERT_TRUE(state.validate().ok());
        const std::string bytes = fileOf(state);
        EXPECT_EQ(bytes, fileOf(state));
        const auto read = parse(bytes);
        ASSERT_TRUE(read.ok()) << read.error().message;
        expectSame(*read, state, fmt::format("degree {}", degree));
        EXPECT_EQ(linesOf(read->options), linesOf(state.options));
        EXPECT_EQ(read->options.stages.back().firstStep, ~std::uint64_t(0));
        EXPECT_EQ(read->options.loss.dssimWeight, 1.0f / 3.0f);
        EXPECT_EQ(read->options.optimizer.position, 1.0 / 7.0);
        EXPECT_EQ(read->options.keepEveryMs, 1.0 / 3.0);
        EXPECT_EQ(read->options.density.unseenShare, 1.0 / 7.0);
        const auto model = parseModel(bytes);
        ASSERT_TRUE(model.ok());
        EXPECT_TRUE(testing::sameBits(model->splats, state.splats));
    }
}

TEST(TrainingFile, HoldsATrainingThatHasHardlyBegun) {
    TrainingState empty;
    empty.options.stages.clear();
    const auto read = parse(fileOf(empty));
    ASSERT_TRUE(read.ok()) << read.error().message;
    expectSame(*read, empty, "empty");
    EXPECT_TRUE(read->options.stages.empty());
    const auto model = parseModel(fileOf(empty));
    ASSERT_FALSE(model.ok());
    EXPECT_NE(model.error().message.english().find("no splats"), std::string::npos);
    TrainingState bad = randomState(3, 0, 1, {3, 3}, 5);
    bad.optimizer.second.pop_back();
    std::ostringstream stream;
    EXPECT_EQ(writeTraining(stream, bad).error().code, ErrorCode::inputNotUsable);
}

// The model outlives the trainer that made it.
TEST(TrainingFile, NamesBothVersions) {
    const TrainingState state = randomState(5, 0, 1, {5, 4}, 13);
    const std::string other = changed(fileOf(state), "training", [](std::string& text) {
        replace(text, fmt::format("trainer {}\n", kTrainerVersion), "trainer 77\n");
        replace(text, "option optimizer.beta1", "option optimizer.beta9");
    });
    const auto read = parse(other);
    ASSERT_FALSE(read.ok());
    EXPECT_NE(read.error().message.english().find("version 77"), std::string::npos) << read.error().message;
    EXPECT_NE(read.error().message.english().find(fmt::format("version {}", kTrainerVersion)),
              std::string::npos);
    EXPECT_TRUE(parseModel(other).ok());

    std::string later = fileOf(state);
    later[8] = 42;
    for (const Error& error : {parse(later).error(), parseModel(later).error()}) {
        EXPECT_EQ(error.code, ErrorCode::inputNotUsable);
        EXPECT_NE(error.message.english().find("version 42"), std::string::npos) << error.message;
        EXPECT_NE(error.message.english().find(fmt::format("version {}", kTrainingFileVersion)),
                  std::string::npos);
    }
}

// All with whole checksums.
TEST(TrainingFile, WhatDoesNotFitIsRefused) {
    const std::string good = fileOf(randomState(5, 1, 2, {5, 4}, 17));
    const auto refused = [&](std::string_view chunk, const std::function<void(std::string&)>& change) {
        const auto read = parse(changed(good, chunk, change));
        ASSERT_FALSE(read.ok()) << chunk;
        EXPECT_EQ(read.error().code, ErrorCode::inputNotUsable) << chunk;
    };
    const auto put = [](std::size_t offset, auto value) {
        return [=](std::string& bytes) { std::memcpy(&bytes[offset], &value, sizeof(value)); };
    };
    const auto swapped = [](const std::string& from, const std::string& to) {
        return [=](std::string& text) { replace(text, from, to); };
    };
    ASSERT_TRUE(parse(changed(good, "model", [](std::string&) {})).ok());
    refused("model", swapped("splats 5", "splats 6"));
    refused("model", swapped("splats 5", "splats 99999999999"));
    refused("model", swapped("splats 5", "splats -5"));
    refused("model", swapped("splats 5", "splats 5\nsplats 5"));
    refused("model", swapped("splats 5", "splat 5"));
    refused("model", swapped("degree 1", "degree 4"));
    refused("model", swapped("degree 1", "degree 0"));
    refused("model", swapped("macula axes", "macula axis"));
    refused("training", swapped("views 2", "views 3"));
    refused("training", swapped("views 2", "views 4000000000"));
    refused("training", swapped("\nsteps 1", "\nsteps x"));
    refused("training", swapped("capacity 10", "capacity 4"));
    refused("training", swapped("capacity 10", "capacity 4294967296"));
    refused("training", swapped("loss.encode display", "loss.encode other"));
    refused("training", swapped("option seed", "option seeds"));
    refused("training", swapped("option seed", "option seed 1\noption seed"));
    refused("training", swapped("stages 0:3:similar", "stages 0-3:similar"));
    refused("training", swapped("stages 0:3:similar", "stages 0:3"));
    refused("training", swapped("stages 0:3:similar", "stages 0::similar"));
    refused("training", swapped("stages 0:3:similar", "stages 0:3:like"));
    refused("splats", put(0, std::nanf("")));
    refused("splats", [](std::string& bytes) { bytes.resize(bytes.size() - 4); });
    refused("second", put(4, -1.0f));
    refused("first", put(4, std::numeric_limits<float>::infinity()));
    refused("stats", put(4, std::nanf("")));
    refused("steps", [](std::string& bytes) { bytes += "more"; });
    refused("views", put(0, 3.0));                      // no rotation
    refused("views", put(152, std::int32_t{1 << 30}));  // columns
    refused("views", put(152, std::int32_t{-1}));
    refused("views", put(152, std::int32_t{4}));
    refused("views", put(136, std::nan("")));  // loss
    refused("pixels", [](std::string& bytes) { bytes.resize(bytes.size() - 16); });
}

TEST(TrainingFile, RandomDamage) {
    std::mt19937 random(19);
    const std::string bytes = fileOf(randomState(4, 0, 2, {5, 4}, 23));
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        const std::string bad = testing::mutated(bytes, random);
        const auto read = parse(bad);
        const auto model = parseModel(bad);
        EXPECT_EQ(read.ok(), bad == bytes);
        refused += read.ok() ? 0 : 1;
        if (model.ok()) {
            ASSERT_TRUE(model->splats.validate().ok());
        }
    }
    EXPECT_GT(refused, 2900);
    for (std::size_t length = 0; length < bytes.size(); ++length)
        ASSERT_FALSE(parse(bytes.substr(0, length)).ok());
}

// What the checksums do not tell, because they were made afterwards.
TEST(TrainingFile, RandomDamageInside) {
    std::mt19937 random(29);
    const std::string bytes = fileOf(randomState(4, 0, 2, {5, 4}, 31));
    const char* names[] = {"model", "training", "views", "splats", "second", "stats", "pixels", "key"};
    int refused = 0;
    for (int i = 0; i < 1600; ++i) {
        const auto read = parse(changed(
            bytes, names[i % 8], [&](std::string& content) { content = testing::mutated(content, random); }));
        refused += read.ok() ? 0 : 1;
        if (read.ok()) {
            ASSERT_TRUE(read->validate().ok());
        }
    }
    EXPECT_GT(refused, 500);
    EXPECT_LT(refused, 1500);
}

TEST(TrainingFile, IsAModelAsWell) {
    std::string name = (fs::temp_directory_path() / "macula-training-XXXXXX").string();
    const fs::path folder = mkdtemp(name.data());
    const TrainingState state = randomState(20, 1, 1, {5, 4}, 37);
    const fs::path path = folder / "a.macula";
    ASSERT_TRUE(writeTraining(path, state).ok());
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}), 1);
    expectSame(*readTraining(path), state, "file");
    const auto model = readModel(path);
    ASSERT_TRUE(model.ok()) << model.error().message;
    EXPECT_TRUE(testing::sameBits(model->splats, state.splats));
    ASSERT_TRUE(writeModel(folder / "a.ply", model->splats).ok());
    const auto refused = [&](const fs::path& bad) {
        const auto read = readTraining(bad);
        ASSERT_FALSE(read.ok());
        EXPECT_EQ(read.error().code, ErrorCode::inputNotUsable);
        EXPECT_EQ(read.error().where, bad.string());
    };
    refused(folder / "a.ply");
    refused(folder / "none.macula");
    refused(folder);
    fs::resize_file(path, fs::file_size(path) - 1);
    refused(path);
    EXPECT_EQ(readModel(path).error().where, path.string());
    EXPECT_EQ(writeTraining(folder / "none" / "a.macula", state).error().code, ErrorCode::outputNotWritable);
    fs::remove_all(folder);
}

// What the page says of chunks, the table in code, and what is written are the same.
TEST(TrainingFile, ThePageAndTheTableSayWhatIsWritten) {
    std::map<std::string, std::string> onPage = testing::chunksOnThePage("| chunk | stride |");
    const std::string bytes = fileOf(randomState(5, 1, 2, {8, 8}, 3));
    std::istringstream stream(bytes);
    auto file = ChunkFile::open(stream, bytes.size(), kTrainingFileVersion);
    ASSERT_TRUE(file.ok());
    std::set<std::string> written;
    for (const ChunkEntry& entry : file->entries()) {
        const auto row = std::ranges::find(kTrainingChunks, entry.name, &TrainingChunk::name);
        ASSERT_NE(row, kTrainingChunks.end()) << entry.name;
        EXPECT_EQ(entry.stride, row->stride) << entry.name;
        written.insert(entry.name);
    }
    EXPECT_EQ(written.size(), kTrainingChunks.size());
    EXPECT_EQ(onPage.size(), kTrainingChunks.size());
    for (const TrainingChunk& chunk : kTrainingChunks)
        EXPECT_EQ(onPage[std::string(chunk.name)], std::to_string(chunk.stride)) << chunk.name;
}

TEST(ModelFormats, AreThoseOfThePage) {
    std::ifstream page(macula::test::projectFolder() / "docs/model-files.md");
    const std::string text{std::istreambuf_iterator<char>(page), {}};
    for (const ModelFormat& format : kModelFormats) {
        EXPECT_NE(text.find("| `" + std::string(format.extension) + "` |"), std::string::npos);
        EXPECT_EQ(modelFormatOf("A" + std::string(format.extension)), &format);
    }
    EXPECT_EQ(modelFormatOf("a.PLY"), &kModelFormats[0]);
    EXPECT_EQ(modelFormatOf("a.obj"), nullptr);
    EXPECT_EQ(modelExtensions(true), ".ply, .spz, .glb or .macula");
    EXPECT_EQ(modelExtensions(false), ".ply, .spz or .glb");
}

}  // namespace
}  // namespace macula::splat
