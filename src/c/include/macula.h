/* The C interface of Macula: open a study, choose how it is drawn, draw it into memory or into an image of
 * your own device, show it live, train, keep and resume the model that the live picture is drawn with, and
 * fetch studies from archives. Include this file; each header that it includes has what belongs to the noun
 * in its name.
 *
 * NOT FOR PRIMARY DIAGNOSIS. Macula is not a medical device: docs/risk.md.
 *
 * Rules for all of it
 *   - Text is UTF-8 with a 0 at the end. Text that comes back belongs to Macula; each function says how long
 *     it lives.
 *   - A struct begins with its size, which the caller sets: `macula_picture picture = {.size = sizeof
 *     picture};` in C; in C++ `macula_picture picture{};` and `picture.size = sizeof picture;`. Every other
 *     member may stay 0, and has its usual value then. A newer Macula accepts the struct of an older header.
 *     A struct for a result needs its size too.
 *   - An empty text counts as null, unless a function says otherwise.
 *   - Functions that can fail return a macula_status. macula_last_error() has the sentence for a person and
 *     what to do. On failure nothing is changed, and handles come back null. No C++ exception gets out.
 *   - Lengths are millimetres. World is the patient's LPS: +x to the patient's left, +y to posterior, +z to
 *     superior.
 *   - Handles are closed by the function of their name; null is allowed. A view holds on to its volume, so
 *     the study may be closed before it.
 *   - Threads: calls that take a handle as const may run at once on several threads; any other call needs its
 *     handles to itself. Different threads may use different handles at once. Only macula_cancel_now() may be
 *     called at any time. Calls block: run those that take a macula_progress on another thread than that of
 *     your user interface.
 *   - Mistakes are noticed where possible: a handle that is closed, of another kind, or in use by another
 *     call gives MACULA_USAGE (no text or no number, where no status is returned), closing it again does
 *     nothing, and a handle that is closed while a call uses it lives until that call ends. Do not rely on
 *     this: a new handle may have the address of a closed one, and handles that cancel are not checked.
 *   - Devices and live pictures belong to the process that opened them: after fork() a child opens its own,
 *     and does not close those. Fork only while no call is under way and no live picture is open, because
 *     their locks would stay locked in the child.
 *   - Files are written only in the places that macula_live_open, macula_live_save and
 *     macula_live_write_model are given, and where macula_archive_fetch says. Only calls for an archive open
 *     connections. Nothing is printed: the log goes to macula_log_to, or to stderr if MACULA_LOG is set in
 *     the environment. Sentences, error texts, stages and the log name no patient; titles, answers of
 *     archives, names of files and the `place` of an error may.
 *   - If Macula finds a mistake of its own, it neither goes on with a wrong picture nor ends your program:
 *     the call returns MACULA_FAULT, and the handles that it was given can only be closed. It ends the
 *     program only if it finds the mistake while something is closed or freed.
 */
#ifndef MACULA_H
#define MACULA_H

#include "macula/archive.h"
#include "macula/camera.h"
#include "macula/device.h"
#include "macula/live.h"
#include "macula/log.h"
#include "macula/model.h"
#include "macula/names.h"
#include "macula/picture.h"
#include "macula/progress.h"
#include "macula/shared_image.h"
#include "macula/status.h"
#include "macula/study.h"
#include "macula/view.h"

#endif
