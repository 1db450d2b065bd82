#include "pipeline/splat/files/option_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <string_view>

namespace macula::splat {

namespace {

// Calls visit(name, option) for each option. The structured bindings list all members, so that a new member
// does not compile until it is entered here.
template <class Options, class Visit>
void forEachOption(Options& options, const Visit& visit) {
    auto& [capacity, seed, optimizer, loss, density, stages, keepEveryMs, key] = options;
    static_cast<void>(key);
    visit("capacity", capacity);
    visit("seed", seed);
    visit("stages", stages);
    visit("keep-every-ms", keepEveryMs);
    auto& [position, positionAtLast, decayFrom, positionSteps, othersAtLast, logScale, rotation, opacityLogit,
           dc, sh, beta1, beta2, epsilon] = optimizer;
    visit("optimizer.position", position);
    visit("optimizer.position-at-last", positionAtLast);
    visit("optimizer.decay-from", decayFrom);
    visit("optimizer.position-steps", positionSteps);
    visit("optimizer.others-at-last", othersAtLast);
    visit("optimizer.log-scale", logScale);
    visit("optimizer.rotation", rotation);
    visit("optimizer.opacity-logit", opacityLogit);
    visit("optimizer.dc", dc);
    visit("optimizer.sh", sh);
    visit("optimizer.beta1", beta1);
    visit("optimizer.beta2", beta2);
    visit("optimizer.epsilon", epsilon);
    auto& [dssimWeight, encode, exposure] = loss;
    visit("loss.dssim-weight", dssimWeight);
    visit("loss.encode", encode);
    visit("loss.exposure", exposure);
    auto& [firstStep, every, lastStep, unseenShare, splitShare] = density;
    visit("density.first-step", firstStep);
    visit("density.every", every);
    visit("density.last-step", lastStep);
    visit("density.unseen-share", unseenShare);
    visit("density.split-share", splitShare);
}

constexpr std::array<std::string_view, 3> kMeasures{"similar", "absolute", "squared"};  // by LossMeasure

template <class T>
std::string text(const T& number) {
    std::array<char, 40> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    return {digits.data(), end};
}
std::string text(const LossEncoding& encode) {
    return encode == LossEncoding::display ? "display" : "none";
}
std::string text(const std::vector<TrainingStage>& stages) {
    std::string all;
    for (const TrainingStage& stage : stages)
        all += (all.empty() ? "" : " ") + text(stage.firstStep) + ":" + text(stage.halvings) + ":" +
               std::string(kMeasures[static_cast<std::size_t>(stage.measure)]);
    return all;
}

// Parses the whole of `from` as a number.
template <class T>
bool parse(std::string_view from, T& number) {
    const auto [end, error] = std::from_chars(from.data(), from.data() + from.size(), number);
    return error == std::errc() && end == from.data() + from.size();
}
bool parse(std::string_view from, LossEncoding& encode) {
    encode = from == "display" ? LossEncoding::display : LossEncoding::none;
    return from == text(encode);
}
bool parse(std::string_view from, LossMeasure& measure) {
    const auto found = std::find(kMeasures.begin(), kMeasures.end(), from);
    measure = static_cast<LossMeasure>(found - kMeasures.begin());
    return found != kMeasures.end();
}
bool parse(std::string_view from, std::vector<TrainingStage>& stages) {
    stages.clear();
    while (!from.empty()) {
        const std::string_view one = from.substr(0, from.find(' '));
        const std::size_t colon = std::min(one.find(':'), one.size());
        const std::size_t second = std::min(one.find(':', colon + 1), one.size());
        if (second == one.size()) return false;
        TrainingStage& stage = stages.emplace_back();
        if (!parse(one.substr(0, colon), stage.firstStep) ||
            !parse(one.substr(colon + 1, second - colon - 1), stage.halvings) ||
            !parse(one.substr(second + 1), stage.measure))
            return false;
        from.remove_prefix(std::min(one.size() + 1, from.size()));
    }
    return true;
}

}  // namespace

std::vector<std::string> linesOf(const TrainerOptions& options) {
    std::vector<std::string> lines;
    forEachOption(options, [&](std::string_view name, const auto& option) {
        lines.push_back(std::string(name) + " " + text(option));
    });
    return lines;
}

Result<TrainerOptions> optionsOf(const std::vector<std::string>& lines) {
    std::map<std::string_view, std::string_view> values;
    bool good = true;
    for (const std::string_view line : lines) {
        const std::size_t space = std::min(line.find(' '), line.size());
        const std::string_view value = line.substr(std::min(space + 1, line.size()));
        good = values.emplace(line.substr(0, space), value).second && good;
    }
    TrainerOptions options;
    std::size_t found = 0;
    forEachOption(options, [&](std::string_view name, auto& option) {
        const auto value = values.find(name);
        good = value != values.end() && parse(value->second, option) && good;
        ++found;
    });
    if (good && values.size() == found) return options;
    return Error{
        ErrorCode::inputNotUsable,
        Text("What the file says about the settings of its training is not understood."),
        {},
        Text("It is damaged or of another version: go on with the Macula it was begun with, or train "
             "anew.")};
}

}  // namespace macula::splat
