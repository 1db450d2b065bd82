// Segmentations of a folder: which are of the volume, what is loaded of them, and what is left in 3D.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "formats/volume_file.h"
#include "pictures/addition_request.h"
#include "pipeline/volume/mask_bits.h"
#include "scene/clip/combined_mask.h"
#include "scene/segments/segment_mask.h"
#include "scene/segments/segment_tints.h"
#include "scene/segments/segmentation_settings.h"
#include "scene/segments/segments_to_draw.h"
#include "scene/state/study_state.h"
#include "study/open/opened_study.h"
#include "study/segmentation/found_segmentation.h"
#include "study/segmentation/loaded_segmentation.h"
#include "support.h"
#include "synthetic_segmentation.h"

namespace macula::scene {
namespace {

using dicom::test::SyntheticSegmentation;
using dicom::test::SyntheticSeries;

std::string digestOf(char c) {
    return std::string(64, c);
}

// Two balls that overlap, in a series of 21 x 19 x 17 voxels, oblique.
class SegmentationOfAFolder : public testing::Test {
  protected:
    void SetUp() override {
        series_.size = {21, 19, 17};
        dicom::test::writeFiles(folder_ / "ct", series_);
        segmentation_.size = series_.size;
        segmentation_.worldFromVoxel = series_.worldFromVoxel;
        centreMm_ = transformPoint(series_.worldFromVoxel, {10, 9, 8});
        segmentation_.parts = {{.number = 1, .label = "Liver", .share = ball(centreMm_, 6.45)},
                               {.number = 2, .label = "Tumour", .share = ball(centreMm_, 3.0)}};
    }
    static std::function<double(const glm::dvec3&)> ball(const glm::dvec3& centreMm, double radiusMm) {
        return [=](const glm::dvec3& mm) { return glm::distance(mm, centreMm) <= radiusMm ? 1.0 : 0.0; };
    }
    // Writes it, and opens the folder.
    void open() {
        dicom::test::writeSegmentation(folder_ / "seg/a", segmentation_);
        Progress progress;
        auto study = study::openStudy(folder_.path(), progress);
        ASSERT_TRUE(study) << study.error().message;
        study_ = *std::move(study);
    }
    std::vector<study::FoundSegmentation> find() {
        Progress progress;
        const auto found = study::findSegmentations(*study_.found, volume(), progress);
        EXPECT_TRUE(found) << found.error().message;
        return found ? *found : std::vector<study::FoundSegmentation>();
    }
    std::shared_ptr<const study::LoadedSegmentation> load(const study::FoundSegmentation& found) {
        Progress progress;
        const auto loaded = study::loadSegments(found, *study_.volume, *volume().stack, progress);
        EXPECT_TRUE(loaded) << loaded.error().message;
        return loaded ? *loaded : nullptr;
    }
    const study::FoundVolume& volume() const { return study_.found->volumes().at(study_.volumeIndex); }
    template <class Visit>
    void forEachVoxel(const Visit& visit) const {
        const glm::ivec3 size = study_.volume->size();
        for (int k = 0; k < size.z; ++k)
            for (int j = 0; j < size.y; ++j)
                for (int i = 0; i < size.x; ++i)
                    visit(glm::ivec3(i, j, k), transformPoint(study_.volume->worldFromVoxel(), {i, j, k}));
    }

    dicom::test::TemporaryFolder folder_;
    SyntheticSeries series_;
    SyntheticSegmentation segmentation_;
    glm::dvec3 centreMm_{0.0};
    study::OpenedStudy study_;
};

TEST_F(SegmentationOfAFolder, IsFoundAndLiesWhereItWasDrawn) {
    segmentation_.parts[0].cieLab = {43803, 26565, 37722};
    open();
    const auto found = find();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found[0].canBeShown()) << found[0].whyNot;
    EXPECT_TRUE(found[0].note.empty());
    EXPECT_EQ(found[0].digest.size(), 64u);
    EXPECT_NE(found[0].title.find("ORGANS"), std::string::npos);
    ASSERT_EQ(found[0].header.segments.size(), 2u);
    const auto loaded = load(found[0]);
    ASSERT_TRUE(loaded);
    EXPECT_TRUE(loaded->notes.empty()) << loaded->notes.front();
    const study::LoadedSegment* liver = loaded->segment(1);
    const study::LoadedSegment* tumour = loaded->segment(2);
    ASSERT_TRUE(liver && tumour && liver->volumeMl && tumour->centroidMm);
    EXPECT_EQ(loaded->segment(3), nullptr);
    std::size_t count = 0;
    forEachVoxel([&](const glm::ivec3& voxel, const glm::dvec3& mm) {
        ASSERT_EQ(liver->voxels->contains(voxel), glm::distance(mm, centreMm_) <= 6.45);
        ASSERT_EQ(tumour->voxels->contains(voxel), glm::distance(mm, centreMm_) <= 3.0);
        count += liver->voxels->contains(voxel) ? 1 : 0;
    });
    const double det = std::abs(glm::determinant(glm::dmat3(study_.volume->worldFromVoxel())));
    EXPECT_NEAR(*liver->volumeMl, double(count) * det / 1000.0, 1e-6);
    EXPECT_NEAR(*liver->volumeMl, 4.0 / 3.0 * 3.14159265 * 268.336 / 1000.0, 0.1) << "a ball of 6.45 mm";
    EXPECT_LT(glm::distance(*tumour->centroidMm, centreMm_), 0.4);
    EXPECT_EQ(study::usualRgb(liver->segment), *liver->segment.recommendedRgb);
    EXPECT_NE(study::usualRgb(tumour->segment), study::usualRgb(liver->segment));
}

TEST_F(SegmentationOfAFolder, OfAnotherCoordinateSystemSaysSo) {
    segmentation_.frameOfReferenceUid = "2.25.77";
    open();
    const auto found = find();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NE(found[0].whyNot.english().find("frame of reference"), std::string::npos);
}

TEST_F(SegmentationOfAFolder, OfAnotherPatientIsNeverShown) {
    segmentation_.patientId = "SOMEBODY ELSE";
    open();
    const auto found = find();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NE(found[0].whyNot.english().find("another patient"), std::string::npos);
}

TEST_F(SegmentationOfAFolder, WithoutAFrameOfReferenceTheSeriesThatItNamesCounts) {
    segmentation_.frameOfReferenceUid.clear();
    open();
    EXPECT_TRUE(find().at(0).canBeShown());
    segmentation_.referencedSeriesUid = "2.25.88";
    open();
    EXPECT_FALSE(find().at(0).canBeShown());
}

TEST_F(SegmentationOfAFolder, DrawnOnOtherVoxelsItIsResampledAndSaysSo) {
    segmentation_.referencedSeriesUid = "2.25.88";
    segmentation_.worldFromVoxel[3] += 0.4 * segmentation_.worldFromVoxel[0];
    open();
    const auto found = find();
    ASSERT_TRUE(found.at(0).canBeShown());
    EXPECT_FALSE(found[0].note.empty());
    const auto loaded = load(found[0]);
    ASSERT_TRUE(loaded);
    ASSERT_EQ(loaded->notes.size(), 2u);
    EXPECT_NE(loaded->notes[1].english().find("nearest"), std::string::npos);
    EXPECT_TRUE(loaded->isResampled);
    EXPECT_FALSE(loaded->hasFractions);
    EXPECT_TRUE(loaded->segment(1)->isInVolume());
}

TEST_F(SegmentationOfAFolder, FractionsAreToldOf) {
    segmentation_.type = "FRACTIONAL";
    open();
    const auto loaded = load(find().at(0));
    ASSERT_TRUE(loaded);
    ASSERT_EQ(loaded->notes.size(), 1u);
    EXPECT_NE(loaded->notes[0].english().find("half"), std::string::npos);
    EXPECT_TRUE(loaded->hasFractions);
    EXPECT_FALSE(loaded->isResampled);
}

TEST_F(SegmentationOfAFolder, AloneAndHiddenLeaveWhatTheySay) {
    open();
    const auto found = find();
    const auto loaded = load(found.at(0));
    ASSERT_TRUE(loaded);
    const auto maskOf = [&](In3d liver, In3d tumour, bool isShown = true) {
        SegmentationSettings choice;
        choice.digest = found[0].digest;
        choice.isShown = isShown;
        SegmentSettings one;
        one.in3d = liver;
        SegmentSettings two;
        two.number = 2;
        two.in3d = tumour;
        choice.segments = {one, two};
        Progress progress;
        const auto mask = segmentMask(std::vector{choice}, {loaded}, *study_.volume, progress);
        EXPECT_TRUE(mask);
        return *mask;
    };
    const auto expectShown = [&](const std::optional<Mask>& mask, auto isShown) {
        ASSERT_TRUE(mask);
        const MaskBits bits = maskBits(*mask, *study_.volume);
        forEachVoxel([&](const glm::ivec3& v, const glm::dvec3& mm) {
            const double far = glm::distance(mm, centreMm_);
            ASSERT_EQ(bits.shows(v.x, v.y, v.z), isShown(far)) << far;
        });
    };
    expectShown(maskOf(In3d::alone, In3d::asIs), [](double mm) { return mm <= 6.45; });
    expectShown(maskOf(In3d::asIs, In3d::hidden), [](double mm) { return mm > 3.0; });
    expectShown(maskOf(In3d::alone, In3d::hidden), [](double mm) { return mm <= 6.45 && mm > 3.0; });
    expectShown(maskOf(In3d::alone, In3d::alone), [](double mm) { return mm <= 6.45; });
    EXPECT_EQ(maskOf(In3d::alone, In3d::hidden)->remark, "one segment alone, a segment left out");
    EXPECT_FALSE(maskOf(In3d::asIs, In3d::asIs));
    EXPECT_FALSE(maskOf(In3d::alone, In3d::hidden, false)) << "it is not shown";
    EXPECT_TRUE(validate([&] {
                    Clip clip;
                    clip.mask = maskOf(In3d::alone, In3d::asIs);
                    return clip;
                }())
                    .ok());

    // With another mask, a voxel is shown where both show it.
    std::vector<std::uint16_t> labels;
    forEachVoxel([&](const glm::ivec3& v, const glm::dvec3&) { labels.push_back(v.x < 10 ? 1 : 0); });
    auto map = LabelMap::create(study_.volume->size(), study_.volume->worldFromVoxel(), {}, labels);
    ASSERT_TRUE(map);
    Mask half;
    half.labels = std::make_shared<const LabelMap>(*std::move(map));
    half.remark = Text("half left out");
    Progress progress;
    const auto both =
        combinedMask(std::vector{half, *maskOf(In3d::alone, In3d::asIs)}, *study_.volume, progress);
    ASSERT_TRUE(both && *both);
    EXPECT_EQ((*both)->remark, "half left out, one segment alone");
    const MaskBits bits = maskBits(**both, *study_.volume);
    forEachVoxel([&](const glm::ivec3& v, const glm::dvec3& mm) {
        ASSERT_EQ(bits.shows(v.x, v.y, v.z), v.x < 10 && glm::distance(mm, centreMm_) <= 6.45);
    });
    const auto none = combinedMask({}, *study_.volume, progress);
    EXPECT_TRUE(none && !*none);
}

TEST_F(SegmentationOfAFolder, InColourTheirVoxelsHaveTheColoursThatWereChosen) {
    open();
    const auto found = find();
    const auto loaded = load(found.at(0));
    ASSERT_TRUE(loaded);
    SegmentationSettings choice;
    choice.digest = found[0].digest;
    choice.isShown = true;
    SegmentSettings liver;
    liver.isColouredIn3d = true;
    liver.rgb = {255, 0, 51};
    SegmentSettings tumour;
    tumour.number = 2;
    tumour.isColouredIn3d = true;
    tumour.opacityIn3d = 0.5;
    choice.segments = {liver, tumour};
    Progress progress;
    const auto made = segmentTints(std::vector{choice}, {loaded}, *study_.volume, progress);
    ASSERT_TRUE(made && *made) << made.error().message;
    const SegmentTints& tints = **made;
    ASSERT_EQ(tints.colours.size(), 2u);
    EXPECT_EQ(tints.colours[0].rgb, glm::vec3(1.0f, 0.0f, 0.2f));
    EXPECT_EQ(tints.colours[1].opacity, 0.5f);
    Additions added;
    added.tints = tints;
    EXPECT_TRUE(validate(added, *study_.volume).ok());
    const TintBox& box = *tints.box;
    forEachVoxel([&](const glm::ivec3& v, const glm::dvec3& mm) {
        const glm::ivec3 at = v - box.low;
        const bool isInBox =
            glm::all(glm::greaterThanEqual(at, glm::ivec3(0))) && glm::all(glm::lessThan(at, box.size));
        const int colour =
            isInBox ? box.voxels[std::size_t((at.z * box.size.y + at.y) * box.size.x + at.x)] : 0;
        const double far = glm::distance(mm, centreMm_);
        ASSERT_EQ(colour, far <= 3.0 ? 2 : far <= 6.45 ? 1 : 0) << "the later one counts " << far;
    });

    choice.isShown = false;
    const auto none = segmentTints(std::vector{choice}, {loaded}, *study_.volume, progress);
    EXPECT_TRUE(none && !*none) << "it is not shown";
    choice.isShown = true;
    const auto notLoaded = segmentTints(std::vector{choice}, {}, *study_.volume, progress);
    EXPECT_TRUE(notLoaded && !*notLoaded);
    EXPECT_TRUE(colouredIn3dOf(onSlicesAlone(std::vector{choice})).empty());

    // Back to the colours of before, when those that were asked for cannot be had.
    const std::vector<ColouredIn3d> before{{choice.digest, 2, std::nullopt, 0.25}};
    const auto back = withColoursIn3d(std::vector{choice}, before);
    EXPECT_EQ(colouredIn3dOf(back), before);
    EXPECT_FALSE(choiceOf(choiceOf(back, choice.digest), 1).isColouredIn3d);
    EXPECT_TRUE(colouredIn3dOf(withColoursIn3d(std::vector{choice}, {})).empty());
    SegmentationSettings hidden = choice;
    hidden.isShown = false;
    EXPECT_EQ(colouredIn3dOf(withColoursIn3d(std::vector{hidden}, before)), before)
        << "colours that it had while hidden do not come back";

    // By its label, for who has no window.
    const SegmentRequest request = *segmentRequestFrom("colour:tumour");
    const auto drawn =
        segmentsToDraw({study_.found.get(), &volume()}, {}, std::vector{request}, *study_.volume, progress);
    ASSERT_TRUE(drawn) << drawn.error().message;
    EXPECT_FALSE(drawn->mask) << "nothing is hidden";
    ASSERT_TRUE(drawn->tints);
    EXPECT_EQ(drawn->tints->colours.size(), 1u);
    EXPECT_TRUE(drawn->notes.empty());
}

// Of a picture with segments in colour is said what is seen in it, and of one that has no colours that.
TEST_F(SegmentationOfAFolder, InColourAPictureSaysSoButAProjection) {
    open();
    study::ReadStudy study;
    study.input.volume = in16Bits(study_.volume);
    study.found = study_.found;
    StudyState state;
    pictures::AdditionRequest request;
    request.segments = {"colour:tumour"};
    const auto choice = pictures::resolveAdditions(request, folder_.path(), state);
    ASSERT_TRUE(choice) << choice.error().message;
    const auto noteIn = [&](trace::Look look) {
        Clip clip;
        Progress progress;
        const auto made = pictures::makeAdditions(*choice, study, look, clip, progress);
        EXPECT_TRUE(made && made->additions.tints && made->notes.size() == 1);
        return made && made->notes.size() == 1 ? made->notes.front().english() : std::string();
    };
    EXPECT_EQ(noteIn(trace::Look::cinematic),
              "Segments are coloured: in them colours are no values of the preset.");
    EXPECT_EQ(noteIn(trace::Look::mip),
              "Segments have no colours in this look: they have in all but projections.");
}

// For who has no window: beside the segmentations of the folder, and where there is no folder.
TEST_F(SegmentationOfAFolder, LabelMapsOfFilesAreDrawnToo) {
    open();
    std::vector<std::uint16_t> labels;
    forEachVoxel([&](const glm::ivec3&, const glm::dvec3& mm) {
        labels.push_back(glm::distance(mm, centreMm_) <= 4.0 ? 9 : 0);
    });
    const auto map =
        LabelMap::create(study_.volume->size(), study_.volume->worldFromVoxel(), {}, std::move(labels));
    ASSERT_TRUE(map);
    Progress progress;
    const std::filesystem::path file = folder_ / "labels.nrrd";
    ASSERT_TRUE(formats::writeVolumeFile(*map, file, progress));
    study::ReadStudy study;
    study.input.volume = in16Bits(study_.volume);
    StudyState state;
    pictures::AdditionRequest request{.segments = {"keep:Label 9"}, .labelMaps = {file}};
    for (const auto& found : {study_.found, std::shared_ptr<const study::FoundVolumes>()}) {
        study.found = found;
        const auto choice = pictures::resolveAdditions(request, folder_ / "a.nii", state);
        ASSERT_TRUE(choice) << choice.error().message;
        Clip clip;
        const auto made = pictures::makeAdditions(*choice, study, trace::Look::cinematic, clip, progress);
        ASSERT_TRUE(made) << made.error().message;
        ASSERT_TRUE(clip.mask);
        const MaskBits bits = maskBits(*clip.mask, *study_.volume);
        forEachVoxel([&](const glm::ivec3& v, const glm::dvec3& mm) {
            ASSERT_EQ(bits.shows(v.x, v.y, v.z), glm::distance(mm, centreMm_) <= 4.0);
        });
    }
    EXPECT_EQ(pictures::filesOf(request).back(), file) << "no output may replace it";
    request.segments.clear();
    EXPECT_EQ(pictures::resolveAdditions(request, folder_ / "a.nii", state).error().code, ErrorCode::usage);
}

TEST_F(SegmentationOfAFolder, IsKeptOrHiddenByItsLabel) {
    open();
    Progress progress;
    const auto draw = [&](const std::vector<std::string>& typed,
                          std::vector<SegmentationSettings> choices = {}) {
        std::vector<SegmentRequest> requests;
        for (const std::string& each : typed) requests.push_back(*segmentRequestFrom(each));
        return segmentsToDraw({study_.found.get(), &volume()}, std::move(choices), requests, *study_.volume,
                              progress);
    };
    const auto both = draw({"keep:liver", "hide:Tumour"});
    ASSERT_TRUE(both) << both.error().message;
    ASSERT_TRUE(both->mask);
    const MaskBits bits = maskBits(*both->mask, *study_.volume);
    forEachVoxel([&](const glm::ivec3& v, const glm::dvec3& mm) {
        const double far = glm::distance(mm, centreMm_);
        ASSERT_EQ(bits.shows(v.x, v.y, v.z), far <= 6.45 && far > 3.0);
    });
    EXPECT_TRUE(both->notes.empty());
    const auto none = draw({"keep:Spleen"});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::usage);
    SegmentSettings one;
    one.in3d = In3d::hidden;
    std::vector<SegmentationSettings> ofAView;
    choose(ofAView, digestOf('e'), one);
    ofAView.front().isShown = true;
    const auto gone = draw({}, ofAView);
    ASSERT_TRUE(gone);
    EXPECT_FALSE(gone->mask);
    EXPECT_FALSE(gone->notes.empty()) << "it is not in the folder";
    for (const char* wrong : {"", "keep", "keep:", ":Liver", "drop:Liver", "Liver"})
        EXPECT_FALSE(segmentRequestFrom(wrong)) << wrong;
    EXPECT_EQ(segmentRequestFrom("hide:Lobe: upper")->label, "Lobe: upper");
}

TEST_F(SegmentationOfAFolder, ATruncatedFileIsAnErrorAndNoSegment) {
    open();
    const auto file = folder_ / "seg/a";
    std::filesystem::resize_file(file, std::filesystem::file_size(file) - 40);
    const auto found = find();
    ASSERT_EQ(found.size(), 1u);
    if (!found[0].canBeShown()) return;  // noticed by its header already
    Progress progress;
    const auto loaded = study::loadSegments(found[0], *study_.volume, *volume().stack, progress);
    ASSERT_FALSE(loaded);
    EXPECT_FALSE(loaded.error().hint.empty());
}

TEST(SegmentationState, IsReadBackAndKeepsNothingThatIsAsByDefault) {
    StudyState state;
    SegmentSettings segment;
    segment.number = 300;
    segment.isVisible = false;
    segment.rgb = {1, 2, 255};
    segment.opacity = 0.25;
    segment.in3d = In3d::hidden;
    segment.isColouredIn3d = true;
    segment.opacityIn3d = 0.75;
    choose(state.segmentations, digestOf('b'), segment);
    SegmentationSettings shown;
    shown.digest = digestOf('a');
    shown.isShown = true;
    choose(state.segmentations, shown);
    ASSERT_EQ(state.segmentations.size(), 2u);
    EXPECT_EQ(state.segmentations[0].digest, digestOf('a')) << "in one order, whoever came first";
    const auto read = studyStateFromJson(toJson(state), {});
    ASSERT_TRUE(read) << read.error().message << read.error().hint;
    EXPECT_EQ(*read, state);
    EXPECT_TRUE(in3dOf(state.segmentations).empty()) << "that one is not shown";

    SegmentationSettings other = choiceOf(state.segmentations, digestOf('b'));
    other.isShown = true;
    StudyState next = state;
    choose(next.segmentations, other);
    EXPECT_EQ(in3dOf(next.segmentations),
              (std::vector<In3dOf>{{digestOf('b'), std::uint16_t{300}, In3d::hidden}}));
    EXPECT_EQ(staleAfter(state, next), Stale::matter);
    EXPECT_TRUE(in3dOf(onSlicesAlone(next.segmentations)).empty());
    StudyState onSlices = state;
    segment.opacity = 0.9;
    choose(onSlices.segmentations, digestOf('b'), segment);
    EXPECT_EQ(staleAfter(state, onSlices), Stale::nothing);

    SegmentSettings usual;
    usual.number = 300;
    choose(state.segmentations, digestOf('b'), usual);
    shown.isShown = false;
    choose(state.segmentations, shown);
    EXPECT_TRUE(state.segmentations.empty());
    EXPECT_EQ(state, StudyState{});
}

TEST(SegmentationState, WhatIsDoneIn3dIsPutBackAndSlicesStay) {
    std::vector<SegmentationSettings> choices;
    const auto add = [&](const char* digest, bool isShown, std::uint16_t number, In3d in3d) {
        SegmentationSettings choice = choiceOf(choices, digest);
        choice.isShown = isShown;
        choose(choices, choice);
        SegmentSettings segment;
        segment.number = number;
        segment.opacity = 0.9;
        segment.in3d = in3d;
        choose(choices, digest, segment);
    };
    add("a", true, 1, In3d::alone);
    add("a", true, 2, In3d::asIs);
    add("b", false, 1, In3d::hidden);
    add("c", true, 1, In3d::hidden);
    EXPECT_EQ(withIn3d(choices, in3dOf(choices)), choices);
    const std::vector<In3dOf> before{{"a", 2, In3d::hidden}, {"d", 4, In3d::alone}};
    const std::vector<SegmentationSettings> back = withIn3d(choices, before);
    EXPECT_EQ(in3dOf(back), before);
    EXPECT_EQ(choiceOf(choiceOf(back, "a"), 1).opacity, 0.9);
    EXPECT_TRUE(choiceOf(back, "c").isShown);
    EXPECT_EQ(choiceOf(choiceOf(back, "b"), 1).in3d, In3d::hidden) << "for when it is shown";
}

TEST(SegmentationState, WhatCannotBeReadIsAnErrorWithItsPlace) {
    const std::string good = digestOf('a');
    const auto read = [](const std::string& segmentations) {
        return studyStateFromJson("{\"version\": 1, \"segmentations\": " + segmentations + "}", "view");
    };
    EXPECT_TRUE(read("[]"));
    EXPECT_TRUE(read("[{\"object\": \"" + good + "\", \"segments\": [{\"number\": 1}]}]"));
    for (const std::string& wrong :
         {std::string("{}"), std::string("[{}]"), std::string("[{\"object\": \"abc\"}]"),
          "[{\"object\": \"" + good + "\", \"names\": 1}]",
          "[{\"object\": \"" + good + "\", \"segments\": [{\"number\": -1}]}]",
          "[{\"object\": \"" + good + "\", \"segments\": [{\"number\": 1.5}]}]",
          "[{\"object\": \"" + good + "\", \"segments\": [{\"number\": 70000}]}]",
          "[{\"object\": \"" + good + "\", \"segments\": [{\"number\": 1, \"opacity\": 2}]}]",
          "[{\"object\": \"" + good + "\", \"segments\": [{\"number\": 1, \"rgb\": [1, 2]}]}]",
          "[{\"object\": \"" + good + "\", \"segments\": [{\"number\": 1, \"rgb\": [1, 2, 256]}]}]",
          "[{\"object\": \"" + good + "\", \"segments\": [{\"number\": 1, \"in3d\": \"gone\"}]}]"}) {
        const auto state = read(wrong);
        ASSERT_FALSE(state) << wrong;
        EXPECT_EQ(state.error().code, ErrorCode::inputNotUsable);
    }
    // Nothing that is written is refused.
    StudyState state;
    SegmentSettings odd;
    odd.opacity = std::numeric_limits<double>::quiet_NaN();
    choose(state.segmentations, good, odd);
    choose(state.segmentations, "no digest", odd);
    EXPECT_TRUE(studyStateFromJson(toJson(state), {}));
}

TEST(RealSegmentation, LiesOnItsSeries) {
    SKIP_WITHOUT_SHARED_DATA();
    Progress progress;
    const auto study = study::openStudy(dicom::test::sharedData() / "odd/legacy_enhanced_pair", progress);
    ASSERT_TRUE(study) << study.error().message;
    const study::FoundVolume& volume = study->found->volumes().at(study->volumeIndex);
    const auto found = study::findSegmentations(*study->found, volume, progress);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), 1u);
    ASSERT_TRUE(found->front().canBeShown()) << found->front().whyNot;
    const auto loaded = study::loadSegments(found->front(), *study->volume, *volume.stack, progress);
    ASSERT_TRUE(loaded) << loaded.error().message;
    const study::LoadedSegment* liver = (*loaded)->segment(1);
    ASSERT_TRUE(liver && liver->isInVolume() && liver->volumeMl);
    EXPECT_EQ(liver->segment.label, "Liver");
    EXPECT_NEAR(*liver->volumeMl, double(liver->voxels->count()) * 0.7 * 0.7 * 2.5 / 1000.0, 1e-4);
}

}  // namespace
}  // namespace macula::scene
