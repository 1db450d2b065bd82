// What is kept of studies between runs, as the program sees it: with a real store in a folder of the test.
#include "live/store/study_keeper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>
#include <sstream>

#include "base/fingerprint.h"
#include "base/no_threads.h"
#include "base/phantom.h"
#include "base/sha256.h"
#include "live/store/model_key_of_drawing.h"
#include "live/store/purge_plan.h"
#include "pipeline/hybrid/model/peripheral_file.h"
#include "scene/choice/preset_choice.h"
#include "scene/state/study_state.h"
#include "splat/training_support.h"
#include "study/found_by_hand.h"

namespace macula::live {
namespace {

namespace fs = std::filesystem;
using Answer = hybrid::StoredModel::Answer;
using namespace std::chrono_literals;

class StudyKeeperTest : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "macula-keeper-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::unique_ptr<StudyKeeper> keeper() {
        return std::make_unique<StudyKeeper>(
            session::StoreOptions{.folder = folder_ / "sessions"},
            [this](const Error& error) { told_.push_back(error.message.english()); });
    }
    // Told apart by the steps of training.
    static std::shared_ptr<const hybrid::PeripheralState> model(const std::string& name,
                                                                std::uint64_t steps) {
        auto state = std::make_shared<hybrid::PeripheralState>();
        state->training = splat::testing::randomState(3, 0, 2, {5, 4}, 11);
        state->training.options.key = name;
        state->training.steps = steps;
        state->first = state->training.options;
        state->seenMm = {.low = glm::dvec3(-1.0), .high = glm::dvec3(1.0)};
        state->gain = 1.25;
        EXPECT_TRUE(state->validate().ok());
        return state;
    }
    static hybrid::StoredModel found(StudyKeeper& keeper, const std::string& name) {
        keeper.waitUntilIdle();
        EXPECT_TRUE(keeper.isIdle());
        return keeper.find(name);
    }
    void store(const std::string& name, const scene::Drawing& drawing, std::uint64_t steps) {
        const auto first = keeper();
        first->willShow(name, volume_, drawing);
        first->keep(model(name, steps));
    }
    std::vector<fs::path> blobs() const {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(folder_ / "sessions" / "models"))
            files.push_back(entry);
        return files;
    }

    fs::path folder_;
    std::vector<std::string> told_;
    std::shared_ptr<const Volume> volume_ =
        std::make_shared<const Volume>(phantom::make({.size = {24, 20, 16}}));
    scene::Drawing drawing_{.transferFunction = std::make_shared<const TransferFunction>(
                                scene::choosePreset("cinematic-bone")->function),
                            .lights = std::make_shared<const trace::LightRig>()};
};

TEST_F(StudyKeeperTest, GivesBackInAnotherRunWhatWasKept) {
    store("study 1 scene 0", drawing_, 123);
    const auto second = keeper();
    // Another name and other objects: what they are counts.
    scene::Drawing same = drawing_;
    same.transferFunction = std::make_shared<const TransferFunction>(*drawing_.transferFunction);
    volume_ = std::make_shared<const Volume>(phantom::make({.size = {24, 20, 16}}));
    second->willShow("study 7 scene 3", volume_, same);
    const hybrid::StoredModel stored = found(*second, "study 7 scene 3");
    ASSERT_EQ(stored.answer, Answer::whole);
    EXPECT_EQ(stored.gain, 1.25);
    EXPECT_EQ(stored.state->training.steps, 123u);
    EXPECT_EQ(stored.state->training.options.key, "study 7 scene 3");
    EXPECT_EQ(stored.splats->size(), 3u);
    EXPECT_EQ(second->find("study 7 scene 3").answer, Answer::none) << "who has taken it has it";
    EXPECT_TRUE(told_.empty()) << told_.front();
}

TEST_F(StudyKeeperTest, TheNewestOfManyIsKept) {
    {
        const auto first = keeper();
        first->willShow("a", volume_, drawing_);
        for (std::uint64_t steps = 1; steps <= 40; ++steps) first->keep(model("a", steps));
    }
    EXPECT_EQ(blobs().size(), 1u);
    const auto second = keeper();
    second->willShow("b", volume_, drawing_);
    const hybrid::StoredModel stored = found(*second, "b");
    ASSERT_EQ(stored.answer, Answer::whole);
    EXPECT_EQ(stored.state->training.steps, 40u);
}

// What was learnt is not lost with the thread that should have written it.
TEST_F(StudyKeeperTest, IsKeptWhereThereIsNoOtherThread) {
    {
        const auto first = keeper();
        first->willShow("a", volume_, drawing_);
        first->waitUntilIdle();
        const macula::test::NoThreads none;
        first->keep(model("a", 123));
        first->waitUntilIdle();
    }
    EXPECT_TRUE(told_.empty()) << told_.front();
    const auto second = keeper();
    second->willShow("b", volume_, drawing_);
    EXPECT_EQ(found(*second, "b").steps, 123u);
}

// Each step of a slider is another scene: what a second volume is does not have to be found for each.
TEST_F(StudyKeeperTest, WhatIsShownBesideTheVolumeIsReadOnce) {
    const auto first = keeper();
    Additions added;
    added.second.emplace();
    added.second->volume = std::make_shared<const Volume>(phantom::make({.size = {10, 9, 8}}));
    added.second->function = drawing_.transferFunction;
    auto box = std::make_shared<TintBox>();
    box->volumeSize = volume_->size();
    box->size = glm::ivec3(1);
    box->voxels = {1};
    added.tints = SegmentTints{box, {{.rgb = {1.0f, 0.0f, 0.0f}, .opacity = 1.0f}}};
    for (int step = 0; step < 10; ++step) {
        added.tints->colours.front().opacity = 0.1f * float(step);
        scene::Drawing next = drawing_;
        next.additions = std::make_shared<const Additions>(added);
        first->willShow(std::to_string(step), volume_, next);
        first->waitUntilIdle();
    }
    EXPECT_EQ(first->digests().made(), 3u) << "both volumes and the segments";
    EXPECT_TRUE(told_.empty()) << told_.front();
}

// As of a run that began anew, because the disk was slow.
TEST_F(StudyKeeperTest, AModelThatHasLearntLessReplacesNone) {
    store("a", drawing_, 50);
    store("a", drawing_, 5);
    const auto second = keeper();
    second->willShow("b", volume_, drawing_);
    const hybrid::StoredModel stored = found(*second, "b");
    ASSERT_EQ(stored.answer, Answer::whole);
    EXPECT_EQ(stored.steps, 50u);
    EXPECT_TRUE(told_.empty());
}

TEST_F(StudyKeeperTest, NothingIsFoundForAnotherVolume) {
    store("a", drawing_, 5);
    std::vector<std::uint16_t> voxels(volume_->voxels().begin(), volume_->voxels().end());
    ++voxels[voxels.size() / 2];
    VolumeOptions options{.size = volume_->size(),
                          .worldFromVoxel = volume_->worldFromVoxel(),
                          .unitsFromStored = volume_->unitsFromStored(),
                          .unit = volume_->unit(),
                          .modality = volume_->modality(),
                          .padding = volume_->padding(),
                          .provenance = volume_->provenance()};
    const auto changed = std::make_shared<const Volume>(std::move(Volume::create(options, voxels)).value());
    --voxels[voxels.size() / 2];
    const auto equal = std::make_shared<const Volume>(std::move(Volume::create(options, voxels)).value());
    const auto second = keeper();
    second->willShow("changed", changed, drawing_);
    EXPECT_EQ(found(*second, "changed").answer, Answer::none);
    second->willShow("equal", equal, drawing_);
    EXPECT_EQ(found(*second, "equal").answer, Answer::whole);
}

TEST_F(StudyKeeperTest, OtherLightsBeginWithItAndOtherPresetsDoNot) {
    store("a", drawing_, 5);
    const auto second = keeper();
    scene::Drawing lit = drawing_;
    lit.settings.lightRotationDeg = 90.0;
    second->willShow("lit", volume_, lit);
    const hybrid::StoredModel warm = found(*second, "lit");
    EXPECT_EQ(warm.answer, Answer::warm);
    ASSERT_NE(warm.splats, nullptr);
    EXPECT_EQ(warm.splats->size(), 3u);
    EXPECT_EQ(warm.state, nullptr);
    scene::Drawing other = drawing_;
    other.transferFunction =
        std::make_shared<const TransferFunction>(scene::choosePreset("cinematic-chest")->function);
    second->willShow("other", volume_, other);
    EXPECT_EQ(found(*second, "other").answer, Answer::none);
}

// As of a device that was lost, when what is on the host is older than what was handed over before.
TEST_F(StudyKeeperTest, NorDoesItTakeThePlaceOfOneThatWaitsToBeSaved) {
    {
        const auto first = keeper();
        first->willShow("a", volume_, drawing_);
        for (int i = 0; i < 20; ++i) first->keep(model("a", 50));
        first->keep(model("a", 5));
    }
    const auto second = keeper();
    second->willShow("b", volume_, drawing_);
    EXPECT_EQ(found(*second, "b").steps, 50u);
}

// Its colours are of other pictures than those that are traced now.
TEST_F(StudyKeeperTest, AModelOfAnotherTracerIsBegunWithAndNotGoneOnWith) {
    PartDigests parts;
    session::ModelKey key = modelKeyOf(fingerprint(*volume_), *volume_, drawing_, parts);
    const auto tracer = std::ranges::find(key.parts, "tracer", &session::KeyPart::name);
    ASSERT_NE(tracer, key.parts.end());
    tracer->digest = sha256Hex("an older one");
    std::ostringstream blob;
    splat::PackedPictures packed;
    ASSERT_TRUE(hybrid::writePeripheral(blob, *model(key.digest(), 500), packed).ok());
    const std::string text = std::move(blob).str();
    {
        auto store = session::Store::open({.folder = folder_ / "sessions"});
        ASSERT_TRUE(store.ok());
        ASSERT_TRUE(store->saveModel(key, std::as_bytes(std::span(text))).ok());
    }
    {
        const auto second = keeper();
        second->willShow("a", volume_, drawing_);
        const hybrid::StoredModel stale = found(*second, "a");
        EXPECT_EQ(stale.answer, Answer::stale);
        EXPECT_EQ(stale.state, nullptr);
        ASSERT_NE(stale.splats, nullptr);
        EXPECT_EQ(stale.splats->size(), 3u);
        second->keep(model("a", 5));  // it has learnt less, of the right pictures
    }
    const auto third = keeper();
    third->willShow("b", volume_, drawing_);
    const hybrid::StoredModel whole = found(*third, "b");
    EXPECT_EQ(whole.answer, Answer::whole);
    EXPECT_EQ(whole.steps, 5u);
    EXPECT_TRUE(told_.empty());
}

// Any bit of a stored model that was changed: it is set aside, said so, and the study begins anew.
TEST_F(StudyKeeperTest, ADamagedModelIsNeverGivenBack) {
    store("a", drawing_, 5);
    const auto files = blobs();
    ASSERT_EQ(files.size(), 1u);
    const auto size = fs::file_size(files.front());
    std::string bytes(size, '\0');
    std::ifstream(files.front(), std::ios::binary).read(bytes.data(), std::streamsize(size));
    for (const std::size_t at : {std::size_t(0), std::size_t(size / 3), std::size_t(size - 1)}) {
        std::string other = bytes;
        other[at] = char(other[at] ^ 0x10);
        store("a", drawing_, 7);  // whole again
        ASSERT_EQ(blobs().size(), 1u);
        std::ofstream(blobs().front(), std::ios::binary) << other;
        told_.clear();
        const auto second = keeper();
        second->willShow("b", volume_, drawing_);
        EXPECT_EQ(found(*second, "b").answer, Answer::damaged) << at;
        ASSERT_FALSE(told_.empty()) << at;
        // And it can be kept again.
        second->keep(model("b", 6));
        second->waitUntilIdle();
        second->willShow("b", volume_, drawing_);
        EXPECT_EQ(found(*second, "b").answer, Answer::whole) << at;
    }
}

TEST_F(StudyKeeperTest, WithoutAStoreNothingIsFoundAndItIsSaidOnce) {
    std::ofstream(folder_ / "sessions") << "a file where the folder should be";
    {
        const auto first = keeper();
        first->willShow("a", volume_, drawing_);
        first->keep(model("a", 5));
        first->keepState(volume_, "{}");
        EXPECT_EQ(first->stateOf(volume_, 5s), std::nullopt);
        EXPECT_EQ(found(*first, "a").answer, Answer::none);
    }
    EXPECT_EQ(told_.size(), 1u);
}

TEST_F(StudyKeeperTest, WithoutAStoreNothingIsHeldOnTo) {
    std::ofstream(folder_ / "sessions") << "a file where the folder should be";
    const auto only = keeper();
    const auto state = model("a", 5);
    only->willShow("a", volume_, drawing_);
    only->keep(state);
    only->waitUntilIdle();
    EXPECT_EQ(state.use_count(), 1);
    EXPECT_EQ(volume_.use_count(), 1);
    only->willShow("b", volume_, drawing_);
    only->keep(model("b", 5));
    EXPECT_EQ(volume_.use_count(), 1);
}

// A hand drags a curve, and then another study is opened.
TEST_F(StudyKeeperTest, NoVolumeIsHeldOnToThatIsNotOpen) {
    const auto only = keeper();
    for (int i = 0; i < 20; ++i) {
        scene::Drawing drawing = drawing_;
        drawing.settings.lightRotationDeg = i;
        only->willShow("a" + std::to_string(i), volume_, drawing);
    }
    only->willShow("other", std::make_shared<const Volume>(phantom::make({.size = {24, 20, 17}})), drawing_);
    only->waitUntilIdle();
    EXPECT_EQ(volume_.use_count(), 1);
}

TEST_F(StudyKeeperTest, WhatWasFoundIsForgottenOnceAnotherSceneIsShown) {
    store("a", drawing_, 5);
    const auto second = keeper();
    second->willShow("a", volume_, drawing_);
    second->waitUntilIdle();
    scene::Drawing lit = drawing_;
    lit.settings.lightRotationDeg = 90.0;
    second->willShow("lit", volume_, lit);
    EXPECT_EQ(found(*second, "a").answer, Answer::none);
    second->willShow("a", volume_, drawing_);
    EXPECT_EQ(found(*second, "a").answer, Answer::whole);
}

// The last of one study is handed over in the moment in which the next one is shown.
TEST_F(StudyKeeperTest, WhatIsHandedOverIsKeptThoughAnotherStudyIsShown) {
    const auto other = std::make_shared<const Volume>(phantom::make({.size = {24, 20, 17}}));
    {
        const auto first = keeper();
        first->willShow("a", volume_, drawing_);
        first->willShow("b", volume_, drawing_);
        first->keep(model("a", 5));
        first->willShow("other", other, drawing_);
    }
    const auto second = keeper();
    second->willShow("again", volume_, drawing_);
    EXPECT_EQ(found(*second, "again").answer, Answer::whole);
}

TEST_F(StudyKeeperTest, WhatIsOpenedIsRecordedThoughNothingOfItIsKept) {
    EXPECT_EQ(keeper()->stateOf(volume_, 60s), std::nullopt);
    auto store = session::Store::open({.folder = folder_ / "sessions"});
    ASSERT_TRUE(store.ok());
    const auto audit = store->listAudit(10);
    ASSERT_TRUE(audit.ok());
    ASSERT_EQ(audit->entries.size(), 1u);
    EXPECT_EQ(audit->entries.front().action, session::nameOf(session::AuditAction::opened));
}

TEST_F(StudyKeeperTest, WhatWasNotOpenedForLongGoesWhereSomebodySaidHowLong) {
    constexpr std::int64_t kDayMs = 86'400'000;
    std::int64_t nowMs = 1'700'000'000'000;
    const session::StoreOptions options{.folder = folder_ / "sessions", .nowMs = [&nowMs] { return nowMs; }};
    const auto studies = [&] {
        auto store = session::Store::open(options);
        std::vector<std::string> found;
        const auto listed = store->listStudies();
        for (const session::StudyEntry& study : listed->entries) found.push_back(study.identity);
        return found;
    };
    const auto openedNow = [&](const char* uid) {
        auto store = session::Store::open(options);
        EXPECT_TRUE(store
                        ->recordOpened({.study = session::studyIdentity(uid),
                                        .series = session::seriesIdentity(uid, "1"),
                                        .volume = sha256Hex(uid)})
                        .ok());
    };
    openedNow("old");
    nowMs += 25 * kDayMs;
    openedNow("young");
    nowMs += 10 * kDayMs;
    { const StudyKeeper keeper(options, {}); }
    EXPECT_EQ(studies().size(), 2u) << "nobody said how long";
    const KeeperListener listener = [this](const Error& error) { told_.push_back(error.message.english()); };
    { const StudyKeeper keeper(options, listener, std::chrono::days(35)); }
    EXPECT_EQ(studies().size(), 2u) << "not yet";
    { const StudyKeeper keeper(options, listener, std::chrono::days(30)); }
    EXPECT_EQ(studies(), std::vector{session::studyIdentity("young")});
    EXPECT_TRUE(told_.empty()) << told_.front();
    auto store = session::Store::open(options);
    const auto audit = store->listAudit(1);
    ASSERT_EQ(audit->entries.size(), 1u);
    EXPECT_EQ(audit->entries.front().action, session::nameOf(session::AuditAction::expired));
    EXPECT_EQ(audit->entries.front().subject, session::studyIdentity("old"));
}

TEST_F(StudyKeeperTest, AClockThatJumpedDeletesNothingAndIsTold) {
    constexpr std::int64_t kDayMs = 86'400'000;
    std::int64_t nowMs = 1'700'000'000'000;
    const session::StoreOptions options{.folder = folder_ / "sessions", .nowMs = [&nowMs] { return nowMs; }};
    ASSERT_TRUE(session::Store::open(options)->recordOpened({.volume = sha256Hex("a file")}).ok());
    nowMs += 5000 * kDayMs;
    const KeeperListener listener = [this](const Error& error) { told_.push_back(error.message.english()); };
    { const StudyKeeper keeper(options, listener, std::chrono::days(30)); }
    ASSERT_EQ(told_.size(), 1u);
    EXPECT_EQ(told_.front(), keptForClock(session::ClockDoubt::ahead).message);
    nowMs -= 5010 * kDayMs;
    { const StudyKeeper keeper(options, listener, std::chrono::days(30)); }
    ASSERT_EQ(told_.size(), 2u);
    EXPECT_EQ(told_.back(), keptForClock(session::ClockDoubt::behind).message);
    nowMs += 11 * kDayMs;
    { const StudyKeeper keeper(options, listener, std::chrono::days(30)); }
    EXPECT_EQ(told_.size(), 2u) << "it is right again";
    const auto report = session::Store::open(options)->purgeVolume(sha256Hex("a file"), {});
    ASSERT_TRUE(report.ok());
    EXPECT_EQ(report->volumes, 1u) << "it was there to the end";
}

TEST_F(StudyKeeperTest, TheStateOfAStudyComesBackForItsVolumeAlone) {
    {
        const auto first = keeper();
        EXPECT_EQ(first->stateOf(volume_, 5s), std::nullopt);
        first->keepState(volume_, R"({"version":1,"look":"mip","leavesTableOut":true,"later":1})");
        first->keepState(volume_, R"({"version":1,"look":"dvr"})");
    }
    const auto second = keeper();
    const auto other = std::make_shared<const Volume>(phantom::make({.size = {24, 20, 17}}));
    EXPECT_EQ(second->stateOf(other, 5s), std::nullopt);
    const auto left = second->stateOf(volume_, 5s);
    ASSERT_TRUE(left);
    EXPECT_NE(left->find("dvr"), std::string::npos);
    EXPECT_EQ(left->find("leavesTableOut"), std::string::npos) << "what was taken back does not come back";
    EXPECT_NE(left->find("later"), std::string::npos) << "what a newer version wrote stays";
    EXPECT_TRUE(told_.empty());
}

// Each keeper is a window of its own: neither knows of the other.
TEST_F(StudyKeeperTest, OfTwoWindowsOnOneStudyNothingThatWasMeasuredIsLost) {
    const auto measured = [](double lengthMm) {
        return slices::Measurement{
            .label = {},
            .shape = slices::Distance{.endsMm = {glm::dvec3(0.0), glm::dvec3(lengthMm, 0.0, 0.0)}}};
    };
    scene::StudyState state;
    const std::string opened = toJson(state);
    const auto baseOfFirst = std::make_shared<std::string>(opened);
    const auto baseOfSecond = std::make_shared<std::string>(opened);
    const auto first = keeper();
    const auto second = keeper();
    EXPECT_EQ(first->stateOf(volume_, 60s), std::nullopt);
    EXPECT_EQ(second->stateOf(volume_, 60s), std::nullopt);
    state.measurements = {measured(10.0)};
    first->keepState(volume_, toJson(state), baseOfFirst);
    EXPECT_TRUE(first->waitUntilStatesAreKept(60s));
    EXPECT_TRUE(told_.empty());
    state.measurements = {measured(20.0)};
    second->keepState(volume_, toJson(state), baseOfSecond);
    EXPECT_TRUE(second->waitUntilStatesAreKept(60s));
    ASSERT_EQ(told_.size(), 1u) << "this window does not show the other measurement";
    EXPECT_NE(told_.front().find("another window"), std::string::npos);
    // The one goes on without having seen the other, and takes its own back.
    first->keepState(volume_, opened, baseOfFirst);
    const auto kept = first->stateOf(volume_, 60s);
    ASSERT_TRUE(kept);
    const auto read = scene::studyStateFromJson(*kept, {});
    ASSERT_TRUE(read) << *kept;
    EXPECT_EQ(read->measurements, std::vector{measured(20.0)});
}

// Else what is in the window and not in the store would look as if another window had removed it.
TEST_F(StudyKeeperTest, WhatCouldNotBeKeptIsKeptWithTheNextState) {
    const auto base = std::make_shared<std::string>(toJson(scene::StudyState{}));
    const std::string opened = *base;
    const auto only = keeper();
    only->keepState(volume_, "no JSON", base);
    EXPECT_TRUE(only->waitUntilStatesAreKept(60s));
    EXPECT_EQ(told_.size(), 1u);
    EXPECT_EQ(*base, opened);
    const std::string next = toJson(scene::StudyState{.layout = scene::Layout::axial});
    only->keepState(volume_, next, base);
    EXPECT_TRUE(only->waitUntilStatesAreKept(60s));
    EXPECT_EQ(*base, next);
}

// Of a newer version, say: it stays, under another name, and spoils nothing of what is kept instead.
TEST_F(StudyKeeperTest, AStateThatCannotBeReadIsSetAsideBeforeAnotherIsKept) {
    const std::string newer = R"({"version":2,"camera":{"lens":"a new one"}})";
    const std::string broken = R"({"version":1,"camera":{"positionMm":[1e7,0,0]}})";
    {
        const auto first = keeper();
        for (const std::string& unreadable : {newer, broken}) {
            first->keepState(volume_, unreadable);
            first->keepState(volume_, R"({"version":1,"look":"dvr"})");
        }
        const auto left = first->stateOf(volume_, 60s);
        ASSERT_TRUE(left);
        const auto read = scene::studyStateFromJson(*left, {});
        ASSERT_TRUE(read) << *left;
        EXPECT_EQ(read->settings.look, trace::Look::dvr);
    }
    EXPECT_TRUE(told_.empty());
    auto store = session::Store::open({.folder = folder_ / "sessions"});
    ASSERT_TRUE(store);
    std::set<std::string> stays;
    const auto studies = store->listStudies();
    ASSERT_TRUE(studies);
    for (const session::StudyEntry& study : studies->entries) {
        const auto listed = store->listDocuments(session::DocumentKind::studyState, study.identity);
        ASSERT_TRUE(listed);
        for (const session::DocumentEntry& entry : listed->entries) {
            const auto document = store->getDocument(entry.id);
            ASSERT_TRUE(document && *document);
            stays.insert(nlohmann::json::parse((*document)->json).dump());
        }
    }
    EXPECT_EQ(stays.size(), 3u);
    EXPECT_TRUE(stays.contains(nlohmann::json::parse(newer).dump()));
    EXPECT_TRUE(stays.contains(nlohmann::json::parse(broken).dump()));
}

TEST_F(StudyKeeperTest, KnowsWhatOfAFolderWasSeenBefore) {
    dicom::Scan scan;
    const auto series = [](const std::string& uid, std::size_t volumes) {
        dicom::Series made = study::test::seriesOf(1, "Thorax", {});
        for (std::size_t n = 0; n < volumes; ++n) made.stacks.push_back(study::test::volumeOf(2));
        made.studyInstanceUid = uid.empty() ? "" : "1.2.3";
        made.seriesInstanceUid = uid;
        return made;
    };
    scan.studies.push_back(study::test::studyOf(
        0, "DOE^JANE", "20200102", "Chest",
        {series("1.2.3.1", 1), series("1.2.3.2", 1), series("1.2.3.3", 2), series("", 1)}));
    const auto folder = std::make_shared<const study::FoundVolumes>(std::move(scan));
    const auto open = [this](const char* uid, const char* digest) {
        auto store = session::Store::open({.folder = folder_ / "sessions"});
        ASSERT_TRUE(store);
        ASSERT_TRUE(store->recordOpened({.study = session::studyIdentity("1.2.3"),
                                         .series = session::seriesIdentity("1.2.3", uid),
                                         .volume = sha256Hex(digest)}));
    };
    const auto seen = [&] {
        std::optional<std::set<std::size_t>> told;
        const auto asked = keeper();
        asked->askWhatWasSeen(folder, [&](const std::set<std::size_t>& s) { told = s; });
        asked->waitUntilIdle();
        return told;
    };
    using Seen = std::optional<std::set<std::size_t>>;
    EXPECT_EQ(seen(), Seen(std::set<std::size_t>{}));
    open("1.2.3.2", "a");
    open("1.2.3.3", "b");  // one of its two volumes: nobody knows which
    EXPECT_EQ(seen(), Seen(std::set<std::size_t>{1}));
    open("1.2.3.3", "c");
    EXPECT_EQ(seen(), Seen(std::set<std::size_t>({1, 2, 3})));
}

}  // namespace
}  // namespace macula::live
