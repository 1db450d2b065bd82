#include "viewer/settings/receive_settings.h"

#include <QJsonArray>
#include <cmath>
#include <utility>

#include "net/dimse/admission.h"

namespace macula::viewer {

namespace {

constexpr int kHighestPort = 65535;
constexpr std::uintmax_t kBytesOfGb = 1'000'000'000;

const QString kAtStart = QStringLiteral("atStart");
const QString kTitle = QStringLiteral("title");
const QString kPort = QStringLiteral("port");
const QString kAddress = QStringLiteral("address");
const QString kCallers = QStringLiteral("callers");
const QString kAnyone = QStringLiteral("anyone");
const QString kCertificate = QStringLiteral("certificate");
const QString kKey = QStringLiteral("key");
const QString kAuthorities = QStringLiteral("authorities");
const QString kLimitGb = QStringLiteral("limitGb");

int wholeNumber(const QJsonValue& value, int least, int most, int otherwise) {
    const double number = value.toDouble(std::nan(""));
    return number >= least && number <= most && number == std::floor(number) ? int(number) : otherwise;
}

}  // namespace

ReceiveSettings receiveSettingsOf(const QJsonObject& object) {
    ReceiveSettings settings;
    settings.atStart = object[kAtStart].toBool(settings.atStart);
    settings.title = object[kTitle].toString(settings.title);
    settings.port = wholeNumber(object[kPort], 1, kHighestPort, settings.port);
    settings.address = object[kAddress].toString(settings.address);
    for (const QJsonValue& caller : object[kCallers].toArray())
        if (caller.isString()) settings.callers.append(caller.toString());
    settings.admitsAnyone = object[kAnyone].toBool(settings.admitsAnyone);
    settings.certificate = object[kCertificate].toString();
    settings.key = object[kKey].toString();
    settings.authorities = object[kAuthorities].toString();
    settings.limitGb = wholeNumber(object[kLimitGb], 0, kMostReceivedGb, settings.limitGb);
    return settings;
}

QJsonObject toJson(const ReceiveSettings& settings) {
    return {{kAtStart, settings.atStart},
            {kTitle, settings.title},
            {kPort, settings.port},
            {kAddress, settings.address},
            {kCallers, QJsonArray::fromStringList(settings.callers)},
            {kAnyone, settings.admitsAnyone},
            {kCertificate, settings.certificate},
            {kKey, settings.key},
            {kAuthorities, settings.authorities},
            {kLimitGb, settings.limitGb}};
}

Result<study::ReceivingOptions> receivingOptions(const ReceiveSettings& settings) {
    study::ReceivingOptions options;
    net::StoreProviderOptions& provider = options.provider;
    provider.ownAe = settings.title.trimmed().toStdString();
    provider.port = static_cast<std::uint16_t>(settings.port);
    provider.address = settings.address.trimmed().toStdString();
    for (const QString& each : settings.callers) {
        MACULA_TRY(net::AdmittedCaller caller, net::admittedCaller(each.trimmed().toStdString()));
        provider.callers.push_back(std::move(caller));
    }
    provider.admitsAnyone = settings.admitsAnyone;
    provider.tls.certificate = settings.certificate.toStdString();
    provider.tls.key = settings.key.toStdString();
    provider.tls.authorities = settings.authorities.toStdString();
    provider.tls.isOn =
        !(settings.certificate.isEmpty() && settings.key.isEmpty() && settings.authorities.isEmpty());
    if (settings.limitGb > 0) provider.mostBytes = static_cast<std::uintmax_t>(settings.limitGb) * kBytesOfGb;
    MACULA_TRY_VOID(net::checkProviderOptions(provider));
    return options;
}

}  // namespace macula::viewer
