#include "viewer/command_line.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QRegularExpression>
#include <utility>

#include "pipeline/trace/settings.h"
#include "scene/camera/view_directions.h"
#include "viewer/keys/keys.h"
#include "viewer/theme/theme.h"

namespace macula::viewer {

namespace {

constexpr int kLargestEdge = trace::kMaxPictureSide;
constexpr int kSmallestEdge = 160;
constexpr double kShortestScriptSeconds = 1e-3;
constexpr double kLongestScriptSeconds = 3600.0;
constexpr const char* kKeepDaysVariable = "MACULA_KEEP_DAYS";
constexpr const char* kSessionsVariable = "MACULA_SESSIONS";

// Told in the terminal, in English.
Error usage(const QString& message, const char* hint = "Run macula-viewer --help.") {
    return {ErrorCode::usage, Text::verbatim(message.toStdString()), {}, Text::verbatim(hint)};
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

Result<double> parseSeconds(const QString& text, double least) {
    bool isNumber = false;
    const double seconds = text.toDouble(&isNumber);
    if (!isNumber || !(seconds >= least && seconds <= kLongestScriptSeconds))
        return usage(QStringLiteral("'%1' is not a number of seconds.").arg(text));
    return seconds;
}

Result<int> parseDays(const QString& source, const QString& text) {
    bool isNumber = false;
    const int days = text.toInt(&isNumber);
    if (!isNumber || days < 1 || days > kMostKeptDays)
        return usage(QStringLiteral("%1 is '%2', which is not a number of days.").arg(source, text),
                     "Give a whole number from 1 to 36500; without one nothing is deleted by itself.");
    return days;
}

Result<ViewDirection> parseView(const QString& text) {
    if (const auto direction = scene::viewDirectionOf(text.toStdString())) return *direction;
    return usage(QStringLiteral("There is no view '%1'.").arg(text),
                 "The views are anterior, posterior, left, right, superior, inferior, oblique, "
                 "three-quarter and turned.");
}

Result<scene::Layout> parseLayout(const QString& text) {
    for (const LayoutRow& row : kLayouts) {
        if (text.toStdString() == nameOf(row.layout)) return row.layout;
    }
    return usage(QStringLiteral("There is no layout '%1'.").arg(text),
                 "The layouts are fourPanes, volume, axial, coronal and sagittal.");
}

Result<Language> parseLanguage(const QString& text) {
    if (const auto language = languageOf(text)) return *language;
    return usage(QStringLiteral("There is no language '%1'.").arg(text), "The languages are en and de.");
}

Result<CommandLine::Script> parseScript(const QString& text) {
    using Script = CommandLine::Script;
    constexpr std::pair<const char*, Script> kScripts[] = {{"orbit", Script::orbit},
                                                           {"changes", Script::changes},
                                                           {"session", Script::session},
                                                           {"opening", Script::opening},
                                                           {"stations", Script::stations}};
    for (const auto& [name, script] : kScripts) {
        if (text == QLatin1String(name)) return script;
    }
    return usage(QStringLiteral("There is no script '%1'.").arg(text),
                 "The scripts are 'orbit', 'changes', 'session', 'opening' and 'stations'.");
}

Result<double> parseFontScale(const QString& text) {
    bool isNumber = false;
    const double scale = text.toDouble(&isNumber);
    if (!isNumber || !(scale >= kSmallestFontScale && scale <= kLargestFontScale))
        return usage(QStringLiteral("'%1' is not a scale of letters.").arg(text), "Write 0.8 to 2.");
    return scale;
}

// The options that Qt does not bring.
struct Options {
    const QCommandLineOption preset{"preset", "What is seen, e.g. ct-bone.", "NAME"};
    const QCommandLineOption lights{"lights", "Where the light comes from, e.g. studio.", "NAME"};
    const QCommandLineOption view{"view",
                                  "Looked at from anterior, posterior, left, right, superior, inferior, "
                                  "oblique, three-quarter or turned (default: by what was scanned).",
                                  "DIRECTION"};
    const QCommandLineOption device{"device", "Index or part of the name of the Vulkan device.", "NAME"};
    const QCommandLineOption size{
        "size", "Of the 3D picture in pixels, e.g. 800x600; of the window, where slices are shown.", "WxH"};
    const QCommandLineOption layout{
        "layout", "Which panes: fourPanes, volume, axial, coronal or sagittal; volume with a script.", "NAME",
        "fourPanes"};
    const QCommandLineOption language{"language", "Of the window: en or de; else that of the desktop.",
                                      "CODE"};
    const QCommandLineOption highContrast{"high-contrast", "Black, white and yellow."};
    const QCommandLineOption fontScale{"font-scale", "Times the size of the desktop's letters, 0.8 to 2.",
                                       "X", "1"};
    const QCommandLineOption samples{"spp", "Samples per pixel of a converged picture.", "N", "512"};
    const QCommandLineOption noModel{
        "no-model", "Small traced pictures while a hand moves, instead of the preview of a model."};
    const QCommandLineOption sessions{
        "sessions", "Where models, and how studies were left, are kept for the next time.", "FOLDER"};
    const QCommandLineOption noSession{"no-session", "Keep nothing, and begin anew."};
    const QCommandLineOption keepDays{
        "keep-days",
        "Before anything is opened, delete what is kept of studies that were not opened for N days. "
        "Default: MACULA_KEEP_DAYS of the environment, else nothing is deleted.",
        "N"};
    const QCommandLineOption calibrate{
        "calibrate", "Measure this machine anew for the quality slider, say how fast it is, and quit."};
    const QCommandLineOption headset{"xr",
                                     "Show the study in a headset (OpenXR) as well; the window mirrors it."};
    const QCommandLineOption script{
        "script",
        "Drive the window, measure it, print JSON, quit. 'orbit': turn the volume, "
        "then rest. 'changes': preset, clip, lights, look, study and size in quick "
        "turns. 'session': a day's work with cold files, and a table. 'opening': open it only. "
        "'stations': screenshots of panels, tools and dialogs.",
        "NAME"};
    const QCommandLineOption screenshots{"screenshots", "Where the script writes its screenshots.", "FOLDER"};
    const QCommandLineOption until{"until", "The last station of the script 'stations', e.g. open.", "NAME"};
    const QCommandLineOption withPatient{
        "with-patient", "Screenshots name patient and study; without this, nothing in the window does."};
    const QCommandLineOption wait{
        "wait", "How long the model learns before the script orbits, or a station converges.", "S", "0"};
    const QCommandLineOption seconds{"seconds", "How long the script orbits, at least, or makes changes.",
                                     "S", "8"};
    const QCommandLineOption turn{"turn", "In how long it orbits once around the patient.", "S", "8"};
    const QCommandLineOption rest{"rest", "How long it rests afterwards, unless the picture converges.", "S",
                                  "300"};

    void addTo(QCommandLineParser& parser) const {
        parser.addOptions({calibrate,   preset,    lights,       view,      device,  size,
                           layout,      language,  highContrast, fontScale, samples, noModel,
                           sessions,    noSession, keepDays,     headset,   script,  screenshots,
                           withPatient, wait,      turn,         seconds,   rest,    until});
    }
};

// What is kept for the next time, where, and for how long.
Result<void> readSessions(const QCommandLineParser& parser, const Options& options, CommandLine& result) {
    if (parser.isSet(options.sessions)) result.sessions = parser.value(options.sessions);
    if (result.sessions && (result.sessions->isEmpty() || parser.isSet(options.noSession)))
        return usage(QStringLiteral("--sessions needs a folder, and does not go with --no-session."));
    // A script measures: it begins anew, unless it is told where.
    result.keepsStudies =
        !parser.isSet(options.noSession) && (result.sessions || !parser.isSet(options.script));
    const QString preset = qEnvironmentVariable(kKeepDaysVariable);
    if (parser.isSet(options.keepDays)) {
        if (!result.keepsStudies)
            return usage(QStringLiteral("--keep-days does nothing where nothing is kept."),
                         "Leave --no-session out; with a --script, say --sessions FOLDER.");
        MACULA_TRY(result.keepDays, parseDays(QStringLiteral("--keep-days"), parser.value(options.keepDays)));
    } else if (result.keepsStudies && !preset.isEmpty()) {
        MACULA_TRY(result.keepDays, parseDays(QLatin1String(kKeepDaysVariable), preset));
    }
    return {};
}

// What drives the window instead of a hand, and how long.
Result<void> readScript(const QCommandLineParser& parser, const Options& options, CommandLine& result) {
    MACULA_TRY(result.waitSeconds, parseSeconds(parser.value(options.wait), 0.0));
    MACULA_TRY(result.turnSeconds, parseSeconds(parser.value(options.turn), kShortestScriptSeconds));
    MACULA_TRY(result.seconds, parseSeconds(parser.value(options.seconds), kShortestScriptSeconds));
    MACULA_TRY(result.restSeconds, parseSeconds(parser.value(options.rest), kShortestScriptSeconds));
    if (parser.isSet(options.script)) {
        MACULA_TRY(result.script, parseScript(parser.value(options.script)));
    }
    using Script = CommandLine::Script;
    // Its size is that of the volume's picture.
    const bool isOfVolume = result.script == Script::orbit || result.script == Script::changes;
    if (isOfVolume && !parser.isSet(options.layout)) result.layout = scene::Layout::volume;
    result.screenshots = parser.value(options.screenshots);
    if (!result.screenshots.isEmpty() && result.script != Script::orbit && result.script != Script::stations)
        return usage(QStringLiteral("--screenshots needs --script orbit or stations."));
    if (result.screenshots.isEmpty() && result.script == Script::stations)
        return usage(QStringLiteral("--script stations needs --screenshots FOLDER."));
    result.lastStation = parser.value(options.until);
    if (!result.lastStation.isEmpty() && result.script != Script::stations)
        return usage(QStringLiteral("--until needs --script stations."));
    result.namesPatient = result.screenshots.isEmpty() || parser.isSet(options.withPatient);
    return {};
}

}  // namespace

Result<CommandLine> parseCommandLine(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Shows a study, path traced. Without FOLDER it opens a built-in phantom.\n"
                       "Not for primary diagnosis."));
    parser.addPositionalArgument(
        QStringLiteral("FOLDER"),
        QStringLiteral("A folder with DICOM files, or a file: one of its images, its "
                       "DICOMDIR, or NIfTI, NRRD or MetaImage."),
        QStringLiteral("[FOLDER]"));
    const Options options;
    options.addTo(parser);
    const QCommandLineOption help = parser.addHelpOption();
    const QCommandLineOption version = parser.addVersionOption();
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
    result.preset = parser.value(options.preset);
    result.lights = parser.value(options.lights);
    result.device = parser.value(options.device);
    if (parser.isSet(options.view)) {
        MACULA_TRY(result.view, parseView(parser.value(options.view)));
    }
    if (parser.isSet(options.size)) {
        MACULA_TRY(result.size, parseSize(parser.value(options.size)));
    }
    MACULA_TRY(result.layout, parseLayout(parser.value(options.layout)));
    result.choosesLayout = parser.isSet(options.layout);
    if (parser.isSet(options.language)) {
        MACULA_TRY(result.language, parseLanguage(parser.value(options.language)));
    }
    result.highContrast = parser.isSet(options.highContrast);
    result.choosesFontScale = parser.isSet(options.fontScale);
    MACULA_TRY(result.fontScale, parseFontScale(parser.value(options.fontScale)));
    bool isNumber = false;
    result.samples = parser.value(options.samples).toUInt(&isNumber);
    if (!isNumber || result.samples == 0) {
        return usage(QStringLiteral("'%1' is not a number of samples.").arg(parser.value(options.samples)));
    }
    result.usesModel = !parser.isSet(options.noModel);
    MACULA_TRY_VOID(readSessions(parser, options, result));
    result.calibrates = parser.isSet(options.calibrate);
    if (result.calibrates && (!folders.isEmpty() || parser.isSet(options.script)))
        return usage(QStringLiteral("--calibrate measures the machine, and opens nothing."),
                     "Leave out the folder and --script.");
    result.showsInHeadset = parser.isSet(options.headset);
    if (result.showsInHeadset && (result.calibrates || parser.isSet(options.script)))
        return usage(QStringLiteral("--xr does not go with --script or --calibrate."),
                     "Leave one of them out.");
    result.choosesView =
        parser.isSet(options.preset) || parser.isSet(options.lights) || parser.isSet(options.view);
    MACULA_TRY_VOID(readScript(parser, options, result));
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
