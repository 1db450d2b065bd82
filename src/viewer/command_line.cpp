#include "viewer/command_line.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QRegularExpression>
#include <array>
#include <utility>

namespace macula::viewer {

namespace {

constexpr int kLargestEdge = 16384;
constexpr int kSmallestEdge = 160;
constexpr double kLongestScriptSeconds = 3600.0;

constexpr std::array<std::pair<const char*, ViewDirection>, 6> kViews{{
    {"anterior", ViewDirection::anterior},
    {"posterior", ViewDirection::posterior},
    {"left", ViewDirection::left},
    {"right", ViewDirection::right},
    {"superior", ViewDirection::superior},
    {"inferior", ViewDirection::inferior},
}};

Error usage(const QString& message, const char* hint = "Run macula-viewer --help.") {
    return {ErrorCode::usage, message.toStdString(), {}, hint};
}

Result<QSize> parseSize(const QString& text) {
    static const QRegularExpression pattern(QStringLiteral("^(\\d{1,5})x(\\d{1,5})$"));
    const QRegularExpressionMatch match = pattern.match(text);
    const QSize size(match.captured(1).toInt(), match.captured(2).toInt());
    if (!match.hasMatch() || size.width() < kSmallestEdge || size.height() < kSmallestEdge ||
        size.width() > kLargestEdge || size.height() > kLargestEdge) {
        return usage(QStringLiteral("'%1' is not a size.").arg(text), "Write it like 800x600.");
    }
    return size;
}

Result<ViewDirection> parseView(const QString& text) {
    for (const auto& [name, direction] : kViews) {
        if (text == QLatin1String(name)) return direction;
    }
    return usage(QStringLiteral("There is no view '%1'.").arg(text),
                 "The views are anterior, posterior, left, right, superior and inferior.");
}

}  // namespace

Result<CommandLine> parseCommandLine(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Shows a study, path traced. Without FOLDER it opens a built-in phantom.\n"
                       "Not for primary diagnosis."));
    parser.addPositionalArgument(QStringLiteral("FOLDER"), QStringLiteral("A folder with DICOM files."),
                                 QStringLiteral("[FOLDER]"));
    const QCommandLineOption help = parser.addHelpOption();
    const QCommandLineOption version = parser.addVersionOption();
    const QCommandLineOption preset("preset", "What is seen, e.g. ct-bone.", "NAME");
    const QCommandLineOption lights("lights", "Where the light comes from, e.g. studio.", "NAME");
    const QCommandLineOption view("view",
                                  "Looked at from anterior, posterior, left, right, superior or "
                                  "inferior.",
                                  "DIRECTION", "anterior");
    const QCommandLineOption device("device", "Index or part of the name of the Vulkan device.", "NAME");
    const QCommandLineOption size("size", "Of the picture in pixels, e.g. 800x600.", "WxH");
    const QCommandLineOption samples("spp", "Samples per pixel of a converged picture.", "N", "512");
    const QCommandLineOption script("script", "'orbit': drive the window, measure it, print JSON, quit.",
                                    "NAME");
    const QCommandLineOption screenshots("screenshots", "Where the script writes its screenshots.", "FOLDER");
    const QCommandLineOption seconds("seconds", "How long the script orbits, at least.", "S", "8");
    parser.addOptions({preset, lights, view, device, size, samples, script, screenshots, seconds});

    if (!parser.parse(arguments)) return usage(parser.errorText() + QLatin1Char('.'));
    CommandLine result;
    if (parser.isSet(help)) {
        // Before there is a QCoreApplication, Qt does not know the name.
        result.print =
            parser.helpText().replace(QLatin1String("<executable_name>"), QLatin1String("macula-viewer"));
        return result;
    }
    if (parser.isSet(version)) {
        result.print = QStringLiteral("macula-viewer %1\n").arg(QCoreApplication::applicationVersion());
        return result;
    }
    const QStringList folders = parser.positionalArguments();
    if (folders.size() > 1) return usage(QStringLiteral("Only one folder can be opened at a time."));
    if (!folders.isEmpty()) result.folder = folders.front();
    result.preset = parser.value(preset);
    result.lights = parser.value(lights);
    result.device = parser.value(device);
    result.screenshots = parser.value(screenshots);
    MACULA_TRY(result.view, parseView(parser.value(view)));
    if (parser.isSet(size)) {
        MACULA_TRY(result.size, parseSize(parser.value(size)));
    }
    bool isNumber = false;
    result.samples = parser.value(samples).toUInt(&isNumber);
    if (!isNumber || result.samples == 0) {
        return usage(QStringLiteral("'%1' is not a number of samples.").arg(parser.value(samples)));
    }
    result.seconds = parser.value(seconds).toDouble(&isNumber);
    if (!isNumber || !(result.seconds > 0.0 && result.seconds <= kLongestScriptSeconds)) {
        return usage(QStringLiteral("'%1' is not a number of seconds.").arg(parser.value(seconds)));
    }
    result.scriptedOrbit = parser.isSet(script);
    if (result.scriptedOrbit && parser.value(script) != QLatin1String("orbit")) {
        return usage(QStringLiteral("There is no script '%1'.").arg(parser.value(script)),
                     "The only script is 'orbit'.");
    }
    if (!result.screenshots.isEmpty() && !result.scriptedOrbit) {
        return usage(QStringLiteral("--screenshots needs --script orbit."));
    }
    return result;
}

}  // namespace macula::viewer
