// Volumes from stacks that are not all there: gaps, damage, and what can be shown meanwhile.
#include <atomic>
#include <cmath>
#include <fstream>
#include <limits>

#include "dicom/loader.h"
#include "dicom/pixels/slice_sources.h"
#include "dicom/stack/value_unit.h"
#include "edit.h"
#include "support.h"
#include "synthetic.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

bool says(const Volume& volume, std::string_view key) {
    const auto& messages = volume.provenance().messages;
    return std::any_of(messages.begin(), messages.end(), [&](const Message& m) { return m.key == key; });
}

struct Scanned {
    explicit Scanned(const fs::path& folder) : found(scan(folder)) {}
    const Series& series() const { return found->studies.at(0).series.at(0); }
    const Stack& stack() const { return series().stacks.at(0); }
    Result<std::shared_ptr<const Volume>> load(const LoadOptions& options = {}) const {
        Progress progress;
        return loadVolume(series(), stack(), progress, options);
    }
    std::optional<Scan> found;
};

// As many slices as wanted, thin enough that the values fit.
SyntheticSeries seriesOf(int slices) {
    SyntheticSeries series;
    series.size.z = slices;
    return series;
}

constexpr double kRounded = 0.5 + 1e-6;  // as it was written
constexpr double kBlended = 1.0 + 1e-6;  // of two that were rounded, and rounded again

TEST(Loading, UnreadableSliceInsideIsInterpolatedAndSaid) {
    const TemporaryFolder folder;
    const SyntheticSeries series = seriesOf(12);
    const auto files = writeFiles(folder / "DOE^JOHN", series);
    const Scanned scanned(folder.path());
    ASSERT_TRUE(scanned.found);
    fs::remove(files[5]);
    const auto volume = scanned.load();
    ASSERT_TRUE(volume) << volume.error().message;
    const auto& provenance = (*volume)->provenance();
    ASSERT_EQ(provenance.interpolatedSlices.size(), 1u);
    EXPECT_EQ(provenance.interpolatedSlices[0].first, provenance.interpolatedSlices[0].last);
    EXPECT_TRUE(says(**volume, key::kUnreadableFile));
    EXPECT_TRUE(says(**volume, key::kGapInterpolated));
    EXPECT_GE(provenance.assumptions.size(), 2u);
    for (const Message& message : provenance.messages)
        EXPECT_EQ((message.sentence.english() + message.action.english()).find("DOE"), std::string::npos);
    expectGrid(**volume, series.size, series.expectedAffine());
    expectRamp(**volume, series.rampOf(), kBlended);
}

TEST(Loading, UnreadableEndsAreCutOff) {
    const TemporaryFolder folder;
    const SyntheticSeries series = seriesOf(12);
    const auto files = writeFiles(folder.path(), series);
    const Scanned scanned(folder.path());
    ASSERT_TRUE(scanned.found);
    for (const std::size_t k : {0, 1, 11}) std::ofstream(files[k], std::ios::binary) << "no image";
    const auto volume = scanned.load();
    ASSERT_TRUE(volume) << volume.error().message;
    EXPECT_EQ((*volume)->size(), glm::ivec3(series.size.x, series.size.y, 9));
    EXPECT_TRUE((*volume)->provenance().interpolatedSlices.empty());
    EXPECT_TRUE(says(**volume, key::kDamagedFile));
    EXPECT_TRUE(says(**volume, key::kMissingSlices));
    EXPECT_FALSE(says(**volume, key::kGapInterpolated));
    expectRamp(**volume, series.rampOf(), kRounded);
}

TEST(Loading, FailsWhenLessThanHalfIsLeft) {
    const TemporaryFolder folder;
    const auto files = writeFiles(folder / "DOE^JOHN", seriesOf(12));
    const Scanned scanned(folder.path());
    ASSERT_TRUE(scanned.found);
    for (std::size_t k = 1; k < 12; k += 2) fs::remove(files[k]);
    EXPECT_TRUE(scanned.load());
    fs::remove(files[0]);
    const auto volume = scanned.load();
    ASSERT_FALSE(volume);
    EXPECT_EQ(volume.error().code, ErrorCode::inputNotUsable);
    EXPECT_TRUE(volume.error().message.english().starts_with("7 of the 12 images")) << volume.error().message;
    EXPECT_EQ((volume.error().message.english() + volume.error().hint.english()).find("DOE"),
              std::string::npos);
    EXPECT_FALSE(volume.error().where.empty());
}

TEST(Loading, MissingPositionsAreInterpolated) {
    const TemporaryFolder folder;
    SyntheticSeries series = seriesOf(12);
    series.places = {0, 1, 2, 4, 5, 8, 9, 10, 11};
    writeFiles(folder.path(), series);
    const auto volume = loadFolder(folder.path());
    ASSERT_NE(volume, nullptr);
    expectGrid(*volume, series.size, series.expectedAffine());
    expectRamp(*volume, series.rampOf(), kBlended);
    EXPECT_EQ(volume->provenance().interpolatedSlices, (std::vector<SliceRange>{{3, 3}, {6, 7}}));
    EXPECT_TRUE(volume->provenance().messages.empty());  // the stack's own messages say it
}

TEST(Loading, UnevenPositionsAreResampled) {
    const TemporaryFolder folder;
    SyntheticSeries series = seriesOf(12);
    series.places = {0, 1.4, 2.2, 3.7, 4.9, 6.1, 7.6, 8.3, 9.9, 11};
    const auto files = writeFiles(folder.path(), series);
    const Scanned scanned(folder.path());
    ASSERT_TRUE(scanned.found);
    const auto volume = scanned.load();
    ASSERT_TRUE(volume) << volume.error().message;
    expectRamp(**volume, series.rampOf(), kBlended);
    // And one of them broken.
    fs::remove(files[4]);
    const auto without = scanned.load();
    ASSERT_TRUE(without);
    EXPECT_EQ((*without)->size(), (*volume)->size());
    expectRamp(**without, series.rampOf(), kBlended);
    EXPECT_TRUE(says(**without, key::kUnreadableFile));
}

TEST(Loading, FramesBehindTheEndOfAMultiFrameFileAreCutOff) {
    const TemporaryFolder folder;
    const SyntheticSeries series = seriesOf(12);
    const fs::path file = folder / "all";
    writeMultiFrame(file, series, slicesOf(series));
    {
        const auto volume = loadFolder(folder.path());
        ASSERT_NE(volume, nullptr);
        expectGrid(*volume, series.size, series.expectedAffine());
        expectRamp(*volume, series.rampOf(), kRounded);
    }
    const Scanned scanned(folder.path());
    ASSERT_TRUE(scanned.found);
    const auto frameBytes = static_cast<std::size_t>(series.size.x * series.size.y * 2);
    truncate(file, 2 * frameBytes + 10);  // inside of the third from the end
    const auto volume = scanned.load();
    ASSERT_TRUE(volume) << volume.error().message;
    EXPECT_EQ((*volume)->size().z, 9);
    EXPECT_TRUE(says(**volume, key::kTruncatedFile));
    expectRamp(**volume, series.rampOf(), kRounded);
}

TEST(Loading, CoarseVolumeComesOnceAndBeforeTheWhole) {
    const TemporaryFolder folder;
    const SyntheticSeries series = seriesOf(18);
    writeFiles(folder.path(), series);
    const Scanned scanned(folder.path());
    ASSERT_TRUE(scanned.found);
    std::atomic<int> calls{0};
    std::shared_ptr<const Volume> coarse;
    const auto volume = scanned.load({.onCoarse = [&](std::shared_ptr<const Volume> early) {
        ++calls;
        coarse = std::move(early);
    }});
    ASSERT_TRUE(volume);
    EXPECT_EQ(calls, 1);
    ASSERT_NE(coarse, nullptr);
    EXPECT_EQ(coarse->size(), glm::ivec3(series.size.x, series.size.y, 5));
    expectRamp(*coarse, series.rampOf(), kRounded);
    for (int k = 0; k < 5; ++k) EXPECT_EQ(coarse->value(3, 2, k), (*volume)->value(3, 2, 4 * k));
    EXPECT_NEAR(coarse->spacingMm().z, 4.0 * (*volume)->spacingMm().z, 1e-9);
}

TEST(Loading, CoarseVolumeDoesWithoutWhatIsBroken) {
    const TemporaryFolder folder;
    const SyntheticSeries series = seriesOf(21);
    const auto files = writeFiles(folder.path(), series);
    const Scanned scanned(folder.path());
    ASSERT_TRUE(scanned.found);
    for (const std::size_t k : {0, 8, 12}) fs::remove(files[k]);
    std::shared_ptr<const Volume> coarse;
    const auto volume = scanned.load({.onCoarse = [&](auto early) { coarse = std::move(early); }});
    ASSERT_TRUE(volume);
    ASSERT_NE(coarse, nullptr);
    EXPECT_EQ(coarse->size().z, 5);  // 4, 8, 12, 16, 20
    expectRamp(*coarse, series.rampOf(), kBlended);
    EXPECT_EQ(coarse->provenance().interpolatedSlices, (std::vector<SliceRange>{{1, 2}}));
}

TEST(Loading, FewSlicesHaveNoCoarseVolume) {
    const TemporaryFolder folder;
    writeFiles(folder.path(), seriesOf(15));
    const Scanned scanned(folder.path());
    ASSERT_TRUE(scanned.found);
    bool called = false;
    EXPECT_TRUE(scanned.load({.onCoarse = [&](auto) { called = true; }}));
    EXPECT_FALSE(called);
}

TEST(Loading, CancelledBeforeItBegins) {
    const TemporaryFolder folder;
    writeFiles(folder.path(), seriesOf(18));
    const Scanned scanned(folder.path());
    ASSERT_TRUE(scanned.found);
    const CancelToken token;
    token.cancel();
    Progress progress({}, token);
    bool called = false;
    const auto volume =
        loadVolume(scanned.series(), scanned.stack(), progress, {.onCoarse = [&](auto) { called = true; }});
    ASSERT_FALSE(volume);
    EXPECT_EQ(volume.error().code, ErrorCode::cancelled);
    EXPECT_FALSE(called);
}

// Slices in float, of which one is missing.
TEST(Loading, FloatSlicesAreInterpolatedToo) {
    const TemporaryFolder folder;
    SyntheticSeries series = seriesOf(12);
    series.modality = "MR";
    series.places = {0, 1, 2, 3, 4, 6, 7, 8, 9, 10, 11};
    auto slices = slicesOf(series);
    for (std::size_t k = 0; k < slices.size(); ++k) {
        slices[k].slope = std::round(1e6 * 0.1 * std::sqrt(double(k + 3))) / 1e6;
        slices[k].intercept = -1024.0;
    }
    writeFiles(folder.path(), series, slices);
    const auto volume = loadFolder(folder.path());
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->format(), VoxelFormat::float32);
    EXPECT_EQ(volume->provenance().interpolatedSlices, (std::vector<SliceRange>{{5, 5}}));
    expectRamp(*volume, series.rampOf(), 0.5 * 0.4 + 1e-3);
}

TEST(SliceSources, WithoutAnyMissingNothingChanges) {
    const std::vector<SliceSource> slices{{0, 0, 0.0}, {0, 1, 0.5}, {1, 1, 0.0}};
    const UsableSlices same = withoutFrames(slices, std::vector{0.0, 2.0}, {true, true});
    EXPECT_EQ(same.first, 0u);
    EXPECT_EQ(same.slices, slices);
}

TEST(SliceSources, NeighboursFillIn) {
    std::vector<SliceSource> slices;
    std::vector<double> places;
    for (std::size_t k = 0; k < 6; ++k) {
        slices.push_back({k, k, 0.0});
        places.push_back(static_cast<double>(k));
    }
    const UsableSlices usable = withoutFrames(slices, places, {false, true, false, false, true, false});
    EXPECT_EQ(usable.first, 1u);
    ASSERT_EQ(usable.slices.size(), 4u);
    EXPECT_EQ(usable.slices[0], (SliceSource{1, 1, 0.0}));
    EXPECT_EQ(usable.slices[1].below, 1u);
    EXPECT_EQ(usable.slices[1].above, 4u);
    EXPECT_NEAR(usable.slices[1].weight, 1.0 / 3.0, 1e-12);
    EXPECT_NEAR(usable.slices[2].weight, 2.0 / 3.0, 1e-12);
    EXPECT_EQ(usable.slices[3], (SliceSource{4, 4, 0.0}));
    EXPECT_EQ(interpolatedRanges(usable.slices), (std::vector<SliceRange>{{1, 2}}));
    EXPECT_EQ(describe(interpolatedRanges(usable.slices)), "2-3");
    EXPECT_TRUE(withoutFrames(slices, places, std::vector<bool>(6, false)).slices.empty());
}

TEST(SliceSources, PaddingIsNotBlended) {
    const std::vector<std::uint16_t> below{0, 100, 0, 10};
    const std::vector<std::uint16_t> above{200, 0, 0, 21};
    std::vector<std::uint16_t> result(4);
    blend(below, above, 0.25, StoredRange{0, 0}, result);
    EXPECT_EQ(result, (std::vector<std::uint16_t>{0, 100, 0, 13}));
    blend(below, above, 0.75, StoredRange{0, 0}, result);
    EXPECT_EQ(result, (std::vector<std::uint16_t>{200, 0, 0, 18}));
    blend(below, above, 0.25, {}, result);
    EXPECT_EQ(result, (std::vector<std::uint16_t>{50, 75, 0, 13}));
    // Halfway between two values lies what padding is stored as.
    blend(std::vector<std::uint16_t>{10}, std::vector<std::uint16_t>{20}, 0.5, StoredRange{14, 16},
          std::span(result).first(1));
    EXPECT_EQ(result[0], 20);

    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    std::vector<float> values(3);
    blend(std::vector<float>{kNan, 1.0F, 2.0F}, std::vector<float>{5.0F, kNan, 4.0F}, 0.25, values);
    EXPECT_TRUE(std::isnan(values[0]));
    EXPECT_EQ(values[1], 1.0F);
    EXPECT_EQ(values[2], 2.5F);
}

Frame ctFrame(int bits = 12, const char* sopClass = "1.2.840.10008.5.1.4.1.1.2") {
    auto instance = std::make_shared<Instance>();
    instance->sopClassUid = sopClass;
    instance->format = CellFormat{bits > 8 ? 16 : 8, bits, bits - 1, false};
    Frame frame{.instance = std::move(instance)};
    frame.slope = 1.0;
    frame.intercept = -1024.0;
    return frame;
}

// Nothing is guessed: bone in Hounsfield units is where a preset says that it is.
TEST(ValueUnit, OfCtIsHounsfieldOnlyWhereThatIsKnown) {
    const auto unitOf = [](Frame frame) { return valueUnit("CT", std::vector<Frame>(3, frame)).unit; };
    EXPECT_EQ(unitOf(ctFrame()), Unit::hounsfield);
    for (const bool withType : {false, true}) {
        Frame none = ctFrame();
        if (withType) none.rescaleType = "HU";
        none.slope = none.intercept = std::nullopt;
        EXPECT_EQ(unitOf(none), Unit::raw);
        Frame half = ctFrame();
        if (withType) half.rescaleType = "HU";
        half.intercept = std::nullopt;
        EXPECT_EQ(unitOf(half), Unit::raw);
    }
    Frame capture = ctFrame(8);
    EXPECT_EQ(unitOf(capture), Unit::raw);
    capture.rescaleType = "HU";  // that is its word
    EXPECT_EQ(unitOf(capture), Unit::hounsfield);
    EXPECT_EQ(unitOf(ctFrame(16, "1.2.840.10008.5.1.4.1.1.7")), Unit::raw);
    EXPECT_EQ(unitOf(ctFrame(16, "1.2.840.10008.5.1.4.1.1.2.1")), Unit::hounsfield);
    Frame table = ctFrame();
    table.modalityLut = std::make_shared<const ModalityLut>(ModalityLut{0, {1, 2}});
    EXPECT_EQ(unitOf(table), Unit::raw);
    table.rescaleType = "HU";
    EXPECT_EQ(unitOf(table), Unit::hounsfield);
    std::vector<Frame> one(3, ctFrame());
    one[1].intercept = std::nullopt;
    EXPECT_EQ(valueUnit("CT", one).unit, Unit::raw);
}

TEST(ValueUnit, IsWhatTheImagesSay) {
    const auto unitOf = [](std::string_view modality, const std::string& rescaleType,
                           const std::string& units = {}) {
        Frame frame = ctFrame();
        frame.rescaleType = rescaleType;
        frame.units = units;
        return valueUnit(modality, std::vector<Frame>(2, frame));
    };
    EXPECT_EQ(unitOf("CT", "").unit, Unit::hounsfield);
    EXPECT_EQ(unitOf("CT", "HU").unit, Unit::hounsfield);
    EXPECT_EQ(unitOf("CT", "US").unit, Unit::raw);
    EXPECT_EQ(unitOf("CT", "ED").unit, Unit::other);
    EXPECT_EQ(unitOf("CT", "ED").name, "ED");
    EXPECT_EQ(unitOf("MR", "").unit, Unit::raw);
    EXPECT_NE(unitOf("MR", "HU").unit, Unit::hounsfield);
    EXPECT_EQ(unitOf("PT", "", "BQML").unit, Unit::becquerelsPerMillilitre);
    EXPECT_EQ(unitOf("PT", "US", "CNTS").unit, Unit::raw);
    EXPECT_EQ(unitOf("PT", "", "GML").unit, Unit::other);
    std::vector<Frame> different(2, ctFrame());
    different[1].rescaleType = "US";
    EXPECT_EQ(valueUnit("CT", different).unit, Unit::raw);
    // HU by definition and HU by its word are the same.
    different[1].rescaleType = "HU";
    EXPECT_EQ(valueUnit("CT", different).unit, Unit::hounsfield);
}

// What a CT object holds that is called a map is no attenuation, unless its type says so.
TEST(ValueUnit, OfMapsIsNotHounsfieldWithoutAWord) {
    using Type = std::vector<std::string>;
    const auto unitOf = [](const Type& type, const std::string& rescaleType = {}) {
        Frame frame = ctFrame();
        frame.imageType = type;
        frame.rescaleType = rescaleType;
        return valueUnit("CT", std::vector<Frame>(2, frame)).unit;
    };
    for (const Type& map :
         {Type{"DERIVED", "SECONDARY", "AXIAL", "MAT_SPECIFIC"},
          Type{"ORIGINAL", "PRIMARY", "VOLUME", "EFF_ATOMIC_NUM"},
          Type{"ORIGINAL", "PRIMARY", "VOLUME", "ELECTRON_DENSITY"},
          Type{"DERIVED", "SECONDARY", "IODINE NO WATER"}, Type{"DERIVED", "PRIMARY", "AXIAL", "DE_IODINE"},
          Type{"DERIVED", "SECONDARY", "PERFUSION", "CBF"},
          Type{"DERIVED", "SECONDARY", "OTHER", "Z EFFECTIVE"},
          Type{"DERIVED", "SECONDARY", "OTHER", "Rho_Z"},
          Type{"DERIVED", "PRIMARY", "VOLUME", "SUBTRACTION"}}) {
        EXPECT_EQ(unitOf(map), Unit::raw) << map.back();
        EXPECT_EQ(unitOf(map, "HU"), Unit::hounsfield) << map.back();
    }
    for (const Type& image :
         {Type{}, Type{"ORIGINAL", "PRIMARY", "AXIAL"}, Type{"DERIVED", "SECONDARY", "AXIAL", "VMI"},
          Type{"DERIVED", "SECONDARY", "MONOENERGETIC", "IODINE MONO 70"},
          Type{"DERIVED", "SECONDARY", "AXIAL", "MAT_REMOVED"},
          Type{"DERIVED", "SECONDARY", "AXIAL", "IODINE_REMOVED"},
          Type{"DERIVED", "SECONDARY", "AXIAL", "VNC"}, Type{"DERIVED", "SECONDARY", "MPR", "AVERAGE"},
          // What maps are made of.
          Type{"ORIGINAL", "PRIMARY", "AXIAL", "PERFUSION"}})
        EXPECT_EQ(unitOf(image), Unit::hounsfield) << (image.empty() ? "" : image.back());
}

// Any text may stand where a unit should: it is not repeated.
TEST(ValueUnit, IsATermOrAnother) {
    for (const char* modality : {"CT", "MR", "PT", "RTDOSE", ""}) {
        for (const char* text : {"DOE^JOHN", "Bq/ml of John Doe", "hu", "\xE2\x80\xAE"}) {
            for (const bool inUnits : {false, true}) {
                Frame frame = ctFrame();
                (inUnits ? frame.units : frame.rescaleType) = text;
                const ValueUnit unit = valueUnit(modality, std::vector<Frame>(2, frame));
                if (inUnits && modality == std::string_view("CT")) {  // which has no such attribute
                    EXPECT_EQ(unit.unit, Unit::hounsfield) << text;
                    continue;
                }
                EXPECT_EQ(unit.unit, Unit::other) << modality << text;
                EXPECT_EQ(unit.name, "another unit") << modality << text;
            }
        }
        Frame known = ctFrame();
        known.rescaleType = "mm2/s";
        EXPECT_EQ(valueUnit(modality, std::vector<Frame>(2, known)).name, "mm2/s") << modality;
    }
}

}  // namespace
}  // namespace macula::dicom::test
