// Seeds of fuzz_model: a few splats in each format, and trainings of a few pixels.
#include <gtest/gtest.h>

#include <sstream>

#include "fuzz/seeds.h"
#include "pipeline/hybrid/model/peripheral_file.h"
#include "pipeline/splat/files/glb.h"
#include "pipeline/splat/files/gzip.h"
#include "pipeline/splat/files/ply.h"
#include "pipeline/splat/files/spz.h"
#include "pipeline/splat/files/training_file.h"
#include "splat/training_support.h"

namespace macula::fuzz {
namespace {

using splat::Splats;
using splat::testing::randomModel;
using splat::testing::randomState;

std::string textOf(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// A PLY of somebody else: text, other names and kinds of numbers, and what is no splat.
const std::string kForeignPly =
    "ply\nformat ascii 1.0\ncomment made up\nelement face 1\nproperty list uchar int vertex_indices\n"
    "element vertex 2\nproperty double x\nproperty float y\nproperty float z\nproperty uchar red\n"
    "property float f_dc_0\nproperty float f_dc_1\nproperty float f_dc_2\nproperty float opacity\n"
    "property float scale_0\nproperty float scale_1\nproperty float scale_2\nproperty float rot_0\n"
    "property float rot_1\nproperty float rot_2\nproperty float rot_3\nend_header\n3 0 1 2\n"
    "1 2 3 255 0.1 0.2 0.3 0.5 -1 -2 -3 1 0 0 0\n-1 -2 -3 0 0.1 0.2 0.3 -0.5 -1 -1 -1 0.5 0.5 0.5 0.5\n";

// Version 1 to 3 without its gzip, as fuzz_model takes it: the header, and one byte for all numbers.
std::string unpackedSpz(char version, char degree, std::size_t splats) {
    const std::size_t position = version == 1 ? 6 : 9;
    const std::size_t rotation = version < 3 ? 3 : 4;
    const std::size_t higher = 3 * splat::shCount(degree);
    std::string file = "NGSP" + std::string{version, 0, 0, 0} + std::string{char(splats), 0, 0, 0} +
                       std::string{degree, 12, 1, 0};
    return file + std::string(splats * (position + 1 + 3 + 3 + rotation + higher), '\x50');
}

hybrid::PeripheralState smallPeripheral() {
    hybrid::PeripheralState state;
    state.training = randomState(2, 0, 1, {2, 2}, 5);
    const splat::TrainingState other = randomState(1, 0, 1, {3, 2}, 6);
    for (const auto& view : other.views) state.heldOut.push_back(view.given);
    state.shown = std::make_shared<const Splats>(randomModel(3, 0, 7));
    state.best = std::make_shared<const Splats>(randomModel(1, 0, 8));
    state.generation = 3;
    state.seenMm = {glm::dvec3(-4.0, -1.0, -3.0), glm::dvec3(2.0, 1.0, 3.0)};
    state.gain = 0.5;
    state.offered = 7;
    state.asked = 9;
    state.roundViews = 5;
    state.first = state.training.options;
    return state;
}

// The same file with no chunk packed: its numbers are changed one by one.
std::string unpacked(const std::string& file) {
    std::istringstream stream(file);
    auto chunks = splat::ChunkFile::open(stream, file.size(), splat::kTrainingFileVersion);
    EXPECT_TRUE(chunks.ok());
    std::vector<std::vector<std::byte>> plain;
    for (const splat::ChunkEntry& entry : chunks->entries())
        plain.push_back(*splat::ChunkFile::unpacked(entry, *chunks->stored(entry)));
    std::vector<splat::Chunk> written;
    for (std::size_t i = 0; i < plain.size(); ++i) written.push_back({chunks->entries()[i].name, plain[i]});
    std::ostringstream out;
    EXPECT_TRUE(splat::writeChunks(out, splat::kTrainingFileVersion, written).ok());
    return out.str();
}

}  // namespace

void writeModelSeeds(const std::filesystem::path& corpus) {
    const std::filesystem::path folder = corpus / "model";
    for (const int degree : {0, 1, 3}) {
        Splats splats = randomModel(3, degree, 1u + unsigned(degree));
        if (degree == 1) splats.colourSpace = splat::ColourSpace::display;
        const std::string of = "_of_degree_" + std::to_string(degree);
        std::ostringstream ply;
        ASSERT_TRUE(splat::writePly(ply, splats).ok());
        save(folder / ("ply" + of), ply.str());
        std::ostringstream glb;
        ASSERT_TRUE(splat::writeGlb(glb, splats).ok());
        save(folder / ("glb" + of), glb.str());
        const auto spz = splat::encodeSpz(splats);
        ASSERT_TRUE(spz.ok());
        save(folder / ("spz" + of), textOf(spz->bytes));
        save(folder / ("spz_unpacked" + of), unpackedSpz(3, char(degree), 3));
    }
    const auto packed = splat::encodeSpz(randomModel(2, 0, 9), splat::SpzVersion::gzip);
    ASSERT_TRUE(packed.ok());
    save(folder / "spz_gzip", textOf(packed->bytes));
    save(folder / "spz_unpacked_of_version_1", unpackedSpz(1, 0, 2));
    save(folder / "spz_unpacked_of_version_2", unpackedSpz(2, 1, 2));
    save(folder / "ply_ascii", kForeignPly);
    std::ostringstream training;
    ASSERT_TRUE(splat::writeTraining(training, randomState(2, 1, 2, {3, 2}, 4)).ok());
    save(folder / "training", training.str());
    save(folder / "training_unpacked", unpacked(training.str()));
    std::ostringstream peripheral;
    splat::PackedPictures pictures;
    ASSERT_TRUE(hybrid::writePeripheral(peripheral, smallPeripheral(), pictures).ok());
    save(folder / "peripheral", peripheral.str());
    save(folder / "peripheral_unpacked", unpacked(peripheral.str()));
}

}  // namespace macula::fuzz
