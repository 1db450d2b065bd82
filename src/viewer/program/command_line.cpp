#include "viewer/program/command_line.h"

#include <QCommandLineParser>

#include "viewer/program/viewer_options.h"

namespace macula::viewer {

namespace {

constexpr const char* kSessionsVariable = "MACULA_SESSIONS";

}  // namespace

Result<CommandLine> parseCommandLine(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Shows a study, path traced. Without FOLDER it opens a built-in phantom.\n"
                       "Not for primary diagnosis."));
    const ViewerOptions shared("macula-viewer", ViewerOptions::User::person);
    shared.addTo(parser);
    const QCommandLineOption calibrate{
        "calibrate", "Measure this machine anew for the quality slider, say how fast it is, and quit."};
    const QCommandLineOption headset{"xr",
                                     "Show the study in a headset (OpenXR) as well; the window mirrors it."};
    parser.addOptions({calibrate, headset});
    if (!parser.parse(arguments)) {
        const bool asksForScript = parser.unknownOptionNames().contains(QLatin1String("script"));
        return shared.usage(
            parser.errorText(),
            asksForScript
                ? "Call macula-viewer-bench SCRIPT instead. Debian's package macula-benchmarks has it."
                : "");
    }
    if (const auto text = shared.textAskedFor(parser)) {
        CommandLine result;
        result.print = text;
        return result;
    }
    MACULA_TRY(CommandLine result, shared.read(parser, parser.positionalArguments()));
    result.calibrates = parser.isSet(calibrate);
    if (result.calibrates && (result.folder || result.link))
        return shared.usage(QStringLiteral("--calibrate measures the machine, and opens nothing."),
                            "Leave out the folder.");
    result.showsInHeadset = parser.isSet(headset);
    if (result.showsInHeadset && result.calibrates)
        return shared.usage(QStringLiteral("--xr does not go with --calibrate."), "Leave one of them out.");
    return result;
}

CommandLine withSettings(CommandLine line, const Settings& settings) {
    if (!line.language) line.language = settings.language;
    line.highContrast = line.highContrast || settings.highContrast;
    if (!line.choosesFontScale) line.fontScale = settings.fontScale;
    if (!line.keepsStudies) return line;
    const bool isFolderTold = line.sessions || qEnvironmentVariableIsSet(kSessionsVariable);
    if (!isFolderTold && !settings.storeFolder.isEmpty()) line.sessions = settings.storeFolder;
    if (!line.keepDays) line.keepDays = settings.keepDays;
    return line;
}

}  // namespace macula::viewer
