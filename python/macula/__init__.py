"""Macula from Python: open a study, choose how it is drawn, and draw it.

    import macula
    study = macula.open("FOLDER")
    view = study.view()
    view.set_preset("cinematic-bone")
    view.draw(640, 480).save("bone.png")
    live = view.live(store="MODELS")  # frame by frame, with a model that is trained and kept
    archive = macula.Archive("Hospital")  # a PACS that is set up: find, fetch, send

NOT FOR PRIMARY DIAGNOSIS. Lengths are millimetres in the patient's LPS: +x to the patient's left, +y to posterior, +z
to superior. Show the notes of studies and pictures to whoever sees them. Objects are used by one thread at a time: what
is in use refuses to be changed by another, and draws for one after the other. A device may be that of several threads.
Functions that hear of progress or have the log must not call Macula.
NumPy is used where it is installed; nothing needs it.
"""

import atexit
import ctypes
import json
import os
import pathlib
import threading

from . import _interface, _png
from ._archive import Archive, Fetched, Found, Refusal, Sent, archives
from ._calls import Error, Watch as _Watch, check as _check, library as _library, texts as _texts
from ._handle import Handle as _Handle, bytes_of as _bytes, is_heard as _is_heard, numbers as _numbers, whole as _whole

__all__ = ["Archive", "Device", "Error", "Fetched", "Found", "Frame", "Live", "Model", "Picture", "Refusal", "Sent",
           "Study", "View", "archives", "built_in", "log_to", "names", "open", "study_of", "version"]

_TYPES = {"b": 1, "B": 2, "h": 3, "H": 4, "i": 5, "I": 6, "f": 7, "d": 8}  # MACULA_INT8 ...
_UNITS = {None: 0, "HU": 1}
_KINDS = {"presets": 0, "clips": 1, "lights": 2, "looks": 3, "qualities": 4}
_DENOISE = {None: 0, True: 1, False: 2}
_MOST = 2 ** 32 - 1


def version():
    return _library.macula_version().decode()


def names(kind):
    """What is built in of "presets", "clips", "lights", "looks" or "qualities"."""
    if kind not in _KINDS:
        raise ValueError(f"There are {', '.join(_KINDS)}.")
    return _texts(_library.macula_name, _KINDS[kind])


def built_in():
    """A dict of lists of all that is built in, with titles, and of presets what they are for."""
    told = ctypes.c_char_p()
    _check(_library.macula_built_in(told))
    return json.loads(told.value)


def _log_to_nobody():
    """At the end of Python, before what has the log is taken apart: threads of Macula may still have something to say."""
    _library.macula_log_to(_interface.LogLine(), None, _LEVELS.index("warning"))


_LEVELS = ("debug", "info", "warning", "error")
_log_line = None  # must live as long as the library may call it
_log_in_change = threading.Lock()  # so that the last line that the library was given is the one that lives


def log_to(function, least="warning"):
    """`function(level, line)` has the log from now on; None: nobody has. It must not call Macula."""
    global _log_line
    if least not in _LEVELS:
        raise ValueError(f"The levels are {', '.join(_LEVELS)}.")

    def hear(_user, level, line):
        _is_heard.now = True
        try:
            function(_LEVELS[level], line.decode("utf-8", "replace"))
        except Exception:  # nothing may go through C, and what is logged is not worth ending for
            pass
        finally:
            _is_heard.now = False

    line = _interface.LogLine() if function is None else _interface.LogLine(hear)
    with _log_in_change:
        atexit.unregister(_log_to_nobody)
        if function is not None:
            atexit.register(_log_to_nobody)
        _check(_library.macula_log_to(line, None, _LEVELS.index(least)))
        _log_line = line


class Device(_Handle):
    """What draws: by number or part of a name; without one, MACULA_DEVICE or the best. A process that is forked opens
    its own."""

    _is_of_process = True

    def __init__(self, preferred=None):
        handle = ctypes.c_void_p()
        _check(_library.macula_device_open(_bytes(preferred), handle))
        super().__init__(handle, _library.macula_device_close)  # one picture at a time, whichever thread wants it


_device = None
_device_in_making = threading.Lock()


def _forget_device():
    """In a process that was forked: it opens one of its own."""
    global _device, _device_in_making
    _device, _device_in_making = None, threading.Lock()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget_device)


def _usual_device():
    global _device
    with _device_in_making:
        if _device is None:
            _device = Device()
        return _device


def _camera_of(told):
    return {"position_mm": tuple(told.position_mm), "target_mm": tuple(told.target_mm), "up": tuple(told.up),
            "vertical_fov_deg": told.vertical_fov_deg, "parallel_height_mm": told.parallel_height_mm}


def _camera(position_mm, target_mm, up, vertical_fov_deg=30.0, parallel_height_mm=0.0):
    return _interface.Camera(position_mm=_numbers(position_mm, 3, "position_mm"),
                             target_mm=_numbers(target_mm, 3, "target_mm"), up=_numbers(up, 3, "up"),
                             vertical_fov_deg=vertical_fov_deg, parallel_height_mm=parallel_height_mm)


def _check_size(width, height):
    if not (0 < width <= 16384 and 0 < height <= 16384):
        raise ValueError("A picture has 1 to 16384 pixels on each side.")


class Picture:
    """`rgba`: width * height * 4 bytes for display, the upper row first. numpy.asarray(picture) has [y, x, channel].
    `record`: a dict of how it was made."""

    def __init__(self, rgba, drawn, width, height, notes, record):
        self.rgba, self.width, self.height, self.notes, self.record = rgba, width, height, notes, record
        self.is_denoised, self.is_empty, self.is_coarse = (bool(drawn.is_denoised), bool(drawn.is_empty),
                                                           bool(drawn.is_coarse))
        self.samples_per_pixel, self.noise, self.seconds = drawn.samples_per_pixel, drawn.noise, drawn.seconds
        self.preset, self.device = drawn.preset.decode(), drawn.device.decode("utf-8", "replace")
        self.camera = _camera_of(drawn.camera)

    @property
    def __array_interface__(self):
        return {"version": 3, "shape": (self.height, self.width, 4), "typestr": "|u1", "data": self.rgba}

    def save(self, path):
        """As PNG, which says how it was made."""
        if pathlib.Path(os.fsdecode(path)).suffix.lower() not in ("", ".png"):
            raise ValueError("A picture is saved as PNG: end its name with .png.")
        said = "denoised" if self.is_denoised else "plain"
        _png.write(path, self.width, self.height, self.rgba, {
            "Software": f"Macula {version()}", "macula:preset": self.preset, "macula:device": self.device,
            "macula:samplesPerPixel": f"{self.samples_per_pixel:g}", "macula:denoising": said,
            "Disclaimer": "Not for primary diagnosis."})


class View(_Handle):
    """What of a volume is drawn, and how; Study.view makes it. None anywhere is the usual."""

    def set_preset(self, preset=None, fit=False):
        """By name, number or file. `fit`: its range is stretched to the volume, for MR."""
        _check(_library.macula_view_set_preset(self._open(), _bytes(preset), bool(fit)))

    def set_look(self, look=None):
        """"cinematic", "clear", "dvr", "mip", "minip" or "average"."""
        _check(_library.macula_view_set_look(self._open(), _bytes(look)))

    def set_lights(self, lights=None):
        """By name, file, or HDR or EXR panorama."""
        _check(_library.macula_view_set_lights(self._open(), _bytes(lights)))

    def set_window(self, centre=0.0, width=0.0):
        """Of mip, minip and average; without a width that of the preset or the series."""
        _check(_library.macula_view_set_window(self._open(), centre, width))

    def set_clip(self, clip=None):
        """By name or file."""
        _check(_library.macula_view_set_clip(self._open(), _bytes(clip)))

    def set_box(self, low_mm, high_mm):
        """Shows what lies between two corners, along the patient's axes."""
        _check(_library.macula_view_set_box(self._open(), _numbers(low_mm, 3, "low_mm"),
                                            _numbers(high_mm, 3, "high_mm")))

    def remove_table(self, remove=True):
        _check(_library.macula_view_remove_table(self._open(), bool(remove)))

    def set_camera(self, position_mm, target_mm, up, vertical_fov_deg=30.0, parallel_height_mm=0.0):
        _check(_library.macula_view_set_camera(
            self._open(), _camera(position_mm, target_mm, up, vertical_fov_deg, parallel_height_mm)))

    def set_direction(self, direction=None):
        """Where the viewer stands: "anterior", "posterior", "left", "right", "superior", "inferior", "oblique",
        "three-quarter" or "turned"; None: by what was scanned."""
        _check(_library.macula_view_set_direction(self._open(), _bytes(direction)))

    def set_background(self, background=None):
        """Behind the patient: "black", "white", "grey" or "#rrggbb"; None: black."""
        _check(_library.macula_view_set_background(self._open(), _bytes(background)))

    @property
    def state(self):
        """All that was chosen, as a dict; json.dump makes a file of it that the viewer and `macula render --session`
        open. Set it to choose all of that at once: a dict, or its text."""
        told = ctypes.c_char_p()
        _check(_library.macula_view_state(self._open(), told))
        return json.loads(told.value)

    @state.setter
    def state(self, state):
        text = state if isinstance(state, str) else json.dumps(state)
        _check(_library.macula_view_set_state(self._open(), text.encode()))

    def live(self, store=None, model=True, device=None, progress=None):
        """A Live of what the view shows now. `store`: the folder where its model is kept between runs; without one
        none is. Without `model` all is traced."""
        options = _interface.LiveOptions(model=0 if model else 1, store=_bytes(store))
        handle, watch, device = ctypes.c_void_p(), _Watch(progress), device or _usual_device()
        with device._held() as on:
            status = _library.macula_live_open(on, self._open(), options, watch.progress, handle)
            return watch.made(status, Live, handle, _library.macula_live_close)

    def draw(self, width, height, samples=0, quality=None, most_noise=0.0, denoise=None, seed=0, device=None,
             progress=None, lens_mm=0.0, focus_mm=0.0, fog_mm=0.0):
        """Returns a Picture. `progress(stage, fraction)` cancels by returning True; then Error.is_cancelled. A lens of
        that diameter blurs what is not at `focus_mm` from the camera (0: at what the middle shows); fog fades what lies
        behind the nearest matter, to 37 % over `fog_mm`."""
        _check_size(width, height)
        if denoise not in _DENOISE:
            raise ValueError("denoise is True, False or None.")
        rgba = bytearray(4 * width * height)
        pixels = (ctypes.c_uint8 * len(rgba)).from_buffer(rgba)
        asked = _interface.Picture(width=width, height=height, denoise=_DENOISE[denoise],
                                   samples_per_pixel=_whole(samples, _MOST, "samples"),
                                   seed=_whole(seed, _MOST, "seed"), quality=_bytes(quality), most_noise=most_noise,
                                   bytes=len(rgba), lens_mm=lens_mm, focus_mm=focus_mm, fog_mm=fog_mm,
                                   rgba=ctypes.cast(pixels, ctypes.POINTER(ctypes.c_uint8)))
        drawn, watch, device = _interface.Drawn(), _Watch(progress), device or _usual_device()
        told = ctypes.c_char_p()
        with self._held() as handle:
            with device._held() as on:
                watch.check(_library.macula_draw(on, handle, asked, watch.progress, drawn))
            _check(_library.macula_view_record(handle, told))
            return Picture(rgba, drawn, width, height, _texts(_library.macula_view_note, handle),
                           json.loads(told.value))

    def pick(self, x, y, width, height, camera=None, progress=None):
        """What of the patient is seen at that pixel of a picture of that size: patient LPS mm, or None where nothing
        is. 0.5 is the middle of the first pixel from the left, and from above. `camera` is that of the picture, without
        one of the last that was drawn."""
        _check_size(width, height)
        eye = None if camera is None else ctypes.pointer(_camera(**camera))
        picked, watch = _interface.Picked(), _Watch(progress)
        watch.check(_library.macula_view_pick(
            self._open(), _interface.Pick(width=width, height=height, x=x, y=y, camera=eye), watch.progress, picked))
        return tuple(picked.point_mm) if picked.is_something else None


class Frame:
    """A frame of a live picture; `rgba` as of Picture. `kind` is "small", "model", "fading" or "traced", `fidelity`
    says what lies between it and a traced picture: show both, and the notes."""

    _KINDS = {1: "small", 2: "model", 3: "fading", 4: "traced"}

    def __init__(self, rgba, shown, width, height, notes):
        self.rgba, self.width, self.height, self.notes = rgba, width, height, notes
        self.kind, self.is_final, self.is_new, self.is_denoised = (self._KINDS[shown.picture], bool(shown.is_final),
                                                                   bool(shown.is_new), bool(shown.is_denoised))
        self.scale, self.samples_per_pixel, self.noise = shown.scale, shown.samples_per_pixel, shown.noise
        self.latency_ms = shown.latency_ms
        self.fovea_age_ms = shown.fovea_age_ms if shown.fovea_age_ms >= 0 else None
        self.fidelity, self.device = (text.decode("utf-8", "replace") for text in (shown.fidelity, shown.device))
        self.camera = _camera_of(shown.camera)

    @property
    def __array_interface__(self):
        return {"version": 3, "shape": (self.height, self.width, 4), "typestr": "|u1", "data": self.rgba}


class Model:
    """How far the model of a live picture is: `stage` and `origin` are words for a person; `error` is the mean
    difference to pictures that are held out, None before it is known."""

    def __init__(self, told):
        self.stage, self.origin = told.stage_name.decode(), told.origin.decode()
        self.is_resumed, self.splats, self.steps, self.views = (bool(told.is_resumed), told.splats, told.steps,
                                                                told.views)
        self.error = told.error if told.error == told.error else None
        self.seconds = told.seconds

    def __repr__(self):
        return f"<model: {self.stage}, {self.splats} splats, {self.steps} steps; {self.origin}>"


class Live(_Handle):
    """The live picture of a view; View.live makes it. Closing saves what was learnt, which may take a while."""

    _is_of_process = True

    def show(self, view, progress=None):
        """From now on what that view shows now."""
        watch = _Watch(progress)
        watch.check(_library.macula_live_show(self._open(), view._open(), watch.progress))

    def frame(self, width, height, camera=None, gaze=(0.0, 0.0), moving=False, for_about_ms=0.0, out=None,
              progress=None):
        """Returns the next Frame. `camera`: a dict as Picture.camera; without one that of the view. `gaze`: where the
        eye looks, -1 to 1, right and up are positive. `out`: a writable buffer that it is drawn into, such as a NumPy
        array of uint8 [height, width, 4], C-contiguous."""
        _check_size(width, height)
        rgba = bytearray(4 * width * height) if out is None else memoryview(out).cast("B")
        if len(rgba) != 4 * width * height:
            raise ValueError(f"The picture has {4 * width * height} bytes, and out has {len(rgba)}.")
        pixels = (ctypes.c_uint8 * len(rgba)).from_buffer(rgba)
        eye = None if camera is None else ctypes.pointer(_camera(**camera))
        asked = _interface.Frame(width=width, height=height, is_moving=bool(moving), camera=eye,
                                 gaze=_numbers(gaze, 2, "gaze"), for_about_ms=for_about_ms, bytes=len(rgba),
                                 rgba=ctypes.cast(pixels, ctypes.POINTER(ctypes.c_uint8)))
        shown, watch = _interface.Shown(), _Watch(progress)
        with self._held() as handle:
            watch.check(_library.macula_live_frame(handle, asked, watch.progress, shown))
            return Frame(rgba, shown, width, height, _texts(_library.macula_live_note, handle))

    @property
    def times(self):
        """Where the time of the calls went: a list of dicts of "stage", "times", "ms", "waitedMs" and "longestMs", the
        longest first."""
        told = ctypes.c_char_p()
        _check(_library.macula_live_times(self._open(), told))
        return json.loads(told.value)

    @property
    def model(self):
        told = _interface.Model()
        _check(_library.macula_live_model(self._open(), told))
        return Model(told)

    def train(self, steps=0, seconds=0.0, progress=None):
        """Teaches the model at least `steps` more, some tens at a time, or for `seconds`, whatever ends first; without
        both until it rests. Returns a Model. What was learnt stays when it is cancelled."""
        told, watch = _interface.Model(), _Watch(progress)
        wanted = _interface.Training(steps=_whole(steps, 2 ** 63 - 1, "steps"), seconds=seconds)
        watch.check(_library.macula_live_train(self._open(), wanted, watch.progress, told))
        return Model(told)

    def save(self, progress=None):
        """To the store, now. A Live with the same store goes on with it, in another run too."""
        watch = _Watch(progress)
        watch.check(_library.macula_live_save(self._open(), watch.progress))

    def write_model(self, path, overwrite=False, progress=None):
        """As .macula, with which `macula train --resume` goes on; or .ply, .spz or .glb."""
        watch = _Watch(progress)
        watch.check(_library.macula_live_write_model(self._open(), _bytes(path), bool(overwrite), watch.progress))


class Study(_Handle):
    """What was opened, with one volume loaded; macula.open and macula.study_of make it."""

    @property
    def titles(self):
        """A line for each volume, which may name the patient where there are several."""
        return _texts(_library.macula_study_title, self._open())

    @property
    def notes(self):
        """Which volume was taken, and what was assumed, left out or repaired in it."""
        return _texts(_library.macula_study_note, self._open())

    @property
    def found(self):
        """All that the folder holds, as a dict: what `macula info --json --patient` writes, with each file that was
        left out, and why; "volumes" has the place there of each of `titles`. It names patients."""
        told = ctypes.c_char_p()
        _check(_library.macula_study_found(self._open(), told))
        return json.loads(told.value)

    def choose(self, index, progress=None):
        """Loads another volume; views of the one before stay."""
        watch = _Watch(progress)
        watch.check(_library.macula_study_choose(self._open(), _whole(index, _MOST, "index"), watch.progress))

    def _volume(self):
        told = _interface.Volume()
        _check(_library.macula_study_volume(self._open(), told))
        return told

    @property
    def index(self):
        """Of the volume that is loaded."""
        return self._volume().index

    @property
    def shape(self):
        """(slices, rows, columns), as of values()."""
        told = self._volume()
        return told.slices, told.rows, told.columns

    @property
    def unit(self):
        """"HU"; empty for the scanner's own numbers."""
        return self._volume().unit_name.decode("utf-8", "replace")

    @property
    def modality(self):
        return self._volume().modality.decode("utf-8", "replace")

    @property
    def study_uid(self):
        """Empty, as those below, where there is none. They may lead to the patient."""
        return self._volume().study_uid.decode("utf-8", "replace")

    @property
    def series_uid(self):
        return self._volume().series_uid.decode("utf-8", "replace")

    @property
    def frame_of_reference_uid(self):
        return self._volume().frame_of_reference_uid.decode("utf-8", "replace")

    @property
    def is_calibrated(self):
        """Whether spacing_mm is a measured one, and no estimate: else each length, area and volume is one too."""
        return not self._volume().is_uncalibrated

    @property
    def value_range(self):
        told = self._volume()
        return told.low, told.high

    @property
    def spacing_mm(self):
        """Along columns, rows, slices: i, j, k."""
        return tuple(self._volume().spacing_mm)

    @property
    def patient_from_voxel(self):
        """Four rows: patient LPS mm of (i, j, k, 1), which is values()[k, j, i]."""
        numbers = list(self._volume().patient_from_voxel)
        return [numbers[4 * row:4 * row + 4] for row in range(4)]

    def values(self):
        """A NumPy array of float32, [k, j, i]; without NumPy a memoryview of that shape."""
        slices, rows, columns = self.shape
        count = slices * rows * columns
        room = bytearray(4 * count)
        numbers = (ctypes.c_float * count).from_buffer(room)
        _check(_library.macula_study_values(self._open(), numbers, count))
        view = memoryview(room).cast("f", (slices, rows, columns))
        try:
            import numpy
        except ImportError:
            return view
        return numpy.asarray(view)

    def view(self):
        """A View of the volume that is loaded: all of it, from the usual direction."""
        handle = ctypes.c_void_p()
        _check(_library.macula_view_create(self._open(), handle))
        return View(handle, _library.macula_view_close)


def _study(make, progress):
    handle, watch = ctypes.c_void_p(), _Watch(progress)
    return watch.made(make(watch.progress, handle), Study, handle, _library.macula_study_close)


def open(path, join=False, progress=None, series_uid=None):
    """A folder with DICOM files, one of them, a DICOMDIR, a NIfTI, NRRD or MetaImage file, or "phantom:".

    `join`: images are one series that agree in all but identifiers made anew for each of them. `series_uid`:
    the series of a folder that is meant, in place of that of the best volume, or its number in `macula info`. A folder
    of several patients is an Error that lists their series, unless it is given."""
    how = _interface.Open(join=bool(join), series_uid=_bytes(series_uid))
    return _study(lambda told, handle: _library.macula_study_open(_bytes(path), how, told, handle), progress)


def study_of(values, patient_from_voxel, unit=None, slope=1.0, intercept=0.0, progress=None):
    """A study of a volume in memory, which is copied.

    `values` is a NumPy array, or another buffer, of three dimensions [k, j, i]: slices, rows, columns, of 8 to 32 bit
    integers or floats. `patient_from_voxel`: four rows that take (i, j, k, 1) at the centre of a voxel to patient LPS
    mm. `unit` is "HU" or None. value = slope * voxel + intercept."""
    if unit not in _UNITS:
        raise ValueError('The unit is "HU" or None.')
    if slope == 0.0:
        raise ValueError("A slope of 0 leaves no value.")
    try:
        view = memoryview(values)
    except TypeError:
        raise TypeError("A volume is a NumPy array, or another buffer.") from None
    kind = view.format.lstrip("@=<") if view.format else ""
    if kind == "l" and view.itemsize == 4:
        kind = "i"
    if view.ndim != 3 or kind not in _TYPES:
        raise ValueError("A volume has three dimensions, of integers of 8 to 32 bits or floats of 32 or 64, in the "
                         f"byte order of this machine; this has {view.ndim}, of format {view.format!r}. See numpy.astype.")
    data = view.tobytes(order="C")
    slices, rows, columns = view.shape
    numbers = [float(number) for row in patient_from_voxel for number in row]
    if len(numbers) != 16:
        raise ValueError("patient_from_voxel has four rows of four numbers.")
    voxels = _interface.Voxels(type=_TYPES[kind], columns=columns, rows=rows, slices=slices, unit=_UNITS[unit],
                               data=ctypes.cast(ctypes.c_char_p(data), ctypes.c_void_p), bytes=len(data), slope=slope,
                               intercept=intercept, patient_from_voxel=(ctypes.c_double * 16)(*numbers))
    return _study(lambda told, handle: _library.macula_study_of_voxels(voxels, told, handle), progress)
