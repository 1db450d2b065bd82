#include "viewer/driven/script_line.h"

#include <QCommandLineParser>
#include <optional>
#include <utility>

#include "viewer/program/viewer_options.h"

namespace macula::viewer {

namespace {

constexpr double kShortestSeconds = 1e-3;
constexpr double kLongestSeconds = 3600.0;
constexpr const char* kScriptNames =
    "The scripts are 'orbit', 'changes', 'session', 'opening' and 'stations'.";

using Script = ScriptLine::Script;

std::optional<Script> scriptOf(const QString& text) {
    constexpr std::pair<const char*, Script> kScripts[] = {{"orbit", Script::orbit},
                                                           {"changes", Script::changes},
                                                           {"session", Script::session},
                                                           {"opening", Script::opening},
                                                           {"stations", Script::stations}};
    for (const auto& [name, script] : kScripts) {
        if (text == QLatin1String(name)) return script;
    }
    return std::nullopt;
}

// What a script has besides the options of the window.
struct ScriptOptions {
    const QCommandLineOption screenshots{"screenshots", "Where 'orbit' or 'stations' writes its screenshots.",
                                         "FOLDER"};
    const QCommandLineOption until{"until", "The last station of 'stations', e.g. open.", "NAME"};
    const QCommandLineOption withPatient{
        "with-patient", "Screenshots name patient and study; without this, nothing in the window does."};
    const QCommandLineOption wait{
        "wait", "How long the model learns before 'orbit' begins, or a station converges.", "S", "0"};
    const QCommandLineOption seconds{"seconds", "How long the script orbits, at least, or makes changes.",
                                     "S", "8"};
    const QCommandLineOption turn{"turn", "In how long it orbits once around the patient.", "S", "8"};
    const QCommandLineOption rest{"rest", "How long it rests afterwards, unless the picture converges.", "S",
                                  "300"};

    void addTo(QCommandLineParser& parser) const {
        parser.addOptions({screenshots, until, withPatient, wait, seconds, turn, rest});
    }
};

Result<double> readSeconds(const ViewerOptions& shared, const QString& text, double least) {
    bool isNumber = false;
    const double seconds = text.toDouble(&isNumber);
    if (!isNumber || !(seconds >= least && seconds <= kLongestSeconds))
        return shared.usage(QStringLiteral("'%1' is not a number of seconds.").arg(text));
    return seconds;
}

Result<void> readScript(const QCommandLineParser& parser, const ViewerOptions& shared,
                        const ScriptOptions& options, ScriptLine& result) {
    const auto seconds = [&](const QCommandLineOption& option, double least) {
        return readSeconds(shared, parser.value(option), least);
    };
    MACULA_TRY(result.waitSeconds, seconds(options.wait, 0.0));
    MACULA_TRY(result.turnSeconds, seconds(options.turn, kShortestSeconds));
    MACULA_TRY(result.seconds, seconds(options.seconds, kShortestSeconds));
    MACULA_TRY(result.restSeconds, seconds(options.rest, kShortestSeconds));
    result.screenshots = parser.value(options.screenshots);
    if (!result.screenshots.isEmpty() && result.script != Script::orbit && result.script != Script::stations)
        return shared.usage(QStringLiteral("--screenshots needs the script orbit or stations."));
    if (result.screenshots.isEmpty() && result.script == Script::stations)
        return shared.usage(QStringLiteral("The script stations needs --screenshots FOLDER."));
    result.lastStation = parser.value(options.until);
    if (!result.lastStation.isEmpty() && result.script != Script::stations)
        return shared.usage(QStringLiteral("--until needs the script stations."));
    result.namesPatient = result.screenshots.isEmpty() || parser.isSet(options.withPatient);
    return {};
}

}  // namespace

Result<ScriptLine> parseScriptLine(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Drives the window by a script, measures it, and prints JSON.\n"
                       "Without FOLDER it opens a built-in phantom. It reads no settings."));
    parser.addPositionalArgument(
        QStringLiteral("SCRIPT"),
        QStringLiteral("'orbit': turn the volume, then rest. 'changes': preset, clip, lights, look, study "
                       "and size in quick turns. 'session': a day's work with cold files, and a table. "
                       "'opening': open it only. 'stations': screenshots of panels, tools and dialogs."));
    const ViewerOptions shared("macula-viewer-bench", ViewerOptions::User::script);
    const ScriptOptions options;
    shared.addTo(parser);
    options.addTo(parser);
    if (!parser.parse(arguments)) return shared.usage(parser.errorText());
    ScriptLine result;
    if (const auto text = shared.textAskedFor(parser)) {
        result.window.print = text;
        return result;
    }
    QStringList words = parser.positionalArguments();
    if (words.isEmpty()) return shared.usage(QStringLiteral("A script is missing."), kScriptNames);
    const QString name = words.takeFirst();
    const auto script = scriptOf(name);
    if (!script) return shared.usage(QStringLiteral("There is no script '%1'.").arg(name), kScriptNames);
    result.script = *script;
    MACULA_TRY(result.window, shared.read(parser, words));
    // The size that these are told is that of the volume's picture.
    const bool isOfVolume = result.script == Script::orbit || result.script == Script::changes;
    if (isOfVolume && !result.window.choosesLayout) result.window.layout = scene::Layout::volume;
    MACULA_TRY_VOID(readScript(parser, shared, options, result));
    return result;
}

}  // namespace macula::viewer
