"""The formats there are. Nothing heavy is imported: the command line's help reads this too."""

from __future__ import annotations

from dataclasses import dataclass

from berthing.errors import InputError


@dataclass(frozen=True)
class Format:
    """One format of files.

    Attributes:
        name: what ``--to`` takes.
        suffix: of its files.
        title: what it is, in a few words.
        module: in this package; its ``write(handover, path)`` writes the file.
        needs: keys that ``meta:`` must have.
        single: whether a file holds one vehicle only.
        attitude_only: whether it holds nothing that a point mass has.
        rates: whether it holds velocities or angular rates.
        package: what has to be installed for it beside the core.
    """

    name: str
    suffix: str
    title: str
    module: str
    needs: tuple[str, ...] = ()
    single: bool = False
    attitude_only: bool = False
    rates: bool = False
    package: str | None = None


_ORBIT = ("epoch", "centre", "frame")

FORMATS = {
    f.name: f
    for f in (
        Format(
            "oem", ".oem", "CCSDS orbit ephemeris, KVN 2.0", "oem", (*_ORBIT, "object_ids"),
            rates=True,
        ),
        Format(
            "aem", ".aem", "CCSDS attitude ephemeris, KVN 2.0", "aem", (*_ORBIT, "object_ids"),
            attitude_only=True, rates=True,
        ),
        Format(
            "basilisk", ".csv", "Basilisk waypointReference table", "basilisk", single=True,
            attitude_only=True, rates=True,
        ),
        Format(
            "spk", ".bsp", "SPICE ephemeris", "spk", (*_ORBIT, "naif_ids"), rates=True,
            package="spiceypy",
        ),
        Format(
            "ck", ".bc", "SPICE attitude, with its clock and frame", "ck",
            ("epoch", "frame", "naif_ids"), attitude_only=True, rates=True,
            package="spiceypy",
        ),
        Format(
            "stk-e", ".e", "STK ephemeris", "stk_ephemeris", _ORBIT, single=True, rates=True
        ),
        Format(
            "stk-a", ".a", "STK attitude", "stk_attitude", _ORBIT, single=True,
            attitude_only=True,
        ),
        Format("czml", ".czml", "scene for Cesium", "czml", ("epoch",)),
        Format("mat", ".mat", "MATLAB, samples and polynomials", "mat"),
        Format("parquet", ".parquet", "table of samples", "parquet", package="pyarrow"),
        Format("gltf", ".glb", "animated scene", "gltf"),
    )
}  # fmt: skip

NAMES = ", ".join(FORMATS)


def format_named(name: str | None) -> Format:
    """The format called ``name``, whatever its case.

    Raises:
        InputError: none was given, or there is none of that name; both with the options.
    """
    if name is None:
        raise InputError("--to", "is missing", f"one of: {NAMES}")
    found = FORMATS.get(name.lower())
    if found is None:
        raise InputError("--to", f"is {name!r}, which is no format", f"one of: {NAMES}")
    return found
