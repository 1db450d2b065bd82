#include "live/model/training_record.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "live/model/model_output.h"

namespace macula::live {

nlohmann::ordered_json toJson(const TrainingRecord& record, const Trained& trained) {
    nlohmann::ordered_json json{{"version", MACULA_VERSION},
                                {"device", trained.device},
                                {"study", record.seriesDigest},
                                {"preset", record.preset},
                                {"lights", record.lights},
                                {"clip", record.clip},
                                {"tableRemoved", record.tableRemoved}};
    if (const auto& m = record.begun)
        json.update({{"points", m->points.count},
                     {"views", m->views},
                     {"viewsTraced", trained.viewsTraced},
                     {"directions", m->directions},
                     {"viewsGivenUp", trained.viewsGivenUp},
                     {"samplesPerPixel", m->samplesPerPixel},
                     {"size", m->sizePx},
                     {"bounces", m->bounces}});
    if (record.begun) {
        const hybrid::ViewTimes& times = trained.viewTimes;
        json["viewSeconds"] = {{"poses", times.poses},       {"paths", times.paths},
                               {"reading", times.reading},   {"lightTable", times.lightTable},
                               {"lighting", times.lighting}, {"waiting", times.waiting},
                               {"beside", times.beside},     {"toTrainer", times.toTrainer}};
    }
    if (record.budgetSeconds > 0.0) json["budgetSeconds"] = record.budgetSeconds;
    json.update({{"iterationsBefore", record.stepsBefore},
                 {"iterations", trained.report.steps},
                 {"plannedIterations", plannedSteps(trained.state)},
                 {"interrupted", trained.interrupted},
                 {"splats", trained.report.splats},
                 {"loss", trained.report.loss},
                 {"meanDifference", trained.report.l1},
                 {"seconds",
                  {{"points", trained.pointsSeconds},
                   {"views", trained.viewsSeconds},
                   {"training", trained.trainSeconds}}}});
    return json;
}

std::string howTimeWasSpent(const Trained& trained, std::size_t views) {
    return fmt::format("Points took {:.1f} s, views {:.1f} s ({} of {} traced), training {:.1f} s.",
                       trained.pointsSeconds, trained.viewsSeconds, trained.viewsTraced, views,
                       trained.trainSeconds);
}

std::string whatIsWritten(const Trained& trained, std::uint64_t steps, const std::filesystem::path& path) {
    std::string sentence = fmt::format("Stopped after {} of {} steps; the model is written as it is then.",
                                       trained.report.steps - trained.firstStep, steps);
    if (holdsTraining(path)) sentence += " --resume goes on with it.";
    return sentence;
}

}  // namespace macula::live
