#include "viewer/quality/converge_now.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace macula::viewer {

namespace {

double secondsOfClock() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Noise falls with the square root of the number of samples.
double fractionOf(const live::FrameShown& frame) {
    const double byNoise = frame.noise > 0.0 ? std::pow(ConvergeNow::kNoiseTarget / frame.noise, 2.0) : 0.0;
    const double bySamples = double(frame.samplesPerPixel) / double(ConvergeNow::kSampleLimit);
    return std::clamp(std::max(byNoise, bySamples), 0.0, 1.0);
}

QString percentText(double share) {
    return ConvergeNow::tr("%L1 %").arg(100.0 * share, 0, 'f', 2);
}

}  // namespace

ConvergeNow::ConvergeNow(const RestGoal& usual, QObject* parent, std::function<double()> nowS)
    : QObject(parent), usual_(usual), nowS_(nowS ? std::move(nowS) : secondsOfClock) {}

void ConvergeNow::start() {
    if (std::exchange(isRunning_, true)) return;
    startedS_ = nowS_();
    startedAt_ = -1.0;
    Q_EMIT began();
    Q_EMIT goalChanged({.sampleLimit = std::max(kSampleLimit, usual_.sampleLimit),
                        .noiseTarget = kNoiseTarget,
                        .convergesNow = true});
}

void ConvergeNow::cancel() {
    if (isRunning_) end({});
}

void ConvergeNow::onOtherPicture() {
    if (isRunning_) end(tr("Converging was stopped: another picture is shown."));
}

void ConvergeNow::end(const QString& told) {
    isRunning_ = false;
    Q_EMIT goalChanged(usual_);
    Q_EMIT ended(told);
}

void ConvergeNow::onFrame(const live::FrameShown& frame) {
    // Frames of the earlier goal still arrive for a while.
    if (!isRunning_ || frame.noiseTarget != kNoiseTarget) return;
    if (frame.picture != live::OnScreen::traced && frame.picture != live::OnScreen::fading) return;
    if (frame.stage == live::Stage::converged) {
        const bool isKnown = std::isfinite(frame.noise) && frame.noise > 0.0;
        return end(isKnown ? tr("The picture is final: %Ln samples, noise %1 of black to white.", nullptr,
                                int(frame.samplesPerPixel))
                                 .arg(percentText(frame.noise))
                           : tr("The picture is final: %Ln samples.", nullptr, int(frame.samplesPerPixel)));
    }
    const double fraction = fractionOf(frame);
    if (startedAt_ < 0.0 && std::isfinite(frame.noise)) {
        startedAt_ = fraction;
        startedS_ = nowS_();
    }
    Q_EMIT progressed(stageOf(frame.noise, fraction), fraction);
}

QString ConvergeNow::stageOf(double noise, double fraction) const {
    QString stage = tr("Converging");
    if (std::isfinite(noise)) stage += tr(", noise %1").arg(percentText(noise));
    if (startedAt_ < 0.0 || !(fraction > startedAt_)) return stage;
    const double leftS = (nowS_() - startedS_) * (1.0 - fraction) / (fraction - startedAt_);
    if (leftS < 90.0) return stage + tr(", %1 s left").arg(std::ceil(leftS), 0, 'f', 0);
    if (leftS < 6000.0) return stage + tr(", %1 min left").arg(std::ceil(leftS / 60.0), 0, 'f', 0);
    return stage + tr(", %1 h left").arg(std::ceil(leftS / 3600.0), 0, 'f', 0);
}

}  // namespace macula::viewer
