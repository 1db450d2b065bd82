#include "evaluate/store_round_trip.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "evaluate/measurement.h"

namespace macula::evaluate {

namespace {

using Json = nlohmann::ordered_json;

Json toJson(const LearntModel& model) {
    return {{"seconds", model.seconds},
            {"stage", model.stage},
            {"steps", model.steps},
            {"splats", model.splats},
            {"views", model.views},
            {"heldOutViews", model.heldOut},
            {"trainedError", orNull(model.trainedError)},
            {"shownError", orNull(model.shownError)}};
}

Json toJson(const FrameTimes& times) {
    Json histogram = Json::array();
    const auto frames = times.histogram();
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const bool isBounded = i < kFrameBucketsMs.size();
        histogram.push_back(
            {{"atMostMs", isBounded ? Json(kFrameBucketsMs.at(i)) : Json()}, {"frames", frames.at(i)}});
    }
    const bool isEmpty = times.ms.empty();
    return {{"frames", times.ms.size()},
            {"medianMs", isEmpty ? Json() : Json(times.percentileMs(0.5))},
            {"p95Ms", isEmpty ? Json() : Json(times.percentileMs(0.95))},
            {"maxMs", isEmpty ? Json() : Json(times.maxMs())},
            {"histogram", std::move(histogram)}};
}

Json toJson(const SavingTimes& times) {
    const bool areComparable = !times.without.ms.empty() && !times.beside.ms.empty();
    const bool hasCalls = !times.callsMs.empty();
    return {{"framesWithout", toJson(times.without)},
            {"framesBeside", toJson(times.beside)},
            {"framesBetween", times.framesBetween},
            {"slowerMedianMs", areComparable ? Json(times.slowerMs(0.5)) : Json()},
            {"slowerP95Ms", areComparable ? Json(times.slowerMs(0.95)) : Json()},
            {"calls", times.callsMs.size()},
            {"callMedianMs", hasCalls ? Json(median(times.callsMs)) : Json()},
            {"callMaxMs", hasCalls ? Json(*std::ranges::max_element(times.callsMs)) : Json()},
            {"firstSavedMs", times.firstMs},
            {"laterSavedMs", times.laterMs},
            {"firstBlobBytes", times.firstBytes},
            {"laterBlobBytes", times.laterBytes}};
}

Json toJson(const ReadingTimes& times) {
    return {{"openStoreMs", times.openStoreMs}, {"digestMs", times.digestMs},
            {"drawableMs", times.drawableMs},   {"blobMs", times.blobMs},
            {"unpackMs", times.unpackMs},       {"blobBytes", times.blobBytes}};
}

Json toJson(const Reopening& reopening, const LearntModel& before) {
    std::optional<double> difference;
    if (reopening.shownError && before.shownError) difference = *reopening.shownError - *before.shownError;
    return {{"keeperReady", reopening.isKeeperReady},
            {"drawableMs", reopening.drawableMs},
            {"firstPictureMs", reopening.firstPictureMs},
            {"wholeMs", reopening.wholeMs},
            {"learningMs", reopening.learningMs},
            {"steps", reopening.steps},
            {"trainedError", orNull(reopening.trainedError)},
            {"shownError", orNull(reopening.shownError)},
            {"shownErrorDifference", orNull(difference)},
            {"sameToTheBit", reopening.isSame}};
}

Json toJson(const StoreBenchmark& store) {
    return {{"studies", store.studies},
            {"series", store.series},
            {"models", store.models},
            {"modelBytes", store.modelBytes},
            {"makeSeconds", store.makeSeconds},
            {"madeInMemory", store.wasMadeInMemory},
            {"openMs", store.openMs},
            {"firstListingMs", store.firstListingMs},
            {"listingMs", store.listingMs},
            {"findMs", store.findMs},
            {"findAndReadMs", store.findAndReadMs},
            {"evictionMs", store.evictionMs},
            {"evictedModels", store.evictedModels},
            {"capBytes", store.capBytes},
            {"bytesLeft", store.bytesLeft},
            {"fileBytesLeft", store.fileBytesLeft},
            {"capHolds", store.capHolds()}};
}

}  // namespace

Json toJson(const StoreRoundTrip& measured) {
    Json json{{"learnt", toJson(measured.learnt)},
              {"saving", toJson(measured.saving)},
              {"closing", {{"hideMs", measured.closing.hideMs}, {"savedMs", measured.closing.savedMs}}},
              {"reading", toJson(measured.reading)},
              {"reopenings", Json::array()}};
    for (const Reopening& reopening : measured.reopenings)
        json["reopenings"].push_back(toJson(reopening, measured.learnt));
    if (measured.store) json["store"] = toJson(*measured.store);
    return json;
}

Json reportOf(const BenchStudy& study, const StoreRoundTripOptions& options, const StoreRoundTrip& measured) {
    Json json = describe("session", study);
    json["learnSeconds"] = options.learnS;
    json["framesOfBlock"] = options.frames;
    json["blocks"] = options.blocks;
    json.update(toJson(measured));
    return json;
}

}  // namespace macula::evaluate
