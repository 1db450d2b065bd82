/* The C interface of Macula: open a study, choose how it is drawn, draw it into memory or into an image of
 * your own device, show it live, and train, keep and resume the model that the live picture is drawn with.
 * Include this file; each of those that it includes has what belongs to the noun it is named for.
 *
 * NOT FOR PRIMARY DIAGNOSIS. Macula is no medical device: docs/risk.md.
 *
 * Rules of all of it
 *   - Text is UTF-8 with a 0 at the end. Text that comes back belongs to Macula; each function says how long
 * it lives.
 *   - A struct begins with its size, which the caller sets: `macula_picture picture = {.size = sizeof
 * picture};` in C; in C++ `macula_picture picture{};` and `picture.size = sizeof picture;`. Every other
 * member may stay 0, and has its usual value then. A newer Macula takes the struct of an older header. A
 * struct for a result needs its size too.
 *   - An empty text is as null, where a function does not say otherwise.
 *   - Functions that can fail return a macula_status. macula_last_error() has the sentence for a person and
 * what to do. On failure nothing is changed, and handles come back null. No C++ exception gets out.
 *   - Lengths are millimetres. World is the patient's LPS: +x to the patient's left, +y to posterior, +z to
 * superior.
 *   - Handles are closed by the function of their name; null is allowed. A view holds on to its volume, so
 * the study may be closed before it.
 *   - Threads: calls that take a handle as const may go on at once in several threads; any other call has its
 * handles for itself. Different handles are used by different threads at once. Only macula_cancel_now() may
 * be called whenever. Calls block: run those that take a macula_progress beside the thread of your user
 * interface.
 *   - Mistakes are noticed where they can be: a handle that is closed, of another kind, or in use by another
 * call is MACULA_USAGE (no text, no number, where no status is returned), closing it once more does nothing,
 * and what is closed while a call uses it ends with that call. Do not rely on it: a new handle may be where a
 * closed one was, and handles that cancel are not watched.
 *   - Devices and live pictures are of the process that opened them: after fork() a child opens its own, and
 * leaves those open. Fork while no call is under way and no live picture is open: locks stay locked there.
 *   - Nothing is written to a file but what macula_live_open, macula_live_save and macula_live_write_model
 * are given places for. Nothing is printed: macula_log_to has the log, or stderr where MACULA_LOG is set in
 * the environment. Sentences, error texts, stages and the log name no patient; titles and the `place` of an
 * error may.
 *   - Where Macula finds a mistake of its own it does not go on with a wrong picture, and does not end your
 * program: the call returns MACULA_FAULT, and the handles that it was given are good for closing alone. Only
 * where that is found while something is closed or freed the program is ended.
 */
#ifndef MACULA_H
#define MACULA_H

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
