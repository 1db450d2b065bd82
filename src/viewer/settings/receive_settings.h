// How the window receives studies that others send.
#pragma once

#include <QJsonObject>
#include <QString>
#include <QStringList>

#include "base/result.h"
#include "study/archive/receiving.h"

namespace macula::viewer {

inline constexpr int kMostReceivedGb = 100'000;

struct ReceiveSettings {
    bool atStart = false;  // whether the window receives from its start on, without being asked
    QString title = QStringLiteral("MACULA");  // our AE title
    int port = 11112;
    QString address = QStringLiteral("127.0.0.1");  // to listen at; empty: all addresses of this machine
    QStringList callers = {};                       // see net::admittedCaller
    bool admitsAnyone = false;
    QString certificate = {};  // PEM files of TLS; all empty: nothing is encrypted
    QString key = {};
    QString authorities = {};
    int limitGb = 0;  // to take in all while the window is open; 0: no limit

    bool operator==(const ReceiveSettings&) const = default;
};

// An invalid value counts as missing.
ReceiveSettings receiveSettingsOf(const QJsonObject& object);
QJsonObject toJson(const ReceiveSettings& settings);

// Fails with usage where they cannot work. Reads no file.
Result<study::ReceivingOptions> receivingOptions(const ReceiveSettings& settings);

}  // namespace macula::viewer
