// Any bytes as a DICOM file: header, frames, pixels and volume are read without a crash and in little memory.
#include <algorithm>
#include <vector>

#include "dicom/best_volume.h"
#include "dicom/loader.h"
#include "dicom/manifest/imaging_manifest.h"
#include "dicom/pixels/pixels.h"
#include "dicom/planar/planar_frame.h"
#include "dicom/presentation/presentation_state.h"
#include "dicom/presentation/softcopy_state.h"
#include "dicom/read/media_directory.h"
#include "dicom/scan.h"
#include "dicom/segmentation/segmentation.h"
#include "dicom/segmentation/structure_set.h"
#include "dicom/stack/examination.h"
#include "fuzz/file_of_bytes.h"

namespace macula::dicom {
namespace {

// Larger images are the same code, only slower.
constexpr std::size_t kMostCells = std::size_t{1} << 20;

std::size_t cellsOf(int columns, int rows) {
    if (columns < 1 || rows < 1) return 0;
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
}

void readPixels(const Examination& found) {
    const Instance& instance = *found.frames.front().instance;
    const std::size_t cells = cellsOf(instance.columns, instance.rows);
    if (!instance.format || cells > kMostCells) return;
    auto reader = PixelReader::open(instance.file, {.transferSyntaxUid = instance.transferSyntaxUid,
                                                    .columns = instance.columns,
                                                    .rows = instance.rows,
                                                    .frames = instance.frames,
                                                    .format = *instance.format});
    if (!reader) return;
    constexpr int kMostFrames = 3;
    std::vector<double> numbers(cells);
    std::vector<std::uint16_t> narrow(cells);
    for (int i = std::min(instance.frames, kMostFrames) - 1; i >= 0; --i) {
        if (reader->isCutOff(i)) MACULA_CHECK(!reader->readNumbers(i, numbers));
        (void)reader->readNumbers(i, numbers);
        if (isNarrow(*instance.format)) (void)reader->read(i, narrow);
    }
}

void loadBest(const Scan& scan) {
    const ChosenStack best = bestVolume(scan);
    if (!best) return;
    const Stack& stack = *best.stack;
    const std::size_t cells = cellsOf(stack.columns, stack.rows);
    if (cells > kMostCells || stack.slices.size() > kMostCells / std::max<std::size_t>(cells, 1)) return;
    Progress progress;
    const auto volume = loadVolume(*best.series, stack, progress);
    if (!volume) return;
    const glm::ivec3 size{stack.columns, stack.rows, static_cast<int>(stack.slices.size())};
    MACULA_CHECK((*volume)->size() == size);
    MACULA_CHECK(isInvertibleAffine((*volume)->worldFromVoxel()));
}

void loadLabels(const std::filesystem::path& file) {
    (void)readPresentationState(file);
    (void)readSoftcopyState(file);
    const auto segmentation = readSegmentation(file);
    if (!segmentation || cellsOf(segmentation->columns, segmentation->rows) > kMostCells) return;
    Progress progress;
    (void)loadSegmentation(*segmentation, progress);
    if (segmentation->frames.empty()) return;
    const ImagePlane& plane = segmentation->frames.front().plane;
    const glm::dmat4 grid =
        affine(plane.columnSpacingMm * plane.rowDirection, plane.rowSpacingMm * plane.columnDirection,
               plane.normal(), plane.positionMm);
    (void)loadSegmentation(*segmentation, grid, {8, 8, 8}, progress);
}

// As the window shows what is no volume.
void showImages(const Examination& found) {
    const Instance& instance = *found.frames.front().instance;
    if (cellsOf(instance.columns, instance.rows) > kMostCells) return;
    Stack stack;
    stack.frames = found.frames;
    for (const std::size_t place : {std::size_t{0}, stack.frames.size() - 1}) {
        const auto header = readPlanarHeader(instance.file, stack.frames[place].number);
        if (!header) continue;
        const auto pixels = loadPlanarFrame(stack, place, *header);
        if (!pixels) continue;
        const std::size_t cells = cellsOf(pixels->columns, pixels->rows);
        MACULA_CHECK(pixels->values.size() == cells || pixels->rgb.size() == 3 * cells);
    }
}

void fillStructures(const std::filesystem::path& file) {
    const auto structures = readStructureSet(file);
    if (!structures) return;
    const glm::dmat4 grid = affine({2, 0, 0}, {0, 2, 0}, {0, 0, 3}, {-16, -16, -12});
    macula::Progress progress;
    (void)voxelsOf(*structures, grid, {16, 16, 8}, progress);
}

}  // namespace
}  // namespace macula::dicom

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace macula::dicom;
    const std::filesystem::path file = macula::fuzz::fileOf(data, size, "image");
    const Examination found = examine(file);
    if (!found.frames.empty()) {
        readPixels(found);
        showImages(found);
    }
    loadLabels(file);
    fillStructures(file);
    (void)readMediaDirectory(file);
    (void)readImagingManifest(file);
    macula::Progress progress;
    if (const auto scan = scanFolder(file, progress)) loadBest(*scan);
    return 0;
}
