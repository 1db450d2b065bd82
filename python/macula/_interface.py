"""macula.h for ctypes: its structs, its functions, and where the library is."""

import ctypes
import os
import pathlib
from ctypes import (CFUNCTYPE, POINTER, Structure, c_char_p, c_double, c_float, c_int32, c_uint8, c_uint32, c_uint64,
                    c_void_p)

_NAME = "libmacula.so.0"


class Sized(Structure):
    """A struct of macula.h, whose first member is its size."""

    def __init__(self, **values):
        super().__init__(size=ctypes.sizeof(type(self)), **values)


class ErrorStruct(Sized):
    _fields_ = [("size", c_uint32), ("status", c_int32), ("message", c_char_p), ("advice", c_char_p),
                ("place", c_char_p)]


Told = CFUNCTYPE(c_int32, c_void_p, c_char_p, c_double)


class Progress(Sized):
    _fields_ = [("size", c_uint32), ("reserved", c_uint32), ("told", Told), ("user", c_void_p), ("cancel", c_void_p)]


class Open(Sized):
    _fields_ = [("size", c_uint32), ("join", c_int32), ("series_uid", c_char_p)]


class Voxels(Sized):
    _fields_ = [("size", c_uint32), ("type", c_int32), ("columns", c_int32), ("rows", c_int32), ("slices", c_int32),
                ("unit", c_int32), ("data", c_void_p), ("bytes", c_uint64), ("slope", c_double),
                ("intercept", c_double), ("patient_from_voxel", c_double * 16)]


class Volume(Sized):
    _fields_ = [("size", c_uint32), ("index", c_uint32), ("columns", c_int32), ("rows", c_int32), ("slices", c_int32),
                ("unit", c_int32), ("unit_name", c_char_p), ("modality", c_char_p), ("low", c_double),
                ("high", c_double), ("spacing_mm", c_double * 3), ("patient_from_voxel", c_double * 16),
                ("study_uid", c_char_p), ("series_uid", c_char_p), ("frame_of_reference_uid", c_char_p),
                ("is_uncalibrated", c_int32), ("reserved", c_int32)]


class Secrets(Sized):
    _fields_ = [("size", c_uint32), ("reserved", c_uint32), ("password", c_char_p), ("token", c_char_p),
                ("key_passphrase", c_char_p)]


class Query(Sized):
    _fields_ = [("size", c_uint32), ("most_answers", c_uint32), ("patient_name", c_char_p), ("patient_id", c_char_p),
                ("patient_birth_date", c_char_p), ("accession_number", c_char_p), ("study_id", c_char_p),
                ("study_uid", c_char_p), ("date_from", c_char_p), ("date_to", c_char_p), ("modality", c_char_p),
                ("description", c_char_p), ("referring_physician", c_char_p)]


Arrived = CFUNCTYPE(c_int32, c_void_p, c_char_p, c_uint64, c_uint64)


class Fetch(Sized):
    _fields_ = [("size", c_uint32), ("series_count", c_uint32), ("study_uid", c_char_p),
                ("series_uids", POINTER(c_char_p)), ("into", c_char_p), ("arrived", Arrived), ("user", c_void_p)]


class Fetched(Sized):
    _fields_ = [("size", c_uint32), ("is_complete", c_int32), ("folder", c_char_p), ("promised", c_uint64),
                ("kept", c_uint64), ("had_already", c_uint64), ("refused", c_uint64), ("never", c_uint64),
                ("bytes", c_uint64)]


class Sent(Sized):
    _fields_ = [("size", c_uint32), ("reserved", c_uint32), ("files", c_uint64), ("stored", c_uint64),
                ("refused", c_uint64)]


class Refusal(Sized):
    _fields_ = [("size", c_uint32), ("reserved", c_uint32), ("file", c_char_p), ("why", c_char_p),
                ("advice", c_char_p)]


class Camera(Sized):
    _fields_ = [("size", c_uint32), ("reserved", c_uint32), ("position_mm", c_double * 3), ("target_mm", c_double * 3),
                ("up", c_double * 3), ("vertical_fov_deg", c_double), ("parallel_height_mm", c_double)]


class Picture(Sized):
    _fields_ = [("size", c_uint32), ("width", c_int32), ("height", c_int32), ("denoise", c_int32),
                ("samples_per_pixel", c_uint32), ("seed", c_uint32), ("quality", c_char_p), ("most_noise", c_double),
                ("rgba", POINTER(c_uint8)), ("bytes", c_uint64), ("row_bytes", c_uint64),
                ("lens_mm", c_double), ("focus_mm", c_double), ("fog_mm", c_double)]


class Drawn(Sized):
    _fields_ = [("size", c_uint32), ("is_denoised", c_int32), ("is_empty", c_int32), ("is_coarse", c_int32),
                ("samples_per_pixel", c_double), ("noise", c_double), ("seconds", c_double), ("preset", c_char_p),
                ("device", c_char_p), ("camera", Camera)]


class Pick(Sized):
    _fields_ = [("size", c_uint32), ("width", c_int32), ("height", c_int32), ("reserved", c_uint32), ("x", c_double),
                ("y", c_double), ("camera", POINTER(Camera))]


class Picked(Sized):
    _fields_ = [("size", c_uint32), ("is_something", c_int32), ("point_mm", c_double * 3)]


class LiveOptions(Sized):
    _fields_ = [("size", c_uint32), ("model", c_int32), ("store", c_char_p), ("store_bytes", c_uint64)]


class Frame(Sized):
    _fields_ = [("size", c_uint32), ("width", c_int32), ("height", c_int32), ("is_moving", c_int32),
                ("camera", POINTER(Camera)), ("gaze", c_double * 2), ("for_about_ms", c_double),
                ("rgba", POINTER(c_uint8)), ("bytes", c_uint64), ("row_bytes", c_uint64), ("image", c_void_p),
                ("shared", c_void_p)]


class Shown(Sized):
    _fields_ = [("size", c_uint32), ("picture", c_int32), ("is_final", c_int32), ("is_new", c_int32),
                ("is_denoised", c_int32), ("scale", c_int32), ("samples_per_pixel", c_double), ("noise", c_double),
                ("latency_ms", c_double), ("fovea_age_ms", c_double), ("fidelity", c_char_p), ("device", c_char_p),
                ("camera", Camera)]


class Model(Sized):
    _fields_ = [("size", c_uint32), ("stage", c_int32), ("is_resumed", c_int32), ("splats", c_uint32),
                ("steps", c_uint64), ("views", c_uint64), ("error", c_double), ("seconds", c_double),
                ("stage_name", c_char_p), ("origin", c_char_p)]


class Training(Sized):
    _fields_ = [("size", c_uint32), ("reserved", c_uint32), ("steps", c_uint64), ("seconds", c_double)]


LogLine = CFUNCTYPE(None, c_void_p, c_int32, c_char_p)


# Those with a status first: what they return is checked. A handle is a void pointer.
_STATUS = {
    "macula_last_error": [POINTER(ErrorStruct)],
    "macula_cancel_create": [POINTER(c_void_p)],
    "macula_archives": [POINTER(c_char_p)],
    "macula_archive_open": [c_char_p, POINTER(Secrets), POINTER(c_void_p)],
    "macula_archive_of_json": [c_char_p, POINTER(Secrets), POINTER(c_void_p)],
    "macula_archive_test": [c_void_p, POINTER(Progress), POINTER(c_char_p)],
    "macula_archive_find": [c_void_p, POINTER(Query), POINTER(Progress), POINTER(c_char_p)],
    "macula_archive_series": [c_void_p, c_char_p, POINTER(Progress), POINTER(c_char_p)],
    "macula_archive_fetch": [c_void_p, POINTER(Fetch), POINTER(Progress), POINTER(Fetched)],
    "macula_archive_send": [c_void_p, POINTER(c_char_p), c_uint32, POINTER(Progress), POINTER(Sent)],
    "macula_archive_refusal": [c_void_p, c_uint32, POINTER(Refusal)],
    "macula_study_open": [c_char_p, POINTER(Open), POINTER(Progress), POINTER(c_void_p)],
    "macula_study_of_voxels": [POINTER(Voxels), POINTER(Progress), POINTER(c_void_p)],
    "macula_study_choose": [c_void_p, c_uint32, POINTER(Progress)],
    "macula_study_volume": [c_void_p, POINTER(Volume)],
    "macula_study_found": [c_void_p, POINTER(c_char_p)],
    "macula_study_values": [c_void_p, POINTER(c_float), c_uint64],
    "macula_view_create": [c_void_p, POINTER(c_void_p)],
    "macula_view_set_preset": [c_void_p, c_char_p, c_int32],
    "macula_view_set_look": [c_void_p, c_char_p],
    "macula_view_set_lights": [c_void_p, c_char_p],
    "macula_view_set_window": [c_void_p, c_double, c_double],
    "macula_view_set_clip": [c_void_p, c_char_p],
    "macula_view_set_box": [c_void_p, c_double * 3, c_double * 3],
    "macula_view_remove_table": [c_void_p, c_int32],
    "macula_view_set_camera": [c_void_p, POINTER(Camera)],
    "macula_view_set_direction": [c_void_p, c_char_p],
    "macula_view_set_background": [c_void_p, c_char_p],
    "macula_device_open": [c_char_p, POINTER(c_void_p)],
    "macula_view_state": [c_void_p, POINTER(c_char_p)],
    "macula_view_set_state": [c_void_p, c_char_p],
    "macula_view_record": [c_void_p, POINTER(c_char_p)],
    "macula_view_pick": [c_void_p, POINTER(Pick), POINTER(Progress), POINTER(Picked)],
    "macula_built_in": [POINTER(c_char_p)],
    "macula_live_open": [c_void_p, c_void_p, POINTER(LiveOptions), POINTER(Progress), POINTER(c_void_p)],
    "macula_live_show": [c_void_p, c_void_p, POINTER(Progress)],
    "macula_live_frame": [c_void_p, POINTER(Frame), POINTER(Progress), POINTER(Shown)],
    "macula_live_times": [c_void_p, POINTER(c_char_p)],
    "macula_live_model": [c_void_p, POINTER(Model)],
    "macula_live_train": [c_void_p, POINTER(Training), POINTER(Progress), POINTER(Model)],
    "macula_live_save": [c_void_p, POINTER(Progress)],
    "macula_live_write_model": [c_void_p, c_char_p, c_int32, POINTER(Progress)],
    "macula_log_to": [LogLine, c_void_p, c_int32],
    "macula_draw": [c_void_p, c_void_p, POINTER(Picture), POINTER(Progress), POINTER(Drawn)],
}
_OTHERS = {
    "macula_version": (c_char_p, []),
    "macula_cancel_now": (None, [c_void_p]),
    "macula_cancel_close": (None, [c_void_p]),
    "macula_archive_note": (c_char_p, [c_void_p, c_uint32]),
    "macula_archive_close": (None, [c_void_p]),
    "macula_name": (c_char_p, [c_int32, c_uint32]),
    "macula_study_volumes": (c_uint32, [c_void_p]),
    "macula_study_title": (c_char_p, [c_void_p, c_uint32]),
    "macula_study_note": (c_char_p, [c_void_p, c_uint32]),
    "macula_study_close": (None, [c_void_p]),
    "macula_view_note": (c_char_p, [c_void_p, c_uint32]),
    "macula_view_close": (None, [c_void_p]),
    "macula_device_close": (None, [c_void_p]),
    "macula_live_note": (c_char_p, [c_void_p, c_uint32]),
    "macula_live_close": (None, [c_void_p]),
}


# Where packages put this one, below a prefix. Anywhere else, as in a checkout, what lies above may be anybody's.
_INSTALLED = ("lib", "python3", "dist-packages", "macula")


def _places():
    """Where the library may be: as told, below the prefix that this was installed in, or where the system has it."""
    told = os.environ.get("MACULA_LIBRARY")
    if told:
        return [told]
    folder = pathlib.Path(__file__).resolve().parent
    if folder.parts[-len(_INSTALLED):] != _INSTALLED:
        return [_NAME]
    prefix = folder.parents[len(_INSTALLED) - 1]
    below = [prefix / "lib" / _NAME, prefix / "lib64" / _NAME, *sorted(prefix.glob("lib/*-linux-gnu*/" + _NAME))]
    return [*(str(place) for place in below if place.is_file()), _NAME]


def load():
    why = None
    for place in _places():
        try:
            library = ctypes.CDLL(place)
            for name, arguments in _STATUS.items():
                function = getattr(library, name)
                function.restype, function.argtypes = c_int32, arguments
            for name, (result, arguments) in _OTHERS.items():
                function = getattr(library, name)
                function.restype, function.argtypes = result, arguments
        except (OSError, AttributeError) as error:  # none, or one of another version
            why = error
            continue
        return library
    raise ImportError(f"{_NAME} could not be loaded ({why}). Install the package libmacula0, or set MACULA_LIBRARY to "
                      "the file.")
